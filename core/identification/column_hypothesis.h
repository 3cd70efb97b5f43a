// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ways to read one column, each with its price.

#include "core/identification/observations.h"

#include <array>
#include <cstddef>
#include <span>

namespace slidercrank
{

inline constexpr std::array<double, 2> kAngleFactors{kDegreesPerRadian, 1.0 / kDegreesPerRadian};

/// A column that is farther off than that, as part of its spread, is not explained.
inline constexpr double kExplained = 0.1;

inline constexpr double kPriceOfCause = 20.0;
inline constexpr double kPriceOfColumn = 4.0;
inline constexpr double kPriceOfHalfTurn = 14.0; // half a turn must beat a free zero point of 180.0°

/// How one column is read.
struct ColumnHypothesis {
    Channel channel;
    double unit = 1.0; ///< of angle or length: multiplies
    double sign = 1.0;
    bool isPerSecond = false; ///< a derivative in seconds, where the instants are in another unit
    bool isTurned = false;    ///< an angle, by half a turn
    bool isZeroFree = false;
    bool isUsed = true;

    friend bool operator==(const ColumnHypothesis &, const ColumnHypothesis &) = default;
};

/// A column against a channel of a model, in the author's units.
class ColumnMatch
{
public:
    ColumnMatch(const ObservedColumn &column, Channel channel, std::span<const double> model);

    /// n ln(mean r² / spread²); 0 where that is not explained.
    double score(double factor, bool isTurned, bool isZeroFree) const;

    double count() const { return m_n; }
    double factor() const; ///< that brings the column nearest to the model
    double factorAboutMeans() const;
    double correlation() const;

private:
    double meanOfTurning(double factor, bool isTurned, bool isZeroFree) const;

    const ObservedColumn &m_column;
    Channel m_channel;
    std::span<const double> m_model;
    double m_n = 0.0, m_y = 0.0, m_m = 0.0, m_yy = 0.0, m_mm = 0.0, m_my = 0.0;
};

/// How well a column read so meets a model.
struct Scored {
    ColumnHypothesis column;
    double score = 0.0; ///< n ln …, without prices
    double price = 0.0;

    double total() const { return score + price; }
};

/// The best way to read a column as a channel, and the plain ones with and without a free zero point.
struct Ways {
    Scored best;
    Scored plain;
    Scored shifted;
};

/// `model`: the channel at the column's rows, in the author's unit. `timeUnit`: seconds that a unit of the file's time
/// is. `values`: how many the whole file has.
Ways waysOf(const ObservedColumn &column, Channel channel, std::span<const double> model, double timeUnit,
            std::size_t values);

} // namespace slidercrank
