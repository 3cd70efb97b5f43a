// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/time_step_equations.h"

#include "core/closed_form/state_at.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"

#include <Eigen/SVD>

#include <cmath>

namespace slidercrank
{

TimeStepEquations equationsAt(const Mechanism &mechanism, double t, double step, const SolverSettings &settings)
{
    TimeStepEquations equations;
    if (settings.method == Method::Newton) {
        const NewtonTimeStep before = solve(mechanism, t - step, settings.newton);
        const NewtonTimeStep timeStep = solve(mechanism, t, settings.newton, before);
        equations.state = timeStep.state;
        equations.q = timeStep.q;
    } else {
        equations.state = ClosedForm(mechanism).stateAt(t);
        equations.q = equations.state.q;
    }
    if (equations.hasPosition()) {
        equations.C = constraints(mechanism, equations.q, t);
        equations.Cq = constraintJacobian(mechanism, equations.q);
        equations.determinant = -mechanism.parameters().b * std::cos(equations.q[Theta3]);
        equations.Ct = constraintTimeDerivative(mechanism);
    }
    if (equations.state.status == Status::Solved) {
        equations.Qd = quadraticVelocityTerm(mechanism, equations.q, equations.state.qDot);
    }
    return equations;
}

double conditionNumber(const Matrix12 &matrix)
{
    const Vector12 singularValues = Eigen::JacobiSVD<Matrix12>(matrix).singularValues();
    const double smallest = singularValues[kCoordinateCount - 1];
    return smallest > 0.0 ? singularValues[0] / smallest : kInfinity;
}

} // namespace slidercrank
