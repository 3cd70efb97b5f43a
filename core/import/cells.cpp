// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"

#include "core/import/unit_text.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace slidercrank
{

namespace
{

constexpr std::string_view kMinusSign = "\u2212";

/// Whether the text is digits in groups of three: "1.234", "12.345.678".
bool isGrouped(std::string_view text, char separator)
{
    const std::size_t first = std::min(text.find(separator), text.size());
    if (first == 0 || first > 3 || text.size() == first || (text.size() - first) % 4 != 0) {
        return false;
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isSeparator = i >= first && (i - first) % 4 == 0;
        if (isSeparator ? text[i] != separator : !isDigit(text[i])) {
            return false;
        }
    }
    return true;
}

/// The number with a decimal point, "-" as its minus sign and no separators of thousands; empty where it is none.
std::string plainNumber(std::string_view text, DecimalSign decimalSign)
{
    const char decimal = decimalSign == DecimalSign::Comma ? ',' : '.';
    const char separator = decimalSign == DecimalSign::Comma ? '.' : ',';
    std::string plain;
    if (text.starts_with(kMinusSign) || text.starts_with('-')) {
        plain = "-";
        text.remove_prefix(text[0] == '-' ? 1 : kMinusSign.size());
    } else if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const std::size_t point = text.find(decimal);
    std::string_view whole = text.substr(0, point);
    const bool hasSeparators = whole.find(separator) != whole.npos;
    const bool isClear = point != text.npos || std::ranges::count(whole, separator) > 1;
    if (text.empty() || text[0] == '-' || text[0] == '+' ||
        (hasSeparators && !(isClear && isGrouped(whole, separator)))) {
        return {};
    }
    std::ranges::remove_copy(whole, std::back_inserter(plain), separator);
    return point == text.npos ? plain : plain + '.' + std::string(text.substr(point + 1));
}

/// `plain`: with a decimal point and no plus sign.
CellNumber parsePlain(std::string_view plain)
{
    CellNumber number;
    const std::size_t first = plain.starts_with('-') ? 1 : 0;
    const bool isNumber = first < plain.size() && (isDigit(plain[first]) || plain[first] == '.'); // not "-inf"
    const char *const end = plain.data() + plain.size();
    double value = 0.0;
    const auto [last, fault] = std::from_chars(plain.data(), end, value);
    if (!isNumber || last != end || fault == std::errc::invalid_argument) {
        return {number.value, {}, RowFault::NotANumber};
    }
    number.places = placesOf(plain);
    if (fault == std::errc::result_out_of_range) {
        if (number.places.first > 0) {
            return {number.value, {}, RowFault::TooLarge};
        }
        value = 0.0;
    }
    number.value = value;
    return number;
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
    const auto isEnd = [](char c) { return c == '\n' || c == '\r'; };
    const auto length = static_cast<std::size_t>(std::ranges::find_if(rest, isEnd) - rest.begin());
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(length);
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : rest.empty() ? 0 : 1);
    return line;
}

Cell CellReader::next()
{
    const bool bySpaces = m_delimiter == ' ';
    const std::size_t size = m_rest.size();
    const auto endFrom = [&](std::size_t at) {
        while (at < size && m_rest[at] != m_delimiter && !(bySpaces && m_rest[at] == '\t')) {
            ++at;
        }
        return at;
    };
    std::size_t begin = 0;
    while (begin < size && isBlank(m_rest[begin]) && (bySpaces || m_rest[begin] != m_delimiter)) {
        ++begin;
    }
    Cell cell;
    std::size_t end = begin;
    if (begin < size && m_rest[begin] == '"') {
        std::size_t close = begin + 1;
        while (close < size && (m_rest[close] != '"' || (close + 1 < size && m_rest[close + 1] == '"'))) {
            close += m_rest[close] == '"' ? 2 : 1;
        }
        const std::size_t behind = std::min(close + 1, size);
        end = endFrom(behind);
        cell.text = trimmed(m_rest.substr(begin + 1, close - begin - 1));
        cell.wellFormed = close < size && trimmed(m_rest.substr(behind, end - behind)).empty();
    } else {
        end = endFrom(begin);
        cell.text = trimmed(m_rest.substr(begin, end - begin));
    }
    m_rest.remove_prefix(std::min(end + 1, size));
    m_hasCell = bySpaces ? !trimmed(m_rest).empty() : end < size;
    return cell;
}

std::vector<std::string_view> splitCells(std::string_view line, char delimiter)
{
    std::vector<std::string_view> cells;
    for (CellReader reader(line, delimiter); reader.hasCell();) {
        cells.push_back(reader.next().text);
    }
    while (!cells.empty() && cells.back().empty()) {
        cells.pop_back();
    }
    return cells;
}

Cells splitBetweenBlanks(std::string_view line, std::size_t least)
{
    Cells cells;
    line = trimmed(line);
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t at = 0; at <= line.size(); ++at) {
        const std::size_t end = std::min(line.find_first_not_of(" \t", at), line.size());
        if (at < line.size() && (depth > 0 || end - at < least)) {
            depth += line[at] == '(' || line[at] == '[' ? 1 : line[at] == ')' || line[at] == ']' ? -1 : 0;
            continue;
        }
        const std::string_view cell = line.substr(begin, at - begin);
        if (!cells.empty() && (cell.starts_with('(') || cell.starts_with('['))) {
            cells.back() = {cells.back().data(),
                            static_cast<std::size_t>(cell.data() + cell.size() - cells.back().data())};
        } else {
            cells.push_back(cell);
        }
        begin = end;
        at = end == line.size() ? end : end - 1;
    }
    return cells;
}

CellNumber parseNumber(std::string_view text, DecimalSign decimalSign)
{
    if (decimalSign == DecimalSign::Point) {
        if (CellNumber number = parsePlain(text); number.fault != RowFault::NotANumber) {
            return number;
        }
    }
    if (text.empty() || equalIgnoringCase(text, "nan") || equalIgnoringCase(text, "-nan")) {
        return {};
    }
    CellNumber number = parsePlain(plainNumber(text, decimalSign));
    const bool isComma = decimalSign == DecimalSign::Comma;
    if (number.fault == RowFault::NotANumber && looksNumeric(text) && text.find(isComma ? '.' : ',') != text.npos) {
        number.fault = isComma ? RowFault::PointForComma : RowFault::CommaForPoint;
    }
    return number;
}

bool looksNumeric(std::string_view text)
{
    text.remove_prefix(text.starts_with(kMinusSign) ? kMinusSign.size() : 0);
    return std::ranges::any_of(text, isDigit) && text.find_first_not_of("0123456789+-.,eE") == text.npos;
}

std::optional<NumberWithUnit> splitUnit(std::string_view text)
{
    for (const std::string_view begins : {" \t", "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ\xC2\xCE"}) {
        const std::size_t at = text.find_first_of(begins);
        if (at == text.npos || !looksNumeric(text.substr(0, at))) {
            continue;
        }
        if (const std::string_view unit = trimmed(text.substr(at)); parseUnit(unit)) {
            return NumberWithUnit{text.substr(0, at), unit};
        }
    }
    return std::nullopt;
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
