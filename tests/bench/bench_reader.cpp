// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the reader with std::from_chars alone, on the same bytes: a million rows of 7 columns in the format of the
// reference report's file, 74 MB. Interleave the repetitions: --benchmark_enable_random_interleaving=true
//
// `bench_reader --write FILE` writes the bytes to a file, to measure the whole program with it.

#include "core/import/reference_data.h"
#include "tests/support/printed_motion.h"

#include <benchmark/benchmark.h>

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>

using namespace slidercrank;

namespace
{

const std::string &largeFile()
{
    static const std::string text =
        printedMotion(Parameters(), {.to = 0.999999, .rows = 1'000'000, .format = "%.6f", .timeFormat = "%.6f"},
                      [](int, Channel) { return false; });
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
