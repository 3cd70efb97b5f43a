// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"

#include "core/import/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::string_view kMinus = "\u2212";
constexpr std::array<std::string_view, 2> kTimes{"·", "×"};
constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::string_view kRaisedMinus = "⁻";
constexpr std::array<std::string_view, 4> kSpaces{" ", "\u00A0", "\u2009", "\u202F"}; // also between groups of three

bool isDecimal(char c)
{
    return c >= '0' && c <= '9';
}

std::size_t digitsAt(std::string_view text, std::size_t at)
{
    const auto first = text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size()));
    return static_cast<std::size_t>(std::find_if_not(first, text.end(), isDecimal) - first);
}

std::size_t spaceAt(std::string_view text, std::size_t at)
{
    const auto found = std::ranges::find_if(
        kSpaces, [&](std::string_view space) { return text.substr(std::min(at, text.size())).starts_with(space); });
    return found == kSpaces.end() ? 0 : found->size();
}

/// With "-" for a minus sign, and without what stands between groups of three digits.
std::string withPlainSigns(std::string_view text)
{
    std::string plain;
    while (!text.empty()) {
        const bool minus = text.starts_with(kMinus);
        plain += minus ? '-' : text.front();
        text.remove_prefix(minus ? kMinus.size() : 1);
    }
    std::size_t at = plain.starts_with('-') || plain.starts_with('+') ? 1 : 0;
    const std::size_t first = digitsAt(plain, at);
    at += first;
    while (first >= 1 && first <= 3) {
        const std::size_t space = spaceAt(plain, at);
        if (space == 0 || digitsAt(plain, at + space) != 3) {
            break;
        }
        plain.erase(at, space);
        at += 3;
    }
    return plain;
}

/// "⁻⁸" or "^-8" at the beginning, as "-8", and how long it is there; empty: there is none.
std::pair<std::string, std::size_t> exponentOf(std::string_view text)
{
    std::string exponent;
    std::size_t at = 0;
    if (text.starts_with('^')) {
        at = text.substr(1).starts_with('-') ? 2 : 1;
        const std::size_t digits = digitsAt(text, at);
        return {digits > 0 ? std::string(text.substr(1, at - 1 + digits)) : "", at + digits};
    }
    if (text.starts_with(kRaisedMinus)) {
        exponent = '-';
        at = kRaisedMinus.size();
    }
    const std::size_t sign = exponent.size();
    const auto digit = [&] {
        return std::ranges::find_if(kRaised, [&](std::string_view each) { return text.substr(at).starts_with(each); });
    };
    for (auto found = digit(); found != kRaised.end(); found = digit()) {
        exponent += static_cast<char>('0' + (found - kRaised.begin()));
        at += found->size();
    }
    return {exponent.size() > sign ? exponent : "", at};
}

/// "1.5·10⁻⁸" as "1.5e-8", "10⁻⁸" as "1e-8": so the program itself writes numbers. Other texts as they are.
std::string withPlainPower(std::string text)
{
    constexpr std::string_view kTen = "10";
    const std::string_view all = text;
    const std::size_t begin = all.starts_with('-') || all.starts_with('+') ? 1 : 0;
    std::size_t end = begin + digitsAt(all, begin);
    const bool isTen = all.substr(begin, end - begin) == kTen;
    if (end < all.size() && all[end] == '.') {
        end += 1 + digitsAt(all, end + 1);
    }
    std::size_t at = end + spaceAt(all, end);
    const auto times =
        std::ranges::find_if(kTimes, [&](std::string_view each) { return all.substr(at).starts_with(each); });
    if (times != kTimes.end() && end > begin) {
        at += times->size();
        at += spaceAt(all, at);
        if (!all.substr(at).starts_with(kTen)) {
            return text;
        }
        at += kTen.size();
    } else if (isTen) {
        at = begin + kTen.size();
        end = begin + 1; // of 10, the 1
    } else {
        return text;
    }
    const auto [exponent, length] = exponentOf(all.substr(at));
    return exponent.empty() ? text
                            : std::string(all.substr(0, end)) + 'e' + exponent + std::string(all.substr(at + length));
}

/// How much of the text is a number, by its signs: "-2.5e-3" of "-2.5e-3 m".
std::size_t numberLength(std::string_view text)
{
    std::size_t at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    const std::size_t whole = digitsAt(text, at);
    at += whole;
    std::size_t decimals = 0;
    if (at < text.size() && text[at] == '.') {
        decimals = digitsAt(text, at + 1);
        at += 1 + decimals;
    }
    if (whole + decimals == 0) {
        return 0;
    }
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::size_t exponent = at + 1;
        exponent += exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+') ? 1 : 0;
        if (const std::size_t digits = digitsAt(text, exponent); digits > 0) {
            at = exponent + digits;
        }
    }
    return at;
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
    const std::string plain = withPlainPower(withPlainSigns(text));
    const std::size_t length = numberLength(plain);
    const CellNumber number = readNumber(std::string_view(plain).substr(0, length), DecimalSign::Point);
    if (length == 0 || number.fault) {
        return refused(length > 0 && *number.fault == RowFault::TooLarge ? QuantityFault::TooLarge
                                                                         : QuantityFault::NotANumber);
    }
    std::string_view rest = std::string_view(plain).substr(length);
    if (rest.starts_with(',') && digitsAt(rest, 1) > 0 && rest.find(',', 1) == rest.npos &&
        plain.find('.') == plain.npos) {
        return refused(QuantityFault::CommaForPoint);
    }
    while (const std::size_t space = spaceAt(rest, 0)) {
        rest.remove_prefix(space);
    }
    if (rest.empty()) {
        return {number.value, {}};
    }
    const auto begins = [&](std::string_view each) { return rest.starts_with(each); };
    if (rest.find_first_of("0123456789+-*/.,^") == 0 || begins(kRaisedMinus) || std::ranges::any_of(kTimes, begins) ||
        std::ranges::any_of(kRaised, begins)) {
        return refused(QuantityFault::NotANumber); // more than one, or a sum
    }
    const std::optional<Unit> unit = unitOf(rest);
    if (!unit) {
        return refused(QuantityFault::UnknownUnit);
    }
    if (!wanted || unit->dimension != wanted->dimension || unit->order != wanted->order) {
        return refused(QuantityFault::WrongUnit);
    }
    return {converted(number.value, *unit, *wanted), {}};
}

} // namespace slidercrank
