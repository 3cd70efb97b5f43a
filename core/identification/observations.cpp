// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/observations.h"

#include "core/comparison/comparison.h"
#include "core/identification/convention.h"
#include "core/identification/even_grid.h"
#include "core/import/clock.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// Whether the channel tells nothing about the mechanism: it is zero in every mechanism, or it is α2, which belongs to
/// the drive. (The acceleration of a run-up is found from θ2.)
bool isUninformative(Channel channel)
{
    const Coordinate coordinate = channel.coordinate;
    const bool belongsToGround = coordinate == R1x || coordinate == R1y || coordinate == Theta1;
    return belongsToGround || coordinate == Theta4 || (coordinate == R4y && channel.order != Order::Position) ||
           channel == Channel{Theta2, Order::Acceleration};
}

/// Whether the file states the unit of a column.
bool statesUnit(const FileLayout &layout, Channel channel)
{
    return std::ranges::any_of(layout.columns, [&](const FileColumn &column) {
        return column.role == ColumnRole::Channel && column.channel == channel && !column.unit.empty();
    });
}

/// Half of the rounding step of the value in each of `rows`, in mm or rad. `values`: all values, in mm or °; `unit`:
/// the size of this unit in mm or rad; `size`: the largest magnitude of the values, in mm or rad, or 0 if all are zero.
/// Zeros do not show their rounding, so that a step is assumed for them.
Values computeHalfSteps(const std::vector<double> &values, const Rounding &rounding, const Indices &rows, double unit,
                        double size)
{
    constexpr double kStepOfZeros = 1e-3; // mm or rad
    if (!(size > 0.0)) {
        return Values::Constant(std::ssize(rows), 0.5 * kStepOfZeros);
    }
    Values halfSteps(std::ssize(rows));
    for (Index i = 0; i < halfSteps.size(); ++i) {
        halfSteps[i] = 0.5 * rounding.stepAt(values[rows[i]]) * unit;
    }
    // Finer digits mean nothing beside the coarsest ones of the column, or are errors of the arithmetic of a program.
    const double leastBesideCoarsest = kSmallestFractionOfLargestStep * halfSteps.maxCoeff();
    const double leastOfArithmetic = 0.5 * kArithmeticStep * size;
    return halfSteps.max(std::max(leastBesideCoarsest, leastOfArithmetic));
}

/// Reads a column in mm or rad, without jumps by whole turns.
ObservedColumn readColumn(const ReferenceData &data, const ReferenceSeries &series, const Indices &rows)
{
    const bool isAnAngle = isAngle(series.channel.coordinate);
    const double unit = isAnAngle ? 1.0 / kDegreesPerRadian : 1.0;
    std::vector<double> values(rows.size());
    std::ranges::transform(rows, values.begin(), [&](Index row) { return series.values[row] * unit; });
    const bool hadJumps = isAnAngle && series.channel.order == Order::Position && removeJumps(values, kTurn);
    const ValueRange range = rangeOf(values);
    ObservedColumn column{
        .channel = series.channel, .statesUnit = statesUnit(data.layout, series.channel), .hadJumps = hadJumps};
    column.range = range.count > 0 ? range.width() : 0.0;
    column.values = Eigen::Map<const Values>(values.data(), std::ssize(values));
    column.setHalfSteps(computeHalfSteps(series.values, series.rounding, rows, unit, range.size()));
    return column;
}

/// Sets the range of a column to 0 if it changes by no more than its rounding, or by no more than the rounding errors
/// of the program that computed it. The rounding steps of such a column become at least as large as these errors.
/// `span`: the span of the abscissa.
void flattenIfConstant(ObservedColumn &column, double span)
{
    // mm or rad: a program that computes a constant position changes it by no more than this. Divided by the n-th power
    // of the span, it limits the n-th derivative.
    constexpr double kMaxArithmeticChange = 1e-8;
    const double maxChange = kMaxArithmeticChange / std::pow(span, static_cast<double>(column.channel.order));
    const double rootMeanSquareStep = std::sqrt(12.0 * column.variance);
    if (column.range <= rootMeanSquareStep || column.range <= maxChange) {
        column.range = 0.0;
        column.setHalfSteps(column.halfSteps.max(maxChange));
    }
}

