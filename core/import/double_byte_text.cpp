// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/double_byte_text.h"

#include "core/import/cells.h"
#include "core/import/unit_text.h"

#include <charconv>
#include <cstddef>
#include <unordered_map>
#include <utility>

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

/// Returns the characters by their codes, which differ in both encodings.
const std::unordered_map<unsigned, std::string_view> &knownCharacters()
{
    constexpr int kEncodings = 2;
    constexpr int kHexadecimal = 16;
    static const std::unordered_map<unsigned, std::string_view> kTable = [] {
        std::unordered_map<unsigned, std::string_view> characters;
        for (std::string_view rest = kCharacters; !rest.empty();) {
            const std::string_view character = takeUntil(' ', rest);
            for (int encoding = 0; encoding < kEncodings; ++encoding) {
                const std::string_view digits = takeUntil(' ', rest);
                unsigned code = 0;
                std::from_chars(digits.data(), digits.data() + digits.size(), code, kHexadecimal);
                characters.emplace(code, character);
            }
        }
        return characters;
    }();
    return kTable;
}

} // namespace

std::optional<std::string> decodeDoubleBytes(std::string_view bytes)
{
    constexpr std::ptrdiff_t kFewestKnown = 2; // a single one may be two letters of another encoding by chance
    constexpr unsigned kSmallestSecondByte = 0x40;
    constexpr std::string_view kUnknown = "〓"; // the sign that printers use for a missing character
    std::string text;
    std::ptrdiff_t known = 0;
    std::ptrdiff_t unknown = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (byteOf(bytes[i]) < 0x80) {
            text += bytes[i];
            continue;
        }
        const bool isPair = i + 1 < bytes.size() && byteOf(bytes[i + 1]) >= kSmallestSecondByte;
        const auto found = knownCharacters().find(isPair ? byteOf(bytes[i]) * 0x100 + byteOf(bytes[i + 1]) : 0);
        const bool isKnown = isPair && found != knownCharacters().end();
        text += isKnown ? found->second : kUnknown;
        ++(isKnown ? known : unknown);
        i += isPair ? 1 : 0;
    }
    const bool isSure = known >= kFewestKnown && 2 * known > unknown;
    return isSure ? std::optional(std::move(text)) : std::nullopt;
}

} // namespace slidercrank
