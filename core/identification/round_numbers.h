// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Nobody builds a crank of 19.9999997 mm. A parameter that was measured is known within its standard error only, and a
// round number there is the better guess: 20 mm, 60 turns a minute.

#include "core/comparison/comparison.h"
#include "core/identification/identification.h"

#include <span>

namespace slidercrank
{

/// The identified mechanism in numbers that a person would have chosen: each parameter is the roundest number (ω2 of
/// those in rad/s, °/s and turns a minute, θ20 in rad and °) that lies within three standard errors, if one so round
/// would be there by chance in one case of ten at most; otherwise it has two digits of its standard error. Where the
/// data do not agree with all of them together as well as with what was identified, they are given as identified.
/// `identified`: the data against the identified mechanism.
Parameters inRoundNumbers(const Identification &found, const ReferenceData &data,
                          std::span<const ChannelComparison> identified);

/// The roundest number that a value with that standard error leaves room for, by the same rule; or, where there is
/// none, the value to two digits of its standard error. `units`: what it may be counted in.
double roundest(double value, double standardError, std::span<const double> units);

} // namespace slidercrank
