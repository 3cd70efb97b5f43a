// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the groups of options that several commands share. All functions throw UsageError.

#include "app/option_reader.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// Returns the names of all 36 channels.
QStringList channelNames();

/// Parses the value of a parameter in an option. A length without a unit is in mm, a speed in rad/s. An angle needs a
/// unit unless it is 0.
double parseParameter(const char *option, const QString &text, Parameter parameter);

Mechanism readMechanism(const OptionReader &options);
Sampling readSampling(const OptionReader &options);
SolverSettings readSolver(const OptionReader &options);

double readStart(const OptionReader &options); ///< --start, in s

/// Throws with the message if two successive time stamps cannot be distinguished.
void checkTimeSteps(const Sampling &sampling, const QString &message);

/// Returns the first time (s) from --start on at which the crank has the angle theta2 (rad). Throws if it does not
/// reach the angle, or only after a time that cannot be used.
double firstTimeAtAngle(const OptionReader &options, const Mechanism &mechanism, double theta2);

/// Returns the time (s) that --at or --at-angle asks for, or nullopt if neither option is given. An angle stands for
/// the first time from --start on at which the crank has it.
std::optional<double> readTimeStamp(const OptionReader &options, const Mechanism &mechanism);

/// Reads --column and --abscissa.
std::vector<ColumnChoice> readColumns(const OptionReader &options);

/// Reads --output, which must not name an input file. Empty: standard output.
QString readOutput(const OptionReader &options);

} // namespace slidercrank
