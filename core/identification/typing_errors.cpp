// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/typing_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// The fourth differences of equally spaced values, which are small for smooth curves. An error of one value adds it,
/// multiplied by these numbers, to five of them.
constexpr std::array kFourthDifference{1.0, -4.0, 6.0, -4.0, 1.0};

/// An error of one value, and how much of the squares of the fourth differences around it this error explains.
struct PossibleError {
    double error = 0.0;
    double explained = 0.0;
};

/// The error of a value that explains the fourth differences around it best, by least squares. Differences that contain
/// a gap do not count.
PossibleError fitError(const std::vector<double> &values, std::size_t row)
{
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t place = 0; place < kFourthDifference.size(); ++place) { // of the value in the difference
        if (row < place || row - place + kFourthDifference.size() > values.size()) {
            continue;
        }
        double difference = 0.0;
        for (std::size_t i = 0; i < kFourthDifference.size(); ++i) {
            difference += kFourthDifference[i] * values[row - place + i];
        }
        if (std::isfinite(difference)) {
            sum += kFourthDifference[place] * difference;
            weight += kFourthDifference[place] * kFourthDifference[place];
        }
    }
    return weight > 0.0 ? PossibleError{sum / weight, sum * sum / weight} : PossibleError{};
}

std::vector<PossibleError> fitErrors(const std::vector<double> &values)
{
    std::vector<PossibleError> errors(values.size());
    for (std::size_t row = 0; row < values.size(); ++row) {
        errors[row] = fitError(values, row);
    }
    return errors;
}

/// The row of a column that may contain a typing error; nullopt if no value is far from its neighbours.
std::optional<std::size_t> findSuspiciousRow(std::vector<double> values)
{
    constexpr double kSuspicion = 6.0; // times the median of the other errors: few curves without an error reach it
    std::vector<PossibleError> errors = fitErrors(values);
    const auto largest = std::ranges::max_element(errors, {}, &PossibleError::explained);
    const std::size_t row = static_cast<std::size_t>(largest - errors.begin());
    const double error = std::abs(largest->error);
    values[row] -= largest->error; // which has also changed the errors of its neighbours
    errors = fitErrors(values);
    const auto magnitude = [](const PossibleError &possible) { return std::abs(possible.error); };
    const auto median = errors.begin() + std::ssize(errors) / 2;
    std::ranges::nth_element(errors, median, {}, magnitude);
    return error > kSuspicion * magnitude(*median) ? std::optional(row) : std::nullopt;
}

} // namespace

std::vector<std::size_t> findSuspiciousRows(const ReferenceData &data)
{
    constexpr std::size_t kMinRows = 9;   // with fewer, five fourth differences are most of them
    constexpr std::size_t kMaxRows = 400; // nobody types more
    std::vector<std::size_t> rows;
    if (data.time.size() < kMinRows || data.time.size() > kMaxRows) {
        return rows;
    }
    for (const ReferenceSeries &series : data.series) {
        const std::optional<std::size_t> row = findSuspiciousRow(series.values);
        if (row && std::ranges::find(rows, *row) == rows.end()) {
            rows.push_back(*row);
        }
    }
    return rows;
}

ReferenceData withoutRow(ReferenceData data, std::size_t row)
{
    for (ReferenceSeries &series : data.series) {
        series.values[row] = std::numeric_limits<double>::quiet_NaN();
    }
    return data;
}

} // namespace slidercrank
