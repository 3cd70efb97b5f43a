// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The conventions of a file that differ from its headings, in words. Numbers in QLocale(), columns by the names that
// they have in files (theta3, R4_x_diff).

#include "core/identification/convention.h"

#include <QString>
#include <QStringList>

#include <span>

namespace slidercrank
{

/// A few words: "angle unit".
QString nameOf(const Convention &convention);

/// "theta3: in radians, but read as degrees." `data`: the file as it was printed.
QString explanationOf(const Convention &convention, const ReferenceData &data);

/// What applying it does, and to what good: "Multiplies theta3 by 57.2958: largest error 0.001 % of peak instead of 98
/// %."
QString effectOf(const ConventionFinding &finding);

/// "R4_x_diff: forward differences, …": of the columns that are known to be differences, and that no finding leaves
/// out.
QStringList differenceSentences(const ReferenceData &data, std::span<const ConventionFinding> findings);

} // namespace slidercrank
