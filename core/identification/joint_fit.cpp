// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/joint_fit.h"

#include "core/identification/column_scale.h"
#include "core/identification/residual_test.h"

#include <utility>

namespace slidercrank
{

namespace
{

/// Whether the last column of a fit, which was added to the others, is explained: its residuals are rounding, or they
/// are below two limits, that of any explained column and the one beside exact columns. `isGeometryExact`: see
/// tryToAddColumn().
bool isLastColumnExplained(const Observations &observations, const Fit &together, bool isGeometryExact)
{
    const Index place = std::ssize(together.columns) - 1;
    const double largestRms = largestFurtherResidual(isGeometryExact) * columnSize(observations, together, place);
    return isWithinRounding(observations, together, place) ||
           (isExplained(observations, together, place) && together.rms.back() < largestRms);
}

/// Whether the columns of `fit` are explained as well by the model of `together`, which was fitted to them and to a
/// further column. Unlike explainsAsWell(), does not raise the limit for systematic residuals, because the further
/// column must not bend the curve of the others.
bool areOthersStillExplained(const Observations &observations, const Fit &together, const Fit &fit,
                             bool isGeometryExact)
{
    const Fit others = evaluateModel(observations, together.model, fit.columns);
    return others.misfit - fit.misfit <= kSameMisfit || (isGeometryExact && isExact(observations, others));
}

} // namespace

std::optional<Fit> tryToAddColumn(const Observations &observations, const Fit &fit, const Model &model, Index k,
                                  bool isGeometryExact)
{
    Indices columns = fit.columns;
    columns.push_back(k);
    Fit together = fitModel(observations, model, columns, fit.unknowns);
    if (!together.isFinite() || !isLastColumnExplained(observations, together, isGeometryExact) ||
        !areOthersStillExplained(observations, together, fit, isGeometryExact)) {
        return std::nullopt;
    }
    return together;
}

} // namespace slidercrank
