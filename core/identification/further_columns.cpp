// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/further_columns.h"

#include "core/identification/column_scale.h"
#include "core/identification/geometry.h"
#include "core/identification/joint_fit.h"
#include "core/identification/residual_test.h"
#include "core/identification/speed_and_size.h"
#include "core/identification/table_speed.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

using Reason = LeftOutColumn::Reason;

/// Whether a slider-crank with proportions other than those of the fit explains the column at the same speed. (A wrong
/// unit changes the lengths, but not the proportions.) A coupler of more than a hundred cranks proves nothing, because
/// its length hardly shows.
bool isMotionOfOtherProportions(const Observations &observations, const Fit &fit, Index k)
{
    constexpr double kMinValues = 20.0; // fewer prove nothing
    // The change of b/a or c/a, relative to (b + |c|)/a. A delay of the column changes neither.
    constexpr double kMinChange = 3e-3;
    if (observations.columns[k].isConstant()) {
        return false;
    }
    const Fit fitOfColumn =
        fitModel(observations, fit.model, {k}, {Parameter::A, Parameter::B, Parameter::C, Parameter::Theta20});
    if (!fitOfColumn.isFinite() || fitOfColumn.counts[0] < kMinValues ||
        !isWithinRounding(observations, fitOfColumn, 0)) {
        return false;
    }
    const Parameters &found = fit.model.mechanism;
    const Parameters &ofColumn = fitOfColumn.model.mechanism;
    const double changeOfProportions = std::max(std::abs(ofColumn.b / ofColumn.a - found.b / found.a),
                                                std::abs(ofColumn.c / ofColumn.a - found.c / found.a));
    return !hidesLengths(found) && !hidesLengths(ofColumn) &&
           changeOfProportions > kMinChange * (found.b + std::abs(found.c)) / found.a;
}

/// The largest deviation of a column from the motion of the fitted mechanism times `factor`, in percent of the largest
/// magnitude in the column, at most 100 %. NaN if the column and the motion are zero.
double deviationInPercentOfPeak(const Observations &observations, const Fit &fit, Index k, double factor)
{
    Model model = fit.model;
    model.readings[k] = {factor, 0.0};
    const Fit fitOfColumn = evaluateModel(observations, model, {k});
    const double deviation = gapsAsZeros(fitOfColumn.residuals.col(0)).abs().maxCoeff();
    // The deviation may exceed each value, as in a column of zeros. Then it is 100 %.
    const double peak = std::max(gapsAsZeros(observations.columns[k].values).abs().maxCoeff(), deviation);
    return peak > 0.0 ? 100.0 * deviation / peak : kNone;
}

/// The result of deviationInPercentOfPeak() with the factor that suits the column best. A different speed of the crank
/// or a different unit would multiply a derivative by such a factor.
double percentOfPeakAtBestScale(const Observations &observations, const Fit &fit, Index k)
{
    return deviationInPercentOfPeak(observations, fit, k, bestFactor(observations, fit.model, k));
}

/// Largest result of percentOfPeakAtBestScale() with which a derivative counts as that of the mechanism at an unknown
/// speed.
constexpr double kMaxPercentAtOpenSpeed = 5.0;

/// Why nothing predicts column k of `result`, so that it cannot be compared with the mechanism; nullopt if the
/// mechanism predicts it.
std::optional<Reason> reasonWithoutPrediction(const FurtherColumns &result, const Observations &observations, Index k,
                                              Drive::Kind drive)
{
    const ObservedColumn &column = observations.columns[k];
    if (!column.isDerivative()) {
        return std::nullopt;
    }
    if (drive == Drive::Kind::Uneven) {
        return Reason::UnevenSpeed;
    }
    // In a table, ω2 is an unknown of the fit only if derivatives have shown it before (withSpeedAndSize()).
    const bool isSpeedKnown = drive != Drive::Kind::OverAngle || result.fit.isFree(Parameter::Omega2);
    if (isSpeedKnown) {
        return std::nullopt;
    }
    if (column.isDifference) { // this is more certain than a different speed that would explain the column
        return Reason::FiniteDifferences;
    }
    const bool suitsAnySpeed = percentOfPeakAtBestScale(observations, result.fit, k) < kMaxPercentAtOpenSpeed;
    return suitsAnySpeed ? Reason::OpenSpeed : Reason::Unknown;
}

/// Why column k is left out, which the mechanism predicts but does not explain.
Reason reasonOfMismatch(const Observations &observations, const Fit &fit, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    if (column.isDifference) {
        return Reason::FiniteDifferences;
    }
    const bool isOtherMotion = column.channel != kSliderLine && isMotionOfOtherProportions(observations, fit, k);
    return isOtherMotion ? Reason::OtherMotion : Reason::Unknown;
}

/// Adds column k to result.fit, or to result.leftOut with a reason.
void addOrLeaveOut(FurtherColumns &result, const Observations &observations, Index k, Drive::Kind drive)
{
    const ObservedColumn &column = observations.columns[k];
    const Fit &fit = result.fit;
    if (const std::optional<Reason> reason = reasonWithoutPrediction(result, observations, k, drive)) {
        const double percent = *reason == Reason::UnevenSpeed ? kNone : percentOfPeakAtBestScale(observations, fit, k);
        result.leftOut.push_back({column.channel, *reason, percent});
        return;
    }
    if (std::optional<Fit> together = addInSimplestReading(observations, fit, k)) {
        result.fit = *std::move(together);
        return;
    }
    const double percent = deviationInPercentOfPeak(observations, fit, k, usualFactor(observations, fit, k));
    result.leftOut.push_back({column.channel, reasonOfMismatch(observations, fit, k), percent});
}

} // namespace

FurtherColumns withFurtherColumns(const Observations &observations, const Fit &fit, const Drive &drive,
                                  const Parameters &given)
{
    const Fit geometry = drive.kind == Drive::Kind::OverTime ? withSpeedOfVelocities(observations, fit) : fit;
    FitWithSpeeds start = withSpeedAndSize(observations, geometry, drive.kind, given.omega2);
    FurtherColumns result{.fit = std::move(start.fit), .speeds = std::move(start.speeds)};
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (Index k = 0; k < std::ssize(observations.columns); ++k) {
            if (observations.columns[k].channel.order == order && !result.fit.usesColumn(k)) {
                addOrLeaveOut(result, observations, k, drive.kind);
            }
        }
    }
    if (drive.kind == Drive::Kind::OverAngle && !observations.containDerivatives(result.fit.columns)) {
        // No derivative was used after all, so that nothing determines the speed.
        std::erase(result.fit.unknowns, Unknown(Parameter::Omega2));
        result.fit.model.mechanism.omega2 = given.omega2;
    }
    return result;
}

} // namespace slidercrank
