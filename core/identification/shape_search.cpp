// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/shape_search.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr std::size_t kCoarseRows = 20; // on which the grid is evaluated
constexpr std::size_t kArcRows = 12;    // the same at the speeds of short arcs
constexpr std::size_t kFitRows = 40;

/// Added to 1 − ρ² on the grid, so that a shape that fits all columns roughly beats one that fits
/// half of them exactly.
constexpr double kLeastUnexplained = 3e-3;

/// The sum of n ln(1 − ρ² + kLeastUnexplained) over the columns.
double dissimilarity(const Observations &data, const Hypothesis &hypothesis)
{
    const std::vector<ColumnRegression> regressions = columnRegressions(data, hypothesis);
    double sum = regressions.empty() ? kInfinity : 0.0;
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        const ObservedColumn &column = data.columns[j];
        if (hypothesis.columns[j].isUsed && column.count > 0.0) {
            const double rounding = column.meanVariance / (column.spread * column.spread);
            sum += column.count * std::log(regressions[j].unexplained() + kLeastUnexplained + rounding);
        }
    }
    return sum;
}

/// Adds at most `most` of the best shapes of a coarse grid at one speed. With both signs of c, ω2 > 0 and the open
/// assembly, no shape of the grid is an image of another one.
void addGridStarts(const Observations &coarse, Hypothesis hypothesis, double speed, std::size_t most,
                   std::vector<Fit> &starts)
{
    if (coarse.isByCrankAngle) { // then the derivatives are with respect to the angle
        hypothesis.abscissaFactor = speed;
        speed = 1.0;
    }
    constexpr std::array kOffsets{0.0, 0.5, -0.5, 1.2, -1.2, 5.0, -5.0, 60.0, -60.0}; // c / a
    constexpr std::array kCouplers{0.85, 1.05, 1.25, 1.7, 2.7, 8.0};                  // b / (a + |c|)
    constexpr int kAngles = 12;
    std::vector<Fit> found;
    for (const double offset : kOffsets) {
        for (const double coupler : kCouplers) {
            Fit best;
            const double b = coupler * (1.0 + std::abs(offset));
            for (int k = 0; k < kAngles; ++k) {
                setMiddleParameters({1.0 / b, 1.0, offset / b, speed, k * kTurn / kAngles}, hypothesis);
                const double misfit = dissimilarity(coarse, hypothesis);
                if (misfit < best.score) {
                    best.hypothesis = hypothesis;
                    best.score = misfit;
                }
            }
            if (best.exists()) {
                found.push_back(std::move(best));
            }
        }
    }
    std::ranges::sort(found, {}, &Fit::score);
    found.resize(std::min(found.size(), most));
    starts.insert(starts.end(), found.begin(), found.end());
}

/// Fits the best starts and adds the distinct fits. Returns whether rounding explains one of them, or nearly explains
/// it if there are more than two columns.
bool fitStarts(const Observations &data, std::vector<Fit> starts, std::size_t most, std::vector<Fit> &fits)
{
    constexpr int kRounds = 2;
    std::ranges::sort(starts, {}, &Fit::score);
    starts.resize(std::min(starts.size(), most));
    bool isExact = false;
    for (Fit &start : starts) {
        for (ColumnUse &column : start.hypothesis.columns) {
            column.hasOffset = column.hasScale = column.isUsed;
        }
        regressScales(data, start.hypothesis);
        Fit fit = fitHypothesis(data, std::move(start.hypothesis), kRounds);
        if (fit.exists() && !isKnown(fit.hypothesis, fits)) {
            isExact |= std::ranges::max(fit.noiseParts) <= (data.columns.size() > 2 ? 1e-6 : 0.0);
            fits.push_back(std::move(fit));
        }
    }
    std::ranges::sort(fits, {}, &Fit::score);
    return isExact;
}

} // namespace

std::vector<Fit> searchShapes(const Observations &data, const std::vector<ColumnUse> &columns,
                              const SpeedCandidates &speeds)
{
    constexpr std::size_t kPerSpeed = 3;
    constexpr std::size_t kArcs = 5;
    const Observations coarse = thinned(data, kCoarseRows);
    const Observations fine = thinned(data, kFitRows);
    Hypothesis hypothesis;
    hypothesis.columns = columns;
    for (std::size_t j = 0; j < columns.size(); ++j) {
        hypothesis.columns[j].isUsed = tellsShape(data.columns[j]);
    }
    hypothesis.isFree = {true, false, true, !speeds.isKnown, true}; // b = 1: then a short crank is a small number
    std::vector<Fit> fits;
    for (const double speed : speeds.periodic) {
        std::vector<Fit> starts;
        addGridStarts(coarse, hypothesis, speed, kPerSpeed, starts);
        if (fitStarts(fine, std::move(starts), kPerSpeed, fits)) {
            return fits;
        }
    }
    std::vector<Fit> starts;
    const Observations arc = thinned(data, kArcRows);
    for (const double speed : speeds.shortArc) {
        addGridStarts(arc, hypothesis, speed, kPerSpeed, starts);
    }
    fitStarts(fine, std::move(starts), kArcs, fits);
    return fits;
}

} // namespace slidercrank
