// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The commands. Each function reads and checks all of its options before it writes anything, and throws UsageError if
// one of them is wrong.

#include "app/command_line.h"

namespace slidercrank
{

class OptionReader;

/// Throws UsageError unless the window can open the argument: a file that exists, or a link with a scene.
void requireFile(const QString &argument);

ExitStatus windowCommand(const OptionReader &options, const Streams &streams); ///< opens the window
ExitStatus solveCommand(const OptionReader &options, const Streams &streams);  ///< the motion as CSV or JSON
ExitStatus limitsCommand(const OptionReader &options, const Streams &streams); ///< dead centres, stroke, peak values …
ExitStatus compareCommand(const OptionReader &options, const Streams &streams);  ///< reference files against the model
ExitStatus identifyCommand(const OptionReader &options, const Streams &streams); ///< the mechanism of reference files
ExitStatus checkCommand(const OptionReader &options, const Streams &streams);    ///< a calculation by hand
ExitStatus studyCommand(const OptionReader &options, const Streams &streams);    ///< speed and error of every method
ExitStatus renderCommand(const OptionReader &options, const Streams &streams);   ///< pictures, frames and reports

} // namespace slidercrank
