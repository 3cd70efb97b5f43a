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
constexpr std::string_view kAmbiguousUnits = "min h r r1 u μ µ g gr ' '' ?";

constexpr std::string_view kPixels = "px pixel pixels";

/// A heading, split. The unit is empty if none is stated.
struct NameAndUnit {
    std::string name{};
    std::string unit{};
};

/// Returns whether a meaning is a quantity or time that can have the unit.
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

/// Returns the unit of a name without the "in" of "t in s" or "t (en s)", unless the text with "in" is itself a unit of
/// inches: "a [in s^-2]".
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
        if (parseUnit(unit) && !isAmong(lowered(unit), kAmbiguousUnits)) {
            return unit;
        }
    }
    return {};
}

/// Returns whether the content of brackets is a unit that suits no quantity: "(%)", "(×2)", "(px)".
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

/// Returns whether brackets that begin at `begin` belong to the name: they contain a point, an argument or an index, as
/// in "x(A)", "theta(t)", "P[3.1]" and "x_{1}", or the whole text, as in "x(B)", has a meaning without unknown words.
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

// Defined below.
std::optional<NameAndUnit> splitUnitFromEnd(std::string_view text);

/// `text`: the content of brackets behind `name`. If it is a symbol with a unit that suits the name, as in "x_B in cm",
/// "d, cm" or "x/cm", returns the unit; otherwise an empty text.
std::string_view unitBehindSymbol(std::string_view text, std::string_view name)
{
    const std::optional<NameAndUnit> split = splitUnitFromEnd(text);
    const bool isUnit =
        split && beginsWithSymbol(split->name) && isUnitOf(name, split->unit) && text.ends_with(split->unit);
    return isUnit ? text.substr(text.size() - split->unit.size()) : std::string_view();
}

