// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What can be said about the file.

#include "core/identification/further_columns.h"
#include "core/identification/identification.h"
#include "core/identification/last_fit.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// What the other steps found out.
struct Findings {
    Drive drive;
    LastFit lastFit;
    std::vector<LeftOutColumn> leftOut;
    std::vector<double> speeds;         ///< the values of ω2 that a table over the crank angle allows, rad/s
    std::vector<Model> otherImages;     ///< other mechanisms that need the same reading of the file
    std::optional<LengthChange> change; ///< the one wrong length of the given mechanism
    double lengthUnit = 1.0;            ///< the unit of the lengths in the file, mm
};

/// The outcome without conventions and comparisons: first whether the file determines the mechanism, then whether the
/// mechanism explains the file.
Identification judge(const ReferenceData &data, const Findings &findings, const Parameters &given);

/// Adds the conventions of an identified or approximate mechanism, and the comparisons of the used columns with it and
/// with the given mechanism. An identified mechanism becomes approximate if a used column does not agree with it.
/// `data`: the table as it is in the file. `change`: the change of its axes, headings or clock after which the
/// observations were read from it, if there was one; it becomes the first convention.
void addConventions(Identification &result, const ReferenceData &data, const std::optional<Convention> &change,
                    const Findings &findings, const Parameters &given);

/// Whether a file has too few rows or columns for any fit; Nothing if it has enough.
Identification::Lack findLack(const Observations &observations);

} // namespace slidercrank
