// SPDX-License-Identifier: GPL-3.0-or-later

// What the mouse and the keyboard do to the plots.

#include "ui/plots/plot_grid.h"

#include "ui/plots/plot_drawing.h"
#include "ui/text/written_number.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QRubberBand>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Scales the range about one of its points.
Interval scale(const Interval &range, double about, double factor)
{
    return {about - (about - range.lower) * factor, about + (range.upper - about) * factor};
}

/// Returns the box that a drag zooms into. A flat box gets the whole height of the axes, a narrow one their whole
/// width.
QRect draggedBox(const QPoint &from, const QPoint &to, const QRect &axes)
{
    constexpr int kMinBoxSide = 8; // px
    QRect box = QRect(from, to).normalized();
    if (box.width() <= kMinBoxSide) {
        box.setLeft(axes.left());
        box.setRight(axes.right());
    }
    if (box.height() <= kMinBoxSide) {
        box.setTop(axes.top());
        box.setBottom(axes.bottom());
    }
    return box & axes;
}

} // namespace

std::optional<std::size_t> PlotGrid::plotAt(const QPointF &place) const
{
    const auto found = std::ranges::find(m_panes, childAt(place.toPoint()));
    return found == m_panes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - m_panes.begin()));
}

QPointF PlotGrid::coordinates(std::size_t plot, const QPointF &place) const
{
    const Plot &shownAxes = shownPlot(plot);
    return {shownAxes.timeAxis->pixelToCoord(place.x()), shownAxes.valueAxis->pixelToCoord(place.y())};
}

void PlotGrid::zoomAbout(double time, double factor)
{
    zoomTime(scale(timeRange(), time, factor));
}

void PlotGrid::wheelEvent(QWheelEvent *event)
{
    refreshIfStale(); // the pointer refers to what is painted
    const std::optional<std::size_t> plot = plotAt(event->position());
    if (!plot || m_drag) {
        return;
    }
    constexpr double kNotch = 120.0;       // angleDelta() of one notch of a mouse wheel
    constexpr double kZoomPerNotch = 0.85; // factor of the visible range
    const double factor = std::pow(kZoomPerNotch, event->angleDelta().y() / kNotch);
    const QPointF about = coordinates(*plot, event->position());
    if (event->position().x() >= axes(*plot).left()) {
        zoomAbout(about.x(), factor);
    } else if (shownPlot(*plot).values) {
        zoomValues(*plot, scale(*shownPlot(*plot).values, about.y(), factor));
    }
}

void PlotGrid::mousePressEvent(QMouseEvent *event)
{
    refreshIfStale();
    const bool isLeft = event->button() == Qt::LeftButton;
    const std::optional<std::size_t> plot = plotAt(event->pos());
    if (!plot || !(isLeft || event->button() == Qt::MiddleButton)) {
        return;
    }
    endDrag(); // a drag with another button, or one whose release was not received
    const bool isPan = !isLeft || event->modifiers().testFlag(Qt::ShiftModifier);
    m_drag = Drag{.plot = *plot, .isPan = isPan, .start = event->pos(), .last = event->pos(), .before = zoom()};
    m_hovered.reset(); // until the pointer moves again
}

void PlotGrid::mouseMoveEvent(QMouseEvent *event)
{
    refreshIfStale();
    const QPoint place = event->pos();
    if (m_drag) {
        drag(place);
    } else {
        const std::optional<std::size_t> plot = plotAt(place);
        m_hovered = plot && axes(*plot).contains(place) ? plot : std::nullopt;
        m_hoverTime = m_hovered ? coordinates(*plot, place).x() : 0.0;
    }
    moveCursors();
}

void PlotGrid::drag(const QPoint &to)
{
    const std::size_t plot = m_drag->plot;
    m_drag->hasMoved |= (to - m_drag->start).manhattanLength() >= QApplication::startDragDistance();
    if (!m_drag->hasMoved) {
        return;
    }
    grabKeyboard(); // so that Escape reaches this widget
    const QPointF movement = coordinates(plot, m_drag->last) - coordinates(plot, to); // time (s) and value
    m_drag->last = to;
    if (m_drag->isPan) {
        setCursor(Qt::ClosedHandCursor);
        const Interval time = timeRange();
        zoomTime({time.lower + movement.x(), time.upper + movement.x()});
        if (std::optional<Interval> &values = m_zoom.values[plot]) {
            values = Interval{values->lower + movement.y(), values->upper + movement.y()};
        }
        refresh(); // the next mouse move is relative to the new axes
    } else {
        m_rubberBand->setGeometry(draggedBox(m_drag->start, to, axes(plot)));
        m_rubberBand->show();
        m_rubberBand->raise();
    }
}

