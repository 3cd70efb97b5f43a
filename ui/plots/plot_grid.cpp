// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "ui/plots/figure_painting.h"
#include "ui/plots/plot_canvas.h"
#include "ui/plots/reading_place.h"
#include "ui/text/axis_scale.h"
#include "ui/text/theme.h"

#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// The line of the instant on show, over a plot.
class CursorLine : public QWidget
{
public:
    explicit CursorLine(QWidget *plot)
        : QWidget(plot)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent *) override { QPainter(this).fillRect(rect(), palette().window()); }
};

} // namespace

PlotGrid::PlotGrid(QWidget *parent)
    : QWidget(parent)
    , m_typography(font())
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Plots of the motion"));
    const std::array<QString, kPlotCount> accessibleNames{tr("Coupler angle θ³ over time"),
                                                          tr("Slider position R_x⁴ over time"),
                                                          tr("Error of the positions over time"),
                                                          tr("Coupler angular velocity dθ³/dt over time"),
                                                          tr("Slider velocity dR_x⁴/dt over time"),
                                                          tr("Error of the velocities over time"),
                                                          tr("Coupler angular acceleration d²θ³/dt² over time"),
                                                          tr("Slider acceleration d²R_x⁴/dt² over time"),
                                                          tr("Error of the accelerations over time")};
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i] = new PlotCanvas(this);
        m_plots[i]->setObjectName(plotName(i));
        m_plots[i]->setAccessibleName(accessibleNames[i]);
        m_plots[i]->installEventFilter(this);
        m_cursors[i] = new CursorLine(m_plots[i]);
        m_overlays[i] = new PlotOverlay(m_plots[i]);
        m_plots[i]->setFocusPolicy(Qt::TabFocus);
    }
    makeChoices();
    emit settingsChanged(m_figure.settings());
    m_hint = new QLabel(this);
    m_hint->setObjectName(QStringLiteral("no_reference_hint"));
    m_hint->setTextFormat(Qt::RichText);
    m_hint->setText(tr("To compare with a simulation, <a href=\"open\">open its CSV…</a> or drop it here."));
    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse); // a label's focus is not seen; by keys there is a menu
    m_hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(m_hint, &QLabel::linkActivated, this, [this] { emit openReferenceRequested(); });
    QEvent paletteChange(QEvent::PaletteChange);
    changeEvent(&paletteChange);
}

QStringList PlotGrid::plotNames()
{
    QStringList names;
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        names << plotName(i);
    }
    return names;
}

QSize PlotGrid::sizeHint() const
{
    return {900, 600};
}

QSize PlotGrid::minimumSizeHint() const
{
    return {420, 230}; // not beautiful, but there on a screen of 800×600
}

void PlotGrid::setResult(const std::shared_ptr<const Result> &result)
{
    const bool hadErrors = m_figure.hasErrors();
    m_figure.setResult(result);
    if (m_figure.hasErrors() != hadErrors) {
        placePlots();
    }
    updateHint();
    requestRefresh();
    update(QRect(0, 0, width(), m_typography.legendHeight()));
}

void PlotGrid::setPose(const Pose &pose)
{
    m_cursorTime = pose.time;
    moveCursors();
}

void PlotGrid::showAll()
{
    setZoom({});
}

void PlotGrid::setZoom(const PlotZoom &zoom)
{
    m_figure.timeZoom = zoom.time;
    m_figure.valueZoom = zoom.values;
    requestRefresh();
}

void PlotGrid::setSettings(const PlotSettings &settings)
{
    if (settings == m_figure.settings()) {
        return;
    }
    m_figure.setSettings(settings);
    emit settingsChanged(settings);
    requestRefresh();
    update(QRect(0, 0, width(), m_typography.legendHeight()));
}

/// Any number of requests in one pass of the event loop make one refresh; a hidden widget waits until it is shown.
void PlotGrid::requestRefresh()
{
    m_isStale = true;
    if (!isVisible() || m_isRefreshQueued) {
        return;
    }
    m_isRefreshQueued = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isRefreshQueued = false;
            if (m_isStale && isVisible()) {
                refresh();
            }
        },
        Qt::QueuedConnection);
}

