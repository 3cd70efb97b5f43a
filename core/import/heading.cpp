// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cells.h"

#include <algorithm>
#include <array>
#include <utility>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

bool isLetter(char c)
{
    return lowerCase(c) >= 'a' && lowerCase(c) <= 'z';
}

/// What people write beyond ASCII, in plain letters.
constexpr std::array<std::pair<std::string_view, std::string_view>, 27> kSpellings{
    {{"á", "a"},     {"é", "e"},     {"í", "i"},     {"ó", "o"},     {"ú", "u"},     {"ü", "u"},    {"ñ", "n"},
     {"Á", "A"},     {"É", "E"},     {"Í", "I"},     {"Ó", "O"},     {"Ú", "U"},     {"Ü", "U"},    {"Ñ", "N"},
     {"θ", "theta"}, {"ω", "omega"}, {"α", "alpha"}, {"ϑ", "theta"}, {"Θ", "theta"}, {"²", "2"},    {"³", "3"},
     {"⁴", "4"},     {"₂", "2"},     {"₃", "3"},     {"₄", "4"},     {"\u0301", ""}, {"\u0303", ""}}};

/// In ASCII; bytes without a plain spelling become '?', a letter that is in no word known here.
std::string plainSpelling(std::string_view name)
{
    std::string plain;
    while (!name.empty()) {
        const bool isAscii = static_cast<unsigned char>(name[0]) < 0x80;
        const auto spelling = std::ranges::find_if(
            kSpellings, [&](const auto &each) { return !isAscii && name.starts_with(each.first); });
        const bool isSpelled = spelling != kSpellings.end();
        plain += isSpelled ? spelling->second : isAscii ? name.substr(0, 1) : "?";
        name.remove_prefix(isSpelled ? spelling->first.size() : 1);
    }
    return plain;
}

/// The runs of letters and the runs of digits, in lower case; "SliderPosition" is two words.
Words wordsOf(std::string_view name)
{
    Words words;
    char before = ' ';
    for (const char c : plainSpelling(name)) {
        const bool isOfWord = isLetter(c) || c == '?';
        if (isOfWord || isDigit(c)) {
            const bool newCapital = lowerCase(c) != c && lowerCase(before) == before;
            const bool goesOn = isOfWord ? (isLetter(before) || before == '?') && !newCapital : isDigit(before);
            if (!goesOn) {
                words.emplace_back();
            }
            words.back() += lowerCase(c);
        }
        before = c;
    }
    return words;
}

std::string joined(const Words &words)
{
    std::string all;
    for (const std::string &word : words) {
        all += word;
    }
    return all;
}

constexpr std::string_view kTimeWords = "time times t tiempo timestamp zeit temps tempo instante";
constexpr std::string_view kTimeCompanions = "elapsed row sim simulation simulacion transcurrido de la stamp latest";
constexpr std::string_view kRowNumbers =
    "n no nr num index row id fila frame paso step sample point node nodo element elemento";
constexpr std::string_view kCounted =
    "steps step frames frame samples sample rows points pasos muestras"; // for a unit of time
constexpr std::string_view kFillers = "de del la el of the en component componente comp trans translational latest";
constexpr std::string_view kCrankAngles = "ca cad degca cadeg kw kurbelwinkel";

enum class Body { Crank, Coupler, Slider };

/// What a word says. Those with a dot are Modelica's variables, the capitals Inventor's.
struct Vocabulary {
    std::string_view words;
    std::optional<Order> order;
    std::optional<Dimension> dimension;
    char axis = ' ';
    std::optional<Body> body{};
};

