// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene.h"

#include "ui/document/byte_stream.h"
#include "ui/document/result.h"
#include "ui/document/scene_part.h"
#include "ui/document/whole_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cstdio>

namespace slidercrank
{

namespace
{

constexpr int kVersion = 1;
constexpr qint64 kLargestFile = 1 << 20; // bytes; a scene has some thousand
constexpr int kMostSteps = 1'000'000;
constexpr int kMostIterations = 1000;
constexpr int kMostColumns = 1'000'000;

// What the enumerators are called in a file.
constexpr std::array<Word<Branch>, 2> kBranches{{{Branch::Open, "open"}, {Branch::Crossed, "crossed"}}};
constexpr std::array<Word<Method>, 2> kMethods{{{Method::Newton, "newton"}, {Method::ClosedForm, "closed-form"}}};
constexpr std::array<Word<ToleranceKind>, 2> kToleranceKinds{
    {{ToleranceKind::Absolute, "absolute"}, {ToleranceKind::Relative, "relative"}}};
constexpr std::array<Word<WarmStart>, 2> kWarmStarts{
    {{WarmStart::Previous, "previous"}, {WarmStart::Taylor, "taylor"}}};
constexpr std::array<Word<Elimination>, 2> kEliminations{
    {{Elimination::Dense, "dense"}, {Elimination::Structured, "structured"}}};
constexpr std::array<Word<ErrorMeasure>, 3> kErrorMeasures{
    {{ErrorMeasure::Percent, "percent"}, {ErrorMeasure::Absolute, "absolute"}, {ErrorMeasure::OfPeak, "of-peak"}}};
constexpr std::array<Word<Abscissa>, 2> kAbscissae{{{Abscissa::Time, "time"}, {Abscissa::CrankAngle, "crank-angle"}}};
constexpr std::array<Word<ColumnRole>, 3> kRoles{
    {{ColumnRole::Ignored, "ignored"}, {ColumnRole::Time, "time"}, {ColumnRole::CrankAngle, "crank-angle"}}};
constexpr std::array<Word<Convention::Kind>, 12> kConventions{{
    {Convention::Kind::AngleUnit, "angle-unit"},
    {Convention::Kind::LengthUnit, "length-unit"},
    {Convention::Kind::TimeUnit, "time-unit"},
    {Convention::Kind::Sign, "sign"},
    {Convention::Kind::HalfTurn, "half-turn"},
    {Convention::Kind::WholeTurns, "whole-turns"},
    {Convention::Kind::ZeroPoint, "zero-point"},
    {Convention::Kind::SwappedColumns, "swapped-columns"},
    {Convention::Kind::Branch, "branch"},
    {Convention::Kind::TimeShift, "time-shift"},
    {Convention::Kind::NotDerivative, "not-derivative"},
    {Convention::Kind::Axis, "axis"},
}};

template <typename Value, std::size_t count>
QString wordOf(const std::array<Word<Value>, count> &words, Value value)
{
    for (const auto &[meaning, word] : words) {
        if (meaning == value) {
            return QLatin1String(word);
        }
    }
    return {};
}

// Writing

QJsonValue jsonOf(const std::optional<Interval> &interval)
{
    return interval ? QJsonValue(QJsonArray{interval->lower, interval->upper}) : QJsonValue();
}

/// Below the folder: from there on; elsewhere, and in the program itself: as it is.
QString pathFrom(const QDir &folder, const QString &path)
{
    const QString relative = folder.relativeFilePath(path);
    const bool below = !path.startsWith(u':') && QDir::isRelativePath(relative) && !relative.startsWith(u"../");
    return below ? relative : path;
}

QJsonObject jsonOf(const ReferenceSource &reference, const QDir &folder)
{
    QJsonArray columns;
    for (const ColumnChoice &choice : reference.columns) {
        const QString use = choice.role == ColumnRole::Channel ? QString::fromUtf8(nameOf(choice.channel))
                                                               : wordOf(kRoles, choice.role);
        columns += QJsonObject{{QStringLiteral("column"), static_cast<qint64>(choice.column) + 1},
                               {QStringLiteral("use"), use},
                               {QStringLiteral("unit"), QString::fromStdString(choice.unit)}};
    }
    QJsonArray conventions;
    for (const Convention &convention : reference.conventions) {
        QJsonArray channels;
        for (const Channel channel : convention.channels) {
            channels += QString::fromUtf8(nameOf(channel));
        }
        conventions += QJsonObject{{QStringLiteral("kind"), wordOf(kConventions, convention.kind)},
                                   {QStringLiteral("channels"), channels},
                                   {QStringLiteral("amount"), convention.amount}};
    }
    QJsonArray files;
    for (const QString &path : reference.paths) {
        files += pathFrom(folder, path);
    }
    return {{QStringLiteral("file"), files.size() == 1 ? files.first() : QJsonValue(files)},
            {QStringLiteral("columns"), columns},
            {QStringLiteral("conventions"), conventions}};
}

QJsonObject jsonOf(const Parameters &parameters)
{
    return {{QStringLiteral("a"), parameters.a},
            {QStringLiteral("b"), parameters.b},
            {QStringLiteral("c"), parameters.c},
            {QStringLiteral("omega2"), parameters.omega2},
            {QStringLiteral("theta20"), parameters.theta20},
            {QStringLiteral("branch"), wordOf(kBranches, parameters.branch)}};
}

QJsonArray jsonOf(const std::vector<Parameters> &kept)
{
    QJsonArray motions;
    for (const Parameters &parameters : kept) {
        motions += jsonOf(parameters);
    }
    return motions;
}

QJsonObject mechanismJsonOf(const Scene &scene)
{
    const MechanismSettings &settings = scene.mechanism;
    const std::optional<QRectF> &frame = scene.mechanismFrame;
    return {
        {QStringLiteral("velocity"), settings.velocity},
        {QStringLiteral("acceleration"), settings.acceleration},
        {QStringLiteral("path"), settings.path},
        {QStringLiteral("names"), settings.names},
        {QStringLiteral("dimensions"), settings.dimensions},
        {QStringLiteral("angles"), settings.angles},
        {QStringLiteral("instantCentre"), settings.instantCentre},
        {QStringLiteral("frame"),
         frame ? QJsonValue(QJsonArray{frame->left(), frame->top(), frame->right(), frame->bottom()}) : QJsonValue()}};
}

QJsonObject viewJsonOf(const Scene &scene)
{
    QJsonObject zoom{{QStringLiteral("time"), jsonOf(scene.zoom.time)}};
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        zoom.insert(plotName(plot), jsonOf(scene.zoom.values[plot]));
    }
    return {{QStringLiteral("time"), scene.time},
            {QStringLiteral("error"), wordOf(kErrorMeasures, scene.plots.error)},
            {QStringLiteral("logarithmicError"), scene.plots.logarithmicError},
            {QStringLiteral("roundingBand"), scene.plots.roundingBand},
            {QStringLiteral("abscissa"), wordOf(kAbscissae, scene.plots.abscissa)},
            {QStringLiteral("zoom"), zoom},
            {QStringLiteral("mechanism"), mechanismJsonOf(scene)}};
}

/// `over` with what stands in `under` alone.
QJsonObject merged(QJsonObject under, const QJsonObject &over)
{
    for (auto entry = over.begin(); entry != over.end(); ++entry) {
        const QJsonValue before = under.value(entry.key());
        under.insert(entry.key(), before.isObject() && entry->isObject()
                                      ? QJsonValue(merged(before.toObject(), entry->toObject()))
                                      : entry.value());
    }
    return under;
}

// Reading

Parameters parametersOf(const ScenePart &part)
{
    return {.a = part.number("a", Bound::Length),
            .b = part.number("b", Bound::Length),
            .c = part.number("c", Bound::Magnitude),
            .omega2 = part.number("omega2", Bound::Magnitude),
            .theta20 = part.number("theta20", Bound::Magnitude),
            .branch = part.choice("branch", kBranches)};
}

Sampling samplingOf(const ScenePart &part)
{
    return {.start = part.number("start", Bound::Magnitude),
            .duration = part.number("duration", Bound::Positive),
            .steps = part.integer("steps", kMostSteps)};
}

SolverSettings solverOf(const ScenePart &part)
{
    SolverSettings solver;
    solver.method = part.choice("method", kMethods);
    solver.newton.maxIterations = part.integer("maxIterations", kMostIterations);
    solver.newton.tolerance = part.number("tolerance", Bound::NotNegative);
    solver.newton.toleranceKind = part.choice("toleranceKind", kToleranceKinds);
    solver.newton.warmStart = part.choice("warmStart", kWarmStarts);
    solver.newton.elimination = part.choice("elimination", kEliminations);
    return solver;
}

ColumnChoice columnChoiceOf(const ScenePart &part)
{
    ColumnChoice choice;
    choice.column = static_cast<std::size_t>(part.integer("column", kMostColumns)) - 1;
    choice.unit = part.text("unit").toStdString();
    const QString use = part.text("use");
    if (const std::optional<Channel> channel = channelNamed(use.toStdString())) {
        choice.role = ColumnRole::Channel;
        choice.channel = *channel;
    } else if (use == u"time") {
        choice.role = ColumnRole::Time;
    } else if (use == u"crank-angle") {
        choice.role = ColumnRole::CrankAngle;
    } else if (use != u"ignored") {
        part.refuse("use", SceneText::tr("\"time\", \"crank-angle\", \"ignored\" or a channel such as \"theta3\" or "
                                         "\"R4_x_diff\""));
    }
    return choice;
}

Convention conventionOf(const ScenePart &part)
{
    Convention convention;
    convention.kind = part.choice("kind", kConventions);
    for (const QJsonValue &name : part.list("channels")) {
        const std::optional<Channel> channel = channelNamed(name.toString().toStdString());
        if (!channel) {
            part.refuse("channels", SceneText::tr("a list of channels such as \"theta3\" or \"R4_x_diff\""));
            return convention;
        }
        convention.channels.push_back(*channel);
    }
    if (convention.kind == Convention::Kind::SwappedColumns && convention.channels.size() != 2) {
        part.refuse("channels", SceneText::tr("a list of two channels"));
    }
    const bool isUnit = convention.kind == Convention::Kind::AngleUnit ||
                        convention.kind == Convention::Kind::LengthUnit ||
                        convention.kind == Convention::Kind::TimeUnit;
    convention.amount = part.number("amount", isUnit ? Bound::Positive : Bound::Magnitude);
    return convention;
}

ReferenceSource referenceOf(const ScenePart &part, const QDir &folder)
{
    ReferenceSource reference;
    const QStringList files = part.texts("file");
    if (files.isEmpty() || files.contains(QString())) {
        part.refuse("file", SceneText::tr("the name of a file"));
    }
    for (const QString &file : files) {
        reference.paths += file.startsWith(u':') ? file : QDir::cleanPath(folder.absoluteFilePath(file));
    }
    for (const ScenePart &column : part.parts("columns")) {
        reference.columns.push_back(columnChoiceOf(column));
    }
    for (const ScenePart &convention : part.parts("conventions")) {
        reference.conventions.push_back(conventionOf(convention));
    }
    return reference;
}

void readView(const ScenePart &view, Scene &scene)
{
    const PlotSettings usual;
    scene.time = view.number("time", Bound::None, scene.sampling.start);
    scene.plots.error = view.choice("error", kErrorMeasures, usual.error);
    scene.plots.logarithmicError = view.flag("logarithmicError", usual.logarithmicError);
    scene.plots.roundingBand = view.flag("roundingBand", usual.roundingBand);
    scene.plots.abscissa = view.choice("abscissa", kAbscissae, usual.abscissa);
    const ScenePart zoom = view.part("zoom", true);
    scene.zoom.time = zoom.interval("time");
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        scene.zoom.values[plot] = zoom.interval(plotName(plot).toLatin1().constData());
    }
    const ScenePart mechanism = view.part("mechanism", true);
    scene.mechanism.velocity = mechanism.flag("velocity", false);
    scene.mechanism.acceleration = mechanism.flag("acceleration", false);
    scene.mechanism.path = mechanism.flag("path", false);
    scene.mechanism.names = mechanism.flag("names", false);
    scene.mechanism.dimensions = mechanism.flag("dimensions", false);
    scene.mechanism.angles = mechanism.flag("angles", false);
    scene.mechanism.instantCentre = mechanism.flag("instantCentre", false);
    scene.mechanismFrame = mechanism.frame("frame");
}

