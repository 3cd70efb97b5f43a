// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// First stage of reading: from the bytes of a file to text in UTF-8.

#include "core/import/reference_data.h"

#include <string>
#include <string_view>

namespace slidercrank
{

struct FileText {
    TextEncoding encoding = TextEncoding::Utf8;
    bool byteOrderMark = false;
    std::string converted{}; ///< empty if the bytes are UTF-8

    /// Returns the text without byte order mark. `bytes` have to be those that were decoded.
    std::string_view in(std::string_view bytes) const;
};

/// Decodes the bytes of a file. A byte order mark determines the encoding. Otherwise it is UTF-8, or Windows-1252
/// (which includes Latin-1) if most bytes outside ASCII are not valid UTF-8. Throws ReadError if the bytes are not
/// text, or text of another format than a table.
FileText decodeText(std::string_view bytes);

} // namespace slidercrank
