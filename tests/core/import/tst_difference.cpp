// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace tst_difference
{

class TestDifference : public QObject
{
    Q_OBJECT

private slots:
    void recognizesDifferenceQuotients()
    {
        struct Row {
            const char *name;
            int from;     // first row of the difference quotient, relative to the row of its value
            int to;       // last row; if it equals `from`, the value is the derivative
            int decimals; // of the positions
            std::optional<Difference> expected;
        };
        const std::vector<Row> rows{{"forward", 0, 1, 3, Difference::Forward},
                                    {"backward", -1, 0, 3, Difference::Backward},
                                    {"central", -1, 1, 3, Difference::Central},
                                    {"central, many digits", -1, 1, 9, Difference::Central},
                                    {"the derivative", 0, 0, 9, {}},
                                    {"the derivative next to few digits", 0, 0, 1, {}}};
        for (const auto &[name, from, to, decimals, expected] : rows) {
            constexpr double kStep = 0.01;
            const auto position = [digits = decimals](int row) {
                return QByteArray::number(50.0 * std::cos(7.0 * kStep * row), 'f', digits);
            };
            QByteArray bytes = "time,R4_x,R4_x_diff,theta2,theta2_diff\n";
            for (int row = 0; row < 60; ++row) {
                const double change = position(row + to).toDouble() - position(row + from).toDouble();
                const double speed = from == to ? -350.0 * std::sin(7.0 * kStep * row) : change / (kStep * (to - from));
                bytes += QByteArray::number(kStep * row) + ',' + position(row) + ',' +
                         QByteArray::number(speed, 'f', 6) + ',' + QByteArray::number(30.0 * row) + ",3000\n";
            }
            const auto outcome = read(bytes);
            const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
            QVERIFY2(columns[2].difference == expected, name);
            QVERIFY2(!columns[1].difference && !columns[4].difference, name); // a constant speed
        }
    }
};

const Suite<TestDifference> suite("tst_difference");

} // namespace tst_difference

#include "tst_difference.moc"
