// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/positions.h"

#include "core/limits/crank_limit.h"

#include <iterator>
#include <optional>

namespace slidercrank
{

namespace
{

/// Returns the column of a channel, which is empty if it was not sampled.
std::vector<double> &columnOf(Trajectory &trajectory, const OutputChannel &channel)
{
    const Channel *coordinate = std::get_if<Channel>(&channel);
    return coordinate ? trajectory.values[indexOf(*coordinate)]
                      : trajectory.derived[indexOf(std::get<DerivedChannel>(channel))];
}

/// Returns a trajectory of the time stamp t alone, at which the crank is at the end of its arc in this state.
Trajectory limitRow(const Mechanism &mechanism, double t, const OutputState &state, const SampledChannels &channels)
{
    Trajectory trajectory = sample(mechanism, {t}, channels, {}); // its values are replaced below
    bool hasDerivative = false;
    for (const OutputChannel &channel : allOutputChannels()) {
        std::vector<double> &column = columnOf(trajectory, channel);
        if (!column.empty()) {
            column.front() = toFileUnit(measureOf(channel), state.valueOf(channel));
            hasDerivative = hasDerivative || orderOf(channel) != Order::Position;
        }
    }
    const Status status = hasDerivative ? state.state.status : Status::Solved;
    SamplingSummary &summary = trajectory.summary;
    summary = {.timeSteps = 1};
    summary.withStatus(status) = {
        .count = 1, .firstTime = trajectory.time.front(), .firstTheta2 = state.state.q[Theta2]};
    trajectory.status.front() = status;
    return trajectory;
}

} // namespace

Trajectory samplePositions(const Mechanism &mechanism, const std::vector<double> &times,
                           const SampledChannels &channels, const SolverSettings &settings)
{
    const MotionLimits limits = motionLimits(mechanism);
    Trajectory motion = sample(mechanism, {}, channels, settings);
    auto next = times.begin(); // the first time stamp that `motion` does not contain yet
    for (auto time = times.begin(); time != times.end(); ++time) {
        if (const std::optional<OutputState> limit = crankLimitStateAt(mechanism, limits, *time, channels.alpha2)) {
            motion.append(sample(mechanism, {next, time}, channels, settings));
            motion.append(limitRow(mechanism, *time, *limit, channels));
            next = std::next(time);
        }
    }
    motion.append(sample(mechanism, {next, times.end()}, channels, settings));
    return motion;
}

} // namespace slidercrank
