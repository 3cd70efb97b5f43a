// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cell_scanner.h"
#include "core/import/text_encoding.h"

#include <algorithm>
#include <array>
#include <vector>

namespace slidercrank
{

namespace
{

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}

bool isLetter(char c)
{
    return isUpper(c) || (c >= 'a' && c <= 'z');
}

struct Spelling {
    std::string_view printed;
    std::string_view plain;
};

/// What people write beyond ASCII, in plain letters.
constexpr std::array<Spelling, 27> kSpellings{
    {{"á", "a"},     {"é", "e"},     {"í", "i"},     {"ó", "o"},     {"ú", "u"},     {"ü", "u"},    {"ñ", "n"},
     {"Á", "A"},     {"É", "E"},     {"Í", "I"},     {"Ó", "O"},     {"Ú", "U"},     {"Ü", "U"},    {"Ñ", "N"},
     {"θ", "theta"}, {"ω", "omega"}, {"α", "alpha"}, {"ϑ", "theta"}, {"Θ", "theta"}, {"²", "2"},    {"³", "3"},
     {"⁴", "4"},     {"₂", "2"},     {"₃", "3"},     {"₄", "4"},     {"\u0301", ""}, {"\u0303", ""}}};

/// In ASCII; what has no plain spelling becomes '?', a letter that is in no word known here.
std::string plainSpelling(std::string_view name)
{
    std::string plain;
    while (!name.empty()) {
        if (static_cast<unsigned char>(name[0]) < 0x80) {
            plain += name[0];
            name.remove_prefix(1);
            continue;
        }
        const auto spelling = std::find_if(kSpellings.begin(), kSpellings.end(),
                                           [&](const Spelling &each) { return name.starts_with(each.printed); });
        if (spelling != kSpellings.end()) {
            plain += spelling->plain;
            name.remove_prefix(spelling->printed.size());
            continue;
        }
        plain += '?';
        name.remove_prefix(std::max<std::size_t>(sequenceLength(name), 1));
    }
    return plain;
}

/// The runs of letters and the runs of digits, in lower case; "SliderPosition" are two words.
std::vector<std::string> wordsOf(const std::string &plain)
{
    std::vector<std::string> words;
    char before = ' ';
    for (const char c : plain) {
        const bool letter = isLetter(c) || c == '?';
        if (letter || isDigit(c)) {
            const bool goesOn =
                letter ? (isLetter(before) || before == '?') && !(isUpper(c) && !isUpper(before)) : isDigit(before);
            if (!goesOn) {
                words.emplace_back();
            }
            words.back() += isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
        }
        before = c;
    }
    return words;
}

constexpr std::string_view kTimeWords = "time times t tiempo timestamp zeit temps tempo instante";
/// Beside a word for the time, these change nothing.
constexpr std::string_view kTimeCompanions = "elapsed row sim simulation simulacion transcurrido de la stamp latest";
constexpr std::string_view kRowNumbers = "n no nr num index row id fila frame paso step sample point node nodo element elemento";
/// In the place of a time's unit.
constexpr std::string_view kCounted = "steps step frames frame samples sample rows points pasos muestras";
constexpr std::string_view kFillers = "de del la el of the en component componente trans translational latest";

enum class Body { Crank, Coupler, Slider };

struct Vocabulary {
    std::string_view words;
    std::optional<Order> order;
    std::optional<Dimension> dimension;
    std::optional<Body> body;
    char axis = ' ';
};

constexpr std::nullopt_t kOpen = std::nullopt;
constexpr std::array<Vocabulary, 21> kVocabulary{{
    {"position posicion pos displacement disp desplazamiento", Order::Position, kOpen, kOpen},
    {"coordinate coordenada stroke carrera", Order::Position, Dimension::Length, kOpen},
    {"x", kOpen, Dimension::Length, kOpen, 'x'},
    {"y", kOpen, Dimension::Length, kOpen, 'y'},
    {"velocity velocidad speed vel v geschwindigkeit", Order::Velocity, kOpen, kOpen},
    {"vx", Order::Velocity, Dimension::Length, kOpen, 'x'},
    {"vy", Order::Velocity, Dimension::Length, kOpen, 'y'},
    {"acceleration aceleracion accel acel acc a beschleunigung", Order::Acceleration, kOpen, kOpen},
    {"tx", kOpen, Dimension::Length, kOpen, 'x'},
    {"ty", kOpen, Dimension::Length, kOpen, 'y'},
    {"rz", kOpen, Dimension::Angle, kOpen},
    {"ax", Order::Acceleration, Dimension::Length, kOpen, 'x'},
    {"ay", Order::Acceleration, Dimension::Length, kOpen, 'y'},
    {"angle angulo rotation rotacion giro orientation theta tita", Order::Position, Dimension::Angle, kOpen},
    {"ang angular rotational", kOpen, Dimension::Angle, kOpen},
    {"omega w", Order::Velocity, Dimension::Angle, kOpen},
    {"alpha alfa", Order::Acceleration, Dimension::Angle, kOpen},
    {"linear lineal", kOpen, Dimension::Length, kOpen},
    {"crank manivela kurbel", kOpen, Dimension::Angle, Body::Crank},
    {"coupler rod conrod connecting biela acoplador pleuel", kOpen, kOpen, Body::Coupler},
    {"slider piston corredera deslizadera deslizador deslizante embolo block bloque", kOpen, kOpen, Body::Slider},
}};

std::string joined(const std::vector<std::string> &words)
{
    std::string all;
    for (const std::string &word : words) {
        all += word == "dot" ? "diff" : word == "ddot" ? "diff2" : word;
    }
    return all;
}

/// nameOf() in small letters, without underscores.
const std::array<std::string, kChannelCount> &plainChannelNames()
{
    static const std::array<std::string, kChannelCount> names = [] {
        std::array<std::string, kChannelCount> plain;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            plain[index] = nameOf(channelAt(index));
            std::erase(plain[index], '_');
            plain[index][0] = plain[index][0] == 'R' ? 'r' : plain[index][0];
        }
        return plain;
    }();
    return names;
}

