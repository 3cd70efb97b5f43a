// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Decodes the headings of tables in Chinese and Japanese, as Excel and programs for laboratories write them on Windows.

#include <optional>
#include <string>
#include <string_view>

namespace slidercrank
{

/// Converts a text in GBK (GB 2312, GB 18030) or Shift-JIS to UTF-8. Two bytes are a character outside ASCII there.
/// Only the characters in the vocabulary of headings are known, whose codes also tell the encoding; the others become
/// 〓. Returns nullopt if too few characters are known.
std::optional<std::string> decodeDoubleBytes(std::string_view bytes);

} // namespace slidercrank
