// SPDX-License-Identifier: GPL-3.0-or-later

// The program as a person or a script meets it: the real executable, its arguments, its two streams, its exit status.

#include "tests/support/waiting.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <numbers>
#include <vector>

namespace
{

constexpr double kDegree = std::numbers::pi / 180.0;

struct Outcome {
    int status = -1;
    QByteArray out;
    QByteArray err;
};

QProcessEnvironment withoutDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    return environment;
}

/// `input`: what stands on standard input.
Outcome run(const QStringList &arguments, const QProcessEnvironment &environment = withoutDisplay(),
            const QByteArray &input = {})
{
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
    process.write(input);
    process.closeWriteChannel();
    Outcome outcome;
    if (process.waitForFinished(slidercrank::kPatience) && process.exitStatus() == QProcess::NormalExit) {
        outcome.status = process.exitCode();
    }
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

Outcome run(const QString &line)
{
    return run(QProcess::splitCommand(line));
}

struct Table {
    QByteArrayList header;
    std::vector<QByteArrayList> cells;

    double at(std::size_t row, const char *name) const
    {
        const qsizetype column = header.indexOf(name);
        return column < 0 ? std::numeric_limits<double>::infinity() : cells[row][column].toDouble();
    }
};

Table tableOf(const QByteArray &csv)
{
    Table table;
    for (const QByteArray &line : csv.split('\n')) {
        if (line.isEmpty()) {
            continue;
        }
        if (table.header.isEmpty()) {
            table.header = line.split(',');
        } else {
            table.cells.push_back(line.split(','));
        }
    }
    return table;
}

/// The six plotted channels straight from the textbook (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15): mm, rad,
/// s.
struct Textbook {
    double theta3, theta3Dot, theta3DDot;
    double R4x, R4xDot, R4xDDot;
};

Textbook textbook(double a, double b, double c, double omega2, double theta2, bool crossed)
{
    const double lifted = std::asin((c - a * std::sin(theta2)) / b);
    Textbook at{};
    at.theta3 = crossed ? std::numbers::pi - lifted : lifted;
    const double s = b * std::cos(at.theta3);
    const double h = b * std::sin(at.theta3);
    at.theta3Dot = -a * omega2 * std::cos(theta2) / s;
    at.theta3DDot = (a * omega2 * omega2 * std::sin(theta2) + h * at.theta3Dot * at.theta3Dot) / s;
    at.R4x = a * std::cos(theta2) + s;
    at.R4xDot = -a * omega2 * std::sin(theta2) - h * at.theta3Dot;
    at.R4xDDot = -a * omega2 * omega2 * std::cos(theta2) - s * at.theta3Dot * at.theta3Dot - h * at.theta3DDot;
    return at;
}

/// Empty when near enough, else what a failed comparison has to tell.
QByteArray awayFrom(double actual, double expected, double tolerance, const char *name, std::size_t row)
{
    const double difference = actual - expected;
    if (std::abs(difference) <= tolerance) {
        return {};
    }
    return QStringLiteral("%1, row %2: %3, expected %4, difference %5, tolerance %6")
        .arg(QLatin1String(name))
        .arg(row)
        .arg(actual, 0, 'g', 17)
        .arg(expected, 0, 'g', 17)
        .arg(difference)
        .arg(tolerance)
        .toUtf8();
}

/// The exact motion of Table 1 with its lengths times `scale`, as a program prints it: `timeText` and `text` make
/// cells.
template <typename TimeText, typename Text>
QByteArray printedFile(double scale, int perSecond, TimeText timeText, Text text)
{
    QByteArray file = "time,theta3,R4_x,theta3_diff,R4_x_diff,theta3_diff2,R4_x_diff2\n";
    for (int i = 0; i <= 2 * perSecond; ++i) {
        const double t = static_cast<double>(i) / perSecond;
        const double omega2 = 2.0 * std::numbers::pi;
        const Textbook at = textbook(20.0 * scale, 65.0 * scale, 25.0 * scale, omega2, omega2 * t, false);
        file += timeText(t);
        for (const double value :
             {at.theta3 / kDegree, at.R4x, at.theta3Dot / kDegree, at.R4xDot, at.theta3DDot / kDegree, at.R4xDDot}) {
            file += ',' + text(value);
        }
        file += '\n';
    }
    return file;
}

QString sample()
{
    return QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");
}

QString authorsFile()
{
    return QStringLiteral(SLIDERCRANK_SOURCE_DIR "/../shared/reference/InventorData.csv");
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A scene as the window saves it, of a crossed mechanism with b = 60 mm; the plots are zoomed in.
QByteArray sceneText(const QByteArray &reference = "null")
{
    return R"({"version": 1,
        "mechanism": {"a": 20, "b": 60, "c": 25, "omega2": 6.283185307179586, "theta20": 0.5, "branch": "crossed"},
        "sampling": {"start": 0.25, "duration": 2, "steps": 10},
        "solver": {"method": "closed-form", "maxIterations": 7, "tolerance": 1e-6, "toleranceKind": "absolute",
                   "warmStart": "previous", "elimination": "structured"},
        "reference": )" +
           reference + R"(, "view": {"time": 0.75, "error": "absolute", "zoom": {"time": [0.5, 1.5]}}})";
}

QString writeFile(const QString &path, const QByteArray &content)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? path : QString();
}

/// Table 1's motion to six digits, θ3 in radians under a heading that does not say so.
QString fileInRadians(const QTemporaryDir &folder)
{
    const Table table = tableOf(run(QStringLiteral("solve --channels theta3,R4_x,R4_x_diff")).out);
    QByteArray csv("time,theta3,R4_x,R4_x_diff\n");
    for (std::size_t row = 0; row < table.cells.size(); ++row) {
        csv += table.cells[row][0] + ',' + QByteArray::number(table.at(row, "theta3") * kDegree, 'g', 6) + ',' +
               QByteArray::number(table.at(row, "R4_x"), 'g', 6) + ',' +
               QByteArray::number(table.at(row, "R4_x_diff"), 'g', 6) + '\n';
    }
    return writeFile(folder.filePath(QStringLiteral("radians.csv")), csv);
}

/// Those columns of the sample, the time first, in a file of its own.
QString plotOfSample(const QTemporaryDir &folder, const char *name, const QList<int> &columns, int everySo = 1)
{
    QByteArray plot;
    const QByteArrayList lines = contentOf(sample()).replace("\xEF\xBB\xBF", "").trimmed().split('\n');
    for (qsizetype line = 0; line < lines.size(); ++line) {
        const QByteArrayList cells = lines[line].trimmed().split(',');
        QByteArrayList kept{cells.first()};
        for (const int column : columns) {
            kept << cells.value(column);
        }
        plot += line == 0 || (line - 1) % everySo == 0 ? kept.join(',') + '\n' : QByteArray();
    }
    return writeFile(folder.filePath(QLatin1String(name)), plot);
}

bool isOneLine(const QByteArray &text)
{
    return text.count('\n') == 1 && text.endsWith('\n');
}

} // namespace

class TestCommandLine : public QObject
{
    Q_OBJECT

private slots:
    void solvesTheReportsStudyByDefault();
    void writesChannelsInTheOrderOfTheCoordinates();
    void writesSeventeenSignificantDigits();
    void writesUnitsThatAreNotTheAuthorsBehindTheName();
    void putsTheInstantsWhereTheyAreAskedFor();
    void agreesWithTheTextbook_data();
    void agreesWithTheTextbook();
    void printsWhatExistsWhereTheMechanismCannotBeAssembled();
    void printsThePositionWhereTheDerivativesDoNotExist();
    void putsAssemblyBeforeSingularity();
    void tellsWhenNewtonDoesNotConverge();
    void solvesLengthsOfAnySizeToARelativeTolerance();
    void writesJson();
    void writesNullForWhatDoesNotExist();
    void understandsAUnitBehindANumber();
    void findsTheInstantOfACrankAngle_data();
    void findsTheInstantOfACrankAngle();
    void refusesAWrongCommandLine_data();
    void refusesAWrongCommandLine();
    void writesTheSameToAFile();
    void writesIntoAPipeWithoutReplacingIt();
    void leavesNothingBehindWhereItCannotWrite();
    void readsWhatItWrites_data();
    void readsWhatItWrites();
    void comparesTheSample();
    void comparesTheSampleInJson();
    void comparesTheSampleInCsv();
    void saysWhyColumnsAreNotUsed();
    void comparesSeveralFiles();
    void comparesTheFilesThatItCanRead();
    void tellsRoundingFromDifference_data();
    void tellsRoundingFromDifference();
    void saysWhatBoundsTheMotion();
    void saysWhoseMotionADifferentFileIs();
    void saysInJsonWhyAFileDiffers();
    void itsSentencesAgreeWithEachOther_data();
    void itsSentencesAgreeWithEachOther();
    void saysWhatAFileMeansOtherwise();
    void neverOverwritesWhatItReads();
    void identifiesTheAuthorsFile_data();
    void identifiesTheAuthorsFile();
    void identifiesInWordsAndGoesOnWithIt();
    void identifiesWhatReadsOtherwise();
    void identifiesNoMechanismThatItWouldRefuse_data();
    void identifiesNoMechanismThatItWouldRefuse();
    void saysWhatAFileCannotFix();
    void namesTheMirrorImageOfASlider();
    void saysWhenItFindsNoMechanism();
    void identifiesSeveralFiles();
    void readsStandardInput();
    void joinsFilesOfOneMotion();
    void saysWhyFilesAreNotOfOneMotion();
    void takesColumnsForWhatIsSaid();
    void readsATableByTheCranksAngle_data();
    void readsATableByTheCranksAngle();
    void knowsNoSpeedOfATableWithoutDerivatives();
    void takesTheSpeedFromTheDerivatives();
    void saysWhereTheAnglesAreCountedFrom();
    void saysWhatIsWrongWithAFile();
    void warnsOfSkippedRowsAndIgnoredColumns();
    void saysWhichColumnsWereGuessed();
    void tellsWhereTheModelOfAFileCannotBeAssembled();
    void studiesSpeedAgainstError();
    void studiesTheMechanismAskedFor();
    void takesAnyFileName();
    void speaksTheSameNumbersInEveryLocale();
    void takesAFileThatIsNoSceneForAReference();
    void saysThatThereIsNoSuchFile_data();
    void saysThatThereIsNoSuchFile();
    void leavesToTheWindowSystemWhatIsIts();
    void takesASceneForWhatIsNotSaid();
    void goesOnFromAScene();
    void rendersASceneAsItWasSaved();
    void saysWhatIsWrongWithAScene_data();
    void saysWhatIsWrongWithAScene();
    void forgetsTheSettings();
    void helpsEverywhere();
    void needsNoPlatformButToRender();
    void rendersPicturesOfTheSizeAskedFor_data();
    void rendersPicturesOfTheSizeAskedFor();
    void rendersTheInstantAskedFor();
    void rendersWhatWasChosen_data();
    void rendersWhatWasChosen();
    void rendersFrames();
    void filmsFrames();
    void leavesNothingBehindWhenInterrupted_data();
    void leavesNothingBehindWhenInterrupted();
    void refusesToRenderABadReference();
    void writesAReport();
    void reportsTheSameNumbersAsItCompares();
};

void TestCommandLine::solvesTheReportsStudyByDefault()
{
    const Outcome outcome = run(QStringLiteral("solve"));
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.err, QByteArray());
    QVERIFY(!outcome.out.contains('\r'));
    QVERIFY(outcome.out.endsWith('\n'));
    const Table table = tableOf(outcome.out);
    QByteArrayList expected{"time"};
    for (const char *order : {"", "_diff", "_diff2"}) {
        for (const char *body : {"1", "2", "3", "4"}) {
            expected << QByteArray("R") + body + "_x" + order << QByteArray("R") + body + "_y" + order
                     << QByteArray("theta") + body + order;
        }
    }
    QCOMPARE(table.header, expected);
    QCOMPARE(table.cells.size(), std::size_t(201));
    for (const QByteArrayList &row : table.cells) {
        QCOMPARE(row.size(), qsizetype(37));
    }
    QCOMPARE(table.at(0, "R4_x"), 80.0); // 20 + √(65² - 25²)
    QCOMPARE(table.at(200, "time"), 1.0);
}

void TestCommandLine::writesChannelsInTheOrderOfTheCoordinates()
{
    const Outcome outcome = run(QStringLiteral("solve --steps 3 --channels theta3_diff2,R4_x,theta4_diff,theta3"));
    QCOMPARE(outcome.status, 0);
    const Table table = tableOf(outcome.out);
    QCOMPARE(table.header, QByteArrayList({"time", "theta3", "R4_x", "theta4_diff", "theta3_diff2"}));
    QCOMPARE(table.cells.size(), std::size_t(4));
}

void TestCommandLine::writesSeventeenSignificantDigits()
{
    const Table table = tableOf(run(QStringLiteral("solve --theta20 0.1")).out);
    int seventeen = 0;
    for (const QByteArrayList &row : table.cells) {
        for (const QByteArray &cell : row) {
            QCOMPARE(cell, QByteArray::number(cell.toDouble(), 'g', 17));
            QVERIFY(cell != "-0");
            seventeen += QByteArray(cell).replace("-", "").replace(".", "").size() >= 17 ? 1 : 0;
        }
    }
    QVERIFY(seventeen > 1000);
}

void TestCommandLine::writesUnitsThatAreNotTheAuthorsBehindTheName()
{
    const QByteArray names = run(QStringLiteral("solve --angle-unit rad --channels "
                                                "theta3,theta3_diff,theta3_diff2,R4_x,R4_x_diff2"))
                                 .out.split('\n')
                                 .first();
    QCOMPARE(names, QByteArray("time,theta3 [rad],R4_x,theta3_diff [rad/s],theta3_diff2 [rad/s^2],R4_x_diff2"));
}

void TestCommandLine::putsTheInstantsWhereTheyAreAskedFor()
{
    const Table table =
        tableOf(run(QStringLiteral("solve --start -1 --duration 0.75 --steps 3 --channels theta2")).out);
    QCOMPARE(table.cells.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(table.at(i, "time"), -1.0 + 0.25 * static_cast<double>(i));
        QVERIFY(std::abs(table.at(i, "theta2") - 360.0 * (-1.0 + 0.25 * static_cast<double>(i))) < 1e-12);
    }
}

void TestCommandLine::agreesWithTheTextbook_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("c");
    QTest::addColumn<double>("omega2");
    QTest::addColumn<double>("theta20");
    QTest::addColumn<bool>("crossed");
    const double turn = 2.0 * std::numbers::pi;
    QTest::newRow("Table 1") << "--tolerance 0" << 20.0 << 65.0 << 25.0 << turn << 0.0 << false;
    QTest::newRow("Table 1 in closed form") << "--method closed-form" << 20.0 << 65.0 << 25.0 << turn << 0.0 << false;
    QTest::newRow("crossed") << "--branch crossed --tolerance 0" << 20.0 << 65.0 << 25.0 << turn << 0.0 << true;
    QTest::newRow("crossed in closed form")
        << "--branch crossed --method closed-form" << 20.0 << 65.0 << 25.0 << turn << 0.0 << true;
    QTest::newRow("turning clockwise, offset below")
        << "--a 12.5 --b=80 --c -5 --omega2 -6.25 --theta20 -0.5 --tolerance 0" << 12.5 << 80.0 << -5.0 << -6.25 << -0.5
        << false;
    QTest::newRow("no offset, closed form")
        << "--c 0 --a +1e1 --b 4.e1 --method closed-form" << 10.0 << 40.0 << 0.0 << turn << 0.0 << false;
}

void TestCommandLine::agreesWithTheTextbook()
{
    QFETCH(QString, options);
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, c);
    QFETCH(double, omega2);
    QFETCH(double, theta20);
    QFETCH(bool, crossed);
    const Table degrees = tableOf(run(QStringLiteral("solve --steps 50 ") + options).out);
    const Table radians = tableOf(run(QStringLiteral("solve --steps 50 --angle-unit rad ") + options).out);
    QCOMPARE(degrees.cells.size(), std::size_t(51));
    QCOMPARE(radians.cells.size(), std::size_t(51));
    for (std::size_t i = 0; i <= 50; ++i) {
        const double theta2 = omega2 * static_cast<double>(i) / 50.0 + theta20;
        const Textbook expected = textbook(a, b, c, omega2, theta2, crossed);
        constexpr double kRoundings = 1e-12; // some thousand units in the last place of a channel's size
        const double size = a + b + std::abs(c);
        const double speed = std::abs(omega2);
        const struct {
            const char *name;
            double actual, expected, size;
        } values[] = {
            {"theta2", degrees.at(i, "theta2") * kDegree, theta2, 1.0 + std::abs(theta2)},
            {"theta3", degrees.at(i, "theta3") * kDegree, expected.theta3, 1.0},
            {"theta3_diff", degrees.at(i, "theta3_diff") * kDegree, expected.theta3Dot, speed},
            {"theta3_diff2", degrees.at(i, "theta3_diff2") * kDegree, expected.theta3DDot, speed * speed},
            {"R4_x", degrees.at(i, "R4_x"), expected.R4x, size},
            {"R4_x_diff", degrees.at(i, "R4_x_diff"), expected.R4xDot, size * speed},
            {"R4_x_diff2", degrees.at(i, "R4_x_diff2"), expected.R4xDDot, size * speed * speed},
            {"R4_y", degrees.at(i, "R4_y"), c, size},
            {"theta3 [rad]", radians.at(i, "theta3 [rad]"), expected.theta3, 1.0},
            {"theta3_diff [rad/s]", radians.at(i, "theta3_diff [rad/s]"), expected.theta3Dot, speed},
            {"theta3_diff2 [rad/s^2]", radians.at(i, "theta3_diff2 [rad/s^2]"), expected.theta3DDot, speed * speed},
            {"R4_x, beside rad", radians.at(i, "R4_x"), degrees.at(i, "R4_x"), 0.0},
        };
        for (const auto &value : values) {
            const QByteArray fault = awayFrom(value.actual, value.expected, kRoundings * value.size, value.name, i);
            QVERIFY2(fault.isEmpty(), fault.constData());
        }
    }
}

