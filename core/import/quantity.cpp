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

/// Signs in ASCII, spaces of any width, raised digits behind "^".
constexpr std::array<Spelling, 17> kSigns{{{"\u2212", "-"},
                                           {"\u00A0", " "},
                                           {"\u2009", " "},
                                           {"\u202F", " "},
                                           {"·", "*"},
                                           {"×", "*"},
                                           {"⁻", "^-"},
                                           {"⁰", "^0"},
                                           {"¹", "^1"},
                                           {"²", "^2"},
                                           {"³", "^3"},
                                           {"⁴", "^4"},
                                           {"⁵", "^5"},
                                           {"⁶", "^6"},
                                           {"⁷", "^7"},
                                           {"⁸", "^8"},
                                           {"⁹", "^9"}}};

/// A power of ten behind a number begins with "@".
constexpr std::array<Spelling, 4> kPowers{{{" * 10^", "@"}, {" *10^", "@"}, {"* 10^", "@"}, {"*10^", "@"}}};

constexpr std::string_view kDigits = "0123456789";

/// Removes the characters at the front of `rest` that are among these, and returns them.
std::string_view take(std::string_view &rest, std::string_view characters)
{
    const std::string_view taken = rest.substr(0, rest.find_first_not_of(characters));
    rest.remove_prefix(taken.size());
    return taken;
}

/// Whether the text begins with a space and a group of three digits, as the thousands of "1 000 001".
bool beginsWithGroup(std::string_view text)
{
    const bool isSpaced = text.starts_with(' ');
    return isSpaced && std::min(text.find_first_not_of(kDigits, 1), text.size()) == 4;
}

/// Removes the number at the front of `rest` and returns it with a decimal point and an exponent, or what else is
/// there.
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

/// Without the tail that 4.35 · 100 has: what was written has no more digits than these.
double withoutTail(double value)
{
    constexpr int kMostDigits = 15;
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kMostDigits);
    std::from_chars(text.data(), written.ptr, value);
    return value;
}

/// How much half a turn is: divided by that first, 360°/s, 60 rpm and 90° become exactly the double nearest to 2π, 2π
/// and π/2.
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
    case Dimension::Length: return withoutTail(value * from.factor / to.factor);
    case Dimension::Time: return withoutTail(value / from.factor * to.factor);
    }
    return value;
}

} // namespace

Quantity readQuantity(std::string_view text, const std::optional<Unit> &wanted)
{
    const auto refused = [](QuantityFault fault) { return Quantity{.fault = fault}; };
    std::string plain = respelled(respelled(text, kSigns), kPowers);
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
        return refused(QuantityFault::NotANumber); // more than one, or a sum
    }
    const std::optional<Unit> unit = parseUnit(rest);
    if (!unit) {
        return refused(QuantityFault::UnknownUnit);
    }
    if (!wanted || unit->dimension != wanted->dimension || unit->order != wanted->order) {
        return refused(QuantityFault::WrongUnit);
    }
    return {converted(number.value, *unit, *wanted), {}};
}

} // namespace slidercrank
