// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said about the part that is pointed at, over the drawing, in the corner where it hides least.

#include <QLabel>
#include <QPolygonF>

namespace slidercrank
{

class MechanismNote : public QLabel
{
    Q_OBJECT

public:
    explicit MechanismNote(QWidget *drawing);

    /// Hidden while there is nothing to say.
    void say(const QString &text);

    /// Into the corner that is farthest from these points (pixels of the drawing).
    void keepAwayFrom(const QPolygonF &points);

private:
    void place();

    Qt::Corner m_corner = Qt::TopRightCorner;
};

} // namespace slidercrank
