// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_output.h"

#include "app/output.h"
#include "ui/text/language.h"
#include "ui/text/printable_text.h"

#include <QLocale>

#include <algorithm>

namespace slidercrank
{

namespace
{

QByteArray bytesOf(const CommandOutput &output, OutputFormat format)
{
    switch (format) {
    case OutputFormat::Text: break;
    case OutputFormat::Csv: return csvText(output.rows);
    case OutputFormat::Json: return jsonDocument(output.json);
    }
    return printableText(output.text).toUtf8();
}

} // namespace

Request::Request(const OptionReader &options)
    : mechanism(readMechanism(options))
    , format(options.choice("format", OutputFormat::Text))
    , outputPath(readOutput(options))
{
    if (format != OutputFormat::Text) {
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }
}

ExitStatus Request::write(const Streams &streams, const CommandOutput &output) const
{
    const QByteArray bytes = bytesOf(output, format);
    return bytes.isEmpty() ? output.status : moreSevere(output.status, writeOutput(streams, outputPath, bytes));
}

QStringList alignedLines(const std::vector<QStringList> &rows)
{
    QStringList lines(static_cast<qsizetype>(rows.size()));
    for (qsizetype column = 0; column < rows.front().size(); ++column) {
        qsizetype width = 0;
        for (const QStringList &row : rows) {
            width = std::max(width, row[column].size());
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QString &cell = rows[i][column];
            lines[static_cast<qsizetype>(i)] +=
                (column == 0 ? cell.leftJustified(width) : cell.rightJustified(width)) + "  ";
        }
    }
    for (QString &line : lines) {
        line = line.trimmed();
    }
    return lines;
}

QString alignedTable(const std::vector<QStringList> &rows)
{
    return alignedLines(rows).join(u'\n') + u'\n';
}

QJsonValue jsonText(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

} // namespace slidercrank
