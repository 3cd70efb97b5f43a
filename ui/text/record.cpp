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

/// Returns the value as a cell of CSV, in quotation marks if its text needs them.
QByteArray csvCell(const QJsonValue &value, CsvSeparators separators)
{
    static const QRegularExpression needsQuotes("[,\"\n ]");
    QString text = value.toVariant().toString(); // the shortest number that reads back the same
    if (value.isDouble()) {
        if (separators == CsvSeparators::OfLanguage) {
            text.replace('.', QLocale().decimalPoint());
        }
        return text.toUtf8();
    }
    if (text.contains(needsQuotes) || text.contains(delimiter(separators))) {
        text = '"' + text.replace("\"", "\"\"") + '"';
    }
    return text.toUtf8();
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
    if (!value || !std::isfinite(*value)) {
        return {};
    }
    return *value + 0.0; // the sum turns -0 into 0
}

QByteArray jsonDocument(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

} // namespace slidercrank
