// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace slidercrank
{

/// Returns the text with no-break spaces between numbers and their units and around the signs of equations.
QString withUnbrokenUnits(QString text);

/// Creates a paragraph of plain text that can be selected and copied. A word longer than a line, such as a file name,
/// is cut off instead of widening the window.
QLabel *plainText(const QString &text = {});

} // namespace slidercrank
