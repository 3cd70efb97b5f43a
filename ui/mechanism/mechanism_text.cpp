// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_text.h"

#include "core/limits/output_channel.h"
#include "core/mechanism/turn.h"
#include "ui/text/channel_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismText)
};

/// Returns four significant digits, or 0 for a value that is only a rounding error of numbers of the size `size`.
QString valueText(double value, double size)
{
    constexpr double kRounding = 1e-12;
    return numberText(std::abs(value) < kRounding * size ? 0.0 : value, kReadoutDigits);
}

/// Returns a value (mm, rad, s) as it is shown, without its unit. `size`: as in valueText().
QString shownText(Measure measure, double value, double size)
{
    const double factor = shownValue(measure, 1.0, notation().units);
    return valueText(factor * value, factor * size);
}

/// Returns the text about a vector. `pattern`: %1 is the magnitude, %2 the unit, %3 and %4 are the components.
QString vectorText(const QString &pattern, const PlaneVector &vector, Measure measure, double size)
{
    return pattern.arg(shownText(measure, vector.length(), size), shownUnit(measure),
                       shownText(measure, vector.x, size), shownText(measure, vector.y, size));
}

QStringList pointLines(const MechanismScene &scene, LinkagePoint point)
{
    const Mechanism &mechanism = scene.mechanism();
    const double size = mechanism.a() + mechanism.b() + std::abs(mechanism.c());
    const double omega2 = std::abs(mechanism.omega2());
    const double accelerationOfCrank = std::hypot(omega2 * omega2, scene.alpha2()); // that of A, divided by a
    const PointMotion motion = scene.motion(point);
    const QString position = MechanismText::tr("position (%1; %2) %3")
                                 .arg(shownText(Measure::Length, motion.position.x, size),
                                      shownText(Measure::Length, motion.position.y, size), shownUnit(Measure::Length));
    if (!std::isfinite(motion.velocity.length())) {
        return {position, MechanismText::tr("no velocity: the coupler is perpendicular to the slider's line")};
    }
    return {position,
            vectorText(MechanismText::tr("velocity %1 %2 (%3; %4)"), motion.velocity, Measure::Speed, size * omega2),
            vectorText(MechanismText::tr("acceleration %1 %2 (%3; %4)"), motion.acceleration, Measure::Acceleration,
                       size * accelerationOfCrank)};
}

QStringList crankLines(const MechanismScene &scene)
{
    return {QStringLiteral("θ₂ = %1").arg(crankAngleWithUnit(scene.pose.motion.theta2)),
            equationText(Parameter::Omega2, scene.mechanism().omega2(), kReadoutDigits)};
}

QStringList couplerLines(const MechanismScene &scene)
{
    const Motion &motion = scene.pose.motion;
    const double omega2 = std::abs(scene.mechanism().omega2());
    const auto lineOf = [&scene](Order order, double value, double size) {
        const Channel channel{Theta3, order};
        const double shownValueOfChannel = shownChannel(channel, scene.mechanism().branch(), value);
        return QStringLiteral("%1 = %2").arg(
            symbolText(channel),
            withUnit(valueText(shownValueOfChannel, shownValue(measureOf(channel), size, notation().units)),
                     shownUnit(channel)));
    };
    QStringList lines{lineOf(Order::Position, motion.theta3, 1.0)};
    if (std::isfinite(motion.theta3Dot)) {
        const State state = outputStateAt(scene.mechanism(), scene.pose.time, scene.alpha2()).state;
        lines << lineOf(Order::Velocity, motion.theta3Dot, omega2)
              << lineOf(Order::Acceleration, state.qDDot[Theta3], std::hypot(omega2 * omega2, scene.alpha2()));
    }
    return lines;
}

QStringList deadCentreLines(const QString &name, const std::optional<SliderPosition> &centre)
{
    return {MechanismText::tr("%1: the slider reverses. Click to go there.").arg(name),
            QStringLiteral("θ₂ = %1").arg(crankAngleWithUnit(centre->theta2)),
            MechanismText::tr("slider at %1").arg(lengthText(centre->R4x, kReadoutDigits))};
}

