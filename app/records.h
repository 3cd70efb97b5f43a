// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A record is described once, by the list of its fields; its JSON object, its line of CSV and its line in a table of
// text follow from that list.

#include "core/mechanism/mechanism.h"

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

/// Keys and values in the order of CSV; null for a value that does not exist.
using Record = std::vector<std::pair<QString, QJsonValue>>;

QJsonObject jsonObject(const Record &record);

/// A heading and a line for each record, with the shortest numbers that read back the same.
QByteArray csvText(const std::vector<Record> &records);

/// A column of a table of text.
struct Column {
    const char *key;
    QString heading;
    int digits = 3; ///< significant digits of a number
};
QString recordTable(const std::vector<Column> &columns, const std::vector<Record> &records);

/// Columns as wide as their widest cell; a column is right-aligned if `isNumeric` says so.
QString alignedTable(const std::vector<QStringList> &rows, const std::vector<bool> &isNumeric);

/// The number as it is typed, 5.03e-6; a dash for what does not exist.
QString roundedText(std::optional<double> value, int digits = 3);

QJsonValue jsonNumber(std::optional<double> value);
QJsonValue jsonText(const QString &text); ///< null for an empty text

template <typename Range, typename ToJson>
QJsonArray jsonList(const Range &range, ToJson toJson)
{
    QJsonArray array;
    for (const auto &element : range) {
        array += toJson(element);
    }
    return array;
}

/// {"a", "b", "c", "omega2", "theta20", "branch"} in mm, rad and s.
QJsonObject jsonMechanism(const Parameters &parameters);

/// A JSON document in one line.
QByteArray jsonDocument(const QJsonObject &object);

/// While one exists, texts are English and their numbers have decimal points: JSON and CSV are the same in every
/// language.
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
