// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/typing_errors.h"

#include "core/identification/convention.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace slidercrank
{

namespace
{

/// The factors of five equally spaced values in their fourth difference, which is small for smooth curves. If one value
/// is wrong, the five differences that contain it change by its error times these factors.
constexpr std::array kFourthDifference{1.0, -4.0, 6.0, -4.0, 1.0};

/// An error of one value, and by how much this error explains the sum of squares of the fourth differences around it.
struct PossibleError {
    double error = 0.0;
    double explained = 0.0;
};

/// Estimates the error of the value in a row: the one that explains the fourth differences around it best, by least
/// squares. Differences that contain a gap do not count.
PossibleError estimateError(const std::vector<double> &values, std::size_t row)
{
    double sumOfProducts = 0.0;
    double sumOfSquares = 0.0;
    for (std::size_t term = 0; term < kFourthDifference.size(); ++term) { // the one that contains the value
        if (row < term || row - term + kFourthDifference.size() > values.size()) {
            continue;
        }
        double difference = 0.0;
        for (std::size_t i = 0; i < kFourthDifference.size(); ++i) {
            difference += kFourthDifference[i] * values[row - term + i];
        }
        if (std::isfinite(difference)) {
            sumOfProducts += kFourthDifference[term] * difference;
            sumOfSquares += kFourthDifference[term] * kFourthDifference[term];
        }
    }
    return sumOfSquares > 0.0
               ? PossibleError{sumOfProducts / sumOfSquares, sumOfProducts * sumOfProducts / sumOfSquares}
               : PossibleError{};
}

/// The result of estimateError() for each value.
std::vector<PossibleError> estimateErrors(const std::vector<double> &values)
{
    std::vector<PossibleError> errors(values.size());
    for (std::size_t row = 0; row < values.size(); ++row) {
        errors[row] = estimateError(values, row);
    }
    return errors;
}

/// A value that is far from the curve through its neighbours.
struct SuspiciousValue {
    std::size_t row = 0;
    double suspicion = 0.0; ///< its error, divided by the median of the errors of the other values or, if that is
                            ///< smaller, by half a rounding step
};

/// The value of a column that is most probably a typing error.
SuspiciousValue findMostSuspicious(const ReferenceSeries &series)
{
    constexpr double kMinUsualError = 0.5; // rounding steps: about the rms of the errors that rounding causes
    std::vector<double> values = series.values;
    if (isAngle(series.channel.coordinate) && series.channel.order == Order::Position) {
        removeJumps(values, kTurnInDegrees);
    }
    std::vector<PossibleError> errors = estimateErrors(values);
    const auto largest = std::ranges::max_element(errors, {}, &PossibleError::explained);
    const std::size_t row = static_cast<std::size_t>(largest - errors.begin());
    const double error = std::abs(largest->error);
    const double step = series.rounding.stepAt(values[row]);
    values[row] -= largest->error; // otherwise it would count as an error of its neighbours, too
    errors = estimateErrors(values);
    const auto magnitude = [](const PossibleError &possible) { return std::abs(possible.error); };
    const auto middle = errors.begin() + std::ssize(errors) / 2;
    std::ranges::nth_element(errors, middle, {}, magnitude);
    const double usualError = std::max(magnitude(*middle), kMinUsualError * step);
    return {.row = row, .suspicion = error > 0.0 ? error / usualError : 0.0};
}

} // namespace

std::size_t maxTypingErrors(const ReferenceData &data)
{
    constexpr std::size_t kMinRows = 9;      // fewer do not have the five fourth differences that an error changes
    constexpr std::size_t kMaxRows = 400;    // nobody types more
    constexpr std::size_t kRowsPerError = 6; // at most one row in six is left out: the others still check the mechanism
    constexpr std::size_t kMaxErrors = 3;    // each costs another identification
    const std::size_t rows = data.time.size();
    return rows < kMinRows || rows > kMaxRows ? 0 : std::min(rows / kRowsPerError, kMaxErrors);
}

std::optional<std::size_t> findRowWithLargestResidual(const LastFit &lastFit)
{
    const Fit &fit = lastFit.fit;
    if (!fit.isFinite() || lastFit.isExact) {
        return std::nullopt;
    }
    constexpr double kMinResidual = 8.0; // times the median of the column: noise of 400 values seldom reaches five
    Values largest = Values::Zero(lastFit.observations.size());
    for (const Index indexInFit : fit.indicesInFit()) {
        const double usual = median(fit.residuals.col(indexInFit).abs());
        if (usual > 0.0) {
            largest = largest.max(gapsAsZeros(fit.residuals.col(indexInFit)).abs() / usual);
        }
    }
    Index row = 0;
    if (largest.maxCoeff(&row) < kMinResidual) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(lastFit.observations.rows[row]);
}

std::optional<std::size_t> findSuspiciousRow(const ReferenceData &data)
{
    constexpr double kMinSuspicion = 10.0; // few curves without an error reach it
    SuspiciousValue mostSuspicious;
    for (const ReferenceSeries &series : data.series) {
        const SuspiciousValue value = findMostSuspicious(series);
        mostSuspicious = value.suspicion > mostSuspicious.suspicion ? value : mostSuspicious;
    }
    return mostSuspicious.suspicion > kMinSuspicion ? std::optional(mostSuspicious.row) : std::nullopt;
}

ReferenceData withoutRow(ReferenceData data, std::size_t row)
{
    for (ReferenceSeries &series : data.series) {
        series.values[row] = std::numeric_limits<double>::quiet_NaN();
    }
    return data;
}

} // namespace slidercrank
