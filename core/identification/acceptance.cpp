// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/acceptance.h"

#include "core/identification/interpretation.h"
#include "core/identification/least_squares.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr double kFewestRowsForNoise = 20.0; // with fewer rows, noise and misfit cannot be distinguished
constexpr double kLargestNoisePart = 0.15;   // of the spread
constexpr Eigen::Index kHarmonics = 8;

/// The autocorrelation at `lag`, in standard deviations of that of independent values. `rows` are the row numbers of
/// the values, `stride` apart; pairs across a gap are skipped. If `rows` is empty, there are no gaps.
double correlation(const std::vector<double> &values, std::size_t lag, const std::vector<std::size_t> &rows = {},
                   std::size_t stride = 1)
{
    double squares = 0.0;
    double products = 0.0;
    double pairs = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        squares += values[i] * values[i];
        if (i >= lag && (rows.empty() || rows[i] - rows[i - lag] == lag * stride)) {
            products += values[i] * values[i - lag];
            pairs += 1.0;
        }
    }
    return squares > 0.0 && pairs > 0.0 ? products / squares * static_cast<double>(values.size()) / std::sqrt(pairs)
                                        : 0.0;
}

/// The mean fourth power divided by the squared mean square: 3 for normally distributed values.
double kurtosis(const std::vector<double> &values)
{
    double squares = 0.0;
    double fourths = 0.0;
    for (const double value : values) {
        squares += value * value;
        fourths += value * value * value * value;
    }
    return squares > 0.0 ? fourths * static_cast<double>(values.size()) / (squares * squares) : 0.0;
}

/// Whether the values, in the order of time, look like independent noise of one distribution: tests the sum of eight
/// squared autocorrelations (Ljung-Box), the first autocorrelation, and the kurtosis, which single bad readings raise.
bool isWhiteInTime(const std::vector<double> &values, const std::vector<std::size_t> &rows)
{
    constexpr std::size_t kLags = 8;
    constexpr double kLargestSum = 30.0; // 99.98 % point of chi-square with 8 degrees of freedom
    constexpr double kSigmas = 3.7;
    constexpr double kLargestKurtosis = 9.0;
    std::size_t stride = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 1; i < rows.size(); ++i) {
        stride = std::min(stride, rows[i] - rows[i - 1]);
    }
    double sum = 0.0;
    for (std::size_t lag = 1; lag <= std::min(kLags, values.size() / 5); ++lag) {
        const double deviations = correlation(values, lag, rows, stride);
        sum += deviations * deviations;
        if (lag == 1 && std::abs(deviations) > kSigmas) {
            return false;
        }
    }
    return sum <= kLargestSum && kurtosis(values) <= kLargestKurtosis;
}

/// Whether the values, in the order of the crank angle, are not correlated with their neighbours and are no function of
/// the angle.
bool isWhiteInAngle(const std::vector<double> &values, const std::vector<double> &angles)
{
    constexpr double kSigmas = 3.7;
    constexpr double kDegreesOfFreedom = 2.0 * kHarmonics + 1.0;
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::size_t i) { return wrapToPi(angles[i]); });
    std::vector<double> sorted;
    for (const std::size_t i : order) {
        sorted.push_back(values[i]);
    }
    const auto n = static_cast<double>(values.size());
    const double explained = n * explainedPart(harmonicBasis(angles, kHarmonics), values, 0.0);
    return correlation(sorted, 1) <= kSigmas &&
           explained <= kDegreesOfFreedom + 4.0 * std::sqrt(2.0 * kDegreesOfFreedom);
}

Residual judgeColumn(const Observations &data, const Fit &fit, const std::vector<double> &angles, std::size_t j)
{
    if (!fit.hypothesis.columns[j].isUsed) {
        return Residual::NotUsed;
    }
    if (fit.noiseVariances[j] == 0.0) {
        return Residual::Rounding;
    }
    std::vector<double> values;
    std::vector<double> valueAngles;
    std::vector<std::size_t> rows;
    double largest = 0.0;
    for (std::size_t i = 0; i < data.abscissa.size(); ++i) {
        const double residual = fit.residuals[j][i];
        if (!std::isnan(residual)) {
            values.push_back(residual / std::sqrt(fit.variances[j][i]));
            valueAngles.push_back(angles[i]);
            rows.push_back(data.rows[i]);
            largest = std::max(largest, std::abs(residual));
        }
    }
    const double range = interpretedRange(data, fit.hypothesis, j);
    const double spread = std::max(data.columns[j].spread * std::abs(fit.hypothesis.columns[j].factor()),
                                   isConstantByNature(data.columns[j].channel) ? range : 0.0);
    if (data.columns[j].count < kFewestRowsForNoise) {
        return Residual::Unexplained;
    }
    const bool isSmall = std::sqrt(fit.noiseVariances[j]) <= kLargestNoisePart * spread;
    if (isSmall && isWhiteInTime(values, rows) && isWhiteInAngle(values, valueAngles)) {
        return Residual::White;
    }
    return largest <= kLargestSystematicPart * range ? Residual::Systematic : Residual::Unexplained;
}

} // namespace

