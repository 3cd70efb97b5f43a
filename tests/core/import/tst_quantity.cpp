// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <string>

using namespace slidercrank;

namespace tst_quantity
{

class TestQuantity : public QObject
{
    Q_OBJECT

private slots:
    void parsesNumbersWithUnits()
    {
        struct Row {
            const char *text;
            Unit expected;
            double value;
        };
        const double pi = std::numbers::pi;
        const std::vector<Row> rows{
            {"25", kMillimetre, 25.0},
            {"25 mm", kMillimetre, 25.0},
            {"60.123456789012345 mm", kMillimetre, 60.123456789012345},
            {"2.5cm", kMillimetre, 25.0},
            {"4.35m", kMillimetre, 4350.0},
            {"1 in", kMillimetre, 25.4},
            {"1.1in", kMillimetre, 27.94},
            {"−25 mm", kMillimetre, -25.0},
            {"1e−3", kMillimetre, 1e-3},
            {"+5", kMillimetre, 5.0},
            {".5", kMillimetre, 0.5},
            {"5.", kMillimetre, 5.0},
            {"1e3mm", kMillimetre, 1000.0},
            {"1.5·10⁻⁷", kMillimetre, 1.5e-7},
            {"10⁻⁸", kMillimetre, 1e-8},
            {"−2.50 × 10¹² mm", kMillimetre, -2.5e12},
            {"1.5·10^-7", kMillimetre, 1.5e-7},
            {"10^−3 m", kMillimetre, 1.0},
            {"1.5·10⁻³ m", kMillimetre, 1.5},
            {"60.1·10²", kMillimetre, 6010.0},
            {"1 000 001", kMillimetre, 1'000'001.0},
            {"-12\u202F500.5 mm", kMillimetre, -12500.5},
            {"60 rpm", kRadianPerSecond, 2.0 * pi},
            {"360deg/s", kRadianPerSecond, 2.0 * pi},
            {"-360 °/s", kTurnPerMinute, -60.0},
            {"2.5 rad/s", kRadianPerSecond, 2.5},
            {"90deg", kRadian, pi / 2.0},
            {"370°", kDegree, 370.0},
            {"1 rad", kDegree, 180.0 / pi},
            {"0.5 s", kSecond, 0.5},
            {"5ms", kSecond, 0.005},
        };
        for (const Row &row : rows) {
            const Quantity quantity = readQuantity(row.text, row.expected);
            QVERIFY2(!quantity.fault && quantity.value == row.value, row.text); // to the last bit
        }
        QCOMPARE(readQuantity("1e-8", {}).value, 1e-8);
    }

    void givesTheReasonForARefusal()
    {
        struct Row {
            std::string text;
            QuantityFault fault;
        };
        using enum QuantityFault;
        const std::vector<Row> rows{
            {"", NotANumber},
            {"sixty", NotANumber},
            {"inf", NotANumber},
            {"nan", NotANumber},
            {"mm", NotANumber},
            {".", NotANumber},
            {"+-5", NotANumber},
            {"20/3", NotANumber},
            {"20 + 3", NotANumber},
            {"20 3", NotANumber},
            {"1.234.5", NotANumber},
            {"1234 567", NotANumber},
            {"1.5·10", NotANumber},
            {"·10⁻⁷", NotANumber},
            {"10⁻", NotANumber},
            {"10^-", NotANumber},
            {"2⁵", NotANumber},
            {"110²", NotANumber},
            {"1e3·10⁻⁷", NotANumber},
            {"1.5·20", NotANumber},
            {"1,5·10⁻⁷", CommaForPoint},
            {"10⁹⁹⁹", TooLarge},
            {"30,5", CommaForPoint},
            {"30,5 mm", CommaForPoint},
            {"1,234.5", NotANumber},
            {"1.234,5", NotANumber},
            {"1,234,567", NotANumber},
            {"1e999", TooLarge},
            {"12abc", UnknownUnit},
            {"0x10", UnknownUnit},
            {"3 s", WrongUnit},
            {"3 mm/s", WrongUnit},
            {std::string(100'000, '1'), TooLarge},
            {std::string(100'000, '*'), NotANumber},
        };
        for (const Row &row : rows) {
            const Quantity quantity = readQuantity(row.text, kMillimetre);
            QVERIFY2(quantity.fault == row.fault && std::isnan(quantity.value), row.text.substr(0, 40).c_str());
        }
        QVERIFY(readQuantity("5 mm", {}).fault == WrongUnit);
    }
};

const Suite<TestQuantity> suite("tst_quantity");

} // namespace tst_quantity

#include "tst_quantity.moc"
