// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The motion sampled at many time stamps by a chosen method: one array for each channel that is asked for.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/newton/newton_options.h"

#include <array>
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

    double instant(int i) const { return start + duration * static_cast<double>(i) / static_cast<double>(steps); }
    std::vector<double> instants() const;

    friend bool operator==(const Sampling &, const Sampling &) = default;
};

/// Time steps for each turn of the crank; infinite where it stands still.
double instantsPerTurn(const Mechanism &mechanism, const Sampling &sampling);

/// With fewer steps a turn, a line through the samples looks like another motion.
inline constexpr double kFewestPerTurn = 20.0;

struct SolverSettings {
    Method method = Method::ClosedForm;
    NewtonOptions newton;

    friend bool operator==(const SolverSettings &, const SolverSettings &) = default;
};

/// How the solution of a range of time stamps went.
struct SamplingSummary {
    std::size_t instants = 0;
    std::array<std::size_t, kStatusCount> statusCounts{}; ///< time stamps by Status

    // Of Newton-Raphson, at the time stamps whose position it found; 0 for the closed form.
    long long iterations = 0;     ///< in all
    int mostIterations = 0;       ///< at one time stamp
    int mostWarmIterations = 0;   ///< at one that had a warm start: never more than the iteration limit of the options
    double largestResidual = 0.0; ///< in the measure of the options

    std::size_t count(Status status) const { return statusCounts[static_cast<std::size_t>(status)]; }

    /// Time stamps that have a position.
    std::size_t found() const { return count(Status::Solved) + count(Status::Singular); }

    friend bool operator==(const SamplingSummary &, const SamplingSummary &) = default;

    /// Adds those of the time stamps that follow.
    void add(const SamplingSummary &next);
};

struct Trajectory {
    std::vector<double> time; ///< s

    /// By indexOf(channel), in the unit of files (mm, °, s); empty where not asked for. Values that do not exist are
    /// NaN: all of them where the status is NotAssemblable, IterationLimit or NotFinite, the derivatives where
    /// Singular.
    std::array<std::vector<double>, kChannelCount> values;

    std::vector<Status> status; ///< one for each time stamp
    SamplingSummary summary;
    bool complete = true; ///< false when stopped before the end: then nothing else here is valid

    const std::vector<double> &operator[](Channel channel) const { return values[indexOf(channel)]; }
};

/// Computes the time stamps in their order (Newton-Raphson starts each from the one before), watching `stop`.
Trajectory sample(const Mechanism &mechanism, std::vector<double> instants, const ChannelSet &channels,
                  const SolverSettings &settings, std::stop_token stop = {});

/// Passes the whole motion piece by piece to take(), so that a long one in closed form is never in memory as a whole.
/// Newton-Raphson, which starts each time step from the one before, makes a single piece. Ends early when stopped, or
/// when take() returns false.
void sampleInPieces(const Mechanism &mechanism, const Sampling &sampling, const ChannelSet &channels,
                    const SolverSettings &settings, const std::function<bool(const Trajectory &)> &take,
                    std::stop_token stop = {});

} // namespace slidercrank
