// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A number of a calculation by hand as a person types it, for the check.

#include "core/check/check.h"
#include "core/check/written_value.h"
#include "ui/text/units.h"

#include <QString>

namespace slidercrank
{

/// A value such as "5.42rad/s".
struct TypedValue {
    OutputChannel channel;
    QString text;
    WrittenValue written; ///< in `unit`, or why the text is no value
    Unit unit;            ///< that of the text, or the expected one
    QString unitName;
    bool hasUnit = false; ///< the text has one

    GivenValue given() const;

    /// Converts to the core's unit (mm, rad, s), and from it to `unit`.
    double toCore(double value) const;
    double fromCore(double value) const;

    /// Returns the unit as it follows a number: " mm", "°".
    QString unitBehind() const;
};

/// Reads a value. `units`: those of a number without a unit. The decimal sign is a point.
TypedValue readTypedValue(const QString &text, const OutputChannel &channel, const Units &units);

/// Returns the value; or, if its text has no unit, the same number in the other unit of angles if it is right only in
/// that one: textbooks give ω and α in rad/s beside angles in degrees. An angle must be within a turn, and have enough
/// digits that chance is unlikely.
TypedValue inLikelyUnit(const TypedValue &typed, const CrankPosition &position, const Units &units);

/// Returns the value and what is wrong with it: "exact: 9.792 mm" and "off by 0.00818 mm".
QString exactText(const TypedValue &typed, const CheckedValue &checked);
QString verdictText(const TypedValue &typed, const CheckedValue &checked);

} // namespace slidercrank
