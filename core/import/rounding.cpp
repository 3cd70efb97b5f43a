// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/rounding.h"

#include "core/import/cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

namespace slidercrank
{

/// The place at which the values of a decade were rounded.
struct RoundedDecade {
    int exponent;
    int place;
    double weight;     ///< number of values
    bool haveAllEnded; ///< no value has digits behind that place
};

namespace
{

/// Returns the exponent of the power of ten of the first digit of a positive number. A unit conversion and its inverse
/// may turn a printed 10 into 9.99…9, which still counts as 10.
int decadeOf(double magnitude)
{
    constexpr double kConversionSlack = 1e-12;
    return static_cast<int>(std::floor(std::log10(magnitude * (1.0 + kConversionSlack))));
}

/// Largest number of digits of a value that a person may have chosen (25, 360, 12.75). Such a value does not show how
/// the program rounds.
constexpr int kMaxDigitsOfChosenNumber = 4;

/// Returns the place at which the only number of a column was rounded: its last printed digit, such as the hundreds of
/// 3.07587e+07. Behind the point, zeros at the end count only among the first kMaxDigitsOfChosenNumber digits: 12.00
/// was rounded to hundredths, but 123456.0 to a whole number.
int placeOfOneValue(const PrintedPlaces &places)
{
    if (places.lastPrinted >= 0) {
        return std::min(places.lastNonZero, places.lastPrinted);
    }
    const int lastCountedZero = std::max(places.firstNonZero - kMaxDigitsOfChosenNumber + 1, places.lastPrinted);
    return std::min({places.lastNonZero, 0, lastCountedZero});
}

/// How far the places of all decades are from those of a rule. The members are sums over all values, and are compared
/// in order: of two rules at the same distance, the coarser one is less.
struct RuleDistance {
    double distance = 0.0;       ///< in places
    double minusRulePlace = 0.0; ///< the place of the rule, negated

