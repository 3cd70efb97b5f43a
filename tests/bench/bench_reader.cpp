// SPDX-License-Identifier: GPL-3.0-or-later

// The reader against the least that any reader of the same bytes does: a loop of std::from_chars over their numbers,
// one thread, nothing kept but a sum. A million rows of 7 columns in the form of the author's file, 74 MB.

#include "core/import/reference_data.h"
#include "core/sampling/trajectory.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr std::size_t kRows = 1'000'000;

/// Six significant digits printed with six decimals, as the author's program does.
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
        const Mechanism mechanism{Parameters()};
        std::vector<double> time(kRows);
        for (std::size_t i = 0; i < kRows; ++i) {
            time[i] = static_cast<double>(i) * 1e-6;
        }
        const Trajectory motion = sample(mechanism, time, plottedChannels(), {});
        std::string rows = "time";
        for (const Channel channel : kPlottedChannels) {
            rows += ',' + std::string(nameOf(channel));
        }
        rows += '\n';
        std::array<char, 64> cell;
        for (std::size_t i = 0; i < kRows; ++i) {
            const int length = std::snprintf(cell.data(), cell.size(), "%.6f", time[i]);
            rows.append(cell.data(), static_cast<std::size_t>(length));
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

double bareFromChars(const std::string &text)
{
    const char *next = text.data() + text.find('\n') + 1;
    const char *const end = text.data() + text.size();
    double sum = 0.0;
    while (next < end) {
        double value = 0.0;
        next = std::from_chars(next, end, value).ptr + 1;
        sum += value;
    }
    return sum;
}

template <typename Work>
double millisecondsOf(Work work)
{
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(work());
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values)
{
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

/// Both in turn, so that whatever else the machine does meets both. ratio: the median of the ratios.
void readerOverFromChars(benchmark::State &state)
{
    const std::string &text = largeFile();
    std::vector<double> bare;
    std::vector<double> reader;
    std::vector<double> ratios;
    for (auto _ : state) {
        bare.push_back(millisecondsOf([&] { return bareFromChars(text); }));
        reader.push_back(millisecondsOf([&] { return readReferenceData(text); }));
        ratios.push_back(reader.back() / bare.back());
    }
    state.counters["MB"] = static_cast<double>(text.size()) * 1e-6;
    state.counters["bare_ms"] = median(bare);
    state.counters["reader_ms"] = median(reader);
    state.counters["ratio"] = median(ratios);
}
BENCHMARK(readerOverFromChars)->Unit(benchmark::kMillisecond)->Iterations(25);

} // namespace

// `bench_reader --write FILE` leaves the file, to time the program on it.
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
