// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/newton.h"

#include "core/closed_form/closed_form.h"
#include "core/newton/constraints.h"
#include "core/newton/structured_system.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Returns the centre of the range of θ3 of the branch.
double branchCentre(Branch branch)
{
    return branch == Branch::Open ? 0.0 : std::numbers::pi;
}

/// Returns whether cos θ3 has the sign of the branch, or is 0 within rounding.
bool isOnBranch(const Mechanism &mechanism, double theta3)
{
    constexpr double kTheta3Rounding = 1.2e-7; // rad, where cos θ3 = 0: √(2 r/b) for a residual of r/b = 7e-15
    const double fromCentre = std::abs(theta3 - branchCentre(mechanism.branch()));
    return fromCentre <= 0.5 * std::numbers::pi + kTheta3Rounding; // false for NaN
}

/// Solves the linear systems as the reference report does. Has the interface of StructuredSystem.
class DenseSystem
{
public:
    using Coordinates = Vector12;
    static const Vector12 &read(const Vector12 &q) { return q; }
    static void write(const Vector12 &q, Vector12 &to) { to = q; }

    DenseSystem(const Mechanism &mechanism, double t)
        : m_mechanism(mechanism)
        , m_t(t)
    {
    }

    void moveTo(const Vector12 &q)
    {
        m_C = constraints(m_mechanism, q, m_t);
        m_cosTheta3 = std::cos(q[Theta3]);
    }

    void moveNear(const Vector12 &q) { moveTo(q); }

    double residual(double perLength) const
    {
        Vector12 scaled = perLength * m_C;
        for (const Constraint row : {GroundAngle, SliderAngle, CrankDrive}) {
            scaled[row] = m_C[row];
        }
        return scaled.norm();
    }

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

/// Returns the magnitude of θ̈3 away from a toggle or, if that is larger, as near to a toggle as a sampled motion comes,
/// in units of a ω²/b and at most 1. According to
///     b³ cos³ θ3 θ̈3 = a ω² (sin θ2 (b² - a² - c²) + a c (1 + sin² θ2))
/// θ̈3 is close to 0 if a ≈ b and c ≈ 0: then θ3 follows the crank, except at the toggle. A motion sampled in a hundred
/// steps per revolution comes within φ = π/100 of the toggle, where θ̈3 is 1/φ³ times as large.
double relativeAcceleration(const Mechanism &mechanism)
{
    constexpr double kGrowth = 3e4; // 1/φ³
    const double a = mechanism.a();
    const double b = mechanism.b();
    const double c = mechanism.c();
    const double seen = kGrowth * (std::abs((b - a) * (b + a) - c * c) + std::abs(a * c));
    const bool isOrdinary = seen >= b * b || seen == 0.0; // a = b and c = 0: θ̈3 is 0 throughout
    return isOrdinary ? 1.0 : seen / (b * b);
}

/// The residuals at which the iteration may stop, in the measure of the options.
struct Thresholds {
    double perLength; ///< factor from mm to the measure
    double rounding;  ///< largest residual that rounding alone can cause: each length row is a sum of a few lengths
    double tolerance; ///< that of the options, at most kResolvedFraction of a, so that the motion of a short crank
                      ///< keeps some digits
    double fractionOfCrank;   ///< kResolvedFraction of a
    double fractionOfCoupler; ///< kResolvedFraction of b
    double perCosineCubed; ///< isResolved() allows |cos θ3|³ times this: near a toggle the terms of θ̈3 cancel down to
                           ///< a third of cos θ3

    Thresholds(const Mechanism &mechanism, const NewtonOptions &options)
    {
        constexpr double kRoundings = 32.0;
        const double reach = characteristicLength(mechanism.parameters());
        perLength = options.toleranceKind == ToleranceKind::Relative ? 1.0 / reach : 1.0;
        rounding = kRoundings * kEpsilon * perLength * reach;
        fractionOfCrank = kResolvedFraction * perLength * mechanism.a();
        fractionOfCoupler = kResolvedFraction * perLength * mechanism.b();
        tolerance = std::min(options.tolerance, std::max(fractionOfCrank, rounding));
        perCosineCubed = fractionOfCoupler * relativeAcceleration(mechanism) / 3.0;
    }

