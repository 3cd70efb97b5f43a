// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data of a reference file as the fits need them: columns in mm, rad and s, each value with the variance of its
// rounding, and an abscissa that is zero in the middle of the file.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace slidercrank
{

/// Properties of a column, computed from all rows. A selection of rows keeps them.
struct ColumnStatistics {
    Channel channel; ///< by its heading
    double mean = 0.0;
    double spread = 0.0; ///< standard deviation
    double range = 0.0;  ///< largest minus smallest value
    double step = 0.0;   ///< largest rounding step
    double meanVariance = 0.0;
    double unitOfHeading = 1.0; ///< in the default unit
    bool varies = false;
    bool hadJumps = false; ///< jumps by whole turns were removed from an angle
};

struct ObservedColumn : ColumnStatistics {
    std::vector<double> values;    ///< NaN where there is a gap
    std::vector<double> variances; ///< of the rounding, times the number of rows that are one independent observation
    double count = 0.0;            ///< number of values
};

/// Computes count, mean, range and spread of a column from its values. If it has none, only the count has a meaning.
void learnSpread(ObservedColumn &column);

/// Whether a column contains information on the shape of the motion: it varies, and its channel depends on more than
/// the crank angle or the offset.
bool tellsShape(const ObservedColumn &column);

/// Whether the column is a derivative that tells the shape.
bool isShapeDerivative(const ObservedColumn &column);

inline bool isLength(Channel channel)
{
    return !isAngle(channel.coordinate);
}

inline bool isPlotted(Channel channel)
{
    return channel.coordinate == R4x || channel.coordinate == Theta3;
}

/// Whether a channel is constant in every mechanism but depends on it: R4y and the crank speed.
bool isConstantByNature(Channel channel);

struct Observations {
    std::vector<double> abscissa; ///< time in s, or the crank angle in rad, minus `origin`
    double origin = 0.0;
    bool isByCrankAngle = false;
    double step = 0.0;             ///< rounding step of the abscissa; 0 if the abscissa is even
    double printedStep = 0.0;      ///< rounding step of the abscissa as printed
    double unitOfHeading = 1.0;    ///< of the abscissa, in the default unit
    std::vector<std::size_t> rows; ///< indices in the file
    std::vector<ObservedColumn> columns;

    double span() const { return abscissa.back() - abscissa.front(); }

    /// The shortest distance of two rows, adjusted so that the span is a whole multiple of it.
    double interval() const;
};

/// Takes all rows that contain a value and all columns that depend on the mechanism. Values of a saturated sensor (many
/// equal extreme values with a sudden edge) become gaps.
Observations observe(const ReferenceData &data);

/// The values at some indices.
template <class T>
std::vector<T> valuesAt(const std::vector<T> &values, std::span<const std::size_t> indices)
{
    std::vector<T> chosen;
    chosen.reserve(indices.size());
    for (const std::size_t index : indices) {
        chosen.push_back(values[index]);
    }
    return chosen;
}

/// The index of the column of a channel; the number of columns if there is none.
template <class Column>
std::size_t columnIndex(const std::vector<Column> &columns, Channel channel)
{
    return static_cast<std::size_t>(std::ranges::find(columns, channel, &Column::channel) - columns.begin());
}

/// Takes some rows only. `rows` must be increasing.
Observations selection(const Observations &all, std::span<const std::size_t> rows);

/// At most `count` evenly spread rows of the first `end` rows.
std::vector<std::size_t> spreadRows(std::size_t end, std::size_t count);

/// Takes at most `count` evenly spread rows.
Observations thinned(const Observations &all, std::size_t count);

} // namespace slidercrank
