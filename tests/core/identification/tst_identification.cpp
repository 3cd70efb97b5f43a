// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/parameter_change.h"

#include "core/identification/sensitivity.h"
#include "tests/support/long_tests.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20240611;

const QString kAuthorsFile = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/../shared/reference/InventorData.csv");

/// A mechanism of the kind that people build: the coupler 3 % to three times longer than a full turn needs.
Parameters ordinary(RandomMechanisms &random)
{
    Parameters p;
    p.a = random.uniform(5.0, 100.0);
    p.c = p.a * random.uniform(-1.5, 1.5);
    p.b = (p.a + std::abs(p.c)) * random.uniform(1.03, 3.0);
    p.omega2 =
        std::exp(random.uniform(std::log(0.1), std::log(100.0))) * (random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
    p.theta20 = random.uniform(-kPi, kPi);
    p.branch = random.uniform(-1.0, 1.0) < 0.0 ? Branch::Open : Branch::Crossed;
    return p;
}

Printing turnsOf(const Parameters &p, double turns, int rows, const QString &channels)
{
    Printing printing;
    printing.to = turns * 2.0 * kPi / std::abs(p.omega2);
    printing.rows = rows;
    printing.channels = channels.toStdString();
    return printing;
}

/// What R4x cannot tell apart.
Parameters mirrored(Parameters p)
{
    p.c = -p.c;
    p.omega2 = -p.omega2;
    p.theta20 = -p.theta20;
    return p;
}

/// What θ3 cannot tell apart.
Parameters reversed(Parameters p)
{
    p.omega2 = -p.omega2;
    p.theta20 = kPi - p.theta20;
    return p;
}

/// Largest difference of lengths as part of a, of the speed as part of itself, of angles in rad.
double distance(const Parameters &found, const Parameters &truth)
{
    if (found.branch != truth.branch) {
        return std::numeric_limits<double>::infinity();
    }
    return std::max({std::abs(found.a - truth.a) / truth.a, std::abs(found.b - truth.b) / truth.a,
                     std::abs(found.c - truth.c) / truth.a, std::abs(found.omega2 / truth.omega2 - 1.0),
                     std::abs(std::remainder(found.theta20 - truth.theta20, 2.0 * kPi))});
}

QString described(const Parameters &p)
{
    return QStringLiteral("a %1 b %2 c %3 omega2 %4 theta20 %5 %6")
        .arg(p.a, 0, 'g', 10)
        .arg(p.b, 0, 'g', 10)
        .arg(p.c, 0, 'g', 10)
        .arg(p.omega2, 0, 'g', 10)
        .arg(p.theta20, 0, 'g', 10)
        .arg(p.branch == Branch::Open ? "open" : "crossed");
}

using Why = Identification::Alternative::Why;

bool hasAlternative(const Identification &result, Why why)
{
    return std::ranges::count(result.alternatives, why, &Identification::Alternative::why) > 0;
}

bool isFound(const Identification &result)
{
    return result.outcome == Identification::Outcome::Identified;
}

} // namespace

class TestIdentification : public QObject
{
    Q_OBJECT

private slots:
    void differentiatesAsDifferencesDo()
    {
        RandomMechanisms random(kSeed);
        for (int i = 0; i < 200; ++i) {
            const Parameters p = ordinary(random);
            const double t = random.uniform(-3.0, 3.0) / std::abs(p.omega2);
            PlottedValues values;
            PlottedDerivatives derivatives;
            QVERIFY(plottedMotion(p, t, values, derivatives));
            const PrintedRow expected = textbookMotion(p, t);
            for (std::size_t k = 0; k < kPrintedChannels; ++k) {
                const double found = toFileUnit(kPlottedChannels[k], values[static_cast<Eigen::Index>(k)]);
                const auto value = static_cast<double>(expected[k]);
                QVERIFY2(std::abs(found - value) <= 1e-9 * std::max(std::abs(value), 1.0), qPrintable(described(p)));
            }
            double Parameters::*const members[] = {&Parameters::a, &Parameters::b, &Parameters::c, &Parameters::omega2,
                                                   &Parameters::theta20};
            for (Eigen::Index j = 0; j < derivatives.cols(); ++j) {
                double Parameters::*const member = members[j];
                const double step = 1e-5 * (j == 4 ? 1.0 : std::abs(j == 3 ? p.omega2 : p.a));
                const auto at = [&](double steps) {
                    Parameters moved = p;
                    moved.*member += steps * step;
                    PlottedValues result;
                    plottedMotion(moved, t, result);
                    return result;
                };
                // Fourth order.
                const PlottedValues difference = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
                for (Eigen::Index k = 0; k < kPlottedCount; ++k) {
                    const double scale = std::abs(values[k]) / step * 1e-5 + std::abs(derivatives(k, j));
                    QVERIFY2(std::abs(difference[k] - derivatives(k, j)) <= 1e-5 * scale,
                             qPrintable(QStringLiteral("channel %1, parameter %2: %3 for %4; %5")
                                            .arg(k)
                                            .arg(j)
                                            .arg(derivatives(k, j))
                                            .arg(difference[k])
                                            .arg(described(p))));
                }
            }
        }
    }