/// The channel whose name has the same letters and digits, whatever stands between them.
std::optional<Channel> channelSpelled(const std::vector<std::string> &words)
{
    const std::array<std::string, kChannelCount> &names = plainChannelNames();
    const auto index = static_cast<std::size_t>(std::ranges::find(names, joined(words)) - names.begin());
    return index < kChannelCount ? std::optional(channelAt(index)) : std::nullopt;
}

bool isTime(const std::vector<std::string> &words)
{
    std::size_t count = 0;
    for (const std::string &word : words) {
        const bool time = isAmong(word, kTimeWords);
        count += time ? 1 : 0;
        if (!time && !isAmong(word, kTimeCompanions)) {
            return false;
        }
    }
    return count == 1;
}

bool isAxis(std::string_view text)
{
    return text == "X" || text == "Y" || text == "Z";
}

/// "P[3.1]", "V[3,1]", "A[1]": the Output Grapher's position, velocity and acceleration of a joint; "Trace:1 P[X]" of a
/// point that is traced.
std::optional<NameMeaning> outputGrapher(std::string_view name)
{
    const std::size_t begin = name.rfind(' ') + 1;
    const std::string_view owner = trimmed(name.substr(0, begin));
    name.remove_prefix(begin);
    if (name.size() < 4 || name[1] != '[' || name.back() != ']') {
        return std::nullopt;
    }
    NameMeaning meaning;
    meaning.kind = NameMeaning::Kind::Quantity;
    switch (name[0]) {
    case 'P': meaning.order = Order::Position; break;
    case 'V': meaning.order = Order::Velocity; break;
    case 'A': meaning.order = Order::Acceleration; break;
    default: return std::nullopt;
    }
    meaning.outputIndex = name.substr(2, name.size() - 3);
    if (!owner.empty()) {
        if (!isAxis(meaning.outputIndex)) {
            return std::nullopt;
        }
        if (meaning.outputIndex == "Z") {
            return NameMeaning{}; // the motion is plane
        }
        meaning.dimension = Dimension::Length;
        meaning.alongY = meaning.outputIndex == "Y";
        meaning.outputIndex += owner;
    }
    return meaning;
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

/// What words say together; nothing where one of them is not understood.
NameMeaning fromWords(const std::vector<std::string> &words, const std::optional<Unit> &unit)
{
    NameMeaning meaning;
    std::optional<Body> body;
    std::optional<int> number; // of the body, behind θ, ω or α
    char axis = ' ';
    bool greek = false;
    bool contradiction = false;
    for (const std::string &word : words) {
        if (isDigit(word[0])) {
            if (greek && word.size() == 1) {
                number = word[0] - '0';
            }
            continue;
        }
        // A single letter is a quantity when it stands alone, not in "a1" or "v_0"; "tx" is one beside others.
        const bool letterOfMany = word.size() == 1 && word != "x" && word != "y" && words.size() > 1;
        const bool axisAlone = words.size() == 1 && isAmong(word, "tx ty rz");
        const auto known = letterOfMany || axisAlone
                               ? kVocabulary.end()
                               : std::find_if(kVocabulary.begin(), kVocabulary.end(),
                                              [&](const Vocabulary &each) { return isAmong(word, each.words); });
        if (known == kVocabulary.end()) {
            if (!isAmong(word, kFillers)) {
                return {};
            }
            continue;
        }
        greek = word == "theta" || word == "omega" || word == "alpha" || word == "alfa" || word == "tita";
        if (known->order) {
            meaning.order = std::max(known->order, meaning.order);
        }
        if (known->dimension) {
            // "linear velocity of the crank", "rotation about x": nothing that is among the channels
            contradiction = contradiction || (meaning.dimension && meaning.dimension != known->dimension);
            meaning.dimension = known->dimension;
        }
        if (known->body) {
            contradiction = contradiction || (body && body != known->body);
            body = known->body;
        }
        axis = known->axis != ' ' ? known->axis : axis;
    }
    if (contradiction || (number && (*number < 2 || *number > 4))) {
        return {};
    }
    if (!body && number) {
        body = *number == 2 ? Body::Crank : Body::Coupler;
        if (*number == 4) {
            return {};
        }
    }
    if (body == Body::Slider) {
        if (meaning.dimension == Dimension::Angle) {
            return {};
        }
        meaning.dimension = Dimension::Length;
    }
    if (!meaning.dimension && unit) {
        meaning.dimension = unit->dimension;
    }
    if (!meaning.order && !(axis != ' ' && words.size() == 1) && !body) {
        return {};
    }
    if (!meaning.order && (axis != ' ' || meaning.dimension == Dimension::Angle)) {
        meaning.order = Order::Position;
    }
    if (!meaning.order) {
        return {};
    }
    meaning.alongY = axis == 'y';
    meaning.kind = NameMeaning::Kind::Quantity;
    if (body) {
        const std::optional<Coordinate> coordinate = coordinateOf(*body, meaning.dimension, axis);
        if (!coordinate) {
            return {};
        }
        meaning.kind = NameMeaning::Kind::Channel;
        meaning.channel = {*coordinate, *meaning.order};
    }
    return meaning;
}

/// "v_x" and "v_{x}" are one word.
std::vector<std::string> withComponentsJoined(std::vector<std::string> words)
{
    if (words.size() == 2 && isAmong(words[0], "v a") && isAmong(words[1], "x y")) {
        words = {words[0] + words[1]};
    }
    return words;
}

/// The one body that is among the words.
std::optional<Body> bodyAmong(const std::vector<std::string> &words)
{
    std::optional<Body> body;
    for (const std::string &word : words) {
        const auto known = std::ranges::find_if(
            kVocabulary, [&](const Vocabulary &each) { return each.body && isAmong(word, each.words); });
        if (known == kVocabulary.end()) {
            continue;
        }
        if (body && body != known->body) {
            return std::nullopt;
        }
        body = known->body;
    }
    return body;
}

/// "slider.s", "der(crank.phi)": how Modelica's library names what a joint, or a body, does.
std::optional<NameMeaning> fromModelica(std::string_view name, const std::optional<Unit> &unit)
{
    int order = 0;
    while (name.starts_with("der(") && name.ends_with(')')) {
        name = name.substr(4, name.size() - 5);
        ++order;
    }
    const std::size_t dot = name.rfind('.');
    const bool isPath = dot != name.npos && dot > 0 && isLetter(name[0]) && std::ranges::all_of(name, [](char c) {
                            return isLetter(c) || isDigit(c) || c == '_' || c == '.' || c == '[' || c == ']';
                        });
    if (!isPath || isTime(wordsOf(std::string(name.substr(0, dot))))) { // "time.s" is the time in seconds
        return std::nullopt;
    }
    NameMeaning meaning;
    const std::string_view variable = name.substr(dot + 1);
    if (variable == "s" || variable == "v") {
        meaning.dimension = Dimension::Length;
    } else if (variable == "phi" || variable == "w") {
        meaning.dimension = Dimension::Angle;
    } else if (variable != "a") {
        return std::nullopt;
    }
    order += variable == "a" ? 2 : variable == "v" || variable == "w" ? 1 : 0;
    if (order > 2) {
        return std::nullopt;
    }
    meaning.isModelica = true;
    meaning.order = static_cast<Order>(order);
    const std::string_view component = name.substr(0, dot);
    meaning.outputIndex = component;
    meaning.kind = NameMeaning::Kind::Quantity;
    if (!meaning.dimension && unit) {
        meaning.dimension = unit->dimension;
    }
    const std::optional<Body> body = bodyAmong(wordsOf(std::string(component.substr(component.rfind('.') + 1))));
    if (body) {
        const Dimension usual = body == Body::Slider ? Dimension::Length : Dimension::Angle;
        if (meaning.dimension.value_or(usual) != usual) {
            return NameMeaning{};
        }
        meaning.dimension = usual;
        meaning.kind = NameMeaning::Kind::Channel;
        meaning.channel = {*coordinateOf(*body, usual, ' '), *meaning.order};
    }
    return meaning;
}

/// A quantity and what it is of, as RecurDyn names them: "Pos_TX" and "Slider".
NameMeaning fromRecurDyn(std::string_view quantity, std::string_view owner, const std::optional<Unit> &unit)
{
    std::vector<std::string> words = wordsOf(plainSpelling(quantity));
    std::ranges::replace(words, std::string("psi"), std::string("rz")); // the angle about z
    if (const std::optional<Body> body = bodyAmong(wordsOf(plainSpelling(owner)))) {
        words.emplace_back(body == Body::Crank ? "crank" : body == Body::Coupler ? "coupler" : "slider");
    }
    return fromWords(words, unit);
}

/// "Y:Pos_TX-Slider@Model1".
NameMeaning fromPair(const Heading &heading)
{
    const std::size_t end = std::min(heading.name.find('@'), heading.name.size());
    const std::string_view name = std::string_view(heading.name).substr(2, end - 2);
    const std::size_t dash = std::min(name.find('-'), name.size());
    return fromRecurDyn(name.substr(0, dash), name.substr(dash), unitOf(heading.unit));
}

/// "Pos_TX@Slider"; nothing where it is something else.
std::optional<NameMeaning> fromRequest(const Heading &heading)
{
    const std::string_view name = heading.name;
    const std::size_t at = name.find('@');
    if (at == name.npos) {
        return std::nullopt;
    }
    const NameMeaning meaning = fromRecurDyn(name.substr(0, at), name.substr(at), unitOf(heading.unit));
    return meaning.kind == NameMeaning::Kind::Nothing ? std::nullopt : std::optional(meaning);
}

/// "3.1" of "P[3.1]" is no unit, nor is "X" of "P[X]".
bool isIndex(std::string_view text)
{
    return text.find_first_not_of("0123456789.,: ") == text.npos || isAxis(text);
}

} // namespace

