// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank compare`: how far a simulation's file is from the exact motion, as a table, CSV or JSON.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus compareFile(const CompareOptions &options);

} // namespace slidercrank
