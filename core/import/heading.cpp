// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>
#include <utility>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;
using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;

// ---- The path of a name ----

/// A name as a path whose last part is the quantity, and whose other parts may name the body:
///
///     slider.s   /crank_slider/slider/position   Latest: Position   Pos_TX@Slider
struct NamePath {
    std::vector<std::string_view> parts{};
    std::string owner{};       ///< all parts but the last one
    bool isOfModelica = false; ///< "slider.s": a variable of Modelica's library, in m, rad and s
};

NamePath splitPath(std::string_view name)
{
    const bool isOfRecurDyn = name.starts_with("Y:"); // "Y:Pos_TX-Slider"
    name.remove_prefix(isOfRecurDyn ? 2 : 0);
    if (const std::size_t at = name.find(isOfRecurDyn ? '-' : '@'); at != name.npos) {
        return {{name.substr(at + 1), name.substr(0, at)}, std::string(name.substr(at + 1))};
    }
    const bool hasBlank = name.find_first_of(" (") != name.npos; // then a point belongs to an abbreviation
    NamePath path;
    std::size_t begin = 0;
    char separator = ' ';
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const bool isEnd = i == name.size();
        if (isEnd || name[i] == '/' || name[i] == ':' || name[i] == '|' || (name[i] == '.' && !hasBlank)) {
            if (i > begin) {
                path.owner = begin == 0 ? std::string() : std::string(name.substr(0, begin - 1));
                path.parts.push_back(name.substr(begin, i - begin));
            }
            begin = i + 1;
            separator = isEnd ? separator : name[i];
        }
    }
    path.isOfModelica = path.parts.size() > 1 && separator == '.' && name.find_first_of(" ,;:/") == name.npos &&
                        findWord('.' + std::string(path.parts.back()), WordUse::Symbol);
    return path;
}

// ---- The words of a name ----

/// What the words of a name say together.
struct NameReading {
    std::optional<Dimension> dimension{};
    std::optional<Order> order{}; ///< without `derivatives`
    std::optional<Body> body{};
    char axis = ' ';
    int derivatives = 0;
    bool hasSymbol = false;
    bool isBodyNamed = false;   ///< by a word or number, and not only by an index such as B
    bool isLabelled = false;    ///< the next letter is that of a joint
    bool isFrame = false;       ///< it has the number 1, as the frame if the links are numbered from there
    bool isUnknownBody = false; ///< it has an index that denotes none of the three bodies
    Doubt doubt = Doubt::None;
    std::string_view symbol{};
};

/// Sets `all` to a value that is known. Returns false if it is another one than before.
template <typename Value>
bool merge(std::optional<Value> &all, const std::optional<Value> &value)
{
    const bool agrees = !all || !value || *all == *value;
    all = value ? value : all;
    return agrees;
}

/// Includes what an entry of the vocabulary says. Returns false if it contradicts the rest.
bool merge(NameReading &all, const WordMeaning &entry)
{
    all.order = std::max(all.order, entry.order);
    all.axis = entry.axis != ' ' ? entry.axis : all.axis;
    return merge(all.dimension, entry.dimension) && merge(all.body, entry.body);
}

/// Includes the number of a link after a symbol: the crank is link 2, the coupler 3 and the slider 4. Returns false if
/// the link has no such quantity. Behind a word, a number only counts columns ("Linear Velocity1").
bool includeNumber(NameReading &all, std::string_view digits)
{
    if (!all.hasSymbol) {
        return true;
    }
    const bool isAngle = all.dimension == Dimension::Angle;
    all.isBodyNamed = true;
    if (digits == "4" && !isAngle) {
        return merge(all.body, std::optional(Body::Slider));
    }
    all.isUnknownBody = !isAngle;
    all.isFrame = digits == "1";
    const std::optional<Body> link = digits == "2"   ? std::optional(Body::Crank)
                                     : digits == "3" ? std::optional(Body::Coupler)
                                                     : std::nullopt;
    return isAmong(digits, "1 2 3") && (!isAngle || merge(all.body, link));
}

/// Returns whether a symbol can stand for a quantity of that order, as in "velocity v" or "crank angle α".
bool isOfOrder(const WordMeaning &symbol, std::optional<Order> order)
{
    const bool isAlpha = symbol.dimension == Dimension::Angle && symbol.order == Order::Acceleration;
    return !order || !symbol.order || symbol.order == order || (isAlpha && order == Order::Position);
}

