// SPDX-License-Identifier: GPL-3.0-or-later

// What the kinematics cost, method beside method in one run. Compare the column per_state; machines differ, ratios
// hardly. Interleaved: --benchmark_enable_random_interleaving=true --benchmark_repetitions=9
// --benchmark_report_aggregates_only=true

#include "core/closed_form/closed_form.h"
#include "core/closed_form/state_at.h"
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

/// The author's file: one turn in 201 instants.
const Case &nominal()
{
    return nominalCases()[1];
}

/// A crank that cannot turn round: the instants beyond its limits count as the others.
const Case &rocker()
{
    const std::span<const Case> cases = hardCases();
    return *std::find_if(cases.begin(), cases.end(), [](const Case &which) { return which.name == "rocker, one arc"; });
}

/// Counts `states` of them a turn of the benchmark's loop.
void countStates(benchmark::State &state, std::size_t states)
{
    state.counters["per_state"] = benchmark::Counter(
        static_cast<double>(states), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// All 36 channels straight from the textbook's formulas and the standard library, as anybody would write them first:
/// the angle in one double, h rounded. Called as a function of a library is, like ClosedForm::stateAt.
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

/// All 36 channels of a turn by stateAt(t).
template <class StateAt>
void states36(benchmark::State &state, const Case &which, const StateAt &stateAt)
{
    const std::vector<double> instants = which.sampling.instants();
    std::vector<State> states(instants.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < instants.size(); ++i) {
            states[i] = stateAt(instants[i]);
        }
        benchmark::DoNotOptimize(states.data());
        benchmark::ClobberMemory();
    }
    countStates(state, instants.size());
}

void plainClosedForm36(benchmark::State &state)
{
    const Parameters parameters = nominal().parameters;
    states36(state, nominal(), [&](double t) { return plainStateAt(parameters, t); });
}
BENCHMARK(plainClosedForm36);

void closedForm36(benchmark::State &state)
{
    const ClosedForm closedForm{Mechanism(nominal().parameters)};
    states36(state, nominal(), [&](double t) { return closedForm.stateAt(t); });
}
BENCHMARK(closedForm36);

void closedForm36Rocker(benchmark::State &state)
{
    const ClosedForm closedForm{Mechanism(rocker().parameters)};
    states36(state, rocker(), [&](double t) { return closedForm.stateAt(t); });
}
BENCHMARK(closedForm36Rocker);

/// The plotted channels on one instruction set.
void closedFormBatch(benchmark::State &state, std::int64_t target)
{
    hwy::SetSupportedTargetsForTest(target);
    const ClosedForm batch{Mechanism(nominal().parameters)};
    const std::vector<double> instants = nominal().sampling.instants();
    std::vector<std::vector<double>> values(6, std::vector<double>(instants.size()));
    std::vector<Status> statuses(instants.size());
    PlottedColumns columns{};
    std::ranges::transform(values, columns.begin(), [](std::vector<double> &column) { return column.data(); });
    for (auto _ : state) {
        batch.evaluate(instants, columns, statuses);
        benchmark::DoNotOptimize(values.data());
        benchmark::ClobberMemory();
    }
    countStates(state, instants.size());
    hwy::SetSupportedTargetsForTest(0);
}

/// All 36 channels by a rung of Newton-Raphson, each instant from the one before, to the report's tolerance.
void newton36(benchmark::State &state, const Case &which, WarmStart warmStart, Elimination elimination)
{
    NewtonOptions options;
    options.warmStart = warmStart;
    options.elimination = elimination;
    const Mechanism mechanism(which.parameters);
    const std::vector<double> instants = which.sampling.instants();
    int iterations = 0;
    for (auto _ : state) {
        NewtonInstant last;
        iterations = 0;
        for (const double t : instants) {
            advance(mechanism, t, last, options);
            benchmark::DoNotOptimize(last);
            iterations += last.iterations;
        }
    }
    state.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(instants.size());
    countStates(state, instants.size());
}
BENCHMARK_CAPTURE(newton36, dense, nominal(), WarmStart::Previous, Elimination::Dense);
BENCHMARK_CAPTURE(newton36, denseTaylor, nominal(), WarmStart::Taylor, Elimination::Dense);
BENCHMARK_CAPTURE(newton36, structured, nominal(), WarmStart::Previous, Elimination::Structured);
BENCHMARK_CAPTURE(newton36, structuredTaylor, nominal(), WarmStart::Taylor, Elimination::Structured);
BENCHMARK_CAPTURE(newton36, structuredTaylorRocker, rocker(), WarmStart::Taylor, Elimination::Structured);

/// The peaks of a turn, as the window shows them at every move of a slider; `gap` from the change point, where they
/// are hardest to find.
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
