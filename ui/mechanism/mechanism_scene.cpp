// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_scene.h"

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismArrows {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismArrows)
};

} // namespace

Cycle computeCycle(const Mechanism &mechanism, const MotionLimits &limits)
{
    constexpr int kSteps = 180;
    Cycle cycle;
    for (const CrankRange &range : limits.ranges) {
        std::vector<LinkageMotion> &arc = cycle.emplace_back();
        for (const double theta2 : anglesAcross(range, kSteps)) {
            const LinkageMotion motion = linkageMotion(withCrankAt(mechanism, theta2), 0.0);
            if (!std::isnan(motion.front().position.x)) {
                arc.push_back(motion);
            }
        }
    }
    return cycle;
}

ArrowScale computeArrowScale(const Cycle &cycle, MotionKind kind, const Mechanism &mechanism, double longest)
{
    // Times that of the crank pin, since an unbounded motion would make all other arrows tiny.
    constexpr double kLargest = 2.5;
    const double omega2 = std::abs(mechanism.omega2());
    ArrowScale scale;
    scale.largest = kLargest * mechanism.a() * (kind == MotionKind::Velocity ? omega2 : omega2 * omega2);
    double largest = 0.0;
    for (const std::vector<LinkageMotion> &arc : cycle) {
        for (const LinkageMotion &sample : arc) {
            for (const PointMotion &motion : sample) {
                largest = std::fmax(largest, std::min(scale.largest, arrowVector(motion, kind).length()));
            }
        }
    }
    if (largest > 0.0) {
        scale.length = nextRoundNumber(0.4 * longest);
        scale.amount = nextRoundNumber(largest / longest * scale.length);
    }
    return scale;
}

QString arrowScaleText(const ArrowScale &scale, MotionKind kind)
{
    const QString unit = kind == MotionKind::Velocity ? QStringLiteral("mm/s") : QStringLiteral("mm/s²");
    return scale.amount == 0.0 ? MechanismArrows::tr("at rest")
                               : MechanismArrows::tr("Scale: %1 mm = %2 %3")
                                     .arg(numberText(scale.length), numberText(scale.amount), unit);
}

const PlaneVector &arrowVector(const PointMotion &motion, MotionKind kind)
{
    return kind == MotionKind::Velocity ? motion.velocity : motion.acceleration;
}

QPointF MechanismScene::crankPin() const
{
    return mechanism().a() * QPointF(std::cos(pose.theta2), std::sin(pose.theta2));
}

PointMotion MechanismScene::motion(LinkagePoint point) const
{
    return linkageMotion(mechanism(), pose.time)[static_cast<std::size_t>(point)];
}

void MechanismScene::updateCycle()
{
    cycle.clear();
    if (!result || !(settings.showsVelocity() || settings.acceleration || settings.path)) {
        return;
    }
    constexpr double kLongestArrow = 0.25; // of the mechanism's extent
    const QRectF bounds = motionBounds(mechanism(), result->limits);
    const double longest = kLongestArrow * std::max(bounds.width(), bounds.height());
    cycle = computeCycle(mechanism(), result->limits);
    velocity = computeArrowScale(cycle, MotionKind::Velocity, mechanism(), longest);
    acceleration = computeArrowScale(cycle, MotionKind::Acceleration, mechanism(), longest);
}

} // namespace slidercrank
