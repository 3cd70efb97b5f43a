// SPDX-License-Identifier: GPL-3.0-or-later

// The check of a calculation by hand.

#include "core/check/check.h"
#include "core/check/written_value.h"
#include "tests/core/check/hand_calculation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_check
{

constexpr std::array kQuantities{"x", "v", "a", "theta3", "omega3", "alpha3"};

/// Returns the value as a student would state it: rounded to that many significant digits, in mm, degrees and s.
/// `value` is in mm, rad and s.
GivenValue written(const char *name, double value, int digits)
{
    const OutputChannel channel = *outputChannelNamed(name);
    const Measure measure = measureOf(channel);
    const double shown = toFileUnit(measure, value);
    const QByteArray text = QByteArray::number(shown, 'e', digits - 1);
    const Unit unit{measure != lengthMeasure(orderOf(channel)) ? Dimension::Angle : Dimension::Length,
                    static_cast<int>(orderOf(channel)), 1.0};
    const WrittenValue read = readWrittenValue(text.toStdString(), unit);
    const double factor = toFileUnit(measure, 1.0);
    return {channel, read.value / factor, read.halfStep / factor};
}

struct Problem {
    Parameters parameters;
    double alpha2;

    CrankPosition position() const { return {Mechanism(parameters), alpha2}; }
    HandCalculation calculation() const { return {parameters, alpha2}; }
};

Problem randomProblem(RandomMechanisms &random)
{
    const Parameters parameters = random.ordinary();
    const double normal = parameters.omega2 * parameters.omega2;
    return {parameters, random.uniform(0.2, 2.0) * normal * (random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0)};
}

/// Numbers of mechanisms, of 300 with the same slip, by the answer of the program.
struct Tally {
    int wrong = 0;     ///< mechanisms for which the slip changes a number
    int named = 0;     ///< the slip was named
    int misnamed = 0;  ///< only other slips were named
    int ambiguous = 0; ///< several slips were named, the right one among them
};

Tally tally(const SlipCase &slipCase, int digits)
{
    Tally result;
    RandomMechanisms random(20261);
    for (int i = 0; i < 300; ++i) {
        const Problem problem = randomProblem(random);
        HandCalculation hand = problem.calculation();
        slipCase.calculate(hand);
        std::vector<GivenValue> given;
        for (const char *name : kQuantities) {
            if (std::isfinite(hand.valueOf(name))) {
                given.push_back(written(name, hand.valueOf(name), digits));
            }
        }
        const CheckResult checked = check(problem.position(), given);
        const bool isAmong = std::ranges::count(checked.slips, slipCase.slip) == 1;
        result.wrong += checked.explanation != CheckOutcome::NotNeeded && given.size() == kQuantities.size();
        result.named += checked.explanation == CheckOutcome::SingleSlip && isAmong;
        result.ambiguous += checked.explanation == CheckOutcome::Ambiguous && isAmong;
        result.misnamed += !checked.slips.empty() && !isAmong;
    }
    return result;
}

/// The position of the examples: a = 3 mm, b = 8 mm, c = 2 mm, θ2 = -30°, ω2 = -15 rad/s, α2 = -10 rad/s².
const Problem kExample{{.a = 3.0, .b = 8.0, .c = 2.0, .omega2 = -15.0, .theta20 = -kPi / 6.0}, -10.0};

class TestCheck : public QObject
{
    Q_OBJECT

private slots:
    void theHandCalculationIsRight()
    {
        RandomMechanisms random(3);
        for (int i = 0; i < 300; ++i) {
            const Problem problem = randomProblem(random);
            std::vector<GivenValue> given;
            for (const char *name : {"x", "v", "a", "theta3", "omega3", "alpha3", "mu"}) {
                given.push_back(written(name, problem.calculation().solve().valueOf(name), 10));
            }
            QVERIFY(check(problem.position(), given).explanation == CheckOutcome::NotNeeded);
        }
    }

    void namesEverySlip_data()
    {
        QTest::addColumn<const SlipCase *>("slipCase");
        for (const SlipCase &slipCase : kSlipCases) {
            QTest::newRow(slipCase.title) << &slipCase;
        }
    }

    void namesEverySlip()
    {
        QFETCH(const SlipCase *, slipCase);
        const Tally five = tally(*slipCase, 5);
        const Tally three = tally(*slipCase, 3);
        const QString counts = QStringLiteral("five digits: %1 wrong, %2 named, %3 ambiguous, %4 misnamed; "
                                              "three digits: %5 wrong, %6 named, %7 ambiguous, %8 misnamed")
                                   .arg(five.wrong)
                                   .arg(five.named)
                                   .arg(five.ambiguous)
                                   .arg(five.misnamed)
                                   .arg(three.wrong)
                                   .arg(three.named)
                                   .arg(three.ambiguous)
                                   .arg(three.misnamed);
        qInfo("%s", qPrintable(counts));
        // Rounding θ3 may change only the last digit of a number.
        const bool mayChangeLastDigitOnly = slipCase->slip == Slip::CouplerAngleRounded;
        QVERIFY2(five.wrong > 50, qPrintable(counts));
        QVERIFY2(five.named >= five.wrong * (mayChangeLastDigitOnly ? 80 : 97) / 100, qPrintable(counts));
        QVERIFY2(five.misnamed == 0 && three.misnamed == 0, qPrintable(counts));
    }

    /// Tests the slips that change the transmission angle alone.
    void namesOtherAnglesThanTheTransmissionAngle()
    {
        struct Row {
            Slip slip;
            double (*angle)(double mu);
        };
        for (const Row &row : {Row{Slip::PressureAngle, [](double mu) { return kPi / 2.0 - mu; }},
                               Row{Slip::ObtuseAngle, [](double mu) { return kPi - mu; }}}) {
            for (const int digits : {3, 5}) {
                for (const bool isBesidePosition : {false, true}) {
                    RandomMechanisms random(2948);
                    int wrong = 0;
                    int named = 0;
                    int uncertain = 0; // 180° - μ with three digits is a whole number of degrees
                    for (int i = 0; i < 300; ++i) {
                        const Problem problem = randomProblem(random);
                        const HandCalculation hand = problem.calculation().solve();
                        std::vector<GivenValue> given{written("mu", row.angle(hand.mu), digits)};
                        if (isBesidePosition) {
                            given.push_back(written("x", hand.x, digits));
                            given.push_back(written("theta3", hand.theta3, digits));
                        }
                        const CheckResult checked = check(problem.position(), given);
                        const bool isAmong = std::ranges::count(checked.slips, row.slip) == 1;
                        wrong += checked.explanation == CheckOutcome::NotNeeded ? 0 : 1;
                        named += checked.explanation == CheckOutcome::SingleSlip && isAmong ? 1 : 0;
                        uncertain += checked.explanation == CheckOutcome::TooFewDigits ? 1 : 0;
                        QVERIFY(checked.slips.empty() || isAmong);
                    }
                    qInfo("%d digits, beside x and theta3: %d; %d named of %d, %d with too few digits", digits,
                          isBesidePosition, named, wrong, uncertain);
                    QVERIFY(wrong > 250 && named + uncertain >= wrong * 97 / 100);
                    QVERIFY(digits == 3 || named >= wrong * 97 / 100);
                }
            }
        }
    }

    void seldomNamesASlipForRandomNumbers_data()
    {
        QTest::addColumn<double>("relativeError");
        QTest::addColumn<bool>("hasFixedSize");
        QTest::addColumn<int>("count");
        for (const double relativeError : {0.05, 0.2}) {
            for (const int count : {1, 2, 3, 4}) {
                const QString title = QStringLiteral("%1 numbers, %2 % off").arg(count).arg(100.0 * relativeError);
                QTest::newRow(qPrintable("exactly " + title)) << relativeError << true << count;
                QTest::newRow(qPrintable("up to " + title)) << relativeError << false << count;
            }
        }
    }

    void seldomNamesASlipForRandomNumbers()
    {
        QFETCH(double, relativeError);
        QFETCH(bool, hasFixedSize);
        QFETCH(int, count);
        constexpr int kCases = 1000;
        RandomMechanisms random(77);
        int named = 0;
        for (int i = 0; i < kCases; ++i) {
            const Problem problem = randomProblem(random);
            const HandCalculation hand = problem.calculation().solve();
            std::vector<const char *> names(kQuantities.begin(), kQuantities.end());
            names.push_back("mu");
            std::vector<GivenValue> given;
            while (static_cast<int>(given.size()) < count) {
                const auto chosen =
                    names.begin() + static_cast<int>(random.uniform(0.0, static_cast<double>(names.size())));
                const double sense = random.uniform(-1.0, 1.0);
                const double error = relativeError * (hasFixedSize ? std::copysign(1.0, sense) : sense);
                given.push_back(written(*chosen, hand.valueOf(*chosen) * (1.0 + error), 3));
                names.erase(chosen);
            }
            named += check(problem.position(), given).slips.empty() ? 0 : 1;
        }
        qInfo("%d of %d", named, kCases);
        QVERIFY2(named <= kCases / (count == 1 ? 50 : 200), qPrintable(QString::number(named)));
    }

    void readsTheLastDigit_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("halfStep");
        QTest::addColumn<int>("digits");
        QTest::newRow("9.74") << 9.74 << 0.005 << 3;
        QTest::newRow("-9.740") << -9.74 << 0.0005 << 4;
        QTest::newRow("+0.0120") << 0.012 << 0.00005 << 3;
        QTest::newRow(".5") << 0.5 << 0.05 << 1;
        QTest::newRow("1.20e3") << 1200.0 << 5.0 << 3;
        QTest::newRow("1.20·10³") << 1200.0 << 5.0 << 3;
        QTest::newRow("1024") << 1024.0 << 0.5 << 4;
        QTest::newRow("1200") << 1200.0 << 5.0 << 3;
        QTest::newRow("1000") << 1000.0 << 5.0 << 3;
        QTest::newRow("-12000") << -12000.0 << 50.0 << 3;
        QTest::newRow("10240") << 10240.0 << 5.0 << 4;
        QTest::newRow("1200.") << 1200.0 << 0.5 << 4;
        QTest::newRow("1200.0") << 1200.0 << 0.05 << 5;
        QTest::newRow("100") << 100.0 << 0.5 << 3;
        QTest::newRow("10") << 10.0 << 0.5 << 2;
        QTest::newRow("0") << 0.0 << 0.5 << 0;
        QTest::newRow("0.00") << 0.0 << 0.005 << 0;
        QTest::newRow("1 024 mm") << 1024.0 << 0.5 << 4;
        QTest::newRow("9.74 cm") << 97.4 << 0.05 << 3;
        QTest::newRow("1.9in") << 48.26 << 1.27 << 2;
        QTest::newRow("0.99m") << 990.0 << 5.0 << 2;
    }

    void readsTheLastDigit()
    {
        QFETCH(double, value);
        QFETCH(double, halfStep);
        QFETCH(int, digits);
        const WrittenValue read = readWrittenValue(QTest::currentDataTag(), kMillimetre);
        QVERIFY(!read.fault);
        QVERIFY(std::abs(read.value - value) <= 1e-12 * std::abs(value));
        QVERIFY(std::abs(read.halfStep - halfStep) <= 1e-9 * halfStep);
        QCOMPARE(read.digits, digits);
    }

    void acceptsTheta3MeasuredAtB()
    {
        // The coupler is inclined by 25.9445°: asin(3.5/8). At B it is 205.9445°, or -154.0555°.
        struct Row {
            const char *degrees;
            bool isRight;
            bool isMeasuredAtB;
        };
        for (const Row &row :
             {Row{"25.94", true, false}, Row{"385.94", true, false}, Row{"-334.06", true, false},
              Row{"205.94", true, true}, Row{"-154.06", true, true}, Row{"565.94", true, true}, Row{"-154", true, true},
              Row{"-25.94", false, false}, Row{"154.06", false, false}, Row{"25.95", false, false}}) {
            const WrittenValue read = readWrittenValue(row.degrees, kDegree);
            const GivenValue given{Channel{Theta3, Order::Position}, read.value / kDegreesPerRadian,
                                   read.halfStep / kDegreesPerRadian};
            const CheckedValue checked = check(kExample.position(), std::vector{given}).values.front();
            QCOMPARE(checked.isRight, row.isRight);
            QCOMPARE(checked.isMeasuredAtB, row.isMeasuredAtB);
        }
    }

    void prefersSlipsThatKeepTheRightValues()
    {
        // If v alone is given, its opposite sign may be due to ω2, or to a slider that is measured towards the crank. A
        // right x excludes the second cause.
        const HandCalculation hand = kExample.calculation().solve();
        const GivenValue v = written("v", -hand.v, 5);
        const CheckResult alone = check(kExample.position(), std::vector{v});
        QVERIFY(alone.explanation == CheckOutcome::Ambiguous);
        QVERIFY(alone.slips == (std::vector{Slip::CrankSpeedSign, Slip::FromOuterDeadCentre}));
        const CheckResult beside = check(kExample.position(), std::vector{v, written("x", hand.x, 5)});
        QVERIFY(beside.slips == std::vector{Slip::CrankSpeedSign});
    }

    /// A former defect: a θ3 and a v of the wrong sign were said to be "measured from the outer dead centre", which a
    /// right x excludes.
    void aRightPositionExcludesWrongInputsAndOtherOrigins()
    {
        const HandCalculation hand = kExample.calculation().solve();
        const GivenValue theta3 = written("theta3", -hand.theta3, 5);
        const GivenValue v = written("v", -hand.v, 5);
        QVERIFY(check(kExample.position(), std::vector{theta3, v}).slips == std::vector{Slip::FromOuterDeadCentre});
        const CheckResult besideX = check(kExample.position(), std::vector{theta3, v, written("x", hand.x, 5)});
        QVERIFY(besideX.explanation == CheckOutcome::None);

        HandCalculation mirrored = kExample.calculation();
        mirrored.c *= -1.0;
        mirrored.solve();
        const GivenValue mirroredV = written("v", mirrored.v, 5);
        QVERIFY(check(kExample.position(), std::vector{mirroredV}).slips == std::vector{Slip::OffsetSign});
        for (const char *name : {"x", "theta3"}) {
            const std::vector beside{mirroredV, written(name, kExample.calculation().solve().valueOf(name), 5)};
            QVERIFY2(check(kExample.position(), beside).explanation == CheckOutcome::None, name);
        }
        // A right x does not exclude a wrong formula for the velocity alone.
        HandCalculation exchanged = kExample.calculation();
        exchangeCoupler(exchanged, Formulas::OfSlider);
        const std::vector beside{written("v", exchanged.v, 5), written("x", hand.x, 5)};
        QVERIFY(check(kExample.position(), beside).slips == std::vector{Slip::CouplerSineForCosine});
    }

    /// x = a cos θ2 + b cos θ3 with the θ3 of a textbook that measures it at B gives the x of the other assembly.
    void aRightTheta3ExcludesTheOtherAssembly()
    {
        const HandCalculation hand = kExample.calculation().solve();
        HandCalculation turned = kExample.calculation();
        turnCoupler(turned, Formulas::OfSlider);
        const GivenValue x = written("x", turned.x, 5);
        const GivenValue theta3 = written("theta3", hand.theta3 + kPi, 5);
        QVERIFY(check(kExample.position(), std::vector{x}).slips == std::vector{Slip::OtherAssembly});
        QVERIFY(check(kExample.position(), std::vector{x, theta3}).slips == std::vector{Slip::CouplerAngleEnd});
    }

    /// Spreadsheets write 4.9E-14 in place of the zero velocity at a dead centre.
    void aRoundingErrorIsZero()
    {
        Problem deadCentre = kExample;
        deadCentre.parameters.c = 0.0;
        deadCentre.parameters.theta20 = kPi;
        const auto deviationOf = [&](const char *text) {
            const WrittenValue read = readWrittenValue(text, kMillimetre);
            const GivenValue given{*outputChannelNamed("v"), read.value, read.halfStep};
            const CheckedValue checked = check(deadCentre.position(), {&given, 1}).values.front();
            return checked.isRight ? checked.deviation : kNone;
        };
        QCOMPARE(deviationOf("0"), 0.0);
        QCOMPARE(deviationOf("4.9e-14"), 0.0);
        QVERIFY(std::isnan(deviationOf("4.9e-6")));
    }

    void theDoubleHarmonicOfTheVelocityExplainsNoAcceleration()
    {
        const Problem engine{{.a = 300.0, .b = 1500.0, .c = 0.0, .omega2 = 5.0 * kPi, .theta20 = 40.0 * kPi / 180.0},
                             0.0};
        const double cosines = std::cos(40.0 * kPi / 180.0) + std::cos(80.0 * kPi / 180.0) / 5.0;
        const double acceleration = -300.0 * std::pow(5.0 * kPi, 2) * cosines;
        const CheckResult checked = check(engine.position(), std::vector{written("a", acceleration, 4)});
        QVERIFY(checked.slips == std::vector{Slip::TwoHarmonics});
    }

    void excludesChanceByDigitsAndQuantities()
    {
        // α2 omitted changes the acceleration by 4 %: two digits of one number may be a coincidence.
        HandCalculation hand = kExample.calculation();
        const double exact = hand.solve().acceleration;
        hand.alpha2 = 0.0;
        const double wrong = hand.solve().acceleration;
        QVERIFY(std::abs(wrong / exact - 1.0) < 0.05);
        const auto explanation = [&](const std::vector<GivenValue> &given) {
            return check(kExample.position(), given).explanation;
        };
        const GivenValue alpha3 = written("alpha3", hand.alpha3, 2);
        QVERIFY(explanation({written("a", wrong, 2)}) == CheckOutcome::TooFewDigits);
        QVERIFY(explanation({written("a", wrong, 5)}) == CheckOutcome::SingleSlip);
        QVERIFY(explanation({written("a", wrong, 2), alpha3}) == CheckOutcome::SingleSlip);
    }

    void forgivesRoundedIntermediateResults()
    {
        HandCalculation hand = kExample.calculation().solve();
        const double v = hand.v;
        hand.omega3 = 5.42; // 5.417…
        hand.solveSlider(hand.theta3);
        QVERIFY(std::abs(hand.v - v) > 0.005);
        const auto explanation = [](double value) {
            return check(kExample.position(), std::vector{written("v", value, 5)}).explanation;
        };
        QVERIFY(explanation(hand.v) == CheckOutcome::RoundedEarlier);
        QVERIFY(explanation(v + 10.0 * (hand.v - v)) == CheckOutcome::None);
    }

    void saysNothingWhereTheMechanismIsImpossible()
    {
        const Problem impossible{{.a = 10.0, .b = 5.0, .c = 0.0, .theta20 = kQuarterTurn}, 0.0};
        const CheckResult result = check(impossible.position(), std::vector{written("x", 1.0, 3)});
        QVERIFY(result.status == Status::NotAssemblable);
        QVERIFY(!result.values.front().isRight && result.slips.empty());
    }
};

const Suite<TestCheck> suite("tst_check");

} // namespace tst_check

#include "tst_check.moc"
