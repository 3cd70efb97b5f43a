// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_labels.h"

#include "core/mechanism/turn.h"
#include "ui/mechanism/mechanism_scenery.h"
#include "ui/mechanism/mechanism_words.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLineF>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismLabels {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismLabels)
};

constexpr double kTextGap = 4.0; ///< px between a link or a line and its text

/// Upright, from the height of O₂ to that of the slider's line.
QLineF offsetLine(const MechanismCanvas &on, const Mechanism &mechanism)
{
    constexpr double kBesideCircle = 14.0;
    const bool isOpen = mechanism.branch() == Branch::Open;
    const double x =
        on.toPixels({isOpen ? -mechanism.a() : mechanism.a(), 0.0}).x() + (isOpen ? -1 : 1) * kBesideCircle;
    return {x, on.toPixels({0.0, 0.0}).y(), x, on.toPixels({0.0, mechanism.c()}).y()};
}

/// Either side of the link, the one that `away` points to first; nearer to its end, where there is no O₂ and no G₃.
std::vector<QPointF> placesBeside(const QLineF &link, QPointF away, double width, const QSizeF &label)
{
    const QPointF along = unitVector(link.p2() - link.p1());
    QPointF across(-along.y(), along.x());
    if (QPointF::dotProduct(across, away) < 0.0) {
        across = -across;
    }
    const double half = 0.5 * (std::abs(across.x()) * label.width() + std::abs(across.y()) * label.height());
    std::vector<QPointF> places;
    for (const double farther : {0.0, label.height()}) {
        for (const double part : {0.6, 0.75, 0.4, 0.25}) {
            for (const double side : {1.0, -1.0}) {
                places.push_back(link.pointAt(part) + side * (0.5 * width + kTextGap + half + farther) * across);
            }
        }
    }
    return places;
}

/// In tenths of a degree; never "-0.0".
QString degreesText(double radians)
{
    const double tenths = std::round(10.0 * kDegreesPerRadian * radians);
    return QStringLiteral("%1°").arg(QLocale().toString(tenths == 0.0 ? 0.0 : 0.1 * tenths, 'f', 1));
}

/// Paints labels, each where the room has a place for it.
class Labels
{
public:
    Labels(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, LabelRoom &room)
        : m_painter(painter)
        , m_on(on)
        , m_drawing(drawing)
        , m_room(room)
        , m_pivot(on.toPixels({0.0, 0.0}))
    {
        if (drawing.pins) {
            m_crank = QLineF(m_pivot, on.toPixels(drawing.pins->A));
            m_coupler = QLineF(m_crank.p2(), on.toPixels(drawing.pins->B));
        }
    }

    /// O₂, A, B, G₃.
    void paintNames()
    {
        constexpr double kBesideJoint = kJointRadius + 4.0;
        if (m_drawing.pins) {
            // A away from both links, or square to them where they are in one line.
            const QPointF toPivot = unitVector(m_crank.p1() - m_crank.p2());
            const QPointF toSlider = unitVector(m_coupler.p2() - m_coupler.p1());
            const QPointF apart = -toPivot - toSlider;
            const QPointF across(-toSlider.y(), toSlider.x());
            const bool isBent = std::hypot(apart.x(), apart.y()) > 0.3;
            paintAround(MechanismLabels::tr("A"), m_crank.p2(), isBent ? apart : across, kBesideJoint);
            paintAround(MechanismLabels::tr("B"), m_coupler.p2(), {0.0, -1.0}, kDeadCentreMark + 1.0);
        }
        paintAround(MechanismLabels::tr("O₂"), m_pivot, {-1.0, 0.4}, kBesideJoint + 8.0);
        if (m_drawing.hasCentre()) {
            const QPointF along = unitVector(m_coupler.p2() - m_coupler.p1());
            const QPointF normal(along.y(), -along.x());
            paintAround(MechanismLabels::tr("G₃"), m_coupler.center(), normal.y() < 0.0 ? normal : -normal,
                        kBesideJoint);
        }
    }

    /// a and b.
    void paintLengths()
    {
        const auto paintBeside = [this](const QString &letter, const QLineF &link, QPointF away, double width) {
            const QSizeF size = sizeOf(letter);
            paintIn(m_room.place(size, placesBeside(link, away, width, size)), letter);
        };
        paintBeside(QStringLiteral("a"), m_crank, m_pivot - m_coupler.p2(), kCrankWidth);
        paintBeside(QStringLiteral("b"), m_coupler, {0.0, 1.0}, kCouplerWidth);
    }

