// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "ui/document/with.h"
#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"

#include <QAction>
#include <QActionGroup>
#include <QLabel>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PlotGrid::PlotGrid(QWidget *parent)
    : QWidget(parent)
    , m_caption(new QLabel(this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(tr("Plots of the motion"));
    const std::array errors{tr("Error of the positions"), tr("Error of the velocities"),
                            tr("Error of the accelerations")};
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        m_panes[plot] = new PlotPane(m_picture, this);
        m_panes[plot]->setObjectName(plotName(plot));
        QString name = errors[plot / kPlotColumns];
        if (!isErrorPlot(plot)) {
            const Channel channel = kPlottedChannels[channelOf(plot)];
            name = QStringLiteral("%1 %2").arg(quantityOf(channel), symbolOf(channel));
            name[0] = name[0].toUpper();
        }
        m_panes[plot]->setAccessibleName(name);
    }
    m_caption->setObjectName(QStringLiteral("no_reference_hint"));
    m_caption->setAutoFillBackground(true);
    m_caption->setBackgroundRole(QPalette::Base); // the background of the figure
    m_caption->setTextInteractionFlags(Qt::LinksAccessibleByMouse); // the keyboard uses the menu instead
    connect(m_caption, &QLabel::linkActivated, this, &PlotGrid::openReferenceRequested);
    makeChoices();
    rebuild();
}

void PlotGrid::makeChoices()
{
    const auto add = [this](const QString &text, auto PlotSettings::*member, auto on, auto off) {
        auto *action = new QAction(text, this);
        action->setCheckable(true);
        action->setChecked(settings().*member == on);
        m_choices << action;
        connect(action, &QAction::triggered, this,
                [this, member, on, off](bool checked) { setSettings(with(settings(), member, checked ? on : off)); });
        connect(this, &PlotGrid::settingsChanged, action,
                [action, member, on](const PlotSettings &settings) { action->setChecked(settings.*member == on); });
        return action;
    };
    auto *measures = new QActionGroup(this);
    for (const auto &[text, measure] : {std::pair{tr("Error in % of the &peak"), ErrorMeasure::OfPeak},
                                        {tr("Error in &% of the reference"), ErrorMeasure::Percent},
                                        {tr("Error &in ° and mm"), ErrorMeasure::Absolute}}) {
        measures->addAction(add(text, &PlotSettings::error, measure, measure));
    }
    add(tr("&Logarithmic errors"), &PlotSettings::logarithmicError, true, false);
    add(tr("File's &rounding"), &PlotSettings::roundingBand, true, false);
    add(tr("Over the crank &angle"), &PlotSettings::abscissa, Abscissa::CrankAngle, Abscissa::Time);
    m_measuring = new QAction(tr("Mea&suring cursors"), this);
    m_measuring->setCheckable(true);
    m_choices << m_measuring;
    connect(m_measuring, &QAction::toggled, this, &PlotGrid::setMeasuring);
}

QStringList PlotGrid::plotNames()
{
    QStringList names;
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        names << plotName(plot);
    }
    return names;
}

void PlotGrid::setResult(const std::shared_ptr<const Result> &result)
{
    m_figure.setResult(result);
    if (plotsToShow() != m_figure.plots()) {
        rebuild();
    }
    requestRefresh();
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

void PlotGrid::setZoom(const PlotZoom &zoom)
{
    m_figure.zoom = zoom;
    requestRefresh();
}

void PlotGrid::showTime(double seconds)
{
    const Interval shown = m_figure.timeRange();
    if (zoom().time && !shown.contains(seconds)) {
        const double half = 0.5 * shown.length();
        m_figure.zoomTime({seconds - half, seconds + half});
        requestRefresh();
    }
}

void PlotGrid::setSettings(const PlotSettings &settings)
{
    if (settings != m_figure.settings()) {
        m_figure.setSettings(settings);
        emit settingsChanged(settings);
        requestRefresh();
    }
}

void PlotGrid::setPresentation(bool isPresentation)
{
    m_figure.setPresentation(isPresentation);
    rebuild();
}

void PlotGrid::maximize(const QString &name)
{
    const qsizetype index = plotNames().indexOf(name);
    m_maximized = index < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(index));
    m_hovered.reset();
    rebuild();
}

