// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/rounding.h"

#include "core/import/cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

/// 10^exponent, the nearest double on every system, which std::pow() is not; 0 or infinity beyond what a double holds.
double powerOfTen(int exponent)
{
    std::array<char, 16> text{'1', 'e'};
    double power = exponent > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    std::from_chars(text.data(), std::to_chars(text.data() + 2, text.data() + text.size(), exponent).ptr, power);
    return power;
}

/// A unit's conversion there and back may leave 9.99…9 of a printed 10: this part of a value decides no decade.
constexpr double kConversionSlack = 1e-12;

/// Power of ten of the first digit of a positive number.
int decadeOf(double magnitude)
{
    const double nudged = magnitude * (1.0 + kConversionSlack);
    const int decade = static_cast<int>(std::floor(std::log10(nudged))); // or one beside it
    return nudged >= powerOfTen(decade + 1) ? decade + 1 : nudged < powerOfTen(decade) ? decade - 1 : decade;
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
struct RoundedDecade {
    int exponent;
    int place;
    double weight;
};

/// The distance from the places of the decades, weighted; among equal ones the coarser promise, negative, is better.
using Fit = std::pair<double, double>;

/// First and last digit of the shortest text that reads as `value`, which is printed at `places`.
PrintedPlaces shortestPlaces(PrintedPlaces places, double value)
{
    std::array<char, 32> text{};
    const auto shortest = std::to_chars(text.data(), text.data() + text.size(), value);
    const PrintedPlaces found = parseNumber({text.data(), shortest.ptr}, DecimalSign::Point).places;
    return {found.zero, found.first, found.last, places.printed};
}

template <typename PlaceOf>
Fit fitOf(const std::vector<RoundedDecade> &decades, PlaceOf placeOf)
{
    Fit fit{0.0, 0.0};
    for (const RoundedDecade &decade : decades) {
        const int place = placeOf(decade.exponent);
        fit.first += decade.weight * std::abs(decade.place - place);
        fit.second -= decade.weight * place;
    }
    return fit;
}

} // namespace

