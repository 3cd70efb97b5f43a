// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_values.h"

#include "core/import/value_sequence.h"

#include <algorithm>
#include <utility>

namespace slidercrank
{

bool isConstant(const RawColumn &column)
{
    constexpr std::size_t kMinValues = 3;
    const ValueRange range = rangeOf(column.values);
    return range.count >= kMinValues && range.width() == 0.0;
}

bool isSingleValue(const RawColumn &column)
{
    return column.values.size() >= kMinConclusiveRows && rangeOf(column.values).count == 1;
}

bool countsRows(const RawColumn &column)
{
    const std::vector<double> values = column.finiteValues();
    const double first = values.empty() ? kNone : values[0];
    bool counts = first == 0.0 || first == 1.0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        counts = counts && values[row] == first + static_cast<double>(row);
    }
    return counts;
}

bool isTurningAngle(const RawColumn &column)
{
    constexpr double kTurn = 360.0;
    const std::optional<Unit> unit = column.unitAs(ColumnRole::CrankAngle);
    const std::vector<double> angles =
        unit ? unwrapped(column.finiteValues(), kTurn / unit->factor) : std::vector<double>();
    return rangeOf(angles).width() > 0.0 && !findReversal(angles);
}

bool makesHalfTurn(const RawColumn &column)
{
    const std::optional<Unit> unit = column.unitAs(ColumnRole::CrankAngle);
    std::vector<double> degrees = unit ? column.finiteValues() : std::vector<double>();
    std::ranges::for_each(degrees, [&](double &value) { value = unit->toDefault(value); });
    return angularWidth(std::move(degrees)) > kLargestSwing;
}

bool isNearlyConstant(const RawColumn &column)
{
    constexpr double kMaxVariation = 0.01; // of the largest value
    const ValueRange range = rangeOf(column.values);
    return range.count >= kMinConclusiveRows && range.size() > 0.0 && range.width() <= kMaxVariation * range.size();
}

} // namespace slidercrank
