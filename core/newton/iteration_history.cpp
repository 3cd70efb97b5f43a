// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/iteration_history.h"

#include "core/newton/constraints.h"

#include <Eigen/LU>

namespace slidercrank
{

namespace
{

/// The solver keeps its residuals, not its coordinates: those follow by going the same way again.
IterationHistory retraced(const Mechanism &mechanism, double t, const Vector12 &start, const NewtonResult &result)
{
    IterationHistory history;
    history.status = result.status;
    history.startedAfar = result.startedAfar;
    Vector12 q = start;
    for (int i = 0; i < result.residualCount; ++i) {
        const bool last = i + 1 == result.residualCount;
        history.iterations.push_back({last ? result.q : q, result.residuals[static_cast<std::size_t>(i)]});
        const Vector12 step = constraintJacobian(mechanism, q).partialPivLu().solve(-constraints(mechanism, q, t));
        q += step;
    }
    return history;
}

} // namespace

IterationHistory iterationsFromAfar(const Mechanism &mechanism, double t, const NewtonOptions &options)
{
    return retraced(mechanism, t, farStart(mechanism, t), assemble(mechanism, t, options));
}

IterationHistory iterationsFrom(const Mechanism &mechanism, double t, const Vector12 &start,
                                const NewtonOptions &options)
{
    const NewtonResult result = track(mechanism, t, start, options);
    return retraced(mechanism, t, result.startedAfar ? farStart(mechanism, t) : start, result);
}

} // namespace slidercrank
