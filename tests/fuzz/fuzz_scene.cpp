// SPDX-License-Identifier: GPL-3.0-or-later

// Reads arbitrary bytes as a scene file. They are refused with a message, or are a valid scene that does not change
// when it is saved and read again. Arbitrary bytes are hardly ever JSON, so half of the mutations replace values in
// JSON.

#include "tests/fuzz/promise.h"
#include "ui/document/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <variant>

using namespace slidercrank;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *bytes, std::size_t size,
                                        std::size_t capacity); // provided by libFuzzer

/// Replaces the value after one of the colons (of an object or array, only its beginning), or mutates bytes as
/// libFuzzer does.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *bytes, std::size_t size, std::size_t capacity,
                                               unsigned seed)
{
    constexpr std::array<std::string_view, 18> kValues{"0",     "-0.0",     "1",          "-1",    "0.5",  "5e-324",
                                                       "-1e-9", "1e9",      "-1e15",      "1e300", "true", "null",
                                                       "\"\"",  "-1.7e308", "2147483648", "[1]",   "{}",   "\"open\""};
    std::mt19937 random(seed);
    std::string text(reinterpret_cast<const char *>(bytes), size);
    const auto colons = static_cast<std::size_t>(std::ranges::count(text, ':'));
    if (colons == 0 || random() % 2 == 0) {
        return LLVMFuzzerMutate(bytes, size, capacity);
    }
    std::size_t begin = 0;
    for (std::size_t i = random() % colons + 1; i > 0; --i) {
        begin = text.find(':', begin) + 1;
    }
    const std::size_t end = std::min(text.find_first_of(",}]", begin), text.size());
    text.replace(begin, end - begin, kValues[random() % kValues.size()]);
    text.resize(std::min(text.size(), capacity));
    std::ranges::copy(text, bytes);
    return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    const QString path = "/folder/scene.json";
    const QByteArray text(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    const std::variant<Scene, QString> outcome = parseScene(text, path);
    if (const QString *message = std::get_if<QString>(&outcome)) {
        require(message->contains("scene.json") && message->endsWith('.'), "the message names the file");
        return 0;
    }
    const Scene &scene = std::get<Scene>(outcome);
    require(!findFault(scene.parameters), "the parameters are valid");
    require(scene.sampling.steps > 0 && scene.sampling.duration > 0.0 && std::isfinite(scene.sampling.start),
            "the sampling is valid");
    require(std::isfinite(scene.time), "the time is finite");
    const QByteArray saved = sceneToJson(scene, path);
    const std::variant<Scene, QString> again = parseScene(saved, path);
    require(std::holds_alternative<Scene>(again) && sceneToJson(std::get<Scene>(again), path) == saved,
            "a saved scene is read back the same");
    return 0;
}
