// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frame is the part of the plane that a drawing of the mechanism shows. It does not move while the mechanism moves.
// While lengths change, the frame follows in coarse steps; when they no longer change, it is fitted to them. Once the
// user has zoomed, the frame does not change at all.
//
// Model coordinates: mm, x to the right, y upwards, O2 at the origin. A rectangle of the model has its smallest y at
// top().

#include "core/limits/mobility.h"
#include "ui/text/interval.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <optional>

namespace slidercrank
{

/// Maps points of the model to pixels of a drawing.
struct MechanismProjection {
    QSizeF size;        ///< pixels
    double scale = 1.0; ///< pixels per mm
    QPointF origin;     ///< O2, pixels

    QPointF toPixels(QPointF model) const { return {origin.x() + scale * model.x(), origin.y() - scale * model.y()}; }
    QPointF toModel(QPointF pixel) const
    {
        return {(pixel.x() - origin.x()) / scale, (origin.y() - pixel.y()) / scale};
    }
    QRectF visible() const; ///< mm, the whole drawing
};

/// Returns the rectangle (mm) in which the pins A and B move. It is never empty, since the crank has a length.
QRectF motionBounds(const Mechanism &mechanism, const MotionLimits &limits);

/// Returns the range (mm) in which the slider moves or, where the crank makes no full turns, one that contains it.
Interval sliderTravel(const Mechanism &mechanism, const MotionLimits &limits);

class MechanismFrame
{
public:
    /// Enlarges the frame generously if the bounds exceed it, and replaces it if it is much too large.
    void follow(const QRectF &bounds);

    /// Fits the frame to the bounds with a margin.
    void fit(const QRectF &bounds);

    /// Returns the projection that shows the whole frame, centred, in a drawing of that size (pixels).
    MechanismProjection projection(const QSizeF &size) const;

    /// Zoom a drawing of the size `size` (px) about the point under `pixel`, or move it by `pixels`.
    void zoom(double factor, QPointF pixel, const QSizeF &size);
    void pan(QPointF pixels, const QSizeF &size);

    const QRectF &fitted() const { return m_fitted; } ///< null before the first call of follow() or fit()

    /// Returns the rectangle that the user zoomed to; nullopt if the fitted frame is shown.
    const std::optional<QRectF> &zoomed() const { return m_zoomed; }
    void setZoomed(const std::optional<QRectF> &zoomed) { m_zoomed = zoomed; }

private:
    QRectF m_fitted;
    std::optional<QRectF> m_zoomed;
};

} // namespace slidercrank
