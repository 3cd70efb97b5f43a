// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/observations.h"

#include "core/import/clock.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kArithmeticPart = 1e-12; // of a column's peak: no computation promises more digits

/// Channels that are zero in every mechanism.
bool isAlwaysZero(Channel channel)
{
    return channel.coordinate == R1x || channel.coordinate == R1y || channel.coordinate == Theta1 ||
           channel.coordinate == Theta4;
}

bool isAnglePosition(Channel channel)
{
    return isAngle(channel.coordinate) && channel.order == Order::Position;
}

/// Removes jumps by whole turns and returns whether there were any. A column with jumps of another size is left as it
/// is: it is in another unit.
bool removeJumps(std::vector<double> &radians)
{
    std::vector<double> continuous = radians;
    double last = kNone;
    double turns = 0.0;
    bool any = false;
    for (double &value : continuous) {
        if (std::isnan(value)) {
            continue;
        }
        const double change = std::isnan(last) ? 0.0 : value + turns - last;
        const double jump = kTurn * std::round(change / kTurn);
        if (jump != 0.0 && std::abs(change - jump) > kQuarterTurn) {
            return false;
        }
        any = any || jump != 0.0;
        turns -= jump;
        value += turns;
        last = value;
    }
    radians = std::move(continuous);
    return any;
}

/// The number of rows that count as one observation: rows that repeat do not round independently of each other.
double repetitionOf(const ObservedColumn &column)
{
    constexpr double kSamePart = 1e-3; // of a step: two differences are equal
    double runs = 1.0;                 // of equal values
    double stretches = 0.0;            // of equal differences
    double last = kNone;
    double difference = kNone;
    for (const double value : column.values) {
        if (std::isnan(value)) {
            continue;
        }
        if (!std::isnan(last)) {
            runs += value != last ? 1.0 : 0.0;
            stretches += std::abs(value - last - difference) <= kSamePart * column.step ? 0.0 : 1.0;
            difference = value - last;
        }
        last = value;
    }
    return column.count / (runs > 1.0 ? std::min({runs, 2.0 * stretches, column.count}) : 1.0);
}

/// The sharpened step if all levels are multiples of about `step` above the first, each rounded to the printed digits;
/// 0 if not. The step becomes known better from level to level.
double sharpenedStep(const std::vector<double> &levels, double step, double printedStep)
{
    constexpr double kSurely = 0.4; // of a step: farther from a multiple it is none, whatever the tolerance
    double countBefore = std::max(std::round((levels[1] - levels[0]) / step), 1.0);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const double height = levels[i] - levels[0];
        const double count = std::round(height / step);
        const double tolerance = 1.02 * printedStep * (1.0 + count / countBefore);
        if (std::abs(height - count * step) > std::min(tolerance, kSurely * step)) {
            return 0.0;
        }
        step = height / count;
        countBefore = count;
    }
    return step;
}

/// The step of a quantized column (encoder, converter): the values are multiples of one step that is much coarser than
/// the printed digits. 0 if they are not.
double quantizationStep(const std::vector<double> &values, double printedStep)
{
    constexpr double kCoarser = 5.0;          // printed steps at least
    constexpr std::size_t kFewestLevels = 12; // distinct values
    constexpr int kMostParts = 40;            // the smallest difference between two values may be so many steps
    std::vector<double> levels;
    levels.reserve(values.size());
    for (const double value : values) {
        if (!std::isnan(value)) {
            levels.push_back(value);
        }
    }
    std::ranges::sort(levels);
    const double finest =
        levels.empty() ? 0.0 : std::max(printedStep, kArithmeticPart * (levels.back() - levels.front()));
    const auto isSame = [&](double x, double y) { return std::abs(x - y) <= 1.1 * finest; };
    const auto repeats = std::ranges::unique(levels, isSame);
    levels.erase(repeats.begin(), repeats.end());
    if (levels.size() < kFewestLevels) {
        return 0.0;
    }
    double smallest = levels[1] - levels[0];
    for (std::size_t i = 1; i < levels.size(); ++i) {
        smallest = std::min(smallest, levels[i] - levels[i - 1]);
    }
    for (int parts = 1; parts <= kMostParts && smallest / parts >= kCoarser * finest; ++parts) {
        if (const double step = sharpenedStep(levels, smallest / parts, finest); step > 0.0) {
            return step;
        }
    }
    return 0.0;
}