constexpr std::nullopt_t kOpen = std::nullopt;
constexpr std::array<Vocabulary, 27> kVocabulary{{
    {"position posicion pos displacement disp desplazamiento", Order::Position, kOpen},
    {"coordinate coordenada stroke carrera", Order::Position, Dimension::Length},
    {"velocity velocidad speed vel v geschwindigkeit", Order::Velocity, kOpen},
    {"acceleration aceleracion accel acel acc a beschleunigung", Order::Acceleration, kOpen},
    {"x tx", kOpen, Dimension::Length, 'x'},
    {"y ty", kOpen, Dimension::Length, 'y'},
    {"vx", Order::Velocity, Dimension::Length, 'x'},
    {"vy", Order::Velocity, Dimension::Length, 'y'},
    {"ax", Order::Acceleration, Dimension::Length, 'x'},
    {"ay", Order::Acceleration, Dimension::Length, 'y'},
    {"rz psi", kOpen, Dimension::Angle},
    {"angle angulo rotation rotacion giro orientation theta tita", Order::Position, Dimension::Angle},
    {"ang angular rotational", kOpen, Dimension::Angle},
    {"omega w", Order::Velocity, Dimension::Angle},
    {"alpha alfa", Order::Acceleration, Dimension::Angle},
    {"linear lineal", kOpen, Dimension::Length},
    {"crank manivela kurbel", kOpen, Dimension::Angle, ' ', Body::Crank},
    {"coupler rod conrod connecting biela acoplador pleuel", kOpen, kOpen, ' ', Body::Coupler},
    {"slider piston corredera deslizadera deslizador deslizante embolo block bloque", kOpen, Dimension::Length, ' ',
     Body::Slider},
    {".s", Order::Position, Dimension::Length},
    {".v", Order::Velocity, Dimension::Length},
    {".a", Order::Acceleration, kOpen},
    {".phi", Order::Position, Dimension::Angle},
    {".w", Order::Velocity, Dimension::Angle},
    {"P", Order::Position, kOpen},
    {"V", Order::Velocity, kOpen},
    {"A", Order::Acceleration, kOpen},
}};

const Vocabulary *find(std::string_view word)
{
    const auto found =
        std::ranges::find_if(kVocabulary, [&](const Vocabulary &each) { return isAmong(word, each.words); });
    return found == kVocabulary.end() ? nullptr : &*found;
}

/// The one body that is among the words.
std::optional<Body> bodyAmong(std::string_view name)
{
    std::optional<Body> body;
    for (const std::string &word : wordsOf(name)) {
        const Vocabulary *const known = find(word);
        if (known && known->body && body && body != known->body) {
            return std::nullopt;
        }
        body = known && known->body ? known->body : body;
    }
    return body;
}

/// The channel whose name has the same letters and digits, whatever stands between them; "dot" is a derivative.
std::optional<Channel> channelSpelled(Words words)
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> plain;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            plain.push_back(joined(wordsOf(nameOf(channelAt(index)))));
        }
        return plain;
    }();
    for (std::string &word : words) {
        word = word == "dot" ? "diff" : word == "ddot" ? "diff2" : word;
    }
    const auto index = static_cast<std::size_t>(std::ranges::find(names, joined(words)) - names.begin());
    return index < kChannelCount ? std::optional(channelAt(index)) : std::nullopt;
}

bool isTime(const Words &words)
{
    const auto isNamed = [](const std::string &word) { return isAmong(word, kTimeWords); };
    return std::ranges::count_if(words, isNamed) == 1 && std::ranges::all_of(words, [&](const std::string &word) {
               return isNamed(word) || isAmong(word, kTimeCompanions);
           });
}

/// A name that a program makes up of a quantity and of the joint or body that it belongs to.
struct CompoundName {
    Words words;
    std::string owner;
    int derivatives = 0;
};

/// "P[3.1]", "V[3,1]", "Trace:1 P[X]": position, velocity and acceleration in Inventor's Output Grapher.
std::optional<CompoundName> fromInventor(std::string_view name)
{
    const std::size_t begin = name.rfind(' ') + 1;
    const std::string owner(trimmed(name.substr(0, begin)));
    name.remove_prefix(begin);
    if (name.size() < 4 || !isAmong(name.substr(0, 1), "P V A") || name[1] != '[' || name.back() != ']') {
        return std::nullopt;
    }
    std::string index(name.substr(2, name.size() - 3));
    if (owner.empty()) {
        return CompoundName{{std::string(1, name[0])}, std::move(index)};
    }
    return CompoundName{{std::string(1, name[0]), std::string(1, lowerCase(index[0]))}, owner}; // "z" means nothing
}

