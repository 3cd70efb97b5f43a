// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answer.h"

#include "app/output.h"
#include "ui/text/language.h"
#include "ui/text/printable_text.h"

#include <QLocale>

#include <algorithm>

namespace slidercrank
{

namespace
{

QByteArray bytesOf(const Answer &answer, OutputFormat format)
{
    switch (format) {
    case OutputFormat::Text: break;
    case OutputFormat::Csv: return csvText(answer.rows);
    case OutputFormat::Json: return jsonDocument(answer.json);
    }
    return printableText(answer.text).toUtf8();
}

} // namespace

Question::Question(const OptionReader &options)
    : mechanism(readMechanism(options))
    , format(options.choice("format", OutputFormat::Text))
    , output(readOutput(options))
{
    if (format != OutputFormat::Text) {
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }
}

ExitStatus Question::write(const Streams &streams, const Answer &answer) const
{
    const QByteArray bytes = bytesOf(answer, format);
    return bytes.isEmpty() ? answer.status : moreSevere(answer.status, writeOutput(streams, output, bytes));
}

QString alignedTable(const std::vector<QStringList> &rows)
{
    std::vector<QString> lines(rows.size());
    for (qsizetype column = 0; column < rows[0].size(); ++column) {
        qsizetype width = 0;
        for (const QStringList &row : rows) {
            width = std::max(width, row[column].size());
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QString &cell = rows[i][column];
            lines[i] += (column == 0 ? cell.leftJustified(width) : cell.rightJustified(width)) + "  ";
        }
    }
    QString table;
    for (const QString &line : lines) {
        table += line.trimmed() + '\n';
    }
    return table;
}

QJsonValue jsonText(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

} // namespace slidercrank
