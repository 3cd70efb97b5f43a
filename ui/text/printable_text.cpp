// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/printable_text.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Returns whether the character changes the direction of the characters that follow it, so that a name can look like
/// another.
bool changesDirection(QChar character)
{
    switch (character.direction()) {
    case QChar::DirLRE:
    case QChar::DirLRO:
    case QChar::DirRLE:
    case QChar::DirRLO:
    case QChar::DirPDF:
    case QChar::DirLRI:
    case QChar::DirRLI:
    case QChar::DirFSI:
    case QChar::DirPDI: return true;
    default: return false;
    }
}

QString withCodes(const QString &text, const QString &kept)
{
    const auto mustBeReplaced = [&kept](QChar character) {
        return (character.category() == QChar::Other_Control && !kept.contains(character)) ||
               changesDirection(character);
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

} // namespace

QString printableText(const QString &text)
{
    return withCodes(text, "\n\t");
}

QString printableLine(const QString &text)
{
    return withCodes(text, {});
}

} // namespace slidercrank
