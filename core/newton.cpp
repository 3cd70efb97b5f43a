// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton.h"

#include "core/clearance.h"
#include "core/constraints.h"
#include "core/structured_system.h"

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

/// The report's way with the linear systems; StructuredSystem is the other.
class DenseSystem
{
public:
    DenseSystem(const Mechanism &mechanism, double t)
        : m_mechanism(mechanism)
        , m_t(t)
    {
    }

    void moveTo(const Vector12 &q)
    {
        m_q = q;
        m_C = slidercrank::constraints(m_mechanism, q, m_t);
    }

    const Vector12 &constraints() const { return m_C; }

    Vector12 step() const { return constraintJacobian(m_mechanism, m_q).partialPivLu().solve(-m_C); }

    double cosTheta3() const { return std::cos(m_q[Theta3]); }

    void differentiate(State &state) const
    {
        const Eigen::PartialPivLU<Matrix12> lu = constraintJacobian(m_mechanism, m_q).partialPivLu();
        state.qDot = lu.solve(-constraintTimeDerivative(m_mechanism));
        state.qDDot = lu.solve(quadraticVelocityTerm(m_mechanism, m_q, state.qDot));
    }

private:
    const Mechanism &m_mechanism;
    double m_t;
    Vector12 m_q;
    Vector12 m_C;
};

double reach(const Mechanism &mechanism)
{
    return mechanism.a() + mechanism.b() + std::abs(mechanism.c());
}

/// The residual as the options want it.
class Measure
{
public:
    Measure(const Mechanism &mechanism, ToleranceKind kind)
    {
        const double lengths = reach(mechanism);
        const double perLength = kind == ToleranceKind::Relative ? 1.0 / lengths : 1.0;
        m_weights.setConstant(perLength);
        m_weights[GroundAngle] = 1.0;
        m_weights[SliderAngle] = 1.0;
        m_weights[CrankDrive] = 1.0;
        constexpr double kRoundings = 32.0; // each row sums a few terms of a length's size, or of an angle's
        m_rounding = kRoundings * std::numeric_limits<double>::epsilon() * (perLength * lengths + 1.0);
    }

    double of(const Vector12 &C) const { return m_weights.cwiseProduct(C).norm(); }

    /// What rounding alone can explain.
    double rounding() const { return m_rounding; }

private:
    Vector12 m_weights;
    double m_rounding;
};

enum class Ending { Converged, IterationLimit, LeftBranch };

void record(NewtonResult &result, double residual)
{
    if (result.residualCount < NewtonResult::kHistory) {
        ++result.residualCount;
    }
    result.residuals[static_cast<std::size_t>(result.residualCount - 1)] = residual; // the last place is the newest's
}

/// Iterates from result.q, counting into result, until an ending. Leaves `system` at result.q.
template <class System>
Ending iterate(System &system, const Mechanism &mechanism, const NewtonOptions &options, int maxIterations,
               NewtonResult &result)
{
    const Measure measure(mechanism, options.toleranceKind);
    const double tolerance = options.tolerance;
    const bool testsFirst = options.warmStart == WarmStart::Taylor && tolerance > 0.0;
    result.residualCount = 0;
    system.moveTo(result.q);
    double residual = measure.of(system.constraints());
    record(result, residual);
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        if (testsFirst && residual <= tolerance) {
            return Ending::Converged;
        }
        const Vector12 next = result.q + system.step();
        if (!isOnBranch(mechanism, next)) {
            // At a toggle the matrix is all but singular, and the step after the last good one is rounding noise.
            return residual <= std::max(tolerance, measure.rounding()) ? Ending::Converged : Ending::LeftBranch;
        }
        ++result.iterations;
        system.moveTo(next);
        const double nextResidual = measure.of(system.constraints());
        if (tolerance == 0.0 && !(nextResidual < residual) && residual <= measure.rounding()) {
            system.moveTo(result.q); // the q before is no worse
            return Ending::Converged;
        }
        const bool wasBelow = residual <= tolerance; // before the update, as in the report
        result.q = next;
        residual = nextResidual;
        record(result, residual);
        if (tolerance == 0.0 ? residual == 0.0 : wasBelow) {
            return Ending::Converged;
        }
    }
    return residual <= tolerance ? Ending::Converged : Ending::IterationLimit;
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
    // Rounding is monotone: where this holds of the rounded difference, it does of the exact one.
    const bool turnsRound = mechanism.b() - mechanism.a() > std::abs(mechanism.c());
    if (!std::isfinite(angle.hi) || !std::isfinite(angle.lo)) {
        result.status = Status::NotFinite;
    } else if (!turnsRound && !Clearance(mechanism).at(sinCos(angle)).assemblable()) {
        result.status = Status::NotAssemblable;
    } else {
        return true;
    }
    result.q.setConstant(kNone);
    return false;
}

