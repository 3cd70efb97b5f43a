// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/hypothesis.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

bool ColumnUse::isHalfTurned() const
{
    return std::remainder(turn / std::numbers::pi, 2.0) != 0.0;
}

bool Hypothesis::isFreeUnknown(Eigen::Index index) const
{
    const auto k = static_cast<std::size_t>(index);
    if (k < kParameterCount) {
        return isFree[k];
    }
    const ColumnUse &column = columns[(k - kParameterCount) / 2];
    return column.isUsed && (index == offsetIndex((k - kParameterCount) / 2) ? column.hasOffset : column.hasScale);
}

Parameters middleParameters(const Hypothesis &hypothesis)
{
    const Eigen::VectorXd &q = hypothesis.unknowns;
    return {std::abs(q[0]),
            std::abs(q[1]),
            q[2],
            q[3],
            q[4] + (q[0] < 0.0 ? std::numbers::pi : 0.0),
            hypothesis.side > 0.0 ? Branch::Open : Branch::Crossed};
}

void setMiddleParameters(const Parameters &middle, Hypothesis &hypothesis)
{
    hypothesis.unknowns.setZero(Hypothesis::offsetIndex(hypothesis.columns.size()));
    hypothesis.unknowns.head(5) << middle.a, middle.b, middle.c, middle.omega2, middle.theta20;
    hypothesis.side = middle.branch == Branch::Open ? 1.0 : -1.0;
}

Parameters parametersOf(const Observations &data, const Hypothesis &hypothesis)
{
    Parameters p = middleParameters(hypothesis);
    p.theta20 = std::remainder(p.theta20 - p.omega2 * data.origin, kTurn);
    p.omega2 /= hypothesis.timeUnit;
    return p;
}

std::array<double, kParameterCount> comparisonSizes(const Parameters &p)
{
    return {p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
}

bool areNear(const Parameters &x, const Parameters &y, double part,
             const std::array<double, kParameterCount> &standardErrors)
{
    constexpr double kErrors = 5.0;
    const std::array sizes = comparisonSizes(x);
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        const auto parameter = static_cast<Parameter>(i);
        double difference = valueOf(x, parameter) - valueOf(y, parameter);
        difference = parameter == Parameter::Theta20 ? std::remainder(difference, kTurn) : difference;
        if (!(std::abs(difference) <= std::fmax(part * sizes[i], kErrors * standardErrors[i]))) { // fmax ignores NaN
            return false;
        }
    }
    return x.branch == y.branch;
}

std::vector<ColumnUse> plainColumns(const Observations &data)
{
    std::vector<ColumnUse> columns;
    for (const ObservedColumn &column : data.columns) {
        columns.push_back({column.channel});
    }
    return columns;
}

double interpretedSpread(const Observations &data, const Hypothesis &hypothesis, std::size_t column)
{
    return data.columns[column].spread * std::abs(hypothesis.columns[column].factor());
}

double sizeOf(const Observations &data, const Hypothesis &hypothesis, std::size_t column)
{
    const Channel channel = data.columns[column].channel;
    return isConstantByNature(channel) ? std::abs(hypothesis.unknowns[channel.coordinate == R4y ? 0 : 3])
                                       : interpretedSpread(data, hypothesis, column);
}

double ColumnRegression::unexplained() const
{
    constexpr double kArithmetic = 1e-15;
    const double both = modelSquares * valueSquares;
    return both > 0.0 ? std::clamp(1.0 - products * products / both, kArithmetic, 1.0) : 1.0;
}

double ColumnRegression::slope() const
{
    return modelSquares > 0.0 ? products / modelSquares : 0.0;
}

double ColumnRegression::meanSquare(double factor, double size) const
{
    return std::max((factor * factor * valueSquares - 2.0 * factor * size * products + size * size * modelSquares) / n,
                    0.0);
}

double ColumnRegression::offset(double factor, double size) const
{
    return factor * (meanValue + center) - size * meanModel;
}

std::vector<ColumnRegression> columnRegressions(const Observations &data, const Hypothesis &hypothesis)
{
    std::vector<ColumnRegression> regressions(data.columns.size());
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        regressions[j].center = data.columns[j].mean;
    }
    const auto add = [&](std::size_t row, std::size_t column, double model, double) {
        ColumnRegression &sums = regressions[column];
        const double value = data.columns[column].values[row] - sums.center;
        sums.n += 1.0;
        sums.meanModel += model;
        sums.meanValue += value;
        sums.modelSquares += model * model;
        sums.valueSquares += value * value;
        sums.products += model * value;
    };
    if (!forEachResidual<double>(data, hypothesis, add)) {
        return {};
    }
    for (ColumnRegression &sums : regressions) {
        const double n = std::max(sums.n, 1.0);
        sums.meanModel /= n;
        sums.meanValue /= n;
        sums.modelSquares = std::max(sums.modelSquares - n * sums.meanModel * sums.meanModel, 0.0);
        sums.valueSquares = std::max(sums.valueSquares - n * sums.meanValue * sums.meanValue, 0.0);
        sums.products -= n * sums.meanModel * sums.meanValue;
    }
    return regressions;
}

} // namespace slidercrank
