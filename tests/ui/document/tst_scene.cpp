// SPDX-License-Identifier: GPL-3.0-or-later

// A scene's file: what goes in comes out, to the last bit; what is no scene is refused in a sentence that says where.

#include "tests/support/random_mechanisms.h"
#include "tests/support/waiting.h"
#include "ui/document/scene.h"
#include "ui/document/session.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // b = 60 mm

QString writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        qFatal("cannot write %s", qPrintable(path));
    }
    return path;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The same bits, or both nothing.
bool isSame(double one, double other)
{
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other) ||
           (std::isnan(one) && std::isnan(other));
}

bool isSame(const std::vector<double> &one, const std::vector<double> &other)
{
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](double x, double y) { return isSame(x, y); });
}

bool isSame(const Trajectory &one, const Trajectory &other)
{
    bool same = isSame(one.time, other.time) && one.status == other.status && one.summary == other.summary;
    for (std::size_t channel = 0; channel < kChannelCount; ++channel) {
        same = same && isSame(one.values[channel], other.values[channel]);
    }
    return same;
}

bool isSame(const Parameters &one, const Parameters &other)
{
    return isSame(one.a, other.a) && isSame(one.b, other.b) && isSame(one.c, other.c) &&
           isSame(one.omega2, other.omega2) && isSame(one.theta20, other.theta20) && one.branch == other.branch;
}

template <typename Value>
Value oneOf(RandomMechanisms &random, std::initializer_list<Value> values)
{
    const auto at = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(values.size())));
    return values.begin()[at];
}

std::optional<Interval> randomInterval(RandomMechanisms &random)
{
    const double lower = random.uniform(-100.0, 100.0);
    return oneOf(random, {false, true}) ? std::optional(Interval{lower, lower + random.uniform(1e-3, 100.0)})
                                        : std::nullopt;
}

ReferenceSource randomReference(RandomMechanisms &random, const QString &folder)
{
    using Kind = Convention::Kind;
    ReferenceSource reference;
    for (std::size_t files = oneOf(random, {1, 1, 3}); files > 0; --files) {
        reference.paths +=
            oneOf(random, {folder + QStringLiteral("/results.csv"), folder + QStringLiteral("/a b/ñ \"2\".csv"),
                           QStringLiteral("/elsewhere/results.csv"), QStringLiteral(":/data/inventor_sample.csv")});
    }
    for (std::size_t column = 0; column < 3; ++column) {
        ColumnChoice choice;
        choice.column = column * 7;
        choice.role =
            oneOf(random, {ColumnRole::Ignored, ColumnRole::Time, ColumnRole::CrankAngle, ColumnRole::Channel});
        if (choice.role == ColumnRole::Channel) {
            choice.channel = channelAt(static_cast<std::size_t>(random.uniform(0.0, kChannelCount)));
        }
        choice.unit = oneOf<std::string>(random, {"", "rad/s²", "m"});
        reference.columns.push_back(choice);
    }
    for (int i = 0; i < 3; ++i) {
        Convention convention;
        convention.kind = oneOf(random, {Kind::AngleUnit, Kind::LengthUnit, Kind::TimeUnit, Kind::Sign, Kind::HalfTurn,
                                         Kind::WholeTurns, Kind::ZeroPoint, Kind::SwappedColumns, Kind::Branch,
                                         Kind::TimeShift, Kind::NotDerivative});
        convention.channels = {kPlottedChannels[1], channelAt(35)};
        convention.amount = random.uniform(0.001, 1000.0);
        reference.conventions.push_back(convention);
    }
    return reference;
}

