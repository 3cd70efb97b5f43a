// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/double_byte_text.h"

#include "core/import/cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace slidercrank
{

namespace
{

/// A character and its codes of two bytes; 0 if an encoding does not contain it.
struct KnownCharacter {
    std::string_view text;
    unsigned gbk;
    unsigned shiftJis;
};

/// The characters of the vocabulary. No two of them have the same code, even in different encodings.
constexpr auto kKnownCharacters = std::to_array<KnownCharacter>(
    {{"位", 0xCEBB, 0x88CA}, {"刻", 0xBFCC, 0x8D8F}, {"力", 0xC1A6, 0x97CD}, {"加", 0xBCD3, 0x89C1},
     {"厘", 0xC0E5, 0x97D0}, {"块", 0xBFE9, 0},      {"塞", 0xC8FB, 0x8DC7}, {"変", 0x89E4, 0x95CF},
     {"寸", 0xB4E7, 0x90A1}, {"差", 0xB2EE, 0x8DB7}, {"度", 0xB6C8, 0x9378}, {"接", 0xBDD3, 0x90DA},
     {"时", 0xCAB1, 0},      {"時", 0x9572, 0x8E9E}, {"曲", 0xC7FA, 0x8BC8}, {"杆", 0xB8CB, 0x9E57},
     {"柄", 0xB1FA, 0x95BF}, {"棒", 0xB0F4, 0x965F}, {"毫", 0xBAC1, 0x9F7C}, {"活", 0xBBEE, 0x8A88},
     {"滑", 0xBBAC, 0x8A8A}, {"秒", 0xC3EB, 0x9562}, {"移", 0xD2C6, 0x88DA}, {"米", 0xC3D7, 0x95C4},
     {"置", 0xD6C3, 0x9275}, {"英", 0xD3A2, 0x8970}, {"角", 0xBDC7, 0x8A70}, {"误", 0xCEF3, 0},
     {"转", 0xD7AA, 0},      {"轴", 0xD6E1, 0},      {"连", 0xC1AC, 0},      {"速", 0xCBD9, 0x91AC},
     {"連", 0xDF42, 0x9841}, {"間", 0xE967, 0x8AD4}, {"间", 0xBCE4, 0},      {"イ", 0xA5A4, 0x8343},
     {"ク", 0xA5AF, 0x834E}, {"コ", 0xA5B3, 0x8352}, {"ス", 0xA5B9, 0x8358}, {"ダ", 0xA5C0, 0x835F},
     {"チ", 0xA5C1, 0x8360}, {"ッ", 0xA5C3, 0x8362}, {"ト", 0xA5C8, 0x8367}, {"ド", 0xA5C9, 0x8368},
     {"ピ", 0xA5D4, 0x8373}, {"ラ", 0xA5E9, 0x8389}, {"ロ", 0xA5ED, 0x838D}, {"ン", 0xA5F3, 0x8393},
     {"ー", 0xA960, 0x815B}, {"轉", 0xDE44, 0xE77A}, {"塊", 0x894B, 0x89F2}, {"回", 0xBBD8, 0x89F1},
     {"軸", 0xDD53, 0x8EB2}, {"（", 0xA3A8, 0x8169}, {"）", 0xA3A9, 0x816A}, {"［", 0xA3DB, 0x816D},
     {"］", 0xA3DD, 0x816E}, {"°", 0xA1E3, 0x818B},  {"θ", 0xA6C8, 0x83C6},  {"ω", 0xA6D8, 0x83D6},
     {"α", 0xA6C1, 0x83BF},  {"φ", 0xA6D5, 0x83D3},  {"：", 0xA3BA, 0x8146}, {"／", 0xA3AF, 0x815E}});

/// Returns the character with a code in one of the two encodings; nullopt if none has it.
std::optional<std::string_view> characterWithCode(unsigned code)
{
    const auto hasCode = [code](const KnownCharacter &character) {
        return code != 0 && (character.gbk == code || character.shiftJis == code);
    };
    const auto found = std::ranges::find_if(kKnownCharacters, hasCode);
    return found != kKnownCharacters.end() ? std::optional(found->text) : std::nullopt;
}

/// Removes the first character of a text, and returns it in UTF-8; nullopt if it is unknown or a byte outside ASCII
/// without a second byte.
std::optional<std::string_view> takeKnownCharacter(std::string_view &bytes)
{
    constexpr unsigned kMinSecondByte = 0x40;
    const bool isAscii = byteOf(bytes[0]) < 0x80;
    const bool isPair = !isAscii && bytes.size() > 1 && byteOf(bytes[1]) >= kMinSecondByte;
    const std::string_view character = bytes.substr(0, isPair ? 2 : 1);
    bytes.remove_prefix(character.size());
    if (isAscii) {
        return character;
    }
    return isPair ? characterWithCode(byteOf(character[0]) * 0x100 + byteOf(character[1])) : std::nullopt;
}

} // namespace

bool isDoubleByteText(std::string_view bytes)
{
    constexpr std::size_t kMinKnown = 2; // a single one may be two letters of a different encoding by chance
    std::size_t known = 0;
    std::size_t unknown = 0;
    while (!bytes.empty()) {
        const bool isAscii = byteOf(bytes[0]) < 0x80;
        const bool isKnown = takeKnownCharacter(bytes).has_value();
        known += isKnown && !isAscii ? 1 : 0;
        unknown += isKnown ? 0 : 1;
    }
    return known >= kMinKnown && 2 * known > unknown;
}

std::string decodeDoubleBytes(std::string_view bytes)
{
    constexpr std::string_view kUnknown = "〓"; // the sign that printers use for a missing character
    std::string text;
    while (!bytes.empty()) {
        text += takeKnownCharacter(bytes).value_or(kUnknown);
    }
    return text;
}

} // namespace slidercrank
