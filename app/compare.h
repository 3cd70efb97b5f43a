// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank compare`: how far simulations' files are from the exact motion, as tables, CSV or JSON.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus compareFiles(const CompareOptions &options);

} // namespace slidercrank
