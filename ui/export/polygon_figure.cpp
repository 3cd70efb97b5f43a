// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/polygon_figure.h"

#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/subscripts.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct PolygonText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PolygonText)
};

QString vectorSymbol(PolygonVector vector)
{
    switch (vector) {
    case PolygonVector::PinVelocity: return QStringLiteral("v_A");
    case PolygonVector::CouplerVelocity: return QStringLiteral("v_BA");
    case PolygonVector::SliderVelocity: return QStringLiteral("v_B");
    case PolygonVector::PinNormal: return QStringLiteral("a_Aⁿ");
    case PolygonVector::PinTangential: return QStringLiteral("a_Aᵗ");
    case PolygonVector::CouplerNormal: return QStringLiteral("a_BAⁿ");
    case PolygonVector::CouplerTangential: return QStringLiteral("a_BAᵗ");
    case PolygonVector::SliderAcceleration: break;
    }
    return QStringLiteral("a_B");
}

bool isSum(PolygonVector vector)
{
    return vector == PolygonVector::SliderVelocity || vector == PolygonVector::SliderAcceleration;
}

QRectF boundsOf(const std::vector<PlacedVector> &polygon)
{
    double left = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    double top = 0.0;
    for (const PlacedVector &placed : polygon) {
        left = std::min(left, placed.to.x);
        right = std::max(right, placed.to.x);
        bottom = std::min(bottom, placed.to.y);
        top = std::max(top, placed.to.y);
    }
    return {left, bottom, right - left, top - bottom};
}

void drawArrow(QPainter &painter, QPointF from, QPointF to)
{
    const QLineF line(from, to);
    painter.drawLine(line);
    constexpr double kMaxHead = 9.0;          // px
    constexpr double kMinHead = 1.0;          // px
    constexpr double kHeadFraction = 0.5;     // of a short arrow
    constexpr double kHalfAngleOfHead = 18.0; // °
    const double head = std::min(kMaxHead, kHeadFraction * line.length());
    if (head < kMinHead) {
        return;
    }
    const double backwards = line.angle() + 180.0; // °
    QLineF left = QLineF::fromPolar(head, backwards - kHalfAngleOfHead).translated(to);
    QLineF right = QLineF::fromPolar(head, backwards + kHalfAngleOfHead).translated(to);
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(QPolygonF{to, left.p2(), right.p2()});
}

} // namespace

QStringList magnitudes(const std::vector<PlacedVector> &polygon, Measure measure)
{
    constexpr double kRounding = 1e-12; // fraction of the largest magnitude: a smaller magnitude is 0
    std::vector<double> lengths;
    for (const PlacedVector &placed : polygon) {
        lengths.push_back(std::hypot(placed.to.x - placed.from.x, placed.to.y - placed.from.y));
    }
    const double largest = lengths.empty() ? 0.0 : std::ranges::max(lengths);
    QStringList texts;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double length = lengths[i] > kRounding * largest ? lengths[i] : 0.0;
        const QString amount = shortNumber(shownValue(measure, length, notation().units));
        const bool isLast = i + 1 == polygon.size();
        texts << QStringLiteral("%1 = %2").arg(vectorSymbol(polygon[i].vector),
                                               isLast ? withUnit(amount, shownUnit(measure)) : amount);
    }
    return texts;
}

namespace
{

/// The smallest height of a polygon with the magnitudes of its vectors below it, in lines of text.
constexpr double kMinHeightWithMagnitudes = 14.0;

/// Height of the heading above both polygons, which states the crank position, in lines of text.
constexpr double kHeadingHeight = 1.5;

/// Draws one polygon, its scale below it and, if there is space, the magnitudes of its vectors.
class PolygonDrawing
{
public:
    PolygonDrawing(QPainter &painter, const QRectF &area, const std::vector<PlacedVector> &polygon, Measure measure,
                   const QPalette &palette)
        : m_painter(painter)
        , m_area(area)
        , m_polygon(polygon)
        , m_measure(measure)
        , m_palette(palette)
    {
    }

