// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include "core/study/measurement.h"
#include "core/study/study_methods.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns the smallest difference that the clock shows. In a browser it may be a millisecond.
double clockStep()
{
    constexpr int kTrials = 10; // another program may run during some of them
    Clock::duration smallest = Clock::duration::max();
    for (int trial = 0; trial < kTrials; ++trial) {
        const Clock::time_point start = Clock::now();
        Clock::time_point now = start;
        while (now == start) {
            now = Clock::now();
        }
        smallest = std::min(smallest, now - start);
    }
    return std::chrono::duration<double>(smallest).count();
}

/// Returns a measurement, not yet begun, of every method at the time stamps of the case.
Measurement methodMeasurement(const Case &studied)
{
    Measurement measurement(studied.parameters, timeStampsOf(studied));
    for (const StudyMethod &method : studyMethods()) {
        measurement.add(method, method.needsEqualSteps ? studied.sampling.timeStamps() : measurement.timeStamps());
    }
    return measurement;
}

/// Returns a measurement, not yet begun, of every method: with every step size if its cost or error depends on it.
Measurement workPrecisionMeasurement(Case studied)
{
    constexpr int kLargestMultiple = 32; // of the number of time steps
    studied.sampling.steps = kWorkPrecisionSteps;
    Measurement measurement(studied.parameters, studied.sampling.timeStamps());
    for (const StudyMethod &method : studyMethods()) {
        // Multiples are powers of two, so that the compared time stamps are the same doubles with each of them.
        const int largestMultiple = method.dependsOnStep ? kLargestMultiple : 1;
        for (int multiple = 1; multiple <= largestMultiple; multiple *= 2) {
            studied.sampling.steps = multiple * kWorkPrecisionSteps;
            measurement.add(method, studied.sampling.timeStamps());
        }
    }
    return measurement;
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Combines the rows of one method and tolerance, of which there is at least one.
MethodResult combineRows(const std::vector<const MethodResult *> &rows)
{
    MethodResult sum;
    sum.method = rows.front()->method;
    sum.tolerance = rows.front()->tolerance;
    sum.channels = rows.front()->channels;
    std::vector<double> times;
    std::vector<double> spreads;
    std::vector<double> iterations;
    for (const MethodResult *row : rows) {
        sum.stateCount += row->stateCount;
        times.push_back(row->nanosecondsPerState);
        spreads.push_back(row->spread);
        if (row->iterationsPerState) {
            iterations.push_back(*row->iterationsPerState);
        }
        if (row->maxError) {
            sum.maxError = std::max(sum.maxError.value_or(0.0), *row->maxError);
            sum.silentFailures = sum.silentFailures.value_or(0) + row->silentFailures.value_or(0);
        }
        std::ranges::transform(sum.counts, row->counts, sum.counts.begin(), std::plus());
    }
    sum.status = worstStatus(sum.counts);
    sum.nanosecondsPerState = medianOf(std::move(times));
    sum.spread = medianOf(std::move(spreads));
    if (!iterations.empty()) {
        sum.iterationsPerState = medianOf(std::move(iterations));
    }
    return sum;
}

} // namespace

std::vector<MethodResult> resultsOverAllCases(const StudyResult &study)
{
    std::vector<MethodResult> results;
    for (const StudyMethod &method : studyMethods()) {
        std::vector<const MethodResult *> rows;
        for (const CaseResult &each : study.cases) {
            for (const MethodResult &row : each.methods) {
                if (row.method == method.name && row.tolerance == method.tolerance) {
                    rows.push_back(&row);
                }
            }
        }
        if (!rows.empty()) {
            results.push_back(combineRows(rows));
        }
    }
    return results;
}

struct Study::State {
    /// A measurement that the study will make.
    struct Plan {
        enum class Kind {
            AllMethods,   ///< every method at the time stamps of the case
            WorkPrecision ///< the error of every method against its cost
        };
        const Case *studied;
        Kind kind;
    };

    StudyRequest request;
    std::vector<Plan> plans{};
    std::size_t completed = 0;                ///< number of plans that are done
    std::optional<Measurement> measurement{}; ///< carries out the next plan; nullopt before it begins
    std::vector<CaseResult> cases{};
    Clock::time_point start = Clock::now();

    void begin()
    {
        const auto &[studied, kind] = plans[completed];
        measurement = kind == Plan::Kind::AllMethods ? methodMeasurement(*studied) : workPrecisionMeasurement(*studied);
    }

    void end()
    {
        const auto &[studied, kind] = plans[completed];
        if (kind == Plan::Kind::AllMethods) {
            cases.push_back(
                {studied->name, studied->parameters, measurement->timeStamps().size(), measurement->results(), {}});
        } else {
            cases.back().workPrecision = measurement->results();
        }
        measurement.reset();
        ++completed;
    }
};

Study::Study(const StudyRequest &request)
    : m_state(std::make_unique<State>(State{request}))
{
    constexpr double kMinClockSteps = 3.0; // shortest duration of a round, in steps of the clock
    State &state = *m_state;
    state.request.secondsPerRound = std::max(request.secondsPerRound, kMinClockSteps * clockStep());
    for (const Case &studied : state.request.cases) {
        const bool isFirst = state.plans.empty(); // whose work and precision are also studied (StudyRequest::cases)
        state.plans.push_back({&studied, State::Plan::Kind::AllMethods});
        if (isFirst) {
            state.plans.push_back({&studied, State::Plan::Kind::WorkPrecision});
        }
    }
}

Study::~Study() = default;

bool Study::advance()
{
    State &state = *m_state;
    if (state.completed == state.plans.size()) {
        return false;
    }
    if (!state.measurement) {
        state.begin();
    } else if (!state.measurement->advance(state.request)) {
        state.end();
    }
    return true;
}

double Study::progress() const
{
    const State &state = *m_state;
    const double progressOfNext = state.measurement ? state.measurement->progress(state.request) : 0.0;
    const auto planCount = static_cast<double>(state.plans.size());
    return state.plans.empty() ? 1.0 : (static_cast<double>(state.completed) + progressOfNext) / planCount;
}

StudyResult Study::result() const
{
    const State &state = *m_state;
    StudyResult result{state.cases, secondsSince(state.start)};
    result.complete = state.completed == state.plans.size();
    if (!result.complete && state.plans[state.completed].kind == State::Plan::Kind::WorkPrecision) {
        result.cases.pop_back(); // the errors of its methods are known, but not yet those against the cost
    }
    return result;
}

StudyResult runStudy(const StudyRequest &request, std::stop_token stop, const std::function<void(double)> &progress)
{
    Study study(request);
    while (!stop.stop_requested() && study.advance()) {
        if (progress) {
            progress(study.progress());
        }
    }
    return study.result();
}

Case studyCase(const Parameters &parameters)
{
    const bool isInitial = parameters == Parameters();
    Case result{isInitial ? "initial mechanism" : "this mechanism", parameters};
    if (parameters.omega2 != 0.0) {
        result.sampling.duration = 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    }
    return result;
}

} // namespace slidercrank
