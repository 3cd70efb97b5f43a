// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/acceptance.h"

#include "core/identification/interpretation.h"
#include "core/identification/least_squares.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kFewestRowsForNoise = 30.0; // with fewer rows, noise and misfit cannot be distinguished
constexpr double kLargestNoisePart = 0.15;   // of the spread

/// The largest deviation of a mechanism that explains a file approximately, relative to a column's range.
constexpr double kLargestSystematicPart = 0.01;

constexpr Eigen::Index kHarmonics = 8;

/// Whether the values, in the order of time, look like independent noise without bad readings: tests the sum of eight
/// squared autocorrelations (Ljung-Box), the skewness, the kurtosis and the largest value.
bool isWhiteInTime(const std::vector<double> &values)
{
    constexpr std::size_t kLags = 8;
    constexpr double kLargestSum = 30.0;     // 99.98 % point of chi-square with 8 degrees of freedom
    constexpr double kLargestKurtosis = 9.0; // 3 for normally distributed values; single bad readings raise it
    constexpr double kLargestSkewness = 1.4; // 0 for symmetric noise; errors of one sign shift the parameters
    double sum = 0.0;
    for (std::size_t lag = 1; lag <= std::min(kLags, values.size() / 5); ++lag) {
        const double deviations = autocorrelation(values, lag);
        sum += deviations * deviations;
    }
    const auto [lowest, highest] = std::ranges::minmax(values);
    return sum <= kLargestSum && std::abs(boost::math::statistics::skewness(values)) <= kLargestSkewness &&
           (boost::math::statistics::kurtosis(values) <= kLargestKurtosis ||
            std::max(-lowest, highest) <= kFarReading * robustDeviation(values));
}

/// Whether the values, in the order of the crank angle, are not correlated with their neighbours.
bool isWhiteInAngle(const std::vector<double> &values, const std::vector<double> &angles)
{
    constexpr double kSigmas = 3.7;
    using AngleAndValue = std::pair<double, double>;
    std::vector<AngleAndValue> pairs;
    for (std::size_t i = 0; i < values.size(); ++i) {
        pairs.emplace_back(wrapToPi(angles[i]), values[i]);
    }
    std::ranges::stable_sort(pairs, {}, &AngleAndValue::first);
    std::vector<double> sorted(values.size());
    std::ranges::transform(pairs, sorted.begin(), &AngleAndValue::second);
    return autocorrelation(sorted, 1) <= kSigmas;
}

Residual judgeColumn(const Observations &data, const Fit &fit, std::size_t j)
{
    const Hypothesis &hypothesis = fit.hypothesis;
    if (!hypothesis.columns[j].isUsed) {
        return Residual::NotUsed;
    }
    if (fit.noiseVariances[j] == 0.0) {
        return Residual::Rounding;
    }
    std::vector<double> values;
    std::vector<double> angles;
    for (std::size_t i = 0; i < data.abscissa.size(); ++i) {
        if (const double residual = fit.residuals[j][i]; !std::isnan(residual)) {
            values.push_back(residual / std::sqrt(fit.variances[j][i]));
            angles.push_back(crankAngle(data, hypothesis, i));
        }
    }
    const ObservedColumn &column = data.columns[j];
    if (column.count < kFewestRowsForNoise) {
        return Residual::Unexplained;
    }
    const double size = sizeOf(data, hypothesis, j);
    const double range =
        isConstantByNature(column.channel) ? size : column.range * std::abs(hypothesis.columns[j].factor());
    const bool isSmall = std::sqrt(fit.noiseVariances[j]) <= kLargestNoisePart * size;
    if (isSmall && isWhiteInTime(values) && isWhiteInAngle(values, angles)) {
        return Residual::White;
    }
    return rangeOf(fit.residuals[j]).size() <= kLargestSystematicPart * range ? Residual::Systematic
                                                                              : Residual::Unexplained;
}

} // namespace

double robustDeviation(std::vector<double> values)
{
    constexpr double kOfNormal = 1.4826; // standard deviation per median absolute deviation
    std::erase_if(values, [](double value) { return std::isnan(value); });
    return values.empty() ? 0.0 : kOfNormal * boost::math::statistics::median_absolute_deviation(values, 0.0);
}

