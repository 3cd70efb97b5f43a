// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/json_node.h"

#include <cmath>
#include <limits>

namespace slidercrank
{

QString JsonNode::placeOf(const char *name) const
{
    return m_place + (m_place.isEmpty() || !*name ? "" : ".") + QLatin1String(name);
}

void JsonNode::check(bool isValid, const char *name) const
{
    if (m_fault && !isValid && m_fault->isEmpty()) {
        *m_fault = placeOf(name);
    }
}

QJsonValue JsonNode::exchange(const QJsonValue &value)
{
    if (!m_fault) {
        m_value = value;
    }
    const bool isFound = m_value.type() == value.type();
    check(isFound || (m_isOptional && !hasValue()));
    return isFound ? m_value : value;
}

JsonNode JsonNode::child(const QJsonValue &value, const QString &place, bool isOptional) const
{
    return m_fault ? JsonNode(*m_fault, value, place, isOptional) : JsonNode();
}

JsonNode JsonNode::field(const char *name, bool isOptional) const
{
    check(m_value.isObject() || (m_isOptional && !hasValue()));
    return child(m_value.toObject().value(QLatin1String(name)), placeOf(name), isOptional);
}

void JsonNode::setField(const char *name, const JsonNode &node)
{
    if (!m_fault) {
        QJsonObject object = m_value.toObject();
        object.insert(QLatin1String(name), node.m_value);
        m_value = object;
    }
}

void describe(bool &value, JsonNode &node)
{
    value = node.exchange(value).toBool();
}

void describe(QString &value, JsonNode &node)
{
    value = node.exchange(value).toString();
}

void describe(double &value, JsonNode &node, double smallest, double largest)
{
    value = node.exchange(value).toDouble();
    node.check(value >= smallest && value <= largest);
}

void describe(int &value, JsonNode &node, int largest)
{
    value = node.exchange(value).toInt(); // 0 if the number is not whole
    node.check(value >= 1 && value <= largest);
}

void describe(QStringList &value, JsonNode &node)
{
    if (node.value().isArray() || (!node.isReading() && value.size() != 1)) {
        std::vector<QString> list(value.begin(), value.end());
        node.items(list);
        value = QStringList(list.begin(), list.end());
    } else {
        value.resize(1);
        describe(value.first(), node);
    }
}

void describe(Channel &channel, JsonNode &node)
{
    QString name = QString::fromUtf8(nameOf(channel));
    describe(name, node);
    const std::optional<Channel> named = channelNamed(name.toStdString());
    node.check(named.has_value());
    channel = named.value_or(channel);
}

namespace
{

/// Describes a list of finite numbers, whose count must remain the same.
void describeNumbers(std::vector<double> &numbers, JsonNode &node)
{
    const std::size_t count = numbers.size();
    node.items(numbers, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
    node.check(numbers.size() == count);
    numbers.resize(count);
}

} // namespace

void describe(Interval &interval, JsonNode &node)
{
    std::vector<double> ends{interval.lower, interval.upper};
    describeNumbers(ends, node);
    interval = {ends[0], ends[1]};
    node.check(std::isfinite(interval.length()) && interval.length() > 0.0);
}

void describe(QRectF &rectangle, JsonNode &node)
{
    std::vector<double> edges{rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()};
    describeNumbers(edges, node);
    rectangle = QRectF(QPointF(edges[0], edges[1]), QPointF(edges[2], edges[3]));
    node.check(rectangle.width() > 0.0 && rectangle.height() > 0.0);
}

} // namespace slidercrank
