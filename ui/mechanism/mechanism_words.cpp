// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_words.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismWords {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismWords)
};

/// What is nothing but the rounding of numbers of that size is 0.
QString text(double value, double size)
{
    constexpr int kDigits = 5;
    constexpr double kNothing = 1e-12;
    return numberText(std::abs(value) < kNothing * size ? 0.0 : value, kDigits);
}

QString vectorText(const QString &pattern, const PlaneVector &vector, double size)
{
    return pattern.arg(text(vector.length(), size), text(vector.x, size), text(vector.y, size));
}

QStringList motionLines(const MechanismDrawing &drawing, LinkagePoint point)
{
    if (!drawing.pose.exists()) {
        return {MechanismWords::tr("no pose at this instant")};
    }
    const Mechanism &mechanism = drawing.mechanism();
    const double size = mechanism.a() + mechanism.b() + std::abs(mechanism.c());
    const double omega2 = std::abs(mechanism.omega2());
    const PointMotion motion = drawing.motion()[static_cast<std::size_t>(point)];
    QStringList lines{
        MechanismWords::tr("position (%1; %2) mm").arg(text(motion.position.x, size), text(motion.position.y, size))};
    if (std::isfinite(motion.velocity.length())) {
        lines << vectorText(MechanismWords::tr("velocity %1 mm/s (%2; %3)"), motion.velocity, size * omega2)
              << vectorText(MechanismWords::tr("acceleration %1 mm/s² (%2; %3)"), motion.acceleration,
                            size * omega2 * omega2);
    } else {
        lines << MechanismWords::tr("no velocity: the coupler is perpendicular to the slider's line");
    }
    return lines;
}

QStringList crankLines(const MechanismDrawing &drawing)
{
    return {MechanismWords::tr("θ₂ = %1°").arg(crankAngleText(drawing.pose.theta2)),
            MechanismWords::tr("ω₂ = %1 rad/s").arg(numberText(drawing.mechanism().omega2(), 5))};
}

QStringList couplerLines(const MechanismDrawing &drawing)
{
    if (!drawing.pose.exists()) {
        return {MechanismWords::tr("no pose at this instant")};
    }
    const Motion motion = ClosedForm(withCrankAt(drawing.mechanism(), drawing.pose.theta2)).motionAt(0.0);
    const double omega2 = std::abs(drawing.mechanism().omega2());
    QStringList lines{MechanismWords::tr("θ³ = %1°").arg(text(kDegreesPerRadian * motion.theta3, 1.0))};
    if (std::isfinite(motion.theta3Dot)) {
        lines << MechanismWords::tr("turns at %1 °/s").arg(text(kDegreesPerRadian * motion.theta3Dot, omega2))
              << MechanismWords::tr("angular acceleration %1 °/s²")
                     .arg(text(kDegreesPerRadian * motion.theta3DDot, omega2 * omega2));
    }
    return lines;
}

QStringList deadCentreLines(const std::optional<DeadCentre> &centre)
{
    if (!centre) {
        return {};
    }
    return {MechanismWords::tr("θ₂ = %1°").arg(crankAngleText(centre->theta2)),
            MechanismWords::tr("slider at %1 mm").arg(numberText(centre->R4x, 5))};
}

QStringList forbiddenLines(const MechanismDrawing &drawing)
{
    QStringList lines;
    for (const CrankRange &range : forbiddenRanges(drawing.result->limits)) {
        if (range.to - range.from < kTurn) {
            lines << MechanismWords::tr("θ₂ from %1° to %2°").arg(crankAngleText(range.from), crankAngleText(range.to));
        }
    }
    return lines << MechanismWords::tr("The crank turns round when b is at least %1 mm.")
                        .arg(numberText(shortestCouplerForFullTurn(drawing.mechanism())));
}

} // namespace

QString partText(const MechanismDrawing &drawing, DrawnPart part)
{
    if (!drawing.result) {
        return {};
    }
    const Mechanism &mechanism = drawing.mechanism();
    const auto lines = [](const QString &first, const QStringList &others) {
        return (QStringList(first) + others).join(u'\n');
    };
    switch (part) {
    case DrawnPart::Background: return {};
    case DrawnPart::O2: return lines(MechanismWords::tr("O₂, about which the crank turns"), crankLines(drawing));
    case DrawnPart::A:
        return lines(mechanism.omega2() == 0.0
                         ? MechanismWords::tr("A – with ω₂ = 0 the crank stands still; drag with Shift to change a")
                         : MechanismWords::tr("A – drag to move the crank; with Shift to change a"),
                     motionLines(drawing, LinkagePoint::A));
    case DrawnPart::B:
        return lines(mechanism.omega2() == 0.0
                         ? MechanismWords::tr("B – with ω₂ = 0 the slider stands still; drag with Shift to change b")
                         : MechanismWords::tr("B – drag to move the slider; with Shift to change b"),
                     motionLines(drawing, LinkagePoint::B));
    case DrawnPart::G3:
        return lines(MechanismWords::tr("G₃, the coupler's centre of mass"), motionLines(drawing, LinkagePoint::G3));
    case DrawnPart::Crank:
        return lines(MechanismWords::tr("Crank, %1 – pull along it to change a")
                         .arg(lengthText(QStringLiteral("a"), mechanism.a())),
                     crankLines(drawing));
    case DrawnPart::Coupler:
        return lines(MechanismWords::tr("Coupler, %1 – pull along it to change b")
                         .arg(lengthText(QStringLiteral("b"), mechanism.b())),
                     couplerLines(drawing));
    case DrawnPart::Guide:
        return MechanismWords::tr("The slider's line, %1 – drag up or down to change c")
            .arg(lengthText(QStringLiteral("c"), mechanism.c()));
    case DrawnPart::OuterDeadCentre:
        return lines(MechanismWords::tr("Outer dead centre: the slider turns back – click to go there"),
                     deadCentreLines(drawing.result->limits.outer));
    case DrawnPart::InnerDeadCentre:
        return lines(MechanismWords::tr("Inner dead centre: the slider turns back – click to go there"),
                     deadCentreLines(drawing.result->limits.inner));
    case DrawnPart::ForbiddenArc:
        return lines(MechanismWords::tr("With the crank here it cannot be assembled: the coupler is too short"),
                     forbiddenLines(drawing));
    }
    return {};
}

QString lengthText(const QString &symbol, double length)
{
    return MechanismWords::tr("%1 = %2 mm").arg(symbol, numberText(length));
}

QString explanationOf(const MechanismDrawing &drawing)
{
    if (!drawing.result || drawing.pose.exists()) {
        return {};
    }
    if (drawing.pose.status == Status::NotFinite) {
        return MechanismWords::tr("There is no pose at this instant: the crank angle is not a finite number.");
    }
    const Mechanism &mechanism = drawing.mechanism();
    const QString turning = atLeastText(shortestCouplerForFullTurn(mechanism));
    if (drawing.result->limits.mobility == Mobility::Impossible) {
        return MechanismWords::tr(
                   "Cannot be assembled at any crank angle: the coupler does not reach the slider's line. b must "
                   "be at least %1 mm for any pose; the crank turns round when b is at least %2 mm.")
            .arg(atLeastText(shortestCouplerForAnyPose(mechanism)), turning);
    }
    const double angle = wrapToTwoPi(drawing.pose.theta2);
    return MechanismWords::tr(
               "Cannot be assembled at θ₂ = %1°: the coupler is too short. The crank turns round when b is at "
               "least %2 mm.")
        .arg(QLocale().toString(angle * kDegreesPerRadian, 'f', 1), turning);
}

} // namespace slidercrank
