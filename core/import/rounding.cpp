// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/rounding.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr int kLowestPower = -323;
constexpr int kHighestPower = 308;

using Powers = std::array<double, kHighestPower - kLowestPower + 1>;

/// The powers of ten that a double holds. A table: a step is asked for at every value compared.
const Powers &powersOfTen()
{
    static const Powers table = [] {
        Powers powers{};
        for (int power = kLowestPower; power <= kHighestPower; ++power) {
            std::array<char, 8> text{'1', 'e'}; // the nearest double on every system, which std::pow() is not
            const char *end = std::to_chars(text.data() + 2, text.data() + text.size(), power).ptr;
            std::from_chars(text.data(), end, powers[static_cast<std::size_t>(power - kLowestPower)]);
        }
        return powers;
    }();
    return table;
}

/// 10^exponent; 0 or infinity beyond what a double holds.
double powerOfTen(const Powers &powers, int exponent)
{
    if (exponent < kLowestPower) {
        return 0.0;
    }
    if (exponent > kHighestPower) {
        return std::numeric_limits<double>::infinity();
    }
    return powers[static_cast<std::size_t>(exponent - kLowestPower)];
}

/// A unit's conversion there and back may leave 9.99…9 of a printed 10: this part of a value decides no decade.
constexpr double kConversionSlack = 1e-12;

/// e such that 2^e <= magnitude < 2^(e + 1), of a positive number.
int binaryExponent(double magnitude)
{
    if (magnitude >= std::numeric_limits<double>::min()) { // as it stands in the number's bits
        return static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52U) - 1023;
    }
    return std::ilogb(magnitude);
}

/// Power of ten of the first digit of a positive number.
int decadeOf(const Powers &powers, double magnitude)
{
    const double nudged = magnitude * (1.0 + kConversionSlack);
    // log10 2 in units of 2^-18, rounded down: exact to the whole number over all exponents of a double.
    constexpr int kLog10Of2 = 78913;
    const int decade = (binaryExponent(nudged) * kLog10Of2) >> 18; // or the one after
    return nudged >= powerOfTen(powers, decade + 1) ? decade + 1 : decade;
}

/// A number of at most so many digits may be one that somebody chose (25, 360, 12.75), and then says nothing about how
/// the program rounds.
constexpr int kDigitsOfAChosenNumber = 4;

/// The place where the one number of a column was rounded, as far as that can be told. Zeros behind the point may be
/// its own: so many digits as a person chooses are taken for known. 3.07587e+07 was not rounded to a whole number.
int placeOfOneValue(const PrintedPlaces &places)
{
    const int place = std::min(places.last, std::max(places.printed, 0));
    const int known = std::max(places.first - kDigitsOfAChosenNumber + 1, places.printed);
    return places.printed < 0 ? std::min(place, known) : place;
}

/// Whether so many of all are more than chance: a value ends one place early in one case of ten.
bool isNoChance(double some, double all)
{
    return 4.0 * some >= all + 8.0;
}

bool isNearlyAll(double some, double all)
{
    return some >= 0.9 * all;
}

/// What a decade tells: the place where its values were rounded, and how many values say so.
struct Decade {
    int exponent;
    int place;
    double weight;
};

struct Fit {
    double distance;   ///< from the places of the decades, weighted
    double coarseness; ///< breaks ties: the larger is the more careful promise
};

template <typename PlaceOf>
Fit fitOf(const std::vector<Decade> &decades, PlaceOf placeOf)
{
    Fit fit{0.0, 0.0};
    for (const Decade &decade : decades) {
        const int place = placeOf(decade.exponent);
        fit.distance += decade.weight * std::abs(decade.place - place);
        fit.coarseness += decade.weight * place;
    }
    return fit;
}

bool isBetter(const Fit &fit, const Fit &best)
{
    return fit.distance < best.distance || (fit.distance == best.distance && fit.coarseness > best.coarseness);
}

} // namespace

