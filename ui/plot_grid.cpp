// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_grid.h"

#include "ui/axis_scale.h"
#include "ui/theme.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPicture>
#include <QToolTip>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr qreal kDotSize = 4.0;

/// Shrunk or widened about one of its points.
Interval scaled(const Interval &range, double about, double factor)
{
    return {about - (about - range.lower) * factor, about + (range.upper - about) * factor};
}

} // namespace

/// One plot: a QCustomPlot that shows a PlotPicture and otherwise does nothing of its own.
class PlotGrid::Plot : public QCustomPlot
{
public:
    explicit Plot(QWidget *parent);

    void setStyle(const PlotTypography &typography, const SeriesColours &colours);
    void display(const PlotPicture &picture, const QMargins &margins);

    const Interval &timeRange() const { return m_picture.time; }
    const Interval &valueRange() const { return m_picture.values; }
    bool hasValues() const { return m_picture.hasValues; }

private:
    /// Title, unit of the time axis, marks and dots: what QCustomPlot has no cheap element for.
    class Lettering : public QCPLayerable
    {
    public:
        explicit Lettering(Plot *plot)
            : QCPLayerable(plot, QStringLiteral("axes"))
            , m_plot(plot)
        {
        }

    protected:
        void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(true); }
        void draw(QCPPainter *painter) override;

    private:
        void drawTitle(QCPPainter &painter, const QRect &axes) const;
        Plot *m_plot;
    };

    class Ticker : public QCPAxisTicker
    {
    public:
        AxisScale scale;

    protected:
        double getTickStep(const QCPRange &) override { return scale.step; }
        int getSubTickCount(double) override { return 0; }
        QString getTickLabel(double tick, const QLocale &locale, QChar, int) override
        {
            return scale.label(tick, locale);
        }
    };

    PlotPicture m_picture;
    QFont m_titleFont;
    QFont m_tickFont;
    SeriesColours m_colours;
    QSharedPointer<Ticker> m_timeTicker;
    QSharedPointer<Ticker> m_valueTicker;
};

PlotGrid::Plot::Plot(QWidget *parent)
    : QCustomPlot(parent)
    , m_timeTicker(new Ticker)
    , m_valueTicker(new Ticker)
{
    setInteractions(QCP::Interactions());
    setAutoAddPlottableToLegend(false);
    setPlottingHint(QCP::phFastPolylines, true); // a line of width 2 costs four times as much without
    layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical); // no second pixmap: nothing is drawn there
    axisRect()->setAutoMargins(QCP::msNone);
    xAxis->setTicker(m_timeTicker);
    yAxis->setTicker(m_valueTicker);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->setSubTicks(false);
        axis->setTickLength(0, kTickLength);
        axis->setTickLabelPadding(kLabelGap);
    }
    for (std::size_t curve = 0; curve < m_picture.curves.size(); ++curve) {
        QCPGraph *graph = addGraph();
        graph->setAdaptiveSampling(false);
        graph->setSelectable(QCP::stNone);
    }
    new Lettering(this);
}

void PlotGrid::Plot::setStyle(const PlotTypography &typography, const SeriesColours &colours)
{
    m_titleFont = typography.title;
    m_tickFont = typography.tick;
    m_colours = colours;
    setBackground(QBrush(colours.background));
    constexpr double kFrameStrength = 0.55;
    const auto mixed = [](int text, int background) {
        return static_cast<int>(std::lround(kFrameStrength * text + (1.0 - kFrameStrength) * background));
    };
    const QColor frame(mixed(colours.text.red(), colours.background.red()),
                       mixed(colours.text.green(), colours.background.green()),
                       mixed(colours.text.blue(), colours.background.blue()));
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->setBasePen(QPen(frame, 1));
        axis->setTickPen(QPen(frame, 1));
        axis->setTickLabelColor(colours.text);
        axis->setTickLabelFont(typography.tick);
        axis->grid()->setPen(QPen(colours.grid, 1));
        axis->grid()->setZeroLinePen(QPen(frame, 1));
    }
    xAxis->grid()->setZeroLinePen(Qt::NoPen); // t = 0 is the axis itself
}

