// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed of the crank that derivatives show, before they are used in a fit.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// In a table over the crank angle, a derivative of order n is the derivative by the angle times ω2ⁿ times a unit.
/// Every derivative that the fit does not use, and the mechanism explains up to a constant factor, votes for the speeds
/// that follow from this factor in each unit; only those with residuals as small as rounding if there are such. Returns
/// the speeds (rad/s) with the most votes; among these, those that contradict the fewest units. (A unit is contradicted
/// if the file states a different one; if it states none and the column contains lengths that are not in mm; and if it
/// states none, θ2 is in radians, and the rate of an angle is not.) These are several if the units do not determine the
/// speed, and none if no derivative votes. If one of the speeds with the most votes has the magnitude of the given
/// speed, returns only this one, with the sign of the given speed; but not if it contradicts more units than a speed
/// ten times as high or low.
std::vector<double> findTableSpeeds(const Observations &observations, const Fit &fit, double givenSpeed);

/// In a file over the time with few rows per turn, different speeds give the same positions. Returns the fit with the
/// speed that a velocity shows; `fit` if no velocity shows a different speed, or if a wrong unit explains the
/// difference.
Fit withSpeedOfVelocities(const Observations &observations, const Fit &fit);

} // namespace slidercrank
