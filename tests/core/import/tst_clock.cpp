// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"
#include "core/import/reference_data.h"
#include "tests/support/suite.h"

#include <QByteArray>
#include <QTest>

#include <cmath>
#include <variant>

using namespace slidercrank;

namespace
{

/// A file whose instants are those texts.
ReferenceData fileWith(const QByteArrayList &instants, const QByteArray &unit)
{
    QByteArray bytes = "time [" + unit + "],R4_x\n";
    for (const QByteArray &instant : instants) {
        bytes += instant + ",12.5\n";
    }
    auto outcome = readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? std::move(*data) : ReferenceData();
}

QByteArrayList printed(int count, double step, char format, int digits, double start = 0.0)
{
    QByteArrayList texts;
    for (int i = 0; i < count; ++i) {
        texts << QByteArray::number(start + step * i, format, digits);
    }
    return texts;
}

} // namespace

class TestClock : public QObject
{
    Q_OBJECT

private slots:
    void tellsWhatTheInstantsAreWorth_data()
    {
        QTest::addColumn<QByteArrayList>("instants");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<double>("step");
        QTest::addColumn<bool>("even");
        QTest::addColumn<bool>("rounded");
        QTest::newRow("5 ms with 6 decimals")
            << printed(201, 0.005, 'f', 6) << QByteArray("s") << 1e-6 << true << false;
        QTest::newRow("30 a second with 4 decimals")
            << printed(61, 1.0 / 30.0, 'f', 4) << QByteArray("s") << 1e-4 << false << true;
        QTest::newRow("30 a second with 9 digits, uneven in the last")
            << printed(61, 1.0 / 30.0, 'g', 9) << QByteArray("s") << 1e-8 << false << true;
        QTest::newRow("30 a second in ms with 1 decimal")
            << printed(61, 1000.0 / 30.0, 'f', 1) << QByteArray("ms") << 1e-4 << false << true;
        QTest::newRow("30 a second with all digits")
            << printed(61, 1.0 / 30.0, 'g', 17) << QByteArray("s") << 1e-18 << true << false;
        QTest::newRow("5 ms, a billion seconds after the start")
            << printed(201, 0.005, 'f', 3, 1e9) << QByteArray("s") << 1e-3 << true << false;
        QTest::newRow("a sample left out")
            << QByteArrayList{"0.00", "0.01", "0.02", "0.04", "0.05"} << QByteArray("s") << 1e-2 << false << false;
        QTest::newRow("chosen instants") << QByteArrayList{"0", "0.1", "0.2", "0.3", "0.5", "0.7",
                                                           "1", "1.5", "2",   "3",   "4"}
                                         << QByteArray("s") << 0.1 << false << false;
        QTest::newRow("two instants") << QByteArrayList{"0", "0.5"} << QByteArray("s") << 0.1 << true << false;
        QTest::newRow("whole seconds") << printed(20, 10.0, 'f', 0) << QByteArray("s") << 1.0 << true << false;
    }

    void tellsWhatTheInstantsAreWorth()
    {
        QFETCH(const QByteArrayList, instants);
        QFETCH(const QByteArray, unit);
        const ReferenceData data = fileWith(instants, unit);
        QCOMPARE(data.time.size(), static_cast<std::size_t>(instants.size()));
        const Clock clock = clockOf(data);
        QTEST(clock.even, "even");
        QTEST(clock.rounded, "rounded");
        QFETCH(const double, step);
        QVERIFY2(std::abs(clock.printedStep - step) <= 1e-9 * step,
                 qPrintable(QString::number(clock.printedStep, 'g', 17)));
        QCOMPARE(clock.step(), clock.even ? 0.0 : clock.printedStep);
    }

    void nothingIsEven()
    {
        const Clock clock = clockOf(ReferenceData());
        QVERIFY(clock.even && clock.printedStep == 0.0);
    }
};

const Suite suite("tst_clock", runWithoutApplication<TestClock>);
#include "tst_clock.moc"
