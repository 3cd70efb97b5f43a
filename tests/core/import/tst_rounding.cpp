// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"
#include "tests/support/suite.h"

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
        const CellNumber number =
            parseNumber(text.toStdString(), text.contains(',') ? DecimalSign::Comma : DecimalSign::Point);
        observer.observe(number.places, number.value);
    }
    return observer.infer(unitFactor);
}

} // namespace

class TestRounding : public QObject
{
    Q_OBJECT

private slots:
    void findsWhereTheDigitsStand()
    {
        struct Row {
            const char *text;
            bool zero;
            int first;
            int last;
            int printed;
        };
        for (const Row &row :
             {Row{"139.397000", false, 2, -3, -6}, Row{"0.0120", false, -2, -3, -4}, Row{"-7.5", false, 0, -1, -1},
              Row{"1200", false, 3, 2, 0}, Row{".25", false, -1, -2, -2}, Row{"25.", false, 1, 0, 0},
              Row{"1.250e+03", false, 3, 1, 0}, Row{"-1.5E-7", false, -7, -8, -8}, Row{"-0.000", true, 0, 0, -3}}) {
            const PrintedPlaces places = parseNumber(row.text, DecimalSign::Point).places;
            QVERIFY2(places.zero == row.zero && places.first == row.first && places.last == row.last &&
                         places.printed == row.printed,
                     row.text);
        }
    }

    void infersTheRule()
    {
        struct Row {
            const char *name;
            QStringList cells;
            Rule rule;
            int digits;
        };
        QStringList fewSmall =
            column([](int i) { return asInventorPrints((i % 2 == 0 ? 1500 : 500) + irregular(i, 300.0), 6); });
        fewSmall << "12.345"
                 << "23.451"
                 << "1.234"
                 << "2.345";
        // Of one number throughout, zeros may be its own.
        const std::vector<Row> rows{
            {"6 significant digits, printed with 6 decimals",
             column([](int i) { return asInventorPrints(irregular(i, 1200.0), 6); }), Rule::SignificantDigits, 6},
            {"3 decimals, printed with 6", column([](int i) { return withDecimals(irregular(i, 130.0), 3) + "000"; }),
             Rule::Decimals, 3},
            {"3 decimals in half of the rows, 6 significant digits in the others", column([](int i) {
                 const double value = irregular(i, 48.0);
                 return i % 2 == 0 ? withDecimals(value, 3) + "000" : asInventorPrints(value, 6);
             }),
             Rule::Decimals, 3},
            {"6 significant digits, with more in one row of ten",
             column([](int i) { return asInventorPrints(irregular(i, 1200.0), i % 10 == 0 ? 8 : 6); }),
             Rule::SignificantDigits, 6},
            {"6 significant digits, with fewer in one row of ten",
             column([](int i) { return asInventorPrints(irregular(i, 1200.0), i % 10 == 0 ? 4 : 6); }),
             Rule::SignificantDigits, 6},
            {"a decimal comma", column([](int i) { return withDecimals(irregular(i, 130.0), 2).replace('.', ','); }),
             Rule::Decimals, 2},
            {"integers", column([](int i) { return withDecimals(irregular(i, 900.0), 0); }), Rule::Decimals, 0},
            {"tens: whole numbers", column([](int i) { return withDecimals(irregular(i, 900.0), 0) + "0"; }),
             Rule::Decimals, 0},
            {"all digits that a double has", column([](int i) { return QString::number(irregular(i, 75.0), 'g', 17); }),
             Rule::SignificantDigits, 16},
            {"6 significant digits, printed with 17",
             column([](int i) { return QString::number(asInventorPrints(irregular(i, 75.0), 6).toDouble(), 'g', 17); }),
             Rule::SignificantDigits, 6},
            {"3 decimals, printed with 19 digits and a comma", column([](int i) {
                 return QString::number(withDecimals(irregular(i, 130.0), 3).toDouble(), 'e', 18).replace('.', ',');
             }),
             Rule::Decimals, 3},
            {"6 significant digits of numbers beyond a million, printed with 6 decimals",
             column([](int i) { return asInventorPrints(irregular(i, 5e6), 6); }), Rule::SignificantDigits, 6},
            {"4 digits with exponents",
             column([](int i) { return QString::number(std::exp(irregular(i, 20.0)), 'e', 3); }),
             Rule::SignificantDigits, 4},
            {"3 decimals, and zeros",
             column([](int i) { return i % 3 == 0 ? "0.000000" : withDecimals(irregular(i, 130.0), 3) + "000"; }),
             Rule::Decimals, 3},
            {"6 significant digits, and four small values that end early", fewSmall, Rule::SignificantDigits, 6},
            {"zeros", column([](int) { return QString("0.000000"); }), Rule::Unknown, 0},
            {"nothing", QStringList(), Rule::Unknown, 0},
            {"25 throughout, with 6 decimals: as many digits as a person chooses",
             column([](int) { return QString("25.000000"); }), Rule::Decimals, 2},
            {"25 throughout, with 1 decimal", column([](int) { return QString("25.0"); }), Rule::Decimals, 1},
            {"360 throughout, either sign", column([](int i) { return QString(i % 2 == 0 ? "360" : "-360"); }),
             Rule::Decimals, 0},
            {"0.1 throughout, as a double has it", column([](int) { return QString("0.10000000000000001"); }),
             Rule::Decimals, 4},
            {"6 rad/s in degrees throughout", column([](int) { return QString("343.775000"); }), Rule::Decimals, 3},
            {"a long coupler's throughout, with an exponent", column([](int) { return QString("3.07587e+07"); }),
             Rule::Decimals, -2},
        };
        for (const Row &row : rows) {
            const Rounding rounding = inferred(row.cells);
            QVERIFY2(rounding.rule == row.rule && rounding.digits == row.digits, row.name);
        }
    }

