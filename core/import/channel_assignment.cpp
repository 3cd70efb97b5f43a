// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/channel_assignment.h"

#include "core/import/column_values.h"
#include "core/import/crank_angles.h"
#include "core/import/unnamed_bodies.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;
using Kind = NameMeaning::Kind;
using Values = std::vector<double>;

/// Returns whether the coordinate is the same in every position of the mechanism.
bool isFixed(Coordinate coordinate)
{
    return coordinate == R1x || coordinate == R1y || coordinate == Theta1 || coordinate == Theta4 || coordinate == R4y;
}

/// Removes columns that contain more words than numbers, unless all candidates do. Keeps columns whose heading is the
/// exact name of a channel, or which a person chose: they lead to an error message.
void removeWords(std::vector<RawColumn *> &candidates)
{
    const auto isMostlyNumbers = [](const RawColumn *column) {
        const auto words = std::ranges::count_if(column->values, [](double value) { return std::isinf(value); });
        return words <= static_cast<std::ptrdiff_t>(rangeOf(column->values).count);
    };
    if (std::ranges::any_of(candidates, isMostlyNumbers)) {
        removeColumns(candidates, ColumnReason::MoreWords, [&](const RawColumn &column) {
            return column.meaning.kind < Kind::ChannelName && !isMostlyNumbers(&column);
        });
    }
}

/// Returns the rounding step of a column at its largest value.
double largestStep(const RawColumn &column)
{
    return column.rounding.infer(column.factor, RoundingObserver::Content::Quantity)
        .stepAt(rangeOf(column.values).size());
}

/// Returns whether the values of all rows differ by no more than a tolerance. Rows without a value in one of the
/// columns count as equal.
bool areEqual(const Values &x, const Values &y, double tolerance)
{
    return std::ranges::equal(
        x, y, [&](double a, double b) { return std::abs(a - b) <= tolerance || !std::isfinite(a - b); });
}

/// Returns whether `column` repeats the values of `other` in a different unit, up to its own rounding, which is
/// coarser. Of two with the same rounding, the second one is the copy.
bool isCoarserCopy(const RawColumn &column, const RawColumn &other)
{
    const double step = largestStep(column);
    const double otherStep = largestStep(other);
    const bool isCoarser = step > otherStep || (step == otherStep && column.index > other.index);
    return isCoarser && column.factor != other.factor && column.values.size() >= 2 &&
           areEqual(column.values, other.values, step);
}

/// Returns whether the abscissa is a crank angle and the column is another one: its channel is θ2; or it has the same
/// heading as the abscissa, and its own values, after jumps by whole turns are removed, never reverse.
bool isSecondCrankAngle(RawTable &table, const RawColumn &column)
{
    const RawColumn *const abscissa = table.abscissa();
    if (!abscissa || abscissa->use.role != ColumnRole::CrankAngle) {
        return false;
    }
    const bool isLikeAbscissa =
        column.use.heading == abscissa->use.heading && !findReversal(unwrapped(column.finiteValues()));
    return column.use.channel == kCrankAngle || isLikeAbscissa;
}

/// Returns whether a column that is a length of an unnamed body by its name may contain row numbers: it has no unit and
/// counts the rows.
bool mayBeRowNumbers(const RawColumn &column)
{
    const bool isUncertainLength = column.meaning.kind == Kind::Quantity && !isAngle(column.use.channel.coordinate);
    return isUncertainLength && column.use.unit.empty() && countsRows(column);
}

/// Removes the candidates that another one makes superfluous: "Position (in)" repeats "Position (mm)", and "Pos" counts
/// the rows beside "Slider mm".
void removeRepeated(std::vector<RawColumn *> &candidates)
{
    const std::vector<RawColumn *> rivals = candidates;
    const auto hasRival = [&rivals](const RawColumn &column, const auto &condition) {
        return std::ranges::any_of(rivals, [&](const RawColumn *other) {
            return other != &column && other->use.channel == column.use.channel && condition(*other);
        });
    };
    removeColumns(candidates, ColumnReason::LikeOther, [&](const RawColumn &column) {
        return hasRival(column, [&](const RawColumn &other) { return isCoarserCopy(column, other); });
    });
    removeColumns(candidates, ColumnReason::RowNumber, [&](const RawColumn &column) {
        return mayBeRowNumbers(column) && hasRival(column, [](const RawColumn &) { return true; });
    });
}

