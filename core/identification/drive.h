// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the crank turns: whether its speed is constant, changes evenly or is uneven, if the file contains its angle.

#include "core/identification/fit.h"

namespace slidercrank
{

struct Drive {
    enum class Kind {
        OverTime,  ///< the file does not contain the angle of the crank: ω2 is an unknown of the fit
        OverAngle, ///< it does not contain the time, or too few rows to show the speed: ω2 follows from derivatives, if
                   ///< at all
        Constant, ///< it contains both, and the speed is constant
        RunUp,    ///< it contains both, and the speed changes evenly
        Uneven    ///< the speed changes unevenly: the angle predicts positions, but nothing predicts derivatives
    };
    Kind kind = Kind::OverTime;

    /// Whether the file shows that the speed changes.
    bool hasChangingSpeed() const { return kind == Kind::RunUp || kind == Kind::Uneven; }

    // Constant, RunUp: θ2 = theta20 + omega2 t + alpha2 t²/2 over the time of the observations.
    double theta20 = kNone; ///< rad
    double omega2 = kNone;  ///< rad/s; Uneven: the mean speed
    double alpha2 = 0.0;    ///< rad/s²

    // Constant, RunUp, Uneven: the smallest and the largest speed in the file, rad/s. The errors of θ2 widen this
    // range.
    double minSpeed = kNone;
    double maxSpeed = kNone;

    // RunUp: standard errors of the angle (rad) and the speed (rad/s) at t = 0 of the file. (theta20 and omega2 are
    // those in the middle of the file.)
    double angleErrorAtZero = kNone;
    double speedErrorAtZero = kNone;
};

/// Finds the drive of a file from the angle in the file, as `model` reads it, and the time.
Drive findDrive(const Observations &observations, const Model &model);

} // namespace slidercrank
