// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_figure.h"

#include "ui/words/axis_scale.h"
#include "ui/words/written_number.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kRadius = 3.6;       // px, of a point
constexpr int kFontPixels = 11;       // pixel sizes: SVG would scale points
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

Axes axesOf(const CaseResult &which, const QSize &size)
{
    Axes axes;
    axes.time = {1, 3};
    axes.error = {-18, 0}; // with room for names below the last digit of a double
    for (const MethodResult &row : which.methods) {
        if (row.maxError && row.nsPerState > 0.0) {
            axes.time.include(row.nsPerState);
            axes.error.include(shownError(row));
        }
    }
    if (const std::optional<double> bound = boundOf(which)) {
        axes.error.include(*bound);
    }
    const QFontMetricsF metrics(labelFont());
    const double left = metrics.height() + metrics.horizontalAdvance(powerOfTen(-16)) + 10.0;
    const double bottom = 2.0 * metrics.height() + 6.0;
    axes.area =
        QRectF(left, 6.0, std::max(20.0, size.width() - left - 10.0), std::max(20.0, size.height() - bottom - 6.0));
    return axes;
}

QColor colourOf(MethodKind kind, const SeriesColours &colours)
{
    switch (kind) {
    case MethodKind::NewtonDense: return colours.reference;
    case MethodKind::NewtonStructured: return colours.model;
    case MethodKind::ClosedForm: return colours.errorOther;
    case MethodKind::Approximation: return colours.error;
    }
    return {};
}

QPainterPath shapeOf(MethodKind kind, const QPointF &at, double r)
{
    QPainterPath path;
    switch (kind) {
    case MethodKind::NewtonDense: path.addRect(QRectF(at.x() - r, at.y() - r, 2.0 * r, 2.0 * r)); break;
    case MethodKind::NewtonStructured: path.addEllipse(at, 1.1 * r, 1.1 * r); break;
    case MethodKind::ClosedForm:
        path.addPolygon(QPolygonF({{at.x(), at.y() - 1.5 * r},
                                   {at.x() + 1.5 * r, at.y()},
                                   {at.x(), at.y() + 1.5 * r},
                                   {at.x() - 1.5 * r, at.y()}}));
        path.closeSubpath();
        break;
    case MethodKind::Approximation:
        path.addPolygon(
            QPolygonF({{at.x(), at.y() - 1.3 * r}, {at.x() + 1.3 * r, at.y() + r}, {at.x() - 1.3 * r, at.y() + r}}));
        path.closeSubpath();
        break;
    }
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
                     StudyFigureText::tr("largest error / peak"));
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

} // namespace

MethodKind kindOf(const MethodResult &row)
{
    switch (row.method.kind) {
    case MethodName::Kind::NewtonDense:
    case MethodName::Kind::NewtonDenseTaylor: return MethodKind::NewtonDense;
    case MethodName::Kind::NewtonStructured:
    case MethodName::Kind::NewtonStructuredTaylor: return MethodKind::NewtonStructured;
    case MethodName::Kind::ClosedForm:
    case MethodName::Kind::ClosedFormBatch: return MethodKind::ClosedForm;
    case MethodName::Kind::FiniteDifference:
    case MethodName::Kind::Harmonics: return MethodKind::Approximation;
    }
    return {};
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

QString descriptionOf(const MethodResult &row)
{
    QString text = titleOf(row);
    if (row.tolerance) {
        text += StudyFigureText::tr(", tolerance %1").arg(numberText(*row.tolerance, 3));
    }
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
        text += u'\n' + StudyFigureText::tr("rounded input alone makes κ·u = %1").arg(shortNumber(*row.errorBound, 3));
    }
    return text;
}

std::vector<StudyPoint> studyPoints(const CaseResult &which, const QSize &size)
{
    const Axes axes = axesOf(which, size);
    std::vector<StudyPoint> points;
    for (std::size_t row = 0; row < which.methods.size(); ++row) {
        const MethodResult &method = which.methods[row];
        if (method.maxError && method.nsPerState > 0.0) {
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
    painter.setPen(QPen(colours.cursor, 1.0));
    painter.drawPolyline(frontLine);

    Labels labels(painter, axes.area, colours.background, points);
    labels.avoid(frontLine);
    if (const std::optional<double> bound = boundOf(which)) {
        const double y = axes.heightOf(*bound);
        painter.setPen(QPen(colours.warning, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(axes.area.left(), y), QPointF(axes.area.right(), y));
        const QString text = StudyFigureText::tr("κ·u");
        const QFontMetricsF metrics(painter.font());
        const QRectF place(axes.area.left() + 3.0, y - metrics.height(), metrics.horizontalAdvance(text),
                           metrics.height());
        painter.setPen(colours.warning);
        painter.drawText(place, Qt::AlignCenter, text);
        labels.take(place);
        labels.avoid(QPolygonF({{axes.area.left(), y}, {axes.area.right(), y}}));
    }

    for (const StudyPoint &point : points) {
        const MethodResult &row = which.methods[point.row];
        const QColor colour = colourOf(kindOf(row), colours);
        painter.setPen(QPen(colour, 1.2));
        painter.setBrush(isSolvedThroughout(row) ? QBrush(colour) : QBrush(colours.background));
        painter.drawPath(shapeOf(kindOf(row), point.at, kRadius));
        if (point.row == marked) {
            painter.setPen(QPen(colours.cursor, 1.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(point.at, 2.4 * kRadius, 2.4 * kRadius);
        }
    }
    // A name once, at the method's most exact point; those of the best front first.
    std::vector<StudyPoint> named;
    for (const StudyPoint &point : points) {
        const MethodResult &row = which.methods[point.row];
        const auto same = std::find_if(named.begin(), named.end(), [&](const StudyPoint &other) {
            return which.methods[other.row].method == row.method;
        });
        if (same == named.end()) {
            named.push_back(point);
        } else if (shownError(row) < shownError(which.methods[same->row])) {
            *same = point;
        }
    }
    const std::vector<std::size_t> front = bestFront(which);
    std::stable_partition(named.begin(), named.end(), [&](const StudyPoint &point) {
        return std::find(front.begin(), front.end(), point.row) != front.end();
    });
    for (const StudyPoint &point : named) {
        const MethodResult &row = which.methods[point.row];
        painter.setPen(colourOf(kindOf(row), colours));
        labels.put(point.at, titleOf(row));
    }
    painter.restore();
}

} // namespace slidercrank
