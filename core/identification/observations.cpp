// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/observations.h"

#include "core/comparison/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

/// What every mechanism has as zeros: the ground, the slider's angle, what does not change.
bool isNothing(Channel channel)
{
    return channel.coordinate == R1x || channel.coordinate == R1y || channel.coordinate == Theta1 ||
           channel.coordinate == Theta4;
}

/// Not the derivative of what does not move, where it is zero; nor a column of the crank's or the coupler's centre that
/// nobody filled in.
bool saysSomething(const ObservedColumn &column)
{
    const Coordinate coordinate = column.channel.coordinate;
    const bool isByNatureConstant =
        coordinate == Theta2 || (coordinate == R4y && column.channel.order == Order::Position);
    return column.varies || isByNatureConstant || isPlotted(column.channel);
}

/// Takes out jumps of whole turns: between two rows the coupler turns by less than half of one. Where something that is
/// no whole turn looks like a jump, the column is in another unit, and is left as it is.
bool takeOutJumps(std::vector<double> &degrees)
{
    constexpr double kNearTurn = 90.0;
    std::vector<double> continuous = degrees;
    bool any = false;
    double last = kNone;
    double turns = 0.0;
    for (double &value : continuous) {
        if (!std::isfinite(value)) {
            continue;
        }
        if (std::isfinite(last)) {
            const double change = value + turns - last;
            const double jumps = std::round(change / 360.0);
            if (jumps != 0.0 && std::abs(change - 360.0 * jumps) > kNearTurn) {
                return false;
            }
            any = any || jumps != 0.0;
            turns -= 360.0 * jumps;
        }
        value += turns;
        last = value;
    }
    degrees = std::move(continuous);
    return any;
}

bool hasValue(const ReferenceData &data, std::size_t row)
{
    return std::ranges::any_of(data.series, [&](const ReferenceSeries &series) {
        return std::isfinite(series.values[row]) && !isNothing(series.channel);
    });
}

/// How many rows count for one: see observations.h.
double repetition(const std::vector<double> &values, std::size_t count, double step)
{
    std::size_t runs = 1;      // of the same value
    std::size_t stretches = 0; // of the same difference
    double last = kNone;
    double difference = kNone;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            continue;
        }
        if (std::isfinite(last)) {
            runs += value != last ? 1 : 0;
            stretches += std::abs(value - last - difference) <= 1e-3 * step ? 0 : 1;
            difference = value - last;
        }
        last = value;
    }
    const std::size_t independent = runs > 1 ? std::min({runs, 2 * stretches, count}) : 1;
    return static_cast<double>(count) / static_cast<double>(independent);
}

void learn(ObservedColumn &column, const Rounding &rounding)
{
    double sum = 0.0;
    ValueRange range = rangeOf(column.values);
    column.count = range.count;
    for (const double value : column.values) {
        sum += std::isfinite(value) ? value : 0.0;
    }
    column.mean = sum / static_cast<double>(std::max<std::size_t>(column.count, 1));
    double squares = 0.0;
    RoundingSteps steps(rounding);
    for (const double value : column.values) {
        if (std::isfinite(value)) {
            squares += (value - column.mean) * (value - column.mean);
            column.step = std::max(column.step, steps.at(value));
        }
    }
    // A column whose digits say nothing is taken to be as good as the others usually are.
    constexpr double kUsualStep = 1e-6;
    constexpr double kStepOfNothing = 1e-3;
    if (!(column.step > 0.0)) {
        column.step = range.size() > 0.0 ? kUsualStep * range.size() : kStepOfNothing;
    }
    column.step = std::max(column.step, kArithmeticStep * range.size());
    column.varies = range.width() > 0.0;
    column.spread = std::max(std::sqrt(squares / static_cast<double>(std::max<std::size_t>(column.count, 1))),
                             column.varies ? 0.0 : column.step);

    constexpr double kFinest = 0.01; // of the largest step
    column.repetition = repetition(column.values, column.count, column.step);
    column.variance.resize(column.values.size());
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        const double value = column.values[i];
        const double step = std::isfinite(value)
                                ? std::max({steps.at(value), kFinest * column.step, kArithmeticStep * range.size()})
                                : column.step;
        column.variance[i] = step * step / 12.0 * column.repetition;
    }
}

} // namespace

bool isPlotted(Channel channel)
{
    return channel.coordinate == Theta3 || channel.coordinate == R4x;
}

bool Observations::has(Channel channel) const
{
    return std::ranges::find(columns, channel, &ObservedColumn::channel) != columns.end();
}

bool Observations::has(Coordinate coordinate) const
{
    return std::ranges::any_of(columns,
                               [&](const ObservedColumn &column) { return column.channel.coordinate == coordinate; });
}

bool Observations::hasPositionOnly() const
{
    return std::ranges::none_of(columns, [](const ObservedColumn &column) {
        return column.channel.coordinate == Theta2 ||
               (column.channel.order != Order::Position && column.channel.coordinate != R4y);
    });
}

