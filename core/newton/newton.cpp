// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/newton.h"

#include "core/closed_form/clearance.h"
#include "core/newton/constraints.h"
#include "core/newton/structured_system.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

/// The middle of the branch's half turn of θ3.
double branchCentre(Branch branch)
{
    return branch == Branch::Open ? 0.0 : std::numbers::pi;
}

/// cos θ3 has the branch's sign, but for what rounding cannot tell from 0.
bool isOnBranch(const Mechanism &mechanism, double theta3)
{
    constexpr double kRoundedCosine = 1.2e-7; // what rounding leaves of a θ3 at a right angle: √(2 r/b), r/b = 7e-15
    const double fromCentre = std::abs(theta3 - branchCentre(mechanism.branch()));
    return fromCentre <= 0.5 * std::numbers::pi + kRoundedCosine; // false for NaN
}

/// The report's way with the linear systems; StructuredSystem is the other.
class DenseSystem
{
public:
    using Coordinates = Vector12;
    static const Vector12 &coordinatesOf(const Vector12 &q) { return q; }
    static void write(const Vector12 &q, Vector12 &to) { to = q; }

    DenseSystem(const Mechanism &mechanism, double t)
        : m_mechanism(mechanism)
        , m_t(t)
    {
    }

    void moveTo(const Vector12 &q)
    {
        m_C = slidercrank::constraints(m_mechanism, q, m_t);
        m_cosTheta3 = std::cos(q[Theta3]);
    }

    void turnTo(const Vector12 &q) { moveTo(q); }

    double residual(double perLength) const
    {
        Vector12 scaled = perLength * m_C;
        for (const Constraint row : {GroundAngle, SliderAngle, CrankDrive}) {
            scaled[row] = m_C[row];
        }
        return scaled.norm();
    }

    const Vector12 &constraints() const { return m_C; }

    Vector12 next(const Vector12 &q) const { return q + constraintJacobian(m_mechanism, q).partialPivLu().solve(-m_C); }

    double cosTheta3() const { return m_cosTheta3; }

    bool differentiate(State &state) const
    {
        const Eigen::PartialPivLU<Matrix12> lu = constraintJacobian(m_mechanism, state.q).partialPivLu();
        state.qDot = lu.solve(-constraintTimeDerivative(m_mechanism));
        state.qDDot = lu.solve(quadraticVelocityTerm(m_mechanism, state.q, state.qDot));
        return state.qDot.allFinite() && state.qDDot.allFinite();
    }

private:
    const Mechanism &m_mechanism;
    double m_t;
    Vector12 m_C;
    double m_cosTheta3;
};

double theta3Of(const Vector12 &q)
{
    return q[Theta3];
}

double theta3Of(const StructuredSystem::Coordinates &q)
{
    return q.theta3;
}

/// Below this (mm) squares of what is left of a length would be 0; then lengths are taken so many times as long.
constexpr double kLeastReach = 1e-100;
constexpr double kUnitsOfTiny = 0x1p660;

enum class Ending { Converged, IterationLimit, LeftBranch };

void record(NewtonResult &result, double residual)
{
    if (result.residualCount < NewtonResult::kHistory) {
        ++result.residualCount;
    }
    result.residuals[static_cast<std::size_t>(result.residualCount - 1)] = residual; // the last place is the newest's
}

/// How much of a ω²/b is left of θ̈3 where nothing is steep, or where a run comes near a toggle. By
///     b³ cos³ θ3 θ̈3 = a ω² (sin θ2 (b² - a² - c²) + a c (1 + sin² θ2))
/// that is next to nothing where a ≈ b and c ≈ 0: there θ3 keeps pace with the crank, but for the toggle. A run of a
/// hundred steps a turn comes within φ = π/100 of it, and sees 1/φ³ of the rest.
double partLeftOfAcceleration(const Mechanism &mechanism)
{
    constexpr double kGrowth = 3e4;
    const double near = 3.0 / kGrowth * mechanism.b();
    const double excess = mechanism.b() - mechanism.a();
    if (std::abs(excess) > near || std::abs(mechanism.c()) > near) {
        return 1.0;
    }
    const double a = mechanism.a() / mechanism.b();
    const double c = mechanism.c() / mechanism.b();
    const double left = std::abs(excess / mechanism.b() * (1.0 + a) - c * c) + std::abs(a * c);
    return left > 0.0 ? std::min(kGrowth * left, 1.0) : 1.0; // a = b and c = 0: θ̈3 is 0 throughout
}

