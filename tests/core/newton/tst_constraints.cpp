// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/constraints.h"
#include "core/sampling/time_step_equations.h"
#include "core/study/cases.h"
#include "tests/core/newton/newton_runs.h"
#include "tests/support/mechanism_list.h"
#include "tests/support/suite.h"

#include <QTest>

#include <Eigen/LU>

using namespace slidercrank;

namespace tst_constraints
{

/// Returns the units of the rows' tolerances: a + b + |c| for lengths, 1 rad for angles.
Vector12 rowUnits(const Parameters &p)
{
    Vector12 units = Vector12::Constant(characteristicLength(p));
    units[GroundAngle] = units[SliderAngle] = units[CrankDrive] = 1.0;
    return units;
}

double coordinateUnit(const Parameters &p, Eigen::Index column)
{
    return isAngle(static_cast<Coordinate>(column)) ? 1.0 : characteristicLength(p);
}

/// Returns random coordinates: lengths of the order of the mechanism's size, angles within about one turn.
Vector12 randomCoordinates(const Parameters &p, RandomMechanisms &random)
{
    Vector12 q;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        q[i] = coordinateUnit(p, i) * random.uniform(-5.0, 5.0);
    }
    return q;
}

/// Returns whether every entry of `error` is at most that of the tolerance.
bool isWithin(const Eigen::MatrixXd &error, const Eigen::MatrixXd &tolerance)
{
    return (error.cwiseAbs().array() <= tolerance.array()).all();
}

/// Step and tolerance of central differences: the truncation error h²/6 and the rounding error u/h are both below 1e-9.
constexpr double kStep = 1e-5;
constexpr double kDifferenceTolerance = 1e-9;

Vector12 coordinates(const ExactState &exact, Order order)
{
    Vector12 result;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        result[i] = static_cast<double>(exact.values[indexOf({static_cast<Coordinate>(i), order})]);
    }
    return result;
}

class TestConstraints : public QObject
{
    Q_OBJECT

private slots:
    /// Changing one coordinate violates exactly the constraints that contain it, by the amount of the change.
    void rowsMatchTheirNames()
    {
        const Parameters p;
        const Mechanism mechanism(p);
        const Vector12 q = coordinates(exactState(p, 0.2), Order::Position);
        struct Row {
            Coordinate pushed;
            std::vector<std::pair<Constraint, double>> broken;
        };
        const Row rows[] = {
            {R1x, {{GroundX, 1.0}}},
            {R1y, {{GroundY, 1.0}}},
            {Theta1, {{GroundAngle, 1.0}, {SliderAngle, -1.0}}},
            {R2x, {{CrankPivotX, 1.0}, {CrankPinX, 1.0}}},
            {R2y, {{CrankPivotY, 1.0}, {CrankPinY, 1.0}}},
            {R3x, {{CrankPinX, -1.0}, {SliderPinX, -1.0}}},
            {R3y, {{CrankPinY, -1.0}, {SliderPinY, -1.0}}},
            {R4x, {{SliderPinX, 1.0}}},
            {R4y, {{SliderPinY, 1.0}, {SliderLine, 1.0}}},
            {Theta4, {{SliderAngle, 1.0}}},
        };
        constexpr double kPush = 0.5;
        constexpr double kTolerance = 1e-13; // mm or rad, a few rounding errors of 100 mm
        for (const Row &row : rows) {
            Vector12 pushed = q;
            pushed[row.pushed] += kPush;
            Vector12 expected = Vector12::Zero();
            for (const auto &[constraint, sign] : row.broken) {
                expected[constraint] = sign * kPush;
            }
            const Vector12 C = constraints(mechanism, pushed, 0.2);
            QVERIFY2((C - expected).cwiseAbs().maxCoeff() < kTolerance, std::string(nameOf({row.pushed, {}})).c_str());
        }
    }

