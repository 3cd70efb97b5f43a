// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/crank_angles.h"

#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_crank_angles
{

class TestCrankAngles : public QObject
{
    Q_OBJECT

private slots:
    void readsATableByCrankAngleIfThereIsNoTime()
    {
        struct Row {
            QByteArray bytes;
            const char *roles;
            const char *degrees;
        };
        const auto over = [](const char *heading) { return QByteArray(heading) + ",R4_x\n0,3\n15,4\n30,5\n"; };
        const std::vector<Row> rows{
            {over("Crank angle (deg)"), "angle R4_x", " 0 15 30"},
            {over("θ₂ [°]"), "angle R4_x", " 0 15 30"},
            {over("Ángulo de la manivela (grados)"), "angle R4_x", " 0 15 30"},
            {over("°CA"), "angle R4_x", " 0 15 30"},
            {"R4_x,CAD\n3,0\n4,15\n5,30\n", "R4_x angle", " 0 15 30"},
            {"theta2 (rad),R4_x\n0,3\n3.141592653589793,4\n6.283185307179586,5\n", "angle R4_x", " 0 180 360"},
            {"theta2 (rad),R4_x\n0,3\n0.262,4\n0.524,5\n", "angle R4_x", " 0 15 30"},
            {"theta2 (rad),R4_x\n-0.1309,3\n0,4\n0.1309,5\n", "angle R4_x", " -7.5 0 7.5"},
            {"theta2,R4_x\n0,3\n14.99,4\n30.01,5\n", "angle R4_x", " 0 14.99 30.01"},
            {"theta2,R4_x\n350,3\n359,4\n0,5\n1,5\n", "angle R4_x", " 350 359 360 361"},
            {"theta2,R4_x\n170,3\n180,4\n-170,5\n", "angle R4_x", " 170 180 190"},
            {"theta2,R4_x\n10,5\n0,4\n350,3\n", "angle R4_x", " -10 0 10"},
            {"theta2,R4_x,t\n0,3,0\n15,4,1\n30,5,2\n", "theta2 R4_x time", ""},
            {"clock,theta2,R4_x\n0,0,3\n0.5,15,4\n1,30,5\n", "time? theta2 R4_x", ""},
            {"stage,theta2,R4_x\n1,0,3\n2,15,4\n3,30,5\n", "- angle R4_x", " 0 15 30"}, // a count of the rows
        };
        for (const Row &row : rows) {
            const Outcome outcome = read(row.bytes);
            const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data, described(outcome).c_str());
            QCOMPARE(rolesOf(data->layout), std::string(row.roles));
            QCOMPARE(data->crank ? described(data->crank->degrees) : std::string(), std::string(row.degrees));
        }
    }

    void computesTheTimeStampsForADrive()
    {
        struct Row {
            const char *name;
            double omega2;
            double theta20;
            const char *expected;
        };
        const double turn = 2.0 * std::numbers::pi;
        const std::vector<Row> rows{
            {"one turn per second", turn, 0.0, "time 0 0.25 1; R4_x 3 4 5"},
            {"two turns per second", 2.0 * turn, 0.0, "time 0 0.125 0.5; R4_x 3 4 5"},
            {"starting at 90 degrees", turn, 0.25 * turn, "time -0.25 0 0.75; R4_x 3 4 5"},
            {"in the other direction", -turn, 0.0, "time -1 -0.25 -0; R4_x 5 4 3"},
            {"standing still", 0.0, 0.0, "none"},
            {"too slow for doubles", 1e-320, 0.0, "none"},
        };
        const ReferenceData data = std::get<ReferenceData>(read("theta2,R4_x\n0,3\n90,4\n360,5\n"));
        for (const auto &[name, omega2, theta20, expected] : rows) {
            Parameters parameters;
            parameters.omega2 = omega2;
            parameters.theta20 = theta20;
            const std::optional<ReferenceData> timed = timedBy(Mechanism(parameters), data);
            QVERIFY2((timed ? described(*timed) : "none") == expected, name);
            if (!timed) {
                continue;
            }
            QCOMPARE(described(*timedBy(Mechanism(), *timed)), described(data)); // only the last drive counts
            const double step = 1.0 / (kDegreesPerRadian * std::abs(omega2));    // the duration of a degree
            QVERIFY2(std::abs(timed->timeRounding.finestStep() - step) < 1e-12 * step, name);
        }
    }
};

const Suite<TestCrankAngles> suite("tst_crank_angles");

} // namespace tst_crank_angles

#include "tst_crank_angles.moc"
