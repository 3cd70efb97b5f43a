// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank study`: speed against error as a table, CSV or JSON.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus study(const StudyOptions &options);

} // namespace slidercrank
