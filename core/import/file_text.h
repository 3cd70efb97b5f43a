// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// First stage of reading: from the bytes of a file to text in UTF-8.

#include "core/import/read_fault.h"

#include <string>
#include <string_view>

namespace slidercrank
{

/// Decodes the bytes of a file to UTF-8, without the byte order mark. The returned view refers to `bytes`, or to
/// `converted` if the text had to be converted. Encodings: UTF-16 (by its mark, or by its zero bytes); UTF-8 if at
/// least half of the characters outside ASCII are valid; otherwise GBK or Shift-JIS (double_byte_text.h), or
/// Windows-1252, -1250 or -1251. The characters of boxes become "|", "-" and "+". Throws ReadError if the bytes are not
/// text, or text of a format other than a table.
std::string_view decodeText(std::string_view bytes, std::string &converted);

} // namespace slidercrank
