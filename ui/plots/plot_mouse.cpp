// SPDX-License-Identifier: GPL-3.0-or-later

// What mouse and keys do to the plots.

#include "ui/plots/figure_plot.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/written_number.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The range shrunk or widened about one of its points.
Interval scale(const Interval &range, double about, double factor)
{
    return {about - (about - range.lower) * factor, about + (range.upper - about) * factor};
}

Interval rangeOf(const QCPAxis &axis)
{
    return {axis.range().lower, axis.range().upper};
}

} // namespace

double PlotGrid::timeAt(std::size_t plot, double x) const
{
    return m_drawing->axes(plot).axis(QCPAxis::atBottom)->pixelToCoord(x + m_panes[plot]->x());
}

double PlotGrid::valueAt(std::size_t plot, double y) const
{
    return m_drawing->axes(plot).axis(QCPAxis::atLeft)->pixelToCoord(y + m_panes[plot]->y());
}

bool PlotGrid::eventFilter(QObject *watched, QEvent *event)
{
    const auto found = std::ranges::find(m_panes, watched);
    if (found == m_panes.end()) {
        return QWidget::eventFilter(watched, event);
    }
    const auto plot = static_cast<std::size_t>(found - m_panes.begin());
    if (m_isStale && event->type() != QEvent::Paint && dynamic_cast<QInputEvent *>(event)) {
        refresh(); // what is pointed at is where it is painted
    }
    switch (event->type()) {
    case QEvent::Wheel: turnWheel(plot, *static_cast<QWheelEvent *>(event)); return true;
    case QEvent::MouseButtonPress: press(plot, *static_cast<QMouseEvent *>(event)); return true;
    case QEvent::MouseMove: move(plot, static_cast<QMouseEvent *>(event)->pos()); return true;
    case QEvent::MouseButtonRelease: release(plot, *static_cast<QMouseEvent *>(event)); return true;
    case QEvent::MouseButtonDblClick:
        if (static_cast<QMouseEvent *>(event)->pos().y() < m_panes[plot]->axes().top()) {
            toggleMaximized(plot); // on the title
        } else {
            showAll();
        }
        return true;
    case QEvent::Hide:
        if (m_drag && m_drag->plot == plot) {
            endDrag();
        }
        return false;
    case QEvent::Leave:
        m_hovered.reset();
        moveCursors();
        return false;
    case QEvent::KeyPress: return pressKey(plot, static_cast<QKeyEvent *>(event)->key());
    case QEvent::ContextMenu: showMenu(plot, static_cast<QContextMenuEvent *>(event)->globalPos()); return true;
    default: return QWidget::eventFilter(watched, event);
    }
}

void PlotGrid::turnWheel(std::size_t plot, const QWheelEvent &wheel)
{
    if (m_drag) {
        return; // what is framed or held is not to move away
    }
    constexpr double kNotch = 120.0;
    constexpr double kFactor = 0.85;
    const double factor = std::pow(kFactor, wheel.angleDelta().y() / kNotch);
    const QPointF at = wheel.position();
    if (at.x() >= m_panes[plot]->axes().left()) {
        m_figure.zoomTime(scale(m_figure.timeRange(), timeAt(plot, at.x()), factor));
    } else if (m_drawing->hasValues(plot)) {
        const Interval values = rangeOf(*m_drawing->axes(plot).axis(QCPAxis::atLeft));
        m_figure.zoomValues(plot, scale(values, valueAt(plot, at.y()), factor));
    }
    requestRefresh();
}

