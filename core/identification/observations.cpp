// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/observations.h"

#include "core/comparison/comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

bool Supply::has(Channel channel) const
{
    const auto found = std::find(kPlottedChannels.begin(), kPlottedChannels.end(), channel);
    return counts[static_cast<std::size_t>(found - kPlottedChannels.begin())] > 0;
}

bool Supply::has(Coordinate coordinate) const
{
    return has({coordinate, Order::Position}) || has({coordinate, Order::Velocity}) ||
           has({coordinate, Order::Acceleration});
}

Supply supplyOf(const ReferenceData &data)
{
    Supply supply;
    std::array<const ReferenceSeries *, kPlottedChannels.size()> series{};
    std::ranges::transform(kPlottedChannels, series.begin(), [&](Channel channel) { return data.find(channel); });
    for (std::size_t row = 0; row < data.time.size(); ++row) {
        bool any = false;
        for (std::size_t plotted = 0; plotted < series.size(); ++plotted) {
            if (series[plotted] && std::isfinite(series[plotted]->values[row])) {
                ++supply.counts[plotted];
                ++supply.values;
                any = true;
            }
        }
        if (any) {
            supply.rows.push_back(row);
        }
    }
    return supply;
}

FitUnits unitsFor(const ReferenceData &data, const Supply &supply, double length)
{
    FitUnits units;
    units.second = data.time[supply.rows.back()] - data.time[supply.rows.front()];
    units.mm = length;
    for (const Order order : {Order::Acceleration, Order::Velocity, Order::Position}) {
        if (const ReferenceSeries *series = data.find({R4x, order})) {
            const double peak = rangeOf(series->values).size() * std::pow(units.second, static_cast<int>(order));
            units.mm = peak > 0.0 && std::isfinite(peak) ? peak : units.mm;
        }
    }
    return units;
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

std::span<const std::size_t> rowsBefore(std::span<const std::size_t> rows, std::size_t end)
{
    return rows.first(static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), end) - rows.begin()));
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

Observations observe(const ReferenceData &data, const FitUnits &units, std::span<const std::size_t> rows)
{
    Observations observations;
    observations.time.reserve(rows.size());
    for (const std::size_t row : rows) {
        observations.time.push_back(units.timeOf(data.time[row]));
    }
    for (std::size_t plotted = 0; plotted < kPlottedChannels.size(); ++plotted) {
        const ReferenceSeries *series = data.find(kPlottedChannels[plotted]);
        if (!series) {
            continue;
        }
        const double factor = units.factor(series->channel);
        ObservedChannel channel;
        channel.plotted = static_cast<Eigen::Index>(plotted);
        channel.values.resize(rows.size());
        channel.steps.resize(rows.size());
        channel.weights.resize(rows.size());
        double sum = 0.0;
        double peak = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double value = series->values[rows[i]];
            if (std::isfinite(value)) {
                channel.values[i] = factor * value;
                channel.steps[i] = factor * series->rounding.stepAt(value);
                channel.weights[i] = 1.0;
                sum += channel.values[i];
                peak = std::max(peak, std::abs(channel.values[i]));
                count += 1.0;
            }
        }
        if (count == 0.0) {
            continue;
        }
        // A column whose digits say nothing is taken to be as good as the others usually are.
        constexpr double kUsualStep = 1e-6;
        const double smallestStep =
            peak * (series->rounding.rule == Rounding::Rule::Unknown ? kUsualStep : kArithmeticStep);
        double squares = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double deviation = channel.values[i] - sum / count;
            squares += channel.weights[i] * deviation * deviation;
            channel.steps[i] = std::max(channel.steps[i], smallestStep);
        }
        channel.deviation = std::max(std::sqrt(squares / count), smallestStep);
        if (!(channel.deviation > 0.0)) {
            // Zero throughout: says next to nothing.
            channel.deviation = 1.0;
            std::fill(channel.steps.begin(), channel.steps.end(), channel.deviation);
        }
        for (double &weight : channel.weights) {
            weight /= channel.deviation;
        }
        observations.channels.push_back(std::move(channel));
    }
    return observations;
}

std::size_t valueCount(const Observations &observations)
{
    std::size_t count = 0;
    for (const ObservedChannel &channel : observations.channels) {
        count += static_cast<std::size_t>(
            std::count_if(channel.weights.begin(), channel.weights.end(), [](double weight) { return weight > 0.0; }));
    }
    return count;
}

Observations lowestOrders(Observations observations)
{
    // kPlottedChannels alternates between θ3 and R4x, the orders ascending.
    std::array<bool, 2> seen{};
    std::erase_if(observations.channels, [&](const ObservedChannel &channel) {
        return std::exchange(seen[static_cast<std::size_t>(channel.plotted % 2)], true);
    });
    return observations;
}

} // namespace slidercrank
