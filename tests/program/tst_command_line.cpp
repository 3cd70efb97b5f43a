// SPDX-License-Identifier: GPL-3.0-or-later

// The contract of the command line: arguments, output, messages and exit status. Most cases call the program's library in this
// process; what depends on the operating system starts the program itself.

#include "app/command_line.h"
#include "app/help.h"
#include "app/option_table.h"
#include "tests/support/suite.h"

#include "tests/support/waiting.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <numbers>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kDegree = std::numbers::pi / 180.0;

struct Outcome {
    int status = -1;
    QByteArray output;
    QByteArray error;

    QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
    QJsonObject firstFile() const { return json()["files"].toArray().first().toObject(); }
};

Outcome run(const QStringList &arguments)
{
    QBuffer output;
    QBuffer error;
    output.open(QIODevice::WriteOnly);
    error.open(QIODevice::WriteOnly);
    const Command command = parseCommandLine(QStringList("slidercrank") + arguments);
    const ExitStatus status = command.run({output, error});
    return {static_cast<int>(status), output.data(), error.data()};
}

/// Splits at spaces; a word in quotes may contain spaces or be empty.
QStringList words(const QString &line)
{
    return line.endsWith("\"\"") ? QProcess::splitCommand(line.chopped(2)) + QStringList(QString()) : QProcess::splitCommand(line);
}

Outcome run(const QString &line)
{
    return run(words(line));
}

/// Starts the program itself, without a display.
Outcome start(const QStringList &arguments, const QByteArray &input = {}, const QStringList &variables = {})
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) {
        environment.remove(name);
    }
    for (const QString &variable : variables) {
        environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
    }
    process.setProcessEnvironment(environment);
    process.start(SLIDERCRANK_PROGRAM, arguments);
    process.write(input);
    process.closeWriteChannel();
    Outcome outcome;
    if (process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit) {
        outcome.status = process.exitCode();
    }
    outcome.output = process.readAllStandardOutput();
    outcome.error = process.readAllStandardError();
    return outcome;
}

struct Table {
    QByteArrayList header;
    std::vector<QByteArrayList> rows;

    explicit Table(const QByteArray &csv)
    {
        for (const QByteArray &line : csv.trimmed().split('\n')) {
            rows.push_back(line.split(','));
        }
        header = rows.front();
        rows.erase(rows.begin());
    }

    double at(std::size_t row, const char *name) const
    {
        const qsizetype column = header.indexOf(name);
        return column < 0 ? std::numeric_limits<double>::infinity() : rows[row][column].toDouble();
    }
};

/// The plotted channels by the formulas of the textbook (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15), in the order theta3,
/// R4_x and their first and second derivatives: mm, °, s.
std::array<double, 6> textbook(double a, double b, double c, double omega2, double theta2, bool crossed)
{
    const double angle = std::asin((c - a * std::sin(theta2)) / b);
    const double theta3 = crossed ? std::numbers::pi - angle : angle;
    const double s = b * std::cos(theta3);
    const double h = b * std::sin(theta3);
    const double first = -a * omega2 * std::cos(theta2) / s;
    const double second = (a * omega2 * omega2 * std::sin(theta2) + h * first * first) / s;
    return {theta3 / kDegree,
            a * std::cos(theta2) + s,
            first / kDegree,
            -a * omega2 * std::sin(theta2) - h * first,
            second / kDegree,
            -a * omega2 * omega2 * std::cos(theta2) - s * first * first - h * second};
}

constexpr const char *kPlotted[] = {"theta3", "R4_x", "theta3_diff", "R4_x_diff", "theta3_diff2", "R4_x_diff2"};

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // of b = 60 mm

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
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
    void initTestCase();

    void solvesByTheTextbook();
    void writesTheRowsThatAreAskedFor();
    void writesChannelsUnitsAndDigits();
    void writesJson();
    void reportsTimeStepsWithoutSolution();
    void understandsUnits();
    void refusesWrongArguments();
    void reportsMissingFiles();
    void printsLimits();
    void variesOneParameter();
    void designsAMechanism();
    void comparesFiles();
    void comparesByNewtonRaphson();
    void explainsADifference();
    void identifiesFiles();
    void identifiesTheReferenceReportsFile();
    void readsWhatItWrites();
    void joinsFiles();
    void takesColumnsAsGiven();
    void readsFilesByCrankAngle();
    void reportsDoubtfulRowsAndColumns();
    void takesSettingsFromAScene();
    void studiesSpeedAgainstError();
    void writesFilesWholeOrNotAtAll();
    void neverOverwritesItsInput();
    void rendersPictures();
    void rendersFrames();
    void writesAReport();
    void removesSettings();
    void helpsInShortLines();
    void runsWithoutDisplay();
    void readsStandardInput();
    void writesIntoPipesAndClosedStreams();
    void leavesNothingBehindWhenInterrupted();
    void writesTheSameNumbersInEveryLanguage();

private:
    QString path(const char *name) const { return m_folder.filePath(name); }

    QString write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName() : QString();
    }

    /// Columns of the sample in a file of their own, the time first.
    QString writePartOfSample(const char *name, const QList<int> &columns) const
    {
        QByteArray part;
        for (const QByteArray &line : contentOf(kSample).replace("\xEF\xBB\xBF", "").trimmed().split('\n')) {
            const QByteArrayList cells = line.trimmed().split(',');
            QByteArrayList chosen{cells.first()};
            for (const int column : columns) {
                chosen += cells.value(column);
            }
            part += chosen.join(',') + '\n';
        }
        return write(name, part);
    }

    QTemporaryDir m_folder;
};

void TestCommandLine::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QLocale::setDefault(QLocale::c());
}

