// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_frame.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

// Margins around the bounds, as fractions of their extent.
constexpr double kMarginFraction = 0.08; // space for the slider and the names
constexpr double kMinMargin = 0.03;      // with less, the frame is enlarged
constexpr double kMarginToGrow = 0.22;   // used when enlarging, since bounds that grow usually continue to grow

QRectF withMargin(const QRectF &bounds, double share)
{
    const double margin = share * std::max(bounds.width(), bounds.height());
    return bounds.adjusted(-margin, -margin, margin, margin);
}

MechanismProjection projectionOnto(const QRectF &frame, const QSizeF &size)
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

QRectF motionBounds(const Mechanism &mechanism, const MotionLimits &limits)
{
    const double a = mechanism.a();
    const double c = mechanism.c();
    Interval x{-a, a};
    // The slider's extreme positions are its dead centres. Where an oscillating crank reverses, the slider needs no
    // further space, because it is at x = a cos θ2, within [-a, a].
    for (const std::optional<SliderPosition> &centre : {limits.outerDeadCentre, limits.innerDeadCentre}) {
        if (centre) {
            x.include(centre->R4x);
        }
    }
    return QRectF(QPointF(x.lower, std::min(-a, c)), QPointF(x.upper, std::max(a, c)));
}

Interval sliderTravel(const Mechanism &mechanism, const MotionLimits &limits)
{
    if (limits.mobility == Mobility::FullTurn && limits.innerDeadCentre && limits.outerDeadCentre) {
        const auto [left, right] = std::minmax(limits.innerDeadCentre->R4x, limits.outerDeadCentre->R4x);
        return {left, right};
    }
    const QRectF bounds = motionBounds(mechanism, limits);
    return {bounds.left(), bounds.right()};
}

void MechanismFrame::follow(const QRectF &bounds)
{
    // If the drawing fills less than this fraction of the frame in both directions, the frame shrinks.
    constexpr double kMinUsedFraction = 0.65;
    const QRectF wanted = withMargin(bounds, kMarginFraction);
    if (m_fitted.isNull() || (wanted.width() < kMinUsedFraction * m_fitted.width() &&
                              wanted.height() < kMinUsedFraction * m_fitted.height())) {
        m_fitted = wanted;
    } else if (!m_fitted.contains(withMargin(bounds, kMinMargin))) {
        m_fitted = m_fitted.united(withMargin(bounds, kMarginToGrow));
    }
}

void MechanismFrame::fit(const QRectF &bounds)
{
    m_fitted = withMargin(bounds, kMarginFraction);
}

MechanismProjection MechanismFrame::projection(const QSizeF &size) const
{
    const QRectF defaultFrame(-1.0, -1.0, 2.0, 2.0); // mm
    return projectionOnto(m_zoomed.value_or(m_fitted.isNull() ? defaultFrame : m_fitted), size);
}

void MechanismFrame::zoom(double factor, QPointF pixel, const QSizeF &size)
{
    // Relative to the scale of the fitted frame. At a closer zoom a circle would exceed the number range of QPainter.
    constexpr double kMinZoom = 0.05;
    constexpr double kMaxZoom = 100.0;
    const MechanismProjection now = projection(size);
    const double fittedScale = m_fitted.isNull() ? now.scale : projectionOnto(m_fitted, size).scale;
    const double sizeFactor =
        now.scale / std::clamp(factor * now.scale, kMinZoom * fittedScale, kMaxZoom * fittedScale);
    const QPointF fixed = now.toModel(pixel);
    const QRectF visible = now.visible();
    m_zoomed =
        QRectF(fixed + sizeFactor * (visible.topLeft() - fixed), fixed + sizeFactor * (visible.bottomRight() - fixed));
}

void MechanismFrame::pan(QPointF pixels, const QSizeF &size)
{
    const MechanismProjection now = projection(size);
    m_zoomed = now.visible().translated(-pixels.x() / now.scale, pixels.y() / now.scale);
}

} // namespace slidercrank
