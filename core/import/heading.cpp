// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cells.h"
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

/// Letters outside ASCII, and their plain spelling.
constexpr std::string_view kLetterSpellings =
    "á=a|à=a|â=a|ã=a|ä=a|ç=c|é=e|è=e|ê=e|í=i|ì=i|ó=o|ò=o|ô=o|õ=o|ö=o|ú=u|ù=u|ü=u|ñ=n|Á=A|Â=A|Ä=A|É=E|Í=I|Ó=O|Ö=O|Ú=U|"
    "Ü=U|Ñ=N|\u0300=|\u0301=|\u0303=|\u0308=|θ=theta|ϑ=theta|Θ=theta|φ=phi|ϕ=phi|ψ=psi|ω=omega|α=alpha|"
    "²=2|³=3|⁴=4|₂=2|₃=3|₄=4|°=";

/// Also true for the bytes of other letters outside ASCII, which no known word contains.
bool isLetter(char c)
{
    return (lowerCase(c) >= 'a' && lowerCase(c) <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Splits a name into runs of letters and runs of digits, in lower case. "SliderPosition" has two words.
Words wordsOf(std::string_view name)
{
    Words words;
    char before = ' ';
    for (const char c : respelled(name, kLetterSpellings)) {
        const bool startsWithCapital = lowerCase(c) != c && lowerCase(before) == before;
        const bool continues = isLetter(c) ? isLetter(before) && !startsWithCapital : isDigit(before);
        if (isLetter(c) || isDigit(c)) {
            words.resize(words.size() + (continues ? 0 : 1));
            words.back() += lowerCase(c);
        }
        before = c;
    }
    return words;
}

constexpr std::string_view kTimeWords = "time times t tiempo timestamp zeit temps tempo instante millis micros";
constexpr std::string_view kTimeCompanions =
    "elapsed row sim simulation simulacion transcurrido de la stamp latest since start relative";
constexpr std::string_view kRowNumbers =
    "n no nr num index row id fila frame paso step sample point node nodo element elemento";
constexpr std::string_view kCountedUnits = "steps step frames frame samples sample rows points pasos muestras";
enum class Body { Crank, Coupler, Slider };

/// What a word, or a name of several words, says about a quantity.
struct WordMeaning {
    std::string_view words{};
    std::optional<Order> order{};
    std::optional<Dimension> dimension{};
    char axis = ' ';
    std::optional<Body> body{};
};

/// Returns what a word says. Words with a dot are variables of Modelica, capital letters those of Inventor.
const WordMeaning *find(std::string_view word)
{
    using enum Order;
    using enum Dimension;
    using enum Body;
    constexpr std::nullopt_t kOpen = std::nullopt;
    static constexpr std::array<WordMeaning, 23> kVocabulary{{
        {"position posicion posizione posicao lage pos displacement disp desplazamiento deplacement spostamento "
         "deslocamento "
         "verschiebung weg P",
         Position},
        {"coordinate coordenada distance distancia abstand stroke carrera hub .s", Position, Length},
        {"velocity velocidad velocita velocidade vitesse speed vel v geschwindigkeit V", Velocity},
        {"acceleration aceleracion accelerazione aceleracao accelerometer accel acel acc a beschleunigung A .a",
         Acceleration},
        {"x tx", kOpen, Length, 'x'},
        {"y ty", kOpen, Length, 'y'},
        {"vx", Velocity, Length, 'x'},
        {"vy", Velocity, Length, 'y'},
        {"ax", Acceleration, Length, 'x'},
        {"ay", Acceleration, Length, 'y'},
        {"angle angulo angolo rotation rotacion rotazione giro orientation theta tita phi winkel .phi", Position,
         Angle},
        {"omega w .w", Velocity, Angle},
        {"alpha alfa", Acceleration, Angle},
        {".v", Velocity, Length},
        {"ang angular angulaire angolare rotational rz psi", kOpen, Angle},
        {"linear lineal lineaire lineare", kOpen, Length},
        {"crank input manivela manivelle manovella kurbel", kOpen, Angle, ' ', Crank},
        {"ca cad kurbelwinkel drehwinkel", Position, Angle, ' ', Crank},
        {"coupler rod conrod connecting biela bielle biella acoplador pleuel", kOpen, kOpen, ' ', Coupler},
        {"pleuelwinkel", Position, Angle, ' ', Coupler},
        {"slider piston pistone pistao corredera deslizadera deslizador deslizante embolo block bloque kolben schieber",
         kOpen, Length, ' ', Slider},
        {"kolbenweg kolbenposition kolbenhub schieberweg", Position, Length, ' ', Slider},
        {"de del la el da do du of the en component componente comp trans translational latest"},
    }};
    return findElement(kVocabulary, [&](const WordMeaning &known) { return isAmong(word, known.words); });
}

/// Sets `all` to a value that is known. Returns false if it is another one than before.
template <typename Value>
bool merge(std::optional<Value> &all, const std::optional<Value> &value)
{
    const bool agrees = !all || !value || *all == *value;
    all = value ? value : all;
    return agrees;
}

/// Returns the channel whose name has the same letters and digits, regardless of punctuation. "dot" is a derivative.
std::optional<Channel> channelSpelled(const Words &words)
{
    std::string text;
    for (const std::string &word : words) {
        text += word == "dot" ? "diff" : word == "ddot" ? "diff2" : word;
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        std::string name = lowered(nameOf(channelAt(index)));
        std::erase(name, '_');
        if (name == text) {
            return channelAt(index);
        }
    }
    return std::nullopt;
}

bool isTime(const Words &words)
{
    const auto isNamed = [](const std::string &word) { return isAmong(word, kTimeWords); };
    const auto suits = [&](const std::string &word) { return isNamed(word) || isAmong(word, kTimeCompanions); };
    return std::ranges::any_of(words, isNamed) && std::ranges::all_of(words, suits);
}

/// The words of a name, which some programs compose of a quantity and the joint or body to which it belongs:
///
///     P[3.1]   V[3,1]                    Inventor's Output Grapher
///     slider.s   crank.phi               Modelica's library
///     Pos_TX@Slider   Y:Pos_TX-Slider    RecurDyn
struct SplitName {
    Words words{}; ///< with those of the owner that name a body
    std::string owner{};
    ColumnReason reason = ColumnReason::UnknownName; ///< that a name of this program implies
};

SplitName splitName(std::string_view name)
{
    SplitName split;
    const std::size_t prefix = name.starts_with("Y:") ? 2 : 0;
    const std::size_t sign = name.find(prefix > 0 ? '-' : '@');
    const std::size_t dot = std::min(name.rfind('.'), name.size());
    if (name.size() >= 4 && isAmong(name.substr(0, 1), "P V A") && name[1] == '[' && name.ends_with(']')) {
        split = {{std::string(name.substr(0, 1))},
                 std::string(name.substr(2, name.size() - 3)),
                 ColumnReason::AngleOrLength};
    } else if (sign != name.npos) {
        split = {wordsOf(name.substr(prefix, sign - prefix)), std::string(name.substr(sign + 1))};
    } else if (dot > 0 && isLetter(name[0]) && name.find_first_of(" ,;:(") == name.npos && find(name.substr(dot)) &&
               !isTime(wordsOf(name.substr(0, dot)))) { // "time.s" is the time in seconds
        split = {{std::string(name.substr(dot))}, std::string(name.substr(0, dot)), ColumnReason::ModelicaName};
    } else {
        split.words = wordsOf(name);
    }
    for (const std::string &word : wordsOf(split.owner.substr(split.owner.rfind('.') + 1))) {
        if (const WordMeaning *const known = find(word); known && known->body) {
            split.words.push_back(word);
        }
    }
    return split;
}

/// Returns what several words mean together, or nullopt if one of them is unknown or they contradict each other:
/// "rotation about x", "linear velocity of the crank".
std::optional<WordMeaning> combine(const Words &words)
{
    WordMeaning all;
    std::optional<Body> link; // by its number after θ, ω or α
    bool isGreek = false;
    for (const std::string &word : words) {
        if (isDigit(word[0])) {
            const bool isNumber = isGreek && word.size() == 1;
            if (isNumber && !isAmong(word, "2 3")) {
                return std::nullopt;
            }
            link = !isNumber ? link : word == "2" ? Body::Crank : Body::Coupler;
            continue;
        }
        // "v" is a velocity if it is the whole name, but not in "v_0"; "tx" is an axis only in longer names.
        const bool isAmbiguous = isAmong(word, words.size() > 1 ? "v a w" : "tx ty rz psi");
        const WordMeaning *const known = isAmbiguous ? nullptr : find(word);
        if (!known || !merge(all.dimension, known->dimension) || !merge(all.body, known->body)) {
            return std::nullopt;
        }
        isGreek = isAmong(word, "theta omega alpha alfa tita");
        all.order = std::max(all.order, known->order);
        all.axis = known->axis != ' ' ? known->axis : all.axis;
    }
    all.body = all.body ? all.body : link;
    const bool isOfCoupler = !all.body || all.body == Body::Coupler;
    const Dimension ofBody = all.body == Body::Crank ? Dimension::Angle : Dimension::Length;
    return isOfCoupler || merge(all.dimension, std::optional(ofBody)) ? std::optional(all) : std::nullopt;
}

/// Returns the channel or quantity of a name, given the unit if it is known; nullopt if it has none.
std::optional<NameMeaning> meaningOfWords(const SplitName &name, const std::string &unitText)
{
    const std::optional<WordMeaning> all = combine(name.words);
    if (!all) {
        return std::nullopt;
    }
    const std::optional<Unit> unit = parseUnit(unitText);
    const Dimension usual = unit ? unit->dimension : Dimension::Length;
    const bool isAngle = all->dimension.value_or(usual) == Dimension::Angle;
    const bool isPosition = all->axis != ' ' ? name.words.size() == 1 || all->body : all->body && isAngle;
    const std::optional<Order> order = all->order || !isPosition ? all->order : Order::Position; // "x", "crank"
    if (!order || (all->body == Body::Coupler && !isAngle)) {
        return std::nullopt;
    }
    if (name.reason == ColumnReason::AngleOrLength && !all->dimension && !unit) {
        return NameMeaning{.reason = unitText.empty() ? name.reason : ColumnReason::UnknownUnit};
    }
    const Coordinate coordinate = all->body == Body::Crank ? Theta2 : isAngle ? Theta3 : all->axis == 'y' ? R4y : R4x;
    const ColumnReason reason = name.reason == ColumnReason::ModelicaName && unitText.empty() ? name.reason
                                : all->body                                                   ? ColumnReason::KnownName
                                            : ColumnReason::QuantityInName;
    return NameMeaning{all->body ? Kind::Words : Kind::Quantity, {coordinate, *order}, reason, name.owner};
}

/// Returns whether an unknown name ends in a quantity: "J1_x", "part 7 velocity".
bool endsInQuantity(Words words)
{
    std::erase_if(words, [](const std::string &word) { return isDigit(word[0]); });
    const WordMeaning *const known = words.size() < 2 ? nullptr : find(words.back());
    return known && !known->body && (words.back().size() > 1 ? known->order || known->dimension : known->axis != ' ');
}

} // namespace

Heading parseHeading(std::string_view cell)
{
    Heading heading{.use = {.heading = respelled(cell, "\"\"=\"")}};
    const std::string_view name = heading.use.heading;
    heading.name = name;
    heading.use.unit = isAmong(lowered(name), "millis micros") ? name : ""; // functions of Arduino
    if (name.starts_with("X:")) { // RecurDyn writes pairs "X:Pos_TX-Slider(mm)" of time stamps, "Y:…" of values
        heading.name = "time";
        return heading;
    }
    if (splitName(name).reason == ColumnReason::ModelicaName) {
        return heading;
    }
    const bool hasBrackets = name.ends_with(']') || name.ends_with(')');
    for (const char separator : std::string_view(name.ends_with(']') ? "[" : hasBrackets ? "(" : ", _")) {
        const std::size_t at = name.rfind(separator);
        if (at == name.npos || (at == 0 && !hasBrackets)) {
            continue;
        }
        const std::string_view unit = trimmed(name.substr(at + 1, name.size() - at - (hasBrackets ? 2 : 1)));
        const bool isIndex = separator == '[' && looksNumeric(unit);            // "P[3.1]"
        const bool isKnown = !isAmong(unit, "in min h r u") && parseUnit(unit); // these are also words
        if (hasBrackets ? !isIndex : isKnown) {
            std::string_view rest = trimmed(name.substr(0, at));
            rest.remove_suffix(rest.ends_with(" in") ? 3 : 0); // "Time in s"
            heading.name = trimmed(rest);
            heading.use.unit = unit;
            break;
        }
    }
    return heading;
}

NameMeaning meaningOf(const Heading &heading)
{
    const std::string &unit = heading.use.unit;
    SplitName name = splitName(heading.name);
    Words &words = name.words;
    if (words.size() == 2 && isAmong(words[0], "v a") && isAmong(words[1], "x y")) {
        words = {words[0] + words[1]}; // "v_x", "v_{x}"
    }
    const bool isNamedTime = isTime(words);
    if (isNamedTime ? isAmong(unit, kCountedUnits) : words.size() == 1 && isAmong(words[0], kRowNumbers)) {
        return {.reason = ColumnReason::RowNumber};
    }
    if (isNamedTime) {
        return {Kind::Time};
    }
    if (const std::optional<Channel> channel = channelSpelled(words)) {
        return {Kind::ChannelName, *channel, ColumnReason::KnownName};
    }
    const ColumnReason unknown =
        endsInQuantity(wordsOf(heading.name)) ? ColumnReason::UnknownBody : ColumnReason::UnknownName;
    return meaningOfWords(name, unit).value_or(NameMeaning{.reason = unknown});
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
        heading.meaning = meaningOf(heading);
        const NameMeaning &meaning = heading.meaning;
        if (meaning.kind == Kind::Nothing) {
            heading.use.reason = heading.use.heading.empty() ? ColumnReason::NoName : meaning.reason;
        }
        if (!isComponent) {
            magnitude = meaning.kind == Kind::Quantity ? std::optional(i) : std::nullopt;
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
