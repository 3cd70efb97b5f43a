// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The 36 channels: each coordinate with its first and second time derivative, under the names that they have in files
// (R4_x, R4_x_diff, R4_x_diff2, theta3, …). Files use mm, degrees and seconds; the core uses mm, rad and seconds.

#include "core/mechanism/enum_table.h"
#include "core/mechanism/mechanism.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace slidercrank
{

/// The order of a time derivative: 0, 1 or 2.
enum class Order { Position, Velocity, Acceleration };

struct Channel {
    Coordinate coordinate = Theta3;
    Order order = Order::Position;

    friend bool operator==(const Channel &, const Channel &) = default;
};

inline constexpr std::size_t kOrderCount = enumeratorCount<Order::Acceleration>();
inline constexpr std::size_t kChannelCount = kOrderCount * kCoordinateCount; // 36

/// Returns the index of a channel, 0 … 35, in the order in which `solve` prints them: all of q, then q̇, then q̈.
constexpr std::size_t indexOf(Channel channel)
{
    return static_cast<std::size_t>(channel.order) * kCoordinateCount + static_cast<std::size_t>(channel.coordinate);
}

/// Returns the channel with that index.
constexpr Channel channelAt(std::size_t index)
{
    return {static_cast<Coordinate>(index % kCoordinateCount), static_cast<Order>(index / kCoordinateCount)};
}

/// A subset of the 36 channels. Bit indexOf(channel) tells whether it contains the channel.
using ChannelSet = std::bitset<kChannelCount>;

ChannelSet allChannels();

/// The six channels that are plotted: θ3, R4x and their derivatives. Arrays of six values have this order.
inline constexpr std::array<Channel, 6> kPlottedChannels{{{Theta3, Order::Position},
                                                          {R4x, Order::Position},
                                                          {Theta3, Order::Velocity},
                                                          {R4x, Order::Velocity},
                                                          {Theta3, Order::Acceleration},
                                                          {R4x, Order::Acceleration}}};
ChannelSet plottedChannels();

/// Returns the index of one of kPlottedChannels.
constexpr std::size_t plottedIndexOf(Channel channel)
{
    return static_cast<std::size_t>(std::ranges::find(kPlottedChannels, channel) - kPlottedChannels.begin());
}

/// Returns the name of the channel in files: "R4_x_diff".
std::string_view nameOf(Channel channel);

/// Returns the channel with exactly this name, or nullopt.
std::optional<Channel> channelNamed(std::string_view name);

constexpr bool isAngle(Coordinate coordinate)
{
    return coordinate == Theta1 || coordinate == Theta2 || coordinate == Theta3 || coordinate == Theta4;
}

constexpr bool isAlongX(Coordinate coordinate)
{
    return coordinate == R1x || coordinate == R2x || coordinate == R3x || coordinate == R4x;
}

constexpr bool isAlongY(Coordinate coordinate)
{
    return coordinate == R1y || coordinate == R2y || coordinate == R3y || coordinate == R4y;
}

/// Returns the unit of a channel in files and on the screen, UTF-8: "mm", "mm/s", "mm/s²", "°", "°/s", "°/s²".
std::string_view fileUnit(Channel channel);

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// Converts a value from the core's unit (mm, rad, s) to that of files and of the screen (mm, °, s).
constexpr double toFileUnit(Channel channel, double value)
{
    return isAngle(channel.coordinate) ? value * kDegreesPerRadian : value;
}

/// Returns the order of magnitude of a channel (mm, rad, s): (1 rad or a + b + |c|)·|ω2|^k for the k-th derivative.
/// Rounding errors are measured against it if a channel is identically zero.
double naturalSize(const Parameters &parameters, Channel channel);

} // namespace slidercrank
