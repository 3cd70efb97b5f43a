// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/number_text.h"

#include "core/import/cell_scanner.h"
#include "core/import/rounding.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr std::string_view kMinusSign = "\u2212";

CellNumber unreadable(RowFault fault)
{
    CellNumber number;
    number.fault = fault;
    return number;
}

/// The number that all of `digits` are, if they are one; with its point, whatever the file's decimal sign.
std::optional<double> valueOf(std::string_view digits)
{
    const std::size_t first = !digits.empty() && digits.front() == '-' ? 1 : 0;
    if (first == digits.size() || !((digits[first] >= '0' && digits[first] <= '9') || digits[first] == '.')) {
        return std::nullopt; // also inf, which from_chars would take
    }
    double value = 0.0;
    const char *const end = digits.data() + digits.size();
    const auto [last, fault] = std::from_chars(digits.data(), end, value);
    if (last != end || fault == std::errc::invalid_argument) {
        return std::nullopt;
    }
    if (fault == std::errc::result_out_of_range) {
        const double sizeBeyondDouble = placesOf(digits).first > 0 ? std::numeric_limits<double>::infinity() : 0.0;
        return sizeBeyondDouble;
    }
    return value;
}

} // namespace

bool equalIgnoringCase(std::string_view text, std::string_view lowerCase)
{
    return std::equal(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(), [](char x, char lower) {
        return (x >= 'A' && x <= 'Z' ? static_cast<char>(x - 'A' + 'a') : x) == lower;
    });
}

bool looksNumeric(std::string_view text)
{
    text.remove_prefix(text.starts_with(kMinusSign) ? kMinusSign.size() : 0);
    return text.find_first_of("0123456789") != std::string_view::npos &&
           text.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
}

CellNumber readNumber(std::string_view text, DecimalSign decimalSign)
{
    if (text.starts_with(kMinusSign)) {
        const std::string_view magnitude = text.substr(kMinusSign.size());
        const bool isMagnitude = !magnitude.empty() && magnitude[0] != '-' && magnitude[0] != '+';
        CellNumber number = isMagnitude ? readNumber(magnitude, decimalSign) : unreadable(RowFault::NotANumber);
        number.value = -number.value;
        return number;
    }
    const bool comma = decimalSign == DecimalSign::Comma;
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    CellNumber number;
    number.digits = plus ? text.substr(1) : text;

    std::optional<double> value;
    std::array<char, 128> withPoint; // no number needs more
    if (!comma) {
        value = valueOf(number.digits);
    } else if (number.digits.size() <= withPoint.size() && number.digits.find('.') == std::string_view::npos) {
        std::replace_copy(number.digits.begin(), number.digits.end(), withPoint.begin(), ',', '.');
        value = valueOf({withPoint.data(), number.digits.size()});
    }
    if (value && std::isfinite(*value)) {
        number.value = *value;
        return number;
    }
    if (value) {
        return unreadable(RowFault::TooLarge);
    }
    if (text.empty() || equalIgnoringCase(text, "nan") || equalIgnoringCase(text, "-nan")) {
        return {};
    }
    if (looksNumeric(text) && text.find(comma ? '.' : ',') != std::string_view::npos) {
        return unreadable(comma ? RowFault::PointForComma : RowFault::CommaForPoint);
    }
    return unreadable(RowFault::NotANumber);
}

std::optional<NumberWithUnit> numberWithUnit(std::string_view text)
{
    for (const char *const begins : {" \t", "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ\xC2\xCE"}) {
        const std::size_t at = text.find_first_of(begins);
        if (at == text.npos || at == 0) {
            continue;
        }
        const NumberWithUnit parts{trimmed(text.substr(0, at)), trimmed(text.substr(at))};
        if (looksNumeric(parts.number) && !parts.unit.empty() && unitOf(parts.unit)) {
            return parts;
        }
    }
    return std::nullopt;
}

std::string_view withoutUnit(std::string_view text, std::string_view unit)
{
    return !unit.empty() && text.ends_with(unit) ? trimmed(text.substr(0, text.size() - unit.size())) : text;
}

} // namespace slidercrank