/// Iterates from q, counting into result, until an ending. Leaves `system` at the last q.
template <class System>
Ending iterate(System &system, const Mechanism &mechanism, const NewtonOptions &options, int maxIterations,
               typename System::Coordinates &q, NewtonResult &result)
{
    const double reach = characteristicLength(mechanism.parameters());
    const bool isTiny = reach < kLeastReach;
    const double unit = isTiny ? kUnitsOfTiny : 1.0;
    const bool isRelative = options.toleranceKind == ToleranceKind::Relative;
    const double perLength = isRelative ? 1.0 / (unit * reach) : isTiny ? 1.0 / kUnitsOfTiny : 1.0;
    const auto measured = [&](double length) { return perLength * (unit * length); };
    const auto residualHere = [&] {
        return isTiny ? residualInUnits(system.constraints(), perLength, unit) : system.residual(perLength);
    };

    // Rounding alone: each row of lengths sums a few terms of their size; those of angles come out exact.
    constexpr double kRoundings = 32.0;
    const double rounding = kRoundings * std::max(std::numeric_limits<double>::epsilon() * measured(reach),
                                                  measured(std::numeric_limits<double>::denorm_min()));

    // A residual that satisfies the tolerance may leave no digit of the motion; then it goes on. The terms of θ̈3 cancel
    // beside an exact toggle until a third of cos θ3 is left of them.
    const double resolved = kResolvedPart * measured(mechanism.a());
    const double tolerance = std::min(options.tolerance, std::max(resolved, rounding));
    const double perCosineCubed = kResolvedPart * measured(mechanism.b()) * partLeftOfAcceleration(mechanism) / 3.0;
    const auto isResolved = [&](double residual) {
        const double cosine = std::abs(system.cosTheta3());
        return residual <= perCosineCubed * (cosine * cosine * cosine) || residual <= rounding;
    };

    // The rounding of a long coupler's rows may hide all of a short crank's, which two or three steps solve.
    const bool testsFirst = options.warmStart == WarmStart::Taylor && tolerance > 0.0;
    result.residualCount = 0;
    system.moveTo(q);
    double residual = residualHere();
    record(result, residual);
    if (rounding > kResolvedPart * measured(mechanism.b())) {
        return Ending::IterationLimit; // of lengths of a few bits, or of a coupler next to nothing, θ3 is never known
    }
    for (int iteration = 0; iteration < maxIterations; ++iteration) {
        if (testsFirst && residual <= std::min(tolerance, resolved) && isResolved(residual)) {
            return Ending::Converged;
        }
        const typename System::Coordinates next = system.next(q);
        if (!isOnBranch(mechanism, theta3Of(next))) {
            // At a toggle the matrix is all but singular, and the step after the last good one is rounding noise.
            return residual <= rounding ? Ending::Converged : Ending::LeftBranch;
        }
        ++result.iterations;
        const bool wasBelow = residual <= tolerance; // before the update, as in the report
        if (tolerance > 0.0 && (testsFirst || wasBelow)) {
            system.turnTo(next); // likely the last
        } else {
            system.moveTo(next);
        }
        const double nextResidual = residualHere();
        const bool isHidden = residual > resolved && iteration < 2;
        if (tolerance == 0.0 && !(nextResidual < residual) && residual <= rounding && !isHidden) {
            system.moveTo(q); // the q before is no worse
            return Ending::Converged;
        }
        q = next;
        residual = nextResidual;
        record(result, residual);
        if (tolerance == 0.0 ? residual == 0.0 : wasBelow && isResolved(residual)) {
            return Ending::Converged;
        }
    }
    // Out of iterations beside a toggle: the position is still known, to 2 √(r/b).
    const bool isLocated =
        residual <= std::max(4.0 * kResolvedPart * kResolvedPart * measured(mechanism.b()), rounding);
    return residual <= tolerance && isLocated ? Ending::Converged : Ending::IterationLimit;
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
    const bool isKnown = std::abs(mechanism.omega2() * t) + std::abs(mechanism.theta20()) <= kLargestDrive;
    // Rounding is monotone: where this holds of the rounded difference, it does of the exact one.
    const bool turnsRound = mechanism.b() - mechanism.a() > std::abs(mechanism.c());
    if (turnsRound && isKnown) {
        return true; // the ordinary case, without looking at the angle
    }
    const TwoPart angle = crankAngle(mechanism.omega2(), t, mechanism.theta20());
    if (!isKnown || !std::isfinite(angle.hi) || !std::isfinite(angle.lo)) {
        result.status = Status::NotFinite;
    } else if (!Clearance(mechanism).at(angle).assemblable()) {
        result.status = Status::NotAssemblable;
    } else {
        return true;
    }
    return false;
}

