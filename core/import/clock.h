// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a file's instants are worth: they are rounded like any other number, and the motion has moved on by what that
// leaves out. Where all of them are equally far apart nothing has been lost in between: 0, 0.005, 0.01 are what the
// program that wrote the file meant, though 0, 0.0133, 0.0266 may have been 0, 0.013303, 0.026606. Where they are but
// for their rounding (0, 0.033, 0.067, 0.1), they were rounded; and where they are not at all (0, 0.1, 0.25, 1),
// somebody may have chosen them.

#include "core/import/rounding.h"

#include <span>

namespace slidercrank
{

struct ReferenceData;

struct Clock {
    /// s: what the instants were rounded to, where it is largest; of an even clock, whose digits tell nothing, the last
    /// place printed. 0: unknown.
    double printedStep = 0.0;
    bool even = true;     ///< all differences are equal, as far as a double tells or to 1e-3 of the step
    bool rounded = false; ///< not even, but what rounding makes of instants that are: ten of them at least

    /// What the instants are off by is to be taken as within half of this, s.
    double step() const { return even ? 0.0 : printedStep; }
};

/// `time`: s, increasing.
Clock clockOf(std::span<const double> time, const Rounding &rounding);

Clock clockOf(const ReferenceData &data);

} // namespace slidercrank
