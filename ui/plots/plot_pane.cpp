// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_pane.h"

#include "ui/text/theme.h"

#include <QPainter>

#include <utility>

namespace slidercrank
{

PlotPane::PlotPane(const QPixmap &picture, QWidget *figure)
    : QWidget(figure)
    , m_picture(picture)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
}

void PlotPane::setCursors(std::vector<PlotCursor> cursors, const QRect &axes)
{
    const QRect before = m_paintedArea;
    if (axes == m_axes) { // otherwise the line has moved with the axes and not in an animation
        setPreviousPlaces(cursors, m_cursors);
    }
    m_axes = axes;
    m_cursors = std::move(cursors);
    placeLabels(m_cursors, m_axes, font(), CrowdedLabelPolicy::CoverLeast);
    QRectF painted;
    for (const PlotCursor &cursor : m_cursors) {
        painted |= QRectF(cursor.x, m_axes.top(), 1.0, m_axes.height());
        for (const PlotCursor::Label &label : cursor.labels) {
            painted |= label.place;
        }
    }
    constexpr double kOutlineOfDot = 1.5;                    // px
    const double margin = dotRadius(font()) + kOutlineOfDot; // for the dots on the line
    m_paintedArea = painted.adjusted(-margin, -margin, margin, margin).toAlignedRect();
    // A single rectangle. To fill a region of several rectangles, Qt starts threads, which takes far longer.
    update(before | m_paintedArea);
}

void PlotPane::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.drawPixmap(-pos(), m_picture);
    paintCursors(painter, m_cursors, m_axes, font(), seriesColours(palette()));
    if (hasFocus()) {
        constexpr int kFocusWidth = 2; // px
        painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusWidth));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(m_axes.adjusted(-1, -1, 1, 1)); // not through the numbers of the axes
    }
}

} // namespace slidercrank

#include "moc_plot_pane.cpp"
