// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene.h"

#include "ui/document/result.h"
#include "ui/document/scene_link.h"
#include "ui/document/settings_fields.h"
#include "ui/document/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>

#include <algorithm>
#include <cfloat>

namespace slidercrank
{

namespace
{

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SceneText)
};

constexpr int kVersion = 1;
constexpr double kLargestTime = DBL_MAX;

/// Returns the path relative to the folder if the file is in or below the folder. Returns other paths, and paths of the
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
                   "%1 is not a scene: it has no “version” that is a number. Open a file that this program saved.")
            .arg(file);
    }
    if (version.toDouble() > kVersion) {
        return SceneText::tr("%1 was saved by a newer slidercrank (scene version %2; this one reads up to %3). Open it "
                             "with the newer one.")
            .arg(file, QString::number(version.toDouble()), QString::number(kVersion));
    }
    return std::nullopt;
}

/// Returns the fields, such as ".mechanism.b", in which `given`, the JSON of a file, differs from `expected`, the JSON
/// that this program would write. A field may be missing or null in `given` if it belongs to the view, or if null or an
/// empty list is expected.
QStringList findDifferences(const QJsonValue &expected, const QJsonValue &given, const QString &field = {})
{
    const QJsonObject fields = expected.toObject();
    const QJsonArray items = expected.toArray();
    const bool isOptional = field.startsWith(".view") || expected.isNull() || (expected.isArray() && items.isEmpty());
    if (isOptional && (given.isUndefined() || given.isNull())) {
        return {};
    }
    // The drawing's frame is stored as a corner and a size, which rounds its edges.
    const bool mustBeEqual = !expected.isObject() && !expected.isArray() && !field.startsWith(".view.mechanism.frame");
    if (expected.type() != given.type() || items.size() != given.toArray().size() ||
        (mustBeEqual && expected != given)) {
        return {field};
    }
    QStringList differences;
    for (const QString &name : fields.keys()) {
        differences += findDifferences(fields[name], given[name], field + u'.' + name);
    }
    for (qsizetype i = 0; i < items.size(); ++i) {
        differences += findDifferences(items[i], given[i], QStringLiteral("%1[%2]").arg(field).arg(i));
    }
    return differences;
}

} // namespace

static void readOrWrite(Scene &scene, JsonNode &node)
{
    int version = kVersion;
    node("version", version, kVersion);
    node("mechanism", scene.parameters);
    node("sampling", scene.sampling);
    node("solver", scene.solver);
    node("reference", scene.reference);
    node("kept", scene.pinned);
    scene.pinned.resize(std::min(scene.pinned.size(), kMaxPinned));
    scene.time = node.isReading ? scene.sampling.start : scene.time;
    node.readOrWriteField("view", [&](JsonNode &view) {
        view("time", scene.time, -kLargestTime, kLargestTime);
        view("alpha2", scene.alpha2, -kLargestParameter, kLargestParameter);
        readOrWrite(scene.plots, view);
        view("zoom", scene.zoom);
        view.readOrWriteField("mechanism", [&](JsonNode &mechanism) {
            readOrWrite(scene.mechanism, mechanism);
            mechanism("frame", scene.mechanismFrame);
        });
        view("table", scene.table);
        view("notation", scene.notation);
    });
}

QByteArray sceneToJson(Scene scene, const QString &path)
{
    if (scene.reference) {
        for (QString &file : scene.reference->paths) {
            file = relativePath(QFileInfo(path).absoluteDir(), file);
        }
    }
    return QJsonDocument(toJson(scene).toObject()).toJson();
}

Scene acceptedScene(const QJsonObject &json)
{
    return fromJson<Scene>(json);
}

std::variant<Scene, QString> parseScene(const QByteArray &json, const QString &path)
{
    const QString shownName = displayName(path);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        const qsizetype line = json.first(std::min<qsizetype>(error.offset, json.size())).count('\n') + 1;
        return SceneText::tr("%1, line %2: this is not JSON (%3). Correct it there, or open another scene.")
            .arg(shownName, QString::number(line), error.errorString());
    }
    const QJsonObject object = document.object();
    if (const auto sentence = versionFault(object.value("version"), shownName)) {
        return *sentence;
    }
    Scene scene = acceptedScene(object);
    const QStringList faultyFields = findDifferences(toJson(scene), object);
    if (scene.reference) {
        for (QString &file : scene.reference->paths) {
            file = absolutePath(QFileInfo(path).absoluteDir(), file);
        }
    }
    if (!faultyFields.isEmpty()) {
        return SceneText::tr("%1: “%2” is missing, or its value is not valid. Correct it there, or open another scene.")
            .arg(shownName, faultyFields.first().mid(1));
    }
    return scene;
}

std::variant<Scene, QString> readScene(const QString &path)
{
    if (isSceneLink(path)) {
        return parseSceneLink(path);
    }
    if (isPipeOrDevice(QFileInfo(path))) { // reading could wait forever
        return SceneText::tr("%1 is a pipe or a device: save the scene in a file, and open that.")
            .arg(displayName(path));
    }
    const std::variant<QByteArray, QString> content = readWhole(path, ExpectedContent::Scene);
    if (const QString *sentence = std::get_if<QString>(&content)) {
        return *sentence;
    }
    return parseScene(std::get<QByteArray>(content), path);
}

bool isNamedAsScene(const QString &path)
{
    return path.endsWith(".slidercrank", Qt::CaseInsensitive) || path.endsWith(".json", Qt::CaseInsensitive) ||
           isSceneLink(path);
}

std::optional<QString> writeScene(const Scene &scene, const QString &path)
{
    return writeWhole(path, sceneToJson(scene, path));
}

} // namespace slidercrank
