// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A cell that should hold a number, of any form that programs write: the number, a gap, or why it is neither.

#include "core/reading/read_fault.h"

#include <limits>
#include <optional>
#include <string_view>

namespace slidercrank
{

struct CellNumber {
    double value = std::numeric_limits<double>::quiet_NaN(); ///< NaN: a gap, or a fault
    std::string_view digits;                                 ///< as printed; empty for a gap
    std::optional<RowFault> fault;
};

/// `text`: the cell without what stands around it. An empty cell and "nan" are gaps.
CellNumber readNumber(std::string_view text, DecimalSign decimalSign);

/// Whether the cell could be a number by its letters, whatever its decimal sign.
bool looksNumeric(std::string_view text);

bool equalIgnoringCase(std::string_view text, std::string_view lowerCase);

} // namespace slidercrank
