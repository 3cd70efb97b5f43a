// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank solve`: the trajectory as CSV or JSON.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus solve(const SolveOptions &options);

} // namespace slidercrank
