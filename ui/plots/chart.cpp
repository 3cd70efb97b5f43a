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

/// Labels the ticks of a logarithmic axis with powers of ten: 10⁻³.
class DecadeTicker : public QCPAxisTickerLog
{
protected:
    QString getTickLabel(double tick, const QLocale &, QChar, int) override
    {
        return powerOfTen(static_cast<int>(std::lround(std::log10(tick))));
    }
};

void setAxis(QCPAxis &axis, const ChartAxis &content, double pixelsPerLabel)
{
    const bool isVertical = axis.orientation() == Qt::Vertical;
    const int pixels = isVertical ? axis.axisRect()->height() : axis.axisRect()->width();
    const auto ticker = content.isLogarithmic ? QSharedPointer<QCPAxisTicker>(new DecadeTicker)
                                              : QSharedPointer<QCPAxisTicker>(new QCPAxisTicker);
    ticker->setTickCount(std::max(1, static_cast<int>(pixels / pixelsPerLabel)));
    axis.setTicker(ticker);
    axis.setLabel(content.title);
    axis.setRange(content.range.lower, content.range.upper);
    if (content.isLogarithmic) {
        axis.setScaleType(QCPAxis::stLogarithmic);
    }
}

void addSeries(PlotDrawing &drawing, const ChartSeries &series, const SeriesColours &colours)
{
    std::vector<CurvePoint> points;
    for (const QPointF &point : series.points) {
        points.push_back({point.x(), point.y()});
    }
    QCPGraph *graph = drawing.addCurve(drawing.axisRect(), points);
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
        constexpr double kUnscaled = 6.0; // the size at which QCustomPlot does not scale the path
        graph->setScatterStyle(
            QCPScatterStyle(series.mark, QPen(colour, 1.2), series.isHollow ? colours.background : colour, kUnscaled));
    }
    for (qsizetype i = 0; i < series.labels.size(); ++i) {
        constexpr int kAway = 6;
        const QPointF &place = series.points[static_cast<std::size_t>(i)];
        const bool isRight = drawing.xAxis->coordToPixel(place.x()) > drawing.axisRect()->center().x();
        QCPItemText *label = drawing.addText(drawing.axisRect(), series.labels[i], place,
                                             (isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
        label->setColor(colour);
        label->setPadding(QMargins(kAway, 0, kAway, 0));
    }
}

/// Hides the legend where there is too little space.
void placeLegend(PlotDrawing &drawing, bool isRight, const QSize &size)
{
    QCPLegend *legend = drawing.legend;
    const QSize most = isRight ? QSize(size.width() - 200, size.height()) : size / 2; // px
    const QSize needed = legend->minimumOuterSizeHint();
    legend->setVisible(legend->itemCount() > 0 && needed.boundedTo(most) == needed);
    if (legend->visible() && isRight) {
        drawing.axisRect()->insetLayout()->take(legend);
        drawing.plotLayout()->addElement(0, 1, legend);
        drawing.plotLayout()->setColumnStretchFactor(1, 1e-3);
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
    m_drawing->setStyle(PlotFonts(font()), colours);
    m_drawing->layOut(size);
    setAxis(*m_drawing->xAxis, m_content.x, 44.0);
    setAxis(*m_drawing->yAxis, m_content.y, 22.0);
    for (const ChartSeries &series : m_content.series) {
        addSeries(*m_drawing, series, colours);
    }
    placeLegend(*m_drawing, m_content.legend == ChartContent::Legend::Right, size);
    if (marked) {
        auto *ring = new QCPItemTracer(m_drawing.get());
        ring->setStyle(QCPItemTracer::tsCircle);
        ring->setSize(18.0);
        ring->setPen(QPen(colours.cursor, 1.5));
        ring->position->setCoords(m_content.series[marked->series].points[marked->point]);
    }
    m_drawing->layOut(size);
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
    m_drawing->paint(painter, size);
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
    double nearest = 9.0; // px, at most
    std::optional<Place> found;
    for (std::size_t series = 0; series < m_content.series.size(); ++series) {
        const std::size_t points = m_content.series[series].mark.isEmpty() ? 0 : m_content.series[series].points.size();
        for (std::size_t point = 0; point < points; ++point) {
            const double distance = QLineF(positionOf({series, point}), position).length();
            if (distance <= nearest) {
                nearest = distance;
                found = Place{series, point};
            }
        }
    }
    return found;
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