    void draw()
    {
        const QFontMetricsF metrics(m_painter.font());
        constexpr double kNameWidth = 2.5;    // lines of text
        constexpr double kNameAndScale = 3.2; // lines of text: the height of a vector's name and of the scale
        const double margin = kNameWidth * metrics.height();
        placeMagnitudes();
        const QRectF inside = m_area.adjusted(margin, metrics.height(), -margin, -kNameAndScale * metrics.height());
        const QRectF bounds = boundsOf(m_polygon);
        m_scale = std::min(inside.width() / std::max(bounds.width(), 1e-300),
                           inside.height() / std::max(bounds.height(), 1e-300));
        if (!(std::max(bounds.width(), bounds.height()) > 0.0)) {
            m_painter.drawText(m_area, Qt::AlignCenter, PolygonText::tr("all vectors are 0"));
            return;
        }
        m_pole = inside.center() - QPointF(m_scale * bounds.center().x(), -m_scale * bounds.center().y());
        for (const PlacedVector &placed : m_polygon) {
            drawVector(placed);
        }
        drawPole();
        drawScale();
        drawMagnitudes();
    }

private:
    /// Reserves a part of the area for the magnitudes: below the polygon, or beside it if the area is low but wide. If
    /// it is low and narrow, they are left out.
    void placeMagnitudes()
    {
        const double lineHeight = QFontMetricsF(m_painter.font()).height();
        const QStringList separate = magnitudes(m_polygon, m_measure);
        const auto height = [lineHeight](const QStringList &lines) {
            return static_cast<double>(lines.size()) * lineHeight;
        };
        if (m_area.height() >= kMinHeightWithMagnitudes * lineHeight) {
            m_magnitudes = joinedLines(separate);
            m_area.setBottom(m_area.bottom() - height(m_magnitudes));
            m_magnitudesTopLeft = m_area.bottomLeft();
            return;
        }
        constexpr double kMinPolygonWidth = 10.0; // lines of text
        double width = 0.0;
        for (const QString &line : separate) {
            width = std::max(width, withSubscripts(line, m_painter.font()).size().width());
        }
        if (height(separate) <= m_area.height() && m_area.width() - width >= kMinPolygonWidth * lineHeight) {
            m_magnitudes = separate;
            m_magnitudesTopLeft = {m_area.left(), m_area.center().y() - 0.5 * height(separate)};
            m_area.setLeft(m_area.left() + width);
        }
    }

    /// Returns the texts, separated by commas, in lines that leave a margin at both sides of the area.
    QStringList joinedLines(const QStringList &texts) const
    {
        constexpr double kMargins = 1.0; // lines of text, both together
        const double available = m_area.width() - kMargins * QFontMetricsF(m_painter.font()).height();
        QStringList lines(QString{});
        for (const QString &text : texts) {
            const QString longer = lines.last().isEmpty() ? text : lines.last() + ", " + text;
            if (lines.last().isEmpty() || withSubscripts(longer + ',', m_painter.font()).size().width() <= available) {
                lines.last() = longer;
            } else {
                lines.last() += ',';
                lines << text;
            }
        }
        return lines;
    }

    /// Draws the magnitudes: lines below the polygon are centred, lines beside it begin one below the other.
    void drawMagnitudes()
    {
        const bool isBelow = m_magnitudesTopLeft.x() == m_area.left();
        QPointF topLeft = m_magnitudesTopLeft;
        for (const QString &line : m_magnitudes) {
            const QStaticText text = withSubscripts(line, m_painter.font());
            const double indent = isBelow ? 0.5 * (m_area.width() - text.size().width()) : 0.0;
            m_painter.drawStaticText(topLeft + QPointF(indent, 0.0), text);
            topLeft.ry() += QFontMetricsF(m_painter.font()).height();
        }
    }

    QPointF toPixels(const PlaneVector &point) const { return m_pole + m_scale * QPointF(point.x, -point.y); }

    void drawVector(const PlacedVector &placed)
    {
        const SeriesColours colours = seriesColours(m_palette);
        constexpr double kSumWidth = 2.5;  // px
        constexpr double kPartWidth = 1.6; // px
        const QColor &partColour = m_measure == Measure::Speed ? colours.velocity : colours.acceleration;
        const QColor &colour = isSum(placed.vector) ? colours.model : partColour;
        const QLineF line(toPixels(placed.from), toPixels(placed.to));
        m_painter.setPen(QPen(colour, isSum(placed.vector) ? kSumWidth : kPartWidth, Qt::SolidLine, Qt::FlatCap));
        drawArrow(m_painter, line.p1(), line.p2());
        constexpr double kMinNamedLength = 3.0; // px: a shorter vector has no name
        if (line.length() < kMinNamedLength) {
            return;
        }
        const QStaticText text = withSubscripts(vectorSymbol(placed.vector), m_painter.font());
        const QRectF box = namePlace(line, text.size(), isSum(placed.vector) ? Side::Right : Side::Left);
        m_names.push_back(box);
        m_painter.setPen(m_palette.color(QPalette::Text));
        m_painter.drawStaticText(box.topLeft(), text);
    }

