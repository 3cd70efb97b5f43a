// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/axis_scale.h"
#include "ui/text/written_number.h"

#include <QTest>

using namespace slidercrank;

namespace tst_axis_scale
{

class TestAxisScale : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void roundsARangeOutwards()
    {
        const Interval rounded = roundedOutwards({4.46, 48.59});
        QVERIFY(rounded.lower < 4.46 && rounded.upper > 48.59 && rounded.length() < 1.3 * (48.59 - 4.46));
        QCOMPARE(roundedOutwards({0.0, 3.0}).lower, 0.0);
        QCOMPARE(roundedOutwards({4.46, 48.6}), roundedOutwards({4.47, 48.61})); // the axis does not move
        for (const double value : {0.0, 5.0, -3e7, 1e-9}) {
            const Interval range = roundedOutwards({value, value});
            QVERIFY(range.length() > 0.0 && range.contains(value));
        }
    }

    void writesNumbersWithTheirDigits()
    {
        struct Row {
            double value;
            int digits;
            const char *text;
        };
        const Row rows[] = {{0.00802941, 3, "0.00803"}, {0.000154, 3, "0.000154"}, {560.2, 3, "560"},
                            {74.5436, 6, "74.5436"},    {1.54e-9, 3, "1.54·10⁻⁹"}, {-2.5e12, 3, "−2.50·10¹²"},
                            {9.9996e9, 3, "1.00·10¹⁰"}, {1e-8, 1, "10⁻⁸"},         {0.0, 3, "0"},
                            {9.99999, 4, "10.00"},      {-99.9996, 4, "−100.0"},   {999999.9, 3, "1.00·10⁶"},
                            {9.994, 3, "9.99"},         {kInfinity, 3, "∞"},       {-kInfinity, 3, "−∞"}};
        for (const auto &[value, digits, text] : rows) {
            QCOMPARE(shortNumber(value, digits), QString::fromUtf8(text));
        }
        const std::pair<double, const char *> numbers[] = {{1e-8, "10⁻⁸"},   {-1e-12, "−10⁻¹²"},
                                                           {1e300, "10³⁰⁰"}, {0.002, "0.002"},
                                                           {-0.0, "0"},      {6.02e23, "6.02·10²³"}};
        for (const auto &[value, text] : numbers) {
            QCOMPARE(numberText(value), QString::fromUtf8(text));
        }
        const std::pair<double, const char *> typed[] = {{1e-8, "1e-8"}, {-2.5e+100, "-2.5e100"}, {0.1, "0.1"}};
        for (const auto &[value, text] : typed) {
            QCOMPARE(typedNumberText(value), QString(text));
        }
        QLocale::setDefault(QLocale::Spanish);
        QCOMPARE(numberText(1.5e-7), QStringLiteral("1,5·10⁻⁷"));
        QCOMPARE(typedNumberText(1.5e-7), QStringLiteral("1,5e-7"));
        QCOMPARE(shortNumber(1.5e-7, 2), QStringLiteral("1,5·10⁻⁷"));
        QCOMPARE(shortNumber(-12316.06, 7), QStringLiteral("−12316,06")); // no groups
        QCOMPARE(fixedText(-12316.06, 1), QStringLiteral("−12316,1"));
        QCOMPARE(fixedText(-0.04, 1), QStringLiteral("0,0"));
    }

    void findsTheNextRoundNumber()
    {
        const std::pair<double, double> rows[] = {{1.0, 1.0},   {1.1, 2.0},  {0.1 * 20.0, 2.0},
                                                  {0.03, 0.05}, {7.0, 10.0}, {101.0, 200.0}};
        for (const auto &[value, round] : rows) {
            QCOMPARE(nextRoundNumber(value), round);
        }
    }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
};

const Suite<TestAxisScale> suite("tst_axis_scale");

} // namespace tst_axis_scale

#include "tst_axis_scale.moc"
