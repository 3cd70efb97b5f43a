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

unsigned byteAt(std::string_view bytes, std::size_t i)
{
    return static_cast<unsigned char>(bytes[i]);
}

std::string fromUtf16(std::string_view bytes, bool littleEndian)
{
    std::u16string units(bytes.size() / 2, u'\0');
    for (std::size_t i = 0; i < units.size(); ++i) {
        const unsigned first = byteAt(bytes, 2 * i);
        const unsigned second = byteAt(bytes, 2 * i + 1);
        units[i] = static_cast<char16_t>(littleEndian ? second << 8U | first : first << 8U | second);
    }
    return boost::locale::conv::utf_to_utf<char>(units);
}

std::string fromWindows1252(std::string_view bytes)
{
    // Where it differs from Latin-1: 0x80 to 0x9F.
    constexpr std::array<char16_t, 32> kCharacters{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
    std::u16string characters(bytes.size(), u'\0');
    std::ranges::transform(bytes, characters.begin(), [&](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 && byte < 0xA0 ? kCharacters[byte - 0x80U] : static_cast<char16_t>(byte);
    });
    return boost::locale::conv::utf_to_utf<char>(characters);
}

bool isUtf8(std::string_view bytes)
{
    using Utf8 = boost::locale::utf::utf_traits<char>;
    std::size_t valid = 0;
    std::size_t invalid = 0;
    for (auto at = bytes.begin(); at != bytes.end();) {
        if (static_cast<unsigned char>(*at) < 0x80) {
            ++at;
            continue;
        }
        auto next = at;
        const bool isValid = boost::locale::utf::is_valid_codepoint(Utf8::decode(next, bytes.end()));
        ++(isValid ? valid : invalid);
        at = isValid ? next : at + 1;
    }
    return invalid <= valid;
}

/// Of text without a mark: in the beginning of a table nearly every character is ASCII, every other byte zero.
std::optional<TextEncoding> findUtf16(std::string_view bytes)
{
    bytes = bytes.substr(0, std::min<std::size_t>(bytes.size() / 2 * 2, 1024));
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    }
    const std::size_t most = bytes.size() / 2 * 3 / 4;
    if (bytes.size() < 4 || std::max(zeros[0], zeros[1]) < most || std::min(zeros[0], zeros[1]) > 0) {
        return std::nullopt;
    }
    return zeros[1] > 0 ? TextEncoding::Utf16LittleEndian : TextEncoding::Utf16BigEndian;
}

TextEncoding findEncoding(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE")) {
        return TextEncoding::Utf16LittleEndian;
    }
    if (bytes.starts_with("\xFE\xFF")) {
        return TextEncoding::Utf16BigEndian;
    }
    if (const std::optional<TextEncoding> utf16 = findUtf16(bytes)) {
        return *utf16;
    }
    constexpr std::size_t kLookedAt = std::size_t{1} << 20U;
    return bytes.starts_with(kUtf8Mark) || isUtf8(bytes.substr(0, kLookedAt)) ? TextEncoding::Utf8
                                                                              : TextEncoding::Windows1252;
}

/// Another format of text, by the first characters of the file.
std::optional<ReadFault::Kind> findFormat(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    text.remove_prefix(first);
    if (text.size() < 2) {
        return std::nullopt;
    }
    const char next = text[std::min(text.find_first_not_of(kBlanks, 1), text.size() - 1)];
    if (text[0] == '<' && (lowerCase(next) >= 'a' ? lowerCase(next) <= 'z' : next == '!' || next == '?')) {
        return ReadFault::Kind::Markup;
    }
    const bool isJson =
        text[0] == '{' ? next == '"' : text[0] == '[' && (next == '{' || next == '['); // "[s]" is a unit
    return isJson ? std::optional(ReadFault::Kind::Json) : std::nullopt;
}

/// Where the first byte stands that no text has; none in text. A few control characters are tolerated.
std::optional<std::size_t> findBinary(std::string_view text)
{
    const auto isControl = [](char c) {
        return static_cast<unsigned char>(c) < 0x20 &&
               std::string_view("\t\n\v\f\r\x1A\x1B").find(c) == std::string_view::npos;
    };
    const std::string_view beginning = text.substr(0, kFileBeginning);
    const std::size_t controls = static_cast<std::size_t>(std::ranges::count_if(beginning, isControl));
    if (100 * controls > beginning.size()) {
        return static_cast<std::size_t>(std::ranges::find_if(beginning, isControl) - beginning.begin());
    }
    const std::size_t zero = text.find('\0');
    return zero == text.npos ? std::nullopt : std::optional(zero);
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
    if (const std::optional<std::size_t> binary = findBinary(all)) {
        std::size_t line = 0;
        for (std::string_view rest = all; all.size() - rest.size() <= *binary; ++line) {
            takeLine(rest);
        }
        return refused(NotText, line);
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
