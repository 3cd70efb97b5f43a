// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Rows of reference data made ready for least squares: the six plotted channels, in units of their own size, weighted.

#include "core/identification/sensitivity.h"
#include "core/reading/reference_data.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace slidercrank
{

/// Which of the six channels hold how much.
struct Supply {
    std::size_t values = 0;                                    ///< of all six
    std::array<std::size_t, kPlottedChannels.size()> counts{}; ///< in the order of kPlottedChannels
    std::vector<std::size_t> rows;                             ///< those with any value, ascending

    bool has(Channel channel) const;
    bool has(Coordinate coordinate) const; ///< in any order
};

Supply supplyOf(const ReferenceData &data);

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

/// Time: from the first value to the last. Length: the largest |R4x|, or what its derivatives let it be; `length` (mm)
/// where there are none. The origin is 0.
FitUnits unitsFor(const ReferenceData &data, const Supply &supply, double length);

/// One of the six channels at the rows of an Observations. Weight 0: no value there.
struct ObservedChannel {
    Eigen::Index plotted = 0; ///< which, in the order of kPlottedChannels
    std::vector<double> values;
    std::vector<double> steps; ///< of the file's rounding
    std::vector<double> weights;
    double deviation = 0.0; ///< standard deviation of the values
};

/// At most so many of the rows, evenly spread.
std::vector<std::size_t> thinned(std::span<const std::size_t> rows, std::size_t most);

/// Those of ascending rows that come before `end`.
std::span<const std::size_t> rowsBefore(std::span<const std::size_t> rows, std::size_t end);

/// Some rows of the data, in FitUnits.
struct Observations {
    std::vector<double> time;
    std::vector<ObservedChannel> channels; ///< only those that the file has, and that have values in these rows
};

/// Weights are 1 / deviation: every channel counts alike.
Observations observe(const ReferenceData &data, const FitUnits &units, std::span<const std::size_t> rows);

std::size_t valueCount(const Observations &observations);

/// Without the channels that are derivatives of others that are there: positions lead a fit home from farther away.
Observations lowestOrders(Observations observations);

} // namespace slidercrank
