// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"

#include "core/import/cells.h"
#include "core/import/read_double.h"
#include "core/import/spellings.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace slidercrank
{

namespace
{

/// Spellings of signs and spaces in ASCII.
const Spellings kQuantitySpellings{{"\u2212", "-"}, {"\u00A0", " "}, {"\u2009", " "},
                                   {"\u202F", " "}, {"·", "*"},      {"×", "*"}};

/// Spellings of the ten whose power multiplies the number before it. "@" marks the power.
const Spellings kPowerSpellings{{" * 10^", "@"}, {" *10^", "@"}, {"* 10^", "@"}, {"*10^", "@"}};

/// Returns a value without the rounding error of a product such as 4.35 · 100.
double withoutRoundingError(double value)
{
    constexpr int kMaxDigits = 15; // of a number that a person writes
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kMaxDigits);
    readDouble(text.data(), written.ptr, value);
    return value;
}

/// Converts a value to a different unit, without the rounding error of the product: 4.35 m is 4350 mm. A factor with π
/// is itself rounded, so that no digits can be restored.
double converted(double value, const Unit &from, const Unit &to)
{
    if (from.factor == to.factor) {
        return value;
    }
    const double product = from.toDefault(value) / to.toDefault(1.0);
    return from.dimension == Dimension::Angle ? product : withoutRoundingError(product);
}

} // namespace

Quantity readQuantity(std::string_view text, const std::optional<Unit> &expected)
{
    const auto refused = [](QuantityFault fault) { return Quantity{.fault = fault}; };
    std::string number = kPowerSpellings.replacedIn(kQuantitySpellings.replacedIn(withCarets(text)));
    const std::size_t first = number.starts_with('-') || number.starts_with('+') ? 1 : 0;
    if (number.compare(first, 3, "10^") == 0) {
        number.replace(first, 3, "1@"); // "10^3" is 1 · 10^3
    }
    const std::size_t end = std::min(number.find_first_not_of("0123456789+-.,eE@^ "), number.size());
    const std::string unitText = number.substr(end);
    number.resize(end);
    if (const std::size_t power = number.find('@'); power != number.npos) {
        number[power] = 'e';
        std::erase(number, '^');
    }
    if (number.find(',') != number.npos) {
        const bool isDecimal = std::ranges::count(number, ',') == 1 && number.find('.') == number.npos;
        return refused(isDecimal ? QuantityFault::CommaForPoint : QuantityFault::NotANumber);
    }
    const CellNumber parsed = parseNumber(trimmed(number), DecimalSign::Point);
    if (parsed.fault == RowFault::TooLarge) {
        return refused(QuantityFault::TooLarge);
    }
    if (std::isnan(parsed.value) || unitText.find_first_of("*/") == 0) { // words, or a product
        return refused(QuantityFault::NotANumber);
    }
    if (unitText.empty()) {
        return {parsed.value, {}};
    }
    const std::optional<Unit> unit = parseUnit(unitText);
    if (!unit) {
        return refused(QuantityFault::UnknownUnit);
    }
    if (!expected || unit->dimension != expected->dimension || unit->order != expected->order) {
        return refused(QuantityFault::WrongUnit);
    }
    return {converted(parsed.value, *unit, *expected), {}};
}

} // namespace slidercrank
