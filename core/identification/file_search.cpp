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
constexpr double kMostExcluded = 0.05; // of the rows

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

bool mayBeExcluded(std::ptrdiff_t count, std::size_t rows)
{
    return count > 0 && static_cast<double>(count) <= kMostExcluded * static_cast<double>(rows);
}

double medianOf(std::vector<double> values)
{
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Flags rows with a value far from the straight line between its neighbours. They may be bad readings.
std::vector<bool> suspiciousRows(const Observations &data)
{
    constexpr double kFar = 12.0;       // times the median distance from that line
    constexpr double kLeastPart = 0.05; // of the spread
    std::vector<bool> flags(data.abscissa.size(), false);
    for (const ObservedColumn &column : data.columns) {
        std::vector<double> distances(flags.size(), 0.0);
        std::vector<double> magnitudes;
        for (std::size_t i = 1; i + 1 < flags.size(); ++i) {
            const double part =
                (data.abscissa[i] - data.abscissa[i - 1]) / (data.abscissa[i + 1] - data.abscissa[i - 1]);
            const double between = (1.0 - part) * column.values[i - 1] + part * column.values[i + 1];
            distances[i] = std::isnan(column.values[i] - between) ? 0.0 : column.values[i] - between;
            magnitudes.push_back(std::abs(distances[i]));
        }
        const double far = std::max(kFar * medianOf(std::move(magnitudes)), kLeastPart * column.spread);
        for (std::size_t i = 1; i + 1 < flags.size(); ++i) {
            const bool isPeak = std::abs(distances[i]) >= std::abs(distances[i - 1]) &&
                                std::abs(distances[i]) >= std::abs(distances[i + 1]);
            if (tellsShape(column) && isPeak && std::abs(distances[i]) > far) {
                flags[i] = true;
            }
        }
    }
    return mayBeExcluded(std::ranges::count(flags, true), flags.size()) ? flags
                                                                        : std::vector<bool>(flags.size(), false);
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
        std::vector<double> magnitudes;
        magnitudes.reserve(flags.size());
        for (const double residual : fit.residuals[j]) {
            if (!std::isnan(residual)) {
                magnitudes.push_back(std::abs(residual));
            }
        }
        const double scale = kOfNormal * medianOf(std::move(magnitudes));
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
    return fitCandidate(last, std::move(hypothesis));
}

/// Extends the best candidates of the window to the whole file.
std::vector<Candidate> inWholeFile(const Observations &all, const Observations &window, const Observations &last,
                                   std::span<const Candidate> candidates, const std::stop_token &stop)
{
    constexpr std::size_t kMost = 6;
    if (window.abscissa.size() == last.abscissa.size()) {
        return {candidates.begin(), candidates.end()};
    }
    std::vector<Candidate> whole;
    for (const Candidate &candidate : candidates.first(std::min(kMost, candidates.size()))) {
        if (Candidate one = extended(all, window, last, candidate); one.exists() && !stop.stop_requested()) {
            one.price = candidate.price; // includes the preference for the given mechanism
            whole.push_back(std::move(one));
        }
    }
    std::ranges::stable_sort(whole, isBetter);
    return whole;
}

/// Searches a file after its outliers were removed.
std::vector<Candidate> searchRest(const Observations &rest, const Observations &last, const Parameters &given,
                                  const std::stop_token &stop)
{
    const Observations window = searchWindow(rest);
    return inWholeFile(rest, window, last, searchCandidates(window, given, stop), stop);
}

bool isIdentified(const FileSearch &search)
{
    return !search.candidates.empty() && search.candidates.front().acceptance == Acceptance::Identified;
}

/// Whether each flagged row has a residual several times as large as all other rows of its column, and is neither the
/// first nor the last. Systematic residuals follow no distribution, so that a smaller one may be a good reading, and
/// filters distort the ends of a file.
bool areFarAway(const Observations &data, const Candidate &candidate, const std::vector<bool> &flags)
{
    constexpr double kTimes = 4.0;
    const Fit fit = evaluateHypothesis(data, candidate.hypothesis);
    std::vector<bool> isFar(flags.size(), false);
    for (const std::vector<double> &residuals : fit.residuals) {
        double largest = 0.0;
        for (std::size_t i = 0; i < flags.size(); ++i) {
            largest = flags[i] || std::isnan(residuals[i]) ? largest : std::max(largest, std::abs(residuals[i]));
        }
        for (std::size_t i = 0; i < flags.size(); ++i) {
            isFar[i] = isFar[i] || std::abs(residuals[i]) > kTimes * largest;
        }
    }
    return isFar == flags && !flags.front() && !flags.back();
}

/// Excludes the rows that are outliers of the best candidate, in several rounds because they bias its fit. Returns
/// whether the other rows are explained; if not, changes nothing.
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
        if (found == flags || !mayBeExcluded(std::ranges::count(found, true), found.size())) {
            break;
        }
        flags = std::move(found);
        Candidate refitted = fitCandidate(finalRows(without(all, flags)), nearest.hypothesis);
        if (!refitted.exists()) {
            return false;
        }
        nearest = std::move(refitted);
    }
    const Acceptance before = search.candidates.front().acceptance;
    if (flags.empty() || nearest.acceptance == Acceptance::Rejected || nearest.acceptance > before ||
        (nearest.acceptance == before && before != Acceptance::Identified) ||
        (nearest.acceptance == Acceptance::Approximate && !areFarAway(all, nearest, flags))) {
        return false;
    }
    const Observations rest = without(all, flags);
    search.data = finalRows(rest);
    search.candidates = searchRest(rest, search.data, given, stop);
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
    FileSearch search;
    const Observations window = searchWindow(all);
    search.data = finalRows(all);
    const std::vector<bool> suspicious = suspiciousRows(window);
    const bool isSuspicious = std::ranges::count(suspicious, true) > 0;
    search.candidates = inWholeFile(all, window, search.data, searchCandidates(window, given, stop), stop);
    if (isIdentified(search)) {
        if (search.data.abscissa.size() < all.abscissa.size()) {
            excludeOutliers(all, given, stop, search);
        }
        return search;
    }
    if (isSuspicious) { // bad readings may have prevented the search from finding the motion
        FileSearch cleaned = search;
        const Observations rest = without(window, suspicious);
        const bool isWhole = window.abscissa.size() == all.abscissa.size();
        cleaned.candidates =
            inWholeFile(all, rest, isWhole ? rest : search.data, searchCandidates(rest, given, stop), stop);
        if (excludeOutliers(all, given, stop, cleaned)) {
            return cleaned;
        }
    }
    excludeOutliers(all, given, stop, search);
    return search;
}

} // namespace slidercrank
