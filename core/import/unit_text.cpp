// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unit_text.h"

#include "core/mechanism/channel.h"

#include <algorithm>
#include <array>
#include <string>

namespace slidercrank
{

namespace
{

struct NamedUnit {
    std::string_view names;
    Unit unit;
};

constexpr std::array<NamedUnit, 11> kUnits{{
    {"mm millimeter millimetre millimeters millimetres milimetros", {Dimension::Length, 0, 1.0}},
    {"cm centimeter centimetre centimeters centimetres centimetros", {Dimension::Length, 0, 10.0}},
    {"m meter metre meters metres metros", {Dimension::Length, 0, 1e3}},
    {"in inch inches", {Dimension::Length, 0, 25.4}},
    {"deg degree degrees grado grados ca cad degca cadeg", {Dimension::Angle, 0, 1.0}},
    {"rad radian radians radianes", {Dimension::Angle, 0, kDegreesPerRadian}},
    {"rpm", {Dimension::Angle, 1, 6.0}},
    {"s sec secs second seconds seg segundo segundos", {Dimension::Time, 0, 1.0}},
    {"ms msec milliseconds", {Dimension::Time, 0, 1e3}},
    {"us", {Dimension::Time, 0, 1e6}},
    {"min minute minutes minuto minutos", {Dimension::Time, 0, 1.0 / 60.0}},
}};

std::optional<Unit> unitNamed(std::string_view name)
{
    const auto found =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const NamedUnit &each) { return isAmong(name, each.names); });
    return found == kUnits.end() ? std::nullopt : std::optional(found->unit);
}

/// Lower case, without spaces, "^", "*" and parentheses; degree, square and micro signs (also the Greek letter, the
/// ordinal sign that stands for degrees on Spanish keyboards, and all of them as a single byte) as "deg", "2" and "u".
std::string plainUnit(std::string_view text)
{
    constexpr std::string_view kMu = "\u03BC";
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (text.substr(i).starts_with(kMu)) {
            plain += 'u';
            i += kMu.size() - 1;
            continue;
        }
        switch (static_cast<unsigned char>(c)) {
        case 0xC2: // first byte of all these signs in UTF-8
        case ' ':
        case '\t':
        case '^':
        case '*':
        case '(':
        case ')': break;
        case 0xB0:
        case 0xBA: plain += "deg"; break;
        case 0xB2: plain += '2'; break;
        case 0xB5: plain += 'u'; break;
        default: plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return plain;
}

} // namespace

bool isAmong(std::string_view word, std::string_view words)
{
    const auto ends = [words](std::size_t at) { return at == words.size() || words[at] == ' '; };
    for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
        if ((at == 0 || words[at - 1] == ' ') && ends(at + word.size())) {
            return true;
        }
    }
    return false;
}

std::optional<Unit> parseUnit(std::string_view text)
{
    const std::string plain = plainUnit(text);
    std::string_view rest = plain;
    const std::string_view base = rest.substr(0, rest.find('/'));
    std::optional<Unit> unit = unitNamed(base);
    rest.remove_prefix(base.size());
    while (unit && !rest.empty()) {
        rest.remove_prefix(1);
        std::string_view per = rest.substr(0, rest.find('/'));
        rest.remove_prefix(per.size());
        const bool squared = !per.empty() && per.back() == '2';
        if (squared) {
            per.remove_suffix(1);
        }
        const std::optional<Unit> perTime = unitNamed(per);
        if (!perTime || perTime->dimension != Dimension::Time || unit->dimension == Dimension::Time) {
            return std::nullopt;
        }
        unit->factor *= squared ? perTime->factor * perTime->factor : perTime->factor;
        unit->order += squared ? 2 : 1;
    }
    return unit && unit->order <= 2 ? unit : std::nullopt;
}

} // namespace slidercrank