/// Makes gaps of the values of a saturated sensor and returns whether there are any: a run of equal extreme values
/// whose neighbours are much farther away than those of a rounded turning point.
bool removeSaturation(std::vector<double> &values, double step)
{
    constexpr std::size_t kShortestRun = 3;
    constexpr double kMostPart = 0.4; // of the rows
    constexpr double kSudden = 4.0;   // times the drop of a rounded parabola
    constexpr std::size_t kBeside = 3;
    const ValueRange range = rangeOf(values);
    if (!(range.width() > 0.0)) {
        return false;
    }
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t first = 0; first < values.size(); ++first) {
        std::size_t end = first;
        while (end < values.size() && (values[end] == range.low || values[end] == range.high) &&
               values[end] == values[first]) {
            ++end;
        }
        const bool hasBefore = first >= kBeside;
        const bool hasBehind = end + kBeside <= values.size();
        if (end - first >= kShortestRun && (hasBefore || hasBehind)) {
            const double half = 0.5 * static_cast<double>(end - first);
            const double ratio = (half + static_cast<double>(kBeside)) / half;
            const double natural = std::max(step, kArithmeticPart * range.size()) * ratio * ratio;
            const bool isSuddenBefore =
                !hasBefore || std::abs(values[first - kBeside] - values[first]) > kSudden * natural;
            const bool isSuddenBehind =
                !hasBehind || std::abs(values[end + kBeside - 1] - values[first]) > kSudden * natural;
            if (isSuddenBefore && isSuddenBehind) {
                runs.emplace_back(first, end);
            }
        }
        first = std::max(first, end == first ? first : end - 1);
    }
    std::size_t count = 0;
    for (const auto &[first, end] : runs) {
        count += end - first;
    }
    if (static_cast<double>(count) > kMostPart * static_cast<double>(values.size())) { // a square wave
        return false;
    }
    for (const auto &[first, end] : runs) {
        std::fill(values.begin() + static_cast<std::ptrdiff_t>(first),
                  values.begin() + static_cast<std::ptrdiff_t>(end), kNone);
    }
    return !runs.empty();
}

/// Mean, spread, steps and variances of a column whose values are set. `unit`: mm or rad per unit of the file's
/// rounding.
void learnStatistics(ObservedColumn &column, const Rounding &rounding, double unit)
{
    constexpr double kUsualStep = 1e-6;   // of the peak, where the digits say nothing
    constexpr double kStepOfZeros = 1e-3; // mm or rad
    constexpr double kFinestPart = 0.01;  // of the column's largest step
    double sum = 0.0;
    for (const double value : column.values) {
        if (!std::isnan(value)) {
            sum += value;
            column.count += 1.0;
        }
    }
    const ValueRange range = rangeOf(column.values);
    column.mean = sum / std::max(column.count, 1.0);
    column.range = column.count > 0.0 ? range.width() : 0.0;
    column.varies = column.range > 0.0;
    RoundingSteps steps(rounding);
    std::vector<double> stepAt(column.values.size(), 0.0);
    double squares = 0.0;
    for (std::size_t i = 0; i < stepAt.size(); ++i) {
        if (const double value = column.values[i]; !std::isnan(value)) {
            stepAt[i] = steps.at(value / unit) * unit;
            column.step = std::max(column.step, stepAt[i]);
            squares += (value - column.mean) * (value - column.mean);
        }
    }
    const double finest = kArithmeticPart * range.size();
    const double usual = range.size() > 0.0 ? kUsualStep * range.size() : kStepOfZeros;
    column.step = std::max(column.step > 0.0 ? column.step : usual, finest);
    if (const double step = column.varies ? quantizationStep(column.values, column.step) : 0.0; step > 0.0) {
        column.step = step;
        std::ranges::fill(stepAt, step);
    }
    column.spread = std::max(std::sqrt(squares / std::max(column.count, 1.0)), column.varies ? 0.0 : column.step);
    const double repetition = repetitionOf(column);
    column.variances.reserve(stepAt.size());
    for (const double step : stepAt) {
        const double counted = std::max({step, kFinestPart * column.step, finest});
        column.variances.push_back(counted * counted / 12.0 * repetition);
        column.meanVariance += column.variances.back() / static_cast<double>(stepAt.size());
    }
}