void TestCommandLine::printsWhatExistsWhereTheMechanismCannotBeAssembled()
{
    const Outcome outcome = run(QStringLiteral("solve --b 40 --steps 4 --channels theta3,R4_x_diff"));
    QCOMPARE(outcome.status, 4);
    QVERIFY(isOneLine(outcome.err));
    for (const char *part : {"1 of 5 instants", "t = 0.75 s", "270°", "at least 45 mm", "--b"}) {
        QVERIFY2(outcome.err.contains(part), outcome.err.constData());
    }
    const Table table = tableOf(outcome.out);
    QCOMPARE(table.cells.size(), std::size_t(5));
    QCOMPARE(table.cells[3], QByteArrayList({"0.75", "nan", "nan"}));
    QVERIFY(!std::isnan(table.at(4, "theta3")));
}

void TestCommandLine::printsThePositionWhereTheDerivativesDoNotExist()
{
    // At θ2 = 0 with b = c the coupler stands square to the slider's line.
    const Outcome outcome = run(QStringLiteral("solve --b 25 --at-angle 0 --method closed-form --channels "
                                               "theta3,theta3_diff,R4_x_diff2"));
    QCOMPARE(outcome.status, 5);
    QVERIFY(isOneLine(outcome.err));
    QVERIFY2(outcome.err.contains("perpendicular to the slider's line"), outcome.err.constData());
    QCOMPARE(tableOf(outcome.out).cells.front(), QByteArrayList({"0", "90", "nan", "nan"}));
}

void TestCommandLine::putsAssemblyBeforeSingularity()
{
    const Outcome outcome = run(QStringLiteral("solve --b 25 --steps 4 --method closed-form"));
    QCOMPARE(outcome.status, 4);
    QVERIFY(isOneLine(outcome.err));
    QVERIFY(outcome.err.contains("cannot be assembled"));
    QVERIFY(outcome.err.contains("perpendicular to the slider's line"));
}

void TestCommandLine::tellsWhenNewtonDoesNotConverge()
{
    const Outcome outcome = run(QStringLiteral("solve --method newton --max-iterations 1 --steps 3 --channels theta3"));
    QCOMPARE(outcome.status, 5);
    QVERIFY(isOneLine(outcome.err));
    QVERIFY2(outcome.err.contains("--max-iterations"), outcome.err.constData());
    QVERIFY(outcome.out.contains(",nan"));
}

/// An absolute tolerance is out of reach of a crank of 20 000 km, and met too early by one of 20 pm.
void TestCommandLine::solvesLengthsOfAnySizeToARelativeTolerance()
{
    const QString large = QStringLiteral("solve --method newton --a 2e10 --b 6e10 --c 2.5e10 --channels theta3 --angle-unit rad ");
    const QString small = QStringLiteral("solve --method newton --a 2e-8 --b 6e-8 --c 2.5e-8 --channels theta3 --angle-unit rad ");
    const QString relative = QStringLiteral("--tolerance-kind relative");
    const Table exact =
        tableOf(run(QStringLiteral("solve --b 60 --channels theta3 --angle-unit rad --method closed-form")).out);
    const auto largestError = [&exact](const Table &table) {
        double largest = 0.0;
        for (std::size_t i = 0; i < exact.cells.size(); ++i) {
            largest = std::max(largest, std::abs(table.at(i, "theta3 [rad]") - exact.at(i, "theta3 [rad]")));
        }
        return largest;
    };
    QCOMPARE(run(large).status, 5);
    QVERIFY(largestError(tableOf(run(small).out)) > 1e-9);
    for (const QString &line : {large, small}) {
        const Outcome outcome = run(line + relative);
        QCOMPARE(outcome.status, 0);
        QVERIFY(largestError(tableOf(outcome.out)) < 1e-12);
    }
    QCOMPARE(run(small + QStringLiteral("--tolerance-kind absolute")).out, run(small).out);
}

void TestCommandLine::writesJson()
{
    const QString choices = QStringLiteral(" --b 60 --c -3.5 --branch crossed --steps 7 --channels R4_x_diff,theta3");
    for (const QString &unit : {QStringLiteral("deg"), QStringLiteral("rad")}) {
        const QString line = QStringLiteral("solve --method closed-form --angle-unit ") + unit + choices;
        const Outcome outcome = run(line + QStringLiteral(" --format json"));
        QCOMPARE(outcome.status, 0);
        QJsonParseError parsing;
        const QJsonObject object = QJsonDocument::fromJson(outcome.out, &parsing).object();
        QCOMPARE(parsing.error, QJsonParseError::NoError);
        QCOMPARE(object.keys(), QStringList({"channels", "mechanism", "method", "time", "units"}));
        QCOMPARE(object["method"].toString(), QStringLiteral("closed-form"));
        QCOMPARE(object["units"].toObject(), QJsonObject({{"length", "mm"}, {"angle", unit}, {"time", "s"}}));
        QCOMPARE(object["mechanism"].toObject(), QJsonObject({{"a", 20},
                                                              {"b", 60},
                                                              {"c", -3.5},
                                                              {"omega2", 2.0 * std::numbers::pi},
                                                              {"theta20", 0},
                                                              {"branch", "crossed"}}));
        const QJsonObject channels = object["channels"].toObject();
        QCOMPARE(channels.keys(), QStringList({"R4_x_diff", "theta3"}));

        const Table csv = tableOf(run(line).out);
        const QByteArray theta3 = unit == u"deg" ? "theta3" : "theta3 [rad]";
        QCOMPARE(object["time"].toArray().size(), qsizetype(8));
        for (std::size_t i = 0; i < 8; ++i) {
            const auto at = static_cast<qsizetype>(i);
            QCOMPARE(object["time"].toArray()[at].toDouble(), csv.at(i, "time"));
            QCOMPARE(channels["theta3"].toArray()[at].toDouble(), csv.at(i, theta3.constData()));
            QCOMPARE(channels["R4_x_diff"].toArray()[at].toDouble(), csv.at(i, "R4_x_diff"));
        }
    }
}

void TestCommandLine::writesNullForWhatDoesNotExist()
{
    const Outcome outcome = run(QStringLiteral("solve --b 40 --steps 4 --channels theta3 --format json"));
    QCOMPARE(outcome.status, 4);
    QJsonParseError parsing;
    const QJsonObject object = QJsonDocument::fromJson(outcome.out, &parsing).object();
    QCOMPARE(parsing.error, QJsonParseError::NoError);
    const QJsonArray theta3 = object["channels"].toObject()["theta3"].toArray();
    QCOMPARE(theta3.size(), qsizetype(5));
    QVERIFY(theta3[3].isNull());
    QVERIFY(theta3[4].isDouble());
}

void TestCommandLine::understandsAUnitBehindANumber()
{
    const QString same = QStringLiteral("--method closed-form --channels theta2,R4_x");
    const Outcome plain = run(QStringLiteral("solve --a 25.4 --b 70 --c -5 --omega2 6.283185307179586 --theta20 "
                                             "1.5707963267948966 --duration 0.5 --start 0.25 ") +
                              same);
    QCOMPARE(plain.status, 0);
    for (const char *line :
         {"--a 1in --b 7cm --c −0.5cm --omega2 60rpm --theta20 90deg --duration 500ms --start 0.25s ",
          "--a 25.4mm --b 0.07m --c -5 --omega2 360deg/s --theta20 90° --duration 0.5s --start 250ms ",
          "--a 2.54·10¹ --b 7·10^-2m --c −5·10⁰ --omega2 0.6·10²rpm --theta20 90deg --duration 5×10⁻¹ --start "
          "250ms ",
          "--a 25.4 --b 70 --c \" -5 \" --omega2 60rpm --theta20 ９０deg --duration 0.5 --start 0.25 --steps 2e2 "}) {
        const Outcome outcome = run(QStringLiteral("solve ") + QString::fromUtf8(line) + same);
        QVERIFY2(outcome.status == 0, qPrintable(outcome.err));
        QCOMPARE(outcome.out, plain.out);
    }
}

void TestCommandLine::findsTheInstantOfACrankAngle_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<double>("expected");
    QTest::newRow("sixty degrees") << "--at-angle 60" << 1.0 / 6.0;
    QTest::newRow("where it starts") << "--at-angle 0" << 0.0;
    QTest::newRow("a whole turn is the same angle") << "--at-angle 420" << 1.0 / 6.0;
    QTest::newRow("a negative angle") << "--at-angle -90" << 0.75;
    QTest::newRow("from a later start") << "--at-angle 60 --start 0.5" << 7.0 / 6.0;
    QTest::newRow("exactly at a later start") << "--at-angle 90 --start 3.25" << 3.25;
    QTest::newRow("from a negative start") << "--at-angle 60 --start -1.5" << -5.0 / 6.0;
    QTest::newRow("turning clockwise") << "--at-angle 60 --omega2 -6.283185307179586" << 5.0 / 6.0;
    QTest::newRow("already there, in radians") << "--at-angle 60 --theta20 1.0471975511965976" << 0.0;
    QTest::newRow("already there but for the last digit") << "--at-angle 60 --theta20 1.0471975511965981" << 0.0;
    QTest::newRow("just passed") << "--at-angle 60 --theta20 1.0471975611965976" << 1.0 - 1e-8 / 6.283185307179586;
    QTest::newRow("standing there") << "--at-angle 45 --omega2 0 --theta20 0.7853981633974483" << 0.0;
    QTest::newRow("slowly") << "--at-angle 90 --omega2 0.001" << 500.0 * std::numbers::pi;
}

void TestCommandLine::findsTheInstantOfACrankAngle()
{
    QFETCH(QString, options);
    QFETCH(double, expected);
    const Outcome outcome = run(QStringLiteral("solve --channels theta2 ") + options);
    QCOMPARE(outcome.status, 0);
    const Table table = tableOf(outcome.out);
    QCOMPARE(table.cells.size(), std::size_t(1));
    const double time = table.at(0, "time");
    QVERIFY2(std::abs(time - expected) <= 1e-13 * std::max(1.0, std::abs(expected)), qPrintable(QString::number(time)));
}

void TestCommandLine::refusesAWrongCommandLine_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *line, const char *says) { QTest::newRow(line) << line << says; };
    row("solv", "no command \"solv\"");
    row("-platform", "no option -platform");
    row("-platform offscreen solve", "must come first");
    row("solve -platform xcb", "no option -platform");
    row("a.json b.json", "one scene, not 2: remove \"b.json\"");
    row("--reset-settings --reference x.csv", "remove what stands beside it");
    row("--reset-settings a.json", "remove what stands beside it");
    row("solve --reset-settings", "no option --reset-settings");
    row("--reference x.csv solve", "must come first");
    row("--reference", "--reference needs a value");
    row("--steps 3", "no option --steps");
    row("solve --foo", "no option --foo");
    row("solve --omga2 3", "did you mean --omega2?");
    row("solve -5", "no option -5");
    row("solve file.csv", "remove \"file.csv\"");
    row("solve --b", "--b needs a value: --b MM");
    row("solve --b 60 --b 61", "--b is given more than once");
    row("solve --b 12abc", "--b must be a number");
    row("solve --b 0,5", "decimal point");
    row("solve --b 20/3", "--b must be a number");
    row("solve --b 3s", "--b must be a number, alone or with mm, cm, m or in behind it, not \"3s\"");
    row("solve --omega2 60rmp", "alone or with rad/s, deg/s or rpm behind it");
    row("solve --theta20 1rad/s", "alone or with deg or rad behind it");
    row("solve --duration 5mm", "alone or with s or ms behind it");
    row("solve --tolerance 1e-8mm", "--tolerance must be a number");
    row("solve --b --c 5", "--b must be a number");
    row("solve --b \"\"", "--b must be a number");
    row("solve --b nan", "--b must be a number");
    row("solve --c inf", "--c must be a number");
    row("solve --c 1e999", "--c must not exceed 1e12");
    row("solve --c +-5", "--c must be a number");
    row("solve --c 0x10", "--c must be a number");
    row("solve --b 0", "--b must be greater than 0");
    row("solve --a -3", "--a must be greater than 0");
    row("solve --c 2e12", "--c must not exceed 1e12");
    row("solve --omega2 -2e12", "--omega2 must not exceed 1e12");
    row("solve --theta20 2e12", "--theta20 must not exceed 1e12");
    row("solve --branch up", "--branch must be open or crossed");
    row("solve --steps 0", "--steps must be a whole number");
    row("solve --steps -4", "--steps must be a whole number");
    row("solve --steps 1.5", "--steps must be a whole number");
    row("solve --steps 100000001", "--steps must be a whole number");
    row("solve --duration 0", "--duration must be greater than 0");
    row("solve --duration -1", "--duration must be greater than 0");
    row("solve --start 1e13", "--start must not exceed");
    row("solve --start 1e9 --duration 1e-6", "too close together");
    row("solve --method euler", "--method must be newton or closed-form");
    row("solve --max-iterations 0", "--max-iterations must be a whole number from 1");
    row("solve --tolerance -1e-9", "--tolerance must be 0 or more");
    row("solve --tolerance-kind loose", "--tolerance-kind must be absolute or relative");
    row("solve --channels R4x", "did you mean R4_x?");
    row("solve --channels theta3,theta3_dif", "did you mean theta3_diff or theta3_diff2?");
    row("solve --channels THETA3", "did you mean theta3?");
    row("solve --channels qqqqqqq", "there are R1_x, R1_y, theta1");
    row("solve --channels \"\"", "no channel \"\"");
    row("solve --angle-unit grad", "--angle-unit must be deg or rad");
    row("solve --format xml", "--format must be csv or json");
    row("solve --output \"\"", "--output needs the name of a file");
    row("solve --at-angle 30 --steps 5", "remove one");
    row("solve --at-angle 30 --duration 5", "remove one");
    row("solve --at-angle 30 --omega2 0", "stands still");
    row("solve --at-angle 30 --omega2 1e-300", "too slowly");
    row("compare", "needs a file");
    row("identify", "needs a file");
    row("identify a.csv \"\"", "needs a file");
    row("compare - - --b 60", "can be read only once");
    row("identify - --scene -", "can be read only once");
    row("render --output x.png --scene - --reference -", "can be read only once");
    row("-", "save what comes from standard input");
    row("--reference -", "save what comes from standard input");
    row("compare a.csv --column x", "--column must be a heading, = and what it is");
    row("compare a.csv --column =time", "--column must be a heading, = and what it is");
    row("compare a.csv --abscissa theta2", "--abscissa must be time or angle");
    row("solve --abscissa angle", "no option --abscissa");
    row("compare a.csv --column \"x=crank-angle [mm]\"", "\"mm\" is no unit of crank-angle");
    row("compare a.csv --column x=R4x", "did you mean R4_x?");
    row("compare a.csv --column x=whatever", "there is no channel \"whatever\"");
    row("compare a.csv --column \"x=R4_x [furlong]\"", "\"furlong\" is no unit of R4_x");
    row("compare a.csv --column \"x=R4_x [s]\"", "\"s\" is no unit of R4_x");
    row("compare a.csv --column \"x=R4_x_diff [mm]\"", "\"mm\" is no unit of R4_x_diff");
    row("compare a.csv --column \"t=time [mm]\"", "\"mm\" is no unit of time");
    row("compare a.csv --column x=R4_x --column x=time", "--column says twice what \"x\" is");
    row("render --output x.png --column x=R4_x", "give its file with --reference");
    row("solve --column x=R4_x", "no option --column");
    row("identify a.csv --format csv", "--format must be text or json");
    row("identify a.csv --b 0", "--b must be greater than 0");
    row("compare a.csv --method newton", "no option --method");
    row("compare a.csv --format xml", "--format must be text, csv or json");
    row("compare a.csv --fail-on-difference=yes", "--fail-on-difference");
    row("render", "needs --output");
    row("render --output x.gif", ".png, .svg or .pdf");
    row("render --output x.png --what R1_x", "theta3, R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2");
    row("render --output x.png --what report", "--output must end in .pdf");
    row("render --output x.pdf --what report --size 900x600", "remove --size");
    row("render --output x.pdf --what report --theme dark", "remove --theme");
    row("render --output x.png --size 900", "--size must be");
    row("render --output x.png --size 0x600", "--size must be");
    row("render --output x.png --size 900x600x2", "--size must be");
    row("render --output x.png --scale 0", "--scale must be");
    row("render --output x.png --size 9000x9000 --scale 9", "smaller --size or --scale");
    row("render --output x.png --theme blue", "--theme must be light or dark");
    row("render --output x.png --at 0.5 --at-angle 30", "remove one");
    row("render --output x.png --at 3", "outside the run");
    row("render --output x.png --format csv", "no option --format");
    row("render --what frames --output x.svg", "a new folder or end in .mp4, .webm or .gif");
    row("render --what frames", "needs --output");
    row("render --what frames --output x --at 0.5", "remove --at");
    row("render --what frames --output x --at-angle 5", "remove --at-angle");
    row("render --what frames --output x --speed 0", "--speed must be greater than 0");
    row("render --what frames --output x --duration 1e6", "more than 100000 frames");
    row("render --what mechanism --output x.png --speed 2", "--speed is of --what frames");
    row("study --cases soft", "--cases must be nominal, hard or all");
    row("study --format xml", "--format must be text, csv or json");
    row("study --steps 100", "no option --steps");
    row("study --b 0", "--b must be greater than 0");
    row("study x.csv", "takes options only");
    row("--cases hard study", "no option --cases");
}