    /// Returns whether velocity and acceleration can be computed from a position with this residual.
    bool isResolved(double residual, double cosTheta3) const
    {
        const double cosine = std::abs(cosTheta3);
        return residual <= perCosineCubed * (cosine * cosine * cosine) || residual <= rounding;
    }
};

enum class Ending { Converged, IterationLimit, LeftBranch };

/// Solves one time step by Newton-Raphson.
template <class System>
class Solver
{
public:
    using Coordinates = typename System::Coordinates;

    Solver(const Mechanism &mechanism, double t, const NewtonOptions &options, NewtonTimeStep &timeStep,
           IterationHistory *history)
        : m_mechanism(mechanism)
        , m_t(t)
        , m_options(options)
        , m_system(mechanism, t)
        , m_thresholds(mechanism, options)
        , m_timeStep(timeStep)
        , m_history(history)
    {
    }

    void solve()
    {
        m_timeStep.iterations = 0;
        Ending ending = Ending::LeftBranch;
        if (hasWarmStart()) {
            m_q = System::read(warmStart());
            if (isOnBranch(m_mechanism, theta3Of(m_q))) {
                ending = iterate(m_options.maxIterations);
            }
        }
        m_timeStep.isColdStart = ending == Ending::LeftBranch;
        if (m_timeStep.isColdStart) {
            m_q = System::read(coldStart(m_mechanism, m_t));
            ending = iterate(std::max(kColdStartIterations, m_options.maxIterations));
        }
        m_timeStep.positionStatus = ending == Ending::Converged ? Status::Solved : Status::IterationLimit;
        System::write(m_q, m_timeStep.q);
        if (ending == Ending::Converged) {
            System::write(m_q, m_timeStep.state.q);
            differentiate();
        }
    }

private:
    /// Returns whether the iteration can start from the previous position. It cannot if there is none, or if the
    /// coupler is perpendicular to the slider's line there, where C_q is singular.
    bool hasWarmStart() const
    {
        const Status status = m_timeStep.positionStatus;
        return (status == Status::Solved || status == Status::IterationLimit) &&
               m_timeStep.state.status != Status::Singular;
    }

    /// Returns the starting point that the previous time step predicts.
    Vector12 warmStart() const
    {
        if (m_options.warmStart == WarmStart::Previous || m_timeStep.state.status != Status::Solved) {
            return m_timeStep.q;
        }
        const State &before = m_timeStep.state;
        const double step = m_t - m_timeStep.t;
        const double half = 0.5 * step;
        Vector12 q;
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            q[i] = before.q[i] + step * (before.qDot[i] + half * before.qDDot[i]);
        }
        q[Theta2] =
            m_mechanism.omega2() * m_t + m_mechanism.theta20(); // linear in t: the same value without rounding errors
        return q;
    }

    /// Adds the current iterate to the history, if one is requested.
    void record()
    {
        if (m_history) {
            if (m_history->size() == kLongestHistory) {
                m_history->pop_back();
            }
            System::write(m_q, m_history->emplace_back().q);
            m_history->back().residual = m_timeStep.residual;
        }
    }

    /// Evaluates the residual of the starting point m_q, with which the history begins.
    void evaluateStart()
    {
        m_system.moveTo(m_q);
        m_timeStep.residual = m_system.residual(m_thresholds.perLength);
        if (m_history) {
            m_history->clear();
        }
        record();
    }

