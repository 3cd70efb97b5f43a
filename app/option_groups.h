// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The groups of options that several commands share. All functions throw UsageError.

#include "app/option_reader.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"

#include <optional>
#include <vector>

namespace slidercrank
{

enum class Format { Text, Csv, Json };

QStringList channelNames();

/// The unit of a number that is given without one.
Unit unitOf(Parameter parameter);

Mechanism readMechanism(const OptionReader &options);
Sampling readSampling(const OptionReader &options);
SolverSettings readSolver(const OptionReader &options);
Format readFormat(const OptionReader &options, Format defaultFormat);

/// The time stamp that --at or --at-angle asks for (s), if one of them is given; angles count from `start` on.
std::optional<double> readTimeStamp(const OptionReader &options, const Mechanism &mechanism, double start);

/// --column and --abscissa.
std::vector<NamedChoice> readColumns(const OptionReader &options);

/// --output, which must be none of the files that are read. Empty: standard output.
QString readOutput(const OptionReader &options, const QStringList &inputFiles = {});

void refuseFiles(const OptionReader &options);

} // namespace slidercrank