void TestCommandLine::refusesAWrongCommandLine()
{
    QFETCH(QString, line);
    QFETCH(QString, says);
    QStringList arguments = QProcess::splitCommand(line);
    if (line.endsWith(QStringLiteral("\"\""))) { // splitCommand drops what is empty
        arguments = line.chopped(3).split(u' ') << QString();
    }
    const Outcome outcome = run(arguments);
    QVERIFY2(outcome.err.contains(says.toUtf8()), outcome.err.constData());
    QVERIFY2(isOneLine(outcome.err), outcome.err.constData());
    QCOMPARE(outcome.out, QByteArray());
    QCOMPARE(outcome.status, 2);
}

void TestCommandLine::writesTheSameToAFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.csv"));
    const QString line = QStringLiteral("solve --steps 1000 --b 60");
    const Outcome toFile = run(QProcess::splitCommand(line) << QStringLiteral("--output") << path);
    QCOMPARE(toFile.status, 0);
    QCOMPARE(toFile.out, QByteArray());
    QCOMPARE(contentOf(path), run(line).out);
    QVERIFY(contentOf(path).size() > 100'000);
}

void TestCommandLine::writesIntoAPipeWithoutReplacingIt()
{
    QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    if (QProcess::execute(QStringLiteral("mkfifo"), {pipe}) != 0) {
        QSKIP("There are no named pipes here.");
    }
    QProcess reader;
    reader.start(QStringLiteral("cat"), {pipe});
    QVERIFY(reader.waitForStarted());
    // Little enough for the pipes between the three of us: nobody reads while run() waits.
    const Outcome outcome = run({"solve", "--steps", "20", "--output", pipe});
    const bool read = reader.waitForFinished(slidercrank::kPatience);
    reader.kill();
    reader.waitForFinished(slidercrank::kPatience);
    QVERIFY(read);
    QCOMPARE(outcome.status, 0);
    QCOMPARE(reader.readAllStandardOutput(), run(QStringLiteral("solve --steps 20")).out);
    QVERIFY(!QFileInfo(pipe).isFile());
}

void TestCommandLine::leavesNothingBehindWhereItCannotWrite()
{
    QTemporaryDir folder;
    const QString inFile = folder.filePath(QStringLiteral("file"));
    QFile file(inFile);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    const QStringList places{folder.filePath(QStringLiteral("missing/motion.csv")), inFile + QStringLiteral("/x.csv"),
                             folder.path()};
    for (const QString &place : places) {
        for (const QStringList &command :
             {QStringList{QStringLiteral("solve")}, QStringList{QStringLiteral("compare"), sample()}}) {
            const Outcome outcome = run(command + QStringList{QStringLiteral("--output"), place});
            QCOMPARE(outcome.status, 3);
            QVERIFY2(isOneLine(outcome.err) && outcome.err.contains("cannot be written"), outcome.err.constData());
        }
    }
    const QString picture = folder.filePath(QStringLiteral("missing/figure.png"));
    const Outcome outcome = run({QStringLiteral("render"), QStringLiteral("--output"), picture});
    QCOMPARE(outcome.status, 3);
    QVERIFY2(isOneLine(outcome.err), outcome.err.constData());
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
             QStringList(QStringLiteral("file")));
    QCOMPARE(contentOf(inFile), QByteArray());
}

void TestCommandLine::readsWhatItWrites_data()
{
    QTest::addColumn<QString>("mechanism");
    QTest::addColumn<QString>("writing");
    QTest::addColumn<QString>("otherMechanism");
    const QString exact = QStringLiteral("--method closed-form");
    const QString newton = QStringLiteral("--tolerance 0");
    for (const QString &method : {exact, newton}) {
        for (const QString &unit : {QStringLiteral("deg"), QStringLiteral("rad")}) {
            const QString writing = method + QStringLiteral(" --angle-unit ") + unit;
            const auto row = [&](const char *name, const char *mechanism, const char *other) {
                QTest::addRow("%s, %s", name, qPrintable(writing)) << mechanism << writing << other;
            };
            row("Table 1", "", "--b 60");
            row("open", "--b 60", "--b 60.001");
            row("crossed", "--branch crossed", "--branch open");
            row("clockwise", "--omega2 -6.25", "--omega2 6.25");
            row("below", "--c -10 --theta20 0.25", "--c -10");
        }
    }
}

void TestCommandLine::readsWhatItWrites()
{
    QFETCH(QString, mechanism);
    QFETCH(QString, writing);
    QFETCH(QString, otherMechanism);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.csv"));
    const Outcome written = run(QProcess::splitCommand(QStringLiteral("solve ") + mechanism + u' ' + writing)
                                << QStringLiteral("--output") << path);
    QCOMPARE(written.status, 0);
    const QStringList compare{QStringLiteral("compare"), path, QStringLiteral("--fail-on-difference")};
    const Outcome same = run(compare + QProcess::splitCommand(mechanism));
    QVERIFY2(same.status == 0, same.out.constData());
    QVERIFY2(same.out.contains("Agrees with this mechanism in 36 of 36"), same.out.constData());
    QCOMPARE(run(compare + QProcess::splitCommand(otherMechanism)).status, 1);
}

void TestCommandLine::comparesTheSample()
{
    const Outcome right = run({QStringLiteral("compare"), sample(), QStringLiteral("--b"), QStringLiteral("60"),
                               QStringLiteral("--fail-on-difference")});
    QCOMPARE(right.status, 0);
    QCOMPARE(right.err, QByteArray());
    QVERIFY2(right.out.contains("Agrees with this mechanism in 6 of 6 channels"), right.out.constData());

    const Outcome wrong = run({QStringLiteral("compare"), sample()});
    QCOMPARE(wrong.status, 0);
    QVERIFY2(wrong.out.contains("Differs from this mechanism in 6 of 6 channels"), wrong.out.constData());
    QCOMPARE(run({QStringLiteral("compare"), sample(), QStringLiteral("--fail-on-difference")}).status, 1);
}

void TestCommandLine::comparesTheSampleInJson()
{
    const Outcome outcome = run({QStringLiteral("compare"), sample(), QStringLiteral("--b"), QStringLiteral("60"),
                                 QStringLiteral("--format"), QStringLiteral("json")});
    QCOMPARE(outcome.status, 0);
    QJsonParseError parsing;
    const QJsonObject object = QJsonDocument::fromJson(outcome.out, &parsing).object();
    QCOMPARE(parsing.error, QJsonParseError::NoError);
    QCOMPARE(object.keys(), QStringList(QStringLiteral("files")));
    QCOMPARE(object["files"].toArray().size(), qsizetype(1));
    const QJsonObject file = object["files"].toArray().first().toObject();
    QCOMPARE(file.keys(), QStringList({"channels", "columns", "explanation", "file", "ignoredColumns", "mechanism",
                                       "skipped", "verdict"}));
    QCOMPARE(file["file"].toString(), sample());
    QCOMPARE(file["mechanism"].toObject()["b"].toDouble(), 60.0);
    QCOMPARE(file["verdict"].toString(), QStringLiteral("agrees"));
    QCOMPARE(file["explanation"], QJsonValue(QJsonValue::Null));
    QCOMPARE(file["skipped"].toArray(), QJsonArray());
    QCOMPARE(file["columns"].toArray().size(), qsizetype(7));
    const QJsonObject time = file["columns"].toArray().first().toObject();
    QCOMPARE(time.keys(), QStringList({"channel", "guessed", "heading", "unit", "why"}));
    QCOMPARE(time["channel"].toString(), QStringLiteral("time"));
    QCOMPARE(time["guessed"], QJsonValue(false));

    QStringList keys{"name",          "unit",          "count",        "maxAbs",
                     "timeOfMaxAbs",  "rms",           "maxPercent",   "timeOfMaxPercent",
                     "zeroReference", "percentOfPeak", "roundingStep", "verdict"};
    keys.sort();
    const QJsonArray channels = file["channels"].toArray();
    QCOMPARE(channels.size(), qsizetype(6));

    // The file against the textbook; the cells as printed, so that a digit lost in reading would show.
    const Table cells = tableOf(contentOf(sample()));
    const struct {
        const char *name;
        const char *unit;
        double Textbook::*value;
    } expected[] = {{"R4_x", "mm", &Textbook::R4x},
                    {"R4_x_diff", "mm/s", &Textbook::R4xDot},
                    {"R4_x_diff2", "mm/s²", &Textbook::R4xDDot},
                    {"theta3", "°", &Textbook::theta3},
                    {"theta3_diff", "°/s", &Textbook::theta3Dot},
                    {"theta3_diff2", "°/s²", &Textbook::theta3DDot}};
    for (qsizetype i = 0; i < 6; ++i) {
        const auto &wanted = expected[i];
        const QJsonObject channel = channels[i].toObject();
        QCOMPARE(channel.keys(), keys);
        QCOMPARE(channel["name"].toString(), QLatin1String(wanted.name));
        QCOMPARE(channel["unit"].toString(), QString::fromUtf8(wanted.unit));
        QCOMPARE(channel["count"].toInt(), 201);
        QCOMPARE(channel["verdict"].toString(), QStringLiteral("agrees"));

        double maxAbs = 0.0;
        double maxPercent = 0.0;
        double squares = 0.0;
        double peak = 0.0;
        int zeros = 0;
        for (std::size_t row = 0; row < 201; ++row) {
            const double theta2 = 2.0 * std::numbers::pi * static_cast<double>(row) / 200.0;
            const double inRadians = textbook(20.0, 60.0, 25.0, 2.0 * std::numbers::pi, theta2, false).*wanted.value;
            const double model = i < 3 ? inRadians : inRadians / kDegree;
            const double reference = cells.at(row, wanted.name);
            const double error = std::abs(model - reference);
            maxAbs = std::max(maxAbs, error);
            squares += error * error;
            peak = std::max(peak, std::abs(reference));
            if (reference == 0.0) {
                ++zeros;
            } else {
                maxPercent = std::max(maxPercent, error / std::abs(reference) * 100.0);
            }
        }
        const struct {
            const char *name;
            double expected;
        } numbers[] = {{"maxAbs", maxAbs},
                       {"maxPercent", maxPercent},
                       {"rms", std::sqrt(squares / 201.0)},
                       {"percentOfPeak", maxAbs / peak * 100.0},
                       {"zeroReference", static_cast<double>(zeros)}};
        for (const auto &number : numbers) {
            // The roundings of both sides, 1e-12 of the values, are 1e-6 of these differences.
            const QByteArray fault = awayFrom(channel[QLatin1String(number.name)].toDouble(), number.expected,
                                              1e-6 * number.expected, number.name, static_cast<std::size_t>(i));
            QVERIFY2(fault.isEmpty(), fault.constData());
        }
    }
}

void TestCommandLine::comparesTheSampleInCsv()
{
    const Outcome outcome =
        run({QStringLiteral("compare"), sample(), QStringLiteral("--format"), QStringLiteral("csv")});
    const Table table = tableOf(outcome.out);
    QCOMPARE(table.header.join(','),
             QByteArray("file,name,unit,count,maxAbs,timeOfMaxAbs,rms,maxPercent,timeOfMaxPercent,zeroReference,"
                        "percentOfPeak,roundingStep,verdict,fileVerdict,sentence"));
    QCOMPARE(table.cells.size(), std::size_t(6));
    QCOMPARE(table.cells[0][1], QByteArray("R4_x"));
    QVERIFY(std::abs(table.at(0, "maxAbs") - 7.22) < 0.005);
    const qsizetype verdict = table.header.indexOf("verdict");
    for (const QByteArrayList &row : table.cells) {
        QCOMPARE(row[verdict], QByteArray("differs"));
        QCOMPARE(row[verdict + 1], QByteArray("differs"));
    }

    // The sentence is that of JSON, whole and quoted; where nothing differs there is none.
    const Outcome json = run({"compare", sample(), "--format", "json"});
    const QString sentence = QJsonDocument::fromJson(json.out)
                                 .object()["files"]
                                 .toArray()
                                 .first()
                                 .toObject()["explanation"]
                                 .toObject()["sentence"]
                                 .toString();
    QVERIFY(sentence.contains(QStringLiteral("b = 60")));
    QString quoted = sentence;
    QVERIFY(
        outcome.out.endsWith(",differs,differs,\"" + quoted.replace(u'"', QStringLiteral("\"\"")).toUtf8() + "\"\n"));
    const Outcome same = run({"compare", sample(), "--b", "60", "--format", "csv"});
    QVERIFY(same.out.endsWith(",agrees,agrees,\n"));
}

void TestCommandLine::saysWhyColumnsAreNotUsed()
{
    QTemporaryDir folder;
    const QString file =
        writeFile(folder.filePath(QStringLiteral("one.csv")), "time,R4_x,theta3,force\n0,74.5,NaN,3\n");
    const Outcome outcome = run({"compare", file});
    QCOMPARE(outcome.err,
             file.toUtf8() + ": these columns were not used: theta3 (no number in it), force (name not known).\n");
    QVERIFY2(outcome.out.startsWith(file.toUtf8() + ": t = 0 s, one instant\n"), outcome.out.constData());
}

void TestCommandLine::comparesSeveralFiles()
{
    QTemporaryDir folder;
    const QString other = folder.filePath(QStringLiteral("other.csv"));
    run({"solve", "--b", "70", "--channels", "theta3,R4_x", "--output", other});
    const QStringList compare{"compare", sample(), other, "--b", "60"};

    const Table csv = tableOf(run(compare + QStringList{"--format", "csv"}).out);
    QCOMPARE(csv.cells.size(), std::size_t(8));
    for (std::size_t row = 0; row < csv.cells.size(); ++row) {
        QCOMPARE(csv.cells[row].first(), '"' + (row < 6 ? sample() : other).toUtf8() + '"');
        QCOMPARE(csv.cells[row][csv.header.indexOf("verdict")], QByteArray(row < 6 ? "agrees" : "differs"));
    }

    QJsonParseError parsing;
    const QJsonObject object =
        QJsonDocument::fromJson(run(compare + QStringList{"--format", "json"}).out, &parsing).object();
    QCOMPARE(parsing.error, QJsonParseError::NoError);
    const QJsonArray files = object["files"].toArray();
    QCOMPARE(files.size(), qsizetype(2));
    QCOMPARE(files[0].toObject()["file"].toString(), sample());
    QCOMPARE(files[1].toObject()["file"].toString(), other);
    QCOMPARE(files[1].toObject()["channels"].toArray().size(), qsizetype(2));

    const Outcome text = run(compare);
    QCOMPARE(text.status, 0);
    QVERIFY2(text.out.endsWith("\n\n2 files: 1 agree, 0 come close, 1 differ.\n"), text.out.constData());
    QVERIFY(text.out.contains("\n\n" + other.toUtf8() + ": t = 0 s to 1 s, 201 instants\n"));
    QCOMPARE(run(compare + QStringList{"--fail-on-difference"}).status, 1);
    QCOMPARE(run({"compare", sample(), sample(), "--b", "60", "--fail-on-difference"}).status, 0);
}

void TestCommandLine::comparesTheFilesThatItCanRead()
{
    QTemporaryDir folder;
    const QString missing = folder.filePath(QStringLiteral("missing.csv"));
    const QStringList compare{"compare", missing, sample(), "--b", "60", "--fail-on-difference", "--format"};
    const Outcome json = run(compare + QStringList{"json"});
    QCOMPARE(json.status, 3);
    QVERIFY2(isOneLine(json.err) && json.err.startsWith(missing.toUtf8()), json.err.constData());
    const QJsonArray files = QJsonDocument::fromJson(json.out).object()["files"].toArray();
    QCOMPARE(files.size(), qsizetype(1));
    QCOMPARE(files[0].toObject()["file"].toString(), sample());
    QCOMPARE(tableOf(run(compare + QStringList{"csv"}).out).cells.size(), std::size_t(6));
    QVERIFY(run(compare + QStringList{"text"}).out.endsWith("1 could not be read.\n"));

    const QString output = folder.filePath(QStringLiteral("table.csv"));
    QCOMPARE(run({"compare", missing, missing, "--output", output}).status, 3);
    QVERIFY(!QFile::exists(output));
}

