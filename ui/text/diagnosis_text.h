// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What was found out about a reference file, as a person reads it: the same sentences in the window, on the command
// line and in the report. Said of a file that differs from the mechanism at hand, they agree with each other: no change
// is named and no other reading offered beside a sentence that nothing explains the file.

#include "core/identification/diagnosis.h"

#include <QString>
#include <QStringList>

namespace slidercrank
{

/// A parameter as it was found, with its unit: "60.000000 ± 0.000001 mm"; where only ratios are known, of a:
/// "3.000000 ± 0.000002 a"; a dash for what the data do not fix.
QString measuredText(Parameter parameter, const Identification &found);

/// Of a mechanism that explains the file: what the data cannot fix or tell apart, and what noise is left. Empty where
/// there is nothing to say.
QString caveatsOf(const Diagnosis &diagnosis);

/// Whose motion the file is: the parameters with their standard errors and what the data cannot fix; or each mechanism
/// that explains it; or what is missing; or what comes nearest, as just that: "a = 20.000001 ± 0.000003 mm, …, open
/// assembly."
QString summaryOf(const Diagnosis &diagnosis);

/// "Round numbers come as near to the data: a = 20 mm, …". Empty where there are none.
QString roundNumbersText(const Diagnosis &diagnosis);

/// "This error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it." Empty where no single parameter
/// explains nearly all. `mechanism`: the one at hand.
QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism);

/// What explains why the file differs from the mechanism at hand, a line each; maybe nothing. `data`: the file as it
/// was printed.
QStringList differenceLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism);

/// The same, and whose motion the file is where it is not of the mechanism at hand.
QStringList explanationLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism);

} // namespace slidercrank