double Candidate::score() const
{
    constexpr double kPricePerSpeed = 1e-5; // prefers the slowest of several aliases
    return fit.score + price + kPricePerSpeed * std::abs(fit.hypothesis.unknowns[3]);
}

std::vector<double> crankAngles(const Observations &data, const Hypothesis &hypothesis)
{
    const double rate = phaseRate(data, hypothesis, hypothesis.unknowns);
    std::vector<double> angles;
    angles.reserve(data.abscissa.size());
    for (const double at : data.abscissa) {
        angles.push_back(rate * at + hypothesis.unknowns[4]);
    }
    return angles;
}

double interpretedRange(const Observations &data, const Hypothesis &hypothesis, std::size_t column)
{
    const Channel channel = data.columns[column].channel;
    const double natural = channel.coordinate == R4y ? hypothesis.unknowns[0] : hypothesis.unknowns[3];
    return isConstantByNature(channel) ? std::abs(natural)
                                       : data.columns[column].range * std::abs(hypothesis.columns[column].factor());
}

bool looksLikeNoise(const std::vector<double> &residuals, const std::vector<double> &angles)
{
    constexpr double kLargestHarmonicPart = 0.6; // smoothed differences have systematic errors, too
    constexpr double kSmooth = 0.92;             // correlation of neighbouring rows of a smooth signal
    const auto n = static_cast<double>(residuals.size());
    const double largest = std::min(kLargestHarmonicPart + (2.0 * kHarmonics + 1.0) / n, 0.95);
    return explainedPart(harmonicBasis(angles, kHarmonics), residuals, 0.0) <= largest &&
           correlation(residuals, 1) <= kSmooth * std::sqrt(n);
}

Candidate judgedCandidate(const Observations &data, Fit fit)
{
    Candidate candidate;
    candidate.price = priceOf(data, fit.hypothesis);
    candidate.fit = std::move(fit);
    const Fit &found = candidate.fit;
    const std::vector<double> angles = crankAngles(data, found.hypothesis);
    candidate.isExact = true;
    candidate.acceptance = Acceptance::Identified;
    double off = 0.0;
    double all = 0.0;
    bool hasOffset = data.isByCrankAngle && found.hypothesis.isFree[indexOf(Parameter::Theta20)];
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const ObservedColumn &column = data.columns[j];
        const ColumnUse &use = found.hypothesis.columns[j];
        candidate.residuals.push_back(judgeColumn(data, found, angles, j));
        hasOffset = hasOffset || (use.isUsed && use.hasOffset);
        if (tellsShape(column)) {
            const double spread = column.spread * use.factor();
            off += column.count * (use.isUsed ? std::min(found.noiseVariances[j] / (spread * spread), 1.0) : 1.0);
            all += column.count;
        }
        const Residual residual = candidate.residuals.back();
        candidate.isExact = candidate.isExact && (residual == Residual::Rounding || residual == Residual::NotUsed);
        candidate.acceptance =
            std::max(candidate.acceptance, residual == Residual::Unexplained  ? Acceptance::Rejected
                                           : residual == Residual::Systematic ? Acceptance::Approximate
                                                                              : Acceptance::Identified);
    }
    if (candidate.acceptance == Acceptance::Approximate && hasOffset) { // a free origin would absorb systematic errors
        candidate.acceptance = Acceptance::Rejected;
    }
    candidate.distance = all > 0.0 ? off / all : 1.0;
    return candidate;
}

bool isBetter(const Candidate &x, const Candidate &y)
{
    return x.acceptance != y.acceptance ? x.acceptance < y.acceptance : x.score() < y.score();
}

} // namespace slidercrank
