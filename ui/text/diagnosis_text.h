// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the result of identifying a mechanism from a reference file. The window, the command line and the report
// use the same sentences. If no mechanism explains the file, no changed parameter or convention is suggested either.

#include "core/identification/diagnosis.h"

#include <QString>
#include <QStringList>

namespace slidercrank
{

/// Returns the identified value of a parameter with its standard error and unit: "60.000000 ± 0.000001 mm". Returns a
/// dash if the data do not determine the parameter. If they determine only ratios of lengths, b and c are for the given
/// a.
QString measuredText(Parameter parameter, const Identification &found);

/// Returns the reservations about an identified mechanism: parameters that the data do not determine, mechanisms that
/// fit equally well, columns and rows that were left out, and noise. Returns an empty string if there are none.
QString caveatText(const Diagnosis &diagnosis);

/// Summarizes an identification: the parameters with their standard errors ("a = 20.000001 ± 0.000003 mm, …, open
/// assembly."), or all mechanisms that fit, or the reason why none was found, or the nearest mechanism.
QString summaryText(const Diagnosis &diagnosis);

/// Returns summaryText(); "Mechanism found in this file:" precedes it if there is exactly one.
QString foundText(const Diagnosis &diagnosis);

/// Returns "Nominal values fit equally well: a = 20 mm, …", or an empty string if they do not.
QString roundNumbersText(const Diagnosis &diagnosis);

/// Returns "With b = 60 mm instead of 65 mm, 99.9999 % of the difference disappears.", or an empty string if no single
/// parameter explains nearly all of the difference. `mechanism` is the given mechanism.
QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism);

/// Returns the explanations of the difference between the file and the given mechanism, one per line, followed by the
/// mechanism of the file if it is not the given one. The list may be empty. `data` is the file before conventions are
/// applied.
QStringList explanationLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism);

} // namespace slidercrank
