// SPDX-License-Identifier: GPL-3.0-or-later

// The rungs of Newton-Raphson beside the report's: the same iteration joint by joint, the Taylor start, the relative
// tolerance.

#include "core/closed_form/closed_form.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"
#include "core/newton/structured_system.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <QTest>

#include <algorithm>
#include <array>

Q_DECLARE_METATYPE(slidercrank::Case)

using namespace slidercrank;

namespace
{

constexpr double kReportTolerance = 1e-8;

using LongVector = Eigen::Matrix<long double, kCoordinateCount, 1>;

NewtonOptions options(Elimination elimination, WarmStart warmStart = WarmStart::Previous,
                      double tolerance = kReportTolerance, ToleranceKind kind = ToleranceKind::Absolute)
{
    return {tolerance == 0.0 ? 50 : 10, tolerance, kind, warmStart, elimination};
}

std::vector<NewtonInstant> run(const Parameters &parameters, const std::vector<double> &instants,
                               const NewtonOptions &wanted)
{
    const Mechanism mechanism(parameters);
    std::vector<NewtonInstant> done;
    NewtonInstant last;
    for (const double t : instants) {
        last = solveInstant(mechanism, t, last, wanted);
        done.push_back(last);
    }
    return done;
}

int iterationsOf(const std::vector<NewtonInstant> &done)
{
    int sum = 0;
    for (const NewtonInstant &instant : done) {
        sum += instant.iterations;
    }
    return sum;
}

QString named(const Case &which)
{
    return QString::fromUtf8(which.name.data(), qsizetype(which.name.size()));
}

QString at(const Case &which, const NewtonInstant &instant)
{
    return QStringLiteral("%1 at t=%2: status %3 after %4 iterations, residual %5, theta3 %6")
        .arg(named(which))
        .arg(instant.t, 0, 'g', 17)
        .arg(int(instant.state.status))
        .arg(instant.iterations)
        .arg(instant.residual)
        .arg(instant.q[Theta3], 0, 'g', 17);
}

void addCases(const std::vector<Case> &cases)
{
    QTest::addColumn<Case>("which");
    for (const Case &which : cases) {
        QTest::newRow(std::string(which.name).c_str()) << which;
    }
}

} // namespace

class tst_structured_newton : public QObject
{
    Q_OBJECT

private slots:
    void constraintsAreTheSameToTheLastBit();
    void turnedConstraintsAreTheSameToRounding();
    void makesTheDenseStepToRounding_data() { addCases(allCases()); }
    void makesTheDenseStepToRounding();
    void needsAsManyIterationsAsDense_data() { addCases(allCases()); }
    void needsAsManyIterationsAsDense();
    void needsOneIterationFromATaylorStart();
    void relativeIterationsAreTheSameAtEveryScale();
    void relativeIterationsAreTheSameAtEveryTime();
    void errorIsWithinTwiceConditioning_data() { addCases(allCases()); }
    void errorIsWithinTwiceConditioning();
    void velocityAndAccelerationSolveTheirSystems();
    void everyWayToSolveStopsWithinItsTolerance_data() { addCases(allCases()); }
    void everyWayToSolveStopsWithinItsTolerance();
};

void tst_structured_newton::constraintsAreTheSameToTheLastBit()
{
    RandomMechanisms random(31);
    for (int i = 0; i < 1000; ++i) {
        const Mechanism mechanism(random.next());
        const double t = random.uniform(-10.0, 10.0);
        Vector12 q;
        for (double &coordinate : q) {
            coordinate = random.uniform(-100.0, 100.0);
        }
        StructuredSystem system(mechanism, t);
        system.moveTo(StructuredSystem::coordinatesOf(q));
        const Vector12 C = constraints(mechanism, q, t);
        QVERIFY(system.constraints() == C);
        QVERIFY(std::abs(system.residual(1.0) - C.norm()) <= 8.0 * kUnitRoundoff * C.norm());
    }
}

