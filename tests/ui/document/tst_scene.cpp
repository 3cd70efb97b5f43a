// SPDX-License-Identifier: GPL-3.0-or-later

// Scenes are read back to the last bit. Other files are refused with the place of the fault.

#include "tests/support/files.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/document/scene.h"
#include "ui/document/scene_link.h"
#include "ui/document/session.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <numbers>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace slidercrank;

namespace tst_scene
{

const QString kPath = "/data/scene.json";

/// Returns a scene with random numbers. Its choices follow from `i`: a few hundred scenes contain each enumerator, both
/// values of each flag, and scenes with and without each optional value.
Scene sceneNumber(int i, RandomMechanisms &random, const QString &folder)
{
    const auto flag = [i](int bit) { return (i >> bit) % 2 == 1; };
    const auto interval = [&random] {
        const double lower = random.uniform(-100.0, 100.0);
        return Interval{lower, lower + random.uniform(1e-3, 100.0)};
    };
    Scene scene;
    scene.parameters = random.next();
    scene.parameters.branch = static_cast<Branch>(flag(0));
    scene.sampling = {random.uniform(-10.0, 10.0), std::exp(random.uniform(-9.0, 9.0)), 1 + i};
    scene.solver = {static_cast<Method>(flag(1)),
                    {1 + i, std::exp(random.uniform(-30.0, 0.0)), static_cast<ToleranceKind>(flag(2)),
                     static_cast<WarmStart>(flag(3)), static_cast<Elimination>(flag(4))}};
    scene.pinned.assign(static_cast<std::size_t>(i % 5), random.next());
    scene.time = random.uniform(-10.0, 10.0);
    scene.plots = {static_cast<ErrorMeasure>(i % 3), flag(0), flag(2), static_cast<Abscissa>(flag(5))};
    scene.mechanism = {flag(0), flag(1), flag(2), flag(3), flag(4), flag(5), flag(6)};
    scene.alpha2 = flag(1) ? random.uniform(-1e3, 1e3) : 0.0;
    if (flag(3)) {
        scene.zoom.time = interval();
        scene.zoom.values[static_cast<std::size_t>(i) % kPlotCount] = interval();
        scene.mechanismFrame = QRectF(-30.5, -20.25, 60.125, 40.5);
    }
    if (flag(5)) {
        const std::vector<OutputChannel> channels = allOutputChannels();
        scene.table = {static_cast<TableStep>(flag(0)), random.uniform(0.1, 90.0), random.uniform(1e-3, 1.0), {}};
        for (int column = 0; column < i % 7; ++column) {
            scene.table->columns.push_back(channels[static_cast<std::size_t>(5 * column + i) % channels.size()]);
        }
    }
    if (flag(6)) {
        scene.notation = Notation{static_cast<Symbols>(flag(0)),
                                  {static_cast<LengthUnit>(i % 4), static_cast<AngleUnit>(i % 3)},
                                  static_cast<CrankSpeedUnit>((i / 3) % 3)};
    }
    if (flag(4)) {
        scene.reference.emplace();
        scene.reference->paths = {folder + "/a b/ñ \"2\".csv", "/elsewhere/results.csv", ":/data/inventor_sample.csv"};
        scene.reference->paths.resize(1 + i % 3);
        const Channel channel = channelAt(static_cast<std::size_t>(i) % kChannelCount);
        scene.reference->columns = {{1, ColumnRole::Ignored, {}, ""},
                                    {2, ColumnRole::Time, {}, "ms"},
                                    {5, ColumnRole::CrankAngle, {}, ""},
                                    {98, ColumnRole::Channel, channel, "rad/s²"}};
        for (int kind = 0; kind <= static_cast<int>(Convention::Kind::Axis); ++kind) {
            scene.reference->conventions.push_back(
                {static_cast<Convention::Kind>(kind), {channel, channelAt(35)}, random.uniform(0.001, 1000.0)});
        }
    }
    return scene;
}

Choices toChoices(const Scene &scene)
{
    return {scene.parameters, scene.sampling, scene.solver, nullptr, scene.pinned, scene.alpha2};
}

QJsonObject toObject(const Scene &scene)
{
    return QJsonDocument::fromJson(sceneToJson(scene, kPath)).object();
}

/// Returns a valid scene in which the value at a path of keys such as "mechanism.b" is replaced; Undefined removes that
/// key.
QByteArray sceneWith(const QString &keyPath, const QJsonValue &value)
{
    Scene scene;
    scene.reference = ReferenceSource{{"/data/results.csv"}, {ColumnChoice{}}, {Convention{}}};
    scene.zoom.time = Interval{0.25, 0.5};
    const auto replaced = [&value](auto &&self, QJsonObject object, QStringList keys) -> QJsonObject {
        const QString key = keys.takeFirst();
        const QJsonValue inner = keys.isEmpty() ? value : self(self, object.value(key).toObject(), keys);
        if (inner.isUndefined()) {
            object.remove(key);
        } else {
            object.insert(key, inner);
        }
        return object;
    };
    return QJsonDocument(replaced(replaced, toObject(scene), keyPath.split(u'.'))).toJson();
}

class TestScene : public QObject
{
    Q_OBJECT

private slots:
    void isReadBackAsItWasSaved()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("scene.json");
        RandomMechanisms random(20);
        for (int i = 0; i < 300; ++i) {
            const Scene scene = sceneNumber(i, random, folder.path());
            QCOMPARE(writeScene(scene, path), std::nullopt);
            const Scene back = std::get<Scene>(readScene(path));
            QVERIFY2(back == scene, contentOf(path).constData()); // to the last bit
            QCOMPARE(sceneToJson(back, path), contentOf(path));
        }
    }

