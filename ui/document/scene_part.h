// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Values out of a scene's file, each checked. The first fault is kept, as a sentence that says where it is; after it
// the values mean nothing.

#include "ui/text/interval.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace slidercrank
{

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SceneText)
};

/// What an enumerator is called in a file.
template <typename Value>
using Word = std::pair<Value, const char *>;

struct SceneFault {
    QString file;
    std::optional<QString> sentence;
};

enum class Bound { None, Magnitude, Positive, Length, NotNegative };

/// One object of the file, and where it is. What it lacks, or what is null, is refused, unless it may lack anything.
class ScenePart
{
public:
    ScenePart(SceneFault &fault, const QJsonObject &object, const QString &place, bool mayLack = false)
        : m_fault(fault)
        , m_object(object)
        , m_place(place)
        , m_mayLack(mayLack)
    {
    }

    /// `must`: what the value of that name has to be.
    void refuse(const char *name, const QString &must) const { refuseAt(placeOf(name), must); }

    std::optional<QJsonValue> value(const char *name) const;
    double number(const char *name, Bound bound, double otherwise = 0.0) const;
    int integer(const char *name, int largest) const; ///< from 1 on
    bool flag(const char *name, bool otherwise) const;
    QString text(const char *name) const;
    QStringList texts(const char *name) const; ///< a text, or a list of them
    QJsonArray list(const char *name) const;
    ScenePart part(const char *name, bool mayLack = false) const;
    std::vector<ScenePart> parts(const char *name) const; ///< a list of objects
    std::optional<Interval> interval(const char *name) const;
    std::optional<QRectF> frame(const char *name) const;

    template <typename Value, std::size_t count>
    Value choice(const char *name, const std::array<Word<Value>, count> &words, Value otherwise = Value()) const
    {
        const std::optional<QJsonValue> found = value(name);
        if (!found) {
            return otherwise;
        }
        QStringList known;
        for (const auto &[meaning, word] : words) {
            if (*found == QJsonValue(QLatin1String(word))) {
                return meaning;
            }
            known += u'"' + QLatin1String(word) + u'"';
        }
        refuse(name, SceneText::tr("one of %1").arg(known.join(QStringLiteral(", "))));
        return otherwise;
    }

private:
    QString placeOf(const char *name) const;
    void refuseAt(const QString &place, const QString &must) const;
    std::optional<QJsonValue> value(const char *name, QJsonValue::Type type, const QString &must) const;

    SceneFault &m_fault;
    QJsonObject m_object;
    QString m_place;
    bool m_mayLack; ///< any of it
};

} // namespace slidercrank