/// Counted from 1.
qsizetype lineAt(const QByteArray &text, qsizetype offset)
{
    return text.first(std::min(offset, text.size())).count('\n') + 1;
}

} // namespace

QByteArray jsonOf(const Scene &scene, const QString &path)
{
    const NewtonOptions &newton = scene.solver.newton;
    const QDir folder = QFileInfo(path).absoluteDir();
    const QJsonObject object{
        {QStringLiteral("version"), kVersion},
        {QStringLiteral("mechanism"), jsonOf(scene.parameters)},
        {QStringLiteral("sampling"), QJsonObject{{QStringLiteral("start"), scene.sampling.start},
                                                 {QStringLiteral("duration"), scene.sampling.duration},
                                                 {QStringLiteral("steps"), scene.sampling.steps}}},
        {QStringLiteral("solver"),
         QJsonObject{{QStringLiteral("method"), wordOf(kMethods, scene.solver.method)},
                     {QStringLiteral("maxIterations"), newton.maxIterations},
                     {QStringLiteral("tolerance"), newton.tolerance},
                     {QStringLiteral("toleranceKind"), wordOf(kToleranceKinds, newton.toleranceKind)},
                     {QStringLiteral("warmStart"), wordOf(kWarmStarts, newton.warmStart)},
                     {QStringLiteral("elimination"), wordOf(kEliminations, newton.elimination)}}},
        {QStringLiteral("reference"), scene.reference ? QJsonValue(jsonOf(*scene.reference, folder)) : QJsonValue()},
        {QStringLiteral("kept"), jsonOf(scene.kept)},
        {QStringLiteral("view"), viewJsonOf(scene)}};
    return QJsonDocument(merged(scene.asRead, object)).toJson();
}

