// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that a drawing of the mechanism shows, as plain data.

#include "core/comparison/reference_pose.h"
#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/mechanism/mechanism_arrows.h"

#include <QPointF>

#include <memory>
#include <optional>

namespace slidercrank
{

/// What can be pointed at.
enum class DrawnPart {
    Background,
    O2,
    A,
    B,
    G3,
    Crank,
    Coupler,
    Guide, ///< the slider's line
    OuterDeadCentre,
    InnerDeadCentre,
    ForbiddenArc
};

struct MechanismDrawing {
    /// The two pins, mm: what is left to draw when there is no pose any more.
    struct Pins {
        QPointF A;
        QPointF B;
    };

    std::shared_ptr<const Result> result; ///< null: nothing is drawn
    Pose pose;
    std::optional<Pins> pins; ///< of the last pose that existed
    ReferencePose ghost;      ///< the reference's linkage; one that does not exist is not drawn
    MechanismSettings settings;

    // What of a whole turn is on show; empty where nothing of it is.
    Cycle cycle;
    ArrowScale velocity;
    ArrowScale acceleration;

    const Mechanism &mechanism() const { return result->mechanism; }

    /// Where A is, or would be, mm.
    QPointF crankPin() const;

    /// At the instant of the pose.
    LinkageMotion motion() const;

    /// After another mechanism, other settings; `frame`: what arrows are to be within, mm.
    void refreshCycle(const QRectF &frame);

    /// Whether G3 is on show.
    bool hasCentre() const;
};

} // namespace slidercrank
