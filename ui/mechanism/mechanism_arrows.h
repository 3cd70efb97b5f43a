// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Arrows of velocity and acceleration at A, B and G3, to a scale that can be written down: "10 mm ≙ 60 mm/s". It is one
// for all of a turn, so that arrows compare, and round. Where a motion runs away (a rocker at its limit, a coupler
// square to the slider's line) an arrow is cut, and drawn dashed.

#include "core/limits/linkage_point.h"
#include "core/limits/mobility.h"
#include "ui/mechanism/mechanism_canvas.h"

#include <QString>

#include <optional>
#include <vector>

namespace slidercrank
{

enum class MotionKind { Velocity, Acceleration };

/// A turn of the crank, or all that a rocker has of it: an arc each. Empty where there is no pose.
using Cycle = std::vector<std::vector<LinkageMotion>>;

Cycle cycleOf(const Mechanism &mechanism, const MotionLimits &limits);

struct ArrowScale {
    double length = 0.0; ///< mm of the drawing
    double amount = 0.0; ///< mm/s or mm/s² that it stands for; 0: nothing moves
    double most = 0.0;   ///< what is more is cut, mm/s or mm/s²
};

/// The arrows of the cycle end within the room (mm), as long as they can be; none longer than `longest` (mm).
ArrowScale arrowScale(const Cycle &cycle, MotionKind kind, const Mechanism &mechanism, const QRectF &room,
                      double longest);

/// "10 mm ≙ 60 mm/s".
QString scaleText(const ArrowScale &scale, MotionKind kind);

/// mm of the model.
struct MotionArrow {
    QPointF tail;
    QPointF tip;
    bool isCut = false;
};

/// None where nothing moves, or the motion does not exist.
std::optional<MotionArrow> arrowOf(const PointMotion &motion, MotionKind kind, const ArrowScale &scale);

void paintArrow(QPainter &painter, const MechanismCanvas &on, const MotionArrow &arrow, MotionKind kind);

/// What the arrows of that kind stand for, with a sample, in line `line` of the upper left corner.
void paintScale(QPainter &painter, const MechanismCanvas &on, const ArrowScale &scale, MotionKind kind, int line);

} // namespace slidercrank
