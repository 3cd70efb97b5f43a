// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Speed against error: each method of the program, and what a student would do instead, timed at the same time stamps
// and judged against the exact motion in at least 50 digits (100 beside a toggle). The one place in the core that reads
// a clock.
//
// Errors are the largest of the six plotted channels, relative to the peak of the channel, over the time stamps that
// the method itself calls solved. The bound beside them is κ·u, in the same measure and over the same instants:
//
//     κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t        u = 2⁻⁵³
//
// an error that even a perfect method makes when what it is given has been rounded to doubles. What takes its numbers
// as exact, as the closed form does, may do better.

#include "core/mechanism/mechanism.h"
#include "core/study/cases.h"

#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

struct StudyRequest {
    std::vector<Case> cases;

    /// Each round times every method once, so that whatever else the machine does meanwhile meets all of them.
    int rounds = 15;

    /// How long a method is repeated in one round: well above what the clock can tell apart.
    double secondsPerRound = 150e-6;
};

/// The tolerance of the reference report; the rows of newton-dense with it are its own calculation.
inline constexpr double kReportsTolerance = 1e-8;

struct MethodName {
    enum class Kind {
        NewtonDense, ///< the report's
        NewtonDenseTaylor,
        NewtonStructured,
        NewtonStructuredTaylor,
        ClosedForm,
        ClosedFormBatch,
        FiniteDifference,
        Harmonics
    };
    Kind kind = Kind::NewtonDense;
    int harmonics = 0; ///< how many, where they are

    friend bool operator==(const MethodName &, const MethodName &) = default;
};

/// What files and the command line call it: newton-dense, closed-form-batch, harmonic-4, …
std::string nameOf(const MethodName &method);

/// A row of the study. Compare times only between rows with the same number of channels.
struct MethodResult {
    MethodName method;
    std::optional<double> tolerance; ///< of Newton-Raphson
    int channels = 6;                ///< how many are computed: 36 or 6

    double nsPerState = 0.0; ///< median over the rounds
    double spread = 0.0;     ///< between the quartiles, ns

    // Of Newton-Raphson. An iteration is one linear system solved for the position; velocity and acceleration are two
    // more linear systems with one matrix.
    std::optional<double> iterationsPerState;
    std::optional<double> linearSolvesPerState;

    std::optional<double> maxError;   ///< none where no instant is solved
    std::optional<double> errorBound; ///< κ·u; none where no instant is solved, or it knows no bound

    std::array<std::size_t, kStatusCount> counts{}; ///< of instants, by Status
    Status status = Status::Solved;                 ///< the worst of them

    /// Time stamps called solved that are not: a channel is off by more than kSilentPart of its peak, as it is on the
    /// wrong branch or beyond the reach of an approximation, or no position exists. None where nothing is called
    /// solved.
    std::optional<std::size_t> silentFailures;
};

inline constexpr double kSilentPart = 0.01;

/// (|h| - b)/b up to which a position at a limit is a matter of the last digits.
inline constexpr double kLimitRounding = 1e-14;

/// Error against cost: what it takes to get the same kOutputs + 1 states of the six plotted channels, at equal time
/// steps over the sampled duration, with a tolerance and a step size.
struct WorkPrecision {
    static constexpr int kOutputs = 25; ///< the steps are multiples of it

    MethodName method;
    std::optional<double> tolerance;
    int steps = kOutputs;
    double microseconds = 0.0; ///< median over the rounds, of the whole calculation
    double spread = 0.0;       ///< between the quartiles, µs
    std::optional<double> linearSolves;
    std::optional<double> maxError; ///< as in MethodResult
};

struct CaseResult {
    std::string name;
    Parameters parameters;
    std::size_t instants = 0;
    std::vector<MethodResult> methods;
    std::vector<WorkPrecision> workPrecision; ///< of the first case only
};

/// What the times belong to.
struct Machine {
    std::string processor; ///< "x86-64"; empty: a family without a name here
    unsigned threads = 0;
    std::string compiler; ///< "GCC 12"; empty: another
    bool isOptimized = true;
};

struct StudyResult {
    Machine machine;
    std::vector<CaseResult> cases;
    double seconds = 0.0; ///< that the study took
    bool complete = true; ///< false when stopped: then the cases are those that were done
};

/// `progress` is called from the calling thread with 0 … 1, ascending, 1 last unless stopped.
StudyResult runStudy(const StudyRequest &request, std::stop_token stop = {},
                     const std::function<void(double)> &progress = {});

/// A turn of this mechanism in 200 steps; a second where the crank stands still.
Case studyCase(const Parameters &parameters);

/// The rows of a case for which no other row with the same number of channels is both faster and at least as accurate:
/// first those with all channels, then those with six; each by ascending time and decreasing error.
std::vector<std::size_t> bestFront(const CaseResult &result);

} // namespace slidercrank