PlotArrangement PlotGrid::arrangementOnScreen() const
{
    return PlotArrangement(size(), m_typography, m_figure.hasErrors(), m_maximized);
}

void PlotGrid::refresh()
{
    m_isStale = false;
    const std::array<PlacedPlot, kPlotCount> plots = placedPlots(m_figure, arrangementOnScreen(), m_typography);
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        if (plots[i].cell.isEmpty()) {
            continue;
        }
        m_plots[i]->display(plots[i].picture, plots[i].margins);
        m_plots[i]->replot(QCustomPlot::rpQueuedRefresh);
    }
    moveCursors();
    for (QWidget *cursor : m_cursors) {
        // Around an opaque line Qt paints the plot in pieces, which takes longer than all of it at once.
        cursor->setAttribute(Qt::WA_OpaquePaintEvent, false);
    }
    updateOverlays();
}

void PlotGrid::placePlots()
{
    const PlotArrangement arrangement = arrangementOnScreen();
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->setVisible(!arrangement.cells[i].isEmpty());
        if (!arrangement.cells[i].isEmpty()) {
            m_plots[i]->setGeometry(arrangement.cells[i]);
        }
    }
    updateHint();
}

void PlotGrid::moveCursors()
{
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        const QRect axes = m_plots[i]->axisRect()->rect();
        const bool isInRange = m_cursorTime && m_plots[i]->hasValues() &&
                               m_plots[i]->timeRange().contains(*m_cursorTime) && axes.width() > 1;
        if (isInRange) {
            const int x = static_cast<int>(std::lround(m_plots[i]->xAxis->coordToPixel(*m_cursorTime)));
            const QRect line(x, axes.top(), 1, axes.height());
            if (m_cursors[i]->geometry() != line) {
                m_cursors[i]->setAttribute(Qt::WA_OpaquePaintEvent); // under it nothing needs to be painted
                m_cursors[i]->setGeometry(line);
            }
        }
        m_cursors[i]->setVisible(isInRange);
    }
}

/// In the legend's line, where that has room for it.
void PlotGrid::updateHint()
{
    const QSize size = m_hint->sizeHint();
    constexpr int kGap = 12;
    constexpr int kRoomForSample = 66; // px: a line of the legend and the gaps around it
    int room = width() - size.width() - 2 * kGap;
    for (const LegendEntry &entry : m_figure.legend(m_maximized)) {
        room -= kRoomForSample + QFontMetrics(m_typography.title).horizontalAdvance(entry.text);
    }
    m_hint->setVisible(!m_figure.hasErrors() && !m_maximized && !m_read.measured && room >= 0);
    m_hint->setGeometry(width() - size.width() - kGap, 0, size.width(), m_typography.legendHeight());
}

void PlotGrid::pan(std::size_t plot, const QPoint &to)
{
    const PlotCanvas &shown = *m_plots[plot];
    const double dt = shown.xAxis->pixelToCoord(m_drag->last.x()) - shown.xAxis->pixelToCoord(to.x());
    const double dv = shown.yAxis->pixelToCoord(m_drag->last.y()) - shown.yAxis->pixelToCoord(to.y());
    const Interval time = m_figure.timeRange();
    m_figure.zoomTime({time.lower + dt, time.upper + dt});
    if (std::optional<Interval> &values = m_figure.valueZoom[plot]) {
        values = Interval{values->lower + dv, values->upper + dv};
    }
    requestRefresh();
}

void PlotGrid::showMenu(std::size_t plot, const QPoint &globalPosition)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(m_maximized ? tr("Show all plots agai&n") : tr("&Maximize this plot")), &QAction::triggered,
            this, [this, plot] { toggleMaximized(plot); });
    connect(menu->addAction(tr("Show the &whole run")), &QAction::triggered, this, &PlotGrid::showAll);
    menu->addSeparator();
    connect(menu->addAction(tr("&Copy this plot")), &QAction::triggered, this,
            [this, plot] { emit copyPlotRequested(plotName(plot)); });
    connect(menu->addAction(tr("&Export this plot…")), &QAction::triggered, this,
            [this, plot] { emit exportPlotRequested(plotName(plot)); });
    connect(menu->addAction(tr("&Keep this motion")), &QAction::triggered, this, &PlotGrid::keepRequested);
    menu->addSeparator();
    menu->addActions(m_choices);
    menu->popup(globalPosition);
}

