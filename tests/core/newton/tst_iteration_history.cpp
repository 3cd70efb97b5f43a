// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"
#include "core/newton/constraints.h"
#include "core/newton/iteration_history.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

class TestIterationHistory : public QObject
{
    Q_OBJECT

private slots:
    void eachResidualIsThatOfItsCoordinates()
    {
        const Mechanism mechanism;
        for (const double t : {0.0, 0.13, 0.25, 0.77}) {
            const IterationHistory history = iterationsFromAfar(mechanism, t);
            QVERIFY(history.iterations.size() > 3);
            for (const Iteration &iteration : history.iterations) {
                const double residual = constraints(mechanism, iteration.q, t).norm();
                QVERIFY2(std::abs(residual - iteration.residual) <= 1e-13,
                         qPrintable(QString("t = %1: %2, not %3").arg(t).arg(iteration.residual).arg(residual)));
            }
        }
    }

    void endsWhereTheSolverEnds()
    {
        const Mechanism mechanism;
        const double t = 0.4;
        const IterationHistory fromAfar = iterationsFromAfar(mechanism, t);
        const NewtonResult assembled = assemble(mechanism, t);
        QCOMPARE(fromAfar.status, Status::Solved);
        QVERIFY(fromAfar.startedAfar);
        QVERIFY(fromAfar.iterations.front().q == farStart(mechanism, t));
        QVERIFY(fromAfar.iterations.back().q == assembled.q);
        QCOMPARE(static_cast<int>(fromAfar.iterations.size()), assembled.iterations + 1);

        const Vector12 before = assemble(mechanism, t - 0.005).q;
        const IterationHistory fromBefore = iterationsFrom(mechanism, t, before);
        QVERIFY(!fromBefore.startedAfar);
        QVERIFY(fromBefore.iterations.front().q == before);
        QVERIFY(fromBefore.iterations.back().q == track(mechanism, t, before).q);
        QCOMPARE(static_cast<int>(fromBefore.iterations.size()), track(mechanism, t, before).iterations + 1);
    }

    void eachIterationSquaresTheErrorOfTheCouplersAngle()
    {
        // Newton's law for sin θ3 = h/b: the next error is tan(θ3)/2 times the square of this one.
        const Mechanism mechanism;
        const double t = 0.75; // the coupler at its steepest
        const double exact = ClosedForm(mechanism).motionAt(t).theta3;
        const IterationHistory history = iterationsFromAfar(mechanism, t);
        int judged = 0;
        for (std::size_t k = 0; k + 1 < history.iterations.size(); ++k) {
            const double error = std::abs(history.iterations[k].q[Theta3] - exact);
            const double next = std::abs(history.iterations[k + 1].q[Theta3] - exact);
            if (error < 0.01 && next > 1e-13) {
                const double factor = next / (error * error);
                const double expected = 0.5 * std::abs(std::tan(exact));
                QVERIFY2(std::abs(factor - expected) <= 0.05 * expected,
                         qPrintable(QString("step %1: %2, not %3").arg(k).arg(factor).arg(expected)));
                ++judged;
            }
        }
        QVERIFY(judged >= 2);
    }

    void aWayThatLeavesTheBranchIsTheOneFromAfar()
    {
        const Mechanism mechanism;
        Vector12 crossed = farStart(mechanism, 0.1);
        crossed[Theta3] = 3.0;
        const IterationHistory history = iterationsFrom(mechanism, 0.1, crossed);
        QVERIFY(history.startedAfar);
        QVERIFY(history.iterations.front().q == farStart(mechanism, 0.1));
        QCOMPARE(history.status, Status::Solved);
    }

    void thereIsNothingWhereItCannotBeAssembled()
    {
        Parameters parameters;
        parameters.b = 40.0;
        const Mechanism rocker(parameters);
        const IterationHistory history = iterationsFromAfar(rocker, 0.75); // the crank points down
        QCOMPARE(history.status, Status::NotAssemblable);
        QVERIFY(history.iterations.empty());
    }
};

QTEST_APPLESS_MAIN(TestIterationHistory)
#include "tst_iteration_history.moc"