/// "slider.s", "der(crank.phi)": what a joint or body does in Modelica's library.
std::optional<CompoundName> fromModelica(std::string_view name)
{
    CompoundName compound;
    for (; name.starts_with("der(") && name.ends_with(')'); name = name.substr(4, name.size() - 5)) {
        ++compound.derivatives;
    }
    const std::size_t dot = name.rfind('.');
    const bool isPath = dot != name.npos && dot > 0 && isLetter(name[0]) && name.find_first_of(" ,;:(") == name.npos;
    if (!isPath || !find(name.substr(dot)) || isTime(wordsOf(name.substr(0, dot)))) { // "time.s" is the time in seconds
        return std::nullopt;
    }
    compound.words = {std::string(name.substr(dot))};
    compound.owner = name.substr(0, dot);
    return compound;
}

/// "Pos_TX@Slider", and in a pair of time and values "Y:Pos_TX-Slider@Model1": RecurDyn.
std::optional<CompoundName> fromRecurDyn(std::string_view name)
{
    const bool isPair = name.starts_with("Y:");
    name.remove_prefix(isPair ? 2 : 0);
    const std::size_t end = name.find(isPair ? '-' : '@');
    return end == name.npos
               ? std::nullopt
               : std::optional(CompoundName{wordsOf(name.substr(0, end)), std::string(name.substr(end + 1))});
}

std::optional<Coordinate> coordinateOf(Body body, std::optional<Dimension> dimension, char axis)
{
    switch (body) {
    case Body::Crank: return Theta2;
    case Body::Coupler: return dimension == Dimension::Angle ? std::optional<Coordinate>(Theta3) : std::nullopt;
    case Body::Slider: return axis == 'y' ? R4y : R4x;
    }
    return std::nullopt;
}

/// What words say together; nothing where one of them is not understood. `derivatives`: taken of it besides.
NameMeaning fromWords(const Words &words, std::optional<Body> body, int derivatives, const Heading &heading)
{
    NameMeaning meaning;
    std::optional<Order> order;
    char axis = ' ';
    char number = ' '; // of the body, behind θ, ω or α
    bool isGreek = false;
    const auto contradicts = [](const auto &known, const auto &before) { return known && before && known != before; };
    for (const std::string &word : words) {
        if (isDigit(word[0])) {
            number = isGreek && word.size() == 1 ? word[0] : number;
            continue;
        }
        // A single letter is a quantity when it stands alone, not in "a1" or "v_0"; "tx" is one beside others.
        const bool isLetterOfMany = word.size() == 1 && isAmong(word, "v a w") && words.size() > 1;
        const bool isAxisAlone = words.size() == 1 && isAmong(word, "tx ty rz psi");
        const Vocabulary *const known = isLetterOfMany || isAxisAlone ? nullptr : find(word);
        if (!known && isAmong(word, kFillers)) {
            continue;
        }
        if (!known || contradicts(known->dimension, meaning.dimension) || contradicts(known->body, body)) {
            return {}; // "rotation about x", "linear velocity of the crank": none of the channels
        }
        isGreek = isAmong(word, "theta omega alpha alfa tita");
        order = known->order ? std::max(known->order, order) : order;
        meaning.dimension = known->dimension ? known->dimension : meaning.dimension;
        body = known->body ? known->body : body;
        axis = known->axis != ' ' ? known->axis : axis;
    }
    if (number != ' ' && !body) {
        body = number == '2' ? Body::Crank : Body::Coupler;
    }
    const auto bodyDimension = body == Body::Crank    ? std::optional(Dimension::Angle)
                               : body == Body::Slider ? std::optional(Dimension::Length)
                                                      : std::nullopt;
    if ((number != ' ' && number != '2' && number != '3') || contradicts(bodyDimension, meaning.dimension)) {
        return {};
    }
    const std::optional<Unit> unit = parseUnit(heading.unit);
    for (const std::optional<Dimension> told :
         {bodyDimension, unit ? std::optional(unit->dimension) : std::nullopt, heading.dimension}) {
        meaning.dimension = meaning.dimension ? meaning.dimension : told;
    }
    const bool isPositionAlone =
        axis != ' ' ? words.size() == 1 || body : body && meaning.dimension == Dimension::Angle;
    if (!order && isPositionAlone) {
        order = Order::Position; // "x", "slider y", "crank"
    }
    if (!order || static_cast<int>(*order) + derivatives > 2) {
        return {};
    }
    meaning.order = static_cast<Order>(static_cast<int>(*order) + derivatives);
    meaning.alongY = axis == 'y';
    meaning.kind = NameMeaning::Kind::Quantity;
    if (body) {
        const std::optional<Coordinate> coordinate = coordinateOf(*body, meaning.dimension, axis);
        meaning.kind = coordinate ? NameMeaning::Kind::Channel : NameMeaning::Kind::Nothing;
        meaning.channel = {coordinate.value_or(R4x), meaning.order};
    }
    return meaning;
}