void PlotGrid::Plot::display(const PlotPicture &picture, const QMargins &margins)
{
    m_picture = picture;
    axisRect()->setMargins(margins);
    m_timeTicker->scale = picture.timeScale;
    m_valueTicker->scale = picture.valueScale;
    xAxis->setRange(picture.time.lower, picture.time.upper);
    yAxis->setRange(picture.values.lower, picture.values.upper);
    QString description = picture.title;
    for (const InkedText &remark : picture.remarks) {
        description += remark.text;
    }
    setAccessibleDescription(description);
    xAxis->setTickLabels(picture.hasTimeLabels);
    yAxis->setTickLabels(picture.hasValues);
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        const PlotPicture::Curve &curve = picture.curves[i];
        QVector<QCPGraphData> points;
        points.reserve(static_cast<qsizetype>(curve.points.size()));
        for (const CurvePoint &point : curve.points) {
            points.append(QCPGraphData(point.t, point.value));
        }
        QCPGraph *line = graph(static_cast<int>(i));
        line->data()->set(points, true);
        line->setPen(penOf(curve.ink, m_colours));
    }
}

void PlotGrid::Plot::Lettering::draw(QCPPainter *painter)
{
    const PlotPicture &picture = m_plot->m_picture;
    const SeriesColours &colours = m_plot->m_colours;
    const QRect axes = m_plot->axisRect()->rect();
    drawTitle(*painter, axes);

    painter->setFont(m_plot->m_tickFont);
    painter->setPen(QPen(colours.text));
    if (picture.hasTimeLabels) {
        // In the corner that both axes leave free.
        const QString first = picture.timeScale.label(picture.time.lower, QLocale());
        const double right = axes.left() - 0.5 * QFontMetricsF(m_plot->m_tickFont).horizontalAdvance(first) - 5.0;
        const QRectF corner(0.0, axes.bottom() + kTickLength + kLabelGap - 1, right, axes.height());
        painter->drawText(corner, Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip,
                          QStringLiteral("t [%1]").arg(picture.timeScale.unit(QStringLiteral("s"))));
    }
    if (!picture.note.isEmpty()) {
        painter->drawText(axes.adjusted(kLabelGap, 0, -kLabelGap, 0), Qt::AlignCenter | Qt::TextWordWrap, picture.note);
    }
    if (picture.markedTime && picture.hasValues && picture.time.contains(*picture.markedTime)) {
        const double x = m_plot->xAxis->coordToPixel(*picture.markedTime);
        painter->setPen(QPen(colours.cursor, 1.0));
        painter->drawLine(QPointF(x, axes.top()), QPointF(x, axes.bottom()));
    }
    for (const PlotPicture::Curve &curve : picture.curves) {
        const QColor colour = colourOf(curve.ink, colours);
        int lastPixel = std::numeric_limits<int>::min();
        for (const double t : curve.marks) {
            const double x = m_plot->xAxis->coordToPixel(t);
            if (picture.time.contains(t) && static_cast<int>(x) != lastPixel) {
                drawMark(*painter, QPointF(x, axes.top()), colour);
                lastPixel = static_cast<int>(x);
            }
        }
        painter->setPen(Qt::NoPen);
        painter->setBrush(colour);
        for (const CurvePoint &point : curve.dots) {
            const QPointF centre(m_plot->xAxis->coordToPixel(point.t), m_plot->yAxis->coordToPixel(point.value));
            painter->drawEllipse(centre, 0.5 * kDotSize, 0.5 * kDotSize);
        }
        painter->setBrush(Qt::NoBrush);
    }
}

