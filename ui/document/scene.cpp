// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/scene.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kVersion = 1;
constexpr qint64 kLargestFile = 1 << 20; // bytes; a scene has some thousand
constexpr int kMostSteps = 1'000'000;
constexpr int kMostIterations = 1000;
constexpr int kMostColumns = 1'000'000;

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SceneText)
};

// What the enumerators are called in a file.
template <typename Value>
using Word = std::pair<Value, const char *>;

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
constexpr std::array<Word<Convention::Kind>, 10> kConventions{{
    {Convention::Kind::AngleUnit, "angle-unit"},
    {Convention::Kind::LengthUnit, "length-unit"},
    {Convention::Kind::TimeUnit, "time-unit"},
    {Convention::Kind::Sign, "sign"},
    {Convention::Kind::HalfTurn, "half-turn"},
    {Convention::Kind::WholeTurns, "whole-turns"},
    {Convention::Kind::SwappedColumns, "swapped-columns"},
    {Convention::Kind::Branch, "branch"},
    {Convention::Kind::TimeShift, "time-shift"},
    {Convention::Kind::NotDerivative, "not-derivative"},
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

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
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
        QString use = toQString(nameOf(choice.channel));
        if (choice.role != ColumnRole::Channel) {
            use = choice.role == ColumnRole::Time ? QStringLiteral("time") : QStringLiteral("ignored");
        }
        columns += QJsonObject{{QStringLiteral("column"), static_cast<qint64>(choice.column) + 1},
                               {QStringLiteral("use"), use},
                               {QStringLiteral("unit"), QString::fromStdString(choice.unit)}};
    }
    QJsonArray conventions;
    for (const Convention &convention : reference.conventions) {
        QJsonArray channels;
        for (const Channel channel : convention.channels) {
            channels += toQString(nameOf(channel));
        }
        conventions += QJsonObject{{QStringLiteral("kind"), wordOf(kConventions, convention.kind)},
                                   {QStringLiteral("channels"), channels},
                                   {QStringLiteral("amount"), convention.amount}};
    }
    return {{QStringLiteral("file"), pathFrom(folder, reference.path)},
            {QStringLiteral("columns"), columns},
            {QStringLiteral("conventions"), conventions}};
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

/// Takes checked values out of a file. The first fault is kept; after it the values mean nothing.
class SceneReader
{
public:
    explicit SceneReader(const QString &file)
        : m_file(file)
    {
    }

    const std::optional<QString> &fault() const { return m_fault; }

    /// `must`: what the value at that place has to be.
    void refuse(const QString &place, const QString &must)
    {
        if (!m_fault) {
            m_fault = SceneText::tr("%1: \"%2\" must be %3. Correct it there, or open another scene.")
                          .arg(m_file, place, must);
        }
    }

    void refuseMissing(const QString &place)
    {
        if (!m_fault) {
            m_fault = SceneText::tr("%1: \"%2\" is missing. Add it there, or open another scene.").arg(m_file, place);
        }
    }

private:
    QString m_file;
    std::optional<QString> m_fault;
};

enum class Bound { None, Magnitude, Positive, NotNegative };

/// One object of the file, and where it is.
class Part
{
public:
    Part(SceneReader &reader, const QJsonObject &object, const QString &place, bool mayLack = false)
        : m_reader(reader)
        , m_object(object)
        , m_place(place)
        , m_mayLack(mayLack)
    {
    }

    QString placeOf(const QString &key) const { return m_place.isEmpty() ? key : m_place + u'.' + key; }

    /// Nothing, or null: where it has to be there, refused.
    std::optional<QJsonValue> value(const char *name) const
    {
        const QString key = QLatin1String(name);
        const QJsonValue value = m_object.value(key);
        if (!value.isUndefined() && !value.isNull()) {
            return value;
        }
        if (!m_mayLack) {
            m_reader.refuseMissing(placeOf(key));
        }
        return std::nullopt;
    }

    void refuse(const char *name, const QString &must) const { m_reader.refuse(placeOf(QLatin1String(name)), must); }

    double number(const char *name, Bound bound, double otherwise = 0.0) const
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
        case Bound::NotNegative:
            if (!(number >= 0.0)) {
                refuse(name, SceneText::tr("a number not less than 0"));
            }
            break;
        }
        return number;
    }

    int integer(const char *name, int largest) const
    {
        const std::optional<QJsonValue> found = value(name);
        const double number = found ? found->toDouble() : 1.0;
        if (!(number >= 1.0 && number <= largest && number == std::floor(number))) {
            refuse(name, SceneText::tr("a whole number from 1 to %1").arg(largest));
            return 1;
        }
        return static_cast<int>(number);
    }

    bool flag(const char *name, bool otherwise) const
    {
        const std::optional<QJsonValue> found = value(name);
        if (found && !found->isBool()) {
            refuse(name, SceneText::tr("true or false"));
        }
        return found ? found->toBool() : otherwise;
    }

    QString text(const char *name) const
    {
        const std::optional<QJsonValue> found = value(name);
        if (found && !found->isString()) {
            refuse(name, SceneText::tr("a text in quotation marks"));
        }
        return found ? found->toString() : QString();
    }

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

    Part part(const char *name, bool mayLack = false) const
    {
        const std::optional<QJsonValue> found = value(name);
        if (found && !found->isObject()) {
            refuse(name, SceneText::tr("an object in braces"));
        }
        return Part(m_reader, found ? found->toObject() : QJsonObject(), placeOf(QLatin1String(name)), mayLack);
    }

    /// An array of objects.
    std::vector<Part> parts(const char *name) const
    {
        const QJsonArray array = list(name);
        std::vector<Part> parts;
        for (qsizetype i = 0; i < array.size(); ++i) {
            const QString place = QStringLiteral("%1[%2]").arg(placeOf(QLatin1String(name))).arg(i);
            if (!array[i].isObject()) {
                m_reader.refuse(place, SceneText::tr("an object in braces"));
            }
            parts.emplace_back(m_reader, array[i].toObject(), place);
        }
        return parts;
    }

    QJsonArray list(const char *name) const
    {
        const std::optional<QJsonValue> found = value(name);
        if (found && !found->isArray()) {
            refuse(name, SceneText::tr("a list in brackets"));
        }
        return found ? found->toArray() : QJsonArray();
    }

    std::optional<Interval> interval(const char *name) const
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

    std::optional<QRectF> frame(const char *name) const
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
            refuse(name,
                   SceneText::tr("four numbers in brackets, left, lower, right and upper, the smaller ones first"));
        }
        return frame;
    }