std::variant<Scene, QString> sceneOf(const QByteArray &json, const QString &path)
{
    const QString shown = shownNameOf(path);
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError) {
        return SceneText::tr("%1, line %2: this is not JSON (%3). Correct it there, or open another scene.")
            .arg(shown, QString::number(lineAt(json, error.offset)), error.errorString());
    }
    Scene scene;
    scene.asRead = document.object();
    const QJsonValue version = scene.asRead.value(QStringLiteral("version"));
    if (!version.isDouble()) {
        return SceneText::tr(
                   "%1 is no scene: it has no \"version\" that is a number. Open a file that this program saved.")
            .arg(shown);
    }
    if (version.toDouble() > kVersion) {
        return SceneText::
            tr("%1 was saved by a newer slidercrank (scene version %2, this one reads up to %3). Open it with that.")
                .arg(shown, QString::number(version.toDouble()), QString::number(kVersion));
    }
    SceneFault fault{shown, std::nullopt};
    const ScenePart whole(fault, scene.asRead, QString());
    if (version.toDouble() != kVersion) {
        whole.refuse("version", QString::number(kVersion));
    }
    scene.parameters = parametersOf(whole.part("mechanism"));
    scene.sampling = samplingOf(whole.part("sampling"));
    scene.solver = solverOf(whole.part("solver"));
    const ScenePart extras(fault, scene.asRead, QString(), true);
    if (extras.value("reference")) {
        scene.reference = referenceOf(whole.part("reference"), QFileInfo(path).absoluteDir());
    }
    for (const ScenePart &kept : extras.parts("kept")) {
        scene.kept.push_back(parametersOf(kept));
    }
    if (scene.kept.size() > kMostKept) {
        extras.refuse("kept", SceneText::tr("a list of at most %1 mechanisms").arg(kMostKept));
    }
    readView(extras.part("view", true), scene);
    if (fault.sentence) {
        return *fault.sentence;
    }
    return scene;
}