    void findsItWhereFewRowsHoldNothingOfAColumn()
    {
        const Parameters truth{20.0, 60.0, 25.0, 6.25, 0.25, Branch::Open};
        Printing printing;
        printing.rows = 401;
        const ReferenceData data =
            printedData(truth, printing, [](int row, std::size_t channel) { return channel == 0 && row % 130 != 3; });
        const Identification found = identify(data, Mechanism());
        QVERIFY(isFound(found));
        QVERIFY(distance(found.parameters, truth) < 1e-4);
    }

    void findsTheMechanismOfTheAuthorsFile()
    {
        QFile file(kAuthorsFile);
        if (!file.open(QIODevice::ReadOnly)) {
            QSKIP("The author's file is not here.");
        }
        const QByteArray bytes = file.readAll();
        const auto outcome = readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        const Identification result = identify(data, Mechanism());
        QVERIFY(isFound(result));
        const Parameters truth{20.0, 60.0, 25.0, 2.0 * kPi, 0.0, Branch::Open};
        QVERIFY2(std::abs(result.parameters.a - 20.0) < 1e-5, qPrintable(described(result.parameters)));
        QVERIFY2(std::abs(result.parameters.b - 60.0) < 1e-5, qPrintable(described(result.parameters)));
        QVERIFY2(std::abs(result.parameters.c - 25.0) < 1e-5, qPrintable(described(result.parameters)));
        QVERIFY(distance(result.parameters, truth) < 1e-6);
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            QVERIFY(result.identifiable[i]);
            QVERIFY(result.standardError[i] > 0.0 && result.standardError[i] < 1e-5);
        }
        QVERIFY(result.iterations <= 10);
        QVERIFY(result.conditionNumber > 5.0 && result.conditionNumber < 20.0);
        QVERIFY(result.rms < 0.4);