private:
    SceneReader &m_reader;
    QJsonObject m_object;
    QString m_place;
    bool m_mayLack; ///< any of it
};

Parameters parametersOf(const Part &part)
{
    Parameters parameters;
    parameters.a = part.number("a", Bound::Positive);
    parameters.b = part.number("b", Bound::Positive);
    parameters.c = part.number("c", Bound::Magnitude);
    parameters.omega2 = part.number("omega2", Bound::Magnitude);
    parameters.theta20 = part.number("theta20", Bound::Magnitude);
    parameters.branch = part.choice("branch", kBranches);
    return parameters;
}

Sampling samplingOf(const Part &part)
{
    Sampling sampling;
    sampling.start = part.number("start", Bound::Magnitude);
    sampling.duration = part.number("duration", Bound::Positive);
    sampling.steps = part.integer("steps", kMostSteps);
    return sampling;
}

SolverSettings solverOf(const Part &part)
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

ColumnChoice columnChoiceOf(const Part &part)
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
    } else if (use != u"ignored") {
        part.refuse("use", SceneText::tr("\"time\", \"ignored\" or a channel such as \"theta3\" or \"R4_x_diff\""));
    }
    return choice;
}

Convention conventionOf(const Part &part)
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

ReferenceSource referenceOf(const Part &part, const QDir &folder)
{
    ReferenceSource reference;
    const QString file = part.text("file");
    if (file.isEmpty()) {
        part.refuse("file", SceneText::tr("the name of a file"));
    }
    reference.path = file.startsWith(u':') ? file : QDir::cleanPath(folder.absoluteFilePath(file));
    for (const Part &column : part.parts("columns")) {
        reference.columns.push_back(columnChoiceOf(column));
    }
    for (const Part &convention : part.parts("conventions")) {
        reference.conventions.push_back(conventionOf(convention));
    }
    return reference;
}

