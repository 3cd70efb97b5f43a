// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_note.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr int kInset = 6;
constexpr int kWidest = 330;

QPoint topLeftIn(Qt::Corner corner, const QRect &room, const QSize &size)
{
    const bool isRight = corner == Qt::TopRightCorner || corner == Qt::BottomRightCorner;
    const bool isBottom = corner == Qt::BottomLeftCorner || corner == Qt::BottomRightCorner;
    return {isRight ? room.right() - size.width() + 1 : room.left(),
            isBottom ? room.bottom() - size.height() + 1 : room.top()};
}

double distanceToBox(const QRectF &box, QPointF point)
{
    const double across = std::max({box.left() - point.x(), 0.0, point.x() - box.right()});
    const double along = std::max({box.top() - point.y(), 0.0, point.y() - box.bottom()});
    return std::hypot(across, along);
}

} // namespace

MechanismNote::MechanismNote(QWidget *drawing)
    : QLabel(drawing)
{
    setObjectName(QStringLiteral("mechanismNote"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setMargin(5);
    setFrameShape(QFrame::Box);
    setFrameShadow(QFrame::Plain);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setForegroundRole(QPalette::Text);
    hide();
}

void MechanismNote::say(const QString &text)
{
    if (text.isEmpty()) {
        hide();
        return;
    }
    setText(text);
    place();
    show();
}

void MechanismNote::keepAwayFrom(const QPolygonF &points)
{
    const QRect room = parentWidget()->rect().adjusted(kInset, kInset, -kInset, -kInset);
    double farthest = -1.0;
    for (const Qt::Corner corner :
         {Qt::TopRightCorner, Qt::TopLeftCorner, Qt::BottomRightCorner, Qt::BottomLeftCorner}) {
        const QRectF box(topLeftIn(corner, room, size()), size());
        double nearest = std::numeric_limits<double>::infinity();
        for (const QPointF &point : points) {
            nearest = std::min(nearest, distanceToBox(box, point));
        }
        if (nearest > farthest) {
            farthest = nearest;
            m_corner = corner;
        }
    }
    place();
}

void MechanismNote::place()
{
    const QRect room = parentWidget()->rect().adjusted(kInset, kInset, -kInset, -kInset);
    const int width = std::min(kWidest, room.width());
    const QSize size(width, heightForWidth(width));
    setGeometry(QRect(topLeftIn(m_corner, room, size), size));
}

} // namespace slidercrank