    auto operator<=>(const RuleDistance &) const = default;
};

/// Returns the distance of all decades from the rule of that kind that has the place of the decade `reference`.
RuleDistance distanceFromRule(Rounding::Rule rule, const RoundedDecade &reference,
                              const std::vector<RoundedDecade> &decades)
{
    RuleDistance sum;
    for (const RoundedDecade &decade : decades) {
        const bool isRelative = rule == Rounding::Rule::SignificantDigits;
        const int place = reference.place + (isRelative ? decade.exponent - reference.exponent : 0);
        sum.distance += decade.weight * std::abs(decade.place - place);
        sum.minusRulePlace -= decade.weight * place;
    }
    return sum;
}

/// Returns `rounding` with the rule and number of digits that are closest to the places of all decades, weighted by
/// their numbers of values. The best place, a weighted median, is that of one of the decades.
Rounding withClosestRule(Rounding rounding, const std::vector<RoundedDecade> &decades)
{
    RuleDistance least{kInfinity};
    for (const Rounding::Rule rule : {Rounding::Rule::SignificantDigits, Rounding::Rule::Decimals}) {
        for (const RoundedDecade &reference : decades) {
            if (const RuleDistance distance = distanceFromRule(rule, reference, decades); distance < least) {
                least = distance;
                rounding.rule = rule;
                rounding.digits = rule == Rounding::Rule::SignificantDigits ? reference.exponent - reference.place + 1
                                                                            : -reference.place;
            }
        }
    }
    return rounding;
}

/// Returns `places` with the places of the non-zero digits of the shortest text that is read as `value`.
PrintedPlaces withShortestPlaces(PrintedPlaces places, double value)
{
    std::array<char, 32> text{};
    const auto shortest = std::to_chars(text.data(), text.data() + text.size(), value);
    const PrintedPlaces found = parseNumber({text.data(), shortest.ptr}, DecimalSign::Point).places;
    return {.isZero = found.isZero,
            .firstNonZero = found.firstNonZero,
            .lastNonZero = found.lastNonZero,
            .lastPrinted = places.lastPrinted};
}

/// Returns the places of a number with 16 or more digits as if it were printed as the shortest text of the same double,
/// and with 16 digits at most: the last digits are those of the binary number. Returns other places unchanged.
PrintedPlaces withoutBinaryDigits(const PrintedPlaces &printed, double value)
{
    constexpr int kMinDigitsOfDouble = 16; // of a number that a program printed in full
    if (printed.firstNonZero - printed.lastNonZero + 1 < kMinDigitsOfDouble) {
        return printed;
    }
    PrintedPlaces places = withShortestPlaces(printed, value);
    const int finest = places.firstNonZero - kMinDigitsOfDouble + 1;
    places.lastNonZero = std::max(places.lastNonZero, finest);
    places.lastPrinted = std::max(places.lastPrinted, finest);
    return places;
}

/// Returns a more precise step for sorted values whose distances are multiples of `step`: a distance of n steps,
/// divided by n, has 1/n of its error. Distances are used in increasing order, so that the step, refined so far, leaves
/// no doubt about n.
double refinedStep(double step, const std::vector<double> &values)
{
    double mostSteps = 1.0; // number of steps in the longest distance used so far
    for (const double value : values) {
        const double distance = value - values.front();
        if (const double steps = std::round(distance / step); steps > mostSteps) {
            step = distance / steps;
            mostSteps = steps;
        }
    }
    return step;
}

std::vector<double> sortedFinite(std::span<const double> values)
{
    std::vector<double> sorted;
    std::ranges::copy_if(values, std::back_inserter(sorted), [](double value) { return std::isfinite(value); });
    std::ranges::sort(sorted);
    return sorted;
}

/// The distances between neighbouring sorted values that are larger than an uncertainty.
struct Gaps {
    double smallest = kInfinity;    ///< smallest of these distances
    std::size_t distinctValues = 1; ///< number of values, of which those closer together count as one
};

Gaps gapsBetween(const std::vector<double> &sorted, double uncertainty)
{
    Gaps gaps;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (const double gap = sorted[i] - sorted[i - 1]; gap > uncertainty) {
            gaps.smallest = std::min(gaps.smallest, gap);
            ++gaps.distinctValues;
        }
    }
    return gaps;
}

} // namespace

double powerOfTen(int exponent)
{
    const double power = std::pow(10.0, std::abs(exponent)); // exact as far as a double is
    return exponent < 0 ? 1.0 / power : power;
}

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

void RoundingObserver::observe(const PrintedPlaces &printed, double value)
{
    m_finestPlace = std::min(m_finestPlace, printed.lastPrinted); // as printed, also beyond the 16th digit
    if (printed.isZero) {
        return;
    }
    const PrintedPlaces places = withoutBinaryDigits(printed, value);
    const double magnitude = std::abs(value);
    if (m_values > 0 && magnitude == m_lastMagnitude) { // a standstill says nothing new
        return;
    }
    m_lastPlaces = places;
    m_lastMagnitude = magnitude;
    ++m_values;
    const int trailingZeros = std::max(std::min(places.lastNonZero, 0) - places.lastPrinted, 0);
    m_trailingZeros += static_cast<std::uint64_t>(trailingZeros);
    m_paddedValues += trailingZeros > 0 ? 1 : 0;
    m_coarsestPlace = std::max(m_coarsestPlace, places.lastPrinted);
    m_smallestExponent = std::min(m_smallestExponent, places.firstNonZero);
    if (std::abs(places.firstNonZero) > kLargestExponent) {
        return;
    }
    const auto length = static_cast<std::size_t>(places.firstNonZero - places.lastNonZero);
    ++m_decades[static_cast<std::size_t>(places.firstNonZero + kLargestExponent)][std::min(length, kMaxDigits - 1)];
}

