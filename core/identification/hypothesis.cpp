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

std::size_t Hypothesis::freeParameterCount() const
{
    const UnknownLayout layout(columns);
    return static_cast<std::size_t>(std::ranges::count(isFree, true)) + static_cast<std::size_t>(layout.size) -
           kParameterCount;
}

UnknownLayout::UnknownLayout(const std::vector<ColumnUse> &columns)
{
    for (const ColumnUse &column : columns) {
        offset.push_back(column.isUsed && column.hasOffset ? size++ : -1);
        scale.push_back(column.isUsed && column.hasScale ? size++ : -1);
    }
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
    hypothesis.unknowns.resize(static_cast<Eigen::Index>(kParameterCount));
    hypothesis.unknowns << middle.a, middle.b, middle.c, middle.omega2, middle.theta20;
    hypothesis.side = middle.branch == Branch::Open ? 1.0 : -1.0;
}

Parameters parametersOf(const Observations &data, const Hypothesis &hypothesis)
{
    Parameters p = middleParameters(hypothesis);
    p.theta20 = std::remainder(p.theta20 - p.omega2 * data.origin, kTurn);
    return p;
}

bool areNear(const Parameters &x, const Parameters &y)
{
    constexpr double kPart = 1e-3;
    const auto near = [](double one, double other, double size) { return std::abs(one - other) <= kPart * size; };
    return x.branch == y.branch && near(x.a, y.a, x.a) && near(x.b, y.b, x.b) &&
           near(x.c, y.c, std::max(std::abs(x.c), x.a)) && near(x.omega2, y.omega2, std::abs(x.omega2)) &&
           near(std::remainder(x.theta20 - y.theta20, kTurn), 0.0, 1.0);
}

std::vector<ColumnUse> plainColumns(const Observations &data)
{
    std::vector<ColumnUse> columns;
    for (const ObservedColumn &column : data.columns) {
        columns.push_back({column.channel});
    }
    return columns;
}

void ColumnRegression::add(double model, double value)
{
    value -= center;
    n += 1.0;
    sumModel += model;
    sumValue += value;
    sumModel2 += model * model;
    sumValue2 += value * value;
    sumProduct += model * value;
}

double ColumnRegression::modelSquares() const
{
    return std::max(sumModel2 - sumModel * sumModel / n, 0.0);
}

double ColumnRegression::valueSquares() const
{
    return std::max(sumValue2 - sumValue * sumValue / n, 0.0);
}

double ColumnRegression::products() const
{
    return sumProduct - sumModel * sumValue / n;
}

double ColumnRegression::unexplained() const
{
    constexpr double kArithmetic = 1e-15;
    const double both = modelSquares() * valueSquares();
    return both > 0.0 ? std::clamp(1.0 - products() * products() / both, kArithmetic, 1.0) : 1.0;
}

double ColumnRegression::slope() const
{
    return modelSquares() > 0.0 ? products() / modelSquares() : 0.0;
}

double ColumnRegression::meanSquare(double factor, double size) const
{
    return std::max(
        (factor * factor * valueSquares() - 2.0 * factor * size * products() + size * size * modelSquares()) / n, 0.0);
}

double ColumnRegression::offset(double factor, double size) const
{
    return (factor * sumValue - size * sumModel) / n + factor * center;
}

std::vector<ColumnRegression> columnRegressions(const Observations &data, const Hypothesis &hypothesis)
{
    std::vector<ColumnRegression> regressions;
    for (const ObservedColumn &column : data.columns) {
        regressions.push_back({column.mean});
    }
    const bool moves = forEachResidual<double>(data, hypothesis, hypothesis.unknowns,
                                               [&](std::size_t row, std::size_t column, double model, double) {
                                                   regressions[column].add(model, data.columns[column].values[row]);
                                               });
    return moves ? regressions : std::vector<ColumnRegression>();
}

} // namespace slidercrank
