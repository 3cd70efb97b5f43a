// SPDX-License-Identifier: GPL-3.0-or-later

// The commands about the model: solve, limits, study and render.

#include "core/mechanism/channel.h"
#include "tests/program/run_program.h"
#include "tests/support/printed_motion.h"
#include "tests/support/suite.h"

#include <QDir>
#include <QImage>
#include <QLocale>
#include <QMap>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_motion_commands
{

constexpr const char *kPlotted[] = {"theta3", "R4_x", "theta3_diff", "R4_x_diff", "theta3_diff2", "R4_x_diff2"};

class TestMotionCommands : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QLocale::setDefault(QLocale::c());
    }

    void solvesByTheTextbook()
    {
        struct Row {
            const char *options;
            Parameters parameters;
        };
        const Row rows[] = {
            {"", {}},
            {"--b 60 --branch crossed", {.b = 60.0, .branch = Branch::Crossed}},
            {"--a 3 --b 10 --c -4 --omega2 -300rad/s --theta20 30deg",
             {.a = 3.0, .b = 10.0, .c = -4.0, .omega2 = -300.0, .theta20 = std::numbers::pi / 6.0}},
            {"--a 2cm --b 8cm --c 0 --omega2 60rpm --theta20 -0.5rad", {.b = 80.0, .c = 0.0, .theta20 = -0.5}},
        };
        for (const auto &[options, parameters] : rows) {
            for (const char *method : {"", " --method newton --tolerance 0", " --method closed-form"}) {
                const RunResult outcome = run(QStringLiteral("solve ") + options + method);
                QCOMPARE(outcome.status, 0);
                QCOMPARE(outcome.error, QByteArray());
                const CsvTable table(outcome.output);
                QCOMPARE(table.rows.size(), std::size_t(201));
                for (std::size_t i = 0; i < table.rows.size(); ++i) {
                    const PrintedRow expected = textbookMotion(parameters, table.at(i, "time"));
                    for (std::size_t k = 0; k < expected.size(); ++k) {
                        const double error = table.at(i, kPlotted[k]) - static_cast<double>(expected[k]);
                        const double size =
                            toFileUnit(kPlottedChannels[k], naturalSize(parameters, kPlottedChannels[k]));
                        QVERIFY2(std::abs(error) < 1e-11 * size, qPrintable(QStringLiteral("%1%2, %3, row %4: %5")
                                                                                .arg(options, method, kPlotted[k])
                                                                                .arg(i)
                                                                                .arg(error)));
                    }
                }
            }
        }
    }

    /// A former defect: where the velocities jump, the closed form gave one of two values without a word.
    void saysWhereTheVelocitiesJump()
    {
        const QString mechanism("solve --a 40 --b 60 --c 20 --channels v,a ");
        const RunResult atAngle = run(mechanism + "--at-angle 270");
        QCOMPARE(atAngle.status, 0);
        QVERIFY2(atAngle.error.contains("The velocities jump at t = 0.75 s (θ₂ = 270.00°) (rows: 1)"),
                 atAngle.error.constData());
        const RunResult sampled = run(mechanism + "--duration 2");
        QVERIFY2(sampled.error.contains("(rows: 2)"), sampled.error.constData());
        const RunResult beside = run(mechanism + "--at-angle 269.9");
        QCOMPARE(beside.error, QByteArray());
        const RunResult newton = run(mechanism + "--at-angle 270 --method newton");
        QCOMPARE(newton.status, 5);
        QVERIFY(!newton.error.contains("jump"));
    }

    void writesTheRequestedRows()
    {
        const CsvTable sampled(run("solve --steps 4 --duration 2 --start -1").output);
        QCOMPARE(sampled.rows.size(), std::size_t(5));
        QCOMPARE(sampled.at(0, "time"), -1.0);
        QCOMPARE(sampled.at(4, "time"), 1.0);

        for (const int turnSign : {1, -1}) {
            const QString crank = QStringLiteral(" --omega2 %1deg/s --theta20 30deg").arg(180 * turnSign);
            const CsvTable revolution(run("solve --step-angle 15 --start 0.5" + crank).output);
            QCOMPARE(revolution.rows.size(), std::size_t(25));
            for (std::size_t i = 0; i < revolution.rows.size(); ++i) {
                const double theta2 = 30.0 + turnSign * (90.0 + 15.0 * static_cast<double>(i));
                QVERIFY(std::abs(revolution.at(i, "theta2") - theta2) < 1e-10);
            }
        }

        const CsvTable atTime(run("solve --at 0.25").output);
        QCOMPARE(atTime.rows.size(), std::size_t(1));
        QCOMPARE(atTime.at(0, "time"), 0.25);

        struct Row {
            const char *options;
            double time;
        };
        for (const Row &row :
             {Row{"--at-angle 90", 0.25}, Row{"--at-angle 90 --start 0.5", 1.25},
              Row{"--at-angle 0 --theta20 90deg", 0.75}, Row{"--at-angle -90 --omega2 -60rpm", 0.25}}) {
            const CsvTable table(run(QStringLiteral("solve ") + row.options).output);
            QVERIFY2(std::abs(table.at(0, "time") - row.time) < 1e-15, row.options);
        }
    }

    void writesChannelsUnitsAndDigits()
    {
        const CsvTable all(run("solve --steps 1").output);
        QCOMPARE(all.header.size(), qsizetype(37));
        QCOMPARE(all.header.mid(0, 4), (QByteArrayList{"time", "R1_x", "R1_y", "theta1"}));
        QCOMPARE(all.header[13], QByteArray("R1_x_diff"));
        QCOMPARE(all.header.last(), QByteArray("theta4_diff2"));

        const CsvTable some(run("solve --steps 3 --channels R4_x_diff,theta3 --angle-unit rad").output);
        QCOMPARE(some.header, (QByteArrayList{"time", "theta3 [rad]", "R4_x_diff"}));
        QCOMPARE(some.rows[1][0], QByteArray("0.33333333333333331"));
        const long double degrees = textbookMotion({}, 1.0L / 3.0L)[0];
        QVERIFY(std::abs(some.at(1, "theta3 [rad]") - static_cast<double>(degrees) / kDegreesPerRadian) < 1e-15);

        const QString line = "solve --steps 3 --channels theta3,theta3_diff,theta3_diff2 --angle-unit ";
        const CsvTable mixed(run(line + "deg-rad/s").output);
        const CsvTable inRadians(run(line + "rad").output);
        QCOMPARE(mixed.header, (QByteArrayList{"time", "theta3", "theta3_diff [rad/s]", "theta3_diff2 [rad/s^2]"}));
        QVERIFY(std::abs(mixed.at(1, "theta3") - static_cast<double>(degrees)) < 1e-13);
        QCOMPARE(mixed.rows[1].mid(2), inRadians.rows[1].mid(2));
    }

    void writesJson()
    {
        const QJsonObject json =
            run("solve --b 40 --steps 8 --channels theta3,R4_x --format json --angle-unit rad").json();
        QCOMPARE(json["mechanism"].toObject()["b"].toDouble(), 40.0);
        QCOMPARE(json["mechanism"].toObject()["branch"].toString(), QStringLiteral("open"));
        QCOMPARE(json["method"].toString(), QStringLiteral("closed-form"));
        QCOMPARE(json["units"].toObject()["angle"].toString(), QStringLiteral("rad"));
        QCOMPARE(run("solve --format json --angle-unit deg-rad/s").json()["units"].toObject()["angle"].toString(),
                 QStringLiteral("deg-rad/s"));
        QCOMPARE(json["time"].toArray().size(), 9);
        QCOMPARE(json["channels"].toObject().keys(), (QStringList{"R4_x", "theta3"}));
        QVERIFY(json["channels"].toObject()["theta3"].toArray()[6].isNull()); // 270°: cannot be assembled
        QCOMPARE(run("solve --method newton --format json").json()["method"].toString(), QStringLiteral("newton"));
    }

    void reportsTimeStepsWithoutSolution()
    {
        struct Row {
            const char *line;
            int status;
            const char *message;
        };
        const Row rows[] = {
            {"solve --b 40", 4, "The mechanism cannot be assembled at"},
            {"solve --b 40", 4, "45 mm"},
            {"solve --b 25 --at-angle 0", 5, "Velocity and acceleration do not exist at t = 0 s (θ₂ = 0.00°):"},
            {"solve --b 25 --steps 4", 4, "cannot be assembled"}, // at some time steps, and singular at others
            {"solve --method newton --max-iterations 1 --tolerance 1e-14", 5, "--max-iterations"},
            {"solve --method newton --a 2e9 --b 6.5e9 --c 2.5e9", 5, "--tolerance-kind relative"},
            {"solve --method newton --max-iterations 1 --tolerance-kind relative", 5, "or --tolerance.\n"},
            {"solve --method newton --a 2e9 --b 6.5e9 --c 2.5e9 --tolerance-kind relative", 0, ""},
            {"solve --method newton --omega2 1e6 --at 1e9", 5, "--method closed-form"}, // kLargestDrive
            {"solve --method newton --omega2 1e6 --duration 1e9", 5, "199 of 201 time steps, first at t = 10⁷ s"},
            {"solve --omega2 1e6 --at 1e9", 0, ""},
            {"limits --c 100 --format csv", 4, "The mechanism cannot be assembled: b = 65 mm < |c| − a"},
            {"compare " SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv --b 40", 4, "first at t ="},
        };
        for (const Row &row : rows) {
            const RunResult outcome = run(QString(row.line));
            QVERIFY2(outcome.status == row.status && outcome.error.contains(row.message), row.line + outcome.error);
            QVERIFY2(!outcome.output.isEmpty(), row.line);
        }
        const CsvTable oscillating(run("solve --b 40 --steps 8").output);
        QCOMPARE(oscillating.rows[6][oscillating.header.indexOf("R4_x")], QByteArray("nan"));
        QVERIFY(std::isfinite(oscillating.at(0, "R4_x")));
        const CsvTable toggle(
            run("solve --b 25 --at-angle 0").output); // the coupler is perpendicular to the slider's line
        QVERIFY(std::abs(toggle.at(0, "theta3") - 90.0) < 1e-12 && std::isnan(toggle.at(0, "R4_x_diff")));
    }

    void printsLimits()
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
        QCOMPARE(limits.size(), qsizetype(19));
        // Computed by hand after Norton, "Design of Machinery".
        const double outer = std::asin(c / (b + a)) * kDegreesPerRadian;
        const double inner = 180.0 + std::asin(c / (b - a)) * kDegreesPerRadian;
        const double stroke = std::sqrt((b + a) * (b + a) - c * c) - std::sqrt((b - a) * (b - a) - c * c);
        const QMap<QString, double> values{{"outer-dead-centre", std::sqrt((b + a) * (b + a) - c * c)},
                                           {"inner-dead-centre", std::sqrt((b - a) * (b - a) - c * c)},
                                           {"stroke", stroke},
                                           {"forward-angle", 360.0 - (inner - outer)},
                                           {"return-angle", inner - outer},
                                           {"forward-time", 1.0 - (inner - outer) / 360.0},
                                           {"return-time", (inner - outer) / 360.0},
                                           {"time-ratio", (inner - outer) / (360.0 - (inner - outer))},
                                           {"minimum-transmission-angle", std::acos((a + c) / b) * kDegreesPerRadian},
                                           {"mean-forward-speed", stroke / (1.0 - (inner - outer) / 360.0)},
                                           {"mean-return-speed", stroke / ((inner - outer) / 360.0)}};
        for (auto value = values.begin(); value != values.end(); ++value) {
            QVERIFY2(std::abs(limits[value.key()].first()["value"].toDouble() - *value) <= 1e-9 * std::abs(*value),
                     qPrintable(value.key()));
        }
        QVERIFY(std::abs(limits["outer-dead-centre"].first()["theta2"].toDouble() - outer) < 1e-9);
        QVERIFY(std::abs(limits["inner-dead-centre"].first()["time"].toDouble() - inner / 360.0) < 1e-12);

        checkPeaks(limits);

        // A symmetric mechanism reaches its largest speed twice, with both signs.
        const QByteArray symmetric = run("limits --c 0 --format csv").output;
        QCOMPARE(symmetric.count("\npeak-slider-speed,"), qsizetype(2));
        QCOMPARE(symmetric.count("\npeak-slider-speed,-"), qsizetype(1));

        QVERIFY(run("limits --b 40 --format csv").output.contains("\nforward-time,,s,,\n"));
        const RunResult impossible = run("limits --c 100 --format json");
        QVERIFY(impossible.output.contains("\"mobility\":\"impossible\"") && !impossible.output.contains("nan"));
        QVERIFY(run("limits --c 100").output.isEmpty());
        QVERIFY(run("limits").output.contains("43.8238 mm"));
    }

    void variesOneParameter()
    {
        const CsvTable table(run("limits --vary b=40..100 --count 7").output);
        QCOMPARE(table.header.mid(0, 4), (QByteArrayList{"b", "outer-dead-centre", "inner-dead-centre", "stroke"}));
        QCOMPARE(table.header.size(), qsizetype(20));
        QCOMPARE(table.rows.size(), std::size_t(7));
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const double b = 40.0 + 10.0 * static_cast<double>(row);
            QCOMPARE(table.at(row, "b"), b);
            const QByteArray single = run(QStringLiteral("limits --format csv --b %1").arg(b)).output;
            QVERIFY(single.contains("\nstroke," + table.rows[row][3] + ','));
        }
        const qsizetype ratio = table.header.indexOf("time-ratio");
        QVERIFY(table.rows[0][ratio].isEmpty() && !table.rows[1][ratio].isEmpty()); // full turns need b >= a + |c| = 45
        const QJsonArray rows = run("limits --vary omega2=0..10 --count 2 --format json").json()["rows"].toArray();
        QVERIFY(rows[0].toObject()["return-time"].isNull() && rows[1].toObject()["return-time"].isDouble());
    }

    void designsAMechanism()
    {
        const RunResult outcome = run("limits --design stroke=80,time-ratio=1.2,transmission-angle=40 --format json");
        QCOMPARE(outcome.status, 0);
        const QJsonObject mechanism = outcome.json()["mechanism"].toObject();
        QVERIFY(mechanism["c"].toDouble() > 0.0);
        for (const QJsonValue &limit : outcome.json()["limits"].toArray()) {
            const double value = limit["value"].toDouble();
            const QString name = limit["name"].toString();
            QVERIFY(name != u"stroke" || std::abs(value - 80.0) < 1e-10);
            QVERIFY(name != u"time-ratio" || std::abs(value - 1.2) < 1e-12);
            QVERIFY(name != u"minimum-transmission-angle" || value >= 40.0);
        }
        const RunResult impossible = run("limits --design stroke=80,time-ratio=1.2,transmission-angle=80");
        QVERIFY(impossible.status == 4 && impossible.error.contains("at most 47.2"));
        const RunResult tooFast = run("limits --design stroke=80,time-ratio=3");
        QVERIFY(tooFast.status == 4 && tooFast.error.contains("below 3"));
        const QJsonObject reversed =
            run("limits --design stroke=80,time-ratio=0.5 --format json").json()["mechanism"].toObject();
        QVERIFY(reversed["c"].toDouble() < 0.0);
    }

    /// The mechanism can be assembled in a tenth of its revolution only, which makes the study short.
    void studiesSpeedAgainstError()
    {
        const RunResult csv = run("study --b 6 --format csv");
        QCOMPARE(csv.status, 0);
        const CsvTable table(csv.output);
        QVERIFY(table.rows.size() > 5);
        for (const char *name : {"case", "method", "nsPerState", "maxError", "silentFailures", "not-assemblable"}) {
            QVERIFY2(table.header.contains(name), name);
        }
        const QJsonObject json = run("study --b 6 --format json").json();
        const QJsonArray methods = json["cases"].toArray().first().toObject()["methods"].toArray();
        QCOMPARE(static_cast<std::size_t>(methods.size()), table.rows.size());
        for (const QJsonValue &method : methods) {
            QVERIFY(method["method"].toString() != u"closed-form" || method["maxError"].toDouble() < 1e-14);
        }
    }

    void rendersPictures()
    {
        struct Row {
            const char *options;
            QSize size; // px; a height of 0 is not checked
        };
        for (const Row &row : {Row{"", {1890, 0}}, Row{"--what mechanism --theme dark", {1890, 0}},
                               Row{"--what theta3 --size 500x300 --scale 2", {1000, 600}},
                               Row{"--what error_position --width 900px", {900, 0}}}) {
            const QString file = path("picture.png");
            const RunResult outcome =
                run(QStringLiteral("render --b 60 --reference %1 -o %2 ").arg(kSample, file) + row.options);
            QVERIFY2(outcome.status == 0, outcome.error);
            const QImage picture(file);
            QVERIFY2(picture.width() == row.size.width(), row.options);
            QVERIFY2(row.size.height() == 0 || picture.height() == row.size.height(), row.options);
            QFile::remove(file);
        }
        run({"render", "--what", "mechanism", "-o", path("at.svg"), "--at-angle", "90"});
        run({"render", "--what", "mechanism", "-o", path("same.svg"), "--at", "0.25"});
        run({"render", "--what", "mechanism", "-o", path("other.svg"), "--at", "0.3"});
        QCOMPARE(contentOf(path("at.svg")), contentOf(path("same.svg")));
        QVERIFY(contentOf(path("at.svg")) != contentOf(path("other.svg")));
        run({"render", "--b", "70", "-o", path("figure.svg")});
        for (const char *name : {"at.svg", "figure.svg"}) {
            QVERIFY(contentOf(path(name)).contains("a = 20 mm"));
        }
    }

    void rendersFrames()
    {
        const QString folder = path("frames.2");
        const QString line = QStringLiteral("render --what frames --size 200x150 --duration 1 --speed 6 -o ") + folder;
        const RunResult outcome = run(line);
        QVERIFY2(outcome.status == 0, outcome.error);
        const QStringList frames = QDir(folder).entryList(QDir::Files, QDir::Name);
        QCOMPARE(frames.first(), QStringLiteral("frame_0001.png"));
        QVERIFY(contentOf(QDir(folder).filePath(frames.first())) != contentOf(QDir(folder).filePath(frames.last())));
        QVERIFY2(run(line).status != 0, "a folder that is not empty is refused");
        if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) {
            const RunResult video = run(line + ".gif");
            QVERIFY(video.status != 0 && video.error.contains("ffmpeg") && video.hasOneLineError());
        }
    }

    void writesAReport()
    {
        const RunResult outcome = run({"render", "--what", "report", "--reference", kSample, "-o", path("report.pdf")});
        QVERIFY2(outcome.status == 0, outcome.error);
        QVERIFY(contentOf(path("report.pdf")).startsWith("%PDF"));
    }

private:
    QString path(const char *name) const { return m_folder.filePath(name); }

    /// Checks that the peaks and their signs agree with those of a finely sampled motion.
    static void checkPeaks(const QMap<QString, QList<QJsonObject>> &limits)
    {
        const CsvTable fine(run("solve --steps 20000 --channels theta3_diff,R4_x_diff,theta3_diff2,R4_x_diff2").output);
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
    }

    QTemporaryDir m_folder;
};

const Suite<TestMotionCommands> suite("tst_motion_commands");

} // namespace tst_motion_commands

#include "tst_motion_commands.moc"