std::variant<Scene, QString> readScene(const QString &path)
{
    const QString shown = shownNameOf(path);
    QFile file(path);
    if (QFileInfo(path).isDir()) {
        return SceneText::tr("%1 is a folder: choose a scene's file.").arg(shown);
    }
    if (!(isStandardInput(path) ? file.open(stdin, QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly))) {
        return SceneText::tr("%1 cannot be opened: %2.").arg(shown, withoutFullStop(file.errorString()));
    }
    const QByteArray bytes = file.read(kLargestFile + 1);
    if (file.error() != QFileDevice::NoError) {
        return SceneText::tr("%1 cannot be read: %2.").arg(shown, withoutFullStop(file.errorString()));
    }
    if (bytes.size() > kLargestFile) {
        return SceneText::tr("%1 is no scene: it is too large. Open a file that this program saved.").arg(shown);
    }
    return sceneOf(bytes, path);
}

bool isNamedAsScene(const QString &path)
{
    return path.endsWith(QLatin1String(".slidercrank"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
}

std::optional<QString> writeScene(const Scene &scene, const QString &path)
{
    const std::optional<QString> reason = writeWhole(path, jsonOf(scene, path));
    return reason ? std::optional(SceneText::tr("%1 cannot be written: %2. Choose another name or folder.")
                                      .arg(QDir::toNativeSeparators(path), *reason))
                  : std::nullopt;
}

} // namespace slidercrank
