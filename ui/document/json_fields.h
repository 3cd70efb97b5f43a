// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the fields of a struct from a JSON object, or writes them into one. The functions describe() in
// settings_fields.h call it for each field.

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

/// A JSON object that is read or written. When it is read, a field that is missing or null keeps its value; that is a
/// fault unless the object is optional. Lists and std::optional fields may always be missing.
class JsonFields
{
public:
    JsonFields() = default; ///< writes an object

    /// Reads an object. `fault` becomes the place of the first fault, such as "mechanism.b".
    JsonFields(QString &fault, const QJsonObject &object, const QString &place = {}, bool isOptional = false)
        : m_fault(&fault)
        , m_object(object)
        , m_place(place)
        , m_isOptional(isOptional)
    {
    }

    bool isReading() const { return m_fault; }
    const QJsonObject &written() const { return m_object; }

    /// Records a fault at the field `name` if `isValid` is false and the object is read.
    void check(bool isValid, const char *name) const { checkAt(isValid, placeOf(name)); }

    void operator()(const char *name, bool &value) { value = exchange(name, value).toBool(value); }
    void operator()(const char *name, QString &value) { value = exchange(name, value).toString(value); }
    void operator()(const char *name, double &value, double smallest = -kLargestParameter,
                    double largest = kLargestParameter);
    void operator()(const char *name, int &value, int largest); ///< from 1 to `largest`
    void operator()(const char *name, QStringList &value);      ///< a string, or a list of strings
    void operator()(const char *name, std::vector<Channel> &value);
    void operator()(const char *name, std::optional<Interval> &value);
    void operator()(const char *name, std::optional<QRectF> &value);

    template <typename Enum>
    void operator()(const char *name, Enum &value, EnumNames names)
    {
        const QString current = QLatin1String(names.begin()[static_cast<std::size_t>(value)]);
        const QString found = exchange(name, current).toString(current);
        const auto match = std::ranges::find_if(names, [&](const char *each) { return found == QLatin1String(each); });
        check(match != names.end(), name);
        value = match == names.end() ? value : static_cast<Enum>(match - names.begin());
    }

    /// Reads or writes the object of that name by fill(JsonFields &).
    template <typename Fill>
    void object(const char *name, Fill fill, bool isOptional = false)
    {
        JsonFields fields = child(m_object.value(QLatin1String(name)), placeOf(name), isOptional || m_isOptional);
        fill(fields);
        write(name, fields.m_object);
    }

    template <typename Struct>
    void operator()(const char *name, std::optional<Struct> &value)
    {
        if (value || hasValue(name)) {
            object(name, [&](JsonFields &fields) { describe(value ? *value : value.emplace(), fields); });
        } else {
            write(name, QJsonValue());
        }
    }

    template <typename Struct>
    void operator()(const char *name, std::vector<Struct> &list)
    {
        const QJsonArray read = readList(name);
        list.resize(m_fault ? static_cast<std::size_t>(read.size()) : list.size());
        QJsonArray written;
        for (Struct &item : list) {
            const qsizetype index = written.size();
            JsonFields fields = child(read.at(index), QStringLiteral("%1[%2]").arg(placeOf(name)).arg(index), false);
            describe(item, fields);
            written += fields.m_object;
        }
        write(name, written);
    }

private:
    bool hasValue(const char *name) const; ///< whether there is a value to read
    QString placeOf(const char *name) const;
    void checkAt(bool isValid, const QString &place) const;

    void write(const char *name, const QJsonValue &value); ///< does nothing if the object is read
    QJsonValue exchange(const char *name, const QJsonValue &value);
    QJsonArray readList(const char *name)
    {
        return hasValue(name) ? exchange(name, QJsonArray()).toArray() : QJsonArray();
    }
    std::vector<double> exchangeNumbers(const char *name, const std::vector<double> &numbers, std::size_t count);
    JsonFields child(const QJsonValue &value, const QString &place, bool isOptional) const;

    QString *m_fault = nullptr; ///< null if the object is written
    QJsonObject m_object;
    QString m_place;
    bool m_isOptional = false;
};

} // namespace slidercrank
