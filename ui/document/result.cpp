// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/result.h"

#include "core/closed_form/closed_form.h"
#include "core/import/reference_data.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kMostStepsKept = 100'000; // of the closed form

/// Whether the crank turns round with room to spare, at angles that vectors are for (batch.h): then every instant is
/// Solved, and many are computed at once.
bool isOrdinary(const Request &request)
{
    constexpr double kRoomToSpare = 1.0 + 1e-9;
    constexpr double kLargestAngle = 1e6; // rad
    const Parameters &p = request.mechanism.parameters();
    const Sampling &run = request.sampling;
    const double latest = std::max(std::abs(run.start), std::abs(run.start + run.duration));
    return p.b > kRoomToSpare * (p.a + std::abs(p.c)) &&
           std::abs(p.theta20) + std::abs(p.omega2) * latest <= kLargestAngle;
}

/// Of a run in closed form.
SamplingSummary summaryOf(const Request &request, std::stop_token stop)
{
    SamplingSummary summary;
    if (isOrdinary(request)) {
        summary.instants = static_cast<std::size_t>(request.sampling.steps) + 1;
        summary.statusCounts[static_cast<std::size_t>(Status::Solved)] = summary.instants;
        return summary;
    }
    const auto add = [&summary](const Trajectory &piece) {
        summary.add(piece.summary);
        return true;
    };
    sampleInPieces(request.mechanism, request.sampling, {}, request.solver, add, std::move(stop));
    return summary;
}

} // namespace

Pose poseAt(const Parameters &parameters, double seconds)
{
    const Motion motion = ClosedForm(Mechanism(parameters)).motionAt(seconds);
    return {.time = seconds,
            .theta2 = motion.theta2,
            .theta3 = motion.theta3,
            .pinX = parameters.a * motion.crank.cos,
            .pinY = parameters.a * motion.crank.sin,
            .sliderX = motion.R4x,
            .status = motion.status};
}

std::shared_ptr<const Result> compute(const Request &request, std::stop_token stop)
{
    auto result = std::make_shared<Result>();
    result->mechanism = request.mechanism;
    result->sampling = request.sampling;
    result->solver = request.solver;
    result->reference = request.reference;
    result->kept = request.kept;
    if (request.reference && request.reference->data.crank) {
        const auto timed = timedBy(request.mechanism, request.reference);
        if (const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&timed)) {
            result->reference = *reference;
            result->untimed = request.reference;
        }
    }
    result->limits = motionLimits(request.mechanism);
    if (!request.reference && !request.kept.empty()) {
        const Sampling &run = request.sampling;
        result->difference =
            differenceOf(request.mechanism, Mechanism(request.kept.back()), run.start, run.start + run.duration);
    }
    if (request.solver.method == Method::ClosedForm && request.sampling.steps >= kMostStepsKept) {
        result->summary = summaryOf(request, stop);
        result->trajectory.complete = !stop.stop_requested();
    } else {
        QElapsedTimer clock;
        clock.start();
        result->trajectory =
            sample(request.mechanism, request.sampling.instants(), plottedChannels(), request.solver, stop);
        if (request.solver.method == Method::Newton) {
            result->sampleSeconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
        }
        result->summary = result->trajectory.summary;
    }
    if (request.reference && result->trajectory.complete) {
        const ReferenceData &data = result->reference->data;
        result->atReference = sample(request.mechanism, data.time, channelsOf(data), request.solver, stop);
        if (result->atReference.complete) {
            result->comparison = compare(request.mechanism, result->atReference, data);
        }
    }
    if (!result->trajectory.complete || !result->atReference.complete) {
        return nullptr;
    }
    return result;
}

/// Costs per instant are those of a slow machine.
bool takesLong(const Request &request)
{
    constexpr double kMoment = 0.05; // s: below what a person takes for a stop
    constexpr double kDenseSeconds = 20e-6;
    constexpr double kStructuredSeconds = 1e-6;
    constexpr double kClosedFormSeconds = 0.2e-6;
    constexpr double kManyAtOnceSeconds = 40e-9;
    const double newton = request.solver.newton.elimination == Elimination::Dense ? kDenseSeconds : kStructuredSeconds;
    const double closedForm = isOrdinary(request) ? kManyAtOnceSeconds : kClosedFormSeconds;
    const double each = request.solver.method == Method::Newton ? newton : closedForm;
    const double compared = std::max(each, kClosedFormSeconds); // as long as computing it
    const double atReference = request.reference ? static_cast<double>(request.reference->data.time.size()) : 0.0;
    return each * (request.sampling.steps + 1.0) + compared * atReference > kMoment;
}

} // namespace slidercrank