    /// A link carries everything but files, pinned motions and what is drawn.
    void isReadBackFromALink()
    {
        RandomMechanisms random(20);
        for (int i = 0; i < 300; ++i) {
            Scene scene = sceneNumber(i, random, "/data");
            scene.reference.reset();
            scene.pinned.clear();
            scene.zoom = {};
            scene.mechanism = {};
            scene.mechanismFrame.reset();
            scene.table.reset();
            scene.notation.reset();
            const QString link = sceneLink(scene);
            QVERIFY2(isSceneLink(link) && isNamedAsScene(link), qPrintable(link));
            QVERIFY2(std::get<Scene>(readScene(link)) == scene, qPrintable(link));
        }
    }

    void isWrittenByHandInALink()
    {
        const auto sceneOf = [](const QString &link) { return std::get<Scene>(readScene(link)); };
        Scene scene = sceneOf("slidercrank.html#a=40&b=120&c=20&omega2=60rpm");
        QVERIFY((scene.parameters == Parameters{40.0, 120.0, 20.0, 2.0 * std::numbers::pi, 0.0, Branch::Open}));
        QCOMPARE(sceneLink(scene), "slidercrank.html#a=40&b=120&c=20&omega2=60rpm");
        scene = sceneOf("https://example.org/course/#b=12cm&theta20=90%C2%B0&branch=crossed&steps=72&time=50ms");
        QVERIFY((scene.parameters ==
                 Parameters{20.0, 120.0, 25.0, 2.0 * std::numbers::pi, std::numbers::pi / 2.0, Branch::Crossed}));
        QCOMPARE(scene.sampling.steps, 72);
        QCOMPARE(scene.time, 0.05);
        QVERIFY(!isSceneLink("results#1.csv") && !isSceneLink("slidercrank.html"));
    }

    void refusesLinksWithAReason_data()
    {
        QTest::addColumn<QString>("link");
        QTest::addColumn<QString>("part");
        QTest::newRow("unknown") << "#a=40&d=3"
                                 << "“d”, which is not a setting";
        QTest::newRow("no unit") << "#theta20=30"
                                 << "30deg or 30rad";
        QTest::newRow("wrong unit") << "#a=40deg"
                                    << "a=40deg";
        QTest::newRow("no number") << "#b=long"
                                   << "b=long";
        QTest::newRow("negative") << "#b=-3"
                                  << "The link says b=-3: b must be between 1e-9 and 1e12 mm.";
        QTest::newRow("negative, with a unit") << "#a=40&b=-3in"
                                               << "The link says b=-3in: b must be between 1e-9 and 1e12 mm.";
        QTest::newRow("no whole number") << "#steps=2.5"
                                         << "The link says steps=2.5: steps must be a whole number from 1 to 1e6.";
        QTest::newRow("branch") << "#branch=upper"
                                << "The link says branch=upper: that is no choice for branch.";
        QTest::newRow("twice") << "#a=40&a=50"
                               << "The link contains a more than once";
    }

    void refusesLinksWithAReason()
    {
        QFETCH(const QString, link);
        QFETCH(const QString, part);
        const auto outcome = readScene(link);
        QVERIFY(std::holds_alternative<QString>(outcome));
        QVERIFY2(std::get<QString>(outcome).contains(part), qPrintable(std::get<QString>(outcome)));
    }

    /// A former defect: "No such file or directory".
    void aPageWithoutSettingsIsTheInitialScene()
    {
        const auto outcome = readScene("https://example.org/slidercrank.html#");
        QVERIFY(std::holds_alternative<Scene>(outcome));
        QVERIFY(std::get<Scene>(outcome).parameters == Parameters());
        QVERIFY(!isSceneLink("motion#") && !isSceneLink("data.csv#"));
    }

