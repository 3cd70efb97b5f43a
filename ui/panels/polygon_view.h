// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The velocity polygon and the acceleration polygon at the present position, drawn to scale with named vectors. They
// follow the animation.

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

    /// Returns the polygons as a figure, which states their position and the parameters.
    FigureSubject figure() const;

    QSize minimumSizeHint() const override { return {300, 120}; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    QString positionText() const;
    void copy();

    Session *m_session;
    QWidget *m_canvas;
};

/// Draws both polygons side by side, each to its own scale, which is shown below it.
void drawPolygons(QPainter &painter, const QRectF &area, const Polygons &polygons, const QPalette &palette);

} // namespace slidercrank
