// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion by the formulas of the textbook with a chosen number of digits, as the reference for all methods.
// The formulas cancel near a toggle, which additional digits compensate (50 suffice away from a toggle, 100
// everywhere). Lengths in mm, angles in rad, time in s.

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/study/judge.h"

#include <boost/math/constants/constants.hpp>
// g++ 14 warns of an access that a condition in this header excludes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <boost/multiprecision/cpp_bin_float.hpp>
#pragma GCC diagnostic pop

#include <array>
#include <cmath>

namespace slidercrank
{

// Binary, so that every double is taken exactly.
using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Digits100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// The input of the motion, converted without rounding.
template <class Real>
struct ExactInput {
    std::array<Real, 6> numbers; ///< a, b, c, ω2, θ20 and t
    Branch branch;

    ExactInput(const Parameters &p, double t)
        : numbers{p.a, p.b, p.c, p.omega2, p.theta20, t}
        , branch(p.branch)
    {
    }
};

template <class Real>
struct ExactState {
    Status status = Status::Solved; ///< Solved, Singular or NotAssemblable
    Real cosTheta3 = 0;
    Real clearance = 0;                     ///< (b - |h|)/b; negative: cannot be assembled
    std::array<Real, kChannelCount> values; ///< by indexOf(channel); only the positions if Singular
};

template <class Real>
ExactState<Real> exactState(const ExactInput<Real> &in)
{
    using std::abs;
    const auto &[a, b, c, omega2, theta20, t] = in.numbers;
    ExactState<Real> out;
    out.values.fill(Real(0));
    TextbookMotion<Real> motion;
    const bool isSolved = motion.compute({a, b, c, omega2, 0}, omega2 * t + theta20,
                                         in.branch == Branch::Open ? 1.0 : -1.0, boost::math::constants::pi<Real>());
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

template <class Real>
ExactState<Real> exactState(const Parameters &parameters, double t)
{
    return exactState(ExactInput<Real>(parameters, t));
}

/// Returns κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t for each channel: its change per unit of relative error of the
/// input. Infinite if such an error could make the mechanism impossible to assemble.
template <class Real>
std::array<double, kChannelCount> conditioning(const Parameters &parameters, double t)
{
    using std::abs;
    const Real step = 1e-25;
    const ExactInput<Real> in(parameters, t);
    std::array<double, kChannelCount> kappa{};
    for (std::size_t i = 0; i < in.numbers.size(); ++i) {
        ExactInput<Real> more = in;
        ExactInput<Real> less = in;
        more.numbers[i] *= 1 + step;
        less.numbers[i] *= 1 - step;
        const ExactState<Real> above = exactState(more);
        const ExactState<Real> below = exactState(less);
        const bool exists = above.status == Status::Solved && below.status == Status::Solved;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            kappa[index] +=
                exists ? static_cast<double>(abs(above.values[index] - below.values[index]) / (2 * step)) : kInfinity;
        }
    }
    return kappa;
}

// Instantiated in exact_motion.cpp, because they take long to compile.
extern template ExactState<Digits50> exactState(const ExactInput<Digits50> &);
extern template ExactState<Digits100> exactState(const ExactInput<Digits100> &);
extern template std::array<double, kChannelCount> conditioning<Digits100>(const Parameters &, double);

} // namespace slidercrank
