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
constexpr double kExactMotionShare = 0.6; // approximate share of the exact motion in the duration of a measurement

/// Sets the sizes from the largest exact values.
void measureSizes(const Parameters &parameters, ExactMotion &motion)
{
    for (const auto &[time, exact] : motion.values) {
        for (std::size_t k = 0; k < kChannels && exact.status == Status::Solved; ++k) {
            motion.sizes[k] = std::max(motion.sizes[k], std::abs(exact.values[k].hi));
        }
    }
    for (std::size_t k = 0; k < kChannels; ++k) {
        const double natural = naturalSize(parameters, kPlottedChannels[k]);
        const double size = motion.sizes[k] > kExactZero * natural ? motion.sizes[k] : natural;
        motion.sizes[k] = std::max(size, std::numeric_limits<double>::min()); // the crank may not turn
    }
}

/// Returns |value - exact|, or infinity if the value is not finite.
double deviation(double value, TwoPart exact)
{
    return std::isfinite(value) ? std::abs((value - exact.hi) - exact.lo) : kInfinity;
}

/// Compares the values of a method with the exact ones, at the time stamps whose exact motion is known, and sets the
/// errors and statuses of `result`.
void compareWithExact(const TimedMethod &timed, const ExactMotion &motion, MethodResult &result)
{
    double maxError = 0.0;
    double maxBound = 0.0;
    std::size_t silentFailures = 0;
    for (std::size_t i = 0; i < timed.timeStamps.size(); ++i) {
        const auto found = motion.values.find(timed.timeStamps[i]);
        if (found == motion.values.end()) {
            continue;
        }
        const Status status = timed.output.statuses[i];
        ++result.counts[static_cast<std::size_t>(status)];
        if (status != Status::Solved) {
            continue;
        }
        const ExactValues &exact = found->second;
        if (exact.status != Status::Solved) {
            silentFailures += exact.clearance < -kLimitRounding ? 1 : 0;
            continue;
        }
        bool isWrong = false;
        for (std::size_t k = 0; k < kChannels; ++k) {
            const double error = deviation(timed.output.values[k][i], exact.values[k]) / motion.sizes[k];
            maxError = std::max(maxError, error);
            maxBound = std::max(maxBound, exact.kappa[k] * kUnitRoundoff / motion.sizes[k]);
            isWrong = isWrong || error > kSilentFraction;
        }
        silentFailures += isWrong ? 1 : 0;
    }
    result.status = worstStatus(result.counts);
    if (result.counts[static_cast<std::size_t>(Status::Solved)] > 0) {
        result.maxError = maxError;
        result.errorBound = std::isfinite(maxBound) ? std::optional(maxBound) : std::nullopt;
        result.silentFailures = silentFailures;
    }
}

double secondsOf(TimedMethod &timed, long long repeats)
{
    const auto start = std::chrono::steady_clock::now();
    for (long long repeat = 0; repeat < repeats; ++repeat) {
        timed.run(timed.output);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Runs the method to obtain its output and to warm up, and sets how often it is repeated in a round of `seconds`. The
/// clock may be too coarse for a single run.
void prepareRounds(TimedMethod &timed, double seconds)
{
    timed.run(timed.output);
    double taken = secondsOf(timed, timed.repeats);
    while (taken < 0.5 * seconds) {
        timed.repeats *= 2;
        taken = secondsOf(timed, timed.repeats);
    }
    if (taken > 0.0) {
        timed.repeats = std::max(1LL, std::llround(static_cast<double>(timed.repeats) * seconds / taken));
    }
}

void timeRound(TimedMethod &timed)
{
    const double states = static_cast<double>(timed.repeats) * static_cast<double>(timed.timeStamps.size());
    timed.nanoseconds.push_back(1e9 * secondsOf(timed, timed.repeats) / states);
}

MethodResult resultOf(TimedMethod &timed, const ExactMotion &motion)
{
    const StudyMethod &method = *timed.method;
    MethodResult result;
    result.method = method.name;
    result.tolerance = method.tolerance;
    result.channels = method.channels;
    result.stateCount = timed.timeStamps.size();
    if (std::vector<double> &times = timed.nanoseconds; !times.empty()) {
        std::ranges::sort(times);
        result.nanosecondsPerState = times[times.size() / 2];
        result.spread = times[3 * times.size() / 4] - times[times.size() / 4];
    }
    if (method.tolerance) {
        const auto states = static_cast<double>(result.stateCount);
        const auto iterations = static_cast<double>(timed.output.iterations);
        const auto solved = std::ranges::count(timed.output.statuses, Status::Solved);
        result.iterationsPerState = iterations / states;
        result.linearSolvesPerState = (iterations + 2.0 * static_cast<double>(solved)) / states;
    }
    compareWithExact(timed, motion, result);
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
    TimedMethod timed{.method = &method, .timeStamps = timeStamps};
    timed.run = method.prepare(Mechanism(m_parameters), timed.timeStamps);
    timed.output.values.fill(std::vector<double>(timeStamps.size()));
    timed.output.statuses.resize(timeStamps.size());
    if (timed.run) {
        m_methods.push_back(std::move(timed));
    }
}

bool Measurement::advance(const StudyRequest &request)
{
    if (m_exactCount < m_timeStamps.size()) {
        const double time = m_timeStamps[m_exactCount++];
        m_motion.values.emplace(time, exactValues(m_parameters, time));
    } else if (m_preparedCount < m_methods.size()) {
        prepareRounds(m_methods[m_preparedCount++], request.secondsPerRound);
    } else if (m_timedRounds < roundCount(request)) {
        timeRound(m_methods[m_timedRounds++ % m_methods.size()]);
    } else {
        return false;
    }
    return true;
}

double Measurement::progress(const StudyRequest &request) const
{
    const auto fraction = [](std::size_t done, std::size_t all) {
        return all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
    };
    return kExactMotionShare * fraction(m_exactCount, m_timeStamps.size()) +
           (1.0 - kExactMotionShare) * fraction(m_timedRounds, roundCount(request));
}

std::vector<MethodResult> Measurement::results()
{
    measureSizes(m_parameters, m_motion);
    std::vector<MethodResult> rows;
    for (TimedMethod &timed : m_methods) {
        rows.push_back(resultOf(timed, m_motion));
    }
    return rows;
}

std::size_t Measurement::roundCount(const StudyRequest &request) const
{
    return static_cast<std::size_t>(request.rounds) * m_methods.size();
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