void PlotGrid::maximize(const QString &name)
{
    const qsizetype index = plotNames().indexOf(name);
    m_maximized.reset();
    if (index >= 0) {
        m_maximized = static_cast<std::size_t>(index);
    }
    m_read.hovered.reset();
    placePlots();
    requestRefresh();
}

void PlotGrid::toggleMaximized(std::size_t plot)
{
    maximize(m_maximized ? QString() : plotName(plot));
    m_plots[plot]->setFocus(Qt::OtherFocusReason); // Escape brings all back
}

void PlotGrid::setMeasuring(bool measuring)
{
    if (measuring != m_read.measured.has_value()) {
        m_read.measured.reset();
        if (measuring) {
            const Interval range = m_figure.timeRange();
            const double third = range.length() / 3.0;
            m_read.measured = {m_figure.nearestInstant(m_figure.pointedInstant(range.lower + third)),
                               m_figure.nearestInstant(m_figure.pointedInstant(range.upper - third))};
        }
        updateOverlays();
    }
    updateHint();
    if (QAction *action = findChild<QAction *>(QStringLiteral("measuringAction"))) {
        action->setChecked(measuring);
    }
}

void PlotGrid::setMeasured(const std::optional<std::array<double, 2>> &instants)
{
    setMeasuring(instants.has_value());
    m_read.measured = instants;
    updateOverlays();
}

void PlotGrid::hoverOver(std::optional<std::size_t> plot, double time)
{
    m_read.hovered = plot;
    m_read.hoverTime = time;
    updateOverlays();
}

OverlayContent PlotGrid::overlayOf(std::size_t plot)
{
    const PlotCanvas &shown = *m_plots[plot];
    OverlayContent content;
    content.axes = shown.axisRect()->rect();
    content.hasFocus = shown.hasFocus();
    if (!shown.hasValues()) {
        return content;
    }
    PlotSight sight{content.axes, shown.curvesInPixels(), {}, {}};
    const auto readAt = [&](double time, const QString &name, bool isSolid) {
        if (shown.timeRange().contains(time)) {
            const int x = static_cast<int>(std::lround(shown.xAxis->coordToPixel(time)));
            content.lines.push_back({x, name, isSolid});
            sight.lines.push_back(x);
        }
        for (const ReadPoint &read : pointsReadAt(m_figure, plot, time)) {
            const QCPAxis *valueAxis = shown.valueAxisOf(read.ink == Ink::ErrorOther ? 1 : 0);
            const QPointF at(shown.xAxis->coordToPixel(read.point.t), valueAxis->coordToPixel(read.point.value));
            if (QRectF(content.axes).contains(at)) {
                content.dots.push_back({at, read.ink});
                sight.dots.push_back(at);
            }
        }
    };
    if (m_read.measured) {
        const auto [first, second] = *m_read.measured;
        readAt(first, QStringLiteral("1"), true);
        readAt(second, QStringLiteral("2"), true);
    }
    if (m_read.hovered) {
        readAt(m_read.hoverTime, {}, false);
    }
    constexpr int kInset = 3; // px
    const QRect room(kInset, content.axes.top() + kInset, shown.width() - 2 * kInset,
                     content.axes.height() - 2 * kInset);
    double leastHidden = 0.0;
    for (const Wording wording : {Wording::Full, Wording::Brief}) { // briefly only where that hides less
        const std::vector<InkedRow> rows = readingsOf(m_figure, plot, m_read, wording);
        const ReadingPlace place = placeOfReading(m_overlays[plot]->sizeOf(rows), room, sight);
        if (content.box.empty() || place.hidden < leastHidden) {
            content.box = rows;
            content.boxPlace = place.topLeft;
            leastHidden = place.hidden;
        }
        if (rows.empty() || leastHidden == 0.0) {
            break;
        }
    }
    return content;
}

void PlotGrid::updateOverlays()
{
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        const bool isFramed = m_drag && m_drag->plot == i && m_drag->kind == Drag::Kind::Box && m_drag->hasMoved;
        const bool isBare = !m_read.hovered && !m_read.measured && !m_plots[i]->hasFocus() && !isFramed;
        OverlayContent content = isBare || m_plots[i]->isHidden() ? OverlayContent() : overlayOf(i);
        if (isFramed) {
            content.frame = framedBox();
        }
        m_overlays[i]->setContent(content);
    }
    update(QRect(0, 0, width(), m_typography.legendHeight()));
}

