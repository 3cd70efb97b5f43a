// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The part of the plane that a drawing of the mechanism shows. The frame stands still while the mechanism moves. While
// lengths change it follows in coarse steps, and it fits them once they rest. Where the user has zoomed, it stays.
//
// Model coordinates: mm, x to the right, y upwards, O2 at the origin. A rectangle of the model has its smallest y at
// top().

#include "core/limits/mobility.h"

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

/// The rectangle (mm) in which the pins A and B of the mechanism move. It is never empty, since the crank has a length.
QRectF motionBounds(const Mechanism &mechanism, const MotionLimits &limits);

class MechanismFrame
{
public:
    /// Widens the frame with room to spare where the bounds have outgrown it; replaces it where it is far too large.
    void follow(const QRectF &bounds);

    /// Fits the frame to the bounds with a margin.
    void fit(const QRectF &bounds);

    /// Shows the whole frame, centred, in a drawing of that size (pixels).
    MechanismProjection projection(const QSizeF &size) const;

    /// In a drawing of that size; the point under the pixel stays where it is.
    void zoom(double factor, QPointF pixel, const QSizeF &size);
    void pan(QPointF pixels, const QSizeF &size);

    const QRectF &fitted() const { return m_fitted; } ///< null before the first bounds

    /// The rectangle that the user zoomed to; nullopt: the fitted one.
    const std::optional<QRectF> &zoomed() const { return m_zoomed; }
    void setZoomed(const std::optional<QRectF> &zoomed) { m_zoomed = zoomed; }

private:
    QRectF m_fitted;
    std::optional<QRectF> m_zoomed;
};

} // namespace slidercrank