    /// θ₂ and θ³, from a line in the direction of x.
    void paintAngles(const QColor &ink)
    {
        const auto paintAngle = [&](const QString &name, const QLineF &link, double angle, double widest) {
            constexpr double kSmallest = 14.0;
            constexpr double kBeyond = 8.0;
            constexpr double kArcHead = 7.0;
            constexpr double kBesideVertex = 20.0;
            const double radius = std::clamp(0.5 * link.length(), kSmallest, widest);
            const QPointF vertex = link.p1();
            const auto towards = [](double direction) { return QPointF(std::cos(direction), -std::sin(direction)); };
            const QLineF base(vertex, vertex + QPointF(radius + kBeyond, 0.0));
            const QRectF circle(vertex - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
            m_painter.setBrush(Qt::NoBrush);
            m_painter.setPen(QPen(mixed(ink, m_on.colours.background, 0.7), 1.0));
            m_painter.drawLine(base);
            constexpr double kSixteenths = 16.0; // as QPainter counts degrees
            m_painter.drawArc(circle, 0, static_cast<int>(std::lround(kSixteenths * kDegreesPerRadian * angle)));
            const double head = std::min(kArcHead, 0.6 * std::abs(angle) * radius);
            const double side = angle < 0.0 ? -1.0 : 1.0;
            // Towards the tip along the chord of its own length: a tangent would leave the arc.
            paintArrowHead(m_painter, vertex + radius * towards(angle),
                           side * towards(angle - side * 0.5 * head / radius + kQuarterTurn), head,
                           mixed(ink, m_on.colours.background, 0.7));
            m_room.ratherKeepOff(base);
            m_painter.setPen(ink);
            // On the other side of the base than the arc, where the label can stay while the angle changes.
            const QPointF beside(link.dx() < 0.0 && &link == &m_coupler ? -1.0 : 1.0, angle < 0.0 ? -0.5 : 0.5);
            paintAround(QStringLiteral("%1 = %2").arg(name, degreesText(angle)), vertex, beside, kBesideVertex);
        };
        constexpr double kWidestOfCrank = 30.0;
        constexpr double kWidestOfCoupler = 36.0;
        paintAngle(QStringLiteral("θ₂"), m_crank, wrapToTwoPi(m_drawing.pose.theta2), kWidestOfCrank);
        paintAngle(QStringLiteral("θ³"), m_coupler, wrapToPi(m_drawing.pose.theta3), kWidestOfCoupler);
    }

    /// At its mark, over the height at which B's name passes by, or below the rail.
    void paintDeadCentre(const std::optional<DeadCentre> &centre, const QString &name, double outwards)
    {
        if (!centre) {
            return;
        }
        const QPointF mark = m_on.toPixels({centre->R4x, m_drawing.mechanism().c()}) + QPointF(0.0, -kDeadCentreMark);
        const QSizeF size = sizeOf(name);
        const double least = 0.5 * size.width() + kTextGap;
        const double most = std::max(least, m_on.size.width() - least);
        const double passing = QFontMetricsF(m_on.font).height() + 2.0;
        const double below = kDeadCentreMark + kRailBelowLine + kHatchLength + kTextGap + 0.5 * size.height();
        std::vector<QPointF> places;
        for (const double y : {-passing - 0.5 * size.height(), -passing - 1.6 * size.height(), below,
                               below + 1.1 * size.height(), below + 2.2 * size.height(), below + 3.3 * size.height()}) {
            for (const double side : {0.0, 0.5, -0.5}) {
                places.emplace_back(std::clamp(mark.x() + side * outwards * size.width(), least, most), mark.y() + y);
            }
        }
        const QRectF place = m_room.place(size, places);
        if (place.bottom() < mark.y() && place.left() <= mark.x() && mark.x() <= place.right()) {
            m_painter.drawLine(mark, QPointF(mark.x(), place.bottom()));
        }
        paintIn(place, name);
    }

private:
    QSizeF sizeOf(const QString &text) const
    {
        const QFontMetricsF metrics(m_painter.font());
        return {metrics.horizontalAdvance(text) + 2.0, metrics.ascent() + 1.0};
    }

    void paintIn(const QRectF &place, const QString &text)
    {
        constexpr double kSpare = 4.0;          // around the letters themselves
        QColor paper = m_on.colours.background; // for what lies beneath: the grid, the rail
        paper.setAlphaF(0.7F);
        m_painter.fillRect(place, paper);
        m_painter.drawText(place.adjusted(-kSpare, -kSpare, kSpare, kSpare), Qt::AlignCenter, text);
    }

    void paintAround(const QString &text, QPointF point, QPointF direction, double reach)
    {
        const QSizeF size = sizeOf(text);
        paintIn(m_room.place(size, placesAround(point, direction, reach, size)), text);
    }

    QPainter &m_painter;
    const MechanismCanvas &m_on;
    const MechanismDrawing &m_drawing;
    LabelRoom &m_room;
    QPointF m_pivot;
    QLineF m_crank;
    QLineF m_coupler;
};

} // namespace

QRectF ghostWordPlace(const MechanismCanvas &on, const ReferencePose &ghost)
{
    constexpr double kLetters = 2.5; // half of "conservado", in heights of a line
    const double height = QFontMetricsF(on.smallFont).height();
    const double halfWidth = kLetters * height;
    const bool isCouplerBelow = ghost.pinY < ghost.sliderY;
    const QPointF slider = on.toPixels({ghost.sliderX, ghost.sliderY});
    return {slider.x() - halfWidth,
            slider.y() + (isCouplerBelow ? -kDeadCentreMark - height : kRailBelowLine + kHatchLength), 2.0 * halfWidth,
            height};
}

