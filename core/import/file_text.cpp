// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/file_text.h"

#include "core/import/cells.h"

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Windows-1252 from 0x80 to 0x9F, where it differs from Latin-1.
constexpr std::u16string_view kWindowsCharacters =
    u"\u20AC?\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152?\u017D??\u2018\u2019\u201C\u201D\u2022"
    u"\u2013\u2014\u02DC\u2122\u0161\u203A\u0153?\u017E\u0178";

std::string fromUtf16(std::string_view bytes, bool isLittleEndian)
{
    std::u16string units(bytes.size() / 2, u'\0');
    for (std::size_t i = 0; i < units.size(); ++i) {
        const auto first = static_cast<unsigned char>(bytes[2 * i]);
        const auto second = static_cast<unsigned char>(bytes[2 * i + 1]);
        units[i] = static_cast<char16_t>(isLittleEndian ? second * 256 + first : first * 256 + second);
    }
    return boost::locale::conv::utf_to_utf<char>(units);
}

std::string fromWindows1252(std::string_view bytes)
{
    std::u16string characters(bytes.size(), u'\0');
    std::ranges::transform(bytes, characters.begin(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 && byte < 0xA0 ? kWindowsCharacters[byte - 0x80U] : static_cast<char16_t>(byte);
    });
    return boost::locale::conv::utf_to_utf<char>(characters);
}

/// Whether at least half of the characters beyond ASCII are valid.
bool isUtf8(std::string_view bytes)
{
    using Utf8 = boost::locale::utf::utf_traits<char>;
    int surplus = 0;
    for (auto at = bytes.begin(); at != bytes.end();) {
        auto next = at + 1;
        if (static_cast<unsigned char>(*at) >= 0x80) {
            next = at;
            const bool isValid = boost::locale::utf::is_valid_codepoint(Utf8::decode(next, bytes.end()));
            surplus += isValid ? 1 : -1;
            next = isValid ? next : at + 1;
        }
        at = next;
    }
    return surplus >= 0;
}

/// Of text without a mark: in the beginning of a table nearly every character is ASCII, every other byte zero.
std::optional<TextEncoding> findUtf16(std::string_view bytes)
{
    bytes = bytes.substr(0, std::min<std::size_t>(bytes.size() / 2 * 2, 1024));
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    }
    const auto [least, most] = std::minmax(zeros[0], zeros[1]);
    if (bytes.size() < 4 || least > 0 || most < bytes.size() / 2 * 3 / 4) {
        return std::nullopt;
    }
    return zeros[1] > 0 ? TextEncoding::Utf16LittleEndian : TextEncoding::Utf16BigEndian;
}

TextEncoding findEncoding(std::string_view bytes)
{
    constexpr std::size_t kLookedAt = std::size_t{1} << 20U;
    if (const std::optional<TextEncoding> utf16 = findUtf16(bytes)) {
        return *utf16;
    }
    return bytes.starts_with("\xFF\xFE")                                        ? TextEncoding::Utf16LittleEndian
           : bytes.starts_with("\xFE\xFF")                                      ? TextEncoding::Utf16BigEndian
           : bytes.starts_with(kUtf8Mark) || isUtf8(bytes.substr(0, kLookedAt)) ? TextEncoding::Utf8
                                                                                : TextEncoding::Windows1252;
}

/// The first character other than a space behind that place; 0 where there is none.
char characterBehind(std::string_view text, std::size_t at)
{
    const std::size_t found = text.find_first_not_of(" \t\r\n", at);
    return found == text.npos ? '\0' : lowerCase(text[found]);
}

/// Other formats begin like this: "[s]" is a unit, though, and "<" alone may begin any bytes.
std::optional<ReadFault::Kind> findFormat(std::string_view bytes, std::string_view text)
{
    using enum ReadFault::Kind;
    const char first = characterBehind(text, 0);
    const char next = first == '\0' ? first : characterBehind(text, text.find(first) + 1);
    const bool isMarkup = first == '<' && ((next >= 'a' && next <= 'z') || next == '!' || next == '?');
    const bool isJson = (first == '{' && next == '"') || (first == '[' && (next == '{' || next == '['));
    return bytes.starts_with("%PDF") ? std::optional(Pdf)
           : isMarkup                ? std::optional(Markup)
           : isJson                  ? std::optional(Json)
                                     : std::nullopt;
}

/// Where the first byte stands that no text has; none in text. A few control characters are tolerated.
std::size_t findBinary(std::string_view text)
{
    const auto isControl = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 &&
               std::string_view("\t\n\v\f\r\x1A\x1B").find(c) == std::string_view::npos;
    };
    const std::string_view beginning = text.substr(0, kFileBeginning);
    const auto controls = static_cast<std::size_t>(std::ranges::count_if(beginning, isControl));
    return 100 * controls > beginning.size()
               ? static_cast<std::size_t>(std::ranges::find_if(beginning, isControl) - beginning.begin())
               : text.find('\0');
}

} // namespace

std::string_view FileText::in(std::string_view bytes) const
{
    if (encoding != TextEncoding::Utf8) {
        return converted;
    }
    return bytes.substr(byteOrderMark ? kUtf8Mark.size() : 0);
}

FileText decodeText(std::string_view bytes)
{
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0") || bytes.starts_with("\x1F\x8B")) {
        throw ReadError{.fault = {ReadFault::Kind::Spreadsheet}};
    }
    FileText text{findEncoding(bytes), bytes.starts_with(kUtf8Mark), {}};
    const bool isLittleEndian = text.encoding == TextEncoding::Utf16LittleEndian;
    if (isLittleEndian || text.encoding == TextEncoding::Utf16BigEndian) {
        text.byteOrderMark = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
        text.converted = fromUtf16(bytes.substr(text.byteOrderMark ? 2 : 0), isLittleEndian);
    } else if (text.encoding == TextEncoding::Windows1252) {
        text.converted = fromWindows1252(bytes);
    }
    const std::string_view all = text.in(bytes);
    const std::size_t binary = findBinary(all);
    const std::optional<ReadFault::Kind> format = findFormat(bytes, all);
    if (binary != all.npos && format != ReadFault::Kind::Pdf) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(all.substr(0, binary), '\n'));
        throw ReadError{.line = lines + 1, .fault = {ReadFault::Kind::NotText}};
    }
    if (format) {
        throw ReadError{.fault = {*format}};
    }
    return text;
}

std::optional<ReadError> findForeignFormat(std::string_view beginning)
{
    try {
        decodeText(beginning);
    } catch (ReadError &error) {
        return std::move(error);
    }
    return std::nullopt;
}

} // namespace slidercrank
