// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the conventions by which a file differs from its headings. Numbers are written in the default locale.
// Columns are called by their names in files (theta3, R4_x_diff).

#include "core/identification/convention.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace slidercrank
{

/// Returns the name of a kind of convention in files and JSON: "angle-unit".
const char *conventionName(Convention::Kind kind);

/// Returns the kind with the name, or nullopt.
std::optional<Convention::Kind> conventionNamed(const QString &name);

/// Returns the unit of the amount of a convention in JSON: "°"; empty for a factor, nullopt if the convention has no
/// amount.
std::optional<QString> amountUnit(const Convention &convention);

/// Explains a convention: "theta3: in radians, but read as degrees."
QString explanationText(const Convention &convention);

/// Explains a convention that was found, and describes how it changes the error: "theta3: in radians, but read as
/// degrees. Largest error: 98.3 → 0.001 % of peak."
QString findingText(const ConventionFinding &finding);

/// Returns a sentence that names the columns that contain finite differences instead of derivatives: "R4_x_diff: finite
/// differences, not the time derivative." Returns an empty string if there are none.
QString finiteDifferenceSentence(const FileLayout &layout);

} // namespace slidercrank
