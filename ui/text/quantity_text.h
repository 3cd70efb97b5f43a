// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers with units as they are typed in the user's locale, and why one will not do, in one short sentence.

#include "core/import/quantity.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace slidercrank
{

/// With the locale's decimal sign, or a point.
Quantity readQuantity(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale = {});

/// A whole number, also in groups of three as countText() writes it.
Quantity readCount(const QString &text);

QString quantityFaultText(const QString &text, QuantityFault fault, const std::optional<Unit> &wanted);

/// Those that are understood where that one is wanted, as people write them.
QStringList unitsFor(const Unit &wanted);

} // namespace slidercrank