/// 0 or 1.
std::optional<std::size_t> PlotGrid::measuringCursorAt(std::size_t plot, const QPoint &position) const
{
    if (!m_read.measured || !m_plots[plot]->axisRect()->rect().contains(position)) {
        return std::nullopt;
    }
    constexpr double kReach = 5.0; // px
    std::optional<std::size_t> nearest;
    double distance = kReach;
    for (std::size_t cursor = 0; cursor < m_read.measured->size(); ++cursor) {
        const double x = m_plots[plot]->xAxis->coordToPixel((*m_read.measured)[cursor]);
        if (std::abs(x - position.x()) <= distance) {
            distance = std::abs(x - position.x());
            nearest = cursor;
        }
    }
    return nearest;
}

/// Of the plot that has the focus, or over which a button is held. + and − zoom about the current instant; 1 and 2
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
        if (!m_maximized) {
            return false;
        }
        maximize({});
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: {
        constexpr double kFactor = 0.7;
        const Interval shown = m_figure.timeRange();
        const bool sees = m_cursorTime && shown.contains(*m_cursorTime);
        m_figure.zoomTime(sees ? *m_cursorTime : 0.5 * (shown.lower + shown.upper),
                          key == Qt::Key_Minus ? 1.0 / kFactor : kFactor);
        requestRefresh();
        return true;
    }
    case Qt::Key_0: showAll(); return true;
    case Qt::Key_1:
    case Qt::Key_2:
        if (!m_read.measured || !m_cursorTime) {
            return false;
        }
        (*m_read.measured)[key == Qt::Key_1 ? 0 : 1] = m_figure.nearestInstant(*m_cursorTime);
        updateOverlays();
        return true;
    default: return false;
    }
}

void PlotGrid::pressOn(std::size_t plot, const QMouseEvent &mouse)
{
    const bool isLeft = mouse.button() == Qt::LeftButton;
    if (!(isLeft || mouse.button() == Qt::MiddleButton) || (m_drag && m_drag->button != mouse.button())) {
        return;
    }
    if (m_drag) { // its release went elsewhere
        endDrag();
    }
    Drag drag;
    drag.plot = plot;
    drag.button = mouse.button();
    drag.start = drag.last = mouse.pos();
    drag.before = zoom();
    const std::optional<std::size_t> cursor = measuringCursorAt(plot, mouse.pos());
    if (!isLeft || mouse.modifiers().testFlag(Qt::ShiftModifier)) {
        drag.kind = Drag::Kind::Move;
    } else if (cursor) {
        drag.kind = Drag::Kind::MeasuringCursor;
        drag.measuringCursor = *cursor;
    }
    m_drag = drag;
}

void PlotGrid::moveOver(std::size_t plot, const QPoint &to)
{
    PlotCanvas &shown = *m_plots[plot];
    const double time = m_figure.pointedInstant(shown.xAxis->pixelToCoord(to.x()));
    if (!m_drag) {
        const bool isOverCursor = measuringCursorAt(plot, to).has_value();
        shown.setCursor(isOverCursor ? Qt::SplitHCursor : Qt::ArrowCursor);
        const bool reads = !isOverCursor && shown.axisRect()->rect().contains(to);
        hoverOver(reads ? std::optional(plot) : std::nullopt, time);
        return;
    }
    if (!m_drag->hasMoved && (to - m_drag->start).manhattanLength() >= QApplication::startDragDistance()) {
        m_drag->hasMoved = true;
        shown.grabKeyboard(); // for Escape
        if (m_drag->kind == Drag::Kind::Move) {
            shown.setCursor(Qt::ClosedHandCursor);
        }
    }
    switch (m_drag->kind) {
    case Drag::Kind::MeasuringCursor:
        if (m_read.measured) {
            (*m_read.measured)[m_drag->measuringCursor] = m_figure.nearestInstant(time);
        }
        break;
    case Drag::Kind::Move:
        if (m_drag->hasMoved) {
            pan(plot, to);
        }
        break;
    case Drag::Kind::Box: break;
    }
    if (m_drag->hasMoved || m_drag->kind == Drag::Kind::MeasuringCursor) {
        m_drag->last = to;
        hoverOver(std::nullopt, time);
    }
}