void PlotGrid::Plot::Lettering::drawTitle(QCPPainter &painter, const QRect &axes) const
{
    const PlotPicture &picture = m_plot->m_picture;
    const QFontMetricsF titleMetrics(m_plot->m_titleFont);
    const QFontMetricsF tickMetrics(m_plot->m_tickFont);
    const double baseline = axes.top() - 2.0 - titleMetrics.descent();
    const auto widthOf = [&tickMetrics](const std::vector<InkedText> &texts) {
        double width = 0.0;
        for (const InkedText &part : texts) {
            width += tickMetrics.horizontalAdvance(part.text);
        }
        return width;
    };
    // Title and remarks over the axes; what is too long for that takes the margins too.
    double left = axes.left();
    double right = axes.right();
    const double titleWidth = titleMetrics.horizontalAdvance(picture.title) + 2.0 * kLabelGap;
    const std::vector<InkedText> *remarks = &picture.remarks;
    if (titleWidth + widthOf(*remarks) > right - left) {
        remarks = &picture.shortRemarks;
    }
    const double excess = titleWidth + widthOf(*remarks) - (right - left);
    if (excess > 0.0) {
        right = m_plot->viewport().width() - kLabelGap;
        left = std::max<double>(kLabelGap, right - widthOf(*remarks) - titleWidth);
    }
    painter.setFont(m_plot->m_titleFont);
    painter.setPen(QPen(m_plot->m_colours.text));
    painter.drawText(QPointF(left, baseline), picture.title);
    double x = right - widthOf(*remarks);
    if (x < left + titleWidth - kLabelGap) {
        return; // a plot narrower than any window makes it
    }
    painter.setFont(m_plot->m_tickFont);
    for (const InkedText &part : *remarks) {
        painter.setPen(QPen(colourOf(part.ink, m_plot->m_colours)));
        painter.drawText(QPointF(x, baseline), part.text);
        x += tickMetrics.horizontalAdvance(part.text);
    }
}

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
        m_plots[i] = new Plot(this);
        m_plots[i]->setObjectName(plotName(i));
        m_plots[i]->setAccessibleName(accessibleNames[i]);
        m_plots[i]->installEventFilter(this);
        m_cursors[i] = new QWidget(m_plots[i]);
        m_cursors[i]->setAttribute(Qt::WA_TransparentForMouseEvents);
        m_cursors[i]->setAutoFillBackground(true);
        m_cursors[i]->hide();
    }
    m_hint = new QLabel(this);
    m_hint->setObjectName(QStringLiteral("no_reference_hint"));
    m_hint->setTextFormat(Qt::RichText);
    m_hint->setText(tr("No reference data.<br><a href=\"open\">Open a reference…</a><br>or drop a CSV here."));
    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setBackgroundRole(QPalette::Base);
    m_hint->setAutoFillBackground(true);
    connect(m_hint, &QLabel::linkActivated, this, [this] { emit openReferenceRequested(); });
    QEvent paletteChange(QEvent::PaletteChange);
    changeEvent(&paletteChange);
}

PlotGrid::~PlotGrid() = default;

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
    return {480, 330};
}

void PlotGrid::setResult(const std::shared_ptr<const Result> &result)
{
    m_figure.setResult(result);
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
    m_figure.timeZoom.reset();
    m_figure.valueZoom = {};
    requestRefresh();
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

std::array<PlotGrid::PlacedPlot, kPlotCount> PlotGrid::placedPlots(const QSize &size)
{
    const PlotArrangement arrangement(size, m_typography);
    std::array<PlacedPlot, kPlotCount> plots;
    std::array<int, kPlotColumns> labelLengths{};
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        const bool hasTimeLabels = arrangement.hasTimeLabels(i);
        const QSize axes = arrangement.cells[i].size().shrunkBy(m_typography.margins(0, hasTimeLabels));
        plots[i].cell = arrangement.cells[i];
        plots[i].picture = m_figure.picture(i, axes, m_typography.digitWidth);
        plots[i].picture.hasTimeLabels = hasTimeLabels;
        int &length = labelLengths[i % kPlotColumns];
        length = std::max(length, plots[i].picture.valueScale.labelLength(plots[i].picture.values));
    }
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        plots[i].margins = m_typography.margins(labelLengths[i % kPlotColumns], arrangement.hasTimeLabels(i));
    }
    return plots;
}

