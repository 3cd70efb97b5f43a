// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The columns of a file in mm, rad and s, with the rounding of each value, over the time and, if the file has
// it, over the angle of the crank.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"

#include <Eigen/Core>

#include <algorithm>
#include <stop_token>
#include <utility>
#include <vector>

namespace slidercrank
{

using Eigen::Index;
using Values = Eigen::ArrayXd;
using Indices = std::vector<Index>; ///< indices of rows or columns of the observations

/// R4_y: its value is c if the slider moves along x.
inline constexpr Channel kSliderLine{R4y, Order::Position};

/// Rounding errors of numbers that a program has computed and not rounded any further, relative to their size.
inline constexpr double kArithmeticError = 1e-9;

/// Fraction of the rows that may be outliers: more are no accidents.
inline constexpr double kMaxOutlierFraction = 0.05;

/// A column in mm, rad and s.
struct ObservedColumn {
    Channel channel{};
    Values values{};         ///< NaN in a gap
    Values halfSteps{};      ///< half of the rounding step of each value
    double variance = 0.0;   ///< variance of the rounding errors: the mean of step²/12
    double range = 0.0;      ///< largest minus smallest value; 0 if these differ by no more than rounding
    bool statesUnit = false; ///< the file states the unit
    bool hadJumps = false;   ///< it had jumps by whole turns, which have been removed

    // Set by withComputedColumnsMarked().
    bool isDifference = false; ///< it contains difference quotients of a column of lower order, or values that agree
                               ///< with them
    bool isPrintedDifference = false; ///< it certainly contains difference quotients: those of the printed values
    bool isInterpolated = false;      ///< its values were interpolated linearly between fewer ones, or repeat these

    bool containsAngles() const { return isAngle(channel.coordinate); } ///< angles, or derivatives of angles
    bool isDerivative() const { return channel.order != Order::Position; }
    bool isConstant() const { return range == 0.0; } ///< it repeats one value with one rounding error

    /// Sets the half steps and the variance of the rounding errors, which are distributed evenly within a step.
    void setHalfSteps(Values newHalfSteps)
    {
        halfSteps = std::move(newHalfSteps);
        variance = halfSteps.square().mean() / 3.0; // step²/12
    }
};

/// What the columns are observed over: time stamps (s) or angles of the crank (rad).
struct Abscissa {
    Values values{};  ///< empty if the file does not contain them
    Values printed{}; ///< as in the file, if observe() has replaced them by evenly spaced values; otherwise empty

    /// Half of the rounding step of the values: 0 if they are evenly spaced as printed; half of the printed step if
    /// evenly spaced values have replaced the printed ones.
    double halfStep = 0.0;

    // If evenly spaced time stamps have replaced the printed ones: how far rounding leaves their start, and the
    // distance from the first to the last one, uncertain, s.
    double startMargin = 0.0;
    double durationMargin = 0.0;
};

/// The rows and columns of a file from which its mechanism is identified.
struct Observations {
    Abscissa time;           ///< zero in the middle of the file; empty in a table over the crank angle
    double timeOrigin = 0.0; ///< time of the file at which `time` is zero, s
    Abscissa angle;          ///< θ2 as in the file, without jumps by whole turns; empty if it is not used
    double lengthUnit = 1.0; ///< the result of findLengthUnit()
    Indices rows;            ///< the index in the file of each row
    std::vector<ObservedColumn>
        columns;          ///< without those that tell nothing; θ2 only if withDriveOfFile() has made it one
    std::stop_token stop; ///< requests the end of every computation with these observations

    Index size() const { return std::ssize(rows); }
    bool hasTime() const { return time.values.size() > 0; }
    bool hasAngle() const { return angle.values.size() > 0; } ///< θ2

    /// The time or, in a table over the crank angle, the angle.
    const Values &abscissa() const { return hasTime() ? time.values : angle.values; }

    /// The distance of the first and the last row: s, or rad in a table over the crank angle.
    double span() const { return std::abs(abscissa()[size() - 1] - abscissa()[0]); }

    /// Whether all of these columns contain angles or derivatives of angles.
    bool containOnlyAngles(const Indices &columnIndices) const
    {
        return std::ranges::all_of(columnIndices, [&](Index k) { return columns[k].containsAngles(); });
    }

    /// Whether any of these columns contains a derivative.
    bool containDerivatives(const Indices &columnIndices) const
    {
        return std::ranges::any_of(columnIndices, [&](Index k) { return columns[k].isDerivative(); });
    }
};

/// Reads the observations from a file. Left out are rows without any value, rows without θ2 if most rows have it, and
/// columns that tell nothing about the mechanism: those that are zero in every mechanism, α2, and empty ones. A column
/// that changes by no more than rounding errors is kept, with a range of 0. θ2 is not used if one of the remaining rows
/// lacks it, or if the rows are too far apart to show how many turns the crank makes.
Observations observe(const ReferenceData &data, std::stop_token stop);

/// The number of rows in which all steps but the last fit search: the time of a search is proportional to it.
inline constexpr Index kSearchedRows = 400;

/// Selects at most `count` rows, one at an irregular place in each of `count` equal sections of the file: at equal
/// distances, a fast motion could look like a slow one.
Observations selectRows(const Observations &observations, Index count);

/// Replaces values that are far from the median of their neighbours by gaps (Hampel's filter: R. Pearson, "Outliers in
/// process modeling and identification", IEEE Trans. Control Syst. Technol. 10, 2002).
Observations withoutSpikes(Observations observations);

/// The unit of the lengths in a file, mm; 1 if its columns are in different units, or none is a length.
double findLengthUnit(const ReferenceData &data);

/// The median of the finite values (of an even number of values, the larger of the two in the middle); 0 if there are
/// none.
double median(const Values &values);

/// The values, with 0 in place of those that are not finite.
inline Values gapsAsZeros(const Values &values)
{
    return values.isFinite().select(values, 0.0);
}

} // namespace slidercrank
