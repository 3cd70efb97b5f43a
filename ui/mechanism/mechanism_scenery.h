// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What stands still in the drawing while the mechanism moves: the grid; ground, circle, rail, dead centres and the arcs
// that cannot be; the coupler's path, the offset's dimension and the arrows' scale where they are on show.

#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drawing.h"

namespace slidercrank
{

/// How far the slider goes, mm.
struct Rail {
    double left = 0.0;
    double right = 0.0;
};
Rail railOf(const MechanismDrawing &drawing);

/// Lines of text that it has in the upper left corner.
int cornerLineCount(const MechanismCanvas &on, const MechanismDrawing &drawing);

inline constexpr double kRailOverhang = kBlockHalfWidth + 4.0; ///< px beyond it at either end

/// The background with the grid, labelled along the lower and the left edge.
void paintGrid(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing);

/// What changes with the lengths.
void paintScenery(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing);

/// Marks one of the parts that stand still; nothing for the others.
void paintSceneryHighlight(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing,
                           DrawnPart part);

} // namespace slidercrank
