// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records.h"

#include "ui/text/finding_text.h"
#include "ui/text/language.h"
#include "ui/text/written_number.h"

#include <QJsonDocument>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
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

QString recordTable(const std::vector<Column> &columns, const std::vector<Record> &records)
{
    std::vector<QStringList> rows(records.size() + 1);
    std::vector<bool> isNumeric;
    for (const Column &column : columns) {
        rows[0] += column.heading;
        bool isText = false;
        for (std::size_t i = 0; i < records.size(); ++i) {
            const QJsonValue value = jsonObject(records[i])[QLatin1String(column.key)];
            isText = isText || value.isString();
            const std::optional<double> number = value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
            rows[i + 1] += value.isString() ? value.toString() : roundedText(number, column.digits);
        }
        isNumeric.push_back(!isText);
    }
    return alignedTable(rows, isNumeric);
}

QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isRightAligned)
{
    std::vector<QString> lines(rows.size());
    for (std::size_t column = 0; !rows.empty() && column < isRightAligned.size(); ++column) {
        const auto cell = [column](const QStringList &row) { return row[static_cast<qsizetype>(column)]; };
        const auto width = [cell](const QStringList &row) { return cell(row).size(); };
        const qsizetype widest = width(*std::ranges::max_element(rows, {}, width));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            lines[i] +=
                isRightAligned[column] ? cell(rows[i]).rightJustified(widest) : cell(rows[i]).leftJustified(widest);
            lines[i] += "  ";
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

QJsonValue jsonNumber(std::optional<double> value)
{
    const bool exists = value && std::isfinite(*value);
    return exists ? QJsonValue(*value == 0.0 ? 0.0 : *value) : QJsonValue(); // without the sign of a negative zero
}

QJsonValue jsonText(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

QByteArray jsonDocument(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

EnglishTexts::EnglishTexts(bool isNeeded)
    : m_isNeeded(isNeeded)
{
    if (m_isNeeded) {
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }
}

EnglishTexts::~EnglishTexts()
{
    if (m_isNeeded) {
        setLanguage(Language::System);
    }
}

} // namespace slidercrank
