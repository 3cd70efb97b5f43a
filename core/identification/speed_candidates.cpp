// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/speed_candidates.h"

#include "core/identification/least_squares.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

/// How often the column goes from clearly below the middle of its range to clearly above it, or back.
int countMiddleCrossings(const ObservedColumn &column)
{
    constexpr double kHysteresis = 0.15;          // fraction of the range: noise crosses nothing
    constexpr std::size_t kValuesPerOutlier = 50; // one value in 50, at either end of the range, may be an outlier
    std::vector<double> sorted;
    sorted.reserve(static_cast<std::size_t>(column.values.size()));
    std::ranges::copy_if(column.values, std::back_inserter(sorted), [](double value) { return std::isfinite(value); });
    if (sorted.empty()) {
        return 0;
    }
    std::ranges::sort(sorted);
    const std::size_t outliers = sorted.size() / kValuesPerOutlier; // at either end
    const double low = sorted[outliers];
    const double high = sorted[sorted.size() - 1 - outliers];
    const double middle = 0.5 * (low + high);
    int side = 0; // where the last value lay that was clearly off the middle: -1 below, 1 above
    int count = 0;
    for (const double value : column.values) {
        if (std::abs(value - middle) > kHysteresis * (high - low)) {
            const int sideNow = value > middle ? 1 : -1;
            count += side == -sideNow ? 1 : 0;
            side = sideNow;
        }
    }
    return count;
}

/// The misfit of a constant and two harmonics of one speed (rad/s) in the columns: the value of the periodogram there.
double misfitOfHarmonics(const Observations &observations, const Indices &columns, double speed)
{
    const Values cosine = (speed * observations.time.values).cos();
    const Values sine = (speed * observations.time.values).sin();
    Eigen::MatrixXd harmonics(cosine.size(), 5);
    harmonics << Values::Ones(cosine.size()), cosine, sine, 2.0 * cosine.square() - 1.0, 2.0 * sine * cosine;
    double misfit = 0.0;
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        const Eigen::MatrixXd basis = column.values.isFinite().cast<double>().matrix().asDiagonal() * harmonics;
        const double squares = fitLinearly(basis, gapsAsZeros(column.values)).residuals.square().sum();
        const double count = static_cast<double>(column.values.isFinite().count());
        misfit += count * std::log(squares / count + column.variance);
    }
    return misfit;
}

/// A point of the periodogram.
struct Trial {
    double speed = 0.0;  ///< rad/s
    double misfit = 0.0; ///< the result of misfitOfHarmonics()
};

/// The trials whose misfit is not higher than that of either neighbour.
std::vector<Trial> findLocalMinima(const std::vector<Trial> &trials)
{
    std::vector<Trial> minima;
    for (std::size_t i = 1; i + 1 < trials.size(); ++i) {
        if (trials[i].misfit <= std::min(trials[i - 1].misfit, trials[i + 1].misfit)) {
            minima.push_back(trials[i]);
        }
    }
    return minima;
}

/// The fraction of the time of the file in which there are rows, at their usual distance; 1 without gaps.
double computeCoverage(const Observations &observations)
{
    const Index pairs = observations.size() - 1;
    const Values distances = observations.time.values.tail(pairs) - observations.time.values.head(pairs);
    return std::min(1.0, static_cast<double>(pairs) * median(distances) / observations.span());
}

/// By how many turns the number that follows from the crossings may be wrong, because the first and the last turn are
/// incomplete.
constexpr double kTurnCountUncertainty = 1.0;

/// Whether the crank may have made a number of turns in a file with a number of pairs of crossings: a periodic motion
/// crosses the middle of its range equally often in every turn, and as often upwards as downwards.
bool agreesWithCrossings(double turns, double crossingPairs)
{
    constexpr double kMaxMiscounted = 0.005; // fraction of the pairs that noise may add or hide
    const double pairsPerTurn = std::max(1.0, std::rint(crossingPairs / turns));
    const double expectedTurns = crossingPairs / pairsPerTurn;
    return std::abs(expectedTurns - turns) <= kTurnCountUncertainty + kMaxMiscounted * crossingPairs;
}

/// How often a column crosses the middle of its range, in pairs: once upwards and once downwards.
struct CrossingCount {
    double pairs = 0.0;
    double rows = 0.0;     ///< number of rows of the file
    double coverage = 1.0; ///< the result of computeCoverage()

