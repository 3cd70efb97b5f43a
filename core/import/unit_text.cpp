// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unit_text.h"

#include "core/import/cells.h"
#include "core/import/read_double.h"
#include "core/import/spellings.h"
#include "core/mechanism/channel.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

namespace slidercrank
{

namespace
{

using enum Dimension;

struct NamedUnit {
    std::string_view names;
    Unit unit;
};

/// Other spellings of units. On Spanish keyboards, the ordinal sign º stands for degrees; "¡" is the sign ° of a
/// Macintosh, read as Windows-1252. The sign of micro has two code points, of which one is the Greek letter.
const Spellings kUnitSpellings{{"×π rad", "pirad"},
                               {"π rad", "pirad"},
                               {"pi rad", "pirad"},
                               {"2π", "rev"},
                               {"2pi", "rev"},
                               {"2 pi", "rev"},
                               {"2*pi", "rev"},
                               {"1/min", "rpm"},
                               {"min^-1", "rpm"},
                               {"min-1", "rpm"},
                               {"min⁻¹", "rpm"},
                               {"dev/dk", "rpm"},
                               {"d/dk", "rpm"},
                               {"-per-", "/"},
                               {"_s_2", "/s2"},
                               {".s.2", "/s2"},
                               {"per", "/"},
                               {" pro ", "/"},
                               {" por ", "/"},
                               {" par ", "/"},
                               {"cycle/", "rev/"},
                               {"cycles/", "rev/"},
                               {"ciclos/", "rev/"},
                               {" al secondo", "/s"},
                               {" squared", "2"},
                               {" al cuadrado", "2"},
                               {" al quadrato", "2"},
                               {" ao quadrado", "2"},
                               {"\\milli", "m"},
                               {"\\centi", "c"},
                               {"\\metre", "m"},
                               {"\\meter", "m"},
                               {"\\radian", "rad"},
                               {"\\degree", "deg"},
                               {"\\second", "s"},
                               {"\\squared", "2"},
                               {"\\per", "/"},
                               {"\\,", " "},
                               {"^\\circ", "deg"},
                               {"\\circ", "deg"},
                               {"\\", ""},
                               {"° ' \"", "deg"},
                               {"°'\"", "deg"},
                               {"° ′ ″", "deg"},
                               {"°′″", "deg"},
                               {"deg min sec", "deg"},
                               {"deg min", "deg"},
                               {"\"", "in"},
                               {"''", "in"},
                               {"'", "ft"},
                               {"″", "in"},
                               {"°", "deg"},
                               {"¡", "deg"},
                               {"º", "deg"},
                               {"˚", "deg"},
                               {"Â°", "deg"},
                               {"\uFFFD", "deg"},
                               {"?", "deg"},
                               {"\u00B5", "u"},
                               {"\u03BC", "u"},
                               {"é", "e"},
                               {"è", "e"},
                               {"ê", "e"},
                               {"í", "i"},
                               {"ì", "i"},
                               {"²", "2"},
                               {"¹", "1"},
                               {"⁻", "-"},
                               {"\u2212", "-"},
                               {" cw", ""},
                               {" ccw", ""},
                               {" atdc", ""},
                               {" atc", ""},
                               {"atdc", ""},
                               {"\t", " "},
                               {".", " "},
                               {"·", " "},
                               {"⋅", " "},
                               {"**", ""},
                               {"*", " "},
                               {"×", " "},
                               {"_", "/"},
                               {"^", ""},
                               {"(", ""},
                               {")", ""},
                               {"{", ""},
                               {"}", ""},
                               {"$", ""}};

/// A new name of a unit is added to a row.
constexpr auto kUnits = std::to_array<NamedUnit>(
    {{"mm мм 毫米 millimeter millimetre millimeters millimetres millimetern milimetro milimetros millimetro millimetri",
      {Length, 0, 1.0}},
     {"cm cms см 厘米 сантиметр сантиметров centimeter centimetre centimeters centimetres centimetro centimetros "
      "centimetri",
      {Length, 0, 10.0}},
     {"m mts mtr м 米 meter metre meters metres metern metro metros metri", {Length, 0, 1e3}},
     {"um micron microns", {Length, 0, 1e-3}},
     {"dm", {Length, 0, 100.0}},
     {"km", {Length, 0, 1e6}},
     {"in inch inches pulgada pulgadas pulg pouce pouces polegada polegadas pollice pollici zoll pol tum tommer duim "
      "cale palce inç дюйм дюйма дюймов 英寸 インチ",
      {Length, 0, 25.4}},
     {"thou mil mils", {Length, 0, 0.0254}},
     {"ft foot feet fuß", {Length, 0, 304.8}},
     {"yd yard yards", {Length, 0, 914.4}},
     {"g", {Length, 2, 9806.65}},
     {"deg gr град 度 도 độ derajat fok aste astetta stupne stupnu degs degree degrees degre degres grado grados gradi "
      "grau graus graden grader grade grad grd stopnie stopni stopniach градусах градусов градусы derece ca cad degca "
      "cadeg kw degkw owk degowk degv degпкв degПКВ",
      {Angle, 0, 1.0}},
     {"dps", {Angle, 1, 1.0}},
     {"ips", {Length, 1, 25.4}},
     {"fpm", {Length, 1, 304.8 / 60.0}},
     {"kph kmh", {Length, 1, 1e6 / 3600.0}},
     {"mph", {Length, 1, 1'609'344.0 / 3600.0}},
     {"gal", {Length, 2, 10.0}},
     {"arcmin", {Angle, 0, 1.0 / 60.0}},
     {"fps", {Length, 1, 304.8}},
     {"rad рад radian radians radianes radianos radianti radianen", {Angle, 0, kDegreesPerRadian}},
     {"mrad", {Angle, 0, 1e-3 * kDegreesPerRadian}},
     {"pirad pi π", {Angle, 0, 180.0}},
     {"gon gons gradian gradians grads", {Angle, 0, 0.9}},
     {"rev revs revolution revolutions turn turns r u об tr tour tours giri vuelta vueltas umdrehung umdrehungen obr "
      "omw varv "
      "omdr",
      {Angle, 0, 360.0}},
     {"rpm", {Angle, 1, 6.0}},
     {"hz hertz cps", {Angle, 1, 360.0}},
     {"s с сек 秒 초 sn sec secs second seconds sek sekunde sekunden seconde secondes secondi secondo seconden seg "
      "segundo segundos segon segons sekundy sekund",
      {Time, 0, 1.0}},
     {"ms мс msec msecs millis millisecond milliseconds milisegundo milisegundos millisekunden millisecondi "
      "millisecondes",
      {Time, 0, 1e3}},
     {"us usec micros microsecond microseconds microsegundos mikrosekunden", {Time, 0, 1e6}},
     {"ns nanosecond nanoseconds", {Time, 0, 1e9}},
     {"min мин mins minute minutes minuto minutos minuten minuti", {Time, 0, 1.0 / 60.0}},
     {"h ч час hr hour hours hora horas stunde stunden", {Time, 0, 1.0 / 3600.0}}});

std::optional<Unit> findUnit(std::string_view name)
{
    static const std::unordered_map<std::string_view, Unit> kUnitsByName = [] {
        std::unordered_map<std::string_view, Unit> units;
        for (const NamedUnit &unit : kUnits) {
            for (std::string_view rest = unit.names; !rest.empty();) {
                units.emplace(takeUntil(' ', rest), unit.unit);
            }
        }
        return units;
    }();
    const auto found = kUnitsByName.find(name);
    return found != kUnitsByName.end() ? std::optional(found->second) : std::nullopt;
}

/// A factor of a product of units: "s-2" has the name "s" and the power -2.
struct UnitFactor {
    std::string_view name{};
    int power = 1;
};

/// Returns whether a name ends with the s of seconds behind a length or an angle, as in "ms" and "rads".
bool endsWithSeconds(std::string_view name)
{
    const std::optional<Unit> unit = name.ends_with('s') ? findUnit(name.substr(0, name.size() - 1)) : std::nullopt;
    return unit && unit->dimension != Time;
}

/// Removes the first factor from a product, and returns it. A power that is no number counts as 0. "ms-1" has the
/// factors "m" and "s-1", as in British textbooks: hardly anything is counted per millisecond.
UnitFactor takeFactor(std::string_view &product)
{
    UnitFactor factor{product.substr(0, product.find_first_of(" /-0123456789"))};
    if (product.substr(factor.name.size()).starts_with('-') && endsWithSeconds(factor.name)) {
        factor.name.remove_suffix(1);
    }
    product.remove_prefix(factor.name.size());
    const std::string_view power = product.substr(0, product.find_first_not_of("-0123456789"));
    if (!power.empty()) {
        factor.power = 0;
        std::from_chars(power.data(), power.data() + power.size(), factor.power);
    }
    product.remove_prefix(power.size());
    return factor;
}

/// Returns the unit of the first factor of a product. The last letters of "mmps", "rads" and "cms2" mean "per second";
/// but "cms" alone is the plural of cm.
std::optional<Unit> parseNumerator(const UnitFactor &factor)
{
    std::optional<Unit> unit = findUnit(factor.name);
    if (unit && factor.power == 1) {
        return unit;
    }
    if (unit && unit->order == 1 && factor.name.ends_with("ps")) { // "ips2": in/s²
        unit->order = factor.power;
        return unit;
    }
    const std::size_t suffix = factor.name.ends_with("ps") ? 2 : 1;
    const bool isRate = (!unit || factor.power == 2) && factor.name.ends_with('s') && factor.name.size() > suffix;
    unit = isRate ? findUnit(factor.name.substr(0, factor.name.size() - suffix)) : std::nullopt;
    if (unit) {
        unit->order = factor.power;
    }
    return unit && unit->dimension != Time ? unit : std::nullopt;
}

/// A unit, split from the power of ten before it.
struct ScaledUnit {
    double power = 1.0; ///< value of the power: 1e-3 in "10^-3 m"
    std::string unit{};
};

/// Splits a unit from the power of ten before it: "10^-3 m", "×10³ mm/s", "1e-3 m".
ScaledUnit splitPower(std::string_view text)
{
    static const Spellings kPowers{{"10^", "1e"}, {"10**", "1e"}, {"10 ", "1e1 "}, {"^", ""}};
    std::string_view rest = text;
    for (const std::string_view sign : {"×", "x", "*"}) {
        rest.remove_prefix(rest.starts_with(sign) ? sign.size() : 0);
    }
    const std::string plain = kPowers.replacedIn(withCarets(trimmed(rest)));
    const std::size_t end = std::min(plain.find(' '), plain.size());
    double power = 1.0;
    const bool isPower =
        plain.starts_with("1e") && readDouble(plain.data(), plain.data() + end, power).ec == std::errc();
    return isPower ? ScaledUnit{power, plain.substr(end)} : ScaledUnit{1.0, std::string(text)};
}

/// Parses a product of a length, an angle or nothing with powers of times, or a time: "mm", "mm/s", "rad s-2", "1/s",
/// "ms". R writes "mm/s" as "mm.s": a length is never multiplied by a time. Returns nullopt for other products.
std::optional<Unit> parseProduct(std::string_view product)
{
    constexpr int kLargestOrder = 2;
    std::optional<Unit> unit;
    bool isBehindSlash = false;
    for (std::string_view rest = trimmed(product); !rest.empty(); rest = trimmed(rest)) {
        if (rest[0] == '/') {
            isBehindSlash = true;
            rest.remove_prefix(1);
            continue;
        }
        const UnitFactor factor = takeFactor(rest);
        if (factor.name.empty() && factor.power == 1 && !unit && !isBehindSlash) { // "1/s"
            continue;
        }
        const std::optional<Unit> time = findUnit(factor.name);
        const bool isTime = time && time->dimension == Time && factor.power != 0;
        const bool isDivisor = isTime && (unit || isBehindSlash || factor.power < 0);
        if (isDivisor) {
            unit = unit.value_or(Unit{Angle, 0, kDegreesPerRadian}); // 1/s is rad/s
            unit->order += std::abs(factor.power);
            if (unit->dimension == Time || unit->order > kLargestOrder) {
                return std::nullopt;
            }
            unit->factor *= std::pow(time->factor, std::abs(factor.power));
        } else if (!unit && !isBehindSlash) {
            unit = parseNumerator(factor);
            if (!unit) {
                return std::nullopt;
            }
        } else {
            return std::nullopt;
        }
    }
    return unit && unit->order <= kLargestOrder ? unit : std::nullopt;
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

std::optional<Unit> parseUnit(std::string_view text)
{
    if (text == "kW") { // kilowatt; without this line it would be read as °KW, degrees of the crankshaft
        return std::nullopt;
    }
    const ScaledUnit scaled = splitPower(text);
    std::optional<Unit> unit = parseProduct(kUnitSpellings.replacedIn(lowered(scaled.unit)));
    if (unit) {
        unit->factor *= unit->dimension == Time ? 1.0 / scaled.power : scaled.power; // units in a second
    }
    return unit;
}

} // namespace slidercrank
