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

/// Another format of text, by the first characters of the file.
std::optional<ReadFault::Kind> findFormat(std::string_view text)
{
    const auto withoutSpace = [](std::string_view rest) {
        return rest.substr(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    };
    text = withoutSpace(text);
    const std::string_view behind = withoutSpace(text.substr(std::min<std::size_t>(text.size(), 1)));
    if (behind.empty()) {
        return std::nullopt;
    }
    const char next = lowerCase(behind[0]);
    if (text[0] == '<' && ((next >= 'a' && next <= 'z') || next == '!' || next == '?')) {
        return ReadFault::Kind::Markup;
    }
    const bool isJson =
        text[0] == '{' ? next == '"' : text[0] == '[' && (next == '{' || next == '['); // "[s]" is a unit
    return isJson ? std::optional(ReadFault::Kind::Json) : std::nullopt;
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

std::variant<FileText, ReadError> decodeText(std::string_view bytes)
{
    using enum ReadFault::Kind;
    const auto refused = [](ReadFault::Kind kind, std::size_t line = 0) { return ReadError{line, 0, {}, {kind}}; };
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0") || bytes.starts_with("\x1F\x8B")) {
        return refused(Spreadsheet);
    }
    if (bytes.starts_with("%PDF")) {
        return refused(Pdf);
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
    if (const std::size_t binary = findBinary(all); binary != all.npos) {
        return refused(NotText, 1 + static_cast<std::size_t>(std::ranges::count(all.substr(0, binary), '\n')));
    }
    if (const std::optional<ReadFault::Kind> format = findFormat(all)) {
        return refused(*format);
    }
    return text;
}

std::optional<ReadError> findForeignFormat(std::string_view beginning)
{
    std::variant<FileText, ReadError> outcome = decodeText(beginning);
    ReadError *const error = std::get_if<ReadError>(&outcome);
    return error ? std::optional(std::move(*error)) : std::nullopt;
}

} // namespace slidercrank