void TestCommandLine::solvesByTheTextbook()
{
    struct Row {
        const char *options;
        double a, b, c, omega2, theta20;
        bool crossed;
    };
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const Row rows[] = {
        {"", 20, 65, 25, kTurn, 0, false},
        {"--b 60 --branch crossed", 20, 60, 25, kTurn, 0, true},
        {"--a 3 --b 10 --c -4 --omega2 -300rad/s --theta20 30deg", 3, 10, -4, -300, 30 * kDegree, false},
        {"--a 2cm --b 8cm --c 0 --omega2 60rpm --theta20 -0.5rad", 20, 80, 0, kTurn, -0.5, false},
    };
    for (const Row &row : rows) {
        for (const char *method : {"", " --method newton --tolerance 0", " --method closed-form"}) {
            const Outcome outcome = run(QStringLiteral("solve ") + row.options + method);
            QCOMPARE(outcome.status, 0);
            QCOMPARE(outcome.error, QByteArray());
            const Table table(outcome.output);
            QCOMPARE(table.rows.size(), std::size_t(201));
            for (std::size_t i = 0; i < table.rows.size(); ++i) {
                const double theta2 = row.omega2 * table.at(i, "time") + row.theta20;
                const auto expected = textbook(row.a, row.b, row.c, row.omega2, theta2, row.crossed);
                for (std::size_t k = 0; k < expected.size(); ++k) {
                    const double size = (k % 2 == 0 ? 1.0 / kDegree : row.a + row.b) * std::pow(std::abs(row.omega2), k / 2);
                    const double error = std::abs(table.at(i, kPlotted[k]) - expected[k]) / size;
                    QVERIFY2(error < 1e-11, qPrintable(QStringLiteral("%1%2, %3, row %4: %5")
                                                           .arg(row.options, method, kPlotted[k])
                                                           .arg(i)
                                                           .arg(error)));
                }
            }
        }
    }
}

void TestCommandLine::writesTheRowsThatAreAskedFor()
{
    const Table sampled(run("solve --steps 4 --duration 2 --start -1").output);
    QCOMPARE(sampled.rows.size(), std::size_t(5));
    QCOMPARE(sampled.at(0, "time"), -1.0);
    QCOMPARE(sampled.at(4, "time"), 1.0);

    const Table revolution(run("solve --step-angle 15 --omega2 3 --theta20 30deg").output);
    QCOMPARE(revolution.rows.size(), std::size_t(25));
    for (std::size_t i = 0; i < revolution.rows.size(); ++i) {
        QVERIFY(std::abs(revolution.at(i, "theta2") - (30.0 + 15.0 * static_cast<double>(i))) < 1e-10);
    }

    const Table atTime(run("solve --at 0.25").output);
    QCOMPARE(atTime.rows.size(), std::size_t(1));
    QCOMPARE(atTime.at(0, "time"), 0.25);

    struct Row {
        const char *options;
        double time;
    };
    for (const Row &row : {Row{"--at-angle 90", 0.25}, Row{"--at-angle 90 --start 0.5", 1.25},
                           Row{"--at-angle 0 --theta20 90deg", 0.75}, Row{"--at-angle -90 --omega2 -60rpm", 0.25}}) {
        const Table table(run(QStringLiteral("solve ") + row.options).output);
        QVERIFY2(std::abs(table.at(0, "time") - row.time) < 1e-15, row.options);
    }
}

void TestCommandLine::writesChannelsUnitsAndDigits()
{
    const Table all(run("solve --steps 1").output);
    QCOMPARE(all.header.size(), qsizetype(37));
    QCOMPARE(all.header.mid(0, 4), (QByteArrayList{"time", "R1_x", "R1_y", "theta1"}));
    QCOMPARE(all.header[13], QByteArray("R1_x_diff"));
    QCOMPARE(all.header.last(), QByteArray("theta4_diff2"));

    const Table some(run("solve --steps 3 --channels R4_x_diff,theta3 --angle-unit rad").output);
    QCOMPARE(some.header, (QByteArrayList{"time", "theta3 [rad]", "R4_x_diff"}));
    QCOMPARE(some.rows[1][0], QByteArray("0.33333333333333331"));
    QVERIFY(std::abs(some.at(1, "theta3 [rad]") - textbook(20, 65, 25, 1, 120 * kDegree, false)[0] * kDegree) < 1e-15);
}

void TestCommandLine::writesJson()
{
    const QJsonObject json = run("solve --b 40 --steps 8 --channels theta3,R4_x --format json --angle-unit rad").json();
    QCOMPARE(json["mechanism"].toObject()["b"].toDouble(), 40.0);
    QCOMPARE(json["mechanism"].toObject()["branch"].toString(), QStringLiteral("open"));
    QCOMPARE(json["method"].toString(), QStringLiteral("closed-form"));
    QCOMPARE(json["units"].toObject()["angle"].toString(), QStringLiteral("rad"));
    QCOMPARE(json["time"].toArray().size(), 9);
    QCOMPARE(json["channels"].toObject().keys(), (QStringList{"R4_x", "theta3"}));
    QVERIFY(json["channels"].toObject()["theta3"].toArray()[6].isNull()); // 270°: cannot be assembled
    QCOMPARE(run("solve --method newton --format json").json()["method"].toString(), QStringLiteral("newton"));
}

