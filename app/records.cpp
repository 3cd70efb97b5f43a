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
    if (value.isString()) {
        static const QRegularExpression needsQuotes("[,\"\n ]");
        QString text = value.toString();
        return (text.contains(needsQuotes) ? '"' + text.replace("\"", "\"\"") + '"' : text).toUtf8();
    }
    if (!value.isDouble()) {
        return {};
    }
    constexpr double kLargestInDigits = 1e15;
    const double number = value.toDouble();
    const bool isWhole = std::abs(number) < kLargestInDigits && number == std::trunc(number); // a count has no exponent
    return isWhole ? QByteArray::number(value.toInteger())
                   : QByteArray::number(number, 'g', QLocale::FloatingPointShortest);
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
            rows[i + 1] +=
                value.isString()
                    ? value.toString()
                    : roundedText(value.isDouble() ? std::optional(value.toDouble()) : std::nullopt, column.digits);
        }
        isNumeric.push_back(!isText);
    }
    return alignedTable(rows, isNumeric);
}

QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isNumeric)
{
    QString table;
    for (const QStringList &row : rows) {
        QString line;
        for (qsizetype column = 0; column < row.size(); ++column) {
            const auto width = [column](const QStringList &cells) { return cells[column].size(); };
            const qsizetype widest = width(*std::ranges::max_element(rows, {}, width));
            line += isNumeric[static_cast<std::size_t>(column)] ? row[column].rightJustified(widest)
                                                                : row[column].leftJustified(widest);
            line += "  ";
        }
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
    return exists ? QJsonValue(*value == 0.0 ? 0.0 : *value) : QJsonValue(); // 0 without a sign
}

QJsonValue jsonText(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

QJsonObject jsonMechanism(const Parameters &parameters)
{
    QJsonObject object{{"branch", parameters.branch == Branch::Open ? "open" : "crossed"}};
    for (const Parameter parameter : kParameters) {
        object.insert(QLatin1String(wordOf(parameter)), jsonNumber(valueOf(parameters, parameter)));
    }
    return object;
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