double Candidate::pricedScore() const
{
    constexpr double kPricePerSpeed = 1e-5; // prefers the slowest of several aliases
    return score + price + kPricePerSpeed * std::abs(hypothesis.unknowns[3]);
}

bool isLikeDifferences(const Observations &data, const Hypothesis &hypothesis, std::size_t column)
{
    constexpr double kLargestUnexplained = 0.05; // of the variance, in any unit
    constexpr double kRightPart = 1e-2;          // of the spread
    constexpr double kLargestHarmonicPart = 0.6; // smoothed differences have systematic errors, too
    constexpr double kSmooth = 0.92;             // correlation of neighbouring rows of a smooth signal
    Hypothesis alone = hypothesis;
    for (std::size_t j = 0; j < alone.columns.size(); ++j) {
        alone.columns[j].isUsed = j == column;
    }
    if (columnRegressions(data, alone)[column].unexplained() <= kLargestUnexplained) {
        return true;
    }
    std::vector<double> residuals;
    std::vector<double> angles;
    forEachResidual<double>(data, alone, [&](std::size_t row, std::size_t, double, double residual) {
        residuals.push_back(residual);
        angles.push_back(crankAngle(data, hypothesis, row));
    });
    if (robustDeviation(residuals) <= kRightPart * interpretedSpread(data, hypothesis, column)) { // in most rows
        return true;
    }
    const double count = std::max(data.columns[column].count, 1.0);
    const double largest = std::min(kLargestHarmonicPart + (2.0 * kHarmonics + 1.0) / count, 0.95);
    return fitLinear(harmonicBasis(angles, kHarmonics), residuals).explained <= largest &&
           autocorrelation(residuals, 1) <= kSmooth * std::sqrt(count);
}

bool isSmallOffset(const Observations &data, const Hypothesis &hypothesis, std::size_t column, double part)
{
    const Channel channel = hypothesis.columns[column].channel;
    const double offset = hypothesis.offset(column);
    const double fromHalfTurn = isLength(channel) ? offset : std::remainder(offset, std::numbers::pi);
    const double size = channel == kCrankAngle ? 1.0 : sizeOf(data, hypothesis, column);
    return std::abs(fromHalfTurn) < std::max(part * size, data.columns[column].step);
}

Candidate judgedCandidate(const Observations &data, Fit fit)
{
    Candidate candidate{std::move(fit)};
    const Hypothesis &hypothesis = candidate.hypothesis;
    candidate.price = priceOf(data, hypothesis);
    bool hasIdleOffset = false;
    int originsOfShape = 0;
    candidate.hasFreeOrigin = data.isByCrankAngle && hypothesis.isFree[indexOf(Parameter::Theta20)];
    bool leavesOut = false;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const ObservedColumn &column = data.columns[j];
        const ColumnUse &use = hypothesis.columns[j];
        candidate.hasFreeOrigin = candidate.hasFreeOrigin || use.hasOffset;
        hasIdleOffset = hasIdleOffset || (use.hasOffset && isSmallOffset(data, hypothesis, j, kIdleOffset));
        leavesOut = leavesOut || !use.isUsed;
        candidate.judgements.push_back(judgeColumn(data, candidate, j));
        originsOfShape += use.hasOffset && tellsShape(column);
    }
    const Residual worst = candidate.worst = std::ranges::max(candidate.judgements);
    candidate.isExact = worst <= Residual::Rounding;
    // A small origin may be an error of the values, such as that of a filter. Among noise, two origins, or one and a
    // column that is left out, may hide another error.
    const bool isTooFree = !candidate.isExact && originsOfShape + (leavesOut ? 1 : 0) > 1;
    candidate.acceptance = worst <= Residual::White && !hasIdleOffset && !isTooFree ? Acceptance::Identified
                           : worst == Residual::Systematic && !candidate.hasFreeOrigin && !leavesOut
                               ? Acceptance::Approximate
                               : Acceptance::Rejected;
    return candidate;
}

bool isBetter(const Candidate &x, const Candidate &y)
{
    return x.acceptance != y.acceptance ? x.acceptance < y.acceptance : x.pricedScore() < y.pricedScore();
}

} // namespace slidercrank
