// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rows of reference data made ready for least squares: the columns that a mechanism can say anything about, with what
// is known of each value's error before any mechanism is fitted.

#include "core/identification/sensitivity.h"
#include "core/import/clock.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <span>
#include <vector>

namespace slidercrank
{

/// What lengths, times and instants are counted in while fitting, so that no number is far from 1 whatever the size of
/// the mechanism and wherever its clock starts.
struct FitUnits {
    double mm = 1.0;     ///< unit of length
    double second = 1.0; ///< unit of time
    double origin = 0.0; ///< instant (s) that counts as 0

    Parameters toFit(const Parameters &parameters) const;
    Parameters fromFit(const Parameters &parameters) const; ///< a, b > 0, θ20 in (-π, π]

    /// What a value of the author's unit is to be multiplied by.
    double factor(Channel channel) const;

    double timeOf(double seconds) const { return (seconds - origin) / second; }
};

/// One column at the rows of an Observations, in the author's unit.
struct ObservedColumn {
    Channel channel;              ///< what the file calls it
    std::vector<double> values;   ///< NaN: none; θ3 without jumps of whole turns
    std::vector<double> variance; ///< of their rounding, times the repetition
    std::size_t count = 0;
    double repetition = 1.0; ///< how many rows count for one
    double mean = 0.0;
    double spread = 0.0; ///< standard deviation, or the step of a column that never changes
    double step = 0.0;   ///< the largest
    bool varies = false;
    bool hasJumps = false; ///< of whole turns, that were taken out
};

/// Some rows of the data.
struct Observations {
    FitUnits units;
    std::vector<double> time; ///< in FitUnits
    double clockStep = 0.0;   ///< of the instants' rounding, in FitUnits; 0 where they are evenly spaced
    double printedClockStep = 0.0;
    std::vector<ObservedColumn> columns;

    bool has(Channel channel) const;
    bool has(Coordinate coordinate) const; ///< in any order
    bool hasPositionOnly() const;          ///< no derivative, and nothing of θ2
    std::size_t valueCount() const;
};

bool isPlotted(Channel channel);

/// Some rows of a file, of which `count` have a value that says something.
struct RowRange {
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t count = 0;
};

/// From the first with a value to the last.
RowRange rowsOf(const ReferenceData &data);
RowRange counted(const ReferenceData &data, std::size_t first, std::size_t end);

/// At most so many of those with a value, evenly spread.
std::vector<std::size_t> spreadOver(const ReferenceData &data, const RowRange &range, std::size_t most);

/// At most so many of the rows, evenly spread.
std::vector<std::size_t> thinned(std::span<const std::size_t> rows, std::size_t most);

/// `length` (mm): the unit of length where the file holds none.
FitUnits unitsFor(const ReferenceData &data, std::span<const std::size_t> rows, double length);

/// Columns with fewer than two values in these rows are left out, and those that every mechanism has as zeros.
///
/// The rounding's variance is that of a uniform distribution over the step. Rows that repeat do not round
/// independently: what is left of n such rows is as many as there are runs, or two of each run of the same difference.
/// A value that happens to be next to nothing, as a position counted from its start, is known no better than a
/// hundredth of the column's largest step.
Observations observe(const ReferenceData &data, const Clock &clock, const FitUnits &units,
                     std::span<const std::size_t> rows);

} // namespace slidercrank
