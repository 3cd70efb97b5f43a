// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_frame.h"

#include "core/comparison/reference_pose.h"
#include "ui/text/written_number.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kClosest =
    100.0; ///< times the fitted frame's scale; closer, a circle no longer fits a drawing's numbers
constexpr double kFarthest = 0.05;

/// The reach with room around it, its edges on round numbers.
QRectF frameAround(const QRectF &reach, double room)
{
    const double extent = std::max(reach.width(), reach.height());
    const double step = nextRoundNumber(extent / 20.0);
    const double margin = room * extent;
    const auto down = [step](double x) { return std::floor(x / step) * step; };
    const auto up = [step](double x) { return std::ceil(x / step) * step; };
    return QRectF(QPointF(down(reach.left() - margin), down(reach.top() - margin)),
                  QPointF(up(reach.right() + margin), up(reach.bottom() + margin)));
}

constexpr double kRoom = 0.08;      ///< beside what moves, for slider and names; of its extent
constexpr double kLeastRoom = 0.03; ///< with less of it, the view is widened

QRectF withLeastRoom(const QRectF &reach)
{
    const double least = kLeastRoom * std::max(reach.width(), reach.height());
    return reach.adjusted(-least, -least, least, least);
}

MechanismProjection projectionOf(const QRectF &frame, const QSizeF &size)
{
    MechanismProjection projection;
    projection.size = size;
    projection.scale =
        std::min(std::max(1.0, size.width()) / frame.width(), std::max(1.0, size.height()) / frame.height());
    projection.origin = QPointF(0.5 * size.width() - projection.scale * frame.center().x(),
                                0.5 * size.height() + projection.scale * frame.center().y());
    return projection;
}

} // namespace

QRectF MechanismProjection::visible() const
{
    return QRectF(toModel({0.0, size.height()}), toModel({size.width(), 0.0}));
}

QRectF characteristicLength(const Mechanism &mechanism, const MotionLimits &limits)
{
    const double a = mechanism.a();
    const double c = mechanism.c();
    double left = -a;
    double right = a;
    // At the ends of a rocker's arc the slider is at a cos θ2, so within the crank circle's width.
    for (const std::optional<DeadCentre> &centre : {limits.outer, limits.inner}) {
        if (centre) {
            left = std::min(left, centre->R4x);
            right = std::max(right, centre->R4x);
        }
    }
    return QRectF(QPointF(left, std::min(-a, c)), QPointF(right, std::max(a, c)));
}

QRectF characteristicLength(const ReferenceData &data, const Mechanism &lengths)
{
    constexpr std::size_t kInstants = 400; // enough for tens of turns, in a moment
    QPolygonF pins;
    const std::size_t rows = data.time.size();
    const std::size_t step = std::max<std::size_t>(1, rows / kInstants);
    for (std::size_t i = 0; i < rows; i += step) {
        const ReferencePose pose = referencePoseAt(data, lengths, data.time[i]);
        if (pose.exists) {
            pins << QPointF(pose.pinX, pose.pinY) << QPointF(pose.sliderX, pose.sliderY);
        }
    }
    return pins.boundingRect();
}

void MechanismFrame::follow(const QRectF &reach)
{
    constexpr double kRoomToGrow = 0.22; // where the reach has just outgrown the frame: it will grow on
    constexpr double kMuchTooLarge = 0.65;
    const QRectF needed = withLeastRoom(reach);
    const QRectF wanted = frameAround(reach, kRoom);
    if (m_fitted.isNull() || wanted.width() < kMuchTooLarge * m_fitted.width() ||
        wanted.height() < kMuchTooLarge * m_fitted.height()) {
        m_fitted = wanted;
    } else if (!m_fitted.contains(needed)) {
        const QRectF grown = frameAround(reach, kRoomToGrow);
        m_fitted = QRectF(QPointF(needed.left() < m_fitted.left() ? grown.left() : m_fitted.left(),
                                  needed.top() < m_fitted.top() ? grown.top() : m_fitted.top()),
                          QPointF(needed.right() > m_fitted.right() ? grown.right() : m_fitted.right(),
                                  needed.bottom() > m_fitted.bottom() ? grown.bottom() : m_fitted.bottom()));
    }
}

void MechanismFrame::include(const QRectF &reach)
{
    if (!reach.isNull() && !m_fitted.contains(withLeastRoom(reach))) {
        m_fitted = m_fitted.united(frameAround(reach, kRoom));
    }
}

void MechanismFrame::refit(const QRectF &reach)
{
    m_fitted = frameAround(reach, kRoom);
}

void MechanismFrame::fit(const QRectF &reach)
{
    refit(reach);
    m_zoomed.reset();
}

MechanismProjection MechanismFrame::projection(const QSizeF &size) const
{
    const QRectF nothing(-1.0, -1.0, 2.0, 2.0);
    return projectionOf(m_zoomed.value_or(m_fitted.isNull() ? nothing : m_fitted), size);
}

void MechanismFrame::zoom(double factor, QPointF about, const QSizeF &size)
{
    const MechanismProjection now = projection(size);
    const double whole = m_fitted.isNull() ? now.scale : projectionOf(m_fitted, size).scale;
    const double scale = std::clamp(factor * now.scale, kFarthest * whole, kClosest * whole);
    const double shrunk = now.scale / scale;
    const QPointF still = now.toModel(about);
    const QRectF visible = now.visible();
    m_zoomed = QRectF(still + shrunk * (visible.topLeft() - still), still + shrunk * (visible.bottomRight() - still));
}

void MechanismFrame::pan(QPointF pixels, const QSizeF &size)
{
    const MechanismProjection now = projection(size);
    m_zoomed = now.visible().translated(-pixels.x() / now.scale, pixels.y() / now.scale);
}

} // namespace slidercrank