void PlotGrid::refresh()
{
    m_isStale = false;
    const std::array<PlacedPlot, kPlotCount> plots = placedPlots(size());
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->display(plots[i].picture, plots[i].margins);
        m_plots[i]->replot(QCustomPlot::rpQueuedRefresh);
    }
    moveCursors();
}

void PlotGrid::placePlots()
{
    const PlotArrangement arrangement(size(), m_typography);
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->setGeometry(arrangement.cells[i]);
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
            m_cursors[i]->setGeometry(x, axes.top(), 1, axes.height());
        }
        m_cursors[i]->setVisible(isInRange);
    }
}

void PlotGrid::updateHint()
{
    m_hint->setVisible(!m_figure.result || !m_figure.result->reference);
    if (m_hint->isHidden()) {
        return;
    }
    const QRect first = m_plots[kErrorColumn]->geometry();
    const QRect last = m_plots[kPlotCount - 1]->geometry();
    const QMargins margins = m_typography.margins(0, true);
    constexpr int kInset = 6;
    const int width = std::max(0, first.width() - margins.left() - margins.right() - 2 * kInset);
    const int height = m_hint->heightForWidth(width);
    m_hint->setGeometry(first.left() + margins.left() + kInset, (first.top() + last.bottom() - height) / 2, width,
                        height);
    m_hint->raise();
}

void PlotGrid::zoomTime(double about, double factor)
{
    const Interval outer = m_figure.outerRange();
    const Interval range = scaled(m_figure.timeRange(), about, factor);
    // Closer, neighbouring instants could not be told apart on the axis any more.
    constexpr double kSmallestPart = 1e-10;
    const double largest = std::max({std::abs(outer.lower), std::abs(outer.upper), outer.length()});
    if (factor < 1.0 && range.length() < kSmallestPart * largest) {
        return;
    }
    m_figure.zoomTime(range);
    requestRefresh();
}

void PlotGrid::zoomValues(std::size_t plot, double about, double factor)
{
    if (!m_plots[plot]->yAxis->tickLabels()) {
        return; // there are no values
    }
    const Interval range = scaled(m_plots[plot]->valueRange(), about, factor);
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    constexpr double kSmallestPart = 1e-10;
    constexpr double kLargestValue = 1e60;
    if (range.length() < kSmallestPart * largest || largest > kLargestValue) {
        return;
    }
    m_figure.valueZoom[plot] = range;
    requestRefresh();
}

void PlotGrid::pan(std::size_t plot, const QPoint &to)
{
    const Plot &shown = *m_plots[plot];
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
    connect(menu->addAction(tr("&Export this plot…")), &QAction::triggered, this,
            [this, plot] { emit exportPlotRequested(plotName(plot)); });
    connect(menu->addAction(tr("Show &all")), &QAction::triggered, this, &PlotGrid::showAll);
    menu->popup(globalPosition);
}

