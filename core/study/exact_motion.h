// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The judge: the exact motion of the slider-crank, straight from the textbook's formulas, in as many digits as are
// asked for. The formulas cancel near a toggle; here digits make up for it (50 are enough away from a toggle, 100
// everywhere). It shares no formula with the closed form of the core, and none with the constraints.
//
// Source: Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15, for θ³ = θ_3 - 180°:
//     h = c - a sin θ2,   sin θ3 = h/b,   cos θ3 = ±√((b - h)(b + h))/b
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <boost/math/constants/constants.hpp>
// g++ 14 takes for possible what a condition in there excludes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <boost/multiprecision/cpp_bin_float.hpp>
#pragma GCC diagnostic pop

#include <array>
#include <cmath>
#include <limits>

namespace slidercrank
{

// Binary, so that every double is taken exactly.
using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Digits100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

inline constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon(); // 2^-53

/// Everything that the motion depends on, exact.
template <class Real>
struct ExactInput {
    Real a, b, c, omega2, theta20, t;
    Branch branch;

    ExactInput(const Parameters &parameters, double instant)
        : a(parameters.a)
        , b(parameters.b)
        , c(parameters.c)
        , omega2(parameters.omega2)
        , theta20(parameters.theta20)
        , t(instant)
        , branch(parameters.branch)
    {
    }
};

template <class Real>
struct ExactState {
    Status status = Status::Solved; ///< Solved, Singular or NotAssemblable
    Real cosTheta3 = 0;
    Real clearance = 0;                     ///< (b - |h|)/b; negative: no pose
    std::array<Real, kChannelCount> values; ///< by indexOf(channel); those of a position only where Singular
};

template <class Real>
ExactState<Real> exactState(const ExactInput<Real> &in)
{
    using std::abs, std::asin, std::cos, std::sin, std::sqrt;
    ExactState<Real> out;
    out.values.fill(Real(0));
    const auto value = [&out](Coordinate coordinate, Order order) -> Real & {
        return out.values[indexOf({coordinate, order})];
    };

    const Real theta2 = in.omega2 * in.t + in.theta20;
    const Real sin2 = sin(theta2);
    const Real cos2 = cos(theta2);
    const Real h = in.c - in.a * sin2;
    out.clearance = (in.b - abs(h)) / in.b;
    if (out.clearance < 0) {
        out.status = Status::NotAssemblable;
        return out;
    }
    const bool open = in.branch == Branch::Open;
    const Real sin3 = h / in.b;
    const Real root = sqrt((in.b - h) * (in.b + h)) / in.b;
    const Real cos3 = open ? root : Real(-root);
    out.cosTheta3 = cos3;

    const Real half = Real(1) / 2;
    const Real steepness = asin(sin3);
    value(R2x, Order::Position) = half * in.a * cos2;
    value(R2y, Order::Position) = half * in.a * sin2;
    value(Theta2, Order::Position) = theta2;
    value(R3x, Order::Position) = in.a * cos2 + half * in.b * cos3;
    value(R3y, Order::Position) = in.a * sin2 + half * in.b * sin3;
    value(Theta3, Order::Position) = open ? steepness : Real(boost::math::constants::pi<Real>() - steepness);
    value(R4x, Order::Position) = in.a * cos2 + in.b * cos3;
    value(R4y, Order::Position) = in.c;
    if (cos3 == 0) {
        out.status = Status::Singular;
        return out;
    }

    const Real w = in.omega2;
    const Real w3 = -in.a * w * cos2 / (in.b * cos3);
    value(R2x, Order::Velocity) = -half * in.a * w * sin2;
    value(R2y, Order::Velocity) = half * in.a * w * cos2;
    value(Theta2, Order::Velocity) = w;
    value(R3x, Order::Velocity) = -in.a * w * sin2 - half * in.b * sin3 * w3;
    value(R3y, Order::Velocity) = in.a * w * cos2 + half * in.b * cos3 * w3;
    value(Theta3, Order::Velocity) = w3;
    value(R4x, Order::Velocity) = -in.a * w * sin2 - in.b * sin3 * w3;

    const Real alpha3 = (in.a * w * w * sin2 + in.b * sin3 * w3 * w3) / (in.b * cos3);
    value(R2x, Order::Acceleration) = -half * in.a * w * w * cos2;
    value(R2y, Order::Acceleration) = -half * in.a * w * w * sin2;
    value(R3x, Order::Acceleration) = -in.a * w * w * cos2 - half * in.b * (cos3 * w3 * w3 + sin3 * alpha3);
    value(R3y, Order::Acceleration) = -in.a * w * w * sin2 - half * in.b * (sin3 * w3 * w3 - cos3 * alpha3);
    value(Theta3, Order::Acceleration) = alpha3;
    value(R4x, Order::Acceleration) = -in.a * w * w * cos2 - in.b * cos3 * w3 * w3 - in.b * sin3 * alpha3;
    return out;
}

template <class Real>
ExactState<Real> exactState(const Parameters &parameters, double t)
{
    return exactState(ExactInput<Real>(parameters, t));
}

/// κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t: how far each channel moves, per unit of relative error in what it is
/// computed from. Where such an error could end the motion (closer to a limit than `step`), infinite.
template <class Real>
std::array<double, kChannelCount> conditioning(const Parameters &parameters, double t)
{
    using std::abs;
    const Real step = 1e-25;
    const ExactInput<Real> in(parameters, t);
    std::array<double, kChannelCount> kappa{};
    for (Real ExactInput<Real>::*member :
         {&ExactInput<Real>::a, &ExactInput<Real>::b, &ExactInput<Real>::c, &ExactInput<Real>::omega2,
          &ExactInput<Real>::theta20, &ExactInput<Real>::t}) {
        ExactInput<Real> more = in;
        ExactInput<Real> less = in;
        more.*member *= 1 + step;
        less.*member *= 1 - step;
        const ExactState<Real> above = exactState(more);
        const ExactState<Real> below = exactState(less);
        const bool exists = above.status == Status::Solved && below.status == Status::Solved;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            kappa[index] += exists ? static_cast<double>(abs(above.values[index] - below.values[index]) / (2 * step))
                                   : std::numeric_limits<double>::infinity();
        }
    }
    return kappa;
}

/// Of naturalSize(): what is less than this is zero, but for the judge's own rounding.
inline constexpr double kExactZero = 1e-36;

// Compiled once, in exact_motion.cpp: these take their time.
extern template ExactState<Digits50> exactState(const ExactInput<Digits50> &);
extern template ExactState<Digits100> exactState(const ExactInput<Digits100> &);
extern template std::array<double, kChannelCount> conditioning<Digits50>(const Parameters &, double);
extern template std::array<double, kChannelCount> conditioning<Digits100>(const Parameters &, double);

} // namespace slidercrank
