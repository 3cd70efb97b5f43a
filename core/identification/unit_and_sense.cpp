// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/unit_and_sense.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// A factor between a column and the model is a unit's when it is this near to it: units lie further apart.
constexpr double kUnitTolerance = 0.05;
/// A column reads as a channel when no value is farther off, as part of how much the channel varies. The mechanism may
/// be known from one column only, and not well; that it is the one is then for kNearlyNothing to say.
constexpr double kLooselyEqual = 0.05;

constexpr std::array<double, 3> kAngleUnits{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian};
/// Ratios of mm, cm, m, in.
constexpr std::array<double, 13> kLengthUnits{
    1.0, 10.0, 1e3, 25.4, 1e2, 1e3 / 25.4, 2.54, 1.0 / 10.0, 1.0 / 1e3, 1.0 / 25.4, 1.0 / 1e2, 25.4 / 1e3, 1.0 / 2.54};

/// A column and what a channel would have in its place. Rows where either has no number do not count.
class ColumnPair
{
public:
    ColumnPair(std::span<const double> values, std::span<const double> model)
        : m_values(values)
        , m_model(model)
        , m_size(sizeOf(model))
    {
        std::size_t count = 0;
        std::size_t missing = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isfinite(values[i]) && std::isfinite(model[i])) {
                ++count;
                m_valueSquares += values[i] * values[i];
                m_products += values[i] * model[i];
            } else if (std::isfinite(values[i])) {
                ++missing;
            }
        }
        // A derivative does not exist at a toggle; a position that does not exist is another mechanism's.
        constexpr std::size_t kPresentForOneMissing = 20;
        m_comparable = count >= kFewestValues && count >= kPresentForOneMissing * missing;
    }

    bool comparable() const { return m_comparable; }

    /// The factor that brings the values nearest to the model.
    double bestFactor() const { return m_valueSquares > 0.0 ? m_products / m_valueSquares : 0.0; }

    /// The same reading with its misfit (infinite where it is too much), and, where it may turn, by how much.
    UnitAndSense measured(UnitAndSense reading) const
    {
        bool first = true;
        double largest = 0.0;
        for (std::size_t i = 0; i < m_values.size(); ++i) {
            double error = reading.factor() * m_values[i] + reading.turn - m_model[i];
            if (!std::isfinite(error)) {
                continue;
            }
            if (reading.turned) {
                if (first) {
                    reading.turn = -180.0 * std::round(error / 180.0);
                    error += reading.turn;
                    first = false;
                }
                error -= 360.0 * std::round(error / 360.0); // a jump that makeContinuous() takes out
            }
            largest = std::max(largest, std::abs(error));
            if (largest > kLooselyEqual * m_size) {
                reading.misfit = std::numeric_limits<double>::infinity();
                return reading;
            }
        }
        reading.misfit = largest == 0.0 ? 0.0 : largest / m_size; // of a channel of zeros, nothing else
        return reading;
    }

private:
    std::span<const double> m_values;
    std::span<const double> m_model;
    double m_size;
    double m_valueSquares = 0.0;
    double m_products = 0.0;
    bool m_comparable = false;
};

} // namespace

double powerOf(double base, Channel channel)
{
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return base;
    case Order::Acceleration: return base * base;
    }
    return 1.0;
}

void makeContinuous(std::span<double> degrees)
{
    double last = std::numeric_limits<double>::quiet_NaN();
    for (double &value : degrees) {
        if (std::isfinite(value)) {
            if (std::isfinite(last)) {
                value -= 360.0 * std::round((value - last) / 360.0);
            }
            last = value;
        }
    }
}

double sizeOf(std::span<const double> values)
{
    constexpr double kVaries = 1e-3; // of the largest magnitude
    const ValueRange range = rangeOf(values);
    return range.width() > kVaries * range.size() ? range.width() : range.size();
}

std::optional<UnitAndSense> unitAndSenseOf(Channel channel, std::span<const double> values,
                                           std::span<const double> model, double timeUnit)
{
    const ColumnPair pair(values, model);
    if (!pair.comparable()) {
        return std::nullopt;
    }
    std::optional<UnitAndSense> best;
    const auto consider = [&](const UnitAndSense &candidate) {
        const UnitAndSense reading = pair.measured(candidate);
        if (reading.misfit <= kLooselyEqual && (!best || reading.steps() < best->steps() ||
                                                (reading.steps() == best->steps() && reading.misfit < best->misfit))) {
            best = reading;
        }
    };
    consider({});
    if (best) {
        return best;
    }
    if (isAngle(channel.coordinate) && channel.order == Order::Position) {
        for (const double unit : kAngleUnits) {
            for (const double sign : {1.0, -1.0}) {
                for (const bool turned : {false, true}) {
                    consider({unit, 1.0, sign, turned});
                }
            }
        }
        return best;
    }
    const double factor = pair.bestFactor();
    const double perTimeUnit = powerOf(1.0 / timeUnit, channel);
    const auto considerUnits = [&](std::span<const double> units) {
        for (const double unit : units) {
            for (const double derivative : {1.0, perTimeUnit}) {
                if (std::abs(std::abs(factor) / (unit * derivative) - 1.0) <= kUnitTolerance) {
                    consider({unit, derivative, factor < 0.0 ? -1.0 : 1.0});
                }
            }
        }
    };
    isAngle(channel.coordinate) ? considerUnits(kAngleUnits) : considerUnits(kLengthUnits);
    return best;
}

} // namespace slidercrank
