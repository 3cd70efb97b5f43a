// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/difference.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

std::optional<Difference> differenceIn(const ReferenceData &data, Channel channel)
{
    constexpr std::size_t kExaminedRows = 512;
    constexpr std::size_t kFewestRows = 12;
    constexpr double kBetter = 16.0;          // ratio of the sums of squares of the second best to the best match
    constexpr double kArithmeticError = 1e-6; // relative to the peak
    const ReferenceSeries *const rate = data.find(channel);
    const std::size_t rows = std::min(data.time.size(), kExaminedRows);
    const bool hasTime = !data.crank;
    if (channel.order == Order::Position || !rate || rows < kFewestRows || !hasTime) {
        return std::nullopt;
    }
    const ReferenceSeries *const base =
        data.find({channel.coordinate, channel.order == Order::Velocity ? Order::Position : Order::Velocity});
    if (!base) {
        return std::nullopt;
    }
    const double step = (data.time[rows - 1] - data.time[0]) / static_cast<double>(rows - 1);
    const std::vector<double> &x = base->values;
    std::array<double, 4> squares{}; // by Difference; [3]: from the derivative, by differences of fourth order
    double count = 0.0;
    for (std::size_t i = 2; i + 2 < rows; ++i) {
        const double central = (x[i + 1] - x[i - 1]) / (2.0 * step);
        const std::array differences{(x[i + 1] - x[i]) / step, (x[i] - x[i - 1]) / step, central,
                                     (4.0 * central - (x[i + 2] - x[i - 2]) / (4.0 * step)) / 3.0};
        if (!std::isfinite(differences[0] + differences[3] + rate->values[i])) {
            continue;
        }
        for (std::size_t k = 0; k < squares.size(); ++k) {
            squares[k] += (rate->values[i] - differences[k]) * (rate->values[i] - differences[k]);
        }
        ++count;
    }
    const auto best = static_cast<std::size_t>(std::ranges::min_element(squares) - squares.begin());
    const double least = squares[best];
    squares[best] = kInfinity;
    if (best == 3 || !(*std::ranges::min_element(squares) > kBetter * least)) {
        return std::nullopt;
    }
    const double peak = rangeOf(rate->values).size();
    const double allowed =
        base->rounding.stepAt(rangeOf(x).size()) / step + rate->rounding.stepAt(peak) + kArithmeticError * peak;
    return least <= allowed * allowed * count ? std::optional(static_cast<Difference>(best)) : std::nullopt;
}

} // namespace slidercrank
