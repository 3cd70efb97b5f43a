// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/drawn_part.h"

#include "core/mechanism/turn.h"
#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_scenery.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slidercrank
{

namespace
{

// How far from it, in pixels, a part still counts as pointed at.
constexpr double kJoint = 12.0;
constexpr double kAroundPin = 18.0; ///< where nothing else is: A is what one drags most
constexpr double kCentre = 8.0;
constexpr double kLink = 8.0;
constexpr double kLine = 4.0;
constexpr double kArc = 5.0;

double distance(QPointF from, QPointF to)
{
    return std::hypot(to.x() - from.x(), to.y() - from.y());
}

double distanceToSegment(QPointF point, QPointF from, QPointF to)
{
    const QPointF along = to - from;
    const double squared = QPointF::dotProduct(along, along);
    const double part = squared > 0.0 ? std::clamp(QPointF::dotProduct(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return distance(point, from + part * along);
}

bool isOnBlock(QPointF away)
{
    constexpr double kAround = 3.0;
    return std::abs(away.x()) <= kBlockHalfWidth + kAround && std::abs(away.y()) <= kBlockHalfHeight + kAround;
}

bool isWithin(const CrankRange &range, double angle)
{
    return wrapToTwoPi(angle - range.from) <= range.to - range.from;
}

} // namespace

DrawnPart partAt(const MechanismDrawing &drawing, const MechanismProjection &on, QPointF pixel)
{
    if (!drawing.result) {
        return DrawnPart::Background;
    }
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QPointF pin = on.toPixels(drawing.crankPin());
    const double fromPin = distance(pixel, pin);
    if (drawing.pins) {
        const QPointF crank = on.toPixels(drawing.pins->A);
        const QPointF slider = on.toPixels(drawing.pins->B);
        const bool onBlock = isOnBlock(pixel - slider);
        if (fromPin <= kJoint && !(onBlock && distance(pixel, slider) < fromPin)) {
            return DrawnPart::A;
        }
        if (onBlock) {
            return DrawnPart::B;
        }
        if (drawing.hasCentre() && distance(pixel, 0.5 * (crank + slider)) <= kCentre) {
            return DrawnPart::G3;
        }
    }
    if (distance(pixel, pivot) <= kJoint && fromPin > kJoint) {
        return DrawnPart::O2;
    }
    const bool onCrank = distanceToSegment(pixel, pivot, pin) <= kLink;
    const bool onCoupler =
        drawing.pins && distanceToSegment(pixel, on.toPixels(drawing.pins->A), on.toPixels(drawing.pins->B)) <= kLink;
    if (fromPin <= kAroundPin && !onCrank && !onCoupler) {
        return DrawnPart::A;
    }
    if (onCrank) {
        return DrawnPart::Crank;
    }
    if (onCoupler) {
        return DrawnPart::Coupler;
    }

    const MotionLimits &limits = drawing.result->limits;
    const double line = on.toPixels({0.0, drawing.mechanism().c()}).y();
    const double below = pixel.y() - line;
    const auto isAt = [&](const std::optional<DeadCentre> &centre) {
        return centre && std::abs(on.toPixels({centre->R4x, 0.0}).x() - pixel.x()) <= kLine &&
               below >= -kDeadCentreMark && below <= kRailBelowLine;
    };
    if (isAt(limits.outer)) {
        return DrawnPart::OuterDeadCentre;
    }
    if (isAt(limits.inner)) {
        return DrawnPart::InnerDeadCentre;
    }
    const double radius = on.scale * drawing.mechanism().a();
    if (std::abs(distance(pixel, pivot) - radius) <= kArc) {
        const double angle = std::atan2(pivot.y() - pixel.y(), pixel.x() - pivot.x());
        if (std::ranges::any_of(forbiddenRanges(limits),
                                [angle](const CrankRange &range) { return isWithin(range, angle); })) {
            return DrawnPart::ForbiddenArc;
        }
    }
    const Rail rail = railOf(drawing);
    const bool onRail = pixel.x() >= on.toPixels({rail.left, 0.0}).x() - kRailOverhang &&
                        pixel.x() <= on.toPixels({rail.right, 0.0}).x() + kRailOverhang && below >= 0.0 &&
                        below <= kRailBelowLine + kHatchLength;
    return std::abs(below) <= kLine || onRail ? DrawnPart::Guide : DrawnPart::Background;
}

DrawnPart partAfter(const MechanismDrawing &drawing, DrawnPart part, int step)
{
    std::vector<DrawnPart> parts{DrawnPart::A,     DrawnPart::B,       DrawnPart::O2,
                                 DrawnPart::Crank, DrawnPart::Coupler, DrawnPart::Guide};
    const MotionLimits &limits = drawing.result->limits;
    const auto addWhere = [&](bool isOnShow, DrawnPart other) {
        if (isOnShow) {
            parts.push_back(other);
        }
    };
    addWhere(drawing.hasCentre(), DrawnPart::G3);
    addWhere(limits.outer.has_value(), DrawnPart::OuterDeadCentre);
    addWhere(limits.inner.has_value(), DrawnPart::InnerDeadCentre);
    addWhere(!forbiddenRanges(limits).empty(), DrawnPart::ForbiddenArc);
    const auto now = std::ranges::find(parts, part);
    const auto count = static_cast<std::ptrdiff_t>(parts.size());
    const std::ptrdiff_t at = now == parts.end() ? (step > 0 ? -1 : count) : now - parts.begin();
    return parts[static_cast<std::size_t>((at + step + count) % count)];
}

} // namespace slidercrank
