// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slidercrank
{

/// Both ends belong to it. Units are those of the caller.
struct Interval {
    double lower = 0.0;
    double upper = 1.0;

    double length() const { return upper - lower; }
    bool contains(double x) const { return lower <= x && x <= upper; }
    friend bool operator==(const Interval &, const Interval &) = default;
};

} // namespace slidercrank
