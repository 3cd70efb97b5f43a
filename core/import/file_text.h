// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// First stage of reading: the bytes of a file → text in UTF-8. Throws ReadError where they are no text of a table.

#include "core/import/reference_data.h"

#include <string>
#include <string_view>

namespace slidercrank
{

struct FileText {
    TextEncoding encoding = TextEncoding::Utf8;
    bool byteOrderMark = false;
    std::string converted; ///< empty where the bytes are in UTF-8

    /// The text without byte order mark; `bytes` are those that this was made of.
    std::string_view in(std::string_view bytes) const;
};

/// The encoding is told by the byte order mark; else UTF-16 by its zero bytes; else it is UTF-8, unless more of the
/// bytes beyond ASCII are invalid than valid: then Windows-1252, which holds Latin-1.
FileText decodeText(std::string_view bytes);

} // namespace slidercrank
