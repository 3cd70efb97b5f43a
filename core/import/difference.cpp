// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/difference.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace slidercrank
{

namespace
{

/// How far a column of rates is from the difference quotients of a column of values, and from its derivative, as sums
/// of squares.
struct Mismatch {
    std::array<double, 3> ofDifferences{}; ///< in the order of Difference
    double ofDerivative = 0.0;
    double rows = 0.0; ///< number of rows in the sums
};

/// Compares the rates of the first rows with the difference quotients of `values`. `spacing`: time between two rows, s.
Mismatch compareWithDifferences(std::span<const double> rates, const std::vector<double> &values, double spacing)
{
    Mismatch mismatch;
    const auto square = [](double error) { return error * error; };
    const std::vector<double> &x = values;
    for (std::size_t i = 2; i + 2 < rates.size(); ++i) {
        const double central = (x[i + 1] - x[i - 1]) / (2.0 * spacing);
        const std::array differences{(x[i + 1] - x[i]) / spacing, (x[i] - x[i - 1]) / spacing, central};
        const double derivative = (4.0 * central - (x[i + 2] - x[i - 2]) / (4.0 * spacing)) / 3.0; // of fourth order
        if (!std::isfinite(differences[0] + derivative + rates[i])) {
            continue;
        }
        for (std::size_t k = 0; k < differences.size(); ++k) {
            mismatch.ofDifferences[k] += square(rates[i] - differences[k]);
        }
        mismatch.ofDerivative += square(rates[i] - derivative);
        ++mismatch.rows;
    }
    return mismatch;
}

} // namespace

std::optional<Difference> differenceIn(const ReferenceData &data, Channel channel)
{
    constexpr std::size_t kExaminedRows = 512;
    constexpr std::size_t kMinRows = 12;
    constexpr double kMinRatio = 16.0;        // second smallest sum of squares, divided by the smallest one
    constexpr double kArithmeticError = 1e-6; // relative to the peak
    const std::size_t rows = std::min(data.time.size(), kExaminedRows);
    const bool hasTime = !data.crank;
    if (channel.order == Order::Position || rows < kMinRows || !hasTime) {
        return std::nullopt;
    }
    const ReferenceSeries *const rate = data.find(channel);
    const ReferenceSeries *const base =
        data.find({channel.coordinate, channel.order == Order::Velocity ? Order::Position : Order::Velocity});
    if (!rate || !base) {
        return std::nullopt;
    }
    const double spacing = (data.time[rows - 1] - data.time[0]) / static_cast<double>(rows - 1);
    const Mismatch mismatch = compareWithDifferences(std::span(rate->values).first(rows), base->values, spacing);
    const auto best = std::ranges::min_element(mismatch.ofDifferences);
    double secondBest = mismatch.ofDerivative;
    for (auto other = mismatch.ofDifferences.begin(); other != mismatch.ofDifferences.end(); ++other) {
        secondBest = other == best ? secondBest : std::min(secondBest, *other);
    }
    const double peak = rangeOf(rate->values).size();
    const double allowed = base->rounding.stepAt(rangeOf(base->values).size()) / spacing + rate->rounding.stepAt(peak) +
                           kArithmeticError * peak;
    const bool isDifference = secondBest > kMinRatio * *best && *best <= allowed * allowed * mismatch.rows;
    return isDifference ? std::optional(static_cast<Difference>(best - mismatch.ofDifferences.begin())) : std::nullopt;
}

} // namespace slidercrank
