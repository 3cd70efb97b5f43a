// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/observations.h"

#include "core/import/clock.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kArithmeticPart = 1e-12; // relative to a column's peak: double precision guarantees no more digits

/// Channels that are zero in every mechanism.
bool isAlwaysZero(Channel channel)
{
    return channel.coordinate == R1x || channel.coordinate == R1y || channel.coordinate == Theta1 ||
           channel.coordinate == Theta4;
}

/// The number of rows for each independent observation. Rounding errors of equal values, or of values with equal
/// differences, are not independent.
double repetitionOf(const ObservedColumn &column)
{
    constexpr double kSamePart = 1e-3; // of a step: closer differences are equal
    double runs = 1.0;                 // groups of consecutive equal values
    double stretches = 0.0;            // groups of consecutive equal differences
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
    return column.count / (runs > 1.0 ? std::min(runs, 2.0 * stretches) : 1.0);
}

/// Replaces the values of a saturated sensor by gaps. Such a value is an extreme that several consecutive rows repeat,
/// much more often than rounding explains at a turning point, and that neighbouring rows approach gradually.
void removeSaturation(std::vector<double> &values, double step)
{
    constexpr std::ptrdiff_t kFewestRepeats = 5;
    constexpr std::ptrdiff_t kShortestRun = 3;
    constexpr double kMostPart = 0.35; // of the rows; with more it stands still
    constexpr double kFewSteps =
        8.0; // steps below the peak within which a parabola has twice as many values as at the peak
    constexpr double kSudden = 2.0;    // times the next change
    constexpr double kMostJumps = 0.2; // of all changes between saturated and other values
    const ValueRange range = rangeOf(values);
    for (const double limit : {range.low, range.high}) {
        double nearest = kInfinity; // distance of another value; the rounding step may be larger than the digits show
        for (const double value : values) {
            nearest = value == limit ? nearest : std::min(nearest, std::abs(value - limit));
        }
        const double tolerance = std::max({step, 0.5 * nearest, kArithmeticPart * range.size()});
        const auto repeats = std::ranges::count(values, limit);
        const auto besideLimit = std::ranges::count_if(values, [&](double value) {
            return value != limit && std::abs(value - limit) < (kFewSteps + 0.5) * tolerance;
        });
        double neighbours = 0.0;
        double jumps = 0.0;
        const bool hasRun = std::search_n(values.begin(), values.end(), kShortestRun, limit) != values.end();
        for (std::size_t i = 2; i + 1 < values.size(); ++i) {
            if ((values[i] == limit) != (values[i - 1] == limit)) {
                neighbours += 1.0;
                const double jump = std::abs(values[i] - values[i - 1]);
                const double next =
                    std::abs(values[i] == limit ? values[i - 1] - values[i - 2] : values[i + 1] - values[i]);
                jumps += jump > kSudden * next + tolerance ? 1.0 : 0.0;
            }
        }
        if (repeats >= kFewestRepeats && hasRun && 2 * besideLimit < repeats && jumps <= kMostJumps * neighbours &&
            static_cast<double>(repeats) <= kMostPart * static_cast<double>(values.size())) {
            std::ranges::replace(values, limit, kNone);
        }
    }
}

/// Computes spread, steps and variances of a column from its values. `unit`: mm or rad per unit of `rounding`.
void learnStatistics(ObservedColumn &column, const Rounding &rounding, double unit)
{
    constexpr double kUsualStep = 1e-6;   // of the peak, for values whose digits reveal no step
    constexpr double kStepOfZeros = 1e-3; // mm or rad
    constexpr double kFinestPart = 0.01;  // of the column's largest step
    const double peak = rangeOf(column.values).size();
    std::vector<double> stepAt(column.values.size(), 0.0);
    for (std::size_t i = 0; i < stepAt.size(); ++i) {
        if (const double value = column.values[i]; !std::isnan(value)) {
            stepAt[i] = rounding.stepAt(value / unit) * unit;
            column.step = std::max(column.step, stepAt[i]);
        }
    }
    const double finest = kArithmeticPart * peak;
    const double usual = peak > 0.0 ? kUsualStep * peak : kStepOfZeros;
    column.step = std::max(column.step > 0.0 ? column.step : usual, finest);
    learnSpread(column);
    const double repetition = repetitionOf(column);
    column.variances.reserve(stepAt.size());
    for (const double step : stepAt) {
        const double counted = std::max({step, kFinestPart * column.step, finest});
        column.variances.push_back(counted * counted / 12.0 * repetition);
        column.meanVariance += column.variances.back() / static_cast<double>(stepAt.size());
    }
}

