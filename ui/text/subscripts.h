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

/// Returns a line of text in which the letters behind an underscore are a subscript: "v_BA [mm/s]".
QStaticText withSubscripts(const QString &line, const QFont &font);

} // namespace slidercrank