/// The measuring cursor, 0 or 1, at a position in a pane.
std::optional<std::size_t> PlotGrid::measuringCursorAt(std::size_t plot, const QPoint &position) const
{
    constexpr double kReach = 5.0; // px
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; m_measured && i < m_measured->size(); ++i) {
        const double x = m_drawing->axes(plot).axis(QCPAxis::atBottom)->coordToPixel((*m_measured)[i]);
        const double distance = std::abs(x - m_panes[plot]->x() - position.x());
        if (distance <= least && m_panes[plot]->axes().contains(position)) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void PlotGrid::press(std::size_t plot, const QMouseEvent &mouse)
{
    const bool isLeft = mouse.button() == Qt::LeftButton;
    if (!(isLeft || mouse.button() == Qt::MiddleButton) || (m_drag && m_drag->button != mouse.button())) {
        return;
    }
    if (m_drag) { // its release went elsewhere
        endDrag();
    }
    Drag drag{.plot = plot, .button = mouse.button(), .start = mouse.pos(), .last = mouse.pos(), .before = zoom()};
    if (!isLeft || mouse.modifiers().testFlag(Qt::ShiftModifier)) {
        drag.kind = Drag::Kind::Pan;
    } else if (const std::optional<std::size_t> cursor = measuringCursorAt(plot, mouse.pos())) {
        drag.kind = Drag::Kind::MeasuringCursor;
        drag.measuringCursor = *cursor;
    }
    m_drag = drag;
}

void PlotGrid::move(std::size_t plot, const QPoint &to)
{
    PlotPane &pane = *m_panes[plot];
    const double time = m_figure.roundedTime(timeAt(plot, to.x()));
    if (!m_drag) {
        const bool isOverCursor = measuringCursorAt(plot, to).has_value();
        pane.setCursor(isOverCursor ? Qt::SplitHCursor : Qt::ArrowCursor);
        m_hovered = !isOverCursor && pane.axes().contains(to) ? std::optional(plot) : std::nullopt;
        m_hoverTime = time;
        moveCursors();
        return;
    }
    if (!m_drag->hasMoved && (to - m_drag->start).manhattanLength() >= QApplication::startDragDistance()) {
        m_drag->hasMoved = true;
        pane.grabKeyboard(); // for Escape
        pane.setCursor(m_drag->kind == Drag::Kind::Pan ? Qt::ClosedHandCursor : pane.cursor());
    }
    if (m_drag->kind == Drag::Kind::MeasuringCursor && m_measured) {
        (*m_measured)[m_drag->measuringCursor] = m_figure.readTime(time).t;
    }
    if (m_drag->kind == Drag::Kind::Pan && m_drag->hasMoved) {
        pan(plot, to);
    }
    if (m_drag->hasMoved) {
        m_drag->last = to;
    }
    pane.setFrame(m_drag->kind == Drag::Kind::Box && m_drag->hasMoved ? draggedBox() : QRect());
    moveCursors();
}

void PlotGrid::release(std::size_t plot, const QMouseEvent &mouse)
{
    if (!m_drag || mouse.button() != m_drag->button) {
        return;
    }
    const bool isOfBox = m_drag->kind == Drag::Kind::Box;
    const bool isClick = isOfBox && !m_drag->hasMoved;
    const QRect box = isOfBox && m_drag->hasMoved ? draggedBox() : QRect();
    endDrag();
    if (!box.isNull()) {
        zoomInto(plot, box);
    } else if (isClick && m_panes[plot]->axes().contains(mouse.pos())) {
        emit timeRequested(m_figure.readTime(timeAt(plot, mouse.pos().x())).t);
    }
}

void PlotGrid::endDrag()
{
    PlotPane &pane = *m_panes[m_drag->plot];
    m_drag.reset();
    pane.releaseKeyboard();
    pane.setCursor(Qt::ArrowCursor);
    pane.setFrame({});
    moveCursors();
}

void PlotGrid::pan(std::size_t plot, const QPoint &to)
{
    const double dt = timeAt(plot, m_drag->last.x()) - timeAt(plot, to.x());
    const double dv = valueAt(plot, m_drag->last.y()) - valueAt(plot, to.y());
    const Interval time = m_figure.timeRange();
    m_figure.zoomTime({time.lower + dt, time.upper + dt});
    if (std::optional<Interval> &values = m_figure.zoom.values[plot]) {
        values = Interval{values->lower + dv, values->upper + dv};
    }
    refresh(); // the next move starts from what is shown then
}

/// What a drag zooms into: all values where it is flat, all of the time where it is narrow. Null where it is both.
QRect PlotGrid::draggedBox() const
{
    constexpr int kLeast = 8; // px
    const QRect axes = m_panes[m_drag->plot]->axes();
    const QPoint start(std::clamp(m_drag->start.x(), axes.left(), axes.right()),
                       std::clamp(m_drag->start.y(), axes.top(), axes.bottom()));
    const QPoint end(std::clamp(m_drag->last.x(), axes.left(), axes.right()),
                     std::clamp(m_drag->last.y(), axes.top(), axes.bottom()));
    const bool isNarrow = std::abs(end.x() - start.x()) < kLeast;
    const bool isFlat = std::abs(end.y() - start.y()) < kLeast;
    if (isNarrow && isFlat) {
        return {};
    }
    QRect box(QPoint(std::min(start.x(), end.x()), std::min(start.y(), end.y())),
              QPoint(std::max(start.x(), end.x()), std::max(start.y(), end.y())));
    if (isNarrow) {
        box = QRect(axes.left(), box.top(), axes.width(), box.height());
    }
    return isFlat ? QRect(box.left(), axes.top(), box.width(), axes.height()) : box;
}

void PlotGrid::zoomInto(std::size_t plot, const QRect &box)
{
    const QRect axes = m_panes[plot]->axes();
    if (box.width() < axes.width()) {
        m_figure.zoomTime({timeAt(plot, box.left()), timeAt(plot, box.right())});
    }
    if (box.height() < axes.height() && m_drawing->hasValues(plot)) {
        m_figure.zoomValues(plot, {valueAt(plot, box.bottom()), valueAt(plot, box.top())});
    }
    requestRefresh();
}

/// Keys of the plot that has the focus, or over which a button is held. + and − zoom about the time on show; 1 and 2
/// bring the measuring cursors to it.
bool PlotGrid::pressKey(std::size_t plot, int key)
{
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter: toggleMaximized(plot); return true;
    case Qt::Key_Escape:
        if (m_drag) {
            const PlotZoom before = m_drag->before;
            endDrag();
            setZoom(before);
            return true;
        }
        if (m_maximized) {
            maximize({});
            return true;
        }
        return false;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: {
        constexpr double kFactor = 0.7;
        const Interval shown = m_figure.timeRange();
        const double about = m_time && shown.contains(*m_time) ? *m_time : 0.5 * (shown.lower + shown.upper);
        m_figure.zoomTime(scale(shown, about, key == Qt::Key_Minus ? 1.0 / kFactor : kFactor));
        requestRefresh();
        return true;
    }
    case Qt::Key_0: showAll(); return true;
    case Qt::Key_1:
    case Qt::Key_2:
        if (!m_measured || !m_time) {
            return false;
        }
        (*m_measured)[key == Qt::Key_1 ? 0 : 1] = m_figure.readTime(*m_time).t;
        moveCursors();
        return true;
    default: return false;
    }
}