/// Returns nullopt if the column contains no information. `span`: of the abscissa.
std::optional<ObservedColumn> observedColumn(const ReferenceSeries &series, std::span<const std::size_t> rows,
                                             double span)
{
    constexpr double kZero = 1e-8; // mm or rad, change in the time of the file: rounding errors
    ObservedColumn column;
    column.channel = series.channel;
    column.unitOfHeading = series.rounding.unitFactor;
    const double unit = isAngle(series.channel.coordinate) ? 1.0 / kDegreesPerRadian : 1.0;
    column.values.reserve(rows.size());
    for (const std::size_t row : rows) {
        const double value = series.values[row];
        column.values.push_back(std::isfinite(value) ? value * unit : kNone);
    }
    removeSaturation(column.values, series.rounding.stepAt(rangeOf(series.values).size()) * unit);
    if (isAngle(column.channel.coordinate) && column.channel.order == Order::Position) {
        column.hadJumps = removeJumps(column.values, kTurn);
    }
    // A wrapped angle was as large as 360° when it was rounded.
    learnStatistics(column, column.hadJumps ? series.rounding.withDecimalsAt(360.0) : series.rounding, unit);
    const bool counts = column.varies || isPlotted(column.channel) || isConstantByNature(column.channel) ||
                        column.channel.coordinate == Theta2;
    const int order = static_cast<int>(column.channel.order);
    const bool isRoundingOfZero = column.varies && order > 0 && column.range * std::pow(span, order) < kZero;
    return counts && !isRoundingOfZero && column.count >= 2.0 ? std::optional(std::move(column)) : std::nullopt;
}

} // namespace

void learnSpread(ObservedColumn &column)
{
    const ValueRange range = rangeOf(column.values);
    column.count = static_cast<double>(range.count);
    column.range = range.width();
    column.varies = column.range > 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (const double value : column.values) {
        sum += std::isnan(value) ? 0.0 : value;
    }
    column.mean = sum / column.count;
    for (const double value : column.values) {
        squares += std::isnan(value) ? 0.0 : (value - column.mean) * (value - column.mean);
    }
    column.spread = std::max(std::sqrt(squares / column.count), column.varies ? 0.0 : column.step);
}

bool tellsShape(const ObservedColumn &column)
{
    return column.varies && column.channel.coordinate != Theta2 && column.channel.coordinate != R4y;
}

bool isShapeDerivative(const ObservedColumn &column)
{
    return tellsShape(column) && column.channel.order != Order::Position;
}

bool isConstantByNature(Channel channel)
{
    return channel == Channel{R4y, Order::Position} || channel == Channel{Theta2, Order::Velocity};
}

double Observations::interval() const
{
    double shortest = kInfinity;
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
    if (abscissa[all.rows.front()] > abscissa[all.rows.back()]) { // a decreasing crank angle
        std::ranges::reverse(all.rows);
    }
    all.abscissa.reserve(all.rows.size());
    all.origin = 0.5 * unit * (abscissa[all.rows.front()] + abscissa[all.rows.back()]);
    for (const std::size_t row : all.rows) {
        all.abscissa.push_back(abscissa[row] * unit - all.origin);
    }
    const Clock clock =
        data.crank ? clockOf(data.crank->degrees, data.crank->rounding) : clockOf(data.time, data.timeRounding);
    all.step = clock.step() * unit;
    all.printedStep = clock.printedStep * unit;
    all.unitOfHeading = (data.crank ? data.crank->rounding : data.timeRounding).unitFactor;
    for (const ReferenceSeries &series : data.series) {
        if (!isAlwaysZero(series.channel) && !(data.crank && series.channel == Channel{Theta2, Order::Position})) {
            if (std::optional<ObservedColumn> column = observedColumn(series, all.rows, all.span())) {
                all.columns.push_back(*std::move(column));
            }
        }
    }
    return all;
}

Observations selection(const Observations &all, std::span<const std::size_t> rows)
{
    Observations some{
        valuesAt(all.abscissa, rows), all.origin, all.isByCrankAngle, all.step, all.printedStep, all.unitOfHeading,
        valuesAt(all.rows, rows),     {}};
    for (const ObservedColumn &whole : all.columns) {
        ObservedColumn &column = some.columns.emplace_back();
        static_cast<ColumnStatistics &>(column) = whole;
        column.values = valuesAt(whole.values, rows);
        column.variances = valuesAt(whole.variances, rows);
        column.count = static_cast<double>(rangeOf(column.values).count);
    }
    return some;
}

std::vector<std::size_t> spreadRows(std::size_t end, std::size_t count)
{
    const std::size_t used = std::min(count, end);
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < used; ++k) {
        rows.push_back(k * (end - 1) / (used - 1));
    }
    return rows;
}

Observations thinned(const Observations &all, std::size_t count)
{
    return selection(all, spreadRows(all.abscissa.size(), count));
}

} // namespace slidercrank
