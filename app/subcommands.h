// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What each subcommand does, once its options are read.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

/// The trajectory as CSV or JSON.
ExitStatus solve(const SolveOptions &options);

/// What bounds the motion: dead centres, stroke, transmission angle, peaks; as text, CSV or JSON.
ExitStatus limits(const LimitsOptions &options);

/// How far simulations' files are from the exact motion, as tables, CSV or JSON.
ExitStatus compareFiles(const CompareOptions &options);

/// The mechanism that each of some simulations' files belongs to, as text or JSON.
ExitStatus identifyFiles(const IdentifyOptions &options);

/// Speed against error as a table, CSV or JSON.
ExitStatus study(const StudyOptions &options);

/// What the window shows, drawn into a file by the window's own rooms. Needs a QApplication.
ExitStatus render(const RenderOptions &options);

} // namespace slidercrank