double Rounding::stepAt(double value) const
{
    switch (rule) {
    case Rule::Unknown: return 0.0;
    case Rule::Decimals: return unitFactor * powerOfTen(-digits);
    case Rule::Multiples: return unitFactor * quantum;
    case Rule::SignificantDigits: {
        const double printed = std::abs(value) / unitFactor;
        const int exponent = printed > 0.0 && std::isfinite(printed) ? decadeOf(printed) : smallestExponent;
        const int place = std::min(exponent - digits + 1, coarsestPlace);
        return unitFactor * powerOfTen(std::max(place, finestPlace));
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
    return rule == Rule::Unknown ? 0.0 : unitFactor * powerOfTen(finestPlace);
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
        const int decade = decadeOf(printed);
        m_from = m_rounding.unitFactor * powerOfTen(decade) * (1.0 + 4.0 * kConversionSlack);
        m_to = m_rounding.unitFactor * powerOfTen(decade + 1) * (1.0 - 4.0 * kConversionSlack);
        m_step = step;
    }
    return step;
}

void RoundingObserver::observe(PrintedPlaces places, double value)
{
    constexpr int kDigitsOfADouble = 16;
    constexpr int kLargestExponent = 48; // decades beyond teach nothing
    if (!places.zero && places.first - places.last + 1 >= kDigitsOfADouble) {
        // To find the shortest text takes as long as to read the number: of very many, some tell enough.
        constexpr std::uint32_t kEnough = 256;
        constexpr std::uint32_t kEvery = 16;
        if (m_long++ >= kEnough && m_long % kEvery != 0) {
            return;
        }
        places = shortestPlaces(places, value);
    }
    m_finestPlace = std::min(m_finestPlace, places.printed);
    if (places.zero) {
        return;
    }
    const double magnitude = std::abs(value);
    if (m_values == 0) {
        m_firstPlaces = places;
        m_firstMagnitude = magnitude;
    }
    m_varies = m_varies || magnitude != m_firstMagnitude;
    ++m_values;
    m_zerosBehind += static_cast<std::uint64_t>(std::max(std::min(places.last, 0) - places.printed, 0));
    m_coarsestPlace = std::max(m_coarsestPlace, places.printed);
    m_smallestExponent = std::min(m_smallestExponent, places.first);
    if (std::abs(places.first) > kLargestExponent) {
        return;
    }
    if (m_latest >= m_decades.size() || m_decades[m_latest].exponent != places.first) {
        const auto found = std::ranges::find(m_decades, places.first, &Decade::exponent);
        m_latest = static_cast<std::size_t>(found - m_decades.begin());
        if (found == m_decades.end()) {
            m_decades.push_back({places.first});
        }
    }
    const auto length = static_cast<std::size_t>(places.first - places.last);
    ++m_decades[m_latest].counts[std::min(length, kMostDigits - 1)];
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
    if (m_values == 0) {
        return rounding;
    }
    rounding.smallestExponent = m_smallestExponent;
    rounding.finestPlace = m_finestPlace;
    if (!m_varies) {
        rounding.rule = Rounding::Rule::Decimals;
        rounding.digits = -placeOfOneValue(shortestPlaces(m_firstPlaces, m_firstMagnitude));
        return rounding;
    }

    std::vector<RoundedDecade> decades;
    for (const Decade &decade : m_decades) {
        const double total = std::accumulate(decade.counts.begin(), decade.counts.end(), 0.0);
        double reached = 0.0;
        for (std::size_t length = 0; length < kMostDigits; ++length) {
            reached += decade.counts[length];
            if (reached == total || hasEnded(reached, total)) {
                decades.push_back({decade.exponent, decade.exponent - static_cast<int>(length), total});
                break;
            }
        }
    }
    std::ranges::sort(decades, {}, &RoundedDecade::exponent);
    if (decades.empty()) {
        return rounding;
    }

    Fit best{std::numeric_limits<double>::infinity(), 0.0};
    for (int digits = 1; digits <= static_cast<int>(kMostDigits); ++digits) {
        const Fit fit = fitOf(decades, [digits](int exponent) { return exponent - digits + 1; });
        if (fit < best) {
            best = fit;
            rounding.rule = Rounding::Rule::SignificantDigits;
            rounding.digits = digits;
        }
    }
    for (const RoundedDecade &candidate : decades) { // the best single place is one of theirs: a weighted median
        const Fit fit = fitOf(decades, [&candidate](int) { return candidate.place; });
        if (fit < best) {
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

std::optional<double> findQuantum(std::span<const double> values, double printedStep)
{
    constexpr std::size_t kFewestValues = 12; // distinct ones
    constexpr double kCoarser = 8.0;          // than what is printed
    constexpr double kOfItself = 1e-9;        // of the value: what computing leaves
    constexpr double kPowerOfTen = 1e-3;      // of the exponent: decimals
    std::vector<double> levels;
    std::vector<double> differences; // of neighbours
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i])) {
            levels.push_back(values[i]);
        }
        if (i > 0 && std::isfinite(values[i] - values[i - 1])) {
            differences.push_back(std::abs(values[i] - values[i - 1]));
        }
    }
    std::ranges::sort(levels);
    std::ranges::sort(differences);
    if (levels.empty()) {
        return std::nullopt;
    }
    const double noise = 2.0 * printedStep + kOfItself * std::max(std::abs(levels.front()), std::abs(levels.back()));
    double quantum = std::numeric_limits<double>::infinity();
    std::size_t distinct = 1;
    std::size_t teeth = 1;
    const auto takeGaps = [&](const std::vector<double> &sorted, std::size_t &count) {
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            if (const double gap = sorted[i] - sorted[i - 1]; gap > 2.0 * noise) {
                quantum = std::min(quantum, gap);
                ++count;
            }
        }
    };
    takeGaps(levels, distinct);
    takeGaps(differences, teeth);
    if (distinct < kFewestValues || teeth < 2 || !(quantum >= kCoarser * noise)) {
        return std::nullopt;
    }
    double seen = 1.0; // steps of the longest distance that has refined the quantum
    for (const double level : levels) {
        const double distance = level - levels.front();
        const double steps = std::round(distance / quantum);
        const double uncertainty = noise * (1.0 + steps / seen);
        if (uncertainty > 0.5 * quantum || std::abs(distance - steps * quantum) > uncertainty) {
            return std::nullopt;
        }
        if (steps > seen) {
            quantum = distance / steps;
            seen = steps;
        }
    }
    const bool fits = std::ranges::all_of(levels, [&](double level) {
        const double distance = level - levels.front();
        return std::abs(distance - std::round(distance / quantum) * quantum) <= noise;
    });
    const double power = std::log10(quantum);
    return fits && std::abs(power - std::round(power)) > kPowerOfTen ? std::optional(quantum) : std::nullopt;
}

} // namespace slidercrank
