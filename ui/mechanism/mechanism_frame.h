// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What part of the plane a drawing of the mechanism shows, and where its points are then. The frame stands still while
// the mechanism moves, follows its lengths in coarse steps while they change, and fits them once they rest; where a
// person has zoomed, it stays as they left it.
//
// Model coordinates: mm, x to the right, y upwards, O2 in the origin. A rectangle of the model has its least y at
// top().

#include "core/import/reference_data.h"
#include "core/limits/mobility.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <optional>

namespace slidercrank
{

/// Where points of the model are in a drawing.
struct MechanismProjection {
    QSizeF size;        ///< pixels
    double scale = 1.0; ///< pixels a mm
    QPointF origin;     ///< pixels, of O2

    QPointF toPixels(QPointF model) const { return {origin.x() + scale * model.x(), origin.y() - scale * model.y()}; }
    QPointF toModel(QPointF pixel) const
    {
        return {(pixel.x() - origin.x()) / scale, (origin.y() - pixel.y()) / scale};
    }
    QRectF visible() const; ///< mm, all of the drawing

    friend bool operator==(const MechanismProjection &, const MechanismProjection &) = default;
};

/// Everywhere that the pins A and B can be, mm. Empty rectangles do not occur: the crank has a length.
QRectF characteristicLength(const Mechanism &mechanism, const MotionLimits &limits);

/// Everywhere that they are in the data, which tell nothing of those lengths, mm; null where the data have no pose.
QRectF characteristicLength(const ReferenceData &data, const Mechanism &lengths);

class MechanismFrame
{
public:
    /// Puts the reach into view, at once where it is out of it, and closer where it has become small.
    void follow(const QRectF &reach);

    /// Widens the view where the reach is beyond it, and never brings it closer.
    void include(const QRectF &reach);

    /// The reach with room around it, whatever was in view.
    void refit(const QRectF &reach);

    /// The same, no longer zoomed.
    void fit(const QRectF &reach);

    /// With all of the frame in the drawing, in the middle.
    MechanismProjection projection(const QSizeF &size) const;

    /// In a drawing of that size; the point under the pixel stays there.
    void zoom(double factor, QPointF about, const QSizeF &size);
    void pan(QPointF pixels, const QSizeF &size);

    const QRectF &fitted() const { return m_fitted; } ///< null before the first reach

    /// What somebody zoomed to; none: all.
    const std::optional<QRectF> &zoomed() const { return m_zoomed; }
    void setZoomed(const std::optional<QRectF> &zoomed) { m_zoomed = zoomed; }

private:
    QRectF m_fitted;
    std::optional<QRectF> m_zoomed;
};

} // namespace slidercrank