    /// C = 0, C_q q̇ = -C_t and C_q q̈ = Q_d on the exact motion of random mechanisms, within a few rounding errors of
    /// the terms of each row.
    void vanishOnTheExactMotion()
    {
        constexpr double kRoundings = 16.0;
        RandomMechanisms random(12);
        for (int i = 0; i < 300; ++i) {
            const Parameters p = random.next();
            const Mechanism mechanism(p);
            const double t = random.uniform(0.0, 2.0 * std::numbers::pi / std::abs(p.omega2));
            const ExactState exact = exactState(p, t);
            const Vector12 q = coordinates(exact, Order::Position);
            const Vector12 qDot = coordinates(exact, Order::Velocity);
            const Vector12 qDDot = coordinates(exact, Order::Acceleration);
            const Matrix12 Cq = constraintJacobian(mechanism, q);
            const Vector12 C = constraints(mechanism, q, t);
            const Vector12 velocity = Cq * qDot + constraintTimeDerivative(mechanism);
            const Vector12 Qd = quadraticVelocityTerm(mechanism, q, qDot);
            const Vector12 acceleration = Cq * qDDot - Qd;
            // A relative error u of θ2 or θ3 changes each C by u θ ∂C/∂θ, and likewise the derivatives of C.
            const double angleSize = 1.0 + std::abs(q[Theta2]) + std::abs(q[Theta3]);
            const double lengths = characteristicLength(p);
            const double speeds = std::abs(p.omega2) + std::abs(qDot[Theta3]);
            const double accelerations = std::abs(qDDot[Theta3]) + speeds * speeds;
            const Vector12 positionSizes = rowUnits(p) * angleSize;
            const Vector12 velocitySizes = (Cq.cwiseAbs() * qDot.cwiseAbs()).array() + lengths * speeds * angleSize;
            const Vector12 accelerationSizes =
                (Cq.cwiseAbs() * qDDot.cwiseAbs() + Qd.cwiseAbs()).array() + lengths * accelerations * angleSize;
            const double unit = kRoundings * kUnitRoundoff;
            QVERIFY2(isWithin(C, unit * positionSizes), describe(p).c_str());
            QVERIFY2(isWithin(velocity, unit * velocitySizes), describe(p).c_str());
            QVERIFY2(isWithin(acceleration, unit * accelerationSizes), describe(p).c_str());
        }
    }

    void theDeterminantIsThatOfTheJacobian()
    {
        const TimeStepEquations equations = equationsAt(Mechanism({.branch = Branch::Crossed}), 0.3, 0.005, {});
        QVERIFY(std::abs(equations.determinant - equations.Cq.determinant()) <= 1e-11);
    }

    void jacobianIsTheDerivative()
    {
        for (const auto &[name, parameters] : mechanismList(40, 11)) {
            const Mechanism mechanism(parameters);
            RandomMechanisms random(13);
            for (int pose = 0; pose < 4; ++pose) {
                const Vector12 q = randomCoordinates(parameters, random);
                const Matrix12 Cq = constraintJacobian(mechanism, q);
                Matrix12 expected;
                Matrix12 tolerance;
                for (Eigen::Index column = 0; column < kCoordinateCount; ++column) {
                    const double unit = coordinateUnit(parameters, column);
                    Vector12 more = q;
                    Vector12 less = q;
                    more[column] += kStep * unit;
                    less[column] -= kStep * unit;
                    // t = 0, because C_q does not depend on t and a large ω2 t would hide the difference.
                    expected.col(column) = (constraints(mechanism, more, 0.0) - constraints(mechanism, less, 0.0)) /
                                           (more[column] - less[column]);
                    tolerance.col(column) = kDifferenceTolerance / unit * rowUnits(parameters);
                }
                QVERIFY2(isWithin(Cq - expected, tolerance), describe(parameters).c_str());
            }
        }
    }
};

const Suite<TestConstraints> suite("tst_constraints");

} // namespace tst_constraints

#include "tst_constraints.moc"
