// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rounds identified parameters. A measured parameter is known within its standard error only, and a round number within
// it is the best estimate: 20 mm instead of 19.9999997 mm.

#include "core/comparison/comparison.h"
#include "core/identification/identification.h"

#include <array>
#include <span>

namespace slidercrank
{

/// Rounds the parameters of an identified or approximate mechanism. Each becomes the roundest number within three
/// standard errors (ω2 in rad/s, °/s or rpm, θ20 in rad or °) if the probability that such a round number is there by
/// chance is at most
/// 10 %; otherwise it is rounded to two digits of its standard error. Returns the parameters as identified if the data
/// deviate more from the rounded ones.
Parameters inRoundNumbers(const Identification &found, const ReferenceData &data);

inline constexpr std::array kPlainUnit{1.0};

/// Rounds one value in the same way, unless its standard error is unknown (0, infinite or NaN). `units`: the units in
/// which it may be a round number.
double roundest(double value, double standardError, std::span<const double> units = kPlainUnit);

} // namespace slidercrank
