// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/best_geometry.h"

#include "core/identification/geometry.h"
#include "core/identification/residual_test.h"
#include "core/identification/speed_candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// The two columns of a fit, θ3 and R4_x or two of the centres of the links, may come from two mechanisms, each of
/// which explains one column exactly and over at least a turn. Then returns the fit of the last column alone; otherwise
/// the same fit.
Fit withoutContradictingColumn(const Observations &searched, const Fit &fit)
{
    if (fit.columns.size() != 2 || isExact(searched, fit)) {
        return fit;
    }
    Fit fitOfOneColumn;
    for (const Index column : fit.columns) {
        Unknowns unknowns = fit.unknowns;
        std::erase_if(unknowns, [&](Unknown unknown) { return unknown.isOrigin() && unknown.column != column; });
        fitOfOneColumn = fitModel(searched, fit.model, {column}, unknowns);
        if (!isExact(searched, fitOfOneColumn) || isShortArc(searched, fitOfOneColumn.model)) {
            return fit;
        }
    }
    return fitOfOneColumn; // that of R4_x, which shapeColumns() lists last: it shows the lengths, θ3 only their ratios
}

/// The geometry of some columns, without the freedoms that they do not need.
ConstrainedFit findConstrainedGeometry(const Observations &wholeFile, const Observations &searched,
                                       const Indices &columns, const Parameters &given)
{
    const std::vector<double> speeds =
        wholeFile.hasAngle() ? std::vector<double>() : findSpeedCandidates(wholeFile, columns);
    Fit fit = withoutContradictingColumn(searched, findGeometry(searched, columns, speeds, given));
    return fit.isFinite() ? withoutFreedoms(searched, withUsualReadings(searched, std::move(fit))) : ConstrainedFit{};
}

/// Whether `higher`, the geometry of the higher orders, is better than `lowest`, that of the lowest ones. `columns`:
/// the columns of both. Over the time, it is better if its misfit in these columns is lower. But if rounding explains
/// the columns of `lowest`, and those of `higher` are difference quotients of them, `lowest` explains everything, so
/// that rounding has to explain all columns by `higher`, too. In a file with θ2, derivatives depend on a speed that is
/// not known yet, so that the misfits cannot be compared; there, `higher` is better if rounding explains its own
/// columns.
bool isHigherBetter(const Observations &searched, const Fit &higher, const Fit &lowest, const Indices &columns)
{
    if (searched.hasAngle()) {
        return isExact(searched, higher);
    }
    const Fit allByHigher = fitWithFreeOrigins(searched, higher, columns);
    const auto isQuotient = [&](Index k) { return searched.columns[k].isDifference; };
    const bool doesLowestExplainAll = isExact(searched, lowest) && std::ranges::all_of(higher.columns, isQuotient);
    if (doesLowestExplainAll && !isExact(searched, allByHigher)) {
        return false;
    }
    return allByHigher.misfit < fitWithFreeOrigins(searched, lowest, columns).misfit;
}

/// The largest rounding step of some columns, relative to the range of the column; infinite without columns.
double coarsestStep(const Observations &observations, const Indices &columns)
{
    double coarsest = columns.empty() ? kInfinity : 0.0;
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        coarsest = std::max(coarsest, std::sqrt(12.0 * column.variance) / column.range); // variance of rounding
    }
    return coarsest;
}

} // namespace

ConstrainedFit findBestGeometry(const Observations &wholeFile, const Observations &searched, const Parameters &given)
{
    const Indices lowestColumns = shapeColumns(searched);
    const Indices higherColumns = higherShapeColumns(searched);
    ConstrainedFit lowest = findConstrainedGeometry(wholeFile, searched, lowestColumns, given);
    const bool hasUsualOrigins = std::ranges::none_of(lowest.fit.unknowns, &Unknown::isOrigin);
    // Nothing has changed the columns of the lowest orders (best_geometry.h).
    const bool areLowestUnchanged = isExact(searched, lowest.fit) && (hasUsualOrigins || searched.hasAngle());
    if (areLowestUnchanged || higherColumns.empty()) {
        return lowest;
    }
    ConstrainedFit higher = findConstrainedGeometry(wholeFile, searched, higherColumns, given);
    Indices columnsOfBoth = lowestColumns;
    columnsOfBoth.insert(columnsOfBoth.end(), higherColumns.begin(), higherColumns.end());
    return isHigherBetter(searched, higher.fit, lowest.fit, columnsOfBoth) ? higher : lowest;
}

ConstrainedFit findGeometryOfHigherDerivatives(const Observations &wholeFile, const Observations &searched,
                                               const Parameters &given)
{
    // With similar rounding steps, the lowest orders have shown the geometry as well.
    constexpr double kMinStepRatio = 3.0;
    const Indices columns = higherShapeColumns(searched);
    const bool areFiner =
        kMinStepRatio * coarsestStep(searched, columns) < coarsestStep(searched, shapeColumns(searched));
    return areFiner ? findConstrainedGeometry(wholeFile, searched, columns, given) : ConstrainedFit{};
}

ConstrainedFit findGeometryOfApproximateFormula(const Observations &wholeFile, const Observations &searched,
                                                const Parameters &given)
{
    Fit fit = findConstrainedGeometry(wholeFile, searched, shapeColumns(searched), given).fit;
    fit.model.isApproximateFormula = true;
    return withoutFreedoms(searched, fitModel(searched, fit.model, fit.columns, fit.unknowns));
}

} // namespace slidercrank