/// Includes an entry of the vocabulary. Returns false if the word is unknown there or contradicts the words before.
bool includeEntry(NameReading &all, std::string_view word, bool mayBeSymbol)
{
    if (isDigits(word)) {
        return includeNumber(all, word);
    }
    if (const WordMeaning *const entry = findWord(word, WordUse::Word)) {
        all.isBodyNamed = all.isBodyNamed || entry->body;
        return merge(all, *entry);
    }
    if (findWord(word, WordUse::Filler)) {
        return true;
    }
    if (const WordMeaning *const index = all.hasSymbol ? findWord(word, WordUse::Index) : nullptr) {
        return merge(all, *index);
    }
    if (all.hasSymbol && findWord(word, WordUse::LetterOfOne)) {
        const bool isOfPiston = word == "p" && all.order; // v_p and a_p, for which a derivative is unusual
        all.doubt = isOfPiston ? all.doubt : word == "p" ? Doubt::IsPistonsIndex : Doubt::IsDerivative;
        return !isOfPiston || merge(all.body, std::optional(Body::Slider));
    }
    if (all.isLabelled && word.size() == 1) { // "joint B"
        const WordMeaning *const index = findWord(word, WordUse::Index);
        all.isUnknownBody = all.isUnknownBody || !index;
        all.isLabelled = false;
        return !index || merge(all, *index);
    }
    if (!all.hasSymbol && findWord(word, WordUse::Label)) {
        all.isLabelled = true;
        return true;
    }
    const WordMeaning *const symbol = mayBeSymbol ? findWord(word, WordUse::Symbol) : nullptr;
    if (symbol && (symbol->axis != ' ' || (!all.hasSymbol && isOfOrder(*symbol, all.order)))) {
        all.hasSymbol = true;
        all.symbol = all.order ? std::string_view() : word;
        WordMeaning entry = *symbol;
        entry.order = all.order ? all.order : symbol->order;
        return merge(all, entry);
    }
    const WordMeaning *const derivative = findWord(word, WordUse::Derivative);
    all.derivatives += derivative ? static_cast<int>(*derivative->order) : 0;
    return derivative;
}

/// Includes one word, which may be a compound of entries such as "kolbenweg", "crankangle" or "xdot". Returns false if
/// it is unknown or contradicts the words before.
bool includeWord(NameReading &all, std::string_view word, bool mayBeSymbol)
{
    NameReading with = all;
    if (includeEntry(with, word, mayBeSymbol)) {
        all = with;
        return true;
    }
    for (std::size_t end = word.size() - 1; end > 0; --end) {
        const std::string_view first = word.substr(0, end);
        const std::string_view rest = word.substr(end);
        const bool isDifferential = first == "d" && !all.hasSymbol && findWord(rest, WordUse::Symbol); // "dx"
        with = all;
        if (!isDifferential && !includeEntry(with, first, mayBeSymbol)) {
            continue;
        }
        const bool isJoined = findWord(first, WordUse::Word) && (rest[0] == 's' || rest[0] == 'n'); // "Kurbelwellenwinkel"
        NameReading joined = with;
        const bool fits = includeWord(with, rest, mayBeSymbol);
        if (!fits && isJoined && (rest.size() == 1 || includeWord(joined, rest.substr(1), mayBeSymbol))) {
            all = joined;
            return true;
        }
        if (fits) {
            all = with;
            all.doubt = isDifferential ? Doubt::IsDerivative : all.doubt;
            return true;
        }
    }
    const bool isIndex = all.hasSymbol && word.size() <= 2 && all.dimension == Dimension::Angle;
    all.isUnknownBody = all.isUnknownBody || isIndex; // "theta_m", which may be the angle of the crank
    return isIndex;
}

