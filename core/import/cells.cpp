// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"

#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace slidercrank
{

namespace
{

constexpr std::string_view kGaps = "nan -nan na n/a #n/a #div/0! #num! null";

constexpr char kApostrophe = '\'';

/// Minus signs, Fortran's exponents, and the characters that only separate thousands.
constexpr std::string_view kNumberSpellings = "\u2212=-| ='|\u00A0='|\u2009='|\u202F='|D=e|d=e";

/// Parses "e-12" or nothing. Returns false for any other text. An exponent beyond any double is limited, so that no sum
/// overflows.
bool parseExponent(std::string_view text, int &exponent)
{
    constexpr int kLargest = 100'000;
    if (text.empty()) {
        return true;
    }
    const std::size_t digits = text.find_first_not_of("+-", 1);
    for (const char c : text.substr(std::min(digits, text.size()))) {
        if (!isDigit(c)) {
            return false;
        }
        exponent = std::min(10 * exponent + (c - '0'), kLargest);
    }
    exponent = text.substr(1).starts_with('-') ? -exponent : exponent;
    return digits == 1 || digits == 2;
}

/// Parses an optional minus sign, digits with at most one decimal sign, and an optional exponent. Large files consist
/// of such numbers, so that they are parsed without a copy.
CellNumber parsePlain(std::string_view text, char decimal)
{
    CellNumber number;
    int count = 0;             // of digits
    int zeros = 0;             // leading ones
    int last = 0;              // number of digits up to the last one that is not 0
    std::optional<int> before; // digits before the decimal sign
    const bool isNegative = text.starts_with('-');
    std::size_t end = isNegative ? 1 : 0;
    std::uint64_t digits = 0; // as a whole number
    for (; end < text.size(); ++end) {
        if (isDigit(text[end])) {
            ++count;
            digits = 10 * digits + static_cast<unsigned>(text[end] - '0');
            last = text[end] == '0' ? last : count;
            zeros += last == 0 ? 1 : 0;
        } else if (text[end] == decimal && !before) {
            before = count;
        } else {
            break;
        }
    }
    const std::string_view rest = text.substr(end);
    int exponent = 0;
    if (count == 0 || !(rest.empty() || rest[0] == 'e' || rest[0] == 'E') || !parseExponent(rest, exponent)) {
        number.fault = RowFault::NotANumber;
        return number;
    }
    const int top = exponent + before.value_or(count); // power of ten one above the first digit
    number.places = {zeros == count, top - zeros - 1, top - last, top - count};
    constexpr int kExactDigits = 15; // fit into a double
    constexpr int kExactPower = 22;  // the same of a power of ten
    const int power = number.places.printed;
    if (count - zeros <= kExactDigits && std::abs(power) <= kExactPower) {
        // Both factors are exact, so that the result is correctly rounded.
        const auto whole = static_cast<double>(digits);
        const double size = power < 0 ? whole / powerOfTen(-power) : whole * powerOfTen(power);
        number.value = isNegative ? -size : size;
        return number;
    }
    std::string pointed;
    if (decimal != '.' && before) {
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
    std::string plain = respelled(text, kNumberSpellings);
    plain.erase(plain.find_last_not_of(kApostrophe) + 1);
    plain.erase(0, plain.find_first_not_of(kApostrophe));
    const bool isNegative = plain.starts_with('-');
    plain.erase(0, isNegative || plain.starts_with('+') ? 1 : 0);
    if (plain.starts_with('-') || plain.starts_with('+')) {
        return {};
    }
    const std::string whole = plain.substr(0, plain.find(decimal));
    separator = whole.find(kApostrophe) != whole.npos ? kApostrophe : separator;
    std::string digits = whole;
    const std::size_t separators = std::erase(digits, separator);
    plain.replace(0, whole.size(), digits);
    std::string grouped = digits;
    for (std::size_t end = digits.size(); end > 3; end -= 3) {
        grouped.insert(end - 3, 1, separator);
    }
    const bool isClear = separators > 1 || separator == kApostrophe || digits.size() < plain.size();
    const bool isGrouped = grouped == whole && isClear;
    return separators == 0 || isGrouped ? (isNegative ? '-' + plain : plain) : std::string();
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
    CellNumber number = parsePlain(text, decimal); // the only object to be returned, so that none is copied
    if (number.fault != RowFault::NotANumber) {
        return number;
    }
    if (text.empty() || isAmong(lowered(text), kGaps)) {
        number.fault.reset();
        return number;
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
