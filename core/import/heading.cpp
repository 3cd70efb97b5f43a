// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cells.h"
#include "core/import/name_derivatives.h"
#include "core/import/name_path.h"
#include "core/import/spellings.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;
using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;

/// Units that are also words, symbols or primes: "min" is a minimum, r1 a length.
constexpr std::string_view kAlsoWords = "min h r r1 u g gr ' '' ?";

constexpr std::string_view kPixels = "px pixel pixels";

/// Returns whether a quantity or time can have the unit.
bool suits(const NameMeaning &meaning, const std::string &unit)
{
    const ColumnRole role = meaning.kind == Kind::Time ? ColumnRole::Time : ColumnRole::Channel;
    return meaning.kind != Kind::Nothing && parseColumnUnit(unit, role, meaning.channel);
}

/// Returns whether a text is a unit of the quantity or time that a name without unknown words denotes.
bool isUnitOf(std::string_view name, const std::string &unit)
{
    const NameMeaning meaning = parseUnit(unit) ? meaningOf(name, unit) : NameMeaning();
    return !meaning.hasUnknownWords && suits(meaning, unit);
}

/// Returns the unit of a name without the "in" of "t in s" or "t (en s)", unless it is that of inches: "a [in s^-2]".
std::string_view withoutPreposition(std::string_view unit, std::string_view name)
{
    const std::size_t end = std::min(unit.find_first_of(" _"), unit.size());
    const bool hasPreposition = end + 1 < unit.size() && isAmong(unit.substr(0, end), "in en em w v в");
    return hasPreposition && !isUnitOf(name, std::string(unit)) ? trimmed(unit.substr(end + 1)) : unit;
}

/// Returns the unit with which a text begins, before a remark or name: "deg" of "deg CCW from +x" and "Degrees of crank
/// rotation". Returns an empty text if there is none.
std::string_view unitAtBeginning(std::string_view text)
{
    for (std::size_t end = text.find_last_of(" ,;"); end != text.npos && end > 0;
         end = text.find_last_of(" ,;", end - 1)) {
        const std::string_view unit = text.substr(0, end);
        if (parseUnit(unit) && !isAmong(lowered(unit), kAlsoWords)) {
            return unit;
        }
    }
    return {};
}

/// Returns whether the content of brackets is a unit that suits no quantity: "(%)", "(×π rad)", "(px)".
bool isUnitOfNoQuantity(std::string_view content)
{
    return wordsOf(content).empty() || content.starts_with("×") || isAmong(content, kPixels);
}

/// Returns whether the content of round brackets, which is no known unit, is a remark: "(filtered)", "(exp)".
bool isRemarkInBrackets(std::string_view content)
{
    constexpr std::size_t kShortestRemark = 6; // bytes: "(bar)" is a unit
    const bool isLong = content.size() >= kShortestRemark && content.find('/') == content.npos;
    return isLong || abbreviatesMethod(wordsOf(content));
}

/// Returns whether brackets that begin at `begin` belong to the name: it has a meaning with them, as "x(B)", or they
/// contain an index, as in "P[3.1]" and "x_{1}".
bool areBracketsOfName(std::string_view text, std::size_t begin, std::string_view content)
{
    const NameMeaning whole = meaningOf(text, {});
    const bool isPoint = begin == 1 && content == "A";                   // "x(A)"
    const bool isVariable = content == "t" && !isBlank(text[begin - 1]); // "Main.Crank.theta(t)"
    const bool isIndex = isPoint || isVariable || isDigits(content) || (text[begin] == '[' && looksNumeric(content));
    return isIndex || (whole.kind != Kind::Nothing && !whole.hasUnknownWords);
}

void splitAtEnd(std::string_view text, Heading &heading);

