// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/file_search.h"

#include "core/identification/crank_speed.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr std::size_t kSearchRows = 300;

/// The rows whose flag is not set, without the influence of the others on the spread of the columns.
Observations without(const Observations &data, const std::vector<bool> &flags)
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (!flags[i]) {
            rows.push_back(i);
        }
    }
    Observations kept = selection(data, rows);
    std::ranges::for_each(kept.columns, learnSpread);
    return kept;
}

/// Whether some rows are flagged, and few enough to be excluded.
bool mayBeExcluded(const std::vector<bool> &flags)
{
    constexpr double kMost = 0.05; // of the rows
    const auto count = static_cast<double>(std::ranges::count(flags, true));
    return count > 0.0 && count <= kMost * static_cast<double>(flags.size());
}

/// Flags rows with a position far outside the range of the others, such as a code for lost values. Derivatives may have
/// high peaks near a toggle position.
std::vector<bool> suspiciousRows(const Observations &data)
{
    std::vector<bool> flags(data.abscissa.size(), false);
    for (const ObservedColumn &column : data.columns) {
        std::vector<double> values = column.values;
        std::ranges::for_each(values, [&](double &value) { value -= column.mean; });
        const double far = column.channel.order == Order::Position ? kFarReading * robustDeviation(values) : kInfinity;
        for (std::size_t row = 0; row < flags.size(); ++row) {
            flags[row] = flags[row] || std::abs(values[row]) > far;
        }
    }
    return flags;
}

/// Flags rows with a residual beyond 8 standard deviations. The standard deviation is that of the rounding, the one
/// that follows from the median absolute residual of all rows, or the same of the rows at similar crank angles, because
/// noise may grow with the reading or the speed. Residuals below 8 millionths of the spread are never flagged.
std::vector<bool> outliers(const Observations &data, const Candidate &candidate)
{
    constexpr std::size_t kMostSectors = 8; // so that a block of bad rows is less than half of a sector
    constexpr std::size_t kRowsOfSector = 20;
    constexpr double kClearlyLarger = 1.5;
    constexpr double kSmallestPart = 1e-6; // of the spread
    const std::size_t count = data.abscissa.size();
    const std::size_t sectors = std::clamp<std::size_t>(count / kRowsOfSector, 1, kMostSectors);
    const Fit fit = evaluateHypothesis(data, candidate.hypothesis);
    const auto sectorOf = [&](std::size_t row) {
        const double turns = crankAngle(data, fit.hypothesis, row) / kTurn;
        return static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(sectors)) % sectors;
    };
    std::vector<bool> flags(count, false);
    for (std::size_t j = 0; j < fit.residuals.size(); ++j) {
        std::vector<std::vector<double>> residuals(sectors);
        for (std::size_t i = 0; i < count; ++i) {
            residuals[sectorOf(i)].push_back(fit.residuals[j][i]);
        }
        const double scale =
            std::max(robustDeviation(fit.residuals[j]), kSmallestPart * interpretedSpread(data, fit.hypothesis, j));
        std::vector<double> scales(sectors, scale);
        std::ranges::transform(residuals, scales.begin(), [&](const std::vector<double> &values) {
            const double ofSector = robustDeviation(values);
            return ofSector > kClearlyLarger * scale ? ofSector : scale;
        });
        for (std::size_t i = 0; i < count; ++i) {
            const double rounding = std::sqrt(std::max(fit.variances[j][i] - fit.noiseVariances[j], 0.0));
            flags[i] =
                flags[i] || std::abs(fit.residuals[j][i]) > kFarReading * std::max(scales[sectorOf(i)], rounding);
        }
    }
    return flags;
}

/// At most 300 rows from the beginning of the file, spread over as many turns as they can resolve.
Observations searchWindow(const Observations &all)
{
    constexpr double kMostTurns = 6.0;
    const std::size_t count = all.abscissa.size();
    const double part = std::min(kMostTurns / roughTurns(all), 1.0);
    const auto end = static_cast<std::size_t>(static_cast<double>(count) * part);
    return selection(all, spreadRows(std::max(end, std::min(kSearchRows, count)), kSearchRows));
}