Scene randomScene(RandomMechanisms &random, const QString &folder)
{
    Scene scene;
    scene.parameters = random.next();
    scene.sampling.start = random.uniform(-10.0, 10.0);
    scene.sampling.duration = std::exp(random.uniform(-9.0, 9.0));
    scene.sampling.steps = static_cast<int>(random.uniform(1.0, 300.0));
    scene.solver.method = oneOf(random, {Method::Newton, Method::ClosedForm});
    scene.solver.newton.maxIterations = static_cast<int>(random.uniform(1.0, 100.0));
    scene.solver.newton.tolerance = oneOf(random, {0.0, 1e-8, std::exp(random.uniform(-30.0, 0.0))});
    scene.solver.newton.toleranceKind = oneOf(random, {ToleranceKind::Absolute, ToleranceKind::Relative});
    scene.solver.newton.warmStart = oneOf(random, {WarmStart::Previous, WarmStart::Taylor});
    scene.solver.newton.elimination = oneOf(random, {Elimination::Dense, Elimination::Structured});
    if (oneOf(random, {false, true})) {
        scene.reference = randomReference(random, folder);
    }
    for (std::size_t i = oneOf(random, {0, 1, 4}); i > 0; --i) {
        scene.kept.push_back(random.next());
    }
    scene.time = scene.sampling.start + random.uniform(0.0, 1.0) * scene.sampling.duration;
    scene.plots.error = oneOf(random, {ErrorMeasure::Percent, ErrorMeasure::Absolute, ErrorMeasure::OfPeak});
    scene.plots.logarithmicError = oneOf(random, {false, true});
    scene.plots.roundingBand = oneOf(random, {false, true});
    scene.plots.abscissa = oneOf(random, {Abscissa::Time, Abscissa::CrankAngle});
    scene.zoom.time = randomInterval(random);
    scene.mechanism = {oneOf(random, {false, true}), oneOf(random, {false, true}), oneOf(random, {false, true}),
                       oneOf(random, {false, true}), oneOf(random, {false, true})};
    scene.mechanismFrame = oneOf<std::optional<QRectF>>(random, {std::nullopt, QRectF(-30.5, -20.25, 60.125, 40.5)});
    for (std::optional<Interval> &values : scene.zoom.values) {
        values = randomInterval(random);
    }
    return scene;
}

Choices choicesOf(const Scene &scene)
{
    return {scene.parameters, scene.sampling, scene.solver, nullptr, scene.kept};
}

/// A good scene with one value of it replaced, at "mechanism.b"; Undefined: removed.
QByteArray sceneWith(const QString &place, const QJsonValue &value)
{
    Scene scene;
    scene.reference = ReferenceSource{{QStringLiteral("/data/results.csv")}, {ColumnChoice{}}, {Convention{}}};
    scene.zoom.time = Interval{0.25, 0.5};
    QJsonObject whole = QJsonDocument::fromJson(jsonOf(scene, QStringLiteral("/data/scene.json"))).object();
    const QStringList keys = place.split(u'.');
    std::vector<QJsonObject> objects{whole};
    for (const QString &key : keys.first(keys.size() - 1)) {
        objects.push_back(objects.back().value(key).toObject());
    }
    QJsonValue inner = value;
    for (qsizetype i = keys.size() - 1; i >= 0; --i) {
        QJsonObject &object = objects[static_cast<std::size_t>(i)];
        if (inner.isUndefined()) {
            object.remove(keys[i]);
        } else {
            object.insert(keys[i], inner);
        }
        inner = object;
    }
    return QJsonDocument(inner.toObject()).toJson();
}

} // namespace