/// Returns the unit behind a symbol that suits a name: "cm" of "x_B in cm", "d, cm" and "x/cm". Returns an empty text
/// if there is none.
std::string_view unitBehindSymbol(std::string_view text, std::string_view name)
{
    Heading heading;
    splitAtEnd(text, heading);
    const std::string &unit = heading.use.unit;
    const bool isUnit = beginsWithSymbol(heading) && isUnitOf(name, unit) && text.ends_with(unit);
    return isUnit ? text.substr(text.size() - unit.size()) : std::string_view();
}

/// Returns the unit in the brackets from `begin` to `end`, which may be empty or unknown; nullopt if what they contain
/// is a part of the name or a remark. A remark may follow a unit that suits a known name: "Crank angle (deg,
/// unwrapped)". An unknown unit is only at the end of the heading.
std::optional<std::string_view> unitInBrackets(std::string_view text, std::size_t begin, std::size_t end)
{
    const std::string_view name = trimmed(text.substr(0, begin));
    const std::string_view bracketed = withoutOrigin(trimmed(text.substr(begin + 1, end - begin - 1)));
    const std::string_view content = withoutPreposition(bracketed, name);
    if (parseUnit(content) || isUnitOfNoQuantity(content)) {
        return content;
    }
    if (const std::string_view first = unitAtBeginning(content); isUnitOf(name, std::string(first))) {
        return first;
    }
    if (const std::string_view ofSymbol = unitBehindSymbol(content, name); !ofSymbol.empty()) {
        return ofSymbol;
    }
    const bool isRemark = text[begin] == '<' || (text[begin] == '(' && isRemarkInBrackets(content));
    const bool isAtEnd = end + 1 == text.size();
    return isAtEnd && !isRemark && !areBracketsOfName(text, begin, content) ? std::optional(content) : std::nullopt;
}

/// Searches the brackets of a heading from the last ones for a unit. If there is one, sets the unit, and the name
/// without it, of "Position (m) Run #1", and returns true. A known unit goes before an unknown one after it: "x [mm]
/// (output)".
bool splitAtBrackets(std::string_view text, Heading &heading)
{
    constexpr std::string_view kOpening = "[({<";
    constexpr std::string_view kClosing = "])}>";
    bool hasUnit = false;
    for (std::size_t end = text.size(); end-- > 0;) {
        const std::size_t bracket = kClosing.find(text[end]);
        const std::size_t begin = bracket == kClosing.npos ? text.npos : text.substr(0, end).rfind(kOpening[bracket]);
        if (begin == text.npos) {
            continue;
        }
        const std::optional<std::string_view> unit = unitInBrackets(text, begin, end);
        const bool isKnown = unit && parseUnit(*unit);
        if (unit && (isKnown || !hasUnit)) {
            hasUnit = true;
            heading.name = trimmed(text.substr(0, begin));
            heading.name.erase(heading.name.find_last_not_of("/ ") + 1); // "x/(mm)"
            heading.name += text.substr(end + 1);
            heading.use.unit = *unit;
        }
        if (isKnown) {
            break;
        }
        end = begin;
    }
    return hasUnit;
}

/// Returns a unit with a slash before the seconds at its end, which names often lack: "m/s2" for "ms2".
std::string withSlash(std::string unit)
{
    const std::size_t second = unit.find_last_of("sS");
    const bool isWord = isAmong(lowered(unit.substr(0, second)), kAlsoWords);
    return second == unit.npos || second == 0 || isWord ? unit : unit.insert(second, "/");
}

/// Returns whether a capital letter begins a word or a unit, as in "timeMs" and "sliderXMm".
bool beginsWord(std::string_view text, std::size_t at)
{
    const auto isCapital = [text](std::size_t i) { return lowerCase(text[i]) != text[i]; };
    const bool isBeforeSmall = at + 1 < text.size() && text[at + 1] >= 'a' && text[at + 1] <= 'z';
    return isCapital(at) && (!isCapital(at - 1) || isBeforeSmall);
}

