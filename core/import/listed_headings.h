// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds headings in consecutive lines that name one column each:
//
//     # Column 1: time [s]          # - time [s]
//     # Column 2: angle [deg]       # - angle [deg]

#include "core/import/heading_line.h"

#include <optional>

namespace slidercrank
{

/// Finds such headings in the lines above the row of numbers, one for each of its cells. HeadingCandidate::line is the
/// last of these lines. Returns nullopt if there are none, or if a line of headings is below them: then the list may
/// describe anything, such as sensors or parameters.
std::optional<HeadingCandidate> findListedHeadings(Lines above, const NumberRow &row);

} // namespace slidercrank
