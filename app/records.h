// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A record is described once, by a list of its fields; from that list follow its JSON object, its row of CSV and its row in a
// table of text.

#include "core/mechanism/mechanism.h"

#include <QByteArray>
#include <QJsonObject>
#include <QJsonValue>
#include <QString>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace slidercrank
{

template <typename Record>
struct Field {
    using Value = std::function<QJsonValue(const Record &)>;
    using Cell = std::function<QString(const Record &)>;

    Field(const char *fieldKey, const Value &fieldValue, const QString &tableHeading = {}, const Cell &tableCell = {})
        : key(fieldKey)
        , value(fieldValue)
        , heading(tableHeading)
        , cell(tableCell)
    {
    }

    const char *key; ///< in JSON and CSV
    Value value;     ///< null, or NaN, for what does not exist
    QString heading; ///< of the table; empty: the field is not in the table
    Cell cell;       ///< in the table; none: the value with three significant digits
};

template <typename Record>
using Fields = std::vector<Field<Record>>;

/// The shortest number that reads back the same, quoted text, or nothing for what does not exist.
QByteArray csvCell(const QJsonValue &value);

/// Columns as wide as their widest cell; a column is right-aligned if `isNumeric` says so.
QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isNumeric);

/// Three significant digits as they are typed, 5.03e-6; a dash for what does not exist.
QString roundedText(std::optional<double> value, int digits = 3);

QJsonValue jsonNumber(std::optional<double> value);

/// {"a", "b", "c", "omega2", "theta20", "branch"} in mm, rad and s.
QJsonObject jsonMechanism(const Parameters &parameters);

/// A JSON document in one line.
QByteArray jsonText(const QJsonObject &object);

/// While one exists, texts are English and their numbers have decimal points: JSON and CSV are the same in every language.
class EnglishTexts
{
public:
    explicit EnglishTexts(bool isNeeded);
    ~EnglishTexts();
    Q_DISABLE_COPY_MOVE(EnglishTexts)

private:
    bool m_isNeeded;
};

template <typename Record>
QJsonObject jsonRecord(const Fields<Record> &fields, const Record &record)
{
    QJsonObject object;
    for (const Field<Record> &field : fields) {
        object.insert(QLatin1String(field.key), field.value(record));
    }
    return object;
}

template <typename Record>
QByteArray csvHeading(const Fields<Record> &fields)
{
    QByteArrayList cells;
    for (const Field<Record> &field : fields) {
        cells += field.key;
    }
    return cells.join(',');
}

template <typename Record>
QByteArray csvRecord(const Fields<Record> &fields, const Record &record)
{
    QByteArrayList cells;
    for (const Field<Record> &field : fields) {
        cells += csvCell(field.value(record));
    }
    return cells.join(',');
}

template <typename Record>
QString recordTable(const Fields<Record> &fields, const std::vector<Record> &records)
{
    std::vector<QStringList> rows(records.size() + 1);
    std::vector<bool> isNumeric;
    for (const Field<Record> &field : fields) {
        if (field.heading.isEmpty()) {
            continue;
        }
        rows[0] += field.heading;
        isNumeric.push_back(!records.empty() && !field.value(records.front()).isString());
        for (std::size_t i = 0; i < records.size(); ++i) {
            const QJsonValue value = field.value(records[i]);
            rows[i + 1] += field.cell        ? field.cell(records[i])
                           : value.isString() ? value.toString()
                           : value.isDouble() ? roundedText(value.toDouble())
                                              : roundedText(std::nullopt);
        }
    }
    return alignedTable(rows, isNumeric);
}

} // namespace slidercrank
