// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads or writes JSON values. A function describe(value, node) does both for a type: here for the types of single
// values and lists, in settings_fields.h for structs of settings.
//
// Whatever is missing or not valid is read as another value, which is valid. So JSON is valid if writing what was read
// gives the same JSON again.

#include "core/mechanism/channel.h"
#include "ui/text/interval.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Names of the enumerators in files, in the order of the enumerators.
using EnumNames = std::initializer_list<const char *>;

/// A JSON value that is read or written.
struct JsonNode {
    bool isReading = false;
    QJsonValue value = {};

    /// Writes `standard` and returns it; or returns the value that is read, and `standard` if its type is another one.
    QJsonValue exchange(const QJsonValue &standard);

    /// Describes a field of an object by fill(JsonNode &).
    void field(const char *name, const std::function<void(JsonNode &)> &fill);

    template <typename Value, typename... Limits>
    void operator()(const char *name, Value &member, const Limits &...limits)
    {
        field(name, [&](JsonNode &node) { describe(member, node, limits...); });
    }

    template <typename Enum>
    void operator()(const char *name, Enum &member, EnumNames names)
    {
        operator()<Enum, EnumNames>(name, member, names);
    }
};

void describe(bool &value, JsonNode &node);
void describe(QString &value, JsonNode &node);
void describe(double &value, JsonNode &node, double smallest = -kLargestParameter, double largest = kLargestParameter);
void describe(int &value, JsonNode &node, int largest); ///< from 1 to `largest`
void describe(QStringList &list, JsonNode &node);       ///< one string, or a list of several
void describe(Channel &channel, JsonNode &node);
void describe(Interval &interval, JsonNode &node); ///< a list of its two ends
void describe(QRectF &rectangle, JsonNode &node);  ///< a list of its left, top, right and bottom edges

bool isValid(const Interval &interval);
bool isValid(const QRectF &rectangle);

template <typename Enum>
void describe(Enum &value, JsonNode &node, EnumNames names)
{
    const QString name = node.exchange(QLatin1String(names.begin()[static_cast<std::size_t>(value)])).toString();
    const auto match = std::find(names.begin(), names.end(), name);
    value = match == names.end() ? value : static_cast<Enum>(match - names.begin());
}

/// A value that may be missing or null.
template <typename Value>
void describe(std::optional<Value> &value, JsonNode &node)
{
    if (value || !(node.value.isUndefined() || node.value.isNull())) {
        describe(value ? *value : value.emplace(), node);
        value = isValid(*value) ? value : std::nullopt;
    } else {
        node.value = QJsonValue();
    }
}

template <typename Item, typename... Limits>
void describe(std::vector<Item> &list, JsonNode &node, const Limits &...limits)
{
    const QJsonArray read = node.value.toArray();
    list.resize(node.isReading ? static_cast<std::size_t>(read.size()) : list.size());
    QJsonArray array;
    for (Item &item : list) {
        JsonNode element{node.isReading, read.at(array.size())};
        describe(item, element, limits...);
        array += element.value;
    }
    node.value = array;
}

} // namespace slidercrank
