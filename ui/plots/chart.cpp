// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/chart.h"

#include "ui/plots/plot_drawing.h"
#include "ui/text/written_number.h"

#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Labels decades as 10⁻⁶, leaving some out where there is little room.
class DecadeTicker : public QCPAxisTickerLog
{
public:
    explicit DecadeTicker(int mostLabels)
        : m_mostLabels(std::max(1, mostLabels))
    {
    }

protected:
    int getSubTickCount(double) override { return 0; }
    QVector<double> createTickVector(double, const QCPRange &range) override
    {
        const int first = static_cast<int>(std::ceil(std::log10(range.lower) - kTouching));
        const int last = static_cast<int>(std::floor(std::log10(range.upper) + kTouching));
        int step = 1;
        for (const int larger : {2, 3, 5, 10, 20, 50, 100}) {
            step = (last - first) / step >= m_mostLabels ? larger : step;
        }
        QVector<double> ticks;
        for (int decade = first; decade <= last; ++decade) {
            if (decade % step == 0) {
                ticks << std::pow(10.0, decade);
            }
        }
        return ticks;
    }
    QString getTickLabel(double tick, const QLocale &, QChar, int) override
    {
        return powerOfTen(static_cast<int>(std::lround(std::log10(tick))));
    }

private:
    static constexpr double kTouching = 1e-9;
    int m_mostLabels;
};

