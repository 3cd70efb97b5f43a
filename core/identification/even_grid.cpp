// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/even_grid.h"

#include "core/identification/noise.h"
#include "core/identification/round_number.h"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace slidercrank
{

namespace
{

/// Number of correct bits of the stretches that findEvenGrid() computes. A minimum determines its argument only to half
/// the bits of a double, and the margins around it need no more.
constexpr int kStretchBits = 26;

/// The argument between `minimum`, at which a convex function is least, and `end` that is farthest from `minimum` and
/// at which the function is not positive: its root there, or `end` if it has none. Returns `minimum` if the function is
/// nowhere negative.
template <class Function>
double farthestBelowZero(const Function &function, double minimum, double end)
{
    if (function(end) <= 0.0) {
        return end;
    }
    if (function(minimum) >= 0.0) {
        return minimum;
    }
    std::uintmax_t evaluations = 50;
    const boost::math::tools::eps_tolerance<double> isClose(kStretchBits);
    const auto [left, right] = boost::math::tools::toms748_solve(function, std::min(minimum, end),
                                                                 std::max(minimum, end), isClose, evaluations);
    return 0.5 * (left + right);
}

/// The limits that rounding sets to the start and the duration of a grid.
class GridLimits
{
public:
    GridLimits(const Values &printed, const Values &halfSteps, const std::vector<double> &gridNumbers)
        : m_printed(printed)
        , m_halfSteps(halfSteps)
        , m_numbers(Eigen::Map<const Values>(gridNumbers.data(), std::ssize(gridNumbers)))
    {
    }

    /// The distance of neighbours in a grid. The first and the last printed value allow durations from the shortest one
    /// (stretch = -1) to the longest one (stretch = 1).
    double spacing(double stretch) const
    {
        return (printedDuration() + stretch * largestChangeOfDuration()) / m_numbers[last()];
    }

    /// The stretch with this spacing.
    double stretchOf(double spacing) const
    {
        return (spacing * m_numbers[last()] - printedDuration()) / largestChangeOfDuration();
    }

    /// The values of a grid that starts at zero.
    Values gridFromZero(double stretch) const { return spacing(stretch) * m_numbers; }

    // Every printed value limits the start of the grid from both sides.
    double earliestStart(double stretch) const { return (m_printed - gridFromZero(stretch) - m_halfSteps).maxCoeff(); }
    double latestStart(double stretch) const { return (m_printed - gridFromZero(stretch) + m_halfSteps).minCoeff(); }

    double middleStart(double stretch) const { return 0.5 * (earliestStart(stretch) + latestStart(stretch)); }

    /// By how much the earliest start is after the latest one; negative if the limits leave starts between them. This
    /// is a convex function, so that its only local minimum is the least.
    double excess(double stretch) const { return earliestStart(stretch) - latestStart(stretch); }

private:
    Index last() const { return m_printed.size() - 1; }
    double printedDuration() const { return m_printed[last()] - m_printed[0]; }
    double largestChangeOfDuration() const { return m_halfSteps[0] + m_halfSteps[last()]; }

    const Values &m_printed;
    const Values &m_halfSteps;
    Values m_numbers;
};

/// The round number between two positive limits, if somebody may have chosen it.
std::optional<double> findChosenBetween(double least, double greatest)
{
    constexpr int kMaxDigits = 4; // of the picture rate of a camera, 29.97 per second
    const double tolerance = 0.5 * (greatest - least);
    const RoundNumber number = findRoundNumber(least + tolerance, tolerance / kStandardErrors, std::array{1.0});
    return number.isChosen && number.digits <= kMaxDigits ? std::optional(number.value) : std::nullopt;
}

/// The spacing between two limits that a person may have chosen: a part of `whole`, or a round number.
std::optional<double> findChosenSpacing(double shortest, double longest, double whole)
{
    if (const std::optional<double> parts = findChosenBetween(whole / longest, whole / shortest)) {
        return whole / *parts;
    }
    return findChosenBetween(shortest, longest);
}

/// The start of the grid with that stretch: the multiple of its spacing that its limits leave, unless they are so far
/// apart that a multiple is between them by chance; otherwise the middle between the limits.
double chooseStart(const GridLimits &limits, double stretch)
{
    constexpr double kMaxChance = 0.1;
    const double middle = limits.middleStart(stretch);
    const double multiple = std::round(middle / limits.spacing(stretch)) * limits.spacing(stretch);
    const double margin = -0.5 * limits.excess(stretch);
    const bool isChosen = std::abs(multiple - middle) <= margin && 2.0 * margin <= kMaxChance * limits.spacing(stretch);
    return isChosen ? multiple : middle;
}

} // namespace

EvenGrid findEvenGrid(const Values &printed, const Values &halfSteps, const std::vector<double> &gridNumbers,
                      double whole)
{
    const GridLimits limits(printed, halfSteps, gridNumbers);
    const auto excess = [&](double stretch) { return limits.excess(stretch); };
    double stretch = boost::math::tools::brent_find_minima(excess, -1.0, 1.0, kStretchBits).first;
    const std::array ends{farthestBelowZero(excess, stretch, -1.0), farthestBelowZero(excess, stretch, 1.0)};
    double start = limits.middleStart(stretch);
    if (const auto chosen = findChosenSpacing(limits.spacing(ends.front()), limits.spacing(ends.back()), whole)) {
        stretch = limits.stretchOf(*chosen);
        start = chooseStart(limits, stretch);
    }
    EvenGrid grid{.values = start + limits.gridFromZero(stretch)};
    const double duration = limits.gridFromZero(stretch)[printed.size() - 1];
    for (const double end : ends) {
        grid.startMargin =
            std::max({grid.startMargin, -0.5 * limits.excess(stretch), std::abs(limits.middleStart(end) - start)});
        grid.durationMargin =
            std::max(grid.durationMargin, std::abs(limits.gridFromZero(end)[printed.size() - 1] - duration));
    }
    return grid;
}

} // namespace slidercrank
