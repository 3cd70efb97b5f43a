// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Decodes the headings of tables in Chinese and Japanese, as Excel and programs for laboratories write them on Windows.

#include <string>
#include <string_view>

namespace slidercrank
{

// A character outside ASCII has two bytes in GBK (GB 2312, GB 18030) and in Shift-JIS. Only the characters in the
// vocabulary of headings are known. No code of these characters means a different one of them in the other encoding, so
// that the encoding need not be determined.

/// Returns whether a text is in one of these encodings: at least two of its characters outside ASCII are known, and
/// more than a third of them.
bool isDoubleByteText(std::string_view bytes);

/// Converts a text in one of these encodings to UTF-8. Unknown characters become 〓.
std::string decodeDoubleBytes(std::string_view bytes);

} // namespace slidercrank
