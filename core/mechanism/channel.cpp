// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/channel.h"

#include "core/mechanism/enum_table.h"

#include <cmath>

namespace slidercrank
{

namespace
{

struct CoordinateNames {
    Coordinate key;
    std::string_view position;
    std::string_view velocity;
    std::string_view acceleration;
};
constexpr CoordinateNames kNames[] = {
    {R1x, "R1_x", "R1_x_diff", "R1_x_diff2"},          {R1y, "R1_y", "R1_y_diff", "R1_y_diff2"},
    {Theta1, "theta1", "theta1_diff", "theta1_diff2"}, {R2x, "R2_x", "R2_x_diff", "R2_x_diff2"},
    {R2y, "R2_y", "R2_y_diff", "R2_y_diff2"},          {Theta2, "theta2", "theta2_diff", "theta2_diff2"},
    {R3x, "R3_x", "R3_x_diff", "R3_x_diff2"},          {R3y, "R3_y", "R3_y_diff", "R3_y_diff2"},
    {Theta3, "theta3", "theta3_diff", "theta3_diff2"}, {R4x, "R4_x", "R4_x_diff", "R4_x_diff2"},
    {R4y, "R4_y", "R4_y_diff", "R4_y_diff2"},          {Theta4, "theta4", "theta4_diff", "theta4_diff2"}};
static_assert(isCompleteTable(kNames, Theta4));

} // namespace

ChannelSet allChannels()
{
    return ChannelSet().set();
}

ChannelSet plottedChannels()
{
    ChannelSet set;
    for (const Channel channel : kPlottedChannels) {
        set.set(indexOf(channel));
    }
    return set;
}

std::string_view nameOf(Channel channel)
{
    const CoordinateNames &names = rowOf(kNames, channel.coordinate);
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return names.velocity;
    case Order::Acceleration: return names.acceleration;
    }
    return names.position;
}

std::optional<Channel> channelNamed(std::string_view name)
{
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        if (nameOf(channelAt(index)) == name) {
            return channelAt(index);
        }
    }
    return std::nullopt;
}

std::string_view fileUnit(Channel channel)
{
    const bool isAngular = isAngle(channel.coordinate);
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return isAngular ? "°/s" : "mm/s";
    case Order::Acceleration: return isAngular ? "°/s²" : "mm/s²";
    }
    return isAngular ? "°" : "mm";
}

double naturalSize(const Parameters &parameters, Channel channel)
{
    const double position = isAngle(channel.coordinate) ? 1.0 : characteristicLength(parameters);
    return position * std::pow(std::abs(parameters.omega2), static_cast<int>(channel.order));
}

} // namespace slidercrank
