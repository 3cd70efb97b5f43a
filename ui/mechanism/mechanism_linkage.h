// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What moves in the drawing of a mechanism: crank, coupler and slider with what is on show of their names, lengths and
// motion; over them the linkage of the reference, or of what was kept, thin, in its colour, where the two differ: the
// ghost.

#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

/// At the pose; where there is none the last one greyed, with what would help.
void paintLinkage(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing);

/// Marks one of the parts that move; nothing for the others.
void paintLinkageHighlight(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing,
                           DrawnPart part);

/// Pixels that the linkage, the ghost touch; null where they are not drawn.
QRectF linkageArea(const MechanismCanvas &on, const MechanismDrawing &drawing);
QRectF ghostArea(const MechanismCanvas &on, const MechanismDrawing &drawing);

} // namespace slidercrank
