// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/json_node.h"

#include <cfloat>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kLargestNumber = DBL_MAX;

} // namespace

QJsonValue JsonNode::exchange(const QJsonValue &current)
{
    if (!isReading) {
        value = current;
    }
    return value.type() == current.type() ? value : current;
}

void JsonNode::readOrWriteField(const char *name, const std::function<void(JsonNode &)> &readOrWriteValue)
{
    QJsonObject object = value.toObject();
    JsonNode node{.isReading = isReading, .value = object.value(QLatin1String(name))};
    readOrWriteValue(node);
    object.insert(QLatin1String(name), node.value);
    value = object;
}

void readOrWrite(bool &value, JsonNode &node)
{
    value = node.exchange(value).toBool();
}

void readOrWrite(QString &value, JsonNode &node)
{
    value = node.exchange(value).toString();
}

void readOrWrite(double &value, JsonNode &node, double smallest, double largest)
{
    value = std::clamp(node.exchange(value).toDouble(), smallest, largest);
}

void readOrWrite(int &value, JsonNode &node, int largest)
{
    value = std::clamp(node.exchange(value).toInt(), 1, largest); // a number that is not whole gives 0
}

void readOrWrite(QStringList &list, JsonNode &node)
{
    if (node.isReading) {
        list = node.value.toVariant().toStringList();
    } else {
        node.value = list.size() == 1 ? QJsonValue(list.first()) : QJsonArray::fromStringList(list);
    }
}

void readOrWrite(Channel &channel, JsonNode &node)
{
    const QString name = node.exchange(QString::fromUtf8(nameOf(channel))).toString();
    channel = channelNamed(name.toStdString()).value_or(channel);
}

void readOrWrite(Interval &interval, JsonNode &node)
{
    std::vector<double> ends{interval.lower, interval.upper};
    readOrWrite(ends, node, -kLargestNumber, kLargestNumber);
    ends.resize(2);
    interval = {ends[0], ends[1]};
}

void readOrWrite(QRectF &rectangle, JsonNode &node)
{
    std::vector<double> edges{rectangle.left(), rectangle.top(), rectangle.right(), rectangle.bottom()};
    readOrWrite(edges, node, -kLargestNumber, kLargestNumber);
    edges.resize(4);
    rectangle = QRectF(QPointF(edges[0], edges[1]), QPointF(edges[2], edges[3]));
}

bool isValid(const Interval &interval)
{
    return std::isfinite(interval.length()) && interval.length() > 0.0;
}

bool isValid(const QRectF &rectangle)
{
    return rectangle.width() > 0.0 && rectangle.height() > 0.0;
}

} // namespace slidercrank
