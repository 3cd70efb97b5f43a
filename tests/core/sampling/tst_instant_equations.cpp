// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/instant_equations.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace
{

constexpr double kStep = 0.005; // s, of the report's study

} // namespace

class TestInstantEquations : public QObject
{
    Q_OBJECT

private slots:
    void holdAtTheExactMotionAndAtNewtons()
    {
        // The closed form knows nothing of the constraints: that they hold there is evidence for both.
        const Mechanism mechanism;
        for (const Method method : {Method::ClosedForm, Method::Newton}) {
            for (const double t : {0.0, 0.2, 0.55, 0.9}) {
                const InstantEquations equations = equationsAt(mechanism, t, kStep, {method, {}});
                QVERIFY(equations.hasPosition());
                QVERIFY(equations.C.norm() <= 1e-12);
                QVERIFY((equations.Cq * equations.state.qDot + equations.Ct).norm() <= 1e-10);
                QVERIFY((equations.Cq * equations.state.qDDot - equations.Qd).norm() <= 1e-9);
                QVERIFY(equations.Qd.norm() > 1.0);
                QCOMPARE(equations.Ct[CrankDrive], -mechanism.omega2());
            }
        }
    }

    void showTheLastIterateWhereNewtonDoesNotConverge()
    {
        const InstantEquations equations = equationsAt(Mechanism(), 0.2, 0.05, {Method::Newton, {1, 1e-8}});
        QCOMPARE(equations.state.status, Status::IterationLimit);
        QVERIFY(equations.hasPosition());
        QVERIFY(equations.C.norm() > 1e-8);
        QVERIFY(equations.Qd.array().isNaN().all());
    }

    void areNothingWhereItCannotBeAssembled()
    {
        Parameters parameters;
        parameters.b = 40.0;
        for (const Method method : {Method::ClosedForm, Method::Newton}) {
            const InstantEquations equations = equationsAt(Mechanism(parameters), 0.75, kStep, {method, {}});
            QCOMPARE(equations.state.status, Status::NotAssemblable);
            QVERIFY(!equations.hasPosition());
            QVERIFY(equations.C.array().isNaN().all());
            QVERIFY(equations.Cq.array().isNaN().all());
        }
    }

    void conditionNumberIsTheRatioOfTheExtremeStretchings()
    {
        Matrix12 matrix = Matrix12::Zero();
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            matrix(i, (i + 5) % kCoordinateCount) = (i % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(i + 1);
        }
        QVERIFY(std::abs(conditionNumber(matrix) - 12.0) <= 1e-12);
        QVERIFY(std::abs(conditionNumber(1e-9 * matrix) - 12.0) <= 1e-12);
        matrix.row(4).setZero();
        QVERIFY(std::isinf(conditionNumber(matrix)));
    }

    void conditionNumberGrowsTowardsAToggle()
    {
        double before = 0.0;
        for (const double b : {45.1, 45.001, 45.00001, 45.0000001}) {
            Parameters parameters;
            parameters.b = b;
            // The crank points down: the coupler is at its steepest.
            const InstantEquations equations = equationsAt(Mechanism(parameters), 0.75, kStep, {});
            const double condition = conditionNumber(equations.Cq);
            QVERIFY2(condition > before, qPrintable(QString("b = %1: %2").arg(b).arg(condition)));
            before = condition;
        }
    }
};

QTEST_APPLESS_MAIN(TestInstantEquations)
#include "tst_instant_equations.moc"
