// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads or writes JSON values. A function readOrWrite(value, node) reads the value from the node if node.isReading;
// otherwise it writes the value into the node. The functions for single values and lists are here, those for structs of
// settings in settings_fields.h.
//
// A value that is missing or not valid is replaced by a default, which is valid. So JSON is valid if writing what was
// read gives the same JSON again.

#include "core/mechanism/channel.h"
#include "ui/text/enum_words.h"
#include "ui/text/interval.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <type_traits>
#include <vector>

namespace slidercrank
{

/// A JSON value that is read or written.
struct JsonNode {
    bool isReading = false;
    QJsonValue value = {};

    /// When writing, stores `current` in the node and returns it. When reading, returns the value of the node, or
    /// `current` if the value has a different type.
    QJsonValue exchange(const QJsonValue &current);

    /// Reads or writes a field of the object in this node: calls readOrWriteValue() with a node for the field's value.
    void readOrWriteField(const char *name, const std::function<void(JsonNode &)> &readOrWriteValue);

    /// Reads `member` from the field `name` of the object in this node, or writes it into the field.
    template <typename Value, typename... Limits>
    void operator()(const char *name, Value &member, const Limits &...limits)
    {
        readOrWriteField(name, [&](JsonNode &node) { readOrWrite(member, node, limits...); });
    }
};

void readOrWrite(bool &value, JsonNode &node);
void readOrWrite(QString &value, JsonNode &node);
void readOrWrite(double &value, JsonNode &node, double smallest = -kLargestParameter,
                 double largest = kLargestParameter);
void readOrWrite(int &value, JsonNode &node, int largest); ///< from 1 to `largest`
void readOrWrite(QStringList &list, JsonNode &node);       ///< one string, or a list of several
void readOrWrite(Channel &channel, JsonNode &node);
void readOrWrite(Interval &interval, JsonNode &node); ///< a list of its two ends
void readOrWrite(QRectF &rectangle, JsonNode &node);  ///< a list of its left, top, right and bottom edges

/// Return whether an optional value is kept; otherwise it becomes nullopt.
bool isValid(const Interval &interval);
bool isValid(const QRectF &rectangle);

/// An enumerator as its word in EnumWords.
template <typename Enum>
requires std::is_enum_v<Enum>
void readOrWrite(Enum &value, JsonNode &node)
{
    const auto &rows = EnumWords<Enum>::rows;
    const QString word = node.exchange(QLatin1String(rowOf(rows, value).word)).toString();
    const auto row = std::ranges::find(rows, word, [](const EnumWord<Enum> &each) { return QString(each.word); });
    value = row == std::end(rows) ? value : row->key;
}

/// A value that may be missing or null.
template <typename Value>
void readOrWrite(std::optional<Value> &value, JsonNode &node)
{
    if (value || !(node.value.isUndefined() || node.value.isNull())) {
        readOrWrite(value ? *value : value.emplace(), node);
        value = isValid(*value) ? value : std::nullopt;
    } else {
        node.value = QJsonValue();
    }
}

template <typename Item, typename... Limits>
void readOrWrite(std::vector<Item> &list, JsonNode &node, const Limits &...limits)
{
    const QJsonArray given = node.value.toArray();
    if (node.isReading) {
        list.resize(static_cast<std::size_t>(given.size()));
    }
    QJsonArray array;
    for (Item &item : list) {
        JsonNode element{.isReading = node.isReading, .value = given.at(array.size())};
        readOrWrite(item, element, limits...);
        array += element.value;
    }
    node.value = array;
}

} // namespace slidercrank
