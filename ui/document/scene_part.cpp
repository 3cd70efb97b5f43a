// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene_part.h"

#include "core/mechanism/mechanism.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

QString ScenePart::placeOf(const char *name) const
{
    return m_place.isEmpty() ? QString(QLatin1String(name)) : m_place + u'.' + QLatin1String(name);
}

void ScenePart::refuseAt(const QString &place, const QString &must) const
{
    if (!m_fault.sentence) {
        m_fault.sentence = SceneText::tr("%1: \"%2\" must be %3. Correct it there, or open another scene.")
                               .arg(m_fault.file, place, must);
    }
}

std::optional<QJsonValue> ScenePart::value(const char *name) const
{
    const QJsonValue value = m_object.value(QLatin1String(name));
    if (!value.isUndefined() && !value.isNull()) {
        return value;
    }
    if (!m_mayLack && !m_fault.sentence) {
        m_fault.sentence = SceneText::tr("%1: \"%2\" is missing. Add it there, or open another scene.")
                               .arg(m_fault.file, placeOf(name));
    }
    return std::nullopt;
}

std::optional<QJsonValue> ScenePart::value(const char *name, QJsonValue::Type type, const QString &must) const
{
    const std::optional<QJsonValue> found = value(name);
    if (found && found->type() != type) {
        refuse(name, must);
    }
    return found;
}

double ScenePart::number(const char *name, Bound bound, double otherwise) const
{
    const std::optional<QJsonValue> found = value(name);
    if (!found) {
        return otherwise;
    }
    const double number = found->toDouble(std::numeric_limits<double>::quiet_NaN());
    const bool bounded = std::abs(number) <= kLargestParameter;
    switch (bound) {
    case Bound::None:
        if (!std::isfinite(number)) {
            refuse(name, SceneText::tr("a number"));
        }
        break;
    case Bound::Magnitude:
        if (!bounded) {
            refuse(name, SceneText::tr("a number of a magnitude up to 1e12"));
        }
        break;
    case Bound::Positive:
        if (!(bounded && number > 0.0)) {
            refuse(name, SceneText::tr("a number greater than 0 and at most 1e12"));
        }
        break;
    case Bound::Length:
        if (!(bounded && number >= kShortestLink)) {
            refuse(name, SceneText::tr("a length from 1e-9 mm to 1e12 mm"));
        }
        break;
    case Bound::NotNegative:
        if (!(number >= 0.0)) {
            refuse(name, SceneText::tr("a number not less than 0"));
        }
        break;
    }
    return number;
}

int ScenePart::integer(const char *name, int largest) const
{
    const std::optional<QJsonValue> found = value(name);
    const double number = found ? found->toDouble() : 1.0;
    if (!(number >= 1.0 && number <= largest && number == std::floor(number))) {
        refuse(name, SceneText::tr("a whole number from 1 to %1").arg(largest));
        return 1;
    }
    return static_cast<int>(number);
}

bool ScenePart::flag(const char *name, bool otherwise) const
{
    const auto found = value(name, QJsonValue::Bool, SceneText::tr("true or false"));
    return found ? found->toBool() : otherwise;
}

QString ScenePart::text(const char *name) const
{
    const auto found = value(name, QJsonValue::String, SceneText::tr("a text in quotation marks"));
    return found ? found->toString() : QString();
}

QStringList ScenePart::texts(const char *name) const
{
    const std::optional<QJsonValue> found = value(name);
    if (!found || !found->isArray()) {
        return {text(name)};
    }
    QStringList texts;
    for (const QJsonValue &each : found->toArray()) {
        texts += each.toString();
    }
    return texts;
}

QJsonArray ScenePart::list(const char *name) const
{
    const auto found = value(name, QJsonValue::Array, SceneText::tr("a list in brackets"));
    return found ? found->toArray() : QJsonArray();
}

ScenePart ScenePart::part(const char *name, bool mayLack) const
{
    const auto found = value(name, QJsonValue::Object, SceneText::tr("an object in braces"));
    return ScenePart(m_fault, found ? found->toObject() : QJsonObject(), placeOf(name), mayLack);
}

std::vector<ScenePart> ScenePart::parts(const char *name) const
{
    const QJsonArray array = list(name);
    std::vector<ScenePart> parts;
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString place = QStringLiteral("%1[%2]").arg(placeOf(name)).arg(i);
        if (!array[i].isObject()) {
            refuseAt(place, SceneText::tr("an object in braces"));
        }
        parts.emplace_back(m_fault, array[i].toObject(), place);
    }
    return parts;
}

std::optional<Interval> ScenePart::interval(const char *name) const
{
    const QJsonArray array = list(name);
    if (array.isEmpty()) {
        return std::nullopt;
    }
    const Interval interval{array[0].toDouble(), array.size() == 2 ? array[1].toDouble() : 0.0};
    const bool numbers = array.size() == 2 && array[0].isDouble() && array[1].isDouble();
    if (!numbers || !(interval.lower < interval.upper) || !std::isfinite(interval.length())) {
        refuse(name, SceneText::tr("two numbers in brackets, the smaller one first"));
    }
    return interval;
}

std::optional<QRectF> ScenePart::frame(const char *name) const
{
    const QJsonArray array = list(name);
    if (array.isEmpty()) {
        return std::nullopt;
    }
    const auto isLength = [](const QJsonValue &value) {
        return value.isDouble() && std::abs(value.toDouble()) <= kLargestParameter;
    };
    const bool lengths = array.size() == 4 && std::all_of(array.begin(), array.end(), isLength);
    const QRectF frame = lengths ? QRectF(QPointF(array[0].toDouble(), array[1].toDouble()),
                                          QPointF(array[2].toDouble(), array[3].toDouble()))
                                 : QRectF();
    if (!(frame.width() > 0.0 && frame.height() > 0.0)) {
        refuse(name, SceneText::tr("four numbers in brackets, left, lower, right and upper, the smaller ones first"));
    }
    return frame;
}

} // namespace slidercrank
