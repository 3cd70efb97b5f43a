// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of a ClaimTable that change its motion or its columns.
#include "tests/support/claim_table.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Content = ClaimColumn::Content;

} // namespace

ClaimTable &ClaimTable::change(const Channels &channels, Content content, const Change &change)
{
    compute();
    for (ClaimColumn &column : columns) {
        const bool isSelected = channels.empty() || std::ranges::any_of(channels, [&](Channel channel) {
                                    return column.heading == nameOf(channel);
                                });
        if (isSelected) {
            change(column);
            column.content = std::max(column.content, content);
        }
    }
    return *this;
}

// The motion.

/// Replaces the motion by one whose positions are a function of time. Its derivatives are computed numerically.
ClaimTable &ClaimTable::setPositions(const std::function<double(Channel, double)> &positions)
{
    m_motion = [=, step = 1e-3 / std::abs(truth->omega2)](Channel channel, double t) {
        const Channel position{channel.coordinate, Order::Position};
        const double before = positions(position, t - step);
        const double after = positions(position, t + step);
        switch (channel.order) {
        case Order::Position: break;
        case Order::Velocity: return (after - before) / (2.0 * step);
        case Order::Acceleration: return (after - 2.0 * positions(position, t) + before) / (step * step);
        }
        return positions(position, t);
    };
    return *this;
}

ClaimTable &ClaimTable::turnedBy(const std::function<double(double)> &law)
{
    isCrankUneven = true;
    return setPositions([=, p = *truth](Channel channel, double t) {
        return valueAt(p, channel, p.theta20 + std::copysign(1.0, p.omega2) * law(std::abs(p.omega2) * t));
    });
}

ClaimTable &ClaimTable::speedingUp(double fraction)
{
    return turnedBy([=](double angle) { return angle * (1.0 + 0.5 * fraction / kTurn * angle); });
}

ClaimTable &ClaimTable::rippling(double fraction, double perTurn)
{
    return turnedBy([=](double angle) { return angle + fraction / perTurn * (1.0 - std::cos(perTurn * angle)); });
}

ClaimTable &ClaimTable::ofYoke(double damping, double third)
{
    return setPositions([=, p = *truth](Channel channel, double t) {
        const double angle = p.omega2 * t + p.theta20;
        return channel.coordinate == Theta2 ? toFileUnit(channel, angle)
                                            : 3.0 * p.a + p.a * std::exp(-damping * std::abs(p.omega2) * t) *
                                                              (std::cos(angle) + third * std::cos(3.0 * angle));
    });
}

// Conventions.

ClaimTable &ClaimTable::reprinted()
{
    return change(kAllColumns, Content::Motion, [](ClaimColumn &column) { column.reprint = "%.18e"; });
}

/// Multiplied lengths are lengths in a different unit, and the mechanism in that unit explains the file equally well.
ClaimTable &ClaimTable::multiplied(const Channels &channels, double factor)
{
    return change(channels, Content::Motion, [&](ClaimColumn &column) {
        column.values *= factor;
        column.factor *= factor;
        column.noise *= std::abs(factor);
        others.push_back(enlarged(*truth, isAngle(column.shown.coordinate) ? 1.0 : std::abs(factor)));
    });
}

/// Multiplied times are times in a different unit, and a crank with the speed in that unit explains the file equally
/// well.
ClaimTable &ClaimTable::timeMultiplied(double factor)
{
    compute();
    time.values *= factor;
    time.factor *= factor;
    return orMechanism(withSpeed(*truth, truth->omega2 / factor));
}

ClaimTable &ClaimTable::shifted(const Channels &channels, double amount)
{
    return change(channels, Content::Motion, [=](ClaimColumn &column) {
        column.values += amount;
        column.hasOrigin = true;
    });
}

ClaimTable &ClaimTable::withinATurn(Channel channel)
{
    return change({channel}, Content::Motion,
                  [](ClaimColumn &column) { column.values -= 360.0 * (column.values / 360.0).floor(); });
}

// Errors of sensors.

ClaimTable &ClaimTable::withUnevenNoise(const Channels &channels, const UnevenNoise &uneven)
{
    const bool isWhite = uneven.correlation == 0.0 && uneven.growth == 0.0;
    return change(channels, isWhite ? Content::Motion : Content::Systematic, [=, this](ClaimColumn &column) {
        const double correlation = uneven.correlation;
        Values noise = m_random.normal(times.size());
        for (Index row = 1; row < noise.size(); ++row) {
            noise[row] = correlation * noise[row - 1] + std::sqrt(1.0 - correlation * correlation) * noise[row];
        }
        column.noise = uneven.fraction * swing(column.shown) * std::abs(column.factor);
        const Values readings = column.values.abs();
        column.values += column.noise * noise * (1.0 + uneven.growth * readings / readings.maxCoeff());
    });
}