bool RoundingObserver::isPadded() const
{
    // By chance, one value in ten ends with one zero, and one in a hundred with two: a ninth of a zero on average.
    // These are clearly more: a quarter of a zero per value, plus four zeros for short columns.
    constexpr std::uint64_t kValuesPerZero = 4;
    constexpr std::uint64_t kSpareZeros = 4;
    const bool areManyZeros = kValuesPerZero * m_trailingZeros >= m_values + kValuesPerZero * kSpareZeros;
    const bool havePaddedValuesMajority = 2 * m_paddedValues >= m_values;
    return areManyZeros && havePaddedValuesMajority;
}

std::vector<RoundedDecade> RoundingObserver::roundedDecades(Content content) const
{
    // Without padding, a program prints all values with the same number of digits, so that nine of ten end there.
    const bool haveEqualDigits = content == Content::TimeStamps || !isPadded();
    // A value ends at its last digit other than 0. A decade is rounded at the first place by which this number of its
    // values has ended: nine of ten or, with padding, clearly more than a quarter.
    constexpr double kEndedFraction = 0.9;
    constexpr double kEndedFractionOfPadded = 0.25;
    constexpr double kSpareValuesOfPadded = 2.0;
    std::vector<RoundedDecade> decades;
    for (int exponent = -kLargestExponent; exponent <= kLargestExponent; ++exponent) {
        const auto &counts = m_decades[static_cast<std::size_t>(exponent + kLargestExponent)];
        const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
        const double needed = haveEqualDigits ? kEndedFraction * total
                                              : std::min(total, kEndedFractionOfPadded * total + kSpareValuesOfPadded);
        double ended = 0.0;
        int place = exponent + 1;
        for (std::size_t i = 0; i < kMaxDigits && ended < needed; ++i) {
            ended += counts[i];
            --place;
        }
        if (total > 0.0) {
            decades.push_back({exponent, place, total, ended == total});
        }
    }
    return decades;
}

int RoundingObserver::coarsestPlaceOf(const Rounding &rounding, const RoundedDecade &largest, Content content) const
{
    constexpr double kMinRoundedValues = 6.0; // of a decade: fewer may all end before the last printed digit by chance
    constexpr int kMinDigitsByHand = 3;       // fewer may be chosen numbers: 5, 10, 20
    const bool isRelative = rounding.rule == Rounding::Rule::SignificantDigits;
    int coarsest = m_coarsestPlace;
    if (isPadded() && m_coarsestPlace < 0) { // the last printed digits say nothing
        const bool isLong = isRelative && rounding.digits > kMaxDigitsOfChosenNumber;
        coarsest = isLong ? INT_MAX : 0;
    }
    // A person rounds -2123 to -2120 if three digits are enough, also beside 853.
    const bool isByHand = isRelative && rounding.digits >= kMinDigitsByHand && content == Content::Quantity;
    const bool endsEarly = largest.haveAllEnded && largest.weight >= kMinRoundedValues;
    return isByHand && endsEarly ? std::max(coarsest, largest.place) : coarsest;
}

Rounding RoundingObserver::infer(double unitFactor, Content content) const
{
    Rounding rounding;
    rounding.unitFactor = unitFactor;
    if (m_values == 0) {
        return rounding;
    }
    rounding.smallestExponent = m_smallestExponent;
    rounding.finestPlace = m_finestPlace;
    if (m_values == 1) {
        rounding.rule = Rounding::Rule::Decimals;
        rounding.digits = -placeOfOneValue(withShortestPlaces(m_lastPlaces, m_lastMagnitude));
        return rounding;
    }
    const std::vector<RoundedDecade> decades = roundedDecades(content);
    rounding = withClosestRule(rounding, decades);
    rounding.coarsestPlace = coarsestPlaceOf(rounding, decades.back(), content);
    if (rounding.rule == Rounding::Rule::Decimals) {
        rounding.digits = std::max(rounding.digits, -rounding.coarsestPlace);
    }
    return rounding;
}