    /// Returns the ending if the iteration limit is reached. That may happen near a toggle, where θ3 is uncertain by
    /// 2 √(r/b): by 0.004 rad with the largest residual r that is accepted.
    Ending endingAtIterationLimit() const
    {
        const double accepted =
            std::max(4.0 * kResolvedFraction * m_thresholds.fractionOfCoupler, m_thresholds.rounding);
        return m_timeStep.residual <= std::min(m_thresholds.tolerance, accepted) ? Ending::Converged
                                                                                 : Ending::IterationLimit;
    }

    /// Iterates from m_q. Leaves `m_system` at the last m_q.
    Ending iterate(int maxIterations)
    {
        const Thresholds &limit = m_thresholds;
        const bool untilNoDecrease = limit.tolerance == 0.0;
        const bool stopsBeforeUpdate = m_options.warmStart == WarmStart::Taylor && !untilNoDecrease;
        double &residual = m_timeStep.residual;
        evaluateStart();
        if (limit.rounding > limit.fractionOfCoupler) {
            return Ending::IterationLimit; // the coupler is so short that θ3 is lost in rounding
        }
        for (int iteration = 0; iteration < maxIterations; ++iteration) {
            if (stopsBeforeUpdate && residual <= std::min(limit.tolerance, limit.fractionOfCrank) && isResolved()) {
                return Ending::Converged;
            }
            const Coordinates next = m_system.next(m_q);
            if (!isOnBranch(m_mechanism, theta3Of(next))) {
                // At a toggle the matrix is nearly singular: beyond the last good iterate, a step is rounding noise.
                return residual <= limit.rounding ? Ending::Converged : Ending::LeftBranch;
            }
            ++m_timeStep.iterations;
            const bool wasBelow = residual <= limit.tolerance; // tested before the update, as in the reference report
            if (!untilNoDecrease && (stopsBeforeUpdate || wasBelow)) {
                m_system.moveNear(next); // probably the last iterate
            } else {
                m_system.moveTo(next);
            }
            const double nextResidual = m_system.residual(limit.perLength);
            if (untilNoDecrease && !(nextResidual < residual) && residual <= limit.rounding) {
                m_system.moveTo(m_q); // the previous iterate is at least as accurate
                return Ending::Converged;
            }
            m_q = next;
            residual = nextResidual;
            record();
            if (untilNoDecrease ? residual == 0.0 : wasBelow && isResolved()) {
                return Ending::Converged;
            }
        }
        return endingAtIterationLimit();
    }

    bool isResolved() const { return m_thresholds.isResolved(m_timeStep.residual, m_system.cosTheta3()); }

    /// Computes velocity and acceleration, and decides whether they are accurate enough (kResolvedFraction). By
    ///     b cos θ3 θ̈3 = a ω² sin θ2 + b sin θ3 θ̇3²
    /// the uncertainty of the two terms on the right must be small compared with θ̈3 itself (at an exact toggle they
    /// nearly cancel) or, if that is larger, with its ordinary magnitude. The uncertainty s of sin θ3 is the residual
    /// or, if larger, its rounding error. It changes θ̇3², which is inversely proportional to cos² θ3, by up to
    /// 2 s/cos² θ3 of itself; hence, apart from the factor 2, the condition
    ///     s (a ω² + b θ̇3²) <= kResolvedFraction · cos³ θ3 · b |θ̈3|.
    /// In addition, the term of the crank must exceed the rounding error of that of the coupler.
    void differentiate()
    {
        State &state = m_timeStep.state;
        const bool isFinite = m_system.differentiate(state);
        const double a = m_mechanism.a();
        const double b = m_mechanism.b();
        const double cosine = std::abs(m_system.cosTheta3());
        const double rounding = kEpsilon * std::max(b, a + std::abs(m_mechanism.c()));
        const double residual = m_timeStep.residual / m_thresholds.perLength;
        const double sineUncertainty = std::max(residual, rounding) / b;
        const double crankTerm = a * m_mechanism.omega2() * m_mechanism.omega2();
        const double couplerTerm = b * state.qDot[Theta3] * state.qDot[Theta3];
        const double termUncertainty = sineUncertainty * (crankTerm + couplerTerm);
        const double ordinaryMagnitude = crankTerm * relativeAcceleration(m_mechanism);
        const double magnitude = std::max(b * std::abs(state.qDDot[Theta3]), ordinaryMagnitude);
        // If the coupler is much shorter than the crank, its term is so large that rounding hides that of the crank.
        const bool isCrankResolved = kEpsilon * couplerTerm <= kResolvedFraction * kResolvedFraction * crankTerm;
        const bool exists = isFinite && isCrankResolved &&
                            termUncertainty <= kResolvedFraction * (cosine * cosine) * cosine * magnitude;
        state.setStatus(exists ? Status::Solved : Status::Singular);
    }

