// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/file_layout.h"

#include <algorithm>

namespace slidercrank
{

bool FileLayout::isGuessed() const
{
    return std::ranges::any_of(columns, isGuess, &FileColumn::reason);
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
