// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What each column of a table is: by a person's choice, by its name, and where that does not tell, by a guess that its
// unit and values have to bear out. What cannot be told is left out, with the reason.

#include "core/import/heading.h"
#include "core/import/read_fault.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace slidercrank
{

/// Numbers from all over a table, in the file's units and order: by column, then by row; NaN where there is none.
using ColumnSamples = std::vector<std::vector<double>>;

struct ColumnUse {
    ColumnRole role = ColumnRole::Ignored;
    Channel channel;
    ColumnReason reason = ColumnReason::UnknownName;
    std::optional<std::size_t> otherColumn;
    double factor = 1.0; ///< to the author's unit; of the time: units in a second
};

/// A column that cannot be used as its name, or a person, says.
struct ColumnFault {
    std::size_t column = 0;
    ReadFault fault;
};

/// `sample` is asked only where names do not tell.
std::variant<std::vector<ColumnUse>, ColumnFault> assignColumns(std::span<const Heading> headings,
                                                                std::span<const ColumnChoice> choices,
                                                                const std::function<ColumnSamples()> &sample);

} // namespace slidercrank
