// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the exact motion in closed form, accurate to the last digits of a double at any time, also at and near a
// toggle, where the coupler is perpendicular to the slider's line. It does not use the constraint equations, so that
// its agreement with Newton-Raphson is evidence for both.
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

/// The six plotted channels at one time stamp, and the quantities from which the other thirty follow.
struct Motion {
    double theta2 = kNone;                                        ///< rad, not wrapped
    SinCos crank{kNone, kNone};                                   ///< sin θ2, cos θ2
    double s = kNone, sDot = kNone, sDDot = kNone;                ///< b cos θ3, mm
    double theta3 = kNone, theta3Dot = kNone, theta3DDot = kNone; ///< rad
    double R4x = kNone, R4xDot = kNone, R4xDDot = kNone;          ///< mm
    Status status = Status::Solved; ///< Solved, Singular (no derivatives), NotAssemblable or NotFinite (no motion)

    /// Returns the values of kPlottedChannels.
    std::array<double, kPlottedChannels.size()> plotted() const
    {
        return {theta3, R4x, theta3Dot, R4xDot, theta3DDot, R4xDDot};
    }
};

/// One output array for each of kPlottedChannels, in that order (mm, rad, s). Channels with a null pointer are not
/// computed.
using PlottedColumns = std::array<double *, kPlottedChannels.size()>;

class ClosedForm
{
public:
    explicit ClosedForm(const Mechanism &mechanism);

    /// Returns the six plotted channels at time t (s).
    Motion motionAt(double t) const;

    /// Returns all 36 channels at time t (s). Defined in state_at.h.
    inline State stateAt(double t) const;

    /// Computes the requested channels and the status at each time stamp (s), with the widest vector instructions of
    /// the processor. The results equal those of motionAt() to the last bit, on every processor. All arrays have the
    /// size of `times`.
    void evaluate(std::span<const double> times, const PlottedColumns &columns, std::span<Status> statuses) const;

private:
    /// Returns the motion at a time stamp that the vector code cannot compute: one without a full solution, near a
    /// limit position of a rocker, or with a very large crank angle.
    Motion difficultMotionAt(double t) const;

    Mechanism m_mechanism;
    MotionConstants m_constants;
};

} // namespace slidercrank
