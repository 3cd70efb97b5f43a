// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/trajectory.h"

#include "core/closed_form/closed_form.h"
#include "core/closed_form/state_at.h"
#include "core/mechanism/in_parallel.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"
#include "core/newton/newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// The number of time stamps between two checks of the stop token.
constexpr std::size_t kStopInterval = 256;

/// Writes one time step at a time into a trajectory.
class RowWriter
{
public:
    RowWriter(Trajectory &trajectory, const SampledChannels &channels)
        : m_trajectory(trajectory)
    {
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            if (channels.coordinates.test(index)) {
                m_coordinates.push_back(channelAt(index));
            }
        }
        for (const OutputChannel &channel : allOutputChannels()) {
            const DerivedChannel *derived = std::get_if<DerivedChannel>(&channel);
            if (derived && channels.derived.test(indexOf(*derived))) {
                m_derived.push_back(*derived);
            }
        }
    }

    /// Writes the coordinates. Derived quantities are not written.
    void write(std::size_t row, const State &state)
    {
        m_trajectory.status[row] = state.status;
        for (const Channel channel : m_coordinates) {
            m_trajectory.values[indexOf(channel)][row] = toFileUnit(channel, state.valueOf(channel));
        }
    }

    void write(std::size_t row, const OutputState &output)
    {
        write(row, output.state);
        for (const DerivedChannel channel : m_derived) {
            m_trajectory.derived[indexOf(channel)][row] =
                toFileUnit(measureOf(OutputChannel(channel)), output.valueOf(channel));
        }
    }

private:
    Trajectory &m_trajectory;
    std::vector<Channel> m_coordinates;
    std::vector<DerivedChannel> m_derived;
};

/// Fills the trajectory by calling solve(t), which returns a State or an OutputState, for each time stamp in turn.
template <class Solve>
void sampleOneByOne(Trajectory &trajectory, const SampledChannels &channels, const std::stop_token &stop,
                    const Solve &solve)
{
    RowWriter writer(trajectory, channels);
    for (std::size_t i = 0; i < trajectory.time.size(); ++i) {
        if (i % kStopInterval == 0 && stop.stop_requested()) {
            trajectory.complete = false;
            return;
        }
        writer.write(i, solve(trajectory.time[i]));
    }
}

/// Returns the state with the crank acceleration, and the derived quantities, from a state by Newton-Raphson. The
/// kinematic coefficients are the velocities at a speed of 1 rad/s (crank_acceleration.h).
OutputState outputOf(const Mechanism &mechanism, double t, State state, double alpha2, const NewtonOptions &options)
{
    if (alpha2 != 0.0 && state.status == Status::Solved) {
        const TwoPart angle = crankAngle(mechanism.omega2(), t, mechanism.theta20());
        state.qDDot += alpha2 * solve(withDrive(mechanism, 1.0, angle.hi), angle.lo, options).state.qDot;
    }
    const double adjacent = mechanism.b() * std::cos(state.q[Theta3]);
    return {state, derivedState(mechanism, state, adjacent)};
}

void sampleByNewton(const Mechanism &mechanism, const NewtonOptions &options, const SampledChannels &channels,
                    Trajectory &trajectory, const std::stop_token &stop)
{
    NewtonTimeStep timeStep;
    SamplingSummary &summary = trajectory.summary;
    const auto advanceTo = [&](double t) -> const State & {
        advance(mechanism, t, timeStep, options);
        if (timeStep.positionStatus == Status::Solved) {
            summary.add({.iterations = timeStep.iterations,
                         .maxIterationsOfStep = timeStep.iterations,
                         .largestResidual = timeStep.residual});
        }
        return timeStep.state;
    };
    if (channels.onlyCoordinatesAtConstantSpeed()) {
        sampleOneByOne(trajectory, channels, stop, advanceTo);
    } else {
        sampleOneByOne(trajectory, channels, stop,
                       [&](double t) { return outputOf(mechanism, t, advanceTo(t), channels.alpha2, options); });
    }
}

/// Samples plotted channels only, which is faster than sampling one by one, and on all processors.
void samplePlotted(const Mechanism &mechanism, Trajectory &trajectory, const std::stop_token &stop)
{
    const ClosedForm closedForm(mechanism);
    const std::span<const double> times(trajectory.time);
    const std::span<Status> statuses(trajectory.status);
    const auto evaluate = [&](std::size_t block) {
        const std::size_t first = block * kStopInterval;
        const std::size_t count = std::min(kStopInterval, times.size() - first);
        if (stop.stop_requested()) {
            return;
        }
        PlottedColumns columns{};
        for (std::size_t k = 0; k < columns.size(); ++k) {
            std::vector<double> &values = trajectory.values[indexOf(kPlottedChannels[k])];
            columns[k] = values.empty() ? nullptr : values.data() + first;
        }
        closedForm.evaluate(times.subspan(first, count), columns, statuses.subspan(first, count));
        for (std::size_t k = 0; k < columns.size(); ++k) {
            for (double &value : std::span(columns[k], columns[k] == nullptr ? 0 : count)) {
                value = toFileUnit(kPlottedChannels[k], value);
            }
        }
    };
    constexpr std::size_t kMinTimeStampsForThreads = 1U << 15U; // starting a thread takes as long as a few thousand
    const bool areMany = times.size() > kMinTimeStampsForThreads;
    inParallel((times.size() + kStopInterval - 1) / kStopInterval, evaluate,
               areMany ? Threads::OnePerProcessor : Threads::CallingThread);
    trajectory.complete = !stop.stop_requested();
}

} // namespace