/// Removes the words that stand for a derivative, wherever they are: the dot of "theta3_dot", the d and dt of
/// "d^2x/dt^2". Returns the number of derivatives.
int takeDerivatives(Words &words)
{
    int count = 0;
    for (std::size_t i = 0; i < words.size();) {
        const bool hasNext = i + 1 < words.size();
        const WordMeaning *const two =
            hasNext ? findWord(words[i] + '_' + words[i + 1], WordUse::Derivative) : nullptr;
        const WordMeaning *const entry = two ? two : findWord(words[i], WordUse::Derivative);
        if (entry) {
            count += static_cast<int>(*entry->order);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i + (two ? 2 : 1)));
        } else {
            ++i;
        }
    }
    const bool isSecond = words.size() > 2 && words[0] == "d" && words[1] == "2";
    const auto denominator = std::ranges::find_if(words, [](const std::string &word) { return word.ends_with("dt"); });
    if (words.size() > 1 || (denominator != words.end() && denominator->size() > 3)) {
        if (denominator != words.end()) { // "dx/dt"
            denominator->resize(denominator->size() - 2);
            if (const auto power = denominator + 1; power != words.end() && *power == "2") {
                words.erase(power);
            }
            count += words[0].starts_with('d') && !isSecond ? 1 : 0;
            words[0].erase(0, isSecond ? 0 : 1);
        }
        if (isSecond) {
            count += 2;
            words.erase(words.begin(), words.begin() + 2);
        }
    }
    std::erase(words, std::string());
    return count;
}

/// Returns what the parts of a path say together, from the last one; nullopt if the last one has unknown words, or
/// such that contradict each other, as in "linear velocity of the crank". Unknown parts before it are ignored, as
/// that of "/slider_crank/slider/position" which names two bodies.
std::optional<NameReading> readPath(const NamePath &path, int derivatives, const Words &lastWords)
{
    NameReading all{.derivatives = derivatives};
    for (std::size_t i = path.parts.size(); i-- > 0;) {
        const bool isLast = i + 1 == path.parts.size();
        const Words words = isLast ? lastWords : wordsOf(path.parts[i]);
        NameReading with = all;
        bool isKnown = true;
        for (std::size_t k = 0; k < words.size() && isKnown; ++k) {
            const std::string two = k + 1 < words.size() ? words[k] + '_' + words[k + 1] : std::string();
            const bool isPair = findWord(two, WordUse::Word); // "link 3"
            isKnown = includeWord(with, isPair ? two : words[k], isLast);
            k += isPair ? 1 : 0;
        }
        if (!isKnown && isLast) {
            return std::nullopt;
        }
        all = isKnown ? with : all;
    }
    const bool isOfCoupler = !all.body || all.body == Body::Coupler;
    const Dimension ofBody = all.body == Body::Crank ? Dimension::Angle : Dimension::Length;
    return isOfCoupler || merge(all.dimension, std::optional(ofBody)) ? std::optional(all) : std::nullopt;
}

// ---- The meaning of a name ----

/// Returns the channel whose name has the same letters and digits, regardless of punctuation.
std::optional<Channel> channelSpelled(const Words &words, int derivatives)
{
    std::string text;
    for (const std::string &word : words) {
        text += word;
    }
    for (std::size_t index = 0; index < kCoordinateCount; ++index) {
        const Channel channel = channelAt(index);
        std::string name = lowered(nameOf(channel));
        std::erase(name, '_');
        if (name == text && derivatives <= 2) {
            return Channel{channel.coordinate, static_cast<Order>(derivatives)};
        }
    }
    return std::nullopt;
}

/// Returns the order of the quantity, as far as the name or its unit tells it.
std::optional<Order> orderOf(const NameReading &name, const std::optional<Unit> &unit)
{
    const bool isAngleUnit = unit && unit->dimension == Dimension::Angle && unit->order == 0;
    const bool isAlpha = findWord(name.symbol, WordUse::Symbol) && name.order == Order::Acceleration &&
                         name.dimension == Dimension::Angle && !name.derivatives && isAngleUnit;
    std::optional<int> order;
    if (name.order && !isAlpha) {
        order = static_cast<int>(*name.order) + name.derivatives;
    } else if (unit && (!name.derivatives || isAlpha)) {
        order = unit->order;
    } else if (name.hasSymbol || name.derivatives || (name.body && name.body != Body::Coupler)) {
        order = name.derivatives;
    }
    return order && *order <= 2 ? std::optional(static_cast<Order>(*order)) : std::nullopt;
}

