// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/trajectory.h"

#include "core/closed_form/batch.h"
#include "core/closed_form/state_at.h"
#include "core/mechanism/in_parallel.h"
#include "core/mechanism/turn.h"
#include "core/newton/newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// Instants between two looks at the stop token.
constexpr std::size_t kInstantsPerLook = 256;

/// Where the computed instants go: one pointer per wanted channel, with the factor to the author's unit.
class Columns
{
public:
    Columns(Trajectory &trajectory, const ChannelSet &channels)
    {
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            if (channels.test(index)) {
                trajectory.values[index].resize(trajectory.time.size());
                m_columns[m_count++] = {channelAt(index), trajectory.values[index].data()};
            }
        }
    }

    void put(std::size_t i, const State &state) const
    {
        for (std::size_t k = 0; k < m_count; ++k) {
            const Channel channel = m_columns[k].channel;
            const Vector12 *derivatives[] = {&state.q, &state.qDot, &state.qDDot};
            const double value = (*derivatives[static_cast<std::size_t>(channel.order)])[channel.coordinate];
            m_columns[k].values[i] = toFileUnit(channel, value);
        }
    }

private:
    struct Column {
        Channel channel;
        double *values = nullptr;
    };
    std::array<Column, kChannelCount> m_columns;
    std::size_t m_count = 0;
};

void sampleByNewton(const Mechanism &mechanism, const NewtonOptions &options, const Columns &columns,
                    Trajectory &trajectory, const std::stop_token &stop)
{
    NewtonInstant last;
    for (std::size_t i = 0; i < trajectory.time.size(); ++i) {
        if (i % kInstantsPerLook == 0 && stop.stop_requested()) {
            trajectory.complete = false;
            return;
        }
        advance(mechanism, trajectory.time[i], last, options);
        if (last.positionStatus == Status::Solved) {
            trajectory.iterations += last.iterations;
            trajectory.mostIterations = std::max(trajectory.mostIterations, last.iterations);
            if (!last.startedAfar) {
                trajectory.mostFromBefore = std::max(trajectory.mostFromBefore, last.iterations);
            }
            trajectory.largestResidual = std::max(trajectory.largestResidual, last.residual);
        }
        trajectory.status[i] = last.state.status;
        columns.put(i, last.state);
    }
}

void sampleInClosedForm(const Mechanism &mechanism, const Columns &columns, Trajectory &trajectory,
                        const std::stop_token &stop)
{
    const ClosedForm closedForm(mechanism);
    for (std::size_t i = 0; i < trajectory.time.size(); ++i) {
        if (i % kInstantsPerLook == 0 && stop.stop_requested()) {
            trajectory.complete = false;
            return;
        }
        const State state = closedForm.stateAt(trajectory.time[i]);
        trajectory.status[i] = state.status;
        columns.put(i, state);
    }
}

/// The shorter way when no channel but the six plotted ones is asked for.
void samplePlotted(const Mechanism &mechanism, Trajectory &trajectory, const std::stop_token &stop)
{
    const auto column = [&trajectory](Channel channel) {
        std::vector<double> &values = trajectory.values[indexOf(channel)];
        return values.empty() ? nullptr : values.data();
    };
    const PlottedColumns columns{column({Theta3, Order::Position}),     column({R4x, Order::Position}),
                                 column({Theta3, Order::Velocity}),     column({R4x, Order::Velocity}),
                                 column({Theta3, Order::Acceleration}), column({R4x, Order::Acceleration})};
    const ClosedFormBatch batch(mechanism);
    const std::span<const double> instants(trajectory.time);
    const std::span<Status> statuses(trajectory.status);
    const auto evaluate = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && !stop.stop_requested(); i += kInstantsPerLook) {
            const std::size_t count = std::min(kInstantsPerLook, end - i);
            batch.evaluate(instants.subspan(i, count), columns.behind(i), statuses.subspan(i, count));
        }
    };
    constexpr std::size_t kPiece = 1U << 15U; // instants: worth a thread
    const std::size_t pieces = (instants.size() + kPiece - 1) / kPiece;
    inParallel(pieces, [&](std::size_t i) { evaluate(i * kPiece, std::min((i + 1) * kPiece, instants.size())); });
    trajectory.complete = !stop.stop_requested();
}

} // namespace

std::vector<double> Sampling::instants() const
{
    std::vector<double> instants(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i) {
        instants[static_cast<std::size_t>(i)] = instant(i);
    }
    return instants;
}

double instantsPerTurn(const Mechanism &mechanism, const Sampling &sampling)
{
    return kTurn * sampling.steps / std::abs(mechanism.omega2() * sampling.duration);
}

std::size_t Trajectory::count(Status wanted) const
{
    return static_cast<std::size_t>(std::count(status.begin(), status.end(), wanted));
}

void RunSummary::add(const Trajectory &piece)
{
    instants += piece.status.size();
    for (const Status status : piece.status) {
        ++endedWith[static_cast<std::size_t>(status)];
    }
    iterations += piece.iterations;
    mostIterations = std::max(mostIterations, piece.mostIterations);
    mostFromBefore = std::max(mostFromBefore, piece.mostFromBefore);
    largestResidual = std::max(largestResidual, piece.largestResidual);
}

Trajectory sample(const Mechanism &mechanism, std::vector<double> instants, const ChannelSet &channels,
                  const SolverSettings &settings, std::stop_token stop)
{
    Trajectory trajectory;
    trajectory.time = std::move(instants);
    trajectory.status.resize(trajectory.time.size());
    const Columns columns(trajectory, channels);
    switch (settings.method) {
    case Method::Newton: sampleByNewton(mechanism, settings.newton, columns, trajectory, stop); break;
    case Method::ClosedForm: {
        const bool plottedOnly = (channels & ~plottedChannels()).none();
        if (plottedOnly) {
            samplePlotted(mechanism, trajectory, stop);
        } else {
            sampleInClosedForm(mechanism, columns, trajectory, stop);
        }
        break;
    }
    }
    return trajectory;
}

void sampleInPieces(const Mechanism &mechanism, const Sampling &sampling, const ChannelSet &channels,
                    const SolverSettings &settings, const std::function<bool(const Trajectory &)> &take,
                    std::stop_token stop)
{
    constexpr int kPiece = 1 << 15; // all 36 channels in some 10 MB
    const int count = sampling.steps + 1;
    const int length = settings.method == Method::Newton ? count : std::min(count, kPiece);
    for (int first = 0; first < count; first += length) {
        std::vector<double> instants;
        instants.reserve(static_cast<std::size_t>(length));
        for (int i = first; i < std::min(first + length, count); ++i) {
            instants.push_back(sampling.instant(i));
        }
        const Trajectory piece = sample(mechanism, std::move(instants), channels, settings, stop);
        if (!piece.complete || !take(piece)) {
            return;
        }
    }
}

} // namespace slidercrank
