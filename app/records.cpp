// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records.h"

#include "ui/text/language.h"
#include "ui/text/written_number.h"

#include <QLocale>

#include <algorithm>

namespace slidercrank
{

QString recordTable(const std::vector<Column> &columns, const std::vector<Record> &records)
{
    std::vector<QStringList> rows(records.size() + 1);
    for (const Column &column : columns) {
        rows[0] += column.heading;
        for (std::size_t i = 0; i < records.size(); ++i) {
            const QJsonValue value = jsonObject(records[i])[QLatin1String(column.key)];
            rows[i + 1] += value.isDouble() ? roundedText(value.toDouble(), column.digits) : value.toString(dash());
        }
    }
    return alignedTable(rows);
}

QString alignedTable(const std::vector<QStringList> &rows)
{
    std::vector<QString> lines(rows.size());
    for (qsizetype column = 0; column < rows[0].size(); ++column) {
        qsizetype width = 0;
        bool isText = false;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QString &cell = rows[i][column];
            width = std::max(width, cell.size());
            isText = isText || (i > 0 && !cell.isEmpty() && cell[0].isLetter());
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QString &cell = rows[i][column];
            lines[i] += (isText ? cell.leftJustified(width) : cell.rightJustified(width)) + "  ";
        }
    }
    QString table;
    for (const QString &line : lines) {
        table += line.trimmed() + '\n';
    }
    return table;
}

QString roundedText(std::optional<double> value, int digits)
{
    return value ? typedNumberText(QString::number(*value, 'g', digits).toDouble()) : dash();
}

QJsonValue jsonText(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

void useLanguageOf(Format format)
{
    if (format != Format::Text) {
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }
}

} // namespace slidercrank
