// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A number of a calculation by hand as a person types it, for the check.

#include "core/check/check.h"
#include "core/check/written_value.h"
#include "ui/text/units.h"

#include <QString>

#include <vector>

namespace slidercrank
{

/// A value such as "5.42rad/s".
struct TypedValue {
    OutputChannel channel;
    QString text;
    WrittenValue parsed; ///< in `unit`, or why the text is no value
    Unit unit;           ///< the unit in the text, or the expected unit
    QString unitName;
    bool hasUnit = false; ///< whether the text has a unit

    GivenValue given() const;

    /// Convert from `unit` to the core's unit (mm, rad, s), and from the core's unit to `unit`.
    double toCore(double value) const;
    double fromCore(double value) const;

    /// Returns the unit as it follows a number: " mm", "°".
    QString unitSuffix() const;
};

/// Reads a value. `units`: those of a number without a unit. The decimal sign is a point.
TypedValue readTypedValue(const QString &text, const OutputChannel &channel, const Units &units);

/// Changes the unit of angular values without a unit from degrees to radians, or vice versa, where that is likely:
/// textbooks give ω and α in rad/s beside angles in degrees. Returns all values. `units`: those of a number without a
/// unit. A value changes its unit
///
///  - if it is right in the other unit only. An angle must also be within a turn, and have so many digits that it is
///    hardly right by chance;
///  - if it is a wrong ω or α, and a slip explains all wrong values in the other unit, but not in the expected unit;
///  - if it is a wrong ω or α that no slip explains, and is nearer in size to the exact value in the other unit.
std::vector<TypedValue> inLikelyUnits(std::vector<TypedValue> values, const CrankPosition &position,
                                      const Units &units);

/// Returns why the typed text was not accepted, and what to write instead. Requires a fault.
QString faultText(const TypedValue &typed);

/// Returns the exact value with its unit: "exact: 9.792 mm".
QString exactText(const TypedValue &typed, const CheckedValue &checked);

/// Returns the verdict: "off by 0.00818 mm", or that the value is right.
QString verdictText(const TypedValue &typed, const CheckedValue &checked);

} // namespace slidercrank
