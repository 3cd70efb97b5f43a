// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is under the pointer in the drawing of a mechanism, and what comes after it.

#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

/// Joints before links, links before what stands still; with a few pixels to spare.
DrawnPart partAt(const MechanismDrawing &drawing, const MechanismProjection &on, QPointF pixel);

/// The next one on show, `step` 1, or the one before, -1; round and round.
DrawnPart partAfter(const MechanismDrawing &drawing, DrawnPart part, int step);

} // namespace slidercrank