void PlotGrid::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_drag || event->button() == Qt::RightButton) {
        return;
    }
    const Drag drag = *m_drag;
    const QRect box = m_rubberBand->geometry();
    const QRect axes = this->axes(drag.plot);
    endDrag();
    if (drag.isPan) {
        return;
    }
    if (!drag.hasMoved && axes.contains(event->pos())) {
        m_timeBeforeClick = m_time;
        emit timeRequested(readTime(coordinates(drag.plot, event->pos()).x()).t);
    } else if (drag.hasMoved && box.isValid()) {
        const QPointF lowerLeft = coordinates(drag.plot, box.bottomLeft());
        const QPointF upperRight = coordinates(drag.plot, box.topRight());
        if (box.width() < axes.width()) {
            zoomTime({lowerLeft.x(), upperRight.x()});
        }
        if (box.height() < axes.height() && shownPlot(drag.plot).values) {
            zoomValues(drag.plot, {lowerLeft.y(), upperRight.y()});
        }
    }
}

void PlotGrid::endDrag()
{
    if (m_drag) {
        m_drag.reset();
        m_rubberBand->hide();
        releaseKeyboard();
        setCursor(Qt::ArrowCursor);
        moveCursors();
    }
}

void PlotGrid::hideEvent(QHideEvent *)
{
    endDrag();
}

void PlotGrid::mouseDoubleClickEvent(QMouseEvent *event)
{
    const std::optional<std::size_t> plot = plotAt(event->pos());
    if (plot && event->pos().y() < axes(*plot).top()) {
        toggleMaximized(*plot); // on the title
    } else if (plot) {
        showAll();
        if (m_timeBeforeClick) { // the first of both clicks moved the time
            emit timeRequested(*m_timeBeforeClick);
        }
    }
}

void PlotGrid::leaveEvent(QEvent *)
{
    m_hovered.reset();
    moveCursors();
}

/// Handles the keys of the plot that has the focus or is being dragged. + and − zoom about the current time or, if it
/// is not shown, about the middle.
void PlotGrid::keyPressEvent(QKeyEvent *event)
{
    constexpr double kZoomPerKey = 0.7; // factor of the visible range
    const Interval shownTime = timeRange();
    const double middle = 0.5 * (shownTime.lower + shownTime.upper);
    const double fixedTime = m_time && shownTime.contains(*m_time) ? *m_time : middle; // about which the keys zoom
    const auto focused = std::ranges::find(m_panes, focusWidget());
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (focused != m_panes.end()) {
            toggleMaximized(static_cast<std::size_t>(focused - m_panes.begin()));
        }
        return;
    case Qt::Key_Escape:
        if (m_drag) {
            const PlotZoom before = m_drag->before;
            endDrag();
            return setZoom(before);
        }
        if (m_maximized) {
            return toggleMaximized(*m_maximized);
        }
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoomAbout(fixedTime, kZoomPerKey);
    case Qt::Key_Minus: return zoomAbout(fixedTime, 1.0 / kZoomPerKey);
    case Qt::Key_0: return showAll();
    default: break;
    }
    PlotFigure::keyPressEvent(event);
}

void PlotGrid::toggleMaximized(std::size_t plot)
{
    m_maximized = m_maximized ? std::nullopt : std::optional(plot);
    m_hovered.reset();
    refresh();
    m_panes[plot]->setFocus(Qt::OtherFocusReason); // so that Escape can show all plots again
}

void PlotGrid::contextMenuEvent(QContextMenuEvent *event)
{
    const std::optional<std::size_t> found = plotAt(event->pos());
    if (!found) {
        return;
    }
    const std::size_t plot = *found;
    const ReadTime time = readTime(m_hovered ? m_hoverTime : m_time.value_or(0.0));
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(m_maximized ? tr("Show all plots agai&n") : tr("&Maximize this plot"), this,
                    [this, plot] { toggleMaximized(plot); });
    menu->addAction(tr("Reset plot &zoom"), this, &PlotGrid::showAll);
    menu->addSeparator();
    menu->addAction(tr("Copy the &values here"), this, [this, plot, time] {
        QStringList cells{typedNumberText(time.t)}; // with all digits
        for (const PlotReading &reading : readings(plot, time)) {
            cells << typedNumberText(reading.number);
        }
        QGuiApplication::clipboard()->setText(cells.join(u'\t'));
    });
    menu->addAction(tr("&Copy this plot"), this, [this, plot] { emit copyPlotRequested(plotName(plot)); });
    menu->addAction(tr("&Export this plot…"), this, [this, plot] { emit exportPlotRequested(plotName(plot)); });
    menu->addSeparator();
    menu->addActions(m_choices);
    menu->popup(event->globalPos());
}

} // namespace slidercrank
