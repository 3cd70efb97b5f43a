// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/chart.h"

#include "ui/plots/plot_drawing.h"

#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

double coordinate(double value, const ChartAxis &axis)
{
    return axis.isLogarithmic ? std::log10(value) : value;
}

/// Gives an axis its title, its range and as many labels as fit its length (px).
void setUpAxis(QCPAxis &axis, const ChartAxis &content, int length, int pixelsPerLabel)
{
    const QSharedPointer<NumberTicker> ticker(new NumberTicker);
    ticker->isLogarithmic = content.isLogarithmic;
    constexpr int kMinLabels = 2;
    ticker->setTickCount(std::max(kMinLabels, length / pixelsPerLabel));
    axis.setTicker(ticker);
    axis.setLabel(content.title);
    axis.setRange(coordinate(content.range.lower, content), coordinate(content.range.upper, content));
}

void addSeries(PlotDrawing &drawing, const ChartContent &content, const ChartSeries &series,
               const SeriesColours &colours, double lineFactor)
{
    std::vector<CurvePoint> points;
    for (const QPointF &point : series.points) {
        points.push_back({coordinate(point.x(), content.x), coordinate(point.y(), content.y)});
    }
    if (!content.y.isLogarithmic) { // far outside the axes, a curve would have too many dashes to be drawn
        points = clip(points, content.x.range, content.y.range);
    }
    QCPGraph *graph = drawing.addCurve(drawing.axisRect(), points);
    if (!series.name.isEmpty()) {
        graph->setName(series.name);
        graph->addToLegend();
    }
    const QColor colour = colours.*series.colour;
    graph->setLineStyle(series.line == ChartSeries::Line::None ? QCPGraph::lsNone : QCPGraph::lsLine);
    graph->setPen(QPen(colour, kCurveWidth * lineFactor,
                       series.line == ChartSeries::Line::Dashed ? Qt::DashLine : Qt::SolidLine));
    if (!series.mark.isEmpty()) {
        constexpr double kUnscaled = 6.0;     // the size at which QCustomPlot does not scale the path
        constexpr double kOutlineWidth = 1.2; // px
        const QColor filling = series.isHollow ? colours.background : colour;
        graph->setScatterStyle(QCPScatterStyle(series.mark, QPen(colour, kOutlineWidth), filling, kUnscaled));
    }
}

/// Shades the axes outside the range of x.
void shadeOutside(PlotDrawing &drawing, const Interval &range, QColor colour)
{
    constexpr float kOpacity = 0.16F;
    colour.setAlphaF(kOpacity);
    const QCPRange axis = drawing.xAxis->range();
    const double from = std::min(range.lower, axis.upper);
    const double to = std::clamp(range.upper, from, axis.upper); // a reversed range leaves nothing unshaded
    for (const auto &[left, right] : {std::pair{axis.lower, from}, {to, axis.upper}}) {
        auto *shade = new QCPItemRect(&drawing);
        shade->setLayer("background");
        shade->setPen(Qt::NoPen);
        shade->setBrush(colour);
        shade->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
        shade->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
        shade->topLeft->setCoords(left, 0.0);
        shade->bottomRight->setCoords(right, 1.0);
    }
}

/// Places the legend beside the axes or, if they would become too narrow, over them. Hides it if it would cover too
/// much of the axes.
void placeLegend(PlotDrawing &drawing, const QSize &size)
{
    constexpr int kMinWidthOfAxes = 200;   // px
    constexpr double kSmallStretch = 1e-3; // so that the axes get the space that the legend does not need
    QCPLegend *legend = drawing.legend;
    const QSize needed = legend->minimumOuterSizeHint();
    const auto fits = [&needed](const QSize &space) { return needed.boundedTo(space) == needed; };
    const bool isBeside = fits(size - QSize(kMinWidthOfAxes, 0));
    legend->setVisible(legend->itemCount() > 0 && (isBeside || fits(size / 2)));
    if (legend->visible() && isBeside) {
        drawing.axisRect()->insetLayout()->take(legend);
        drawing.plotLayout()->addElement(0, 1, legend);
        drawing.plotLayout()->setColumnStretchFactor(1, kSmallStretch);
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
    m_drawing.reset();
    update();
}

/// Makes a new drawing of the content, laid out for the size.
void Chart::rebuildDrawing(const QSize &size, const QFont &font, const QPalette &palette)
{
    constexpr int kPixelsPerNumberOfX = 44; // width of a number and the gap beside it
    constexpr int kPixelsPerNumberOfY = 22; // height of a number and the gap below it
    const SeriesColours colours = seriesColours(palette);
    m_drawing = std::make_unique<PlotDrawing>();
    const PlotFonts fonts(font);
    m_drawing->setStyle(fonts, colours);
    m_drawing->layOut(size);
    setUpAxis(*m_drawing->xAxis, m_content.x, m_drawing->axisRect()->width(), kPixelsPerNumberOfX);
    setUpAxis(*m_drawing->yAxis, m_content.y, m_drawing->axisRect()->height(), kPixelsPerNumberOfY);
    if (m_content.unshaded) {
        shadeOutside(*m_drawing, *m_content.unshaded, colours.warning);
    }
    for (const ChartSeries &series : m_content.series) {
        addSeries(*m_drawing, m_content, series, colours, fonts.lineFactor);
    }
    QCPLegend *legend = m_drawing->legend;
    legend->setFont(fonts.tick);
    legend->setTextColor(colours.text);
    legend->setBrush(Qt::NoBrush);
    legend->setBorderPen(Qt::NoPen);
    placeLegend(*m_drawing, size);
    m_drawing->layOut(size);
}

void Chart::paintEvent(QPaintEvent *)
{
    rebuildDrawing(size(), font(), palette());
    m_drawing->drawInto(*this); // faster than paint(), which records the drawing first
}

void Chart::paint(QPainter &painter, const QSize &size, const QPalette &palette)
{
    rebuildDrawing(size, painter.font(), palette);
    m_drawing->paint(painter, size);
}

QPointF Chart::positionOf(const PointIndex &index)
{
    if (!m_drawing || m_drawing->viewport().size() != size()) {
        rebuildDrawing(size(), font(), palette());
    }
    const QPointF &point = m_content.series[index.series].points[index.point];
    return {m_drawing->xAxis->coordToPixel(coordinate(point.x(), m_content.x)),
            m_drawing->yAxis->coordToPixel(coordinate(point.y(), m_content.y))};
}

std::optional<Chart::PointIndex> Chart::pointAt(const QPointF &position)
{
    constexpr double kReach = 9.0; // px around a point
    double nearest = kReach;
    std::optional<PointIndex> found;
    for (std::size_t series = 0; series < m_content.series.size(); ++series) {
        const std::size_t points = m_content.series[series].mark.isEmpty() ? 0 : m_content.series[series].points.size();
        for (std::size_t point = 0; point < points; ++point) {
            const double distance = QLineF(positionOf({series, point}), position).length();
            if (distance <= nearest) {
                nearest = distance;
                found = PointIndex{series, point};
            }
        }
    }
    return found;
}

void Chart::mouseMoveEvent(QMouseEvent *event)
{
    const std::optional<PointIndex> index = pointAt(event->position());
    const QStringList tips = index ? m_content.series[index->series].tips : QStringList();
    const auto point = static_cast<qsizetype>(index ? index->point : 0);
    QToolTip::showText(event->globalPosition().toPoint(), tips.value(point), this); // an empty text hides the tool tip
}

} // namespace slidercrank

#include "moc_chart.cpp"
