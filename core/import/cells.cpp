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

constexpr std::string_view kMinusSign = "\u2212";

bool isSign(std::string_view text)
{
    return text.starts_with('-') || text.starts_with('+');
}

/// Powers of ten that a double holds exactly.
constexpr std::array<double, 23> kExactPowers = [] {
    std::array<double, 23> powers{};
    double power = 1.0;
    for (double &each : powers) {
        each = power;
        power *= 10.0;
    }
    return powers;
}();

/// Reads the exponent, "e-12" or none; false where the text is something else.
bool readExponent(std::string_view text, int &exponent)
{
    constexpr int kLargest = 100'000; // far beyond any double, and no sum of such overflows
    if (text.empty()) {
        return true;
    }
    text.remove_prefix(text.substr(1).starts_with('+') && !text.substr(2).starts_with('-') ? 2 : 1);
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    const int limit = text.starts_with('-') ? -kLargest : kLargest;
    exponent = fault == std::errc::result_out_of_range ? limit : std::clamp(exponent, -kLargest, kLargest);
    return fault != std::errc::invalid_argument && end == text.data() + text.size();
}

/// `text`: an optional minus sign, digits with at most one decimal sign, an optional exponent.
CellNumber parsePlain(std::string_view text, char decimal)
{
    const bool isNegative = text.starts_with('-');
    const std::size_t begin = isNegative ? 1 : 0;
    std::uint64_t mantissa = 0;
    std::size_t point = text.npos;
    std::size_t end = begin; // of the digits
    for (; end < text.size(); ++end) {
        const auto digit = static_cast<unsigned>(text[end]) - unsigned{'0'};
        if (digit <= 9) {
            mantissa = 10 * mantissa + digit;
        } else if (text[end] == decimal && point == text.npos) {
            point = end;
        } else {
            break;
        }
    }
    const std::size_t length = end - begin - (point == text.npos ? 0 : 1);
    const bool hasExponent = end < text.size() && (text[end] == 'e' || text[end] == 'E');
    int exponent = 0;
    if (length == 0 || (end < text.size() && !hasExponent) || !readExponent(text.substr(end), exponent)) {
        return {.fault = RowFault::NotANumber};
    }
    const auto isNothing = [decimal](char c) { return c == '0' || c == decimal; };
    const auto placeOf = [&](std::size_t digit) {
        const std::size_t before = point == text.npos ? end : point; // of the point
        return exponent + static_cast<int>(before) - static_cast<int>(digit) - (digit < before ? 1 : 0);
    };
    CellNumber number;
    number.places.printed = point == end - 1 ? exponent : placeOf(end - 1);
    std::size_t first = begin;
    while (first < end && isNothing(text[first])) {
        ++first;
    }
    number.places.zero = first == end;
    if (!number.places.zero) {
        std::size_t last = end - 1;
        while (isNothing(text[last])) {
            --last;
        }
        number.places.first = placeOf(first);
        number.places.last = placeOf(last);
    }
    // Both factors are doubles exactly: one correctly rounded operation.
    constexpr std::size_t kMostDigits = 19; // of the mantissa
    constexpr std::uint64_t kLargestExact = std::uint64_t{1} << 53U;
    const auto power = static_cast<std::size_t>(std::abs(number.places.printed));
    if (length <= kMostDigits && mantissa <= kLargestExact && power < kExactPowers.size()) {
        const auto whole = static_cast<double>(mantissa);
        const double size = number.places.printed < 0 ? whole / kExactPowers[power] : whole * kExactPowers[power];
        number.value = isNegative ? -size : size;
        return number;
    }
    std::string pointed;
    if (decimal != '.' && point != text.npos) {
        pointed = text;
        pointed[point] = '.';
        text = pointed;
    }
    double value = 0.0; // stays where the number is too small
    const std::errc fault = std::from_chars(text.data(), text.data() + text.size(), value).ec;
    if (fault == std::errc::result_out_of_range && number.places.first > 0) {
        number.fault = RowFault::TooLarge;
    } else {
        number.value = value;
    }
    return number;
}

/// The number with "-" as its minus sign, no plus sign and no separators of thousands; empty where it is none.
std::string withoutSeparators(std::string_view text, char decimal, char separator)
{
    const std::size_t sign = text.starts_with(kMinusSign) ? kMinusSign.size() : isSign(text) ? 1 : 0;
    std::string plain = sign > 0 && text[0] != '+' ? "-" : "";
    text.remove_prefix(sign);
    const std::string_view whole = text.substr(0, text.find(decimal));
    const auto separators = std::ranges::count(whole, separator);
    bool isGrouped = whole.size() % 4 != 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        isGrouped = isGrouped && ((whole.size() - i) % 4 == 0 ? whole[i] == separator : isDigit(whole[i]));
    }
    const bool isClear = separators == 0 || (isGrouped && (whole.size() < text.size() || separators > 1));
    if (!isClear || isSign(text)) {
        return {};
    }
    std::ranges::remove_copy(whole, std::back_inserter(plain), separator);
    return plain.append(text.substr(whole.size()));
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

bool equalIgnoringCase(std::string_view text, std::string_view lowerCaseText)
{
    return std::ranges::equal(text, lowerCaseText, {}, lowerCase);
}

std::string_view takeLine(std::string_view &rest)
{
    const auto end = std::ranges::find_if(rest, [](char c) { return c == '\n' || c == '\r'; });
    const std::string_view line = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(line.size());
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
    return line;
}

Cell takeCell(std::string_view &rest, char delimiter)
{
    const bool bySpaces = delimiter == ' ';
    const char other = bySpaces ? '\t' : delimiter;
    const std::size_t size = rest.size();
    std::size_t begin = 0;
    while (begin < size && isBlank(rest[begin]) && (bySpaces || rest[begin] != delimiter)) {
        ++begin;
    }
    Cell cell;
    std::size_t end = begin;
    const bool isQuoted = begin < size && rest[begin] == '"';
    if (isQuoted) {
        for (++end; end < size && (rest[end] != '"' || rest.substr(end + 1).starts_with('"')); ++end) {
            end += rest[end] == '"' ? 1 : 0;
        }
        cell.text = trimmed(rest.substr(begin + 1, end - begin - 1));
        cell.wellFormed = end < size;
        begin = end = std::min(end + 1, size);
    }
    while (end < size && rest[end] != delimiter && rest[end] != other) {
        ++end;
    }
    const std::string_view text = trimmed(rest.substr(begin, end - begin));
    cell.text = isQuoted ? cell.text : text;
    cell.wellFormed = cell.wellFormed && (!isQuoted || text.empty());
    const bool isLast = end == size || (bySpaces && trimmed(rest.substr(end)).empty());
    rest = isLast ? std::string_view() : rest.substr(end + 1);
    return cell;
}

Cells splitCells(std::string_view line, char delimiter)
{
    Cells cells;
    std::string_view rest = line;
    do {
        cells.push_back(takeCell(rest, delimiter).text);
    } while (rest.data() != nullptr);
    while (!cells.empty() && cells.back().empty()) {
        cells.pop_back();
    }
    return cells;
}

Cells splitBetweenBlanks(std::string_view line, std::size_t least)
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
    if (text.empty() || equalIgnoringCase(text, "nan") || equalIgnoringCase(text, "-nan")) {
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
    text.remove_prefix(text.starts_with(kMinusSign) ? kMinusSign.size() : 0);
    return std::ranges::any_of(text, isDigit) && text.find_first_not_of("0123456789+-.,eE") == text.npos;
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
