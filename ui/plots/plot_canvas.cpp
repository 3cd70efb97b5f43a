// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_canvas.h"

#include "ui/text/axis_scale.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slidercrank
{

PlotCanvas::PlotCanvas(QWidget *parent)
    : QCustomPlot(parent)
    , m_timeTicker(new Ticker)
    , m_valueTicker(new Ticker)
    , m_rightTicker(new Ticker)
{
    setInteractions(QCP::Interactions());
    setAutoAddPlottableToLegend(false);
    setPlottingHint(QCP::phFastPolylines, true); // a line of width 2 costs four times as much without
    mPaintBuffers = {QSharedPointer<QCPAbstractPaintBuffer>(new OpaqueBuffer(this, bufferDevicePixelRatio()))};
    layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical); // no second pixmap: nothing is drawn there
    axisRect()->setAutoMargins(QCP::msNone);
    xAxis->setTicker(m_timeTicker);
    yAxis->setTicker(m_valueTicker);
    yAxis2->setTicker(m_rightTicker);
    for (QCPAxis *axis : {xAxis, yAxis, yAxis2}) {
        axis->setSubTicks(false);
        axis->setTickLength(0, kTickLength);
        axis->setTickLabelPadding(kLabelGap);
    }
    for (std::size_t curve = 0; curve < m_picture.curves.size(); ++curve) {
        addCurve();
    }
    new Bands(this);
    new Lettering(this);
}

QCPGraph *PlotCanvas::addCurve()
{
    QCPGraph *curve = addGraph();
    curve->setAdaptiveSampling(false);
    curve->setSelectable(QCP::stNone);
    return curve;
}

void PlotCanvas::setStyle(const PlotTypography &typography, const SeriesColours &colours)
{
    m_titleFont = typography.title;
    m_tickFont = typography.tick;
    m_lineFactor = typography.lineFactor;
    m_colours = colours;
    setBackground(QBrush(colours.background));
    constexpr double kFrameStrength = 0.55;
    const auto mixed = [](int text, int background) {
        return static_cast<int>(std::lround(kFrameStrength * text + (1.0 - kFrameStrength) * background));
    };
    const QColor frame(mixed(colours.text.red(), colours.background.red()),
                       mixed(colours.text.green(), colours.background.green()),
                       mixed(colours.text.blue(), colours.background.blue()));
    for (QCPAxis *axis : {xAxis, yAxis, yAxis2}) {
        axis->setBasePen(QPen(frame, 1));
        axis->setTickPen(QPen(frame, 1));
        axis->setTickLabelColor(colours.text);
        axis->setTickLabelFont(typography.tick);
        axis->grid()->setPen(QPen(colours.grid, 1));
        axis->grid()->setZeroLinePen(QPen(frame, 1));
    }
    xAxis->grid()->setZeroLinePen(Qt::NoPen); // t = 0 is the axis itself
}

void PlotCanvas::display(const PlotPicture &picture, const QMargins &margins)
{
    m_picture = picture;
    axisRect()->setMargins(margins);
    m_timeTicker->scale = picture.timeLabels.scale;
    m_timeTicker->zero = picture.timeLabels.zero;
    m_timeTicker->perUnit = picture.timeLabels.perUnit;
    m_timeTicker->setTickOrigin(picture.timeLabels.zero);
    m_valueTicker->scale = picture.valueScale;
    yAxis2->setVisible(picture.rightValues.has_value());
    if (picture.rightValues) {
        m_rightTicker->scale = picture.rightScale;
        yAxis2->setRange(picture.rightValues->lower, picture.rightValues->upper);
    }
    yAxis->setTickLabelColor(picture.rightValues ? colourOf(picture.curves[0].ink, m_colours) : m_colours.text);
    yAxis2->setTickLabelColor(colourOf(picture.curves[1].ink, m_colours));
    xAxis->setRange(picture.time.lower, picture.time.upper);
    yAxis->setRange(picture.values.lower, picture.values.upper);
    QString description = picture.words[0] + picture.title;
    for (const InkedText &remark : picture.remarks) {
        description += remark.text;
    }
    setAccessibleDescription(description);
    xAxis->setTickLabels(picture.hasTimeLabels);
    yAxis->setTickLabels(picture.hasValues);
    const auto show = [this](QCPGraph *line, const PlotPicture::Curve &curve) {
        QVector<QCPGraphData> points;
        points.reserve(static_cast<qsizetype>(curve.points.size()));
        for (const CurvePoint &point : curve.points) {
            points.append(QCPGraphData(point.t, point.value));
        }
        line->data()->set(points, true);
        line->setPen(penOf(curve.ink, m_colours, m_lineFactor));
    };
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        QCPGraph *line = graph(static_cast<int>(i));
        show(line, picture.curves[i]);
        line->setValueAxis(i == 1 && picture.rightValues ? yAxis2 : yAxis);
    }
    while (m_kept.size() < picture.kept.size()) {
        m_kept.push_back(addCurve());
        m_kept.back()->setLayer(QStringLiteral("grid"));
    }
    for (std::size_t i = 0; i < m_kept.size(); ++i) {
        show(m_kept[i], i < picture.kept.size() ? picture.kept[i] : PlotPicture::Curve());
    }
}

