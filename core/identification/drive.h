// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the crank turns, if the file contains its angle.

#include "core/identification/fit.h"

namespace slidercrank
{

struct Drive {
    enum class Kind {
        OverTime,  ///< the file does not contain the angle of the crank: ω2 is an unknown of the fit
        OverAngle, ///< it does not contain the time: ω2 follows from derivatives, if at all
        Constant,  ///< it contains both, and the speed is constant
        RunUp,     ///< the speed changes evenly
        Uneven     ///< it changes in another way: positions follow from the angle, but nothing predicts derivatives
    };
    Kind kind = Kind::OverTime;

    /// Whether the speed changes.
    bool isUneven() const { return kind == Kind::RunUp || kind == Kind::Uneven; }

    // Constant, RunUp: the polynomial of θ2 over the time of the observations.
    double theta20 = kNone; ///< rad
    double omega2 = kNone;  ///< rad/s
    double alpha2 = 0.0;    ///< rad/s², RunUp

    // RunUp, Uneven.
    double least = kNone; ///< smallest and largest speed, rad/s
    double greatest = kNone;

    // RunUp: standard errors of the angle and the speed at t = 0 of the file.
    double angleError = kNone;
    double speedError = kNone;
};

/// Finds out how the crank turns, from its angle as `model` reads it.
Drive findDrive(const Observations &observations, const Model &model);

} // namespace slidercrank
