// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"
#include "tests/support/suite.h"

#include <QStringList>
#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace tst_rounding
{

using Rule = Rounding::Rule;

/// Returns numbers from -size to size without a pattern in their last digits.
double irregular(int i, double size)
{
    return size * std::sin(1.0 + 0.7 * i);
}

QString withDecimals(double value, int decimals)
{
    return QString::number(value, 'f', decimals);
}

/// Rounds to significant digits and prints six decimals, as Inventor does.
QString padded(double value, int significantDigits)
{
    return withDecimals(QString::number(value, 'e', significantDigits - 1).toDouble(), 6);
}

Rounding inferred(const QStringList &cells)
{
    RoundingObserver observer;
    for (const QString &cell : cells) {
        const DecimalSign sign = cell.contains(u',') ? DecimalSign::Comma : DecimalSign::Point;
        const CellNumber number = parseNumber(cell.toStdString(), sign);
        observer.observe(number.places, number.value);
    }
    return observer.infer(1.0, RoundingObserver::Content::Quantity);
}

struct ColumnRow {
    const char *name;
    QString (*print)(int row);
    Rule rule;
    int digits;
};

const std::vector<ColumnRow> kColumns{
    {"6 digits, padded to 6 decimals", [](int i) { return padded(irregular(i, 1200.0), 6); }, Rule::SignificantDigits,
     6},
    {"3 decimals, padded", [](int i) { return withDecimals(irregular(i, 130.0), 3) + "000"; }, Rule::Decimals, 3},
    {"3 decimals in half of the rows, 6 digits in the others",
     [](int i) {
         const double value = irregular(i, 48.0);
         return i % 2 == 0 ? withDecimals(value, 3) + "000" : padded(value, 6);
     },
     Rule::Decimals, 3},
    {"6 digits, more in one row of ten", [](int i) { return padded(irregular(i, 1200.0), i % 10 == 0 ? 8 : 6); },
     Rule::SignificantDigits, 6},
    {"6 digits, fewer in one row of ten", [](int i) { return padded(irregular(i, 1200.0), i % 10 == 0 ? 4 : 6); },
     Rule::SignificantDigits, 6},
    {"a decimal comma", [](int i) { return withDecimals(irregular(i, 130.0), 2).replace('.', ','); }, Rule::Decimals,
     2},
    {"whole numbers", [](int i) { return withDecimals(irregular(i, 900.0), 0); }, Rule::Decimals, 0},
    {"tens, which are whole numbers", [](int i) { return withDecimals(irregular(i, 900.0), 0) + "0"; }, Rule::Decimals,
     0},
    {"all digits of a double", [](int i) { return QString::number(irregular(i, 75.0), 'g', 17); },
     Rule::SignificantDigits, 16},
    {"ns since 1970", [](int i) { return "1716200000" + withDecimals(5e8 + irregular(i, 4e8), 0); },
     Rule::SignificantDigits, 16},
    {"6 digits, printed with 17",
     [](int i) { return QString::number(padded(irregular(i, 75.0), 6).toDouble(), 'g', 17); }, Rule::SignificantDigits,
     6},
    {"6 digits beyond a million", [](int i) { return padded(irregular(i, 5e6), 6); }, Rule::SignificantDigits, 6},
    {"4 digits with exponents", [](int i) { return QString::number(std::exp(irregular(i, 20.0)), 'e', 3); },
     Rule::SignificantDigits, 4},
    {"3 decimals, and zeros",
     [](int i) { return i % 3 == 0 ? "0.000000" : withDecimals(irregular(i, 130.0), 3) + "000"; }, Rule::Decimals, 3},
    {"6 digits, and four small values with fewer",
     [](int i) { return i < 4 ? withDecimals(1.2345 * (i + 1), 3) : padded(1e3 + irregular(i, 500.0), 6); },
     Rule::SignificantDigits, 6},
    {"6 digits, and a standstill in half of the rows",
     [](int i) { return i < 100 ? QString("80") : QString::number(80.0 + irregular(i, 15.0), 'g', 6); },
     Rule::SignificantDigits, 6},
    {"zeros", [](int) { return QString("0.000000"); }, Rule::Unknown, 0},
    // If all values are equal, their zeros may be significant.
    {"25, padded: as many digits as a person chooses", [](int) { return QString("25.000000"); }, Rule::Decimals, 2},
    {"25, 1 decimal", [](int) { return QString("25.0"); }, Rule::Decimals, 1},
    {"360 with either sign", [](int i) { return QString(i % 2 == 0 ? "360" : "-360"); }, Rule::Decimals, 0},
    {"0.1 as a double", [](int) { return QString("0.10000000000000001"); }, Rule::Decimals, 4},
    {"6 rad/s in degrees", [](int) { return QString("343.775000"); }, Rule::Decimals, 3},
    {"an exponent", [](int) { return QString("3.07587e+07"); }, Rule::Decimals, -2},
};

class TestRounding : public QObject
{
    Q_OBJECT

private slots:
    void infersTheRule()
    {
        for (const ColumnRow &column : kColumns) {
            QStringList cells;
            for (int row = 0; row < 200; ++row) {
                cells << column.print(row);
            }
            const Rounding rounding = inferred(cells);
            QVERIFY2(rounding.rule == column.rule && rounding.digits == column.digits, column.name);
        }
        QCOMPARE(inferred({}).rule, Rule::Unknown);
    }

    void isNoCoarserThanThePrintedDigits()
    {
        struct Row {
            QStringList cells;
            double value;
            double step;
        };
        const std::vector<Row> rows{
            {{"70", "40"}, 70.0, 1.0},
            {{"7", "40"}, 40.0, 1.0},
            {{"70.0", "40.0"}, 70.0, 0.1},
            {{"70.", "40."}, 70.0, 1.0},
            {{".25", "-.5"}, 0.5, 0.01},
            {{"1.250e+03", "-3.5E+02"}, 350.0, 10.0},
            {{"8.53", "12.30"}, 12.3, 0.01},
            {{"70.000000", "40.000000"}, 70.0, 1.0},
            {{"74.543600", "-1139.910000"}, 1139.91, 0.01},
            {{"12.34", "45.67", "78.9", "23.45"}, 78.9, 0.01},
            {{"1.63",  "6.36",  "13.72", "23.00", "33.38", "44.00", "54.08", "63.00",
              "70.28", "75.64", "78.90", "80.00", "78.90", "75.64", "70.28", "63.00",
              "54.08", "44.00", "33.38", "23.00", "13.72", "6.36",  "1.63"},
             44.0,
             0.01},
            {{"1.63", "6.36",  "13.72", "23", "33.38", "44", "54.08", "63", "70.28", "75.64", "78.9", "80",
              "78.9", "75.64", "70.28", "63", "54.08", "44", "33.38", "23", "13.72", "6.36",  "1.63"},
             44.0,
             0.01},
            {{"6.36", "23", "44", "63", "75.64", "80", "75.64", "63", "44", "23", "6.36"}, 44.0, 0.01},
            {{"-2120", "-2030", "-1730", "-1260", "-700", "-143", "336", "678", "879", "1020", "1040", "1090", "973",
              "814", "304"},
             2120.0,
             10.0},
            {{"30", "60", "90", "120", "150", "180"}, 90.0, 1.0},
            {{"30.0", "60.0", "90.0", "120.0", "150.0", "180.0", "210.0", "240.0"}, 90.0, 1.0}};
        for (const Row &row : rows) {
            const double found = inferred(row.cells).stepAt(row.value);
            QVERIFY2(std::abs(found - row.step) <= 1e-12 * row.step, qPrintable(row.cells.join(' ')));
        }
        const Rounding rounding = inferred({"0.000000", "12.345600", "-0.004321", "123.4560"});
        QCOMPARE(rounding.smallestExponent, -3);
        QCOMPARE(rounding.finestPlace, -6);
    }

    void returnsTheStepOfTheRule()
    {
        struct Row {
            Rounding rounding;
            double value;
            double step;
        };
        constexpr double kRadian = 57.29577951308232;
        const Rounding six{Rule::SignificantDigits, 6, 1.0, -3};
        const Rounding sixDecimals{Rule::SignificantDigits, 6, 1.0, -3, -6};
        const Rounding encoder{Rule::Multiples, 0, kRadian, 0, -4, 3, 0.25};
        const std::vector<Row> rows{{six, 139.397, 1e-3},
                                    {six, -1139.91, 1e-2},
                                    {six, 0.0, 1e-8},
                                    {six, 1e-300, 1e-305},
                                    {sixDecimals, 12.0, 1e-4},
                                    {sixDecimals, 0.001, 1e-6},
                                    {encoder, 7.0, 0.25 * kRadian},
                                    {{Rule::Decimals, 3, 10.0, 0}, 74.5, 1e-2},
                                    {{Rule::Decimals, -2}, 1200.0, 100.0},
                                    {{Rule::SignificantDigits, 2, 1.0, 0, 0, 0}, 1234.0, 1.0},
                                    {Rounding(), 12.0, 0.0}};
        for (const Row &row : rows) {
            const double found = row.rounding.stepAt(row.value);
            QVERIFY2(std::abs(found - row.step) <= 1e-12 * row.step, qPrintable(QString::number(found, 'g', 17)));
        }
        // Converting a power of ten to a different unit and back may yield a value just below it.
        for (const double factor : {1.0, kRadian, 25.4, 10.0, 1e3, 1e6, kRadian * 1e6}) {
            const Rounding rounding{Rule::SignificantDigits, 6, factor, 0};
            for (int exponent = -20; exponent <= 20; ++exponent) {
                for (const double mantissa : {1.0, 1.1, 9.99999}) {
                    const double step = std::pow(10.0, exponent - 5) * factor;
                    const double found = rounding.stepAt(mantissa * std::pow(10.0, exponent) * factor);
                    QVERIFY2(std::abs(found - step) < 1e-9 * step, qPrintable(QString::number(exponent)));
                }
            }
        }
    }
};

const Suite<TestRounding> suite("tst_rounding");

} // namespace tst_rounding

#include "tst_rounding.moc"
