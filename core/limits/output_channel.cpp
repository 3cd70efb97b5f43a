// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/output_channel.h"

#include "core/closed_form/crank_acceleration.h"
#include "core/closed_form/state_at.h"
#include "core/limits/crank_limit.h"
#include "core/limits/mobility.h"
#include "core/mechanism/enum_table.h"
#include "core/mechanism/find_element.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

// The displacement x of the slider from the outer dead centre, at which B has the distance a + b from O2, is a
// difference of nearly equal numbers near that dead centre. The law of cosines gives it without a cancellation. B has
// the distance d from O2, with d² = R4x² + c² = a² + b² + 2ab cos(θ3 - θ2), and d = a + b at the outer dead centre:
//
//     R_outer² - R4x² = 2ab (1 - cos(θ3 - θ2)) = 4ab sin²((θ3 - θ2)/2)
//     x = |R_outer - R4x| = 4ab sin²((θ3 - θ2)/2) / |R_outer + R4x|

namespace slidercrank
{

namespace
{

/// A symbol of textbooks for an output channel, as inPlainLetters() returns it.
struct Symbol {
    std::string_view symbol;
    std::string_view channelName;
};
constexpr std::array kSymbols{Symbol{"x", "R4_x"},
                              Symbol{"xB", "R4_x"},
                              Symbol{"Rx4", "R4_x"},
                              Symbol{"v", "R4_x_diff"},
                              Symbol{"vB", "R4_x_diff"},
                              Symbol{"v4", "R4_x_diff"},
                              Symbol{"a", "R4_x_diff2"},
                              Symbol{"aB", "R4_x_diff2"},
                              Symbol{"a4", "R4_x_diff2"},
                              Symbol{"theta2", "theta2"},
                              Symbol{"omega2", "theta2_diff"},
                              Symbol{"alpha2", "theta2_diff2"},
                              Symbol{"theta3", "theta3"},
                              Symbol{"omega3", "theta3_diff"},
                              Symbol{"alpha3", "theta3_diff2"},
                              Symbol{"s", "displacement"},
                              Symbol{"mu", "transmission_angle"}};

/// How a letter or an index may also be written.
struct Spelling {
    std::string_view spelled;
    std::string_view plain;
};
constexpr std::array kSpellings{
    Spelling{"θ", "theta"}, Spelling{"ω", "omega"}, Spelling{"α", "alpha"}, Spelling{"μ", "mu"}, // Greek
    Spelling{"µ", "mu"},                                                                         // the micro sign
    Spelling{"₂", "2"},     Spelling{"²", "2"},     Spelling{"₃", "3"},     Spelling{"³", "3"},
    Spelling{"⁴", "4"},     Spelling{"ₓ", "x"},     Spelling{"_", ""}};

/// Returns a symbol without Greek letters, raised or lowered figures and underscores: "omega3" for "ω₃".
std::string inPlainLetters(std::string_view symbol)
{
    std::string plain(symbol);
    for (const Spelling &spelling : kSpellings) {
        for (auto at = plain.find(spelling.spelled); at != plain.npos; at = plain.find(spelling.spelled)) {
            plain.replace(at, spelling.spelled.size(), spelling.plain);
        }
    }
    return plain;
}

/// The names of a quantity and of its derivatives in files.
struct DerivedNames {
    DerivedQuantity key;
    std::string_view position;
    std::string_view velocity;
    std::string_view acceleration;
};
constexpr DerivedNames kDerivedNames[] = {
    {DerivedQuantity::TransmissionAngle, "transmission_angle", "transmission_angle_diff", "transmission_angle_diff2"},
    {DerivedQuantity::Displacement, "displacement", "displacement_diff", "displacement_diff2"},
    {DerivedQuantity::PinX, "A_x", "A_x_diff", "A_x_diff2"},
    {DerivedQuantity::PinY, "A_y", "A_y_diff", "A_y_diff2"}};
static_assert(isCompleteTable(kDerivedNames, kDerivedQuantities.back()));

/// Returns a multiple of a coordinate's motion.
QuantityMotion multiple(const State &state, Coordinate coordinate, double factor)
{
    return {.position = factor * state.q[coordinate],
            .velocity = factor * state.qDot[coordinate],
            .acceleration = factor * state.qDDot[coordinate]};
}

/// Returns the transmission angle. `adjacent`: b cos θ3 (mm), as in derivedState().
QuantityMotion transmissionAngle(const Mechanism &mechanism, const State &state, double adjacent)
{
    const bool isOpen = mechanism.branch() == Branch::Open;
    const double elevation = isOpen ? state.q[Theta3] : std::numbers::pi - state.q[Theta3]; // asin(h/b)
    const double opposite = mechanism.b() * std::abs(std::sin(elevation));
    // μ = 90° - |elevation|, so that the slope dμ/d(elevation) is -1 or 1. It does not exist where the elevation is 0:
    // there μ has a kink. The elevation rises with θ3 on the open branch and falls with it on the crossed one.
    double slope = kNone;
    if (elevation > 0.0) {
        slope = -1.0;
    } else if (elevation < 0.0) {
        slope = 1.0;
    }
    QuantityMotion motion = multiple(state, Theta3, isOpen ? slope : -slope);
    motion.position = std::atan2(std::abs(adjacent), opposite);
    return motion;
}

QuantityMotion displacement(const Mechanism &mechanism, const State &state)
{
    const double side = mechanism.branch() == Branch::Open ? 1.0 : -1.0; // sign of R4x at the outer dead centre
    const MotionConstants k(mechanism);
    const double outer = std::sqrt(k.reach * k.gamma);
    const double reached = side * state.q[R4x];
    const double sine = std::sin(0.5 * (state.q[Theta3] - state.q[Theta2]));
    QuantityMotion motion = multiple(state, R4x, -side);
    motion.position =
        reached > 0.0 ? 4.0 * mechanism.a() * mechanism.b() * sine * sine / (outer + reached) : outer - reached;
    return motion;
}

} // namespace

std::vector<OutputChannel> allOutputChannels()
{
    std::vector<OutputChannel> channels;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (std::ptrdiff_t coordinate = 0; coordinate < kCoordinateCount; ++coordinate) {
            channels.emplace_back(Channel{static_cast<Coordinate>(coordinate), order});
        }
        for (const DerivedQuantity quantity : kDerivedQuantities) {
            channels.emplace_back(DerivedChannel{quantity, order});
        }
    }
    return channels;
}

