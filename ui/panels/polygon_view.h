// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows the velocity polygon and the acceleration polygon at the current position. They follow the animation.

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

    QSize minimumSizeHint() const override { return {300, 190}; } ///< px, of a legible polygon

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void copy();

    Session *m_session;
    QWidget *m_canvas;
};

/// Returns the polygons at the current position as a figure, which states the position and the parameters.
FigureSubject polygonSubject(const Session &session);

} // namespace slidercrank