void TestCommandLine::tellsRoundingFromDifference_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("mechanism");
    QTest::addColumn<int>("agreeing");
    QTest::addColumn<int>("differing");
    const auto sixDigits = [](double value) { return QByteArray::number(value, 'g', 6); };
    const auto inFull = [](double value) {
        return QByteArray::number(QByteArray::number(value, 'g', 6).toDouble(), 'e', 18);
    };
    const auto whole = [](double value) { return QByteArray::number(value, 'f', 0); };
    const auto fourDecimals = [](double value) { return QByteArray::number(value, 'f', 4); };
    QTest::newRow("30 frames a second, instants of four decimals")
        << printedFile(1.0, 30, fourDecimals, sixDigits) << QString() << 6 << 0;
    QTest::newRow("six digits, printed with 19") << printedFile(1.0, 100, inFull, inFull) << QString() << 6 << 0;
    QTest::newRow("of a mechanism a fifth longer, six digits, instants of four decimals")
        << printedFile(1.2, 30, fourDecimals, sixDigits) << QString() << 3 << 3;
    QTest::newRow("of a mechanism half as long again, whole millimetres")
        << printedFile(1.5, 100, sixDigits, whole) << QString() << 3 << 3;
    QByteArray constants = "time,theta2_diff,R4_y\n";
    for (int i = 0; i < 50; ++i) {
        constants += QByteArray::number(0.01 * i) + ",360,25\n";
    }
    QTest::newRow("constants") << constants << "--omega2 6.2831855 --c 25.000012" << 2 << 0;
    QTest::newRow("two whole numbers of another mechanism")
        << QByteArray("time,R4_x\n0,70\n0.5,40\n") << "--a 60 --b 350" << 0 << 1;
}

void TestCommandLine::tellsRoundingFromDifference()
{
    QFETCH(QByteArray, file);
    QFETCH(QString, mechanism);
    QFETCH(int, agreeing);
    QFETCH(int, differing);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.csv"));
    writeFile(path, file);
    const Outcome outcome = run(QStringList{"compare", path, "--fail-on-difference", "--format", "csv"} +
                                QProcess::splitCommand(mechanism));
    int agrees = 0;
    int differs = 0;
    const Table table = tableOf(outcome.out);
    const qsizetype verdict = table.header.indexOf("verdict");
    for (const QByteArrayList &row : table.cells) {
        agrees += row[verdict] == "agrees" ? 1 : 0;
        differs += row[verdict] == "differs" ? 1 : 0;
    }
    QVERIFY2(agrees == agreeing && differs == differing, outcome.out.constData());
    QCOMPARE(outcome.status, differing > 0 ? 1 : 0);
}

void TestCommandLine::saysWhatBoundsTheMotion()
{
    const double a = 20.0;
    const double b = 65.0;
    const double c = 25.0;
    const double degree = std::acos(-1.0) / 180.0;
    const Outcome outcome = run({"limits", "--format", "json"});
    QCOMPARE(outcome.status, 0);
    const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
    QCOMPARE(json["mobility"].toString(), QStringLiteral("full-turn"));
    QMap<QString, QJsonObject> limits;
    for (const QJsonValue &limit : json["limits"].toArray()) {
        limits.insert(limit["name"].toString(), limit.toObject());
    }
    QCOMPARE(limits.size(), qsizetype(15));
    // Norton, "Design of Machinery", by hand.
    const double outer = std::asin(c / (b + a)) / degree;
    const double inner = 180.0 + std::asin(c / (b - a)) / degree;
    const double stroke = std::sqrt((b + a) * (b + a) - c * c) - std::sqrt((b - a) * (b - a) - c * c);
    const QMap<QString, double> values{{"outer-dead-centre", std::sqrt((b + a) * (b + a) - c * c)},
                                       {"inner-dead-centre", std::sqrt((b - a) * (b - a) - c * c)},
                                       {"stroke", stroke},
                                       {"forward-angle", 360.0 - (inner - outer)},
                                       {"return-angle", inner - outer},
                                       {"forward-time", 1.0 - (inner - outer) / 360.0},
                                       {"return-time", (inner - outer) / 360.0},
                                       {"time-ratio", (inner - outer) / (360.0 - (inner - outer))},
                                       {"least-transmission-angle", std::acos((a + c) / b) / degree},
                                       {"mean-forward-speed", stroke / (1.0 - (inner - outer) / 360.0)},
                                       {"mean-return-speed", stroke / ((inner - outer) / 360.0)}};
    for (auto value = values.begin(); value != values.end(); ++value) {
        QVERIFY2(std::abs(limits[value.key()]["value"].toDouble() - value.value()) <= 1e-9 * std::abs(value.value()),
                 qPrintable(value.key()));
    }
    QVERIFY(std::abs(limits["outer-dead-centre"]["theta2"].toDouble() - outer) < 1e-9);
    QVERIFY(std::abs(limits["inner-dead-centre"]["time"].toDouble() - inner / 360.0) < 1e-12);
    // The peaks against a run of fine steps.
    const Table run20000 = tableOf(run({"solve", "--method", "closed-form", "--steps", "20000", "--channels",
                                        "theta3_diff,R4_x_diff,theta3_diff2,R4_x_diff2"})
                                       .out);
    const QStringList peaks{"peak-coupler-speed", "peak-slider-speed", "peak-coupler-acceleration",
                            "peak-slider-acceleration"};
    for (qsizetype k = 0; k < peaks.size(); ++k) {
        double largest = 0.0;
        for (const QByteArrayList &row : run20000.cells) {
            largest = std::max(largest, std::abs(row[k + 1].toDouble()));
        }
        QVERIFY2(std::abs(limits[peaks[k]]["value"].toDouble() - largest) <= 1e-6 * largest, qPrintable(peaks[k]));
    }

    // A rocker has no dead centres to go between, and what cannot be assembled has nothing.
    const Outcome rocker = run({"limits", "--b", "40", "--format", "csv"});
    QCOMPARE(rocker.status, 0);
    QVERIFY2(rocker.out.contains("\nforward-time,,s,,\n"), rocker.out.constData());
    const Outcome impossible = run({"limits", "--c", "100", "--format", "json"});
    QCOMPARE(impossible.status, 4);
    QVERIFY(impossible.out.contains("\"mobility\":\"impossible\"") && !impossible.out.contains("nan"));
    const Outcome text = run(QStringList{"limits"});
    QVERIFY2(text.out.startsWith("The crank turns round: b = 65 mm") && text.out.contains("43.8238 mm"),
             text.out.constData());
}

void TestCommandLine::saysWhoseMotionADifferentFileIs()
{
    for (const QString &file : {sample(), authorsFile()}) {
        if (!QFile::exists(file)) {
            QSKIP("The author's own file is not here.");
        }
        const Outcome wrong = run({"compare", file});
        QVERIFY2(
            wrong.out.contains("\nThis error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it.\n"),
            wrong.out.constData());
        QVERIFY2(wrong.out.contains("\nThe file's own mechanism: a = "), wrong.out.constData());
        const Outcome right = run({"compare", file, "--b", "60"});
        QCOMPARE(right.out.count("agrees within the file's rounding"), qsizetype(6));
        QVERIFY2(!right.out.contains("This error") && !right.out.contains("own mechanism"), right.out.constData());
    }
}

void TestCommandLine::saysInJsonWhyAFileDiffers()
{
    const Outcome outcome = run({"compare", sample(), "--format", "json"});
    const QJsonObject file = QJsonDocument::fromJson(outcome.out).object()["files"].toArray().first().toObject();
    QCOMPARE(file["verdict"].toString(), QStringLiteral("differs"));
    const QJsonObject explanation = file["explanation"].toObject();
    QVERIFY(
        explanation["sentence"].toString().startsWith(QStringLiteral("This error looks like b = 60 instead of 65")));
    QVERIFY(std::abs(explanation["mechanism"].toObject()["b"].toDouble() - 60.0) < 1e-5);
    QCOMPARE(explanation["conventions"].toArray(), QJsonArray());
}

void TestCommandLine::itsSentencesAgreeWithEachOther_data()
{
    QTest::addColumn<QString>("channels");
    QTest::addColumn<QString>("rows");
    QTest::newRow("the coupler's centre alone") << "R3_x,R3_y,R3_x_diff"
                                                << "200";
    QTest::newRow("a column of it") << "R3_x"
                                    << "200";
    QTest::newRow("two exact rows") << "theta3,R4_x"
                                    << "1";
}

void TestCommandLine::itsSentencesAgreeWithEachOther()
{
    QFETCH(const QString, channels);
    QFETCH(const QString, rows);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.csv"));
    const QStringList solve{"solve", "--b", "60", "--duration", "0.3", "--steps", rows, "--channels", channels};
    QCOMPARE(run(solve + QStringList{"--output", path}).status, 0);
    const Outcome compared = run({"compare", path});
    QVERIFY2(compared.out.contains("\nDiffers from this mechanism in "), compared.out.constData());
    QVERIFY2(!compared.out.contains("Read this way") && !compared.out.contains("slider-crank"),
             compared.out.constData());

    // What explains the difference is said where a mechanism explains the file.
    const Outcome identified = run({"identify", path});
    const bool isFound = identified.status == 0;
    QCOMPARE(compared.out.contains(" explains 9"), isFound);
    QCOMPARE(compared.out.contains("\nThe file's own mechanism: "), isFound);
    QCOMPARE(identified.out.contains("To go on with it"), isFound);
    QVERIFY(isFound || (isOneLine(identified.err) && !identified.err.contains("±")));
    QVERIFY(!isFound || rows != "1");
}

void TestCommandLine::saysWhatAFileMeansOtherwise()
{
    QTemporaryDir folder;
    const QString path = fileInRadians(folder);
    const Outcome outcome = run({"compare", path});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.out.contains("\ntheta3: in radians, but read as degrees. Multiplies theta3 by 57.2958: "),
             outcome.out.constData());
    QVERIFY2(outcome.out.endsWith("\nRead this way, it does not differ from this mechanism.\n"),
             outcome.out.constData());
    QVERIFY2(!outcome.out.contains("This error"), outcome.out.constData());
}

void TestCommandLine::neverOverwritesWhatItReads()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.svg")); // however it is named
    run({"solve", "--output", path});
    const QByteArray content = contentOf(path);
    for (const QStringList &line :
         {QStringList{"compare", sample(), path}, QStringList{"identify", path, "--format", "json"},
          QStringList{"render", "--reference", path}}) {
        const Outcome outcome = run(line + QStringList{"--output", path});
        QCOMPARE(outcome.status, 2);
        QVERIFY2(isOneLine(outcome.err) && outcome.err.contains("would overwrite"), outcome.err.constData());
    }
    QCOMPARE(contentOf(path), content);
}

/// A turn and more of a = 20, b = 60, c = 10 mm at 2π rad/s, written with other names and other powers of ten.
void TestCommandLine::identifiesNoMechanismThatItWouldRefuse_data()
{
    QTest::addColumn<QByteArray>("names");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("first"); // of the column of time or angle
    QTest::addColumn<double>("velocity");
    QTest::addColumn<bool>("isFound");
    const auto row = [](const char *tag, const char *names, double length, double first, double velocity,
                        bool isFound) {
        QTest::newRow(tag) << QByteArray(names) << length << first << velocity << isFound;
    };
    const char *const byTime = "t [s],R4_x [mm],R4_x_diff [mm/s],R4_x_diff2 [mm/s2]\n";
    const char *const byAngle =
        "Crank angle (deg),Slider position (mm),Slider velocity (mm/s),Slider acceleration (mm/s2)\n";
    row("as it is", byTime, 1.0, 1.0, 1.0, true);
    row("by crank angle", byAngle, 1.0, 360.0, 1.0, true);
    row("too long", byTime, 1e13, 1.0, 1e13, false);
    row("too fast", byTime, 1.0, 1e-13, 1e13, false);
    row("too fast in the unit of time that it has", byTime, 1.0, 1e-10, 1e13, false);
    row("too long by crank angle", byAngle, 1e13, 360.0, 1e13, false);
    row("too fast by crank angle", byAngle, 1.0, 360.0, 1e13, false);
}

void TestCommandLine::identifiesNoMechanismThatItWouldRefuse()
{
    QFETCH(QByteArray, names);
    QFETCH(double, length);
    QFETCH(double, first);
    QFETCH(double, velocity);
    QFETCH(bool, isFound);
    constexpr int kRows = 120;
    QByteArray text = names;
    for (int i = 0; i < kRows; ++i) {
        const double turns = 1.2 * i / kRows;
        const double theta2 = 2.0 * std::numbers::pi * turns;
        const double sine = (10.0 - 20.0 * std::sin(theta2)) / 60.0;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const double position = 20.0 * std::cos(theta2) + 60.0 * cosine;
        const double slope = -20.0 * std::sin(theta2) + 20.0 * std::cos(theta2) * sine / cosine;
        const double bend = -20.0 * std::cos(theta2) - 20.0 * std::sin(theta2) * sine / cosine -
                            400.0 / 60.0 * std::pow(std::cos(theta2), 2) / std::pow(cosine, 3);
        const double speed = 2.0 * std::numbers::pi * velocity / length;
        for (const double value :
             {first * turns, length * position, length * slope * speed, length * bend * speed * speed}) {
            text += QByteArray::number(value, 'g', 12) + ',';
        }
        text.back() = '\n';
    }
    const Outcome outcome = run({"identify", "-", "--format", "json"}, withoutDisplay(), text);
    const QJsonObject found = QJsonDocument::fromJson(outcome.out).object();
    const QJsonObject mechanism = found["mechanism"].toObject();
    QCOMPARE(found["outcome"].toString() == QLatin1String("identified"), isFound);
    QCOMPARE(mechanism.isEmpty(), !isFound);
    QCOMPARE(outcome.status == 0, isFound);
    if (isFound) {
        QVERIFY(std::abs(mechanism["b"].toDouble() - 60.0) < 1e-6);
        QVERIFY(std::abs(mechanism["omega2"].toDouble() - 2.0 * std::numbers::pi) < 1e-6);
    }
}

void TestCommandLine::identifiesTheAuthorsFile_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("the sample") << sample();
    QTest::newRow("the author's own") << authorsFile();
}

void TestCommandLine::identifiesTheAuthorsFile()
{
    QFETCH(QString, file);
    if (!QFile::exists(file)) {
        QSKIP("The author's own file is not here.");
    }
    const Outcome outcome = run({"identify", file, "--format", "json"});
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.err, QByteArray());
    QJsonParseError parsing;
    const QJsonObject found = QJsonDocument::fromJson(outcome.out, &parsing).object();
    QCOMPARE(parsing.error, QJsonParseError::NoError);
    QCOMPARE(found.keys(), QStringList({"alternatives", "channels", "columns", "conditionNumber", "conventions", "file",
                                        "identifiable", "iterations", "mechanism", "noise", "outcome", "rounded",
                                        "standardError", "summary"}));
    QCOMPARE(found["file"].toString(), file);
    QCOMPARE(found["outcome"].toString(), QStringLiteral("identified"));
    QCOMPARE(found["alternatives"].toArray(), QJsonArray());
    QCOMPARE(found["noise"].toObject(), QJsonObject());

    // Other measurements of the same file found these within 3e-5 mm, 1e-6 rad/s and 1e-6 rad.
    const struct {
        const char *name;
        double value;
        double tolerance;
    } expected[] = {{"a", 20.0, 1e-5},
                    {"b", 60.0, 1e-5},
                    {"c", 25.0, 1e-5},
                    {"omega2", 2.0 * std::numbers::pi, 1e-6},
                    {"theta20", 0.0, 1e-6}};
    const QJsonObject mechanism = found["mechanism"].toObject();
    const QJsonObject errors = found["standardError"].toObject();
    const QJsonObject identifiable = found["identifiable"].toObject();
    QCOMPARE(mechanism.size(), qsizetype(6));
    QCOMPARE(errors.size(), qsizetype(5));
    QCOMPARE(identifiable.size(), qsizetype(5));
    for (const auto &parameter : expected) {
        const QLatin1String name(parameter.name);
        QVERIFY2(std::abs(mechanism[name].toDouble() - parameter.value) < parameter.tolerance, parameter.name);
        QVERIFY2(errors[name].toDouble() > 0.0 && errors[name].toDouble() < parameter.tolerance, parameter.name);
        QCOMPARE(identifiable[name], QJsonValue(true));
    }
    QCOMPARE(mechanism["branch"].toString(), QStringLiteral("open"));
    const QJsonObject rounded = found["rounded"].toObject();
    QCOMPARE(rounded["a"].toDouble(), 20.0);
    QCOMPARE(rounded["b"].toDouble(), 60.0);
    QCOMPARE(rounded["c"].toDouble(), 25.0);
    QCOMPARE(rounded["omega2"].toDouble(), 2.0 * std::numbers::pi);
    QCOMPARE(rounded["theta20"].toDouble(), 0.0);
    QVERIFY(found["iterations"].toInt() > 0 && found["iterations"].toInt() < 50);
    QVERIFY(found["conditionNumber"].toDouble() > 1.0 && found["conditionNumber"].toDouble() < 100.0);
    QCOMPARE(found["conventions"].toArray(), QJsonArray());
    QVERIFY(found["summary"].toString().startsWith(QStringLiteral("a = ")));
    const QJsonArray channels = found["channels"].toArray();
    QCOMPARE(channels.size(), qsizetype(6));
    for (const QJsonValue &channel : channels) {
        QCOMPARE(channel.toObject()["verdict"].toString(), QStringLiteral("agrees"));
        QCOMPARE(channel.toObject().size(), qsizetype(12));
    }
}