Heading headingOf(std::string_view cell)
{
    Heading heading;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        heading.printed += cell[i];
        if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') {
            ++i; // a doubled mark stands for one
        }
    }
    std::string_view name = heading.printed;
    const bool isWhole = name.starts_with("der(") && name.ends_with(')') && name.find(' ') == name.npos;
    if (isWhole) {
        heading.name = name; // a derivative in Modelica
        return heading;
    }
    if (!name.empty() && (name.back() == ']' || name.back() == ')')) {
        const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
        const bool index = open != name.npos && name.back() == ']' && open + 2 < name.size() &&
                           isIndex(name.substr(open + 1, name.size() - open - 2));
        if (open != name.npos && !index) {
            heading.unit = trimmed(name.substr(open + 1, name.size() - open - 2));
            name = trimmed(name.substr(0, open));
        }
    } else {
        for (const char separator : {',', ' ', '_'}) {
            const std::size_t at = name.rfind(separator);
            if (at == name.npos || at == 0) {
                continue;
            }
            const std::string_view tail = trimmed(name.substr(at + 1));
            if (tail != "in" && tail != "min" && unitOf(tail)) { // these are words as well
                heading.unit = tail;
                name = trimmed(name.substr(0, at));
                break;
            }
        }
    }
    heading.name = name;
    return heading;
}

