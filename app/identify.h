// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank identify`: the mechanism that a simulation's file belongs to, as text or JSON.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus identifyFile(const IdentifyOptions &options);

} // namespace slidercrank