/// At most a thousand rows of the file, in evenly spread blocks of consecutive rows, so that neighbours can be
/// compared.
Observations finalRows(const Observations &all)
{
    constexpr std::size_t kRows = 20; // of a block
    constexpr std::size_t kMost = 50; // blocks
    const std::size_t blocks = (all.abscissa.size() + kRows - 1) / kRows;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < all.abscissa.size(); ++row) {
        const std::size_t block = row / kRows;
        if ((block + 1) * kMost / blocks > block * kMost / blocks) {
            rows.push_back(row);
        }
    }
    return selection(all, rows);
}

/// Fits a candidate of the window to ever larger parts of the file, each four times as long as the one before, because
/// each fit determines the speed well enough for the next part only. The last fit is to `last`.
Candidate extended(const Observations &all, const Observations &window, const Observations &last,
                   const Candidate &found)
{
    constexpr std::size_t kGrowth = 4;
    constexpr std::size_t kRows = 200;
    constexpr int kRounds = 3;
    Hypothesis hypothesis = found.hypothesis;
    std::size_t end =
        static_cast<std::size_t>(std::ranges::upper_bound(all.abscissa, window.abscissa.back()) - all.abscissa.begin());
    while (end < all.abscissa.size()) {
        end = std::min(kGrowth * end, all.abscissa.size());
        Fit fit = fitHypothesis(selection(all, spreadRows(end, kRows)), hypothesis, kRounds);
        if (!fit.exists()) {
            break;
        }
        hypothesis = std::move(fit.hypothesis);
    }
    hypothesis.abscissaStep = all.step; // only the whole file shows whether the time stamps are rounded
    Candidate candidate = fitCandidate(last, std::move(hypothesis));
    candidate.price = found.price; // includes the preference for the given mechanism
    return candidate;
}

/// Searches the window, and extends its best candidates to all rows.
FileSearch searchRows(const Observations &all, const Parameters &given, const std::stop_token &stop)
{
    constexpr std::size_t kMost = 6;
    const Observations window = searchWindow(all);
    FileSearch search{finalRows(all), searchCandidates(window, given, stop), {}};
    if (window.abscissa.size() < search.data.abscissa.size()) {
        search.candidates.resize(std::min(kMost, search.candidates.size()));
        for (Candidate &candidate : search.candidates) {
            candidate = stop.stop_requested() ? Candidate() : extended(all, window, search.data, candidate);
        }
        std::erase_if(search.candidates, [](const Candidate &candidate) { return !candidate.exists(); });
        std::ranges::stable_sort(search.candidates, isBetter);
    }
    return search;
}

/// Excludes the rows that are outliers of the best candidate, in several rounds because they bias its fit. Changes
/// nothing if the mechanism of the other rows is not identified.
void excludeOutliers(const Observations &all, const Parameters &given, const std::stop_token &stop, FileSearch &search)
{
    constexpr int kRounds = 4;
    Candidate nearest = search.candidates.empty() ? Candidate() : search.candidates.front();
    std::vector<bool> flags;
    for (int round = 0; round < kRounds && nearest.exists() && !stop.stop_requested(); ++round) {
        std::vector<bool> found = outliers(all, nearest);
        if (found == flags || !mayBeExcluded(found)) {
            break;
        }
        flags = std::move(found);
        nearest = fitCandidate(finalRows(without(all, flags)), nearest.hypothesis);
    }
    // Systematic residuals follow no distribution, so that large ones may be good readings.
    if (flags.empty() || nearest.acceptance != Acceptance::Identified) {
        return;
    }
    search = searchRows(without(all, flags), given, stop);
    search.candidates.push_back(std::move(nearest));
    std::ranges::stable_sort(search.candidates, isBetter);
    const std::vector<bool> remaining = outliers(all, search.candidates.front());
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] && remaining[i]) {
            search.excluded.insert(all.rows[i]);
        }
    }
}

} // namespace

FileSearch searchFile(const Observations &all, const Parameters &given, const std::stop_token &stop)
{
    FileSearch search = searchRows(all, given, stop);
    const std::vector<bool> suspicious = suspiciousRows(all);
    if (!isIdentified(search.candidates) && mayBeExcluded(suspicious)) { // they may have prevented the search
        FileSearch cleaned = searchRows(without(all, suspicious), given, stop);
        excludeOutliers(all, given, stop, cleaned);
        if (!cleaned.excluded.empty()) {
            return cleaned;
        }
    }
    if (!isIdentified(search.candidates) || search.data.abscissa.size() < all.abscissa.size()) {
        excludeOutliers(all, given, stop, search);
    }
    return search;
}

} // namespace slidercrank