std::optional<double> findQuantum(std::span<const double> values, double printedStep)
{
    constexpr std::size_t kMinValues = 12;        // distinct ones
    constexpr double kMinQuantum = 8.0;           // in units of the uncertainty
    constexpr double kArithmeticError = 1e-9;     // relative to the value
    constexpr double kPowerOfTenTolerance = 1e-3; // of the exponent
    std::vector<double> changes;                  // between neighbours
    for (std::size_t i = 1; i < values.size(); ++i) {
        changes.push_back(std::abs(values[i] - values[i - 1]));
    }
    const std::vector<double> levels = sortedFinite(values);
    const std::vector<double> differences = sortedFinite(changes);
    if (levels.empty()) {
        return std::nullopt;
    }
    const double uncertainty = // of a difference of two changes: four values, each off by half a step
        2.0 * printedStep + kArithmeticError * std::max(std::abs(levels.front()), std::abs(levels.back()));
    const Gaps gaps = gapsBetween(levels, 2.0 * uncertainty);
    const Gaps gapsOfDifferences = gapsBetween(differences, 2.0 * uncertainty);
    const double smallestGap = std::min(gaps.smallest, gapsOfDifferences.smallest);
    if (gaps.distinctValues < kMinValues || gapsOfDifferences.distinctValues < 2 ||
        !(smallestGap >= kMinQuantum * uncertainty)) {
        return std::nullopt;
    }
    const double quantum = refinedStep(smallestGap, levels);
    const bool fits = std::ranges::all_of(levels, [&](double level) {
        const double distance = level - levels.front();
        return std::abs(distance - std::round(distance / quantum) * quantum) <= uncertainty;
    });
    const double power = std::log10(quantum);
    return fits && std::abs(power - std::round(power)) > kPowerOfTenTolerance ? std::optional(quantum) : std::nullopt;
}

std::optional<double> findStepOfFive(std::span<const double> values, const Rounding &rounding)
{
    constexpr std::size_t kMinValues = 6;      // distinct ones; of fewer, all may be multiples of 5 by chance
    constexpr double kArithmeticError = 1e-13; // of a unit conversion, relative to the largest value
    constexpr double kMaxEvenFraction = 0.7;   // of multiples of 5 that are multiples of 10: with more, the step is 10
    constexpr double kMaxErrorOfStep = 0.1;    // relative to a step: with more, every value is a multiple of it
    std::vector<double> magnitudes(values.begin(), values.end());
    std::ranges::for_each(magnitudes, [&](double &value) { value = std::abs(value) / rounding.unitFactor; });
    std::vector<double> levels = sortedFinite(magnitudes);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    if (levels.size() < kMinValues || rounding.finestPlace == INT_MIN) {
        return std::nullopt;
    }
    const double tolerance = kArithmeticError * levels.back();
    const auto isMultipleOf = [tolerance](double level, double step) {
        return std::abs(level - step * std::round(level / step)) <= tolerance;
    };
    const auto areMultiplesOf = [&](double step) {
        return std::ranges::all_of(levels, [&](double level) { return isMultipleOf(level, step); });
    };
    // The largest power of ten of which all values are multiples is 10^place. The step is 5 times that power.
    const int coarserThanErrors = static_cast<int>(std::ceil(std::log10(tolerance / kMaxErrorOfStep)));
    int place = std::max(rounding.finestPlace, coarserThanErrors);
    while (areMultiplesOf(powerOfTen(place + 1)) && powerOfTen(place + 1) < levels.back()) {
        ++place;
    }
    const double step = 5.0 * powerOfTen(place);
    const auto even =
        std::ranges::count_if(levels, [&](double level) { return isMultipleOf(level, powerOfTen(place + 1)); });
    const bool areSteps = static_cast<double>(even) <= kMaxEvenFraction * static_cast<double>(levels.size());
    return areSteps && areMultiplesOf(step) ? std::optional(step * rounding.unitFactor) : std::nullopt;
}

} // namespace slidercrank
