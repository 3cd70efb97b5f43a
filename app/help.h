// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `--help` prints, and the manual page, both made from the option table.

#include "app/option_table.h"

namespace slidercrank
{

/// In the language in use, in lines of at most 100 characters.
QString helpText(Subcommand subcommand);

/// slidercrank.1 in the format of man(7).
QString manualPage();

} // namespace slidercrank
