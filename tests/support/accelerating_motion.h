// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes all output channels of a crank that accelerates, with 115 digits. The derivatives are difference quotients
// of the positions over 1e-25 s. Lengths in mm, angles in rad, time in s.

#include "core/limits/output_channel.h"
#include "tests/support/deviation.h"

#include <map>
#include <string_view>

namespace slidercrank
{

using ExactOutputs = std::map<std::string_view, ManyDigits>; ///< values by the names of output channels

/// Returns the positions of all output channels at a crank angle; those of derived quantities follow from their
/// definitions.
inline ExactOutputs exactPositions(const Parameters &p, const ManyDigits &theta2)
{
    ExactInput in(p, 0.0);
    in.theta20 = theta2;
    const ExactState exact = exactState(in);
    ExactOutputs outputs;
    const auto positionOf = [&](Coordinate coordinate) { return exact.values[indexOf({coordinate, Order::Position})]; };
    for (std::size_t index = 0; index < static_cast<std::size_t>(kCoordinateCount); ++index) {
        outputs[nameOf(channelAt(index))] = exact.values[index];
    }
    const ManyDigits a = p.a;
    const ManyDigits pinX = a * cos(theta2);
    const ManyDigits pinY = a * sin(theta2);
    outputs["A_x"] = pinX;
    outputs["A_y"] = pinY;
    const ManyDigits outerDeadCentre = sqrt((a + p.b) * (a + p.b) - ManyDigits(p.c) * p.c);
    outputs["displacement"] = p.branch == Branch::Open ? ManyDigits(outerDeadCentre - positionOf(R4x))
                                                       : ManyDigits(positionOf(R4x) + outerDeadCentre);
    outputs["transmission_angle"] = atan2(abs(positionOf(R4x) - pinX), abs(p.c - pinY));
    return outputs;
}

/// Returns all output channels at t = 0 of a crank that accelerates, θ2 = θ20 + ω2 t + α2 t²/2.
inline ExactOutputs exactMotion(const Parameters &p, double alpha2)
{
    const ManyDigits step = 1e-25; // s
    const auto at = [&](const ManyDigits &t) {
        return exactPositions(p, ManyDigits(p.theta20 + t * p.omega2 + t * t * alpha2 / 2));
    };
    ExactOutputs outputs = at(0.0);
    const ExactOutputs before = at(ManyDigits(-step));
    const ExactOutputs after = at(step);
    ExactOutputs motion = outputs;
    for (const OutputChannel &channel : allOutputChannels()) {
        const std::string_view name = nameOf(channel);
        const std::string_view position = name.substr(0, name.find("_diff"));
        if (orderOf(channel) == Order::Velocity) {
            motion[name] = (after.at(position) - before.at(position)) / (2 * step);
        } else if (orderOf(channel) == Order::Acceleration) {
            motion[name] = (after.at(position) - 2 * outputs[position] + before.at(position)) / (step * step);
        }
    }
    return motion;
}

} // namespace slidercrank
