// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads which positions `solve` computes, if they are not equal time steps: --at, --at-angle, --step-angle, --when and
// --omega2-for. All functions throw UsageError.

#include "app/option_groups.h"
#include "core/limits/output_channel.h"
#include "ui/text/units.h"

#include <vector>

namespace slidercrank
{

/// Positions of a mechanism, by the times at which they occur.
struct Positions {
    Mechanism mechanism;            ///< with --omega2-for, its crank speed is the computed one
    std::vector<double> timeStamps; ///< s
};

/// Returns the positions that the options ask for, in the order of the output; none if they ask for time steps. A crank
/// that turns has all of them in one element. A crank that stands still has an element for each position, whose
/// mechanism has the crank angle at all times. Reports the crank speed that --omega2-for finds.
std::vector<Positions> readPositions(const OptionReader &options, const Mechanism &mechanism, const Units &units,
                                     const Streams &streams);

/// Reads --length-unit and --angle-unit.
Units readUnits(const OptionReader &options, const Units &defaults = {});

/// Reads --alpha2 (rad/s²), which applies to positions only.
double readCrankAcceleration(const OptionReader &options);

/// Parses the name of a channel of the output, or its symbol in textbooks.
OutputChannel parseOutputChannel(const QString &name);

/// Parses such a name in the value of an option, such as "when". The error message names the option.
OutputChannel parseOutputChannel(const char *option, const QString &name);

} // namespace slidercrank
