// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/measurement.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr double kJudgeShare = 0.6; // approximate share of the exact motion in the duration of a measurement

/// Sets the sizes of the channels from the exact motion.
void measureSizes(const Parameters &parameters, JudgedMotion &motion)
{
    for (const auto &[time, judged] : motion.exact) {
        for (std::size_t k = 0; k < kChannels && judged.status == Status::Solved; ++k) {
            motion.sizes[k] = std::max(motion.sizes[k], std::abs(judged.values[k].hi));
        }
    }
    for (std::size_t k = 0; k < kChannels; ++k) {
        const double natural = naturalSize(parameters, kPlottedChannels[k]);
        const double size = motion.sizes[k] > kExactZero * natural ? motion.sizes[k] : natural;
        motion.sizes[k] = std::max(size, std::numeric_limits<double>::min()); // the crank may not turn
    }
}

/// Returns |got - exact|, or infinity if `got` is not finite.
double deviation(double got, TwoPart exact)
{
    return std::isfinite(got) ? std::abs((got - exact.hi) - exact.lo) : kInfinity;
}

/// Sets the errors and statuses of the result from the answers at the times of the motion.
void compareAnswers(const Contender &contender, const JudgedMotion &motion, MethodResult &result)
{
    double worst = 0.0;
    double bound = 0.0;
    std::size_t silent = 0;
    for (std::size_t i = 0; i < contender.timeStamps.size(); ++i) {
        const auto exact = motion.exact.find(contender.timeStamps[i]);
        if (exact == motion.exact.end()) {
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
            const double error = deviation(contender.answers.values[k][i], judged.values[k]) / motion.sizes[k];
            worst = std::max(worst, error);
            bound = std::max(bound, judged.kappa[k] * kUnitRoundoff / motion.sizes[k]);
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

double secondsOf(Contender &contender, long long repeats)
{
    const auto start = std::chrono::steady_clock::now();
    for (long long repeat = 0; repeat < repeats; ++repeat) {
        contender.run(contender.answers);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
    const double states = static_cast<double>(contender.repeats) * static_cast<double>(contender.timeStamps.size());
    contender.nanoseconds.push_back(1e9 * secondsOf(contender, contender.repeats) / states);
}

MethodResult resultOf(Contender &contender, const JudgedMotion &motion)
{
    const StudyMethod &method = *contender.method;
    MethodResult result;
    result.method = method.name;
    result.tolerance = method.tolerance;
    result.channels = method.channels;
    result.states = contender.timeStamps.size();
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
    compareAnswers(contender, motion, result);
    return result;
}

} // namespace

Measurement::Measurement(const Parameters &parameters, std::vector<double> timeStamps)
    : m_parameters(parameters)
    , m_timeStamps(std::move(timeStamps))
{
}

void Measurement::add(const StudyMethod &method, const std::vector<double> &timeStamps)
{
    Contender contender{&method, timeStamps};
    contender.run = method.prepare(Mechanism(m_parameters), contender.timeStamps);
    contender.answers.values.fill(std::vector<double>(timeStamps.size()));
    contender.answers.status.resize(timeStamps.size());
    if (contender.run) {
        m_contenders.push_back(std::move(contender));
    }
}

bool Measurement::advance(const StudyRequest &request)
{
    if (m_judged < m_timeStamps.size()) {
        const double time = m_timeStamps[m_judged++];
        m_motion.exact.emplace(time, judge(m_parameters, time));
    } else if (m_prepared < m_contenders.size()) {
        prepareRounds(m_contenders[m_prepared++], request.secondsPerRound);
    } else if (m_timed < roundCount(request)) {
        timeRound(m_contenders[m_timed++ % m_contenders.size()]);
    } else {
        return false;
    }
    return true;
}

double Measurement::progress(const StudyRequest &request) const
{
    const auto part = [](std::size_t done, std::size_t all) {
        return all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
    };
    return kJudgeShare * part(m_judged, m_timeStamps.size()) + (1.0 - kJudgeShare) * part(m_timed, roundCount(request));
}

std::vector<MethodResult> Measurement::results()
{
    measureSizes(m_parameters, m_motion);
    std::vector<MethodResult> rows;
    for (Contender &contender : m_contenders) {
        rows.push_back(resultOf(contender, m_motion));
    }
    return rows;
}

std::size_t Measurement::roundCount(const StudyRequest &request) const
{
    return static_cast<std::size_t>(request.rounds) * m_contenders.size();
}

Status worstStatus(const std::array<std::size_t, kStatusCount> &counts)
{
    for (const Status status : {Status::NotFinite, Status::IterationLimit, Status::Singular, Status::NotAssemblable}) {
        if (counts[static_cast<std::size_t>(status)] > 0) {
            return status;
        }
    }
    return Status::Solved;
}

} // namespace slidercrank