template <class System>
void assembleFromAfar(System &system, const Mechanism &mechanism, double t, const NewtonOptions &options,
                      typename System::Coordinates &q, NewtonResult &result)
{
    q = system.coordinatesOf(farStart(mechanism, t));
    result.startedAfar = true;
    const int maxIterations = std::max(kAssemblyIterations, options.maxIterations);
    conclude(result, iterate(system, mechanism, options, maxIterations, q, result));
}

/// From q, and into it.
template <class System>
void trackFrom(System &system, const Mechanism &mechanism, double t, const NewtonOptions &options,
               typename System::Coordinates &q, NewtonResult &result)
{
    const Ending ending = isOnBranch(mechanism, theta3Of(q))
                              ? iterate(system, mechanism, options, options.maxIterations, q, result)
                              : Ending::LeftBranch;
    if (ending == Ending::LeftBranch) {
        assembleFromAfar(system, mechanism, t, options, q, result);
    } else {
        conclude(result, ending);
    }
}

void setNothing(State &state)
{
    state.qDot.setConstant(kNone);
    state.qDDot.setConstant(kNone);
}

/// Velocity and acceleration at the q of `system`, whose residual is given in mm. For kResolvedPart, what θ̈3 is made of
///     b cos θ3 θ̈3 = a ω² sin θ2 + b sin θ3 θ̇3²
/// is set beside what is left of it (beside an exact toggle the two all but cancel), or would be where nothing is
/// steep. Of sin θ3 are uncertain: what the residual tells, a rounding, and what θ2 lost when ω t and θ20 were rounded,
/// δ: (a/b) cos θ2 δ, and the same part of cos θ2 itself.
template <class System>
void differentiateHere(const System &system, const Mechanism &mechanism, double residual, State &state)
{
    const bool finite = system.differentiate(state);
    const double cosine = std::abs(system.cosTheta3());
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    constexpr double kSmallest = 4.0 * std::numeric_limits<double>::denorm_min(); // what sums of a few lengths lose
    const double rounding = kEpsilon * std::max(mechanism.b(), mechanism.a() + std::abs(mechanism.c())) + kSmallest;
    double uncertainty = std::max(residual, rounding) / mechanism.b();
    constexpr double kManyAngles = 1000.0; // rad: below, it is less than the rounding wherever that counts
    const double angles = std::abs(state.q[Theta2] - mechanism.theta20()) + std::abs(state.q[Theta2]);
    if (angles > kManyAngles && mechanism.omega2() != 0.0) {
        const double delta = 0.5 * kEpsilon * angles;
        const double pace = std::abs(state.qDot[Theta3] / mechanism.omega2());
        uncertainty += delta * cosine * (pace + mechanism.a() / mechanism.b());
    }
    const double crankTerm = mechanism.a() * mechanism.omega2() * mechanism.omega2();
    const double couplerTerm = mechanism.b() * state.qDot[Theta3] * state.qDot[Theta3];
    const double uncertain = uncertainty * (crankTerm + couplerTerm);
    const double resolved = kResolvedPart * (cosine * cosine) * cosine;
    // Beside the accelerations of a coupler that whirls the crank's own are lost to rounding.
    const bool isCrankThere = kEpsilon * couplerTerm <= kResolvedPart * kResolvedPart * crankTerm;
    const bool exists = finite && isCrankThere &&
                        (uncertain <= resolved * (mechanism.b() * std::abs(state.qDDot[Theta3])) ||
                         uncertain <= resolved * (crankTerm * partLeftOfAcceleration(mechanism)));
    state.status = exists ? Status::Solved : Status::Singular;
    if (!exists) {
        setNothing(state);
    }
}

/// Whether the next instant can start from this one. From a square coupler it cannot: there the matrix is singular.
bool isWarm(const NewtonInstant &instant)
{
    const bool hasPosition =
        instant.positionStatus == Status::Solved || instant.positionStatus == Status::IterationLimit;
    return hasPosition && instant.state.status != Status::Singular;
}

