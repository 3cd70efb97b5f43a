// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes as a scene's file: refused in a sentence, or a scene that can be drawn and is the same once saved. Half of
// the time the bytes stay JSON, with other values in it: of any bytes next to none is.

#include "tests/fuzz/promise.h"
#include "ui/document/scene.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <variant>

using namespace slidercrank;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *bytes, std::size_t size, std::size_t room); // libFuzzer's own

namespace
{

class Mutation
{
public:
    explicit Mutation(unsigned seed)
        : m_random(seed)
    {
    }

    bool isOneIn(int count) { return below(count) == 0; }

    QJsonObject of(QJsonObject object)
    {
        if (object.isEmpty()) {
            return object;
        }
        const QString key = object.keys().at(below(object.size()));
        if (isOneIn(kSeldom)) {
            object.remove(key);
        } else {
            object[key] = of(object.value(key));
        }
        return object;
    }

private:
    static constexpr int kSeldom = 8;

    int below(qsizetype count) { return std::uniform_int_distribution<int>(0, static_cast<int>(count) - 1)(m_random); }

    QJsonArray of(QJsonArray array)
    {
        if (array.isEmpty() || isOneIn(kSeldom)) {
            array.append(array.isEmpty() ? anything() : array.at(below(array.size())));
        } else if (isOneIn(kSeldom)) {
            array.removeAt(below(array.size()));
        } else {
            const int place = below(array.size());
            array[place] = of(array.at(place));
        }
        return array;
    }

    QJsonValue of(const QJsonValue &value)
    {
        if (isOneIn(kSeldom)) {
            return anything();
        }
        switch (value.type()) {
        case QJsonValue::Object: return of(value.toObject());
        case QJsonValue::Array: return of(value.toArray());
        case QJsonValue::Bool: return !value.toBool();
        case QJsonValue::Double: return isOneIn(2) ? anyNumber() : value.toDouble() * anyNumber();
        case QJsonValue::String: return withOtherBytes(value.toString());
        case QJsonValue::Null:
        case QJsonValue::Undefined: break;
        }
        return anything();
    }

    QJsonValue anything()
    {
        const QJsonValue all[] = {{}, true, anyNumber(), QString(), QJsonArray{anyNumber()}, QJsonObject{{"b", 0}}};
        return all[below(std::size(all))];
    }

    double anyNumber()
    {
        constexpr double kAll[] = {0.0, -0.0, 1.0, -1.0, 0.5, 5e-324, -1e-9, 1e9, -1e15, 1e300, -1.7e308, 2147483648.0};
        return kAll[below(std::size(kAll))];
    }

    QString withOtherBytes(const QString &text)
    {
        constexpr qsizetype kMoreRoom = 8;
        QByteArray bytes = text.toUtf8();
        const qsizetype size = bytes.size();
        bytes.resize(size + kMoreRoom);
        auto *data = reinterpret_cast<std::uint8_t *>(bytes.data());
        const auto room = static_cast<std::size_t>(bytes.size());
        bytes.resize(static_cast<qsizetype>(LLVMFuzzerMutate(data, static_cast<std::size_t>(size), room)));
        return QString::fromUtf8(bytes);
    }

    std::mt19937 m_random;
};

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *bytes, std::size_t size, std::size_t room, unsigned seed)
{
    Mutation mutation(seed);
    const QByteArray text(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    const QJsonObject scene = QJsonDocument::fromJson(text).object();
    if (!scene.isEmpty() && !mutation.isOneIn(2)) {
        const QByteArray other = QJsonDocument(mutation.of(scene)).toJson(QJsonDocument::Compact);
        if (static_cast<std::size_t>(other.size()) <= room) {
            std::copy(other.begin(), other.end(), bytes);
            return static_cast<std::size_t>(other.size());
        }
    }
    return LLVMFuzzerMutate(bytes, size, room);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    const QString path = QStringLiteral("/folder/scene.json");
    const QByteArray text(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    const std::variant<Scene, QString> outcome = parseScene(text, path);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        require(sentence->contains(QLatin1String("scene.json")) && sentence->endsWith(u'.'), "a sentence on the file");
        return 0;
    }
    const Scene &scene = std::get<Scene>(outcome);
    require(!findFault(scene.parameters), "the mechanism is one");
    require(scene.sampling.steps > 0 && scene.sampling.duration > 0.0 && std::isfinite(scene.sampling.start),
            "there are instants");
    require(std::isfinite(scene.time), "the instant on show is one");
    const QByteArray saved = sceneToJson(scene, path);
    const std::variant<Scene, QString> again = parseScene(saved, path);
    require(std::holds_alternative<Scene>(again), "what is saved can be opened");
    require(sceneToJson(std::get<Scene>(again), path) == saved, "and is the same then");
    return 0;
}
