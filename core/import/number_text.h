// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A cell that should hold a number, of any form that programs write: the number, a gap, or why it is neither.

#include "core/import/read_fault.h"

#include <limits>
#include <optional>
#include <string_view>

namespace slidercrank
{

struct CellNumber {
    double value = std::numeric_limits<double>::quiet_NaN(); ///< NaN: a gap, or a fault
    std::string_view digits;                                 ///< as printed, maybe without sign; empty for a gap
    std::optional<RowFault> fault;
};

/// `text`: the cell without what stands around it. An empty cell and "nan" are gaps. A minus may be the typographer's.
CellNumber readNumber(std::string_view text, DecimalSign decimalSign);

/// A cell that holds a number with its unit, "0.005 sec": where they part.
struct NumberWithUnit {
    std::string_view number;
    std::string_view unit;
};

/// Nothing where there is no unit, or none that is known.
std::optional<NumberWithUnit> numberWithUnit(std::string_view text);

/// The cell without that unit, if it has it.
std::string_view withoutUnit(std::string_view text, std::string_view unit);

/// Whether the cell could be a number by its letters, whatever its decimal sign.
bool looksNumeric(std::string_view text);

bool equalIgnoringCase(std::string_view text, std::string_view lowerCase);

} // namespace slidercrank
