// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the limits of a motion: whether and why the crank makes full turns, where the slider reverses, and the peak
// velocities and accelerations of slider and coupler.

#include "core/limits/mobility.h"
#include "core/sampling/trajectory.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A limit that exists for some mechanisms.
struct LimitDescription {
    const char *key; ///< name in JSON and CSV
    const char *unit;
    const char *name;        ///< untranslated
    const char *explanation; ///< untranslated
};

/// The limits in JSON and CSV, in their order.
std::span<const LimitDescription> limitsInFiles();

/// A row of the table of limits: a value, with the crank angle at which it occurs or with a remark.
struct MotionFact {
    std::string_view key = {}; ///< name in JSON and CSV; empty for what only tables show
    QString name = {};
    double number = 0.0; ///< the value at full precision, in `unit`; infinite if it is unbounded
    QString unit = {};   ///< empty if the value is a ratio
    QString explanation = {};
    std::optional<double> theta2 = {}; ///< rad
    QString remark = {};               ///< instead of the crank angle
    std::optional<double> time = {};   ///< first time at which the crank has this angle, s
};

/// States whether the crank can make full turns, with the inequality that decides it.
QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits);

/// Returns a lower limit of a length (mm), rounded up to six digits so that the rounded value satisfies the limit. The
/// text contains no unit.
QString atLeastText(double limit);

/// Returns the dead centres, the limit positions of the crank, the stroke, its times and the transmission angle; then
/// the peaks of motionPeaks(), whose keys begin with "peak", one fact for each place.
std::vector<MotionFact> motionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &sampling);

/// Returns a table of the facts. The first row contains the headings.
std::vector<QStringList> limitTable(const std::vector<MotionFact> &facts);

/// Formats the value with its unit.
QString valueText(const MotionFact &fact, int digits = 6);

/// Return the crank angle in degrees, from 0 to 360, and its text without the unit.
double degreesFromZero(double theta2);
QString crankAngleText(double theta2);

/// Returns a warning if the samples are too few to draw the motion; otherwise an empty string.
QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &sampling);

/// Returns "95 in total, at most 4 at a time step", over the time steps that Newton-Raphson solved, or a dash if it
/// solved none.
QString iterationsText(const SamplingSummary &run);

} // namespace slidercrank
