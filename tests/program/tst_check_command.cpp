// SPDX-License-Identifier: GPL-3.0-or-later

// The command `check` names the slip that gives the wrong numbers of a calculation by hand.

#include "tests/program/run_program.h"
#include "tests/support/suite.h"

#include <QLocale>
#include <QStandardPaths>
#include <QTest>

using namespace slidercrank;

namespace tst_check_command
{

// By a pocket calculator: θ3 = asin(3.5/8) = 25.9445°, x = 9.79182 mm, v = -41.4608 mm/s, ω3 = 5.41736 rad/s = 310.392
// °/s, a = -709.099 mm/s², and without α2 -681.458 mm/s².
constexpr const char *kExample = "check --a 3 --b 8 --c 2 --at-angle -30 --omega2 -15 --alpha2 -10 ";

QJsonObject checkJson(const QString &values, const char *command = kExample)
{
    return run(command + values + " --format json").json();
}

QString slipName(const QString &values, const char *command = kExample)
{
    return checkJson(values, command)["slip"].toObject()["name"].toString();
}

class TestCheckCommand : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QLocale::setDefault(QLocale::c());
    }

    void judgesEachValueAtItsLastDigit()
    {
        const RunResult right = run(QString(kExample) + "x=9.79 v=-41.46 a=-709 theta3=25.9 omega3=310.4 R4_y=2.00");
        QCOMPARE(right.status, 0);
        QCOMPARE(right.error, QByteArray());
        QVERIFY(right.output.contains("right to its 3 digits"));
        QVERIFY(right.output.endsWith("All values are right to their last digit.\n"));

        const RunResult wrong = run(QString(kExample) + "x=9.80 v=-41.46");
        QCOMPARE(wrong.status, 1);
        QVERIFY(wrong.output.contains("exact: 9.792 mm  off by 0.00818 mm"));
    }

    void understandsUnitsAndConventions()
    {
        QCOMPARE(run(QString(kExample) + "x=0.979cm v=-4.146cm/s omega3=5.42rad/s theta3=0.453rad").status, 0);
        QCOMPARE(run("check --a 3in --b 8in --c 2in --at-angle -30deg x=9.79in").status, 0);
        QCOMPARE(run("check --a 3in --b 8in --c 2in --at-angle -30deg --omega2 -15 --alpha2 -10 --length-unit in "
                     "--angle-unit rad x=9.79 v=-41.46 a=-709 theta3=0.453 omega3=5.42 mu=64.1deg")
                     .status,
                 0);
        const RunResult power = run(QString(kExample) + "a=-7.09e1cm/s²");
        QVERIFY2(power.output.contains("exact: −70.91 cm/s²  right"), power.output.constData());
        const RunResult inches = run("check --a 3in --b 8in --c 2in --at-angle -30 --length-unit in x=9.80");
        QVERIFY2(inches.output.contains("exact: 9.792 in  off by 0.00818 in"), inches.output.constData());
        const QJsonObject atB = checkJson("theta3=-154deg")["values"].toArray().first().toObject();
        QCOMPARE(atB["verdict"].toString(), QString("right"));
        QCOMPARE(atB["convention"].toString(), QString("measured-at-B"));
        QCOMPARE(atB["unit"].toString(), QString("deg"));
        QVERIFY(std::abs(atB["exact"].toDouble() + 154.0555) < 1e-4);
        QVERIFY(run(QString(kExample) + "theta3=-154").output.contains("measured at B (θ₃ = θ³ + 180°)"));
    }

    /// A former defect: the unit of "4.1cm/s" was ".1cm/s".
    void theUnitBeginsBehindTheLastDigit()
    {
        const RunResult decimals = run(QString(kExample) + "v=-4.1cm/s theta3=25.1deg omega3=5.1rad/s x=1.0cm");
        for (const char *text : {"exact: −4.146 cm/s  right", "exact: 25.94 deg  off by −0.844 deg",
                                 "exact: 5.417 rad/s  off by −0.317 rad/s", "exact: 0.9792 cm  right"}) {
            QVERIFY2(decimals.output.contains(text), decimals.output.constData());
        }
    }

    /// A former defect: the velocity just after the jump was said to be that of the other assembly.
    void namesNoSlipWhereTheVelocitiesJump()
    {
        const RunResult outcome = run("check --a 40 --b 60 --c 20 --omega2 360deg/s --at-angle 270 x=0 v=559.1");
        QCOMPARE(outcome.status, 5);
        QVERIFY2(outcome.output.contains("does not exist here"), outcome.output.constData());
        QVERIFY2(!outcome.output.contains("assembly"), outcome.output.constData());
        QVERIFY2(outcome.error.contains("Velocity and acceleration do not exist at θ₂ = 270.00°:"),
                 outcome.error.constData());
    }

    /// A former defect: "cannot be assembled at t = 0 s (θ₂ = 60.00°)", where the crank is at 0°.
    void namesTheCrankAngleOfAnImpossiblePosition()
    {
        const RunResult outcome = run("check --a 40 --b 30 --c 80 --at-angle 60 x=50");
        QCOMPARE(outcome.status, 4);
        QVERIFY2(outcome.error.contains("The mechanism cannot be assembled at θ₂ = 60.00°:"),
                 outcome.error.constData());
    }

    void writesJson()
    {
        const RunResult outcome = run(QString(kExample) + "x=9.79 theta3=-154 v=41.46 omega3=-310.4 --format json");
        QCOMPARE(outcome.status, 1);
        const QJsonObject json = outcome.json();
        const QJsonObject v = json["values"].toArray()[2].toObject();
        QCOMPARE(v["name"].toString(), QString("v"));
        QCOMPARE(v["given"].toDouble(), 41.46);
        QVERIFY(std::abs(v["exact"].toDouble() + 41.4608) < 1e-4);
        QCOMPARE(v["digits"].toInt(), 4);
        QCOMPARE(v["verdict"].toString(), QString("wrong"));
        QVERIFY(v["convention"].isNull());
        QCOMPARE(json["slip"].toObject()["name"].toString(), QString("crank-speed-sign"));
        QCOMPARE(json["slip"].toObject()["sentence"].toString(),
                 QString("ω₂ with the opposite sign gives exactly your v and omega3."));
        QVERIFY(checkJson("x=9.79 v=-41.46").contains("slip"));
        QVERIFY(checkJson("x=9.79 v=-41.46")["slip"].isNull());
    }

    /// Textbooks give the rates of angles in rad/s beside angles in degrees.
    void readsRatesWithoutUnitInRadiansIfTheyAreRightThere()
    {
        const RunResult radians = run(QString(kExample) + "theta3=-154 omega3=5.42");
        QCOMPARE(radians.status, 0);
        QVERIFY2(radians.output.contains("rad/s  right to its 3 digits"), radians.output.constData());
        QCOMPARE(run(QString(kExample) + "omega3=310.4").status, 0); // °/s
        QCOMPARE(run(QString(kExample) + "omega3=5.48").status, 1);
        QCOMPARE(run(QString(kExample) + "omega3=5.42deg/s").status, 1);
    }

    /// A wrong rate without unit is taken in rad/s if only then a slip gives it, or else if it is nearer in size to the
    /// exact value in rad/s than to that in °/s.
    void readsWrongRatesWithoutUnitInTheLikelyUnit()
    {
        const auto unitOf = [](const QString &values, const char *options = "") {
            return checkJson(values + options)["values"].toArray().last().toObject()["unit"].toString();
        };
        QCOMPARE(slipName("x=9.79 v=41.46 omega3=-5.42"), QString("crank-speed-sign"));
        QCOMPARE(unitOf("x=9.79 v=41.46 omega3=-5.42"), QString("rad/s"));
        QCOMPARE(slipName("x=9.79 v=41.46 omega3=-310.4"), QString("crank-speed-sign"));
        QCOMPARE(unitOf("x=9.79 v=41.46 omega3=-310.4"), QString("°/s"));
        QCOMPARE(slipName("v=-395.9 omega3=51.73"), QString("crank-speed-in-rpm")); // by the size, it would be in °/s
        QCOMPARE(unitOf("omega3=5.48"), QString("rad/s"));
        QCOMPARE(unitOf("omega3=311.9"), QString("°/s"));
        QCOMPARE(unitOf("omega3=311.9", " --angle-unit rad"), QString("°/s"));
        QCOMPARE(unitOf("theta3=25.9 alpha3=-28.0"), QString("rad/s²"));
    }

    void writesRoundingErrorsAsZero()
    {
        const RunResult outcome = run("check --a 40 --b 120 --c 0 --omega2 10 --at-angle 180 v=0 theta3=0 x=8e1");
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.output.contains("exact: 0 mm/s  right\n"), outcome.output.constData());
        QVERIFY2(outcome.output.contains("exact: 0°  right\n"), outcome.output.constData());
        QVERIFY2(outcome.output.contains("right to its only digit\n"), outcome.output.constData());
    }

    void understandsSymbolsAsTheyAreWritten()
    {
        const RunResult outcome = run(QString(kExample) + "x_B=9.79 ω₃=5.42 \u03BC=64.1 θ3=25.9");
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.output.startsWith("x_B"));
    }

    /// A former defect: 154 instead of 205.9°, an error of the sign, was accepted as 154 rad, which stand for 154 ±
    /// 0.5 rad and so for a third of all angles.
    void takesNoCommonAngleForRadians()
    {
        for (const char *angle : {"154", "334", "20", "1", "1000000", "2e3deg"}) { // ± 5000 and ± 500

            QCOMPARE(run(QString(kExample) + "theta3=" + angle).status, 1);
        }
        QCOMPARE(run(QString(kExample) + "theta3=0.453").status, 0);
        QCOMPARE(run(QString(kExample) + "theta3=3.59").status, 0); // at B
        QCOMPARE(run(QString(kExample) + "--angle-unit rad theta3=25.9").status, 0);
    }

    /// A former defect: simple harmonic motion was said to give exactly a θ3 that is measured clockwise.
    void slipsOfTheSliderExplainNoAngleAlone()
    {
        QStringList names;
        for (const QJsonValue &candidate : checkJson("theta3=-25.9445")["candidates"].toArray()) {
            names << candidate.toObject()["name"].toString();
        }
        QCOMPARE(names, QStringList({"other-assembly", "coupler-angle-sign"}));
    }

    /// A former defect: 13.9 instead of 19.09° was called radians, because 57.3 · 19.09° and 13.9° are six half turns
    /// apart.
    void anAngleInTheWrongUnitHasNoPeriod()
    {
        const char *position = "check --a 29.56 --b 85.2 --c 8.32 --at-angle 318.6 ";
        QCOMPARE(slipName("theta3=13.9", position), QString());
        QCOMPARE(slipName("theta3=0.3332deg", position), QString("value-in-radians"));
        QCOMPARE(slipName("theta3=3.4748deg", position), QString("value-in-radians")); // at B
    }

    void namesTheSlipOfEachCalculation()
    {
        QCOMPARE(slipName("x=-4.596 theta3=154.06"), QString("other-assembly"));
        QCOMPARE(slipName("x=9.79 v=-41.46 a=-681.46"), QString("crank-acceleration-omitted"));
        QCOMPARE(slipName("x=9.79 v=-41.46 omega3=5.42deg/s"), QString("value-in-radians"));
        QCOMPARE(slipName("x=0.3855 v=-41.46"), QString("inches"));
        QCOMPARE(slipName("x=24.87 v=-105.3"), QString("inches")); // in cm
        QCOMPARE(slipName("x=9.79 v=-41.46 mu=25.94"), QString("pressure-angle"));
        QCOMPARE(slipName("x=9.79 v=-41.46 mu=115.94"), QString("obtuse-angle"));
        QCOMPARE(slipName("x=2.5981 v=-22.500"), QString("harmonic-motion"));
        QCOMPARE(slipName("x=9.79 v=-50"), QString());
        const QJsonArray candidates = checkJson("v=41.46")["candidates"].toArray();
        QCOMPARE(candidates.size(), qsizetype(2));
        QCOMPARE(candidates[0].toObject()["name"].toString(), QString("crank-speed-sign"));
    }

    void reportsPositionsWithoutMotion()
    {
        const RunResult impossible = run("check --a 10 --b 5 --c 0 --at-angle 90 x=1.0");
        QCOMPARE(impossible.status, 4);
        QVERIFY(impossible.hasOneLineError());
        const RunResult singular = run("check --a 10 --b 5 --c 5 --at-angle 0 x=10.00 v=1.0");
        QCOMPARE(singular.status, 5);
        QVERIFY(singular.output.endsWith("does not exist here\n"));
    }

    void refusesWhatIsNoValue_data()
    {
        QTest::addColumn<QString>("values");
        QTest::addColumn<QString>("message");
        QTest::newRow("no values") << ""
                                   << "Give the values to be checked";
        QTest::newRow("no equals sign") << "9.74"
                                        << "A value must be a name, = and a number";
        QTest::newRow("unknown quantity") << "speed=3"
                                          << "\"speed\" is no quantity";
        QTest::newRow("no number") << "x=nine"
                                   << "x: “nine” is not a number";
        QTest::newRow("decimal comma") << "x=9,74"
                                       << "Write the decimal sign as";
        QTest::newRow("comma before three digits") << "a=1,024"
                                                   << "a: A comma is not accepted: write 1.024, or 1024";
        QTest::newRow("mixed fraction") << "\"x=9 3/4\""
                                        << "write it as a decimal number, such as 9.75 mm.";
        QTest::newRow("fraction with a unit") << "\"x=1/2 in\" --length-unit in"
                                              << "x: “1/2 in” does not show to which digit it is rounded: write it as "
                                                 "a decimal number, such as 0.5 in.";
        QTest::newRow("nothing behind the equals sign") << "x= 9"
                                                        << "x has no value";
        QTest::newRow("other dimension") << "x=9deg"
                                         << "use a unit such as mm, cm, m, km, in, ft, yd.";
        QTest::newRow("length for a velocity") << "v=9mm"
                                               << "use a unit such as mm/s, cm/s, m/s, km/s, in/s, ft/s, yd/s.";
        QTest::newRow("rpm for an acceleration") << "alpha3=9rpm"
                                                 << "use a unit such as deg/s^2, rad/s^2, rev/s^2.";
        QTest::newRow("twice") << "v=1 R4_x_diff=2"
                               << "is given more than once";
        QTest::newRow("acceleration without a number") << "x=1 --alpha2 5mm"
                                                       << "--alpha2";
    }

    void refusesWhatIsNoValue()
    {
        QFETCH(QString, values);
        QFETCH(QString, message);
        const RunResult outcome = run("check --at-angle 30 " + values);
        QCOMPARE(outcome.status, 2);
        QVERIFY(outcome.hasOneLineError());
        QVERIFY2(outcome.error.contains(message.toUtf8()), outcome.error.constData());
        QVERIFY(outcome.output.isEmpty());
    }
};

const Suite<TestCheckCommand> suite("tst_check_command");

} // namespace tst_check_command

#include "tst_check_command.moc"
