// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/file_text.h"

#include "core/import/cells.h"
#include "core/import/double_byte_text.h"
#include "core/import/reference_data.h"
#include "core/import/spellings.h"
#include "core/import/unit_text.h"

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr unsigned kFirstLetter = 0xC0; // outside ASCII, in the code pages of Windows
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// Windows-1252 from 0x80 to 0x9F, where it differs from Latin-1.
constexpr std::u16string_view kWesternCharacters =
    u"\u20AC?\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152?\u017D??\u2018\u2019\u201C\u201D\u2022"
    u"\u2013\u2014\u02DC\u2122\u0161\u203A\u0153?\u017E\u0178";

/// Windows-1250 from 0x80: the letters of Polish, Czech and Hungarian.
constexpr std::u16string_view kCentralCharacters =
    u"€?‚?„…†‡?‰Š‹ŚŤŽŹ?‘’“”•–—?™š›śťžź\u00A0ˇ˘Ł¤Ą¦§¨©Ş«¬\u00AD®Ż°±˛ł´µ¶·¸ąş»Ľ˝ľż"
    u"ŔÁÂĂÄĹĆÇČÉĘËĚÍÎĎĐŃŇÓÔŐÖ×ŘŮÚŰÜÝŢßŕáâăäĺćçčéęëěíîďđńňóôőö÷řůúűüýţ˙";

/// Returns whether at least half of the characters outside ASCII are valid UTF-8.
bool isUtf8(std::string_view bytes)
{
    using Utf8 = boost::locale::utf::utf_traits<char>;
    int surplus = 0; // valid characters minus invalid bytes
    for (auto at = bytes.begin(); at != bytes.end();) {
        auto next = at + 1;
        if (byteOf(*at) >= 0x80) {
            next = at;
            const bool isValid = boost::locale::utf::is_valid_codepoint(Utf8::decode(next, bytes.end()));
            surplus += isValid ? 1 : -1;
            next = isValid ? next : at + 1;
        }
        at = next;
    }
    return surplus >= 0;
}

/// The formats that refuseFormats() looks for. Binary data may begin like markup or JSON, which are text.
enum class Formats { Binary, All };

/// Throws if a text begins like one of these formats. The beginnings are long enough for a table with "[s]" or "<" at
/// its beginning to be accepted.
void refuseFormats(std::string_view text, Formats formats)
{
    using enum ReadFault::Kind;
    constexpr std::array<std::pair<std::string_view, ReadFault::Kind>, 11> kBeginnings{
        {{"pk\x03\x04", Spreadsheet},
         {"\xD0\xCF\x11\xE0", Spreadsheet},
         {"\x1F\x8B", Spreadsheet},
         {"%pdf", Pdf},
         {"<!", Markup},
         {"<?", Markup},
         {"<html", Markup},
         {"<table", Markup},
         {"{\"", Json},
         {"[{", Json},
         {"[[", Json}}};
    constexpr std::size_t kExaminedSize = 1000; // bytes
    std::string beginning = lowered(text.substr(0, kExaminedSize));
    std::erase_if(beginning, isBlank);
    for (const auto &[bytes, format] : kBeginnings) {
        const bool isBinary = format == Spreadsheet || format == Pdf;
        if (beginning.starts_with(bytes) && (isBinary || formats == Formats::All)) {
            throw ReadError{.fault = {format}};
        }
    }
}

/// Returns the position of the first control character if more than one of a hundred bytes near the beginning is one,
/// and otherwise that of the first zero byte. Returns npos if the text has neither.
std::size_t findBinary(std::string_view text)
{
    const auto isControl = [](char c) {
        return byteOf(c) < 0x20 && std::string_view("\t\n\v\f\r\x1A\x1B").find(c) == std::string_view::npos;
    };
    constexpr std::size_t kMinBytesPerControl = 100; // in a text
    const std::string_view beginning = text.substr(0, kFileBeginning);
    const auto controls = static_cast<std::size_t>(std::ranges::count_if(beginning, isControl));
    return kMinBytesPerControl * controls > beginning.size()
               ? static_cast<std::size_t>(std::ranges::find_if(beginning, isControl) - beginning.begin())
               : text.find('\0');
}

/// Removes zero bytes and the end-of-file character (Ctrl+Z) after the text, unless there are more than kMaxPadding.
std::string_view withoutPadding(std::string_view text)
{
    constexpr std::size_t kMaxPadding = kFileBeginning / 2; // bytes
    const std::size_t end = text.find_last_not_of(std::string_view("\0\x1A", 2)) + 1;
    return text.size() - end <= kMaxPadding ? text.substr(0, end) : text;
}

/// Returns the text with box characters replaced by those of ASCII: "| 0.1 | 85 |" for "│ 0.1 │ 85 │", "+---+" for
/// "├───┤".
std::string withAsciiBoxes(std::string_view text)
{
    static const Spellings kBoxes = [] {
        Spellings boxes{};
        boxes.addCharacters("─━┄┅┈┉╌╍═", "-");
        boxes.addCharacters("│┃┆┇┊┋╎╏║", "|");
        boxes.addCharacters("┌┍┎┏┐┑┒┓└┕┖┗┘┙┚┛├┝┞┟┠┡┢┣┤┥┦┧┨┩┪┫┬┭┮┯┰┱┲┳┴┵┶┷┸┹┺┻┼┽┾┿╀╁╂╃╄╅╆╇╈╉╊╋"
                            "╒╓╔╕╖╗╘╙╚╛╜╝╞╟╠╡╢╣╤╥╦╧╨╩╪╫╬╭╮╯╰",
                            "+");
        return boxes;
    }();
    return kBoxes.replacedIn(text);
}

