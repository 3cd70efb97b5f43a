// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_drawing.h"

#include "ui/text/written_number.h"

#include <QLocale>
#include <QPicture>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

/// Draws a line as separate segments and dashes. Qt draws them several times faster than a polyline.
class SegmentedGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;

protected:
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &points) const override
    {
        if (painter->device()->devType() == QInternal::Picture) { // an export: the corners of the line are joined
            return QCPGraph::drawLinePlot(painter, points);
        }
        constexpr double kEndless = 1e9;     // line widths
        constexpr double kMinSegment = 1e-3; // px
        QPen pen = painter->pen();
        const QVector<double> dashes = pen.style() == Qt::SolidLine ? QVector<double>{kEndless} : pen.dashPattern();
        qsizetype dash = 0; // odd in a gap between two dashes
        double remaining = dashes[0] * pen.widthF();
        QVector<QLineF> segments;
        for (qsizetype i = 1; i < points.size(); ++i) {
            const QLineF line(points[i - 1], points[i]);
            const double length = line.length();
            double from = 0.0;
            while (length - from > kMinSegment) { // false if the length is NaN
                const double to = std::min(from + remaining, length);
                if (dash % 2 == 0) {
                    segments << QLineF(line.pointAt(from / length), line.pointAt(to / length));
                }
                remaining -= to - from;
                from = to;
                if (remaining < kMinSegment) {
                    dash = (dash + 1) % dashes.size();
                    remaining = dashes[dash] * pen.widthF();
                }
            }
        }
        pen.setStyle(Qt::SolidLine);
        painter->setPen(pen);
        painter->drawLines(segments);
    }
};

/// Returns an angle of whole degrees as a multiple of π: "−3π/2".
QString multipleOfPiText(long degrees)
{
    const long divisor = std::gcd(degrees, 180L);
    const long numerator = std::abs(degrees) / divisor;
    if (numerator == 0) {
        return numberText(0.0);
    }
    const QString multiple = numerator == 1 ? QStringLiteral("π") : QStringLiteral("%1π").arg(numerator);
    const QString text = divisor == 180 ? multiple : QStringLiteral("%1/%2").arg(multiple).arg(180 / divisor);
    return degrees < 0 ? QStringLiteral("−") + text : text;
}

/// Returns the exponent of the power of ten that all labels of an axis shall have, or nullopt if numberText() writes
/// none of them with a power. Labels such as "500000" and "10⁶", or "5·10⁹" and "10¹⁰", would be hard to compare.
/// `largest`: the largest magnitude on the axis. `digits`: the significant digits of the labels.
std::optional<int> commonPower(double step, double largest, int digits)
{
    constexpr int kSmallestPlain = -4; // exponent down to which numberText() writes no power
    if (!(step > 0.0) || !std::isfinite(largest) || largest < step) {
        return std::nullopt;
    }
    const auto exponentOf = [](double magnitude) { return static_cast<int>(std::floor(std::log10(magnitude))); };
    const auto isWrittenWithPower = [digits](int exponent) { return exponent < kSmallestPlain || exponent >= digits; };
    const double largestLabel = std::floor(largest / step * (1.0 + kEpsilon)) * step;
    const bool hasPower = isWrittenWithPower(exponentOf(step)) || isWrittenWithPower(exponentOf(largestLabel));
    return hasPower ? std::optional(exponentOf(largestLabel)) : std::nullopt;
}

} // namespace

double smallestDetail(const QPainter &painter)
{
    constexpr double kOnPaper = 0.06; // mm
    constexpr double kMmPerInch = 25.4;
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    const double dotsPerPixel = std::sqrt(std::abs(painter.deviceTransform().determinant()));
    const double dots = isVector ? kOnPaper / kMmPerInch * painter.device()->logicalDpiX() : 1.0;
    return dots / dotsPerPixel;
}

double NumberTicker::getTickStep(const QCPRange &range)
{
    constexpr double kMinDigits = 6.0;
    constexpr double kMaxDigits = 17.0;
    constexpr double kFullTurn = 360.0;
    constexpr std::array kTurnSteps{10.0, 15.0, 30.0, 45.0, 90.0, 180.0}; // °
    const double unit = std::abs(perUnit);
    const double wantedStep = range.size() / unit / mTickCount;
    m_step = nextRoundNumber(wantedStep);
    const double perDegree = angle ? shownValue(Measure::Angle, 1.0, {.angle = *angle}) / kDegreesPerRadian : 1.0;
    const double degrees = wantedStep / perDegree;
    m_isPartOfTurn = angle && degrees > 0.5 * kTurnSteps.front();
    if (m_isPartOfTurn) {
        m_step = perDegree * (degrees > kTurnSteps.back()
                                  ? std::max(kFullTurn, kFullTurn * nextRoundNumber(degrees / kFullTurn))
                                  : *std::ranges::lower_bound(kTurnSteps, degrees));
    } else if (isLogarithmic) {
        m_step = std::max(1.0, m_step);
    } else if (const double step = m_step * unit; mTickCount > 1 && std::floor((range.upper - mTickOrigin) / step) <=
                                                                        std::ceil((range.lower - mTickOrigin) / step)) {
        // A single tick shows no scale. In the series 1, 2, 5, 10, each number is at least this fraction of the next.
        constexpr double kToNextSmaller = 0.4;
        m_step = nextRoundNumber(kToNextSmaller * m_step);
    }
    const double largest = std::max(std::abs(range.lower - mTickOrigin), std::abs(range.upper - mTickOrigin)) / unit;
    const double digits = std::ceil(std::log10(largest / m_step)) + 1.0; // not finite if the range underflows
    m_digits = static_cast<int>(std::min(std::max(kMinDigits, digits), kMaxDigits));
    m_commonPower = commonPower(m_step, largest, m_digits);
    return m_step * unit;
}

