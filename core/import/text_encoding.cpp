// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/text_encoding.h"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>

namespace slidercrank
{

namespace
{

using Utf8 = boost::locale::utf::utf_traits<char>;

constexpr char32_t kReplacement = 0xFFFD;

unsigned byteAt(std::string_view bytes, std::size_t i)
{
    return static_cast<unsigned char>(bytes[i]);
}

/// Windows-1252 where it is not Latin-1: 0x80 to 0x9F. The five that it leaves open stay what they are.
constexpr std::array<char32_t, 32> kWindows1252{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

void append(std::string &text, char32_t c)
{
    Utf8::encode(c, std::back_inserter(text));
}

std::string fromUtf16(std::string_view bytes, bool littleEndian)
{
    std::u16string units(bytes.size() / 2, u'\0'); // half a unit at the end is nothing
    for (std::size_t i = 0; i < units.size(); ++i) {
        const unsigned first = byteAt(bytes, 2 * i);
        const unsigned second = byteAt(bytes, 2 * i + 1);
        units[i] = static_cast<char16_t>(littleEndian ? second << 8 | first : first << 8 | second);
    }
    std::string text;
    text.reserve(units.size() + units.size() / 8);
    for (auto at = units.cbegin(); at != units.cend();) {
        auto next = at;
        const char32_t c = boost::locale::utf::utf_traits<char16_t>::decode(next, units.cend());
        const bool isSound = boost::locale::utf::is_valid_codepoint(c);
        append(text, isSound ? c : kReplacement);
        at = isSound ? next : at + 1; // what follows half a pair may be sound again
    }
    return text;
}

std::string fromWindows1252(std::string_view bytes)
{
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        append(text, byte >= 0x80 && byte < 0xA0 ? kWindows1252[byte - 0x80U] : byte);
    }
    return text;
}

bool isUtf8(std::string_view bytes)
{
    std::size_t sound = 0;
    std::size_t broken = 0;
    for (std::size_t i = findBeyondAscii(bytes, 0); i < bytes.size(); i = findBeyondAscii(bytes, i)) {
        const std::size_t length = sequenceLength(bytes.substr(i));
        ++(length > 0 ? sound : broken);
        i += std::max<std::size_t>(length, 1);
    }
    return broken <= sound;
}

/// Text in UTF-16 without a mark: in what begins a table nearly every character is ASCII, every other byte zero.
std::optional<TextEncoding> findUtf16(std::string_view bytes)
{
    constexpr std::size_t kLookedAt = 1024;
    bytes = bytes.substr(0, std::min(bytes.size() / 2 * 2, kLookedAt));
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

} // namespace

std::size_t findBeyondAscii(std::string_view bytes, std::size_t from)
{
    std::uint64_t eight = 0; // at a time: nearly all of a table is ASCII
    for (; from + sizeof eight <= bytes.size(); from += sizeof eight) {
        std::memcpy(&eight, bytes.data() + from, sizeof eight);
        if ((eight & 0x8080808080808080U) != 0) {
            break;
        }
    }
    while (from < bytes.size() && byteAt(bytes, from) < 0x80) {
        ++from;
    }
    return from;
}

std::size_t sequenceLength(std::string_view text)
{
    const int trail = text.empty() ? -1 : Utf8::trail_length(text.front());
    const bool isWhole = trail >= 0 && static_cast<std::size_t>(trail) < text.size() &&
                         std::all_of(text.begin() + 1, text.begin() + 1 + trail, Utf8::is_trail);
    return isWhole ? static_cast<std::size_t>(trail) + 1 : 0;
}

EncodingFound findEncoding(std::string_view bytes)
{
    if (bytes.starts_with("\xEF\xBB\xBF")) {
        return {TextEncoding::Utf8, 3};
    }
    if (bytes.starts_with("\xFF\xFE")) {
        return {TextEncoding::Utf16LittleEndian, 2};
    }
    if (bytes.starts_with("\xFE\xFF")) {
        return {TextEncoding::Utf16BigEndian, 2};
    }
    if (const std::optional<TextEncoding> utf16 = findUtf16(bytes)) {
        return {*utf16, 0};
    }
    return {isUtf8(bytes) ? TextEncoding::Utf8 : TextEncoding::Windows1252, 0};
}

std::string toUtf8(std::string_view bytes, TextEncoding encoding)
{
    switch (encoding) {
    case TextEncoding::Utf8: return std::string(bytes);
    case TextEncoding::Utf16LittleEndian: return fromUtf16(bytes, true);
    case TextEncoding::Utf16BigEndian: return fromUtf16(bytes, false);
    case TextEncoding::Windows1252: return fromWindows1252(bytes);
    }
    return {};
}

std::size_t codeUnitSize(TextEncoding encoding)
{
    const bool isUtf16 = encoding == TextEncoding::Utf16LittleEndian || encoding == TextEncoding::Utf16BigEndian;
    return isUtf16 ? 2 : 1;
}

std::size_t sizeIn(TextEncoding encoding, std::string_view text)
{
    if (encoding == TextEncoding::Utf8) {
        return text.size();
    }
    std::size_t units = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        units += (byte & 0xC0U) == 0x80U ? 0 : byte >= 0xF0U && codeUnitSize(encoding) == 2 ? 2 : 1;
    }
    return units * codeUnitSize(encoding);
}

} // namespace slidercrank
