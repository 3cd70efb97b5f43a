// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_figure.h"

#include "ui/text/axis_scale.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kRadius = 4.0;       // px, of a point
constexpr int kFontPixels = 11;       // pixel sizes: SVG would scale points
constexpr double kLegendGap = 12.0;   // px, between the picture and its legend
constexpr double kLegendSign = 22.0;  // px, for a mark or a piece of line before its name
constexpr double kLeastWidth = 200.0; // px, of the picture beside a legend
constexpr double kLeastError = 1e-17; // an error of 0 is drawn here, below what a double can resolve

struct StudyFigureText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StudyFigureText)
};

struct Decades {
    int from = 0;
    int to = 1;

    void include(double value)
    {
        const double logarithm = std::log10(value);
        from = std::min(from, static_cast<int>(std::floor(logarithm)));
        to = std::max(to, static_cast<int>(std::ceil(logarithm)));
    }
    double part(double value) const { return (std::log10(value) - from) / (to - from); }

    /// Between labels, so that as many fit.
    int step(double most) const
    {
        for (const int step : {1, 2, 4, 5}) {
            if ((to - from) / step <= most) {
                return step;
            }
        }
        return 10;
    }
};

/// κ·u over the instants of the methods that solve the most.
std::optional<double> boundOf(const CaseResult &which)
{
    const std::size_t solved = static_cast<std::size_t>(Status::Solved);
    const MethodResult *best = nullptr;
    for (const MethodResult &row : which.methods) {
        if (row.silentFailures && (!best || row.counts[solved] > best->counts[solved])) {
            best = &row;
        }
    }
    return best && best->errorBound && *best->errorBound > 0.0 ? best->errorBound : std::nullopt;
}

bool hasPoint(const MethodResult &row)
{
    return row.maxError && row.nsPerState > 0.0;
}

double shownError(const MethodResult &row)
{
    const double error = row.maxError.value_or(kLeastError);
    return std::max(kLeastError, std::isfinite(error) ? error : 1.0);
}

struct Axes {
    QRectF area;
    Decades time;
    Decades error;

    QPointF place(double nanoseconds, double relativeError) const
    {
        return {area.left() + area.width() * time.part(nanoseconds), heightOf(relativeError)};
    }
    double heightOf(double relativeError) const { return area.bottom() - area.height() * error.part(relativeError); }
};

QFont labelFont()
{
    QFont font;
    font.setPixelSize(kFontPixels);
    return font;
}

/// The kinds of method that have a point, in the order of their rows.
std::vector<MethodName::Kind> kindsIn(const CaseResult &which)
{
    std::vector<MethodName::Kind> kinds;
    for (const MethodResult &row : which.methods) {
        if (hasPoint(row) && std::ranges::count(kinds, row.method.kind) == 0) {
            kinds.push_back(row.method.kind);
        }
    }
    return kinds;
}

/// A row of that kind, which solves all.
MethodResult solvedBy(MethodName::Kind kind)
{
    MethodResult row;
    row.method.kind = kind;
    return row;
}

QString legendText(MethodName::Kind kind)
{
    return kind == MethodName::Kind::Harmonics ? StudyFigureText::tr("so many harmonics") : titleOf(solvedBy(kind));
}

struct LineNames {
    QString front = StudyFigureText::tr("fastest for its error");
    QString bound = StudyFigureText::tr("cost of rounded input");
};

/// Of the legend beside the picture; 0 where there is no room for it.
double legendWidth(const CaseResult &which, const QSize &size)
{
    const QFontMetricsF metrics(labelFont());
    const std::vector<MethodName::Kind> kinds = kindsIn(which);
    const LineNames lines;
    double widest = std::max(metrics.horizontalAdvance(lines.front), metrics.horizontalAdvance(lines.bound));
    for (const MethodName::Kind kind : kinds) {
        widest = std::max(widest, metrics.horizontalAdvance(legendText(kind)));
    }
    const double width = kLegendGap + kLegendSign + widest;
    const double height = metrics.height() * static_cast<double>(kinds.size() + 2);
    return !kinds.empty() && size.width() - width >= kLeastWidth && size.height() >= height ? width : 0.0;
}

