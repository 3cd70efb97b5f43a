// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include "core/mechanism/two_part_angle.h"
#include "core/study/exact_motion.h"
#include "core/study/study_methods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <thread>

namespace slidercrank
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kChannels = kPlottedChannels.size();

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The exact motion at one time stamp. The values, by kPlottedChannels, are in two parts, so that comparing with them
/// takes no many-digit arithmetic.
struct Judged {
    Status status = Status::Solved;
    double clearance = 0.0; ///< (b - |h|)/b
    std::array<TwoPart, kChannels> values;
    std::array<double, kChannels> kappa{}; ///< rad, mm
};

struct Judgement {
    std::vector<Judged> timeStamps;
    std::array<double, kChannels> sizes{}; ///< rad, mm: the peak, or naturalSize() where that is 0
};

template <class Real>
TwoPart inTwoParts(const Real &value)
{
    const auto hi = static_cast<double>(value);
    return {hi, static_cast<double>(Real(value - hi))};
}

template <class Real>
Judged judgedFrom(const Parameters &parameters, double t, const ExactState<Real> &exact)
{
    Judged judged;
    judged.status = exact.status;
    judged.clearance = static_cast<double>(exact.clearance);
    for (std::size_t k = 0; k < kChannels; ++k) {
        const std::size_t index = indexOf(kPlottedChannels[k]);
        judged.values[k] = inTwoParts(exact.values[index]);
    }
    if (exact.status == Status::Solved) {
        const std::array<double, kChannelCount> kappa = conditioning<Real>(parameters, t);
        for (std::size_t k = 0; k < kChannels; ++k) {
            judged.kappa[k] = kappa[indexOf(kPlottedChannels[k])];
        }
    }
    return judged;
}

Judged judge(const Parameters &parameters, double t)
{
    // The formulas cancel as the clearance falls, to its third power; the difference quotient in κ takes 25 digits.
    constexpr double kEnoughClearance = 1e-4;
    const ExactState<Digits50> exact = exactState<Digits50>(parameters, t);
    return exact.clearance > kEnoughClearance ? judgedFrom(parameters, t, exact)
                                              : judgedFrom(parameters, t, exactState<Digits100>(parameters, t));
}

std::array<double, kChannels> sizesOf(const Parameters &parameters, const std::vector<Judged> &run)
{
    std::array<double, kChannels> sizes{};
    for (const Judged &judged : run) {
        for (std::size_t k = 0; k < kChannels && judged.status == Status::Solved; ++k) {
            sizes[k] = std::max(sizes[k], std::abs(judged.values[k].hi));
        }
    }
    for (std::size_t k = 0; k < kChannels; ++k) {
        const double natural = naturalSize(parameters, kPlottedChannels[k]);
        if (sizes[k] <= kExactZero * natural) {
            sizes[k] = natural;
        }
    }
    return sizes;
}

/// Returns error / size, and 0 for 0/0, which occurs if the crank does not turn.
double relative(double error, double size)
{
    return error == 0.0 ? 0.0 : error / size;
}

/// A method applied to a case.
struct Contender {
    const StudyMethod *method = nullptr;
    StudyRun run{};
    std::vector<std::size_t> timeStamps{}; ///< indices of the judged time stamps in those of the case
    std::size_t stride = 1;                ///< every stride-th answer is judged
    StudyAnswers answers{};
    long long repeats = 1;
    std::vector<double> nanoseconds{}; ///< per state, one value for each round
};

/// Returns |got - exact|, or infinity if `got` is not finite.
double deviation(double got, TwoPart exact)
{
    const long double value = got;
    const auto error =
        static_cast<double>((value - static_cast<long double>(exact.hi)) - static_cast<long double>(exact.lo));
    return std::isfinite(got) ? std::abs(error) : kInfinity;
}

/// Orders statuses by severity. NotAssemblable is a property of the mechanism, the others are failures of the method.
int severity(Status status)
{
    constexpr std::array<int, kStatusCount> kByStatus{0, 2, 3, 1, 4};
    return kByStatus[static_cast<std::size_t>(status)];
}

