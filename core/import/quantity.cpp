// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"

#include "core/import/cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kLongestText = 200; // bytes: beyond that only digits are read, for std::regex recurses

/// In ASCII: spaces, signs, and raised digits behind "^".
std::string plainText(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kSigns{{{"\u2212", "-"},
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
    std::string plain;
    while (!text.empty()) {
        const auto sign = std::ranges::find_if(kSigns, [&](const auto &each) { return text.starts_with(each.first); });
        plain += sign == kSigns.end() ? text.substr(0, 1) : sign->second;
        text.remove_prefix(sign == kSigns.end() ? 1 : sign->first.size());
    }
    return plain;
}

/// What stands behind a number.
struct NumberAndRest {
    std::string number; ///< with a decimal point and an exponent; empty: there is none
    std::string rest;
};

/// "-2.5e-3 m", "1 000.5", "1.5·10⁻⁸", "10⁻⁸".
NumberAndRest splitNumber(const std::string &plain)
{
    static const std::regex kPower(R"(([+-]?)10((?:\^-?\^?|\^)\d(?:\^?\d)*)( *)(.*))");
    static const std::regex kNumber(
        R"(([+-]?(?:\d{1,3}(?: \d{3})+(?!\d)|\d+|(?=\.\d))(?:\.\d*)?)(?:[eE]([+-]?\d+)| ?\* ?10(\^-?\^?\d(?:\^?\d)*))? *(.*))");
    if (plain.size() > kLongestText) {
        return {plain, {}};
    }
    std::smatch found;
    NumberAndRest parts;
    std::string exponent;
    if (std::regex_match(plain, found, kPower)) {
        parts = {found.str(1) + '1', found.str(4)};
        exponent = found.str(2);
    } else if (std::regex_match(plain, found, kNumber)) {
        parts = {found.str(1), found.str(4)};
        exponent = found.str(2) + found.str(3);
    }
    std::erase(parts.number, ' ');
    std::erase(exponent, '^');
    parts.number += exponent.empty() ? "" : 'e' + exponent;
    return parts;
}

/// Without the tail that 4.35 · 100 has: what was written has no more digits than these.
double withoutTail(double value)
{
    constexpr int kDigits = 15;
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
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
    const std::string plain = plainText(text);
    const auto [digits, rest] = splitNumber(plain);
    const CellNumber number = parseNumber(digits, DecimalSign::Point);
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
    if (rest.find_first_of("0123456789+-*/.,^") == 0) {
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
