// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/file_search.h"

#include "core/identification/crank_speed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr std::size_t kSearchRows = 300;
constexpr std::size_t kFinalRows = 1000;

/// The rows whose flag is not set.
Observations without(const Observations &data, const std::vector<bool> &flags)
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (!flags[i]) {
            rows.push_back(i);
        }
    }
    return selection(data, rows);
}

/// Whether some rows are flagged, and few enough to be excluded.
bool mayBeExcluded(const std::vector<bool> &flags)
{
    constexpr double kMost = 0.05; // of the rows
    const auto count = static_cast<double>(std::ranges::count(flags, true));
    return count > 0.0 && count <= kMost * static_cast<double>(flags.size());
}

/// The median of the magnitudes, without NaN; 0 if there are none.
double medianMagnitude(std::vector<double> values)
{
    std::erase_if(values, [](double value) { return std::isnan(value); });
    const auto middle = values.begin() + std::ranges::ssize(values) / 2;
    std::ranges::nth_element(values, middle, {}, [](double value) { return std::abs(value); });
    return values.empty() ? 0.0 : std::abs(*middle);
}

/// Flags rows with a value far from the straight line between its neighbours. They may be bad readings.
std::vector<bool> suspiciousRows(const Observations &data)
{
    constexpr double kFar = 12.0;       // times the median distance from that line
    constexpr double kLeastPart = 0.05; // of the spread
    std::vector<bool> flags(data.abscissa.size(), false);
    for (const ObservedColumn &column : data.columns) {
        std::vector<double> distances(flags.size(), kNone);
        for (std::size_t i = 1; i + 1 < flags.size(); ++i) {
            const double part =
                (data.abscissa[i] - data.abscissa[i - 1]) / (data.abscissa[i + 1] - data.abscissa[i - 1]);
            distances[i] =
                std::abs(column.values[i] - (1.0 - part) * column.values[i - 1] - part * column.values[i + 1]);
        }
        const double far = std::max(kFar * medianMagnitude(distances), kLeastPart * column.spread);
        for (std::size_t i = 1; i + 1 < flags.size() && tellsShape(column); ++i) {
            const bool isPeak = !(distances[i] < distances[i - 1]) && !(distances[i] < distances[i + 1]);
            flags[i] = flags[i] || (isPeak && distances[i] > far);
        }
    }
    return flags;
}

/// Flags rows in which the residual of a used column exceeds 8 standard deviations, estimated by the median absolute
/// deviation.
std::vector<bool> outliers(const Observations &data, const Candidate &candidate)
{
    constexpr double kFar = 8.0;
    constexpr double kOfNormal = 1.4826; // standard deviation per median absolute deviation
    std::vector<bool> flags(data.abscissa.size(), false);
    const Fit fit = evaluateHypothesis(data, candidate.hypothesis);
    if (!fit.exists()) {
        return flags;
    }
    // Near a toggle position the accelerations are unbounded, so that a large residual need not be a bad reading.
    constexpr double kNearToggle = 1e-4; // of the square of the coupler's length
    const auto isNearToggle = [&](std::size_t row) {
        const Eigen::VectorXd &q = fit.hypothesis.unknowns;
        const double height = (q[2] - q[0] * std::sin(crankAngle(data, fit.hypothesis, row))) / q[1];
        return 1.0 - height * height < kNearToggle;
    };
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const double scale = kOfNormal * medianMagnitude(fit.residuals[j]);
        const double factor = fit.hypothesis.columns[j].factor();
        for (std::size_t i = 0; i < flags.size(); ++i) {
            // Without the estimated noise, which contains the outliers.
            const double rounding = factor * factor * data.columns[j].variances[i];
            const double variance = std::max(fit.variances[j][i] - fit.noiseVariances[j], rounding);
            const double far = kFar * std::max(scale, std::sqrt(variance));
            flags[i] = flags[i] || (std::abs(fit.residuals[j][i]) > far && !isNearToggle(i));
        }
    }
    return flags;
}

/// At most 300 rows from the beginning of the file, spread over as many turns as they can resolve.
Observations searchWindow(const Observations &all)
{
    constexpr double kMostTurns = 6.0;
    const std::size_t count = all.abscissa.size();
    if (count <= kSearchRows) {
        return all;
    }
    const double turns = roughTurns(all);
    std::size_t end = count;
    if (turns > kMostTurns) {
        end = static_cast<std::size_t>(static_cast<double>(count) * kMostTurns / turns);
        end = std::clamp(end, std::min(kSearchRows, count), count);
    }
    return selection(all, spreadRows(end, kSearchRows));
}

/// At most a thousand rows of the file, in blocks of consecutive rows, so that neighbours can be compared.
Observations finalRows(const Observations &all)
{
    constexpr std::size_t kBlock = 20;
    const std::size_t count = all.abscissa.size();
    if (count <= kFinalRows) {
        return all;
    }
    std::vector<std::size_t> rows;
    constexpr std::size_t kBlocks = kFinalRows / kBlock;
    for (std::size_t block = 0; block < kBlocks; ++block) {
        const std::size_t first = block * (count - kBlock) / (kBlocks - 1);
        for (std::size_t i = 0; i < kBlock; ++i) {
            if (rows.empty() || first + i > rows.back()) {
                rows.push_back(first + i);
            }
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

/// Excludes the rows that are outliers of the best candidate, in several rounds because they bias its fit. Returns
/// whether the mechanism of the other rows is identified; if not, changes nothing.
bool excludeOutliers(const Observations &all, const Parameters &given, const std::stop_token &stop, FileSearch &search)
{
    constexpr int kRounds = 4;
    if (search.candidates.empty()) {
        return false;
    }
    Candidate nearest = search.candidates.front();
    std::vector<bool> flags;
    for (int round = 0; round < kRounds && !stop.stop_requested(); ++round) {
        std::vector<bool> found = outliers(all, nearest);
        if (found == flags || !mayBeExcluded(found)) {
            break;
        }
        flags = std::move(found);
        nearest = fitCandidate(finalRows(without(all, flags)), nearest.hypothesis);
        if (!nearest.exists()) {
            return false;
        }
    }
    // Systematic residuals follow no distribution, so that large ones may be good readings.
    if (flags.empty() || nearest.acceptance != Acceptance::Identified) {
        return false;
    }
    search = searchRows(without(all, flags), given, stop);
    if (search.candidates.empty() || isBetter(nearest, search.candidates.front())) {
        search.candidates.insert(search.candidates.begin(), std::move(nearest));
    }
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i]) {
            search.excluded.push_back(all.rows[i]);
        }
    }
    std::ranges::sort(search.excluded);
    return true;
}

} // namespace

FileSearch searchFile(const Observations &all, const Parameters &given, const std::stop_token &stop)
{
    FileSearch search = searchRows(all, given, stop);
    const bool isIdentified =
        !search.candidates.empty() && search.candidates.front().acceptance == Acceptance::Identified;
    const std::vector<bool> suspicious = suspiciousRows(all);
    if (!isIdentified && mayBeExcluded(suspicious)) { // they may have prevented the search from finding the motion
        FileSearch cleaned = searchRows(without(all, suspicious), given, stop);
        if (excludeOutliers(all, given, stop, cleaned)) {
            return cleaned;
        }
    }
    if (!isIdentified || search.data.abscissa.size() < all.abscissa.size()) {
        excludeOutliers(all, given, stop, search);
    }
    return search;
}

} // namespace slidercrank