void TestCommandLine::reportsTimeStepsWithoutSolution()
{
    struct Row {
        const char *line;
        int status;
        const char *says;
    };
    const Row rows[] = {
        {"solve --b 40", 4, "The mechanism cannot be assembled at"},
        {"solve --b 40", 4, "45 mm"},
        {"solve --b 25 --at-angle 0", 5, "Velocity and acceleration do not exist at 1 of 1 time steps"},
        {"solve --b 25 --steps 4", 4, "cannot be assembled"}, // and singular at others
        {"solve --method newton --max-iterations 1 --tolerance 1e-14", 5, "--max-iterations"},
        {"solve --method newton --a 2e9 --b 6.5e9 --c 2.5e9", 5, "--tolerance-kind relative"},
        {"solve --method newton --a 2e9 --b 6.5e9 --c 2.5e9 --tolerance-kind relative", 0, ""},
        {"limits --c 100", 4, ""},
        {"compare " SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv --b 40", 4, "first at t ="},
    };
    for (const Row &row : rows) {
        const Outcome outcome = run(QString(row.line));
        QVERIFY2(outcome.status == row.status && outcome.error.contains(row.says), row.line + outcome.error);
        QVERIFY2(!outcome.output.isEmpty(), row.line);
    }
    const Table oscillating(run("solve --b 40 --steps 8").output);
    QCOMPARE(oscillating.rows[6][oscillating.header.indexOf("R4_x")], QByteArray("nan"));
    QVERIFY(std::isfinite(oscillating.at(0, "R4_x")));
    const Table toggle(run("solve --b 25 --at-angle 0").output); // the coupler is perpendicular to the slider's line
    QVERIFY(std::abs(toggle.at(0, "theta3") - 90.0) < 1e-12 && std::isnan(toggle.at(0, "R4_x_diff")));
}

void TestCommandLine::understandsUnits()
{
    const QByteArray expected = run("solve --a 25.4 --b 65 --c 25 --omega2 6.283185307179586 --theta20 0 --duration 0.5").output;
    QCOMPARE(run("solve --a 1in --b 6.5cm --c 0.025m --omega2 6.283185307179586rad/s --theta20 0deg --duration 500ms").output,
             expected);
    QCOMPARE(run("solve --theta20 180deg --steps 2").output, run("solve --theta20 3.141592653589793rad --steps 2").output);
}

void TestCommandLine::refusesWrongArguments()
{
    struct Row {
        const char *line;
        const char *says;
    };
    const Row rows[] = {
        {"solv", "did you mean solve?"},
        {"-platform offscreen solve", "must come first"},
        {"a.json b.json", "one scene"},
        {"--reset-settings --reference x.csv", "remove the other arguments"},
        {"--steps 3", "no option --steps"},
        {"-", "cannot read standard input"},
        {"help fly", "solve, limits, compare"},
        {"solve --omga2 3", "did you mean --omega2?"},
        {"solve file.csv", "remove \"file.csv\""},
        {"solve --b", "--b"},
        {"solve --b 60 --b 61", "more than once"},
        {"solve -o a -o b", "more than once"},
        {"solve --b 12abc", "--b must be a number"},
        {"solve --b 0,5", "decimal point"},
        {"solve --b 3s", "followed by mm, cm, m or in, not \"3s\""},
        {"solve --b nan", "--b must be a number"},
        {"solve --b \"\"", "--b must be a number"},
        {"solve --c 1e999", "must not exceed 1e12"},
        {"solve --b 0", "--b must be"},
        {"solve --c 2e12", "--c must not exceed 1e12"},
        {"solve --theta20 30", "--theta20 30: add a unit, 30deg or 30rad."},
        {"solve --branch up", "--branch must be open or crossed"},
        {"solve --steps 1.5", "--steps must be a whole number from 1"},
        {"solve --steps 100000001", "--steps must be a whole number"},
        {"solve --duration 0", "--duration must be greater than 0"},
        {"solve --start 1e9 --duration 1e-6", "too short"},
        {"solve --method euler", "--method must be"},
        {"solve --max-iterations 0", "--max-iterations"},
        {"solve --tolerance -1e-9", "--tolerance must be 0 or more"},
        {"solve --tolerance-kind loose", "absolute or relative"},
        {"solve --channels R4x", "did you mean R4_x?"},
        {"solve --channels qqqqqqq", "R1_x, R1_y, theta1"},
        {"solve --format xml", "--format must be csv or json"},
        {"solve --output \"\"", "--output needs the name of a file"},
        {"solve --at 0 --at-angle 30", "remove one"},
        {"solve --at-angle 30 --steps 5", "remove one"},
        {"solve --at-angle 30 --omega2 0", "stands still"},
        {"solve --at-angle 30 --omega2 1e-300", "larger --omega2"},
        {"solve --step-angle 7", "must divide 360"},
        {"solve --step-angle 10 --omega2 0", "stands still"},
        {"solve --step-angle 10 --steps 3", "remove --steps"},
        {"limits --vary b=50 --format csv", "b=50..120"},
        {"limits --vary x=1..2 --format csv", "must name a parameter"},
        {"limits --vary b=0..2 --format csv", "valid values"},
        {"limits --vary b=50..120", "--format csv or --format json"},
        {"limits --count 3", "belongs to --vary"},
        {"limits --design ratio=2", "stroke=80"},
        {"limits --design time-ratio=2", "stroke=80"},
        {"limits --design stroke=80 --b 3", "remove --b"},
        {"compare", "needs a file"},
        {"compare - - --b 60", "only once"},
        {"compare a.csv --column x", "must be a heading"},
        {"compare a.csv --abscissa theta2", "--abscissa must be time or angle"},
        {"compare a.csv --column x=R4x", "did you mean R4_x?"},
        {"compare a.csv --column \"x=R4_x [s]\"", "\"s\" is not a unit of R4_x"},
        {"compare a.csv --column x=R4_x --column x=time", "two meanings"},
        {"identify a.csv --format csv", "--format must be text or json"},
        {"identify a.csv --method newton", "no option --method"},
        {"render", "--output"},
        {"render --output x.bmp", ".png, .svg or .pdf"},
        {"render --output x.png --what R1_x", "theta3"},
        {"render --output x.png --what report", ".pdf"},
        {"render --output x.pdf --what report --size 900x600", "remove --size"},
        {"render --output x.png --size 900", "--size must be"},
        {"render --output x.png --scale 0", "--scale must be"},
        {"render --output x.png --size 9000x9000 --scale 9", "larger than"},
        {"render --output x.png --at 0.5 --at-angle 30", "remove one"},
        {"render --output x.png --at 3", "outside"},
        {"render --output x.png --column x=R4_x", "--reference"},
        {"render --what frames --output x --at 0.5", "remove --at"},
        {"render --what frames --output x --duration 1e6", "100000 frames"},
        {"render --what mechanism --output x.png --speed 2", "--speed"},
        {"study --cases soft", "nominal, hard or all"},
        {"study x.csv", "takes options only"},
    };
    for (const Row &row : rows) {
        const Outcome outcome = run(QString(row.line));
        QVERIFY2(outcome.error.contains(row.says), QByteArray(row.line) + ": " + outcome.error);
        QVERIFY2(isOneLine(outcome.error), row.line);
        QCOMPARE(outcome.output, QByteArray());
        QVERIFY2(outcome.status == 2, row.line);
    }
}

void TestCommandLine::reportsMissingFiles()
{
    const QString noScene = write("broken.slidercrank", "{");
    for (const QStringList &line : {QStringList{"compare", "no.csv"}, QStringList{"identify", "no.csv"},
                                    QStringList{"solve", "--scene", "no.slidercrank"}, QStringList{"solve", "--scene", noScene},
                                    QStringList{"./no.csv"}, QStringList{"no.slidercrank"}, QStringList{kSample, "no.csv"},
                                    QStringList{"render", "-o", path("x.png"), "--reference", "no.csv"}}) {
        const Outcome outcome = run(line);
        QVERIFY2(outcome.status == 3 && isOneLine(outcome.error), qPrintable(line.join(' ')));
    }
}

void TestCommandLine::printsLimits()
{
    const double a = 20.0;
    const double b = 65.0;
    const double c = 25.0;
    const QJsonObject json = run("limits --format json").json();
    QCOMPARE(json["mobility"].toString(), QStringLiteral("full-turn"));
    QMap<QString, QList<QJsonObject>> limits;
    for (const QJsonValue &limit : json["limits"].toArray()) {
        limits[limit["name"].toString()] += limit.toObject();
    }
    QCOMPARE(limits.size(), qsizetype(15));
    // Norton, "Design of Machinery", by hand.
    const double outer = std::asin(c / (b + a)) / kDegree;
    const double inner = 180.0 + std::asin(c / (b - a)) / kDegree;
    const double stroke = std::sqrt((b + a) * (b + a) - c * c) - std::sqrt((b - a) * (b - a) - c * c);
    const QMap<QString, double> values{{"outer-dead-centre", std::sqrt((b + a) * (b + a) - c * c)},
                                       {"inner-dead-centre", std::sqrt((b - a) * (b - a) - c * c)},
                                       {"stroke", stroke},
                                       {"forward-angle", 360.0 - (inner - outer)},
                                       {"return-angle", inner - outer},
                                       {"forward-time", 1.0 - (inner - outer) / 360.0},
                                       {"return-time", (inner - outer) / 360.0},
                                       {"time-ratio", (inner - outer) / (360.0 - (inner - outer))},
                                       {"least-transmission-angle", std::acos((a + c) / b) / kDegree},
                                       {"mean-forward-speed", stroke / (1.0 - (inner - outer) / 360.0)},
                                       {"mean-return-speed", stroke / ((inner - outer) / 360.0)}};
    for (auto value = values.begin(); value != values.end(); ++value) {
        QVERIFY2(std::abs(limits[value.key()].first()["value"].toDouble() - *value) <= 1e-9 * std::abs(*value),
                 qPrintable(value.key()));
    }
    QVERIFY(std::abs(limits["outer-dead-centre"].first()["theta2"].toDouble() - outer) < 1e-9);
    QVERIFY(std::abs(limits["inner-dead-centre"].first()["time"].toDouble() - inner / 360.0) < 1e-12);

    // The peaks have the sign of the motion there: compared with a finely sampled motion.
    const Table fine(run("solve --steps 20000").output);
    const QMap<QString, const char *> peaks{{"peak-coupler-speed", "theta3_diff"},
                                            {"peak-slider-speed", "R4_x_diff"},
                                            {"peak-coupler-acceleration", "theta3_diff2"},
                                            {"peak-slider-acceleration", "R4_x_diff2"}};
    for (auto peak = peaks.begin(); peak != peaks.end(); ++peak) {
        double largest = 0.0;
        for (std::size_t row = 0; row < fine.rows.size(); ++row) {
            const double value = fine.at(row, *peak);
            largest = std::abs(value) > std::abs(largest) ? value : largest;
        }
        QVERIFY2(std::abs(limits[peak.key()].first()["value"].toDouble() - largest) <= 1e-6 * std::abs(largest),
                 qPrintable(peak.key()));
    }
    // A symmetric mechanism reaches its largest speed twice, with both signs.
    const QByteArray symmetric = run("limits --c 0 --format csv").output;
    QCOMPARE(symmetric.count("\npeak-slider-speed,"), qsizetype(2));
    QCOMPARE(symmetric.count("\npeak-slider-speed,-"), qsizetype(1));

    QVERIFY(run("limits --b 40 --format csv").output.contains("\nforward-time,,s,,\n"));
    const Outcome impossible = run("limits --c 100 --format json");
    QVERIFY(impossible.output.contains("\"mobility\":\"impossible\"") && !impossible.output.contains("nan"));
    QVERIFY(run("limits").output.contains("43.8238 mm"));
}

void TestCommandLine::variesOneParameter()
{
    const Table table(run("limits --vary b=40..100 --count 7 --format csv").output);
    QCOMPARE(table.header.mid(0, 4), (QByteArrayList{"b", "outer-dead-centre", "inner-dead-centre", "stroke"}));
    QCOMPARE(table.header.size(), qsizetype(16));
    QCOMPARE(table.rows.size(), std::size_t(7));
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double b = 40.0 + 10.0 * static_cast<double>(row);
        QCOMPARE(table.at(row, "b"), b);
        const QByteArray single = run(QStringLiteral("limits --format csv --b %1").arg(b)).output;
        QVERIFY(single.contains("\nstroke," + table.rows[row][3] + ','));
    }
    const qsizetype ratio = table.header.indexOf("time-ratio");
    QVERIFY(table.rows[0][ratio].isEmpty() && !table.rows[1][ratio].isEmpty()); // 40 < a + |c| <= 50
    const QJsonArray rows = run("limits --vary omega2=0..10 --count 2 --format json").json()["rows"].toArray();
    QVERIFY(rows[0].toObject()["return-time"].isNull() && rows[1].toObject()["return-time"].isDouble());
}

