// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion by the formulas of the textbook with 115 digits, as the reference for all methods. The formulas
// cancel near a toggle, which so many digits compensate. Lengths in mm, angles in rad, time in s.

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/study/judge.h"

#include <array>
#include <cmath>
#include <mpreal.h>
#undef IsInf // a macro of mpreal.h, and the name of a function of Highway

namespace slidercrank
{

/// A number with 115 digits. Every double is one of these numbers. (The precision of mpreal itself is a global
/// variable; a result has the precision of its operands.)
struct ManyDigits : mpfr::mpreal {
    static constexpr int kBits = 384;

    ManyDigits(double value = 0.0)
        : mpreal(value, kBits)
    {
    }
    ManyDigits(const mpreal &value)
        : mpreal(value)
    {
    }
};

/// The input of the motion, converted without rounding.
template <class Real = ManyDigits>
struct ExactInput {
    std::array<Real, 6> numbers; ///< a, b, c, ω2, θ20 and t
    Branch branch;

    ExactInput(const Parameters &p, double t)
        : numbers{p.a, p.b, p.c, p.omega2, p.theta20, t}
        , branch(p.branch)
    {
    }
};

template <class Real = ManyDigits>
struct ExactState {
    Status status = Status::Solved; ///< Solved, Singular or NotAssemblable
    Real cosTheta3 = 0;
    Real clearance = 0;                     ///< (b - |h|)/b; negative: cannot be assembled
    std::array<Real, kChannelCount> values; ///< by indexOf(channel); only the positions if Singular
};

template <class Real>
ExactState<Real> exactState(const ExactInput<Real> &in)
{
    using std::abs, std::acos;
    const auto &[a, b, c, omega2, theta20, t] = in.numbers;
    ExactState<Real> out;
    out.values.fill(Real(0));
    TextbookMotion<Real> motion;
    const bool isSolved = motion.compute({a, b, c, omega2, 0}, omega2 * t + theta20,
                                         in.branch == Branch::Open ? 1.0 : -1.0, Real(acos(Real(-1))));
    out.clearance = (b - abs(Real(c - motion.pinY[0]))) / b;
    out.status = isSolved ? Status::Solved : out.clearance < 0 ? Status::NotAssemblable : Status::Singular;
    if (out.status == Status::NotAssemblable) {
        return out;
    }
    out.cosTheta3 = (motion.sliderX[0] - motion.pinX[0]) / b;
    for (std::size_t index = 0; index < (isSolved ? kChannelCount : kCoordinateCount); ++index) {
        out.values[index] = motion.valueAt(channelAt(index));
    }
    return out;
}

template <class Real = ManyDigits>
ExactState<Real> exactState(const Parameters &parameters, double t)
{
    return exactState(ExactInput<Real>(parameters, t));
}

/// Returns κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t for each channel: its change per unit of relative error of the
/// input. Infinite if such an error could make the mechanism impossible to assemble.
std::array<double, kChannelCount> conditioning(const Parameters &parameters, double t);

extern template ExactState<> exactState(const ExactInput<> &);

} // namespace slidercrank
