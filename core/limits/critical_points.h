// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the critical points of functions of the crank angle over a revolution: their extrema, and the limits of the
// motion. Between two of them a function is monotone, so that its extremes over any time span are among them and the
// values at the start and at the end of that time span. Lengths in mm, angles in rad, time in s.
//
// Extrema are found as the zeros of the next derivative, not as the largest of some samples. Near a
// toggle, where the coupler is perpendicular to the slider's line, the search resolves the width of the peaks there,
// √(ε/a) rad with ε = b - a - |c|.

#include "core/mechanism/channel.h"
#include "core/mechanism/enum_table.h"

#include <array>
#include <span>
#include <vector>

namespace slidercrank
{

struct CriticalPoint {
    /// As the crank angle increases, a curve begins or ends at each limit position of a rocker. At an exact toggle,
    /// where the velocities jump, it ends and begins again.
    enum class Kind { End, Begin, Extremum };

    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< ±∞ for the derivatives at a limit position of a rocker
    Kind kind = Kind::Extremum;
};

/// The critical points of one curve, ascending by the crank angle; empty if there is no motion. The same extremum can
/// occur twice, with angles that differ by rounding only.
using CriticalPoints = std::vector<CriticalPoint>;

/// Functions of the crank angle. Every channel except the crank angle and the transmission angle is a multiple of one
/// of them plus a constant.
enum class CrankFunction {
    CouplerAngle,   ///< θ3
    SliderPosition, ///< R4x
    CouplerCentreX, ///< R3x
    PinX,           ///< a cos θ2
    PinY            ///< a sin θ2
};
inline constexpr std::size_t kCrankFunctionCount = enumeratorCount<CrankFunction::PinY>();

/// A function f of the crank angle, or its first or second derivative by the crank angle, f' or f''.
struct CrankCurve {
    CrankFunction function = CrankFunction::CouplerAngle;
    Order order = Order::Position;

    /// A crank that accelerates has the second time derivative f'' ω2² + f' α2: with the ratio α2/ω2², the curve is
    /// f'' + ratio · f'. Must be 0 unless the order is Acceleration.
    double accelerationRatio = 0.0;
};

/// Returns the critical points of each curve, with values for ω2 = 1 rad/s.
std::vector<CriticalPoints> findCriticalPoints(const Mechanism &mechanism, std::span<const CrankCurve> curves);

/// Returns the critical points of each plotted channel, in the order of kPlottedChannels.
std::array<CriticalPoints, kPlottedChannels.size()> findCriticalPoints(const Mechanism &mechanism);

} // namespace slidercrank
