// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the limits of a motion: whether and why the crank makes full turns, where the slider reverses, and the peak
// velocities and accelerations of slider and coupler.

#include "core/limits/limit.h"
#include "core/sampling/trajectory.h"
#include "ui/text/notation.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace slidercrank
{

/// A row of the table of limits: a value, with the crank angle at which it occurs or with a remark.
struct MotionFact {
    LimitKind kind = LimitKind::Stroke;
    QString name = {};
    double number = 0.0; ///< the value at full precision, in `unit`; infinite if it is unbounded
    QString unit = {};   ///< empty if the value is a ratio
    QString explanation = {};
    std::optional<double> theta2 = {}; ///< rad
    QString remark = {};               ///< instead of the crank angle
    std::optional<double> time = {};   ///< first time at which the crank has this angle, s
};

/// Says that the velocities jump at the position that is shown (velocitiesJumpAt()).
QString jumpSentence();

/// States whether the crank can make full turns, with the inequality that decides it.
QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits);

/// Returns a lower limit of a length (mm) with its unit, rounded up to six digits so that the rounded value satisfies
/// the limit.
QString atLeastText(double limit);

/// Describes the limits in the order of findLimits().
std::vector<MotionFact> motionFacts(const Mechanism &mechanism, const MotionLimits &motion, const Sampling &sampling,
                                    const Notation &notation = {});

/// Returns the name of a limit in the current language: "stroke", "peak slider velocity".
QString limitName(LimitKind kind);

/// Returns the first time (s) within the time range at which the crank has the angle of the limit.
std::optional<double> timeOf(const Limit &limit, const Mechanism &mechanism, const Sampling &sampling);

/// Returns a table of the facts. The first row contains the headings.
std::vector<QStringList> limitTable(const std::vector<MotionFact> &facts);

/// Formats the value with its unit.
QString valueText(const MotionFact &fact, int digits = kUsualDigits);

/// Returns the crank angle in degrees, from 0 to 360. `theta2`: rad.
double degreesFromZero(double theta2);

/// Returns the crank angle in the chosen unit, from 0 to a whole turn. `theta2`: rad.
double shownCrankAngle(double theta2);

/// Return shownCrankAngle() as a text: "30.00", and with its unit: "30.00°".
QString crankAngleText(double theta2);
QString crankAngleWithUnit(double theta2);

/// Returns a warning if the samples are too few to draw the motion; otherwise an empty string.
QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &sampling);

/// Returns a sentence that says why a time step has no solution, or only a part of it; empty for Status::Solved.
QString statusSentence(Status status, const NewtonOptions &options);

/// Returns "95 in total, at most 4 at a time step", over the time steps that Newton-Raphson solved, or a dash if it
/// solved none.
QString iterationsText(const SamplingSummary &summary);

} // namespace slidercrank