/// Where sin θ3 and cos θ3 are turned from those of a θ3 close by, they are off by two roundings at most, and the rows
/// by b/2 times that and the roundings of their sums. The step from there is the one from a q moved to.
void tst_structured_newton::turnedConstraintsAreTheSameToRounding()
{
    RandomMechanisms random(32);
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const Parameters parameters = random.next();
        const Mechanism mechanism(parameters);
        const double t = random.uniform(-10.0, 10.0);
        Vector12 q;
        for (double &coordinate : q) {
            coordinate = random.uniform(-100.0, 100.0);
        }
        q[Theta3] = random.uniform(-5.0, 5.0);
        for (const double turn : {0x1.1p-11, 0x1.ffp-12, -0x1.ffp-12, 1e-4, -3e-6, 1e-9, -1e-13, 0.0}) {
            Vector12 near = q;
            near[Theta3] += turn;
            const StructuredSystem::Coordinates there = StructuredSystem::coordinatesOf(near);
            StructuredSystem turned(mechanism, t);
            turned.moveTo(StructuredSystem::coordinatesOf(q));
            turned.turnTo(there);
            StructuredSystem moved(mechanism, t);
            moved.moveTo(there);
            const double difference = (turned.constraints() - moved.constraints()).cwiseAbs().maxCoeff();
            const double sums = 400.0 + parameters.a + parameters.b; // mm, what a row's partial sums reach
            const double rounding = kUnitRoundoff * (2.0 * 0.5 * parameters.b + 4.0 * sums);
            worst = std::max(worst, difference / rounding);
            QVERIFY2(difference <= rounding, qPrintable(QStringLiteral("turn %1: %2").arg(turn).arg(difference)));
            Vector12 fromTurned;
            Vector12 fromMoved;
            StructuredSystem::write(turned.next(there), fromTurned);
            StructuredSystem::write(moved.next(there), fromMoved);
            QVERIFY(fromTurned == fromMoved);
        }
    }
    qInfo("at most %.3g of the bound", worst);
}

/// From each iterate of the dense way, both make a step: ‖difference‖ ≤ u (κ ‖Δq‖ + ‖q‖), with the 2-norm of the twelve
/// numbers (mm and rad mixed) and κ the ratio of the extreme singular values of C_q. The dense step is added in more
/// digits, so that ‖q‖ stands for the rounding of one iterate.
void tst_structured_newton::makesTheDenseStepToRounding()
{
    QFETCH(Case, which);
    const Mechanism mechanism(which.parameters);
    double worst = 0.0;
    for (const double t : instantsOf(which)) {
        const NewtonResult answer = assemble(mechanism, t);
        if (answer.status == Status::NotAssemblable) {
            continue;
        }
        // Four steps on the way from the coupler halfway between the middle of its branch and the answer.
        Vector12 q = answer.q;
        q[Theta3] = 0.5 * (q[Theta3] + (which.parameters.branch == Branch::Open ? 0.0 : std::numbers::pi));
        StructuredSystem system(mechanism, t);
        for (int k = 0; k < 4; ++k) {
            const Matrix12 Cq = constraintJacobian(mechanism, q);
            const Vector12 step = Cq.partialPivLu().solve(-constraints(mechanism, q, t));
            system.moveTo(StructuredSystem::coordinatesOf(q));
            Vector12 next;
            StructuredSystem::write(system.next(StructuredSystem::coordinatesOf(q)), next);
            const LongVector difference = next.cast<long double>() - (q.cast<long double>() + step.cast<long double>());
            const Eigen::JacobiSVD<Matrix12> svd(Cq);
            const double kappa = svd.singularValues()[0] / svd.singularValues()[11];
            if (!(kappa < 0.1 / kUnitRoundoff)) {
                break; // no digit of the step means anything
            }
            const double ratio =
                static_cast<double>(difference.norm()) / (kUnitRoundoff * (kappa * step.norm() + q.norm()));
            worst = std::max(worst, ratio);
            QVERIFY2(ratio <= 1.0, qPrintable(QStringLiteral("t=%1, step %2: %3 times the bound, kappa %4")
                                                  .arg(t, 0, 'g', 17)
                                                  .arg(k)
                                                  .arg(ratio)
                                                  .arg(kappa)));
            q += step;
        }
    }
    qInfo("at most %.3g of the bound", worst);
}

/// But where rounding decides: at a change point's one singular instant the matrix is singular at the answer itself,
/// and lengths of 1e10 mm never satisfy an absolute tolerance of 1e-8 but by chance.
void tst_structured_newton::needsAsManyIterationsAsDense()
{
    QFETCH(Case, which);
    const std::vector<double> instants = instantsOf(which);
    const int mayDiffer = which.name.starts_with("change point") ? 1 : 0;
    for (const ToleranceKind kind : {ToleranceKind::Absolute, ToleranceKind::Relative}) {
        if (kind == ToleranceKind::Absolute && which.name == "lengths x 1e9") {
            continue;
        }
        for (const WarmStart start : {WarmStart::Previous, WarmStart::Taylor}) {
            for (const double tolerance : {1e-4, kReportTolerance}) {
                const std::vector<NewtonInstant> dense =
                    run(which.parameters, instants, options(Elimination::Dense, start, tolerance, kind));
                const std::vector<NewtonInstant> structured =
                    run(which.parameters, instants, options(Elimination::Structured, start, tolerance, kind));
                int different = 0;
                for (std::size_t i = 0; i < instants.size(); ++i) {
                    const bool same = dense[i].iterations == structured[i].iterations &&
                                      dense[i].positionStatus == structured[i].positionStatus;
                    different += same ? 0 : 1;
                    QVERIFY2(different <= mayDiffer, qPrintable(at(which, structured[i]) +
                                                                QStringLiteral("\n    dense: ") + at(which, dense[i])));
                }
            }
        }
    }
}

