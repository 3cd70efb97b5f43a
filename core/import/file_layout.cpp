// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/file_layout.h"

#include <algorithm>

namespace slidercrank
{

bool FileLayout::isGuessed() const
{
    return std::any_of(columns.begin(), columns.end(), [](const FileColumn &column) { return isGuess(column.reason); });
}

bool FileLayout::isOpen() const
{
    const auto isUsedAs = [this](ColumnRole role) { return std::ranges::count(columns, role, &FileColumn::role) > 0; };
    const bool hasInstants = isUsedAs(ColumnRole::Time) || isUsedAs(ColumnRole::CrankAngle);
    return hasInstants && std::ranges::any_of(columns, [&](const FileColumn &column) {
               return column.reason == ColumnReason::LikeOther
                          ? columns[*column.otherColumn].role == ColumnRole::Ignored
                          : leavesOpen(column.reason) && !isUsedAs(ColumnRole::Channel);
           });
}

std::optional<Unit> parseColumnUnit(const std::string &text, ColumnRole role, Channel channel)
{
    const bool isOfAngle = role == ColumnRole::CrankAngle || isAngle(channel.coordinate);
    Unit expected{isOfAngle ? Dimension::Angle : Dimension::Length};
    expected.dimension = role == ColumnRole::Time ? Dimension::Time : expected.dimension;
    expected.order = role == ColumnRole::Channel ? static_cast<int>(channel.order) : 0;
    const std::optional<Unit> unit = text.empty() ? expected : parseUnit(text);
    const bool suits = unit && unit->dimension == expected.dimension && unit->order == expected.order;
    return suits && role != ColumnRole::Ignored ? unit : std::nullopt;
}

} // namespace slidercrank
