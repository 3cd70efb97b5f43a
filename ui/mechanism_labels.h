// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names of the points and dimensions of the lengths, beside the drawing of the mechanism.

#include "ui/mechanism_canvas.h"
#include "ui/mechanism_drawing.h"

namespace slidercrank
{

inline constexpr double kLabelReach = 42.0; ///< px around a joint that its name may touch

/// O₂.
void paintPivotName(QPainter &painter, const MechanismCanvas &on);

/// A, B and G₃, in that ink.
void paintNames(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, const QColor &ink);

/// c, from O₂ to the slider's line, left of the crank's circle.
void paintOffset(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism);

/// a and b, beside their links; the texts may reach as far as labelWidth() from the links' middles.
void paintLengths(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing);
double lengthLabelReach(const MechanismCanvas &on, const Mechanism &mechanism);

} // namespace slidercrank
