// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace slidercrank
{

/// Returns the text with control characters written as "\x1b", and also those that reverse the direction of writing.
/// Names of files and headings may contain any character: a terminal would obey escape sequences, and an SVG with
/// control characters is not well-formed. Tabs and line feeds are kept.
QString printableText(const QString &text);

/// Does the same with a text that is to stay in one line: writes tabs and line feeds as "\x0a", too.
QString printableLine(const QString &text);

} // namespace slidercrank
