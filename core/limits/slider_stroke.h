// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From where the slider is to where the crank is. Between two dead centres the slider moves one way only, so that each
// of its places belongs to one crank angle there. Lengths in mm, angles in rad.

#include "core/limits/mobility.h"
#include "core/mechanism/mechanism.h"

#include <optional>

namespace slidercrank
{

/// Crank angles between a dead centre, or an end of a rocker's arc, and the next; from < to, not wrapped.
struct SliderStroke {
    double from = 0.0;
    double to = 0.0;
    double R4xFrom = 0.0;
    double R4xTo = 0.0;
};

/// The stroke that the crank angle belongs to; at the end of one the stroke that follows it in that sense, which is
/// +1 or -1. None where there is no pose.
std::optional<SliderStroke> strokeAround(const Mechanism &mechanism, const MotionLimits &limits, double theta2,
                                         int sense);

/// Where the crank is with the slider there; for a slider beyond the stroke the nearer end.
double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x);

} // namespace slidercrank
