// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QTest>

#include <limits>

using namespace slidercrank;

namespace tst_written_number
{

class TestWrittenNumber : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void writesAsManyDigitsAsTheErrorLeaves()
    {
        struct Row {
            double value;
            double error;
            double scale;
            const char *text;
        };
        const Row rows[] = {
            {20.0000012, 1.2e-5, 100.0, "20.00000 ± 0.00001"},
            {60.04, 0.96, 100.0, "60 ± 1"},
            {60.0, 0.002, 100.0, "60.000 ± 0.002"},
            {9.99996, 1e-4, 100.0, "10.0000 ± 0.0001"},
            {-2e-6, 1.3e-5, 1.0, "0 ± 0.00001"},
            {312.0, 4012.0, 1.0, "0 ± 4000"},
            {2.0000004e-8, 1.1e-14, 1e-7, "2.000000·10⁻⁸ ± 10⁻¹⁴"},
            {20.0, std::numeric_limits<double>::quiet_NaN(), 100.0, "20"},
            {20.000000000000004, 1e-15, 100.0, "20"}, // only rounding of the computation
            {6.8e-14, 1e-15, 100.0, "0"},
        };
        for (const auto &[value, error, scale, text] : rows) {
            QCOMPARE(measuredText(value, error, scale), QString::fromUtf8(text));
        }
    }

    void roundsBoundsInwards()
    {
        QCOMPARE(lowerBoundText(37.4166, 4), QString("37.42"));
        QCOMPARE(upperBoundText(81.2404, 4), QString("81.24"));
        QCOMPARE(upperBoundText(81.2499, 4), QString("81.24"));
        QCOMPARE(lowerBoundText(-54.8182, 4), QString("−54.81"));
        QCOMPARE(upperBoundText(-54.8182, 4), QString("−54.82"));
        QCOMPARE(lowerBoundText(80.0 - 1e-13, 4), QString("80"));
        QCOMPARE(upperBoundText(80.0 + 1e-13, 4), QString("80"));
        QCOMPARE(lowerBoundText(9.9996, 4), QString("10"));
        QCOMPARE(upperBoundText(0.0, 4), QString("0"));
    }
};

const Suite<TestWrittenNumber> suite("tst_written_number");

} // namespace tst_written_number

#include "tst_written_number.moc"