/// The start from which Newton's way is monotone: sin θ3 - h/b rises and bends one way between here and the root.
template <class System>
void assembleFromAfar(System &system, const Mechanism &mechanism, double t, const NewtonOptions &options,
                      NewtonResult &result)
{
    const double theta2 = mechanism.omega2() * t + mechanism.theta20();
    const double theta3 = branchCentre(mechanism.branch());
    const double pinX = mechanism.a() * std::cos(theta2);
    const double pinY = mechanism.a() * std::sin(theta2);
    const double couplerX = mechanism.branch() == Branch::Open ? mechanism.b() : -mechanism.b();
    result.q << 0.0, 0.0, 0.0, 0.5 * pinX, 0.5 * pinY, theta2, pinX + 0.5 * couplerX, pinY, theta3, pinX + couplerX,
        mechanism.c(), 0.0;
    result.startedAfar = true;
    conclude(result, iterate(system, mechanism, options, std::max(kAssemblyIterations, options.maxIterations), result));
}

/// From result.q.
template <class System>
void trackFromHere(System &system, const Mechanism &mechanism, double t, const NewtonOptions &options,
                   NewtonResult &result)
{
    const Ending ending = isOnBranch(mechanism, result.q)
                              ? iterate(system, mechanism, options, options.maxIterations, result)
                              : Ending::LeftBranch;
    if (ending == Ending::LeftBranch) {
        assembleFromAfar(system, mechanism, t, options, result);
    } else {
        conclude(result, ending);
    }
}

void setNothing(State &state)
{
    state.qDot.setConstant(kNone);
    state.qDDot.setConstant(kNone);
}

/// Velocity and acceleration at the q of `system`, whose residual is given in mm.
template <class System>
void differentiateHere(const System &system, const Mechanism &mechanism, double residual, State &state)
{
    system.differentiate(state);
    const double cosine = system.cosTheta3();
    const double uncertainty = std::max(residual / mechanism.b(), std::numeric_limits<double>::epsilon());
    const bool resolved = cosine * cosine >= kResolvedCosine * uncertainty;
    const bool exists = resolved && state.qDot.allFinite() && state.qDDot.allFinite();
    state.status = exists ? Status::Solved : Status::Singular;
    if (!exists) {
        setNothing(state);
    }
}

bool isWarm(Status status)
{
    return status == Status::Solved || status == Status::IterationLimit;
}

/// What `before` lets expect of t.
Vector12 expected(const NewtonInstant &before, double t, WarmStart warmStart)
{
    if (warmStart == WarmStart::Previous || before.state.status != Status::Solved) {
        return before.position.q;
    }
    const double step = t - before.t;
    return before.state.q + step * (before.state.qDot + (0.5 * step) * before.state.qDDot);
}

template <class System>
void solveInstantWith(const Mechanism &mechanism, const NewtonInstant &before, const NewtonOptions &options,
                      NewtonInstant &here)
{
    NewtonResult &position = here.position;
    if (canStart(mechanism, here.t, position)) {
        System system(mechanism, here.t);
        if (isWarm(before.position.status)) {
            position.q = expected(before, here.t, options.warmStart);
            trackFromHere(system, mechanism, here.t, options, position);
        } else {
            assembleFromAfar(system, mechanism, here.t, options, position);
        }
        if (position.status == Status::Solved) {
            const bool relative = options.toleranceKind == ToleranceKind::Relative;
            const double residual = relative ? position.residual() * reach(mechanism) : position.residual();
            here.state.q = position.q;
            differentiateHere(system, mechanism, residual, here.state);
            return;
        }
    }
    here.state.q.setConstant(kNone);
    setNothing(here.state);
    here.state.status = position.status;
}

} // namespace

NewtonResult assemble(const Mechanism &mechanism, double t, const NewtonOptions &options)
{
    NewtonResult result;
    if (!canStart(mechanism, t, result)) {
        return result;
    }
    switch (options.elimination) {
    case Elimination::Dense: {
        DenseSystem system(mechanism, t);
        assembleFromAfar(system, mechanism, t, options, result);
        break;
    }
    case Elimination::Structured: {
        StructuredSystem system(mechanism, t);
        assembleFromAfar(system, mechanism, t, options, result);
        break;
    }
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
    switch (options.elimination) {
    case Elimination::Dense: {
        DenseSystem system(mechanism, t);
        trackFromHere(system, mechanism, t, options, result);
        break;
    }
    case Elimination::Structured: {
        StructuredSystem system(mechanism, t);
        trackFromHere(system, mechanism, t, options, result);
        break;
    }
    }
    return result;
}

State differentiate(const Mechanism &mechanism, const Vector12 &q, double residual)
{
    State state;
    state.q = q;
    DenseSystem system(mechanism, 0.0); // C_q, C_t and Q_d do not depend on time
    system.moveTo(q);
    differentiateHere(system, mechanism, residual, state);
    return state;
}

NewtonInstant solveInstant(const Mechanism &mechanism, double t, const NewtonInstant &before,
                           const NewtonOptions &options)
{
    NewtonInstant here;
    here.t = t;
    switch (options.elimination) {
    case Elimination::Dense: solveInstantWith<DenseSystem>(mechanism, before, options, here); break;
    case Elimination::Structured: solveInstantWith<StructuredSystem>(mechanism, before, options, here); break;
    }
    return here;
}

} // namespace slidercrank
