// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/double_byte_text.h"

#include "core/import/cells.h"
#include "core/import/unit_text.h"
#include "core/mechanism/find_element.h"

#include <charconv>
#include <cstddef>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

/// The characters of the vocabulary, and the two bytes of each in GBK and in Shift-JIS; 0 where it does not occur.
constexpr std::string_view kCharacters =
    "位 CEBB 88CA 刻 BFCC 8D8F 力 C1A6 97CD 加 BCD3 89C1 厘 C0E5 97D0 块 BFE9 0 塞 C8FB 8DC7 変 89E4 95CF "
    "寸 B4E7 90A1 差 B2EE 8DB7 度 B6C8 9378 接 BDD3 90DA 时 CAB1 0 時 9572 8E9E 曲 C7FA 8BC8 杆 B8CB 9E57 "
    "柄 B1FA 95BF 棒 B0F4 965F 毫 BAC1 9F7C 活 BBEE 8A88 滑 BBAC 8A8A 秒 C3EB 9562 移 D2C6 88DA "
    "米 C3D7 95C4 置 D6C3 9275 英 D3A2 8970 角 BDC7 8A70 误 CEF3 0 转 D7AA 0 轴 D6E1 0 连 C1AC 0 "
    "速 CBD9 91AC 連 DF42 9841 間 E967 8AD4 间 BCE4 0 イ A5A4 8343 ク A5AF 834E コ A5B3 8352 ス A5B9 8358 "
    "ダ A5C0 835F チ A5C1 8360 ッ A5C3 8362 ト A5C8 8367 ド A5C9 8368 ピ A5D4 8373 ラ A5E9 8389 "
    "ロ A5ED 838D ン A5F3 8393 ー A960 815B 轉 DE44 E77A 塊 894B 89F2 回 BBD8 89F1 軸 DD53 8EB2 "
    "（ A3A8 8169 ） A3A9 816A ［ A3DB 816D ］ A3DD 816E ° A1E3 818B θ A6C8 83C6 ω A6D8 83D6 "
    "α A6C1 83BF φ A6D5 83D3 ： A3BA 8146 ／ A3AF 815E";

struct DoubleByteCharacter {
    std::string_view utf8{};
    unsigned gbk = 0;
    unsigned shiftJis = 0;
};

/// Removes the next code from the table.
unsigned takeCode(std::string_view &table)
{
    constexpr int kHexadecimal = 16;
    const std::string_view digits = takeUntil(' ', table);
    unsigned code = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), code, kHexadecimal);
    return code;
}

const std::vector<DoubleByteCharacter> &knownCharacters()
{
    static const std::vector<DoubleByteCharacter> kTable = [] {
        std::vector<DoubleByteCharacter> characters;
        for (std::string_view rest = kCharacters; !rest.empty();) {
            DoubleByteCharacter &character = characters.emplace_back();
            character.utf8 = takeUntil(' ', rest);
            character.gbk = takeCode(rest);
            character.shiftJis = takeCode(rest);
        }
        return characters;
    }();
    return kTable;
}

using Encoding = unsigned DoubleByteCharacter::*;

/// Returns whether a byte begins a character of two bytes. In Shift-JIS, some bytes are narrow letters of their own.
bool beginsPair(unsigned byte, Encoding encoding)
{
    const bool isNarrowLetter = encoding == &DoubleByteCharacter::shiftJis && byte >= 0xA0 && byte < 0xE0;
    return byte > 0x80 && byte < 0xFF && !isNarrowLetter;
}

/// A text, and how many of its characters outside ASCII are known.
struct DecodedText {
    std::string text{};
    std::ptrdiff_t known = 0;
    std::ptrdiff_t unknown = 0;
};

DecodedText decodeAs(Encoding encoding, std::string_view bytes)
{
    constexpr std::string_view kUnknown = "〓"; // the sign that printers use for a missing character
    DecodedText decoded;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const unsigned byte = byteOf(bytes[i]);
        if (byte < 0x80) {
            decoded.text += bytes[i];
            continue;
        }
        const bool isPair = beginsPair(byte, encoding) && i + 1 < bytes.size() && byteOf(bytes[i + 1]) >= 0x40;
        const unsigned code = isPair ? byte * 0x100 + byteOf(bytes[++i]) : 0;
        const auto *const found =
            findElement(knownCharacters(), [&](const DoubleByteCharacter &entry) { return entry.*encoding == code; });
        const bool isKnown = isPair && found;
        decoded.text += isKnown ? found->utf8 : kUnknown;
        ++(isKnown ? decoded.known : decoded.unknown);
    }
    return decoded;
}

} // namespace

std::optional<std::string> decodeDoubleBytes(std::string_view bytes)
{
    constexpr std::ptrdiff_t kFewestKnown = 2; // a single one may be two letters of another encoding by chance
    DecodedText gbk = decodeAs(&DoubleByteCharacter::gbk, bytes);
    DecodedText shiftJis = decodeAs(&DoubleByteCharacter::shiftJis, bytes);
    DecodedText &better = gbk.known - gbk.unknown >= shiftJis.known - shiftJis.unknown ? gbk : shiftJis;
    const bool isSure = better.known >= kFewestKnown && 2 * better.known > better.unknown;
    return isSure ? std::optional(std::move(better.text)) : std::nullopt;
}

} // namespace slidercrank