void findComponents(std::vector<Heading> &row)
{
    std::optional<std::size_t> magnitude;
    for (std::size_t i = 0; i < row.size(); ++i) {
        Heading &heading = row[i];
        if (heading.name != "X-comp" && heading.name != "Y-comp") {
            magnitude = meaningOf(heading).kind == NameMeaning::Kind::Quantity ? std::optional(i) : std::nullopt;
        } else if (magnitude) {
            Heading &whole = row[*magnitude];
            whole.component = whole.component.value_or(i);
            heading.name = whole.name + (heading.name[0] == 'X' ? " x" : " y");
            heading.unit = heading.unit.empty() ? whole.unit : heading.unit;
        }
    }
}

std::string perSecond(std::string_view unit, Order order)
{
    return std::string(unit) + (order == Order::Position ? "" : order == Order::Velocity ? "/s" : "/s2");
}

} // namespace

Heading parseHeading(std::string_view cell)
{
    Heading heading;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        heading.printed += cell[i];
        i += cell.substr(i).starts_with("\"\"") ? 1 : 0;
    }
    std::string_view name = heading.printed;
    heading.name = name;
    if (fromModelica(name)) {
        return heading;
    }
    if (name.ends_with(']') || name.ends_with(')')) {
        const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
        if (open == name.npos) {
            return heading;
        }
        const std::string_view inside = trimmed(name.substr(open + 1, name.size() - open - 2));
        // "3.1" of "P[3.1]" is no unit, nor is "X" of "P[X]".
        const bool isIndex = name.back() == ']' && !inside.empty() &&
                             (inside.find_first_not_of("0123456789.,: ") == inside.npos || isAmong(inside, "X Y Z"));
        if (!isIndex) {
            heading.unit = name.starts_with("X:") ? "" : inside; // in a pair of RecurDyn it is that of the values
            heading.name = trimmed(name.substr(0, open));
        }
        return heading;
    }
    for (const char separator : {',', ' ', '_'}) {
        const std::size_t at = name.rfind(separator);
        const std::string_view tail = at == name.npos || at == 0 ? std::string_view() : trimmed(name.substr(at + 1));
        if (tail != "in" && tail != "min" && parseUnit(tail)) { // these are words as well
            heading.unit = tail;
            heading.name = trimmed(name.substr(0, at));
            break;
        }
    }
    return heading;
}