Axes axesOf(const CaseResult &which, const QSize &size)
{
    Axes axes;
    axes.time = {1, 3};
    axes.error = {-17, 0}; // with room below the last digit of a double
    for (const MethodResult &row : which.methods) {
        if (hasPoint(row)) {
            axes.time.include(row.nsPerState);
            axes.error.include(shownError(row));
        }
    }
    if (const std::optional<double> bound = boundOf(which)) {
        axes.error.include(*bound);
    }
    const QFontMetricsF metrics(labelFont());
    const double left = metrics.height() + metrics.horizontalAdvance(powerOfTen(-16)) + 10.0;
    const double right = 10.0 + legendWidth(which, size);
    const double bottom = 2.0 * metrics.height() + 6.0;
    axes.area =
        QRectF(left, 6.0, std::max(20.0, size.width() - left - right), std::max(20.0, size.height() - bottom - 6.0));
    return axes;
}

QColor colourOf(MethodName::Kind kind, const SeriesColours &colours)
{
    switch (kind) {
    case MethodName::Kind::NewtonDense:
    case MethodName::Kind::NewtonDenseTaylor: return colours.reference;
    case MethodName::Kind::NewtonStructured:
    case MethodName::Kind::NewtonStructuredTaylor: return colours.model;
    case MethodName::Kind::ClosedForm:
    case MethodName::Kind::ClosedFormBatch: return colours.errorOther;
    case MethodName::Kind::FiniteDifference:
    case MethodName::Kind::Harmonics: return colours.error;
    }
    return {};
}

/// A polygon around the origin, its first corner straight above it, every other one that far away.
QPolygonF starOf(int corners, double outer, double inner)
{
    QPolygonF polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double distance = i % 2 == 0 ? outer : inner;
        polygon << QPointF(distance * std::sin(angle), -distance * std::cos(angle));
    }
    return polygon;
}

/// Of about the same size, around the origin.
QPainterPath shapeOf(MethodName::Kind kind)
{
    const QPolygonF cross{{-0.4, -1.3}, {0.4, -1.3}, {0.4, -0.4}, {1.3, -0.4}, {1.3, 0.4},   {0.4, 0.4},
                          {0.4, 1.3},   {-0.4, 1.3}, {-0.4, 0.4}, {-1.3, 0.4}, {-1.3, -0.4}, {-0.4, -0.4}};
    QPainterPath path;
    switch (kind) {
    case MethodName::Kind::NewtonDense: path.addRect(QRectF(-1.0, -1.0, 2.0, 2.0)); break;
    case MethodName::Kind::NewtonDenseTaylor: path.addPolygon(QTransform().rotate(45.0).map(cross)); break;
    case MethodName::Kind::NewtonStructured: path.addEllipse(QPointF(), 1.1, 1.1); break;
    case MethodName::Kind::NewtonStructuredTaylor: path.addPolygon(cross); break;
    case MethodName::Kind::ClosedForm: path.addPolygon(starOf(4, 1.5, 1.5)); break;
    case MethodName::Kind::ClosedFormBatch: path.addPolygon(starOf(10, 1.7, 0.7)); break;
    case MethodName::Kind::FiniteDifference:
        path.addPolygon(QTransform().rotate(180.0).map(starOf(3, 1.4, 1.4)));
        break;
    case MethodName::Kind::Harmonics: path.addPolygon(starOf(3, 1.4, 1.4)); break;
    }
    path.closeSubpath();
    return path;
}