void TestCommandLine::designsAMechanism()
{
    const Outcome outcome = run("limits --design stroke=80,time-ratio=1.2,transmission-angle=40 --format json");
    QCOMPARE(outcome.status, 0);
    const QJsonObject mechanism = outcome.json()["mechanism"].toObject();
    QVERIFY(mechanism["c"].toDouble() > 0.0);
    for (const QJsonValue &limit : outcome.json()["limits"].toArray()) {
        const double value = limit["value"].toDouble();
        const QString name = limit["name"].toString();
        QVERIFY(name != u"stroke" || std::abs(value - 80.0) < 1e-10);
        QVERIFY(name != u"time-ratio" || std::abs(value - 1.2) < 1e-12);
        QVERIFY(name != u"least-transmission-angle" || value >= 40.0);
    }
    const Outcome impossible = run("limits --design stroke=80,time-ratio=1.2,transmission-angle=80");
    QVERIFY(impossible.status == 4 && impossible.error.contains("at most 47.2"));
    const Outcome tooFast = run("limits --design stroke=80,time-ratio=3");
    QVERIFY(tooFast.status == 4 && tooFast.error.contains("below 3"));
    const QJsonObject reversed = run("limits --design stroke=80,time-ratio=0.5 --format json").json()["mechanism"].toObject();
    QVERIFY(reversed["c"].toDouble() < 0.0);
}

