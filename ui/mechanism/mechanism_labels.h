// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names of points, dead centres and angles, and letters of the lengths, in the drawing of the mechanism: off its links
// and off each other. What the lengths are stands in a corner: beside short links that move there is no room for it.

#include "ui/mechanism/label_room.h"
#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

/// Between links, slider, ground, the slider's line and the offset's dimension.
LabelRoom labelRoomOf(const MechanismCanvas &on, const MechanismDrawing &drawing);

/// Where the reference's linkage, which is there, is named: at its slider, off its coupler.
QRectF ghostWordPlace(const MechanismCanvas &on, const ReferencePose &ghost);

/// All that are on show and may have to give way to what moves, in that ink.
void paintLabels(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, const QColor &ink,
                 LabelRoom &room);

/// c, from O₂ to the slider's line, beside the crank's circle where the coupler does not come.
void paintOffset(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism);

/// How long a, b and c are, in the upper left corner.
QStringList valueLines(const MechanismCanvas &on, const Mechanism &mechanism);
void paintValues(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism);

} // namespace slidercrank
