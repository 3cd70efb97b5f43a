// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Helpers that run Newton-Raphson and compare the results with the exact motion.

#include "core/closed_form/state_at.h"
#include "core/mechanism/turn.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"

#include <QString>

#include <numbers>

namespace slidercrank
{

inline constexpr NewtonOptions kReportOptions; ///< Table 2 of the reference report
inline constexpr NewtonOptions kSmallestResidual{.maxIterations = 50,
                                                 .tolerance = 0.0}; ///< iterates until the residual no longer decreases

/// Returns every combination of elimination, warm start and tolerance kind, starting with that of the reference report.
inline std::vector<NewtonOptions> optionCombinations(int maxIterations, double tolerance)
{
    std::vector<NewtonOptions> combinations;
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const WarmStart warmStart : {WarmStart::Previous, WarmStart::Taylor}) {
            for (const ToleranceKind kind : {ToleranceKind::Absolute, ToleranceKind::Relative}) {
                combinations.push_back({maxIterations, tolerance, kind, warmStart, elimination});
            }
        }
    }
    return combinations;
}

/// Solves the time steps one after the other, each with a warm start from the previous one.
inline std::vector<NewtonTimeStep> solveInTurn(const Parameters &parameters, const std::vector<double> &times,
                                               const NewtonOptions &options)
{
    const Mechanism mechanism(parameters);
    std::vector<NewtonTimeStep> done;
    NewtonTimeStep timeStep;
    for (const double t : times) {
        advance(mechanism, t, timeStep, options);
        done.push_back(timeStep);
    }
    return done;
}

inline bool isAngleRow(Eigen::Index row)
{
    return row == GroundAngle || row == SliderAngle || row == CrankDrive;
}

/// Returns a time step that provides start coordinates but no derivatives.
inline NewtonTimeStep startAt(const Vector12 &q)
{
    NewtonTimeStep start;
    start.q = q;
    start.positionStatus = Status::Solved;
    start.state.status = Status::NotFinite;
    return start;
}

/// Returns the time stamps of `steps` equal time steps in this number of turns.
inline std::vector<double> timeStampsOfTurns(const Parameters &parameters, int steps, double turns = 1.0)
{
    return Sampling{0.0, turns * kTurn / std::abs(parameters.omega2), steps}.timeStamps();
}

/// Describes the options by the values of their enumerators.
inline QString describe(const NewtonOptions &options)
{
    return QStringLiteral("elimination %1, warm start %2, tolerance kind %3, tolerance %4; ")
        .arg(int(options.elimination))
        .arg(int(options.warmStart))
        .arg(int(options.toleranceKind))
        .arg(options.tolerance);
}

inline QString describe(const Parameters &parameters, const NewtonTimeStep &timeStep)
{
    return QStringLiteral("%1\n    t=%2: status %3 after %4 iterations, residual %5, theta3 %6")
        .arg(QString::fromStdString(describe(parameters)))
        .arg(timeStep.t, 0, 'g', 17)
        .arg(int(timeStep.state.status))
        .arg(timeStep.iterations)
        .arg(timeStep.residual)
        .arg(timeStep.q[Theta3], 0, 'g', 17);
}

/// Returns the state by the closed form, as reference for deviations.
inline RoughState<double> closedFormState(const Parameters &parameters, double t)
{
    const State state = ClosedForm{Mechanism(parameters)}.stateAt(t);
    RoughState<double> exact;
    exact.status = state.status;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        exact.values[index] = valueOf(state, channelAt(index));
    }
    return exact;
}

inline double exactTheta3(const Parameters &parameters, double t)
{
    return ClosedForm{Mechanism(parameters)}.motionAt(t).theta3;
}

inline Deviation worseOf(const Deviation &x, const Deviation &y)
{
    return y.ratio() > x.ratio() ? y : x;
}

} // namespace slidercrank
