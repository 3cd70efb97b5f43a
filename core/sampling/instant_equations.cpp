// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/instant_equations.h"

#include "core/closed_form/state_at.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"

#include <Eigen/SVD>

#include <limits>

namespace slidercrank
{

namespace
{

NewtonInstant newtonAt(const Mechanism &mechanism, double t, double step, const NewtonOptions &options)
{
    return solveInstant(mechanism, t, solveInstant(mechanism, t - step, {}, options), options);
}

} // namespace

InstantEquations equationsAt(const Mechanism &mechanism, double t, double step, const SolverSettings &settings)
{
    InstantEquations equations;
    switch (settings.method) {
    case Method::Newton: {
        const NewtonInstant instant = newtonAt(mechanism, t, step, settings.newton);
        equations.state = instant.state;
        equations.q = instant.q;
        break;
    }
    case Method::ClosedForm:
        equations.state = ClosedForm(mechanism).stateAt(t);
        equations.q = equations.state.q;
        break;
    }
    if (!equations.hasPosition()) {
        equations.C.setConstant(kNone);
        equations.Cq.setConstant(kNone);
        equations.Ct.setConstant(kNone);
        equations.Qd.setConstant(kNone);
        return equations;
    }
    equations.C = constraints(mechanism, equations.q, t);
    equations.Cq = constraintJacobian(mechanism, equations.q);
    equations.Ct = constraintTimeDerivative(mechanism);
    if (equations.state.status == Status::Solved) {
        equations.Qd = quadraticVelocityTerm(mechanism, equations.q, equations.state.qDot);
    } else {
        equations.Qd.setConstant(kNone);
    }
    return equations;
}

double conditionNumber(const Matrix12 &matrix)
{
    const Vector12 singularValues = Eigen::JacobiSVD<Matrix12>(matrix).singularValues();
    const double smallest = singularValues[kCoordinateCount - 1];
    return smallest > 0.0 ? singularValues[0] / smallest : std::numeric_limits<double>::infinity();
}

} // namespace slidercrank