/// What `before` lets expect of t.
template <class System>
typename System::Coordinates expected(const System &system, const Mechanism &mechanism, const NewtonInstant &before,
                                      double t, WarmStart warmStart)
{
    if (warmStart == WarmStart::Previous || before.state.status != Status::Solved) {
        return system.coordinatesOf(before.q);
    }
    const double step = t - before.t;
    const double half = 0.5 * step;
    Vector12 q;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        q[i] = before.q[i] + step * (before.state.qDot[i] + half * before.state.qDDot[i]);
    }
    q[Theta2] = mechanism.omega2() * t + mechanism.theta20(); // linear in t: the same, without the rounding
    return system.coordinatesOf(q);
}

/// Calls work(system) with the system that solves at t.
template <class Work>
void withSystem(const Mechanism &mechanism, double t, Elimination elimination, const Work &work)
{
    switch (elimination) {
    case Elimination::Dense: {
        DenseSystem system(mechanism, t);
        work(system);
        break;
    }
    case Elimination::Structured: {
        StructuredSystem system(mechanism, t);
        work(system);
        break;
    }
    }
}

} // namespace

// sin θ3 - h/b rises and bends one way between here and the root.
Vector12 farStart(const Mechanism &mechanism, double t)
{
    const double theta2 = mechanism.omega2() * t + mechanism.theta20();
    const double theta3 = branchCentre(mechanism.branch());
    const double pinX = mechanism.a() * std::cos(theta2);
    const double pinY = mechanism.a() * std::sin(theta2);
    const double couplerX = mechanism.branch() == Branch::Open ? mechanism.b() : -mechanism.b();
    Vector12 start;
    start << 0.0, 0.0, 0.0, 0.5 * pinX, 0.5 * pinY, theta2, pinX + 0.5 * couplerX, pinY, theta3, pinX + couplerX,
        mechanism.c(), 0.0;
    return start;
}

NewtonResult assemble(const Mechanism &mechanism, double t, const NewtonOptions &options)
{
    NewtonResult result;
    result.q.setConstant(kNone);
    if (canStart(mechanism, t, result)) {
        withSystem(mechanism, t, options.elimination, [&]<class System>(System &system) {
            typename System::Coordinates q;
            assembleFromAfar(system, mechanism, t, options, q, result);
            system.write(q, result.q);
        });
    }
    return result;
}

NewtonResult track(const Mechanism &mechanism, double t, const Vector12 &start, const NewtonOptions &options)
{
    NewtonResult result;
    result.q.setConstant(kNone);
    if (canStart(mechanism, t, result)) {
        withSystem(mechanism, t, options.elimination, [&]<class System>(System &system) {
            typename System::Coordinates q = system.coordinatesOf(start);
            trackFrom(system, mechanism, t, options, q, result);
            system.write(q, result.q);
        });
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

void advance(const Mechanism &mechanism, double t, NewtonInstant &instant, const NewtonOptions &options)
{
    NewtonResult position;
    State &state = instant.state;
    if (canStart(mechanism, t, position)) {
        withSystem(mechanism, t, options.elimination, [&]<class System>(System &system) {
            typename System::Coordinates q;
            if (isWarm(instant)) {
                q = expected(system, mechanism, instant, t, options.warmStart);
                trackFrom(system, mechanism, t, options, q, position);
            } else {
                assembleFromAfar(system, mechanism, t, options, q, position);
            }
            system.write(q, instant.q);
            if (position.status == Status::Solved) {
                const bool relative = options.toleranceKind == ToleranceKind::Relative;
                const double residual =
                    relative ? position.residual() * characteristicLength(mechanism.parameters()) : position.residual();
                system.write(q, state.q);
                differentiateHere(system, mechanism, residual, state);
            }
        });
    } else {
        instant.q.setConstant(kNone);
    }
    if (position.status != Status::Solved) {
        state.q.setConstant(kNone);
        setNothing(state);
        state.status = position.status;
    }
    instant.t = t;
    instant.iterations = position.iterations;
    instant.residual = position.residual();
    instant.positionStatus = position.status;
    instant.startedAfar = position.startedAfar;
}

NewtonInstant solveInstant(const Mechanism &mechanism, double t, const NewtonInstant &before,
                           const NewtonOptions &options)
{
    NewtonInstant here = before;
    advance(mechanism, t, here, options);
    return here;
}

} // namespace slidercrank
