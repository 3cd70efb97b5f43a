// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/file_search.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// A file of so many rows is looked at as a whole.
constexpr std::size_t kShortFile = 600;

constexpr std::size_t kWindowRows = 360;

/// Swings of a column within a window.
constexpr double kWindowSwings = 8.0;

/// How often a column goes all the way up, from the lowest to the highest quarter of its range.
std::size_t swingsOf(std::span<const double> values)
{
    const ValueRange range = rangeOf(values);
    const double low = range.low + 0.25 * range.width();
    const double high = range.high - 0.25 * range.width();
    std::size_t swings = 0;
    bool isDown = false;
    for (const double value : values) {
        if (isDown && value > high) {
            isDown = false;
            ++swings;
        } else if (value < low) {
            isDown = true;
        }
    }
    return swings;
}

Candidate refitted(const SearchRows &rows, const FitUnits &from, const Candidate &candidate,
                   const std::stop_token &stop)
{
    // The constants come out of the fit by themselves.
    const Parameters start = rows.all.units.toFit(from.fromFit(candidate.fit.parameters));
    const double crossed = candidate.fit.parameters.branch == Branch::Crossed ? kPriceOfCrossed : 0.0;
    return candidateFrom(rows, candidate.reading, candidate.penalty - crossed, start, stop);
}

} // namespace

std::optional<FileSearch> searchIn(const ReferenceData &data, const Parameters &given)
{
    FileSearch search;
    search.rows = rowsOf(data);
    if (search.rows.count < 2) {
        return std::nullopt;
    }
    search.clock = clockOf(data);
    RowRange first = search.rows;
    if (first.count > kShortFile) {
        std::size_t swings = 0;
        for (const ReferenceSeries &series : data.series) {
            swings = std::max(swings, swingsOf(series.values));
        }
        const double part = std::min(1.0, kWindowSwings / std::max(static_cast<double>(swings), 1.0));
        const auto rows = static_cast<std::size_t>(std::ceil(part * static_cast<double>(first.end - first.first)));
        first = counted(data, first.first, std::min(first.end, first.first + std::max(rows, kWindowRows)));
        search.isWhole = false;
    }
    const std::size_t most = search.isWhole ? kShortFile : kWindowRows;
    search.window = searchRowsOf(data, search.clock, spreadOver(data, first, most), given);
    return search;
}

SearchRows wholeOf(const ReferenceData &data, const FileSearch &search, const Parameters &given)
{
    return search.isWhole ? search.window
                          : searchRowsOf(data, search.clock, spreadOver(data, search.rows, kMostFitRows), given);
}

Candidate grown(const ReferenceData &data, const FileSearch &search, const SearchRows &whole,
                const Candidate &candidate, const std::stop_token &stop)
{
    if (search.isWhole) {
        return candidate;
    }
    constexpr double kGrowth = 4.0;
    const FitUnits &units = search.window.all.units;
    const double first = data.time[search.rows.first];
    double reach = 2.0 * (units.origin - first) + 0.0; // from the first row to the window's last
    Candidate current = candidate;
    FitUnits from = units;
    const double span = data.time[search.rows.end - 1] - first;
    for (reach *= kGrowth; reach < span && !stop.stop_requested(); reach *= kGrowth) {
        const auto last =
            static_cast<std::size_t>(std::ranges::upper_bound(data.time, first + reach) - data.time.begin());
        const RowRange some = counted(data, search.rows.first, std::min(last, search.rows.end));
        const SearchRows part =
            searchRowsOf(data, search.clock, spreadOver(data, some, kWindowRows), from.fromFit(current.fit.parameters));
        if (part.all.columns.size() != current.reading.size()) {
            break;
        }
        current = refitted(part, from, current, stop);
        from = part.all.units;
    }
    return whole.all.columns.size() == current.reading.size() ? refitted(whole, from, current, stop) : current;
}

} // namespace slidercrank
