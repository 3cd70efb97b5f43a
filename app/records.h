// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A record is a list of keys and values. It can be written as a JSON object, as a line of CSV, and as a row of a table
// of text.

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

/// Returns a line of keys and a line for each record. Numbers have as few digits as read back the same number.
QByteArray csvText(const std::vector<Record> &records);

/// A column of a table of text.
struct Column {
    const char *key;
    QString heading;
    int digits = 3; ///< significant digits of a number
};

/// Columns of numbers are right-aligned.
QString recordTable(const std::vector<Column> &columns, const std::vector<Record> &records);

/// Returns the cells in columns that are as wide as their widest cell.
QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isRightAligned);

/// Formats a number as one would type it, such as 5.03e-6; a dash if there is none.
QString roundedText(std::optional<double> value, int digits = 3);

/// Null if there is no value, or if it is not finite.
QJsonValue jsonNumber(std::optional<double> value);

/// Null if the text is empty.
QJsonValue jsonText(const QString &text);

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

/// While this object exists, texts are in English and numbers in them have decimal points. JSON and CSV are written so,
/// and are the same in every language.
class EnglishTexts
{
public:
    explicit EnglishTexts(bool isNeeded);
    ~EnglishTexts();
    Q_DISABLE_COPY_MOVE(EnglishTexts)

private:
    bool m_isNeeded;
};

} // namespace slidercrank
