// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where to start looking for the mechanism that made some data: from the data themselves.
//
// The speed W is found first: every column is periodic in W t, so that a constant and two harmonics, each derivative
// differentiated exactly, leave least at the right speed. Two only: with four, half the speed fits as well.
//
// Then, with θ2 = W t + φ, u = a cos φ and v = a sin φ, so that a cos θ2 = u cos W t - v sin W t and
// a sin θ2 = v cos W t + u sin W t, everything else is linear. Let the file's θ3 be q = θ3 + z, and its R4x be r + m
// with mean m, the slider really being at r + R:
//
//     both       B1 cos q + B2 sin q + a cos θ2 + (m - R) = r + m,   B1 sin q - B2 cos q + a sin θ2 - c = 0
//     θ3 alone   sin q = tan z cos q + (c - a sin θ2) / (b cos z)
//     R4x alone  r² = -2 R r + 2 r a cos θ2 + (2 R u + 2 c v) cos W t + (2 c u - 2 R v) sin W t + D - R²,
//                D = b² - a² - c²
//
// with B1 = b cos z and B2 = b sin z. Where the origin of a column is trusted, z = 0 and R = m. Over more than a turn
// or so these are written at the phases of a turn, from six harmonics; over less, on the rows themselves, derivatives
// summed up.

#include "core/identification/motion_fit.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Magnitudes of the speed that the columns may have, in whatever units and senses; some, the best first.
std::vector<double> speedsOf(const FitProblem &problem, const std::stop_token &stop);

/// Mechanisms worth trying, in FitUnits; none is wrong by more than one of imagesOf() where the data can be fitted at
/// all. `speeds`: as speedsOf(). `size`: the crank's length where the data hold none.
std::vector<Parameters> startsOf(const FitProblem &problem, const std::vector<double> &speeds, double size,
                                 const std::stop_token &stop);

/// A coupler just long enough for the motion to exist at all rows.
void lengthenCoupler(const FitProblem &problem, Parameters &parameters);

/// All lengths scaled so that the columns that are lengths fit best.
void scaleToFit(const FitProblem &problem, Parameters &parameters);

/// What a mechanism leaves, without any fit but of the free constants: Σ n ln(mean r² / z²) over the columns; infinite
/// where it does not move as long as the data do.
double misfitOf(const FitProblem &problem, const Parameters &parameters);

/// The speed that θ2 or its derivative tells (FitUnits, signed); 0: neither is there.
double crankSpeedOf(const FitProblem &problem);

} // namespace slidercrank
