// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include "core/mechanism/two_part_angle.h"
#include "core/study/exact_motion.h"
#include "core/study/study_methods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
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

/// The exact motion at one instant. Values by kPlottedChannels, in two parts, so that they need no many-digit numbers
/// to be compared with.
struct Judged {
    Status status = Status::Solved;
    double clearance = 0.0; ///< (b - |h|)/b
    std::array<TwoPart, kChannels> values;
    std::array<TwoPart, kChannels> valuesInDegrees;
    std::array<double, kChannels> kappa{}; ///< rad, mm
};

struct Judgement {
    std::vector<Judged> instants;
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
    static const Real kDegrees = 180 / boost::math::constants::pi<Real>();
    Judged judged;
    judged.status = exact.status;
    judged.clearance = static_cast<double>(exact.clearance);
    for (std::size_t k = 0; k < kChannels; ++k) {
        const std::size_t index = indexOf(kPlottedChannels[k]);
        const Real &value = exact.values[index];
        judged.values[k] = inTwoParts(value);
        judged.valuesInDegrees[k] =
            isAngle(kPlottedChannels[k].coordinate) ? inTwoParts(Real(value * kDegrees)) : judged.values[k];
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

/// 0/0 is no error: a channel of a crank that stands still.
double relative(double error, double size)
{
    return error == 0.0 ? 0.0 : error / size;
}

/// A method at work on a case.
struct Contender {
    const StudyMethod *method = nullptr;
    StudyRun run;
    std::vector<std::size_t> instants; ///< which of the case's
    StudyAnswers answers;
    long long repeats = 1;
    std::vector<double> nanoseconds; ///< per state, a value a round
};

double lag(double got, TwoPart exact)
{
    return std::isfinite(got) ? std::abs((got - exact.hi) - exact.lo) : kInfinity;
}

/// How much worse one status is than another: what cannot be assembled is the mechanism's, the others are the method's.
int severity(Status status)
{
    switch (status) {
    case Status::Solved: return 0;
    case Status::NotAssemblable: return 1;
    case Status::Singular: return 2;
    case Status::IterationLimit: return 3;
    case Status::NotFinite: return 4;
    }
    return 0;
}

/// Errors and statuses of the answers.
void compareAnswers(const Contender &contender, const Judgement &judgement, MethodResult &result)
{
    const StudyMethod &method = *contender.method;
    double worst = 0.0;
    double bound = 0.0;
    std::size_t silent = 0;
    for (std::size_t i = 0; i < contender.instants.size(); ++i) {
        const Status status = contender.answers.status[i];
        ++result.counts[static_cast<std::size_t>(status)];
        if (severity(status) > severity(result.status)) {
            result.status = status;
        }
        if (status != Status::Solved) {
            continue;
        }
        const Judged &judged = judgement.instants[contender.instants[i]];
        if (judged.status != Status::Solved) {
            silent += judged.clearance < -kLimitRounding ? 1 : 0;
            continue;
        }
        bool isWrong = false;
        for (std::size_t k = 0; k < kChannels; ++k) {
            const bool degrees = method.givesDegrees && isAngle(kPlottedChannels[k].coordinate);
            const double unit = degrees ? kDegreesPerRadian : 1.0;
            const double got = contender.answers.values[k][i];
            const double error =
                relative(lag(got, degrees ? judged.valuesInDegrees[k] : judged.values[k]), unit * judgement.sizes[k]);
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
    }
    if (method.isExact) {
        result.silentFailures = silent;
    }
}

/// Of sorted values, between neighbours where need be.
double quantile(const std::vector<double> &sorted, double part)
{
    const double position = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

std::vector<Contender> contendersOf(const Case &which, const std::vector<double> &all, const std::vector<double> &steps)
{
    std::vector<std::size_t> everyIndex(all.size());
    std::iota(everyIndex.begin(), everyIndex.end(), std::size_t{0});
    std::vector<std::size_t> stepIndices;
    for (const double t : steps) {
        stepIndices.push_back(static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), t) - all.begin()));
    }
    std::vector<Contender> contenders;
    for (const StudyMethod &method : studyMethods()) {
        const bool everywhere = method.instants == StudyMethod::Instants::All;
        StudyRun run = method.prepare(which, everywhere ? all : steps);
        if (!run) {
            continue;
        }
        Contender contender;
        contender.method = &method;
        contender.run = std::move(run);
        contender.instants = everywhere ? everyIndex : stepIndices;
        for (std::vector<double> &values : contender.answers.values) {
            values.resize(contender.instants.size());
        }
        contender.answers.status.resize(contender.instants.size());
        contenders.push_back(std::move(contender));
    }
    return contenders;
}

/// Of a case, the judge takes about so much of the time.
constexpr double kJudgeShare = 0.6;

/// The exact motion at all instants; empty when stopped.
template <class Reach>
std::optional<Judgement> judgeAll(const Case &which, const std::vector<double> &instants, const std::stop_token &stop,
                                  const Reach &reach)
{
    Judgement judgement;
    judgement.instants.reserve(instants.size());
    for (const double t : instants) {
        if (stop.stop_requested()) {
            return std::nullopt;
        }
        judgement.instants.push_back(judge(which.parameters, t));
        reach(static_cast<double>(judgement.instants.size()) / static_cast<double>(instants.size()));
    }
    judgement.sizes = sizesOf(which.parameters, judgement.instants);
    return judgement;
}

/// Once to warm up and for the answers, then in rounds. False when stopped.
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
                static_cast<double>(contender.repeats) * static_cast<double>(contender.instants.size());
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
        result.iterationsPerState =
            static_cast<double>(contender.answers.iterations) / static_cast<double>(contender.instants.size());
    }
    compareAnswers(contender, judgement, result);
    return result;
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
        const std::vector<double> all = instantsOf(which);
        const std::vector<double> steps = which.sampling.instants();
        const std::optional<Judgement> judgement =
            judgeAll(which, all, stop, [&](double part) { reach(kJudgeShare * part); });
        std::vector<Contender> contenders = contendersOf(which, all, steps);
        const bool timed = judgement && timeAll(contenders, request, stop,
                                                [&](double part) { reach(kJudgeShare + (1.0 - kJudgeShare) * part); });
        if (!timed) {
            result.complete = false;
            break;
        }
        CaseResult of;
        of.traits = which.traits;
        of.parameters = which.parameters;
        of.instants = all.size();
        for (Contender &contender : contenders) {
            of.methods.push_back(resultOf(contender, *judgement));
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
    Case result{{{isTable1 ? CaseTrait::Kind::ReportTable : CaseTrait::Kind::ThisMechanism}}, parameters};
    if (parameters.omega2 != 0.0) {
        result.sampling.duration = 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    }
    return result;
}

std::vector<std::size_t> bestFront(const CaseResult &result)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < result.methods.size(); ++i) {
        if (result.methods[i].maxError) {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return result.methods[i].nsPerState; });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || *result.methods[i].maxError < *result.methods[front.back()].maxError) {
            front.push_back(i);
        }
    }
    return front;
}

} // namespace slidercrank
