// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads what a person types into a number box: a number with an optional unit, or an expression of numbers and π with
// + - * / and parentheses, followed by an optional unit: "2*pi", "2π", "40*1.2", "1/2 in", "(3+4)/2 cm". π behind a
// number is a factor of that number: "1/2π" is 1/(2π), as in textbooks.

#include "core/import/quantity.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace slidercrank
{

/// Returns the quantity in the unit `wanted`, as readQuantity() does. The fault of an expression that cannot be
/// computed is NotANumber.
Quantity readExpression(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale = {});

} // namespace slidercrank
