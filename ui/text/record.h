// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A record is a list of keys and values. It can be written as a JSON object and as a line of CSV.

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QJsonValue>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace slidercrank
{

/// Keys and values in the order of CSV. A value that does not exist is null.
using Record = std::vector<std::pair<QString, QJsonValue>>;

QJsonObject jsonObject(const Record &record);

enum class CsvSeparators {
    Standard,  ///< decimal point and comma
    OfLanguage ///< the decimal sign of the language, and a semicolon if that is a comma
};

/// The separators of the files and of the clipboard that the window writes.
CsvSeparators csvSeparators();
void setCsvSeparators(CsvSeparators separators);

/// Returns the delimiter between the cells of a line.
QChar delimiter(CsvSeparators separators);

/// Returns a line of keys and a line for each record. Numbers have as few digits as read back the same number.
QByteArray csvText(const std::vector<Record> &records, CsvSeparators separators = CsvSeparators::Standard);

/// Returns null if there is no value, or if it is not finite.
QJsonValue jsonNumber(std::optional<double> value);

/// Converts each element of a range by `toJson`.
template <typename Range, typename ToJson>
QJsonArray jsonList(const Range &range, ToJson toJson)
{
    QJsonArray array;
    for (const auto &element : range) {
        array += toJson(element);
    }
    return array;
}

/// Returns a JSON document of one line.
QByteArray jsonDocument(const QJsonObject &object);

} // namespace slidercrank
