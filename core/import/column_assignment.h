// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third stage of reading: what each column of a table is. A person's choice decides first, then the name of a channel,
// then words that say body and quantity, and last a quantity of the body that is usually exported, where unit and
// values do not contradict it. The column with the best evidence becomes the channel; between equals a person has to
// choose.

#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace slidercrank
{

struct ColumnAssignment {
    ColumnRole role = ColumnRole::Ignored;
    Channel channel;
    ColumnReason reason = ColumnReason::UnknownName;
    std::optional<std::size_t> otherColumn;

    /// Of a channel: to the author's unit. Of the time: divides, so that 5 ms are 0.005 s to the last bit; of the crank
    /// angle: divides, too, to degrees.
    double factor = 1.0;
};

/// A column that cannot be used as its name, or a person, says.
struct ColumnFault {
    std::size_t column = 0;
    ReadFault fault;
};

/// By column, then by row, in the file's units; NaN where there is no number.
using Columns = std::vector<std::vector<double>>;

/// `values`: some rows from all over the table.
std::variant<std::vector<ColumnAssignment>, ColumnFault>
assignColumns(std::span<const Heading> headings, std::span<const ColumnChoice> choices, const Columns &values);

/// The factor to the author's unit; 1 without a unit, nothing where the unit does not suit.
std::optional<double> factorTo(Channel channel, const std::string &unitText);

} // namespace slidercrank
