// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How one column of a file would have to be read to be one channel of a motion: its unit, its sign, its zero.

#include "core/mechanism/channel.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace slidercrank
{

inline constexpr std::array<double, 2> kTimeUnits{1e-3, 1e3}; ///< ms read as s, s read as ms

/// Fewer numbers could agree by chance.
inline constexpr std::size_t kFewestValues = 8;

/// How a column's numbers become a channel's: multiplied, then made continuous, then turned.
struct UnitAndSense {
    double unit = 1.0;     ///< of angle or length
    double timeUnit = 1.0; ///< of a derivative's time, with its power
    double sign = 1.0;
    bool turned = false;
    double turn = 0.0; ///< degrees

    double misfit = std::numeric_limits<double>::infinity(); ///< largest error as part of the channel's size

    double factor() const { return sign * unit * timeUnit; }
    /// The time unit is a fault of the file, and none of the column.
    int steps() const { return (unit != 1.0) + (sign < 0.0) + turned; }
    bool isPlain() const { return steps() == 0 && timeUnit == 1.0; }
};

/// The reading of fewest steps that makes a column the channel, or none. `timeUnit`: that of the instants, which a
/// derivative may count in too.
std::optional<UnitAndSense> unitAndSenseOf(Channel channel, std::span<const double> values,
                                           std::span<const double> model, double timeUnit);

/// How much a channel varies; where it does not, how large it is.
double sizeOf(std::span<const double> values);

/// Takes out jumps of whole turns: between two rows no angle of the mechanism turns by half of one.
void makeContinuous(std::span<double> degrees);

/// base to the power of the channel's order.
double powerOf(double base, Channel channel);

} // namespace slidercrank
