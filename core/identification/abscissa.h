// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Chooses the abscissa of a fit: the time or the angle of the crank in the file, as printed or evenly spaced.

#include "core/identification/drive.h"
#include "core/identification/fit.h"

namespace slidercrank
{

/// A fit with the observations to which it belongs.
struct ObservedFit {
    Observations wholeFile; ///< all rows of the file
    Observations searched;  ///< the rows to which the model was fitted
    Fit fit;

    /// Standard errors of the lengths, in addition to those of `fit`, if withBestAbscissa() has replaced the angles in
    /// the file by fitted ones; otherwise 0.
    ParameterErrors errorsOfAngles{};
};

/// If observe() has replaced rounded time stamps or angles by evenly spaced ones, chooses those at which the values of
/// the other columns were probably computed, and fits the model to them:
///   1. in a table of positions over the crank angle, different evenly spaced angles, which are fitted: if they agree
///      with the printed ones within rounding, and are needed to explain the columns within their own rounding;
///   2. the printed ones, if these explain the columns better: a program may have computed its values at rounded times;
///   3. otherwise those of observe().
/// If observe() has not replaced any, returns `observed`.
ObservedFit withBestAbscissa(ObservedFit observed);

/// A fit, and the drive that it uses.
struct DrivenFit {
    ObservedFit observed;
    Drive drive;
};

/// Uses `drive`, the result of findDrive() for the fit, in a file with the time and θ2:
///   - A constant speed predicts θ2, which becomes a column of a fit over the time. But if θ2 explains the columns of
///     the fit better than a constant speed does, what looked like errors of θ2 are changes of the speed. Then the fit
///     remains, and the drive becomes uneven.
///   - The model gets the speed and the acceleration of a run-up.
///   - Any other drive changes nothing.
DrivenFit withDriveOfFile(ObservedFit observed, const Drive &drive);

} // namespace slidercrank
