// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Words for the check of a calculation by hand. The window and the command line use the same texts.

#include "core/check/check.h"

#include <QString>
#include <QStringList>

namespace slidercrank
{

/// Describes the verdict on one value: "right to its 3 digits", "off by 86.6 mm/s". `digits`: the significant digits of
/// the value; `deviation`: in the displayed unit, which is `unit`.
QString checkedValueText(const CheckedValue &checked, int digits, double deviation, const QString &unit);

/// Returns the sentence about a slip: "ω₂ with the opposite sign gives exactly your v and a." `wrongNames`: the names
/// of the wrong values.
QString slipText(Slip slip, const QStringList &wrongNames);

/// Returns the conclusion from all values: the sentence about the slip, or why none is named. Empty if the motion does
/// not exist at the position.
QString explanationText(const CheckResult &result, const QStringList &wrongNames);

} // namespace slidercrank