/// The rows with a value in any informative column. They must also have a value of θ2 if the file has a column θ2 in
/// which more than half of the values are present.
Indices rowsWithValues(const ReferenceData &data)
{
    const ReferenceSeries *const crank = data.find(kCrankAngle);
    const auto isKnown = [](double value) { return std::isfinite(value); };
    const bool needsAngle = crank && 2 * std::ranges::count_if(crank->values, isKnown) > std::ssize(data.time);
    const auto hasValue = [&](Index row) {
        return std::ranges::any_of(data.series, [&](const ReferenceSeries &series) {
            return isKnown(series.values[row]) && !isUninformative(series.channel);
        });
    };
    Indices rows;
    rows.reserve(data.time.size());
    for (Index row = 0; row < std::ssize(data.time); ++row) {
        const bool lacksAngle = needsAngle && !isKnown(crank->values[row]);
        if (!lacksAngle && hasValue(row)) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Reads the time stamps of a file (s), or the angles of a table over the crank angle (°), in some rows. Those that are
/// evenly spaced as printed are taken as exact (clock.h). Those that are evenly spaced within their rounding are
/// replaced by a grid; their half step remains, because a program may have computed its values at the printed ones (see
/// withBestAbscissa()).
Abscissa readAbscissa(const std::vector<double> &stamps, const Rounding &rounding, const Indices &rows, double whole)
{
    const TimePrecision clock = timePrecisionOf(stamps, rounding);
    const Values printed = Eigen::Map<const Values>(stamps.data(), std::ssize(stamps));
    if (!clock.isRoundedGrid) {
        return {.values = printed(rows), .halfStep = 0.5 * clock.roundingStep()};
    }
    const auto halfStep = [&](double stamp) { return 0.5 * rounding.stepAt(stamp); };
    const EvenGrid grid = findEvenGrid(printed, printed.unaryExpr(halfStep), clock.gridNumbers, whole);
    return {.values = grid.values(rows),
            .printed = printed(rows),
            .halfStep = 0.5 * clock.roundingStep(),
            .startMargin = grid.startMargin,
            .durationMargin = grid.durationMargin};
}

/// Reads the time stamps of a file over the time.
void observeTime(Observations &observations, const ReferenceData &data)
{
    constexpr double kSecond = 1.0;
    Abscissa &time = observations.time;
    time = readAbscissa(data.time, data.timeRounding, observations.rows, kSecond);
    observations.timeOrigin = 0.5 * (time.values[0] + time.values[observations.size() - 1]);
    time.values -= observations.timeOrigin;
    time.printed -= observations.timeOrigin;
}

/// Whether too many rows are too far apart to show how many turns the crank makes, and in which direction. Half a turn
/// between two rows hides the direction; a quarter of a turn leaves a margin. `angle`: rad, without jumps.
bool hidesTurns(const Values &angle)
{
    const Index pairs = angle.size() - 1;
    return ((angle.tail(pairs) - angle.head(pairs)).abs() > kQuarterTurn).cast<double>().mean() > kMaxOutlierFraction;
}

/// Continues the angle of the crank at its usual speed across gaps in time, in which the crank may have made turns that
/// no row shows.
void countTurnsInGaps(Values &angle, const Values &time)
{
    constexpr double kMinGap = 1.5; // in units of the usual time between two rows
    const Index pairs = angle.size() - 1;
    const Values durations = time.tail(pairs) - time.head(pairs);
    const Values advances = angle.tail(pairs) - angle.head(pairs);
    const double usualDuration = median(durations);
    const double usualSpeed = median(advances / durations);
    double turns = 0.0;
    for (Index i = 0; i < pairs; ++i) {
        if (durations[i] > kMinGap * usualDuration) {
            turns += std::rint((usualSpeed * durations[i] - advances[i]) / kTurn);
        }
        angle[i + 1] += kTurn * turns;
    }
}

/// Reads the abscissa of a table over the crank angle.
void observeTableAngle(Observations &observations, const CrankAngles &crank)
{
    constexpr double kTurnInDegrees = 360.0;
    Abscissa &angle = observations.angle;
    angle = readAbscissa(crank.degrees, crank.rounding, observations.rows, kTurnInDegrees);
    angle.values /= kDegreesPerRadian;
    angle.printed /= kDegreesPerRadian;
    angle.halfStep /= kDegreesPerRadian;
    angle.startMargin /= kDegreesPerRadian;
    angle.durationMargin /= kDegreesPerRadian;
}

/// Whether somebody has chosen the angles and computed the other columns from them: they are evenly spaced, and each is
/// a multiple of a half or a third of their distance, as 30°, 45°, 60° or 105°, 115°, 125°.
bool areChosen(const Values &angle)
{
    constexpr double kPartsOfDistance = 6.0; // so that halves and thirds are whole numbers of parts
    if (angle.size() < 2) {
        return false;
    }
    const double distance = angle[1] - angle[0];
    const Values parts = angle * (kPartsOfDistance / distance);
    const Values advances = (angle.tail(angle.size() - 1) - angle.head(angle.size() - 1)) / distance;
    return (parts - parts.round()).abs().maxCoeff() < kArithmeticError &&
           (advances - 1.0).abs().maxCoeff() < kArithmeticError;
}

/// Reads θ2 of a file over the time. It is not used if a row lacks it, or if the rows do not show how many turns the
/// crank makes.
void observeAngleColumn(Observations &observations, const ReferenceData &data)
{
    const ReferenceSeries *const crank = data.find(kCrankAngle);
    if (!crank) {
        return;
    }
    const ObservedColumn column = readColumn(data, *crank, observations.rows);
    if (!column.values.isFinite().all() || hidesTurns(column.values)) {
        return;
    }
    Abscissa &angle = observations.angle;
    angle.values = column.values;
    angle.halfStep = column.halfSteps.maxCoeff();
    if (areChosen(column.values)) { // exact, apart from the motion during half a rounding step of the time
        const double motionInHalfStep = observations.time.halfStep / observations.span() * column.range;
        angle.halfStep = std::min(angle.halfStep, motionInHalfStep + kArithmeticError * column.range);
    }
    countTurnsInGaps(angle.values, observations.time.values);
}

/// The observations in some of their rows.
Observations withRows(const Observations &observations, const Indices &rows)
{
    Observations selected = observations;
    selected.rows.resize(rows.size());
    std::ranges::transform(rows, selected.rows.begin(), [&](Index row) { return observations.rows[row]; });
    for (Abscissa *abscissa : {&selected.time, &selected.angle}) {
        for (Values *values : {&abscissa->values, &abscissa->printed}) {
            *values = values->size() > 0 ? Values((*values)(rows)) : Values();
        }
    }
    for (std::size_t k = 0; k < observations.columns.size(); ++k) {
        selected.columns[k].values = observations.columns[k].values(rows);
        selected.columns[k].halfSteps = observations.columns[k].halfSteps(rows);
    }
    return selected;
}

/// The distance of each value from the median of the seven values around it, itself included; NaN in a gap. 0 if there
/// are fewer values.
Values distancesFromNeighbours(const Values &values)
{
    constexpr Index kWindow = 7; // rows: a value and three on either side
    Values distances = Values::Zero(values.size());
    if (values.size() < kWindow) {
        return distances;
    }
    for (Index i = 0; i < values.size(); ++i) {
        std::array<double, kWindow> window;
        const Index first = std::clamp<Index>(i - kWindow / 2, 0, values.size() - kWindow);
        const auto end = std::copy_if(values.data() + first, values.data() + first + kWindow, window.begin(),
                                      [](double value) { return std::isfinite(value); });
        const auto middle = window.begin() + (end - window.begin()) / 2;
        std::nth_element(window.begin(), middle, end);
        distances[i] = end == window.begin() ? kNone : std::abs(values[i] - *middle);
    }
    return distances;
}

} // namespace

Observations observe(const ReferenceData &data, std::stop_token stop)
{
    Observations observations;
    observations.stop = std::move(stop);
    observations.lengthUnit = findLengthUnit(data);
    observations.rows = rowsWithValues(data);
    if (observations.rows.empty()) {
        return observations;
    }
    if (data.crank) { // a table over the crank angle: its time stamps were computed from θ2
        observeTableAngle(observations, *data.crank);
    } else {
        observeTime(observations, data);
        observeAngleColumn(observations, data);
    }
    for (const ReferenceSeries &series : data.series) {
        if (isUninformative(series.channel) || series.channel == kCrankAngle) {
            continue; // observeAngleColumn() has read θ2, or left it out
        }
        ObservedColumn column = readColumn(data, series, observations.rows);
        flattenIfConstant(column, observations.span());
        if (column.values.isFinite().any()) {
            observations.columns.push_back(std::move(column));
        }
    }
    return observations;
}

Observations selectRows(const Observations &observations, Index count)
{
    constexpr double kGoldenSection = 0.6180339887498949; // its multiples are spread evenly and irregularly
    if (observations.size() <= count) {
        return observations;
    }
    const double stride = static_cast<double>(observations.size()) / static_cast<double>(count);
    Indices rows;
    for (double k = 0.0; k < static_cast<double>(count); k += 1.0) {
        rows.push_back(static_cast<Index>((k + std::fmod(kGoldenSection * k, 1.0)) * stride));
    }
    return withRows(observations, rows);
}

double findLengthUnit(const ReferenceData &data)
{
    std::optional<double> unit;
    for (const ReferenceSeries &series : data.series) {
        if (isAngle(series.channel.coordinate)) {
            continue;
        }
        const double factor = series.rounding.unitFactor;
        if (std::abs(factor / unit.value_or(factor) - 1.0) > kArithmeticError) {
            return 1.0;
        }
        unit = factor;
    }
    return unit.value_or(1.0);
}

double median(const Values &values)
{
    std::vector<double> finite;
    finite.reserve(static_cast<std::size_t>(values.size()));
    std::ranges::copy_if(values, std::back_inserter(finite), [](double value) { return std::isfinite(value); });
    const auto middle = finite.begin() + std::ssize(finite) / 2;
    std::ranges::nth_element(finite, middle);
    return finite.empty() ? 0.0 : *middle;
}

Observations withoutSpikes(Observations observations)
{
    constexpr double kMaxDeviation = 12.0;    // times the usual distance from the median of the window: not a motion
    constexpr double kFractionOfSpread = 0.3; // of the column: a smaller deviation does not mislead the search
    for (ObservedColumn &column : observations.columns) {
        const Values distances = distancesFromNeighbours(column.values);
        const double spread = median((column.values - median(column.values)).abs());
        const double limit = std::max(kMaxDeviation * median(distances), kFractionOfSpread * spread);
        column.values = (distances > limit).select(kNone, column.values);
    }
    return observations;
}

} // namespace slidercrank