NameMeaning meaningOf(const Heading &heading)
{
    if (const std::optional<NameMeaning> grapher = outputGrapher(heading.name)) {
        return *grapher;
    }
    if (heading.part == Heading::Part::Abscissa) {
        return {};
    }
    if (heading.part == Heading::Part::Ordinate) {
        return fromPair(heading);
    }
    if (const std::optional<NameMeaning> request = fromRequest(heading)) {
        return *request;
    }
    if (const std::optional<NameMeaning> modelica = fromModelica(heading.name, unitOf(heading.unit))) {
        return *modelica;
    }
    NameMeaning meaning;
    const std::vector<std::string> words = withComponentsJoined(wordsOf(plainSpelling(heading.name)));
    if (words.empty()) {
        return meaning;
    }
    if (isTime(words)) {
        const bool isCounted = isAmong(plainSpelling(heading.unit), kCounted);
        meaning.kind = isCounted ? NameMeaning::Kind::RowNumber : NameMeaning::Kind::Time;
    } else if (const std::optional<Channel> channel = channelSpelled(words)) {
        meaning.kind = NameMeaning::Kind::Channel;
        meaning.channel = *channel;
        meaning.fileName = true;
    } else if (words.size() == 1 && isAmong(words[0], kRowNumbers)) {
        meaning.kind = NameMeaning::Kind::RowNumber;
    } else {
        meaning = fromWords(words, unitOf(heading.unit));
    }
    return meaning;
}

bool endsInQuantity(const Heading &heading)
{
    std::vector<std::string> words = wordsOf(plainSpelling(heading.name));
    std::erase_if(words, [](const std::string &word) { return isDigit(word[0]); });
    if (words.size() < 2) {
        return false;
    }
    const std::string &last = words.back();
    return isAmong(last, "x y") || (last.size() > 1 && std::ranges::any_of(kVocabulary, [&](const Vocabulary &each) {
                                        return !each.body && isAmong(last, each.words);
                                    }));
}

bool saysNothing(const Heading &heading)
{
    const std::vector<std::string> words = wordsOf(plainSpelling(heading.name));
    return std::ranges::all_of(words, [](const std::string &word) {
        return isDigit(word[0]) || isAmong(word, "y value values data output result results plot curve series valor "
                                                 "valores datos salida resultado resultados curva serie");
    });
}

} // namespace slidercrank