void TestCommandLine::comparesFiles()
{
    const Outcome same = run({"compare", kSample, "--b", "60", "--format", "json", "--fail-on-difference"});
    QCOMPARE(same.status, 0);
    const QJsonObject file = same.firstFile();
    QCOMPARE(file["file"].toString(), kSample);
    QCOMPARE(file["mechanism"].toObject()["b"].toDouble(), 60.0);
    QCOMPARE(file["verdict"].toString(), QStringLiteral("agrees"));
    QVERIFY(file["explanation"].isNull());
    QCOMPARE(file["channels"].toArray().size(), 6);
    for (const QJsonValue &channel : file["channels"].toArray()) {
        QCOMPARE(channel["verdict"].toString(), QStringLiteral("agrees"));
        QCOMPARE(channel["count"].toInt(), 201);
        QVERIFY(channel["percentOfPeak"].toDouble() < 0.001);
    }

    // Every form says the same; errors against the textbook.
    const QJsonObject other = run({"compare", kSample, "--format", "json"}).firstFile();
    const Table csv(run({"compare", kSample, "--format", "csv"}).output);
    QCOMPARE(csv.header.first(), QByteArray("file"));
    const Table sample(contentOf(kSample).replace("\r", "").replace("\xEF\xBB\xBF", ""));
    for (std::size_t k = 0; k < csv.rows.size(); ++k) {
        const QJsonObject channel = other["channels"].toArray()[static_cast<qsizetype>(k)].toObject();
        const QByteArray name = csv.rows[k][csv.header.indexOf("name")];
        QCOMPARE(channel["name"].toString().toUtf8(), name);
        QCOMPARE(channel["maxAbs"].toDouble(), csv.at(k, "maxAbs"));
        double largest = 0.0;
        for (std::size_t row = 0; row < sample.rows.size(); ++row) {
            const double theta2 = 2.0 * std::numbers::pi * sample.at(row, "time");
            const auto model = textbook(20, 65, 25, 2.0 * std::numbers::pi, theta2, false);
            const auto index = std::ranges::find_if(kPlotted, [&](const char *each) { return name == each; }) - std::begin(kPlotted);
            largest = std::max(largest, std::abs(model[static_cast<std::size_t>(index)] - sample.at(row, name)));
        }
        QVERIFY2(std::abs(channel["maxAbs"].toDouble() - largest) < 1e-8 * largest, name);
    }
    QCOMPARE(run({"compare", kSample, "--fail-on-difference"}).status, 1);

    const QString broken = write("broken.csv", "time,theta3\n0,abc\n");
    const Outcome several = run({"compare", kSample, broken, kSample});
    QCOMPARE(several.status, 3);
    QCOMPARE(several.output.count("Model:"), qsizetype(2));
    QVERIFY(several.output.contains("3 files: ") && several.output.contains("1 could not be read"));
}

void TestCommandLine::comparesByNewtonRaphson()
{
    const QJsonArray exact = run({"compare", kSample, "--b", "60", "--format", "json"}).firstFile()["channels"].toArray();
    const Outcome newton = run({"compare", kSample, "--b", "60", "--method", "newton", "--format", "json"});
    QCOMPARE(newton.status, 0);
    for (qsizetype k = 0; k < exact.size(); ++k) {
        const QJsonObject channel = newton.firstFile()["channels"].toArray()[k].toObject();
        QVERIFY(std::abs(channel["maxAbs"].toDouble() - exact[k]["maxAbs"].toDouble()) < 1e-6);
    }
    const Outcome failed = run({"compare", kSample, "--method", "newton", "--max-iterations", "1", "--tolerance", "1e-14"});
    QCOMPARE(failed.status, 5);
}

void TestCommandLine::explainsADifference()
{
    const Outcome outcome = run({"compare", kSample, "--format", "json"});
    const QJsonObject explanation = outcome.firstFile()["explanation"].toObject();
    QVERIFY(explanation["sentence"].toString().contains("b = 60"));
    QVERIFY(std::abs(explanation["mechanism"].toObject()["b"].toDouble() - 60.0) < 1e-4);

    QByteArray radians("time,theta3,R4_x\n");
    for (int i = 0; i <= 100; ++i) {
        const auto values = textbook(20, 65, 25, 1, 2.0 * std::numbers::pi * i / 100.0, false);
        radians += QByteArray::number(i / 100.0) + ',' + QByteArray::number(values[0] * kDegree, 'g', 6) + ',' +
                   QByteArray::number(values[1], 'g', 6) + '\n';
    }
    const QString file = write("radians.csv", radians);
    const QJsonObject convention =
        run({"compare", file, "--format", "json"}).firstFile()["explanation"].toObject()["conventions"].toArray().first().toObject();
    QCOMPARE(convention["name"].toString(), QStringLiteral("angle-unit"));
    QCOMPARE(convention["channel"].toString(), QStringLiteral("theta3"));
    QVERIFY(convention["after"].toDouble() < 0.01 && convention["before"].toDouble() > 90.0);
}

