// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Makes the help and the manual page from the option table.

#include "app/option_table.h"

namespace slidercrank
{

/// Returns the text of `--help` in the current language, in lines of at most 100 characters.
QString helpText(const CommandDescription &command);

/// Returns slidercrank.1 in the format of man(7).
QString manualPage();

} // namespace slidercrank
