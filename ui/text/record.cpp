// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/record.h"

#include <QJsonDocument>
#include <QLocale>
#include <QRegularExpression>
#include <QVariant>

#include <cmath>

namespace slidercrank
{

namespace
{

QByteArray csvCell(const QJsonValue &value, CsvSeparators separators)
{
    static const QRegularExpression needsQuotes("[,\"\n ]");
    QString text = value.toVariant().toString(); // the shortest number that reads back the same
    if (value.isDouble()) {
        return (separators == CsvSeparators::Standard ? text : text.replace('.', QLocale().decimalPoint())).toUtf8();
    }
    return (text.contains(needsQuotes) || text.contains(delimiter(separators)) ? '"' + text.replace("\"", "\"\"") + '"'
                                                                               : text)
        .toUtf8();
}

CsvSeparators &chosenSeparators()
{
    static CsvSeparators separators = CsvSeparators::Standard;
    return separators;
}

} // namespace

CsvSeparators csvSeparators()
{
    return chosenSeparators();
}

void setCsvSeparators(CsvSeparators separators)
{
    chosenSeparators() = separators;
}

QChar delimiter(CsvSeparators separators)
{
    const bool isSemicolon = separators == CsvSeparators::OfLanguage && QLocale().decimalPoint() == u",";
    return isSemicolon ? u';' : u',';
}

QJsonObject jsonObject(const Record &record)
{
    QJsonObject object;
    for (const auto &[key, value] : record) {
        object.insert(key, value);
    }
    return object;
}

QByteArray csvText(const std::vector<Record> &records, CsvSeparators separators)
{
    const char between = delimiter(separators).toLatin1();
    QByteArrayList lines;
    for (const Record &record : records) {
        QByteArrayList keys, cells;
        for (const auto &[key, value] : record) {
            keys += key.toUtf8();
            cells += csvCell(value, separators);
        }
        if (lines.isEmpty()) {
            lines += keys.join(between) + '\n';
        }
        lines += cells.join(between) + '\n';
    }
    return lines.join();
}

QJsonValue jsonNumber(std::optional<double> value)
{
    const bool exists = value && std::isfinite(*value);
    return exists ? QJsonValue(*value == 0.0 ? 0.0 : *value) : QJsonValue(); // without the sign of a negative zero
}

QByteArray jsonDocument(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

} // namespace slidercrank
