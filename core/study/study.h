// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Measures speed against error: each method of the program, and the methods that a student would use instead, are timed
// at the same time stamps and compared with the exact motion in 115 digits. No other module of the core reads a clock.
//
// The error of a method is the largest error of the six plotted channels, relative to the peak of the channel, over the
// time stamps that the method itself reports as solved. The error bound is κ·u, relative to the same peaks and over the
// same time stamps:
//
//     κ = Σ |p ∂f/∂p| over a, b, c, ω2, θ20, t        u = 2⁻⁵³
//
// It is the error of a perfect method whose input has been rounded to doubles. A method that takes its input as exact,
// as the closed form does, may be more accurate.

#include "core/mechanism/mechanism.h"
#include "core/study/cases.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

struct StudyRequest {
    std::vector<Case> cases; ///< of the first one, the error is also measured for several step sizes

    /// Each round times every method once, so that a load on the machine affects all methods.
    int rounds = 15;

    /// The time for which a method is repeated in one round, well above the resolution of the clock.
    double secondsPerRound = 150e-6;
};

/// The tolerance of the reference report; newton-dense with this tolerance repeats the calculation of the report.
inline constexpr double kReferenceReportTolerance = 1e-8;

struct MethodName {
    enum class Kind {
        NewtonDense, ///< as in the reference report
        NewtonDenseTaylor,
        NewtonStructured,
        NewtonStructuredTaylor,
        ClosedForm,
        ClosedFormBatch,
        FiniteDifference,
        Harmonics
    };
    Kind kind = Kind::NewtonDense;
    int harmonics = 0; ///< their number, for Harmonics

    friend bool operator==(const MethodName &, const MethodName &) = default;
};

/// Returns the name of a method in files and on the command line: newton-dense, closed-form-batch, harmonic-4, …
std::string nameOf(const MethodName &method);

/// A row of the study. Compare times only between rows with the same number of channels.
struct MethodResult {
    MethodName method{};
    std::optional<double> tolerance{}; ///< of Newton-Raphson
    int channels = 6;                  ///< number of channels computed: 36 or 6
    std::size_t stateCount = 0;        ///< number of computed time stamps

    double nanosecondsPerState = 0.0; ///< median over the rounds
    double spread = 0.0;              ///< between the quartiles, ns

    // Of Newton-Raphson. An iteration is one linear system solved for the position; velocity and acceleration are two
    // more linear systems with one matrix.
    std::optional<double> iterationsPerState;
    std::optional<double> linearSolvesPerState;

    std::optional<double> maxError;   ///< nullopt if no time stamp is solved
    std::optional<double> errorBound; ///< κ·u; nullopt if no time stamp is solved, or if κ is infinite

    std::array<std::size_t, kStatusCount> counts{}; ///< number of time stamps, indexed by Status
    Status status = Status::Solved;                 ///< by worstStatus()

    /// The number of time stamps that are wrong although they are reported as solved: a channel deviates by more than
    /// kSilentFraction of its peak, as on the wrong branch or with too coarse an approximation, or the mechanism cannot
    /// be assembled. nullopt if no time stamp is reported as solved.
    std::optional<std::size_t> silentFailures;
};

inline constexpr double kSilentFraction = 0.01;

/// If (|h| - b)/b with h = c - a sin θ2 is at most this, rounding decides whether a position exists: a method that
/// reports a position is not counted as wrong.
inline constexpr double kLimitRounding = 1e-14;

/// The number of equal time steps between the first and the last state that CaseResult::workPrecision compares.
inline constexpr int kWorkPrecisionSteps = 25;

struct CaseResult {
    std::string name;
    Parameters parameters;
    std::size_t timeStampCount = 0;
    std::vector<MethodResult> methods;

    /// The rows of a chart of error against cost: one for each tolerance and step size, of the first case only. The
    /// errors are those of kWorkPrecisionSteps + 1 states at equal time steps over the sampled duration. The cost is
    /// that of all states that the method computes to reach them (MethodResult::stateCount).
    std::vector<MethodResult> workPrecision = {};
};

struct StudyResult {
    std::vector<CaseResult> cases;
    double seconds = 0.0; ///< duration of the study
    bool complete = true; ///< false if stopped: `cases` then contains those completed
};

/// A study in pieces of a few milliseconds, for a program that cannot wait for all of it.
class Study
{
public:
    explicit Study(const StudyRequest &request);
    ~Study();

    bool advance();             ///< does the next piece of work; returns false if everything is done
    double progress() const;    ///< the fraction that is done, 0 … 1; it never decreases
    StudyResult result() const; ///< the results of the completed cases

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Runs the study. Calls `progress` in the calling thread with ascending values from 0 to 1; the last is 1 unless
/// stopped.
StudyResult runStudy(const StudyRequest &request, std::stop_token stop = {},
                     const std::function<void(double)> &progress = {});

/// Returns a row for each method and tolerance with its results over all cases: the sums of the counts, the largest
/// error, and the medians of the times, their spreads and the iterations. A method that does not apply to a case has no
/// row there. There are no error bounds, because those of different mechanisms cannot be compared.
std::vector<MethodResult> resultsOverAllCases(const StudyResult &study);

/// Returns the case of one revolution of this mechanism in 200 steps, or of one second if the crank does not turn.
Case studyCase(const Parameters &parameters);

} // namespace slidercrank
