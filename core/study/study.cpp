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

/// Receives the completed fraction of a piece of work.
using Progress = std::function<void(double)>;

constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr double kJudgeShare = 0.6; // of the exact motion in the duration of a case, approximately

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Judgement {
    std::map<double, Judged> exact{};      ///< by time
    std::array<double, kChannels> sizes{}; ///< rad, mm: the peak, or naturalSize() where that is 0; positive
};

/// Computes the exact motion at the times, or fewer if stopped.
Judgement judgeAll(const Parameters &parameters, const std::vector<double> &times, const std::stop_token &stop,
                   const Progress &reach)
{
    Judgement judgement;
    for (std::size_t i = 0; i < times.size() && !stop.stop_requested(); ++i) {
        const Judged judged = judge(parameters, times[i]);
        for (std::size_t k = 0; k < kChannels && judged.status == Status::Solved; ++k) {
            judgement.sizes[k] = std::max(judgement.sizes[k], std::abs(judged.values[k].hi));
        }
        judgement.exact.emplace(times[i], judged);
        reach(kJudgeShare * static_cast<double>(i + 1) / static_cast<double>(times.size()));
    }
    for (std::size_t k = 0; k < kChannels; ++k) {
        const double natural = naturalSize(parameters, kPlottedChannels[k]);
        const double size = judgement.sizes[k] > kExactZero * natural ? judgement.sizes[k] : natural;
        judgement.sizes[k] = std::max(size, std::numeric_limits<double>::min()); // the crank may not turn
    }
    return judgement;
}

/// A method applied to a case.
struct Contender {
    const StudyMethod *method = nullptr;
    std::vector<double> times{};
    StudyRun run{};
    StudyAnswers answers{};
    long long repeats = 1;
    std::vector<double> nanoseconds{}; ///< per state, one value for each round
};

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
void compareAnswers(const Contender &contender, const Judgement &judgement, MethodResult &result)
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

/// Runs each method once to obtain the answers and to warm up, then in rounds. Returns false if stopped.
bool timeAll(std::vector<Contender> &contenders, const StudyRequest &request, const std::stop_token &stop,
             const Progress &reach)
{
    for (Contender &contender : contenders) {
        contender.run(contender.answers);
        const Clock::time_point start = Clock::now();
        contender.run(contender.answers);
        const double once = std::max(secondsSince(start), 1e-8);
        contender.repeats = std::max(1LL, static_cast<long long>(request.secondsPerRound / once));
        if (stop.stop_requested()) {
            return false;
        }
    }
    for (int round = 0; round < request.rounds; ++round) {
        for (Contender &contender : contenders) {
            const Clock::time_point start = Clock::now();
            for (long long repeat = 0; repeat < contender.repeats; ++repeat) {
                contender.run(contender.answers);
            }
            const double states = static_cast<double>(contender.repeats) * static_cast<double>(contender.times.size());
            contender.nanoseconds.push_back(1e9 * secondsSince(start) / states);
        }
        if (stop.stop_requested()) {
            return false;
        }
        reach(kJudgeShare + (1.0 - kJudgeShare) * (round + 1) / request.rounds);
    }
    return true;
}

MethodResult resultOf(Contender &contender, const Judgement &judgement)
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

/// Times the contenders, and compares their answers with the exact motion at the times `judged`. Returns no rows if
/// stopped.
std::vector<MethodResult> measure(std::vector<Contender> contenders, const Parameters &parameters,
                                  const std::vector<double> &judged, const StudyRequest &request,
                                  const std::stop_token &stop, const Progress &reach)
{
    const Judgement judgement = judgeAll(parameters, judged, stop, reach);
    const bool isTimed = timeAll(contenders, request, stop, reach);
    std::vector<MethodResult> rows;
    for (std::size_t i = 0; i < contenders.size() && isTimed; ++i) {
        rows.push_back(resultOf(contenders[i], judgement));
    }
    return rows;
}

/// Measures every method, with every step size if its cost or error depends on it. Returns no rows if stopped.
std::vector<MethodResult> measureWorkPrecision(Case which, const StudyRequest &request, const std::stop_token &stop,
                                               const Progress &reach)
{
    which.sampling.steps = kWorkPrecisionOutputs;
    const std::vector<double> outputs = which.sampling.timeStamps();
    std::vector<Contender> contenders;
    for (const StudyMethod &method : studyMethods()) {
        // A power of two, so that the time stamps of the outputs are the same doubles.
        for (int multiple = 1; multiple <= (method.dependsOnStep ? 32 : 1); multiple *= 2) {
            which.sampling.steps = multiple * kWorkPrecisionOutputs;
            addContender(method, Mechanism(which.parameters), which.sampling.timeStamps(), contenders);
        }
    }
    return measure(std::move(contenders), which.parameters, outputs, request, stop, reach);
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

StudyResult runStudy(const StudyRequest &request, std::stop_token stop, const std::function<void(double)> &progress)
{
    const Clock::time_point start = Clock::now();
    StudyResult result;
    double done = 0.0; // cases; the error against the cost counts as one, too
    const auto reach = [&](double ofNext) {
        if (progress) {
            progress((done + ofNext) / (static_cast<double>(request.cases.size()) + 1.0));
        }
    };
    for (const Case &which : request.cases) {
        const std::vector<double> times = timeStampsOf(which);
        std::vector<Contender> contenders;
        for (const StudyMethod &method : studyMethods()) {
            addContender(method, Mechanism(which.parameters),
                         method.needsEqualSteps ? which.sampling.timeStamps() : times, contenders);
        }
        CaseResult caseResult{which.name, which.parameters, times.size(), {}, {}};
        caseResult.methods = measure(std::move(contenders), which.parameters, times, request, stop, reach);
        ++done;
        if (result.cases.empty() && !stop.stop_requested()) {
            caseResult.workPrecision = measureWorkPrecision(which, request, stop, reach);
            ++done;
        }
        if (stop.stop_requested()) {
            result.complete = false;
            break;
        }
        result.cases.push_back(std::move(caseResult));
    }
    result.seconds = secondsSince(start);
    if (result.complete && progress) {
        progress(1.0);
    }
    return result;
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
