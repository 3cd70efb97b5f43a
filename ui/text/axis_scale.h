// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where an axis has its ticks and how their numbers are written, so that labels stay short whatever the size of the
// values: very large and very small ones share a power of a thousand, which goes to the unit ("[10⁻³ %]").

#include "ui/text/interval.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace slidercrank
{

struct AxisScale {
    double step = 1.0; ///< between ticks: 1, 2 or 5 times a power of ten
    int exponent = 0;  ///< labels show value / 10^exponent; a multiple of 3
    int decimals = 0;
    bool isLogarithmic = false; ///< values are decimal logarithms; labels are powers of ten

    QString label(double value, const QLocale &locale) const;

    /// "mm", or "10³ mm".
    QString unit(const QString &unit) const;

    /// Of the longest label in that range.
    int labelLength(const Interval &range) const;

    friend bool operator==(const AxisScale &, const AxisScale &) = default;
};

/// About that many intervals between ticks, at least one.
AxisScale axisScale(const Interval &range, double intervals);

/// For degrees: parts and multiples of a turn where ticks are more than a few degrees apart.
AxisScale degreeScale(const Interval &range, double intervals);

/// For decimal logarithms: whole decades.
AxisScale logarithmicScale(const Interval &range, double intervals);

/// The range widened a little and rounded outwards, so that the axis stands still while the values change a little.
/// A range without length gets one.
Interval roundedOutwards(const Interval &range);

} // namespace slidercrank
