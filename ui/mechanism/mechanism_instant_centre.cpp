// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_instant_centre.h"

#include "core/limits/instant_centre.h"
#include "ui/mechanism/mechanism_scenery.h"
#include "ui/text/axis_scale.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismCentre {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismCentre)
};

constexpr double kBeyondAllBounds = 1e4; // times the mechanism's size

bool isBeyondAllBounds(const InstantCentre &centre, const Mechanism &mechanism)
{
    const double size = mechanism.a() + mechanism.b() + std::abs(mechanism.c());
    return !(centre.toA <= kBeyondAllBounds * size);
}

QStringList linesOf(const InstantCentre &centre, const Mechanism &mechanism)
{
    constexpr int kDigits = 4;
    const double speedOfA = mechanism.a() * std::abs(mechanism.omega2());
    if (!std::isfinite(centre.omega3)) {
        return {MechanismCentre::tr("no velocity: the coupler is perpendicular to the slider's line")};
    }
    if (isBeyondAllBounds(centre, mechanism)) {
        return {MechanismCentre::tr("P at infinity: the coupler does not turn,"),
                MechanismCentre::tr("A and B move alike, at %1 mm/s").arg(shortNumber(speedOfA, kDigits))};
    }
    const double speed = std::abs(centre.omega3);
    const auto product = [&](const QString &point, double distance) {
        return MechanismCentre::tr("speed of %1: %2 rad/s · %3 mm = %4 mm/s", "of a point: |ω₃| times its distance")
            .arg(point, shortNumber(speed, kDigits), shortNumber(distance, kDigits),
                 shortNumber(speed * distance, kDigits));
    };
    return {MechanismCentre::tr("P: the coupler turns about it at %1 rad/s").arg(shortNumber(centre.omega3, kDigits)),
            product(QStringLiteral("A"), centre.toA), product(QStringLiteral("B"), centre.toB)};
}

/// That a velocity is square to its ray.
void paintRightAngle(QPainter &painter, QPointF at, QPointF ray, QPointF velocity)
{
    constexpr double kSide = 9.0;
    const QPointF along = (kJointRadius + kSide) * ray;
    const QPointF across = (kJointRadius + kSide) * velocity;
    painter.drawPolyline(QPolygonF{at + along, at + along + across, at + across});
}

void paintCross(QPainter &painter, QPointF at, const QColor &ink)
{
    constexpr double kRadius = 5.0;
    painter.setPen(QPen(ink, 1.4));
    painter.drawEllipse(at, kRadius, kRadius);
    painter.drawLine(at - QPointF(kRadius + 3.0, 0.0), at + QPointF(kRadius + 3.0, 0.0));
    painter.drawLine(at - QPointF(0.0, kRadius + 3.0), at + QPointF(0.0, kRadius + 3.0));
}

/// Where the way from within the box leaves it.
QPointF edgeOf(const QRectF &box, QPointF from, QPointF direction)
{
    const auto toEdge = [](double start, double step, double lower, double upper) {
        return step > 0.0 ? (upper - start) / step : step < 0.0 ? (lower - start) / step : 1e9;
    };
    const double way = std::min(toEdge(from.x(), direction.x(), box.left(), box.right()),
                                toEdge(from.y(), direction.y(), box.top(), box.bottom()));
    return from + std::max(0.0, way) * direction;
}

/// From A and B to P, or to where it lies.
void paintRays(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, QPointF centre,
               LabelRoom &room)
{
    const LinkageMotion motion = drawing.motion();
    const double least = 1e-9 * drawing.mechanism().a() * std::abs(drawing.mechanism().omega2());
    painter.setBrush(Qt::NoBrush);
    for (const LinkagePoint point : {LinkagePoint::A, LinkagePoint::B}) {
        const QPointF pin = on.toPixels(point == LinkagePoint::A ? drawing.pins->A : drawing.pins->B);
        const PlaneVector &velocity = motion[static_cast<std::size_t>(point)].velocity;
        const double length = std::hypot(centre.x() - pin.x(), centre.y() - pin.y());
        if (length < 1.0) {
            continue;
        }
        const QPointF ray = (centre - pin) / length;
        const double seen = std::min(length, on.size.width() + on.size.height()); // painters do not like what is far
        const QLineF drawn(pin, pin + seen * ray);
        painter.setPen(QPen(on.muted, 1.0, Qt::DashLine));
        painter.drawLine(drawn);
        room.ratherKeepOff(drawn);
        painter.setPen(QPen(on.muted, 1.0));
        if (velocity.length() > least) {
            paintRightAngle(painter, pin, ray, unitVector({velocity.x, -velocity.y}));
        }
    }
}

} // namespace

void paintInstantCentre(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, LabelRoom &room)
{
    const Mechanism &mechanism = drawing.mechanism();
    const std::optional<InstantCentre> centre = instantCentre(mechanism, drawing.pose.time);
    if (!centre) {
        return;
    }
    const QPointF at = on.toPixels({centre->position.x, centre->position.y});
    const bool isWithinBounds = !isBeyondAllBounds(*centre, mechanism);
    if (isWithinBounds) {
        paintRays(painter, on, drawing, at, room);
    }
    int line = cornerLineCount(on, drawing);
    painter.setFont(on.smallFont);
    painter.setPen(on.colours.text);
    for (const QString &text : linesOf(*centre, mechanism)) {
        constexpr double kInset = 4.0;
        const double width = QFontMetricsF(on.smallFont).horizontalAdvance(text);
        const QRectF box = cornerLine(on, line++, width + 2.0 * kInset);
        painter.fillRect(box, on.colours.background);
        painter.drawText(box.adjusted(kInset, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
        room.keepOff(box);
    }
    if (!isWithinBounds) {
        return;
    }
    constexpr double kInset = 12.0;
    const QRectF inside = QRectF(QPointF(), on.size).adjusted(kInset, kInset, -kInset, -kInset);
    const QColor &ink = on.colours.errorOther; // that of velocities
    QPointF named = at;
    QPointF away(1.0, 0.0);
    if (inside.contains(at)) {
        paintCross(painter, at, ink);
    } else if (const QPointF pin = on.toPixels(drawing.pins->A); inside.contains(pin)) {
        const QPointF direction = unitVector(at - pin);
        constexpr double kSide = 12.0;
        named = edgeOf(inside, pin, direction);
        paintArrowHead(painter, named, direction, kSide, ink);
        away = QPointF(-direction.y(), direction.x());
    } else {
        return;
    }
    constexpr double kReach = 11.0;
    const QFontMetricsF metrics(on.font);
    const QString name = QStringLiteral("P");
    const QSizeF size(metrics.horizontalAdvance(name) + 2.0, metrics.ascent());
    painter.setFont(on.font);
    painter.setPen(on.colours.text);
    painter.drawText(room.place(size, placesAround(named, away, kReach, size)).adjusted(-4.0, -4.0, 4.0, 4.0),
                     Qt::AlignCenter, name);
}

} // namespace slidercrank
