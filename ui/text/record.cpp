// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/record.h"

#include <QJsonDocument>
#include <QRegularExpression>
#include <QVariant>

#include <cmath>

namespace slidercrank
{

namespace
{

QByteArray csvCell(const QJsonValue &value)
{
    static const QRegularExpression needsQuotes("[,\"\n ]");
    QString text = value.toVariant().toString(); // the shortest number that reads back the same
    return (text.contains(needsQuotes) ? '"' + text.replace("\"", "\"\"") + '"' : text).toUtf8();
}

} // namespace

QJsonObject jsonObject(const Record &record)
{
    QJsonObject object;
    for (const auto &[key, value] : record) {
        object.insert(key, value);
    }
    return object;
}

QByteArray csvText(const std::vector<Record> &records)
{
    QByteArrayList lines;
    for (const Record &record : records) {
        QByteArrayList keys, cells;
        for (const auto &[key, value] : record) {
            keys += key.toUtf8();
            cells += csvCell(value);
        }
        if (lines.isEmpty()) {
            lines += keys.join(',') + '\n';
        }
        lines += cells.join(',') + '\n';
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