void TestCommandLine::identifiesFiles()
{
    const Outcome outcome = run({"identify", kSample, "--format", "json"});
    QCOMPARE(outcome.status, 0);
    const QJsonObject file = outcome.firstFile();
    QCOMPARE(file["outcome"].toString(), QStringLiteral("identified"));
    QCOMPARE(file["rounded"].toObject()["b"].toDouble(), 60.0);
    QVERIFY(std::abs(file["mechanism"].toObject()["b"].toDouble() - 60.0) <= 5.0 * file["standardError"].toObject()["b"].toDouble());
    QVERIFY(file["identifiable"].toObject()["c"].toBool());
    QVERIFY(file["leftOut"].toArray().isEmpty() && file["excludedRows"].toArray().isEmpty());
    QCOMPARE(file["channels"].toArray().size(), 6);

    // The options in the text lead to a model that agrees.
    const QByteArray text = run({"identify", kSample}).output;
    const QByteArray options = text.mid(text.indexOf("--a ")).trimmed();
    QCOMPARE(run(QStringList{"compare", kSample, "--fail-on-difference"} + words(options)).status, 0);

    const QString noise = write("noise.csv", "time,R4_x\n0,1\n1,5\n2,3\n3,9\n4,2\n");
    const Outcome none = run({"identify", noise});
    QVERIFY(none.status == 5 && none.output.isEmpty() && isOneLine(none.error));
    const Outcome several = run({"identify", kSample, noise, "--format", "json"});
    QCOMPARE(several.status, 5);
    QCOMPARE(several.json()["files"].toArray().size(), 2);
    QVERIFY(several.json()["files"].toArray()[1].toObject()["mechanism"].isNull());
}

void TestCommandLine::identifiesTheReferenceReportsFile()
{
    const QString file = qEnvironmentVariable("SLIDERCRANK_REFERENCE_FILE");
    if (file.isEmpty()) {
        QSKIP("SLIDERCRANK_REFERENCE_FILE does not name the reference report's CSV file.");
    }
    const QJsonObject found = run({"identify", file, "--format", "json"}).firstFile();
    QCOMPARE(found["outcome"].toString(), QStringLiteral("identified"));
    const QJsonObject rounded = found["rounded"].toObject();
    QCOMPARE((QList<double>{rounded["a"].toDouble(), rounded["b"].toDouble(), rounded["c"].toDouble(), rounded["theta20"].toDouble()}),
             (QList<double>{20.0, 60.0, 25.0, 0.0}));
    for (const QJsonValue &channel : found["channels"].toArray()) {
        QCOMPARE(channel["verdict"].toString(), QStringLiteral("agrees"));
    }
}

void TestCommandLine::readsWhatItWrites()
{
    for (const char *options : {"", "--b 60 --branch crossed --angle-unit rad", "--omega2 -300 --theta20 1rad --start 5"}) {
        const QString file = path("motion.csv");
        QCOMPARE(run(QStringLiteral("solve %1 -o %2").arg(options, file)).status, 0);
        const QString mechanism = QString(options).remove("--angle-unit rad").remove("--start 5");
        const QJsonObject compared = run(QStringLiteral("compare %1 %2 --format json").arg(file, mechanism)).firstFile();
        QCOMPARE(compared["channels"].toArray().size(), 36);
        QVERIFY(compared["skipped"].toArray().isEmpty() && compared["ignoredColumns"].toArray().isEmpty());
        for (const QJsonValue &channel : compared["channels"].toArray()) {
            QVERIFY2(channel["verdict"].toString() == u"agrees", qPrintable(channel["name"].toString()));
        }
    }
}

void TestCommandLine::joinsFiles()
{
    const QString angles = writePartOfSample("angles.csv", {1, 3, 5});
    const QString lengths = writePartOfSample("lengths.csv", {2, 4, 6});
    const QJsonObject whole = run({"identify", kSample, "--format", "json"}).firstFile();
    const QJsonObject joined = run({"identify", angles, lengths, "--join", "--format", "json"}).firstFile();
    QCOMPARE(joined["joined"].toArray().size(), 2);
    QCOMPARE(joined["channels"].toArray().size(), 6);
    QVERIFY(std::abs(joined["mechanism"]["b"].toDouble() - whole["mechanism"]["b"].toDouble()) < 1e-6);
    const Outcome other = run({"compare", angles, write("other.csv", "time,R4_x\n0,1\n3,2\n"), "--join"});
    QVERIFY(other.status == 3 && other.error.contains("angles.csv") && other.error.contains("other.csv"));
}

void TestCommandLine::takesColumnsAsGiven()
{
    QByteArray csv("T,u,id\n");
    for (int i = 0; i <= 20; ++i) {
        const double slider = textbook(20, 60, 25, 1, 2.0 * std::numbers::pi * i / 20.0, false)[1];
        csv += QByteArray::number(50 * i) + ',' + QByteArray::number(slider / 1000.0, 'g', 9) + ",7\n";
    }
    const QString file = write("columns.csv", csv);
    const QJsonObject compared = run({"compare", file, "--b", "60", "--format", "json", "--column", "T=time [ms]", "--column",
                                      "u=R4_x [m]", "--column", "#3=ignored"})
                                     .firstFile();
    QCOMPARE(compared["verdict"].toString(), QStringLiteral("agrees"));
    QCOMPARE(compared["channels"].toArray().first().toObject()["name"].toString(), QStringLiteral("R4_x"));
    QCOMPARE(compared["columns"].toArray()[1].toObject()["guessed"].toBool(), false);
}