/// Measured elsewhere for the same study: 1.0.
void tst_structured_newton::needsOneIterationFromATaylorStart()
{
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const double b : {60.0, 65.0}) {
            Parameters p;
            p.b = b;
            const std::vector<NewtonInstant> done =
                run(p, Sampling{}.instants(), options(elimination, WarmStart::Taylor));
            for (std::size_t i = 1; i < done.size(); ++i) {
                QCOMPARE(done[i].state.status, Status::Solved);
                QVERIFY(!done[i].startedAfar);
                QVERIFY(done[i].residual <= kReportTolerance);
            }
            const double mean = double(iterationsOf(done) - done[0].iterations) / double(done.size() - 1);
            qInfo("b = %g: %.3g iterations a state", b, mean);
            QCOMPARE(mean, 1.0);
        }
    }
}

void tst_structured_newton::relativeIterationsAreTheSameAtEveryScale()
{
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const WarmStart start : {WarmStart::Previous, WarmStart::Taylor}) {
            for (const double gap : {1.0 / 3.0, 1e-2, 1e-4}) {
                const Parameters unit{20.0, 45.0 * (1.0 + gap), 25.0, 2.0 * std::numbers::pi, 0.0, Branch::Open};
                const NewtonOptions wanted = options(elimination, start, 1e-10, ToleranceKind::Relative);
                const std::vector<NewtonInstant> expected = run(unit, Sampling{}.instants(), wanted);
                for (const double factor : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
                    Parameters p = unit;
                    p.a *= factor;
                    p.b *= factor;
                    p.c *= factor;
                    const std::vector<NewtonInstant> done = run(p, Sampling{}.instants(), wanted);
                    for (std::size_t i = 0; i < done.size(); ++i) {
                        const QString where =
                            QStringLiteral("gap %1 factor %2 t=%3: %4 iterations, status %5, residual %6")
                                .arg(gap)
                                .arg(factor)
                                .arg(done[i].t)
                                .arg(done[i].iterations)
                                .arg(int(done[i].state.status))
                                .arg(done[i].residual);
                        QVERIFY2(done[i].iterations == expected[i].iterations, qPrintable(where));
                        QVERIFY2(done[i].state.status == expected[i].state.status, qPrintable(where));
                    }
                }
            }
        }
    }
}

void tst_structured_newton::relativeIterationsAreTheSameAtEveryTime()
{
    Parameters p;
    p.omega2 = 6.25; // exact in few bits, and a period of the sampling: the same crank angles to rounding at any time
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const WarmStart start : {WarmStart::Previous, WarmStart::Taylor}) {
            const NewtonOptions wanted = options(elimination, start, 1e-10, ToleranceKind::Relative);
            const double turn = 2.0 * std::numbers::pi / p.omega2;
            const std::vector<NewtonInstant> early = run(p, Sampling{0.0, turn, 200}.instants(), wanted);
            const double late = std::round(1e9 / turn) * turn;
            const std::vector<NewtonInstant> lateRun = run(p, Sampling{late, turn, 200}.instants(), wanted);
            for (std::size_t i = 0; i < early.size(); ++i) {
                QCOMPARE(lateRun[i].state.status, Status::Solved);
                QVERIFY(lateRun[i].residual <= 1e-10);
                QCOMPARE(lateRun[i].iterations, early[i].iterations);
            }
        }
    }
}

