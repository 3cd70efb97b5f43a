// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quantities of a slider-crank that follow from its 12 coordinates, with their first and second time derivatives. They
// are output only: files that are read have no such columns. Lengths in mm, angles in rad, time in s.
//
//     transmission angle   μ = atan2(|b cos θ3|, |b sin θ3|), the acute angle between the coupler and the normal to the
//                          slider's line, 90° - |θ3| on the open branch. It has a kink at 90°, where the coupler is
//                          parallel to the slider's line: its derivatives do not exist there
//     displacement         distance of the slider from the outer dead centre, >= 0
//     A_x, A_y             position of the crank pin A
//
// Source: R. L. Norton, "Design of Machinery", sections 3.3 and 4.10 (transmission angle).

#include "core/mechanism/measure.h"
#include "core/mechanism/state.h"

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

enum class DerivedQuantity { TransmissionAngle, Displacement, PinX, PinY };
inline constexpr std::array<DerivedQuantity, 4> kDerivedQuantities{
    DerivedQuantity::TransmissionAngle, DerivedQuantity::Displacement, DerivedQuantity::PinX, DerivedQuantity::PinY};

/// A derived quantity, or its first or second time derivative.
struct DerivedChannel {
    DerivedQuantity quantity = DerivedQuantity::TransmissionAngle;
    Order order = Order::Position;

    friend bool operator==(const DerivedChannel &, const DerivedChannel &) = default;
};

inline constexpr std::size_t kDerivedChannelCount = kOrderCount * kDerivedQuantities.size();

constexpr std::size_t indexOf(DerivedChannel channel)
{
    return static_cast<std::size_t>(channel.order) * kDerivedQuantities.size() +
           static_cast<std::size_t>(channel.quantity);
}

/// Everything that `solve` and the tables can show: one of the 36 channels, or a quantity derived from them.
using OutputChannel = std::variant<Channel, DerivedChannel>;

/// Returns all output channels: positions, then first, then second derivatives; within each order, coordinates first.
std::vector<OutputChannel> allOutputChannels();

/// Returns the name of the channel in files: "R4_x_diff", "transmission_angle", "displacement_diff2".
std::string_view nameOf(const OutputChannel &channel);

/// Returns the output channel with this name, or with this symbol of a textbook: x, v, a or x_B, v_B, a_B of the
/// slider, omega3, alpha3, mu for the transmission angle, s for the displacement. Greek letters and indices may be
/// written as such: ω₃, ω3, omega_3. Otherwise nullopt.
std::optional<OutputChannel> outputChannelNamed(std::string_view name);

Order orderOf(const OutputChannel &channel);

/// Returns the same quantity as its position, velocity or acceleration.
OutputChannel withOrder(OutputChannel channel, Order order);

Measure measureOf(const OutputChannel &channel);

/// A quantity with its first and second time derivatives.
struct QuantityMotion {
    double position = kNone;
    double velocity = kNone;
    double acceleration = kNone;

    double at(Order order) const;
};

/// The derived quantities at one time. Values that do not exist are NaN.
struct DerivedState {
    QuantityMotion transmissionAngle;
    QuantityMotion displacement;
    QuantityMotion pinX;
    QuantityMotion pinY;

    const QuantityMotion &motionOf(DerivedQuantity quantity) const;
};

/// Computes the derived quantities. `adjacent`: b cos θ3 (mm), which near a toggle is more accurate than the cosine of
/// the rounded θ3.
DerivedState derivedState(const Mechanism &mechanism, const State &state, double adjacent);

/// All output channels at one time.
struct OutputState {
    State state;
    DerivedState derived;

    double valueOf(const OutputChannel &channel) const; ///< mm, rad, s
};

/// Returns 0 instead of a value (mm, rad, s) that is only a rounding error: below 1e-12 of the channel's natural size.
/// `mechanism`, `alpha2` (rad/s²): the motion that has the value.
double withoutNoise(double value, const OutputChannel &channel, const Mechanism &mechanism, double alpha2 = 0.0);

/// Returns the exact motion at time t (s), at which the crank has the speed ω2 and the acceleration alpha2 (rad/s²).
OutputState outputStateAt(const Mechanism &mechanism, double t, double alpha2 = 0.0);

/// Returns the same as outputStateAt(), except where the velocities jump (velocitiesJumpAt()) and at the ends of the
/// arc of a rocker. There the velocities of outputStateAt() are those of one side, or huge rounding errors: unless the
/// crank is at rest, this function returns none, and the status Singular, as Newton-Raphson does.
OutputState unambiguousStateAt(const Mechanism &mechanism, double t, double alpha2 = 0.0);

} // namespace slidercrank
