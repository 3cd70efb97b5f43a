// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Texts about the parts of the drawing, with numbers and units.

#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

#include <QString>

namespace slidercrank
{

/// Returns a line that says what the part is and what dragging it does, followed by its values. Empty for the
/// background. Requires a pose that exists.
QString partText(const MechanismScene &scene, DrawnPart part);

/// Returns "a = 20 mm".
QString lengthText(const Mechanism &mechanism, Parameter length);

/// Returns the crank angle as the timeline shows it: beyond a whole turn, it counts on.
QString timelineAngle(const MechanismScene &scene);

/// Returns "Scale: 10 mm = 50 mm/s".
QString arrowScaleText(const ArrowScale &scale);

/// Returns why the mechanism cannot be assembled at this crank angle and what would help. Empty if it can be assembled.
QString assemblyProblem(const MechanismScene &scene);

} // namespace slidercrank