LabelRoom labelRoomOf(const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    LabelRoom room(on.size);
    constexpr double kCornerWidth = 240.0; // of a line there, about
    const int cornerLines = cornerLineCount(on, drawing);
    for (int line = 0; line < cornerLines; ++line) {
        room.keepOff(cornerLine(on, line, kCornerWidth));
    }
    const QPointF pivot = on.toPixels({0.0, 0.0});
    room.keepOff(QRectF(pivot.x() - kGroundHalfWidth, pivot.y(), 2.0 * kGroundHalfWidth, kGroundDepth));
    if (drawing.settings.dimensions) {
        constexpr double kAroundLetter = 8.0;
        const QLineF offset = offsetLine(on, drawing.mechanism());
        room.ratherKeepOff(offset);
        room.keepOff(QRectF(offset.center() - QPointF(kAroundLetter, kAroundLetter),
                            2.0 * QSizeF(kAroundLetter, kAroundLetter)));
    }
    if (drawing.pins) {
        const QPointF crank = on.toPixels(drawing.pins->A);
        const QPointF slider = on.toPixels(drawing.pins->B);
        room.keepOff({pivot, crank}, kCrankWidth);
        room.keepOff({crank, slider}, kCouplerWidth);
        room.keepOff(QRectF(slider.x() - kBlockHalfWidth, slider.y() - kBlockHalfHeight, 2.0 * kBlockHalfWidth,
                            2.0 * kBlockHalfHeight));
    }
    if (drawing.ghost.exists) {
        const QPointF crank = on.toPixels({drawing.ghost.pinX, drawing.ghost.pinY});
        const QPointF slider = on.toPixels({drawing.ghost.sliderX, drawing.ghost.sliderY});
        room.ratherKeepOff({pivot, crank});
        room.ratherKeepOff({crank, slider});
        room.keepOff(ghostWordPlace(on, drawing.ghost));
    }
    return room;
}

void paintLabels(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, const QColor &ink,
                 LabelRoom &room)
{
    const MechanismSettings &settings = drawing.settings;
    Labels labels(painter, on, drawing, room);
    painter.setFont(on.font);
    painter.setPen(ink);
    if (settings.names) {
        labels.paintNames();
    }
    if (drawing.pins && drawing.pose.exists()) {
        if (settings.dimensions) {
            labels.paintLengths();
        }
        if (settings.angles) {
            labels.paintAngles(ink);
        }
    }
    if (settings.names) {
        const MotionLimits &limits = drawing.result->limits;
        const bool isOuterRight = limits.outer && limits.inner && limits.outer->R4x > limits.inner->R4x;
        painter.setFont(on.smallFont);
        painter.setPen(on.muted);
        labels.paintDeadCentre(limits.outer, MechanismLabels::tr("outer dead centre"), isOuterRight ? 1.0 : -1.0);
        labels.paintDeadCentre(limits.inner, MechanismLabels::tr("inner dead centre"), isOuterRight ? -1.0 : 1.0);
    }
}

void paintOffset(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism)
{
    constexpr double kLongest = 8.0;
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QLineF offset = offsetLine(on, mechanism);
    const double x = offset.x1();
    const double outwards = x < pivot.x() ? -1.0 : 1.0;
    painter.setPen(QPen(on.muted, 1.0));
    painter.drawLine(QPointF(x + outwards * kTextGap, pivot.y()),
                     QPointF(pivot.x() + outwards * kJointRadius, pivot.y()));
    if (offset.length() > 1.0) {
        painter.drawLine(offset);
        const double head = std::min(kLongest, 0.4 * offset.length());
        const QPointF up(0.0, offset.dy() < 0.0 ? -1.0 : 1.0);
        paintArrowHead(painter, offset.p2(), up, head, on.muted);
        paintArrowHead(painter, offset.p1(), -up, head, on.muted);
    }
    paintNote(painter, on, offset.center(), QStringLiteral("c"));
}

QStringList valueLines(const MechanismCanvas &on, const Mechanism &mechanism)
{
    const QStringList lines{lengthText(QStringLiteral("a"), mechanism.a()),
                            lengthText(QStringLiteral("b"), mechanism.b()),
                            lengthText(QStringLiteral("c"), mechanism.c())};
    const QString together = lines.join(QStringLiteral("   "));
    const double width = QFontMetricsF(on.smallFont).horizontalAdvance(together) + 2.0 * kTextGap;
    return cornerLine(on, 0, width).right() <= on.size.width() ? QStringList{together} : lines;
}

void paintValues(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism)
{
    const QStringList lines = valueLines(on, mechanism);
    painter.setFont(on.smallFont);
    painter.setPen(on.colours.text);
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
        const double width = QFontMetricsF(on.smallFont).horizontalAdvance(lines[i]);
        const QRectF box = cornerLine(on, i, width + 2.0 * kTextGap);
        painter.fillRect(box, on.colours.background);
        painter.drawText(box.adjusted(kTextGap, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, lines[i]);
    }
}

} // namespace slidercrank
