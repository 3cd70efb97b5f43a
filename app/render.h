// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `slidercrank render`: what the window shows, drawn into a file by the window's own rooms. Needs a QApplication.

#include "app/command_line.h"
#include "app/options.h"

namespace slidercrank
{

ExitStatus render(const RenderOptions &options);

} // namespace slidercrank