        const std::vector<ParameterChange> causes =
            parameterChanges(data, Mechanism(), identify(data, Mechanism()).parameters);
        QCOMPARE(causes.size(), kParameterCount);
        QCOMPARE(causes[0].parameter, Parameter::B);
        QVERIFY(std::abs(causes[0].value - 60.0) < 5e-4);
        QVERIFY(causes[0].explained > 0.999999);
        QVERIFY(causes[1].explained < 0.9);
    }

    void findsRandomMechanisms_data()
    {
        QTest::addColumn<QString>("channels");
        QTest::newRow("all six channels") << "111111";
        QTest::newRow("θ3 and R4x") << "110000";
        QTest::newRow("R4x") << "010000";
        QTest::newRow("θ3 and the speed of R4x") << "100100";
        QTest::newRow("R4x and the speed of θ3") << "011000";
        QTest::newRow("both speeds") << "001100";
        QTest::newRow("everything of R4x") << "010101";
        QTest::newRow("the speed of R4x") << "000100";
    }

    void findsRandomMechanisms()
    {
        QFETCH(const QString, channels);
        const bool onlyR4x =
            !channels.contains('1') || (channels[0] == '0' && channels[2] == '0' && channels[4] == '0');
        RandomMechanisms random(kSeed);
        for (int i = 0; i < numericRuns(100, 1000); ++i) {
            const Parameters truth = ordinary(random);
            const double turns = random.uniform(0.6, 3.0);
            const int rows = static_cast<int>(random.uniform(80.0, 500.0));
            const ReferenceData data = printedData(truth, turnsOf(truth, turns, rows, channels));
            const Identification result = identify(data, Mechanism());
            const bool image = onlyR4x && result.parameters.omega2 * truth.omega2 < 0.0;
            const double found = distance(result.parameters, image ? mirrored(truth) : truth);
            QVERIFY2(isFound(result) && found <= 1e-3,
                     qPrintable(QStringLiteral("%1: %2 turns, %3 rows: off by %4: %5 instead of %6")
                                    .arg(i)
                                    .arg(turns)
                                    .arg(rows)
                                    .arg(found)
                                    .arg(described(result.parameters), described(truth))));
            QCOMPARE(hasAlternative(result, Why::MirrorImage), onlyR4x);
            QVERIFY(!result.onlyRatios && result.alternatives.size() == (onlyR4x ? 1 : 0));
        }
    }

    void findsTheRatiosFromTheCouplerAlone_data()
    {
        QTest::addColumn<QString>("channels");
        QTest::newRow("θ3") << "100000";
        QTest::newRow("θ3 and its derivatives") << "101010";
        QTest::newRow("the speed of θ3") << "001000";
    }

    void findsTheRatiosFromTheCouplerAlone()
    {
        QFETCH(const QString, channels);
        RandomMechanisms random(kSeed);
        for (int i = 0; i < numericRuns(100, 100); ++i) {
            const Parameters truth = ordinary(random);
            const ReferenceData data = printedData(truth, turnsOf(truth, random.uniform(0.6, 3.0), 201, channels));
            Parameters given;
            given.a = truth.a;
            given.omega2 = 1.0;
            given.branch = truth.branch;
            const Identification result = identify(data, Mechanism(given));
            QVERIFY(isFound(result));
            QCOMPARE(result.parameters.a, given.a);
            QVERIFY(result.parameters.omega2 > 0.0);
            const double found = distance(result.parameters, truth.omega2 < 0.0 ? reversed(truth) : truth);
            QVERIFY2(found <= 1e-3, qPrintable(described(result.parameters) + " instead of " + described(truth)));
            QVERIFY(result.onlyRatios && hasAlternative(result, Why::Reversed));
            QVERIFY(!hasAlternative(result, Why::MirrorImage));
            QCOMPARE(hasAlternative(result, Why::OtherAssembly), channels[0] == '0');
            QVERIFY(!result.identifiable[indexOf(Parameter::A)] && !result.identifiable[indexOf(Parameter::B)]);
            QVERIFY(!result.identifiable[indexOf(Parameter::C)] && result.identifiable[indexOf(Parameter::Omega2)]);
        }
    }

    void findsAMechanismFromItsAccelerations()
    {
        RandomMechanisms random(kSeed);
        for (int i = 0; i < 10; ++i) {
            const Parameters truth = ordinary(random);
            const double turns = random.uniform(0.6, 3.0);
            const Identification result =
                identify(printedData(truth, turnsOf(truth, turns, 201, "000011")), Mechanism());
            QVERIFY2(isFound(result) && distance(result.parameters, truth) <= 1e-3,
                     qPrintable(described(result.parameters) + " instead of " + described(truth)));
        }
    }

    void findsARocker()
    {
        RandomMechanisms random(kSeed);
        for (int i = 0; i < numericRuns(100, 100); ++i) {
            // Around the middle of the arc where c - a sin θ2 stays within ±b.
            Parameters truth = ordinary(random);
            const double c = std::abs(truth.c);
            truth.b = c + truth.a * random.uniform(-0.3, 0.9);
            if (truth.b < 0.1 * truth.a || truth.b < c - 0.7 * truth.a || truth.b > 0.9 * (truth.a + c)) {
                continue;
            }
            const double limit = std::asin(std::clamp((c - truth.b) / truth.a, -1.0, 1.0));
            const double upper = c + truth.b > truth.a ? kPi - limit : std::asin((c + truth.b) / truth.a);
            const double margin = 0.02 * (upper - limit);
            const double sign = truth.c < 0.0 ? -1.0 : 1.0;
            const double from = truth.omega2 * sign > 0.0 ? limit + margin : upper - margin;
            const double to = truth.omega2 * sign > 0.0 ? upper - margin : limit + margin;
            truth.theta20 = sign * from;
            Printing printing;
            printing.to = std::abs((to - from) / truth.omega2);
            for (const char *channels : {"111111", "110000", "010000"}) {
                printing.channels = channels;
                const Identification result = identify(printedData(truth, printing), Mechanism());
                const bool image = channels[0] == '0' && result.parameters.omega2 * truth.omega2 < 0.0;
                QVERIFY2(isFound(result) && distance(result.parameters, image ? mirrored(truth) : truth) <= 1e-3,
                         qPrintable(described(result.parameters) + " instead of " + described(truth)));
            }
        }
    }

    void bridgesGaps()
    {
        RandomMechanisms random(kSeed);
        for (int i = 0; i < numericRuns(100, 100); ++i) {
            const Parameters truth = ordinary(random);
            Printing printing = turnsOf(truth, 3.0, 300, "111111");
            // A turn is missing altogether, of the rest one cell in two; θ3 ends early, R4x begins late.
            const auto isGap = [&](int row, std::size_t channel) {
                return (row > 100 && row < 200) || (channel == 0 && row > 220) || (channel == 1 && row < 80) ||
                       random.uniform(0.0, 1.0) < 0.5;
            };
            const Identification result = identify(printedData(truth, printing, isGap), Mechanism());
            QVERIFY2(isFound(result) && distance(result.parameters, truth) <= 1e-3,
                     qPrintable(described(result.parameters) + " instead of " + described(truth)));
        }
    }

    void findsAMechanismOfAnySizeAtAnyTime()
    {
        for (const double size : {1e-9, 1e9}) {
            Parameters truth{20.0 * size, 60.0 * size, -25.0 * size, -1e3, 1.0, Branch::Crossed};
            Printing printing;
            printing.from = 1e4;
            printing.to = 1e4 + 0.01;
            printing.timeFormat = "%.12g";
            const Identification result = identify(printedData(truth, printing), Mechanism());
            QVERIFY(isFound(result));
            // At t = 0 the angle is as uncertain as the speed times 1e4 s.
            const double error = result.standardError[indexOf(Parameter::Theta20)];
            const double off = std::remainder(result.parameters.theta20 - truth.theta20, 2.0 * kPi);
            QVERIFY2(std::abs(off) < 5.0 * error, qPrintable(QStringLiteral("%1 ± %2").arg(off).arg(error)));
            truth.theta20 = result.parameters.theta20;
            QVERIFY2(distance(result.parameters, truth) < 1e-5, qPrintable(described(result.parameters)));
        }
    }

    void findsAThousandTurnsInManyRows()
    {
        const Parameters truth{20.0, 60.0, 25.0, -7.0, 2.0, Branch::Open};
        const Identification result =
            identify(printedData(truth, turnsOf(truth, 1000.0, 50000, "110000")), Mechanism());
        QVERIFY2(isFound(result) && distance(result.parameters, truth) < 1e-5,
                 qPrintable(described(result.parameters)));
    }

    void tellsHowFarOffItMayBe()
    {
        // Of errors that are as they are said to be, one in 300 is beyond three standard errors.
        RandomMechanisms random(kSeed);
        int count = 0;
        int beyond = 0;
        for (int i = 0; i < 100; ++i) {
            const Parameters truth = ordinary(random);
            const Identification result =
                identify(printedData(truth, turnsOf(truth, random.uniform(0.6, 3.0), 201, "110000")), Mechanism());
            const double errors[] = {result.parameters.a - truth.a, result.parameters.b - truth.b,
                                     result.parameters.c - truth.c, result.parameters.omega2 - truth.omega2,
                                     std::remainder(result.parameters.theta20 - truth.theta20, 2.0 * kPi)};
            for (std::size_t k = 0; k < kParameterCount; ++k) {
                ++count;
                beyond += std::abs(errors[k]) > 3.0 * result.standardError[k] ? 1 : 0;
            }
        }
        QVERIFY2(beyond <= count / 50, qPrintable(QStringLiteral("%1 of %2").arg(beyond).arg(count)));
    }

    void leavesOutAColumnThatIsWrong()
    {
        ReferenceData data = printedData({20.0, 60.0, 25.0, 5.0, 0.5, Branch::Open});
        for (ReferenceSeries &series : data.series) {
            if (series.channel.order == Order::Velocity) {
                for (double &value : series.values) {
                    value *= kDegreesPerRadian;
                }
            }
        }
        const Identification result = identify(data, Mechanism());
        // As they say, no mechanism explains all of them; the one that explains the others comes nearest.
        QCOMPARE(result.outcome, Identification::Outcome::Nearest);
        QVERIFY2(distance(result.parameters, {20.0, 60.0, 25.0, 5.0, 0.5, Branch::Open}) < 1e-5,
                 qPrintable(described(result.parameters)));
    }

    void findsNothingInNonsense()
    {
        ReferenceData data = printedData(Parameters());
        RandomMechanisms random(kSeed);
        for (ReferenceSeries &series : data.series) {
            for (double &value : series.values) {
                value = random.uniform(-1.0, 1.0);
            }
        }
        QCOMPARE(identify(data, Mechanism()).outcome, Identification::Outcome::None);
    }

    void saysThatNothingMoves()
    {
        Parameters standing;
        standing.omega2 = 0.0;
        standing.theta20 = 0.3;
        QCOMPARE(identify(printedData(standing), Mechanism()).lack, Identification::Lack::NothingMoves);
    }

    void saysThatThereAreTooFewData()
    {
        Printing printing;
        printing.rows = 4;
        printing.channels = "010000";
        QCOMPARE(identify(printedData(Parameters(), printing), Mechanism()).lack, Identification::Lack::FewValues);
        QCOMPARE(identify(ReferenceData(), Mechanism()).outcome, Identification::Outcome::Insufficient);
        QVERIFY(parameterChanges(ReferenceData(), Mechanism(), Parameters()).empty());
    }

    void stopsWhenAsked()
    {
        std::stop_source source;
        source.request_stop();
        const ReferenceData data = printedData(Parameters());
        QVERIFY(identify(data, Mechanism(), source.get_token()).stopped);
        QVERIFY(parameterChanges(data, Mechanism(), Parameters(), source.get_token()).empty());
    }

    void findsTheParameterThatMakesADifference_data()
    {
        QTest::addColumn<int>("which");
        QTest::newRow("a") << 0;
        QTest::newRow("b") << 1;
        QTest::newRow("c") << 2;
        QTest::newRow("ω2") << 3;
        QTest::newRow("θ20") << 4;
    }

    void findsTheParameterThatMakesADifference()
    {
        QFETCH(const int, which);
        RandomMechanisms random(kSeed);
        for (int i = 0; i < 50; ++i) {
            const Parameters truth = ordinary(random);
            Parameters given = truth;
            double Parameters::*const members[] = {&Parameters::a, &Parameters::b, &Parameters::c, &Parameters::omega2,
                                                   &Parameters::theta20};
            double Parameters::*const member = members[which];
            switch (which) {
            case 0: given.a *= random.uniform(0.3, 0.99); break;
            case 1: given.b *= random.uniform(1.01, 2.0); break;
            case 2: given.c = given.a * random.uniform(-1.5, 1.5); break;
            case 3: given.omega2 *= random.uniform(-1.5, 1.5); break;
            default: given.theta20 += random.uniform(-kPi, kPi); break;
            }
            const ReferenceData data = printedData(truth, turnsOf(truth, random.uniform(0.6, 3.0), 201, "111111"));
            const std::vector<ParameterChange> causes =
                parameterChanges(data, Mechanism(given), identify(data, Mechanism(given)).parameters);
            QCOMPARE(causes.size(), kParameterCount);
            const QString what = described(given) + " instead of " + described(truth);
            QVERIFY2(indexOf(causes[0].parameter) == static_cast<std::size_t>(which), qPrintable(what));
            QVERIFY2(causes[0].explained > 0.999, qPrintable(what));
            const double off = causes[0].value - truth.*member;
            const double scale = which == 4 ? 1.0 : which == 3 ? std::abs(truth.omega2) : truth.a;
            QVERIFY2(std::abs(which == 4 ? std::remainder(off, 2.0 * kPi) : off) <= 1e-3 * scale, qPrintable(what));
        }
    }
};

QTEST_APPLESS_MAIN(TestIdentification)
#include "tst_identification.moc"
