// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "ui/document/with.h"
#include "ui/plots/figure_plot.h"
#include "ui/text/finding_text.h"

#include <QAction>
#include <QActionGroup>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PlotGrid::PlotGrid(QWidget *parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Plots of the motion"));
    const std::array<QString, kPlotRows> errors{tr("Error of the positions"), tr("Error of the velocities"),
                                                tr("Error of the accelerations")};
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        m_panes[plot] = new PlotPane(m_picture, this);
        m_panes[plot]->setObjectName(plotName(plot));
        const Channel channel = kPlottedChannels[isErrorPlot(plot) ? 0 : channelOf(plot)];
        QString name = isErrorPlot(plot) ? errors[plot / kPlotColumns]
                                         : QStringLiteral("%1 %2").arg(quantityOf(channel), symbolOf(channel));
        name[0] = name[0].toUpper();
        m_panes[plot]->setAccessibleName(name);
        m_panes[plot]->installEventFilter(this);
    }
    makeChoices();
    m_hint = new QLabel(this);
    m_hint->setObjectName(QStringLiteral("no_reference_hint"));
    m_hint->setTextFormat(Qt::RichText);
    m_hint->setText(tr("To compare with a simulation, <a href=\"open\">open its CSV…</a> or drop it here."));
    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse); // a label's focus is not seen; by keys there is a menu
    connect(m_hint, &QLabel::linkActivated, this, [this] { emit openReferenceRequested(); });
    rebuild();
}

PlotGrid::~PlotGrid() = default;

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
    add(tr("File's &rounding as a band"), &PlotSettings::roundingBand, true, false);
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
    const bool hadErrors = m_figure.hasErrors();
    m_figure.setResult(result);
    if (m_figure.hasErrors() != hadErrors) {
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
    if (isMeasuring != m_measured.has_value()) {
        m_measured.reset();
        if (isMeasuring) {
            const Interval range = m_figure.timeRange();
            const double third = range.length() / 3.0;
            m_measured = {m_figure.readTime(m_figure.roundedTime(range.lower + third)).t,
                          m_figure.readTime(m_figure.roundedTime(range.upper - third)).t};
        }
    }
    m_measuring->setChecked(isMeasuring);
    moveCursors();
    update();
}

void PlotGrid::setMeasured(const std::optional<std::array<double, 2>> &times)
{
    setMeasuring(times.has_value());
    m_measured = times;
    moveCursors();
}

/// The maximized plot, all nine, or those of the motion where there are no errors.
std::vector<std::size_t> PlotGrid::plotsOnShow() const
{
    if (m_maximized) {
        return {*m_maximized};
    }
    std::vector<std::size_t> plots;
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        if (!isErrorPlot(plot) || m_figure.hasErrors()) {
            plots.push_back(plot);
        }
    }
    return plots;
}

void PlotGrid::rebuild()
{
    const PlotFonts fonts(font());
    const SeriesColours colours = seriesColours(palette());
    m_drawing = std::make_unique<FigurePlot>(plotsOnShow(), fonts, colours);
    for (PlotPane *pane : m_panes) {
        pane->setStyle(fonts.tick, colours);
    }
    requestRefresh();
}

/// Several requests in one pass of the event loop make one refresh; a hidden widget waits until it is shown.
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

void PlotGrid::refresh()
{
    m_isStale = false;
    m_drawing->show(m_figure, size());
    const double ratio = devicePixelRatioF();
    if (m_picture.size() != size() * ratio || m_picture.devicePixelRatio() != ratio) {
        m_picture = QPixmap(size() * ratio);
        m_picture.setDevicePixelRatio(ratio);
    }
    m_drawing->drawInto(m_picture);
    placePanes();
    moveCursors();
    update();
}

void PlotGrid::placePanes()
{
    const std::vector<std::size_t> &shown = m_drawing->plots();
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        const bool isShown = std::ranges::find(shown, plot) != shown.end();
        m_panes[plot]->setVisible(isShown);
        if (isShown) {
            m_panes[plot]->setGeometry(m_drawing->cell(plot));
            m_panes[plot]->setAccessibleDescription(m_drawing->description(plot));
            m_panes[plot]->update();
        }
    }
    const QSize hint = m_hint->sizeHint();
    constexpr int kGap = 12;
    m_hint->setGeometry(width() - hint.width() - kGap, 0, hint.width(), m_drawing->legendHeight());
    const std::shared_ptr<const Result> &result = m_figure.result();
    const bool isAlone = result && !result->reference && result->kept.empty();
    m_hint->setVisible(isAlone && !m_figure.isPresentation() && !m_maximized && m_drawing->legendEnd() < m_hint->x());
}

