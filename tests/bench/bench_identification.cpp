// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how long the program takes to identify the mechanism and the conventions of a file. The search starts at
// Table 1 of the reference report, which is far from the mechanism of most files.

#include "core/identification/identification.h"
#include "tests/support/printed_motion.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

using namespace slidercrank;

namespace
{

/// A mechanism that differs from Table 1 in every parameter.
const Parameters kFarFromTable1{80.0, 150.0, -40.0, -11.0, 2.0, Branch::Crossed};

/// The mechanism of the reference report's file: Table 1 with b = 60.
const Parameters kReport{20.0, 60.0, 25.0, 2.0 * std::numbers::pi, 0.0, Branch::Open};

Printing printingOf(int rows, double duration, const std::vector<Channel> &channels)
{
    Printing printing;
    printing.rows = rows;
    printing.to = duration;
    printing.channels = channels;
    return printing;
}

void measureIdentification(benchmark::State &state, const ReferenceData &data)
{
    int iterations = 0;
    for (auto _ : state) {
        const Identification result = identify(data, Mechanism());
        iterations = result.iterations;
        benchmark::DoNotOptimize(&result);
    }
    state.counters["iterations"] = iterations;
}

void identifyMotion(benchmark::State &state, const Parameters &truth, const std::vector<Channel> &channels, int rows,
                    double duration)
{
    measureIdentification(state, printedData(truth, printingOf(rows, duration, channels)));
}
BENCHMARK_CAPTURE(identifyMotion, report, kReport, kSixChannels, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, all_six, kFarFromTable1, kSixChannels, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, theta3_and_R4x, kFarFromTable1, kAngleAndPosition, 201, 1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, R4x, kFarFromTable1, {kSlider}, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, theta3, kFarFromTable1, {kTheta3}, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, velocities, kFarFromTable1, {kTheta3Speed, kSliderSpeed}, 201, 1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, accelerations, kFarFromTable1, {kTheta3Acceleration, kSliderAcceleration}, 201, 1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, half_a_turn, kFarFromTable1, kSixChannels, 201, 0.3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, many_rows, kFarFromTable1, kSixChannels, 100'000, 100.0)
    ->Unit(benchmark::kMillisecond);

/// Measures a file whose angles are in radians.
void identifyRadians(benchmark::State &state, const Parameters &truth, int rows, double duration)
{
    const std::vector<Channel> angles{
        {Theta3, Order::Position}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}};
    const Convention toRadians{Convention::Kind::AngleUnit, angles, 1.0 / kDegreesPerRadian};
    measureIdentification(state, applied(toRadians, printedData(truth, printingOf(rows, duration, kSixChannels))));
}
BENCHMARK_CAPTURE(identifyRadians, given, Parameters(), 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyRadians, report, kReport, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyRadians, many_rows, kReport, 1'000'000, 1e4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