void readView(const Part &view, Scene &scene)
{
    const PlotSettings usual;
    scene.time = view.number("time", Bound::None, scene.sampling.start);
    scene.plots.error = view.choice("error", kErrorMeasures, usual.error);
    scene.plots.logarithmicError = view.flag("logarithmicError", usual.logarithmicError);
    scene.plots.roundingBand = view.flag("roundingBand", usual.roundingBand);
    scene.plots.abscissa = view.choice("abscissa", kAbscissae, usual.abscissa);
    const Part zoom = view.part("zoom", true);
    scene.zoom.time = zoom.interval("time");
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        scene.zoom.values[plot] = zoom.interval(plotName(plot).toLatin1().constData());
    }
    const Part mechanism = view.part("mechanism", true);
    scene.mechanism.velocity = mechanism.flag("velocity", false);
    scene.mechanism.acceleration = mechanism.flag("acceleration", false);
    scene.mechanism.path = mechanism.flag("path", false);
    scene.mechanism.names = mechanism.flag("names", false);
    scene.mechanism.dimensions = mechanism.flag("dimensions", false);
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
        {QStringLiteral("mechanism"),
         QJsonObject{{QStringLiteral("a"), scene.parameters.a},
                     {QStringLiteral("b"), scene.parameters.b},
                     {QStringLiteral("c"), scene.parameters.c},
                     {QStringLiteral("omega2"), scene.parameters.omega2},
                     {QStringLiteral("theta20"), scene.parameters.theta20},
                     {QStringLiteral("branch"), wordOf(kBranches, scene.parameters.branch)}}},
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
        {QStringLiteral("view"), viewJsonOf(scene)}};
    return QJsonDocument(merged(scene.asRead, object)).toJson();
}

std::variant<Scene, QString> sceneOf(const QByteArray &json, const QString &path)
{
    const QString shown = QDir::toNativeSeparators(path);
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
    SceneReader reader(shown);
    const Part whole(reader, scene.asRead, QString());
    if (version.toDouble() != kVersion) {
        whole.refuse("version", QString::number(kVersion));
    }
    scene.parameters = parametersOf(whole.part("mechanism"));
    scene.sampling = samplingOf(whole.part("sampling"));
    scene.solver = solverOf(whole.part("solver"));
    const Part extras(reader, scene.asRead, QString(), true);
    if (extras.value("reference")) {
        scene.reference = referenceOf(whole.part("reference"), QFileInfo(path).absoluteDir());
    }
    readView(extras.part("view", true), scene);
    if (reader.fault()) {
        return *reader.fault();
    }
    return scene;
}

std::variant<Scene, QString> readScene(const QString &path)
{
    const QString shown = QDir::toNativeSeparators(path);
    QFile file(path);
    if (QFileInfo(path).isDir()) {
        return SceneText::tr("%1 is a folder: choose a scene's file.").arg(shown);
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return SceneText::tr("%1 cannot be opened: %2.").arg(shown, file.errorString());
    }
    const QByteArray bytes = file.read(kLargestFile + 1);
    if (file.error() != QFileDevice::NoError) {
        return SceneText::tr("%1 cannot be read: %2.").arg(shown, file.errorString());
    }
    if (bytes.size() > kLargestFile) {
        return SceneText::tr("%1 is no scene: it is too large. Open a file that this program saved.").arg(shown);
    }
    return sceneOf(bytes, path);
}

std::optional<QString> writeScene(const Scene &scene, const QString &path)
{
    QSaveFile file(path); // renamed into place when complete
    if (file.open(QIODevice::WriteOnly)) {
        file.write(jsonOf(scene, path));
        if (file.commit()) {
            return std::nullopt;
        }
    }
    return SceneText::tr("%1 cannot be written: %2. Choose another name or folder.")
        .arg(QDir::toNativeSeparators(path), file.errorString());
}

} // namespace slidercrank
