// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/abscissa.h"

#include "core/import/crank_angles.h"

#include <utility>

namespace slidercrank
{

namespace
{

/// Makes the angle of the crank in the file a column like the others, because a constant speed predicts it, and fits it
/// together with them over the time.
ObservedFit withAngleAsColumn(ObservedFit current, const Drive &drive)
{
    Observations &observations = current.wholeFile;
    Fit &fit = current.fit;
    ObservedColumn angle{.channel = kCrankAngle,
                         .values = observations.angle,
                         .range = observations.angle.maxCoeff() - observations.angle.minCoeff()};
    angle.setHalfSteps(Values::Constant(observations.size(), observations.angleHalfStep));
    observations.columns.push_back(std::move(angle));
    const Index column = std::ssize(observations.columns) - 1;
    Model &model = fit.model;
    model.readings.push_back({1.0 / model.angleFactor, -model.mechanism.theta20 / model.angleFactor});
    model.followsAngle = false;
    model.mechanism.omega2 = drive.omega2;
    model.mechanism.theta20 = drive.theta20;
    fit.columns.push_back(column);
    for (const Unknown unknown : {Unknown{Unknown::Kind::CrankAngle}, {Unknown::Kind::Omega2}}) {
        if (!fit.isFree(unknown)) {
            fit.unknowns.push_back(unknown);
        }
    }
    fit.unknowns.push_back({Unknown::Kind::Origin, column});
    current.searched = selectRows(withoutSpikes(observations), kSearchedRows);
    fit = fitModel(current.searched, fit.model, fit.columns, fit.unknowns);
    return current;
}

} // namespace

ObservedFit withBestAbscissa(ObservedFit current)
{
    const Fit &fit = current.fit;
    const auto abscissa = fit.model.followsAngle ? &Observations::angle : &Observations::time;
    const auto printedAbscissa = fit.model.followsAngle ? &Observations::printedAngle : &Observations::printedTime;
    Observations printed = current.searched;
    printed.*abscissa = printed.*printedAbscissa;
    if ((printed.*abscissa).size() == 0) {
        return current;
    }
    Fit other = fitModel(printed, fit.model, fit.columns, fit.unknowns);
    if (other.misfit < fit.misfit) {
        current.fit = std::move(other);
        current.searched = std::move(printed);
        current.wholeFile.*abscissa = current.wholeFile.*printedAbscissa;
        current.wholeFile.timeMargin = 0.0; // the time stamps are exact
    }
    return current;
}

ObservedFit withDriveOfFile(ObservedFit current, const Drive &drive)
{
    if (drive.kind == Drive::Kind::Constant) {
        return withAngleAsColumn(std::move(current), drive);
    }
    if (drive.kind == Drive::Kind::RunUp) {
        current.fit.model.mechanism.omega2 = drive.omega2;
        current.fit.model.alpha2 = drive.alpha2;
    }
    return current;
}

} // namespace slidercrank
