// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A reference file as the engine sees it: columns of numbers in mm, rad and s, each value with the variance that its
// rounding leaves, over an abscissa that is counted from the middle of the file.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"

#include <cstddef>
#include <span>
#include <vector>

namespace slidercrank
{

/// What all rows of a column tell; a selection of rows keeps it.
struct ColumnStatistics {
    Channel channel; ///< what its heading says
    double mean = 0.0;
    double spread = 0.0; ///< standard deviation
    double range = 0.0;  ///< largest less smallest value
    double step = 0.0;   ///< largest rounding step
    double meanVariance = 0.0;
    bool varies = false;
    bool hadJumps = false; ///< an angle that jumped by whole turns, and is continuous here
};

struct ObservedColumn : ColumnStatistics {
    std::vector<double> values;    ///< NaN where there is a gap
    std::vector<double> variances; ///< of the rounding, times the number of rows that count as one observation
    double count = 0.0;            ///< number of values
};

/// Channels that tell the shape of the motion: they vary, and do not follow from the crank angle or the offset alone.
bool tellsShape(const ObservedColumn &column);

inline bool isLength(Channel channel)
{
    return !isAngle(channel.coordinate);
}

/// Channels that every mechanism keeps constant: R4y and the crank's speed.
bool isConstantByNature(Channel channel);

struct Observations {
    std::vector<double> abscissa; ///< time in s, or the crank angle in rad, less `origin`
    double origin = 0.0;
    bool isByCrankAngle = false;
    bool hasSaturation = false;    ///< values of a saturated sensor were made gaps
    double step = 0.0;             ///< rounding of the abscissa that counts: 0 where it is even
    double printedStep = 0.0;      ///< rounding of the abscissa as it is printed
    std::vector<std::size_t> rows; ///< of the file
    std::vector<ObservedColumn> columns;

    double span() const { return abscissa.back() - abscissa.front(); }
    bool isEmpty() const { return abscissa.size() < 2; }

    /// The shortest interval between two rows, such that a whole number of them makes the span.
    double interval() const;
};

/// All rows that hold a value, and all columns that say something about a mechanism. Values of a saturated sensor (many
/// equal extreme values with a sudden edge) are gaps.
Observations observe(const ReferenceData &data);

/// The observations of some rows only, in rising order.
Observations selection(const Observations &all, std::span<const std::size_t> rows);

/// The observations of at most `count` rows, evenly spread.
Observations thinned(const Observations &all, std::size_t count);

} // namespace slidercrank
