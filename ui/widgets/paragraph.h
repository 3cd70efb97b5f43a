// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace slidercrank
{

/// Creates a paragraph of plain text that can be selected and copied. A word longer than a line, such as a file name,
/// is cut off instead of widening the window.
QLabel *plainText(const QString &text = {});

} // namespace slidercrank
