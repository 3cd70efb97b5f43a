// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"

#include "core/import/cells.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

namespace slidercrank
{

namespace
{

/// To ASCII signs, with "^" before each superscript character and "@" before a power of ten after a number.
constexpr std::string_view kQuantitySpellings =
    "\u2212=-|\u00A0= |\u2009= |\u202F= |·=*|×=*|⁻=^-|⁰=^0|¹=^1|²=^2|³=^3|⁴=^4|⁵=^5|⁶=^6|⁷=^7|⁸=^8|⁹=^9";
constexpr std::string_view kPowerSpellings = " * 10^=@| *10^=@|* 10^=@|*10^=@";

constexpr std::string_view kDigits = "0123456789";

/// Removes the leading characters of `rest` that are among `characters`, and returns them.
std::string_view take(std::string_view &rest, std::string_view characters)
{
    const std::string_view taken = rest.substr(0, rest.find_first_not_of(characters));
    rest.remove_prefix(taken.size());
    return taken;
}

/// Returns whether the text begins with a space and a group of three digits, as in "1 000 001".
bool beginsWithGroup(std::string_view text)
{
    return text.starts_with(' ') && std::min(text.find_first_not_of(kDigits, 1), text.size()) == 4;
}

/// Removes the number at the beginning of `rest` and returns it with decimal point and exponent. The result is no
/// number if the text does not begin with one.
std::string takeNumber(std::string_view &rest)
{
    std::string number(rest.substr(0, rest.find_first_not_of("+-") == 1 ? 1 : 0));
    rest.remove_prefix(number.size());
    const std::string_view digits = take(rest, kDigits);
    number += digits;
    while (!digits.empty() && digits.size() <= 3 && beginsWithGroup(rest)) {
        number += rest.substr(1, 3);
        rest.remove_prefix(4);
    }
    if (rest.starts_with('.')) {
        rest.remove_prefix(1);
        number.append(".").append(take(rest, kDigits));
    }
    if (rest.starts_with('@') || rest.starts_with('e') || rest.starts_with('E')) {
        std::string_view behind = rest.substr(1);
        std::string exponent(take(behind, rest[0] == '@' ? "-^0123456789" : "+-0123456789"));
        std::erase(exponent, '^');
        if (exponent.find_first_of(kDigits) != exponent.npos) {
            number += 'e' + exponent;
            rest = behind;
        }
    }
    return number;
}

/// Removes the rounding error of a product such as 4.35 · 100.
double withoutRoundingError(double value)
{
    constexpr int kMostDigits = 15; // that a person writes
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kMostDigits);
    std::from_chars(text.data(), written.ptr, value);
    return value;
}

/// Returns half a turn in that unit. Dividing by it first converts 360°/s, 60 rpm and 90° exactly to the doubles
/// nearest to 2π, 2π and π/2.
double halfTurnIn(const Unit &unit)
{
    return unit.factor == kDegreesPerRadian ? std::numbers::pi : 180.0 / unit.factor;
}

double converted(double value, const Unit &from, const Unit &to)
{
    if (from.factor == to.factor) {
        return value;
    }
    switch (from.dimension) {
    case Dimension::Angle: return value / halfTurnIn(from) * halfTurnIn(to);
    case Dimension::Length: return withoutRoundingError(value * from.factor / to.factor);
    case Dimension::Time: return withoutRoundingError(value / from.factor * to.factor);
    }
    return value;
}

} // namespace

Quantity readQuantity(std::string_view text, const std::optional<Unit> &expected)
{
    const auto refused = [](QuantityFault fault) { return Quantity{.fault = fault}; };
    std::string plain = respelled(respelled(text, kQuantitySpellings), kPowerSpellings);
    const std::size_t first = plain.starts_with('-') || plain.starts_with('+') ? 1 : 0;
    if (plain.compare(first, 3, "10^") == 0) {
        plain.replace(first, 3, "1@");
    }
    std::string_view rest = plain;
    const std::string digits = takeNumber(rest);
    const CellNumber number = parseNumber(digits, DecimalSign::Point);
    take(rest, " ");
    if (digits.empty() || number.fault) {
        return refused(number.fault == RowFault::TooLarge ? QuantityFault::TooLarge : QuantityFault::NotANumber);
    }
    const bool hasDecimalComma = rest.size() > 1 && rest[0] == ',' && isDigit(rest[1]) && rest.rfind(',') == 0;
    if (hasDecimalComma && plain.find('.') == plain.npos) {
        return refused(QuantityFault::CommaForPoint);
    }
    if (rest.empty()) {
        return {number.value, {}};
    }
    if (rest.find_first_of("0123456789+-*/.,^@") == 0) {
        return refused(QuantityFault::NotANumber); // several numbers, or a sum
    }
    const std::optional<Unit> unit = parseUnit(rest);
    if (!unit) {
        return refused(QuantityFault::UnknownUnit);
    }
    if (!expected || unit->dimension != expected->dimension || unit->order != expected->order) {
        return refused(QuantityFault::WrongUnit);
    }
    return {converted(number.value, *unit, *expected), {}};
}

} // namespace slidercrank
