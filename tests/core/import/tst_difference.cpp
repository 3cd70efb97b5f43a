// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

class TestDifference : public QObject
{
    Q_OBJECT

private slots:
    void knowsDifferencesForWhatTheyAre_data()
    {
        QTest::addColumn<int>("from"); // rows
        QTest::addColumn<int>("to");
        QTest::addColumn<int>("decimals"); // of the positions
        QTest::addColumn<std::optional<Difference>>("kind");
        using Kind = std::optional<Difference>;
        QTest::newRow("forward") << 0 << 1 << 3 << Kind(Difference::Forward);
        QTest::newRow("backward") << -1 << 0 << 3 << Kind(Difference::Backward);
        QTest::newRow("central") << -1 << 1 << 3 << Kind(Difference::Central);
        QTest::newRow("central, of many digits") << -1 << 1 << 9 << Kind(Difference::Central);
        QTest::newRow("the derivative") << 0 << 0 << 9 << Kind();
        QTest::newRow("the derivative beside few digits") << 0 << 0 << 1 << Kind();
    }

    void knowsDifferencesForWhatTheyAre()
    {
        QFETCH(const int, from);
        QFETCH(const int, to);
        QFETCH(const int, decimals);
        using Found = std::optional<Difference>;
        QFETCH(const Found, kind);
        constexpr double kStep = 0.01;
        const auto position = [&](int row) {
            const QByteArray text = QByteArray::number(50.0 * std::cos(7.0 * kStep * row), 'f', decimals);
            return text.toDouble();
        };
        QByteArray bytes = "time,R4_x,R4_x_diff,theta2,theta2_diff\n";
        for (int row = 0; row < 60; ++row) {
            const double speed = from == to ? -350.0 * std::sin(7.0 * kStep * row)
                                            : (position(row + to) - position(row + from)) / (kStep * (to - from));
            bytes += QByteArray::number(kStep * row) + ',' + QByteArray::number(position(row), 'f', decimals) + ',' +
                     QByteArray::number(speed, 'f', 6) + ',' + QByteArray::number(30.0 * row) + ",3000\n";
        }
        const auto outcome = read(bytes);
        const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
        QVERIFY(columns[2].difference == kind);
        QVERIFY(!columns[1].difference && !columns[4].difference); // of an even motion they are the derivative
    }
};

const Suite suite("tst_difference", runWithoutApplication<TestDifference>);
#include "tst_difference.moc"
