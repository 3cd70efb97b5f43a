// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton.h"

#include "core/clearance.h"
#include "core/constraints.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The middle of the branch's half turn of θ3.
double branchCentre(Branch branch)
{
    return branch == Branch::Open ? 0.0 : std::numbers::pi;
}

/// cos θ3 has the branch's sign, but for what rounding cannot tell from 0.
bool isOnBranch(const Mechanism &mechanism, const Vector12 &q)
{
    constexpr double kRoundedCosine = 1.2e-7; // √(kResolvedCosine ε): less has no meaning at a double-precision θ3
    const double fromCentre = std::abs(q[Theta3] - branchCentre(mechanism.branch()));
    return fromCentre <= 0.5 * std::numbers::pi + kRoundedCosine; // false for NaN
}

/// A residual that rounding alone can explain (mm and rad mixed): each row of C sums a few terms of these sizes.
double roundingResidual(const Mechanism &mechanism, const Vector12 &q)
{
    constexpr double kRoundings = 32.0;
    const double sizes = mechanism.a() + mechanism.b() + std::abs(mechanism.c()) + std::abs(q[Theta2]) + 1.0;
    return kRoundings * std::numeric_limits<double>::epsilon() * sizes;
}

enum class Ending { Converged, IterationLimit, LeftBranch };

void record(NewtonResult &result, double residual)
{
    if (result.residualCount < NewtonResult::kHistory) {
        ++result.residualCount;
    }
    result.residuals[static_cast<std::size_t>(result.residualCount - 1)] = residual; // the last place is the newest's
}

/// Iterates from result.q, counting into result, until an ending.
Ending iterate(const Mechanism &mechanism, double t, const NewtonOptions &options, int maxIterations,
               NewtonResult &result)
{
    result.residualCount = 0;
    Vector12 C = constraints(mechanism, result.q, t);
    double residual = C.norm();
    record(result, residual);
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        const Vector12 step = constraintJacobian(mechanism, result.q).partialPivLu().solve(-C);
        const Vector12 next = result.q + step;
        if (!isOnBranch(mechanism, next)) {
            // At a toggle the matrix is all but singular, and the step after the last good one is rounding noise.
            const double enough = std::max(options.tolerance, roundingResidual(mechanism, result.q));
            return residual <= enough ? Ending::Converged : Ending::LeftBranch;
        }
        ++result.iterations;
        C = constraints(mechanism, next, t);
        const double nextResidual = C.norm();
        if (options.tolerance == 0.0) {
            const bool falls = nextResidual < residual;
            if (!falls && residual <= roundingResidual(mechanism, next)) {
                return Ending::Converged; // at the q before, which is no worse
            }
            result.q = next;
            residual = nextResidual;
            record(result, residual);
            if (residual == 0.0) {
                return Ending::Converged;
            }
        } else {
            const bool wasBelow = residual <= options.tolerance; // before the update, as in the report
            result.q = next;
            residual = nextResidual;
            record(result, residual);
            if (wasBelow) {
                return Ending::Converged;
            }
        }
    }
    return residual <= options.tolerance ? Ending::Converged : Ending::IterationLimit;
}

void conclude(NewtonResult &result, Ending ending)
{
    switch (ending) {
    case Ending::Converged: result.status = Status::Solved; break;
    case Ending::IterationLimit:
    case Ending::LeftBranch: result.status = Status::IterationLimit; break;
    }
}

/// Whether there is anything to iterate for; otherwise says in `result` why not.
bool canStart(const Mechanism &mechanism, double t, NewtonResult &result)
{
    const TwoPart angle = crankAngle(mechanism.omega2(), t, mechanism.theta20());
    if (!std::isfinite(angle.hi) || !std::isfinite(angle.lo)) {
        result.status = Status::NotFinite;
    } else if (!Clearance(mechanism).at(sinCos(angle)).assemblable()) {
        result.status = Status::NotAssemblable;
    } else {
        return true;
    }
    result.q.setConstant(kNone);
    return false;
}

/// The start from which Newton's way is monotone: sin θ3 - h/b rises and bends one way between here and the root.
void assembleFromAfar(const Mechanism &mechanism, double t, const NewtonOptions &options, NewtonResult &result)
{
    const double theta2 = mechanism.omega2() * t + mechanism.theta20();
    const double theta3 = branchCentre(mechanism.branch());
    const double pinX = mechanism.a() * std::cos(theta2);
    const double pinY = mechanism.a() * std::sin(theta2);
    const double couplerX = mechanism.branch() == Branch::Open ? mechanism.b() : -mechanism.b();
    result.q << 0.0, 0.0, 0.0, 0.5 * pinX, 0.5 * pinY, theta2, pinX + 0.5 * couplerX, pinY, theta3, pinX + couplerX,
        mechanism.c(), 0.0;
    result.startedAfar = true;
    conclude(result, iterate(mechanism, t, options, std::max(kAssemblyIterations, options.maxIterations), result));
}

} // namespace

NewtonResult assemble(const Mechanism &mechanism, double t, const NewtonOptions &options)
{
    NewtonResult result;
    if (canStart(mechanism, t, result)) {
        assembleFromAfar(mechanism, t, options, result);
    }
    return result;
}

NewtonResult track(const Mechanism &mechanism, double t, const Vector12 &start, const NewtonOptions &options)
{
    NewtonResult result;
    if (!canStart(mechanism, t, result)) {
        return result;
    }
    result.q = start;
    const Ending ending = isOnBranch(mechanism, start) ? iterate(mechanism, t, options, options.maxIterations, result)
                                                       : Ending::LeftBranch;
    if (ending == Ending::LeftBranch) {
        assembleFromAfar(mechanism, t, options, result);
    } else {
        conclude(result, ending);
    }
    return result;
}

State differentiate(const Mechanism &mechanism, const Vector12 &q, double residual)
{
    State state;
    state.q = q;
    const Eigen::PartialPivLU<Matrix12> lu = constraintJacobian(mechanism, q).partialPivLu();
    state.qDot = lu.solve(-constraintTimeDerivative(mechanism));
    state.qDDot = lu.solve(quadraticVelocityTerm(mechanism, q, state.qDot));
    const double cosine = std::cos(q[Theta3]);
    const double uncertainty = std::max(residual / mechanism.b(), std::numeric_limits<double>::epsilon());
    const bool resolved = cosine * cosine >= kResolvedCosine * uncertainty;
    if (!resolved || !state.qDot.allFinite() || !state.qDDot.allFinite()) {
        state.qDot.setConstant(kNone);
        state.qDDot.setConstant(kNone);
        state.status = Status::Singular;
    }
    return state;
}

} // namespace slidercrank