std::vector<QPolygonF> PlotCanvas::curvesInPixels() const
{
    std::vector<QPolygonF> parts;
    for (int i = 0; i < graphCount(); ++i) {
        bool isBroken = true;
        for (const QCPGraphData &point : *graph(i)->data()) {
            if (std::isnan(point.value)) {
                isBroken = true;
                continue;
            }
            if (isBroken) {
                parts.emplace_back();
                isBroken = false;
            }
            parts.back() << graph(i)->coordsToPixels(point.key, point.value);
        }
    }
    return parts;
}

void PlotCanvas::paintEvent(QPaintEvent *)
{
    if (devicePixelRatioF() != bufferDevicePixelRatio()) { // on another screen, or it was scaled anew
        setBufferDevicePixelRatio(devicePixelRatioF());
        replot(rpQueuedRefresh);
    }
    QCPPainter painter(this);
    for (const auto &buffer : mPaintBuffers) {
        buffer->draw(&painter);
    }
}

PlotCanvas::OpaqueBuffer::OpaqueBuffer(const PlotCanvas *plot, double devicePixelRatio)
    : QCPAbstractPaintBuffer(plot->size(), devicePixelRatio)
    , m_plot(plot)
{
    reallocateBuffer();
}

QCPPainter *PlotCanvas::OpaqueBuffer::startPainting()
{
    return new QCPPainter(&m_pixmap); // deleted by QCustomPlot
}

void PlotCanvas::OpaqueBuffer::clear(const QColor &)
{
    m_pixmap.fill(m_plot->m_colours.background);
}

void PlotCanvas::OpaqueBuffer::reallocateBuffer()
{
    setInvalidated();
    m_pixmap = QPixmap(mSize * mDevicePixelRatio);
    m_pixmap.setDevicePixelRatio(mDevicePixelRatio);
    clear({});
}

void PlotCanvas::Bands::draw(QCPPainter *painter)
{
    const PlotPicture &picture = m_plot->m_picture;
    const QRectF axes = m_plot->axisRect()->rect();
    painter->setPen(Qt::NoPen);
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        const PlotPicture::Curve &curve = picture.curves[i];
        painter->setBrush(bandColourOf(curve.ink, m_plot->m_colours));
        QPolygonF band;
        const auto finish = [&] {
            if (band.size() > 1) {
                band.append(QPointF(band.last().x(), axes.bottom()));
                band.prepend(QPointF(band.first().x(), axes.bottom()));
                painter->drawPolygon(band);
            }
            band.clear();
        };
        for (const CurvePoint &point : curve.band) {
            if (std::isnan(point.value)) {
                finish();
                continue;
            }
            const double x = m_plot->xAxis->coordToPixel(point.t);
            const double y = m_plot->valueAxisOf(i)->coordToPixel(point.value);
            // Painters do not like what is far outside; vector devices do not clip.
            band.append(QPointF(std::clamp(x, axes.left(), axes.right()), std::clamp(y, axes.top(), axes.bottom())));
        }
        finish();
    }
    painter->setBrush(Qt::NoBrush);
}