double Rounding::stepAt(double value) const
{
    const Powers &powers = powersOfTen();
    switch (rule) {
    case Rule::Unknown: return 0.0;
    case Rule::Decimals: return unitFactor * powerOfTen(powers, -digits);
    case Rule::SignificantDigits: {
        const double printed = std::abs(value) / unitFactor;
        const int exponent = printed > 0.0 && std::isfinite(printed) ? decadeOf(powers, printed) : smallestExponent;
        const int place = std::min(exponent - digits + 1, coarsestPlace);
        return unitFactor * powerOfTen(powers, std::max(place, finestPlace));
    }
    }
    return 0.0;
}

Rounding Rounding::withDecimalsAt(double value) const
{
    Rounding rounding = *this;
    if (rule == Rule::SignificantDigits) {
        rounding.rule = Rule::Decimals;
        rounding.digits = -static_cast<int>(std::lround(std::log10(stepAt(value) / unitFactor)));
    }
    return rounding;
}

double Rounding::finestStep() const
{
    return rule == Rule::Unknown ? 0.0 : unitFactor * powerOfTen(powersOfTen(), finestPlace);
}

double RoundingSteps::stepElsewhere(double value)
{
    const double step = m_rounding.stepAt(value);
    const double printed = std::abs(value) / m_rounding.unitFactor;
    if (m_rounding.rule != Rounding::Rule::SignificantDigits) {
        m_from = 0.0;
        m_to = std::numeric_limits<double>::infinity();
        m_step = step;
    } else if (printed > 0.0 && std::isfinite(printed)) {
        // Short of the decade's ends, where the slack decides.
        const Powers &powers = powersOfTen();
        const int decade = decadeOf(powers, printed);
        m_from = m_rounding.unitFactor * powerOfTen(powers, decade) * (1.0 + 4.0 * kConversionSlack);
        m_to = m_rounding.unitFactor * powerOfTen(powers, decade + 1) * (1.0 - 4.0 * kConversionSlack);
        m_step = step;
    }
    return step;
}

PrintedPlaces placesOf(std::string_view digits)
{
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const char *const begin =
        digits.data() + (!digits.empty() && !isDigit(digits[0]) && digits[0] != '.' && digits[0] != ',' ? 1 : 0);
    const char *const end = digits.data() + digits.size();
    const char *point = end;
    const char *stop = begin; // behind the last digit: the end, or the exponent
    for (; stop != end && *stop != 'e' && *stop != 'E'; ++stop) {
        point = isDigit(*stop) ? point : stop;
    }
    int exponent = 0;
    for (const char *c = stop; c != end; ++c) {
        if (isDigit(*c)) {
            constexpr int kLargest = 100000; // far beyond any double, and no sum of such overflows
            exponent = std::min(exponent * 10 + (*c - '0'), kLargest);
        }
    }
    if (end - stop > 1 && stop[1] == '-') {
        exponent = -exponent;
    }
    point = std::min(point, stop);

    // The digit just before the point stands at 10^exponent.
    const auto placeOf = [&](const char *digit) {
        return static_cast<int>(digit < point ? point - digit - 1 : point - digit) + exponent;
    };
    const auto isNothing = [](char c) { return c == '0' || c == '.' || c == ','; };
    const char *last = stop;
    while (last != begin && isNothing(last[-1])) {
        --last;
    }
    PrintedPlaces places;
    places.printed = stop == point ? exponent : placeOf(stop - 1);
    places.zero = last == begin;
    if (!places.zero) {
        const char *first = begin;
        while (isNothing(*first)) {
            ++first;
        }
        places.first = placeOf(first);
        places.last = placeOf(last - 1);
    }
    return places;
}

PrintedPlaces shortestPlaces(PrintedPlaces places, std::string_view digits)
{
    std::array<char, 128> text; // no number needs more
    digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
    if (digits.size() > text.size()) {
        return places;
    }
    char *const end = std::replace_copy(digits.begin(), digits.end(), text.data(), ',', '.');
    double value = 0.0;
    if (std::from_chars(text.data(), end, value).ec != std::errc()) {
        return places; // beyond what a double holds
    }
    const auto shortest = std::to_chars(text.data(), text.data() + text.size(), value);
    const PrintedPlaces found = placesOf({text.data(), static_cast<std::size_t>(shortest.ptr - text.data())});
    places.zero = found.zero;
    places.first = found.first;
    places.last = found.last;
    return places;
}

