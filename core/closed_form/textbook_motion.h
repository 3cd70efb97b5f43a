// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion of an offset slider-crank by the formulas of the textbook (R. L. Norton, "Design of Machinery",
// eq. 4.16, 6.22, 7.15) with any number type: double, an automatic-differentiation type, or a type with many digits.
// With many digits it checks the closed form, with which it shares no formula. With double it loses digits near a
// toggle. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/channel.h"

#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

template <class T>
struct TextbookMotion {
    T theta2, omega2, c, pi;
    T height{}, reach{}; ///< b sin θ3 and b cos θ3
    double side;

    // Indices of a coordinate and its derivatives, which are the numbers of the enumerators of Order.
    static constexpr std::size_t kPosition = 0;
    static constexpr std::size_t kVelocity = 1;
    static constexpr std::size_t kAcceleration = 2;

    std::array<T, kOrderCount> pinX, pinY; ///< the crank pin A
    std::array<T, kOrderCount> sliderX;
    T omega3, alpha3;

    /// The parameters that the formulas use, by Parameter: a, b, c (mm) and ω2 (rad/s); θ20 is not used.
    using Numbers = std::array<T, kParameterCount>;

    /// Computes the motion at the crank angle `crankAngle` (rad). `branchSide`: 1 for the open branch, -1 for the
    /// crossed one; `valueOfPi`: π with the digits of T. Returns false if the mechanism cannot be assembled, or if it
    /// is singular; the positions are valid in the second case.
    bool compute(const Numbers &parameters, const T &crankAngle, double branchSide,
                 const T &valueOfPi = T(std::numbers::pi))
    {
        using std::cos, std::sin, std::sqrt;
        const T &a = parameters[indexOf(Parameter::A)];
        const T &b = parameters[indexOf(Parameter::B)];
        c = parameters[indexOf(Parameter::C)];
        omega2 = parameters[indexOf(Parameter::Omega2)];
        theta2 = crankAngle;
        pi = valueOfPi;
        side = branchSide;
        pinX[kPosition] = a * cos(theta2);
        pinY[kPosition] = a * sin(theta2);
        for (std::size_t k = 1; k < kOrderCount; ++k) { // the derivatives of a rotation
            pinX[k] = -(omega2 * pinY[k - 1]);
            pinY[k] = omega2 * pinX[k - 1];
        }
        height = c - pinY[kPosition];
        const T square = (b - height) * (b + height);
        if (!(square >= 0.0)) {
            return false;
        }
        reach = side * sqrt(square);
        sliderX[kPosition] = pinX[kPosition] + reach;
        if (!(square > 0.0)) {
            return false;
        }
        omega3 = -pinY[kVelocity] / reach;
        alpha3 = (height * omega3 * omega3 - pinY[kAcceleration]) / reach;
        sliderX[kVelocity] = pinX[kVelocity] - height * omega3;
        sliderX[kAcceleration] = pinX[kAcceleration] + pinY[kVelocity] * omega3 - height * alpha3;
        return true;
    }

    /// Returns θ3, which is continuous on either branch. It is computed only on request, because the arctangent takes
    /// a large part of the time.
    T theta3() const
    {
        using std::atan2;
        const T angle = atan2(T(side * height), T(side * reach));
        return side < 0.0 ? T(angle + pi) : angle;
    }

    /// Returns the value of a channel after compute(); its derivatives do not exist if compute() returned false.
    T valueAt(Channel channel) const
    {
        const auto k = static_cast<std::size_t>(channel.order);
        switch (channel.coordinate) {
        case Theta2:
            if (channel.order == Order::Position) {
                return theta2;
            }
            return channel.order == Order::Velocity ? omega2 : T(0.0);
        case Theta3:
            if (channel.order == Order::Position) {
                return theta3();
            }
            return channel.order == Order::Velocity ? omega3 : alpha3;
        case R4x: return sliderX[k];
        case R4y: return k == 0 ? c : T(0.0);
        case R3x: return T(0.5 * (pinX[k] + sliderX[k]));
        case R3y: return k == 0 ? T(0.5 * (pinY[k] + c)) : T(0.5 * pinY[k]);
        case R2x: return T(0.5 * pinX[k]);
        case R2y: return T(0.5 * pinY[k]);
        case R1x:
        case R1y:
        case Theta1:
        case Theta4: break;
        }
        return T(0.0);
    }
};

} // namespace slidercrank