void PlotCanvas::Lettering::draw(QCPPainter *painter)
{
    const PlotPicture &picture = m_plot->m_picture;
    const SeriesColours &colours = m_plot->m_colours;
    const QRect axes = m_plot->axisRect()->rect();
    drawTitle(*painter, axes);

    painter->setFont(m_plot->m_tickFont);
    painter->setPen(QPen(colours.text));
    if (picture.hasTimeLabels) {
        // In the corner that both axes leave free.
        const QString first = picture.timeLabels.label(picture.time.lower);
        const double right = axes.left() - 0.5 * QFontMetricsF(m_plot->m_tickFont).horizontalAdvance(first) - 5.0;
        const QRectF corner(0.0, axes.bottom() + kTickLength + kLabelGap - 1, right, axes.height());
        painter->drawText(corner, Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip, picture.timeLabels.title);
    }
    if (!picture.note.isEmpty()) {
        painter->drawText(axes.adjusted(kLabelGap, 0, -kLabelGap, 0), Qt::AlignCenter | Qt::TextWordWrap, picture.note);
    }
    if (picture.markedTime && picture.hasValues && picture.time.contains(*picture.markedTime)) {
        const double x = m_plot->xAxis->coordToPixel(*picture.markedTime);
        painter->setPen(QPen(colours.cursor, 1.0));
        painter->drawLine(QPointF(x, axes.top()), QPointF(x, axes.bottom()));
    }
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        const PlotPicture::Curve &curve = picture.curves[i];
        const QCPAxis *valueAxis = m_plot->valueAxisOf(i);
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
            const QPointF centre(m_plot->xAxis->coordToPixel(point.t), valueAxis->coordToPixel(point.value));
            painter->drawEllipse(centre, 0.5 * kDotSize, 0.5 * kDotSize);
        }
        painter->setBrush(Qt::NoBrush);
    }
}

/// Whether the topmost number beside the axis reaches up to the line of the title.
bool PlotCanvas::Lettering::hasValueBesideTitle(const QRect &axes) const
{
    const QCPAxis *axis = m_plot->valueAxisOf(0);
    QVector<double> values;
    axis->ticker()->generate(axis->range(), QLocale(), QLatin1Char('g'), 6, values, nullptr, nullptr);
    const double half = 0.5 * QFontMetricsF(m_plot->m_tickFont).height();
    return std::any_of(values.begin(), values.end(), [&](double value) {
        const double y = axis->coordToPixel(value);
        return y > axes.top() - half && y < axes.top() + half;
    });
}

void PlotCanvas::Lettering::drawTitle(QCPPainter &painter, const QRect &axes) const
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
    const double room = picture.remarks.empty() ? m_plot->viewport().width() - kLabelGap - left
                                                : right - left - widthOf(picture.remarks);
    QString title = picture.title;
    for (const QString &words : picture.words) {
        const QString whole = words + picture.title;
        if (titleMetrics.horizontalAdvance(whole) + 2.0 * kLabelGap <= room) {
            title = whole;
            break;
        }
    }
    const double titleWidth = titleMetrics.horizontalAdvance(title) + 2.0 * kLabelGap;
    const std::vector<InkedText> *remarks = &picture.remarks;
    if (titleWidth + widthOf(*remarks) > right - left) {
        remarks = &picture.shortRemarks;
    }
    static const std::vector<InkedText> kNoRemarks;
    const double leftmost = hasValueBesideTitle(axes) ? left : kLabelGap;
    if (titleWidth + widthOf(*remarks) > right - left) {
        right = m_plot->viewport().width() - kLabelGap;
        remarks = titleWidth + widthOf(*remarks) > right - leftmost ? &kNoRemarks : remarks;
        left = std::min(left, std::max(leftmost, right - widthOf(*remarks) - titleWidth));
    }
    painter.setFont(m_plot->m_titleFont);
    painter.setPen(QPen(m_plot->m_colours.text));
    painter.drawText(QPointF(left, baseline), title);
    double x = right - widthOf(*remarks);
    painter.setFont(m_plot->m_tickFont);
    for (const InkedText &part : *remarks) {
        painter.setPen(QPen(colourOf(part.ink, m_plot->m_colours)));
        painter.drawText(QPointF(x, baseline), part.text);
        x += tickMetrics.horizontalAdvance(part.text);
    }
}

} // namespace slidercrank
