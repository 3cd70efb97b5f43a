// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a file has to be read, and its comparison, read in this way, with the mechanism found.

#include "core/identification/findings.h"

#include <optional>

namespace slidercrank
{

/// Adds the conventions of an identified or approximate mechanism, and the comparisons of the used columns with it and
/// with the given mechanism. An identified mechanism becomes approximate if a used column does not agree with it.
/// `data`: the table as it is in the file. `change`: the change of its axes, headings or clock after which the
/// observations were read from it, if there was one; it becomes the first convention.
void addReading(Identification &result, const ReferenceData &data, const std::optional<Convention> &change,
                const Findings &findings, const Parameters &given);

} // namespace slidercrank
