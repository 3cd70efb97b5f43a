// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/difference_quotients.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// A quotient needs this number of rows before and after its own one.
constexpr Index kRowsOnEachSide = 2;

/// A difference quotient: the factors of the values from kRowsOnEachSide rows before a row to kRowsOnEachSide rows
/// after it.
struct Stencil {
    std::array<double, 2 * kRowsOnEachSide + 1> factors;
    int order; ///< order of the derivative that the quotient approximates
};
constexpr Stencil kSecondDifference{{0.0, 1.0, -2.0, 1.0, 0.0}, 2};
constexpr std::array<Stencil, 7> kStencils{
    {{{0.0, -0.5, 0.0, 0.5, 0.0}, 1}, // central
     {{0.0, 0.0, -1.0, 1.0, 0.0}, 1}, // forward
     {{0.0, -1.0, 1.0, 0.0, 0.0}, 1}, // backward
     kSecondDifference,
     {{0.25, 0.0, -0.5, 0.0, 0.25}, 2}, // central quotient of central quotients
     {{0.0, 0.0, 1.0, -2.0, 1.0}, 2},   // forward quotient of forward quotients
     {{1.0, -2.0, 1.0, 0.0, 0.0}, 2}}}; // backward quotient of backward quotients

/// Quotients in all rows but the first and the last kRowsOnEachSide ones. Their divisor is half the distance between
/// both neighbours of the row, to the power of the order. (For forward and backward quotients, this requires evenly
/// spaced rows.)
struct Quotients {
    Values values;
    Values bounds; ///< the largest errors of the quotients because of the rounding of the column
};

Quotients computeQuotients(const Stencil &stencil, const Values &abscissa, const ObservedColumn &column)
{
    const Index rows = abscissa.size() - 2 * kRowsOnEachSide;
    const Values widths =
        0.5 * (abscissa.segment(kRowsOnEachSide + 1, rows) - abscissa.segment(kRowsOnEachSide - 1, rows)).abs();
    Quotients quotients{Values::Zero(rows), Values::Zero(rows)};
    for (Index k = 0; k < std::ssize(stencil.factors); ++k) {
        if (const double factor = stencil.factors[k]; factor != 0.0) { // otherwise a gap, which is NaN, would count
            quotients.values += factor * column.values.segment(k, rows) / widths.pow(stencil.order);
            quotients.bounds += std::abs(factor) * column.halfSteps.segment(k, rows) / widths.pow(stencil.order);
        }
    }
    return quotients;
}

/// The values of a column, and the quotients of one of lower order times the factor that suits all rows best.
struct ScaledQuotients {
    Values values;
    Values predictions;
    Values bounds; ///< the largest errors of the predictions because of the rounding of the lower column

    /// Whether most values are predicted within some bounds, and enough of these are not zero within them: zeros would
    /// prove nothing.
    bool areWithin(const Values &largestErrors) const
    {
        constexpr double kMinFraction = 0.8;       // of the rows: the others may lie beside gaps or jumps
        constexpr double kMinMovingFraction = 0.4; // of the rows
        const Eigen::ArrayX<bool> agrees = (values - predictions).abs() <= largestErrors;
        const Eigen::ArrayX<bool> agreesAndMoves = agrees && values.abs() > largestErrors;
        return agrees.cast<double>().mean() > kMinFraction && agreesAndMoves.cast<double>().mean() > kMinMovingFraction;
    }
};

ScaledQuotients scaleQuotients(const Stencil &stencil, const Values &abscissa, const ObservedColumn &column,
                               const ObservedColumn &lower)
{
    const Quotients quotients = computeQuotients(stencil, abscissa, lower);
    const Values values = column.values.segment(kRowsOnEachSide, quotients.values.size());
    const Values products = gapsAsZeros(quotients.values * values);
    // By least squares, without gaps and without values that are zero, which prove nothing.
    const double factor = products.sum() / (products != 0.0).select(quotients.values.square(), 0.0).sum();
    return {.values = values, .predictions = factor * quotients.values, .bounds = std::abs(factor) * quotients.bounds};
}

/// Whether the column agrees with the quotients within the rounding of both columns.
bool agreeWithinRounding(const ScaledQuotients &quotients, const ObservedColumn &column)
{
    // Fraction of the range of the column. Agreement within a larger bound would prove nothing.
    constexpr double kMaxBound = 0.05;
    const Values bounds = column.halfSteps.segment(kRowsOnEachSide, quotients.values.size()) + quotients.bounds;
    return quotients.areWithin((bounds < kMaxBound * column.range).select(bounds, kNone));
}

/// Whether the column repeats the quotients of the printed values of `lower`. A derivative would differ from them by
/// the errors that the rounding of these values causes.
bool arePrintedQuotients(const ScaledQuotients &quotients, const ObservedColumn &lower)
{
    constexpr double kMaxError = 0.02; // fraction of the largest error that the rounding causes
    constexpr Index kMinRows = 6;      // with a free factor, fewer quotients may agree by chance
    // The half steps of values with all digits are overestimated, because they also allow for errors of the arithmetic.
    const bool isRounded = lower.halfSteps.maxCoeff() > kArithmeticError * lower.range;
    return isRounded && quotients.values.size() >= kMinRows && quotients.areWithin(kMaxError * quotients.bounds);
}

/// Sets isDifference and isPrintedDifference of a column.
void markDifferences(const Observations &observations, ObservedColumn &column)
{
    for (const ObservedColumn &lower : observations.columns) {
        const int order = static_cast<int>(column.channel.order) - static_cast<int>(lower.channel.order);
        for (const Stencil &stencil : kStencils) {
            if (lower.channel.coordinate != column.channel.coordinate || stencil.order != order) {
                continue;
            }
            const ScaledQuotients quotients = scaleQuotients(stencil, observations.abscissa(), column, lower);
            const bool isPrintedDifference = arePrintedQuotients(quotients, lower);
            column.isPrintedDifference = column.isPrintedDifference || isPrintedDifference;
            column.isDifference = column.isDifference || isPrintedDifference || agreeWithinRounding(quotients, column);
        }
    }
}

/// Whether many values repeat the one before or lie on the line through their neighbours, although the column is curved
/// at the other values.
bool isInterpolatedOrHeld(const Observations &observations, const ObservedColumn &column)
{
    constexpr double kMinFraction = 0.45; // of the rows: nearly every second one
    constexpr double kMinCurvature = 3.0; // at the other rows (median), relative to what rounding can simulate
    const Quotients curvature = computeQuotients(kSecondDifference, observations.abscissa(), column);
    const Index rows = curvature.values.size();
    const Eigen::ArrayX<bool> isRepeated =
        column.values.segment(kRowsOnEachSide, rows) == column.values.segment(kRowsOnEachSide - 1, rows);
    const Eigen::ArrayX<bool> isOnLineOrRepeated = curvature.values.abs() <= curvature.bounds || isRepeated;
    const Values curvatureOfOthers = isOnLineOrRepeated.select(kNone, curvature.values.abs() / curvature.bounds);
    return isOnLineOrRepeated.cast<double>().mean() > kMinFraction && median(curvatureOfOthers) > kMinCurvature;
}

} // namespace

Observations withComputedColumnsMarked(Observations observations)
{
    constexpr Index kMinRows = 2 * kRowsOnEachSide + 1;
    for (ObservedColumn &column : observations.columns) {
        if (observations.size() >= kMinRows && !column.isConstant()) {
            markDifferences(observations, column);
            column.isInterpolated = isInterpolatedOrHeld(observations, column);
        }
    }
    return observations;
}

} // namespace slidercrank
