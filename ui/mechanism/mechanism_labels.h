// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names of the points and letters of the lengths, beside the drawing of the mechanism. What the lengths are stands in a
// corner: beside short links that move there is no room for it.

#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

inline constexpr double kLabelReach = 42.0; ///< px around a joint that its name may touch

/// O₂.
void paintPivotName(QPainter &painter, const MechanismCanvas &on);

/// A, B and G₃, in that ink.
void paintNames(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, const QColor &ink);

/// c, from O₂ to the slider's line, left of the crank's circle.
void paintOffset(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism);

/// a and b, beside their links: there, px, and no farther from it than letterReach().
void paintLengths(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing);
QPointF placeOfLetter(QPointF from, QPointF to);
double letterReach(const MechanismCanvas &on);

/// How long a, b and c are, in the upper left corner.
QStringList valueLines(const MechanismCanvas &on, const Mechanism &mechanism);
void paintValues(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism);

} // namespace slidercrank
