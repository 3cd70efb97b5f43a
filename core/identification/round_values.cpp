// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_values.h"

#include "core/comparison/comparison.h"
#include "core/identification/rounding_test.h"

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

int placeOfFirstDigit(double magnitude)
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

/// A round value of a parameter, in a unit in which a person may have chosen it.
double roundValue(Parameter parameter, double value, double standardError, double lengthUnit)
{
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr double kTurnPerMinute = std::numbers::pi / 30.0;
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return roundLength(value, standardError, lengthUnit);
    case Parameter::Omega2: return roundest(value, standardError, std::array{1.0, kDegree, kTurnPerMinute});
    case Parameter::Theta20: break;
    }
    return roundest(value, standardError, std::array{kDegree, 1.0});
}

/// The model with other parameters at t = 0 of the file.
Model withParameters(Model model, const Parameters &parameters, const Observations &observations)
{
    const double angleInFile = model.mechanism.theta20;
    const double speed = model.mechanism.omega2;
    model.mechanism = parameters;
    model.mechanism.theta20 =
        model.followsAngle ? angleInFile : parameters.theta20 + parameters.omega2 * observations.timeOrigin;
    model.mechanism.omega2 = model.alpha2 == 0.0 ? parameters.omega2 : speed;
    return model;
}

/// Whether a model explains the file as well as the fit from which it was rounded: its misfit is hardly higher, and it
/// agrees with the same columns.
bool isAsGood(const Observations &observations, const Fit &rounded, const Fit &fit)
{
    constexpr double kEquallyGood = 0.5 * kSameMisfit; // about what the errors of five parameters explain
    const auto agrees = [&](const Fit &some, Index k) {
        const Values errors = finite(some.residuals.col(k)).abs();
        const auto beyond = static_cast<double>((errors > roundingBounds(observations, some, k)).count());
        return 100.0 * (some.counts[k] - beyond) >= static_cast<double>(kPercentWithinBound) * some.counts[k];
    };
    bool isGood = rounded.misfit - fit.misfit < kEquallyGood;
    for (Index k = 0; isGood && k < fit.residuals.cols(); ++k) {
        isGood = agrees(rounded, k) || !agrees(fit, k);
    }
    return isGood;
}

} // namespace

double roundest(double value, double standardError, std::span<const double> units)
{
    // Standard errors between neighbouring numbers of the same roundness. Those within the tolerance of three on either
    // side are a tenth of them: the probability that one of these numbers is there by chance.
    constexpr double kSpacing = 2.0 * kStandardErrors / 0.1;
    const double tolerance = kStandardErrors * standardError;
    if (!(standardError > 0.0) || std::isinf(standardError)) {
        return value;
    }
    if (std::abs(value) <= tolerance) {
        return 0.0;
    }
    std::optional<double> best;
    int fewestDigits = INT_MAX;
    for (const double unit : units) {
        const int highest = placeOfFirstDigit((std::abs(value) + tolerance) / unit) + 1;
        for (int place = highest; std::pow(10.0, place) * unit >= kSpacing * standardError; --place) {
            const double rounded = roundedTo(place, value / unit);
            if (std::abs(rounded * unit - value) <= tolerance) {
                const int digits = placeOfFirstDigit(std::abs(rounded)) - place + 1;
                best = digits < fewestDigits ? rounded * unit : best;
                fewestDigits = std::min(digits, fewestDigits);
                break;
            }
        }
    }
    const int place = placeOfFirstDigit(standardError / units.front()) - 1;
    return best.value_or(roundedTo(place, value / units.front()) * units.front());
}

double roundLength(double value, double standardError, double unit)
{
    constexpr int kDigits = 15;                    // 6 in are 152.4 mm, and not 152.39999999999998 mm
    if (std::fmod(std::log10(unit), 1.0) == 0.0) { // a round number of metres is one of millimetres, too
        return roundest(value, standardError, std::array{1.0});
    }
    const double rounded = roundest(value, standardError, std::array{unit});
    return rounded == 0.0 ? 0.0 : roundedTo(placeOfFirstDigit(std::abs(rounded)) + 1 - kDigits, rounded);
}

Parameters roundedParameters(const LastFit &lastFit, const Parameters &exact, double lengthUnit)
{
    constexpr double kArithmetic = 1e-13; // relative accuracy of the computation
    // Fractions of the standard errors, tried in this order. Parameters that depend on each other may each change by
    // their standard errors only together, so that more of their digits are needed.
    constexpr std::array kFractions{1.0, 0.1, 0.01};
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    for (const double part : kFractions) {
        Parameters rounded = exact;
        for (const Parameter parameter : kAllParameters) {
            const double size = parameter == Parameter::Theta20  ? 1.0
                                : parameter == Parameter::Omega2 ? std::abs(exact.omega2)
                                                                 : characteristicLength(exact);
            const double standardError = lastFit.standardError[indexOf(parameter)];
            const double error = std::max(part * standardError, kArithmetic * size);
            if (std::isfinite(standardError)) {
                valueOf(rounded, parameter) = roundValue(parameter, valueOf(exact, parameter), error, lengthUnit);
            }
        }
        const Model model = withParameters(fit.model, rounded, observations);
        if (!findFault(rounded) && isAsGood(observations, evaluated(observations, model, fit.columns), fit)) {
            return rounded;
        }
    }
    return exact;
}

} // namespace slidercrank