void setAxis(QCPAxis &axis, const ChartAxis &content, double pixels)
{
    constexpr double kPixelsPerLabel[] = {44.0, 22.0};
    const double labels = pixels / kPixelsPerLabel[axis.orientation() == Qt::Vertical ? 1 : 0];
    axis.setLabel(content.title);
    axis.setScaleType(content.isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis.setRange(content.range.lower, content.range.upper);
    if (content.isLogarithmic) {
        axis.setTicker(QSharedPointer<DecadeTicker>::create(static_cast<int>(labels)));
    } else {
        const auto ticker = QSharedPointer<QCPAxisTicker>::create();
        ticker->setTickCount(std::max(1, static_cast<int>(labels)));
        axis.setTicker(ticker);
    }
    axis.setSubTicks(false);
}

void setSeries(PlotDrawing &drawing, const ChartSeries &series, const SeriesColours &colours)
{
    QCPGraph *graph = drawing.addCurve();
    QVector<QCPGraphData> data;
    for (const QPointF &point : series.points) {
        data << QCPGraphData(point.x(), point.y());
    }
    graph->data()->set(data, true);
    graph->setName(series.name);
    if (!series.name.isEmpty()) {
        graph->addToLegend();
    }
    using Line = ChartSeries::Line;
    const QColor colour = colours.*series.colour;
    graph->setLineStyle(series.line == Line::None    ? QCPGraph::lsNone
                        : series.line == Line::Steps ? QCPGraph::lsStepLeft
                                                     : QCPGraph::lsLine);
    graph->setPen(QPen(colour, 1.0, series.line == Line::Dashed ? Qt::DashLine : Qt::SolidLine));
    if (!series.mark.isEmpty()) {
        constexpr double kUnscaled = 6.0; // QCustomPlot's size for paths drawn as they are
        constexpr double kOutline = 1.2;
        graph->setScatterStyle(QCPScatterStyle(series.mark, QPen(colour, kOutline),
                                               series.isHollow ? colours.background : colour, kUnscaled));
    }
    for (qsizetype i = 0; i < std::min<qsizetype>(series.labels.size(), data.size()); ++i) {
        constexpr int kAway = 6;
        const double x = drawing.xAxis->coordToPixel(data[i].key);
        const bool isRight = x > drawing.axisRect()->center().x();
        auto *label = new QCPItemText(&drawing);
        label->setText(series.labels[i]);
        label->setColor(colour);
        label->setFont(drawing.xAxis->tickLabelFont());
        label->setPositionAlignment((isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
        label->setPadding(QMargins(kAway, 0, kAway, 0));
        label->position->setCoords(data[i].key, data[i].value);
    }
}

/// Hidden where there is too little room beside the axes.
void placeLegend(PlotDrawing &drawing, ChartContent::Legend place, const QSize &size)
{
    constexpr int kLeast = 200; // px, of the axes
    constexpr double kNoStretch = 1e-3;
    QCPLegend &legend = *drawing.legend;
    const bool isRight = place == ChartContent::Legend::Right;
    legend.setFillOrder(isRight ? QCPLegend::foRowsFirst : QCPLegend::foColumnsFirst);
    const QSize needed = legend.minimumOuterSizeHint();
    const bool fits = isRight ? needed.width() + kLeast <= size.width() && needed.height() <= size.height()
                              : needed.width() <= size.width() && 3 * needed.height() <= size.height();
    if (!fits || legend.itemCount() == 0) {
        return;
    }
    drawing.axisRect()->insetLayout()->take(&legend);
    legend.setVisible(true);
    if (isRight) {
        drawing.plotLayout()->addElement(0, 1, &legend);
        drawing.plotLayout()->setColumnStretchFactor(1, kNoStretch);
    } else {
        drawing.plotLayout()->insertRow(0);
        drawing.plotLayout()->addElement(0, 0, &legend);
        drawing.plotLayout()->setRowStretchFactor(0, kNoStretch);
    }
}

} // namespace

Chart::Chart(QWidget *parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

Chart::~Chart() = default;

void Chart::setContent(const ChartContent &content)
{
    m_content = content;
    m_marked.reset();
    m_drawing.reset();
    update();
}

void Chart::setMarked(const std::optional<Place> &place)
{
    if (place != m_marked) {
        m_marked = place;
        update();
    }
}

void Chart::fill(const QSize &size, const QPalette &palette, const std::optional<Place> &marked)
{
    const SeriesColours colours = seriesColours(palette);
    m_drawing = std::make_unique<PlotDrawing>();
    PlotDrawing &drawing = *m_drawing;
    drawing.setStyle(PlotFonts(font()), colours);
    drawing.layOut(size);
    setAxis(*drawing.xAxis, m_content.x, drawing.axisRect()->width());
    setAxis(*drawing.yAxis, m_content.y, drawing.axisRect()->height());
    for (const ChartSeries &series : m_content.series) {
        setSeries(drawing, series, colours);
    }
    placeLegend(drawing, m_content.legend, size);
    if (marked) {
        constexpr double kDiameter = 18.0;
        auto *ring = new QCPItemTracer(&drawing);
        ring->setStyle(QCPItemTracer::tsCircle);
        ring->setSize(kDiameter);
        ring->setPen(QPen(colours.cursor, 1.5));
        ring->position->setCoords(m_content.series[marked->series].points[marked->point]);
    }
    drawing.layOut(size);
}

void Chart::paintEvent(QPaintEvent *)
{
    fill(size(), palette(), m_marked);
    QCPPainter painter(this);
    m_drawing->toPainter(&painter, width(), height());
}

void Chart::paint(QPainter &painter, const QSize &size, const QPalette &palette)
{
    fill(size, palette, std::nullopt);
    m_drawing->paint(painter, QRect(QPoint(), size));
}

QPointF Chart::positionOf(const Place &place)
{
    if (!m_drawing || m_drawing->viewport().size() != size()) {
        fill(size(), palette(), m_marked);
    }
    const QPointF &point = m_content.series[place.series].points[place.point];
    return {m_drawing->xAxis->coordToPixel(point.x()), m_drawing->yAxis->coordToPixel(point.y())};
}

std::optional<Chart::Place> Chart::pointAt(const QPointF &position)
{
    constexpr double kNear = 9.0; // px
    std::optional<Place> nearest;
    double least = kNear;
    for (std::size_t series = 0; series < m_content.series.size(); ++series) {
        const std::size_t points = m_content.series[series].mark.isEmpty() ? 0 : m_content.series[series].points.size();
        for (std::size_t point = 0; point < points; ++point) {
            const QPointF away = positionOf({series, point}) - position;
            if (const double distance = std::hypot(away.x(), away.y()); distance <= least) {
                least = distance;
                nearest = Place{series, point};
            }
        }
    }
    return nearest;
}

void Chart::mouseMoveEvent(QMouseEvent *event)
{
    const std::optional<Place> place = pointAt(event->position());
    if (!place) {
        QToolTip::hideText();
        return;
    }
    const QStringList &tips = m_content.series[place->series].tips;
    QToolTip::showText(event->globalPosition().toPoint(), tips.value(static_cast<qsizetype>(place->point)), this);
    emit pointed(*place);
}

} // namespace slidercrank
