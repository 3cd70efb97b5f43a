// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the mobility of the mechanism: whether the crank makes full turns, between which crank angles the mechanism
// can be assembled, its dead centres and its stroke; and the crank angle from the position of the slider. Lengths in
// mm, angles in rad.
//
// Source: R. L. Norton, "Design of Machinery", sections 2.13 (Grashof's condition), 3.8 and 4.10 (dead centres).

#include "core/limits/coupler_angles.h"
#include "core/mechanism/mechanism.h"

#include <optional>
#include <vector>

namespace slidercrank
{

enum class Mobility {
    FullTurn,  ///< b >= a + |c|: the crank makes full turns
    Rocker,    ///< the crank oscillates within one arc, or within one of two arcs
    Locked,    ///< b = |c| - a: can be assembled in a single position
    Impossible ///< b < |c| - a: cannot be assembled
};

/// A range of crank angles, with from <= to and `from` in [-π, π). Its length is 2π if the crank makes full turns, and
/// 0 if the mechanism is locked.
struct CrankRange {
    double from = 0.0;
    double to = 0.0;
};

/// A crank angle and the position of the slider there.
struct SliderPosition {
    double theta2 = 0.0;
    double R4x = 0.0;
};

struct MotionLimits {
    Mobility mobility = Mobility::FullTurn;

    /// The crank angles at which the mechanism can be assembled; disjoint, ascending.
    std::vector<CrankRange> ranges;

    /// The positions at the ends of the ranges, where the coupler is perpendicular to the slider's line. Empty if the
    /// crank makes full turns; a locked mechanism has one.
    std::vector<SliderPosition> crankLimits;

    /// The dead centres of this branch, where crank and coupler are collinear and the velocity of the slider is zero: B
    /// farthest from O2 (extended, b + a) and nearest to it (folded, |b - a|). θ2 is within [-π, π).
    std::optional<SliderPosition> outerDeadCentre;
    std::optional<SliderPosition> innerDeadCentre;

    /// Largest minus smallest R4x that the slider reaches (in the arc with the larger stroke); nullopt if Impossible.
    std::optional<double> stroke;

    /// The angles by which the crank turns while the slider moves from the inner to the outer dead centre and back, in
    /// the direction of ω2 (counter-clockwise for ω2 = 0), and the time ratio, the slower stroke over the faster (>=
    /// 1). Full turns only.
    std::optional<double> angleOutwards;
    std::optional<double> angleInwards;
    std::optional<double> timeRatio;

    CouplerAngles coupler; ///< not valid if the mobility is Impossible
};

/// Computes mobility, ranges, dead centres, strokes and coupler angles.
MotionLimits motionLimits(const Mechanism &mechanism);

/// Returns the crank angles at which the mechanism cannot be assembled: the gaps between the ranges, or the full circle
/// if there is no range.
std::vector<CrankRange> forbiddenRanges(const MotionLimits &limits);

/// Returns steps + 1 crank angles from one end of the range to the other. They are denser near the ends, where the
/// coupler of a rocker rotates fastest.
std::vector<double> anglesAcross(const CrankRange &range, int steps);

/// A range of crank angles between two successive dead centres or ends of the arc of a rocker, in which the slider
/// moves in one direction only. The angles are not wrapped.
struct SliderStroke {
    SliderPosition from; ///< has the smaller crank angle
    SliderPosition to;
};

enum class CrankDirection { Clockwise, CounterClockwise };

/// Returns the stroke that contains the crank angle. Where two strokes meet, returns the one that the crank enters when
/// it turns in `direction`. Returns nullopt if the mechanism cannot be assembled at the angle.
std::optional<SliderStroke> strokeAround(const MotionLimits &limits, double theta2, CrankDirection direction);

/// Returns the crank angle within the stroke at which the slider is at R4x; for R4x beyond the stroke, that of the
/// nearer end.
double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x);

/// Returns whether the velocities jump at a crank angle (rad): whether the crank only just makes full turns (b = a +
/// |c|) and the coupler is perpendicular to the slider's line at that angle, except for rounding. The velocity just
/// before that position then differs from the velocity just after it.
bool velocitiesJumpAt(const Mechanism &mechanism, double theta2);

/// Returns the length (mm) of the shortest coupler with which the mechanism can be assembled, |c| - a. If it is
/// negative, any length suffices.
inline double shortestCouplerForAnyPose(const Mechanism &mechanism)
{
    return std::abs(mechanism.c()) - mechanism.a();
}

/// Returns the length (mm) of the shortest coupler with which the crank makes full turns, a + |c|.
inline double shortestCouplerForFullTurn(const Mechanism &mechanism)
{
    return mechanism.a() + std::abs(mechanism.c());
}

} // namespace slidercrank
