// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said about the parts of the drawing, with numbers and units.

#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

#include <QString>

namespace slidercrank
{

/// A line that says what the part is and what dragging it does, then its values. Empty for the background. Requires a
/// pose that exists.
QString partText(const MechanismScene &scene, DrawnPart part);

/// "a = 20 mm".
QString lengthText(const QString &symbol, double length);

/// Why the mechanism cannot be assembled at this crank angle and what would help. Empty if it can.
QString assemblyProblem(const MechanismScene &scene);

} // namespace slidercrank
