// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes as a scene's file: refused in a sentence, or a scene that can be drawn and is the same once saved.

#include "tests/fuzz/promise.h"
#include "ui/document/scene.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

using namespace slidercrank;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    const QString path = QStringLiteral("/folder/scene.json");
    const QByteArray text(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    const std::variant<Scene, QString> outcome = sceneOf(text, path);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        require(sentence->contains(QLatin1String("scene.json")) && sentence->endsWith(u'.'), "a sentence on the file");
        return 0;
    }
    const Scene &scene = std::get<Scene>(outcome);
    require(!findFault(scene.parameters), "the mechanism is one");
    require(scene.sampling.steps > 0 && scene.sampling.duration > 0.0 && std::isfinite(scene.sampling.start),
            "there are instants");
    require(std::isfinite(scene.time), "the instant on show is one");
    const QByteArray saved = jsonOf(scene, path);
    const std::variant<Scene, QString> again = sceneOf(saved, path);
    require(std::holds_alternative<Scene>(again), "what is saved can be opened");
    require(jsonOf(std::get<Scene>(again), path) == saved, "and is the same then");
    return 0;
}
