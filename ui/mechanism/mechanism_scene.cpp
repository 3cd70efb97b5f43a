// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_scene.h"

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PointMotion MechanismScene::motion(LinkagePoint point) const
{
    return motionOf(linkageMotion(mechanism(), pose.time, alpha2()), point);
}

QRectF MechanismScene::inFreeCorner(const QRectF &area, const QSizeF &size, const QRectF &obstacle) const
{
    QRectF box(area.topLeft(), size);
    if (mechanism().branch() == Branch::Open) {
        box.moveRight(area.right());
    }
    if (mechanism().c() >= 0.0) {
        box.moveBottom(area.bottom());
        if (box.intersects(obstacle)) {
            box.moveBottom(obstacle.top());
        }
    } else if (box.intersects(obstacle)) {
        box.moveTop(obstacle.bottom());
    }
    return box;
}

ArrowScale MechanismScene::arrows(PlaneVector PointMotion::*vector) const
{
    constexpr double kArrowOfA = 0.2;      // times the mechanism's extent
    constexpr double kMaxArrowRatio = 2.5; // times the arrow of A
    ArrowScale scale{vector};
    const QRectF bounds = motionBounds(mechanism(), result->limits);
    const double arrowOfA = kArrowOfA * std::max(bounds.width(), bounds.height());
    const double omega2 = std::abs(mechanism().omega2());
    const double amountOfA = mechanism().a() * (scale.isOfVelocity() ? omega2 : std::hypot(omega2 * omega2, alpha2()));
    scale.largest = kMaxArrowRatio * amountOfA;
    scale.length = nextRoundNumber(0.5 * arrowOfA);
    scale.amount = amountOfA > 0.0 ? nextRoundNumber(amountOfA / arrowOfA * scale.length) : 0.0;
    return scale;
}

} // namespace slidercrank
