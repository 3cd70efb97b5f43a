// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/abscissa.h"

#include "core/identification/noise.h"
#include "core/identification/residual_test.h"
#include "core/identification/speed_and_size.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// Appends the angle of the crank in the file to the columns.
void appendAngle(Observations &observations)
{
    ObservedColumn angle{.channel = kCrankAngle,
                         .values = observations.angle.values,
                         .range = observations.angle.values.maxCoeff() - observations.angle.values.minCoeff()};
    angle.setHalfSteps(Values::Constant(observations.size(), observations.angle.halfStep));
    observations.columns.push_back(std::move(angle));
}

/// Changes a model that follows the angle in the file to one that turns with the constant speed of a drive. That angle,
/// which appendAngle() has made the last column of the observations, is appended to the columns of the fit; θ20, ω2 and
/// the origin of the angle become free.
void followTime(const Observations &observations, Fit &fit, const Drive &drive)
{
    fit.model = modelAtSpeed(observations, fit, drive.omega2);
    Model &model = fit.model;
    model.readings.push_back({1.0 / model.angleFactor, -model.mechanism.theta20 / model.angleFactor});
    model.followsAngle = false;
    model.mechanism.theta20 = drive.theta20;
    const Index column = std::ssize(model.readings) - 1;
    fit.columns.push_back(column);
    fit.unknowns = fit.unknownsWith({Parameter::Theta20, Parameter::Omega2, originOf(column)});
}

/// Makes the angle of the crank in the file a column of the observations, because a constant speed predicts it, and
/// fits it together with the columns of the fit over the time.
ObservedFit withAngleAsColumn(ObservedFit observed, const Drive &drive)
{
    appendAngle(observed.wholeFile);
    observed.searched = selectRows(withoutSpikes(observed.wholeFile), kSearchedRows); // with the new column
    Fit &fit = observed.fit;
    followTime(observed.searched, fit, drive);
    fit = fitModel(observed.searched, fit.model, fit.columns, fit.unknowns);
    return observed;
}

/// Whether the angle in the file explains the columns better than a constant speed does. (Errors of the angle would
/// make the fit over the angle the worse one.) `overTime` is a fit of the columns of `overAngle` and of the angle.
bool isAngleBetter(const Fit &overAngle, const ObservedFit &overTime)
{
    const auto isInterpolated = [&](Index k) { return overTime.searched.columns[k].isInterpolated; };
    if (std::ranges::any_of(overAngle.columns, isInterpolated)) {
        return false; // the angle was interpolated or held like these columns, so that they suit it, but not the time
    }
    const Fit byAngle = evaluateModel(overTime.searched, overAngle.model, overAngle.columns);
    const Fit byTime = evaluateModel(overTime.searched, overTime.fit.model, overAngle.columns);
    return !explainsAsWell(overTime.searched, byTime, byAngle);
}

/// Whether observe() has replaced the time stamps or angles that a model follows by those of an even grid, so that the
/// printed ones are an alternative.
bool wasAbscissaMadeEven(const Observations &observations, const Model &model)
{
    return (model.followsAngle ? observations.angle : observations.time).printed.size() > 0;
}

/// The observations with the abscissa of a model as it was printed. Its values are not moved within their rounding any
/// more, but the bounds of rounding still allow for half a step of it.
Observations withPrintedAbscissa(Observations observations, const Model &model)
{
    Abscissa &abscissa = model.followsAngle ? observations.angle : observations.time;
    abscissa.values = abscissa.printed;
    abscissa.startMargin = 0.0;
    abscissa.durationMargin = 0.0;
    return observations;
}

/// Fits the start and the spacing of evenly spaced angles together with the unknowns of a fit of positions: the angle
/// in the file takes the place of the time, so that θ2 = ω2 · angle + θ20.
Fit fitOverFreeAngles(Observations observations, const Fit &fit)
{
    observations.time = std::exchange(observations.angle, {});
    Model start = fit.model;
    start.followsAngle = false;
    start.mechanism.omega2 = fit.model.angleFactor;
    return fitModel(observations, std::move(start), fit.columns,
                    fit.unknownsWith({Parameter::Theta20, Parameter::Omega2}));
}

