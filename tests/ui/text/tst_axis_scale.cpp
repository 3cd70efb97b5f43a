// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/axis_scale.h"
#include "ui/text/written_number.h"

#include <QTest>

using namespace slidercrank;

class TstAxisScale : public QObject
{
    Q_OBJECT

private slots:
    void writesShortLabels_data();
    void writesShortLabels();
    void roundsARangeOutwards();
    void standsStillWhileTheValuesChangeALittle();
    void givesAConstantARange();
    void standsValuesThatUnderflow();
    void writesNumbersWithTheirDigits_data();
    void writesNumbersWithTheirDigits();
    void writesPowersOfTenInOneWay();
    void writesLabelsInTheGivenLanguage();
};

void TstAxisScale::writesShortLabels_data()
{
    QTest::addColumn<double>("lower");
    QTest::addColumn<double>("upper");
    QTest::addColumn<double>("tick");
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("unit");
    QTest::newRow("degrees") << 0.0 << 50.0 << 20.0 << "20"
                             << "mm";
    QTest::newRow("below one") << 0.0 << 0.02 << 0.005 << "0.005"
                               << "mm";
    QTest::newRow("negative zero") << -1.0 << 1.0 << -1e-17 << "0.0"
                                   << "mm";
    QTest::newRow("small") << 0.0 << 4e-4 << 2e-4 << "0.0002"
                           << "mm";
    QTest::newRow("tiny") << 0.0 << 4e-5 << 2e-5 << "20"
                          << "10⁻⁶ mm";
    QTest::newRow("huge") << -2e9 << 2e9 << 1e9 << "1"
                          << "10⁹ mm";
    QTest::newRow("far from zero") << 74.2 << 76.1 << 75.5 << "75.5"
                                   << "mm";
}

void TstAxisScale::writesShortLabels()
{
    QFETCH(double, lower);
    QFETCH(double, upper);
    QFETCH(double, tick);
    const AxisScale scale = axisScale({lower, upper}, 5.0);
    QTEST(scale.label(tick, QLocale::c()), "label");
    QTEST(scale.unit(QStringLiteral("mm")), "unit");
    constexpr int kRoom = 6; // characters, the room that plots give to labels
    QVERIFY(scale.labelLength({lower, upper}) <= kRoom);
}

void TstAxisScale::roundsARangeOutwards()
{
    const Interval rounded = roundedOutwards({4.46, 48.59});
    QVERIFY(rounded.lower < 4.46 && rounded.upper > 48.59);
    QVERIFY(rounded.length() < 1.3 * (48.59 - 4.46));
    QCOMPARE(roundedOutwards({0.0, 3.0}).lower, 0.0);
}

void TstAxisScale::standsStillWhileTheValuesChangeALittle()
{
    QCOMPARE(roundedOutwards({4.46, 48.6}), roundedOutwards({4.47, 48.61}));
}

void TstAxisScale::givesAConstantARange()
{
    for (const double value : {0.0, 5.0, -3e7, 1e-9}) {
        const Interval range = roundedOutwards({value, value});
        QVERIFY(range.length() > 0.0);
        QVERIFY(range.contains(value));
    }
}

void TstAxisScale::standsValuesThatUnderflow()
{
    for (const double largest : {5e-324, 1e-310, 1e-300, 1e300}) {
        const AxisScale scale = axisScale({0.0, largest}, 5.0);
        QVERIFY(scale.decimals >= 0 && scale.decimals <= 17);
    }
}

void TstAxisScale::writesNumbersWithTheirDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("digits");
    QTest::addColumn<QString>("text");
    QTest::newRow("report's largest error") << 0.00802941 << 3 << "0.00803";
    QTest::newRow("its slider's") << 0.000154 << 3 << "0.000154";
    QTest::newRow("large") << 560.2 << 3 << "560";
    QTest::newRow("a position") << 74.5436 << 6 << "74.5436";
    QTest::newRow("very small") << 1.54e-9 << 3 << "1.54·10⁻⁹";
    QTest::newRow("very large") << -2.5e12 << 3 << "-2.50·10¹²";
    QTest::newRow("carries into the next power") << 9.9996e9 << 3 << "1.00·10¹⁰";
    QTest::newRow("a power alone") << 1e-8 << 1 << "10⁻⁸";
    QTest::newRow("zero") << 0.0 << 3 << "0";
}

void TstAxisScale::writesNumbersWithTheirDigits()
{
    QFETCH(double, value);
    QFETCH(int, digits);
    QTEST(shortNumber(value, digits, QLocale::c()), "text");
}

/// On the screen as on an axis; where one types as one types it.
void TstAxisScale::writesPowersOfTenInOneWay()
{
    QLocale::setDefault(QLocale::Spanish);
    QCOMPARE(numberText(1.5e-7), QStringLiteral("1,5·10⁻⁷"));
    QCOMPARE(typedNumberText(1.5e-7), QStringLiteral("1,5e-7"));
    QLocale::setDefault(QLocale::c());
    QCOMPARE(numberText(1e-8), QStringLiteral("10⁻⁸"));
    QCOMPARE(numberText(-1e-12, 2), QStringLiteral("-10⁻¹²"));
    QCOMPARE(numberText(1e300), QStringLiteral("10³⁰⁰"));
    QCOMPARE(numberText(6.02e23, QLocale::FloatingPointShortest), QStringLiteral("6.02·10²³"));
    QCOMPARE(numberText(0.002), QStringLiteral("0.002"));
    QCOMPARE(typedNumberText(1e-8), QStringLiteral("1e-8"));
    QCOMPARE(typedNumberText(-2.5e+100), QStringLiteral("-2.5e100"));
    QCOMPARE(typedNumberText(0.1), QStringLiteral("0.1"));
}

void TstAxisScale::writesLabelsInTheGivenLanguage()
{
    QCOMPARE(shortNumber(-12316.06, 7, QLocale(QLocale::English)), QStringLiteral("-12316.06")); // as the axes
    QCOMPARE(shortNumber(-12316.06, 7, QLocale(QLocale::Spanish)), QStringLiteral("-12316,06"));
    QCOMPARE(axisScale({0.0, 1.0}, 5.0).label(0.2, QLocale(QLocale::Spanish)), QStringLiteral("0,2"));
}

QTEST_APPLESS_MAIN(TstAxisScale)
#include "tst_axis_scale.moc"
