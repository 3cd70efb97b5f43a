// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the mechanism can do at all: turn round or rock, between which crank angles, how far the slider goes.
// Angles in rad, lengths in mm. Both depend on the branch where the text says so.
//
// Source: Grashof's condition for the slider-crank and the dead centres, Norton, "Design of
// Machinery", 2.13, 3.8, 4.10.

#include "core/mechanism/mechanism.h"

#include <optional>
#include <vector>

namespace slidercrank
{

enum class Mobility {
    FullTurn,  ///< b >= a + |c|: the crank turns round
    Rocker,    ///< the crank swings within one arc, or two
    Locked,    ///< b = |c| - a: one pose only
    Impossible ///< b < |c| - a: no pose at all
};

/// from <= to, from within [-π, π); 2π long when the crank turns round, of length 0 when locked.
struct CrankRange {
    double from = 0.0;
    double to = 0.0;
};

/// A pose where the slider stands still for a moment: crank and coupler in one line.
struct DeadCentre {
    double theta2 = 0.0; ///< within [-π, π)
    double R4x = 0.0;
};

struct MotionLimits {
    Mobility mobility = Mobility::FullTurn;

    /// Where the mechanism can be assembled; disjoint, ascending.
    std::vector<CrankRange> ranges;

    /// Of this branch: farthest from O2 (stretched, b + a) and nearest (folded, |b - a|), where they exist.
    std::optional<DeadCentre> outer;
    std::optional<DeadCentre> inner;

    /// Largest minus smallest R4x that the slider reaches (in the wider of two arcs); none when impossible.
    std::optional<double> stroke;

    /// Crank angle that the slider needs from the inner to the outer dead centre and back, turning with ω2 (for ω2 = 0
    /// counter-clockwise), and their ratio, the slower stroke over the faster (>= 1). Full turn only.
    std::optional<double> angleOutwards;
    std::optional<double> angleInwards;
    std::optional<double> timeRatio;

    /// Largest pressure angle |θ3| of the coupler against the slider's line, measured to the nearer side, and a crank
    /// angle where it is reached. The transmission angle there is π/2 minus it.
    double largestPressureAngle = 0.0;
    double largestPressureAngleAt = 0.0;
};

MotionLimits motionLimits(const Mechanism &mechanism);

/// Crank angles at which it cannot be assembled: between the ranges, each from within [-π, π); all of the circle when
/// there is no range.
std::vector<CrankRange> forbiddenRanges(const MotionLimits &limits);

/// Crank angles from one end of the range to the other, closer together towards the ends, where a rocker's coupler
/// swings fastest.
std::vector<double> anglesAcross(const CrankRange &range, int steps);

/// The shortest coupler for which there is any pose, |c| - a (may be negative: any length will do), and for which the
/// crank turns round, a + |c|. mm.
double shortestCouplerForAnyPose(const Mechanism &mechanism);
double shortestCouplerForFullTurn(const Mechanism &mechanism);

/// The longest crank, b - |c|, and the largest offset |c|, b - a, for which the crank turns round; where that is not
/// positive, or negative, there is none. mm.
double longestCrankForFullTurn(const Mechanism &mechanism);
double largestOffsetForFullTurn(const Mechanism &mechanism);

} // namespace slidercrank
