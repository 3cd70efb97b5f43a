// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the result of identifying a mechanism from a reference file. The window, the command line and the report
// use the same sentences. ui/text/explanation.h explains the difference between the file and the model.

#include "core/identification/identification.h"
#include "ui/text/notation.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace slidercrank
{

/// Returns the name of an outcome in JSON: "identified".
const char *outcomeName(Identification::Outcome outcome);

/// Returns the name of a symmetry in JSON: "mirror-image".
const char *symmetryName(AlternativeMechanism::Symmetry symmetry);

/// Returns the name of the reason why a column was left out, in JSON: "finite-differences".
const char *reasonName(LeftOutColumn::Reason reason);

/// Returns the notation of the sentences about an identification: that of the window, but with lengths in the unit of
/// the file if they are in mm in the window.
Notation notationOf(const Identification &found);

/// Returns the identified value of a parameter with its standard error and unit: "60.000000 ± 0.000001 mm". Returns a
/// dash if the data do not determine the parameter. If they determine only ratios of lengths, b and c are for the given
/// a.
QString measuredText(Parameter parameter, const Identification &found, const Notation &shown);

/// Summarizes an identification. "Mechanism identified in this file: a = 20.000001 ± 0.000003 mm, …, open assembly.",
/// followed by reservations; or the reason why none was identified, and what would help.
QString summaryText(const Identification &found);

/// Returns "Rounded values that fit equally well: a = 20 mm, …", or an empty string if no
/// rounded values do.
QString roundNumbersText(const Identification &found);

/// Returns "With b = 60 mm instead of 65 mm, this mechanism agrees with the file.", or an empty string if the change of
/// a single length of the given mechanism does not explain the file.
QString singleLengthExplanation(const Identification &found, const Parameters &given);

/// Names the lines of the file that were excluded as outliers, or returns an empty string.
QString outlierText(const Identification &found);

/// Lists the columns that were not used, with their reasons and deviations, or returns an empty string.
QString leftOutText(const Identification &found);

/// Returns a table of the residuals of each column. The first row contains the headings.
std::vector<QStringList> residualTable(const std::vector<ColumnResidual> &residuals);

/// Returns "The crank speed varies from 5 to 15 rad/s.", or an empty string if it is constant or unknown. If the speed
/// changes evenly, the sentence also gives α₂.
QString driveText(const Identification &found);

/// Explains that the window shows a motion at the constant crank speed `omega2` (rad/s), although the speed in the file
/// varies. Returns an empty string if the speed in the file is constant or unknown.
QString shownDriveText(const Identification &found, double omega2);

} // namespace slidercrank
