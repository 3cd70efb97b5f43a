// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables of sentences, with one row for each enumerator.

#include "core/mechanism/enum_table.h"

namespace slidercrank
{

/// A row with nothing but a sentence.
template <typename Enum>
struct EnumText {
    Enum key;
    const char *text; ///< untranslated
};

} // namespace slidercrank
