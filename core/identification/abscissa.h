// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a fit follows the time or the angle of the crank, and in which form.

#include "core/identification/drive.h"
#include "core/identification/fit.h"

namespace slidercrank
{

/// A fit with the observations to which it belongs.
struct ObservedFit {
    Observations wholeFile; ///< all rows of the file
    Observations searched;  ///< the rows to which the model was fitted
    Fit fit;
    ParameterErrors errorsOfAngles{}; ///< possible errors of the lengths if the angles were fitted, too; otherwise 0
};

/// Chooses between the time stamps or angles at which the values may have been computed, if observe() has replaced
/// rounded ones by evenly spaced ones:
///   1. in a table of positions over the crank angle, different evenly spaced angles, which are fitted: if they agree
///      with the printed ones within rounding, and are needed to explain the columns within their own rounding;
///   2. the printed ones, if these explain the columns better: a program may have computed its values at rounded times;
///   3. otherwise those of observe().
ObservedFit withBestAbscissa(ObservedFit observed);

/// A fit, and the drive that it uses.
struct DrivenFit {
    ObservedFit observed;
    Drive drive;
};

/// Uses the drive of a file with the time and θ2. A constant speed predicts θ2, which becomes a column of a fit over
/// the time. But if θ2 explains the other columns better than a constant speed does, what looked like errors of θ2 are
/// changes of the speed: then the drive becomes uneven. The speed and acceleration of a run-up are taken from the
/// drive. Otherwise returns `observed`.
DrivenFit withDriveOfFile(ObservedFit observed, const Drive &drive);

} // namespace slidercrank
