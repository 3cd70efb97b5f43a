// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene_link.h"

#include "core/import/quantity.h"
#include "ui/document/result.h"
#include "ui/text/printable_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QHash>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QUrl>
#include <QUrlQuery>

#include <algorithm>
#include <limits>

namespace slidercrank
{

namespace
{

struct SceneLinkText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SceneLinkText)
};

/// The objects of a scene whose fields a link carries.
const QStringList kSections{"mechanism", "sampling", "solver", "view"};

/// The fields that every link carries, so that it can be read and changed by hand.
const QStringList kFieldsInEveryLink{"a", "b", "c", "omega2"};

struct NamedUnit {
    QString name; ///< in links; empty: the unit of scene files
    Unit unit;
};

/// Returns the units in which a field is written, that of scene files first. Empty: the field is a pure number.
QList<NamedUnit> unitsOf(const QString &field)
{
    static const QHash<QString, QList<NamedUnit>> kUnits{
        {"a", {{"", kMillimetre}}},
        {"b", {{"", kMillimetre}}},
        {"c", {{"", kMillimetre}}},
        {"omega2", {{"", kRadianPerSecond}, {"rpm", kTurnPerMinute}, {"deg/s", kDegreePerSecond}}},
        {"theta20", {{"rad", kRadian}, {"deg", kDegree}}},
        {"start", {{"", kSecond}}},
        {"duration", {{"", kSecond}}},
        {"time", {{"", kSecond}}},
        {"alpha2", {{"", kRadianPerSquareSecond}}},
    };
    return kUnits.value(field);
}

QString &pageAddress()
{
    static QString address = "slidercrank.html";
    return address;
}

/// Returns the scene of a link without settings, with which the window begins.
Scene initialScene()
{
    Scene scene;
    scene.solver = initialSolver();
    return scene;
}

QJsonObject sceneObject(const Scene &scene)
{
    return QJsonDocument::fromJson(sceneToJson(scene, {})).object();
}

/// Returns whether a link carries fields of this type: single values, but no lists and objects.
bool isCarried(const QJsonValue &value)
{
    return value.isDouble() || value.isString() || value.isBool();
}

/// Writes a number in the unit in which it is shortest, so that the same double is read again.
QString numberInLink(const QString &field, double value)
{
    constexpr int kSafeDigits = 15; // a decimal number with so few digits is read and written again unchanged
    const QList<NamedUnit> units = unitsOf(field);
    const auto exactText = [](double number) { return QString::number(number, 'g', QLocale::FloatingPointShortest); };
    if (units.isEmpty()) {
        return exactText(value);
    }
    const Unit &stored = units.first().unit;
    QString shortest = exactText(value) + units.first().name;
    qsizetype digits = exactText(value).size();
    for (const NamedUnit &unit : units.sliced(1)) {
        const QString number = QString::number(value * stored.factor / unit.unit.factor, 'g', kSafeDigits);
        const bool isSame = readQuantity(number + unit.name, stored, QLocale::c()).value == value;
        if (isSame && number.size() < digits) {
            shortest = number + unit.name;
            digits = number.size();
        }
    }
    return shortest;
}

QString textInLink(const QString &field, const QJsonValue &value)
{
    if (value.isBool()) {
        return value.toBool() ? "true" : "false";
    }
    return value.isString() ? value.toString() : numberInLink(field, value.toDouble());
}

/// Returns the number in the unit of scene files, or a sentence if the text is none.
std::variant<double, QString> readNumber(const QString &field, const QString &text)
{
    const QList<NamedUnit> units = unitsOf(field);
    const std::optional<Unit> stored = units.isEmpty() ? std::nullopt : std::optional(units.first().unit);
    const Quantity withoutUnit = readQuantity(text, {}, QLocale::c());
    if (stored == kRadian && !withoutUnit.fault && withoutUnit.value != 0.0) { // the unit could be ° or rad
        return SceneLinkText::tr("The link says %1=%2: add a unit, %2deg or %2rad.").arg(field, printableText(text));
    }
    const auto &[number, fault] = readQuantity(text, stored, QLocale::c());
    if (fault) {
        return SceneLinkText::tr("The link says %1=%2. %3")
            .arg(field, printableText(text), quantityFaultText(text, *fault, stored));
    }
    return number;
}

/// Returns the number that is nearest to `number` among those that a scene accepts in the field.
double nearestAccepted(QJsonObject scene, const QString &section, const QString &field, double number)
{
    QJsonObject fields = scene[section].toObject();
    fields[field] = number;
    scene[section] = fields;
    return sceneObject(acceptedScene(scene))[section].toObject()[field].toDouble();
}

