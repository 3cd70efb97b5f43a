// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_numbers.h"

#include "core/identification/findings.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kStandardErrors = 3.0; // the true value is farther away in one of 400 cases

/// Smallest distance of equally round numbers, in standard errors: one of them is then within three standard errors of
/// a value by chance with a probability of 10 %.
constexpr double kLeastSpacing = 2.0 * kStandardErrors / 0.1;

/// Smallest standard error, relative to the size of the parameter: the accuracy of the computation.
constexpr double kArithmetic = 1e-13;

int powerOfTenBelow(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// The nearest multiple of 10^place. Divides if the place is negative, so that the result is the double nearest to the
/// decimal number.
double roundedTo(int place, double value)
{
    const double power = std::pow(10.0, std::abs(place));
    return (place < 0 ? std::round(value * power) / power : std::round(value / power) * power) + 0.0; // never -0
}

/// The roundest number within three standard errors of a value, in any of some units; nullopt if none is round enough.
std::optional<double> roundNumber(std::span<const double> units, double value, double standardError)
{
    std::optional<double> best;
    int fewest = INT_MAX; // digits
    const double tolerance = kStandardErrors * standardError;
    if (std::abs(value) <= tolerance) {
        return 0.0;
    }
    for (const double unit : units) {
        const int highest = powerOfTenBelow((std::abs(value) + tolerance) / unit) + 1;
        for (int place = highest; std::pow(10.0, place) * unit >= kLeastSpacing * standardError; --place) {
            const double rounded = roundedTo(place, value / unit);
            if (std::abs(rounded * unit - value) <= tolerance) {
                const int digits = powerOfTenBelow(std::abs(rounded)) - place + 1;
                best = digits < fewest ? rounded * unit : best;
                fewest = std::min(digits, fewest);
                break;
            }
        }
    }
    return best;
}

/// The largest deviation, relative to the range of its column.
double largestPart(const Parameters &parameters, const ReferenceData &data)
{
    double largest = 0.0;
    const std::vector<ChannelComparison> channels = compareTimed(parameters, data);
    for (std::size_t j = 0; j < channels.size(); ++j) {
        const ChannelComparison &channel = channels[j];
        const double range =
            isConstantByNature(channel.channel) ? channel.peak : rangeOf(data.series[j].values).width();
        largest = channel.missingModel > 0 ? kInfinity : std::max(largest, channel.maxAbs.value_or(0.0) / range);
    }
    return largest;
}

/// Whether no column deviates clearly more from the rounded mechanism than from the fitted one.
bool explainsAsWell(const Parameters &rounded, const ReferenceData &data, std::span<const ChannelComparison> fitted)
{
    constexpr double kEqually = 1.05; // of the rms deviation
    constexpr double kGrowth = 9.0;   // of chi-square, if the deviation is noise: three standard deviations
    return std::ranges::equal(compareTimed(rounded, data), fitted, [&](const auto &after, const auto &before) {
        const double natural = toFileUnit(after.channel, naturalSize(rounded, after.channel));
        const double equally = before.rms > before.roundingStep
                                   ? std::min(kEqually, std::sqrt(1.0 + kGrowth / static_cast<double>(before.count)))
                                   : kEqually;
        return after.verdict <= before.verdict &&
               after.rms.value_or(0.0) <= equally * before.rms.value_or(0.0) + kArithmeticStep * natural;
    });
}

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTurnAMinute = std::numbers::pi / 30.0;
constexpr std::array kSpeedUnits{1.0, kDegree, kTurnAMinute};
constexpr std::array kAngleUnits{kDegree, 1.0};

std::span<const double> unitsOf(Parameter parameter)
{
    return parameter == Parameter::Theta20  ? std::span<const double>(kAngleUnits)
           : parameter == Parameter::Omega2 ? std::span<const double>(kSpeedUnits)
                                            : std::span<const double>(kPlainUnit);
}

/// The standard error of a parameter, at least the accuracy of the computation; NaN if unknown.
double errorOf(const Identification &found, Parameter parameter)
{
    const double size = parameter == Parameter::Theta20  ? 1.0
                        : parameter == Parameter::Omega2 ? std::abs(found.parameters.omega2)
                                                         : characteristicLength(found.parameters);
    const double error = found.standardError[indexOf(parameter)];
    return std::isfinite(error) && std::max(error, size) > 0.0 ? std::max(error, kArithmetic * size) : kNone;
}

} // namespace

double roundest(double value, double standardError, std::span<const double> units)
{
    if (!(standardError > 0.0) || std::isinf(standardError)) {
        return value;
    }
    return roundNumber(units, value, standardError).value_or(roundedTo(powerOfTenBelow(standardError) - 1, value));
}

Parameters inRoundNumbers(const Identification &found, const ReferenceData &data)
{
    const ReferenceData some = thinned(data);
    const std::vector<ChannelComparison> fitted = compareTimed(found.parameters, some);
    // The systematic errors of an approximate mechanism may be larger than its standard errors.
    const bool isApproximate = found.outcome == Identification::Outcome::Approximate;
    const double most = 1.1 * largestPart(found.parameters, some);
    for (double errorFactor = isApproximate ? 27.0 : 1.0; errorFactor >= 1.0; errorFactor /= 3.0) {
        Parameters rounded = found.parameters;
        for (const Parameter parameter : kAllParameters) {
            double &value = valueOf(rounded, parameter);
            value = roundest(value, errorFactor * errorOf(found, parameter), unitsOf(parameter));
        }
        if (!findFault(rounded) &&
            (isApproximate ? largestPart(rounded, some) <= most : explainsAsWell(rounded, some, fitted))) {
            return rounded;
        }
    }
    return found.parameters;
}

} // namespace slidercrank