/// Converts the coupler's angle at B, which Norton calls θ3, to the one at A. They differ by half a turn, which is
/// subtracted if the middle of the angles is above 90°, and added otherwise. Removes jumps by whole turns.
void measureAtA(RawColumn &column)
{
    constexpr double kHalfTurn = 180.0;
    column.values = unwrapped(std::move(column.values));
    const ValueRange range = rangeOf(column.values);
    column.origin = range.low + range.high > kHalfTurn ? kHalfTurn : -kHalfTurn;
    std::ranges::for_each(column.values, [&column](double &value) { value -= column.origin; });
}

/// Returns the columns that could be channels according to their names and units, in the default unit and with the
/// channel that they would be. Sets the reason of columns with unsuitable units. Throws if the unit of a column with
/// the exact name of a channel is unsuitable.
std::vector<RawColumn *> findCandidates(RawTable &table)
{
    std::vector<RawColumn *> candidates;
    for (RawColumn &column : table.columns) {
        const NameMeaning &meaning = column.meaning;
        if (!column.isUndecided() || meaning.kind < Kind::Quantity) {
            continue;
        }
        const std::optional<Unit> unit = column.unitAs(ColumnRole::Channel, meaning.channel);
        if (!unit && meaning.kind >= Kind::ChannelName) {
            throw errorAtHeading(table, column, {Fault::UnknownUnit, meaning.channel});
        }
        if (!unit) {
            column.use.reason = ColumnReason::UnknownUnit;
            continue;
        }
        convert(column, *unit);
        column.use.channel = meaning.channel;
        if (meaning.isAtB) {
            measureAtA(column);
        }
        if (isFixed(meaning.channel.coordinate)) { // its values are known, so that no row is skipped because of them
            std::ranges::replace_if(
                column.values, [](double value) { return std::isinf(value); }, kNone);
        }
        candidates.push_back(&column);
    }
    return candidates;
}

/// Uses a candidate as its channel, unless another candidate may be the same channel with evidence that is at least as
/// good: then it is ignored. Throws if both have the exact name of the channel, or were chosen.
void assignChannel(const RawTable &table, RawColumn &column, const std::vector<RawColumn *> &candidates)
{
    const auto *const rival = findElement(candidates, [&](const RawColumn *other) {
        return other != &column && other->use.channel == column.use.channel &&
               compareEvidence(other->meaning, column.meaning) >= 0;
    });
    const Kind evidence = column.meaning.kind;
    if (!rival) {
        column.use.role = ColumnRole::Channel;
        column.use.reason = column.meaning.reason;
    } else if (evidence >= Kind::ChannelName && (*rival)->meaning.kind == evidence) {
        throw sameChannelError(table, column, **rival);
    } else {
        column.use.reason = ColumnReason::LikeOther;
    }
}

} // namespace

ReadError sameChannelError(const RawTable &table, const RawColumn &first, const RawColumn &second)
{
    const Channel channel = first.use.channel;
    return first.use.file == second.use.file
               ? errorAtHeading(table, second, {Fault::ChannelTwice, channel})
               : ReadError{.fault = {Fault::ChannelInBoth, channel, table.fileOf(first).name}, .file = second.use.file};
}

void assignChannels(RawTable &table)
{
    std::vector<RawColumn *> candidates = findCandidates(table);
    removeWords(candidates);
    removeRepeated(candidates);
    assignBodies(table, candidates);
    removeColumns(candidates, ColumnReason::LikeOther,
                  [&table](const RawColumn &column) { return isSecondCrankAngle(table, column); });
    for (RawColumn *const column : candidates) {
        assignChannel(table, *column, candidates);
    }
}

} // namespace slidercrank
