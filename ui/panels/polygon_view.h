// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The velocity polygon and the acceleration polygon at the current position, drawn to scale with named vectors, whose
// magnitudes are stated. They follow the animation.

#include "core/limits/polygon.h"
#include "ui/export/figure_form.h"

#include <QWidget>

namespace slidercrank
{

class Session;

class PolygonView : public QWidget
{
    Q_OBJECT

public:
    explicit PolygonView(Session *session, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override { return {300, 120}; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void copy();

    Session *m_session;
    QWidget *m_canvas;
};

/// Draws both polygons side by side, each to its own scale, which is shown below it, with the magnitudes if there is
/// space.
void drawPolygons(QPainter &painter, const QRectF &area, const Polygons &polygons, const QPalette &palette);

/// Returns a drawing of both polygons at time t (s), with the crank acceleration alpha2 (rad/s²), below their position.
FigureDrawing polygonFigure(const Mechanism &mechanism, double t, double alpha2, const QPalette &palette);

/// Returns the polygons at the current position as a figure, which states the position and the parameters.
FigureSubject polygonSubject(const Session &session);

/// Returns the height (px) of a figure of the polygons.
int polygonHeight(int width, const QFont &font);

} // namespace slidercrank