ClaimTable &ClaimTable::withNoise(const Channels &channels, double fraction)
{
    return withUnevenNoise(channels, {.fraction = fraction});
}

ClaimTable &ClaimTable::truncated(const Channels &channels, double step)
{
    return change(channels, Content::Motion, [=](ClaimColumn &column) {
        column.quantum = step;
        column.values = step * (column.values / step).floor();
    });
}

ClaimTable &ClaimTable::inSteps(const Channels &channels, double step)
{
    return change(channels, Content::Motion, [=](ClaimColumn &column) { column.values += 0.5 * step; })
        .truncated(channels, step);
}

ClaimTable &ClaimTable::withTone(const Channels &channels, const Tone &tone)
{
    return change(channels, Content::Systematic, [=, this](ClaimColumn &column) {
        const Values angles = tone.perTurn * truth->omega2 * times + m_random.between(0.0, kTurn);
        column.values += tone.fraction * swing(column.shown) * angles.sin();
    });
}

ClaimTable &ClaimTable::withBacklash(Channel channel, double fraction)
{
    return change({channel}, Content::Systematic, [=, this](ClaimColumn &column) {
        column.values += fraction * swing(column.shown) * exact(kSliderSpeed, times).sign();
    });
}

ClaimTable &ClaimTable::misread(Channel channel, const Misreading &misreading)
{
    return change({channel}, Content::Motion, [=, this](ClaimColumn &column) {
        const double rows = static_cast<double>(times.size());
        for (int count = static_cast<int>(m_random.between(1.0, 0.03 * rows)); count > 0; --count) {
            const Index row = 1 + m_random.index(times.size() - 2);
            const double wrong = misreading.factor * column.values[row] + misreading.offset;
            if (std::abs(wrong - column.values[row]) > 0.05 * swing(column.shown)) {
                column.values[row] = wrong;
                badRows.insert(row);
            }
        }
    });
}

ClaimTable &ClaimTable::mistyped(Channel channel)
{
    return change({channel}, Content::Motion, [this](ClaimColumn &column) {
        const Index row = m_random.index(times.size());
        const double value = column.values[row];
        const double deviation = m_random.eitherSign(0.01, 0.05) * swing(column.shown);
        const double wrong = m_random.oneOf({-value, 10.0 * value, 0.1 * value, value + deviation});
        if (std::abs(wrong - value) > 20.0 * column.stepAt(value)) { // a smaller error may look like rounding
            column.values[row] = wrong;
            badRows.insert(row);
        }
    });
}

ClaimTable &ClaimTable::failing(Channel channel, double probability, double fraction)
{
    return change({channel}, Content::Systematic, [=, this](ClaimColumn &column) {
        for (double &value : column.values) {
            value -= m_random.isTrue(probability) ? m_random.between(0.0, fraction) * swing(column.shown) : 0.0;
        }
    });
}

ClaimTable &ClaimTable::frozen(Channel channel)
{
    return change({channel}, Content::Motion, [this](ClaimColumn &column) {
        const double rows = static_cast<double>(times.size());
        const auto first = static_cast<Index>(m_random.between(0.1 * rows, 0.8 * rows));
        for (Index row = first + static_cast<Index>(m_random.between(1.0, 0.025 * rows)); row > first; --row) {
            column.values[row] = column.values[first];
            badRows.insert(row);
        }
    });
}

ClaimTable &ClaimTable::saturated(Channel channel, double fraction)
{
    return change({channel}, Content::Motion, [=, this](ClaimColumn &column) {
        const double limit = column.values.maxCoeff() - 2.0 * fraction * swing(column.shown);
        hasSaturation = true;
        for (Index row = 0; row < times.size(); ++row) {
            if (column.values[row] > limit - 1e-6 * swing(column.shown)) { // printed like the limit
                column.values[row] = limit;
                badRows.insert(row);
            }
        }
    });
}

ClaimTable &ClaimTable::withGaps(const Channels &channels, double probability)
{
    return change(channels, Content::Motion, [=, this](ClaimColumn &column) {
        // The first row keeps its values, because the import finds the table by its first row of numbers.
        for (Index row = 1; row < times.size(); ++row) {
            column.values[row] = m_random.isTrue(probability) ? kNone : column.values[row];
        }
    });
}