void TestCommandLine::identifiesInWordsAndGoesOnWithIt()
{
    const Outcome outcome = run({"identify", sample()});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.out.contains(" mm, b = ") && outcome.out.contains(" ± "), outcome.out.constData());
    QVERIFY2(outcome.out.contains("\nAgrees with this mechanism in 6 of 6 channels"), outcome.out.constData());
    const QByteArray lead = "\nTo go on with it: ";
    const qsizetype at = outcome.out.indexOf(lead);
    QVERIFY2(at > 0, outcome.out.constData());
    const QString options = QString::fromUtf8(outcome.out.mid(at + lead.size())).trimmed();
    const Outcome compared = run(QStringList{"compare", sample(), "--fail-on-difference"} + options.split(u' '));
    QVERIFY2(compared.status == 0 && compared.out.contains("Agrees with this mechanism in 6 of 6"),
             (options.toUtf8() + compared.err + compared.out).constData());
}

void TestCommandLine::identifiesWhatReadsOtherwise()
{
    QTemporaryDir folder;
    const Outcome outcome = run({"identify", fileInRadians(folder), "--format", "json"});
    QCOMPARE(outcome.status, 0);
    const QJsonObject found = QJsonDocument::fromJson(outcome.out).object();
    const QJsonArray conventions = found["conventions"].toArray();
    QCOMPARE(conventions.size(), qsizetype(1));
    const QJsonObject convention = conventions[0].toObject();
    QCOMPARE(convention.keys(), QStringList({"after", "amount", "before", "channel", "explanation", "name", "unit"}));
    QCOMPARE(convention["name"].toString(), QStringLiteral("angle-unit"));
    QCOMPARE(convention["channel"].toString(), QStringLiteral("theta3"));
    QVERIFY(std::abs(convention["amount"].toDouble() - 180.0 / std::numbers::pi) < 1e-12);
    QCOMPARE(convention["unit"], QJsonValue(QJsonValue::Null));
    QCOMPARE(convention["explanation"].toString(), QStringLiteral("theta3: in radians, but read as degrees."));
    QVERIFY(convention["before"].toDouble() > 90.0);
    QVERIFY(convention["after"].toDouble() < 0.01);
    QVERIFY(std::abs(found["mechanism"].toObject()["b"].toDouble() - 65.0) < 1e-3);
    for (const QJsonValue &channel : found["channels"].toArray()) {
        QCOMPARE(channel.toObject()["verdict"].toString(), QStringLiteral("agrees"));
    }
}

void TestCommandLine::saysWhatAFileCannotFix()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("angle.csv"));
    run({"solve", "--a", "30", "--b", "90", "--c", "-15", "--channels", "theta3", "--output", path});
    const Outcome outcome = run({"identify", path, "--format", "json"});
    QCOMPARE(outcome.status, 0);
    const QJsonObject found = QJsonDocument::fromJson(outcome.out).object();
    const QJsonObject mechanism = found["mechanism"].toObject();
    QVERIFY(std::abs(mechanism["b"].toDouble() / mechanism["a"].toDouble() - 3.0) < 1e-6);
    QVERIFY(std::abs(mechanism["c"].toDouble() / mechanism["a"].toDouble() + 0.5) < 1e-6);
    QCOMPARE(found["identifiable"].toObject()["a"], QJsonValue(false));
    QCOMPARE(found["standardError"].toObject()["a"], QJsonValue(QJsonValue::Null));
    const QString summary = found["summary"].toString();
    QVERIFY2(summary.contains(QStringLiteral("The coupler angle θ³ alone determines only b/a and c/a; a = 20 mm")),
             qPrintable(summary));
}

void TestCommandLine::namesTheMirrorImageOfASlider()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("slider.csv"));
    run({"solve", "--a", "30", "--b", "90", "--c", "-15", "--channels", "R4_x", "--output", path});
    const Outcome outcome = run({"identify", path, "--format", "json"});
    QCOMPARE(outcome.status, 0);
    const QJsonObject found = QJsonDocument::fromJson(outcome.out).object();
    QCOMPARE(found["outcome"].toString(), QStringLiteral("identified"));
    QCOMPARE(found["alternatives"].toArray().size(), qsizetype(1));
    const QJsonObject image = found["alternatives"].toArray().first().toObject();
    QCOMPARE(image.keys(), QStringList({"mechanism", "why"}));
    QCOMPARE(image["why"].toString(), QStringLiteral("mirror-image"));
    QCOMPARE(image["mechanism"].toObject()["c"].toDouble(), -found["mechanism"].toObject()["c"].toDouble());
    QCOMPARE(image["mechanism"].toObject()["omega2"].toDouble(), -found["mechanism"].toObject()["omega2"].toDouble());
}

void TestCommandLine::saysWhenItFindsNoMechanism()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("short.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time,R4_x\n0,80\n0.1,79\n");
    file.close();
    const Outcome text = run({"identify", path});
    QCOMPARE(text.status, 5);
    QCOMPARE(text.out, QByteArray());
    QVERIFY2(isOneLine(text.err) && text.err.contains("too few values"), text.err.constData());
    const Outcome json = run({"identify", path, "--format", "json"});
    QCOMPARE(json.status, 5);
    const QJsonObject none = QJsonDocument::fromJson(json.out).object();
    QCOMPARE(none["outcome"].toString(), QStringLiteral("insufficient"));
    QCOMPARE(none["mechanism"], QJsonValue(QJsonValue::Null));
    QCOMPARE(none["rounded"], QJsonValue(QJsonValue::Null));
    QCOMPARE(none["conditionNumber"], QJsonValue(QJsonValue::Null));
    QCOMPARE(none["identifiable"].toObject()["b"], QJsonValue(false));
    QCOMPARE(none["channels"].toArray(), QJsonArray());
    QCOMPARE(run({"identify", folder.filePath(QStringLiteral("missing.csv"))}).status, 3);
}

void TestCommandLine::identifiesSeveralFiles()
{
    QTemporaryDir folder;
    const QString missing = folder.filePath(QStringLiteral("missing.csv"));
    const QString few = folder.filePath(QStringLiteral("few.csv"));
    writeFile(few, "time,R4_x\n0,80\n0.1,79\n");
    const auto filesOf = [](const Outcome &outcome) {
        return QJsonDocument::fromJson(outcome.out).object()["files"].toArray();
    };

    // The status is that of the worst: 0 only where all are identified or ambiguous.
    const Outcome two = run({"identify", sample(), sample(), "--format", "json"});
    QCOMPARE(two.status, 0);
    QCOMPARE(filesOf(two).size(), qsizetype(2));
    const Outcome one = run({"identify", sample(), "--format", "json"});
    QCOMPARE(filesOf(two)[1].toObject(), QJsonDocument::fromJson(one.out).object());

    const Outcome json = run({"identify", few, sample(), "--format", "json"});
    QCOMPARE(json.status, 5);
    QCOMPARE(filesOf(json)[0].toObject()["outcome"].toString(), QStringLiteral("insufficient"));
    QCOMPARE(filesOf(json)[1].toObject()["outcome"].toString(), QStringLiteral("identified"));
    QVERIFY2(isOneLine(json.err) && json.err.startsWith(few.toUtf8()), json.err.constData());

    const Outcome text = run({"identify", sample(), few, missing});
    QCOMPARE(text.status, 3);
    QVERIFY2(text.out.startsWith(sample().toUtf8() + ": t = 0 s"), text.out.constData());
    QVERIFY2(text.out.contains("\n\n" + few.toUtf8() + ": t = 0 s to 0.1 s, 2 instants\nThere are too few values"),
             text.out.constData());
    QVERIFY2(text.out.endsWith("\n\n3 files: 1 identified, 0 ambiguous, 1 not identified, 1 could not be read.\n"),
             text.out.constData());
    QVERIFY2(isOneLine(text.err) && text.err.startsWith(missing.toUtf8()), text.err.constData());
}

void TestCommandLine::readsStandardInput()
{
    const QByteArray motion = contentOf(sample());
    const auto entryOf = [](const Outcome &outcome) {
        return QJsonDocument::fromJson(outcome.out).object()["files"].toArray().first().toObject();
    };
    const QStringList compare{"compare", "--b", "60", "--format", "json"};
    const Outcome file = run(compare + QStringList{sample()});
    const Outcome pipe = run(compare + QStringList{"-"}, withoutDisplay(), motion);
    QCOMPARE(pipe.status, 0);
    QCOMPARE(entryOf(pipe)["file"].toString(), QStringLiteral("-"));
    QCOMPARE(entryOf(pipe)["channels"], entryOf(file)["channels"]);

    const Outcome text = run({"identify", "-"}, withoutDisplay(), motion);
    QCOMPARE(text.status, 0);
    QVERIFY2(text.out.startsWith("Standard input: t = 0 s to 1 s, 201 instants\n"), text.out.constData());

    QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("figure.png"));
    QCOMPARE(run({"render", "--reference", "-", "--output", picture}, withoutDisplay(), motion).status, 0);

    // More than a pipe holds, and more than is looked at to tell whether it is a table.
    QByteArray large = "id,T,x\n";
    for (int row = 0; large.size() < 3'000'000; ++row) {
        large += QByteArray::number(row) + ',' + QByteArray::number(row) + ",25\n";
    }
    const QStringList named{"--column", "T=time [us]", "--column", "x=R4_y", "--column", "id=ignored"};
    const Outcome all = run(compare + QStringList{"-"} + named, withoutDisplay(), large);
    QCOMPARE(all.status, 0);
    QCOMPARE(entryOf(all)["channels"].toArray().first().toObject()["count"].toInt(), large.count('\n') - 1);

    const Outcome none = run({"compare", "-"});
    QCOMPARE(none.status, 3);
    QVERIFY2(none.err.startsWith("Standard input: ") && none.err.contains("is empty"), none.err.constData());

    // A scene, too; a pipe by its name is a file like any other.
    const Outcome scene = run({"limits", "--scene", "-"}, withoutDisplay(), "{\"version\": 1}");
    QCOMPARE(scene.status, 3);
    QVERIFY2(scene.err.startsWith("Standard input: "), scene.err.constData());
    const QString fifo = folder.filePath(QStringLiteral("fifo"));
    if (QProcess::execute(QStringLiteral("mkfifo"), {fifo}) == 0) {
        QProcess writer;
        writer.start(QStringLiteral("cp"), {sample(), fifo});
        QCOMPARE(entryOf(run(compare + QStringList{fifo}))["channels"], entryOf(file)["channels"]);
        QVERIFY(writer.waitForFinished(slidercrank::kPatience));
    }
}

void TestCommandLine::joinsFilesOfOneMotion()
{
    QTemporaryDir folder;
    const QString position = plotOfSample(folder, "position.csv", {1});
    const QString rates = plotOfSample(folder, "rates.csv", {2, 3});
    const QString coupler = plotOfSample(folder, "coupler.csv", {4, 5, 6});
    const QStringList plots{position, rates, coupler};
    const auto entryOf = [](const Outcome &outcome) {
        const QJsonObject object = QJsonDocument::fromJson(outcome.out).object();
        return object.contains("files") ? object["files"].toArray().first().toObject() : object;
    };
    for (const QStringList &command :
         {QStringList{"compare", "--b", "60"}, QStringList{"compare"}, QStringList{"identify"}}) {
        const QStringList inJson = command + QStringList{"--format", "json"};
        const Outcome outcome = run(inJson + QStringList{"--join"} + plots);
        QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), outcome.err.constData());
        const QJsonObject joined = entryOf(outcome);
        const QJsonObject whole = entryOf(run(inJson + QStringList{sample()}));
        for (const QString &key : whole.keys()) {
            if (key != u"file" && key != u"columns") {
                QVERIFY2(joined[key] == whole[key], qPrintable(key));
            }
        }
        QCOMPARE(joined.keys().size(), whole.keys().size() + 1);
        QCOMPARE(joined["file"].toString(), plots.join(QStringLiteral(" + ")));
        QCOMPARE(joined["joined"].toArray(), QJsonArray::fromStringList(plots));
        const QJsonObject last = joined["columns"].toArray().last().toObject();
        QCOMPARE(last["file"].toString(), QStringLiteral("coupler.csv"));
        QCOMPARE(last["heading"].toString(), QStringLiteral("theta3_diff2"));
    }

    // One of them may come from elsewhere; columns count on; a row left out is named with its file.
    const Outcome pipe = run({"compare", "--b", "60", "--join", position, "-"}, withoutDisplay(), contentOf(coupler));
    QCOMPARE(pipe.status, 0);
    QVERIFY2(pipe.out.contains("Agrees with this mechanism in 4 of 4 channels"), pipe.out.constData());
    const QString value = writeFile(folder.filePath(QStringLiteral("value.csv")),
                                    contentOf(rates).replace("R4_x_diff,R4_x_diff2", "Value,Other") + "1.1,?,0\n");
    const Outcome named = run({"compare", "--b", "60", "--join", position, value, "--column", "#4=R4_x_diff"});
    QCOMPARE(named.status, 0);
    QVERIFY2(named.out.contains("Agrees with this mechanism in 2 of 2 channels"), named.out.constData());
    QVERIFY2(named.err.contains("the first in line 203 (value.csv), column 2") &&
                 named.err.contains("were not used: Other (value.csv)"),
             named.err.constData());

    const QString picture = folder.filePath(QStringLiteral("plot.svg"));
    QCOMPARE(
        run({"render", "--what", "R4_x", "--reference", position, "--reference", coupler, "--output", picture}).status,
        0);
    const Outcome window = run({position, rates}); // which it misses here
    QVERIFY2(window.status == 2 && window.err.contains("There is no display"), window.err.constData());
}

void TestCommandLine::saysWhyFilesAreNotOfOneMotion()
{
    QTemporaryDir folder;
    const QString position = plotOfSample(folder, "position.csv", {1});
    const QString again = plotOfSample(folder, "again.csv", {1, 4});
    const QString coarse = plotOfSample(folder, "coarse.csv", {4}, 2);
    const QString missing = folder.filePath(QStringLiteral("missing.csv"));
    const QString text = writeFile(folder.filePath(QStringLiteral("text.csv")), "%PDF-1.7\n");
    const auto refused = [&](const QString &other, const QString &sentence, const QStringList &more = {}) {
        const Outcome outcome = run(QStringList{"compare", "--join", position, other} + more);
        const bool isSaid = outcome.status == 3 && outcome.out.isEmpty() && isOneLine(outcome.err) &&
                            QString::fromUtf8(outcome.err).startsWith(sentence);
        return isSaid ? QByteArray() : outcome.err + outcome.out;
    };
    QCOMPARE(refused(again, again + ": it holds R4_x, and " + position + " does, too"), QByteArray());
    QCOMPARE(refused(coarse, coarse + ": its instants are not those of " + position), QByteArray());
    QCOMPARE(refused(position, position + " is named twice"), QByteArray());
    QCOMPARE(refused(missing, missing + " cannot be opened"), QByteArray());
    QCOMPARE(refused(text, text + ": The file is a PDF document"), QByteArray());
    QCOMPARE(
        refused(again, position + " + " + again + ": several columns are called \"time\"", {"--column", "time=time"}),
        QByteArray());

    QCOMPARE(run({position, missing}).status, 3);
    const Outcome scene = run({position, QStringLiteral("a.slidercrank")});
    QVERIFY2(scene.status == 2 && scene.err.contains("a.slidercrank is a scene: open it by itself"),
             scene.err.constData());
}

