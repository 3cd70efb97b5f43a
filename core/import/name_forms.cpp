// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_forms.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <array>
#include <vector>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

/// Beginnings of remarks about the abscissa of a plot, the sensor (", Ch P1" of PASCO), the coordinate system (of
/// SolidWorks) and the origin ("piston position from TDC").
constexpr auto kRemarkBeginnings =
    std::to_array<std::string_view>({" vs ",     " vs. ",         " versus ",      ", Ch ",         " Ref. Coordinate",
                                     " from ",   " since ",       " relative to ", " with ",        " after ",
                                     " ab ",     " vom ",         " nach ",        " desde ",       " respecto a",
                                     " depuis ", " par rapport ", " à partir ",    " rispetto al ", " dal ",
                                     " vanaf ",  " od ",          " a partir ",    "_from_",        "_desde_",
                                     "_depuis_"});

/// Returns the name without the value of a parameter after it: "velocity at 60 rpm", "v @ 60 rpm".
std::string_view withoutParameter(std::string_view name)
{
    for (const std::string_view preposition : {" at ", " @ ", " a ", " bei ", " à "}) {
        const std::size_t at = name.find(preposition);
        const std::string_view value = name.substr(std::min(at, name.size()));
        if (value.size() > preposition.size() && isDigit(value[preposition.size()])) {
            name = name.substr(0, at);
        }
    }
    return name;
}

/// Returns the name without its argument, which is the time, an angle or the number of a sample: "x(t)", "v[φ]",
/// "x[n]", "x_i".
std::string_view withoutArgument(std::string_view name)
{
    if (name.ends_with("_i")) {
        return name.substr(0, name.size() - 2);
    }
    const std::size_t bracket = name.find_last_of("([");
    if (bracket == name.npos || bracket == 0 || name.find_first_of(")]", bracket) + 1 != name.size()) {
        return name;
    }
    const std::string_view inner = name.substr(bracket + 1, name.size() - bracket - 2);
    const Words variable = wordsOf(inner);
    const WordMeaning *const symbol = variable.empty() ? nullptr : findWord(variable[0], WordUse::Symbol);
    const bool isAngle = symbol && symbol->dimension == Dimension::Angle && !symbol->order;
    const bool isNumberOfSample = inner == "n" || inner == "i"; // but "R (N)" is a force
    return isTime(variable) || isAngle || isNumberOfSample ? name.substr(0, bracket) : name;
}

/// Returns where the first comma outside brackets is, or npos.
std::size_t findOuterComma(std::string_view text)
{
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += (text[i] == '(' ? 1 : 0) - (text[i] == ')' ? 1 : 0);
        if (text[i] == ',' && depth == 0) {
            return i;
        }
    }
    return text.npos;
}

/// Returns how often a call differentiates by these variables: ", t", ", t, t", ", (t, 2)", or nothing for once.
int countDerivatives(std::string_view variables)
{
    const auto count = static_cast<int>(std::ranges::count(variables, 't'));
    return variables.find('2') != variables.npos ? 2 : std::max(count, 1);
}

/// Returns whether a word is a symbol, also with an index: "v", "vb", "t".
bool isSymbol(const std::string &word)
{
    const bool hasIndex = findWord(word.substr(0, 1), WordUse::Symbol) && findWord(word.substr(1), WordUse::Index);
    return hasIndex || findWord(word, WordUse::Symbol) || word == "t";
}

} // namespace

std::string_view withoutTrailingRemark(std::string_view name)
{
    for (const std::string_view beginning : kRemarkBeginnings) {
        name = name.substr(0, name.find(beginning));
    }
    return withoutParameter(name);
}

int takeDerivativeCalls(std::string_view &name, const std::optional<Unit> &unit)
{
    name = withoutArgument(name);
    int count = 0;
    const bool mayBeDerivative = !unit || unit->order > 0;
    for (const std::string_view function : {"der(", "diff(", "derivative(", "d("}) {
        while (mayBeDerivative && lowered(name.substr(0, function.size())) == function && name.ends_with(')')) {
            name = name.substr(function.size(), name.size() - function.size() - 1);
            const std::size_t comma = findOuterComma(name);
            count += countDerivatives(name.substr(std::min(comma, name.size())));
            name = name.substr(0, comma);
        }
    }
    name = withoutArgument(name);
    return count;
}

bool isElement(std::string_view name)
{
    const std::size_t bracket = name.rfind('(');
    return bracket != name.npos && bracket > 0 &&
           name.substr(bracket + 1).find_first_not_of(" 0123456789)") == name.npos;
}

bool isRelative(std::string_view name)
{
    constexpr std::size_t kLongestSymbol = 5; // "{V_B"
    const std::size_t slash = name.rfind('/');
    return slash != name.npos && slash > 0 && slash <= kLongestSymbol &&
           isAmong(name.substr(slash + 1), "A B C O A} B}") && lowerCase(name[slash - 1]) != name[slash - 1];
}

bool isRatio(std::string_view name)
{
    const std::size_t slash = std::min(name.find('/'), name.size());
    const Words numerator = wordsOf(name.substr(0, slash));
    const Words denominator = wordsOf(name.substr(slash));
    if (numerator.empty() || denominator.empty()) {
        return false;
    }
    const bool isToAlike = numerator[0] == denominator[0] || denominator[0] == "omega";
    const bool isLength =
        isAmong(numerator[0], "x s d") && (numerator.size() == 1 || findWord(numerator[1], WordUse::Index));
    const bool isToLink = isLength && denominator.size() == 1 && isAmong(denominator[0], "a b l r");
    return isToLink || (isToAlike && isSymbol(numerator[0]));
}

bool isOverAngle(std::string_view name, const std::string &unit)
{
    constexpr std::array<std::string_view, 6> kDivisors{"/dθ", "/dφ", "/dϕ", "/dα", "/dth", "/dphi"};
    const std::string plain = lowered(name);
    if (std::ranges::any_of(kDivisors, [&](std::string_view divisor) { return plain.find(divisor) != plain.npos; })) {
        return true;
    }
    const std::size_t slash = unit.rfind('/');
    const std::size_t end = unit.find_last_not_of("^2\xC2\xB2") + 1; // without a power of two
    if (slash == unit.npos || end <= slash) {
        return false;
    }
    const std::optional<Unit> angle = parseUnit(unit.substr(slash + 1, end - slash - 1));
    return angle && angle->dimension == Dimension::Angle && angle->order == 0 && parseUnit(unit.substr(0, slash));
}

bool isMagnitude(std::string_view name)
{
    const bool isBetweenBars = name.size() > 2 && name.front() == '|' && name.back() == '|';
    return isBetweenBars || name.find("abs(") != name.npos || isAmong(lowered(name), "absolute magnitude total norm");
}

} // namespace slidercrank