/// Returns whether lines are drawn with box characters near the beginning of a text.
bool hasBoxes(std::string_view text)
{
    const std::string_view beginning = text.substr(0, kFileBeginning);
    return beginning.find("\xE2\x94") != text.npos || beginning.find("\xE2\x95") != text.npos; // U+2500 to U+257F
}

/// Returns which byte of each pair is the lower one, 0 or 1, if the text is UTF-16: by the byte order mark or, without
/// one, because the other byte of most characters is zero. Otherwise nullopt.
std::optional<std::size_t> findLowerByte(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        return bytes[0] == '\xFF' ? 0 : 1;
    }
    const std::string_view beginning = bytes.substr(0, kFileBeginning);
    std::array<std::size_t, 2> zeros{}; // at even and at odd positions
    for (std::size_t i = 0; i < beginning.size(); ++i) {
        zeros[i % 2] += beginning[i] == '\0' ? 1 : 0;
    }
    const std::size_t lower = zeros[0] < zeros[1] ? 0 : 1;
    const bool isUtf16 = zeros[lower] == 0 && 4 * zeros[1 - lower] > beginning.size();
    return isUtf16 ? std::optional(lower) : std::nullopt;
}

/// The encodings with one byte per character that are distinguished: code pages of Windows.
enum class CodePage { Western, Central, Cyrillic };

bool isAsciiLetter(char c)
{
    return lowerCase(c) >= 'a' && lowerCase(c) <= 'z';
}

/// Returns the encoding of a text: the Cyrillic one if most letters outside ASCII have no letter of ASCII beside them;
/// otherwise that of Central Europe if one of the bytes of the Polish ł, ą and ż, which are ³, ¹ and ¿ in the Western
/// one, is between letters of ASCII; otherwise the Western one.
CodePage codePageOf(std::string_view bytes)
{
    std::ptrdiff_t apart = 0; // letters outside ASCII that have no letter of ASCII beside them, minus those that have
    bool isPolish = false;
    for (std::size_t i = 1; i + 1 < bytes.size(); ++i) {
        const bool isBesideAscii = isAsciiLetter(bytes[i - 1]) || isAsciiLetter(bytes[i + 1]);
        if (byteOf(bytes[i]) >= kFirstLetter) {
            apart += isBesideAscii ? -1 : 1;
        }
        isPolish = isPolish || (std::string_view("\xB3\xB9\xBF").find(bytes[i]) != std::string_view::npos &&
                                isAsciiLetter(bytes[i - 1]) && isAsciiLetter(bytes[i + 1]));
    }
    if (apart > 0) {
        return CodePage::Cyrillic;
    }
    return isPolish ? CodePage::Central : CodePage::Western;
}

/// Returns the character of a byte outside ASCII. Of the Cyrillic encoding, only the letters are known.
char16_t characterOf(unsigned char byte, CodePage page)
{
    if (page == CodePage::Central) {
        return kCentralCharacters[byte - 0x80U];
    }
    if (page == CodePage::Cyrillic && byte >= kFirstLetter) {
        return static_cast<char16_t>(u'\u0410' + byte - kFirstLetter);
    }
    return byte < 0xA0 ? kWesternCharacters[byte - 0x80U] : static_cast<char16_t>(byte);
}

std::u16string decodeAs(CodePage page, std::string_view bytes)
{
    std::u16string text(bytes.size(), u' ');
    std::ranges::transform(bytes, text.begin(), [page](unsigned char byte) {
        return byte >= 0x80 ? characterOf(byte, page) : static_cast<char16_t>(byte);
    });
    return text;
}

} // namespace

std::string_view decodeText(std::string_view bytes, std::string &converted)
{
    constexpr std::size_t kExamined = std::size_t{1} << 20U; // bytes, for the encoding
    refuseFormats(bytes, Formats::Binary);
    std::string_view text = bytes;
    std::u16string units; // the text, if it is in an encoding other than UTF-8
    if (const std::optional<std::size_t> lower = findLowerByte(bytes)) {
        units.resize(bytes.size() / 2);
        for (std::size_t i = 0; i < units.size(); ++i) {
            units[i] = static_cast<char16_t>(byteOf(bytes[2 * i + 1 - *lower]) * 256 + byteOf(bytes[2 * i + *lower]));
        }
    } else if (const std::string_view examined = bytes.substr(0, kExamined); !isUtf8(examined)) {
        if (isDoubleByteText(examined)) {
            text = converted = decodeDoubleBytes(bytes);
        } else {
            units = decodeAs(codePageOf(examined), bytes);
        }
    }
    if (!units.empty()) {
        text = converted = boost::locale::conv::utf_to_utf<char>(units);
    }
    text.remove_prefix(text.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
    if (hasBoxes(text)) {
        text = converted = withAsciiBoxes(text);
    }
    text = withoutPadding(text);
    if (const std::size_t binary = findBinary(text); binary != text.npos) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(text.substr(0, binary), '\n'));
        throw ReadError{.line = lines + 1, .fault = {ReadFault::Kind::NotText}};
    }
    refuseFormats(text, Formats::All);
    return text;
}

std::optional<ReadError> findForeignFormat(std::string_view beginning)
{
    try {
        std::string converted;
        decodeText(beginning, converted);
    } catch (ReadError &error) {
        return std::move(error);
    }
    return std::nullopt;
}

} // namespace slidercrank