QStringList partLines(const MechanismScene &scene, DrawnPart part)
{
    const Mechanism &mechanism = scene.mechanism();
    const MotionLimits &limits = scene.result->limits;
    using enum DrawnPart;
    switch (part) {
    case Background: return {};
    case Ground:
    case O2: return QStringList(MechanismText::tr("O₂, the fixed pivot of the crank")) + crankLines(scene);
    case A:
        return QStringList(MechanismText::tr("A: drag to move the mechanism, with Shift to change a.")) +
               pointLines(scene, LinkagePoint::A);
    case Slider:
    case B:
        return QStringList(MechanismText::tr("B: drag to move the mechanism.")) + pointLines(scene, LinkagePoint::B);
    case G3:
        return QStringList(MechanismText::tr("G₃, the coupler's centre of mass")) + pointLines(scene, LinkagePoint::G3);
    case Crank:
        return QStringList(MechanismText::tr("Crank, %1: drag to change a.").arg(lengthText(mechanism, Parameter::A))) +
               crankLines(scene);
    case Coupler:
        return QStringList(
                   MechanismText::tr("Coupler, %1: drag to change b.").arg(lengthText(mechanism, Parameter::B))) +
               couplerLines(scene);
    case Guide:
        return {MechanismText::tr("The slider's line, %1: drag up or down to change c.")
                    .arg(lengthText(mechanism, Parameter::C))};
    case OuterDeadCentre: return deadCentreLines(MechanismText::tr("Outer dead centre"), limits.outerDeadCentre);
    case InnerDeadCentre: return deadCentreLines(MechanismText::tr("Inner dead centre"), limits.innerDeadCentre);
    case ForbiddenArc: return {mobilitySentence(mechanism, limits)};
    }
    return {};
}

} // namespace

QString partText(const MechanismScene &scene, DrawnPart part)
{
    return scene.result ? partLines(scene, part).join(u'\n') : QString();
}

QString lengthText(const Mechanism &mechanism, Parameter length)
{
    return equationText(length, valueOf(mechanism.parameters(), length));
}

QString arrowScaleText(const ArrowScale &scale)
{
    if (scale.amount == 0.0) {
        return MechanismText::tr("at rest");
    }
    const Measure measure = scale.isOfVelocity() ? Measure::Speed : Measure::Acceleration;
    const double length = shownValue(Measure::Length, scale.length, notation().units);
    // Lets a length that exceeds a round number only by rounding error keep that number.
    constexpr double kRounding = 0.999;
    const double rounded = nextRoundNumber(kRounding * length); // in units other than mm, the length is not round
    const double amount = shownValue(measure, scale.amount, notation().units) * (rounded / length);
    return MechanismText::tr("Scale: %1 = %2")
        .arg(withUnit(numberText(rounded), shownUnit(Measure::Length)),
             withUnit(numberText(amount), shownUnit(measure)));
}

QString missingPoseText(const MechanismScene &scene)
{
    if (!scene.result || scene.pose.exists()) {
        return {};
    }
    if (scene.pose.motion.status == Status::NotFinite) {
        return MechanismText::tr("The crank angle at this time is not a finite number.");
    }
    const Mechanism &mechanism = scene.mechanism();
    const QString forFullTurn = atLeastText(shortestCouplerForFullTurn(mechanism));
    if (scene.result->limits.mobility == Mobility::Impossible) {
        return MechanismText::tr("The mechanism cannot be assembled at any crank angle: the coupler does not reach the "
                                 "slider's line. It can be assembled if b ≥ %1; the crank makes full turns if "
                                 "b ≥ %2.")
            .arg(atLeastText(shortestCouplerForAnyPose(mechanism)), forFullTurn);
    }
    return MechanismText::tr("The mechanism cannot be assembled at θ₂ = %1: the coupler is too short. The crank makes "
                             "full turns if b ≥ %2.")
        .arg(crankAngleWithUnit(scene.pose.motion.theta2), forFullTurn);
}

} // namespace slidercrank