void PlotGrid::setMeasuring(bool isMeasuring)
{
    if (isMeasuring && !m_measured) {
        const Interval range = m_figure.timeRange();
        const double third = range.length() / 3.0;
        m_measured = {m_figure.readTime(range.lower + third).t, m_figure.readTime(range.upper - third).t};
    }
    setMeasured(isMeasuring ? m_measured : std::nullopt);
}

void PlotGrid::setMeasured(const std::optional<std::array<double, 2>> &times)
{
    m_measured = times;
    m_measuring->setChecked(times.has_value());
    moveCursors();
    updateCaption();
}

QString PlotGrid::measuredText() const
{
    if (!m_measured) {
        return {};
    }
    const auto [first, second] = *m_measured;
    return QStringLiteral("1: %1 · 2: %2 · Δ = %3")
        .arg(m_figure.timeText(first), m_figure.timeText(second), m_figure.durationText(second - first));
}

/// Returns the maximized plot, all nine plots, or without errors the six of the motion.
std::vector<std::size_t> PlotGrid::plotsToShow() const
{
    std::vector<std::size_t> plots;
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        if (m_maximized ? plot == *m_maximized : !isErrorPlot(plot) || m_figure.hasErrors()) {
            plots.push_back(plot);
        }
    }
    return plots;
}

void PlotGrid::rebuild()
{
    const PlotFonts fonts(font());
    const SeriesColours colours = seriesColours(palette());
    m_figure.setPlots(plotsToShow(), fonts, colours);
    for (PlotPane *pane : m_panes) {
        pane->setStyle(fonts.tick, colours);
    }
    requestRefresh();
}

/// Combines the requests of one pass of the event loop into one refresh. A hidden widget refreshes when it is shown.
void PlotGrid::requestRefresh()
{
    m_isStale = true;
    if (isVisible() && !m_isRefreshQueued) {
        m_isRefreshQueued = true;
        const auto refreshNow = [this] {
            m_isRefreshQueued = false;
            if (isVisible()) {
                refreshIfStale();
            }
        };
        QMetaObject::invokeMethod(this, refreshNow, Qt::QueuedConnection);
    }
}

void PlotGrid::refreshIfStale()
{
    if (m_isStale || m_picture.devicePixelRatio() != devicePixelRatioF()) { // the window was moved to another screen
        refresh();
    }
}

void PlotGrid::refresh()
{
    m_isStale = false;
    m_figure.show(size());
    const double ratio = devicePixelRatioF();
    if (m_picture.size() != size() * ratio || m_picture.devicePixelRatio() != ratio) {
        m_picture = QPixmap(size() * ratio);
        m_picture.setDevicePixelRatio(ratio);
    }
    m_figure.drawInto(m_picture);
    placePanes();
    moveCursors();
    update();
}

void PlotGrid::placePanes()
{
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        const QCPAxisRect *axes = m_figure.plot(plot).axes;
        m_panes[plot]->setVisible(axes != nullptr);
        if (axes) {
            m_panes[plot]->setGeometry(axes->outerRect());
            m_panes[plot]->setAccessibleDescription(m_figure.description(plot));
            m_panes[plot]->update();
        }
    }
    updateCaption();
}

/// Shows the measured times or, without a file, how to compare with one.
void PlotGrid::updateCaption()
{
    const std::shared_ptr<const Result> &result = m_figure.result();
    const bool isAlone = result && !result->reference && result->pinned.empty() && !m_figure.isPresentation();
    const QString hint = tr("To compare with a simulation, <a href=\"open\">open its CSV…</a> or drop it here.");
    const QString text = m_measured ? measuredText() : isAlone && !m_maximized ? hint : QString();
    if (text != m_caption->text()) {
        m_caption->setText(text);
    }
    constexpr int kGap = 12;
    const QRect legend = m_figure.legendPlace();
    const int textWidth = m_caption->sizeHint().width();
    m_caption->setGeometry(width() - textWidth - kGap, 0, textWidth, legend.height());
    m_caption->setVisible(!text.isEmpty() && (m_measured || legend.right() < m_caption->x()));
}

