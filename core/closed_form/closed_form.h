// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exact motion in closed form, to the last digits that a double holds: also at and near a toggle, where the coupler
// is perpendicular to the slider's line, and at any time. It does not use the constraint equations, so that its
// agreement with Newton-Raphson is evidence for both.
//
// With ω = ω2 and the names of motion_constants.h:
//
//     s   = b cos θ3 = ±√(p m)          + open, - crossed
//     θ3  = atan2(g h, s)               crossed: π - atan2(g h, |s|), so that it is continuous; within [-π/2, 3π/2]
//     θ̇3  = -a ω cos θ2 / s             θ̈3  = g a ω² N / s³,     N = a (g h) cos²θ2 + x s²
//     ṡ   = -(g h) θ̇3                   s̈   = -a ω² G / s³,      G = a b² cos²θ2 + (g h) x s²
//     R4x = a cos θ2 + s
//
// These are the textbook's formulas (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15) without differences of nearly
// equal numbers; motion_kernel-inl.h rearranges N, G and R4x where they would cancel. Lengths in mm, angles in rad,
// time in s.

#include "core/closed_form/motion_constants.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/mechanism/two_part_angle.h"

#include <span>

namespace slidercrank
{

struct State;

/// The six plotted channels at one time stamp, and what the other thirty follow from.
struct Motion {
    double theta2 = kNone;                                        ///< rad, not wrapped
    SinCos crank{kNone, kNone};                                   ///< sin θ2, cos θ2
    double s = kNone, sDot = kNone, sDDot = kNone;                ///< b cos θ3, mm
    double theta3 = kNone, theta3Dot = kNone, theta3DDot = kNone; ///< rad
    double R4x = kNone, R4xDot = kNone, R4xDDot = kNone;          ///< mm
    Status status = Status::Solved; ///< Solved, Singular (no derivatives), NotAssemblable or NotFinite (no motion)
};

/// One array for each of kPlottedChannels, in that order and in mm and rad; a null pointer for a channel that is not
/// wanted and therefore not computed.
using PlottedColumns = std::array<double *, kPlottedChannels.size()>;

class ClosedForm
{
public:
    explicit ClosedForm(const Mechanism &mechanism);

    /// The six plotted channels at time t (s).
    Motion motionAt(double t) const;

    /// All 36 channels at time t (s); defined in state_at.h.
    inline State stateAt(double t) const;

    /// The wanted channels and the status at each time stamp (s), computed in the widest vectors that the processor
    /// has. The numbers are those of motionAt() to the last bit, on every processor. The arrays are as long as `times`.
    void evaluate(std::span<const double> times, const PlottedColumns &columns, std::span<Status> statuses) const;

private:
    /// For the time stamps that the vectors leave: one without a full solution, one near a limit of a rocker, or one
    /// with a very large crank angle.
    Motion difficultMotionAt(double t) const;

    Mechanism m_mechanism;
    MotionConstants m_constants;
};

/// Whether the mechanism has a position at time t (s); false also where the crank angle is not a finite number.
bool isAssemblable(const Mechanism &mechanism, double t);

} // namespace slidercrank
