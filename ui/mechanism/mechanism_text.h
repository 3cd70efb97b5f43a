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

/// Returns "Scale: 10 mm = 50 mm/s", or "at rest" if all arrows have the length 0.
QString arrowScaleText(const ArrowScale &scale);

/// Returns why there is no pose: the mechanism cannot be assembled at this crank angle, with the coupler length that
/// would help, or the crank angle is not a finite number. Empty if the pose exists, or if there is no result yet.
QString missingPoseText(const MechanismScene &scene);

} // namespace slidercrank