/// Returns the channel or quantity of a name with known words.
NameMeaning meaningOfReading(const NameReading &name, const NamePath &path, const std::string &unitText)
{
    const std::optional<Unit> unit = parseUnit(unitText);
    const Dimension usual = unit ? unit->dimension : Dimension::Length;
    const bool isAngle = name.dimension.value_or(usual) == Dimension::Angle;
    const bool says = name.order || name.hasSymbol || name.body;
    const std::optional<Order> order = says ? orderOf(name, unit) : std::nullopt;
    const bool isUnknownBody = name.isUnknownBody && !isAngle;
    if (!order || (name.body == Body::Coupler && !isAngle) || isUnknownBody) {
        return {.reason = isUnknownBody ? ColumnReason::UnknownBody : ColumnReason::UnknownName};
    }
    NameMeaning meaning{.owner = path.owner};
    const Coordinate ofAngle = name.isFrame ? Theta1 : name.body == Body::Crank ? Theta2 : Theta3;
    const Coordinate coordinate = isAngle ? ofAngle : name.axis == 'y' ? R4y : R4x;
    const bool isCertain = (name.body || name.isFrame) && name.isBodyNamed && (name.order || name.hasSymbol || name.axis != ' ' || isAngle);
    meaning.kind = isCertain ? Kind::Words : Kind::Quantity;
    meaning.channel = {coordinate, *order};
    meaning.reason = path.isOfModelica && unitText.empty() ? ColumnReason::ModelicaName
                     : isCertain                           ? ColumnReason::KnownName
                                                           : ColumnReason::QuantityInName;
    const bool isAlpha = isAmong(name.symbol, "alpha alfa al") && !name.body && !unit && !name.derivatives;
    meaning.doubt = name.isUnknownBody ? Doubt::IsOfCrank
                    : isAlpha          ? Doubt::IsAngle
                    : unit             ? Doubt::None
                                       : name.doubt;
    return meaning;
}

/// Returns the meaning of P[3.1], V[3.1] and A[3.1] in Inventor's Output Grapher, where only the unit tells an angle
/// from a length.
std::optional<NameMeaning> meaningInInventor(std::string_view name, const std::string &unitText)
{
    constexpr std::string_view kLetters = "PVA";
    const std::size_t order = name.size() >= 4 && name[1] == '[' && name.ends_with(']') ? kLetters.find(name[0]) : kLetters.npos;
    if (order == kLetters.npos) {
        return std::nullopt;
    }
    const std::optional<Unit> unit = parseUnit(unitText);
    if (!unit) {
        return NameMeaning{.reason = unitText.empty() ? ColumnReason::AngleOrLength : ColumnReason::UnknownUnit};
    }
    const Coordinate coordinate = unit->dimension == Dimension::Angle ? Theta3 : R4x;
    return NameMeaning{Kind::Quantity,
                       {coordinate, static_cast<Order>(order)},
                       ColumnReason::QuantityInName,
                       std::string(name.substr(2, name.size() - 3))};
}

/// Returns whether an unknown name ends in a quantity: "J1_x", "part 7 velocity".
bool endsInQuantity(Words words)
{
    std::erase_if(words, isDigits);
    if (words.size() < 2) {
        return false;
    }
    const WordMeaning *const word = findWord(words.back(), WordUse::Word);
    const WordMeaning *const symbol = findWord(words.back(), WordUse::Symbol);
    return (word && !word->body && (word->order || word->dimension)) || (symbol && symbol->axis != ' ');
}

/// Returns what a name with that unit means by itself.
NameMeaning meaningOf(std::string_view name, const std::string &unit)
{
    constexpr std::string_view kCountedUnits = "steps step frames frame samples sample rows points pasos muestras";
    if (const std::optional<NameMeaning> meaning = meaningInInventor(name, unit)) {
        return *meaning;
    }
    int derivatives = 0;
    for (; lowered(name.substr(0, 4)) == "der(" && name.ends_with(')'); ++derivatives) { // Modelica
        name = name.substr(4, name.size() - 5);
    }
    name = name.substr(0, name.find(", Ch ")); // the sensor of a PASCO interface
    const std::string plain = respelled(name, "/dt=dt|/ dt=dt|/d t=dt"); // not a path
    NamePath path = splitPath(plain);
    const bool isAboutZ = path.parts.size() > 1 && path.parts.back() == "z"; // "twist/angular/z"
    if (isAboutZ) {
        path.parts.pop_back();
    }
    const std::size_t bracket = name.rfind('(');
    if (path.parts.empty() || (bracket != name.npos && bracket > 0 && name.substr(bracket + 1).find_first_not_of("0123456789)") == name.npos)) {
        return {.reason = path.parts.empty() ? ColumnReason::UnknownName : ColumnReason::UnknownBody}; // "x(4)"
    }
    Words words = path.isOfModelica ? Words{'.' + std::string(path.parts.back())} : wordsOf(path.parts.back());
    const bool isNamedTime = isTime(words);
    if (isNamedTime ? isAmong(unit, kCountedUnits) : isRowNumber(words)) {
        return {.reason = ColumnReason::RowNumber};
    }
    if (isNamedTime) {
        return {Kind::Time};
    }
    const Words allWords = wordsOf(name);
    derivatives += takeDerivatives(words);
    if (const std::optional<Channel> channel = channelSpelled(words, derivatives)) {
        return {Kind::ChannelName, *channel, ColumnReason::KnownName};
    }
    const std::optional<NameReading> reading = readPath(path, derivatives, words);
    const bool isKnown = reading && (!isAboutZ || reading->dimension == Dimension::Angle);
    NameMeaning meaning = isKnown ? meaningOfReading(*reading, path, unit) : NameMeaning();
    if (meaning.reason == ColumnReason::UnknownName && meaning.kind == Kind::Nothing && endsInQuantity(allWords)) {
        meaning.reason = ColumnReason::UnknownBody;
    }
    return meaning;
}