void drawGrid(QPainter &painter, const Axes &axes, const SeriesColours &colours, const QSize &size)
{
    const QFontMetricsF metrics(painter.font());
    const double lineHeight = metrics.height();
    const int timeStep = axes.time.step(axes.area.width() / 45.0);
    const int errorStep = axes.error.step(axes.area.height() / (1.3 * lineHeight));
    for (int decade = axes.time.from; decade <= axes.time.to; ++decade) {
        const double x = axes.place(std::pow(10.0, decade), 1.0).x();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(x, axes.area.top()), QPointF(x, axes.area.bottom()));
        if ((decade - axes.time.from) % timeStep == 0) {
            painter.setPen(colours.text);
            painter.drawText(QRectF(x - 40.0, axes.area.bottom() + 2.0, 80.0, lineHeight),
                             Qt::AlignHCenter | Qt::AlignTop, powerOfTen(decade));
        }
    }
    for (int decade = axes.error.from; decade <= axes.error.to; ++decade) {
        if (decade % errorStep != 0) {
            continue;
        }
        const double y = axes.heightOf(std::pow(10.0, decade));
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(axes.area.left(), y), QPointF(axes.area.right(), y));
        painter.setPen(colours.text);
        painter.drawText(QRectF(0.0, y - lineHeight, axes.area.left() - 4.0, 2.0 * lineHeight),
                         Qt::AlignRight | Qt::AlignVCenter, powerOfTen(decade));
    }
    painter.setPen(colours.text);
    painter.drawText(QRectF(axes.area.left(), size.height() - lineHeight - 2.0, axes.area.width(), lineHeight),
                     Qt::AlignCenter, StudyFigureText::tr("time per state [ns]"));
    painter.save();
    painter.translate(0.0, axes.area.bottom());
    painter.rotate(-90.0);
    painter.drawText(QRectF(0.0, 1.0, axes.area.height(), lineHeight), Qt::AlignCenter,
                     StudyFigureText::tr("error / peak"));
    painter.restore();
}

/// From the top at the fastest method, right and down to the most exact.
QPolygonF frontOf(const Axes &axes, const CaseResult &which)
{
    QPolygonF line;
    for (const std::size_t row : bestFront(which)) {
        const MethodResult &method = which.methods[row];
        const QPointF at = axes.place(method.nsPerState, shownError(method));
        line << QPointF(at.x(), line.isEmpty() ? axes.area.top() : line.back().y()) << at;
    }
    if (!line.isEmpty()) {
        line << QPointF(axes.area.right(), line.back().y());
    }
    return line;
}

/// Beside points, where they hide neither points nor one another; over a line only where there is no room else. A point
/// that is crowded in has none.
class Labels
{
public:
    Labels(QPainter &painter, const QRectF &area, const QColor &background, const std::vector<StudyPoint> &points)
        : m_painter(painter)
        , m_area(area)
        , m_background(background)
    {
        for (const StudyPoint &point : points) {
            m_taken.push_back(QRectF(point.at.x() - kRadius, point.at.y() - kRadius, 2.0 * kRadius, 2.0 * kRadius));
        }
    }

    void take(const QRectF &place) { m_taken.push_back(place); }
    void avoid(const QPolygonF &line)
    {
        for (qsizetype i = 1; i < line.size(); ++i) {
            m_lines.push_back(QRectF(line[i - 1], line[i]).normalized().adjusted(-1.0, -1.0, 1.0, 1.0));
        }
    }

    void put(const QPointF &at, const QString &text)
    {
        const QFontMetricsF metrics(m_painter.font());
        const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
        const double away = kRadius + 3.0;
        const double right = at.x() + away;
        const double left = at.x() - away - size.width();
        const double middle = at.x() - 0.5 * size.width();
        const double above = at.y() - away - size.height();
        const double below = at.y() + away;
        const double beside = at.y() - 0.5 * size.height();
        const std::array candidates{QPointF(right, beside), QPointF(left, beside),      QPointF(middle, above),
                                    QPointF(middle, below), QPointF(at.x() + 2, above), QPointF(at.x() + 2, below),
                                    QPointF(right, above),  QPointF(left, above),       QPointF(left, below)};
        for (const bool overLines : {false, true}) {
            for (const QPointF &corner : candidates) {
                const QRectF place(corner, size);
                if (m_area.contains(place) && !hits(m_taken, place) && (overLines || !hits(m_lines, place))) {
                    if (overLines) {
                        m_painter.fillRect(place, m_background);
                    }
                    m_painter.drawText(place, Qt::AlignCenter, text);
                    m_taken.push_back(place);
                    return;
                }
            }
        }
    }

private:
    static bool hits(const std::vector<QRectF> &others, const QRectF &place)
    {
        return std::any_of(others.begin(), others.end(),
                           [&place](const QRectF &other) { return other.intersects(place); });
    }

