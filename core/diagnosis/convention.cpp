// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnosis/convention.h"

#include "core/diagnosis/column_reading.h"
#include "core/diagnosis/explanation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// So many instants decide; of a longer file no more are looked at.
constexpr std::size_t kMostRows = 400;
/// Instants that one swing of a column must keep, or what lies between them is lost.
constexpr std::size_t kRowsPerSwing = 20;

void multiply(ReferenceSeries &series, double factor)
{
    for (double &value : series.values) {
        value *= factor;
    }
    series.rounding.unitFactor *= std::abs(factor);
}

/// A column that is to be shifted keeps its decimals, but not its significant digits.
void keepDecimals(ReferenceSeries &series)
{
    Rounding &rounding = series.rounding;
    if (rounding.rule == Rounding::Rule::SignificantDigits) {
        const double step = rounding.stepAt(rangeOf(series.values).size()) / rounding.unitFactor;
        rounding.rule = Rounding::Rule::Decimals;
        rounding.digits = -static_cast<int>(std::lround(std::log10(step)));
    }
}

void shift(ReferenceSeries &series, double amount)
{
    keepDecimals(series);
    for (double &value : series.values) {
        value += amount;
    }
}

/// How often a column goes all the way up, from the lowest to the highest quarter of its range.
std::size_t swingsOf(std::span<const double> values)
{
    const ValueRange range = rangeOf(values);
    const double low = range.low + 0.25 * range.width();
    const double high = range.high - 0.25 * range.width();
    std::size_t swings = 0;
    bool down = false;
    for (const double value : values) {
        if (down && value > high) {
            down = false;
            ++swings;
        } else if (value < low) {
            down = true;
        }
    }
    return swings;
}

/// The file, or so many instants from its start on that the motion is still to be seen between them.
ReferenceData decisiveRows(const ReferenceData &data, const std::stop_token &stop)
{
    const std::size_t rows = data.time.size();
    std::size_t stride = 1;
    if (rows > kMostRows) {
        std::size_t swings = 1;
        for (const ReferenceSeries &series : data.series) {
            if (stop.stop_requested()) {
                return {};
            }
            swings = std::max(swings, swingsOf(series.values));
        }
        stride = std::clamp<std::size_t>(rows / (swings * kRowsPerSwing), 1, rows / kMostRows);
    }

    ReferenceData some;
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, {}, series.rounding});
    }
    for (std::size_t i = 0; i < kMostRows && i * stride < rows; ++i) {
        // Not exactly every so manieth: a column may have a value in every tenth row only.
        const std::size_t row = std::min(i * stride + i % std::min<std::size_t>(stride, 13), rows - 1);
        some.time.push_back(data.time[row]);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            some.series[k].values.push_back(data.series[k].values[row]);
        }
    }
    std::erase_if(some.series,
                  [](const ReferenceSeries &series) { return rangeOf(series.values).count < kFewestValues; });
    return some;
}

} // namespace

ReferenceData applied(const Convention &convention, ReferenceData data)
{
    for (ReferenceSeries &series : data.series) {
        if (!concerns(convention, series.channel)) {
            continue;
        }
        switch (convention.kind) {
        case Kind::AngleUnit:
        case Kind::LengthUnit:
        case Kind::Sign: multiply(series, convention.amount); break;
        case Kind::TimeUnit: multiply(series, powerOf(1.0 / convention.amount, series.channel)); break;
        case Kind::HalfTurn:
        case Kind::WholeTurns:
            keepDecimals(series);
            makeContinuous(series.values);
            shift(series, convention.amount);
            break;
        case Kind::ZeroPoint: shift(series, convention.amount); break;
        case Kind::SwappedColumns:
            series.channel = convention.channels[series.channel == convention.channels[0] ? 1 : 0];
            break;
        case Kind::Branch:
        case Kind::TimeShift:
        case Kind::NotDerivative: break;
        }
    }
    switch (convention.kind) {
    case Kind::TimeUnit:
        for (double &instant : data.time) {
            instant *= convention.amount;
        }
        data.timeRounding.unitFactor *= std::abs(convention.amount);
        break;
    case Kind::TimeShift:
        for (double &instant : data.time) {
            instant += convention.amount;
        }
        break;
    case Kind::NotDerivative:
        std::erase_if(data.series, [&](const ReferenceSeries &series) { return concerns(convention, series.channel); });
        break;
    case Kind::AngleUnit:
    case Kind::LengthUnit:
    case Kind::Sign:
    case Kind::HalfTurn:
    case Kind::WholeTurns:
    case Kind::ZeroPoint:
    case Kind::SwappedColumns:
    case Kind::Branch: break;
    }
    return data;
}

std::vector<ConventionFinding> findConventions(const ReferenceData &data, const Mechanism &mechanism,
                                               std::stop_token stop)
{
    const ReferenceData rows = decisiveRows(data, stop);
    const auto isOfTheSix = [](const ReferenceSeries &series) { return isPlotted(series.channel); };
    if (stop.stop_requested() || std::ranges::none_of(rows.series, isOfTheSix)) {
        return {};
    }
    if (const auto explanation = explainedAtHand(rows, mechanism.parameters(), stop)) {
        return findingsOf(rows, *explanation);
    }
    const auto explanation = explainedByFit(rows, mechanism, stop);
    return explanation && !stop.stop_requested() ? findingsOf(rows, *explanation) : std::vector<ConventionFinding>();
}

} // namespace slidercrank
