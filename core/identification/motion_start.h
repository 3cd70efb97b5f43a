// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where to start looking for the mechanism that made some data: from the data themselves. Given the speed, the shape is
// linear (linear_shape.h): over more than a turn or so it is found at the phases of a turn, from six harmonics; over
// less, on the rows themselves, derivatives summed up.

#include "core/identification/motion_fit.h"

#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Mechanisms worth trying, in FitUnits; none is wrong by more than one of mirrorImages() where the data can be fitted
/// at all. `speeds`: as of crank_speed.h. `size`: the crank's length where the data hold none.
std::vector<Parameters> startsOf(const FitProblem &problem, const std::vector<double> &speeds, double size,
                                 const std::stop_token &stop);

/// A coupler just long enough for the motion to exist at all rows.
void lengthenCoupler(const FitProblem &problem, Parameters &parameters);

/// All lengths scaled so that the columns that are lengths fit best.
void scaleToFit(const FitProblem &problem, Parameters &parameters);

/// What a mechanism leaves, without any fit but of the free constants: Σ n ln(mean r² / z²) over the columns; infinite
/// where it does not move as long as the data do.
double misfitOf(const FitProblem &problem, const Parameters &parameters);

/// Whether they are one mechanism, images apart: within 1e-3.
bool isSameMechanism(const Parameters &x, const Parameters &y);

/// Each of them once, images apart.
std::vector<Parameters> distinct(std::span<const Parameters> mechanisms);

} // namespace slidercrank
