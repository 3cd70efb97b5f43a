// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The speed of the crank that derivatives show, before they are used in a fit.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// In a table over the crank angle, a derivative of order n is the derivative by the angle times ω2ⁿ times a unit.
/// Every derivative that fits up to such a factor votes for the speed of its own unit and for that of the other unit of
/// angles. Returns the speeds (rad/s) with the most votes; among these, those that contradict the fewest stated units.
/// Several if the units leave it open; none if the file has no such derivatives. If one of them has the magnitude of
/// the given speed, it is the only one, with the sign of the given speed.
std::vector<double> speedsOfTable(const Observations &observations, const Fit &fit, double givenSpeed);

/// In a file over the time with few rows per turn, different speeds give the same positions. Returns the fit with the
/// speed that a velocity shows, or the same fit if none shows another speed or a different unit explains it.
Fit withSpeedOfVelocities(const Observations &observations, const Fit &fit);

} // namespace slidercrank
