// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion by the formulas of the textbook with 115 digits, as the reference for all methods. The formulas
// cancel near a toggle, for which 115 digits compensate. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/study/exact_values.h"

#include <array>
#include <mpreal.h>
#undef IsInf // a macro of mpreal.h, and the name of a function of Highway

namespace slidercrank
{

/// A number with 115 digits. Conversion from a double is exact. Numbers are made by this type, because the precision of
/// a new mpreal is a global variable; a result has the precision of its operands.
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
struct ExactInput {
    ManyDigits a, b, c, omega2, theta20, t;
    Branch branch;

    ExactInput(const Parameters &p, double time)
        : a(p.a)
        , b(p.b)
        , c(p.c)
        , omega2(p.omega2)
        , theta20(p.theta20)
        , t(time)
        , branch(p.branch)
    {
    }
};

struct ExactState {
    Status status = Status::Solved; ///< Solved, Singular or NotAssemblable
    ManyDigits cosTheta3;
    ManyDigits clearance;                         ///< (b - |h|)/b with h = c - a sin θ2; negative: cannot be assembled
    std::array<ManyDigits, kChannelCount> values; ///< indexed by indexOf(channel); only the positions if Singular
};

ExactState exactState(const ExactInput &input);

/// Returns κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t for each channel: the change of the channel per unit of relative
/// error of the input. Infinite if such an error could make the mechanism impossible to assemble.
std::array<double, kChannelCount> conditioning(const Parameters &parameters, double t);

} // namespace slidercrank
