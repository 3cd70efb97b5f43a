// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_meaning.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"

#include <algorithm>
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
///     slider.s   /crank_slider/slider/position   Latest: Position   Pos_TX@Slider   Position - Cart
struct NamePath {
    std::vector<std::string_view> parts{};
    std::string owner{};       ///< all parts but the last one
    bool isOfModelica = false; ///< "slider.s": a variable of Modelica's library
    bool isInSi = false;       ///< by Modelica or ROS: in m, rad and s
};

/// Last parts of paths that say nothing: "slider_tx/value", "Piston/Bâti" (relative to the frame).
constexpr std::string_view kIgnoredEnds =
    "value series data signal ground frame base bâti bati bastidor telaio gestell";

NamePath splitPath(std::string_view name)
{
    const bool isOfRecurDyn = name.starts_with("Y:"); // "Y:Pos_TX-Slider"
    name.remove_prefix(isOfRecurDyn ? 2 : 0);
    const std::string_view mark = isOfRecurDyn ? "-" : name.find('@') != name.npos ? "@" : " - ";
    if (const std::size_t at = name.find(mark); at != name.npos && at > 0) {
        const std::string_view owner = name.substr(at + mark.size()); // "Slider@Model1"
        return {{owner.substr(0, owner.find('@')), name.substr(0, at)}, std::string(owner)};
    }
    const bool hasBlank = name.find_first_of(" (") != name.npos; // then a point belongs to an abbreviation
    NamePath path;
    std::size_t begin = 0;
    char separator = ' ';
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const bool isEnd = i == name.size();
        const bool isComma = i > 1 && i + 3 < name.size() && name.substr(i, 2) == ", "; // "Slider, X Displacement"
        if (isEnd || isComma || name[i] == '/' || name[i] == ':' || name[i] == '|' || (name[i] == '.' && !hasBlank)) {
            if (i > begin) {
                path.owner = begin == 0 ? std::string() : std::string(name.substr(0, begin - 1));
                path.parts.push_back(name.substr(begin, i - begin));
            }
            begin = i + 1;
            separator = isEnd ? separator : name[i];
        }
    }
    while (path.parts.size() > 1 && isAmong(lowered(path.parts.back()), kIgnoredEnds)) {
        path.parts.pop_back();
    }
    path.isOfModelica = path.parts.size() > 1 && separator == '.' && name.find_first_of(" ,;:/") == name.npos &&
                        findWord('.' + std::string(path.parts.back()), WordUse::Symbol);
    path.isInSi = path.isOfModelica || (path.parts.size() > 1 && name.starts_with('/'));
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
    bool hasIndex = false;
    bool isOrderNamed = false;  ///< by a word such as "velocity"
    bool isBodyNamed = false;   ///< by a word or number, and not only by an index such as B
    bool isLabelled = false;    ///< the next letter is that of a joint
    bool isFrame = false;       ///< it has the number 1, as the frame if the links are numbered from there
    bool isUnknownBody = false; ///< it has an index that denotes none of the three bodies
    Doubt doubt = Doubt::None;
    std::string symbol{};
    std::string joints{}; ///< the ends of a link: "bc" in "ω_BC"
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
        all.isLabelled = false;
        all.isBodyNamed = all.isBodyNamed || entry->body;
        all.isOrderNamed = all.isOrderNamed || entry->order;
        return merge(all, *entry);
    }
    const bool isLabelled = std::exchange(all.isLabelled, !all.hasSymbol && findWord(word, WordUse::Label));
    if (isLabelled && word.size() == 1 && !isAmong(word, "x y")) { // "joint B", "velocity of B"
        const WordMeaning *const index = findWord(word, WordUse::Index);
        all.isUnknownBody = all.isUnknownBody || !index;
        return !index || merge(all, *index);
    }
    if (all.isLabelled || findWord(word, WordUse::Filler)) {
        return true;
    }
    const bool mayBeIndex = all.hasSymbol || (all.order && isAmong(word, "b c")); // "x_s", "velocity B"
    const bool isOfLink = word.size() > 1 && all.dimension == Dimension::Angle;   // "ω_BC", but not "xBp"
    if (const WordMeaning *const index =
            mayBeIndex && (word.size() == 1 || isOfLink) ? findWord(word, WordUse::Index) : nullptr) {
        const bool isOfSlider = index->body == Body::Slider && all.dimension == Dimension::Angle; // θ_c, θ_b
        all.isUnknownBody = all.isUnknownBody || isOfSlider;
        const bool isSecond = std::exchange(all.hasIndex, true);
        if (isSecond) {
            return false;
        }
        all.joints = !index->body && word.size() > 1 ? word : "";
        return isOfSlider || merge(all, *index);
    }
    if (all.hasSymbol && findWord(word, WordUse::LetterOfOne)) {
        const bool isOfPiston = word == "p" && all.order; // v_p and a_p, for which a derivative is unusual
        all.doubt = isOfPiston ? all.doubt : word == "p" ? Doubt::IsPistonsIndex : Doubt::IsDerivative;
        return !isOfPiston || merge(all.body, std::optional(Body::Slider));
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

/// Includes a known word with an ending, such as a plural or genitive: "pistonun". Returns false if it is none.
bool includeStem(NameReading &all, std::string_view word)
{
    constexpr std::size_t kShortestStem = 5; // bytes
    constexpr std::size_t kLongestEnding = 3;
    const std::size_t shortest = std::max(kShortestStem, word.size() - std::min(word.size(), kLongestEnding));
    for (std::size_t size = word.size(); size-- > shortest;) {
        if (findWord(word.substr(0, size), WordUse::Word)) {
            return includeEntry(all, word.substr(0, size), false);
        }
    }
    return false;
}

/// Includes one word, which may be a compound of entries such as "kolbenweg", "crankangle" or "xdot". Returns false if
/// it is unknown or contradicts the words before. Short fillers are no parts of compounds: "end" is not "en" and "d".
bool includeWord(NameReading &all, std::string_view word, bool mayBeSymbol, bool isPart = false)
{
    constexpr std::size_t kShortestFiller = 4; // in a compound
    const auto include = [&](NameReading &reading, std::string_view part, bool isWhole) {
        const bool isAllowed = isWhole || part.size() >= kShortestFiller || !findWord(part, WordUse::Filler);
        return isAllowed && includeEntry(reading, part, mayBeSymbol);
    };
    NameReading with = all;
    if (include(with, word, !isPart)) {
        all = with;
        return true;
    }
    for (std::size_t end = word.size() - 1; end > 0; --end) {
        const std::string_view first = word.substr(0, end);
        const std::string_view rest = word.substr(end);
        const bool isDifferential = first == "d" && !all.hasSymbol && findWord(rest, WordUse::Symbol); // "dx"
        with = all;
        if (!isDifferential && !include(with, first, false)) {
            continue;
        }
        const bool isJoined = findWord(first, WordUse::Word) && (rest[0] == 's' || rest[0] == 'n');
        NameReading joined = with; // "Kurbelwellenwinkel"
        const bool fits = includeWord(with, rest, mayBeSymbol, true);
        if (fits || (isJoined && rest.size() > 1 && includeWord(joined, rest.substr(1), mayBeSymbol, true))) {
            all = fits ? with : joined;
            all.doubt = fits && isDifferential ? Doubt::IsDerivative : all.doubt;
            return true;
        }
    }
    return includeStem(all, word);
}

/// Includes an unknown index of an angle, such as that of "theta_m", which may be the angle of the crank.
bool includeUnknownIndex(NameReading &all, std::string_view word)
{
    const bool isIndex = all.hasSymbol && word.size() <= 2 && all.dimension == Dimension::Angle;
    all.isUnknownBody = all.isUnknownBody || isIndex;
    return isIndex;
}

/// Removes the words that stand for a derivative, wherever they are: the dot of "theta3_dot", the d and dt of
/// "d^2x/dt^2". Returns the number of derivatives.
int takeDerivatives(Words &words)
{
    int count = 0;
    if (words == Words{"ddot"} || words == Words{"dddot"}) { // of the distance d
        words = {"d", words[0].substr(1)};
    }
    for (std::size_t i = 0; i < words.size();) {
        const bool hasNext = i + 1 < words.size();
        const WordMeaning *const two = hasNext ? findWord(words[i] + '_' + words[i + 1], WordUse::Derivative) : nullptr;
        const bool isLabel = i == 0 && hasNext && findWord(words[0], WordUse::Label); // "Punto B", but "x punto"
        const WordMeaning *const entry = two ? two : findWord(words[i], WordUse::Derivative);
        if (entry && !isLabel) {
            count += static_cast<int>(*entry->order);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i + (two ? 2 : 1)));
        } else {
            ++i;
        }
    }
    const bool isSecond = words.size() > 2 && words[0] == "d" && words[1] == "2";
    if (words.empty() || !words[0].starts_with('d')) {
        return count;
    }
    const auto denominator = std::ranges::find_if(words, [](const std::string &word) { return word.ends_with("dt"); });
    if (words.size() > 1 || (denominator != words.end() && denominator->size() > 3)) {
        if (denominator != words.end()) { // "dx/dt"
            denominator->resize(denominator->size() - 2);
            if (const auto power = denominator + 1; power != words.end() && *power == "2") {
                words.erase(power);
            }
            count += isSecond ? 0 : 1;
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

/// Returns the body that the words name; nullopt if it is none or several, as in "slider_crank".
std::optional<Body> bodyAmong(const Words &words)
{
    std::optional<Body> body;
    for (const std::string &word : words) {
        const WordMeaning *const entry = findWord(word, WordUse::Word);
        if (entry && !merge(body, entry->body)) {
            return std::nullopt;
        }
    }
    return body;
}

/// Returns what the parts of a path say together, from the last one; nullopt if the last one has unknown words, or
/// such that contradict each other, as in "linear velocity of the crank". Parts before it that are unknown or
/// name two bodies, as in "/slider_crank/slider/position", are ignored if another part names the body.
std::optional<NameReading> readPath(const NamePath &path, int derivatives, const Words &lastWords)
{
    NameReading all{.derivatives = derivatives};
    bool hasUnknownPart = false;
    for (std::size_t i = path.parts.size(); i-- > 0;) {
        const bool isLast = i + 1 == path.parts.size();
        Words words = isLast ? lastWords : wordsOf(path.parts[i]);
        std::erase_if(words, [&](const std::string &word) { return !isLast && isDigits(word) && words.size() == 2; });
        NameReading with = all;
        bool isKnown = true;
        for (std::size_t k = 0; k < words.size() && isKnown; ++k) {
            const std::string two = k + 1 < words.size() ? words[k] + '_' + words[k + 1] : std::string();
            const bool isPair = findWord(two, WordUse::Word); // "link 3"
            isKnown = includeWord(with, isPair ? two : words[k], isLast) || includeUnknownIndex(with, words[k]);
            k += isPair ? 1 : 0;
        }
        if (!isKnown && isLast) {
            return std::nullopt;
        }
        if (isKnown) {
            all = with;
        } else if (!all.body) { // "Slider_J004"
            all.body = bodyAmong(words);
            all.isBodyNamed = all.body.has_value();
        }
        hasUnknownPart = hasUnknownPart || !isKnown;
    }
    all.isUnknownBody = all.isUnknownBody || (hasUnknownPart && !all.body && !path.isOfModelica);
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
    if (name.isOrderNamed && name.hasSymbol && static_cast<int>(*name.order) == name.derivatives) {
        order = name.derivatives; // "velocity ẋ"
    } else if (name.order && !isAlpha) {
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
    const bool isOfRevoluteJoint = path.isInSi && name.body == Body::Coupler; // "/joint_states/rod/position"
    const Dimension usual = unit ? unit->dimension : isOfRevoluteJoint ? Dimension::Angle : Dimension::Length;
    const bool isAngle = name.dimension.value_or(usual) == Dimension::Angle;
    const bool says = name.order || name.hasSymbol || name.body;
    const std::optional<Order> order = says ? orderOf(name, unit) : std::nullopt;
    const bool isUnknownBody = name.isUnknownBody && !isAngle;
    if (!order || (name.body == Body::Coupler && !isAngle) || isUnknownBody) {
        return {.channel = {R4x, order.value_or(Order::Position)},
                .reason = isUnknownBody ? ColumnReason::UnknownBody : ColumnReason::UnknownName};
    }
    NameMeaning meaning{.owner = path.owner + name.joints};
    const Coordinate ofAngle = name.isFrame ? Theta1 : name.body == Body::Crank ? Theta2 : Theta3;
    const Coordinate coordinate = isAngle ? ofAngle : name.axis == 'y' ? R4y : R4x;
    const bool isCertain = (name.body || name.isFrame) && name.isBodyNamed &&
                           (name.order || name.hasSymbol || name.axis != ' ' || isAngle);
    meaning.kind = isCertain ? Kind::Words : Kind::Quantity;
    meaning.channel = {coordinate, *order};
    meaning.reason = path.isInSi && unitText.empty() ? ColumnReason::PathInSi
                     : isCertain                     ? ColumnReason::KnownName
                                                     : ColumnReason::QuantityInName;
    const bool isAlpha = isAmong(name.symbol, "alpha alfa al") && !name.body && !unit && !name.derivatives;
    meaning.doubt = name.isUnknownBody ? Doubt::IsOfCrank : isAlpha ? Doubt::IsAngle : unit ? Doubt::None : name.doubt;
    return meaning;
}

/// Returns the meaning of P[3.1], V[3.1] and A[3.1] in Inventor's Output Grapher, where only the unit tells an angle
/// from a length.
std::optional<NameMeaning> meaningInInventor(std::string_view name, const std::string &unitText)
{
    constexpr std::string_view kLetters = "PVA";
    const std::size_t order =
        name.size() >= 4 && name[1] == '[' && name.ends_with(']') ? kLetters.find(name[0]) : kLetters.npos;
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

/// Removes the variable of "x(t)" or "v[φ]" and the calls of functions that differentiate, and returns the number of
/// derivatives: "der(x)" of Modelica, "diff(x(t), t, t)" and "Derivative(x(t), (t, 2))" of computer algebra.
int takeCalls(std::string_view &name)
{
    int count = 0;
    for (const std::string_view function : {"der(", "diff(", "derivative(", "d("}) {
        while (lowered(name.substr(0, function.size())) == function && name.ends_with(')')) {
            name = name.substr(function.size(), name.size() - function.size() - 1);
            const std::size_t comma = name.find(',');
            const std::string_view variables = name.substr(std::min(comma, name.size()));
            const auto times = static_cast<int>(std::ranges::count(variables, 't'));
            count += variables.find('2') != variables.npos ? 2 : std::max(times, 1);
            name = name.substr(0, comma);
        }
    }
    const std::size_t bracket = name.find_last_of("([");
    if (bracket != name.npos && bracket > 0 && name.find_first_of(")]", bracket) + 1 == name.size()) {
        const Words variable = wordsOf(name.substr(bracket));
        const WordMeaning *const symbol = variable.empty() ? nullptr : findWord(variable[0], WordUse::Symbol);
        const bool isAngle = symbol && symbol->dimension == Dimension::Angle && !symbol->order;
        name = isTime(variable) || isAngle ? name.substr(0, bracket) : name;
    }
    return count;
}

/// Returns the order of the quantity in which an unknown name ends: "J1_x", "part 7 velocity"; nullopt if it is none.
std::optional<Order> orderAtEnd(Words words)
{
    std::erase_if(words, isDigits);
    if (words.size() < 2) {
        return std::nullopt;
    }
    const WordMeaning *const word = findWord(words.back(), WordUse::Word);
    const WordMeaning *const symbol = findWord(words.back(), WordUse::Symbol);
    const bool isQuantity = word && !word->body && (word->order || word->dimension);
    return isQuantity                      ? word->order.value_or(Order::Position)
           : symbol && symbol->axis != ' ' ? std::optional(Order::Position)
                                           : std::nullopt;
}

} // namespace

NameMeaning meaningOf(std::string_view name, const std::string &unit)
{
    constexpr std::string_view kCountedUnits = "steps step frames frame samples sample rows points pasos muestras";
    if (const std::optional<NameMeaning> meaning = meaningInInventor(name, unit)) {
        return *meaning;
    }
    int derivatives = takeCalls(name);
    for (const std::string_view remark : {", Ch ", " from ", " relative to "}) { // ", Ch P1": sensors of PASCO
        name = name.substr(0, name.find(remark));
    }
    const std::string plain = respelled(name, "/dt=dt|/ dt=dt|/d t=dt|₊=."); // not a path, and one of Julia
    NamePath path = splitPath(plain);
    const std::size_t bracket = name.rfind('(');
    if (path.parts.empty() || (bracket != name.npos && bracket > 0 &&
                               name.substr(bracket + 1).find_first_not_of("0123456789)") == name.npos)) {
        return {.reason = path.parts.empty() ? ColumnReason::UnknownName : ColumnReason::UnknownBody}; // "x(4)"
    }
    Words words = path.isOfModelica ? Words{'.' + std::string(path.parts.back())} : wordsOf(path.parts.back());
    const bool isNamedTime = isTime(words);
    if (isNamedTime ? isAmong(unit, kCountedUnits) : isRowNumber(words) && !parseUnit(unit)) {
        return {.reason = ColumnReason::RowNumber};
    }
    if (isNamedTime && path.parts.back() == "T" && !unit.empty() &&
        !parseColumnUnit(unit, ColumnRole::Time, {})) { // a torque or temperature
        return {.reason = ColumnReason::UnknownUnit};
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
    const bool isAboutZ = std::ranges::count(allWords, "z") > 0; // "twist/angular/z"; the motion is in x and y
    const bool isKnown = reading && (!isAboutZ || reading->dimension == Dimension::Angle);
    if (isKnown && isAboutZ && !reading->body && unit.empty()) { // "Z_AngVel", of any body
        return {.reason = ColumnReason::UnknownBody};
    }
    NameMeaning meaning = isKnown ? meaningOfReading(*reading, path, unit) : NameMeaning();
    if (meaning.kind != Kind::Nothing || meaning.reason != ColumnReason::UnknownName) {
        return meaning;
    }
    if (!unit.empty() && parseColumnUnit(unit, ColumnRole::CrankAngle, {})) { // "Phase [°]"
        return {Kind::Quantity, {Theta3, Order::Position}, ColumnReason::WideAngle, path.owner, Doubt::IsOfCrank};
    }
    const std::optional<Order> order = orderAtEnd(allWords);
    return {.channel = {R4x, order.value_or(Order::Position)},
            .reason = order ? ColumnReason::UnknownBody : ColumnReason::UnknownName};
}

} // namespace slidercrank