void TestCommandLine::takesColumnsForWhatIsSaid()
{
    // Table 1 with b = 60 under names that say nothing, in m and rad, beside a column that would be taken for another.
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("model.csv"));
    QByteArray motion = "clock;slider.s;arm.phi (rad);x = y;x = y\n";
    for (int row = 0; row <= 40; ++row) {
        const Textbook at = textbook(20, 60, 25, 2 * std::numbers::pi, 2 * std::numbers::pi * row / 40.0, false);
        const double cells[] = {25.0 * row, at.R4x / 1000.0, at.theta3, at.theta3Dot, 7.0};
        for (const double cell : cells) {
            motion += QByteArray::number(cell, 'g', 9) + ';';
        }
        motion.back() = '\n';
    }
    writeFile(path, motion);
    const QStringList columns{"--column", "clock=time [ms]", "--column", "slider.s=R4_x [m]",
                              "--column", "arm.phi=theta3",  "--column", "#4=theta3_diff [rad/s]"};
    const Outcome json =
        run(QStringList{"compare", path, "--b", "60", "--format", "json", "--fail-on-difference"} + columns);
    QVERIFY2(json.status == 0, json.err.constData());
    const QJsonObject entry = QJsonDocument::fromJson(json.out).object()["files"].toArray().first().toObject();
    QStringList names;
    for (const QJsonValue &channel : entry["channels"].toArray()) {
        names += channel.toObject()["name"].toString();
    }
    QCOMPARE(names, QStringList({"R4_x", "theta3", "theta3_diff"}));
    QCOMPARE(entry["columns"].toArray()[1].toObject()["why"].toString(), QStringLiteral("chosen by hand"));
    QCOMPARE(entry["ignoredColumns"].toArray().size(), qsizetype(1));
    const Outcome found = run(QStringList{"identify", path} + columns);
    QVERIFY2(found.status == 0 && found.out.contains("--b 60 "), found.out.constData());

    // Said otherwise it is another motion.
    QStringList otherwise = columns;
    otherwise[3] = QStringLiteral("slider.s=R4_x [cm]");
    QCOMPARE(run(QStringList{"compare", path, "--b", "60", "--fail-on-difference"} + otherwise).status, 1);

    const auto refusal = [&](const QString &column) {
        const Outcome outcome = run({"compare", path, "--column", column});
        return outcome.status == 3 && isOneLine(outcome.err) ? outcome.err : QByteArray();
    };
    const QByteArray missing = refusal(QStringLiteral("slider.x=R4_x"));
    QVERIFY2(missing.contains("no column \"slider.x\"") && missing.contains("clock, slider.s, arm.phi (rad), x = y"),
             missing.constData());
    QVERIFY(refusal(QStringLiteral("#6=R4_x")).contains("no column \"#6\""));
    QVERIFY(refusal(QStringLiteral("x = y=R4_x")).contains("several columns are called \"x = y\""));
}

void TestCommandLine::readsATableByTheCranksAngle_data()
{
    QTest::addColumn<QByteArray>("heading");
    QTest::addColumn<double>("first"); // °
    QTest::addColumn<double>("step");
    QTest::addColumn<double>("unit"); // in a degree
    QTest::addColumn<QString>("options");
    const double radian = 180.0 / std::numbers::pi;
    QTest::newRow("textbook, every 15°") << QByteArray("Crank angle (deg)") << 0.0 << 15.0 << 1.0 << QString();
    QTest::newRow("engine, two turns") << QByteArray("CAD") << -360.0 << 30.0 << 1.0 << QString();
    QTest::newRow("backwards") << QByteArray("theta2") << 360.0 << -15.0 << 1.0 << QString();
    QTest::newRow("radians") << QByteArray("theta2 (rad)") << 0.0 << 15.0 << 1.0 / radian << QString();
    QTest::newRow("said so") << QByteArray("phi") << 0.0 << 15.0 << 1.0 << "--abscissa angle";
    QTest::newRow("said so of the column")
        << QByteArray("phi") << 0.0 << 15.0 << 1.0 / radian << "--column \"phi=crank-angle [rad]\"";
}

void TestCommandLine::readsATableByTheCranksAngle()
{
    QFETCH(const QByteArray, heading);
    QFETCH(const double, first);
    QFETCH(const double, step);
    QFETCH(const double, unit);
    QFETCH(const QString, options);
    QByteArray table = heading + ",Slider position (mm),Coupler angle (deg)\n";
    for (int row = 0; row <= 24; ++row) {
        const double angle = first + step * row;
        const Textbook at = textbook(20, 60, 25, 1.0, angle * kDegree, false);
        table += QByteArray::number(angle * unit, 'g', 9) + ',' + QByteArray::number(at.R4x, 'f', 5) + ',' +
                 QByteArray::number(at.theta3 / kDegree, 'f', 5) + '\n';
    }
    QTemporaryDir folder;
    const QString path = writeFile(folder.filePath(QStringLiteral("table.csv")), table);
    const QStringList compare =
        QStringList{"compare", path, "--fail-on-difference", "--format", "json"} + QProcess::splitCommand(options);

    // Whatever the drive: positions by angle do not depend on it.
    for (const QStringList &drive : {QStringList{}, QStringList{"--omega2", "-157", "--theta20", "2rad"}}) {
        const Outcome same = run(compare + QStringList{"--b", "60"} + drive);
        QVERIFY2(same.status == 0, same.out.constData());
        const QJsonObject entry = QJsonDocument::fromJson(same.out).object()["files"].toArray().first().toObject();
        QCOMPARE(entry["columns"].toArray().first().toObject()["channel"].toString(), QStringLiteral("crank-angle"));
        QCOMPARE(entry["columns"].toArray().first().toObject()["guessed"].toBool(), options.isEmpty());
        const QJsonObject slider = entry["channels"].toArray().first().toObject();
        QCOMPARE(slider["count"].toInt(), 25);
        QVERIFY(slider["maxAbs"].toDouble() <= 0.51e-5 + 20 * 1e-8 * 10);
    }
    const Outcome text = run(QStringList{"compare", path} + QProcess::splitCommand(options));
    QVERIFY2(text.out.contains("b = 60 instead of 65 mm"), text.out.constData());
    QVERIFY2(text.out.contains("25 angles, timed by ω₂ = 6.28318531 rad/s") && text.out.contains("at θ₂ [°]"),
             text.out.constData());

    if (!options.isEmpty()) {
        QCOMPARE(run(compare + QStringList{"--b", "60.01"}).status, 1); // another mechanism is another one
        const Outcome still = run(compare + QStringList{"--omega2", "0"});
        QCOMPARE(still.status, 3);
        QVERIFY2(isOneLine(still.err) && still.err.contains("choose another ω₂"), still.err.constData());
    }
}

void TestCommandLine::knowsNoSpeedOfATableWithoutDerivatives()
{
    QByteArray table = "Crank angle (deg),R4_x\n";
    for (int angle = 0; angle <= 360; angle += 15) {
        const Textbook at = textbook(20, 60, 25, 1.0, angle * kDegree, false);
        table += QByteArray::number(angle) + ',' + QByteArray::number(at.R4x, 'f', 5) + '\n';
    }
    QTemporaryDir folder;
    const QString path = writeFile(folder.filePath(QStringLiteral("table.csv")), table);
    const QStringList identify{"identify", path, "--omega2", "3", "--theta20", "30deg"};
    const Outcome json = run(identify + QStringList{"--format", "json"});
    QCOMPARE(json.status, 0);
    const QJsonObject found = QJsonDocument::fromJson(json.out).object();
    const QJsonObject mechanism = found["mechanism"].toObject();
    const QJsonObject error = found["standardError"].toObject();
    const QJsonObject identifiable = found["identifiable"].toObject();
    for (const auto &[name, value] : {std::pair{"a", 20.0}, std::pair{"b", 60.0}, std::pair{"c", 25.0}}) {
        QVERIFY(identifiable[QLatin1String(name)].toBool());
        QVERIFY(error[QLatin1String(name)].toDouble() < 1e-4);
        QVERIFY(std::abs(mechanism[QLatin1String(name)].toDouble() - value) <
                5.0 * error[QLatin1String(name)].toDouble());
    }
    for (const auto &[name, value] : {std::pair{"omega2", 3.0}, std::pair{"theta20", 30.0 * kDegree}}) {
        QCOMPARE(identifiable[QLatin1String(name)], QJsonValue(false));
        QCOMPARE(error[QLatin1String(name)], QJsonValue(QJsonValue::Null));
        QCOMPARE(mechanism[QLatin1String(name)].toDouble(), value);
    }
    const Outcome text = run(identify);
    QVERIFY2(text.out.contains("The data do not determine ω₂ = 3 rad/s and θ₂₀ = 30°: kept as given."),
             text.out.constData());
    QVERIFY2(text.out.contains("--a 20 --b 60 --c 25 --omega2 3 "), text.out.constData());
    static const QRegularExpression otherPowers(QStringLiteral("[0-9]E[-0-9]|e[+]|e-?0[0-9]|10⁻"));
    QVERIFY2(!QString::fromUtf8(text.out).contains(otherPowers), text.out.constData());
    QVERIFY2(text.out.contains("e-6 "), text.out.constData());
}

void TestCommandLine::takesTheSpeedFromTheDerivatives()
{
    const auto tableOfSpeed = [](double omega2) {
        QByteArray table =
            "Crank angle (deg),Slider position (mm),Slider velocity (mm/s),Slider acceleration (m/s^2)\n";
        for (int angle = 0; angle <= 360; angle += 15) {
            const Textbook at = textbook(20, 60, 25, omega2, angle * kDegree, false);
            table += QByteArray::number(angle) + ',' + QByteArray::number(at.R4x, 'f', 4) + ',' +
                     QByteArray::number(at.R4xDot, 'f', 1) + ',' + QByteArray::number(at.R4xDDot / 1000.0, 'f', 3) +
                     '\n';
        }
        return table;
    };
    QTemporaryDir folder;
    for (const double omega2 : {157.0, -42.0}) {
        const QString path = writeFile(folder.filePath(QStringLiteral("table.csv")), tableOfSpeed(omega2));
        const Outcome json = run({"identify", path, "--format", "json"});
        const QJsonObject found = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(found["outcome"].toString(), QStringLiteral("identified"));
        QCOMPARE(found["identifiable"].toObject()["omega2"], QJsonValue(true));
        QCOMPARE(found["identifiable"].toObject()["theta20"], QJsonValue(false));
        const double error = found["standardError"].toObject()["omega2"].toDouble();
        QVERIFY(error > 0.0 && error < 1e-4 * std::abs(omega2));
        QVERIFY(std::abs(found["mechanism"].toObject()["omega2"].toDouble() - omega2) < 4.0 * error);
        QCOMPARE(found["rounded"].toObject()["omega2"].toDouble(), omega2);
        QVERIFY(found["summary"].toString().contains(QStringLiteral("ω₂ follows from its derivatives")));

        // Against the model's speed only the derivatives differ; against the file's nothing.
        const Outcome other = run({"compare", path, "--b", "60"});
        QVERIFY2(other.out.contains("Differs from this mechanism in 2 of 3 channels"), other.out.constData());
        QVERIFY2(other.out.contains("This error looks like ω₂ = " + QByteArray::number(omega2)), other.out.constData());
        QCOMPARE(
            run({"compare", path, "--b", "60", "--omega2", QString::number(omega2), "--fail-on-difference"}).status, 0);
    }
}

void TestCommandLine::saysWhereTheAnglesAreCountedFrom()
{
    // From the outer dead centre, as engines do, and clockwise.
    const double dead = std::asin(25.0 / 80.0) / kDegree;
    for (const double sign : {1.0, -1.0}) {
        QByteArray table = "CAD,theta3,R4_x\n";
        for (int angle = 0; angle < 720; angle += 15) {
            const Textbook at = textbook(20, 60, 25, 1.0, (sign * angle + dead) * kDegree, false);
            table += QByteArray::number(angle) + ',' + QByteArray::number(at.theta3 / kDegree, 'f', 5) + ',' +
                     QByteArray::number(at.R4x, 'f', 5) + '\n';
        }
        QTemporaryDir folder;
        const QString path = writeFile(folder.filePath(QStringLiteral("engine.csv")), table);
        const Outcome json = run({"compare", path, "--b", "60", "--format", "json"});
        const QJsonObject entry = QJsonDocument::fromJson(json.out).object()["files"].toArray().first().toObject();
        const QJsonArray conventions = entry["explanation"].toObject()["conventions"].toArray();
        QCOMPARE(conventions.size(), qsizetype(sign > 0.0 ? 1 : 2));
        const QJsonObject zero = conventions.last().toObject();
        QCOMPARE(zero["name"].toString(), QStringLiteral("zero-point"));
        QCOMPARE(zero["channel"].toString(), QStringLiteral("theta2"));
        QVERIFY(std::abs(zero["amount"].toDouble() - dead) < 1e-4);
        QVERIFY(zero["after"].toDouble() < 1e-3 && zero["before"].toDouble() > 1.0);
        if (sign < 0.0) {
            QCOMPARE(conventions.first().toObject()["name"].toString(), QStringLiteral("sign"));
        }
        QVERIFY(entry["explanation"].toObject()["sentence"].toString().contains(
            QStringLiteral("Read this way, it does not differ from this mechanism.")));
    }
}

void TestCommandLine::saysWhatIsWrongWithAFile()
{
    QTemporaryDir folder;
    const QString noise = folder.filePath(QStringLiteral("noise.csv"));
    QFile file(noise);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("Once upon a time\nthere was no number here\n");
    file.close();
    for (const QString &path : {folder.filePath(QStringLiteral("missing.csv")), folder.path(), noise}) {
        const Outcome outcome = run({QStringLiteral("compare"), path});
        QCOMPARE(outcome.status, 3);
        QCOMPARE(outcome.out, QByteArray());
        QVERIFY2(isOneLine(outcome.err), outcome.err.constData());
        QVERIFY(QString::fromUtf8(outcome.err).startsWith(QDir::toNativeSeparators(path)));
    }
}

void TestCommandLine::warnsOfSkippedRowsAndIgnoredColumns()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rows.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("time,R4_x,colour\n0,80,1\n0.25,oops,2\n0.5,40,3\n");
    file.close();
    const Outcome text = run({QStringLiteral("compare"), path});
    QCOMPARE(text.status, 0);
    QVERIFY2(text.err.contains("line 3") && text.err.contains("oops"), text.err.constData());
    QVERIFY2(text.err.contains("colour"), text.err.constData());

    const Outcome json = run({QStringLiteral("compare"), path, QStringLiteral("--format"), QStringLiteral("json")});
    const QJsonObject entry = QJsonDocument::fromJson(json.out).object()["files"].toArray().first().toObject();
    QCOMPARE(entry["ignoredColumns"].toArray(), QJsonArray({"colour"}));
    QCOMPARE(entry["skipped"].toArray().size(), qsizetype(1));
    const QJsonObject skipped = entry["skipped"].toArray().first().toObject();
    QCOMPARE(skipped.keys(), QStringList({"column", "line", "reason", "text"}));
    QCOMPARE(skipped["line"].toInt(), 3);
    QCOMPARE(skipped["column"].toInt(), 2);
    QCOMPARE(skipped["text"].toString(), QStringLiteral("oops"));
    QCOMPARE(entry["channels"].toArray().first().toObject()["count"].toInt(), 2);
}

void TestCommandLine::saysWhichColumnsWereGuessed()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("grapher.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("Time (s),\"P[3.1] (deg)\",\"P[4.2] (mm)\"\n");
    for (int row = 0; row <= 80; ++row) {
        const double t = row / 80.0;
        const Textbook at = textbook(20, 60, 25, 2 * std::numbers::pi, 2 * std::numbers::pi * t, false);
        file.write(QByteArray::number(t) + ',' + QByteArray::number(at.theta3 / kDegree) + ',' +
                   QByteArray::number(at.R4x) + '\n');
    }
    file.close();
    for (const QStringList &arguments :
         {QStringList{"compare", path, "--b", "60"}, QStringList{"identify", path},
          QStringList{"render", "--reference", path, "--what", "report", "--output", folder.filePath("x.pdf")}}) {
        const Outcome outcome = run(arguments);
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.err.contains("P[3.1]") && outcome.err.contains("as theta3 (guessed by its unit)"),
                 outcome.err.constData());
        QVERIFY2(outcome.err.contains("as R4_x (guessed by its unit)"), outcome.err.constData());
        QVERIFY2(!outcome.err.contains("as the time"), outcome.err.constData());
    }
    QVERIFY(!run(QStringLiteral("compare ") + sample()).err.contains("guessed"));
}

void TestCommandLine::tellsWhereTheModelOfAFileCannotBeAssembled()
{
    const Outcome outcome = run({QStringLiteral("compare"), sample(), QStringLiteral("--b"), QStringLiteral("40"),
                                 QStringLiteral("--fail-on-difference")});
    QCOMPARE(outcome.status, 4);
    QVERIFY2(outcome.err.contains("cannot be assembled") && outcome.err.contains("at least 45 mm"),
             outcome.err.constData());
    QVERIFY(outcome.out.contains("theta3_diff2"));
}

