// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_numbers.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kStandardErrors = 3.0; // a true value is farther away in one case of four hundred

/// A number that stands so many standard errors from the next as round: one is within three of a value, on either side,
/// by chance in a tenth of the cases.
constexpr double kLeastSpacing = 2.0 * kStandardErrors / 0.1;

/// Of the size of the mechanism. Nothing is known better than arithmetic lets it be.
constexpr double kArithmetic = 1e-13;

/// 99.9 % point of chi-squared with five degrees of freedom: by how much the sum of the squared errors, each in units
/// of its own scatter, may grow.
constexpr double kMostGrowth = 20.5;

int powerOfTenBelow(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// The nearest multiple of 10^place. By division where the place is a decimal, so that 2.5 is the double that reads so.
double roundedTo(int place, double value)
{
    const double power = std::pow(10.0, std::abs(place));
    return (place < 0 ? std::round(value * power) / power : std::round(value / power) * power) + 0.0; // never -0
}

struct RoundNumber {
    double value;
    int digits;
};

/// In one unit.
std::optional<RoundNumber> roundNumber(double value, double standardError)
{
    if (std::abs(value) <= kStandardErrors * standardError) {
        return RoundNumber{0.0, 0};
    }
    const int highest = powerOfTenBelow(std::abs(value) + kStandardErrors * standardError) + 1;
    for (int place = highest; std::pow(10.0, place) >= kLeastSpacing * standardError; --place) {
        const double rounded = roundedTo(place, value);
        if (std::abs(rounded - value) <= kStandardErrors * standardError) {
            return RoundNumber{rounded, powerOfTenBelow(std::abs(rounded)) - place + 1};
        }
    }
    return std::nullopt;
}

/// Whether the data are as near to the rounded mechanism as to the fitted one.
bool agreesAsWell(const Mechanism &rounded, const ReferenceData &data, std::span<const ChannelComparison> identified)
{
    const std::optional<ReferenceData> timed = data.crank ? timedBy(rounded, data) : std::nullopt;
    const std::vector<ChannelComparison> channels = compareExactly(rounded, timed ? *timed : data).channels;
    double growth = 0.0;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const double natural = toFileUnit(channels[i].channel, naturalSize(rounded.parameters(), channels[i].channel));
        const double before = std::max(identified[i].rms.value_or(0.0), kArithmeticStep * natural);
        const double ratio = channels[i].rms.value_or(0.0) / before;
        growth += static_cast<double>(channels[i].count) * (ratio * ratio - 1.0);
        if (channels[i].verdict > identified[i].verdict) {
            return false;
        }
    }
    return growth <= kMostGrowth;
}

/// Whether no channel is more than a tenth farther off, rounding apart.
bool explainsAsWell(const Mechanism &rounded, const ReferenceData &data, std::span<const ChannelComparison> identified)
{
    constexpr double kFactor = 1.1;
    constexpr double kStepsOfRounding = 0.3; // root mean square of a rounding error
    const std::optional<ReferenceData> timed = data.crank ? timedBy(rounded, data) : std::nullopt;
    const std::vector<ChannelComparison> channels = compareExactly(rounded, timed ? *timed : data).channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const double before =
            std::max(identified[i].rms.value_or(0.0), kStepsOfRounding * identified[i].roundingStep.value_or(0.0));
        if (channels[i].rms.value_or(0.0) > kFactor * before) {
            return false;
        }
    }
    return true;
}

/// Each parameter as the roundest number that its standard error, so many times, leaves room for.
Parameters roundedBy(const Identification &found, double errorFactor)
{
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr double kTurnAMinute = std::numbers::pi / 30.0;
    constexpr std::array kLengthUnits{1.0};
    constexpr std::array kSpeedUnits{1.0, kDegree, kTurnAMinute};
    constexpr std::array kAngleUnits{kDegree, 1.0};

    const Parameters &fitted = found.parameters;
    const auto rounded = [&](Parameter parameter, double value, double scale, std::span<const double> units) {
        const double standardError =
            std::max(errorFactor * found.standardError[indexOf(parameter)], kArithmetic * scale);
        return standardError > 0.0 && std::isfinite(standardError) ? roundest(value, standardError, units) : value;
    };
    const double size = characteristicLength(fitted);
    Parameters parameters = fitted;
    parameters.a = rounded(Parameter::A, fitted.a, size, kLengthUnits);
    parameters.b = rounded(Parameter::B, fitted.b, size, kLengthUnits);
    parameters.c = rounded(Parameter::C, fitted.c, size, kLengthUnits);
    parameters.omega2 = rounded(Parameter::Omega2, fitted.omega2, std::abs(fitted.omega2), kSpeedUnits);
    parameters.theta20 = rounded(Parameter::Theta20, fitted.theta20, 1.0, kAngleUnits);
    return parameters;
}

} // namespace

double roundest(double value, double standardError, std::span<const double> units)
{
    double best = roundedTo(powerOfTenBelow(standardError) - 1, value);
    int fewest = std::numeric_limits<int>::max();
    for (const double unit : units) {
        const std::optional<RoundNumber> candidate = roundNumber(value / unit, standardError / unit);
        if (candidate && candidate->digits < fewest) {
            fewest = candidate->digits;
            best = candidate->value * unit;
        }
    }
    return best;
}

Parameters inRoundNumbers(const Identification &found, const ReferenceData &data,
                          std::span<const ChannelComparison> identified)
{
    if (found.outcome != Identification::Outcome::Approximate) {
        const Parameters rounded = roundedBy(found, 1.0);
        const bool isGood = !findFault(rounded) && agreesAsWell(Mechanism(rounded), data, identified);
        return isGood ? rounded : found.parameters;
    }
    for (const double errorFactor : {1000.0, 300.0, 100.0, 30.0, 10.0, 3.0, 1.0}) { // a filter moves the parameters far
        const Parameters nominal = roundedBy(found, errorFactor);
        if (!findFault(nominal) && explainsAsWell(Mechanism(nominal), data, identified)) {
            return nominal;
        }
    }
    return found.parameters;
}

} // namespace slidercrank