/// Returns the unit in the brackets from `begin` to `end`, which may be empty or unknown; nullopt if the content of the
/// brackets is a part of the name or a remark. A remark may follow a unit that suits a known name: "Crank angle (deg,
/// unwrapped)". An unknown unit is only at the end of the heading.
std::optional<std::string_view> unitInBrackets(std::string_view text, std::size_t begin, std::size_t end)
{
    const std::string_view name = trimmed(text.substr(0, begin));
    const std::string_view bracketed = withoutTrailingRemark(trimmed(text.substr(begin + 1, end - begin - 1)));
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

/// Searches the brackets of a heading for a unit, beginning with the last ones: "Position (m) Run #1". A known unit has
/// priority over an unknown one behind it: "x [mm] (output)". Returns nullopt if no brackets contain a unit.
std::optional<NameAndUnit> splitUnitFromBrackets(std::string_view text)
{
    constexpr std::string_view kOpening = "[({<";
    constexpr std::string_view kClosing = "])}>";
    std::optional<NameAndUnit> split;
    for (std::size_t end = text.size(); end-- > 0;) {
        const std::size_t bracket = kClosing.find(text[end]);
        const std::size_t begin = bracket == kClosing.npos ? text.npos : text.substr(0, end).rfind(kOpening[bracket]);
        if (begin == text.npos || areBracketsOfLatex(text, begin)) {
            continue;
        }
        const std::optional<std::string_view> unit = unitInBrackets(text, begin, end);
        const bool isKnown = unit && parseUnit(*unit);
        if (unit && (isKnown || !split)) {
            std::string name(trimmed(text.substr(0, begin)));
            name.erase(name.find_last_not_of("/ ") + 1); // "x/(mm)"
            split = {name + std::string(text.substr(end + 1)), std::string(*unit)};
        }
        if (isKnown) {
            break;
        }
        end = begin; // continue before these brackets
    }
    return split;
}

/// Returns a unit with a slash before its last s, which stands for the seconds: "m/s2" for "ms2" (names often omit the
/// slash). Returns it unchanged if no s is behind its first character, or if one of kAmbiguousUnits is before the s.
std::string withSlash(std::string unit)
{
    const std::size_t second = unit.find_last_of("sS");
    const bool isWord = isAmong(lowered(unit.substr(0, second)), kAmbiguousUnits);
    return second == unit.npos || second == 0 || isWord ? unit : unit.insert(second, "/");
}

/// Returns whether a capital letter at `at` begins a word or a unit, as in "timeMs" and "sliderXMm".
bool beginsWord(std::string_view text, std::size_t at)
{
    const auto isCapital = [text](std::size_t i) { return lowerCase(text[i]) != text[i]; };
    const bool isBeforeSmall = at + 1 < text.size() && text[at + 1] >= 'a' && text[at + 1] <= 'z';
    return isCapital(at) && (!isCapital(at - 1) || isBeforeSmall);
}

/// Returns the unit that `text`, which stands behind a name, denotes:
///
/// 1. pixels, which are no unit of a channel, or a unit that suits the name,
/// 2. else the unit with the slash that the text lacks, "m/s2" for "ms2", if that suits the name,
/// 3. else a unit of time behind a name without a meaning, as in "ticks_ms"; but a single letter only with `isClear`:
///    the separator before it announces a unit, as in "Messzeit / s".
///
/// Returns nullopt if the text is no such unit.
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

/// Splits "v/(m/s)", "Time in s", "t, s", "x-mm", "time_ms" or "timeMs" into name and unit. Of several endings that can
/// be the unit of the name before them, the longest one is chosen. Returns nullopt if there is none.
std::optional<NameAndUnit> splitUnitFromEnd(std::string_view text)
{
    for (std::size_t at = 1; at < text.size(); ++at) {
        const bool isSeparator = std::string_view("/, _-.:").find(text[at]) != std::string_view::npos;
        if (!isSeparator && !beginsWord(text, at)) {
            continue;
        }
        const std::string_view end = trimmed(text.substr(at + (isSeparator ? 1 : 0)));
        const std::string_view name = trimmed(text.substr(0, at));
        const std::string_view printed = withoutPreposition(end, name);
        const bool isClear = text[at] == '/' || text[at] == ',' || printed.size() < end.size(); // "/ s", ", s", "in s"
        const bool isInput = printed == "in" && meaningOf(name, "in").hasUnknownWords; // not inches: "theta_in"
        const bool isAmbiguous = isInput || isAmong(lowered(printed), kAmbiguousUnits);
        const bool isIndex = text[at] == '_' && printed.starts_with('{'); // "θ_{r}"
        if (printed.empty() || printed[0] == '/' || isIndex || (isAmbiguous && !isClear)) {
            continue;
        }
        if (std::optional<std::string> unit = unitBehind(name, std::string(printed), isClear)) {
            return NameAndUnit{std::string(name), *std::move(unit)};
        }
    }
    return std::nullopt;
}

/// Splits "Degrees of crank rotation". Returns nullopt if the text does not begin with a unit that suits the name.
std::optional<NameAndUnit> splitUnitFromBeginning(std::string_view text)
{
    const std::string unit(unitAtBeginning(text));
    const std::string_view name = trimmed(text.substr(unit.size()));
    return isUnitOf(name, unit) ? std::optional(NameAndUnit{std::string(name), unit}) : std::nullopt;
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

/// Returns the unit that fills a heading apart from a remark: "millis", "Degrees", "Inches from TDC". Returns nullopt
/// for other headings and for units that may also be words or symbols.
std::optional<Unit> unitAlone(std::string_view text)
{
    const bool mayBeUnit = text.size() > 1 && !isAmong(lowered(text), kAmbiguousUnits);
    return mayBeUnit ? parseUnit(withoutTrailingRemark(text)) : std::nullopt;
}

/// Splits a heading that is only a unit of time or of angles, or a word for a unit of length. The name of a unit of
/// time is "time"; other units are their own names. Returns nullopt for other headings, such as "mm", which may be in a
/// line of units.
std::optional<NameAndUnit> splitLoneUnit(std::string_view text)
{
    constexpr std::size_t kLongestSymbol = 2; // of a unit of length
    const std::optional<Unit> unit = unitAlone(text);
    if (!unit || unit->order != 0 || (unit->dimension == Dimension::Length && text.size() <= kLongestSymbol)) {
        return std::nullopt;
    }
    return NameAndUnit{unit->dimension == Dimension::Time ? "time" : std::string(text),
                       std::string(withoutTrailingRemark(text))};
}

/// Splits a heading in the first way that succeeds. Otherwise all of it is the name.
NameAndUnit splitHeading(const std::string &text)
{
    if (text.starts_with("X:")) { // RecurDyn writes pairs "X:Pos_TX-Slider(mm)" of time stamps, "Y:…" of values
        return {.name = "time"};
    }
    for (const auto split : {splitLoneUnit, splitUnitFromBrackets, splitUnitFromEnd, splitUnitFromBeginning}) {
        if (std::optional<NameAndUnit> found = split(text)) {
            return *std::move(found);
        }
    }
    return {.name = text};
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
    if (text.size() > kMaxNameSize) {
        return heading;
    }
    NameAndUnit split = splitHeading(text);
    heading.name = std::move(split.name);
    heading.use.unit = std::move(split.unit);
    const bool isInLineOfUnits = text.find('/') != text.npos && unitAlone(text); // "mm/s"
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
