// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"
#include "core/import/reference_data.h"
#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace tst_clock
{

QByteArrayList printed(int count, double step, char format, int digits, double start = 0.0)
{
    QByteArrayList texts;
    for (int i = 0; i < count; ++i) {
        texts << QByteArray::number(start + step * i, format, digits);
    }
    return texts;
}

class TestClock : public QObject
{
    Q_OBJECT

private slots:
    void findsThePrecisionOfTimeStamps()
    {
        struct Row {
            const char *name;
            QByteArrayList times;
            const char *unit;
            double step;
            bool even;
            bool rounded;
        };
        const double frame = 1.0 / 30.0;
        const std::vector<Row> rows{
            {"5 ms, 6 decimals", printed(201, 0.005, 'f', 6), "s", 1e-6, true, false},
            {"30 Hz, 4 decimals", printed(61, frame, 'f', 4), "s", 1e-4, false, true},
            {"30 Hz, 9 digits, uneven in the last one", printed(61, frame, 'g', 9), "s", 1e-8, false, true},
            {"30 Hz in ms, 1 decimal", printed(61, 1e3 * frame, 'f', 1), "ms", 1e-4, false, true},
            {"40 Hz, 2 decimals", printed(101, 0.025, 'f', 2), "s", 1e-2, false, true},
            {"30 Hz, 2 decimals", printed(61, frame, 'f', 2), "s", 1e-2, false, true},
            {"30 Hz, 2 decimals, a gap", printed(30, frame, 'f', 2) + printed(30, frame, 'f', 2, 33 * frame), "s", 1e-2,
             false, true},
            {"72 Hz, 2 decimals, as if some were missing", printed(73, 1.0 / 72.0, 'f', 2), "s", 1e-2, false, true},
            {"whole seconds with a gap", printed(8, 1.0, 'f', 0) + printed(8, 1.0, 'f', 0, 10.0), "s", 1.0, true,
             false},
            {"30 Hz, all digits", printed(61, frame, 'g', 17), "s", 1e-18, true, false},
            {"5 ms, after a billion seconds", printed(201, 0.005, 'f', 3, 1e9), "s", 1e-3, true, false},
            {"a missing sample", {"0.00", "0.01", "0.02", "0.04", "0.05"}, "s", 1e-2, false, false},
            {"chosen", {"0", "0.1", "0.2", "0.3", "0.5", "0.7", "1", "1.5", "2", "3"}, "s", 0.1, false, false},
            {"two", {"0", "0.5"}, "s", 0.1, true, false},
            {"whole seconds", printed(20, 10.0, 'f', 0), "s", 1.0, true, false},
        };
        for (const Row &row : rows) {
            const QByteArray table = row.times.join(",12.5\n");
            const auto outcome = read(QByteArray("time [") + row.unit + "],R4_x\n" + table + ",12.5\n");
            const auto &data = std::get<ReferenceData>(outcome);
            const TimePrecision clock = timePrecisionOf(data.time, data.timeRounding);
            QVERIFY2(clock.isEven == row.even && clock.isRoundedGrid == row.rounded, row.name);
            QVERIFY2(std::abs(clock.printedStep - row.step) <= 1e-9 * row.step, row.name);
            QCOMPARE(clock.roundingStep(), clock.isEven ? 0.0 : clock.printedStep);
        }
        const TimePrecision none = timePrecisionOf({}, {});
        QVERIFY(none.isEven && none.printedStep == 0.0);
    }
};

const Suite<TestClock> suite("tst_clock");

} // namespace tst_clock

#include "tst_clock.moc"
