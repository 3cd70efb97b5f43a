// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "ui/document/setting_action.h"
#include "ui/plots/plot_drawing.h"
#include "ui/text/channel_text.h"
#include "ui/text/written_number.h"

#include <QActionGroup>
#include <QLabel>
#include <QPainter>
#include <QRubberBand>
#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PlotGrid::PlotGrid()
    : m_hint(new QLabel(tr("To compare with a simulation, <a href=\"open\">open its CSV…</a> or drop it here."), this))
    , m_rubberBand(new QRubberBand(QRubberBand::Rectangle, this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(tr("Plots of the motion"));
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        m_panes[plot] = new PlotPane(m_picture, this);
        m_panes[plot]->setObjectName(plotName(plot));
        m_panes[plot]->setAccessibleName(isErrorPlot(plot) ? nameOfErrors(orderOfPlot(plot))
                                                           : quantityName(kPlottedChannels[channelIndex(plot)]));
    }
    setObjectName("plots");
    m_hint->setObjectName("no_reference_hint");
    m_hint->setAutoFillBackground(true);
    m_hint->setBackgroundRole(QPalette::Base);                   // the background of the figure
    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse); // the keyboard uses the menu instead
    connect(m_hint, &QLabel::linkActivated, this, &PlotGrid::openReferenceRequested);
    makeChoices();
}

void PlotGrid::makeChoices()
{
    auto *measures = new QActionGroup(this);
    for (const auto &[text, measure] : {std::pair{tr("Error in % of the &peak"), ErrorMeasure::OfPeak},
                                        {tr("Error in &% of the reference"), ErrorMeasure::Percent},
                                        {tr("A&bsolute error"), ErrorMeasure::Absolute}}) {
        m_choices << measures->addAction(makeSettingAction(this, text, &PlotSettings::error, measure, measure));
    }
    m_choices << makeSwitchAction(this, tr("&Logarithmic errors"), &PlotSettings::logarithmicError)
              << makeSwitchAction(this, tr("File's &rounding"), &PlotSettings::roundingBand);
    m_errorChoices = m_choices;
    m_choices << makeSettingAction(this, tr("Over the crank &angle"), &PlotSettings::abscissa, Abscissa::CrankAngle,
                                   Abscissa::Time);
}

QStringList PlotGrid::plotNames()
{
    QStringList names;
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        names << plotName(plot);
    }
    return names;
}

std::vector<std::size_t> PlotGrid::plotsNamed(const QStringList &names)
{
    std::vector<std::size_t> plots;
    for (const QString &name : names) {
        plots.push_back(static_cast<std::size_t>(plotNames().indexOf(name)));
    }
    return plots;
}

void PlotGrid::setPose(const Pose &pose)
{
    m_time = pose.time;
    moveCursors();
}

void PlotGrid::showAll()
{
    setZoom({});
}

void PlotGrid::showTime(double seconds)
{
    const Interval shownTime = timeRange();
    if (zoom().time && !shownTime.contains(seconds)) {
        const double half = 0.5 * shownTime.length();
        zoomTime({seconds - half, seconds + half});
    }
}

void PlotGrid::setSettings(const PlotSettings &settings)
{
    if (settings != this->settings()) {
        PlotFigure::setSettings(settings);
        emit settingsChanged(settings);
    }
}

std::vector<std::size_t> PlotGrid::plotsToShow(const std::optional<std::size_t> &maximized) const
{
    std::vector<std::size_t> plots;
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        if (maximized ? plot == *maximized : !isErrorPlot(plot) || hasErrors()) {
            plots.push_back(plot);
        }
    }
    return plots;
}

/// From now on, the figure paints itself below the panes.
void PlotGrid::requestRefresh()
{
    for (PlotPane *pane : m_panes) {
        pane->setAttribute(Qt::WA_OpaquePaintEvent, false);
    }
    PlotFigure::requestRefresh();
}

bool PlotGrid::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::PaletteChange: {
        const QString hint = m_hint->text();
        m_hint->clear(); // a label gives links their colour when its text is set
        m_hint->setText(hint);
        requestRefresh();
        break;
    }
    case QEvent::FontChange:
    case QEvent::Resize: requestRefresh(); break;
    case QEvent::LayoutRequest:
        if (isVisible()) { // a hidden widget is refreshed when it is painted
            refreshIfStale();
        }
        break;
    default: break;
    }
    return PlotFigure::event(event);
}

void PlotGrid::refreshIfStale()
{
    const bool isOtherScreen = !m_picture.isNull() && m_picture.devicePixelRatio() != devicePixelRatioF();
    if (result() && (m_isStale || isOtherScreen)) {
        refresh();
    }
}

