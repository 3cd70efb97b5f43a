// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"

#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace slidercrank
{

namespace
{

/// Powers of ten that a double represents exactly.
constexpr std::array kExactPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

constexpr std::string_view kGaps = "nan -nan na n/a #n/a #div/0! #num! null";

constexpr char kApostrophe = '\'';

/// Minus signs, Fortran's exponents, and the characters that only separate thousands.
constexpr std::string_view kNumberSpellings = "\u2212=-| ='|\u00A0='|\u2009='|\u202F='|D=e|d=e";

/// Parses "e-12" or nothing. Returns false for any other text.
bool parseExponent(std::string_view text, int &exponent)
{
    constexpr int kLargest = 100'000; // far beyond any double, and small enough that no sum overflows
    if (text.empty()) {
        return true;
    }
    text.remove_prefix(text.substr(1).starts_with('+') && !text.substr(2).starts_with('-') ? 2 : 1);
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    const int limit = text.starts_with('-') ? -kLargest : kLargest;
    exponent = fault == std::errc::result_out_of_range ? limit : std::clamp(exponent, -kLargest, kLargest);
    return fault != std::errc::invalid_argument && end == text.data() + text.size();
}

/// Parses an optional minus sign, digits with at most one decimal sign, and an optional exponent.
CellNumber parsePlain(std::string_view text, char decimal)
{
    CellNumber number; // returned everywhere, so that it is never copied
    const bool isNegative = text.starts_with('-');
    std::uint64_t mantissa = 0;
    int count = 0;  // of digits
    int whole = -1; // digits before the decimal sign; -1: no decimal sign yet
    const std::size_t begin = isNegative ? 1 : 0;
    std::size_t end = begin;
    for (; end < text.size(); ++end) {
        const auto digit = static_cast<unsigned>(text[end]) - unsigned{'0'};
        if (digit <= 9) {
            ++count;
            mantissa = 10 * mantissa + digit;
        } else if (text[end] == decimal && whole < 0) {
            whole = count;
        } else {
            break;
        }
    }
    const bool hasExponent = end < text.size() && (text[end] == 'e' || text[end] == 'E');
    int exponent = 0;
    if (count == 0 || (end < text.size() && !hasExponent) || !parseExponent(text.substr(end), exponent)) {
        number.fault = RowFault::NotANumber;
        return number;
    }
    int zeros = 0; // leading ones
    for (std::size_t i = begin; i < end && (text[i] == '0' || text[i] == decimal); ++i) {
        zeros += text[i] == '0' ? 1 : 0;
    }
    const int beforeFirst = exponent + (whole < 0 ? count : whole); // power of ten one above the first digit
    constexpr int kMostDigits = 19;                                 // that fit into the mantissa
    number.places.zero = zeros == count;
    number.places.printed = beforeFirst - count;
    if (zeros < count) {
        number.places.first = beforeFirst - zeros - 1;
        number.places.last = number.places.printed;
        for (std::uint64_t rest = mantissa; count - zeros <= kMostDigits && rest % 10 == 0; rest /= 10) {
            ++number.places.last;
        }
    }
    // If both factors are exact, the result of one operation is correctly rounded.
    constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53U;
    const auto power = static_cast<std::size_t>(std::abs(number.places.printed));
    if (count - zeros <= kMostDigits && mantissa <= kLargestExact && power < kExactPowers.size()) {
        const auto exact = static_cast<double>(mantissa);
        const double size = number.places.printed < 0 ? exact / kExactPowers[power] : exact * kExactPowers[power];
        number.value = isNegative ? -size : size;
        return number;
    }
    std::string pointed;
    if (decimal != '.' && whole >= 0) {
        pointed = text;
        std::ranges::replace(pointed, decimal, '.');
        text = pointed;
    }
    double value = 0.0; // of a number that is too small
    const std::errc fault = std::from_chars(text.data(), text.data() + text.size(), value).ec;
    if (fault == std::errc::result_out_of_range && number.places.first > 0) {
        number.fault = RowFault::TooLarge;
    } else {
        number.value = value;
    }
    return number;
}

/// Returns the number without plus sign and thousands separators, or an empty text where these are ambiguous.
std::string withoutSeparators(std::string_view text, char decimal, char separator)
{
    const std::string respelledText = respelled(text, kNumberSpellings);
    std::string_view rest = respelledText;
    rest.remove_prefix(std::min(rest.find_first_not_of(kApostrophe), rest.size()));
    rest.remove_suffix(rest.size() - (rest.find_last_not_of(kApostrophe) + 1));
    std::string plain = rest.starts_with('-') ? "-" : "";
    rest.remove_prefix(rest.starts_with('-') || rest.starts_with('+') ? 1 : 0);
    const std::string_view whole = rest.substr(0, rest.find(decimal));
    const bool hasApostrophe = whole.find(kApostrophe) != whole.npos;
    separator = hasApostrophe ? kApostrophe : separator;
    const auto separators = std::ranges::count(whole, separator);
    bool isGrouped = whole.size() % 4 != 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        isGrouped = isGrouped && ((whole.size() - i) % 4 == 0 ? whole[i] == separator : isDigit(whole[i]));
    }
    const bool isClear =
        separators == 0 || (isGrouped && (hasApostrophe || whole.size() < rest.size() || separators > 1));
    if (!isClear || rest.starts_with('-') || rest.starts_with('+')) {
        return {};
    }
    std::ranges::remove_copy(whole, std::back_inserter(plain), separator);
    return plain.append(rest.substr(whole.size()));
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string_view takeLine(std::string_view &rest)
{
    const auto end = std::ranges::find_if(rest, [](char c) { return c == '\n' || c == '\r'; });
    const std::string_view line = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(line.size());
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
    return line;
}

std::string_view takeCell(std::string_view &rest, char delimiter)
{
    const bool bySpaces = delimiter == ' ';
    const char other = bySpaces ? '\t' : delimiter;
    const std::size_t size = rest.size();
    std::size_t begin = 0;
    while (begin < size && isBlank(rest[begin]) && (bySpaces || rest[begin] != delimiter)) {
        ++begin;
    }
    std::size_t end = begin;
    if (begin < size && rest[begin] == '"') {
        for (++end; end < size && (rest[end] != '"' || rest.substr(end + 1).starts_with('"')); ++end) {
            end += rest[end] == '"' ? 1 : 0;
        }
    }
    const std::size_t closing = end; // quotation mark
    while (end < size && rest[end] != delimiter && rest[end] != other) {
        ++end;
    }
    std::string_view text = trimmed(rest.substr(begin, end - begin));
    if (closing > begin && text.size() == closing + 1 - begin) {
        text = trimmed(text.substr(1, text.size() - 2));
    }
    const bool isLast = end == size || (bySpaces && trimmed(rest.substr(end)).empty());
    rest = isLast ? std::string_view() : rest.substr(end + 1);
    return text;
}

Cells splitCells(std::string_view line, char delimiter)
{
    Cells cells;
    std::string_view rest = line;
    do {
        cells.push_back(takeCell(rest, delimiter));
    } while (rest.data() != nullptr);
    while (!cells.empty() && cells.back().empty()) {
        cells.pop_back();
    }
    return cells;
}

Cells splitAtBlanks(std::string_view line, std::size_t least)
{
    Cells cells;
    std::size_t blanks = 0;
    int depth = 0;
    for (const char &c : trimmed(line)) {
        if (isBlank(c)) {
            ++blanks;
            continue;
        }
        const bool opens = c == '(' || c == '[';
        if (cells.empty() || (blanks >= least && depth == 0 && !opens)) {
            cells.push_back({&c, 0});
        }
        cells.back() = {cells.back().data(), &c + 1};
        depth += opens ? 1 : c == ')' || c == ']' ? -1 : 0;
        blanks = 0;
    }
    return cells;
}

CellNumber parseNumber(std::string_view text, DecimalSign decimalSign)
{
    const bool isComma = decimalSign == DecimalSign::Comma;
    const char decimal = isComma ? ',' : '.';
    const char separator = isComma ? '.' : ',';
    CellNumber number = parsePlain(text, decimal);
    if (number.fault != RowFault::NotANumber) {
        return number;
    }
    if (text.empty() || isAmong(lowered(text), kGaps)) {
        return {};
    }
    number = parsePlain(withoutSeparators(text, decimal, separator), decimal);
    if (number.fault == RowFault::NotANumber && looksNumeric(text) && text.find(separator) != text.npos) {
        number.fault = isComma ? RowFault::PointForComma : RowFault::CommaForPoint;
    }
    return number;
}

bool looksNumeric(std::string_view text)
{
    const std::string plain = respelled(text, kNumberSpellings);
    return std::ranges::any_of(plain, isDigit) && !plain.starts_with('e') &&
           plain.find_first_not_of("0123456789+-.,eE'") == plain.npos;
}

NumberWithUnit splitUnit(std::string_view text)
{
    for (const std::string_view begins : {" \t", "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ\xC2\xCE"}) {
        const std::size_t at = text.find_first_of(begins);
        const std::string_view unit = at == text.npos ? std::string_view() : trimmed(text.substr(at));
        if (!unit.empty() && looksNumeric(text.substr(0, at)) && parseUnit(unit)) {
            return {text.substr(0, at), unit};
        }
    }
    return {text};
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t kLongest = 40; // bytes
    if (text.size() <= kLongest) {
        return std::string(text);
    }
    std::size_t length = kLongest;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    return std::string(text.substr(0, length)) + "…";
}

} // namespace slidercrank