    const Mechanism &m_mechanism;
    double m_t;
    const NewtonOptions &m_options;
    System m_system;
    Thresholds m_thresholds;
    NewtonTimeStep &m_timeStep;
    IterationHistory *m_history;
    Coordinates m_q;
};

/// Returns Solved if a position exists, otherwise the reason why there is none.
Status statusBeforeIterating(const Mechanism &mechanism, double t)
{
    const bool isResolved = std::abs(mechanism.omega2() * t) + std::abs(mechanism.theta20()) <= kLargestDrive;
    // Rounding is monotone: if this is true of the rounded difference, it is true of the exact one.
    const bool makesFullTurns = mechanism.b() - mechanism.a() > std::abs(mechanism.c());
    if (!isResolved) {
        return Status::NotFinite;
    }
    if (makesFullTurns) {
        return Status::Solved; // the ordinary case, without computing the angle
    }
    const Status status = ClosedForm(mechanism).motionAt(t).status;
    return status == Status::Singular ? Status::Solved : status;
}

} // namespace

// Between this point and the root, sin θ3 - h/b with h = c - a sin θ2 is a monotone function of θ3 whose curvature does
// not change sign, so that Newton-Raphson converges monotonically.
Vector12 coldStart(const Mechanism &mechanism, double t)
{
    const double theta2 = mechanism.omega2() * t + mechanism.theta20();
    const double pinX = mechanism.a() * std::cos(theta2);
    const double pinY = mechanism.a() * std::sin(theta2);
    const double couplerX = mechanism.branch() == Branch::Open ? mechanism.b() : -mechanism.b();
    Vector12 start;
    setCoordinates(start, {.R2x = 0.5 * pinX,
                           .R2y = 0.5 * pinY,
                           .theta2 = theta2,
                           .R3x = pinX + 0.5 * couplerX,
                           .R3y = pinY,
                           .theta3 = branchCentre(mechanism.branch()),
                           .R4x = pinX + couplerX,
                           .R4y = mechanism.c()});
    return start;
}

void advance(const Mechanism &mechanism, double t, NewtonTimeStep &timeStep, const NewtonOptions &options,
             IterationHistory *history)
{
    const Status status = statusBeforeIterating(mechanism, t);
    if (status != Status::Solved) {
        if (history) {
            history->clear();
        }
        timeStep.q.setConstant(kNone);
        timeStep.iterations = 0;
        timeStep.residual = 0.0;
        timeStep.positionStatus = status;
        timeStep.isColdStart = false;
    } else if (options.elimination == Elimination::Dense) {
        Solver<DenseSystem>(mechanism, t, options, timeStep, history).solve();
    } else {
        Solver<StructuredSystem>(mechanism, t, options, timeStep, history).solve();
    }
    if (timeStep.positionStatus != Status::Solved) {
        timeStep.state.setStatus(timeStep.positionStatus);
    }
    timeStep.t = t;
}

NewtonTimeStep solve(const Mechanism &mechanism, double t, const NewtonOptions &options, NewtonTimeStep start,
                     IterationHistory *history)
{
    advance(mechanism, t, start, options, history);
    return start;
}

} // namespace slidercrank