/// Returns the unit that the text behind a name denotes, "m/s2" also if it lacks the slash. It has to suit the name;
/// one of time may also follow a name without a meaning, as in "ticks_ms", and be only a letter if the separator before
/// it `isClear`, as in "Messzeit / s". Pixels are no unit of a channel. Returns nullopt if the text is no such unit.
std::optional<std::string> unitBehind(std::string_view name, const std::string &text, bool isClear)
{
    const NameMeaning meaning = parseUnit(text) ? meaningOf(name, text) : NameMeaning();
    if (isAmong(text, kPixels) || suits(meaning, text)) {
        return text;
    }
    if (const std::string slashed = withSlash(text); isUnitOf(name, slashed)) {
        return slashed;
    }
    const bool isTime = meaning.kind == Kind::Nothing && parseColumnUnit(text, ColumnRole::Time, {});
    const bool endsInBrackets = text.ends_with(')'); // "f (t/s)": the brackets began before the separator
    return isTime && !endsInBrackets && (text.size() > 1 || isClear) ? std::optional(text) : std::nullopt;
}

/// Sets name and unit of "v/(m/s)", "Time in s", "t, s", "x-mm", "time_ms" or "timeMs" if the unit suits the name. The
/// longest one that does is the unit.
void splitAtEnd(std::string_view text, Heading &heading)
{
    for (std::size_t at = 1; at < text.size(); ++at) {
        const bool isSeparator = std::string_view("/, _-.:").find(text[at]) != std::string_view::npos;
        if (!isSeparator && !beginsWord(text, at)) {
            continue;
        }
        const std::string_view end = trimmed(text.substr(at + (isSeparator ? 1 : 0)));
        const std::string_view name = trimmed(text.substr(0, at));
        const std::string_view printed = withoutPreposition(end, name);
        const bool isClear = text[at] == '/' || text[at] == ',' || printed.size() < end.size();
        const bool isInput = printed == "in" && meaningOf(name, "in").hasUnknownWords; // "theta_in" is an angle
        if (printed.empty() || printed[0] == '/' || (!isClear && (isInput || isAmong(lowered(printed), kAlsoWords)))) {
            continue;
        }
        if (const std::optional<std::string> unit = unitBehind(name, std::string(printed), isClear)) {
            heading.name = name;
            heading.use.unit = *unit;
            return;
        }
    }
}

/// Sets name and unit of "Degrees of crank rotation" if the unit suits the name.
void splitAtBeginning(std::string_view text, Heading &heading)
{
    const std::string unit(unitAtBeginning(text));
    const std::string_view name = trimmed(text.substr(unit.size()));
    if (isUnitOf(name, unit)) {
        heading.name = name;
        heading.use.unit = unit;
    }
}

/// Returns where the brace at the beginning of a text is closed; npos if it is not.
std::size_t closingBrace(std::string_view text)
{
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += (text[i] == '{' ? 1 : 0) - (text[i] == '}' ? 1 : 0);
        if (depth == 0) {
            return i;
        }
    }
    return text.npos;
}

/// Returns the last part of the name's path: "DX" of "Body_4/DX".
std::string lastPartOf(const Heading &heading)
{
    const NamePath path = splitPath(heading.name);
    return path.parts.empty() ? std::string() : std::string(path.parts.back());
}

/// Returns whether the name is a symbol with the mark of a second derivative, such as "xpp" or "d2x". "a" and
/// "acceleration" have none: beside them, "xp" may still be anything.
bool isSecondDerivative(const Heading &heading)
{
    const NameMeaning &meaning = heading.meaning;
    const Words words = wordsOf(lastPartOf(heading));
    const bool isAcceleration = meaning.channel.order == Order::Acceleration && meaning.kind >= Kind::Quantity;
    const bool isMarked = !words.empty() && !findWord(words[0], WordUse::Word) && words[0] != "a";
    return isAcceleration && isMarked && meaning.doubt == Doubt::None;
}

