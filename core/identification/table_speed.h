// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed of the crank that derivatives show, before they are used in a fit.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// In a table over the crank angle, a derivative of order n is the derivative by the angle times ω2ⁿ times a unit.
/// Returns the speeds (rad/s) that the derivatives show: several if their units leave several open, none if no
/// derivative shows one.
///   1. Each derivative that the fit does not use, and that its mechanism explains up to a factor, votes for the
///      speeds that follow from this factor, one for each unit. If that mechanism does not explain it, but one that is
///      fitted to it together with the columns of the fit does, the derivative votes for the speeds of that mechanism.
///      Derivatives of lengths do not vote if the fit contains only angles. If the residuals of some voting derivatives
///      are as small as rounding, only these vote.
///   2. A vote contradicts the unit of its column if the file states a different one. If it states none, lengths are
///      expected in mm, and rates of angles in radians if θ2 is in radians.
///   3. The speeds with the most votes are returned, and among these those that contradict the fewest units.
///   4. If one of the speeds with the most votes has the magnitude of the given speed, it is returned alone, with the
///      sign of the given speed; but not if it contradicts more units than a speed ten times as high or low.
///   5. If rule 3 returns a single speed, which is a tenth of the given one, and only a velocity of a length votes for
///      it, ten times this speed is returned, too: the velocity may be in cm/s under a heading that says mm/s.
std::vector<double> findTableSpeeds(const Observations &observations, const Fit &fit, double givenSpeed);

/// In a file over the time with few rows per turn, different speeds give the same positions. Returns the fit with the
/// speed that a velocity of R4_x or θ3 shows; `fit` if none shows a different speed with which the fit explains its
/// columns as well, or if a wrong unit explains the difference.
Fit withSpeedOfVelocities(const Observations &observations, const Fit &fit);

} // namespace slidercrank