ClaimTable &ClaimTable::withoutABlock(const Channels &channels)
{
    return change(channels, Content::Motion, [this](ClaimColumn &column) {
        column.values.segment(times.size() / 4, times.size() / 5).setConstant(kNone);
    });
}

// Filters and clocks.

ClaimTable &ClaimTable::smoothed(const Channels &channels, const WeightedMean &mean)
{
    const auto [before, after, decay] = mean;
    const Values lags = Values::LinSpaced(before + after + 1, -after, before);
    const Values weights = (-decay * lags.abs()).exp() / (-decay * lags.abs()).exp().sum();
    compute();
    delay = (weights * lags).sum() * timeBetweenRows();
    return change(channels, Content::Systematic, [&](ClaimColumn &column) {
        column.values.setZero();
        for (Index k = 0; k < lags.size(); ++k) {
            column.values += weights[k] * exact(column.shown, times - lags[k] * timeBetweenRows());
        }
    });
}

ClaimTable &ClaimTable::interpolated(const Channels &channels, double rows)
{
    return change(channels, Content::Systematic, [=, this](ClaimColumn &column) {
        const double coarse = rows * timeBetweenRows();
        const Values before = times[0] + coarse * ((times - times[0]) / coarse).floor();
        const Values fraction = (times - before) / coarse;
        column.values =
            (1.0 - fraction) * exact(column.shown, before) + fraction * exact(column.shown, before + coarse);
    });
}

ClaimTable &ClaimTable::held(const Channels &channels, double rows)
{
    return change(channels, Content::Systematic, [=, this](ClaimColumn &column) {
        const double coarse = rows * timeBetweenRows();
        delay = 0.5 * coarse; // on average
        column.values = exact(column.shown, times[0] + coarse * ((times - times[0]) / coarse).floor());
    });
}

ClaimTable &ClaimTable::jittered(const Channels &channels, double fraction)
{
    return change(channels, Content::Systematic, [=, this](ClaimColumn &column) {
        column.values = exact(column.shown, times + fraction * timeBetweenRows() * m_random.normal(times.size()));
    });
}

// Values that do not belong to the motion.

ClaimTable &ClaimTable::delayed(const Channels &channels, double rows)
{
    compute();
    orMechanism(withStart(*truth, truth->theta20 - truth->omega2 * rows * timeBetweenRows()));
    return change(channels, Content::Foreign, [=, this](ClaimColumn &column) {
        column.values = exact(column.shown, times - rows * timeBetweenRows());
    });
}

ClaimTable &ClaimTable::amplified(const Channels &channels, double factor)
{
    return change(channels, Content::Foreign, [=](ClaimColumn &column) { column.values *= factor; });
}

ClaimTable &ClaimTable::ofLongerCoupler(const Channels &channels, double factor)
{
    Parameters longer = *truth;
    longer.b *= factor;
    return orMechanism(longer).change(channels, Content::Foreign, [&](ClaimColumn &column) {
        column.values = valuesOf(longer, column.shown, times);
    });
}

ClaimTable &ClaimTable::differentiated(const Channels &channels, int rows)
{
    const Values lags = Values::LinSpaced(2 * rows + 1, -rows, rows);
    const Values squares = lags.square() - lags.square().mean();
    return change(channels, Content::Foreign, [&](ClaimColumn &column) {
        const double step = timeBetweenRows();
        const bool isVelocity = column.shown.order == Order::Velocity;
        const Values weights = isVelocity ? Values(lags / lags.square().sum() / step)
                                          : Values(2.0 * squares / squares.square().sum() / step / step);
        const ClaimColumn &source = *find(std::string(nameOf({column.shown.coordinate, Order::Position})));
        const Values positions = source.values.unaryExpr([&](double value) { return std::stod(source.print(value)); });
        column.values.setConstant(kNone);
        column.noise = 0.0;
        for (Index row = rows; row + rows < positions.size(); ++row) {
            column.values[row] = (weights * positions.segment(row - rows, lags.size())).sum();
        }
    });
}

ClaimTable &ClaimTable::replacedByRandom(const Channels &channels)
{
    return change(channels, Content::Foreign, [this](ClaimColumn &column) {
        for (double &value : column.values) {
            value = m_random.between(-100.0, 100.0);
        }
    });
}

} // namespace slidercrank