/// Returns whether the name is "v_p", "a_p" or "xp_dot", of the piston. "vp" and "ap" are such names in a row without
/// "v" and "a", whose derivatives they would be.
bool isOfPiston(const Heading &heading, std::span<const Heading> row)
{
    const Words words = wordsOf(heading.name);
    if (words.size() == 1 && isAmong(words[0], "vp ap")) {
        const std::string symbol = words[0].substr(0, 1);
        return std::ranges::none_of(row, [&](const Heading &other) { return lowered(other.name) == symbol; });
    }
    const bool isMarked = words.size() == 2 && isAmong(words[0], "xp sp") && isAmong(words[1], "dot ddot d dd");
    return isMarked || (words.size() == 2 && isAmong(words[0], "v a") && words[1] == "p");
}

/// Returns whether the name is that of a displacement and no differential: "DX" of Adams, or "dx" beside "vx".
bool isDisplacement(const Heading &heading, std::span<const Heading> row)
{
    const auto lastWordOf = [](const Heading &named) {
        const std::string part = lastPartOf(named);
        return part.substr(part.rfind(' ') + 1); // "DX" of "Slider DX"
    };
    const std::string symbol = lastWordOf(heading);
    const auto isVelocity = [&](const Heading &other) {
        return lowered(lastWordOf(other)) == 'v' + lowered(symbol).substr(1);
    };
    return isAmong(symbol, "DX DY") || (symbol.starts_with('d') && std::ranges::any_of(row, isVelocity));
}

/// Returns whether the name is that of point A, beside the same of point B: columns a, b and c, or "Ax", "Ay" and "Bx".
bool isOfPointA(const Heading &heading, std::span<const Heading> row)
{
    const auto withoutAxis = [](const Heading &ofPoint) {
        const std::string name = lowered(ofPoint.name);
        return name.substr(0, name.find_last_not_of("xy") + 1);
    };
    const std::string point = withoutAxis(heading);
    return point.starts_with('a') && std::ranges::any_of(row, [&](const Heading &other) {
               return withoutAxis(other) == 'b' + point.substr(1) && other.use.unit == heading.use.unit;
           });
}

/// Returns whether the heading is that of the crank pin, A_x or A_y, in a table that the command `solve` has written.
/// Such a table states no unit of lengths in mm. Only a column with a name that other programs do not use tells it.
bool isCrankPinOfSolve(const Heading &heading, std::span<const Heading> row)
{
    static constexpr std::string_view kOwnNames =
        "transmission_angle displacement_diff displacement_diff2 A_x_diff A_y_diff A_x_diff2 A_y_diff2";
    const auto isOfSolve = [](const Heading &other) {
        return other.meaning.kind == Kind::ChannelName || isAmong(other.name, kOwnNames);
    };
    return isAmong(heading.name, "A_x A_y") && heading.use.unit.empty() && std::ranges::any_of(row, isOfSolve);
}

/// Returns whether the name is the symbol of a vector whose x component is another column: "v" beside "v_x".
bool isMagnitude(const Heading &heading, std::span<const Heading> row)
{
    const Words words = wordsOf(lastPartOf(heading));
    if (words.size() != 1 || !isAmong(words[0], "v a")) {
        return false;
    }
    return std::ranges::any_of(row, [&](const Heading &other) {
        const Words component = wordsOf(lastPartOf(other));
        return component == Words{words[0], "x"} || component == Words{words[0] + 'x'};
    });
}

