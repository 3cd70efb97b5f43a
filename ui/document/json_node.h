// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads or writes JSON values. A function describe(value, node) does both for a type: here for the types of single
// values and lists, in settings_fields.h for structs of settings.

#include "core/mechanism/channel.h"
#include "ui/text/interval.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Names of the enumerators in files, in the order of the enumerators.
using EnumNames = std::initializer_list<const char *>;

/// A JSON value that is read or written. If it is read and missing or null, the described value keeps its default. That
/// is a fault unless the node is optional; lists and std::optional values may always be missing.
class JsonNode
{
public:
    JsonNode() = default; ///< is written

    /// Is read. `fault` becomes the place of the first fault, such as "mechanism.b".
    JsonNode(QString &fault, const QJsonValue &value, const QString &place = {}, bool isOptional = false)
        : m_fault(&fault)
        , m_value(value)
        , m_place(place)
        , m_isOptional(isOptional)
    {
    }

    bool isReading() const { return m_fault; }
    bool hasValue() const { return m_fault && !m_value.isUndefined() && !m_value.isNull(); } ///< to be read
    const QJsonValue &value() const { return m_value; }

    /// Records a fault here, or at the field `name`, if `isValid` is false and the value is read.
    void check(bool isValid, const char *name = "") const;

    /// Writes `value` and returns it, or returns the value that is read if it has the same type.
    QJsonValue exchange(const QJsonValue &value);

    /// Describes a field of an object.
    template <typename Value, typename... Limits>
    void operator()(const char *name, Value &value, const Limits &...limits)
    {
        JsonNode node = field(name, m_isOptional);
        describe(value, node, limits...);
        setField(name, node);
    }

    template <typename Enum>
    void operator()(const char *name, Enum &value, EnumNames names)
    {
        operator()<Enum, EnumNames>(name, value, names);
    }

    /// Describes an optional object, whose fields may be missing, by fill(JsonNode &).
    template <typename Fill>
    void object(const char *name, Fill fill)
    {
        JsonNode node = field(name, true);
        fill(node);
        setField(name, node);
    }

    /// Describes a list.
    template <typename Item, typename... Limits>
    void items(std::vector<Item> &list, const Limits &...limits)
    {
        const QJsonArray read = hasValue() ? exchange(QJsonArray()).toArray() : QJsonArray();
        list.resize(m_fault ? static_cast<std::size_t>(read.size()) : list.size());
        QJsonArray written;
        for (Item &item : list) {
            const qsizetype index = written.size();
            JsonNode node = child(read.at(index), QStringLiteral("%1[%2]").arg(m_place).arg(index), false);
            describe(item, node, limits...);
            written += node.m_value;
        }
        m_value = m_fault ? m_value : written;
    }

private:
    QString placeOf(const char *name) const;
    JsonNode child(const QJsonValue &value, const QString &place, bool isOptional) const;
    JsonNode field(const char *name, bool isOptional) const;
    void setField(const char *name, const JsonNode &node);

    QString *m_fault = nullptr; ///< null if the value is written
    QJsonValue m_value;
    QString m_place;
    bool m_isOptional = false;
};

void describe(bool &value, JsonNode &node);
void describe(QString &value, JsonNode &node);
void describe(double &value, JsonNode &node, double smallest = -kLargestParameter, double largest = kLargestParameter);
void describe(int &value, JsonNode &node, int largest); ///< from 1 to `largest`
void describe(QStringList &value, JsonNode &node);      ///< a string, or a list of strings
void describe(Channel &channel, JsonNode &node);
void describe(Interval &interval, JsonNode &node); ///< a list of its two ends
void describe(QRectF &rectangle, JsonNode &node);  ///< a list of its left, top, right and bottom edges

template <typename Enum>
void describe(Enum &value, JsonNode &node, EnumNames names)
{
    QString name = QLatin1String(names.begin()[static_cast<std::size_t>(value)]);
    describe(name, node);
    const auto match = std::ranges::find_if(names, [&](const char *each) { return name == QLatin1String(each); });
    node.check(match != names.end());
    value = match == names.end() ? value : static_cast<Enum>(match - names.begin());
}

template <typename Value>
void describe(std::optional<Value> &value, JsonNode &node)
{
    if (value || node.hasValue()) {
        describe(value ? *value : value.emplace(), node);
    }
}

template <typename Item>
void describe(std::vector<Item> &list, JsonNode &node)
{
    node.items(list);
}

} // namespace slidercrank
