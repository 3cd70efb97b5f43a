// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads numbers with units in the user's locale, and explains why an input is invalid.

#include "core/import/quantity.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace slidercrank
{

/// Reads a number with an optional unit. The decimal sign is that of the locale, or a point.
Quantity readQuantity(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale = {});

QString quantityFaultText(const QString &text, QuantityFault fault, const std::optional<Unit> &wanted);

/// Returns the units that can be entered for a quantity of this dimension.
QStringList unitsFor(const Unit &wanted);

/// Returns the name of the unit after a space; empty if it is not among unitsFor().
QString unitAfterNumber(const Unit &unit);

} // namespace slidercrank