bool PlotGrid::eventFilter(QObject *watched, QEvent *event)
{
    const auto found = std::find(m_plots.begin(), m_plots.end(), watched);
    if (found == m_plots.end()) {
        return QWidget::eventFilter(watched, event);
    }
    const auto index = static_cast<std::size_t>(found - m_plots.begin());
    Plot &plot = **found;
    switch (event->type()) {
    case QEvent::Resize: // QCustomPlot would replot at once, with curves decimated for the old size
        plot.setViewport(plot.rect());
        requestRefresh();
        return true;
    case QEvent::Wheel: {
        const auto *wheel = static_cast<QWheelEvent *>(event);
        constexpr double kNotch = 120.0;
        constexpr double kFactor = 0.85;
        const double factor = std::pow(kFactor, wheel->angleDelta().y() / kNotch);
        const QRect axes = plot.axisRect()->rect();
        if (wheel->position().x() < axes.left()) {
            zoomValues(index, plot.yAxis->pixelToCoord(wheel->position().y()), factor);
        } else {
            zoomTime(plot.xAxis->pixelToCoord(wheel->position().x()), factor);
        }
        event->accept();
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (mouse->button() == Qt::LeftButton) {
            m_drag = Drag{index, mouse->pos(), mouse->pos()};
        }
        return true;
    }
    case QEvent::MouseMove: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (m_drag) {
            const QPoint to = mouse->pos();
            m_drag->hasMoved =
                m_drag->hasMoved || (to - m_drag->start).manhattanLength() >= QApplication::startDragDistance();
            if (m_drag->hasMoved) {
                pan(m_drag->plot, to);
                m_drag->last = to;
            }
        } else if (plot.axisRect()->rect().contains(mouse->pos())) {
            QToolTip::showText(mouse->globalPosition().toPoint(),
                               m_figure.readout(index, plot.xAxis->pixelToCoord(mouse->pos().x())), &plot);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    case QEvent::MouseButtonRelease: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (mouse->button() == Qt::LeftButton && m_drag) {
            const bool isClick = !m_drag->hasMoved && plot.axisRect()->rect().contains(mouse->pos());
            m_drag.reset();
            if (isClick) {
                emit timeRequested(plot.xAxis->pixelToCoord(mouse->pos().x()));
            }
        }
        return true;
    }
    case QEvent::MouseButtonDblClick: showAll(); return true;
    case QEvent::ContextMenu: showMenu(index, static_cast<QContextMenuEvent *>(event)->globalPos()); return true;
    default: return QWidget::eventFilter(watched, event);
    }
}

bool PlotGrid::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && m_figure.result && m_figure.result->reference) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (help->pos().y() < m_typography.legendHeight()) { // the name may be elided there
            QToolTip::showText(help->globalPos(), m_figure.result->reference->path, this);
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
    drawLegend(painter, QRect(0, 0, width(), m_typography.legendHeight()), m_figure.legend(true, true), m_typography,
               seriesColours(palette()));
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

namespace
{

/// QCustomPlot draws with a painter of its own class only: recorded, it can be played to any painter.
void replay(QPainter &painter, const QRect &cell, QCustomPlot &plot)
{
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    QPicture recording;
    QCPPainter recorder(&recording);
    recorder.setMode(QCPPainter::pmVectorized, isVector);
    plot.toPainter(&recorder, cell.width(), cell.height());
    recorder.end();
    painter.save();
    painter.translate(cell.topLeft());
    painter.drawPicture(0, 0, recording);
    painter.restore();
}

} // namespace

void PlotGrid::paintFigure(QPainter &painter, const QSize &size, const QPalette &palette)
{
    const SeriesColours colours = seriesColours(palette);
    painter.fillRect(QRect(QPoint(), size), colours.background);
    drawLegend(painter, PlotArrangement(size, m_typography).legend, m_figure.legend(true, true), m_typography, colours);
    Plot plot(nullptr);
    plot.setStyle(m_typography, colours);
    for (PlacedPlot &placed : placedPlots(size)) {
        placed.picture.markedTime = m_markedTime;
        plot.display(placed.picture, placed.margins);
        replay(painter, placed.cell, plot);
    }
}

void PlotGrid::paintPlot(QPainter &painter, const QString &name, const QSize &size, const QPalette &palette)
{
    const auto index = static_cast<std::size_t>(plotNames().indexOf(name));
    Q_ASSERT(index < kPlotCount);
    const SeriesColours colours = seriesColours(palette);
    const QRect legend(0, 0, size.width(), m_typography.legendHeight());
    const QRect cell(0, legend.height(), size.width(), std::max(0, size.height() - legend.height()));
    painter.fillRect(QRect(QPoint(), size), colours.background);
    drawLegend(painter, legend, m_figure.legend(!isErrorPlot(index), isErrorPlot(index)), m_typography, colours);
    const QSize axes = cell.size().shrunkBy(m_typography.margins(0, true));
    PlotPicture picture = m_figure.picture(index, axes, m_typography.digitWidth);
    picture.markedTime = m_markedTime;
    Plot plot(nullptr);
    plot.setStyle(m_typography, colours);
    plot.display(picture, m_typography.margins(picture.valueScale.labelLength(picture.values), true));
    replay(painter, cell, plot);
}

} // namespace slidercrank