/// Solved with tolerance 0, each channel at each instant is off by 2 u (|f| + κ) at most, κ = Σ |p ∂f/∂p|. Judged are
/// the instants where it is hard, and every other one of the run.
void tst_structured_newton::errorIsWithinTwiceConditioning()
{
    QFETCH(Case, which);
    const Parameters &p = which.parameters;
    const std::vector<double> instants = instantsOf(which);
    const std::array runs{run(p, instants, options(Elimination::Structured, WarmStart::Previous, 0.0)),
                          run(p, instants, options(Elimination::Structured, WarmStart::Taylor, 0.0))};
    Deviation worst;
    int values = 0;
    const auto judge = [&]<class Real>(std::size_t i, const ExactState<Real> &exact) {
        if (exact.status != Status::Solved) {
            return;
        }
        std::array<double, kChannelCount> tolerances = conditioning<Real>(p, instants[i]);
        for (std::size_t k = 0; k < kChannelCount; ++k) {
            tolerances[k] += std::abs(static_cast<double>(exact.values[k]));
            tolerances[k] *= 2.0 * kUnitRoundoff;
            tolerances[k] += kExactZero * naturalSize(p, channelAt(k));
        }
        for (const std::vector<NewtonInstant> &done : runs) {
            if (done[i].state.status != Status::Solved) {
                continue;
            }
            const Deviation deviation = worstDeviation(done[i].state, exact, instants[i], tolerances);
            worst = deviation.ratio() > worst.ratio() ? deviation : worst;
            values += static_cast<int>(kChannelCount);
        }
    };
    const std::vector<double> square = squareInstants(which);
    for (std::size_t i = 0; i < instants.size(); ++i) {
        if (i % 2 != 0 && !std::binary_search(square.begin(), square.end(), instants[i])) {
            continue;
        }
        constexpr double kEnoughClearance = 1e-4; // for 50 digits
        const ExactState<Digits50> exact = exactState<Digits50>(p, instants[i]);
        if (exact.clearance > kEnoughClearance) {
            judge(i, exact);
        } else {
            judge(i, exactState<Digits100>(p, instants[i]));
        }
    }
    const QString said = QString::fromStdString(describe(worst));
    QVERIFY2(worst.accepted(), qPrintable(said));
    qInfo("worst of %d values: %.3g of the bound, %s", values, worst.ratio(), qPrintable(said));
}

/// C_q q̇ = -C_t and C_q q̈ = Q_d, row by row to the rounding of the row's terms.
void tst_structured_newton::velocityAndAccelerationSolveTheirSystems()
{
    RandomMechanisms random(33);
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const Mechanism mechanism(random.next());
        const double t = random.uniform(-1.0, 1.0);
        const NewtonInstant solved =
            solveInstant(mechanism, t, {}, options(Elimination::Structured, WarmStart::Previous, 0.0));
        QCOMPARE(solved.state.status, Status::Solved);
        const Matrix12 Cq = constraintJacobian(mechanism, solved.q);
        const Vector12 Qd = quadraticVelocityTerm(mechanism, solved.q, solved.state.qDot);
        const Vector12 minusCt = -constraintTimeDerivative(mechanism);
        const auto compare = [&](const Vector12 &x, const Vector12 &rightSide) {
            const Vector12 sizes = Cq.cwiseAbs() * x.cwiseAbs() + rightSide.cwiseAbs();
            const Vector12 left = (Cq * x - rightSide).cwiseAbs();
            for (Eigen::Index row = 0; row < kCoordinateCount; ++row) {
                constexpr double kRoundings = 32.0; // of them, up to 20 are those of a θ3 near π
                const double bound = kRoundings * kUnitRoundoff * sizes[row];
                worst = std::max(worst, bound > 0.0 ? left[row] / bound : 0.0);
                QVERIFY2(left[row] <= bound, describe(mechanism.parameters()).c_str());
            }
        };
        compare(solved.state.qDot, minusCt);
        compare(solved.state.qDDot, Qd);
    }
    qInfo("at most %.3g of the bound", worst);
}

void tst_structured_newton::everyWayToSolveStopsWithinItsTolerance()
{
    QFETCH(Case, which);
    const Mechanism mechanism(which.parameters);
    const double reach = which.parameters.a + which.parameters.b + std::abs(which.parameters.c);
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const WarmStart start : {WarmStart::Previous, WarmStart::Taylor}) {
            for (const ToleranceKind kind : {ToleranceKind::Absolute, ToleranceKind::Relative}) {
                const NewtonOptions wanted = options(elimination, start, kReportTolerance, kind);
                for (const NewtonInstant &instant : run(which.parameters, instantsOf(which), wanted)) {
                    if (instant.positionStatus != Status::Solved) {
                        continue;
                    }
                    Vector12 C = constraints(mechanism, instant.q, instant.t);
                    if (kind == ToleranceKind::Relative) {
                        const Vector12 mm = C / reach;
                        const Vector12 rad = C;
                        C = mm;
                        for (const Constraint row : {GroundAngle, SliderAngle, CrankDrive}) {
                            C[row] = rad[row];
                        }
                    }
                    const double rounding =
                        64.0 * kUnitRoundoff * (kind == ToleranceKind::Relative ? 2.0 : reach + 1.0);
                    // The structured way turns sin θ3 and cos θ3 to the last iterate: four rows differ by a rounding
                    // of b/2 times theirs, and of the sums.
                    const double turned = elimination == Elimination::Dense ? 0.0 : 0.125 * rounding;
                    QVERIFY2(std::abs(instant.residual - C.norm()) <= 1e-12 * C.norm() + turned,
                             qPrintable(at(which, instant)));
                    QVERIFY2(instant.residual <= std::max(kReportTolerance, rounding), qPrintable(at(which, instant)));
                }
            }
        }
    }
}

QTEST_APPLESS_MAIN(tst_structured_newton)
#include "tst_structured_newton.moc"
