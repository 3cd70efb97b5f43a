// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/joint_fit.h"

#include "core/identification/column_scale.h"
#include "core/identification/residual_test.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

/// Whether the last column of a fit, which was added to the others, is explained: rounding explains its residuals, or
/// they are below the limits of both isExplained() and maxResidualOfFurtherColumn(). `others`: the fit without this
/// column.
bool isLastColumnExplained(const Observations &observations, const Fit &together, const Fit &others)
{
    const Index indexInFit = std::ssize(together.columns) - 1;
    return isWithinRounding(observations, together, indexInFit) ||
           (isExplained(observations, together, indexInFit) &&
            together.rms.back() <
                maxResidualOfFurtherColumn(observations, others) * columnSize(observations, together, indexInFit));
}

/// The origin with which the motion times `factor` fits a column of positions best (the median); 0 for derivatives.
double bestOrigin(const Observations &observations, const Fit &fit, Index k, double factor)
{
    const ObservedColumn &column = observations.columns[k];
    const Values differences = column.values - factor * computeMotion(fit.model, observations, {k}).col(0);
    return column.isDerivative() ? 0.0 : median(differences);
}

/// Whether the column may be measured from a different origin. Only positions have an origin; a constant one shows
/// none, apart from R4_y, which is constant in every mechanism.
bool mayHaveOrigin(const ObservedColumn &column)
{
    return !column.isDerivative() && (!column.isConstant() || column.channel == kSliderLine);
}

/// The readings of a column that are tried before one with a free origin, the simplest first. `factor`: the result of
/// usualFactor(), ±1 or ± a conversion of units.
///   1. If |factor| is not 1 and the model follows the time: ±1, the unit that the heading states. (If it follows the
///      angle, findTableSpeeds() has chosen between the units.)
///   2. `factor`.
///   3. If the column may have an origin: -factor.
/// In 2 and 3, the position θ3 or θ2 gets the multiple of half a turn that is nearest to its best origin; other origins
/// are 0.
std::vector<ColumnReading> simpleReadings(const Observations &observations, const Fit &fit, Index k, double factor)
{
    const ObservedColumn &column = observations.columns[k];
    std::vector<ColumnReading> readings;
    if (std::abs(factor) != 1.0 && !fit.model.followsAngle) {
        readings.push_back({std::copysign(1.0, factor), 0.0});
    }
    if (!mayHaveOrigin(column)) {
        readings.push_back({factor, 0.0});
        return readings;
    }
    for (const double signedFactor : {factor, -factor}) {
        const double origin = bestOrigin(observations, fit, k, signedFactor);
        readings.push_back({signedFactor, column.containsAngles() ? nearestHalfTurns(origin, signedFactor) : 0.0});
    }
    return readings;
}

/// Whether the last column of a fit may be used: it does not contain difference quotients of printed values for certain
/// (isPrintedDifference), and if it only agrees with difference quotients (isDifference), its residuals are as small as
/// rounding.
bool mayUseLastColumn(const Observations &observations, const Fit &fit)
{
    const Index indexInFit = std::ssize(fit.columns) - 1;
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    return !column.isPrintedDifference && (!column.isDifference || isNearRounding(observations, fit, indexInFit));
}

/// Fits column k together with the columns of a fit, in the simplest reading with which a mechanism explains them all:
/// one of simpleReadings(), otherwise with a free origin. Returns nullopt if there is none.
std::optional<Fit> tryReadings(const Observations &observations, const Fit &fit, Index k)
{
    const double factor = usualFactor(observations, fit, k);
    Model model = fit.model;
    for (const ColumnReading &reading : simpleReadings(observations, fit, k, factor)) {
        model.readings[k] = reading;
        if (std::optional<Fit> together = tryToAddColumn(observations, fit, model, k)) {
            return together;
        }
    }
    if (!mayHaveOrigin(observations.columns[k])) {
        return std::nullopt;
    }
    Fit withOrigin = fit;
    withOrigin.unknowns.push_back(originOf(k));
    for (const double signedFactor : {factor, -factor}) {
        model.readings[k] = {signedFactor, bestOrigin(observations, fit, k, signedFactor)};
        if (std::optional<Fit> together = tryToAddColumn(observations, withOrigin, model, k)) {
            return together;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Fit> tryToAddColumn(const Observations &observations, const Fit &fit, const Model &model, Index k)
{
    Indices columns = fit.columns;
    columns.push_back(k);
    Fit together = fitModel(observations, model, columns, fit.unknowns);
    if (!together.isFinite() || !isLastColumnExplained(observations, together, fit)) {
        return std::nullopt;
    }
    const Fit others = evaluateModel(observations, together.model, fit.columns);
    return explainsAsWell(observations, others, fit) ? std::optional(std::move(together)) : std::nullopt;
}

std::optional<Fit> addInSimplestReading(const Observations &observations, const Fit &fit, Index k)
{
    std::optional<Fit> together = tryReadings(observations, fit, k);
    return together && mayUseLastColumn(observations, *together) ? std::move(together) : std::nullopt;
}

} // namespace slidercrank