    enum class Side { Left, Right };

    /// Returns a box for the name of a vector. If possible, the box covers neither a vector nor another name, is
    /// clearly nearer to its own vector than to every other one, and is on the side `side` of its middle.
    QRectF namePlace(const QLineF &line, const QSizeF &size, Side side) const
    {
        const QLineF normal = line.normalVector().unitVector();
        const QPointF left(normal.dx(), normal.dy());
        const QPointF preferred = side == Side::Left ? left : -left;
        const double apart = 0.5 * (std::abs(left.x()) * size.width() + std::abs(left.y()) * size.height()) + 2.0;
        std::vector<QRectF> places;
        for (const double distance : {apart, 1.5 * apart, 2.0 * apart, 3.0 * apart}) {
            for (const double part : {0.5, 0.3, 0.7, 0.0, 1.0}) {
                for (const QPointF &direction : {preferred, -preferred}) {
                    QRectF &box = places.emplace_back(QPointF(), size);
                    box.moveCenter(line.pointAt(part) + distance * direction);
                }
            }
        }
        constexpr double kGapInHeights = 0.4; // between two names, which would otherwise be read as one
        const double gap = kGapInHeights * size.height();
        const auto isFree = [this, gap](const QRectF &box) {
            const QRectF withGap = box.adjusted(-gap, 0.0, gap, 0.0);
            const auto covers = [&withGap](const QRectF &name) { return name.intersects(withGap); };
            const auto crosses = [this, &box](const PlacedVector &placed) {
                return isCrossed(box, {toPixels(placed.from), toPixels(placed.to)});
            };
            return std::ranges::none_of(m_names, covers) && std::ranges::none_of(m_polygon, crosses);
        };
        const auto isClear = [&](const QRectF &box) { return isFree(box) && isNearest(box.center(), line); };
        for (const auto &found : {std::ranges::find_if(places, isClear), std::ranges::find_if(places, isFree)}) {
            if (found != places.end()) {
                return *found;
            }
        }
        return places.front();
    }

    /// Returns whether the point is clearly nearer to the vector than to every other vector of the polygon.
    bool isNearest(const QPointF &point, const QLineF &vector) const
    {
        constexpr double kMinDistanceRatio = 1.5;
        const double own = distance(point, vector);
        return std::ranges::all_of(m_polygon, [&](const PlacedVector &placed) {
            const QLineF other(toPixels(placed.from), toPixels(placed.to));
            return other == vector || distance(point, other) >= kMinDistanceRatio * own;
        });
    }

    static double distance(const QPointF &point, const QLineF &line)
    {
        const QPointF along = line.p2() - line.p1();
        const double square = std::max(QPointF::dotProduct(along, along), 1e-300);
        const double part = std::clamp(QPointF::dotProduct(point - line.p1(), along) / square, 0.0, 1.0);
        return QLineF(point, line.pointAt(part)).length();
    }

    static bool isCrossed(const QRectF &box, const QLineF &line)
    {
        const QLineF diagonals[] = {{box.topLeft(), box.bottomRight()}, {box.bottomLeft(), box.topRight()}};
        return box.contains(line.p1()) || box.contains(line.p2()) ||
               std::ranges::any_of(diagonals, [&line](const QLineF &diagonal) {
                   return line.intersects(diagonal) == QLineF::BoundedIntersection;
               });
    }

    void drawPole()
    {
        m_painter.setPen(QPen(m_palette.color(QPalette::Text), kScaleWidth));
        m_painter.setBrush(m_palette.base());
        m_painter.drawEllipse(m_pole, 3.0, 3.0);
    }