    QPainter &m_painter;
    QRectF m_area;
    QColor m_background;
    std::vector<QRectF> m_taken;
    std::vector<QRectF> m_lines;
};

bool isSolvedThroughout(const MethodResult &row)
{
    return row.status == Status::Solved || row.status == Status::NotAssemblable;
}

QPen frontPen(const SeriesColours &colours)
{
    return QPen(colours.cursor, 1.0);
}

QPen boundPen(const SeriesColours &colours)
{
    return QPen(colours.warning, 1.0, Qt::DashLine);
}

void drawLegend(QPainter &painter, const Axes &axes, const CaseResult &which, const SeriesColours &colours)
{
    const double lineHeight = QFontMetricsF(painter.font()).height();
    const double left = axes.area.right() + kLegendGap;
    const double middle = left + 0.4 * kLegendSign;
    double y = 0.5 * lineHeight;
    const auto write = [&](const QString &text) {
        painter.setPen(colours.text);
        painter.drawText(QPointF(left + kLegendSign, y + 0.35 * lineHeight), text);
        y += lineHeight;
    };
    for (const MethodName::Kind kind : kindsIn(which)) {
        drawMark(painter, {middle, y}, solvedBy(kind), colours);
        write(legendText(kind));
    }
    const LineNames names;
    const auto drawLine = [&](const QPen &pen) {
        painter.setPen(pen);
        painter.drawLine(QPointF(left, y), QPointF(left + 0.8 * kLegendSign, y));
    };
    drawLine(frontPen(colours));
    write(names.front);
    if (boundOf(which)) {
        drawLine(boundPen(colours));
        write(names.bound);
    }
}

} // namespace

void drawMark(QPainter &painter, const QPointF &at, const MethodResult &row, const SeriesColours &colours)
{
    const QColor colour = colourOf(row.method.kind, colours);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(isSolvedThroughout(row) ? QBrush(colour) : QBrush(colours.background));
    painter.drawPath(QTransform::fromTranslate(at.x(), at.y()).scale(kRadius, kRadius).map(shapeOf(row.method.kind)));
}

QString titleOf(const MethodResult &row)
{
    switch (row.method.kind) {
    case MethodName::Kind::NewtonDense: return StudyFigureText::tr("Newton dense (report)");
    case MethodName::Kind::NewtonDenseTaylor: return StudyFigureText::tr("Newton dense, Taylor");
    case MethodName::Kind::NewtonStructured: return StudyFigureText::tr("Newton structured");
    case MethodName::Kind::NewtonStructuredTaylor: return StudyFigureText::tr("Newton structured, Taylor");
    case MethodName::Kind::ClosedForm: return StudyFigureText::tr("closed form");
    case MethodName::Kind::ClosedFormBatch: return StudyFigureText::tr("closed form, batch");
    case MethodName::Kind::FiniteDifference: return StudyFigureText::tr("differences");
    case MethodName::Kind::Harmonics: return StudyFigureText::tr("%1 harmonics").arg(row.method.harmonics);
    }
    return {};
}