/// Returns the cursor of a plot at that time, with the values there.
PlotPane::Cursor PlotGrid::cursorAt(std::size_t plot, double time)
{
    constexpr int kDigits = 4;
    const QCPAxis &timeAxis = m_figure.axis(plot, QCPAxis::atBottom);
    const QPoint corner = m_panes[plot]->pos();
    const SeriesColours colours = seriesColours(palette());
    const ReadTime read = m_figure.readTime(time);
    PlotPane::Cursor cursor;
    cursor.x = std::round(timeAxis.coordToPixel(time)) - corner.x();
    for (const PlotReading &reading : m_figure.readings(plot, read)) {
        const QPointF place(timeAxis.coordToPixel(read.t),
                            m_figure.axis(plot, QCPAxis::atLeft).coordToPixel(reading.value));
        if (QRectF(axes(plot)).adjusted(-1.0, -1.0, 1.0, 1.0).contains(place)) {
            cursor.dots.push_back({place - corner, colours.*reading.ink, shortNumber(reading.number, kDigits)});
        }
    }
    return cursor;
}

std::vector<PlotPane::Cursor> PlotGrid::cursors(std::size_t plot)
{
    std::vector<PlotPane::Cursor> cursors;
    const auto add = [&](double time) -> PlotPane::Cursor * {
        const bool isSeen = m_figure.plot(plot).values && m_figure.timeRange().contains(time);
        return isSeen ? &cursors.emplace_back(cursorAt(plot, time)) : nullptr;
    };
    if (m_time) {
        add(*m_time);
    }
    for (std::size_t i = 0; m_measured && i < m_measured->size(); ++i) {
        if (PlotPane::Cursor *cursor = add((*m_measured)[i])) {
            cursor->heading << QString::number(i + 1);
        }
    }
    const ReadTime hovered = m_figure.readTime(m_hoverTime);
    if (PlotPane::Cursor *cursor = m_hovered && !m_drag ? add(hovered.t) : nullptr) {
        cursor->isLight = true;
        if (plot == *m_hovered) {
            cursor->heading << m_figure.timeText(hovered.t);
        }
        if (plot == *m_hovered && plot == 0 && !cursor->dots.empty()) {
            constexpr int kDigits = 4;
            const double theta3 = m_figure.readings(plot, hovered).front().number;
            cursor->heading << tr("textbook's θ₃ = %1°").arg(shortNumber(theta3 + 180.0, kDigits));
        }
    }
    return cursors;
}

void PlotGrid::moveCursors()
{
    if (m_isStale) {
        return; // refresh() moves them
    }
    for (const std::size_t plot : m_figure.plots()) {
        m_panes[plot]->setCursors(cursors(plot), axes(plot).translated(-m_panes[plot]->pos()));
    }
    if (m_measured) { // otherwise it does not depend on the time, and its layout would cost more than all cursors
        updateCaption();
    }
}

void PlotGrid::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) {
        rebuild();
    }
}

void PlotGrid::paintEvent(QPaintEvent *event)
{
    refreshIfStale(); // grab() paints hidden widgets, too
    QPainter painter(this);
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_picture);
}

void PlotGrid::resizeEvent(QResizeEvent *)
{
    requestRefresh();
}

void PlotGrid::showEvent(QShowEvent *)
{
    requestRefresh();
}

void PlotGrid::paintFigure(QPainter &painter, const QSize &size, const QPalette &palette)
{
    const std::optional<std::size_t> maximized = std::exchange(m_maximized, std::nullopt);
    const std::vector<std::size_t> plots = plotsToShow();
    m_maximized = maximized;
    paint(painter, plots, size, palette);
}

void PlotGrid::paintPlot(QPainter &painter, const QString &name, const QSize &size, const QPalette &palette)
{
    const qsizetype index = plotNames().indexOf(name);
    Q_ASSERT(index >= 0);
    paint(painter, {static_cast<std::size_t>(index)}, size, palette);
}

void PlotGrid::paint(QPainter &painter, const std::vector<std::size_t> &plots, const QSize &size,
                     const QPalette &palette)
{
    m_figure.setPlots(plots, PlotFonts(font()), seriesColours(palette));
    m_figure.setFooter(m_figure.result() ? mechanismText(m_figure.result()->mechanism) : QString());
    m_figure.show(size, m_markedTime);
    m_figure.paint(painter, size);
    m_figure.setFooter({});
    rebuild(); // restores the figure for the screen
}

} // namespace slidercrank
