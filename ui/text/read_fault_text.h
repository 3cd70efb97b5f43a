// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Explains, in the current language, why a file or a row cannot be read.

#include "core/import/reference_data.h"

#include <QString>

namespace slidercrank
{

/// Returns a sentence that explains the fault and how to correct it.
QString faultText(const ReadFault &fault);

/// Returns the reason for skipping a row, as a clause: "not a number".
QString rowFaultText(const SkippedRow &row);

} // namespace slidercrank
