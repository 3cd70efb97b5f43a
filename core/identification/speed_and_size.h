// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed of the crank and the size of the mechanism, where the columns from which the geometry was found leave them
// open.

#include "core/identification/drive.h"
#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// The model of a fit over the angle of the crank at a different speed. If the fit contains velocities or accelerations
/// of lengths, the lengths and the signs of the readings change so that it predicts the same values. (Angles in the fit
/// do not depend on the speed.)
Model modelAtSpeed(const Observations &observations, const Fit &fit, double omega2);

/// The result of withSpeedAndSize().
struct FitWithSpeeds {
    Fit fit; ///< of the geometry, with the columns that had to be added and the speed that they show

    /// In a table over the crank angle, the candidates for ω2 (rad/s) that the derivatives allow, see
    /// findTableSpeeds().
    std::vector<double> speeds{};
};

/// Adds columns to a fit of the geometry that show what this fit leaves open: the speed in a table over the crank
/// angle, and the size if the fit contains only angles, which show only ratios of lengths. `drive`: the kind of the
/// drive. `givenSpeed` (rad/s): preferred among the speeds that a table allows if it does not show the unit of its
/// derivatives.
FitWithSpeeds withSpeedAndSize(const Observations &observations, const Fit &geometry, Drive::Kind drive,
                               double givenSpeed);

} // namespace slidercrank