std::vector<double> Sampling::timeStamps(int first, int count) const
{
    std::vector<double> times(static_cast<std::size_t>(count));
    std::ranges::generate(times, [&] { return timeStamp(first++); });
    return times;
}

SampledChannels::SampledChannels(const std::vector<OutputChannel> &channels, double crankAcceleration)
    : alpha2(crankAcceleration)
{
    for (const OutputChannel &channel : channels) {
        if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
            coordinates.set(indexOf(*coordinate));
        } else {
            derived.set(indexOf(std::get<DerivedChannel>(channel)));
        }
    }
}

const std::vector<double> &Trajectory::operator[](const OutputChannel &channel) const
{
    const Channel *coordinate = std::get_if<Channel>(&channel);
    return coordinate ? values[indexOf(*coordinate)] : derived[indexOf(std::get<DerivedChannel>(channel))];
}

void Trajectory::append(const Trajectory &next)
{
    const auto appendAll = [](auto &elements, const auto &nextElements) {
        elements.insert(elements.end(), nextElements.begin(), nextElements.end());
    };
    appendAll(time, next.time);
    appendAll(status, next.status);
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        appendAll(values[index], next.values[index]);
    }
    for (std::size_t index = 0; index < kDerivedChannelCount; ++index) {
        appendAll(derived[index], next.derived[index]);
    }
    summary.add(next.summary);
    complete = complete && next.complete;
}

double timeStepsPerTurn(const Mechanism &mechanism, const Sampling &sampling)
{
    return kTurn * sampling.steps / std::abs(mechanism.omega2() * sampling.duration);
}

void SamplingSummary::add(const SamplingSummary &next)
{
    timeSteps += next.timeSteps;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        if (statuses[i].count == 0) {
            statuses[i] = next.statuses[i];
        } else {
            statuses[i].count += next.statuses[i].count;
        }
    }
    iterations += next.iterations;
    maxIterationsOfStep = std::max(maxIterationsOfStep, next.maxIterationsOfStep);
    largestResidual = std::max(largestResidual, next.largestResidual);
}

Trajectory sample(const Mechanism &mechanism, std::vector<double> times, const SampledChannels &channels,
                  const SolverSettings &settings, std::stop_token stop)
{
    Trajectory trajectory;
    trajectory.time = std::move(times);
    trajectory.status.resize(trajectory.time.size());
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        trajectory.values[index].resize(channels.coordinates.test(index) ? trajectory.time.size() : 0);
    }
    for (std::size_t index = 0; index < kDerivedChannelCount; ++index) {
        trajectory.derived[index].resize(channels.derived.test(index) ? trajectory.time.size() : 0);
    }
    if (settings.method == Method::Newton) {
        sampleByNewton(mechanism, settings.newton, channels, trajectory, stop);
    } else if (!channels.onlyCoordinatesAtConstantSpeed()) {
        sampleOneByOne(trajectory, channels, stop,
                       [&](double t) { return outputStateAt(mechanism, t, channels.alpha2); });
    } else if ((channels.coordinates & ~plottedChannels()).none()) {
        samplePlotted(mechanism, trajectory, stop);
    } else {
        const ClosedForm closedForm(mechanism);
        sampleOneByOne(trajectory, channels, stop, [&](double t) { return closedForm.stateAt(t); });
    }
    SamplingSummary &summary = trajectory.summary;
    summary.timeSteps = trajectory.time.size();
    for (std::size_t i = summary.timeSteps; i-- > 0;) { // backwards, so that the first time remains
        StatusSummary &status = summary.withStatus(trajectory.status[i]);
        ++status.count;
        status.firstTime = trajectory.time[i];
        status.firstTheta2 = mechanism.theta20() + mechanism.omega2() * trajectory.time[i];
    }
    return trajectory;
}

void sampleInPieces(const Mechanism &mechanism, const Sampling &sampling, const SampledChannels &channels,
                    const SolverSettings &settings, const std::function<bool(const Trajectory &)> &take,
                    std::stop_token stop)
{
    constexpr int kMaxPiece = 1 << 15; // time stamps, of which all 36 channels take about 10 MB
    const int count = sampling.steps + 1;
    const int length = settings.method == Method::Newton ? count : std::min(count, kMaxPiece);
    for (int first = 0; first < count; first += length) {
        const int size = std::min(length, count - first);
        const Trajectory piece = sample(mechanism, sampling.timeStamps(first, size), channels, settings, stop);
        if (!piece.complete || !take(piece)) {
            return;
        }
    }
}

} // namespace slidercrank
