// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how long it takes to identify the mechanism of a file and how the file has to be interpreted. The search
// starts at Table 1 of the reference report, which is far from the mechanism of most files.

#include "core/identification/identification.h"
#include "tests/support/printed_motion.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

using namespace slidercrank;

namespace
{

/// Differs from Table 1 in every parameter.
const Parameters kFarOff{80.0, 150.0, -40.0, -11.0, 2.0, Branch::Crossed};

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

void measure(benchmark::State &state, const ReferenceData &data)
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
    measure(state, printedData(truth, printingOf(rows, duration, channels)));
}
BENCHMARK_CAPTURE(identifyMotion, report, kReport, kSixChannels, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, all_six, kFarOff, kSixChannels, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, theta3_and_R4x, kFarOff, kAngleAndPosition, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, R4x, kFarOff, {kSlider}, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, theta3, kFarOff, {kTheta3}, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, velocities, kFarOff, {kTheta3Speed, kSliderSpeed}, 201, 1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, accelerations, kFarOff, {kTheta3Acceleration, kSliderAcceleration}, 201, 1.0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, half_a_turn, kFarOff, kSixChannels, 201, 0.3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyMotion, many_rows, kFarOff, kSixChannels, 100'000, 100.0)->Unit(benchmark::kMillisecond);

/// Measures with angles in radians.
void identifyRadians(benchmark::State &state, const Parameters &truth, int rows, double duration)
{
    const std::vector<Channel> angles{
        {Theta3, Order::Position}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}};
    const Convention toRadians{Convention::Kind::AngleUnit, angles, 1.0 / kDegreesPerRadian};
    measure(state, applied(toRadians, printedData(truth, printingOf(rows, duration, kSixChannels))));
}
BENCHMARK_CAPTURE(identifyRadians, given, Parameters(), 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyRadians, report, kReport, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyRadians, many_rows, kReport, 1'000'000, 1e4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
