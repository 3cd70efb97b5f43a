// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Explains, in the current language, why a file or a row cannot be read.

#include "core/import/reference_data.h"

#include <QString>

#include <vector>

namespace slidercrank
{

/// Returns a sentence that explains the fault and how to correct it.
QString faultText(const ReadFault &fault);

/// Returns the options of the command line that make these choices: --column "Theta=theta2". Empty without choices.
QString optionText(const std::vector<ColumnChoice> &choices);

/// Returns the reason for skipping a row, as a clause: "not a number".
QString rowFaultText(const SkippedRow &row);

} // namespace slidercrank
