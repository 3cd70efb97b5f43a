// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the crank angle from the position of the slider. Between two dead centres the slider moves in one direction
// only, so that each of its positions belongs to one crank angle there. Lengths in mm, angles in rad.

#include "core/limits/mobility.h"
#include "core/mechanism/mechanism.h"

#include <optional>

namespace slidercrank
{

/// A range of crank angles between two successive dead centres or ends of the arc of a rocker; from < to, not wrapped.
struct SliderStroke {
    double from = 0.0;
    double to = 0.0;
    double R4xFrom = 0.0;
    double R4xTo = 0.0;
};

/// Returns the stroke that contains the crank angle; at the end of a stroke, the one that follows in the direction
/// `sense`
/// (+1 or -1). Returns nullopt if the mechanism cannot be assembled there.
std::optional<SliderStroke> strokeAround(const Mechanism &mechanism, const MotionLimits &limits, double theta2,
                                         int sense);

/// Returns the crank angle at which the slider is at R4x; for R4x beyond the stroke, that of the nearer end.
double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x);

} // namespace slidercrank
