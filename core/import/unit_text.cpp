// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unit_text.h"

#include "core/mechanism/channel.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>

namespace slidercrank
{

namespace
{

struct NamedUnit {
    std::string_view names;
    Unit unit;
};

/// On Spanish keyboards, the ordinal sign º stands for degrees. Micro has two code points, one is the Greek letter.
constexpr std::string_view kUnitSpellings =
    "1/min=rpm|min^-1=rpm|min-1=rpm|min⁻¹=rpm|s^-1=/s|s^-2=/s2|s-1=/s|s-2=/s2|s⁻¹=/s|s⁻²=/s2| "
    "=|\t=|.=|^=|*=|·=|(=|)=|²=2|°=deg|º=deg|\u00B5=u|\u03BC=u";

std::optional<Unit> unitNamed(std::string_view name)
{
    using enum Dimension;
    static constexpr std::array<NamedUnit, 19> kUnits{{
        {"mm millimeter millimetre millimeters millimetres milimetros", {Length, 0, 1.0}},
        {"cm centimeter centimetre centimeters centimetres centimetros", {Length, 0, 10.0}},
        {"m meter metre meters metres metros", {Length, 0, 1e3}},
        {"um micron microns", {Length, 0, 1e-3}},
        {"in inch inches", {Length, 0, 25.4}},
        {"ft foot feet", {Length, 0, 304.8}},
        {"g", {Length, 2, 9806.65}},
        {"deg degs degree degrees grado grados grad grd ca cad degca cadeg", {Angle, 0, 1.0}},
        {"rad radian radians radianes", {Angle, 0, kDegreesPerRadian}},
        {"mrad", {Angle, 0, 1e-3 * kDegreesPerRadian}},
        {"gon gons gradian gradians grads", {Angle, 0, 0.9}},
        {"rev revs revolution revolutions turn turns r u tr", {Angle, 0, 360.0}},
        {"rpm", {Angle, 1, 6.0}},
        {"s sec secs second seconds sek sekunde sekunden seconde secondes secondi seg segundo segundos",
         {Time, 0, 1.0}},
        {"ms msec msecs millis millisecond milliseconds milisegundos", {Time, 0, 1e3}},
        {"us usec micros microsecond microseconds microsegundos", {Time, 0, 1e6}},
        {"ns nanosecond nanoseconds", {Time, 0, 1e9}},
        {"min mins minute minutes minuto minutos", {Time, 0, 1.0 / 60.0}},
        {"h hr hour hours hora horas stunde stunden", {Time, 0, 1.0 / 3600.0}},
    }};
    const auto *const found = findElement(kUnits, [&](const NamedUnit &unit) { return isAmong(name, unit.names); });
    return found ? std::optional(found->unit) : std::nullopt;
}

} // namespace

std::string_view takeUntil(char separator, std::string_view &rest)
{
    const std::string_view part = rest.substr(0, rest.find(separator));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    return part;
}

bool isAmong(std::string_view word, std::string_view words)
{
    for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) {
            return true;
        }
    }
    return false;
}

std::string lowered(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), lowerCase);
    return lower;
}

std::string respelled(std::string_view text, std::string_view table)
{
    std::string result;
    while (!text.empty()) {
        // Also many characters at once, if none of them occurs in the table.
        std::string_view from = text.substr(0, std::max<std::size_t>(text.find_first_of(table), 1));
        std::string_view to = from;
        for (std::string_view rest = table; !rest.empty();) {
            const std::string_view entry = takeUntil('|', rest);
            const std::size_t sign = entry.find('=');
            if (text.starts_with(entry.substr(0, sign))) {
                from = entry.substr(0, sign);
                to = entry.substr(sign + 1);
                break;
            }
        }
        result += to;
        text.remove_prefix(from.size());
    }
    return result;
}

std::optional<Unit> parseUnit(std::string_view text)
{
    const std::string plain = lowered(respelled(text, kUnitSpellings)) + '/';
    std::string_view rest = plain;
    std::optional<Unit> unit = unitNamed(takeUntil('/', rest));
    while (unit && !rest.empty()) {
        std::string_view per = takeUntil('/', rest);
        const int power = per.ends_with('2') ? 2 : 1;
        per.remove_suffix(power == 2 ? 1 : 0);
        const std::optional<Unit> time = unitNamed(per);
        if (!time || time->dimension != Dimension::Time || unit->dimension == Dimension::Time) {
            return std::nullopt;
        }
        unit->factor *= power == 2 ? time->factor * time->factor : time->factor;
        unit->order += power;
    }
    return unit && unit->order <= 2 ? unit : std::nullopt;
}

} // namespace slidercrank
