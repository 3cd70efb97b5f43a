// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said about the parts of the mechanism that are on show, in words and numbers with units.

#include "ui/mechanism/mechanism_drawing.h"

#include <QString>

namespace slidercrank
{

/// A line what it is and what a drag does there, then its numbers. Empty for the background.
QString partText(const MechanismDrawing &drawing, DrawnPart part);

/// "a = 20 mm".
QString lengthText(const QString &symbol, double length);

/// Why there is no pose, and what would help; empty while there is one.
QString explanationOf(const MechanismDrawing &drawing);

} // namespace slidercrank
