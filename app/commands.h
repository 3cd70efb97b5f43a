// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The subcommands. Each function reads its options completely, throws UsageError if one is wrong, and returns what is
// then to be run.

#include "app/command_line.h"

namespace slidercrank
{

class OptionReader;

Command prepareWindow(OptionReader &options);

/// The arguments without the options that Qt reads itself, such as "-platform offscreen". Qt takes them with one dash
/// or two.
QStringList withoutWindowSystemOptions(const QStringList &arguments);

/// Whether an option of Qt selects the display.
bool choosesPlatform(const QStringList &arguments);

Command prepareSolve(OptionReader &options);    ///< the motion as CSV or JSON
Command prepareLimits(OptionReader &options);   ///< dead centres, stroke, transmission angle, peak values
Command prepareCompare(OptionReader &options);  ///< how far reference files are from the model
Command prepareIdentify(OptionReader &options); ///< the mechanism that each reference file belongs to
Command prepareStudy(OptionReader &options);    ///< speed against error
Command prepareRender(OptionReader &options);   ///< what the window shows, drawn into a file

} // namespace slidercrank
