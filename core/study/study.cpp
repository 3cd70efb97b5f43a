// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include "core/study/judge.h"
#include "core/study/study_methods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

namespace slidercrank
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr double kJudgeShare = 0.6; // of the exact motion in the duration of a case, approximately

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

// Not in an anonymous namespace, because Study contains them.

struct StudyJudgement {
    std::map<double, Judged> exact{};      ///< by time
    std::array<double, kChannels> sizes{}; ///< rad, mm: the peak, or naturalSize() where that is 0; positive
};

namespace
{

/// Sets the sizes of the channels from the exact motion.
void measureSizes(const Parameters &parameters, StudyJudgement &judgement)
{
    for (const auto &[time, judged] : judgement.exact) {
        for (std::size_t k = 0; k < kChannels && judged.status == Status::Solved; ++k) {
            judgement.sizes[k] = std::max(judgement.sizes[k], std::abs(judged.values[k].hi));
        }
    }
    for (std::size_t k = 0; k < kChannels; ++k) {
        const double natural = naturalSize(parameters, kPlottedChannels[k]);
        const double size = judgement.sizes[k] > kExactZero * natural ? judgement.sizes[k] : natural;
        judgement.sizes[k] = std::max(size, std::numeric_limits<double>::min()); // the crank may not turn
    }
}

} // namespace

/// A method applied to a case.
struct Contender {
    const StudyMethod *method = nullptr;
    std::vector<double> times{};
    StudyRun run{};
    StudyAnswers answers{};
    long long repeats = 1;
    std::vector<double> nanoseconds{}; ///< per state, one value for each round
};