void RoundingObserver::add(const RoundingObserver &later)
{
    for (std::size_t decade = 0; decade < kDecades; ++decade) {
        for (std::size_t length = 0; length < kMostDigits; ++length) {
            m_counts[decade][length] += later.m_counts[decade][length];
        }
    }
    m_long += later.m_long;
    m_values += later.m_values;
    m_zerosBehind += later.m_zerosBehind;
    m_coarsestPlace = std::max(m_coarsestPlace, later.m_coarsestPlace);
    m_finestPlace = std::min(m_finestPlace, later.m_finestPlace);
    m_smallestExponent = std::min(m_smallestExponent, later.m_smallestExponent);
    const bool differ =
        !m_onlyMagnitude.empty() && !later.m_onlyMagnitude.empty() && m_onlyMagnitude != later.m_onlyMagnitude;
    m_varies = m_varies || later.m_varies || differ;
    if (m_onlyMagnitude.empty()) {
        m_onlyMagnitude = later.m_onlyMagnitude;
    }
}

Rounding RoundingObserver::infer(double unitFactor) const
{
    return inferWith(isNoChance, unitFactor);
}

Rounding RoundingObserver::inferOfInstants(double unitFactor) const
{
    return inferWith(isNearlyAll, unitFactor);
}

Rounding RoundingObserver::inferWith(bool (*hasEnded)(double some, double all), double unitFactor) const
{
    Rounding rounding;
    rounding.unitFactor = unitFactor;
    if (m_onlyMagnitude.empty()) {
        return rounding;
    }
    rounding.smallestExponent = m_smallestExponent;
    rounding.finestPlace = m_finestPlace;
    if (!m_varies) {
        rounding.rule = Rounding::Rule::Decimals;
        rounding.digits = -placeOfOneValue(shortestPlaces(placesOf(m_onlyMagnitude), m_onlyMagnitude));
        return rounding;
    }

    std::vector<Decade> decades;
    for (std::size_t row = 0; row < kDecades; ++row) {
        const auto &counts = m_counts[row];
        const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
        double reached = 0.0;
        for (std::size_t length = 0; length < kMostDigits && total > 0.0; ++length) {
            reached += counts[length];
            if (reached == total || hasEnded(reached, total)) {
                const int exponent = static_cast<int>(row) - kLargestExponent;
                decades.push_back({exponent, exponent - static_cast<int>(length), total});
                break;
            }
        }
    }
    if (decades.empty()) {
        return rounding;
    }

    Fit best{std::numeric_limits<double>::infinity(), 0.0};
    for (int digits = 1; digits <= static_cast<int>(kMostDigits); ++digits) {
        const Fit fit = fitOf(decades, [digits](int exponent) { return exponent - digits + 1; });
        if (isBetter(fit, best)) {
            best = fit;
            rounding.rule = Rounding::Rule::SignificantDigits;
            rounding.digits = digits;
        }
    }
    for (const Decade &candidate : decades) { // the best single place is one of theirs: a weighted median
        const Fit fit = fitOf(decades, [&candidate](int) { return candidate.place; });
        if (isBetter(fit, best)) {
            best = fit;
            rounding.rule = Rounding::Rule::Decimals;
            rounding.digits = -candidate.place;
        }
    }
    rounding.coarsestPlace = coarsestPlace(rounding);
    if (rounding.rule == Rounding::Rule::Decimals) {
        rounding.digits = std::max(rounding.digits, -rounding.coarsestPlace);
    }
    return rounding;
}

/// Of the rule as it was found without regard to this.
int RoundingObserver::coarsestPlace(const Rounding &rounding) const
{
    // As digits, so many zeros at the end would be a coincidence: one value in ten has one, one in a hundred two.
    const bool isPadded = 4 * m_zerosBehind >= m_values + 16;
    if (m_coarsestPlace >= 0 || !isPadded) {
        return m_coarsestPlace;
    }
    const bool isLong = rounding.rule == Rounding::Rule::SignificantDigits && rounding.digits > kDigitsOfAChosenNumber;
    return isLong ? std::numeric_limits<int>::max() : 0;
}

} // namespace slidercrank
