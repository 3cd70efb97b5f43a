// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_arrows.h"

#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismArrows {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismArrows)
};

constexpr int kStepsOfCycle = 180;
constexpr double kShaftWidth = 2.0;
constexpr double kHead = 10.0; ///< px

const PlaneVector &vectorOf(const PointMotion &motion, MotionKind kind)
{
    return kind == MotionKind::Velocity ? motion.velocity : motion.acceleration;
}

/// The least of … 1, 2, 3, 4, 5, 6, 8, 10, 20 … that is not below the value (> 0).
double nextWritableNumber(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (digit * power >= value * (1.0 - 1e-12)) {
            return digit * power;
        }
    }
    return 10.0 * power;
}

/// How much a mm must stand for at least, so that from there `amount` mm/s stay within the bound.
double leastPerMillimetre(double from, double amount, double lowest, double highest)
{
    const double room = amount > 0.0 ? highest - from : from - lowest;
    return room > 0.0 ? std::abs(amount) / room : 0.0; // a point outside of the room has no say
}

QColor colourOf(MotionKind kind, const SeriesColours &colours)
{
    return kind == MotionKind::Velocity ? colours.errorOther : colours.error;
}

/// Velocities have a full head and accelerations a hollow one: not told apart by colour alone.
void paintShaftAndHead(QPainter &painter, QPointF tail, QPointF tip, MotionKind kind, bool isCut,
                       const SeriesColours &colours)
{
    const QPointF along = tip - tail;
    const double length = std::hypot(along.x(), along.y());
    if (length < 1.0) {
        return;
    }
    const QPointF direction = along / length;
    const double head = std::min(kHead, 0.6 * length);
    const QColor colour = colourOf(kind, colours);
    painter.setPen(QPen(colour, kShaftWidth, isCut ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(tail, tip - 0.9 * head * direction);
    paintArrowHead(painter, tip, direction, head, colour);
    if (kind == MotionKind::Acceleration && head > 6.0) {
        paintArrowHead(painter, tip - 0.3 * head * direction, direction, 0.5 * head, colours.background);
    }
}

} // namespace

Cycle cycleOf(const Mechanism &mechanism, const MotionLimits &limits)
{
    Cycle cycle;
    for (const CrankRange &range : limits.ranges) {
        std::vector<LinkageMotion> arc;
        for (const double theta2 : anglesAcross(range, kStepsOfCycle)) {
            const LinkageMotion motion = linkageMotion(withCrankAt(mechanism, theta2), 0.0);
            if (!std::isnan(motion.front().position.x)) {
                arc.push_back(motion);
            }
        }
        cycle.push_back(std::move(arc));
    }
    return cycle;
}

ArrowScale arrowScale(const Cycle &cycle, MotionKind kind, const Mechanism &mechanism, const QRectF &room,
                      double longest)
{
    constexpr double kUnusual = 2.5; // times the crank pin's own: a motion that runs away would dwarf all others
    const double omega2 = std::abs(mechanism.omega2());
    ArrowScale scale;
    scale.most = kUnusual * mechanism.a() * (kind == MotionKind::Velocity ? omega2 : omega2 * omega2);
    double perMillimetre = 0.0;
    for (const std::vector<LinkageMotion> &arc : cycle) {
        for (const LinkageMotion &instant : arc) {
            for (const PointMotion &motion : instant) {
                PlaneVector vector = vectorOf(motion, kind);
                const double amount = vector.length();
                if (!(amount > 0.0)) {
                    continue;
                }
                if (amount > scale.most) {
                    vector = vector * (scale.most / amount);
                }
                perMillimetre = std::max({perMillimetre, vector.length() / longest,
                                          leastPerMillimetre(motion.position.x, vector.x, room.left(), room.right()),
                                          leastPerMillimetre(motion.position.y, vector.y, room.top(), room.bottom())});
            }
        }
    }
    if (perMillimetre > 0.0 && std::isfinite(perMillimetre)) {
        scale.length = nextRoundNumber(0.2 * longest);
        scale.amount = nextWritableNumber(perMillimetre * scale.length);
    }
    return scale;
}

QString scaleText(const ArrowScale &scale, MotionKind kind)
{
    if (scale.amount == 0.0) {
        return kind == MotionKind::Velocity ? MechanismArrows::tr("no velocity")
                                            : MechanismArrows::tr("no acceleration");
    }
    return (kind == MotionKind::Velocity ? MechanismArrows::tr("velocity: %1 mm ≙ %2 mm/s")
                                         : MechanismArrows::tr("acceleration: %1 mm ≙ %2 mm/s²"))
        .arg(numberText(scale.length), numberText(scale.amount));
}

std::optional<MotionArrow> arrowOf(const PointMotion &motion, MotionKind kind, const ArrowScale &scale)
{
    const PlaneVector &vector = vectorOf(motion, kind);
    const double amount = vector.length();
    if (scale.amount == 0.0 || !(amount > 0.0) || !std::isfinite(amount)) {
        return std::nullopt;
    }
    MotionArrow arrow;
    arrow.isCut = amount > scale.most * (1.0 + 1e-9);
    const PlaneVector drawn = vector * (scale.length / scale.amount * (arrow.isCut ? scale.most / amount : 1.0));
    arrow.tail = {motion.position.x, motion.position.y};
    arrow.tip = arrow.tail + QPointF(drawn.x, drawn.y);
    return arrow;
}

void paintArrow(QPainter &painter, const MechanismCanvas &on, const MotionArrow &arrow, MotionKind kind)
{
    paintShaftAndHead(painter, on.toPixels(arrow.tail), on.toPixels(arrow.tip), kind, arrow.isCut, on.colours);
}

void paintScale(QPainter &painter, const MechanismCanvas &on, const ArrowScale &scale, MotionKind kind, int line)
{
    constexpr double kSample = 26.0;
    const QString text = scaleText(scale, kind);
    const QRectF box = cornerLine(on, line, kSample + QFontMetricsF(on.smallFont).horizontalAdvance(text) + 14.0);
    painter.fillRect(box, on.colours.background);
    const QPointF left(box.left() + 4.0, box.center().y());
    paintShaftAndHead(painter, left, left + QPointF(kSample, 0.0), kind, false, on.colours);
    painter.setFont(on.smallFont);
    painter.setPen(on.colours.text);
    painter.drawText(box.adjusted(kSample + 10.0, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

} // namespace slidercrank
