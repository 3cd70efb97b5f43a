// SPDX-License-Identifier: GPL-3.0-or-later

// Tests Newton-Raphson at random time stamps of mechanisms of all kinds: every solution with status Solved is correct.

#include "core/newton/constraints.h"
#include "core/newton/structured_system.h"
#include "tests/core/newton/newton_runs.h"
#include "tests/support/all_cases.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace tst_newton_random
{

/// Random mechanisms of one kind.
struct Kind {
    const char *name;
    double unsolved; ///< largest accepted fraction of unsolved time stamps, of those that can be assembled
    void (*change)(Parameters &p, double gap, RandomMechanisms &random);
};

const Kind kKinds[] = {
    {"ordinary", 0.0, [](Parameters &, double, RandomMechanisms &) {}},
    {"a = b, c = 0", 0.4, [](Parameters &p, double, RandomMechanisms &) { p.b = p.a, p.c = 0.0; }},
    {"a and b almost equal, c = 0", 0.3,
     [](Parameters &p, double gap, RandomMechanisms &) { p.b = p.a * (1.0 + gap), p.c = 0.0; }},
    {"toggles", 0.15, [](Parameters &p, double gap, RandomMechanisms &) { p.b = (p.a + std::abs(p.c)) * (1.0 + gap); }},
    {"rockers", 0.01,
     [](Parameters &p, double, RandomMechanisms &random) { p.b = (p.a + std::abs(p.c)) * random.uniform(0.2, 1.0); }},
    {"short couplers", 0.5,
     [](Parameters &p, double, RandomMechanisms &random) {
         p.c = p.a * random.uniform(-0.99, 0.99);
         p.b = p.a * std::pow(10.0, random.uniform(-15.0, 0.0));
     }},
    {"long couplers", 0.3,
     [](Parameters &p, double, RandomMechanisms &random) { p.b *= std::pow(10.0, random.uniform(0.0, 6.0)); }},
    {"late", 0.1,
     [](Parameters &p, double gap, RandomMechanisms &random) {
         p.theta20 = std::pow(10.0, random.uniform(0.0, 11.0));
         p.b = random.uniform(-1.0, 1.0) < 0.0 ? p.b : (p.a + std::abs(p.c)) * (1.0 + std::abs(gap));
     }},
};

/// Returns a random mechanism at or near a toggle, one of four kinds in turn: a change point (a = b, c = 0), an exact
/// toggle, a coupler that is slightly longer than a full turn requires, or slightly shorter.
Parameters nearToggle(int number, RandomMechanisms &random)
{
    Parameters p = random.next();
    double gap = std::pow(10.0, random.uniform(-15.0, -4.0));
    switch (number % 4) {
    case 0:
        p.c = 0.0;
        gap = 0.0;
        break;
    case 1: gap = 0.0; break;
    case 2: break;
    case 3: gap = -gap; break;
    }
    p.b = (p.a + std::abs(p.c)) * (1.0 + gap);
    return p;
}

/// Returns a random time stamp at which the mechanism can be assembled. If `i` is 2 or 3 modulo 4, the crank is near
/// the end of a rocker's arc or, if the crank makes full turns, near ±90°.
double randomTime(const Parameters &p, int i, RandomMechanisms &random)
{
    const double lowest = std::asin(std::clamp((p.c - p.b) / p.a, -1.0, 1.0));
    const double highest = std::asin(std::clamp((p.c + p.b) / p.a, -1.0, 1.0));
    double angle = std::asin(std::clamp((p.c + p.b * random.uniform(-1.0, 1.0)) / p.a, -1.0, 1.0));
    if (i % 4 >= 2) {
        const double distance = std::pow(10.0, random.uniform(-9.0, -0.5));
        angle = i % 4 == 2 ? lowest + distance : highest - distance;
    } else if (highest - lowest == std::numbers::pi) {
        angle = random.uniform(-10.0, 10.0);
    }
    const double mirrored = i % 2 == 0 ? angle : std::numbers::pi - angle;
    const double turns = std::round(p.theta20 / kTurn) + std::floor(random.uniform(-5.0, 5.0));
    return (mirrored + kTurn * turns - p.theta20) / p.omega2;
}

/// Returns the peak of each channel over two hundred poses: a hundred equal steps of a turn, and a hundred crank angles
/// at which a rocker can be assembled.
std::array<double, kChannelCount> peaks(const Parameters &p)
{
    constexpr int kPoses = 100;
    std::vector<RoughState<double>> states;
    for (int i = 0; i < kPoses; ++i) {
        const double angle = kTurn * (i + 0.5) / kPoses;
        const double angleOfRocker = std::asin(std::clamp((p.c + p.b * std::cos(angle)) / p.a, -1.0, 1.0));
        for (const double theta2 : {angle, angleOfRocker}) {
            states.push_back(closedFormState(p, (theta2 - p.theta20) / p.omega2));
        }
    }
    std::array<double, kChannelCount> sizes = channelSizes(p, states);
    if (p.a != p.b || p.c != 0.0) {
        return sizes;
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) { // channels that vanish have only rounding errors
        const double natural = naturalSize(p, channelAt(index));
        sizes[index] = sizes[index] <= 1e-14 * natural ? natural : sizes[index];
    }
    return sizes;
}

class TestNewtonRandom : public QObject
{
    Q_OBJECT

private slots:
    /// Uses each combination of options in turn, and a warm start from another random time stamp.
    void solvedStatesAreAccurateToOnePercent()
    {
        const std::vector<NewtonOptions> combinations =
            optionCombinations(kReportOptions.maxIterations, kReportOptions.tolerance);
        for (std::size_t kind = 0; kind < std::size(kKinds); ++kind) {
            constexpr double kToleranceFraction = 0.01;
            RandomMechanisms random(40 + kind);
            int poses = 0;
            int unsolved = 0;
            for (int i = 0; i < numericCaseCount(500, 5000); ++i) {
                Parameters p = random.next();
                const double sign = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
                kKinds[kind].change(p, sign * std::pow(10.0, random.uniform(-16.0, -1.0)), random);
                if (findFault(p)) { // a coupler shorter than the program accepts
                    continue;
                }
                const Mechanism mechanism(p);
                const NewtonOptions &options = combinations[static_cast<std::size_t>(i) % combinations.size()];
                const std::array<double, kChannelCount> sizes = peaks(p);
                for (int k = 0; k < 20; ++k) {
                    const double t = randomTime(p, k, random);
                    const double before = t - std::pow(10.0, random.uniform(-4.0, 0.0)) / p.omega2;
                    const NewtonTimeStep timeStep = solve(mechanism, t, options, solve(mechanism, before, options));
                    const RoughState<double> exact = closedFormState(p, t);
                    const Status status = timeStep.state.status;
                    if (exact.status != Status::Solved) {
                        continue;
                    }
                    ++poses;
                    unsolved += status == Status::Solved ? 0 : 1;
                    if (status != Status::Solved && status != Status::Singular) {
                        continue;
                    }
                    std::array<double, kChannelCount> tolerances;
                    for (std::size_t index = 0; index < kChannelCount; ++index) {
                        tolerances[index] = kToleranceFraction * std::max(sizes[index], std::abs(exact.values[index]));
                    }
                    const Order last = status == Status::Solved ? Order::Acceleration : Order::Position;
                    const Deviation deviation = worstDeviation(timeStep.state, exact, t, tolerances, last);
                    if (!deviation.accepted()) { // QVERIFY2 would always write the text
                        QFAIL((describe(p) + "\n    " + describe(deviation)).c_str());
                    }
                }
            }
            qInfo("%s: %d of %d unsolved", kKinds[kind].name, unsolved, poses);
            QVERIFY2(unsolved <= kKinds[kind].unsolved * poses, kKinds[kind].name);
        }
    }

    /// Within 0.03 rad of a toggle, a limit, an exact toggle and a change point, solutions with status Solved have a
    /// relative error below 6 kResolvedFraction. The error is relative to the value or, if larger, to the size of the
    /// channel far from the toggle.
    void solvedDerivativesAreAccurateNearAToggle()
    {
        constexpr double kToleranceFraction = 6.0 * kResolvedFraction;
        constexpr int kMechanisms = 600;
        RandomMechanisms random(22);
        int solved = 0;
        for (int i = 0; i < kMechanisms; ++i) {
            const Parameters p = nearToggle(i, random);
            const double steepestAngle = (p.c >= 0.0 ? -0.5 : 0.5) * std::numbers::pi;
            const double offset =
                std::pow(10.0, random.uniform(-8.0, -1.5)) * (random.uniform(-1.0, 1.0) < 0.0 ? -1 : 1);
            const double t = (steepestAngle + offset - p.theta20) / p.omega2;
            const double before = t + 0.01 / p.omega2 * (offset < 0.0 ? -1.0 : 1.0);
            const ExactState exact = exactState(p, t);
            if (exact.status != Status::Solved) {
                continue;
            }
            std::array<double, kChannelCount> tolerances;
            for (std::size_t index = 0; index < kChannelCount; ++index) {
                const double ordinary = naturalSize(p, channelAt(index)) * p.a / (p.a + p.b + std::abs(p.c));
                tolerances[index] =
                    kToleranceFraction * std::max(std::abs(static_cast<double>(exact.values[index])), ordinary);
            }
            for (const double tolerance : {0.0, 1e-12, 1e-8, 1e-4}) {
                for (const NewtonOptions &options : optionCombinations(60, tolerance)) {
                    const NewtonTimeStep timeStep = solveInTurn(p, {before, t}, options).back();
                    if (timeStep.state.status == Status::Solved) {
                        ++solved;
                        const Deviation deviation = worstDeviation(timeStep.state, exact, t, tolerances);
                        QVERIFY2(
                            deviation.accepted(),
                            qPrintable(describe(options) + QString::fromStdString(describe(p) + describe(deviation))));
                    }
                }
            }
        }
        QVERIFY(solved > kMechanisms);
    }

    /// From each of several iterates, the steps of both eliminations agree: ‖difference‖ <= u (κ ‖Δq‖ + ‖q‖), with the
    /// 2-norm of the twelve numbers (mm and rad mixed) and κ the ratio of the extreme singular values of C_q.
    void structuredStepsEqualDenseSteps()
    {
        using LongVector = Eigen::Matrix<long double, kCoordinateCount, 1>;
        const std::vector<Case> cases = allCases();
        for (const Case &namedCase : cases) {
            const Mechanism mechanism(namedCase.parameters);
            for (const double t : timeStampsOf(namedCase)) {
                const NewtonTimeStep answer = solve(mechanism, t);
                if (answer.positionStatus == Status::NotAssemblable) {
                    continue;
                }
                Vector12 q = answer.q;
                q[Theta3] = 0.5 * (q[Theta3] + coldStart(mechanism, t)[Theta3]);
                StructuredSystem system(mechanism, t);
                for (int k = 0; k < 4; ++k) {
                    const Matrix12 Cq = constraintJacobian(mechanism, q);
                    const Vector12 C = constraints(mechanism, q, t);
                    const Vector12 step = Cq.partialPivLu().solve(-C);
                    system.moveTo(StructuredSystem::read(q));
                    QVERIFY(std::abs(system.residual(1.0) - C.norm()) <= 8.0 * kUnitRoundoff * C.norm());
                    Vector12 next;
                    StructuredSystem::write(system.next(StructuredSystem::read(q)), next);
                    const LongVector difference =
                        next.cast<long double>() - (q.cast<long double>() + step.cast<long double>());
                    const Vector12 singularValues = Eigen::JacobiSVD<Matrix12>(Cq).singularValues();
                    const double kappa = singularValues[0] / singularValues[11];
                    if (!(kappa < 0.1 / kUnitRoundoff)) {
                        break; // no digit of the step is significant
                    }
                    const double bound = kUnitRoundoff * (kappa * step.norm() + q.norm());
                    QVERIFY2(static_cast<double>(difference.norm()) <= bound, std::string(namedCase.name).c_str());
                    q += step;
                }
            }
        }
    }
};

const Suite<TestNewtonRandom> suite("tst_newton_random");

} // namespace tst_newton_random

#include "tst_newton_random.moc"
