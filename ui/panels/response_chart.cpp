// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/response_chart.h"

#include "ui/text/axis_scale.h"
#include "ui/text/written_number.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Indices of the series of the chart; Corners are two opposite corners of its axes.
enum Series : std::size_t { Corners, Curve };

/// Returns the range of the finite values, without the steep rise of a peak towards infinity.
Interval valueRange(const Response &response, std::size_t limit)
{
    constexpr double kSteep = 3.0; // times the median
    std::vector<double> values;
    for (const LimitValues &limits : response.limits) {
        if (const double value = limits[limit]; std::isfinite(value)) {
            values.push_back(value);
        }
    }
    if (values.empty()) {
        return {};
    }
    std::ranges::sort(values);
    const double steep = std::max(kSteep * values[values.size() / 2], values.front());
    return {values.front(), limit >= kFirstPeak ? std::min(values.back(), steep) : values.back()};
}

} // namespace

ResponseChart::ResponseChart(std::size_t limit)
    : m_limit(limit)
{
    setAccessibleName(title());
    setCursor(Qt::SizeHorCursor);
}

void ResponseChart::setCurve(const Response &response, const QString &title)
{
    m_range = response.range;
    m_curveRange = valueRange(response, m_limit);
    ChartContent content{{title, m_range.assembled}, {{}, {kNone, kNone}}};
    content.series = {{}, {.line = ChartSeries::Line::Solid}};
    for (std::size_t i = 0; i < response.values.size(); ++i) {
        content.series[Curve].points.emplace_back(response.values[i], response.limits[i][m_limit]);
    }
    setContent(content);
}

void ResponseChart::setDots(const Dots &dots)
{
    m_dots = dots;
    Interval range = m_curveRange;
    for (const Dot &dot : dots) {
        if (std::isfinite(dot.limits[m_limit])) {
            range = {std::min(range.lower, dot.limits[m_limit]), std::max(range.upper, dot.limits[m_limit])};
        }
    }
    range = roundedOutwards(range);
    if (range != content().y.range) {
        ChartContent changed = content();
        const Interval &across = m_range.assembled;
        changed.y.range = range;
        changed.series[Corners].points = {{across.lower, range.lower}, {across.upper, range.upper}};
        setContent(changed);
        m_picture = {};
    }
    setAccessibleDescription(shortNumber(dots[0].limits[m_limit], 4));
    update();
}

QString ResponseChart::title() const
{
    const std::array titles{tr("stroke [mm]"), tr("time ratio"), tr("min. transmission angle [°]"),
                            tr("peak slider speed [mm/s]"), tr("peak slider acc. [mm/s²]")};
    return titles[m_limit];
}

QRectF ResponseChart::axisArea()
{
    return content().series.empty()
               ? QRectF()
               : QRectF(Chart::positionOf({Corners, 0}), Chart::positionOf({Corners, 1})).normalized();
}

QPointF ResponseChart::positionOf(const Dot &dot)
{
    const QRectF area = axisArea();
    const auto part = [](double value, const Interval &range) { return (value - range.lower) / range.length(); };
    return {area.left() + area.width() * part(dot.value, m_range.assembled),
            area.bottom() - area.height() * part(dot.limits[m_limit], content().y.range)};
}

/// Shades the values with which the crank does not make full turns.
void ResponseChart::paintShade(QPainter &painter, const QPalette &palette)
{
    constexpr float kOpacity = 0.16F;
    const QRectF area = axisArea();
    QColor colour = seriesColours(palette).warning;
    colour.setAlphaF(kOpacity);
    const Interval &range = m_range.fullTurn;
    const auto pixel = [&](double value) {
        return range.lower > range.upper ? area.right()
                                         : std::clamp(positionOf(Dot{value}).x(), area.left(), area.right());
    };
    painter.fillRect(QRectF(area.topLeft(), QPointF(pixel(range.lower), area.bottom())), colour);
    painter.fillRect(QRectF(QPointF(pixel(range.upper), area.top()), area.bottomRight()), colour);
}

void ResponseChart::paintDots(QPainter &painter, const QPalette &palette)
{
    constexpr double kRadius = 4.5; // px
    constexpr double kRing = 9.0;
    const QRectF area = axisArea();
    const SeriesColours colours = seriesColours(palette);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = m_dots.size(); i-- > 0;) { // the current value is drawn above the pinned motions
        const QPointF dot = positionOf(m_dots[i]);
        if (!std::isfinite(m_dots[i].limits[m_limit]) || !m_range.assembled.contains(m_dots[i].value)) {
            continue;
        }
        const QColor colour = i == 0 ? colours.cursor : colours.pinned;
        painter.setPen(colour);
        painter.setBrush(i == 0 ? colour : colours.background);
        painter.drawEllipse(dot, kRadius, kRadius);
        painter.setBrush(Qt::NoBrush);
        const bool isRight = dot.x() > area.center().x();
        QRectF label(dot.x() + kRing, dot.y() - 2.0 * kRing, area.width(), 2.0 * kRing);
        label.moveLeft(isRight ? dot.x() - kRing - label.width() : label.left());
        painter.drawText(label, isRight ? Qt::AlignRight : Qt::AlignLeft, shortNumber(m_dots[i].limits[m_limit], 4));
    }
}

void ResponseChart::paintEvent(QPaintEvent *)
{
    if (content().series.empty()) {
        return;
    }
    const QSize pixels = size() * devicePixelRatio();
    if (m_picture.size() != pixels) {
        m_picture = QPixmap(pixels);
        m_picture.setDevicePixelRatio(devicePixelRatio());
        QPainter painter(&m_picture);
        paint(painter, size(), palette());
        paintShade(painter, palette());
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    paintDots(painter, palette());
}

void ResponseChart::changeEvent(QEvent *event)
{
    m_picture = {};
    Chart::changeEvent(event);
}

void ResponseChart::paintAll(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    ResponseChart copy(m_limit);
    copy.resize(size);
    copy.m_range = m_range;
    copy.m_dots = m_dots;
    copy.setContent(content());
    copy.paint(painter, size, palette);
    copy.paintShade(painter, palette);
    copy.paintDots(painter, palette);
}

/// Requests the value at that position, rounded to a small fraction of the range and limited to the range.
void ResponseChart::requestAt(double pixel)
{
    const QRectF area = axisArea();
    if (area.width() <= 0.0) {
        return;
    }
    const auto &[lower, upper] = m_range.assembled;
    const double value = std::lerp(lower, upper, (pixel - area.left()) / area.width());
    const double step = nextRoundNumber((upper - lower) / 400.0);
    const double rounded = QString::number(std::round(value / step) * step, 'g', 12).toDouble();
    emit requested(std::clamp(rounded, lower, upper));
}

void ResponseChart::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton) {
        emit dragBegan();
        requestAt(event->position().x());
    }
}

void ResponseChart::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton) {
        requestAt(event->position().x());
    } else {
        Chart::mouseMoveEvent(event);
    }
}

void ResponseChart::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton) {
        emit dragEnded();
    }
}

} // namespace slidercrank