    /// A scene opens its reference with its conventions and chosen columns, also after both files were moved together.
    void opensItsReferenceAgain()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("before/data"));
        const QString data = folder.filePath("before/data/results.csv");
        QVERIFY(QFile::copy(kSample, data));
        Session before;
        const Channel slider{R4x, Order::Position};
        Scene scene;
        scene.reference = ReferenceSource{
            {data},
            {{2, ColumnRole::Channel, slider, "cm"}},
            {{Convention::Kind::HalfTurn, {kPlottedChannels[0]}, 180.0}, {Convention::Kind::TimeShift, {}, 0.125}}};
        before.open(toChoices(scene), 0.0, scene.reference);
        AWAIT(before.reference());
        scene.reference = before.reference()->source;
        QCOMPARE(writeScene(scene, folder.filePath("before/scene.json")), std::nullopt);
        QVERIFY(QDir(folder.path()).rename("before", "after"));

        const Scene back = std::get<Scene>(readScene(folder.filePath("after/scene.json")));
        QCOMPARE(back.reference->paths, QStringList(folder.filePath("after/data/results.csv")));
        Session after;
        after.open(toChoices(back), back.time, back.reference);
        AWAIT(after.reference());
        const ReferenceData &dataBefore = before.reference()->data;
        const ReferenceData &dataAfter = after.reference()->data;
        QCOMPARE(dataAfter.time, dataBefore.time);
        QCOMPARE(dataAfter.time.front(), 0.125);
        QVERIFY(std::ranges::equal(dataAfter.series, dataBefore.series, {}, &ReferenceSeries::values,
                                   &ReferenceSeries::values));
        QVERIFY(dataAfter.find(slider)->values.front() > 500.0); // the column is taken as cm
        after.readAsPrinted();
        QCOMPARE(after.reference()->data.time.front(), 0.0);
    }

    void ignoresUnknownKeys()
    {
        const Scene scene = std::get<Scene>(parseScene(sceneWith("view.arrows", true), kPath));
        QVERIFY(!toObject(scene)[u"view"].toObject().contains(u"arrows"));
    }

    /// Each of these scenes has the mechanism of the sample, the time after two steps, and a zoom.
    void opensScenesOfEarlierVersions()
    {
        const QDir folder(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/tests/ui/document/scenes"));
        const QStringList names = folder.entryList(QDir::Files);
        QVERIFY(names.size() >= 3);
        for (const QString &name : names) {
            const auto outcome = parseScene(contentOf(folder.filePath(name)), folder.filePath(name));
            QVERIFY2(std::holds_alternative<Scene>(outcome), qPrintable(name));
            const Scene &scene = std::get<Scene>(outcome);
            QVERIFY(std::abs(scene.parameters.b - 60.0) < 1e-6); // the first version did not round b
            QCOMPARE(scene.sampling, Sampling());
            QCOMPARE(scene.solver.method, Method::ClosedForm);
            QVERIFY(scene.zoom.time && scene.zoom.time->lower > 0.05 && scene.zoom.time->upper < 0.95);
            QCOMPARE(scene.time, 0.01);
            QCOMPARE(scene.reference.value().paths, QStringList(folder.filePath("inventor_sample.csv")));
        }
    }

    void requiresNeitherReferenceNorView()
    {
        for (const char *keyPath : {"reference", "reference.columns", "kept", "view", "view.zoom", "view.error",
                                    "view.time", "view.mechanism", "view.mechanism.path"}) {
            for (const QJsonValue &value : {QJsonValue(QJsonValue::Undefined), QJsonValue()}) {
                const auto outcome = parseScene(sceneWith(QLatin1String(keyPath), value), kPath);
                QVERIFY2(std::holds_alternative<Scene>(outcome), keyPath);
            }
        }
        const QJsonArray frame{-99.1, -20, 1.123456789012345, 20}; // the right edge is rounded when it is read
        QVERIFY(std::holds_alternative<Scene>(parseScene(sceneWith("view.mechanism.frame", frame), kPath)));
        const auto scene = std::get<Scene>(parseScene(sceneWith("sampling.start", 3.0), kPath));
        QCOMPARE(scene.time, 0.0); // as saved
        QJsonObject whole = QJsonDocument::fromJson(sceneWith("sampling.start", 3.0)).object();
        whole.remove("view");
        QCOMPARE(std::get<Scene>(parseScene(QJsonDocument(whole).toJson(), kPath)).time, 3.0);
    }

    void refusesOtherFiles()
    {
        const auto checkRefusal = [](const QByteArray &json, const QString &part) {
            const auto outcome = parseScene(json, kPath);
            const QString *sentence = std::get_if<QString>(&outcome);
            QVERIFY2(sentence, json.constData());
            QVERIFY2(sentence->contains("scene.json") && sentence->endsWith(u'.') && !sentence->contains(u'\n'),
                     qPrintable(*sentence));
            QVERIFY2(sentence->contains(part), qPrintable(part + u'|' + *sentence));
        };
        struct Row {
            const char *keyPath;
            QJsonValue value;
            const char *inner = ""; ///< the key or index of the fault within the value
        };
        const QJsonObject mechanism = toObject(Scene()).value(u"mechanism").toObject();
        QJsonObject impossible = mechanism;
        impossible.insert("b", -1.0);
        const auto column = [](int number, const char *use) {
            return QJsonArray{QJsonObject{{"column", number}, {"use", use}, {"unit", ""}}};
        };
        const auto convention = [](const char *kind, const QJsonArray &channels, double amount) {
            return QJsonArray{QJsonObject{{"kind", kind}, {"channels", channels}, {"amount", amount}}};
        };
        const Row rows[] = {
            {"kept", QJsonArray{mechanism, impossible}, "[1].b"},
            {"kept", QJsonArray{65.0}, "[0]"},
            {"kept", mechanism},
            {"kept", QJsonArray{mechanism, mechanism, mechanism, mechanism, mechanism}},
            {"version", 0},
            {"mechanism.a", 0},
            {"mechanism.b", -1e-9},
            {"mechanism.b", 2e12},
            {"mechanism.b", "65"},
            {"mechanism.c", kInfinity},
            {"mechanism.omega2", -2e12},
            {"mechanism.branch", "left"},
            {"mechanism", "x"},
            {"sampling.duration", 0},
            {"sampling.steps", 1.5},
            {"sampling.steps", 0},
            {"sampling.steps", 1e9},
            {"solver.maxIterations", 0},
            {"solver.tolerance", -1},
            {"reference", "x"},
            {"reference", QJsonObject{{"file", QString()}}},
            {"reference.columns", "x"},
            {"reference.columns", QJsonArray{1}, "[0]"},
            {"reference.columns", column(0, "time"), "[0].column"},
            {"reference.columns", column(1, "theta7"), "[0].use"},
            {"reference.conventions", convention("upside-down", {}, 1.0), "[0].kind"},
            {"reference.conventions", convention("swapped-columns", {"theta3"}, 1.0), "[0].channels"},
            {"reference.conventions", convention("sign", {"x"}, -1.0), "[0].channels[0]"},
            {"reference.conventions", convention("time-unit", {}, 0.0), "[0].amount"},
            {"view.error", "miles"},
            {"view.roundingBand", 1},
            {"view.time", "now"},
            {"view.zoom.time", QJsonArray{2, 1}},
            {"view.zoom.time", QJsonArray{"1", 2}, "[0]"},
            {"view.zoom.plot_theta3", QJsonArray{2}},
            {"view.mechanism.frame", QJsonArray{0, 40, 60, -20}},
        };
        for (const auto &[keyPath, value, inner] : rows) {
            checkRefusal(sceneWith(keyPath, value), QStringLiteral("“%1%2”").arg(keyPath, inner));
        }
        for (const char *keyPath :
             {"mechanism", "mechanism.a", "mechanism.c", "mechanism.branch", "sampling", "sampling.steps", "solver",
              "solver.method", "solver.maxIterations", "solver.tolerance", "solver.elimination"}) {
            checkRefusal(sceneWith(keyPath, QJsonValue::Undefined), QStringLiteral("“%1” is missing,").arg(keyPath));
        }
        for (const auto &[json, part] : {std::pair<QByteArray, QString>{sceneWith("version", 2), "newer"},
                                         {sceneWith("version", 1e300), "newer"},
                                         {sceneWith("version", "1"), "not a scene"},
                                         {{}, "line 1: this is not JSON"},
                                         {"{\n\"version\": 1,\n}", "line 3: this is not JSON"},
                                         {QByteArray("\xff\xfe{\0}\0", 6), "not JSON"},
                                         {"[]", "not a scene"},
                                         {"{\"name\": 1}", "it has no “version”"}}) {
            checkRefusal(json, part);
        }
    }

    void reportsFilesThatCannotBeRead()
    {
        const QTemporaryDir folder;
        for (const auto &[path, reason] : {std::pair<QString, const char *>{"/nowhere/x.json", "cannot be opened"},
                                           {folder.path(), "is a folder"}}) {
            QVERIFY(std::get<QString>(readScene(path)).contains(reason));
        }
#ifdef Q_OS_UNIX
        const QString pipe = folder.filePath("pipe.slidercrank");
        QCOMPARE(mkfifo(qPrintable(pipe), S_IRUSR | S_IWUSR), 0);
        QVERIFY(std::get<QString>(readScene(pipe)).contains("is a pipe or a device")); // and does not wait for a writer
#endif
    }
};

const Suite<TestScene> suite("tst_scene");

} // namespace tst_scene

#include "tst_scene.moc"
