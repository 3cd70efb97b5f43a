// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The coupler's instant centre P in the drawing of the mechanism, with the velocities that it explains: those of A and
// B are square to the rays from P, and |ω3| times as large as these are long.

#include "ui/mechanism/label_room.h"
#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

/// Where P lies beyond the drawing, the way to it; where it is beyond all bounds, that in words.
void paintInstantCentre(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, LabelRoom &room);

} // namespace slidercrank
