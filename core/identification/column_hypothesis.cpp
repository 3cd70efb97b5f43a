// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/column_hypothesis.h"

#include "core/identification/unit_and_sense.h"
#include "core/identification/candidate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Ratios of mm, cm, m, in.
constexpr std::array<double, 12> kLengthFactors{10.0,       1e3,       25.4,       1e2,       1e3 / 25.4, 2.54,
                                                1.0 / 10.0, 1.0 / 1e3, 1.0 / 25.4, 1.0 / 1e2, 25.4 / 1e3, 1.0 / 2.54};

/// A start is no better known than that: what is met so well is met, and needs no other reading.
constexpr double kMet = 0.01;

bool hasOrigin(Channel channel)
{
    return channel.order == Order::Position && (channel.coordinate == R4x || channel.coordinate == R4y ||
                                                channel.coordinate == Theta2 || channel.coordinate == Theta3);
}

} // namespace

ColumnMatch::ColumnMatch(const ObservedColumn &column, Channel channel, std::span<const double> model)
    : m_column(column)
    , m_channel(channel)
    , m_model(model)
{
    for (std::size_t i = 0; i < model.size(); ++i) {
        const double y = column.values[i];
        const double m = model[i];
        if (!std::isnan(y)) {
            m_n += 1.0;
            m_y += y;
            m_m += m;
            m_yy += y * y;
            m_mm += m * m;
            m_my += m * y;
        }
    }
}

double ColumnMatch::score(double factor, bool isTurned, bool isZeroFree) const
{
    double mean = 0.0;
    if (isTurning(m_channel)) {
        // Without turns anything is an angle: only what varies as the model does.
        const double modelSpread = std::sqrt(std::max(m_mm / m_n - m_m * m_m / (m_n * m_n), 0.0));
        const double ratio = std::abs(factor) * m_column.spread / modelSpread;
        if (m_channel.coordinate != Theta2 && !(ratio > 0.5 && ratio < 2.0)) {
            return 0.0;
        }
        mean = meanOfTurning(factor, isTurned, isZeroFree);
    } else {
        const double sum = m_m - factor * m_y;
        const double squares = m_mm - 2.0 * factor * m_my + factor * factor * m_yy;
        mean = (squares - (isZeroFree ? sum * sum / m_n : 0.0)) / m_n;
    }
    constexpr double kOfAConstant = 0.05; // of the model's size
    const double size =
        std::abs(factor) * std::max(m_column.spread, m_column.varies ? 0.0 : kOfAConstant * std::sqrt(m_mm / m_n));
    const double part = std::max(mean / (size * size), kMet * kMet);
    return part < kExplained * kExplained ? m_n * std::log(part) : 0.0;
}

double ColumnMatch::factor() const
{
    return m_yy > 0.0 ? m_my / m_yy : 0.0;
}

double ColumnMatch::factorAboutMeans() const
{
    const double yy = m_yy - m_y * m_y / m_n;
    return yy > 0.0 ? (m_my - m_m * m_y / m_n) / yy : 0.0;
}

double ColumnMatch::correlation() const
{
    const double yy = m_yy - m_y * m_y / m_n;
    const double mm = m_mm - m_m * m_m / m_n;
    return (m_my - m_m * m_y / m_n) / std::sqrt(std::max(yy * mm, 1e-300));
}

double ColumnMatch::meanOfTurning(double factor, bool isTurned, bool isZeroFree) const
{
    const double turn = isTurned ? 180.0 : 0.0;
    double first = kNone;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < m_model.size(); ++i) {
        if (std::isnan(m_column.values[i])) {
            continue;
        }
        double residual = factor * m_column.values[i] + turn - m_model[i];
        if (isZeroFree) {
            first = std::isnan(first) ? residual : first;
            residual -= first;
        }
        residual -= 360.0 * std::nearbyint(residual / 360.0);
        sum += residual;
        squares += residual * residual;
    }
    return (squares - (isZeroFree ? sum * sum / m_n : 0.0)) / m_n;
}

