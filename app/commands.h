// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The subcommands. Each function reads and checks all options, throws UsageError if one of them is wrong, and returns
// the command that is to be run.

#include "app/command_line.h"

namespace slidercrank
{

class OptionReader;

Command prepareWindow(OptionReader &options);
Command prepareSolve(OptionReader &options);    ///< writes the motion as CSV or JSON
Command prepareLimits(OptionReader &options);   ///< prints dead centres, stroke, transmission angle and peak values
Command prepareCompare(OptionReader &options);  ///< prints how far reference files are from the model
Command prepareIdentify(OptionReader &options); ///< finds the mechanism that each reference file belongs to
Command prepareStudy(OptionReader &options);    ///< measures speed and error of every method
Command prepareRender(OptionReader &options);   ///< draws what the window shows into a file

} // namespace slidercrank