/// Decides between the meanings of "xp", "dx" and the like by the other columns: beside "xpp" or "d2x" they are
/// derivatives; beside "v_p", or without an "x", "x_p" is the x of the piston; and "DX", or "dx" beside "vx", is a
/// displacement. Otherwise only a person can tell.
void resolveDerivatives(std::vector<Heading> &row)
{
    const auto isNamed = [&](std::string_view name) {
        return std::ranges::any_of(row, [&](const Heading &heading) { return lowered(heading.name) == name; });
    };
    const bool hasSecond = std::ranges::any_of(row, isSecondDerivative);
    const bool hasPiston =
        std::ranges::any_of(row, [&row](const Heading &heading) { return isOfPiston(heading, row); });
    for (Heading &heading : row) {
        NameMeaning &meaning = heading.meaning;
        if (meaning.doubt != Doubt::IsDerivative && meaning.doubt != Doubt::IsPistonsIndex) {
            continue;
        }
        const std::string name = lowered(heading.name);
        const bool isIndex =
            hasPiston || ((name.ends_with("_p") || name.ends_with("(p)")) && !isNamed(name.substr(0, 1)));
        if (isDisplacement(heading, row)) {
            meaning.doubt = Doubt::None;
        } else if (hasSecond && meaning.channel.order < Order::Acceleration) {
            const bool isOfPosition = meaning.channel.order == Order::Position;
            meaning.channel.order = isOfPosition ? Order::Velocity : Order::Acceleration;
        } else if (meaning.doubt == Doubt::IsDerivative || !isIndex) {
            meaning = {.reason = ColumnReason::UnknownBody};
        }
    }
}

/// Decides that α is the angular acceleration where ω is before it. Otherwise its values have to tell it from an angle.
void resolveAlphas(std::span<Heading> row)
{
    bool isBehindOmega = false;
    for (Heading &heading : row) {
        NameMeaning &meaning = heading.meaning;
        const WordMeaning *const symbol = findWord(meaning.symbol, WordUse::Symbol);
        isBehindOmega =
            isBehindOmega || (symbol && symbol->dimension == Dimension::Angle && symbol->order == Order::Velocity);
        meaning.doubt = isBehindOmega && meaning.doubt == Doubt::IsAngle ? Doubt::None : meaning.doubt;
    }
}

/// Gives different owners to the columns of several points whose headings are the same, as Tracker writes "x", "y",
/// "x", "y": the first x and y are those of one point.
void separatePoints(std::span<Heading> row)
{
    const auto isOfPoint = [](const Heading &heading) {
        const NameMeaning &meaning = heading.meaning;
        return meaning.kind == Kind::Quantity && meaning.namesAxis && meaning.owner.empty() &&
               !isAngle(meaning.channel.coordinate);
    };
    const auto countIn = [&](std::span<const Heading> part, const Heading &heading) {
        return std::ranges::count_if(part, [&](const Heading &other) {
            return other.meaning.channel == heading.meaning.channel && other.use.heading == heading.use.heading;
        });
    };
    const auto isRepeatedY = [&](const Heading &heading) {
        return isOfPoint(heading) && heading.meaning.channel.coordinate == R4y && countIn(row, heading) > 1;
    };
    if (std::ranges::none_of(row, isRepeatedY)) {
        return;
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (isOfPoint(row[i]) && countIn(row, row[i]) > 1) {
            row[i].meaning.owner = std::to_string(countIn(row.first(i), row[i]));
            row[i].meaning.doubt = Doubt::IsOfPart;
        }
    }
}

/// Takes the meaning from headings that are no channels, as the other columns show: those of the crank pin and of
/// magnitudes.
void excludeOtherQuantities(std::vector<Heading> &row)
{
    for (Heading &heading : row) {
        if (isOfPointA(heading, row) || isCrankPinOfSolve(heading, row)) {
            heading.meaning = {.reason = ColumnReason::CrankPin};
        } else if (isMagnitude(heading, row)) {
            heading.meaning = {.reason = ColumnReason::Magnitude};
        }
    }
}

/// Returns whether a word is the symbol of an angle or angular velocity, or begins like "angular" in some language.
bool isAngular(const std::string &word)
{
    constexpr std::array<std::string_view, 8> kBeginnings{"ang", "winkel", "hoek",   "kat",
                                                          "uhl", "unghi",  "vinkel", "угл"};
    const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
    const auto isBeginning = [&word](std::string_view beginning) { return word.starts_with(beginning); };
    return (symbol && symbol->dimension == Dimension::Angle) || std::ranges::any_of(kBeginnings, isBeginning);
}

