// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the methods of kinematics side by side. Compare the ratios of the column per_state, which hardly depend on
// the machine. Interleave the repetitions: --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
// --benchmark_report_aggregates_only=true

#include "core/closed_form/closed_form.h"
#include "core/closed_form/state_at.h"
#include "core/closed_form/vector_targets.h"
#include "core/limits/extremes.h"
#include "core/newton/newton.h"
#include "core/sampling/trajectory.h"
#include "core/study/cases.h"

#include <benchmark/benchmark.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

using namespace slidercrank;

namespace
{

/// Returns the case of the reference report's file: one turn in 201 time steps.
Case nominal()
{
    return nominalCases()[1];
}

/// Returns a case whose crank cannot make full turns. Some of its time steps are beyond the limits of the crank.
Case rocker()
{
    const std::vector<Case> cases = hardCases();
    return *std::find_if(cases.begin(), cases.end(), [](const Case &each) { return each.name == "rocker, one arc"; });
}

/// Reports the time per state, given the number of states per iteration of the benchmark.
void countStates(benchmark::State &state, std::size_t states)
{
    state.counters["per_state"] = benchmark::Counter(
        static_cast<double>(states), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Computes all 36 channels directly by the textbook's formulas, with the angle in one double. Like
/// ClosedForm::stateAt, which is in a library, this function is not inlined.
HWY_NOINLINE State plainStateAt(const Parameters &p, double t)
{
    const double w = p.omega2;
    const double theta2 = w * t + p.theta20;
    const double sin2 = std::sin(theta2);
    const double cos2 = std::cos(theta2);
    const double h = p.c - p.a * sin2;
    const double root = std::sqrt((p.b - h) * (p.b + h));
    const double s = p.branch == Branch::Open ? root : -root;
    const double theta3 = std::atan2(h, s);
    const double w3 = -p.a * w * cos2 / s;
    const double alpha3 = (p.a * w * w * sin2 + h * w3 * w3) / s;
    const double sDot = -h * w3;
    const double sDDot = -s * w3 * w3 - h * alpha3;
    State state;
    state.q << 0.0, 0.0, 0.0, 0.5 * p.a * cos2, 0.5 * p.a * sin2, theta2, p.a * cos2 + 0.5 * s, p.a * sin2 + 0.5 * h,
        theta3, p.a * cos2 + s, p.c, 0.0;
    state.qDot << 0.0, 0.0, 0.0, -0.5 * p.a * w * sin2, 0.5 * p.a * w * cos2, w, -p.a * w * sin2 + 0.5 * sDot,
        p.a * w * cos2 + 0.5 * s * w3, w3, -p.a * w * sin2 + sDot, 0.0, 0.0;
    state.qDDot << 0.0, 0.0, 0.0, -0.5 * p.a * w * w * cos2, -0.5 * p.a * w * w * sin2, 0.0,
        -p.a * w * w * cos2 + 0.5 * sDDot, -0.5 * p.a * w * w * sin2, alpha3, -p.a * w * w * cos2 + sDDot, 0.0, 0.0;
    return state;
}

/// Measures all 36 channels of a turn by stateAt(t).
template <class StateAt>
void measureStates36(benchmark::State &state, const Case &given, const StateAt &stateAt)
{
    const std::vector<double> times = given.sampling.timeStamps();
    std::vector<State> states(times.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            states[i] = stateAt(times[i]);
        }
        benchmark::DoNotOptimize(states.data());
        benchmark::ClobberMemory();
    }
    countStates(state, times.size());
}

void plainClosedForm36(benchmark::State &state)
{
    const Parameters parameters = nominal().parameters;
    measureStates36(state, nominal(), [&](double t) { return plainStateAt(parameters, t); });
}
BENCHMARK(plainClosedForm36);

void closedForm36(benchmark::State &state)
{
    const ClosedForm closedForm{Mechanism(nominal().parameters)};
    measureStates36(state, nominal(), [&](double t) { return closedForm.stateAt(t); });
}
BENCHMARK(closedForm36);

void closedForm36Rocker(benchmark::State &state)
{
    const ClosedForm closedForm{Mechanism(rocker().parameters)};
    measureStates36(state, rocker(), [&](double t) { return closedForm.stateAt(t); });
}
BENCHMARK(closedForm36Rocker);

/// Measures the plotted channels with one instruction set.
void closedFormBatch(benchmark::State &state, std::int64_t target)
{
    hwy::SetSupportedTargetsForTest(target);
    const ClosedForm batch{Mechanism(nominal().parameters)};
    const std::vector<double> times = nominal().sampling.timeStamps();
    std::vector<std::vector<double>> values(6, std::vector<double>(times.size()));
    std::vector<Status> statuses(times.size());
    PlottedColumns columns{};
    std::ranges::transform(values, columns.begin(), [](std::vector<double> &column) { return column.data(); });
    for (auto _ : state) {
        batch.evaluate(times, columns, statuses);
        benchmark::DoNotOptimize(values.data());
        benchmark::ClobberMemory();
    }
    countStates(state, times.size());
    hwy::SetSupportedTargetsForTest(0);
}

/// Measures all 36 channels by Newton-Raphson with the default tolerance. The first guess of a time step follows from
/// the previous time step, as `warmStart` says.
void newton36(benchmark::State &state, const Case &given, WarmStart warmStart, Elimination elimination)
{
    NewtonOptions options;
    options.warmStart = warmStart;
    options.elimination = elimination;
    const Mechanism mechanism(given.parameters);
    const std::vector<double> times = given.sampling.timeStamps();
    int iterations = 0;
    for (auto _ : state) {
        NewtonTimeStep last;
        iterations = 0;
        for (const double t : times) {
            advance(mechanism, t, last, options);
            benchmark::DoNotOptimize(last);
            iterations += last.iterations;
        }
    }
    state.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(times.size());
    countStates(state, times.size());
}
BENCHMARK_CAPTURE(newton36, dense, nominal(), WarmStart::Previous, Elimination::Dense);
BENCHMARK_CAPTURE(newton36, denseTaylor, nominal(), WarmStart::Taylor, Elimination::Dense);
BENCHMARK_CAPTURE(newton36, structured, nominal(), WarmStart::Previous, Elimination::Structured);
BENCHMARK_CAPTURE(newton36, structuredTaylor, nominal(), WarmStart::Taylor, Elimination::Structured);
BENCHMARK_CAPTURE(newton36, structuredTaylorRocker, rocker(), WarmStart::Taylor, Elimination::Structured);

/// Measures the peaks of a turn, which the window computes at every move of a slider. They are hardest to find near the
/// change point b = a + c = 45 mm; `gap` is the relative distance of b from it.
void motionPeaks(benchmark::State &state, double gap)
{
    Parameters p;
    p.b = 45.0 * (1.0 + gap);
    const Mechanism mechanism(p);
    for (auto _ : state) {
        const std::vector<Peak> peaks = slidercrank::motionPeaks(mechanism);
        benchmark::DoNotOptimize(peaks.data());
    }
}
BENCHMARK_CAPTURE(motionPeaks, wide, 0.5)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(motionPeaks, narrow, 1e-12)->Unit(benchmark::kMicrosecond);

} // namespace

int main(int argc, char **argv)
{
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        const std::string name = hwy::TargetName(target);
        benchmark::RegisterBenchmark(("closedFormBatch6/" + name).c_str(), closedFormBatch, target);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