Ways waysOf(const ObservedColumn &column, Channel channel, std::span<const double> model, double timeUnit,
            std::size_t values)
{
    const ColumnMatch match(column, channel, model);
    Ways ways;
    const bool canShift = hasOrigin(channel);
    const auto consider = [&](ColumnHypothesis one) {
        const double factor = one.sign * one.unit * (one.isPerSecond ? powerOf(timeUnit, channel) : 1.0);
        Scored scored{one, match.score(factor, one.isTurned, one.isZeroFree), 0.0};
        const double perCause = kPriceOfCause + kPriceOfColumn;
        scored.price = (one.unit != 1.0 ? perCause : 0.0) + (one.sign < 0.0 ? perCause : 0.0) +
                       (one.isPerSecond ? kPriceOfColumn : 0.0) + (one.isTurned ? kPriceOfHalfTurn : 0.0) +
                       (one.isZeroFree ? priceOfZero(channel) + std::log(static_cast<double>(values)) : 0.0);
        return scored;
    };
    ways.plain = consider({channel});
    ways.shifted = ways.plain;
    if (canShift) {
        ColumnHypothesis shifted{channel};
        shifted.isZeroFree = true;
        ways.shifted = consider(shifted);
    }
    ways.best = ways.shifted.total() < ways.plain.total() ? ways.shifted : ways.plain;
    const bool isNothing = std::ranges::none_of(column.values, [](double value) { return std::abs(value) > 0.0; });
    if (isNothing || ways.plain.score <= 1.99 * match.count() * std::log(kMet)) {
        return ways; // zeros are zeros in every unit
    }
    const auto improve = [&](const ColumnHypothesis &one) {
        const Scored scored = consider(one);
        if (scored.score < 0.0 && scored.total() < ways.best.total()) {
            ways.best = scored;
        }
    };
    const auto improveInAllOrigins = [&](ColumnHypothesis one) {
        improve(one);
        if (canShift) {
            one.isZeroFree = true;
            improve(one);
        }
    };
    if (channel.order != Order::Position && timeUnit != 1.0) {
        ColumnHypothesis one{channel};
        one.isPerSecond = true;
        improve(one);
        one.sign = -1.0;
        improve(one);
    }
    if (isTurning(channel)) {
        for (const double unit : {1.0, kAngleFactors[0], kAngleFactors[1]}) {
            for (const double sign : {1.0, -1.0}) {
                for (const bool isTurned : {false, true}) {
                    ColumnHypothesis one{channel};
                    one.unit = unit;
                    one.sign = sign;
                    one.isTurned = isTurned && channel.coordinate == Theta3;
                    improveInAllOrigins(one);
                }
            }
        }
        return ways;
    }
    const std::span<const double> units =
        isAngle(channel.coordinate) ? std::span<const double>(kAngleFactors) : std::span<const double>(kLengthFactors);
    ColumnHypothesis negated{channel};
    negated.sign = -1.0;
    improveInAllOrigins(negated);
    constexpr double kNear = 0.05;
    const std::array<double, 2> factors{match.factor(), match.factorAboutMeans()};
    for (const double unit : units) {
        for (const bool isPerSecond : {false, true}) {
            if (isPerSecond && (timeUnit == 1.0 || channel.order == Order::Position)) {
                continue;
            }
            const double whole = unit * (isPerSecond ? powerOf(timeUnit, channel) : 1.0);
            for (const double factor : factors) {
                if (std::abs(std::abs(factor) / whole - 1.0) <= kNear) {
                    ColumnHypothesis one{channel};
                    one.unit = unit;
                    one.sign = factor < 0.0 ? -1.0 : 1.0;
                    one.isPerSecond = isPerSecond;
                    improveInAllOrigins(one);
                }
            }
        }
    }
    return ways;
}

} // namespace slidercrank
