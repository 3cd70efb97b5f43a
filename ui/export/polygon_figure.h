// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the velocity polygon and the acceleration polygon side by side, to scale, with named vectors and their
// magnitudes.

#include "core/limits/polygon.h"
#include "ui/export/figure_export.h"
#include "ui/text/units.h"

#include <QRectF>
#include <QStringList>

#include <vector>

namespace slidercrank
{

/// Returns the magnitude of each vector: "v_A = 20.00", …, "v_B = 30.15 in/s". The last text has the unit.
QStringList magnitudes(const std::vector<PlacedVector> &polygon, Measure measure);

/// Returns whether a vector of the polygons is not 0.
bool hasVectors(const Polygons &polygons);

/// Draws both polygons side by side, each to its own scale, which is shown below it, with the magnitudes if there is
/// space.
void drawPolygons(QPainter &painter, const QRectF &area, const Polygons &polygons, const QPalette &palette);

/// Returns a drawing of both polygons at time t (s), with the crank acceleration alpha2 (rad/s²), below a heading that
/// states θ₂ and α₂.
FigureDrawing polygonFigure(const Mechanism &mechanism, double t, double alpha2, const QPalette &palette);

/// Returns the height (px) of a figure of the polygons.
int polygonHeight(int width, const QFont &font);

/// Returns the smallest height (px) with which drawPolygons() draws the magnitudes below the polygons.
int minimumPolygonHeight(const QFont &font);

} // namespace slidercrank
