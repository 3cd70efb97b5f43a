// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the reader with std::from_chars alone, on the same bytes: a million rows of 7 columns in the format of the
// reference report's file, 74 MB. Interleave the repetitions: --benchmark_enable_random_interleaving=true
//
// `bench_reader --write FILE` writes the bytes to a file, to measure the whole program with it.

#include "core/import/reference_data.h"
#include "core/sampling/trajectory.h"

#include <benchmark/benchmark.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr std::size_t kRows = 1'000'000;

/// Appends a number with six significant digits, padded with zeros to six decimals.
void append(std::string &text, double value)
{
    std::array<char, 64> cell;
    std::snprintf(cell.data(), cell.size(), "%.6g", value);
    const double rounded = std::strtod(cell.data(), nullptr);
    const int length = std::snprintf(cell.data(), cell.size(), "%.6f", rounded);
    text.append(cell.data(), static_cast<std::size_t>(length));
}

const std::string &largeFile()
{
    static const std::string text = [] {
        std::vector<double> time(kRows);
        for (std::size_t i = 0; i < kRows; ++i) {
            time[i] = static_cast<double>(i) * 1e-6;
        }
        const Trajectory motion = sample(Mechanism(Parameters()), time, plottedChannels(), {});
        std::string rows = "time";
        for (const Channel channel : kPlottedChannels) {
            rows += ',' + std::string(nameOf(channel));
        }
        rows += '\n';
        for (std::size_t i = 0; i < kRows; ++i) {
            append(rows, time[i]);
            for (const Channel channel : kPlottedChannels) {
                rows += ',';
                append(rows, motion[channel][i]);
            }
            rows += '\n';
        }
        return rows;
    }();
    return text;
}

void fromCharsAlone(benchmark::State &state)
{
    const std::string &text = largeFile();
    for (auto _ : state) {
        const char *const end = text.data() + text.size();
        double sum = 0.0;
        for (const char *next = text.data() + text.find('\n') + 1; next < end;) {
            double value = 0.0;
            next = std::from_chars(next, end, value).ptr + 1;
            sum += value;
        }
        benchmark::DoNotOptimize(sum);
    }
}
BENCHMARK(fromCharsAlone)->Unit(benchmark::kMillisecond);

void reader(benchmark::State &state)
{
    const std::string &text = largeFile();
    for (auto _ : state) {
        benchmark::DoNotOptimize(readReferenceData(text));
    }
}
BENCHMARK(reader)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char **argv)
{
    if (argc == 3 && std::string(argv[1]) == "--write") {
        std::FILE *const file = std::fopen(argv[2], "wb");
        const bool written = file && std::fwrite(largeFile().data(), 1, largeFile().size(), file) == largeFile().size();
        return file && std::fclose(file) == 0 && written ? 0 : 1;
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