    void isNoCoarserThanWhatIsPrinted()
    {
        struct Row {
            QStringList cells;
            double value;
            double step;
        };
        const std::vector<Row> rows{{{"70", "40"}, 70.0, 1.0},
                                    {{"7", "40"}, 40.0, 1.0},
                                    {{"70.0", "40.0"}, 70.0, 0.1},
                                    {{"8.53", "12.30"}, 12.3, 0.01},
                                    {{"70.000000", "40.000000"}, 70.0, 1.0},
                                    {{"74.543600", "-1139.910000"}, 1139.91, 0.01},
                                    {{"12.34", "45.67", "78.9", "23.45"}, 78.9, 0.01},
                                    {{"30", "60", "90", "120", "150", "180"}, 90.0, 1.0},
                                    {{"30.0", "60.0", "90.0", "120.0", "150.0", "180.0", "210.0", "240.0"}, 90.0, 1.0}};
        for (const Row &row : rows) {
            const double found = inferred(row.cells).stepAt(row.value);
            QVERIFY2(std::abs(found - row.step) <= 1e-12 * row.step, qPrintable(row.cells.join(' ')));
        }
    }

    void stepsAsTheRuleSays()
    {
        struct Row {
            Rounding rounding;
            double value;
            double step;
        };
        constexpr double kRadian = 57.29577951308232;
        const Rounding six{Rule::SignificantDigits, 6, 1.0, -3};
        const Rounding padded{Rule::SignificantDigits, 6, 1.0, -3, -6};
        const Rounding radians{Rule::SignificantDigits, 6, kRadian, 0};
        const Rounding encoder{Rule::Multiples, 0, kRadian, 0, -4, 3, 0.25};
        const std::vector<Row> rows{{six, 139.397, 1e-3},
                                    {six, -1139.91, 1e-2},
                                    {six, 0.0, 1e-8},
                                    {padded, 12.0, 1e-4},
                                    {padded, 0.001, 1e-6},
                                    {radians, 9.99999 * kRadian, 1e-5 * kRadian},
                                    {radians, 10.0 * kRadian, 1e-4 * kRadian},
                                    {encoder, 7.0, 0.25 * kRadian},
                                    {{Rule::Decimals, 3, 10.0, 0}, 74.5, 1e-2},
                                    {{Rule::Decimals, -2}, 1200.0, 100.0},
                                    {{Rule::SignificantDigits, 2, 1.0, 0, 0, 0}, 1234.0, 1.0},
                                    {Rounding(), 12.0, 0.0}};
        for (const Row &row : rows) {
            const double found = row.rounding.stepAt(row.value);
            QVERIFY2(std::abs(found - row.step) <= 1e-12 * row.step, qPrintable(QString::number(found, 'g', 17)));
        }
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

    void stepsInARowAreThoseOfEachValue()
    {
        for (const Rule rule : {Rule::SignificantDigits, Rule::Decimals, Rule::Multiples, Rule::Unknown}) {
            Rounding rounding{rule, 6, 57.29577951308232, -4, -7};
            RoundingSteps steps(rounding);
            std::mt19937 random(20240918); // fixed: a failure can be repeated
            double value = 1.0;
            for (int i = 0; i < 30'000; ++i) {
                value *= random() % 8 == 0 ? -1.9 : 1.01; // neighbours alike, through all decades
                value = std::abs(value) > 1e8 ? 1e-7 : value;
                const double next = i % 1000 == 0 ? 0.0 : i % 777 == 0 ? rounding.unitFactor * 100.0 : value;
                QCOMPARE(steps.at(next), rounding.stepAt(next));
            }
        }
    }

    void remembersTheSmallestValueAndTheFinestPlace()
    {
        const Rounding rounding = inferred({"0.000000", "12.345600", "-0.004321", "123.4560"});
        QCOMPARE(rounding.smallestExponent, -3);
        QCOMPARE(rounding.finestPlace, -6);
    }
};

const Suite suite("tst_rounding", runWithoutApplication<TestRounding>);
#include "tst_rounding.moc"