void PlotGrid::releaseOver(std::size_t plot, const QMouseEvent &mouse)
{
    if (!m_drag || mouse.button() != m_drag->button) {
        return;
    }
    const bool isOfBox = m_drag->kind == Drag::Kind::Box;
    const bool isClick = isOfBox && !m_drag->hasMoved;
    const QRect box = isOfBox && m_drag->hasMoved ? framedBox() : QRect();
    endDrag();
    if (!box.isNull()) {
        zoomInto(plot, box);
    } else if (isClick && m_plots[plot]->axisRect()->rect().contains(mouse.pos())) {
        emit timeRequested(m_plots[plot]->xAxis->pixelToCoord(mouse.pos().x()));
    }
}

void PlotGrid::endDrag()
{
    PlotCanvas &held = *m_plots[m_drag->plot];
    m_drag.reset();
    held.releaseKeyboard();
    held.setCursor(Qt::ArrowCursor);
    updateOverlays();
}

/// What a drag of a box frames: all of the values where it is too flat, all of the time where it is too narrow. Null
/// where it is both.
QRect PlotGrid::framedBox() const
{
    constexpr int kLeast = 8; // px
    const QRect axes = m_plots[m_drag->plot]->axisRect()->rect();
    const auto spanOf = [](int from, int to, int lowest, int highest) {
        return std::pair(std::clamp(std::min(from, to), lowest, highest),
                         std::clamp(std::max(from, to), lowest, highest));
    };
    auto [left, right] = spanOf(m_drag->start.x(), m_drag->last.x(), axes.left(), axes.right());
    auto [top, bottom] = spanOf(m_drag->start.y(), m_drag->last.y(), axes.top(), axes.bottom());
    const bool isNarrow = right - left < kLeast;
    const bool isFlat = bottom - top < kLeast;
    if (isNarrow && isFlat) {
        return {};
    }
    if (isNarrow) {
        left = axes.left();
        right = axes.right();
    }
    if (isFlat) {
        top = axes.top();
        bottom = axes.bottom();
    }
    return QRect(QPoint(left, top), QPoint(right, bottom));
}

void PlotGrid::zoomInto(std::size_t plot, const QRect &box)
{
    const PlotCanvas &shown = *m_plots[plot];
    const QRect axes = shown.axisRect()->rect();
    if (box.width() < axes.width()) {
        m_figure.zoomTime(Interval{shown.xAxis->pixelToCoord(box.left()), shown.xAxis->pixelToCoord(box.right())});
    }
    if (box.height() < axes.height() && shown.hasValues()) {
        m_figure.zoomValues(plot,
                            Interval{shown.yAxis->pixelToCoord(box.bottom()), shown.yAxis->pixelToCoord(box.top())});
    }
    requestRefresh();
}

