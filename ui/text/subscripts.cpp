// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/subscripts.h"

#include <QRegularExpression>
#include <QTextOption>
#include <QTransform>

namespace slidercrank
{

QString subscriptHtml(const QString &text)
{
    static const QRegularExpression kSubscript("_([A-Za-z]+)");
    return text.toHtmlEscaped().replace(kSubscript, "<sub>\\1</sub>");
}

QString symbolHtml(const QString &sentence)
{
    static const QRegularExpression kSymbol("(?<![A-Za-z0-9_])([xvaAGR])_(B|[AG]?[xy])(?![A-Za-z0-9_])");
    return sentence.contains(kSymbol)
               ? sentence.toHtmlEscaped().replace(kSymbol, "\\1<sub>\\2</sub>").replace(u'\n', QStringLiteral("<br>"))
               : sentence;
}

QStaticText withSubscripts(const QString &line, const QFont &font)
{
    QStaticText text;
    text.setTextFormat(Qt::PlainText);
    text.setText(line);
    if (line.contains(u'_')) {
        text.setTextFormat(Qt::RichText);
        text.setText(subscriptHtml(line));
        QTextOption oneLine;
        oneLine.setWrapMode(QTextOption::NoWrap);
        text.setTextOption(oneLine);
    }
    text.prepare(QTransform(), font);
    return text;
}

} // namespace slidercrank