/// Sets the errors and statuses of the result.
void compareAnswers(const Contender &contender, const Judgement &judgement, MethodResult &result)
{
    double worst = 0.0;
    double bound = 0.0;
    std::size_t silent = 0;
    for (std::size_t i = 0; i < contender.timeStamps.size(); ++i) {
        const std::size_t answer = i * contender.stride;
        const Status status = contender.answers.status[answer];
        ++result.counts[static_cast<std::size_t>(status)];
        if (severity(status) > severity(result.status)) {
            result.status = status;
        }
        if (status != Status::Solved) {
            continue;
        }
        const Judged &judged = judgement.timeStamps[contender.timeStamps[i]];
        if (judged.status != Status::Solved) {
            silent += judged.clearance < -kLimitRounding ? 1 : 0;
            continue;
        }
        bool isWrong = false;
        for (std::size_t k = 0; k < kChannels; ++k) {
            const double error =
                relative(deviation(contender.answers.values[k][answer], judged.values[k]), judgement.sizes[k]);
            const double limit = relative(judged.kappa[k] * kUnitRoundoff, judgement.sizes[k]);
            worst = std::max(worst, error);
            bound = std::max(bound, limit);
            isWrong = isWrong || error > kSilentPart;
        }
        silent += isWrong ? 1 : 0;
    }
    if (result.counts[static_cast<std::size_t>(Status::Solved)] > 0) {
        result.maxError = worst;
        result.errorBound = std::isfinite(bound) ? std::optional(bound) : std::nullopt;
        result.silentFailures = silent;
    }
}

/// Returns a quantile of sorted values, interpolated between neighbours.
double quantile(const std::vector<double> &sorted, double part)
{
    const double position = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

/// Adds a method to be run at `times`, unless it does not apply to the mechanism. Every stride-th time is judged;
/// `judged` holds the indices of the corresponding exact motions.
void addContender(const StudyMethod &method, const Case &which, const std::vector<double> &times,
                  const std::vector<std::size_t> &judged, std::size_t stride, std::vector<Contender> &contenders)
{
    if (StudyRun run = method.prepare(which, times)) {
        Contender &contender = contenders.emplace_back(Contender{&method, std::move(run), judged, stride});
        contender.answers.values.fill(std::vector<double>(times.size()));
        contender.answers.status.resize(times.size());
    }
}

std::vector<Contender> makeContenders(const Case &which, const std::vector<double> &all,
                                      const std::vector<double> &steps)
{
    std::vector<std::size_t> everyIndex(all.size());
    std::iota(everyIndex.begin(), everyIndex.end(), std::size_t{0});
    std::vector<std::size_t> stepIndices;
    for (const double t : steps) {
        stepIndices.push_back(static_cast<std::size_t>(std::ranges::lower_bound(all, t) - all.begin()));
    }
    std::vector<Contender> contenders;
    for (const StudyMethod &method : studyMethods()) {
        const bool isEverywhere = method.timeStamps == StudyMethod::TimeStamps::All;
        addContender(method, which, isEverywhere ? all : steps, isEverywhere ? everyIndex : stepIndices, 1, contenders);
    }
    return contenders;
}

/// The approximate share of the exact motion in the time of a case.
constexpr double kJudgeShare = 0.6;

/// Computes the exact motion at all time stamps. Returns nullopt if stopped.
template <class Reach>
std::optional<Judgement> judgeAll(const Case &which, const std::vector<double> &timeStamps, const std::stop_token &stop,
                                  const Reach &reach)
{
    Judgement judgement;
    judgement.timeStamps.reserve(timeStamps.size());
    for (const double t : timeStamps) {
        if (stop.stop_requested()) {
            return std::nullopt;
        }
        judgement.timeStamps.push_back(judge(which.parameters, t));
        reach(static_cast<double>(judgement.timeStamps.size()) / static_cast<double>(timeStamps.size()));
    }
    judgement.sizes = sizesOf(which.parameters, judgement.timeStamps);
    return judgement;
}

/// Runs each method once to obtain the answers and to warm up, then in rounds. Returns false if stopped.
template <class Reach>
bool timeAll(std::vector<Contender> &contenders, const StudyRequest &request, const std::stop_token &stop,
             const Reach &reach)
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
            const double states =
                static_cast<double>(contender.repeats) * static_cast<double>(contender.answers.status.size());
            contender.nanoseconds.push_back(1e9 * secondsSince(start) / states);
        }
        if (stop.stop_requested()) {
            return false;
        }
        reach(static_cast<double>(round + 1) / request.rounds);
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
    std::sort(contender.nanoseconds.begin(), contender.nanoseconds.end());
    if (!contender.nanoseconds.empty()) {
        result.nsPerState = quantile(contender.nanoseconds, 0.5);
        result.spread = quantile(contender.nanoseconds, 0.75) - quantile(contender.nanoseconds, 0.25);
    }
    if (method.tolerance) {
        const auto states = static_cast<double>(contender.answers.status.size());
        const auto iterations = static_cast<double>(contender.answers.iterations);
        const auto solved = std::ranges::count(contender.answers.status, Status::Solved);
        result.iterationsPerState = iterations / states;
        result.linearSolvesPerState = (iterations + 2.0 * static_cast<double>(solved)) / states;
    }
    compareAnswers(contender, judgement, result);
    return result;
}

