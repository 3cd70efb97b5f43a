// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Samples the motion at many time stamps by a chosen method. The result has one array for each requested channel.

#include "core/limits/output_channel.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/newton/newton_options.h"

#include <array>
#include <bitset>
#include <functional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class Method { Newton, ClosedForm };

/// steps + 1 time stamps start + duration·i/steps, both ends included. The defaults are Table 2 of the reference
/// report.
struct Sampling {
    double start = 0.0;    ///< s
    double duration = 1.0; ///< s
    int steps = 200;       ///< >= 1

    double timeStamp(int i) const { return start + duration * static_cast<double>(i) / static_cast<double>(steps); }
    std::vector<double> timeStamps() const { return timeStamps(0, steps + 1); }
    std::vector<double> timeStamps(int first, int count) const; ///< `count`, from timeStamp(first) on

    friend bool operator==(const Sampling &, const Sampling &) = default;
};

/// Returns the number of time steps per revolution of the crank; infinite if the crank does not turn.
double timeStepsPerTurn(const Mechanism &mechanism, const Sampling &sampling);

/// With fewer time steps per revolution, a polyline through the samples misrepresents the motion.
inline constexpr double kMinSamplesPerTurn = 20.0;

struct SolverSettings {
    Method method = Method::ClosedForm;
    NewtonOptions newton;

    friend bool operator==(const SolverSettings &, const SolverSettings &) = default;
};

/// The time steps that have the same status.
struct StatusSummary {
    std::size_t count = 0;

    // The first of these time steps; 0 if there is none.
    double firstTime = 0.0;   ///< s
    double firstTheta2 = 0.0; ///< rad

    friend bool operator==(const StatusSummary &, const StatusSummary &) = default;
};

/// Summarizes the outcome of solving many time steps.
struct SamplingSummary {
    std::size_t timeSteps = 0;
    std::array<StatusSummary, kStatusCount> statuses{}; ///< indexed by Status

    // The iterations and residuals of the time steps whose position Newton-Raphson found; 0 for the closed form.
    long long iterations = 0;     ///< total number
    int maxIterationsOfStep = 0;  ///< largest number in one time step
    double largestResidual = 0.0; ///< as NewtonOptions::toleranceKind measures it

    StatusSummary &withStatus(Status status) { return statuses[static_cast<std::size_t>(status)]; }
    const StatusSummary &withStatus(Status status) const { return statuses[static_cast<std::size_t>(status)]; }
    std::size_t count(Status status) const { return withStatus(status).count; }

    /// Returns the number of time steps that have a position.
    std::size_t positionCount() const { return count(Status::Solved) + count(Status::Singular); }

    friend bool operator==(const SamplingSummary &, const SamplingSummary &) = default;

    /// Adds the summary of the time steps that follow.
    void add(const SamplingSummary &next);
};

/// What is sampled. Converts from a set of channels.
struct SampledChannels {
    ChannelSet coordinates;
    std::bitset<kDerivedChannelCount> derived = {}; ///< indexed by indexOf(DerivedChannel)
    double alpha2 = 0.0; ///< rad/s²: the acceleration of the crank at each time stamp, in addition to the speed ω2

    SampledChannels(const ChannelSet &channels)
        : coordinates(channels)
    {
    }
    explicit SampledChannels(const std::vector<OutputChannel> &channels, double crankAcceleration = 0.0);

    bool onlyCoordinatesAtConstantSpeed() const { return derived.none() && alpha2 == 0.0; }
};

struct Trajectory {
    std::vector<double> time; ///< s

    /// Indexed by indexOf(channel), in the units of files (mm, °, s); empty if not requested. Values that do not exist
    /// are NaN: all of them if the status is NotAssemblable, IterationLimit or NotFinite, the derivatives if it is
    /// Singular.
    std::array<std::vector<double>, kChannelCount> values;

    std::array<std::vector<double>, kDerivedChannelCount>
        derived; ///< indexed by indexOf(DerivedChannel); units and missing values as in `values`

    std::vector<Status> status; ///< one for each time stamp
    SamplingSummary summary;
    bool complete = true; ///< false if sampling was stopped: then no other member is valid

    /// Adds the time steps of `next`. Requires both to hold the same channels.
    void append(const Trajectory &next);

    const std::vector<double> &operator[](Channel channel) const { return values[indexOf(channel)]; }
    const std::vector<double> &operator[](const OutputChannel &channel) const;
};

/// Samples the motion at the time stamps `times` (s), in their order: Newton-Raphson starts each from the previous one.
/// Ends early if `stop` is requested.
Trajectory sample(const Mechanism &mechanism, std::vector<double> times, const SampledChannels &channels,
                  const SolverSettings &settings, std::stop_token stop = {});

/// Samples the motion in pieces and passes each to take(), so that a long motion in closed form is never in memory as a
/// whole. Newton-Raphson, which starts each time step from the previous one, makes a single piece. Ends early if `stop`
/// is requested or take() returns false.
void sampleInPieces(const Mechanism &mechanism, const Sampling &sampling, const SampledChannels &channels,
                    const SolverSettings &settings, const std::function<bool(const Trajectory &)> &take,
                    std::stop_token stop = {});

} // namespace slidercrank