/// What is read at a time in a plot, px in its pane.
PlotPane::Cursor PlotGrid::cursorAt(std::size_t plot, double time)
{
    constexpr int kDigits = 4;
    const QCPAxisRect &axes = m_drawing->axes(plot);
    const QCPAxis &timeAxis = *axes.axis(QCPAxis::atBottom);
    const QPoint corner = m_drawing->cell(plot).topLeft();
    const SeriesColours colours = seriesColours(palette());
    PlotPane::Cursor cursor;
    cursor.x = std::round(timeAxis.coordToPixel(time)) - corner.x();
    for (const PlotReading &reading : m_figure.readings(plot, m_figure.readTime(time))) {
        const QPointF at(timeAxis.coordToPixel(reading.t), axes.axis(QCPAxis::atLeft)->coordToPixel(reading.value));
        if (QRectF(axes.rect()).adjusted(-1.0, -1.0, 1.0, 1.0).contains(at)) {
            cursor.dots.push_back({at - corner, colours.*reading.ink, shortNumber(reading.number, kDigits)});
        }
    }
    return cursor;
}

void PlotGrid::moveCursors()
{
    if (m_isStale) {
        return; // refresh() moves them
    }
    for (const std::size_t plot : m_drawing->plots()) {
        const Interval range = m_figure.timeRange();
        std::vector<PlotPane::Cursor> cursors;
        const auto add = [&](double time) -> PlotPane::Cursor * {
            if (!m_drawing->hasValues(plot) || !range.contains(time)) {
                return nullptr;
            }
            return &cursors.emplace_back(cursorAt(plot, time));
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
            const std::vector<PlotReading> readings = m_figure.readings(plot, hovered);
            if (plot == *m_hovered) {
                cursor->heading << m_figure.timeText(hovered.t);
            }
            if (plot == *m_hovered && plot == 0 && !readings.empty()) {
                constexpr double kHalfTurn = 180.0;
                constexpr int kDigits = 4;
                cursor->heading << tr("textbook's θ₃ = %1°").arg(shortNumber(readings[0].number + kHalfTurn, kDigits));
            }
        }
        const QRect axes = m_drawing->axes(plot).rect().translated(-m_drawing->cell(plot).topLeft());
        m_panes[plot]->setCursors(cursors, axes);
    }
    if (m_measured) {
        update(QRect(0, 0, width(), m_drawing->legendHeight()));
    }
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

/// Names that the legend may elide, and titles that may be shortened.
bool PlotGrid::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const QPoint global = static_cast<QHelpEvent *>(event)->globalPos();
    const QPoint at = mapFromGlobal(global);
    const std::shared_ptr<const Result> &result = m_figure.result();
    QString text;
    if (at.y() < m_drawing->legendHeight() && result && result->reference) {
        text = result->reference->paths.join(u'\n');
    }
    for (const std::size_t plot : m_drawing->plots()) {
        if (m_drawing->cell(plot).contains(at) && at.y() < m_drawing->axes(plot).top()) {
            text = m_drawing->description(plot);
        }
    }
    QToolTip::showText(global, text, this);
    return true;
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
    if (m_isStale || m_picture.devicePixelRatio() != devicePixelRatioF()) { // grab() of a hidden one, another screen
        refresh();
    }
    QPainter painter(this);
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_picture);
    if (m_measured) {
        constexpr int kGap = 12;
        const SeriesColours colours = seriesColours(palette());
        const QString text = measuredText();
        painter.setFont(PlotFonts(font()).title);
        QRect place(0, 0, painter.fontMetrics().horizontalAdvance(text), m_drawing->legendHeight());
        place.moveRight(width() - kGap);
        painter.fillRect(place.adjusted(-kGap, 0, kGap, 0), colours.background);
        painter.setPen(colours.text);
        painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, text);
    }
}

void PlotGrid::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    requestRefresh();
}

void PlotGrid::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    requestRefresh();
}

void PlotGrid::paintFigure(QPainter &painter, const QSize &size, const QPalette &palette)
{
    const std::optional<std::size_t> maximized = std::exchange(m_maximized, std::nullopt);
    paint(painter, plotsOnShow(), size, palette);
    m_maximized = maximized;
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
    const SeriesColours colours = seriesColours(palette);
    const PlotFonts fonts(font());
    const int footer = m_figure.result() ? QFontMetrics(fonts.tick).height() + 4 : 0;
    const QRect area(0, 0, size.width(), size.height() - footer);
    FigurePlot drawing(plots, fonts, colours);
    drawing.show(m_figure, area.size(), m_markedTime);
    painter.fillRect(QRect(QPoint(), size), colours.background);
    drawing.paint(painter, area);
    if (footer > 0) {
        const QRect place(12, area.height(), size.width() - 24, footer);
        const QString text = mechanismText(m_figure.result()->mechanism);
        painter.save();
        painter.setFont(fonts.tick);
        painter.setPen(colours.text);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(fonts.tick).elidedText(text, Qt::ElideRight, place.width()));
        painter.restore();
    }
}

} // namespace slidercrank
