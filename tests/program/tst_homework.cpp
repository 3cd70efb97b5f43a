// SPDX-License-Identifier: GPL-3.0-or-later

// The exercises of a textbook through the command line: the tables of positions, velocities and accelerations of offset
// slider-cranks (R. L. Norton, "Design of Machinery", Tables P4-2, P6-2 and P7-2), the
// positions in which a quantity has a value, and the effect of tolerances.

#include "core/limits/tolerance.h"
#include "tests/program/run_program.h"
#include "tests/support/accelerating_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"
#include "ui/text/written_number.h"

#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_homework
{

/// A row of the tables: inches, degrees, rad/s and rad/s².
struct TextbookRow {
    const char *name;
    double a;
    double b;
    double c;
    double theta2;
    double omega2;
    double alpha2;
};

constexpr TextbookRow kTextbookRows[] = {
    {"a", 1.4, 4.0, 1.0, 45.0, 10.0, 0.0},      {"b", 2.0, 6.0, -3.0, 60.0, -12.0, 5.0},
    {"c", 3.0, 8.0, 2.0, -30.0, -15.0, -10.0},  {"d", 3.5, 10.0, 1.0, 120.0, 24.0, -4.0},
    {"e", 5.0, 20.0, -5.0, 225.0, -50.0, 10.0}, {"f", 3.0, 13.0, 0.0, 100.0, -45.0, 50.0},
    {"g", 7.0, 25.0, 10.0, 330.0, 100.0, 18.0},
};

/// The options of a mechanism, with every digit.
QString optionsOf(const Parameters &p)
{
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    return QStringLiteral(" --a %1 --b %2 --c %3 --omega2 %4 --theta20 %5rad --branch %6")
        .arg(number(p.a), number(p.b), number(p.c), number(p.omega2), number(p.theta20),
             p.branch == Branch::Open ? "open" : "crossed");
}

class TestHomework : public QObject
{
    Q_OBJECT

private slots:
    void solvesTheTextbooksTables_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<bool>("isOpen");
        for (int i = 0; i < static_cast<int>(std::size(kTextbookRows)); ++i) {
            QTest::addRow("%s open", kTextbookRows[i].name) << i << true;
            QTest::addRow("%s crossed", kTextbookRows[i].name) << i << false;
        }
    }

    /// One command gives every value, first in inches and radians, then in mm and degrees.
    void solvesTheTextbooksTables()
    {
        QFETCH(int, row);
        QFETCH(bool, isOpen);
        const TextbookRow &exercise = kTextbookRows[row];
        constexpr double kInch = 25.4; // mm
        const Parameters p{exercise.a * kInch,
                           exercise.b * kInch,
                           exercise.c * kInch,
                           exercise.omega2,
                           exercise.theta2 / kDegreesPerRadian,
                           isOpen ? Branch::Open : Branch::Crossed};
        const ExactOutputs exact = exactMotion(p, exercise.alpha2);
        const QString line = QStringLiteral("solve --a %1in --b %2in --c %3in --omega2 %4 --at-angle %5 --alpha2 %6 "
                                            "--branch %7 --channels ")
                                 .arg(exercise.a)
                                 .arg(exercise.b)
                                 .arg(exercise.c)
                                 .arg(exercise.omega2)
                                 .arg(exercise.theta2)
                                 .arg(exercise.alpha2)
                                 .arg(isOpen ? "open" : "crossed");
        const QByteArrayList names{"theta3",     "theta3_diff", "theta3_diff2",       "R4_x",        "R4_x_diff",
                                   "R4_x_diff2", "A_x_diff",    "A_y_diff",           "A_x_diff2",   "A_y_diff2",
                                   "R3_x_diff2", "R3_y_diff2",  "transmission_angle", "displacement"};
        const RunResult inInches = run(line + names.join(',') + " --length-unit in --angle-unit rad");
        const RunResult inDefault = run(line + names.join(','));
        QCOMPARE(inInches.status, 0);
        QCOMPARE(inDefault.status, 0);
        const CsvTable inches(inInches.output);
        const CsvTable millimetres(inDefault.output);
        QVERIFY(inches.header.contains("R4_x_diff2 [in/s^2]") && inches.header.contains("theta3_diff [rad/s]"));
        for (const QByteArray &name : names) {
            const OutputChannel channel =
                *outputChannelNamed({name.constData(), static_cast<std::size_t>(name.size())});
            const bool isAngle = isAngular(measureOf(channel));
            const qsizetype column =
                std::ranges::find_if(
                    inches.header, [&name](const QByteArray &heading) { return heading.split(' ').first() == name; }) -
                inches.header.begin();
            QVERIFY2(column < inches.header.size(), name);
            const double value = static_cast<double>(exact.at(nameOf(channel)));
            const double size = (isAngle ? 1.0 : characteristicLength(p)) *
                                std::pow(std::abs(p.omega2), static_cast<int>(orderOf(channel)));
            const double fromInches = inches.rows[0][column].toDouble() * (isAngle ? 1.0 : kInch);
            const double fromMillimetres = millimetres.at(0, name) / (isAngle ? kDegreesPerRadian : 1.0);
            QVERIFY2(std::abs(fromInches - value) <= 1e-12 * size, name);
            QVERIFY2(std::abs(fromMillimetres - value) <= 1e-12 * size, name);
        }
    }

    /// `--alpha2 0` changes nothing. With an acceleration, both methods agree.
    void bothMethodsGiveTheSameAcceleration()
    {
        QCOMPARE(run("solve --at-angle 60 --alpha2 0").output, run("solve --at-angle 60").output);
        const QString line = "solve --step-angle 30 --alpha2 25 --tolerance 0 --method ";
        const CsvTable closedForm(run(line + "closed-form").output);
        const CsvTable newton(run(line + "newton").output);
        for (std::size_t row = 0; row < closedForm.rows.size(); ++row) {
            for (const char *name : {"R4_x_diff2", "theta3_diff2", "R3_x_diff2", "theta2_diff2"}) {
                QVERIFY2(std::abs(closedForm.at(row, name) - newton.at(row, name)) <= 1e-9 * 1e4, name);
            }
        }
        QVERIFY(std::abs(closedForm.at(0, "theta2_diff2") - 25.0 * kDegreesPerRadian) < 1e-9);
        // A crank at rest has the angle of --at-angle. Without a speed, α₂ alone accelerates the links.
        const CsvTable still(run("solve --omega2 0 --at-angle 60").output);
        QCOMPARE(still.at(0, "theta2"), 60.0);
        QCOMPARE(still.at(0, "R4_x"), CsvTable(run("solve --at-angle 60").output).at(0, "R4_x"));
        QCOMPARE(still.at(0, "R4_x_diff2"), 0.0);
        const CsvTable rest(run("solve --omega2 0 --at-angle 60 --alpha2 5").output);
        QCOMPARE(rest.at(0, "theta2"), 60.0);
        QCOMPARE(rest.at(0, "R4_x_diff"), 0.0);
        QVERIFY(std::abs(rest.at(0, "R4_x_diff2")) > 1.0);
    }

    /// The α₂ of a scene, here of a link, applies to single positions but not to time steps.
    void singlePositionsHaveTheAccelerationOfTheScene()
    {
        const QString link = "solve --scene slidercrank.html#a=40&b=120&c=20&omega2=60rpm&alpha2=-10 ";
        const QString same = "solve --a 40 --b 120 --c 20 --omega2 60rpm ";
        QCOMPARE(run(link + "--at-angle 60").output, run(same + "--at-angle 60 --alpha2 -10").output);
        QCOMPARE(run(link + "--at-angle 60 --alpha2 0").output, run(same + "--at-angle 60").output);
        QCOMPARE(run(link + "--steps 4").output, run(same + "--steps 4").output);
        QCOMPARE(run(link + "--when R4_x=130").output, run(same + "--when R4_x=130 --alpha2 -10").output);
        QCOMPARE(run(link + "--when R4_x_diff2=60").output, run(same + "--when R4_x_diff2=60 --alpha2 -10").output);
    }

    /// Norton's P7-2 row c: with α2, the slider has the acceleration -709.10 in/s² at θ2 = -30°.
    void findsAnAccelerationOfACrankThatAccelerates()
    {
        const QString row = "solve --a 3in --b 8in --c 2in --omega2 -15 --alpha2 -10 --length-unit in ";
        const Parameters p{3.0 * 25.4, 8.0 * 25.4, 2.0 * 25.4, -15.0, -30.0 / kDegreesPerRadian};
        const double wanted = static_cast<double>(exactMotion(p, -10.0).at("R4_x_diff2")) / 25.4;
        QVERIFY(std::abs(wanted + 709.10) < 0.005);
        const CsvTable found(
            run(row + QStringLiteral("--channels theta2,R4_x_diff2 --when a=%1").arg(wanted, 0, 'g', 17)).output);
        bool isAmong = false;
        for (std::size_t i = 0; i < found.rows.size(); ++i) {
            QVERIFY(std::abs(found.at(i, "R4_x_diff2 [in/s^2]") - wanted) < 1e-9);
            isAmong |= std::abs(std::remainder(found.at(i, "theta2") + 30.0, 360.0)) < 1e-9;
        }
        QVERIFY(isAmong);
        const RunResult none = run(row + "--when a=1e9");
        QVERIFY(none.status == 4 && none.error.contains("There is no position"));
        // sqrt((3 + 8)² - 2²) = 10.81665383… in and sqrt((8 - 3)² - 2²) = 4.58257569… in
        const RunResult beyond = run(row + "--when x=11");
        QVERIFY2(beyond.error.contains("R4_x lies between 4.582575695 in and 10.81665382 in."), beyond.error);
    }

    /// θ3 = 190° at B is 10° at A, where `solve` measures it.
    void anAngleAtBIsNamedAsSuch()
    {
        const RunResult atB = run("solve --a 40 --b 120 --c 20 --when theta3=190");
        QCOMPARE(atB.status, 4);
        QVERIFY2(atB.hasOneLineError() && atB.error.contains("write theta3=10°"), atB.error);
        const RunResult atA = run("solve --a 40 --b 120 --c 20 --when theta3=10°");
        QCOMPARE(CsvTable(atA.output).rows.size(), std::size_t(2));
        QCOMPARE(CsvTable(run("solve --a 40 --b 120 --c 20 --when theta3=-350").output).rows.size(), std::size_t(2));
        const QByteArray atNeither = run("solve --a 40 --b 120 --c 20 --when theta3=80").error; // asin((20 ± 40)/120)
        const QByteArray inGap = run("solve --a 40 --b 20 --c 5 --when x=0").error; // between the arcs of a rocker
        QVERIFY2(inGap.contains("slidercrank limits") && !inGap.contains("lies between"), inGap);
        QVERIFY2(atNeither.contains("theta3 lies between −9.594068226° and 30°."), atNeither);
    }

    void findsThePositionsOfAValue()
    {
        const CsvTable table(run("solve --when R4_x=60 --channels theta2,R4_x").output);
        QCOMPARE(table.rows.size(), std::size_t(2));
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            QVERIFY(std::abs(table.at(row, "R4_x") - 60.0) < 1e-12);
        }
        QVERIFY(table.at(0, "time") >= 0.0 && table.at(0, "time") < table.at(1, "time") && table.at(1, "time") < 1.0);
        const CsvTable later(run("solve --when R4_x=6cm --start 0.5 --channels R4_x").output);
        QVERIFY(later.at(0, "time") >= 0.5 && later.at(1, "time") < 1.5);
        const CsvTable inches(run("solve --when R4_x=2.5 --length-unit in --channels R4_x").output);
        QVERIFY(std::abs(inches.at(0, "R4_x [in]") - 2.5) < 1e-14);
        QCOMPARE(CsvTable(run("solve --when transmission_angle=60deg").output).rows.size(), std::size_t(2));
        QCOMPARE(CsvTable(run("solve --when theta3_diff=0.1rad/s").output).rows.size(), std::size_t(2));

        // The limits of a rocker, sin θ2 = ±b/a, at times that are rounded.
        const RunResult limits = run("solve --a 20 --b 10 --c 0 --when theta3=90 --channels R4_x --start 1000.3");
        QCOMPARE(limits.status, 0);
        QCOMPARE(CsvTable(limits.output).rows.size(), std::size_t(2));
        const RunResult none = run("solve --when R4_x=90");
        QCOMPARE(none.status, 4);
        QVERIFY2(none.output.isEmpty() && none.hasOneLineError() && none.error.contains("R4_x = 90 mm"), none.error);
    }

    /// A former defect: because the two ends of the arc, 210° and 330°, are rounded, the slider had 10¹⁰ mm/s at one of
    /// them, and the mechanism could not be assembled at the other one.
    void theEndsOfARockersArcAreLimitPositions()
    {
        const double x = 60.0 * std::cos(std::numbers::pi / 6.0);
        for (const char *const speed : {"1", "2", "7", "10", "60rpm", "-1", "-3"}) {
            for (const char *const position : {"--at-angle 210", "--at-angle 330", "--at-angle -30", "--when mu=0",
                                               "--at-angle 330 --method newton"}) {
                const QString line =
                    QString("solve --a 60 --b 50 --c 20 --omega2 %1 %2 --channels ").arg(speed, position);
                const RunResult all = run(line + "theta2,theta3,R4_x,R4_x_diff");
                QCOMPARE(all.status, 5);
                QVERIFY2(all.error.contains("perpendicular to the slider's line"), all.error);
                const CsvTable table(all.output);
                QCOMPARE(table.rows.size(), std::size_t(QString(position).contains("when") ? 2 : 1));
                QVERIFY(std::isnan(table.at(0, "R4_x_diff")));
                QVERIFY(std::abs(std::abs(table.at(0, "R4_x")) - x) < 1e-13);
                QCOMPARE(table.at(0, "theta3"), 90.0);
                const RunResult positionsOnly = run(line + "R4_x,transmission_angle");
                QVERIFY2(positionsOnly.status == 0 && positionsOnly.error.isEmpty(), positionsOnly.error);
                QCOMPARE(CsvTable(positionsOnly.output).at(0, "transmission_angle"), 0.0);
            }
        }
        QVERIFY(CsvTable(run("solve --a 60 --b 50 --c 20 --omega2 2 --at-angle 330.000001").output).at(0, "R4_x_diff") >
                1e4); // mm/s: almost at the limit the slider is fast
    }

    /// 100 random mechanisms by the command; tst_crank_search has more, and all channels.
    void findsEveryPositionOfRandomMechanisms()
    {
        RandomMechanisms random(465);
        for (int i = 0; i < 100; ++i) {
            Parameters p = random.next();
            p.theta20 = 0.0;
            const double outer = std::sqrt((p.a + p.b) * (p.a + p.b) - p.c * p.c);
            const double inner = std::sqrt((p.b - p.a) * (p.b - p.a) - p.c * p.c);
            const double value =
                (p.branch == Branch::Open ? 1.0 : -1.0) * std::lerp(inner, outer, random.uniform(0.01, 0.99));
            const RunResult found = run(
                QStringLiteral("solve --channels theta2,R4_x --when R4_x=%1").arg(value, 0, 'g', 17) + optionsOf(p));
            QCOMPARE(found.status, 0);
            const CsvTable table(found.output);
            QCOMPARE(table.rows.size(), std::size_t(2));
            for (std::size_t row = 0; row < 2; ++row) {
                QVERIFY(std::abs(table.at(row, "R4_x") - value) <= 1e-12 * characteristicLength(p));
            }
        }
    }

    /// The positions of a crank at rest are listed by angle, all at the time --start and with zero velocities.
    void listsThePositionsOfACrankThatStandsStill()
    {
        const QString options = " --channels theta2,R4_x,R4_x_diff,R4_x_diff2 --alpha2 5 --start 2";
        for (const char *positions : {"--when R4_x=60", "--step-angle 15"}) {
            const QString line = QStringLiteral("solve --theta20 100deg ") + positions + options;
            const CsvTable still(run(line + " --omega2 0").output);
            const CsvTable turning(run(line + " --omega2 50deg/s").output); // has turned by 100° at --start
            QCOMPARE(still.rows.size(), turning.rows.size());
            std::vector<double> angles;
            for (std::size_t row = 0; row < still.rows.size(); ++row) {
                angles.push_back(still.at(row, "theta2"));
                QVERIFY(angles.back() >= 100.0 && angles.back() <= 460.0);
                const Parameters p{.omega2 = 0.0, .theta20 = angles.back() / kDegreesPerRadian};
                const auto exact = exactMotion(p, 5.0);
                for (const char *name : {"R4_x", "R4_x_diff", "R4_x_diff2"}) {
                    QVERIFY(std::abs(still.at(row, name) - static_cast<double>(exact.at(name))) < 1e-11);
                }
                QCOMPARE(still.at(row, "time"), 2.0);
            }
            QVERIFY(std::ranges::is_sorted(angles));
        }
        QCOMPARE(CsvTable(run("solve --omega2 0 --when R4_x=60").output).rows.size(), std::size_t(2));
        const RunResult json = run("solve --omega2 0 --theta20 30deg --when R4_x=60 --channels theta2 --format json");
        QCOMPARE(json.json()["channels"].toObject()["theta2"].toArray().size(), qsizetype(2));
        QVERIFY(std::abs(json.json()["mechanism"].toObject()["theta20"].toDouble() * kDegreesPerRadian - 30.0) < 1e-12);
        // The message names the angle of the first position that does not exist: 25 - 20 sin θ2 > 40 at 240°.
        const RunResult missing = run("solve --omega2 0 --b 40 --step-angle 15 --channels theta2");
        QVERIFY2(missing.status == 4 && missing.error.contains("θ₂ = 240.00°"), missing.error);
    }

    /// θ3 at A reaches -asin(20/120) = -9.594°, which a textbook measures at B.
    void statesTheExtremesOfTheCouplerInTheNotationOfTextbooks()
    {
        const QString line = "limits --a 40 --b 120 --c 20";
        QVERIFY(run(line).output.contains("−9.59407°"));
        const QByteArray textbook = run(line + " --notation textbook").output;
        QVERIFY2(textbook.contains(" 170.406°") && !textbook.contains("−9.59"), textbook);
        QVERIFY(run(line).output.contains("−9.59407°")); // the choice is that of one command
        QCOMPARE(run(line + " --notation textbook --format json").output, run(line + " --format json").output);
    }

    /// Norton's P7-2 row b with ω2 = 10 rad/s: a_B = 35.39 in/s² with α2, and 50.47 in/s² without.
    void drawsPolygonsAndReportsWithAnAcceleration()
    {
        const QTemporaryDir folder;
        const QString row =
            "render --a 2in --b 6in --c -3in --omega2 10 --at-angle 60 --length-unit in --notation textbook ";
        const QString picture = folder.filePath("polygons.svg");
        QCOMPARE(run(row + "--what polygons --alpha2 5 -o " + picture).status, 0);
        static const QRegularExpression kTag("<[^>]*>");
        const QString text = QString::fromUtf8(contentOf(picture)).remove(kTag).simplified(); // also of hard spaces
        QVERIFY(text.contains("θ₂ = 60°, α₂ = 5 rad/s²") && text.contains("a = 2 in"));
        const double bTimesOmega3 = 6.0 * 2.7108639; // in/s, ω3 = -a ω2 cos θ2 / (b cos θ3)
        for (const double amount :
             {20.0, bTimesOmega3, 30.14845, 200.0, 10.0, 35.39473}) { // v_A, v_BA, v_B, a_Aⁿ, a_Aᵗ, a_B
            QVERIFY2(text.contains(" = " + shortNumber(amount)), qPrintable(QString::number(amount)));
        }
        const QString report = folder.filePath("report.pdf");
        if (!QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            for (const auto &[option, value] : {std::pair("", "= 50.4690 in/s²"),
                                                {"--alpha2 5 ", "= 35.3947 in/s²"},
                                                {"--step-angle 40 ", "Table, every 40°"},
                                                {"", "Table, every 15°"}}) {
                QCOMPARE(run(row + option + "--what report -o " + report).status, 0);
                QProcess process;
                process.start("pdftotext", {report, "-"});
                QVERIFY(process.waitForFinished(kPatience));
                const QString words = QString::fromUtf8(process.readAllStandardOutput()).replace(QChar::Nbsp, u' ');
                QVERIFY2(words.contains(value), qPrintable(words.left(800)));
            }
        }
        const RunResult figure = run(row + "--alpha2 5 -o " + picture);
        QVERIFY2(figure.status == 2 && figure.error.contains("remove --alpha2"), figure.error);
        QCOMPARE(run("render --b 30 --what polygons --at-angle 270 -o " + picture).status, 4);
    }

    void findsTheCrankSpeedForAVelocity()
    {
        const RunResult found = run("solve --at-angle 60 --omega2-for R4_x_diff=-8m/s");
        QCOMPARE(found.status, 0);
        const CsvTable table(found.output);
        QVERIFY(std::abs(table.at(0, "R4_x_diff") + 8000.0) < 1e-9);
        QVERIFY(std::abs(table.at(0, "theta2") - 60.0) < 1e-9);
        QVERIFY(found.error.startsWith("--omega2 ") && found.hasOneLineError());
        const double speed = found.error.split(' ').last().toDouble();
        QVERIFY(std::abs(table.at(0, "theta2_diff") / kDegreesPerRadian - speed) <= 1e-14 * std::abs(speed));
        const RunResult deadCentre = run("solve --c 0 --at-angle 0 --omega2-for R4_x_diff=8m/s");
        QVERIFY(deadCentre.status == 4 && deadCentre.hasOneLineError() && deadCentre.error.contains("dead centre"));
    }

    void knowsTheSymbolsOfTextbooks()
    {
        QCOMPARE(run("solve --when x_B=60").output, run("solve --when R4_x=60").output);
        QCOMPARE(run("solve --channels v,mu").output, run("solve --channels R4_x_diff,transmission_angle").output);
        QCOMPARE(run("solve --channels θ₃,ω₃,v_B").output, run("solve --channels theta3,theta3_diff,R4_x_diff").output);
        QCOMPARE(run("solve --omega2 2π --a 1/2in --steps 2").output, run("solve --a 12.7 --steps 2").output);
        QCOMPARE(run("solve --at-angle 60 --omega2-for v=8m/s").output,
                 run("solve --at-angle 60 --omega2-for R4_x_diff=8m/s").output);
    }

    void refusesWhatDoesNotFitTogether()
    {
        struct Row {
            const char *line;
            const char *message;
        };
        for (const Row &row :
             {Row{"solve --alpha2 5", "add --at-angle"}, Row{"solve --when R4_x", "such as R4_x=60"},
              Row{"solve --when R4_y=25", "does not depend"},
              Row{"solve --when nothing=25", "\"nothing\" is no quantity: choose x, v, a,"},
              Row{"solve --when R4_x=60s", "use a unit such as mm, cm, m, km, in, ft, yd"},
              Row{"solve --when R4_x=60 --steps 5", "remove --steps"},
              Row{"solve --when R4_x=60 --at-angle 5", "remove one"},
              Row{"solve --when R4_x_diff=60 --omega2 0", "stands still"},
              Row{"solve --omega2-for R4_x_diff=60", "add --at-angle"},
              Row{"solve --at-angle 60 --omega2-for R4_x=60", "first derivative"},
              Row{"solve --at-angle 60 --omega2-for R4_x_diff=60 --omega2 5", "remove --omega2"},
              Row{"solve --length-unit ft", "--length-unit must be mm, cm, m or in"},
              Row{"solve --start 1e12 --omega2 1e6 --step-angle 90", "too close in time"},
              Row{"solve --omega2 1e-300 --step-angle 90", "larger --omega2"},
              Row{"limits --tolerance d", "such as a=0.05"}, Row{"limits --tolerance a=-5", "between 0 and"},
              Row{"limits --vary b=50..60 --tolerance a=1", "remove --tolerance"},
              Row{"limits --design time-ratio=1.2", "--a and --b"},
              Row{"limits --design time-ratio=1.2 --a 40 --b 120 --c 5", "remove --c"}}) {
            const RunResult outcome = run(QString(row.line));
            QVERIFY2(outcome.status == 2 && outcome.error.contains(row.message) && outcome.hasOneLineError(),
                     row.line + outcome.error);
        }
    }

    void printsWhatTolerancesChange()
    {
        const Parameters p;
        const RunResult json = run("limits --tolerance a=0.05,b=0.1,c=0.05 --format json");
        int seen = 0;
        for (const QJsonValue &limit : json.json()["limits"].toArray()) {
            const QString name = limit["name"].toString();
            const double plus = limit["plus"].toDouble();
            const double minus = limit["minus"].toDouble();
            const auto strokeOf = [](double a, double b, double c) {
                return std::sqrt((a + b) * (a + b) - c * c) - std::sqrt((b - a) * (b - a) - c * c);
            };
            if (name == u"stroke") { // grows with a and |c|, decreases with b
                ++seen;
                const double stroke = strokeOf(p.a, p.b, p.c);
                QVERIFY(std::abs(plus - (strokeOf(20.05, 64.9, 25.05) - stroke)) < 1e-10);
                QVERIFY(std::abs(minus - (stroke - strokeOf(19.95, 65.1, 24.95))) < 1e-10);
            } else if (name == u"minimum-transmission-angle") {
                ++seen;
                const double angle = std::acos(45.0 / 65.0) * kDegreesPerRadian;
                QVERIFY(std::abs(plus - (std::acos(44.9 / 65.1) * kDegreesPerRadian - angle)) < 1e-10);
                QVERIFY(std::abs(minus - (angle - std::acos(45.1 / 64.9) * kDegreesPerRadian)) < 1e-10);
            }
        }
        QCOMPARE(seen, 2);
        QVERIFY(run("limits --tolerance b=0.1").output.contains("plus"));
        const CsvTable toggle(run("limits --b 45.05 --tolerance b=0.1 --format csv").output);
        for (const QByteArrayList &row : toggle.rows) {
            QVERIFY(row[0] != "time-ratio" || (row[5].isEmpty() && row[6].isEmpty() && !row[1].isEmpty()));
        }
    }

    void designsTheOffset()
    {
        const RunResult found = run("limits --design time-ratio=1.2 --a 40 --b 120 --format json");
        QCOMPARE(found.status, 0);
        const QJsonObject mechanism = found.json()["mechanism"].toObject();
        QCOMPARE(mechanism["a"].toDouble(), 40.0);
        QCOMPARE(mechanism["b"].toDouble(), 120.0);
        const double c = mechanism["c"].toDouble();
        QVERIFY(c > 0.0);
        const double alpha = std::asin(c / 80.0) - std::asin(c / 160.0);
        QVERIFY(std::abs((M_PI + alpha) / (M_PI - alpha) - 1.2) < 1e-13);
        const RunResult tooLarge = run("limits --design time-ratio=2.9 --a 40 --b 120");
        QVERIFY(tooLarge.status == 4 && tooLarge.error.contains("time ratio is below 2"));
        QCOMPARE(run("limits --design time-ratio=1.2 --a 40 --b 30").status, 4);
    }

    void printsLimitsInOtherUnits()
    {
        const QJsonArray limits =
            run("limits --length-unit in --angle-unit rad --format json").json()["limits"].toArray();
        for (const QJsonValue &limit : limits) {
            if (limit["name"].toString() == u"coupler-swing") {
                QCOMPARE(limit["unit"].toString(), QStringLiteral("rad"));
                QVERIFY(std::abs(limit["value"].toDouble() - (std::asin(45.0 / 65.0) - std::asin(5.0 / 65.0))) < 1e-14);
            } else if (limit["name"].toString() == u"peak-slider-speed") {
                QCOMPARE(limit["unit"].toString(), QStringLiteral("in/s"));
            }
        }
        QVERIFY(run("limits --length-unit in").output.contains(" in/s"));
        const CsvTable varied(run("limits --vary b=3in..5in --count 3 --length-unit in").output);
        QVERIFY(std::abs(varied.at(1, "b") - 4.0) < 1e-14); // in the unit of the limits beside it
        QVERIFY(run("limits --a 1e-3 --b 1e12 --c 0 --format csv").output.contains("\nstroke,0.002,mm"));
    }
};

const Suite<TestHomework> suite("tst_homework");

} // namespace tst_homework

#include "tst_homework.moc"
