// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The precision of time stamps. They are rounded like any other number, and the mechanism moves during the rounding
// error. Three kinds are distinguished, whether or not some time stamps of an even sequence are missing:
//
//     0, 0.005, 0.01          evenly spaced: taken as exact. A program that wrote 0, 0.0133, 0.0266 may have meant
//                             0, 0.013303, 0.026606, but nothing shows it.
//     0, 0.033, 0.067, 0.1    evenly spaced within their rounding: they were rounded.
//     0, 0.1, 0.25, 1         uneven: they may be exact or rounded, and are treated as rounded.

#include "core/import/rounding.h"

#include <span>
#include <vector>

namespace slidercrank
{

/// How precisely the printed time stamps of a file are known.
struct TimePrecision {
    /// Largest rounding step of the time stamps, s; that of the last printed digit if they are evenly spaced, because
    /// their digits do not show the rounding. 0 if it is unknown.
    double printedStep = 0.0;

    /// The time stamps are evenly spaced, apart from gaps, within the precision of a double or 1e-3 of the rounding
    /// step.
    bool isEven = true;

    /// At least ten time stamps are evenly spaced within their rounding, but not `isEven`.
    bool isRoundedGrid = false;

    /// If `isRoundedGrid`: how many spacings each time stamp is after the first one.
    std::vector<double> gridNumbers{};

    /// Returns the rounding step of the time stamps, s: each may be off by half of it. 0 if they are exact.
    double roundingStep() const { return isEven ? 0.0 : printedStep; }
};

/// Finds the precision of time stamps, in s, which increase. `rounding`: the rule that their digits show.
TimePrecision timePrecisionOf(std::span<const double> time, const Rounding &rounding);

} // namespace slidercrank
