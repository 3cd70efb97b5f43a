// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/channel.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr std::array<std::string_view, kChannelCount> kNames{
    "R1_x",       "R1_y",       "theta1",       "R2_x",       "R2_y",       "theta2",
    "R3_x",       "R3_y",       "theta3",       "R4_x",       "R4_y",       "theta4",
    "R1_x_diff",  "R1_y_diff",  "theta1_diff",  "R2_x_diff",  "R2_y_diff",  "theta2_diff",
    "R3_x_diff",  "R3_y_diff",  "theta3_diff",  "R4_x_diff",  "R4_y_diff",  "theta4_diff",
    "R1_x_diff2", "R1_y_diff2", "theta1_diff2", "R2_x_diff2", "R2_y_diff2", "theta2_diff2",
    "R3_x_diff2", "R3_y_diff2", "theta3_diff2", "R4_x_diff2", "R4_y_diff2", "theta4_diff2"};

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
    return kNames[indexOf(channel)];
}

std::optional<Channel> channelNamed(std::string_view name)
{
    const auto index = static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
    return index < kChannelCount ? std::optional(channelAt(index)) : std::nullopt;
}

std::string_view fileUnit(Channel channel)
{
    constexpr std::array<std::string_view, 3> kAngleUnits{"°", "°/s", "°/s²"};
    constexpr std::array<std::string_view, 3> kLengthUnits{"mm", "mm/s", "mm/s²"};
    const auto order = static_cast<std::size_t>(channel.order);
    return isAngle(channel.coordinate) ? kAngleUnits[order] : kLengthUnits[order];
}

double naturalSize(const Parameters &parameters, Channel channel)
{
    const double position = isAngle(channel.coordinate) ? 1.0 : characteristicLength(parameters);
    return position * std::pow(std::abs(parameters.omega2), static_cast<int>(channel.order));
}

} // namespace slidercrank
