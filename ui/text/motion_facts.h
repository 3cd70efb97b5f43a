// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said about the limits of a motion, in words and numbers with units: why the crank turns round or does not,
// where the slider turns back, how fast slider and coupler ever get.

#include "core/limits/extremes.h"
#include "core/limits/mobility.h"
#include "core/sampling/trajectory.h"

#include <QString>

#include <optional>
#include <vector>

namespace slidercrank
{

/// A row of a table: a value at a crank angle, or one with a remark.
struct MotionFact {
    QString name;
    QString value;
    double number = 0.0; ///< the same, every digit, in the unit
    QString unit;        ///< empty: a ratio
    QString explanation;
    std::optional<double> theta2; ///< rad
    QString remark;
    std::optional<double> instant; ///< s, where the run first comes to that crank angle
};

/// Whether the crank turns round, with the numbers of the inequality that decides it, and what would help.
QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits);

/// The length that it takes (mm, without the unit), shortened so that one typed as it stands will do.
QString atLeastText(double limit);

/// Dead centres, the ends of a rocker, the stroke and its times, the transmission angle.
std::vector<MotionFact> positionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &run);

std::vector<MotionFact> peakFacts(const Mechanism &mechanism, const MotionLimits &limits,
                                  const std::vector<Peak> &peaks, const Sampling &run);

/// That the samples are too few for a line through them to be the motion, and how many steps would do; empty where they
/// are not.
QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &run);

/// "95 in all, at most 4 an instant", over the instants that Newton-Raphson found; a dash where it found none.
QString iterationsText(const SamplingSummary &run, const NewtonOptions &options);

/// Within [0, 360), in degrees, without the unit.
QString crankAngleText(double radians);

/// An instant of a run, or a time, of that length (s), without the unit: of the same decimals for all of a run.
QString secondsText(double seconds, double length);

} // namespace slidercrank