std::size_t Observations::valueCount() const
{
    std::size_t count = 0;
    for (const ObservedColumn &column : columns) {
        count += column.count;
    }
    return count;
}

RowRange rowsOf(const ReferenceData &data)
{
    RowRange range{0, data.time.size(), 0};
    while (range.first < range.end && !hasValue(data, range.first)) {
        ++range.first;
    }
    while (range.end > range.first && !hasValue(data, range.end - 1)) {
        --range.end;
    }
    return counted(data, range.first, range.end);
}

RowRange counted(const ReferenceData &data, std::size_t first, std::size_t end)
{
    RowRange range{first, end, 0};
    for (std::size_t row = first; row < end; ++row) {
        range.count += hasValue(data, row) ? 1 : 0;
    }
    return range;
}

std::vector<std::size_t> spreadOver(const ReferenceData &data, const RowRange &range, std::size_t most)
{
    const std::size_t count = std::min(range.count, most);
    std::vector<std::size_t> rows;
    std::size_t seen = 0;
    for (std::size_t row = range.first; row < range.end && rows.size() < count; ++row) {
        if (hasValue(data, row)) {
            const std::size_t wanted = count == 1 ? 0 : rows.size() * (range.count - 1) / (count - 1);
            if (seen++ >= wanted) {
                rows.push_back(row);
            }
        }
    }
    return rows;
}

std::vector<std::size_t> thinned(std::span<const std::size_t> rows, std::size_t most)
{
    const std::size_t count = std::min(rows.size(), most);
    std::vector<std::size_t> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = rows[count == 1 ? 0 : i * (rows.size() - 1) / (count - 1)];
    }
    return result;
}

FitUnits unitsFor(const ReferenceData &data, std::span<const std::size_t> rows, double length)
{
    FitUnits units;
    const double first = data.time[rows.front()];
    const double last = data.time[rows.back()];
    units.second = last > first ? last - first : 1.0;
    units.origin = 0.5 * (first + last);
    units.mm = length;
    bool isKnown = false;
    for (const Coordinate coordinate : {R4x, R3x, R2x, R3y, R2y}) {
        for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
            const ReferenceSeries *series = data.find({coordinate, order});
            if (!series || isKnown) {
                continue;
            }
            ValueRange range;
            for (const std::size_t row : rows) {
                const double value = series->values[row];
                if (std::isfinite(value)) {
                    range.low = std::min(range.low, value);
                    range.high = std::max(range.high, value);
                }
            }
            // A derivative's unit of time is guessed to be that of a turn in all.
            const double size =
                0.5 * range.width() * std::pow(units.second / (2.0 * std::numbers::pi), static_cast<int>(order));
            if (size > 0.0 && std::isfinite(size)) {
                units.mm = size;
                isKnown = true;
            }
        }
    }
    return units;
}

Parameters FitUnits::toFit(const Parameters &parameters) const
{
    return {parameters.a / mm,
            parameters.b / mm,
            parameters.c / mm,
            parameters.omega2 * second,
            std::remainder(parameters.omega2 * origin + parameters.theta20, 2.0 * std::numbers::pi),
            parameters.branch};
}

Parameters FitUnits::fromFit(const Parameters &fitted) const
{
    Parameters parameters{std::abs(fitted.a) * mm, std::abs(fitted.b) * mm, fitted.c * mm,
                          fitted.omega2 / second,  fitted.theta20,          fitted.branch};
    const double halfTurn = fitted.a < 0.0 ? std::numbers::pi : 0.0;
    parameters.theta20 = std::remainder(fitted.theta20 + halfTurn - parameters.omega2 * origin, 2.0 * std::numbers::pi);
    if (parameters.theta20 <= -std::numbers::pi) {
        parameters.theta20 = std::numbers::pi;
    }
    return parameters;
}

double FitUnits::factor(Channel channel) const
{
    const double unit = isAngle(channel.coordinate) ? 1.0 / kDegreesPerRadian : 1.0 / mm;
    return unit * std::pow(second, static_cast<int>(channel.order));
}

Observations observe(const ReferenceData &data, const Clock &clock, const FitUnits &units,
                     std::span<const std::size_t> rows)
{
    Observations observations;
    observations.units = units;
    observations.time.reserve(rows.size());
    for (const std::size_t row : rows) {
        observations.time.push_back(units.timeOf(data.time[row]));
    }
    observations.printedClockStep = clock.printedStep / units.second;
    observations.clockStep = clock.step() / units.second;
    for (const ReferenceSeries &series : data.series) {
        if (isNothing(series.channel)) {
            continue;
        }
        ObservedColumn column;
        column.channel = series.channel;
        column.values.reserve(rows.size());
        for (const std::size_t row : rows) {
            column.values.push_back(std::isfinite(series.values[row]) ? series.values[row] : kNone);
        }
        if (series.channel == Channel{Theta3, Order::Position}) {
            column.hasJumps = takeOutJumps(column.values);
        }
        learn(column, series.rounding);
        if (column.count >= 2 && saysSomething(column)) {
            observations.columns.push_back(std::move(column));
        }
    }
    return observations;
}

} // namespace slidercrank
