// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A run of instants, computed by a chosen method: only the channels that somebody asked for, one array a channel.

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

/// steps + 1 instants start + duration·i/steps, both ends included. The defaults are Table 2 of the report.
struct Sampling {
    double start = 0.0;    ///< s
    double duration = 1.0; ///< s
    int steps = 200;       ///< >= 1

    double instant(int i) const { return start + duration * static_cast<double>(i) / static_cast<double>(steps); }
    std::vector<double> instants() const;

    friend bool operator==(const Sampling &, const Sampling &) = default;
};

/// How many instants there are to a turn of the crank; infinite where it stands still.
double instantsPerTurn(const Mechanism &mechanism, const Sampling &sampling);

/// With fewer to a turn, a line through them is another motion.
inline constexpr double kFewestPerTurn = 20.0;

struct SolverSettings {
    Method method = Method::Newton;
    NewtonOptions newton;

    friend bool operator==(const SolverSettings &, const SolverSettings &) = default;
};

struct Trajectory {
    std::vector<double> time; ///< s

    /// By indexOf(channel), in the unit of the author's files (mm, °, s); empty where not asked for. What does not
    /// exist is NaN: everything where the status is NotAssemblable, IterationLimit or NotFinite, derivatives where
    /// Singular.
    std::array<std::vector<double>, kChannelCount> values;

    std::vector<Status> status; ///< one an instant

    // Of Newton-Raphson, at the instants whose position it found; 0 for the closed form.
    long long iterations = 0;     ///< in all
    int mostIterations = 0;       ///< at one instant
    int mostFromBefore = 0;       ///< at one that started from the instant before: never above the options' most
    double largestResidual = 0.0; ///< in the measure of the options

    bool complete = true; ///< false when stopped before the end: then the arrays are not to be used

    const std::vector<double> &operator[](Channel channel) const { return values[indexOf(channel)]; }

    /// How many instants ended with that status.
    std::size_t count(Status wanted) const;
};

/// How a run went, without its instants.
struct RunSummary {
    std::size_t instants = 0;
    std::array<std::size_t, kStatusCount> endedWith{}; ///< how many instants, by Status

    // Of Newton-Raphson, as in Trajectory.
    long long iterations = 0;
    int mostIterations = 0;
    int mostFromBefore = 0;
    double largestResidual = 0.0;

    std::size_t count(Status status) const { return endedWith[static_cast<std::size_t>(status)]; }

    /// Instants that have a position.
    std::size_t found() const { return count(Status::Solved) + count(Status::Singular); }

    /// The next piece of the run.
    void add(const Trajectory &piece);
};

/// Computes the instants in their order (Newton-Raphson starts each from the one before), watching `stop`.
Trajectory sample(const Mechanism &mechanism, std::vector<double> instants, const ChannelSet &channels,
                  const SolverSettings &settings, std::stop_token stop = {});

/// The whole run, piece after piece in their order, for who passes it on and does not keep it: a long one in closed
/// form is never in memory as a whole; Newton-Raphson, which starts each instant from the one before, comes in one
/// piece. Ends when stopped, or when take() returns false.
void sampleInPieces(const Mechanism &mechanism, const Sampling &sampling, const ChannelSet &channels,
                    const SolverSettings &settings, const std::function<bool(const Trajectory &)> &take,
                    std::stop_token stop = {});

} // namespace slidercrank
