// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the columns of a file should contain: a mechanism, the motion of its crank, and the reading of each column,
//
//     value in the file = factor · motion + origin.
//
// The angle of the crank follows from the time, θ2 = ω2 t + θ20, or from the angle in the file, θ2 = factor · angle +
// θ20. Its speed, which derivatives need, is ω2 + α2 t. Only a run-up has an angular acceleration α2 other than 0, and
// its angle is always that in the file. Over the time, the angle may also have a ripple. Lengths are in mm, angles in
// rad, time in s; t is zero in the middle of the file.

#include "core/identification/observations.h"

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/mechanism.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slidercrank
{

/// How a column has to be read (see above). The factor is ±1 times a unit conversion.
struct ColumnReading {
    double factor = 1.0;
    double origin = 0.0; ///< the value in the file where the motion is zero

    friend bool operator==(const ColumnReading &, const ColumnReading &) = default;
};

/// The multiple of half a turn that is nearest to the origin of a column of angles. `factor`: that of its reading.
inline double nearestHalfTurns(double origin, double factor)
{
    const double halfTurn = kHalfTurn * factor;
    return halfTurn * std::rint(origin / halfTurn);
}

/// An oscillation of the angle of the crank, once per turn: cosine · cos φ + sine · sin φ (rad) at the phase φ = ω2 t.
/// It occurs if the speed of the crank varies with the load.
struct Ripple {
    double cosine = 0.0;
    double sine = 0.0;

    bool isZero() const { return cosine == 0.0 && sine == 0.0; }
    double angle(double phase) const { return cosine * std::cos(phase) + sine * std::sin(phase); }

    /// The derivative of the angle by the phase.
    double derivative(double phase) const { return sine * std::cos(phase) - cosine * std::sin(phase); }
};

/// A mechanism with the motion of its crank and the readings of the columns.
struct Model {
    /// θ20: the angle of the crank at t = 0 of the observations (the middle of the file) or, if followsAngle, where the
    /// angle in the file is zero.
    Parameters mechanism{};
    bool followsAngle = false;             ///< θ2 follows from the angle in the file
    double angleFactor = 1.0;              ///< factor of the angle in the file: ±1 times a unit conversion
    double alpha2 = 0.0;                   ///< angular acceleration of the crank, rad/s²
    Ripple ripple{};                       ///< zero if followsAngle
    bool isApproximateFormula = false;     ///< R4_x is that of the approximate formula (computeUnitSpeedMotion())
    std::vector<ColumnReading> readings{}; ///< reading of each column of the observations

    /// The angle of the crank in a row, rad.
    double crankAngle(const Observations &observations, Index row) const
    {
        if (followsAngle) {
            return mechanism.theta20 + angleFactor * observations.angle.values[row];
        }
        const double phase = mechanism.omega2 * observations.time.values[row];
        return mechanism.theta20 + phase + (ripple.isZero() ? 0.0 : ripple.angle(phase));
    }

    /// The speed of the crank in a row, rad/s.
    double crankSpeed(const Observations &observations, Index row) const
    {
        double speed = mechanism.omega2;
        if (alpha2 != 0.0) {
            speed += alpha2 * observations.time.values[row];
        }
        if (!ripple.isZero()) {
            speed += mechanism.omega2 * ripple.derivative(mechanism.omega2 * observations.time.values[row]);
        }
        return speed;
    }

    /// The angular acceleration of the crank in a row, rad/s².
    double crankAcceleration(const Observations &observations, Index row) const
    {
        const double w = mechanism.omega2;
        return alpha2 - (ripple.isZero() ? 0.0 : w * w * ripple.angle(w * observations.time.values[row]));
    }
};

/// Whether the coupler or c is so much longer than the crank that its length hardly shows in the motion.
inline bool hidesLengths(const Parameters &mechanism)
{
    constexpr double kMaxRatio = 100.0; // to the crank
    return std::max(mechanism.b, std::abs(mechanism.c)) > kMaxRatio * mechanism.a;
}

/// Replaces R4_x and its derivatives by those of the approximate formula in the chapter on engines of the textbook
/// (R. L. Norton, "Design of Machinery"): b cos θ3 = √(b² - h²) ≈ b - h²/2b with h = b sin θ3. `b`: mm.
template <class Number>
void approximateSlider(TextbookMotion<Number> &motion, const Number &b)
{
    using Motion = TextbookMotion<Number>;
    const Number &h = motion.height; // c - y of the crank pin
    const Number &velocityY = motion.pinY[Motion::kVelocity];
    const Number &accelerationY = motion.pinY[Motion::kAcceleration];
    const Number reach = b - 0.5 * h * h / b; // |b cos θ3|
    const Number velocityOfReach = h * velocityY / b;
    const Number accelerationOfReach = (h * accelerationY - velocityY * velocityY) / b;
    motion.sliderX[Motion::kPosition] = motion.pinX[Motion::kPosition] + motion.side * reach;
    motion.sliderX[Motion::kVelocity] = motion.pinX[Motion::kVelocity] + motion.side * velocityOfReach;
    motion.sliderX[Motion::kAcceleration] = motion.pinX[Motion::kAcceleration] + motion.side * accelerationOfReach;
}

/// Computes the positions of a mechanism at one angle of the crank (rad), and their derivatives by this angle.
/// `lengths`: a, b, c (mm). `isApproximateFormula`: R4_x is that of approximateSlider(). `Number`: double or a type
/// with partial derivatives. Returns false if the mechanism cannot be assembled there or is singular.
template <class Number>
bool computeUnitSpeedMotion(TextbookMotion<Number> &motion, Branch branch, const std::array<Number, 3> &lengths,
                            const Number &crankAngle, bool isApproximateFormula)
{
    // At a speed of one radian per second, the derivatives with respect to the time are those with respect to the
    // angle.
    const Number omega2(1.0);
    const Number theta20(0.0);
    const auto &[a, b, c] = lengths;
    if (!motion.compute({a, b, c, omega2, theta20}, crankAngle, branch == Branch::Open ? 1.0 : -1.0)) {
        return false;
    }
    if (isApproximateFormula) {
        approximateSlider(motion, b);
    }
    return true;
}

/// The motion of a channel at a speed ω (rad/s) and an angular acceleration α (rad/s²) of the crank. With the
/// derivatives f' and f'' with respect to the angle of the crank, a position is f, a velocity f'ω, and an acceleration
/// f''ω² + f'α.
template <class Number>
Number motionAtSpeed(const TextbookMotion<Number> &motion, Channel channel, double speed, double acceleration)
{
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return Number(motion.valueAt(channel) * speed);
    case Order::Acceleration:
        const Number byAcceleration = motion.valueAt({channel.coordinate, Order::Velocity});
        return Number(motion.valueAt(channel) * (speed * speed) + byAcceleration * acceleration);
    }
    return motion.valueAt({channel.coordinate, Order::Position});
}

/// The motion of the model in each row (mm, rad, s), without the readings: a column for each of `columns`. NaN where
/// the mechanism cannot be assembled or is singular, and in the remaining rows if the observations request a stop.
Eigen::ArrayXXd computeMotion(const Model &model, const Observations &observations, const Indices &columns);

/// The values that some columns should contain: factor · motion + origin. Otherwise like computeMotion().
Eigen::ArrayXXd predictValues(const Model &model, const Observations &observations, const Indices &columns);

} // namespace slidercrank
