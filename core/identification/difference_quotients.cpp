// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/difference_quotients.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// A difference quotient: the factors of the values before, in and after a row.
struct Stencil {
    std::array<double, 3> factors;
    int order; ///< of the derivative
};
constexpr Stencil kSecondDifference{{1.0, -2.0, 1.0}, 2};
constexpr std::array<Stencil, 4> kStencils{{{{-0.5, 0.0, 0.5}, 1}, // central
                                            {{0.0, -1.0, 1.0}, 1}, // forward
                                            {{-1.0, 1.0, 0.0}, 1}, // backward
                                            kSecondDifference}};

/// Quotients in all rows but the first and the last, with the largest effect of the rounding of the values.
struct Quotients {
    Values values;
    Values bounds;
};

Quotients quotientsOf(const Stencil &stencil, const Values &abscissa, const ObservedColumn &column)
{
    const Index rows = abscissa.size() - 2;
    const Values widths = 0.5 * (abscissa.tail(rows) - abscissa.head(rows)).abs();
    Quotients quotients{Values::Zero(rows), Values::Zero(rows)};
    for (Index k = 0; k < 3; ++k) {
        const double factor = stencil.factors[k];
        quotients.values += factor * column.values.segment(k, rows) / widths.pow(stencil.order);
        quotients.bounds += std::abs(factor) * column.halfSteps.segment(k, rows) / widths.pow(stencil.order);
    }
    return quotients;
}

bool isDifferenceOf(const Stencil &stencil, const Values &abscissa, const ObservedColumn &column,
                    const ObservedColumn &lower)
{
    constexpr double kMinFraction = 0.8; // of the rows; the first and the last may be computed in another way
    constexpr double kMaxBound = 0.05;   // of the range: a larger rounding of the quotients would prove nothing
    const Quotients quotients = quotientsOf(stencil, abscissa, lower);
    const Values values = column.values.segment(1, quotients.values.size());
    const Values products = finite(quotients.values * values);
    const double factor = products.sum() / (products != 0.0).select(quotients.values.square(), 0.0).sum();
    const Values bounds = column.halfSteps.segment(1, values.size()) + std::abs(factor) * quotients.bounds;
    const auto agree = (values - factor * quotients.values).abs() <= bounds && bounds < kMaxBound * column.range;
    const auto agreeOnMotion = agree && values.abs() > bounds; // zeros prove nothing
    return agree.cast<double>().mean() > kMinFraction && agreeOnMotion.cast<double>().mean() > 0.5 * kMinFraction;
}

bool containsDifferences(const Observations &observations, const ObservedColumn &column)
{
    for (const ObservedColumn &lower : observations.columns) {
        const int order = static_cast<int>(column.channel.order) - static_cast<int>(lower.channel.order);
        for (const Stencil &stencil : kStencils) {
            if (lower.channel.coordinate == column.channel.coordinate && stencil.order == order &&
                isDifferenceOf(stencil, observations.abscissa(), column, lower)) {
                return true;
            }
        }
    }
    return false;
}

bool isInterpolatedOrHeld(const Observations &observations, const ObservedColumn &column)
{
    constexpr double kMinFraction = 0.45; // of the rows: nearly one of two
    constexpr double kMinCurvature = 3.0; // bounds of rounding, median of the curvature of the other rows
    const Quotients curvature = quotientsOf(kSecondDifference, observations.abscissa(), column);
    const Index rows = curvature.values.size();
    const auto isRepeated = column.values.segment(1, rows) == column.values.head(rows);
    const Eigen::ArrayX<bool> isStraight = curvature.values.abs() <= curvature.bounds || isRepeated;
    const Values others = isStraight.select(kNone, curvature.values.abs() / curvature.bounds);
    return isStraight.cast<double>().mean() > kMinFraction && median(others) > kMinCurvature;
}

} // namespace

Observations withComputedColumnsMarked(Observations observations)
{
    constexpr Index kMinRows = 3;
    for (ObservedColumn &column : observations.columns) {
        if (observations.size() >= kMinRows && column.range > 0.0) {
            column.isDifference = containsDifferences(observations, column);
            column.isInterpolated = isInterpolatedOrHeld(observations, column);
        }
    }
    return observations;
}

} // namespace slidercrank
