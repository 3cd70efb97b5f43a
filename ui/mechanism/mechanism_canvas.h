// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What every part of the mechanism's drawing is drawn on: where points go, in which colours and font. The drawing
// follows the conventions of mechanism textbooks: a hatched line is ground, a circle is a revolute joint.

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/theme.h"

#include <QFont>

class QPainter;

namespace slidercrank
{

struct MechanismCanvas : MechanismProjection {
    SeriesColours colours;
    QColor muted;     ///< text and lines that are not the point
    QColor highlight; ///< what is pointed at
    QFont font;       ///< in pixels, so that text has the same size beside the drawing on every device
    QFont smallFont;
    double hairline = 1.0; ///< pixels that are one where the drawing is seen
};

MechanismCanvas canvasOf(const MechanismProjection &projection, const QPalette &palette, const QFont &font);

// Sizes in pixels: parts must stay visible and graspable whatever the mechanism's size.
inline constexpr double kCrankWidth = 10.5;
inline constexpr double kCouplerWidth = 8.0;
inline constexpr double kJointRadius = 6.0; ///< covers the ends of the links
inline constexpr double kBlockHalfWidth = 19.0;
inline constexpr double kBlockHalfHeight = 12.0;
inline constexpr double kRailBelowLine = kBlockHalfHeight + 1.0;
inline constexpr double kHatchLength = 7.0;
inline constexpr double kGroundHalfWidth = 17.0; ///< below O₂
inline constexpr double kGroundDepth = 17.0 + kHatchLength;
inline constexpr double kDeadCentreMark = kBlockHalfHeight + 8.0; ///< how far it rises above the slider's line

/// `share` of the colour on the background.
QColor mixed(const QColor &colour, const QColor &background, double share);

/// Of length 1; up the drawing for a vector of no length.
QPointF unitVector(QPointF vector);

void paintJoint(QPainter &painter, QPointF at, const QColor &edge, const QColor &fill);

/// A filled head with its tip there.
void paintArrowHead(QPainter &painter, QPointF tip, QPointF direction, double length, const QColor &colour);

/// For a line of small text, that wide, in the upper left corner; lines count from 0.
QRectF cornerLine(const MechanismCanvas &on, int line, double width);

/// Centred there, on paper, so that lines beneath do not cross it.
void paintNote(QPainter &painter, const MechanismCanvas &on, QPointF centre, const QString &text);

} // namespace slidercrank
