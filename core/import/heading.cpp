// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading.h"

#include "core/import/cells.h"
#include "core/import/name_derivatives.h"
#include "core/import/name_forms.h"
#include "core/import/spellings.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

/// Units that are also words, symbols or primes: "min" is a minimum, r1 a length, and μ, which a unit may have instead
/// of u, the transmission angle.
constexpr std::string_view kAlsoWords = "min h r r1 u μ µ g gr ' '' ?";

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

/// Returns whether the content of round brackets, which is no known unit, is a remark: "(filtered)", "(exp)", "(FD)".
bool isRemarkInBrackets(std::string_view content)
{
    constexpr std::size_t kShortestRemark = 6; // bytes: "(bar)" is a unit
    const bool isLong = content.size() >= kShortestRemark && content.find('/') == content.npos;
    const std::vector<std::string> words = wordsOf(content);
    return isLong || abbreviatesMethod(words) || namesDifferences(words);
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

/// Returns whether brackets that begin at `begin` contain an argument or index of LaTeX, as in "\dot{r}", "{r}_B" and
/// "θ_{r}", where r is no unit. The unit of "x {mm}" and "x/{mm}" stands apart.
bool areBracketsOfLatex(std::string_view text, std::size_t begin)
{
    const bool isApart = begin > 0 && (isBlank(text[begin - 1]) || text[begin - 1] == '/');
    return text[begin] == '{' && !isApart;
}

void splitAtEnd(std::string_view text, Heading &heading);

/// Returns the unit behind a symbol that suits a name: "cm" of "x_B in cm", "d, cm" and "x/cm". Returns an empty text
/// if there is none.
std::string_view unitBehindSymbol(std::string_view text, std::string_view name)
{
    Heading heading;
    splitAtEnd(text, heading);
    const std::string &unit = heading.use.unit;
    const bool isUnit = beginsWithSymbol(heading.name) && isUnitOf(name, unit) && text.ends_with(unit);
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
        if (begin == text.npos || areBracketsOfLatex(text, begin)) {
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
        const bool isInput = printed == "in" && meaningOf(name, "in").hasUnknownWords; // not inches: "theta_in"
        const bool isIndex = text[at] == '_' && printed.starts_with('{');              // "θ_{r}"
        if (printed.empty() || printed[0] == '/' || isIndex ||
            (!isClear && (isInput || isAmong(lowered(printed), kAlsoWords)))) {
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
    const bool isInBraces = isBetween('{', '}');
    if (isInBrackets || isInBraces || isBetween('\'', '\'') || isBetween('<', '>')) {
        return text.substr(1, text.size() - 2);
    }
    const bool isOfPandas = text.starts_with("('") && text.ends_with("')");
    return isOfPandas ? kPandasSeparators.replacedIn(text.substr(2, text.size() - 4)) : text;
}

/// Returns the text without the number of a measurement or curve that programs write behind a heading: " Run #1" of
/// PASCO and " - Plot 0" of LabVIEW.
std::string withoutNumberOfCurve(std::string text)
{
    for (const std::string_view label : {" Run #", " - Plot "}) {
        const std::size_t at = text.rfind(label);
        if (at != text.npos && isDigits(text.substr(at + label.size()))) {
            return std::string(trimmed(text.substr(0, text.find_last_not_of(" ,", at) + 1)));
        }
    }
    return text;
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
    static const Spellings kMarkup{{"\\textbf", ""}, {"\\mathbf", ""}, {"\\boldsymbol", ""}, {"\\vec", ""},
                                   {"$", ""},        {"\\mathrm", ""}, {"\\text", ""},       {"\\rm", ""},
                                   {"\\si", ""},     {"\\unit", ""},   {"\\,", " "},         {"\\left", ""},
                                   {"\\right", ""},  {"\\frac", ""},   {"}{d", "/d"},        {"（", "("},
                                   {"）", ")"},      {"［", "["},      {"］", "]"},          {"／", "/"},
                                   {"“", ""},        {"”", ""}};
    Heading heading{.use = {.heading = kQuotedCharacters.replacedIn(cell)}};
    const std::string text = withoutNumberOfCurve(withoutEnclosure(kMarkup.replacedIn(heading.use.heading)));
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

bool beginsWithSymbol(std::string_view name)
{
    std::vector<std::string> words = wordsOf(name);
    takeDerivatives(words);
    return !words.empty() && (findWord(words[0], WordUse::Symbol) || words[0] == "t");
}

} // namespace slidercrank
