// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "ui/document/setting_action.h"
#include "ui/plots/plot_drawing.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QActionGroup>
#include <QLabel>
#include <QPainter>
#include <QRubberBand>

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
    const std::array errors{tr("Error of the positions"), tr("Error of the velocities"),
                            tr("Error of the accelerations")};
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        m_panes[plot] = new PlotPane(m_picture, this);
        m_panes[plot]->setObjectName(plotName(plot));
        m_panes[plot]->setAccessibleName(isErrorPlot(plot) ? errors[plot / kPlotColumns]
                                                           : quantityName(kPlottedChannels[channelOf(plot)]));
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
                                        {tr("Error &in ° and mm"), ErrorMeasure::Absolute}}) {
        m_choices << measures->addAction(makeSettingAction(this, text, &PlotSettings::error, measure, measure));
    }
    m_choices << makeSettingAction(this, tr("&Logarithmic errors"), &PlotSettings::logarithmicError, true, false)
              << makeSettingAction(this, tr("File's &rounding"), &PlotSettings::roundingBand, true, false)
              << makeSettingAction(this, tr("Over the crank &angle"), &PlotSettings::abscissa, Abscissa::CrankAngle,
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
    const Interval shown = timeRange();
    if (zoom().time && !shown.contains(seconds)) {
        const double half = 0.5 * shown.length();
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
    requestRefresh();
    compose({plotsToShow(m_maximized), font(), palette()}, size());
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
    const bool isAlone = !result()->isCompared() && !m_maximized && !isPresentation();
    constexpr int kGap = 12;
    const int hintWidth = m_hint->sizeHint().width();
    m_hint->setGeometry(width() - hintWidth - kGap, 0, hintWidth, m_legendSize.height());
    m_hint->setVisible(isAlone && m_legendSize.width() < m_hint->x());
    placeCursors();
    update();
}

/// Returns the cursors of a plot: at the current time and at the pointer.
std::vector<PlotPane::Cursor> PlotGrid::cursors(std::size_t plot)
{
    constexpr double kRoundingError = 1e-9; // of the axis
    const Plot &shown = shownPlot(plot);
    const QPoint corner = m_panes[plot]->pos();
    const SeriesColours colours = seriesColours(palette());
    std::vector<PlotPane::Cursor> cursors;
    const auto add = [&](double time, const QStringList &headings, bool isLight = false) {
        if (!shown.values || !timeRange().contains(time)) {
            return;
        }
        const ReadTime read = readTime(time);
        PlotPane::Cursor cursor{std::round(shown.timeAxis->coordToPixel(time)) - corner.x(), isLight, {}};
        for (const QString &heading : headings) {
            cursor.labels.push_back({QStaticText(heading), colours.text});
        }
        for (const PlotReading &reading : readings(plot, read)) {
            const QPointF place(shown.timeAxis->coordToPixel(read.t), shown.valueAxis->coordToPixel(reading.value));
            if (QRectF(axes(plot)).adjusted(-1.0, -1.0, 1.0, 1.0).contains(place)) {
                // On a linear axis, a value that is far below a pixel is the rounding error of zero.
                const bool isZero = reading.value == reading.number &&
                                    std::abs(reading.number) < kRoundingError * shown.valueAxis->range().size();
                cursor.labels.push_back(
                    {QStaticText(shortNumber(isZero ? 0.0 : reading.number)), colours.*reading.ink, place - corner});
            }
        }
        cursors.push_back(cursor);
    };
    if (m_time) {
        add(*m_time, {});
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
        add(hovered.t, headings, true);
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
    if (m_picture.isNull() && isVisible()) { // while the figure changes, as during a drag, it is of no use
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

void PlotGrid::paintFigure(QPainter &painter, const QString &name, const QSize &size, const QPalette &palette)
{
    const qsizetype index = plotNames().indexOf(name);
    const std::optional<std::size_t> plot = name.isEmpty() ? std::nullopt : std::optional<std::size_t>(index);
    compose({plotsToShow(plot), font(), palette}, size);
    paint(painter);
    requestRefresh(); // restores the figure for the screen
}

} // namespace slidercrank

#include "moc_plot_grid.cpp"
