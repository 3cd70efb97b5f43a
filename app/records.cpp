// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records.h"

#include "ui/text/finding_text.h"
#include "ui/text/language.h"
#include "ui/text/written_number.h"

#include <QJsonDocument>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

QByteArray csvCell(const QJsonValue &value)
{
    if (value.isString()) {
        QString text = value.toString();
        const bool needsQuotes = text.contains(u',') || text.contains(u'"') || text.contains(u'\n') || text.contains(u' ');
        return needsQuotes ? '"' + text.replace(u'"', QStringLiteral("\"\"")).toUtf8() + '"' : text.toUtf8();
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

QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isNumeric)
{
    QString table;
    for (const QStringList &row : rows) {
        QString line;
        for (qsizetype column = 0; column < row.size(); ++column) {
            const auto longest = std::ranges::max_element(rows, {}, [column](const QStringList &each) { return each[column].size(); });
            const qsizetype width = (*longest)[column].size();
            line += isNumeric[static_cast<std::size_t>(column)] ? row[column].rightJustified(width)
                                                                : row[column].leftJustified(width);
            line += QStringLiteral("  ");
        }
        table += line.trimmed() + u'\n';
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

QJsonObject jsonMechanism(const Parameters &parameters)
{
    QJsonObject object;
    for (const Parameter parameter : kParameters) {
        object.insert(QLatin1String(wordOf(parameter)), jsonNumber(valueOf(parameters, parameter)));
    }
    object.insert("branch",
                  parameters.branch == Branch::Open ? QStringLiteral("open") : QStringLiteral("crossed"));
    return object;
}

QByteArray jsonText(const QJsonObject &object)
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