std::optional<ObservedColumn> observedColumn(const ReferenceSeries &series, std::span<const std::size_t> rows,
                                             bool &hasSaturation)
{
    ObservedColumn column;
    column.channel = series.channel;
    const double unit = isAngle(series.channel.coordinate) ? 1.0 / kDegreesPerRadian : 1.0;
    column.values.reserve(rows.size());
    for (const std::size_t row : rows) {
        const double value = series.values[row];
        column.values.push_back(std::isfinite(value) ? value * unit : kNone);
    }
    hasSaturation |= removeSaturation(column.values, series.rounding.stepAt(rangeOf(series.values).size()) * unit);
    if (isAnglePosition(column.channel)) {
        column.hadJumps = removeJumps(column.values);
    }
    learnStatistics(column, series.rounding, unit);
    const bool isPlotted = column.channel.coordinate == R4x || column.channel.coordinate == Theta3;
    const bool counts =
        column.varies || isPlotted || isConstantByNature(column.channel) || column.channel.coordinate == Theta2;
    return counts && column.count >= 2.0 ? std::optional(std::move(column)) : std::nullopt;
}

} // namespace

bool tellsShape(const ObservedColumn &column)
{
    return column.varies && column.channel.coordinate != Theta2 && column.channel.coordinate != R4y;
}

bool isConstantByNature(Channel channel)
{
    return channel == Channel{R4y, Order::Position} || channel == Channel{Theta2, Order::Velocity};
}

double Observations::interval() const
{
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < abscissa.size(); ++i) {
        shortest = std::min(shortest, abscissa[i] - abscissa[i - 1]);
    }
    return span() / std::round(span() / shortest);
}

Observations observe(const ReferenceData &data)
{
    Observations all;
    all.rows.reserve(data.time.size());
    for (std::size_t row = 0; row < data.time.size(); ++row) {
        if (std::ranges::any_of(data.series, [&](const ReferenceSeries &series) {
                return std::isfinite(series.values[row]) && !isAlwaysZero(series.channel);
            })) {
            all.rows.push_back(row);
        }
    }
    if (all.rows.size() < 2) {
        return all;
    }
    all.isByCrankAngle = data.crank.has_value();
    const std::vector<double> &abscissa = data.crank ? data.crank->degrees : data.time;
    const double unit = data.crank ? 1.0 / kDegreesPerRadian : 1.0;
    if (abscissa[all.rows.front()] > abscissa[all.rows.back()]) { // an angle that falls
        std::ranges::reverse(all.rows);
    }
    all.abscissa.reserve(all.rows.size());
    all.origin = 0.5 * unit * (abscissa[all.rows.front()] + abscissa[all.rows.back()]);
    for (const std::size_t row : all.rows) {
        all.abscissa.push_back(abscissa[row] * unit - all.origin);
    }
    const Clock clock = data.crank ? clockOf(data.crank->degrees, data.crank->rounding) : clockOf(data);
    all.step = clock.step() * unit;
    all.printedStep = clock.printedStep * unit;
    for (const ReferenceSeries &series : data.series) {
        if (!isAlwaysZero(series.channel) && !(data.crank && series.channel == Channel{Theta2, Order::Position})) {
            if (std::optional<ObservedColumn> column = observedColumn(series, all.rows, all.hasSaturation)) {
                all.columns.push_back(*std::move(column));
            }
        }
    }
    return all;
}

Observations selection(const Observations &all, std::span<const std::size_t> rows)
{
    Observations some;
    some.origin = all.origin;
    some.isByCrankAngle = all.isByCrankAngle;
    some.step = all.step;
    some.printedStep = all.printedStep;
    for (const std::size_t row : rows) {
        some.rows.push_back(all.rows[row]);
        some.abscissa.push_back(all.abscissa[row]);
    }
    for (const ObservedColumn &whole : all.columns) {
        ObservedColumn &column = some.columns.emplace_back();
        static_cast<ColumnStatistics &>(column) = whole;
        for (const std::size_t row : rows) {
            column.values.push_back(whole.values[row]);
            column.variances.push_back(whole.variances[row]);
            column.count += std::isnan(column.values.back()) ? 0.0 : 1.0;
        }
    }
    return some;
}

Observations thinned(const Observations &all, std::size_t count)
{
    if (all.abscissa.size() <= count) {
        return all;
    }
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < count; ++k) {
        rows.push_back(k * (all.abscissa.size() - 1) / (count - 1));
    }
    return selection(all, rows);
}

} // namespace slidercrank