QVector<QString> NumberTicker::createLabelVector(const QVector<double> &ticks, const QLocale &locale, QChar format,
                                                 int precision)
{
    QVector<QString> labels = QCPAxisTicker::createLabelVector(ticks, locale, format, precision);
    const bool isCrowded = ticks.size() > 2 && ticks[1] - ticks[0] < minLabelDistance;
    for (qsizetype i = 1; isCrowded && i < labels.size(); i += 2) {
        labels[i].clear();
    }
    return labels;
}

QString NumberTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    constexpr double kRoundingError = 1e-6; // fraction of a step
    const double value = (tick - mTickOrigin) / perUnit;
    if (m_isPartOfTurn && angle == AngleUnit::Radian) {
        return multipleOfPiText(std::lround(value * kDegreesPerRadian));
    }
    if (isLogarithmic) {
        return powerOfTenText(static_cast<int>(std::lround(value)));
    }
    if (std::abs(value) < kRoundingError * m_step) {
        return numberText(0.0);
    }
    if (m_commonPower) {
        return withPowerOfTen(numberText(value / std::pow(10.0, *m_commonPower), m_digits), *m_commonPower);
    }
    return numberText(value, m_digits);
}

PlotDrawing::PlotDrawing()
{
    mReplotting = true; // otherwise QCustomPlot replots into buffers that are not used
    setAutoAddPlottableToLegend(false);
}

void PlotDrawing::layOut(const QSize &size)
{
    setViewport(QRect(QPoint(), size));
    QCustomPlot::updateLayout();
}

void PlotDrawing::drawInto(QPaintDevice &device)
{
    setBufferDevicePixelRatio(device.devicePixelRatioF());
    QCPPainter painter(&device);
    painter.fillRect(viewport(), mBackgroundBrush);
    draw(&painter);
}

void PlotDrawing::paint(QPainter &painter, const QSize &size)
{
    // QCustomPlot draws only with a QCPPainter. The drawing is recorded with one and replayed with the given painter.
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    QPicture recording;
    QCPPainter recorder(&recording);
    recorder.setMode(QCPPainter::pmVectorized, isVector);
    toPainter(&recorder, size.width(), size.height());
    recorder.end();
    painter.drawPicture(0, 0, recording);
}

void PlotDrawing::setStyle(const PlotFonts &fonts, const SeriesColours &colours)
{
    setBackground(QBrush(colours.background));
    // Fraction of the text colour in that of the frame. The colours are mixed here, because Qt starts threads to draw a
    // transparent line, which takes longer than the line.
    constexpr double kTextInFrame = 0.55;
    constexpr int kLineWidth = 1; // px
    const QColor frame = mixed(colours.text, colours.background, kTextInFrame);
    const QPen framePen(frame, kLineWidth);
    const QPen gridPen(colours.grid, kLineWidth);
    for (QCPAxisRect *rect : axisRects()) {
        for (QCPAxis *axis : rect->axes()) {
            axis->setBasePen(framePen);
            axis->setTickPen(framePen);
            axis->setTickLabelColor(colours.text);
            axis->setTickLabelFont(fonts.tick);
            axis->setSubTicks(false);
            axis->setLabelColor(colours.text);
            axis->setLabelFont(fonts.tick);
            axis->grid()->setPen(gridPen);
            axis->grid()->setZeroLinePen(axis->orientation() == Qt::Vertical ? framePen : gridPen);
        }
    }
}

QCPGraph *PlotDrawing::addCurve(QCPAxisRect *axes, std::span<const CurvePoint> points)
{
    QVector<QCPGraphData> graphData;
    graphData.reserve(static_cast<qsizetype>(points.size()));
    for (const CurvePoint &point : points) {
        graphData << QCPGraphData(point.t, point.value);
    }
    auto *curve = new SegmentedGraph(axes->axis(QCPAxis::atBottom), axes->axis(QCPAxis::atLeft));
    curve->setAdaptiveSampling(false); // it draws falling curves thicker than rising ones
    constexpr bool kIsSorted = true;   // by time
    curve->data()->set(graphData, kIsSorted);
    return curve;
}

} // namespace slidercrank
