// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/rounding.h"

#include <QStringList>
#include <QTest>

#include <cmath>
#include <random>

using namespace slidercrank;
using Rule = Rounding::Rule;

namespace
{

constexpr int kRows = 200;

/// Numbers without pattern in their last digits, from -size to size.
double irregular(int i, double size)
{
    return size * std::sin(1.0 + 0.7 * i);
}

QString withDecimals(double value, int decimals)
{
    return QString::number(value, 'f', decimals);
}

/// As the author's files are: rounded to so many significant digits, then printed with six decimals.
QString asInventorPrints(double value, int significantDigits)
{
    return withDecimals(QString::number(value, 'e', significantDigits - 1).toDouble(), 6);
}

template <typename Print>
QStringList column(Print print)
{
    QStringList cells;
    for (int i = 0; i < kRows; ++i) {
        cells << print(i);
    }
    return cells;
}

Rounding inferred(const QStringList &cells, double unitFactor = 1.0)
{
    RoundingObserver observer;
    for (const QString &cell : cells) {
        const QByteArray text = cell.toLatin1();
        observer.observe({text.constData(), static_cast<std::size_t>(text.size())});
    }
    return observer.infer(unitFactor);
}

} // namespace

class TestRounding : public QObject
{
    Q_OBJECT

private slots:
    void findsWhereTheDigitsStand_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("zero");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("last");
        QTest::addColumn<int>("printed");
        QTest::newRow("trailing zeros") << QByteArray("139.397000") << false << 2 << -3 << -6;
        QTest::newRow("leading zeros") << QByteArray("0.0120") << false << -2 << -3 << -4;
        QTest::newRow("negative") << QByteArray("-7.5") << false << 0 << -1 << -1;
        QTest::newRow("decimal comma") << QByteArray("74,5436") << false << 1 << -4 << -4;
        QTest::newRow("integer") << QByteArray("1200") << false << 3 << 2 << 0;
        QTest::newRow("no digit before the point") << QByteArray(".25") << false << -1 << -2 << -2;
        QTest::newRow("no digit behind the point") << QByteArray("25.") << false << 1 << 0 << 0;
        QTest::newRow("exponent") << QByteArray("1.250e+03") << false << 3 << 1 << 0;
        QTest::newRow("negative exponent") << QByteArray("-1.5E-7") << false << -7 << -8 << -8;
        QTest::newRow("zero") << QByteArray("-0.000") << true << 0 << 0 << -3;
    }

    void findsWhereTheDigitsStand()
    {
        QFETCH(const QByteArray, text);
        const PrintedPlaces places = placesOf({text.constData(), static_cast<std::size_t>(text.size())});
        QTEST(places.zero, "zero");
        QTEST(places.first, "first");
        QTEST(places.last, "last");
        QTEST(places.printed, "printed");
    }

    void infersTheRule_data()
    {
        QTest::addColumn<QStringList>("cells");
        QTest::addColumn<int>("rule");
        QTest::addColumn<int>("digits");
        const auto significant = static_cast<int>(Rule::SignificantDigits);
        const auto decimals = static_cast<int>(Rule::Decimals);
        const auto unknown = static_cast<int>(Rule::Unknown);

        QTest::newRow("6 significant digits, printed with 6 decimals")
            << column([](int i) { return asInventorPrints(irregular(i, 1200.0), 6); }) << significant << 6;
        QTest::newRow("3 decimals, printed with 6")
            << column([](int i) { return withDecimals(irregular(i, 130.0), 3) + "000"; }) << decimals << 3;
        QTest::newRow("3 decimals in half of the rows, 6 significant digits in the others") << column([](int i) {
            const double value = irregular(i, 48.0);
            return i % 2 == 0 ? withDecimals(value, 3) + "000" : asInventorPrints(value, 6);
        }) << decimals << 3;
        QTest::newRow("6 significant digits, with more in one row of ten")
            << column([](int i) { return asInventorPrints(irregular(i, 1200.0), i % 10 == 0 ? 8 : 6); }) << significant
            << 6;
        QTest::newRow("6 significant digits, with fewer in one row of ten")
            << column([](int i) { return asInventorPrints(irregular(i, 1200.0), i % 10 == 0 ? 4 : 6); }) << significant
            << 6;
        QTest::newRow("a decimal comma") << column([](int i) {
            return withDecimals(irregular(i, 130.0), 2).replace('.', ',');
        }) << decimals << 2;
        QTest::newRow("integers") << column([](int i) { return withDecimals(irregular(i, 900.0), 0); }) << decimals
                                  << 0;
        QTest::newRow("tens: whole numbers")
            << column([](int i) { return withDecimals(irregular(i, 900.0), 0) + "0"; }) << decimals << 0;
        QTest::newRow("all digits that a double has")
            << column([](int i) { return QString::number(irregular(i, 75.0), 'g', 17); }) << significant << 16;
        QTest::newRow("6 significant digits, printed with 17") << column([](int i) {
            return QString::number(asInventorPrints(irregular(i, 75.0), 6).toDouble(), 'g', 17);
        }) << significant << 6;
        QTest::newRow("3 decimals, printed with 19 digits and a comma") << column([](int i) {
            return QString::number(withDecimals(irregular(i, 130.0), 3).toDouble(), 'e', 18).replace('.', ',');
        }) << decimals << 3;
        QTest::newRow("6 significant digits of numbers beyond a million, printed with 6 decimals")
            << column([](int i) { return asInventorPrints(irregular(i, 5e6), 6); }) << significant << 6;
        QTest::newRow("4 digits with exponents")
            << column([](int i) { return QString::number(std::exp(irregular(i, 20.0)), 'e', 3); }) << significant << 4;
        QTest::newRow("3 decimals, and zeros")
            << column([](int i) { return i % 3 == 0 ? "0.000000" : withDecimals(irregular(i, 130.0), 3) + "000"; })
            << decimals << 3;
        QStringList fewSmall =
            column([](int i) { return asInventorPrints((i % 2 == 0 ? 1500 : 500) + irregular(i, 300.0), 6); });
        fewSmall << "12.345"
                 << "23.451"
                 << "1.234"
                 << "2.345";
        QTest::newRow("6 significant digits, and four small values that end early") << fewSmall << significant << 6;
        QTest::newRow("zeros") << column([](int) { return QString("0.000000"); }) << unknown << 0;
        QTest::newRow("nothing") << QStringList() << unknown << 0;

        // One number throughout: its zeros may be the number's own.
        QTest::newRow("25 throughout, with 6 decimals: as many digits as a person chooses")
            << column([](int) { return QString("25.000000"); }) << decimals << 2;
        QTest::newRow("25 throughout, with 1 decimal") << column([](int) { return QString("25.0"); }) << decimals << 1;
        QTest::newRow("360 throughout, either sign")
            << column([](int i) { return QString(i % 2 == 0 ? "360" : "-360"); }) << decimals << 0;
        QTest::newRow("0.1 throughout, as a double has it")
            << column([](int) { return QString("0.10000000000000001"); }) << decimals << 4;
        QTest::newRow("6 rad/s in degrees throughout")
            << column([](int) { return QString("343.775000"); }) << decimals << 3;
        QTest::newRow("a long coupler's throughout, with an exponent")
            << column([](int) { return QString("3.07587e+07"); }) << decimals << -2;
    }

    void infersTheRule()
    {
        QFETCH(const QStringList, cells);
        const Rounding rounding = inferred(cells);
        QTEST(static_cast<int>(rounding.rule), "rule");
        QTEST(rounding.digits, "digits");
    }

    void isNoCoarserThanWhatIsPrinted_data()
    {
        QTest::addColumn<QStringList>("cells");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        QTest::newRow("two whole numbers") << QStringList{"70", "40"} << 70.0 << 1.0;
        QTest::newRow("and one of them beyond a decade") << QStringList{"7", "40"} << 40.0 << 1.0;
        QTest::newRow("two with a decimal") << QStringList{"70.0", "40.0"} << 70.0 << 0.1;
        QTest::newRow("two with two decimals, of which one ends early") << QStringList{"8.53", "12.30"} << 12.3 << 0.01;
        QTest::newRow("two whole ones with six decimals") << QStringList{"70.000000", "40.000000"} << 70.0 << 1.0;
        QTest::newRow("two of six digits with six decimals")
            << QStringList{"74.543600", "-1139.910000"} << 1139.91 << 0.01;
        QTest::newRow("one of four that ends early by chance")
            << QStringList{"12.34", "45.67", "78.9", "23.45"} << 78.9 << 0.01;
        QTest::newRow("chosen angles") << QStringList{"30", "60", "90", "120", "150", "180"} << 90.0 << 1.0;
        QTest::newRow("chosen angles with a decimal")
            << QStringList{"30.0", "60.0", "90.0", "120.0", "150.0", "180.0", "210.0", "240.0"} << 90.0 << 1.0;
    }

    void isNoCoarserThanWhatIsPrinted()
    {
        QFETCH(const QStringList, cells);
        QFETCH(const double, value);
        QFETCH(const double, step);
        const double found = inferred(cells).stepAt(value);
        QVERIFY2(std::abs(found - step) <= 1e-12 * step, qPrintable(QString::number(found, 'g', 17)));
    }

    void stepsAsTheRuleSays_data()
    {
        QTest::addColumn<Rounding>("rounding");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        const Rounding six{Rule::SignificantDigits, 6, 1.0, -2};
        QTest::newRow("6 digits at 99.9999") << six << 99.9999 << 1e-4;
        QTest::newRow("6 digits at 100") << six << 100.0 << 1e-3;
        QTest::newRow("6 digits at -1139.91") << six << -1139.91 << 1e-2;
        QTest::newRow("6 digits at 0.001") << six << 0.001 << 1e-8;
        QTest::newRow("6 digits at 1e300") << six << 1e300 << 1e295;
        QTest::newRow("6 digits at 0: as at the smallest value") << six << 0.0 << 1e-7;
        const Rounding printed{Rule::SignificantDigits, 6, 1.0, -2, -6};
        QTest::newRow("6 digits printed with 6 decimals, at 12") << printed << 12.0 << 1e-4;
        QTest::newRow("6 digits printed with 6 decimals, at 0.001") << printed << 0.001 << 1e-6;
        QTest::newRow("6 digits printed with 6 decimals, at 0") << printed << 0.0 << 1e-6;
        const Rounding radians{Rule::SignificantDigits, 6, 57.29577951308232, 0};
        QTest::newRow("6 digits in rad, at 9.99999 rad")
            << radians << 9.99999 * 57.29577951308232 << 1e-5 * 57.29577951308232;
        QTest::newRow("6 digits in rad, at 10 rad") << radians << 10.0 * 57.29577951308232 << 1e-4 * 57.29577951308232;
        const Rounding decimals{Rule::Decimals, 3, 10.0, 0};
        QTest::newRow("3 decimals in cm") << decimals << 74.5 << 1e-2;
        QTest::newRow("3 decimals at 0") << decimals << 0.0 << 1e-2;
        QTest::newRow("hundreds") << Rounding{Rule::Decimals, -2} << 1200.0 << 100.0;
        const Rounding whole{Rule::SignificantDigits, 2, 1.0, 0, 0, 0};
        QTest::newRow("2 digits of whole numbers, at 1234") << whole << 1234.0 << 1.0;
        QTest::newRow("unknown") << Rounding() << 12.0 << 0.0;
    }

    void stepsAsTheRuleSays()
    {
        QFETCH(const Rounding, rounding);
        QFETCH(const double, value);
        QFETCH(const double, step);
        const double found = rounding.stepAt(value);
        QVERIFY2(std::abs(found - step) <= 1e-12 * step, qPrintable(QString::number(found, 'g', 17)));
    }

    void keepsTheDecadeThroughAConversion()
    {
        // A power of ten converted to another unit and back may come out just below it.
        for (const double factor : {57.29577951308232, 25.4, 10.0, 1e3, 1e6, 57.29577951308232e6}) {
            const Rounding rounding{Rule::SignificantDigits, 6, factor, 0};
            for (int exponent = -20; exponent <= 20; ++exponent) {
                const double value = std::pow(10.0, exponent) * factor;
                const double step = std::pow(10.0, exponent - 5) * factor;
                QVERIFY2(std::abs(rounding.stepAt(value) - step) < 1e-9 * step,
                         qPrintable(QStringLiteral("10^%1 · %2").arg(exponent).arg(factor)));
            }
        }
    }

    void stepsInARowAreThoseOfEachValue_data()
    {
        QTest::addColumn<int>("rule");
        QTest::newRow("significant digits") << int(Rule::SignificantDigits);
        QTest::newRow("decimals") << int(Rule::Decimals);
        QTest::newRow("unknown") << int(Rule::Unknown);
    }

    void stepsInARowAreThoseOfEachValue()
    {
        QFETCH(const int, rule);
        Rounding rounding{static_cast<Rule>(rule), 6, 57.29577951308232, -4};
        rounding.finestPlace = -7;
        RoundingSteps steps(rounding);
        std::mt19937 random(20240918); // fixed: a failure can be repeated
        double value = 1.0;
        for (int i = 0; i < 100000; ++i) {
            value *= random() % 8 == 0 ? -1.9 : 1.01; // neighbours alike, through all decades
            value = std::abs(value) > 1e8 ? 1e-7 : value;
            const double next = i % 1000 == 0 ? 0.0 : i % 777 == 0 ? rounding.unitFactor * 100.0 : value;
            QCOMPARE(steps.at(next), rounding.stepAt(next));
        }
    }

    void remembersTheSmallestValueAndTheFinestPlace()
    {
        const Rounding rounding = inferred({"0.000000", "12.345600", "-0.004321", "123.4560"});
        QCOMPARE(rounding.smallestExponent, -3);
        QCOMPARE(rounding.finestPlace, -6);
    }
};

QTEST_APPLESS_MAIN(TestRounding)
#include "tst_rounding.moc"