void TestCommandLine::studiesSpeedAgainstError()
{
    const Outcome json = run(QStringLiteral("study --format json"));
    QCOMPARE(json.status, 0);
    QCOMPARE(json.err, QByteArray());
    const QJsonObject study = QJsonDocument::fromJson(json.out).object();
    QVERIFY(study.contains(QStringLiteral("machine")));
    QCOMPARE(study["cases"].toArray().size(), 1);
    const QJsonObject nominal = study["cases"][0].toObject();
    QCOMPARE(nominal["name"].toString(), QStringLiteral("Table 1 of the report"));
    QStringList methods;
    for (const QJsonValue &method : nominal["methods"].toArray()) {
        methods += method["method"].toString();
        QCOMPARE(method["status"].toString(), QStringLiteral("solved"));
        QVERIFY(method["nsPerState"].toDouble() > 0.0);
        if (methods.last() == QStringLiteral("closed-form")) {
            QVERIFY(method["maxError"].toDouble() < 1e-15);
        }
    }
    for (const char *name : {"newton-dense", "newton-dense-taylor", "newton-structured", "newton-structured-taylor",
                             "closed-form", "closed-form-batch", "finite-difference", "harmonic-2"}) {
        QVERIFY2(methods.contains(QLatin1String(name)), name);
    }

    const Outcome text = run(QStringLiteral("study"));
    QCOMPARE(text.status, 0);
    QVERIFY(text.out.startsWith("Table 1 of the report: a = 20 mm, b = 65 mm"));
    QVERIFY(text.out.contains("Silently wrong instants: 0."));
}

void TestCommandLine::studiesTheMechanismAskedFor()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("study.csv"));
    const Outcome outcome = run({"study", "--b", "40", "--branch", "crossed", "--format", "csv", "--output", path});
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.out, QByteArray());
    const Table table = tableOf(contentOf(path));
    QVERIFY(table.cells.size() > 10);
    QCOMPARE(table.cells[0][0], QByteArray("\"this mechanism\""));
    QVERIFY(table.at(0, "not-assemblable") > 0.0); // a rocker; said, and no failure of the study
    QCOMPARE(table.at(0, "silentFailures"), 0.0);
}

void TestCommandLine::takesAnyFileName()
{
    QTemporaryDir folder;
    const QString name = QStringLiteral("Lösung θ₃ 曲柄 %1 \"50 %2\", a.csv");
    const QString path = folder.filePath(name);
    QCOMPARE(run({QStringLiteral("solve"), QStringLiteral("--output"), path}).status, 0);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList(name));
    const Outcome json = run({QStringLiteral("compare"), path, QStringLiteral("--format"), QStringLiteral("json")});
    QCOMPARE(json.status, 0);
    const QJsonObject entry = QJsonDocument::fromJson(json.out).object()["files"].toArray().first().toObject();
    QCOMPARE(entry["file"].toString(), path);
    const Outcome text = run({QStringLiteral("compare"), path});
    QVERIFY(QString::fromUtf8(text.out).startsWith(QDir::toNativeSeparators(path)));
}

void TestCommandLine::speaksTheSameNumbersInEveryLocale()
{
    QProcessEnvironment german = withoutDisplay();
    german.insert(QStringLiteral("LC_ALL"), QStringLiteral("de_DE.UTF-8"));
    german.insert(QStringLiteral("LANG"), QStringLiteral("de_DE.UTF-8"));
    for (const QStringList &arguments :
         {QStringList{"solve", "--b", "60.5"}, QStringList{"compare", sample()}, QStringList{"identify", sample()},
          QStringList{"compare", sample(), "--format", "json"}}) {
        const Outcome outcome = run(arguments, german);
        QCOMPARE(outcome.status, 0);
        QCOMPARE(outcome.out, run(arguments).out);
    }
}

void TestCommandLine::takesAFileThatIsNoSceneForAReference()
{
    const Outcome outcome = run({sample()}); // for the window, which it misses here: nothing is wrong with the file
    QCOMPARE(outcome.status, 2);
    QVERIFY2(isOneLine(outcome.err) && outcome.err.contains("There is no display"), outcome.err.constData());
    QCOMPARE(run({sample(), QStringLiteral("--reference"), sample()}).status, 3);
}

void TestCommandLine::saysThatThereIsNoSuchFile_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("file");
    for (const char *line : {"nofile.csv", "scene.txt", "./nofile", "nofile.json"}) {
        QTest::newRow(line) << line << line;
    }
    QTest::newRow("behind the window system's options") << "-platform offscreen --style windows -session 42_1 "
                                                           "-qwindowgeometry 800x600+0+0 -reverse --style=a nofile.csv"
                                                        << "nofile.csv";
}

void TestCommandLine::saysThatThereIsNoSuchFile()
{
    QFETCH(QString, line);
    QFETCH(QString, file);
    const Outcome outcome = run(line);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(isOneLine(outcome.err) && outcome.err.contains(file.toUtf8()), outcome.err.constData());
}

void TestCommandLine::leavesToTheWindowSystemWhatIsIts()
{
    const QTemporaryDir settings;
    QProcessEnvironment environment = withoutDisplay();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), settings.path());
    QProcess window;
    window.setProcessEnvironment(environment);
    window.start(QStringLiteral(SLIDERCRANK_PROGRAM), {QStringLiteral("--platform"), QStringLiteral("offscreen"),
                                                       QStringLiteral("-session"), QStringLiteral("42_1")});
    AWAIT(QFile::exists(settings.filePath(QStringLiteral("slidercrank/slidercrank.conf")))); // it greets
    QCOMPARE(window.state(), QProcess::Running);
    window.kill();
    QVERIFY(window.waitForFinished(slidercrank::kPatience));
}

void TestCommandLine::takesASceneForWhatIsNotSaid()
{
    QTemporaryDir folder;
    const QString scene = writeFile(folder.filePath(QStringLiteral("a scene.json")), sceneText());
    const QString said =
        QStringLiteral("solve --b 60 --theta20 0.5 --branch crossed --start 0.25 --duration 2 --steps 10 "
                       "--method closed-form");
    const Outcome taken = run({"solve", "--scene", scene});
    QCOMPARE(taken.err, QByteArray());
    QCOMPARE(taken.status, 0);
    QCOMPARE(taken.out, run(said).out);
    QCOMPARE(tableOf(taken.out).cells.size(), std::size_t(11));

    const QString otherwise = QStringLiteral("--b 70 --branch open --steps 4 --method newton --tolerance 0 --start 1");
    const Outcome over = run(QStringList{"solve", "--scene", scene} + QProcess::splitCommand(otherwise));
    QCOMPARE(over.status, 0);
    QCOMPARE(over.out, run(QStringLiteral("solve --theta20 0.5 --duration 2 --max-iterations 7 ") + otherwise).out);
    QCOMPARE(run({"solve", "--scene", scene, "--at-angle", "60", "--channels", "theta3"}).out,
             run(QStringLiteral("solve --b 60 --theta20 0.5 --branch crossed --start 0.25 --method closed-form "
                                "--at-angle 60 --channels theta3"))
                 .out);

    const Outcome overwriting = run({"solve", "--scene", scene, "--output", scene});
    QCOMPARE(overwriting.status, 2);
    QVERIFY2(overwriting.err.contains("would overwrite"), overwriting.err.constData());
    QCOMPARE(contentOf(scene), sceneText());
}

void TestCommandLine::goesOnFromAScene()
{
    QTemporaryDir folder;
    const QByteArray open = sceneText().replace("crossed", "open").replace("\"theta20\": 0.5", "\"theta20\": 0");
    const QString scene = writeFile(folder.filePath(QStringLiteral("scene.json")), open);
    const QStringList comparing{"compare", sample(), "--fail-on-difference", "--scene", scene};
    QCOMPARE(run(comparing).status, 0); // the sample is of b = 60 mm
    QCOMPARE(run(comparing + QStringList{"--b", "65"}).status, 1);

    // Angles alone tell the lengths' ratios; the scene says how long the crank is.
    const QByteArray longer =
        QByteArray(open).replace("\"a\": 20", "\"a\": 40").replace("60", "120").replace("25,", "50,");
    const QString twice = writeFile(folder.filePath(QStringLiteral("twice.json")), longer);
    const QString angles = folder.filePath(QStringLiteral("angles.csv"));
    run({"solve", "--b", "62", "--channels", "theta3,theta3_diff", "--output", angles});
    const auto crankOf = [&](const QString &path) {
        const Outcome found = run({"identify", angles, "--format", "json", "--scene", path});
        return QJsonDocument::fromJson(found.out).object()["mechanism"].toObject()["a"].toDouble();
    };
    QCOMPARE(crankOf(scene), 20.0);
    QCOMPARE(crankOf(twice), 40.0);

    const QString rocker =
        writeFile(folder.filePath(QStringLiteral("rocker.json")), QByteArray(open).replace("60", "40"));
    const Table study = tableOf(run({"study", "--scene", rocker, "--format", "csv"}).out);
    QVERIFY(study.cells.size() > 5);
    QVERIFY(study.at(0, "not-assemblable") > 0.0);
}

void TestCommandLine::rendersASceneAsItWasSaved()
{
    QTemporaryDir folder;
    const QByteArray reference = R"({"file": "measured.csv", "columns": [], "conventions": []})";
    const QString scene = writeFile(folder.filePath(QStringLiteral("scene.json")), sceneText(reference));
    QVERIFY(QFile::copy(sample(), folder.filePath(QStringLiteral("measured.csv"))));
    const auto picture = [&](const QStringList &options) {
        const QString path = folder.filePath(QStringLiteral("picture.png"));
        QFile::remove(path);
        const Outcome outcome = run(QStringList{"render", "--output", path} + options);
        if (outcome.status != 0) {
            qWarning() << outcome.err;
        }
        return QImage(path);
    };
    const QStringList said = QProcess::splitCommand(QStringLiteral(
        "--b 60 --theta20 0.5 --branch crossed --start 0.25 --duration 2 --steps 10 --method closed-form"));
    const QImage pose = picture({"--what", "mechanism", "--scene", scene});
    QVERIFY(!pose.isNull());
    QCOMPARE(pose, picture(said + QStringList{"--what", "mechanism", "--at", "0.75", "--reference", sample()}));
    QVERIFY(pose != picture({"--what", "mechanism", "--scene", scene, "--at", "0.8"}));

    // Beside it what was on show, as large as it was.
    const auto drawn = [&](const QByteArray &choices) {
        const QByteArray view = QByteArray("\"view\": {\"mechanism\": {") + choices + "}, ";
        const QString chosen =
            writeFile(folder.filePath(QStringLiteral("chosen.json")), sceneText().replace("\"view\": {", view));
        const QString path = folder.filePath(QStringLiteral("picture.svg"));
        const Outcome outcome = run({"render", "--what", "mechanism", "--scene", chosen, "--output", path});
        return outcome.status == 0 ? contentOf(path) : outcome.err;
    };
    const QByteArray plain = drawn("\"frame\": null");
    QVERIFY2(plain.contains("<svg"), plain.constData());
    const std::pair<QByteArray, QByteArray> choices[] = {{"\"velocity\": true", ">velocity: "},
                                                         {"\"acceleration\": true", ">acceleration: "},
                                                         {"\"path\": true", {}},
                                                         {"\"names\": true", ">O₂<"},
                                                         {"\"dimensions\": true", ">a = 20 mm"},
                                                         {"\"frame\": [-10, -5, 20, 15]", {}}};
    for (const auto &[choice, text] : choices) {
        const QByteArray with = drawn(choice);
        QVERIFY2(with.contains("<svg") && with != plain, with.constData());
        QVERIFY2(text.isEmpty() || (with.contains(text) && !plain.contains(text)), choice.constData());
    }

    // The same curves, but as far as they were in view, and the errors in the measure chosen.
    const QImage figure = picture({"--scene", scene});
    QVERIFY(!figure.isNull());
    QVERIFY(figure != picture(said + QStringList{"--at", "0.75", "--reference", sample()}));
    const QByteArray unzoomed =
        sceneText(reference).replace("\"error\": \"absolute\", ", "").replace("[0.5, 1.5]", "null");
    writeFile(scene, unzoomed);
    QCOMPARE(picture({"--scene", scene}), picture(said + QStringList{"--at", "0.75", "--reference",
                                                                     folder.filePath(QStringLiteral("measured.csv"))}));

    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("measured.csv"))));
    const Outcome without = run({"render", "--scene", scene, "--output", folder.filePath(QStringLiteral("x.png"))});
    QCOMPARE(without.status, 3);
    QVERIFY2(isOneLine(without.err) && without.err.contains("measured.csv"), without.err.constData());
}

void TestCommandLine::saysWhatIsWrongWithAScene_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("not there") << QByteArray() << QByteArray("cannot be opened");
    QTest::newRow("not JSON") << QByteArray("time,theta3\n0,1\n") << QByteArray("line 1: this is not JSON");
    QTest::newRow("another JSON") << QByteArray("{\"a\": 1}") << QByteArray("no \"version\"");
    QTest::newRow("no length") << sceneText().replace("\"b\": 60", "\"b\": -60")
                               << QByteArray("\"mechanism.b\" must be");
    QTest::newRow("half of it") << sceneText().first(300) << QByteArray("this is not JSON");
}

void TestCommandLine::saysWhatIsWrongWithAScene()
{
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, says);
    QTemporaryDir folder;
    const QString scene = folder.filePath(QStringLiteral("scene.json"));
    if (!content.isEmpty()) {
        writeFile(scene, content);
    }
    for (const QStringList &line :
         {QStringList{scene}, QStringList{"solve", "--scene", scene},
          QStringList{"compare", sample(), "--scene", scene}, QStringList{"identify", sample(), "--scene", scene},
          QStringList{"study", "--scene", scene},
          QStringList{"render", "--output", folder.filePath(QStringLiteral("x.png")), "--scene", scene}}) {
        const Outcome outcome = run(line);
        QVERIFY2(isOneLine(outcome.err) && outcome.err.contains(says) && outcome.err.contains("scene.json"),
                 outcome.err.constData());
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(outcome.status, 3);
    }
}

void TestCommandLine::forgetsTheSettings()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("slidercrank")));
    const QString path = writeFile(folder.filePath(QStringLiteral("slidercrank/slidercrank.conf")),
                                   "[General]\ntheme=2\n[layout]\nfolded=true\n");
    QProcessEnvironment environment = withoutDisplay();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.path());
    const Outcome outcome = run({"--reset-settings"}, environment);
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.err, QByteArray());
    QVERIFY(isOneLine(outcome.out));
    QVERIFY2(!contentOf(path).contains("theme") && !contentOf(path).contains("folded"), contentOf(path).constData());
    QCOMPARE(run({"--reset-settings"}, environment).status, 0); // nothing to forget
#else
    QSKIP("Settings are no file that this test could see.");
#endif
}

void TestCommandLine::helpsEverywhere()
{
    const QRegularExpression option(QStringLiteral("--[a-z][a-z0-9-]*"));
    const QString manual = QString::fromUtf8(contentOf(QStringLiteral(SLIDERCRANK_MANUAL))).remove(QLatin1Char('\\'));
    for (const QString &command :
         {QString(), QStringLiteral("solve"), QStringLiteral("limits"), QStringLiteral("compare"),
          QStringLiteral("identify"), QStringLiteral("study"), QStringLiteral("render")}) {
        const QStringList words = command.isEmpty() ? QStringList() : QStringList(command);
        const Outcome help = run(words + QStringList(QStringLiteral("--help")));
        QCOMPARE(help.status, 0);
        QCOMPARE(help.err, QByteArray());
        QVERIFY(help.out.contains("Usage: slidercrank"));
        QVERIFY(help.out.contains("Exit status"));
        for (auto each = option.globalMatch(QString::fromUtf8(help.out)); each.hasNext();) {
            const QString name = each.next().captured();
            QVERIFY2(manual.contains(QRegularExpression(name + QStringLiteral("(?![a-z0-9-])"))), qPrintable(name));
        }
        const Outcome version = run(words + QStringList(QStringLiteral("--version")));
        QCOMPARE(version.status, 0);
        QVERIFY(QRegularExpression(
                    QStringLiteral("^slidercrank \\d+\\.\\d+\\.\\d+\nQt 6\\.\\d+\\.\\d+, Eigen 3\\.\\d+\\.\\d+, "
                                   "Highway 1\\.\\d+\\.\\d+, Boost 1\\.\\d+\\.\\d+, \\w+ \\d+[.\\d]*\n$"))
                    .match(QString::fromUtf8(version.out))
                    .hasMatch());
    }
    // Whatever else is wrong with the line: who asks for help gets it.
    QCOMPARE(run(QStringLiteral("solve --foo --b x --help")).status, 0);
    const QByteArray solveHelp = run(QStringLiteral("solve --help")).out;
    for (const char *name : {"--a ", "--b ", "--c ", "--omega2", "--theta20", "--branch", "--steps", "--duration",
                             "--start", "--at-angle", "--method", "--max-iterations", "--tolerance", "--tolerance-kind",
                             "--channels", "--angle-unit", "--output", "--format", "\"mechanism\""}) {
        QVERIFY2(solveHelp.contains(name), name);
    }
}

