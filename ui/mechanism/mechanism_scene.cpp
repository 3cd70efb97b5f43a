// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_scene.h"

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

QPointF MechanismScene::crankPin() const
{
    return mechanism().a() * QPointF(std::cos(pose.theta2), std::sin(pose.theta2));
}

PointMotion MechanismScene::motion(LinkagePoint point) const
{
    return linkageMotion(mechanism(), pose.time)[static_cast<std::size_t>(point)];
}

QRectF MechanismScene::inFreeCorner(const QRectF &area, const QSizeF &size) const
{
    QRectF box(area.topLeft(), size);
    if (mechanism().branch() == Branch::Open) {
        box.moveRight(area.right());
    }
    if (mechanism().c() >= 0.0) {
        box.moveBottom(area.bottom());
    }
    return box;
}

void MechanismScene::updateCycle()
{
    constexpr int kSteps = 180;
    cycle.clear();
    if (!result || !(settings.showsVelocity() || settings.acceleration || settings.path)) {
        return;
    }
    for (const CrankRange &range : result->limits.ranges) {
        std::vector<LinkageMotion> &arc = cycle.emplace_back();
        for (const double theta2 : anglesAcross(range, kSteps)) {
            const LinkageMotion motion = linkageMotion(withCrankAt(mechanism(), theta2), 0.0);
            if (!std::isnan(motion.front().position.x)) {
                arc.push_back(motion);
            }
        }
    }
    updateScale(velocity);
    updateScale(acceleration);
}

/// Chooses a round scale with which no arrow of the cycle is longer than a part of the mechanism's extent.
void MechanismScene::updateScale(ArrowScale &scale)
{
    constexpr double kLongest = 0.25; // times the extent
    constexpr double kLargest = 2.5;  // times that of A, since an unbounded motion would make all other arrows tiny
    const QRectF bounds = motionBounds(mechanism(), result->limits);
    const double longest = kLongest * std::max(bounds.width(), bounds.height());
    const double omega2 = std::abs(mechanism().omega2());
    scale.largest = kLargest * mechanism().a() * (scale.isOfVelocity() ? omega2 : omega2 * omega2);
    double largest = 0.0;
    for (const std::vector<LinkageMotion> &arc : cycle) {
        for (const LinkageMotion &sample : arc) {
            for (const PointMotion &motion : sample) {
                largest = std::fmax(largest, std::min(scale.largest, (motion.*scale.vector).length()));
            }
        }
    }
    scale.length = largest > 0.0 ? nextRoundNumber(0.4 * longest) : 0.0;
    scale.amount = largest > 0.0 ? nextRoundNumber(largest / longest * scale.length) : 0.0;
}

} // namespace slidercrank