void TestCommandLine::readsFilesByCrankAngle()
{
    QByteArray csv("phi,Slider position (mm)\n");
    for (int angle = 0; angle <= 360; angle += 15) {
        csv += QByteArray::number(angle) + ',' + QByteArray::number(textbook(20, 60, 25, 1, angle * kDegree, false)[1], 'f', 5) + '\n';
    }
    const QString file = write("angles.csv", csv);
    for (const char *drive : {"", "--omega2 -157 --theta20 2rad"}) { // positions by angle do not depend on the drive
        const Outcome outcome = run(QStringLiteral("compare %1 --abscissa angle --b 60 --format json %2").arg(file, drive));
        QCOMPARE(outcome.firstFile()["verdict"].toString(), QStringLiteral("agrees"));
    }
    QVERIFY(run({"compare", file, "--abscissa", "angle"}).output.contains("at θ₂ [°]"));
    QCOMPARE(run({"compare", file, "--abscissa", "angle", "--omega2", "0"}).status, 3);
}

void TestCommandLine::reportsDoubtfulRowsAndColumns()
{
    const QString file = write("doubtful.csv", "time,P[3.1] (deg),colour\n0,24,red\n0.1,abc,red\n0.2,10,red\n0.3,4,red\n");
    const Outcome outcome = run({"compare", file});
    QVERIFY(outcome.error.contains("line 3, column 2") && outcome.error.contains("colour") &&
            outcome.error.contains("guessed"));
    const QJsonObject json = run({"compare", file, "--format", "json"}).firstFile();
    QCOMPARE(json["skipped"].toArray().first().toObject()["line"].toInt(), 3);
    QCOMPARE(json["ignoredColumns"].toArray().first().toString(), QStringLiteral("colour"));
    const Outcome unreadable = run({"compare", write("empty.csv", "")});
    QVERIFY(unreadable.status == 3 && isOneLine(unreadable.error));
}

void TestCommandLine::takesSettingsFromAScene()
{
    const QString scene = write("a scene.slidercrank", R"({"version": 1,
        "mechanism": {"a": 20, "b": 60, "c": 25, "omega2": 6.283185307179586, "theta20": 0.5, "branch": "crossed"},
        "sampling": {"start": 0.25, "duration": 2, "steps": 10},
        "solver": {"method": "closed-form", "maxIterations": 7, "tolerance": 1e-6, "toleranceKind": "absolute",
                   "warmStart": "previous", "elimination": "structured"},
        "reference": null, "view": {"time": 0.75}})");
    QCOMPARE(run({"solve", "--scene", scene}).output,
             run("solve --b 60 --theta20 0.5rad --branch crossed --start 0.25 --duration 2 --steps 10 --method closed-form").output);
    QCOMPARE(run({"solve", "--scene", scene, "--b", "70", "--branch", "open", "--steps", "4"}).output,
             run("solve --b 70 --theta20 0.5rad --start 0.25 --duration 2 --steps 4 --method closed-form").output);
    QCOMPARE(run({"render", "--scene", scene, "--what", "mechanism", "-o", path("scene.svg")}).status, 0);
    QVERIFY(contentOf(path("scene.svg")).startsWith("<?xml"));
}

void TestCommandLine::studiesSpeedAgainstError()
{
    const Outcome csv = run("study --b 60 --format csv");
    QCOMPARE(csv.status, 0);
    const Table table(csv.output);
    QVERIFY(table.rows.size() > 5);
    for (const char *name : {"case", "method", "nsPerState", "maxError", "silentFailures", "not-assemblable"}) {
        QVERIFY2(table.header.contains(name), name);
    }
    const QJsonObject json = run("study --b 60 --format json").json();
    const QJsonArray methods = json["cases"].toArray().first().toObject()["methods"].toArray();
    QCOMPARE(static_cast<std::size_t>(methods.size()), table.rows.size());
    for (const QJsonValue &method : methods) {
        QVERIFY(method["method"].toString() != u"closed-form" || method["maxError"].toDouble() < 1e-14);
    }
}

void TestCommandLine::writesFilesWholeOrNotAtAll()
{
    const QString file = path("motion.csv");
    for (const char *option : {"-o", "--output"}) {
        QFile::remove(file);
        const Outcome outcome = run({"solve", option, file});
        QCOMPARE(outcome.output, QByteArray());
        QCOMPARE(contentOf(file), run("solve").output);
    }
    for (const QString &target : {path("no folder/motion.csv"), m_folder.path()}) {
        const Outcome outcome = run({"solve", "-o", target});
        QVERIFY2(outcome.status == 3 && isOneLine(outcome.error), outcome.error);
    }
}

void TestCommandLine::neverOverwritesItsInput()
{
    const QString file = path("motion.svg");
    run({"solve", "-o", file});
    const QByteArray content = contentOf(file);
    for (const QStringList &line : {QStringList{"compare", kSample, file}, QStringList{"identify", file},
                                    QStringList{"render", "--reference", file}}) {
        const Outcome outcome = run(line + QStringList{"-o", file});
        QVERIFY2(outcome.status == 2 && outcome.error.contains("would overwrite"), outcome.error);
    }
    QCOMPARE(contentOf(file), content);
}

void TestCommandLine::rendersPictures()
{
    struct Row {
        const char *options;
        QSize size;
    };
    for (const Row &row : {Row{"", {1400, 1800}}, Row{"--what mechanism --theme dark", {900, 700}},
                           Row{"--what theta3 --size 500x300 --scale 2", {1000, 600}}, Row{"--what error_position", {900, 600}}}) {
        const QString file = path("picture.png");
        const Outcome outcome = run(QStringLiteral("render --b 60 --reference %1 -o %2 ").arg(kSample, file) + row.options);
        QVERIFY2(outcome.status == 0, outcome.error);
        QVERIFY2(QImage(file).size() == row.size, row.options);
        QFile::remove(file);
    }
    run({"render", "--what", "mechanism", "-o", path("at.svg"), "--at-angle", "90"});
    run({"render", "--what", "mechanism", "-o", path("same.svg"), "--at", "0.25"});
    run({"render", "--what", "mechanism", "-o", path("other.svg"), "--at", "0.3"});
    QCOMPARE(contentOf(path("at.svg")), contentOf(path("same.svg")));
    QVERIFY(contentOf(path("at.svg")) != contentOf(path("other.svg")));
}