// ---- The unit in a heading ----

/// Returns whether a quantity or time can have the unit.
bool suits(const NameMeaning &meaning, const std::string &unit)
{
    const ColumnRole role = meaning.kind == Kind::Time ? ColumnRole::Time : ColumnRole::Channel;
    return meaning.kind != Kind::Nothing && parseColumnUnit(unit, role, meaning.channel);
}

/// Sets name and unit of "Position (m) Run #1", and returns whether there is a unit in brackets. Text in brackets that
/// is no unit is part of the name if the name has a meaning with it, as "x(B)", or if it is an index, as "P[3.1]".
bool splitAtBrackets(std::string_view text, Heading &heading)
{
    constexpr std::string_view kOpening = "[({<";
    constexpr std::string_view kClosing = "])}>";
    for (std::size_t end = text.size(); end-- > 0;) {
        const std::size_t kind = kClosing.find(text[end]);
        const std::size_t begin = kind == kClosing.npos ? text.npos : text.substr(0, end).rfind(kOpening[kind]);
        if (begin == text.npos) {
            continue;
        }
        const std::string_view unit = trimmed(text.substr(begin + 1, end - begin - 1));
        const bool isLast = end + 1 == text.size();
        const bool isUnit = parseUnit(unit) || unit.empty();
        const bool isPart = kind > 1 || (kind == 0 && looksNumeric(unit)) ||
                            meaningOf(text, {}).kind != Kind::Nothing;
        if (isUnit || (isLast && !isPart)) {
            heading.name = trimmed(text.substr(0, begin));
            heading.name += isLast ? "" : text.substr(end + 1);
            heading.use.unit = unit;
            return true;
        }
        end = begin;
    }
    return false;
}

/// Sets name and unit of "v/(m/s)", "Time in s", "t, s", "x-mm", "time_ms" or "timeMs" if the unit suits the name. The
/// longest one that does is the unit.
void splitAtEnd(std::string_view text, Heading &heading)
{
    constexpr std::string_view kAlsoWords = "in min h r u g"; // units only where nothing else is possible
    for (std::size_t at = 1; at < text.size(); ++at) {
        const bool isCapital = lowerCase(text[at]) != text[at] && lowerCase(text[at - 1]) == text[at - 1];
        const bool isSeparator = std::string_view("/, _-.:").find(text[at]) != std::string_view::npos;
        if (!isSeparator && (!isCapital || isBlank(text[at - 1]))) {
            continue;
        }
        std::string_view unit = trimmed(text.substr(at + (isSeparator ? 1 : 0)));
        std::string_view name = trimmed(text.substr(0, at));
        const bool hasIn = unit.starts_with("in ") || unit.starts_with("en ");
        unit = trimmed(unit.substr(hasIn ? 3 : 0));
        const bool isClear = text[at] == '/' || text[at] == ',' || hasIn;
        if (unit.empty() || unit[0] == '/' || (!isClear && isAmong(lowered(unit), kAlsoWords)) || !parseUnit(unit)) {
            continue;
        }
        if (const std::string unitText(unit); suits(meaningOf(name, unitText), unitText)) {
            heading.name = name;
            heading.use.unit = unit;
            return;
        }
    }
}

} // namespace

