// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the conventions by which a file differs from its headings. Numbers are written in the default locale.
// Columns are called by their names in files (theta3, R4_x_diff).

#include "core/identification/convention.h"

#include <QString>
#include <QStringList>

#include <span>

namespace slidercrank
{

/// Returns the name of a convention: "angle unit".
QString conventionName(const Convention &convention);

/// Explains a convention: "theta3: in radians, but read as degrees." `data` is the file before conventions are applied.
QString explanationText(const Convention &convention, const ReferenceData &data);

/// Describes how a convention changes the data and the error: "Multiplies theta3 by 57.2958: largest error 0.001 % of
/// peak instead of 98 %."
QString effectText(const ConventionFinding &finding);

/// Returns a sentence for each group of columns that contain finite differences instead of derivatives: "R4_x_diff:
/// forward differences, …". Columns that a finding leaves out are not named.
QStringList differenceSentences(const ReferenceData &data, std::span<const ConventionFinding> findings);

} // namespace slidercrank