std::string_view nameOf(const OutputChannel &channel)
{
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        return nameOf(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    const DerivedNames &names = rowOf(kDerivedNames, quantity);
    switch (order) {
    case Order::Position: break;
    case Order::Velocity: return names.velocity;
    case Order::Acceleration: return names.acceleration;
    }
    return names.position;
}

std::optional<OutputChannel> outputChannelNamed(std::string_view name)
{
    const std::string plain = inPlainLetters(name);
    const Symbol *symbol = findElement(kSymbols, [&plain](const Symbol &each) { return each.symbol == plain; });
    const std::string_view wanted = symbol ? symbol->channelName : name;
    for (const OutputChannel &channel : allOutputChannels()) {
        if (nameOf(channel) == wanted) {
            return channel;
        }
    }
    return std::nullopt;
}

Order orderOf(const OutputChannel &channel)
{
    return std::visit([](const auto &each) { return each.order; }, channel);
}

OutputChannel withOrder(OutputChannel channel, Order order)
{
    std::visit([order](auto &each) { each.order = order; }, channel);
    return channel;
}

Measure measureOf(const OutputChannel &channel)
{
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        return measureOf(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    return quantity == DerivedQuantity::TransmissionAngle ? angleMeasure(order) : lengthMeasure(order);
}

double QuantityMotion::at(Order order) const
{
    switch (order) {
    case Order::Position: return position;
    case Order::Velocity: return velocity;
    case Order::Acceleration: return acceleration;
    }
    return kNone;
}

const QuantityMotion &DerivedState::motionOf(DerivedQuantity quantity) const
{
    switch (quantity) {
    case DerivedQuantity::TransmissionAngle: return transmissionAngle;
    case DerivedQuantity::Displacement: return displacement;
    case DerivedQuantity::PinX: return pinX;
    case DerivedQuantity::PinY: break;
    }
    return pinY;
}

DerivedState derivedState(const Mechanism &mechanism, const State &state, double adjacent)
{
    return {.transmissionAngle = transmissionAngle(mechanism, state, adjacent),
            .displacement = displacement(mechanism, state),
            .pinX = multiple(state, R2x, 2.0), // R2 is the midpoint of O2-A
            .pinY = multiple(state, R2y, 2.0)};
}

double OutputState::valueOf(const OutputChannel &channel) const
{
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        return state.valueOf(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    return derived.motionOf(quantity).at(order);
}

double withoutNoise(double value, const OutputChannel &channel, const Mechanism &mechanism, double alpha2)
{
    constexpr double kRounding = 1e-12; // relative to the natural size of the channel
    const double length = isAngular(measureOf(channel)) ? 1.0 : characteristicLength(mechanism.parameters());
    const double rate = std::hypot(mechanism.omega2(), std::sqrt(std::abs(alpha2)));
    const double size = length * std::pow(rate, static_cast<int>(orderOf(channel)));
    return std::abs(value) < kRounding * size ? 0.0 : value;
}

OutputState outputStateAt(const Mechanism &mechanism, double t, double alpha2)
{
    OutputState output;
    output.state = ClosedForm(mechanism).stateAt(t);
    addCrankAcceleration(mechanism, t, alpha2, output.state);
    output.derived = derivedState(mechanism, output.state, ClosedForm(mechanism).motionAt(t).s);
    return output;
}

OutputState unambiguousStateAt(const Mechanism &mechanism, double t, double alpha2)
{
    if (const std::optional<OutputState> limit = crankLimitStateAt(mechanism, motionLimits(mechanism), t, alpha2)) {
        return *limit;
    }
    OutputState output = outputStateAt(mechanism, t, alpha2);
    const bool isAtRest = mechanism.omega2() == 0.0 && alpha2 == 0.0;
    if (!isAtRest && output.state.status == Status::Solved && velocitiesJumpAt(mechanism, output.state.q[Theta2])) {
        output.state.setStatus(Status::Singular);
        output.derived = derivedState(mechanism, output.state, ClosedForm(mechanism).motionAt(t).s);
    }
    return output;
}

} // namespace slidercrank
