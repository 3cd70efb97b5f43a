// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Chooses the ticks of an axis and the format of their labels.

#include "ui/text/interval.h"

#include <QString>

namespace slidercrank
{

struct AxisScale {
    double step = 1.0;          ///< distance between ticks: 1, 2 or 5 times a power of ten, or a part of a turn
    int digits = 6;             ///< significant digits of the labels
    bool isLogarithmic = false; ///< values are decimal logarithms; labels are powers of ten

    QString label(double value) const;

    /// Returns the number of characters of the longest label in the range.
    int labelLength(const Interval &range) const;

    friend bool operator==(const AxisScale &, const AxisScale &) = default;
};

/// Returns a scale that divides the range into about `intervals` intervals.
AxisScale axisScale(const Interval &range, double intervals);

/// Returns a scale for degrees. Ticks that are more than a few degrees apart are parts or multiples of a turn.
AxisScale degreeScale(const Interval &range, double intervals);

/// Returns a scale for decimal logarithms. Ticks are whole decades apart.
AxisScale logarithmicScale(const Interval &range, double intervals);

/// Returns the range, widened a little and rounded outwards, so that small changes of the values do not move the axis.
/// A range of length zero is widened, too.
Interval roundedOutwards(const Interval &range);

} // namespace slidercrank