void PlotGrid::toggleMaximized(std::size_t plot)
{
    maximize(m_maximized ? QString() : plotName(plot));
    m_panes[plot]->setFocus(Qt::OtherFocusReason); // Escape brings all back
}

/// Time and values with all their digits.
void PlotGrid::copyValues(std::size_t plot, const ReadTime &time)
{
    QStringList cells{typedNumberText(time.t)};
    for (const PlotReading &reading : m_figure.readings(plot, time)) {
        cells << typedNumberText(reading.number);
    }
    QGuiApplication::clipboard()->setText(cells.join(u'\t'));
}

void PlotGrid::showMenu(std::size_t plot, const QPoint &globalPosition)
{
    const ReadTime time = m_figure.readTime(m_hovered ? m_hoverTime : m_time.value_or(0.0));
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(m_maximized ? tr("Show all plots agai&n") : tr("&Maximize this plot"), this,
                    [this, plot] { toggleMaximized(plot); });
    menu->addAction(tr("Show the &whole run"), this, &PlotGrid::showAll);
    menu->addSeparator();
    menu->addAction(tr("Copy the &values here"), this, [this, plot, time] { copyValues(plot, time); });
    menu->addAction(tr("&Copy this plot"), this, [this, plot] { emit copyPlotRequested(plotName(plot)); });
    menu->addAction(tr("&Export this plot…"), this, [this, plot] { emit exportPlotRequested(plotName(plot)); });
    menu->addAction(tr("&Keep this motion"), this, &PlotGrid::keepRequested);
    menu->addSeparator();
    menu->addActions(m_choices);
    menu->popup(globalPosition);
}

} // namespace slidercrank
