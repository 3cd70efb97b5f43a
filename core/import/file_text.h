// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// First stage of reading: from the bytes of a file to text in UTF-8.

#include "core/import/read_fault.h"

#include <string>
#include <string_view>

namespace slidercrank
{

/// Decodes the bytes of a file. Returns the text without byte order mark, which refers to the bytes or to `converted`.
/// A byte order mark determines the encoding. Otherwise it is UTF-8, or if most bytes outside ASCII are not valid
/// UTF-8, a code page of Windows: 1252 (which includes Latin-1), 1250 for Polish, or 1251 for Russian. The lines of a
/// table drawn with box characters become "|", "-" and "+". Throws ReadError if the bytes are not text, or text of
/// a format other than a table.
std::string_view decodeText(std::string_view bytes, std::string &converted);

} // namespace slidercrank
