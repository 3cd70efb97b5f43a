// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace slidercrank
{

/// A closed interval. The caller chooses the unit.
struct Interval {
    double lower = 0.0;
    double upper = 1.0;

    double length() const { return upper - lower; }
    bool isEmpty() const { return lower > upper; }
    bool contains(double x) const { return lower <= x && x <= upper; }

    /// Extends the interval so that it contains x.
    void include(double x)
    {
        lower = std::min(lower, x);
        upper = std::max(upper, x);
    }

    friend bool operator==(const Interval &, const Interval &) = default;
};

} // namespace slidercrank
