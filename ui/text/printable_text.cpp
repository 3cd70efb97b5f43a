// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/printable_text.h"

#include <algorithm>

namespace slidercrank
{

QString printableText(const QString &text)
{
    const auto mustBeReplaced = [](QChar character) {
        return character.category() == QChar::Other_Control && character != u'\n' && character != u'\t';
    };
    if (std::ranges::none_of(text, mustBeReplaced)) {
        return text;
    }
    QString printable;
    for (const QChar character : text) {
        if (mustBeReplaced(character)) {
            printable += QStringLiteral("\\x%1").arg(uint{character.unicode()}, 2, 16, QLatin1Char('0'));
        } else {
            printable += character;
        }
    }
    return printable;
}

} // namespace slidercrank