/// Decides whether a speed of rotation in 1/s or Hz is in rad/s or in turns per second, by its name:
///
///     n, Drehzahl               1/s, Hz   turns per second
///     ω, angular velocity       1/s       rad/s
///     crank speed               Hz        turns per second
///     ω, angular velocity       Hz        only a person can tell
///     crank speed               1/s       only a person can tell
///     fs, another unknown name  Hz        not used: the frequency of anything
void resolveReciprocalSeconds(Heading &heading)
{
    NameMeaning &meaning = heading.meaning;
    const std::string unit = lowered(heading.use.unit);
    const std::optional<Unit> parsed = parseUnit(unit);
    const bool isHertz = unit == "hz" || unit == "hertz";
    const bool isReciprocal = isHertz || (parsed == parseUnit("1/s") && unit.find("rad") == unit.npos);
    if (!isReciprocal || meaning.kind < Kind::Quantity || meaning.kind >= Kind::ChannelName) {
        return;
    }
    const Words words = wordsOf(heading.name);
    const bool isInTurns = !unitOfRotation(words).empty() || std::ranges::count(words, "n") > 0;
    const bool isInRadians = !isInTurns && std::ranges::any_of(words, isAngular);
    if (isInTurns) {
        heading.use.unit = "rev/s";
    } else if (isHertz && meaning.hasUnknownWords) {
        meaning = {.channel = meaning.channel, .reason = ColumnReason::UnknownBody};
    } else if (isHertz == isInRadians) { // "ω [Hz]" contradicts itself, and "crank speed [1/s]" leaves it open
        meaning = {.channel = meaning.channel, .reason = ColumnReason::TurnsOrRadians};
    } else if (isHertz) {
        heading.use.unit = "rev/s";
    }
}

/// Completes the names and units of components, which PMKS+ writes behind the magnitude of their vector: "Velocity
/// (cm/s)", "X-comp", "Y-comp". Marks the magnitude.
void completeComponents(std::span<Heading> row)
{
    Heading *vector = nullptr;
    for (Heading &heading : row) {
        const bool isComponent = isAmong(heading.name, "X-comp Y-comp");
        if (isComponent && vector) {
            vector->use.reason = ColumnReason::Magnitude;
            heading.name = vector->name + (heading.name[0] == 'X' ? " x" : " y");
            heading.use.unit = heading.use.unit.empty() ? vector->use.unit : heading.use.unit;
        } else if (!isComponent) {
            const bool isQuantity = meaningOf(heading.name, heading.use.unit).kind == Kind::Quantity;
            vector = isQuantity ? &heading : nullptr;
        }
    }
}

/// If the path of any name implies m, rad and s, those of the other names without a unit do, too: "slider.frame_a.x"
/// beside "slider.v".
void implySiUnits(std::span<Heading> row)
{
    const auto impliesSi = [](const Heading &heading) { return heading.meaning.reason == ColumnReason::PathInSi; };
    if (std::ranges::none_of(row, impliesSi)) {
        return;
    }
    for (Heading &heading : row) {
        NameMeaning &meaning = heading.meaning;
        if (heading.use.unit.empty() && meaning.kind >= Kind::Quantity && !meaning.owner.empty()) {
            meaning.reason = ColumnReason::PathInSi;
        }
    }
}

/// Symbols such as "x_B" or "d" beside θ₂ or θ₃ are those of a textbook, which denote the slider: its columns need no
/// confirmation by a person.
void recognizeTextbook(std::span<Heading> row)
{
    const auto isAngleOfLink = [](const Heading &heading) {
        const Coordinate coordinate = heading.meaning.channel.coordinate;
        return heading.meaning.kind >= Kind::Words && (coordinate == Theta2 || coordinate == Theta3) &&
               beginsWithSymbol(heading);
    };
    if (std::ranges::none_of(row, isAngleOfLink)) {
        return;
    }
    for (Heading &heading : row) {
        NameMeaning &meaning = heading.meaning;
        const bool isGuess = meaning.kind == Kind::Quantity && meaning.reason == ColumnReason::QuantityInName;
        if (isGuess && meaning.channel.coordinate == R4x && beginsWithSymbol(heading)) {
            meaning.reason = ColumnReason::KnownName;
        }
    }
}

