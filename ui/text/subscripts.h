// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws symbols such as v_BA with real subscripts, for which Unicode has no letters.

#include <QFont>
#include <QStaticText>
#include <QString>

namespace slidercrank
{

/// Returns the text as HTML in which the letters behind an underscore are a subscript.
QString subscriptHtml(const QString &text);

/// Returns a sentence as HTML in which the symbols of textbooks, such as v_B, have subscripts. Other words with an
/// underscore, such as the heading R4_x of a file, stay as they are. A sentence without such a symbol is returned
/// unchanged, as plain text.
QString symbolHtml(const QString &sentence);

/// Returns a line of text in which the letters behind an underscore are a subscript: "v_BA [mm/s]".
QStaticText withSubscripts(const QString &line, const QFont &font);

} // namespace slidercrank