    /// Whether there are so few rows that crossings may fall between them.
    bool mayMissCrossings() const
    {
        constexpr double kMinRowsPerPair = 8.0;
        return rows < kMinRowsPerPair * pairs;
    }
    /// Whether the number of pairs is so certain that only the numbers of turns with which agreesWithCrossings() is
    /// true need be tried.
    bool isReliable() const
    {
        constexpr double kFullCoverage = 0.95; // with less coverage, gaps hide crossings
        return coverage >= kFullCoverage && !mayMissCrossings();
    }
};

/// Equally spaced numbers of turns, without those that the number of crossings excludes. If crossings may be missed,
/// the numbers end at half a turn per row: a faster crank gives the same positions as a slower one.
std::vector<double> possibleTurns(const CrossingCount &crossings)
{
    constexpr double kSpacing = 0.1;  // a tenth of the width of a minimum of the periodogram
    constexpr double kMinTurns = 0.7; // with fewer turns, two harmonics fit any speed; findSpeedCandidates() adds arcs
    constexpr double kMaxTurnsPerRow = 0.5;
    constexpr double kMaxPairsPerTurn = 5.0; // accelerations have several pairs of crossings per turn
    const double minTurns = std::max(crossings.pairs / kMaxPairsPerTurn - kTurnCountUncertainty, kMinTurns);
    const double maxTurns = crossings.mayMissCrossings() ? kMaxTurnsPerRow * crossings.rows
                                                         : crossings.pairs / crossings.coverage + kTurnCountUncertainty;
    std::vector<double> possible;
    for (double turns = minTurns; turns <= maxTurns; turns += kSpacing) {
        if (!crossings.isReliable() || agreesWithCrossings(turns, crossings.pairs)) {
            possible.push_back(turns);
        }
    }
    return possible;
}

/// The largest number of crossings in a column.
int countMaxCrossings(const Observations &observations, const Indices &columns)
{
    int maxCrossings = 0;
    for (const Index column : columns) {
        maxCrossings = std::max(maxCrossings, countMiddleCrossings(observations.columns[column]));
    }
    return maxCrossings;
}

/// The speed at which the crank makes one turn in the file, rad/s.
double findSpeedOfOneTurn(const Observations &observations)
{
    return kTurn / observations.span();
}

/// The periodogram at the speeds that the crossings allow.
std::vector<Trial> computePeriodogram(const Observations &observations, const Indices &columns,
                                      const CrossingCount &crossings)
{
    const double speedOfOneTurn = findSpeedOfOneTurn(observations);
    const Observations selected = selectRows(observations, kSearchedRows);
    std::vector<Trial> trials;
    for (const double turns : possibleTurns(crossings)) {
        if (!selected.stop.stop_requested()) {
            const double speed = turns * speedOfOneTurn;
            trials.push_back({speed, misfitOfHarmonics(selected, columns, speed)});
        }
    }
    return trials;
}

/// Speeds (rad/s) of a crank that makes one and a half turns in the file or less; the highest first.
std::vector<double> arcSpeeds(const Observations &observations)
{
    constexpr double kMaxTurns = 1.5;  // one and a half turns may have only the two crossings of a single turn
    constexpr double kMinTurns = 0.05; // a shorter arc has no recognizable shape
    constexpr double kRatio = 1.3;     // ratio of neighbouring speeds: a fit finds the speeds between them
    std::vector<double> speeds;
    for (double turns = kMaxTurns; turns > kMinTurns; turns /= kRatio) {
        speeds.push_back(turns * findSpeedOfOneTurn(observations));
    }
    return speeds;
}

} // namespace

std::vector<double> findSpeedCandidates(const Observations &observations, const Indices &columns)
{
    constexpr std::size_t kMaxCandidates = 4; // each costs a search of the geometry
    constexpr int kCrossingsOfOneTurn = 2;
    const int crossings = countMaxCrossings(observations, columns);
    const bool mayBeArc = crossings <= kCrossingsOfOneTurn;
    std::vector<Trial> trials = computePeriodogram(observations, columns,
                                                   {.pairs = 0.5 * crossings,
                                                    .rows = static_cast<double>(observations.size()),
                                                    .coverage = computeCoverage(observations)});
    std::vector<Trial> best = findLocalMinima(trials);
    if (best.empty() && !mayBeArc) { // the misfit rises or falls from the first trial to the last
        best = std::move(trials);
    }
    std::ranges::stable_sort(best, {}, &Trial::misfit);
    std::vector<double> speeds;
    for (std::size_t i = 0; i < std::min(kMaxCandidates, best.size()); ++i) {
        speeds.push_back(best[i].speed);
    }
    if (mayBeArc) {
        std::ranges::copy(arcSpeeds(observations), std::back_inserter(speeds));
    }
    return speeds;
}

} // namespace slidercrank