void TestCommandLine::rendersFrames()
{
    const QString folder = path("frames");
    const QString line = QStringLiteral("render --what frames --size 200x150 --duration 1 --speed 6 -o ") + folder;
    const Outcome outcome = run(line);
    QVERIFY2(outcome.status == 0, outcome.error);
    const QStringList frames = QDir(folder).entryList(QDir::Files, QDir::Name);
    QCOMPARE(frames.first(), QStringLiteral("frame_0001.png"));
    QVERIFY(contentOf(QDir(folder).filePath(frames.first())) != contentOf(QDir(folder).filePath(frames.last())));
    QVERIFY2(run(line).status != 0, "a folder that is not empty is refused");
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) {
        const Outcome video = run(line + ".gif");
        QVERIFY(video.status != 0 && video.error.contains("ffmpeg") && isOneLine(video.error));
    }
}

void TestCommandLine::writesAReport()
{
    const Outcome outcome = run({"render", "--what", "report", "--reference", kSample, "-o", path("report.pdf")});
    QVERIFY2(outcome.status == 0, outcome.error);
    QVERIFY(contentOf(path("report.pdf")).startsWith("%PDF"));
}

void TestCommandLine::removesSettings()
{
    QCoreApplication::setOrganizationName("slidercrank-test");
    QSettings().setValue("language", "es");
    QCOMPARE(run("--reset-settings").status, 0);
    QVERIFY(QSettings().allKeys().filter("language").isEmpty());
}

void TestCommandLine::helpsInShortLines()
{
    for (const CommandDescription &command : allCommands()) {
        const bool isWindow = &command == &allCommands().front();
        const QStringList name = isWindow ? QStringList() : QStringList(command.name);
        const QByteArray help = run(name + QStringList("-h")).output;
        QCOMPARE(run(QStringList("help") + name).output, help);
        for (const QString &line : QString::fromUtf8(help).split('\n')) {
            QVERIFY2(line.size() <= 100, qPrintable(line));
        }
        for (const OptionDescription &option : optionsOf(command)) {
            QVERIFY2(help.contains(QByteArray("--") + option.name), option.name);
            QVERIFY2(manualPage().contains(QString("\\-\\-") + QString(option.name).replace("-", "\\-")), option.name);
        }
    }
    QVERIFY(run("--version").output.startsWith("slidercrank "));
}

void TestCommandLine::runsWithoutDisplay()
{
    QCOMPARE(start({"solve", "--steps", "3"}).output, run("solve --steps 3").output);
    const Outcome window = start({});
    QVERIFY(window.status == 2 && window.error.contains("display"));
    QCOMPARE(start({"solve", "--b", "0"}).status, 2);
    QCOMPARE(start({"render", "-o", path("process.png"), "--size", "300x300"}).status, 0);
}

void TestCommandLine::readsStandardInput()
{
    const QByteArray sample = contentOf(kSample);
    const Outcome outcome = start({"compare", "-", "--b", "60", "--fail-on-difference"}, sample);
    QVERIFY2(outcome.status == 0, outcome.error);
    QCOMPARE(start({"identify", "-", "--format", "json"}, sample).firstFile()["rounded"].toObject()["b"].toDouble(), 60.0);
}

void TestCommandLine::writesIntoPipesAndClosedStreams()
{
#ifdef Q_OS_UNIX
    QProcess shell;
    const auto exitCode = [&](const char *script) {
        shell.start("/bin/sh", {"-c", QString(script).replace("PROGRAM", SLIDERCRANK_PROGRAM)});
        return shell.waitForFinished(kPatience) ? shell.exitCode() : -1;
    };
    QCOMPARE(exitCode("PROGRAM solve --steps 5 -o /dev/stdout | grep -c time"), 0);
    QCOMPARE(exitCode("PROGRAM solve >/dev/full"), 3);
    QVERIFY(exitCode("PROGRAM solve >&-") != 0);
#else
    QSKIP("Needs a shell.");
#endif
}

void TestCommandLine::leavesNothingBehindWhenInterrupted()
{
#ifdef Q_OS_UNIX
    QProcess process;
    const QString folder = path("interrupted");
    process.start(SLIDERCRANK_PROGRAM, {"render", "--what", "frames", "--duration", "1000", "-o", folder});
    QVERIFY(process.waitForStarted());
    QTest::qWait(1500);
    QVERIFY(process.state() == QProcess::Running);
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(kPatience));
    QVERIFY(process.exitStatus() == QProcess::CrashExit || process.exitCode() != 0);
    QVERIFY(!QFileInfo::exists(folder));
#else
    QSKIP("Needs signals.");
#endif
}

void TestCommandLine::writesTheSameNumbersInEveryLanguage()
{
    for (const QStringList &line : {QStringList{"solve", "--steps", "3"}, QStringList{"compare", kSample, "--format", "json"},
                                    QStringList{"identify", kSample, "--format", "json"}}) {
        QCOMPARE(start(line, {}, {"LC_ALL=es_ES.UTF-8", "LANGUAGE=es"}).output, start(line, {}, {"LC_ALL=C.UTF-8"}).output);
    }
    QVERIFY(start({"solve", "--help"}, {}, {"LC_ALL=es_ES.UTF-8", "LANGUAGE=es"}).output.contains("Mecanismo"));
}

const Suite suite("tst_command_line", runWithWidgets<TestCommandLine>);
#include "tst_command_line.moc"