void PlotGrid::refresh()
{
    requestRefresh(); // the panes stay transparent until there is a new picture
    compose({.plots = plotsToShow(m_maximized), .font = font(), .palette = palette()}, size());
    m_picture = QPixmap();
    for (std::size_t index = 0; index < kPlotCount; ++index) {
        const Plot &plot = shownPlot(index);
        m_panes[index]->setVisible(plot.axes != nullptr);
        if (plot.axes) {
            m_panes[index]->setFont(PlotFonts(font()).tick);
            m_panes[index]->setGeometry(plot.axes->outerRect());
            m_panes[index]->setAccessibleDescription(plot.titles.front().text() + ". " + plot.note);
        }
    }
    for (QAction *choice : m_errorChoices) {
        choice->setVisible(hasErrors());
    }
    const bool needsHint = !result()->isCompared() && !m_maximized && !isPresentation();
    constexpr int kGap = 12; // px, to the edge of the figure
    const int hintWidth = m_hint->sizeHint().width();
    m_hint->setGeometry(width() - hintWidth - kGap, 0, hintWidth, m_legendSize.height());
    m_hint->setVisible(needsHint && m_legendSize.width() < m_hint->x());
    placeCursors();
    update();
}

/// Returns the cursors of a plot, in its pane: at the current time and at the pointer.
std::vector<PlotCursor> PlotGrid::cursors(std::size_t plot)
{
    const QPoint corner = m_panes[plot]->pos();
    std::vector<PlotCursor> cursors;
    const auto add = [&](std::optional<PlotCursor> cursor) {
        if (cursor) {
            cursors.push_back(translated(*std::move(cursor), -corner));
        }
    };
    if (m_time) {
        add(cursorAt(plot, *m_time, {}));
    }
    if (m_hovered) {
        const ReadTime hovered = readTime(m_hoverTime);
        QStringList headings;
        if (plot == *m_hovered) {
            headings << timeText(hovered.t);
            if (m_time) {
                headings << timeText(hovered.t, m_time);
            }
        }
        std::optional<PlotCursor> atPointer = cursorAt(plot, hovered.t, headings);
        if (atPointer) {
            atPointer->followsPointer = true;
        }
        add(std::move(atPointer));
    }
    return cursors;
}

QRect PlotGrid::axes(std::size_t plot) const
{
    return shownPlot(plot).axes->rect();
}

void PlotGrid::moveCursors()
{
    if (m_isStale) {
        return; // refresh() moves them
    }
    // The picture is not made earlier, because it would be of no use while the figure changes, as during a drag.
    if (m_picture.isNull() && isVisible()) {
        m_picture = QPixmap(size() * devicePixelRatioF());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        drawInto(m_picture);
        for (const std::size_t plot : plots()) {
            m_panes[plot]->setAttribute(Qt::WA_OpaquePaintEvent);
        }
    }
    placeCursors();
}

void PlotGrid::placeCursors()
{
    for (const std::size_t plot : plots()) {
        m_panes[plot]->setCursors(cursors(plot), axes(plot).translated(-m_panes[plot]->pos()));
    }
}

void PlotGrid::paintEvent(QPaintEvent *)
{
    refreshIfStale(); // grab() paints hidden widgets, too
    if (m_picture.isNull()) {
        drawInto(*this);
    } else {
        QPainter(this).drawPixmap(0, 0, m_picture);
    }
}

void PlotGrid::paintFigure(QPainter &painter, const FigureContent &content, const QSize &size, const QPalette &palette)
{
    const std::vector<std::size_t> plots = content.plots.empty() ? plotsToShow({}) : content.plots;
    const QScopedValueRollback zoomOnScreen(m_zoom.time, content.time ? content.time : m_zoom.time);
    compose({.plots = plots,
             .font = painter.font(),
             .palette = palette,
             .maxColumns = columnsThatFit(size.width(), painter.font()),
             .detail = smallestDetail(painter),
             .cursorTime = content.cursorTime},
            size);
    paint(painter);
    requestRefresh(); // restores the figure for the screen
}

std::vector<NamedPlot> PlotGrid::choosablePlots() const
{
    std::vector<NamedPlot> plots;
    for (const std::size_t plot : plotsToShow({})) {
        plots.push_back({.name = plotName(plot), .text = m_panes[plot]->accessibleName()});
    }
    return plots;
}

int PlotGrid::figureHeight(const FigureContent &content, int width, const QFont &font)
{
    const std::vector<std::size_t> plots = content.plots.empty() ? plotsToShow({}) : content.plots;
    const int height = heightFor(plots, width, font);
    compose({.plots = plots, .font = font, .maxColumns = columnsThatFit(width, font), .cursorTime = content.cursorTime},
            {width, height});
    requestRefresh(); // restores the figure for the screen
    return height + excessOfLegend();
}

} // namespace slidercrank

#include "moc_plot_grid.cpp"
