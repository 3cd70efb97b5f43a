// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/unit_text.h"

#include "core/mechanism/channel.h"

#include <array>
#include <string>

namespace slidercrank
{

namespace
{

struct NamedUnit {
    std::string_view name;
    Unit unit;
};

constexpr Unit kMillimetre{Dimension::Length, 0, 1.0};
constexpr Unit kCentimetre{Dimension::Length, 0, 10.0};
constexpr Unit kMetre{Dimension::Length, 0, 1e3};
constexpr Unit kInch{Dimension::Length, 0, 25.4};
constexpr Unit kDegree{Dimension::Angle, 0, 1.0};
constexpr Unit kRadian{Dimension::Angle, 0, kDegreesPerRadian};
constexpr Unit kRpm{Dimension::Angle, 1, 6.0};
constexpr Unit kSecond{Dimension::Time, 0, 1.0};
constexpr Unit kMillisecond{Dimension::Time, 0, 1e3};
constexpr Unit kMicrosecond{Dimension::Time, 0, 1e6};

constexpr std::array<NamedUnit, 33> kUnits{{{"mm", kMillimetre},
                                            {"millimeter", kMillimetre},
                                            {"millimetre", kMillimetre},
                                            {"milimetros", kMillimetre},
                                            {"cm", kCentimetre},
                                            {"m", kMetre},
                                            {"meter", kMetre},
                                            {"metre", kMetre},
                                            {"metros", kMetre},
                                            {"in", kInch},
                                            {"inch", kInch},
                                            {"deg", kDegree},
                                            {"degree", kDegree},
                                            {"degrees", kDegree},
                                            {"grado", kDegree},
                                            {"grados", kDegree},
                                            {"rad", kRadian},
                                            {"radian", kRadian},
                                            {"radians", kRadian},
                                            {"radianes", kRadian},
                                            {"rpm", kRpm},
                                            {"s", kSecond},
                                            {"sec", kSecond},
                                            {"secs", kSecond},
                                            {"second", kSecond},
                                            {"seconds", kSecond},
                                            {"seg", kSecond},
                                            {"segundo", kSecond},
                                            {"segundos", kSecond},
                                            {"ms", kMillisecond},
                                            {"msec", kMillisecond},
                                            {"us", kMicrosecond},
                                            {"milliseconds", kMillisecond}}};

std::optional<Unit> unitNamed(std::string_view name)
{
    for (const NamedUnit &unit : kUnits) {
        if (unit.name == name) {
            return unit.unit;
        }
    }
    return std::nullopt;
}

/// Lower case, without spaces, "^", "*" and parentheses; degree, square and micro signs (also the ordinal sign that
/// stands for degrees on Spanish keyboards, and all of them as a single byte) as "deg", "2" and "u".
std::string plainUnit(std::string_view text)
{
    std::string plain;
    for (const char c : text) {
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

std::optional<Unit> unitOf(std::string_view text)
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