bool PlotGrid::eventFilter(QObject *watched, QEvent *event)
{
    const auto found = std::find(m_plots.begin(), m_plots.end(), watched);
    if (found == m_plots.end()) {
        return QWidget::eventFilter(watched, event);
    }
    const auto index = static_cast<std::size_t>(found - m_plots.begin());
    PlotCanvas &plot = **found;
    switch (event->type()) {
    case QEvent::Resize: // QCustomPlot would replot at once, with curves decimated for the old size
        plot.setViewport(plot.rect());
        requestRefresh();
        return true;
    case QEvent::Wheel: {
        const auto *wheel = static_cast<QWheelEvent *>(event);
        if (m_drag) {
            return true; // what is framed or held is not to move away
        }
        constexpr double kNotch = 120.0;
        constexpr double kFactor = 0.85;
        const double factor = std::pow(kFactor, wheel->angleDelta().y() / kNotch);
        const QRect axes = plot.axisRect()->rect();
        if (wheel->position().x() >= axes.left()) {
            m_figure.zoomTime(plot.xAxis->pixelToCoord(wheel->position().x()), factor);
        } else if (plot.hasValues()) {
            m_figure.zoomValues(index, plot.valueRange(), plot.yAxis->pixelToCoord(wheel->position().y()), factor);
        }
        requestRefresh();
        event->accept();
        return true;
    }
    case QEvent::MouseButtonPress: pressOn(index, *static_cast<QMouseEvent *>(event)); return true;
    case QEvent::MouseMove: moveOver(index, static_cast<QMouseEvent *>(event)->pos()); return true;
    case QEvent::MouseButtonRelease: releaseOver(index, *static_cast<QMouseEvent *>(event)); return true;
    case QEvent::Hide:
        if (m_drag && m_drag->plot == index) {
            endDrag();
        }
        return false;
    case QEvent::MouseButtonDblClick: {
        const bool isTitle = static_cast<QMouseEvent *>(event)->pos().y() < plot.axisRect()->rect().top();
        if (isTitle) {
            toggleMaximized(index);
        } else {
            showAll();
        }
        return true;
    }
    case QEvent::Leave: hoverOver(std::nullopt, 0.0); return false;
    case QEvent::FocusIn:
    case QEvent::FocusOut:
        QMetaObject::invokeMethod(this, &PlotGrid::updateOverlays, Qt::QueuedConnection); // it has it only afterwards
        return false;
    case QEvent::KeyPress: return pressKey(index, static_cast<QKeyEvent *>(event)->key());
    case QEvent::ContextMenu: showMenu(index, static_cast<QContextMenuEvent *>(event)->globalPos()); return true;
    default: return QWidget::eventFilter(watched, event);
    }
}

bool PlotGrid::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && m_figure.result && m_figure.result->reference) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (help->pos().y() < m_typography.legendHeight()) { // the name may be elided there
            QToolTip::showText(help->globalPos(), m_figure.result->reference->paths.join(u'\n'), this);
            return true;
        }
    }
    return QWidget::event(event);
}

void PlotGrid::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    const bool isFont = event->type() == QEvent::FontChange;
    if (!isFont && event->type() != QEvent::PaletteChange) {
        return;
    }
    if (isFont) {
        m_typography = PlotTypography(font());
        placePlots();
    }
    const SeriesColours colours = seriesColours(palette());
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->setStyle(m_typography, colours);
        QPalette cursor;
        cursor.setColor(QPalette::Window, colours.cursor);
        m_cursors[i]->setPalette(cursor);
        m_overlays[i]->setStyle(m_typography.tick, colours);
    }
    requestRefresh();
}

void PlotGrid::paintEvent(QPaintEvent *)
{
    if (m_isStale) { // drawn without being visible, as grab() does
        refresh();
    }
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const SeriesColours colours = seriesColours(palette());
    QRect legend(0, 0, width(), m_typography.legendHeight());
    constexpr int kRoomForCurves = 300; // px: model, reference and a gap
    const QString measured = measuredText(m_figure, m_read, m_typography.title, width() - kRoomForCurves);
    if (!measured.isEmpty()) {
        constexpr int kGap = 12;
        painter.setFont(m_typography.title);
        painter.setPen(colours.text);
        painter.drawText(legend.adjusted(0, 0, -kGap, 0), Qt::AlignRight | Qt::AlignVCenter, measured);
        legend.setRight(legend.right() - QFontMetrics(m_typography.title).horizontalAdvance(measured) - 2 * kGap);
    }
    drawLegend(painter, legend, m_figure.legend(m_maximized), m_typography, colours);
}

void PlotGrid::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placePlots();
}

void PlotGrid::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale) {
        requestRefresh();
    }
}

void PlotGrid::paintFigure(QPainter &painter, const QSize &size, const QPalette &palette)
{
    paintPlots(painter, m_figure, PlotArrangement(size, m_typography, m_figure.hasErrors()), m_typography,
               seriesColours(palette), m_markedTime);
}

void PlotGrid::paintPlot(QPainter &painter, const QString &name, const QSize &size, const QPalette &palette)
{
    const auto index = static_cast<std::size_t>(plotNames().indexOf(name));
    Q_ASSERT(index < kPlotCount);
    paintPlots(painter, m_figure, PlotArrangement(size, m_typography, m_figure.hasErrors(), index), m_typography,
               seriesColours(palette), m_markedTime);
}

} // namespace slidercrank