namespace
{

/// Returns |got - exact|, or infinity if `got` is not finite.
double deviation(double got, TwoPart exact)
{
    return std::isfinite(got) ? std::abs((got - exact.hi) - exact.lo) : kInfinity;
}

/// Returns the worst status among those that occur. NotAssemblable is a property of the mechanism, the others are
/// failures of the method.
Status worstStatus(const std::array<std::size_t, kStatusCount> &counts)
{
    for (const Status status : {Status::NotFinite, Status::IterationLimit, Status::Singular, Status::NotAssemblable}) {
        if (counts[static_cast<std::size_t>(status)] > 0) {
            return status;
        }
    }
    return Status::Solved;
}

/// Sets the errors and statuses of the result from the answers at the times of the judgement.
void compareAnswers(const Contender &contender, const StudyJudgement &judgement, MethodResult &result)
{
    double worst = 0.0;
    double bound = 0.0;
    std::size_t silent = 0;
    for (std::size_t i = 0; i < contender.times.size(); ++i) {
        const auto exact = judgement.exact.find(contender.times[i]);
        if (exact == judgement.exact.end()) {
            continue;
        }
        const Status status = contender.answers.status[i];
        ++result.counts[static_cast<std::size_t>(status)];
        if (status != Status::Solved) {
            continue;
        }
        const Judged &judged = exact->second;
        if (judged.status != Status::Solved) {
            silent += judged.clearance < -kLimitRounding ? 1 : 0;
            continue;
        }
        bool isWrong = false;
        for (std::size_t k = 0; k < kChannels; ++k) {
            const double error = deviation(contender.answers.values[k][i], judged.values[k]) / judgement.sizes[k];
            worst = std::max(worst, error);
            bound = std::max(bound, judged.kappa[k] * kUnitRoundoff / judgement.sizes[k]);
            isWrong = isWrong || error > kSilentFraction;
        }
        silent += isWrong ? 1 : 0;
    }
    result.status = worstStatus(result.counts);
    if (result.counts[static_cast<std::size_t>(Status::Solved)] > 0) {
        result.maxError = worst;
        result.errorBound = std::isfinite(bound) ? std::optional(bound) : std::nullopt;
        result.silentFailures = silent;
    }
}

/// Adds a method to be run at `times`, unless it does not apply to the mechanism.
void addContender(const StudyMethod &method, const Mechanism &mechanism, const std::vector<double> &times,
                  std::vector<Contender> &contenders)
{
    Contender contender{&method, times};
    contender.run = method.prepare(mechanism, contender.times);
    contender.answers.values.fill(std::vector<double>(times.size()));
    contender.answers.status.resize(times.size());
    if (contender.run) {
        contenders.push_back(std::move(contender));
    }
}

double secondsOf(Contender &contender, long long repeats)
{
    const Clock::time_point start = Clock::now();
    for (long long repeat = 0; repeat < repeats; ++repeat) {
        contender.run(contender.answers);
    }
    return secondsSince(start);
}

/// Runs the method to obtain the answers and to warm up, and sets how often it is repeated in a round of `seconds`. The
/// clock may be too coarse for a single run.
void prepareRounds(Contender &contender, double seconds)
{
    contender.run(contender.answers);
    double taken = secondsOf(contender, contender.repeats);
    while (taken < 0.5 * seconds) {
        contender.repeats *= 2;
        taken = secondsOf(contender, contender.repeats);
    }
    if (taken > 0.0) {
        contender.repeats = std::max(1LL, std::llround(static_cast<double>(contender.repeats) * seconds / taken));
    }
}

void timeRound(Contender &contender)
{
    const double states = static_cast<double>(contender.repeats) * static_cast<double>(contender.times.size());
    contender.nanoseconds.push_back(1e9 * secondsOf(contender, contender.repeats) / states);
}

/// Returns the smallest difference that the clock shows. In a browser it may be a millisecond.
double clockStep()
{
    const Clock::time_point start = Clock::now();
    Clock::time_point now = start;
    while (now == start) {
        now = Clock::now();
    }
    return std::chrono::duration<double>(now - start).count();
}

MethodResult resultOf(Contender &contender, const StudyJudgement &judgement)
{
    const StudyMethod &method = *contender.method;
    MethodResult result;
    result.method = method.name;
    result.tolerance = method.tolerance;
    result.channels = method.channels;
    result.states = contender.times.size();
    if (std::vector<double> &times = contender.nanoseconds; !times.empty()) {
        std::ranges::sort(times);
        result.nsPerState = times[times.size() / 2];
        result.spread = times[3 * times.size() / 4] - times[times.size() / 4];
    }
    if (method.tolerance) {
        const auto states = static_cast<double>(result.states);
        const auto iterations = static_cast<double>(contender.answers.iterations);
        const auto solved = std::ranges::count(contender.answers.status, Status::Solved);
        result.iterationsPerState = iterations / states;
        result.linearSolvesPerState = (iterations + 2.0 * static_cast<double>(solved)) / states;
    }
    compareAnswers(contender, judgement, result);
    return result;
}

} // namespace

/// Compares the answers of the contenders with the exact motion at the times `judged`, and times them, in small pieces.
struct Measurement {
    Parameters parameters;
    std::vector<double> judged;
    std::vector<Contender> contenders{};
    StudyJudgement judgement{};
    std::size_t judgedCount = 0;
    std::size_t preparedCount = 0;
    std::size_t timedCount = 0; ///< over all rounds

    /// Does the next piece. Returns false if everything is done.
    bool advance(int rounds, double secondsPerRound)
    {
        if (judgedCount < judged.size()) {
            const double time = judged[judgedCount++];
            judgement.exact.emplace(time, judge(parameters, time));
        } else if (preparedCount < contenders.size()) {
            prepareRounds(contenders[preparedCount++], secondsPerRound);
        } else if (timedCount < static_cast<std::size_t>(rounds) * contenders.size()) {
            timeRound(contenders[timedCount++ % contenders.size()]);
        } else {
            return false;
        }
        return true;
    }

    /// The part that is done, 0 … 1.
    double progress(int rounds) const
    {
        const auto part = [](std::size_t done, std::size_t all) {
            return all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
        };
        return kJudgeShare * part(judgedCount, judged.size()) +
               (1.0 - kJudgeShare) * part(timedCount, static_cast<std::size_t>(rounds) * contenders.size());
    }