/// Returns the unit of a quantity without a stated unit; empty if it is the default unit. Paths of some programs imply
/// m, rad and s; "rpm" and the like are units themselves; ω and α are in rad/s and rad/s²; and another derivative is in
/// the unit of its position.
std::string impliedUnit(const Heading &heading, std::span<const Heading> row)
{
    const NameMeaning &meaning = heading.meaning;
    const std::string perTime(derivativeSuffix(meaning.channel.order));
    if (meaning.reason == ColumnReason::PathInSi) {
        return (isAngle(meaning.channel.coordinate) ? "rad" : "m") + perTime;
    }
    if (const std::string_view unit = unitOfRotation(wordsOf(heading.name)); !unit.empty()) {
        return std::string(unit);
    }
    const auto isAngularRate = [](const std::string &word) { // ω or α
        const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
        return symbol && symbol->dimension == Dimension::Angle && symbol->order > Order::Position;
    };
    if (meaning.channel.order != Order::Position && isAngle(meaning.channel.coordinate) &&
        meaning.doubt != Doubt::IsAngle &&
        (isAngularRate(meaning.symbol) || std::ranges::any_of(wordsOf(heading.name), isAngularRate))) {
        return "rad" + perTime;
    }
    const auto isPosition = [&](const Heading &other) {
        return other.meaning.kind >= Kind::Quantity &&
               other.meaning.channel == Channel{meaning.channel.coordinate, Order::Position} &&
               (meaning.hasUnknownWords || !other.meaning.hasUnknownWords);
    };
    const Heading *const position = findElement(row, isPosition);
    const std::optional<Unit> unit = position ? parseUnit(position->use.unit) : std::nullopt;
    const bool differs = unit && unit->factor != 1.0;
    return differs && meaning.channel.order != Order::Position ? position->use.unit + perTime : std::string();
}

/// Removes the marks around a heading: "{$x$ (mm)}" of LaTeX, the label "<x>" of a signal in Simulink, 'x', and the
/// brackets of "[Slider Position (mm)]". Brackets without a "(" inside stay: they are a unit, "[mm]". "('slider', 'x')"
/// of pandas becomes the path "slider/x".
std::string withoutEnclosure(std::string text)
{
    static const Spellings kPandasSeparators{{"', '", "/"}};
    const auto isBetween = [&text](char first, char last) {
        return text.size() > 2 && text.front() == first && text.back() == last;
    };
    const bool isInBrackets = isBetween('[', ']') && text.find('(') != text.npos;
    const bool isInBraces = isBetween('{', '}') && closingBrace(text) == text.size() - 1;
    if (isInBrackets || isInBraces || isBetween('\'', '\'') || isBetween('<', '>')) {
        return text.substr(1, text.size() - 2);
    }
    const bool isOfPandas = text.starts_with("('") && text.ends_with("')");
    return isOfPandas ? kPandasSeparators.replacedIn(text.substr(2, text.size() - 4)) : text;
}

/// Returns the text without the number of the measurement that PASCO writes behind a heading: " Run #1".
std::string withoutRun(std::string text)
{
    const std::size_t run = text.rfind(" Run #");
    const bool isAtEnd = run != text.npos && isDigits(text.substr(run + 6));
    return isAtEnd ? std::string(trimmed(text.substr(0, text.find_last_not_of(" ,", run) + 1))) : text;
}

