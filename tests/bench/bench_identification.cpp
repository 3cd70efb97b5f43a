// SPDX-License-Identifier: GPL-3.0-or-later

// What it costs to find the mechanism that made 201 rows, and how a file has to be interpreted. The start is Table 1 of
// the report, which the data are far from.

#include "core/identification/diagnosis.h"
#include "tests/support/printed_motion.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

using namespace slidercrank;

namespace
{

/// Nothing as in Table 1.
const Parameters kFarOff{80.0, 150.0, -40.0, -11.0, 2.0, Branch::Crossed};

/// Table 1 with b = 60, as the author's file has it.
const Parameters kAuthors{20.0, 60.0, 25.0, 2.0 * std::numbers::pi, 0.0, Branch::Open};

void identifyChannels(benchmark::State &state, const Parameters &truth, const std::string &channels, int rows,
                      double duration)
{
    Printing printing;
    printing.rows = rows;
    printing.to = duration;
    printing.channels = channels;
    const ReferenceData data = printedData(truth, printing);
    int iterations = 0;
    for (auto _ : state) {
        const Identification result = diagnose(data, Mechanism()).identification;
        iterations = result.iterations;
        benchmark::DoNotOptimize(&result);
    }
    state.counters["iterations"] = iterations;
}
BENCHMARK_CAPTURE(identifyChannels, authors_file, kAuthors, "111111", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, all_six, kFarOff, "111111", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, theta3_and_R4x, kFarOff, "110000", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, R4x, kFarOff, "010000", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, theta3, kFarOff, "100000", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, velocities, kFarOff, "001100", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, accelerations, kFarOff, "000011", 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, half_a_turn, kFarOff, "111111", 201, 0.3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(identifyChannels, many_rows, kFarOff, "111111", 100000, 100.0)->Unit(benchmark::kMillisecond);

/// Of a file with its angles in radians, against Table 1.
void findRadians(benchmark::State &state, const Parameters &truth, int rows, double duration)
{
    Printing printing;
    printing.rows = rows;
    printing.to = duration;
    const std::vector<Channel> angles{
        {Theta3, Order::Position}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}};
    const Convention toRadians{Convention::Kind::AngleUnit, angles, 1.0 / kDegreesPerRadian};
    const ReferenceData data = applied(toRadians, printedData(truth, printing));
    for (auto _ : state) {
        const Diagnosis found = diagnose(data, Mechanism());
        benchmark::DoNotOptimize(&found);
    }
}
BENCHMARK_CAPTURE(findRadians, at_hand, Parameters(), 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findRadians, authors_file, kAuthors, 201, 1.0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findRadians, many_rows, kAuthors, 1'000'000, 1e4)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
