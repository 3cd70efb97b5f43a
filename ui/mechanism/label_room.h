// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Room for labels between what is drawn: each goes to the first of its places where it crosses nothing, or to the one
// where it crosses least. It depends on one instant alone, so that a motion looks the same there and back. All in px.

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace slidercrank
{

class LabelRoom
{
public:
    explicit LabelRoom(const QSizeF &drawing)
        : m_drawing(QPointF(), drawing)
    {
    }

    void keepOff(const QLineF &link, double width);
    void keepOff(const QRectF &box);
    void ratherKeepOff(const QLineF &line); ///< a thin one, which may be crossed where there is no other room

    /// Where a label of that size goes, and is from now on in the way of others; `centres`: its places, the best first.
    QRectF place(const QSizeF &label, const std::vector<QPointF> &centres);

private:
    double crossedBy(const QRectF &label) const;

    struct Link {
        QLineF line;
        double halfWidth = 0.0;
    };
    QRectF m_drawing;
    std::vector<Link> m_links;
    std::vector<QLineF> m_lines;
    std::vector<QRectF> m_boxes;
};

/// Places all round a point, so far from it that nothing is nearer than `reach`: in that direction first, then to
/// either side of it, then farther away.
std::vector<QPointF> placesAround(QPointF point, QPointF direction, double reach, const QSizeF &label);

} // namespace slidercrank
