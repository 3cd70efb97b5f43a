// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which encoding a text file is in, and the same text in UTF-8.

#include "core/import/file_layout.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace slidercrank
{

struct EncodingFound {
    TextEncoding encoding = TextEncoding::Utf8;
    std::size_t markLength = 0; ///< bytes of the byte order mark; 0: none
};

/// By the byte order mark; else UTF-16 by its zero bytes; else UTF-8, unless more of its bytes beyond ASCII are broken
/// than sound: then Windows-1252, which holds Latin-1.
EncodingFound findEncoding(std::string_view bytes);

/// Bytes without a byte order mark, as text. What is no character becomes U+FFFD.
std::string toUtf8(std::string_view bytes, TextEncoding encoding);

/// The least that a character takes: what stands at another offset than a multiple of this begins none.
std::size_t codeUnitSize(TextEncoding encoding);

/// Bytes that this text was in that encoding, from which toUtf8() made it.
std::size_t sizeIn(TextEncoding encoding, std::string_view text);

/// Where the first byte beyond ASCII stands, from that place on; the size where there is none.
std::size_t findBeyondAscii(std::string_view bytes, std::size_t from);

/// Of a UTF-8 sequence that begins `text`; 0 where none does.
std::size_t sequenceLength(std::string_view text);

} // namespace slidercrank
