// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene.h"

#include "ui/document/result.h"
#include "ui/document/settings_fields.h"
#include "ui/document/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>

#include <algorithm>
#include <limits>

namespace slidercrank
{

namespace
{

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SceneText)
};

constexpr int kVersion = 1;
constexpr double kLargestTime = std::numeric_limits<double>::max();
constexpr qint64 kLargestFile = 1 << 20; // bytes; a typical scene has a few thousand

void describe(Scene &scene, JsonNode &node)
{
    int version = kVersion;
    node("version", version, kVersion);
    node("mechanism", scene.parameters);
    node("sampling", scene.sampling);
    node("solver", scene.solver);
    node("reference", scene.reference);
    node("kept", scene.pinned);
    node.check(scene.pinned.size() <= kMaxPinned, "kept");
    scene.time = node.isReading() ? scene.sampling.start : scene.time;
    node.object("view", [&](JsonNode &view) {
        view("time", scene.time, -kLargestTime, kLargestTime);
        describe(scene.plots, view);
        view("zoom", scene.zoom);
        view.object("mechanism", [&](JsonNode &mechanism) {
            describe(scene.mechanism, mechanism);
            mechanism("frame", scene.mechanismFrame);
        });
    });
}

/// Returns the path relative to the folder if the file is in or below the folder. Returns other paths, and those of the
/// program's resources, unchanged.
QString relativePath(const QDir &folder, const QString &path)
{
    const QString relative = folder.relativeFilePath(path);
    const bool isBelow = !path.startsWith(u':') && QDir::isRelativePath(relative) && !relative.startsWith(u"../");
    return isBelow ? relative : path;
}

QString absolutePath(const QDir &folder, const QString &path)
{
    return path.startsWith(u':') ? path : QDir::cleanPath(folder.absoluteFilePath(path));
}

/// Returns a message if the file is not a scene that this version can read.
std::optional<QString> versionFault(const QJsonValue &version, const QString &file)
{
    if (!version.isDouble()) {
        return SceneText::tr(
                   "%1 is not a scene: it has no \"version\" that is a number. Open a file that this program saved.")
            .arg(file);
    }
    if (version.toDouble() > kVersion) {
        return SceneText::tr("%1 was saved by a newer slidercrank (scene version %2; this one reads up to %3). Open it "
                             "with the newer one.")
            .arg(file, QString::number(version.toDouble()), QString::number(kVersion));
    }
    return std::nullopt;
}

} // namespace

QByteArray sceneToJson(Scene scene, const QString &path)
{
    if (scene.reference) {
        for (QString &file : scene.reference->paths) {
            file = relativePath(QFileInfo(path).absoluteDir(), file);
        }
    }
    JsonNode node;
    describe(scene, node);
    return QJsonDocument(node.value().toObject()).toJson();
}

std::variant<Scene, QString> parseScene(const QByteArray &json, const QString &path)
{
    const QString shown = displayName(path);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        const qsizetype line = json.first(std::min<qsizetype>(error.offset, json.size())).count('\n') + 1;
        return SceneText::tr("%1, line %2: this is not JSON (%3). Correct it there, or open another scene.")
            .arg(shown, QString::number(line), error.errorString());
    }
    const QJsonObject object = document.object();
    if (const auto sentence = versionFault(object.value("version"), shown)) {
        return *sentence;
    }
    QString fault;
    JsonNode node(fault, object);
    Scene scene;
    describe(scene, node);
    if (scene.reference) {
        for (QString &file : scene.reference->paths) {
            file = absolutePath(QFileInfo(path).absoluteDir(), file);
        }
    }
    if (!fault.isEmpty()) {
        return SceneText::tr(
                   "%1: \"%2\" is missing, or its value is not valid. Correct it there, or open another scene.")
            .arg(shown, fault);
    }
    return scene;
}

std::variant<Scene, QString> readScene(const QString &path)
{
    QFile file;
    if (const std::optional<QString> sentence = openForReading(file, path)) {
        return *sentence;
    }
    const QByteArray bytes = file.read(kLargestFile + 1);
    if (const std::optional<QString> sentence = readFailure(file, path)) {
        return *sentence;
    }
    if (bytes.size() > kLargestFile) {
        return SceneText::tr("%1 is not a scene: it is too large. Open a file that this program saved.")
            .arg(displayName(path));
    }
    return parseScene(bytes, path);
}

bool isNamedAsScene(const QString &path)
{
    return path.endsWith(".slidercrank", Qt::CaseInsensitive) || path.endsWith(".json", Qt::CaseInsensitive);
}

std::optional<QString> writeScene(const Scene &scene, const QString &path)
{
    return writeWhole(path, sceneToJson(scene, path));
}

} // namespace slidercrank