Heading parseHeading(std::string_view cell)
{
    Heading heading{.use = {.heading = respelled(cell, "\"\"=\"")}};
    std::string text = heading.use.heading;
    if (text.size() > 2 && text.starts_with('\'') && text.ends_with('\'')) {
        text = text.substr(1, text.size() - 2); // between apostrophes
    } else if (text.starts_with("('") && text.ends_with("')")) {
        text = respelled(text.substr(2, text.size() - 4), "', '=."); // "('slider', 'x')" of pandas
    }
    heading.name = text;
    const std::optional<Unit> alone = text.size() > 1 ? parseUnit(text) : std::nullopt;
    if (text.starts_with("X:")) { // RecurDyn writes pairs "X:Pos_TX-Slider(mm)" of time stamps, "Y:…" of values
        heading.name = "time";
    } else if (isInTurnsPerMinute(wordsOf(text)) && text.find_first_of("[(/") == text.npos) {
        heading.use.unit = "rpm";
    } else if (alone && alone->dimension == Dimension::Time && alone->order == 0) { // "millis", "seconds"
        heading.name = "time";
        heading.use.unit = text;
    } else if (!splitAtBrackets(text, heading)) {
        splitAtEnd(text, heading);
    }
    const bool isUnitAlone = alone && text.find('/') != text.npos; // "mm/s" in a line of units
    heading.meaning = isUnitAlone ? NameMeaning() : meaningOf(heading.name, heading.use.unit);
    return heading;
}

/// Decides between the meanings of "xp", "dx" and the like by the other columns: beside "xpp" or "d2x", or both "v_p"
/// and "x_p", there is only one. Otherwise only a person can tell.
void resolveDoubts(std::vector<Heading> &row)
{
    const auto isSecond = [](const Heading &heading) {
        const Words words = wordsOf(heading.name);
        return heading.meaning.channel.order == Order::Acceleration && heading.meaning.kind >= Kind::Quantity &&
               heading.meaning.doubt == Doubt::None && !words.empty() && !findWord(words[0], WordUse::Word) &&
               words[0] != "a";
    };
    const auto isOfPiston = [](const Heading &heading) {
        const Words words = wordsOf(heading.name);
        return words.size() == 2 && isAmong(words[0], "v a") && words[1] == "p";
    };
    const bool hasSecond = std::ranges::any_of(row, isSecond);
    const bool hasPiston = std::ranges::any_of(row, isOfPiston);
    for (Heading &heading : row) {
        NameMeaning &meaning = heading.meaning;
        if (meaning.doubt != Doubt::IsDerivative && meaning.doubt != Doubt::IsPistonsIndex) {
            continue;
        }
        if (hasSecond && meaning.channel.order < Order::Acceleration) {
            meaning.channel.order = static_cast<Order>(static_cast<int>(meaning.channel.order) + 1);
        } else if (meaning.doubt == Doubt::IsDerivative || !hasPiston) {
            meaning = {.reason = ColumnReason::UnknownBody};
        }
    }
}

void interpretHeadings(std::vector<Heading> &row)
{
    std::optional<std::size_t> magnitude;
    for (std::size_t i = 0; i < row.size(); ++i) {
        Heading &heading = row[i];
        const bool isComponent = isAmong(heading.name, "X-comp Y-comp");
        if (isComponent && magnitude) {
            Heading &whole = row[*magnitude];
            whole.use.reason = ColumnReason::Magnitude;
            heading.name = whole.name + (heading.name[0] == 'X' ? " x" : " y");
            heading.use.unit = heading.use.unit.empty() ? whole.use.unit : heading.use.unit;
        }
        heading.meaning = meaningOf(heading.name, heading.use.unit);
        if (!isComponent) {
            magnitude = heading.meaning.kind == Kind::Quantity ? std::optional(i) : std::nullopt;
        }
    }
    resolveDoubts(row);
    for (Heading &heading : row) {
        const NameMeaning &meaning = heading.meaning;
        if (meaning.kind == Kind::Nothing) {
            heading.use.reason = heading.use.heading.empty() ? ColumnReason::NoName : meaning.reason;
        }
        if (meaning.reason == ColumnReason::ModelicaName && meaning.kind >= Kind::Quantity &&
            heading.use.unit.empty()) {
            constexpr std::array kPerTime{"", "/s", "/s2"};
            const std::string base = isAngle(meaning.channel.coordinate) ? "rad" : "m";
            heading.use.unit = base + kPerTime[static_cast<std::size_t>(meaning.channel.order)];
        }
    }
}

} // namespace slidercrank