/// Sets name and unit of a heading that is only a unit: "millis", "Degrees", "Inches from TDC". Returns false for
/// others and for "mm", which may be in a line of units.
bool splitUnitAlone(std::string_view text, const Unit &unit, Heading &heading)
{
    constexpr std::size_t kLongestSymbol = 2; // of a unit of length
    const bool isTime = unit.dimension == Dimension::Time;
    if (unit.order != 0 || (unit.dimension == Dimension::Length && text.size() <= kLongestSymbol)) {
        return false;
    }
    heading.name = isTime ? "time" : text;
    heading.use.unit = withoutOrigin(text);
    return true;
}

} // namespace

Heading parseHeading(std::string_view cell)
{
    static const Spellings kQuotedCharacters{{"\"\"", "\""}, {"\r\n", " "}, {"\n", " "}};
    // Commands of LaTeX, the wide brackets of Chinese and Japanese, and the quotation marks of word processors.
    static const Spellings kMarkup{{"$", ""},      {"\\mathrm", ""}, {"\\text", ""}, {"\\rm", ""},    {"\\si", ""},
                                   {"\\unit", ""}, {"\\,", " "},     {"\\left", ""}, {"\\right", ""}, {"\\frac", ""},
                                   {"}{d", "/d"},  {"（", "("},      {"）", ")"},    {"［", "["},     {"］", "]"},
                                   {"／", "/"},    {"“", ""},        {"”", ""}};
    Heading heading{.use = {.heading = kQuotedCharacters.replacedIn(cell)}};
    const std::string text = withoutRun(withoutEnclosure(kMarkup.replacedIn(heading.use.heading)));
    heading.name = text;
    if (text.size() > kLongestName) {
        return heading;
    }
    const bool mayBeUnit = text.size() > 1 && !isAmong(lowered(text), kAlsoWords);
    const std::optional<Unit> alone = mayBeUnit ? parseUnit(withoutOrigin(text)) : std::nullopt;
    if (text.starts_with("X:")) { // RecurDyn writes pairs "X:Pos_TX-Slider(mm)" of time stamps, "Y:…" of values
        heading.name = "time";
    } else if (!(alone && splitUnitAlone(text, *alone, heading)) && !splitAtBrackets(text, heading)) {
        splitAtEnd(text, heading);
        if (heading.use.unit.empty()) {
            splitAtBeginning(text, heading);
        }
    }
    const bool isInLineOfUnits = alone && text.find('/') != text.npos; // "mm/s"
    heading.meaning = isInLineOfUnits ? NameMeaning() : meaningOf(heading.name, heading.use.unit);
    return heading;
}

std::string_view derivativeSuffix(Order order)
{
    switch (order) {
    case Order::Position: break;
    case Order::Velocity: return "/s";
    case Order::Acceleration: return "/s2";
    }
    return "";
}

bool beginsWithSymbol(const Heading &heading)
{
    Words words = wordsOf(heading.name);
    takeDerivatives(words);
    if (!words.empty() && words[0].ends_with("dot")) { // "xdot", "xddot"
        words[0].resize(words[0].find_last_not_of("dot") + 1);
    }
    return !words.empty() && (findWord(words[0], WordUse::Symbol) || words[0] == "t");
}

void interpretHeadings(std::vector<Heading> &row)
{
    completeComponents(row);
    for (Heading &heading : row) {
        heading.meaning = meaningOf(heading.name, heading.use.unit);
    }
    resolveDerivatives(row);
    resolveAlphas(row);
    separatePoints(row);
    excludeOtherQuantities(row);
    std::ranges::for_each(row, resolveReciprocalSeconds);
    implySiUnits(row);
    for (Heading &heading : row) {
        if (heading.meaning.kind == Kind::Nothing) {
            heading.use.reason = heading.use.heading.empty() ? ColumnReason::NoName : heading.meaning.reason;
        }
        if (heading.meaning.kind >= Kind::Quantity && heading.use.unit.empty()) {
            heading.use.unit = impliedUnit(heading, row);
        }
    }
    recognizeTextbook(row);
}

} // namespace slidercrank