class TestScene : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void comesBackAsItWasSaved()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        RandomMechanisms random(20);
        for (int i = 0; i < 500; ++i) {
            const Scene scene = randomScene(random, folder.path());
            QCOMPARE(writeScene(scene, path), std::nullopt);
            const std::variant<Scene, QString> outcome = readScene(path);
            const QString *sentence = std::get_if<QString>(&outcome);
            QVERIFY2(!sentence, sentence ? qPrintable(*sentence) : "");
            const Scene &back = std::get<Scene>(outcome);
            QVERIFY2(isSame(back.parameters, scene.parameters), contentOf(path).constData());
            QVERIFY(isSame(back.sampling.start, scene.sampling.start));
            QVERIFY(isSame(back.sampling.duration, scene.sampling.duration));
            QCOMPARE(back.sampling.steps, scene.sampling.steps);
            QVERIFY(back.solver == scene.solver);
            QVERIFY(back.kept == scene.kept);
            QVERIFY(isSame(back.time, scene.time));
            QVERIFY(back.plots == scene.plots);
            QVERIFY(back.zoom == scene.zoom);
            QVERIFY(back.mechanism == scene.mechanism);
            QVERIFY(back.mechanismFrame == scene.mechanismFrame);
            QCOMPARE(back.reference.has_value(), scene.reference.has_value());
            if (scene.reference) {
                QCOMPARE(back.reference->paths, scene.reference->paths);
                QVERIFY(back.reference->conventions == scene.reference->conventions);
                QCOMPARE(back.reference->columns.size(), scene.reference->columns.size());
                for (std::size_t column = 0; column < scene.reference->columns.size(); ++column) {
                    const ColumnChoice &one = back.reference->columns[column];
                    const ColumnChoice &other = scene.reference->columns[column];
                    QVERIFY(one.column == other.column && one.role == other.role && one.channel == other.channel &&
                            one.unit == other.unit);
                }
            }
            QCOMPARE(jsonOf(back, path), contentOf(path));
        }
    }

    void keepsEveryDigitOfAnyNumber()
    {
        std::mt19937_64 engine(7);
        const QString path = QStringLiteral("/scene.json");
        for (int i = 0; i < 2000; ++i) {
            Scene scene;
            scene.parameters.c = std::bit_cast<double>(engine());
            if (!(std::abs(scene.parameters.c) <= kLargestParameter)) {
                continue;
            }
            const std::variant<Scene, QString> outcome = sceneOf(jsonOf(scene, path), path);
            QVERIFY(std::holds_alternative<Scene>(outcome));
            QVERIFY2(isSame(std::get<Scene>(outcome).parameters.c, scene.parameters.c),
                     qPrintable(QString::number(scene.parameters.c, 'g', 17)));
        }
    }

    void givesTheSameMotionToTheLastBit()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        RandomMechanisms random(21);
        for (int i = 0; i < 40; ++i) {
            Scene scene = randomScene(random, folder.path());
            scene.reference.reset();
            Session before;
            before.open(choicesOf(scene), scene.time, std::nullopt);
            QCOMPARE(writeScene(scene, path), std::nullopt);
            const std::variant<Scene, QString> outcome = readScene(path);
            QVERIFY(std::holds_alternative<Scene>(outcome));
            Session after;
            after.open(choicesOf(std::get<Scene>(outcome)), std::get<Scene>(outcome).time, std::nullopt);
            QVERIFY(after.result()->sampling == scene.sampling);
            QVERIFY(isSame(after.result()->trajectory, before.result()->trajectory));
            QVERIFY(isSame(after.time(), scene.time));
        }
    }

    void readsItsReferenceAsItWasReadBefore()
    {
        const QTemporaryDir folder;
        const QString data = folder.filePath(QStringLiteral("results.csv"));
        QVERIFY(QFile::copy(kSample, data));
        const QString path = folder.filePath(QStringLiteral("scene.json"));

        Session before;
        QSignalSpy loaded(&before, &Session::referenceLoaded);
        before.loadReference(data);
        QVERIFY(loaded.wait(kPatience));
        before.apply({Convention::Kind::HalfTurn, {kPlottedChannels[0]}, 180.0});
        before.apply({Convention::Kind::TimeShift, {}, 0.125});
        Scene scene;
        scene.parameters = before.parameters();
        scene.solver = before.solver();
        scene.reference = sourceOf(*before.reference());
        QCOMPARE(writeScene(scene, path), std::nullopt);
        QCOMPARE(QJsonDocument::fromJson(contentOf(path)).object()[u"reference"][u"file"].toString(),
                 QStringLiteral("results.csv"));

        const Scene back = std::get<Scene>(readScene(path));
        Session after;
        QSignalSpy opened(&after, &Session::opened);
        after.open(choicesOf(back), back.time, back.reference);
        QVERIFY(opened.wait(kPatience));
        QCOMPARE(opened.first().first().toString(), QString());
        QCOMPARE(after.reference()->conventions.size(), std::size_t(2));
        QVERIFY(isSame(after.result()->atReference, before.result()->atReference));
        QCOMPARE(after.result()->comparison.size(), before.result()->comparison.size());
        for (std::size_t i = 0; i < before.result()->comparison.size(); ++i) {
            QVERIFY(after.result()->comparison[i].maxAbs == before.result()->comparison[i].maxAbs);
        }
        after.readAsPrinted();
        QCOMPARE(after.reference()->conventions.size(), std::size_t(0));
    }

    void keepsTheColumnsThatAPersonChose()
    {
        const QTemporaryDir folder;
        ReferenceSource source;
        source.paths = {writeFile(folder.filePath(QStringLiteral("two.csv")), "t,first,second\n0,85,1\n0.5,45,2\n")};
        source.columns = {{1, ColumnRole::Channel, {R4x, Order::Position}, "m"}};
        Scene scene;
        scene.reference = source;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        QCOMPARE(writeScene(scene, path), std::nullopt);
        const Scene back = std::get<Scene>(readScene(path));
        Session session;
        QSignalSpy opened(&session, &Session::opened);
        session.open(choicesOf(back), back.time, back.reference);
        QVERIFY(opened.wait(kPatience));
        QVERIFY(session.reference());
        const ReferenceSeries *series = session.reference()->data.find({R4x, Order::Position});
        QVERIFY(series);
        QCOMPARE(series->values.front(), 85'000.0);
        QCOMPARE(sourceOf(*session.reference()).columns.size(), std::size_t(1));
    }

    void findsItsReferenceWhereBothWereMoved()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("before/data")));
        Scene scene;
        scene.reference = ReferenceSource{{folder.filePath(QStringLiteral("before/data/results.csv"))}, {}, {}};
        QCOMPARE(writeScene(scene, folder.filePath(QStringLiteral("before/scene.json"))), std::nullopt);
        QVERIFY(QDir(folder.path()).rename(QStringLiteral("before"), QStringLiteral("after")));
        const Scene back = std::get<Scene>(readScene(folder.filePath(QStringLiteral("after/scene.json"))));
        QCOMPARE(back.reference->paths, QStringList(folder.filePath(QStringLiteral("after/data/results.csv"))));
    }

    void opensWithoutAReferenceThatIsGone()
    {
        Session session;
        session.loadReference(kSample);
        QSignalSpy opened(&session, &Session::opened);
        Choices choices;
        choices.parameters.b = 70.0;
        session.open(choices, 0.5, ReferenceSource{{QStringLiteral("/nowhere/results.csv")}, {}, {}});
        QVERIFY(opened.wait(kPatience));
        QVERIFY(opened.first().first().toString().contains(QLatin1String("results.csv")));
        QCOMPARE(session.parameters().b, 70.0);
        QCOMPARE(session.time(), 0.5);
        QVERIFY(!session.reference());
    }

    void openingCannotBeUndone()
    {
        Session session;
        Choices choices;
        choices.parameters.b = 70.0;
        session.setParameters(choices.parameters);
        QVERIFY(!session.undoStack().isClean());
        choices.parameters.b = 80.0;
        session.open(choices, 0.0, std::nullopt);
        QVERIFY(session.undoStack().isClean());
        QVERIFY(!session.undoStack().canUndo() && !session.undoStack().canRedo());
        QCOMPARE(session.result()->mechanism.b(), 80.0);
    }

    void keepsTheKeysThatItDoesNotKnow()
    {
        QJsonObject whole = QJsonDocument::fromJson(sceneWith(QStringLiteral("view.arrows"), true)).object();
        whole.insert(QStringLiteral("notes"), QJsonArray{QStringLiteral("of a person"), 1});
        const QString path = QStringLiteral("/data/scene.json");
        std::variant<Scene, QString> outcome = sceneOf(QJsonDocument(whole).toJson(), path);
        QVERIFY(std::holds_alternative<Scene>(outcome));
        Scene &scene = std::get<Scene>(outcome);
        scene.parameters.b = 33.0;
        scene.reference.reset();
        scene.zoom = {};
        const QJsonObject written = QJsonDocument::fromJson(jsonOf(scene, path)).object();
        QCOMPARE(written[u"notes"], whole[u"notes"]);
        QCOMPARE(written[u"view"][u"arrows"], QJsonValue(true));
        QCOMPARE(written[u"mechanism"][u"b"], QJsonValue(33.0));
        QVERIFY(written[u"reference"].isNull());
        QVERIFY(written[u"view"][u"zoom"][u"time"].isNull());
    }

    /// Each was saved by an earlier state of the program: at Table 1, the sample's mechanism taken over, two steps on,
    /// the time zoomed in where the wheel was turned.
    void opensWhatEarlierVersionsSaved()
    {
        const QDir folder(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/tests/ui/document/scenes"));
        const QStringList names = folder.entryList(QDir::Files);
        QVERIFY(names.size() >= 3);
        for (const QString &name : names) {
            const QByteArray saved = contentOf(folder.filePath(name));
            const std::variant<Scene, QString> outcome = sceneOf(saved, folder.filePath(name));
            QVERIFY2(std::holds_alternative<Scene>(outcome), qPrintable(name));
            Scene scene = std::get<Scene>(outcome);
            QVERIFY(std::abs(scene.parameters.b - 60.0) < 1e-6); // the first did not round it
            QCOMPARE(scene.sampling, Sampling());
            QCOMPARE(scene.solver.method, Method::ClosedForm);
            QVERIFY(scene.zoom.time && scene.zoom.time->lower > 0.05 && scene.zoom.time->upper < 0.95);
            QCOMPARE(scene.time, 0.01);
            QVERIFY(scene.reference);
            QCOMPARE(scene.reference->paths, QStringList(folder.filePath(QStringLiteral("inventor_sample.csv"))));

            scene.reference->paths = {kSample};
            Session session;
            QSignalSpy opened(&session, &Session::opened);
            session.open({scene.parameters, scene.sampling, scene.solver, nullptr}, scene.time, scene.reference);
            QVERIFY(opened.wait(kPatience));
            QCOMPARE(opened.first().first().toString(), QString());
            for (const ChannelComparison &channel : session.result()->comparison) {
                QCOMPARE(channel.verdict, Verdict::Agrees);
            }
        }
    }

    void needsNeitherReferenceNorView()
    {
        for (const char *place :
             {"reference", "kept", "view", "view.zoom", "view.error", "view.time", "reference.columns.x"}) {
            const std::variant<Scene, QString> outcome =
                sceneOf(sceneWith(QLatin1String(place), QJsonValue::Undefined), QStringLiteral("/data/scene.json"));
            QVERIFY2(std::holds_alternative<Scene>(outcome) || QByteArray(place).endsWith('x'), place);
        }
    }

    void refusesWhatIsNoScene_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QStringList>("told");
        const auto broken = [](const char *name, const char *place, const QJsonValue &value, const QStringList &told) {
            QTest::newRow(name) << sceneWith(QLatin1String(place), value) << told;
        };
        const QJsonValue none = QJsonValue::Undefined;
        const double infinity = std::numeric_limits<double>::infinity();
        const QJsonObject mechanism = QJsonDocument::fromJson(jsonOf(Scene(), QStringLiteral("/data/scene.json")))
                                          .object()[u"mechanism"]
                                          .toObject();
        QJsonObject impossible = mechanism;
        impossible.insert(QStringLiteral("b"), -1.0);
        broken("a kept mechanism that is none", "kept", QJsonArray{mechanism, impossible},
               {"\"kept[1].b\"", "1e-9"});
        broken("kept numbers", "kept", QJsonArray{65.0}, {"\"kept[0]\"", "braces"});
        broken("a kept mechanism for a list", "kept", mechanism, {"\"kept\"", "a list"});
        broken("too many kept", "kept", QJsonArray{mechanism, mechanism, mechanism, mechanism, mechanism},
               {"\"kept\"", "at most 4"});
        QTest::newRow("empty") << QByteArray() << QStringList{"line 1", "not JSON"};
        QTest::newRow("text") << QByteArray("hello") << QStringList{"line 1", "not JSON"};
        QTest::newRow("cut off") << sceneWith(QStringLiteral("x"), 1).left(200) << QStringList{"line ", "not JSON"};
        QTest::newRow("a comma too many") << QByteArray("{\n\"version\": 1,\n}") << QStringList{"line 3", "not JSON"};
        QTest::newRow("bytes") << QByteArray("\xff\xfe{\0}\0", 6) << QStringList{"not JSON"};
        QTest::newRow("a list") << QByteArray("[]") << QStringList{"no scene"};
        QTest::newRow("another JSON") << QByteArray("{\"name\": 1}") << QStringList{"no scene", "version"};
        broken("newer", "version", 2, {"newer", "version 2"});
        broken("much newer", "version", 1e300, {"newer"});
        broken("version of text", "version", QStringLiteral("1"), {"no scene"});
        broken("version 0", "version", 0, {"\"version\" must be 1"});
        for (const char *place :
             {"mechanism",        "mechanism.a",          "mechanism.b",      "mechanism.c",
              "mechanism.omega2", "mechanism.theta20",    "mechanism.branch", "sampling",
              "sampling.start",   "sampling.duration",    "sampling.steps",   "solver",
              "solver.method",    "solver.maxIterations", "solver.tolerance", "solver.toleranceKind",
              "solver.warmStart", "solver.elimination",   "reference.file",   "reference.columns"}) {
            QTest::addRow("without %s", place)
                << sceneWith(QLatin1String(place), none) << QStringList{QStringLiteral("\"%1\" is missing").arg(place)};
        }
        broken("not finite", "mechanism.c", infinity, {"\"mechanism.c\" is missing"}); // JSON has no such number
        broken("no length", "mechanism.a", 0, {"\"mechanism.a\"", "1e-9"});
        broken("negative length", "mechanism.b", -1e-9, {"\"mechanism.b\"", "1e-9"});
        broken("too long", "mechanism.b", 2e12, {"\"mechanism.b\"", "1e12"});
        broken("too fast", "mechanism.omega2", -2e12, {"\"mechanism.omega2\"", "1e12"});
        broken("a number in quotes", "mechanism.b", QStringLiteral("65"), {"\"mechanism.b\"", "1e-9 mm"});
        broken("another branch", "mechanism.branch", QStringLiteral("left"), {"\"mechanism.branch\"", "\"crossed\""});
        broken("mechanism of text", "mechanism", QStringLiteral("x"), {"\"mechanism\"", "object"});
        broken("no duration", "sampling.duration", 0, {"\"sampling.duration\"", "greater than 0"});
        broken("half a step", "sampling.steps", 1.5, {"\"sampling.steps\"", "whole number"});
        broken("too many steps", "sampling.steps", 1e9, {"\"sampling.steps\"", "1000000"});
        broken("no iterations", "solver.maxIterations", 0, {"\"solver.maxIterations\"", "whole number"});
        broken("negative tolerance", "solver.tolerance", -1, {"\"solver.tolerance\"", "not less than 0"});
        broken("reference of text", "reference", QStringLiteral("x"), {"\"reference\"", "object"});
        broken("no file", "reference.file", QString(), {"\"reference.file\"", "name of a file"});
        broken("columns of text", "reference.columns", QStringLiteral("x"), {"\"reference.columns\"", "list"});
        broken("a column of text", "reference.columns", QJsonArray{1}, {"\"reference.columns[0]\"", "object"});
        broken("column 0", "reference.columns", QJsonArray{QJsonObject{{"column", 0}, {"use", "time"}, {"unit", ""}}},
               {"\"reference.columns[0].column\"", "from 1"});
        broken("an unknown channel", "reference.columns",
               QJsonArray{QJsonObject{{"column", 1}, {"use", "theta7"}, {"unit", ""}}},
               {"\"reference.columns[0].use\"", "channel"});
        const auto convention = [](const char *kind, const QJsonArray &channels, double amount) {
            return QJsonArray{QJsonObject{{"kind", kind}, {"channels", channels}, {"amount", amount}}};
        };
        broken("an unknown convention", "reference.conventions", convention("upside-down", {}, 1.0),
               {"\"reference.conventions[0].kind\"", "\"half-turn\""});
        broken("a swap of one", "reference.conventions", convention("swapped-columns", {"theta3"}, 1.0),
               {"\"reference.conventions[0].channels\"", "two channels"});
        broken("a convention of no channel", "reference.conventions", convention("sign", {"x"}, -1.0),
               {"\"reference.conventions[0].channels\"", "theta3"});
        broken("instants all at once", "reference.conventions", convention("time-unit", {}, 0.0),
               {"\"reference.conventions[0].amount\"", "greater than 0"});
        broken("an unknown measure", "view.error", QStringLiteral("miles"), {"\"view.error\"", "\"of-peak\""});
        broken("neither true nor false", "view.roundingBand", 1, {"\"view.roundingBand\"", "true or false"});
        broken("time of text", "view.time", QStringLiteral("now"), {"\"view.time\"", "number"});
        broken("zoom backwards", "view.zoom.time", QJsonArray{2, 1}, {"\"view.zoom.time\"", "smaller one first"});
        broken("frame upside down", "view.mechanism.frame", QJsonArray{0, 40, 60, -20},
               {"\"view.mechanism.frame\"", "four numbers"});
        broken("zoom of one", "view.zoom.plot_theta3", QJsonArray{2}, {"\"view.zoom.plot_theta3\"", "two numbers"});
    }

    void refusesWhatIsNoScene()
    {
        QFETCH(const QByteArray, json);
        QFETCH(const QStringList, told);
        const std::variant<Scene, QString> outcome = sceneOf(json, QStringLiteral("/data/scene.json"));
        const QString *sentence = std::get_if<QString>(&outcome);
        QVERIFY(sentence);
        QVERIFY2(sentence->contains(QLatin1String("scene.json")), qPrintable(*sentence));
        QVERIFY2(!sentence->contains(u'\n') && sentence->endsWith(u'.'), qPrintable(*sentence));
        for (const QString &part : told) {
            QVERIFY2(sentence->contains(part), qPrintable(*sentence));
        }
    }

    void saysWhyAFileCannotBeOpened()
    {
        const QTemporaryDir folder;
        const QString large = writeFile(folder.filePath(QStringLiteral("large.json")), QByteArray(2 << 20, ' '));
        for (const auto &[path, told] : {std::pair{QStringLiteral("/nowhere/x.json"), "cannot be opened"},
                                         std::pair{folder.path(), "is a folder"}, std::pair{large, "too large"}}) {
            const std::variant<Scene, QString> outcome = readScene(path);
            QVERIFY(std::holds_alternative<QString>(outcome));
            QVERIFY2(std::get<QString>(outcome).contains(QLatin1String(told)), qPrintable(std::get<QString>(outcome)));
        }
    }

    /// Whoever has the old file open still reads all of it: the new one was never written into its place.
    void isReplacedInOneStep()
    {
#ifdef Q_OS_WIN
        QSKIP("an open file cannot be replaced there");
#endif
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        QCOMPARE(writeScene(Scene(), path), std::nullopt);
        const QByteArray before = contentOf(path);
        QFile old(path);
        QVERIFY(old.open(QIODevice::ReadOnly));
        Scene other;
        other.parameters.b = 33.0;
        QCOMPARE(writeScene(other, path), std::nullopt);
        QCOMPARE(old.readAll(), before);
        QVERIFY(contentOf(path) != before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"scene.json"});
    }

    void leavesNothingWhereItCannotWrite()
    {
        const QTemporaryDir folder;
        const std::optional<QString> missing = writeScene(Scene(), folder.filePath(QStringLiteral("no/scene.json")));
        QVERIFY(missing && missing->contains(QLatin1String("cannot be written")));
        QVERIFY(!QFileInfo::exists(folder.filePath(QStringLiteral("no"))));

        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("taken.json"))); // a folder of that name
        QVERIFY(writeScene(Scene(), folder.filePath(QStringLiteral("taken.json"))).has_value());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
    }

    void leavesTheOldOneInAReadOnlyFolder()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        QCOMPARE(writeScene(Scene(), path), std::nullopt);
        const QByteArray before = contentOf(path);
        QVERIFY(QFile::setPermissions(folder.path(), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
        const bool isWritable = QFileInfo(folder.path()).isWritable(); // for an administrator everything is
        Scene other;
        other.parameters.b = 33.0;
        const std::optional<QString> problem = writeScene(other, path);
        QFile::setPermissions(folder.path(), QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
        if (isWritable) {
            QSKIP("no folder is read-only for this user");
        }
        QVERIFY(problem && problem->contains(QLatin1String("scene.json")));
        QCOMPARE(contentOf(path), before);
    }
};

QTEST_MAIN(TestScene)
#include "tst_scene.moc"
