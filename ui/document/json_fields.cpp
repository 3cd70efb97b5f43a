// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/json_fields.h"

#include <QVariant>

#include <cmath>

namespace slidercrank
{

bool JsonFields::hasValue(const char *name) const
{
    const QJsonValue value = m_object.value(QLatin1String(name));
    return m_fault && !value.isUndefined() && !value.isNull();
}

QString JsonFields::placeOf(const char *name) const
{
    return m_place.isEmpty() ? QString(QLatin1String(name)) : m_place + u'.' + QLatin1String(name);
}

void JsonFields::checkAt(bool isValid, const QString &place) const
{
    if (m_fault && !isValid && m_fault->isEmpty()) {
        *m_fault = place;
    }
}

void JsonFields::write(const char *name, const QJsonValue &value)
{
    if (!m_fault) {
        m_object.insert(QLatin1String(name), value);
    }
}

/// Writes the value, or reads a value of the same type. Returns Undefined if there is no such value.
QJsonValue JsonFields::exchange(const char *name, const QJsonValue &value)
{
    write(name, value);
    const QJsonValue found = m_object.value(QLatin1String(name));
    const bool isFound = hasValue(name) && found.type() == value.type();
    check(isFound || (m_isOptional && !hasValue(name)), name);
    return isFound ? found : QJsonValue::Undefined;
}

void JsonFields::operator()(const char *name, double &value, double smallest, double largest)
{
    value = exchange(name, value).toDouble(value);
    check(value >= smallest && value <= largest, name);
}

void JsonFields::operator()(const char *name, int &value, int largest)
{
    const QJsonValue found = exchange(name, value);
    value = found.toInt(found.isDouble() ? 0 : value); // 0 if the number is not whole
    check(value >= 1 && value <= largest, name);
}

void JsonFields::operator()(const char *name, QStringList &value)
{
    if (m_object.value(QLatin1String(name)).isArray()) {
        value = QVariant(readList(name).toVariantList()).toStringList();
    } else if (!m_fault && value.size() != 1) {
        write(name, QJsonArray::fromStringList(value));
    } else {
        value.resize(1);
        (*this)(name, value.first());
    }
}

void JsonFields::operator()(const char *name, std::vector<Channel> &value)
{
    QJsonArray names;
    for (const Channel channel : value) {
        names += QString::fromUtf8(nameOf(channel));
    }
    write(name, names);
    for (const QJsonValue &item : readList(name)) {
        const std::optional<Channel> channel = channelNamed(item.toString().toStdString());
        check(channel.has_value(), name);
        value.push_back(channel.value_or(Channel()));
    }
}

/// When writing, writes the numbers, or null if there are none. When reading, reads `count` numbers.
std::vector<double> JsonFields::exchangeNumbers(const char *name, const std::vector<double> &numbers, std::size_t count)
{
    QJsonArray array;
    std::ranges::copy(numbers, std::back_inserter(array));
    write(name, array.isEmpty() ? QJsonValue() : array);
    std::vector<double> found;
    for (const QJsonValue &number : readList(name)) {
        found.push_back(number.toDouble(kNone));
        check(std::isfinite(found.back()), name);
    }
    check(found.size() == count || !hasValue(name), name);
    found.resize(hasValue(name) ? count : 0);
    return found;
}

void JsonFields::operator()(const char *name, std::optional<Interval> &value)
{
    const auto ends = exchangeNumbers(name, value ? std::vector{value->lower, value->upper} : std::vector<double>(), 2);
    if (!ends.empty()) {
        value = {ends[0], ends[1]};
        check(std::isfinite(value->length()) && value->length() > 0.0, name);
    }
}

void JsonFields::operator()(const char *name, std::optional<QRectF> &value)
{
    const auto edges = exchangeNumbers(
        name, value ? std::vector{value->left(), value->top(), value->right(), value->bottom()} : std::vector<double>(),
        4);
    if (!edges.empty()) {
        value = QRectF(QPointF(edges[0], edges[1]), QPointF(edges[2], edges[3]));
        check(value->width() > 0.0 && value->height() > 0.0, name);
    }
}

JsonFields JsonFields::child(const QJsonValue &value, const QString &place, bool isOptional) const
{
    checkAt(value.isObject() || (isOptional && (value.isUndefined() || value.isNull())), place);
    return m_fault ? JsonFields(*m_fault, value.toObject(), place, isOptional) : JsonFields();
}

} // namespace slidercrank