/// A table over the crank angle with exact angles, which are those in the file times `stretch` plus `shift` (rad).
Observations withMovedAngles(Observations observations, double stretch, double shift)
{
    observations.angle.values = stretch * observations.angle.values + shift;
    observations.angle.halfStep = 0.0;
    return observations;
}

/// The fit of positions over the angle in the file, with evenly spaced angles that are fitted, too. nullopt if the fit
/// is none of this kind, if the angles of observe() explain the positions exactly or the fitted ones do not, or if an
/// angle has moved by more than half a rounding step from the printed one (and as much again, at most, for the error
/// with which the fit determines the first angle).
std::optional<ObservedFit> withFittedAngles(const ObservedFit &observed)
{
    const Fit &fit = observed.fit;
    const bool arePositions = !observed.searched.containDerivatives(fit.columns);
    if (!fit.model.followsAngle || !arePositions) {
        return std::nullopt;
    }
    const Observations withExactAngles = withMovedAngles(observed.searched, 1.0, 0.0); // not moved, but exact
    if (isExact(withExactAngles, fit)) {
        return std::nullopt;
    }
    const Fit freeFit = fitOverFreeAngles(observed.searched, fit);
    if (!freeFit.isFinite()) {
        return std::nullopt;
    }
    const Parameters &found = freeFit.model.mechanism;
    const double stretch = found.omega2 / fit.model.angleFactor;
    const double shift = (found.theta20 - fit.model.mechanism.theta20) / fit.model.angleFactor;
    ObservedFit moved{.wholeFile = withMovedAngles(observed.wholeFile, stretch, shift),
                      .searched = withMovedAngles(observed.searched, stretch, shift),
                      .fit = fit};
    const Values moves = (moved.wholeFile.angle.values - moved.wholeFile.angle.printed).abs();
    const double errorOfStart = standardErrorOrZero(freeFit, Parameter::Theta20) / std::abs(fit.model.angleFactor);
    const double halfStep = observed.wholeFile.angle.halfStep;
    if (!(moves <= halfStep + std::min(kStandardErrors * errorOfStart, halfStep)).all()) {
        return std::nullopt;
    }
    for (const Parameter length : kLengths) {
        valueOf(moved.fit.model.mechanism, length) = valueOf(found, length);
        moved.errorsOfAngles[indexOf(length)] = standardErrorOrZero(freeFit, length);
    }
    moved.fit = fitModel(moved.searched, moved.fit.model, fit.columns, fit.unknowns);
    return isExact(moved.searched, moved.fit) ? std::optional(std::move(moved)) : std::nullopt;
}

} // namespace

ObservedFit withBestAbscissa(ObservedFit observed)
{
    const Fit &fit = observed.fit;
    if (!wasAbscissaMadeEven(observed.searched, fit.model)) {
        return observed;
    }
    if (std::optional<ObservedFit> fitted = withFittedAngles(observed)) {
        return *std::move(fitted);
    }
    Observations printed = withPrintedAbscissa(observed.searched, fit.model);
    Fit fitOfPrinted = fitModel(printed, fit.model, fit.columns, fit.unknowns);
    if (fitOfPrinted.misfit < fit.misfit) {
        observed.wholeFile = withPrintedAbscissa(std::move(observed.wholeFile), fit.model);
        observed.searched = std::move(printed);
        observed.fit = std::move(fitOfPrinted);
    }
    return observed;
}

DrivenFit withDriveOfFile(ObservedFit observed, const Drive &drive)
{
    if (drive.kind == Drive::Kind::RunUp) {
        observed.fit.model = modelAtSpeed(observed.searched, observed.fit, drive.omega2);
        observed.fit.model.alpha2 = drive.alpha2;
    }
    if (drive.kind != Drive::Kind::Constant) {
        return {std::move(observed), drive};
    }
    ObservedFit overTime = withAngleAsColumn(observed, drive);
    if (isAngleBetter(observed.fit, overTime)) {
        Drive uneven = drive;
        uneven.kind = Drive::Kind::Uneven;
        return {std::move(observed), uneven};
    }
    return {std::move(overTime), drive};
}

} // namespace slidercrank