/// Measures every method, with every step size if its cost or error depends on it. Returns no rows if stopped.
std::vector<WorkPrecision> measureWorkPrecision(const Case &which, const StudyRequest &request,
                                                const std::stop_token &stop)
{
    constexpr std::array kMultiples{1, 2, 4, 8, 16, 32};
    constexpr int kOutputs = WorkPrecision::kOutputs;
    std::vector<std::size_t> outputs(kOutputs + 1);
    std::iota(outputs.begin(), outputs.end(), std::size_t{0});
    std::vector<Case> cases(kMultiples.size(), which);
    std::vector<std::vector<double>> times;
    for (std::size_t i = 0; i < kMultiples.size(); ++i) {
        cases[i].sampling.steps = kMultiples[i] * kOutputs;
        times.push_back(cases[i].sampling.timeStamps());
    }
    const auto ignoreProgress = [](double) {};
    const std::optional<Judgement> judgement = judgeAll(which, times.front(), stop, ignoreProgress);
    std::vector<Contender> contenders;
    for (const StudyMethod &method : studyMethods()) {
        for (std::size_t i = 0; i < (method.dependsOnStep ? kMultiples.size() : 1); ++i) {
            const auto stride = static_cast<std::size_t>(kMultiples[i]);
            addContender(method, cases[i], times[i], outputs, stride, contenders);
        }
    }
    std::vector<WorkPrecision> rows;
    if (!judgement || !timeAll(contenders, request, stop, ignoreProgress)) {
        return rows;
    }
    for (Contender &contender : contenders) {
        const auto states = static_cast<double>(contender.answers.status.size());
        const MethodResult result = resultOf(contender, *judgement);
        const auto solves = result.linearSolvesPerState;
        rows.push_back({result.method, result.tolerance, static_cast<int>(states) - 1,
                        1e-3 * states * result.nsPerState, 1e-3 * states * result.spread,
                        solves ? std::optional(states * *solves) : std::nullopt, result.maxError});
    }
    return rows;
}

Machine thisMachine()
{
    Machine machine;
#if defined(__x86_64__) || defined(_M_X64)
    machine.processor = "x86-64";
#elif defined(__aarch64__) || defined(_M_ARM64)
    machine.processor = "arm64";
#endif
    machine.threads = std::thread::hardware_concurrency();
#if defined(__clang__)
    machine.compiler = "Clang " + std::to_string(__clang_major__);
#elif defined(__GNUC__)
    machine.compiler = "GCC " + std::to_string(__GNUC__);
#elif defined(_MSC_VER)
    machine.compiler = "MSVC " + std::to_string(_MSC_VER);
#endif
#ifndef NDEBUG
    machine.isOptimized = false;
#endif
    return machine;
}

} // namespace

StudyResult runStudy(const StudyRequest &request, std::stop_token stop, const std::function<void(double)> &progress)
{
    const Clock::time_point start = Clock::now();
    StudyResult result;
    result.machine = thisMachine();
    const auto reach = [&](double ofNext) {
        if (progress) {
            const double done = static_cast<double>(result.cases.size()) + ofNext;
            progress(std::min(1.0, done / static_cast<double>(request.cases.size())));
        }
    };
    for (const Case &which : request.cases) {
        const std::vector<double> all = timeStampsOf(which);
        const std::vector<double> steps = which.sampling.timeStamps();
        const std::optional<Judgement> judgement =
            judgeAll(which, all, stop, [&](double part) { reach(kJudgeShare * part); });
        std::vector<Contender> contenders = makeContenders(which, all, steps);
        const bool timed = judgement && timeAll(contenders, request, stop,
                                                [&](double part) { reach(kJudgeShare + (1.0 - kJudgeShare) * part); });
        if (!timed) {
            result.complete = false;
            break;
        }
        CaseResult of{which.name, which.parameters, all.size(), {}, {}};
        for (Contender &contender : contenders) {
            of.methods.push_back(resultOf(contender, *judgement));
        }
        if (result.cases.empty()) {
            of.workPrecision = measureWorkPrecision(which, request, stop);
            if (stop.stop_requested()) {
                result.complete = false;
                break;
            }
        }
        result.cases.push_back(std::move(of));
    }
    result.seconds = secondsSince(start);
    if (result.complete && progress) {
        progress(1.0);
    }
    return result;
}

Case studyCase(const Parameters &parameters)
{
    const bool isTable1 = parameters == Parameters();
    Case result{isTable1 ? "Table 1 of the reference report" : "this mechanism", parameters};
    if (parameters.omega2 != 0.0) {
        result.sampling.duration = 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    }
    return result;
}

std::vector<std::size_t> bestFront(const CaseResult &result)
{
    const std::vector<MethodResult> &rows = result.methods;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].maxError) {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i) { return std::pair(-rows[i].channels, rows[i].nsPerState); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        const bool isFirst = front.empty() || rows[front.back()].channels != rows[i].channels;
        if (isFirst || *rows[i].maxError < *rows[front.back()].maxError) {
            front.push_back(i);
        }
    }
    return front;
}

} // namespace slidercrank