/// Returns a message if the scene does not accept the value that the link gives the field.
std::optional<QString> findRefusal(const QJsonObject &scene, const QString &section, const QString &field,
                                   const QString &text)
{
    const QJsonValue given = scene[section].toObject()[field];
    if (sceneObject(acceptedScene(scene))[section].toObject()[field] == given) {
        return std::nullopt;
    }
    const QString quotation = SceneLinkText::tr("The link says %1=%2:").arg(field, printableText(text)) + u' ';
    if (!given.isDouble()) {
        return quotation + SceneLinkText::tr("that is no choice for %1.").arg(field);
    }
    constexpr double kLargest = std::numeric_limits<double>::max();
    constexpr double kLargestWhole = std::numeric_limits<int>::max();
    const double smallest = nearestAccepted(scene, section, field, -kLargest);
    const double largest = nearestAccepted(scene, section, field, kLargest);
    // A field of whole numbers takes a number that is no int as the smallest one that it accepts (readOrWrite()).
    const bool isWhole = smallest == largest;
    const QList<NamedUnit> units = unitsOf(field);
    const QString unit = units.isEmpty() ? QString() : unitAfterNumber(units.first().unit);
    return quotation + (isWhole ? SceneLinkText::tr("%1 must be a whole number from %2 to %3.")
                                      .arg(field, typedNumberText(smallest),
                                           typedNumberText(nearestAccepted(scene, section, field, kLargestWhole)))
                                : SceneLinkText::tr("%1 must be between %2 and %3.")
                                      .arg(field, typedNumberText(smallest), typedNumberText(largest) + unit));
}

/// Puts a field of the link into the scene. Returns a message if that is not possible.
std::optional<QString> insertField(const QString &field, const QString &text, QJsonObject &scene)
{
    const auto hasField = [&](const QString &section) { return isCarried(scene[section].toObject().value(field)); };
    const auto section = std::ranges::find_if(kSections, hasField);
    if (section == kSections.end()) {
        return SceneLinkText::tr("The link contains “%1”, which is not a setting. It is written as in %2.")
            .arg(printableText(field), "slidercrank.html#b=120&omega2=60rpm");
    }
    QJsonObject fields = scene[*section].toObject();
    QJsonValue value = text;
    if (fields.value(field).isBool() && (text == u"true" || text == u"false")) {
        value = text == u"true";
    } else if (fields.value(field).isDouble()) {
        const std::variant<double, QString> number = readNumber(field, text);
        if (const QString *sentence = std::get_if<QString>(&number)) {
            return *sentence;
        }
        value = std::get<double>(number);
    }
    fields[field] = value;
    scene[*section] = fields;
    return findRefusal(scene, *section, field, text);
}

} // namespace

bool isSceneLink(const QString &text)
{
    static const QRegularExpression kLink("(^|/|\\.html?)#[^#]*=|\\.html?#$");
    return text.contains(kLink) && !QFileInfo::exists(text);
}

QString sceneLink(const Scene &scene)
{
    const QJsonObject initial = sceneObject(initialScene());
    const QJsonObject object = sceneObject(scene);
    QStringList parts;
    for (const QString &section : kSections) {
        const QJsonObject fields = object[section].toObject();
        for (const QString &field : fields.keys()) {
            const bool isInitial = fields[field] == initial[section].toObject().value(field);
            if (isCarried(fields[field]) && (!isInitial || kFieldsInEveryLink.contains(field))) {
                parts += field + u'=' + textInLink(field, fields[field]);
            }
        }
    }
    return pageAddress() + u'#' + parts.join(u'&');
}

std::variant<Scene, QString> parseSceneLink(const QString &link)
{
    QJsonObject scene = sceneObject(initialScene());
    const QUrlQuery query(link.section(u'#', 1));
    for (const auto &[field, text] : query.queryItems(QUrl::FullyDecoded)) {
        if (query.allQueryItemValues(field).size() > 1) {
            return SceneLinkText::tr("The link contains %1 more than once: keep one of them.")
                .arg(printableText(field));
        }
        if (const auto sentence = insertField(field, text, scene)) {
            return *sentence;
        }
    }
    return parseScene(QJsonDocument(scene).toJson(), link);
}

void setPageAddress(const QString &address)
{
    pageAddress() = address;
}

} // namespace slidercrank
