// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Conventions of the axes, headings or clock of a table, which are applied before the other steps.

#include "core/identification/identification.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// The rotation of the axes by a quarter turn if the slider moves along y and not along x; nullopt otherwise.
/// `rotatesAngles`: whether angles are also measured from the new x axis.
std::optional<Convention> findAxisRotation(const ReferenceData &data, bool rotatesAngles);

/// Conventions of the table, one of which may explain what `result`, that of the table as it is in the file, does not
/// explain: a clock in a different unit, or two headings exchanged.
std::vector<Convention> possibleTableConventions(const ReferenceData &data, const Identification &result);

} // namespace slidercrank