/// What the method does.
QString explanationOf(MethodName::Kind kind)
{
    switch (kind) {
    case MethodName::Kind::NewtonDense:
        return StudyFigureText::tr("Newton-Raphson as in the report: 12 equations solved together (dense LU), started "
                                   "from the instant before");
    case MethodName::Kind::NewtonStructured:
        return StudyFigureText::tr("Newton-Raphson on the same 12 equations, solved joint by joint");
    case MethodName::Kind::NewtonDenseTaylor:
    case MethodName::Kind::NewtonStructuredTaylor:
        return StudyFigureText::tr("The same, started from the position, velocity and acceleration of the instant "
                                   "before (Taylor series)");
    case MethodName::Kind::ClosedForm: return StudyFigureText::tr("The exact formulas, instant by instant");
    case MethodName::Kind::ClosedFormBatch:
        return StudyFigureText::tr("The exact formulas for several instants at once (vector instructions)");
    case MethodName::Kind::FiniteDifference:
        return StudyFigureText::tr("Velocity and acceleration as central differences of exact positions");
    case MethodName::Kind::Harmonics:
        return StudyFigureText::tr("The motion as a Fourier series with so many harmonics");
    }
    return {};
}

QString descriptionOf(const MethodResult &row)
{
    QString text = titleOf(row);
    if (row.tolerance) {
        text += StudyFigureText::tr(", tolerance %1").arg(numberText(*row.tolerance, 3));
    }
    text += u'\n' + explanationOf(row.method.kind);
    text += u'\n' +
            StudyFigureText::tr("%1 ns per state (± %2), %3 channels")
                .arg(shortNumber(row.nsPerState, 3), shortNumber(0.5 * row.spread, 2), QString::number(row.channels));
    if (row.iterationsPerState) {
        text += u'\n' + StudyFigureText::tr("%1 iterations per state").arg(shortNumber(*row.iterationsPerState, 3));
    }
    text +=
        u'\n' + (row.maxError ? StudyFigureText::tr("largest error %1 of the peak").arg(shortNumber(*row.maxError, 3))
                              : StudyFigureText::tr("no instant solved"));
    if (row.errorBound) {
        text += u'\n' + StudyFigureText::tr("rounding a, b, c, ω₂, θ₂₀ and t to doubles alone may cost %1")
                            .arg(shortNumber(*row.errorBound, 3));
    }
    return text;
}

std::vector<StudyPoint> studyPoints(const CaseResult &which, const QSize &size)
{
    const Axes axes = axesOf(which, size);
    std::vector<StudyPoint> points;
    for (std::size_t row = 0; row < which.methods.size(); ++row) {
        const MethodResult &method = which.methods[row];
        if (hasPoint(method)) {
            points.push_back({row, axes.place(method.nsPerState, shownError(method))});
        }
    }
    return points;
}

void drawStudy(QPainter &painter, const QSize &size, const CaseResult &which, const SeriesColours &colours,
               std::optional<std::size_t> marked)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(labelFont());
    painter.fillRect(QRect(QPoint(0, 0), size), colours.background);
    const Axes axes = axesOf(which, size);
    const std::vector<StudyPoint> points = studyPoints(which, size);
    drawGrid(painter, axes, colours, size);
    const QPolygonF frontLine = frontOf(axes, which);
    painter.setPen(frontPen(colours));
    painter.drawPolyline(frontLine);

    Labels labels(painter, axes.area, colours.background, points);
    labels.avoid(frontLine);
    const std::optional<double> bound = boundOf(which);
    if (bound) {
        const QPolygonF line{{axes.area.left(), axes.heightOf(*bound)}, {axes.area.right(), axes.heightOf(*bound)}};
        painter.setPen(boundPen(colours));
        painter.drawPolyline(line);
        labels.avoid(line);
    }
    for (const StudyPoint &point : points) {
        const MethodResult &row = which.methods[point.row];
        drawMark(painter, point.at, row, colours);
        if (point.row == marked) {
            painter.setPen(QPen(colours.cursor, 1.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(point.at, 2.4 * kRadius, 2.4 * kRadius);
        }
    }
    for (const StudyPoint &point : points) {
        if (const MethodName &method = which.methods[point.row].method; method.kind == MethodName::Kind::Harmonics) {
            painter.setPen(colourOf(method.kind, colours));
            labels.put(point.at, QString::number(method.harmonics));
        }
    }
    if (legendWidth(which, size) > 0.0) {
        drawLegend(painter, axes, which, colours);
    }
    painter.restore();
}

} // namespace slidercrank