void TestCommandLine::needsNoPlatformButToRender()
{
    QProcessEnvironment noPlatform = withoutDisplay();
    noPlatform.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("nonsense"));
    QCOMPARE(run({"solve"}, noPlatform).status, 0);
    QCOMPARE(run({"compare", sample()}, noPlatform).status, 0);
    QCOMPARE(run({"identify", sample()}, noPlatform).status, 0);
    QCOMPARE(run({"--help"}, noPlatform).status, 0);
    QCOMPARE(run({"render", "--output", "x.gif"}, noPlatform).status, 2);
    QProcessEnvironment full = withoutDisplay(); // no room for what Qt would keep there
    full.remove(QStringLiteral("XDG_RUNTIME_DIR"));
    full.insert(QStringLiteral("TMPDIR"), QStringLiteral("/proc"));
    const QTemporaryDir folder;
    QCOMPARE(run({"render", "--output", folder.filePath(QStringLiteral("x.svg"))}, full).err, QByteArray());
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    const Outcome window = run(QStringList());
    QCOMPARE(window.status, 2);
    QVERIFY(window.err.contains("display"));
#endif
}

void TestCommandLine::rendersPicturesOfTheSizeAskedFor_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QSize>("size");
    QTest::newRow("figure") << "" << QSize(1400, 1800);
    QTest::newRow("figure with reference, dark") << "--theme dark --b 60 --reference SAMPLE" << QSize(1400, 1800);
    QTest::newRow("mechanism") << "--what mechanism --at-angle 60" << QSize(900, 700);
    QTest::newRow("one plot") << "--what theta3_diff" << QSize(900, 600);
    QTest::newRow("error plot") << "--what error_velocity --reference SAMPLE --b 60" << QSize(900, 600);
    QTest::newRow("another size") << "--what R4_x --size 640x480 --method newton --steps 20000" << QSize(640, 480);
}

void TestCommandLine::rendersPicturesOfTheSizeAskedFor()
{
    QFETCH(QString, options);
    QFETCH(QSize, size);
    QTemporaryDir folder;
    QStringList arguments = QProcess::splitCommand(QStringLiteral("render ") + options);
    arguments.replaceInStrings(QStringLiteral("SAMPLE"), sample());
    const auto render = [&](const QString &name, const QStringList &more = {}) {
        const QString path = folder.filePath(name);
        const Outcome outcome = run(arguments + QStringList{QStringLiteral("--output"), path} + more);
        if (outcome.status != 0 || !outcome.err.isEmpty() || !outcome.out.isEmpty()) {
            qWarning() << outcome.status << outcome.err << outcome.out;
            return QString();
        }
        return path;
    };
    const QImage picture(render(QStringLiteral("x.png")));
    QCOMPARE(picture.size(), size);
    bool oneColour = true;
    for (int y = 0; y < picture.height(); y += 3) {
        for (int x = 0; x < picture.width(); x += 3) {
            oneColour = oneColour && picture.pixel(x, y) == picture.pixel(0, 0);
        }
    }
    QVERIFY(!oneColour);
    QCOMPARE(QImage(render(QStringLiteral("x2.PNG"), {QStringLiteral("--scale"), QStringLiteral("1.5")})).size(),
             size * 1.5);

    const QByteArray svg = contentOf(render(QStringLiteral("x.svg")));
    const QByteArray viewBox =
        "viewBox=\"0 0 " + QByteArray::number(size.width()) + ' ' + QByteArray::number(size.height()) + '"';
    QVERIFY2(svg.contains(viewBox), svg.left(400).constData());
    QVERIFY(svg.contains("<text") && svg.contains("</svg>"));

    const QByteArray pdf = contentOf(render(QStringLiteral("x.pdf")));
    QVERIFY(pdf.startsWith("%PDF"));
    const QRegularExpressionMatch box =
        QRegularExpression(QStringLiteral("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]")).match(QString::fromLatin1(pdf));
    QVERIFY(box.hasMatch());
    // Points of 1/72 inch against pixels of 1/96 inch.
    QVERIFY(std::abs(box.captured(1).toDouble() - size.width() * 0.75) < 1.0);
    QVERIFY(std::abs(box.captured(2).toDouble() - size.height() * 0.75) < 1.0);
}

void TestCommandLine::rendersTheInstantAskedFor()
{
    QTemporaryDir folder;
    const auto picture = [&](const QString &options) {
        const QString path = folder.filePath(QStringLiteral("pose.png"));
        QFile::remove(path);
        run(QProcess::splitCommand(QStringLiteral("render --what mechanism ") + options)
            << QStringLiteral("--output") << path);
        return contentOf(path);
    };
    const QByteArray start = picture(QString());
    QVERIFY(!start.isEmpty());
    QCOMPARE(picture(QStringLiteral("--at 0")), start);
    const QByteArray quarter = picture(QStringLiteral("--at 0.25"));
    QVERIFY(!quarter.isEmpty() && quarter != start);
    QCOMPARE(picture(QStringLiteral("--at-angle 90")), quarter);
    QCOMPARE(picture(QStringLiteral("--at -0.75")), quarter);
    // Far beyond the run: the mechanism alone has a pose at any instant.
    const QByteArray slowQuarter = picture(QStringLiteral("--omega2 0.001 --at-angle 90"));
    QVERIFY(!slowQuarter.isEmpty());
    QCOMPARE(slowQuarter, picture(QStringLiteral("--omega2 0.001 --theta20 1.5707963267948966")));

    const Outcome impossible = run({"render", "--what", "mechanism", "--b", "40", "--at", "0.75", "--output",
                                    folder.filePath(QStringLiteral("impossible.png"))});
    QCOMPARE(impossible.status, 4);
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("impossible.png"))));
}

void TestCommandLine::rendersWhatWasChosen_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("other");
    QTest::newRow("instant in a plot") << "--what theta3 --at 0.3"
                                       << "--what theta3";
    QTest::newRow("angle in the figure") << "--at-angle 60"
                                         << "--at-angle 61";
    QTest::newRow("theme") << "--what mechanism --theme dark"
                           << "--what mechanism";
    QTest::newRow("reference") << "--what R4_x --reference SAMPLE"
                               << "--what R4_x";
    QTest::newRow("channel") << "--what R4_x"
                             << "--what R4_x_diff";
    QTest::newRow("mechanism") << "--what R4_x --b 60"
                               << "--what R4_x";
    QTest::newRow("branch") << "--what mechanism --branch crossed"
                            << "--what mechanism";
    QTest::newRow("run") << "--what R4_x --duration 2"
                         << "--what R4_x";
    QTest::newRow("a run that takes a while") << "--what R4_x --steps 20000 --duration 2"
                                              << "--what R4_x --steps 20000";
}

void TestCommandLine::rendersWhatWasChosen()
{
    QFETCH(QString, options);
    QFETCH(QString, other);
    QTemporaryDir folder;
    const auto picture = [&](const QString &choice, const QString &name) {
        const QString path = folder.filePath(name);
        QStringList arguments = QProcess::splitCommand(QStringLiteral("render ") + choice);
        arguments.replaceInStrings(QStringLiteral("SAMPLE"), sample());
        const Outcome outcome = run(arguments << QStringLiteral("--output") << path);
        return outcome.status == 0 ? QImage(path) : QImage();
    };
    const QImage chosen = picture(options, QStringLiteral("chosen.png"));
    const QImage otherwise = picture(other, QStringLiteral("other.png"));
    QVERIFY(!chosen.isNull() && !otherwise.isNull());
    QCOMPARE(picture(options, QStringLiteral("again.png")), chosen);
    QVERIFY(chosen != otherwise);
}

void TestCommandLine::rendersFrames()
{
    QTemporaryDir folder;
    const QStringList line{"render",      "--what",  "frames", "--duration", "0.2",
                           "--b",         "60",      "--size", "240x200",    "--scale",
                           "1.5",         "--theme", "dark",   "--output",   folder.filePath(QStringLiteral("motion")),
                           "--reference", sample()};
    const Outcome outcome = run(line + QStringList{"--speed", "0.5"});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.status, 0);
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("motion"));
    const QDir frames(folder.filePath(QStringLiteral("motion")));
    QCOMPARE(frames.entryList(QDir::Files).size(), 12); // 0.2 s of the motion take 0.4 s
    const auto still = [&](const QString &instant) {
        const QString path = folder.filePath(QStringLiteral("still.png"));
        run({"render", "--what", "mechanism", "--b", "60", "--at", instant, "--size", "240x200", "--scale", "1.5",
             "--theme", "dark", "--output", path});
        return QImage(path).convertToFormat(QImage::Format_RGB32);
    };
    const auto frame = [&](int number) {
        return QImage(frames.filePath(QStringLiteral("frame_%1.png").arg(number + 1, 4, 10, QLatin1Char('0'))))
            .convertToFormat(QImage::Format_RGB32);
    };
    QCOMPARE(frame(0).size(), QSize(360, 300));
    QCOMPARE(frame(0), still(QStringLiteral("0")));
    QCOMPARE(frame(6), still(QStringLiteral("0.1")));
    QVERIFY(frame(6) != frame(11));

    // The linkage of another file beside it, frame by frame.
    const Outcome again = run(line); // the folder is not empty any more
    QCOMPARE(again.status, 3);
    QVERIFY2(isOneLine(again.err) && again.err.contains("new or empty folder"), again.err.constData());
    QVERIFY(QDir(frames).removeRecursively());
    run(line + QStringList{"--a", "22"});
    const QImage both = frame(6);
    QVERIFY(QDir(frames).removeRecursively());
    run(line.first(line.size() - 2) + QStringList{"--a", "22"});
    QVERIFY(both != frame(6));

    const Outcome impossible = run({"render", "--what", "frames", "--b", "40", "--start", "0.6", "--duration", "0.2",
                                    "--size", "120x100", "--output", folder.filePath(QStringLiteral("rocker"))});
    QCOMPARE(impossible.status, 4);
    QVERIFY2(isOneLine(impossible.err) && impossible.err.contains("of 6 instants"), impossible.err.constData());
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("rocker/frame_0006.png"))));

    const Outcome nowhere =
        run({"render", "--what", "frames", "--output", folder.filePath(QStringLiteral("missing/motion"))});
    QCOMPARE(nowhere.status, 3);
    QVERIFY2(isOneLine(nowhere.err) && nowhere.err.contains("cannot be written"), nowhere.err.constData());
}

void TestCommandLine::filmsFrames()
{
    QTemporaryDir folder;
    const QStringList line{"render",     "--what",   "frames",
                           "--duration", "0.5",      "--size",
                           "121x101",    "--output", folder.filePath(QStringLiteral("motion.mp4"))};
    QProcessEnvironment poor = withoutDisplay();
    poor.insert(QStringLiteral("PATH"), folder.path());
    const Outcome without = run(line, poor);
    QCOMPARE(without.status, 3);
    QVERIFY2(isOneLine(without.err) && without.err.contains("ffmpeg"), without.err.constData());
    QVERIFY(QDir(folder.path()).isEmpty());

    const QString judge = QStandardPaths::findExecutable(QStringLiteral("ffprobe"));
    if (judge.isEmpty()) {
        QSKIP("There is no ffmpeg here to make a video.");
    }
    QCOMPARE(run(line).status, 0);
    QProcess process;
    process.start(judge, {"-v", "error", "-count_frames", "-show_entries", "stream=width,height,nb_read_frames", "-of",
                          "csv=p=0", line.last()});
    QVERIFY(process.waitForFinished(slidercrank::kPatience));
    QCOMPARE(process.readAllStandardOutput().trimmed(), QByteArray("122,102,15")); // even sides
}

void TestCommandLine::leavesNothingBehindWhenInterrupted_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("signal");
    QTest::newRow("frames") << "motion" << SIGTERM;
    QTest::newRow("video") << "motion.mp4" << SIGTERM;
#ifdef SIGHUP
    QTest::newRow("the terminal is closed") << "motion" << SIGHUP;
#endif
}

void TestCommandLine::leavesNothingBehindWhenInterrupted()
{
#ifdef Q_OS_WIN
    QSKIP("Windows has no signal by which one program asks another to end.");
#endif
    QFETCH(const QString, name);
    if (name.endsWith(QLatin1String("mp4")) && QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty()) {
        QSKIP("There is no ffmpeg here to make a video.");
    }
    const QTemporaryDir folder;
    QProcess process;
    process.setProcessEnvironment(withoutDisplay());
    process.start(QStringLiteral(SLIDERCRANK_PROGRAM),
                  {"render", "--what", "frames", "--duration", "1000", "--output", folder.filePath(name)});
    AWAIT(!QDir(folder.path()).isEmpty()); // it is at work
#ifdef Q_OS_UNIX
    QFETCH(const int, signal);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
#endif
    QVERIFY(process.waitForFinished(slidercrank::kPatience));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit); // by the signal
    QCOMPARE(process.readAllStandardError(), QByteArray());
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TestCommandLine::refusesToRenderABadReference()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("figure.png"));
    const Outcome outcome =
        run({"render", "--reference", folder.filePath(QStringLiteral("missing.csv")), "--output", path});
    QCOMPARE(outcome.status, 3);
    QVERIFY2(isOneLine(outcome.err), outcome.err.constData());
    QVERIFY(!QFile::exists(path));
}

void TestCommandLine::writesAReport()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    const Outcome outcome = run({"render", "--what", "report", "--reference", sample(), "--output", path});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.status, 0);
    const QByteArray pdf = contentOf(path);
    QVERIFY(pdf.startsWith("%PDF") && pdf.trimmed().endsWith("%%EOF"));
    QVERIFY(pdf.contains("/MediaBox [0 0 595") || pdf.contains("/MediaBox [0.000000000 0.000000000 595"));
    QCOMPARE(run({"render", "--what", "report", "--output", path}).status, 0); // without a reference, too
    QCOMPARE(run({"render", "--what", "report", "--b", "40", "--output", path}).status, 4);
    QVERIFY(contentOf(path).startsWith("%PDF"));

    const Outcome nowhere =
        run({"render", "--what", "report", "--output", folder.filePath(QStringLiteral("missing/report.pdf"))});
    QCOMPARE(nowhere.status, 3);
    QVERIFY2(isOneLine(nowhere.err) && nowhere.err.contains("cannot be written"), nowhere.err.constData());
}

void TestCommandLine::reportsTheSameNumbersAsItCompares()
{
    const QString reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
    if (reader.isEmpty()) {
        QSKIP("There is no pdftotext here.");
    }
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    const auto textOf = [&](const QStringList &options) {
        run(QStringList{"render", "--what", "report", "--reference", sample(), "--output", path} + options);
        QProcess process;
        process.start(reader, {QStringLiteral("-layout"), path, QStringLiteral("-")});
        process.waitForFinished(slidercrank::kPatience);
        return QString::fromUtf8(process.readAllStandardOutput()).replace(QChar::Nbsp, u' ');
    };
    const QString different = textOf({QStringLiteral("--method"), QStringLiteral("newton")});
    QVERIFY2(different.contains(QStringLiteral("inventor_sample.csv")), qPrintable(different));
    QVERIFY2(different.contains(QStringLiteral("looks like b = 60 instead of 65 mm, which explains 99.9999 % of it.")),
             qPrintable(different));
    QVERIFY(different.contains(QStringLiteral("until ‖C‖ ≤ 10⁻⁸")));
    const QString same = textOf({QStringLiteral("--b"), QStringLiteral("60")});
    QCOMPARE(same.count(QStringLiteral("agrees within the file's rounding")), qsizetype(6));

    // A row a channel, as many as `compare` has, with its numbers to three digits.
    const QJsonArray channels = QJsonDocument::fromJson(run({"compare", sample(), "--format", "json"}).out)
                                    .object()["files"]
                                    .toArray()[0]
                                    .toObject()["channels"]
                                    .toArray();
    const QStringList symbols{"Rₓ⁴ [mm]", "v⁴ [mm/s]", "a⁴ [mm/s²]",
                              "θ³ [°]",   "ω³ [°/s]",   "α³ [°/s²]"};
    QCOMPARE(channels.size(), symbols.size());
    const QStringList lines = different.split(u'\n');
    for (qsizetype i = 0; i < symbols.size(); ++i) {
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const QString &candidate) {
            return candidate.startsWith(symbols[i]) && candidate.endsWith(QStringLiteral("differs"));
        });
        QVERIFY2(line != lines.end(), qPrintable(symbols[i] + different));
        const QStringList cells = line->mid(symbols[i].size()).simplified().split(u' ');
        const QJsonObject channel = channels[i].toObject();
        QVERIFY2(std::abs(cells[0].toDouble() / channel["maxAbs"].toDouble() - 1.0) < 5e-3, qPrintable(*line));
        QVERIFY2(std::abs(cells[1].toDouble() - channel["timeOfMaxAbs"].toDouble()) < 1e-9, qPrintable(*line));
        QVERIFY2(std::abs(cells[2].toDouble() / channel["rms"].toDouble() - 1.0) < 5e-3, qPrintable(*line));
        QVERIFY2(std::abs(cells[3].toDouble() / channel["maxPercent"].toDouble() - 1.0) < 5e-3, qPrintable(*line));
        QVERIFY2(std::abs(cells[5].toDouble() / channel["percentOfPeak"].toDouble() - 1.0) < 5e-3, qPrintable(*line));
    }
}

QTEST_GUILESS_MAIN(TestCommandLine)

#include "tst_command_line.moc"