    std::vector<MethodResult> results()
    {
        measureSizes(parameters, judgement);
        std::vector<MethodResult> rows;
        for (Contender &contender : contenders) {
            rows.push_back(resultOf(contender, judgement));
        }
        return rows;
    }
};

namespace
{

/// Measures every method at the time stamps of the case.
Measurement measurementOf(const Case &which)
{
    Measurement measurement{which.parameters, timeStampsOf(which)};
    for (const StudyMethod &method : studyMethods()) {
        addContender(method, Mechanism(which.parameters),
                     method.needsEqualSteps ? which.sampling.timeStamps() : measurement.judged, measurement.contenders);
    }
    return measurement;
}

/// Measures every method, with every step size if its cost or error depends on it.
Measurement workPrecisionOf(Case which)
{
    which.sampling.steps = kWorkPrecisionOutputs;
    Measurement measurement{which.parameters, which.sampling.timeStamps()};
    for (const StudyMethod &method : studyMethods()) {
        // A power of two, so that the time stamps of the outputs are the same doubles.
        for (int multiple = 1; multiple <= (method.dependsOnStep ? 32 : 1); multiple *= 2) {
            which.sampling.steps = multiple * kWorkPrecisionOutputs;
            addContender(method, Mechanism(which.parameters), which.sampling.timeStamps(), measurement.contenders);
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
MethodResult combined(const std::vector<const MethodResult *> &rows)
{
    MethodResult sum;
    sum.method = rows.front()->method;
    sum.tolerance = rows.front()->tolerance;
    sum.channels = rows.front()->channels;
    std::vector<double> times;
    std::vector<double> spreads;
    std::vector<double> iterations;
    for (const MethodResult *row : rows) {
        sum.states += row->states;
        times.push_back(row->nsPerState);
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
    sum.nsPerState = medianOf(std::move(times));
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
            results.push_back(combined(rows));
        }
    }
    return results;
}

struct Study::State {
    StudyRequest request;
    Clock::time_point start = Clock::now();
    std::optional<Measurement> measurement{}; ///< that is being done
    std::size_t begun = 0;                    ///< number of measurements
    std::vector<CaseResult> cases{};

    /// The error against the cost of the first case is the second measurement.
    std::size_t measurementCount() const { return request.cases.size() + (request.cases.empty() ? 0 : 1); }
    bool isWorkPrecision() const { return begun == 2; }

    void begin()
    {
        ++begun;
        const Case &which = request.cases[begun == 1 ? 0 : begun - 2];
        measurement = isWorkPrecision() ? workPrecisionOf(which) : measurementOf(which);
        if (!isWorkPrecision()) {
            cases.push_back({which.name, which.parameters, measurement->judged.size(), {}, {}});
        }
    }

    void end()
    {
        (isWorkPrecision() ? cases.back().workPrecision : cases.back().methods) = measurement->results();
        measurement.reset();
    }
};

Study::Study(const StudyRequest &request)
    : m_state(std::make_unique<State>(State{request}))
{
    constexpr double kLeastSteps = 3.0; // of the clock in a round
    m_state->request.secondsPerRound = std::max(request.secondsPerRound, kLeastSteps * clockStep());
}

Study::~Study() = default;

bool Study::advance()
{
    State &state = *m_state;
    if (!state.measurement) {
        if (state.begun == state.measurementCount()) {
            return false;
        }
        state.begin();
    } else if (!state.measurement->advance(state.request.rounds, state.request.secondsPerRound)) {
        state.end();
    }
    return true;
}

double Study::progress() const
{
    const State &state = *m_state;
    const double done = static_cast<double>(state.begun - (state.measurement ? 1 : 0)) +
                        (state.measurement ? state.measurement->progress(state.request.rounds) : 0.0);
    return state.measurementCount() == 0 ? 1.0 : done / static_cast<double>(state.measurementCount());
}

StudyResult Study::result() const
{
    StudyResult result{m_state->cases, secondsSince(m_state->start)};
    result.complete = m_state->begun == m_state->measurementCount() && !m_state->measurement;
    if (m_state->measurement || m_state->begun == 1) { // the last case is not completed
        result.cases.pop_back();
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