NameMeaning meaningOf(const Heading &heading)
{
    NameMeaning meaning;
    if (heading.name.starts_with("X:")) { // of a pair of RecurDyn
        meaning.kind = NameMeaning::Kind::Time;
        return meaning;
    }
    for (const auto &splitName : {fromInventor, fromModelica, fromRecurDyn}) {
        const std::optional<CompoundName> compound = splitName(heading.name);
        if (!compound) {
            continue;
        }
        const std::string_view component = std::string_view(compound->owner).substr(compound->owner.rfind('.') + 1);
        meaning = fromWords(compound->words, bodyAmong(component), compound->derivatives, heading);
        if (meaning.kind != NameMeaning::Kind::Nothing) {
            meaning.isModelica = splitName == fromModelica;
            meaning.owner = splitName == fromRecurDyn ? "" : compound->owner;
            return meaning;
        }
    }
    Words words = wordsOf(heading.name);
    if (words.size() == 2 && isAmong(words[0], "v a") && isAmong(words[1], "x y")) {
        words = {words[0] + words[1]}; // "v_x", "v_{x}"
    }
    meaning = NameMeaning();
    if (words.empty()) {
        return meaning;
    }
    if (isTime(words)) {
        const bool isCounted = isAmong(heading.unit, kCounted);
        meaning.kind = isCounted ? NameMeaning::Kind::RowNumber : NameMeaning::Kind::Time;
    } else if (const std::optional<Channel> channel = channelSpelled(words)) {
        meaning.kind = NameMeaning::Kind::Channel;
        meaning.channel = *channel;
        meaning.order = channel->order;
        meaning.isExact = true;
    } else if (words.size() == 1 && isAmong(words[0], kRowNumbers)) {
        meaning.kind = NameMeaning::Kind::RowNumber;
    } else {
        meaning = fromWords(words, {}, 0, heading);
    }
    return meaning;
}

bool isCrankAngle(const Heading &heading)
{
    const NameMeaning meaning = meaningOf(heading);
    const bool isNamed =
        meaning.kind == NameMeaning::Kind::Channel && meaning.channel == Channel{Theta2, Order::Position};
    std::string letters;
    for (const char c : heading.name) {
        letters += isLetter(c) ? std::string(1, lowerCase(c)) : "";
    }
    return isNamed || isAmong(letters, kCrankAngles);
}

bool endsInQuantity(const Heading &heading)
{
    Words words = wordsOf(heading.name);
    std::erase_if(words, [](const std::string &word) { return isDigit(word[0]); });
    if (words.size() < 2) {
        return false;
    }
    const Vocabulary *const known = find(words.back());
    return known && !known->body && (words.back().size() > 1 || known->axis != ' ');
}

bool saysNothing(const Heading &heading)
{
    return std::ranges::all_of(wordsOf(heading.name), [](const std::string &word) {
        return isDigit(word[0]) || isAmong(word, "y value values data output result results plot curve series valor "
                                                 "valores datos salida resultado resultados curva serie");
    });
}

void relateHeadings(std::vector<Heading> &row)
{
    findComponents(row);
    std::vector<NameMeaning> meanings(row.size());
    std::ranges::transform(row, meanings.begin(), meaningOf);
    for (std::size_t i = 0; i < row.size(); ++i) {
        NameMeaning &meaning = meanings[i];
        if (meaning.owner.empty() || meaning.kind == NameMeaning::Kind::Nothing) {
            continue;
        }
        for (std::size_t j = 0; j < row.size() && !meaning.dimension; ++j) {
            row[i].dimension = meaning.dimension =
                meanings[j].owner == meaning.owner ? meanings[j].dimension : std::nullopt;
        }
        if (meaning.isModelica && meaning.dimension && row[i].unit.empty()) {
            row[i].unit = perSecond(meaning.dimension == Dimension::Angle ? "rad" : "m", meaning.order);
            row[i].unitOfModelica = true;
        }
    }
}

bool giveUnits(std::vector<Heading> &row, std::string_view ofLengths, std::string_view ofAngles)
{
    bool any = false;
    for (Heading &heading : row) {
        const NameMeaning meaning = meaningOf(heading);
        std::optional<Dimension> dimension = meaning.dimension;
        if (meaning.isExact) {
            dimension = isAngle(meaning.channel.coordinate) ? Dimension::Angle : Dimension::Length;
        }
        const std::string_view unit = dimension == Dimension::Length  ? ofLengths
                                      : dimension == Dimension::Angle ? ofAngles
                                                                      : "";
        if (heading.unit.empty() && !unit.empty()) {
            heading.unit = perSecond(unit, meaning.order);
            any = true;
        }
    }
    return any;
}

} // namespace slidercrank
