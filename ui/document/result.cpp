// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/result.h"

#include "core/limits/crank_limit.h"

#include <QElapsedTimer>

#include <algorithm>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kMinUnstoredSteps = 100'000; // from here on, samples in closed form are computed when they are needed

/// Returns the summary of a motion in closed form whose samples are not stored.
SamplingSummary summarize(const Choices &choices, std::stop_token stop)
{
    SamplingSummary summary;
    const auto &[start, duration, steps] = choices.sampling;
    const Mechanism mechanism(choices.parameters);
    const bool isSolvedEverywhere = mechanism.b() > shortestCouplerForFullTurn(mechanism) &&
                                    poseAt(choices.parameters, start).exists() &&
                                    poseAt(choices.parameters, start + duration).exists();
    if (isSolvedEverywhere) {
        summary.timeSteps = static_cast<std::size_t>(steps) + 1;
        summary.withStatus(Status::Solved) = {.count = summary.timeSteps,
                                              .firstTime = start,
                                              .firstTheta2 = mechanism.theta20() + mechanism.omega2() * start};
        return summary;
    }
    const auto add = [&summary](const Trajectory &piece) {
        summary.add(piece.summary);
        return true;
    };
    sampleInPieces(mechanism, choices.sampling, ChannelSet(), choices.solver, add, std::move(stop));
    return summary;
}

} // namespace

SolverSettings initialSolver()
{
    SolverSettings solver;
    solver.newton.elimination = Elimination::Structured; // the same iterates as Dense, ten times faster
    return solver;
}

Pose poseAt(const Parameters &parameters, double seconds)
{
    const Mechanism mechanism(parameters);
    const std::optional<Motion> limit = crankLimitMotionAt(mechanism, motionLimits(mechanism), seconds, 0.0);
    return {.time = seconds, .motion = limit ? *limit : ClosedForm(mechanism).motionAt(seconds)};
}

Parameters mechanismToUse(const Identification &found)
{
    Parameters parameters = found.rounded;
    if (found.drive && found.drive->alpha2) { // the ω2 found is the speed at t = 0
        parameters.omega2 = std::midpoint(found.drive->least, found.drive->greatest);
    }
    return parameters;
}

std::shared_ptr<const Result> compute(const Choices &choices, std::stop_token stop)
{
    auto result = std::make_shared<Result>();
    const auto &[parameters, sampling, solver, reference, pinned, alpha2] = choices;
    const Mechanism mechanism(parameters);
    result->choices = choices;
    result->mechanism = mechanism;
    result->sampling = sampling;
    result->solver = solver;
    result->pinned = pinned;
    const ReferenceOutcome timed = timedBy(mechanism, reference);
    const auto *found = std::get_if<std::shared_ptr<const Reference>>(&timed);
    result->reference = found ? *found : reference;
    result->limits = motionLimits(mechanism);
    if (!reference && !pinned.empty()) {
        const double end = sampling.start + sampling.duration;
        result->difference = differenceOf(mechanism, Mechanism(pinned.back()), sampling.start, end);
    }
    if (solver.method == Method::ClosedForm && sampling.steps >= kMinUnstoredSteps) {
        result->summary = summarize(choices, stop);
        result->trajectory.complete = !stop.stop_requested();
    } else {
        QElapsedTimer clock;
        clock.start();
        result->trajectory = sample(mechanism, sampling.timeStamps(), plottedChannels(), solver, stop);
        if (solver.method == Method::Newton) {
            result->sampleSeconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
        }
        result->summary = result->trajectory.summary;
    }
    if (reference && result->trajectory.complete) {
        const ReferenceData &data = result->reference->data;
        result->atReference = sample(mechanism, data.time, channelsOf(data), solver, stop);
        if (result->atReference.complete) {
            result->comparison = compare(mechanism, result->atReference, data);
            findRoundedTime(result->comparison, mechanism, result->atReference, data);
        }
    }
    return result->trajectory.complete && result->atReference.complete ? result : nullptr;
}

// Estimates the duration from the times per time step on a slow computer.
bool takesLong(const Choices &choices)
{
    constexpr double kNoticeableDelay = 0.05;   // s
    constexpr double kTimeOfNewton = 1e-6;      // s per time step
    constexpr double kTimeOfClosedForm = 40e-9; // s per time step
    constexpr double kTimeToCompare = 0.2e-6;   // s per row of the reference
    const double perStep = choices.solver.method == Method::Newton ? kTimeOfNewton : kTimeOfClosedForm;
    const double rows = choices.reference ? static_cast<double>(choices.reference->data.time.size()) : 0.0;
    return perStep * (choices.sampling.steps + 1.0) + std::max(perStep, kTimeToCompare) * rows > kNoticeableDelay;
}

} // namespace slidercrank