    void drawScale()
    {
        constexpr double kMinBarLength = 80.0; // px
        // Fraction of the width. The bar represents the next round number, which is at most 2.5 times larger.
        constexpr double kMaxFraction = 0.36;
        const double minLength = std::min(kMinBarLength, kMaxFraction * m_area.width());
        const double unit = shownValue(m_measure, 1.0, notation().units);
        const double amount = nextRoundNumber(minLength / m_scale * unit); // in the unit that is shown
        const double length = amount / unit * m_scale;
        const QFontMetricsF metrics(m_painter.font());
        const double y = m_area.bottom() - 1.2 * metrics.height();
        const double left = m_area.center().x() - 0.5 * length;
        m_painter.setPen(QPen(m_palette.color(QPalette::Text), kScaleWidth));
        m_painter.drawLine(QPointF(left, y), QPointF(left + length, y));
        for (const double x : {left, left + length}) {
            m_painter.drawLine(QPointF(x, y - 3.0), QPointF(x, y + 3.0));
        }
        m_painter.drawText(QRectF(m_area.left(), y + 2.0, m_area.width(), metrics.height()), Qt::AlignCenter,
                           withUnit(numberText(amount), shownUnit(m_measure)));
    }

    static constexpr double kScaleWidth = 1.2; // px: of the lines of the scale and of the pole

    QPainter &m_painter;
    QRectF m_area; ///< of the polygon and its scale; the magnitudes are outside
    const std::vector<PlacedVector> &m_polygon;
    Measure m_measure;
    const QPalette &m_palette;
    double m_scale = 1.0; ///< px per mm/s or mm/s²
    QPointF m_pole;
    QStringList m_magnitudes; ///< lines
    QPointF m_magnitudesTopLeft;
    std::vector<QRectF> m_names; ///< px; the names that have been drawn
};

/// Returns the text of the crank angle (rad) and, unless it is 0, of the crank acceleration (rad/s²).
QString positionText(double theta2, double alpha2)
{
    const QString angle = withUnit(numberText(shownCrankAngle(theta2)), shownUnit(Measure::Angle));
    const QString position = QStringLiteral("θ₂ = %1").arg(angle);
    return alpha2 == 0.0 ? position : QStringLiteral("%1, α₂ = %2 rad/s²").arg(position, numberText(alpha2));
}

} // namespace

bool hasVectors(const Polygons &polygons)
{
    const auto isNonZero = [](const PlacedVector &placed) {
        return placed.from.x != placed.to.x || placed.from.y != placed.to.y;
    };
    return std::ranges::any_of(polygons.velocity, isNonZero) || std::ranges::any_of(polygons.acceleration, isNonZero);
}

void drawPolygons(QPainter &painter, const QRectF &area, const Polygons &polygons, const QPalette &palette)
{
    if (polygons.velocity.empty()) {
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         PolygonText::tr("There are no velocities in this position."));
        return;
    }
    const QRectF left(area.topLeft(), QSizeF(0.5 * area.width(), area.height()));
    PolygonDrawing(painter, left, polygons.velocity, Measure::Speed, palette).draw();
    PolygonDrawing(painter, left.translated(left.width(), 0.0), polygons.acceleration, Measure::Acceleration, palette)
        .draw();
}

FigureDrawing polygonFigure(const Mechanism &mechanism, double t, double alpha2, const QPalette &palette)
{
    const double theta2 = mechanism.theta20() + mechanism.omega2() * t;
    return [palette, polygons = polygonsAt(mechanism, t, alpha2),
            position = positionText(theta2, alpha2)](QPainter &painter, const QSize &size) {
        const QRectF area({0.0, 0.0}, QSizeF(size));
        const double heading = kHeadingHeight * QFontMetricsF(painter.font()).height();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.fillRect(area, palette.base());
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(0.0, 0.0, area.width(), heading), Qt::AlignCenter, position);
        drawPolygons(painter, area.adjusted(0.0, heading, 0.0, 0.0), polygons, palette);
    };
}

int minimumPolygonHeight(const QFont &font)
{
    return static_cast<int>(std::ceil(kMinHeightWithMagnitudes * QFontMetricsF(font).height()));
}

int polygonHeight(int width, const QFont &font)
{
    constexpr double kUsualLines = 2.0; // lines of magnitudes below each polygon
    const double line = QFontMetricsF(font).height();
    return static_cast<int>(
        std::ceil(std::max(0.5 * width + kUsualLines * line, (kHeadingHeight + kMinHeightWithMagnitudes) * line)));
}

} // namespace slidercrank
