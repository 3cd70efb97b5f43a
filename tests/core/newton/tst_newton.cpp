// SPDX-License-Identifier: GPL-3.0-or-later

// Tests Newton-Raphson on the named cases and on random mechanisms: its accuracy, its number of iterations, that it
// stays on its branch, and that it reports when it finds no solution.

#include "core/newton/constraints.h"
#include "tests/core/newton/newton_runs.h"
#include "tests/support/all_cases.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace tst_newton
{

/// Returns |f| + κ for each channel. Rounding the inputs causes an error of u times this.
std::array<double, kChannelCount> roundingSizes(const Parameters &p, double t, const ExactState &exact)
{
    std::array<double, kChannelCount> sizes = conditioning(p, t);
    for (std::size_t k = 0; k < kChannelCount; ++k) {
        sizes[k] += std::abs(static_cast<double>(exact.values[k])) + naturalSize(p, channelAt(k)) * 1e-20;
    }
    return sizes;
}

class TestNewton : public QObject
{
    Q_OBJECT

private slots:
    /// core/README.md states 8.1e-15 of the peak for lengths that are not scaled.
    void agreesWithTheClosedFormAtEveryScale()
    {
        constexpr double kTolerance = 5e-14; // of a channel's peak
        for (const double factor : {1.0, 1e-9, 1e9}) {
            RandomMechanisms random(21);
            Deviation worst;
            for (int i = 0; i < numericCaseCount(factor == 1.0 ? 300 : 30, 3000); ++i) {
                Parameters p = random.next();
                p.a *= factor;
                p.b *= factor;
                p.c *= factor;
                const std::vector<double> times = timeStampsOfTurns(p, 40);
                for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                    p.branch = branch;
                    const auto tolerances = scaled(roughSizes(p, times), kTolerance);
                    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
                        if (elimination == Elimination::Dense && factor != 1.0) {
                            continue; // the matrix mixes mm and rad: 1e-11 rad/s² is lost in rounding next to 1e11 mm
                        }
                        for (const NewtonTimeStep &timeStep : solveInTurn(
                                 p, times, {.maxIterations = 50, .tolerance = 0.0, .elimination = elimination})) {
                            if (timeStep.state.status != Status::Solved) { // QVERIFY2 would always write the text
                                QFAIL(qPrintable(describe(p, timeStep)));
                            }
                            const Deviation deviation =
                                worstDeviation(timeStep.state, closedFormState(p, timeStep.t), timeStep.t, tolerances);
                            if (!deviation.accepted()) {
                                QFAIL((describe(p) + describe(deviation)).c_str());
                            }
                            worst = worseOf(worst, deviation);
                        }
                    }
                }
            }
            qInfo("lengths times %g, worst: %.3g of peak", factor, worst.ratio() * kTolerance);
        }
    }

    /// core/README.md states 1.9 u (|f| + κ) for the structured elimination with tolerance 0. Checked at every other
    /// time step and where the coupler is perpendicular to the slider's path.
    void errorIsWithinTwiceTheConditioning()
    {
        const std::size_t interval = kIsSanitized ? 16 : 2; // of the checked time steps; the exact states take long
        for (const Case &namedCase : allCases()) {
            const Parameters &p = namedCase.parameters;
            const std::vector<double> times = timeStampsOf(namedCase);
            const std::vector<double> perpendicular = perpendicularTimes(namedCase);
            Deviation worst;
            std::vector<std::vector<NewtonTimeStep>> solutions;
            for (const WarmStart start : {WarmStart::Previous, WarmStart::Taylor}) {
                solutions.push_back(solveInTurn(p, times,
                                                {.maxIterations = 50,
                                                 .tolerance = 0.0,
                                                 .warmStart = start,
                                                 .elimination = Elimination::Structured}));
            }
            for (std::size_t i = 0; i < times.size(); ++i) {
                const bool isJudged =
                    i % interval == 0 || std::binary_search(perpendicular.begin(), perpendicular.end(), times[i]);
                if (!isJudged) {
                    continue;
                }
                const ExactState exact = exactState(p, times[i]);
                if (exact.status != Status::Solved) {
                    continue;
                }
                const auto tolerances = scaled(roundingSizes(p, times[i], exact), 2.0 * kUnitRoundoff);
                for (const std::vector<NewtonTimeStep> &done : solutions) {
                    if (done[i].state.status == Status::Solved) {
                        worst = worseOf(worst, worstDeviation(done[i].state, exact, times[i], tolerances));
                    }
                }
            }
            qInfo("worst: %.3g u (|f| + kappa), %s", 2.0 * worst.ratio(), describe(worst).c_str());
            QVERIFY2(worst.accepted(), describe(worst).c_str());
        }
    }

    void needsTheIterationsOfTheDocumentation()
    {
        for (const double b : {60.0, 65.0}) {
            for (NewtonOptions options : optionCombinations(10, 1e-8)) {
                const std::vector<NewtonTimeStep> done = solveInTurn({.b = b}, Sampling{}.timeStamps(), options);
                int iterations = 0;
                for (std::size_t i = 1; i < done.size(); ++i) {
                    QVERIFY(!done[i].isColdStart && done[i].state.status == Status::Solved);
                    QVERIFY(done[i].iterations <= 5);
                    iterations += done[i].iterations;
                }
                const double mean = double(iterations) / double(done.size() - 1);
                if (options.warmStart == WarmStart::Taylor) {
                    QVERIFY2(mean == 1.0, qPrintable(describe(options)));
                } else {
                    QVERIFY2(mean > 2.5 && mean < 4.5, qPrintable(describe(options)));
                }
            }
        }
    }

    /// The iteration limit of the options is for warm starts: a cold start has its own.
    void coldStartConvergesWithinItsLimit()
    {
        constexpr NewtonOptions kOneIteration{1, 0.0};
        for (const Case &namedCase : allCases()) {
            const Mechanism mechanism(namedCase.parameters);
            for (const double t : timeStampsOf(namedCase)) {
                const NewtonTimeStep timeStep = solve(mechanism, t, kOneIteration);
                const bool exists = ClosedForm{mechanism}.motionAt(t).status != Status::NotAssemblable;
                const Status expected = exists ? Status::Solved : Status::NotAssemblable;
                QVERIFY2(timeStep.positionStatus == expected, qPrintable(describe(namedCase.parameters, timeStep)));
                QVERIFY(timeStep.isColdStart == exists && timeStep.iterations <= kColdStartIterations);
            }
        }
    }

    /// With so few steps a warm start alone would jump to the other branch.
    void staysOnTheBranchWithFewStepsPerTurn()
    {
        constexpr double kTolerance = 1e-11; // θ3 has the relative error u/cos² θ3: 1e-13 for the smallest gap
        int coldStarts = 0;
        for (const double gap : {1e-1, 1e-2, 1e-3}) {
            for (const int steps : {2, 3, 4, 5, 8, 15, 47}) {
                for (int kind = 0; kind < numericCaseCount(48, 48); ++kind) {
                    const double c = 25.0 * (kind % 3 - 1);
                    const Parameters p{20.0,
                                       (20.0 + std::abs(c)) * (1.0 + gap),
                                       c,
                                       kind % 2 == 0 ? kTurn : -kTurn,
                                       0.2 * (kind / 12),
                                       kind / 6 % 2 == 0 ? Branch::Open : Branch::Crossed};
                    for (const NewtonOptions &options : {kReportOptions, kSmallestResidual}) {
                        for (const NewtonTimeStep &timeStep :
                             solveInTurn(p, timeStampsOfTurns(p, 3 * steps, 3.0), options)) {
                            const double error = std::abs(timeStep.state.q[Theta3] - exactTheta3(p, timeStep.t));
                            if (timeStep.state.status != Status::Solved || !(error < kTolerance)) {
                                QFAIL(qPrintable(describe(p, timeStep)));
                            }
                            coldStarts += timeStep.t > 0.0 && timeStep.isColdStart ? 1 : 0;
                        }
                    }
                }
            }
        }
        QVERIFY(coldStarts > 100); // otherwise nothing was tested
    }

    /// Starts from the other branch, from a perpendicular coupler (singular matrix), and from an angle that is not a
    /// number.
    void replacesStartsThatCannotConverge()
    {
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            Parameters p;
            p.branch = branch;
            const double centre = branch == Branch::Open ? 0.0 : std::numbers::pi;
            Vector12 q = ClosedForm{Mechanism(p)}.stateAt(0.19).q;
            for (const double theta3 : {std::numbers::pi - q[Theta3], centre + 3.0, centre + 0.5 * std::numbers::pi,
                                        centre - 0.5 * std::numbers::pi, kNone}) {
                q[Theta3] = theta3;
                for (const NewtonOptions &options : optionCombinations(50, 0.0)) {
                    const NewtonTimeStep timeStep = solve(Mechanism(p), 0.2, options, startAt(q));
                    const bool isRight = std::abs(timeStep.q[Theta3] - exactTheta3(p, 0.2)) < 1e-12;
                    QVERIFY2(timeStep.positionStatus == Status::Solved && isRight, qPrintable(describe(options)));
                }
            }
        }
    }

    /// At an exact toggle, the position is accurate to √u; velocity and acceleration do not exist.
    void reportsWhyThereIsNoSolution()
    {
        struct Row {
            Parameters parameters;
            double t;
            int maxIterations;
            Status status;
            int iterations = 0;
        };
        const Row rows[] = {
            {{.b = 4.0}, 0.74, 10, Status::NotAssemblable},
            {{.b = 40.0}, 0.75, 10, Status::NotAssemblable},
            {{.b = 1e-9}, 0.2, 10, Status::NotAssemblable},
            {{}, kNone, 10, Status::NotFinite},
            {{}, kInfinity, 10, Status::NotFinite},
            {{}, 1e308, 10, Status::NotFinite},
            {{.omega2 = 1e6}, 1e9, 10, Status::NotFinite}, // θ2 no longer resolved
            {{}, 0.2, 1, Status::IterationLimit, 1},
            // The rounding of the crank pin's position exceeds a coupler of 1e-13 a, so that θ3 is undetermined.
            {{1e3, 1e-9, 0.0}, 0.0, 10, Status::IterationLimit, 0},
        };
        for (const Row &row : rows) {
            const Parameters &p = row.parameters;
            IterationHistory history(1);
            const NewtonTimeStep start = startAt(solve(Mechanism(), 0.0).q);
            const NewtonTimeStep timeStep = solve(Mechanism(p), row.t, {row.maxIterations, 1e-8}, start, &history);
            QVERIFY2(timeStep.positionStatus == row.status && timeStep.state.status == row.status &&
                         timeStep.iterations == row.iterations,
                     qPrintable(describe(p, timeStep)));
            QVERIFY(timeStep.state.q.array().isNaN().all() && timeStep.state.qDDot.array().isNaN().all());
            QVERIFY(history.empty() || row.status == Status::IterationLimit);
        }
        for (const double c : {25.0, -25.0}) {
            for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                const Parameters p{.a = 20.0, .b = 45.0, .c = c, .omega2 = kTurn, .branch = branch};
                const double t = c > 0.0 ? 0.75 : 0.25;
                const NewtonTimeStep timeStep = solve(Mechanism(p), t, kSmallestResidual);
                QCOMPARE(timeStep.state.status, Status::Singular);
                QVERIFY(std::abs(timeStep.q[Theta3] - exactTheta3(p, t)) < 1e-7 && timeStep.state.q == timeStep.q);
                QVERIFY(timeStep.state.qDot.array().isNaN().all() && timeStep.state.qDDot.array().isNaN().all());
            }
        }
    }

    /// With all options, the reported residual is that of the solution, and within the tolerance or the rounding error
    /// of the rows.
    void reportsTheResidualOfTheSolution()
    {
        std::vector<NewtonOptions> combinations = optionCombinations(10, 1e-8);
        std::ranges::copy(optionCombinations(50, 0.0), std::back_inserter(combinations));
        const std::vector<Case> cases = allCases();
        for (std::size_t i = 0; i < cases.size(); i += kIsSanitized ? 8 : 1) { // as numericCaseCount()
            const Parameters &p = cases[i].parameters;
            const double reach = characteristicLength(p);
            for (const NewtonOptions &options : combinations) {
                const bool isRelative = options.toleranceKind == ToleranceKind::Relative;
                for (const NewtonTimeStep &timeStep : solveInTurn(p, timeStampsOf(cases[i]), options)) {
                    if (timeStep.positionStatus != Status::Solved) {
                        continue;
                    }
                    Vector12 C = constraints(Mechanism(p), timeStep.q, timeStep.t);
                    for (Eigen::Index row = 0; row < kCoordinateCount; ++row) {
                        C[row] /= isRelative && !isAngleRow(row) ? reach : 1.0;
                    }
                    const double rounding = 64.0 * kUnitRoundoff * (isRelative ? 2.0 : reach + 1.0);
                    const bool isRight = std::abs(timeStep.residual - C.norm()) <= 1e-12 * C.norm() + 0.125 * rounding;
                    if (!isRight || !(timeStep.residual <= std::max(options.tolerance, rounding))) {
                        QFAIL(qPrintable(describe(options) + describe(p, timeStep)));
                    }
                }
            }
        }
    }

    /// Uses a tolerance larger than the motion itself, or too large for a nearby toggle.
    void iteratesBelowATooLargeTolerance()
    {
        struct Row {
            Parameters parameters;
            double tolerance;
            ToleranceKind kind = ToleranceKind::Relative;
        };
        const Row rows[] = {
            {{.b = 2e10}, 1e-8},
            {{2e-8, 6e-8, 2.5e-8}, 1e-8, ToleranceKind::Absolute},
            {{.b = 45.0}, 1e-4},
            {{20.0, 20.02, 0.0}, 1e-2},
            {{}, 1e3, ToleranceKind::Absolute},
        };
        for (const Row &row : rows) {
            const Parameters &p = row.parameters;
            const std::vector<double> times = Sampling{}.timeStamps();
            const auto tolerances = scaled(roughSizes(p, times), 0.01);
            for (const NewtonOptions &options : optionCombinations(60, row.tolerance)) {
                if (options.toleranceKind != row.kind) {
                    continue;
                }
                int unsolved = 0;
                for (const NewtonTimeStep &timeStep : solveInTurn(p, times, options)) {
                    if (timeStep.state.status != Status::Solved) {
                        ++unsolved;
                        continue;
                    }
                    const Deviation deviation =
                        worstDeviation(timeStep.state, closedFormState(p, timeStep.t), timeStep.t, tolerances);
                    if (!deviation.accepted()) {
                        QFAIL((describe(p) + describe(deviation)).c_str());
                    }
                }
                QVERIFY2(unsolved <= 2, qPrintable(describe(options))); // the toggle itself
            }
        }
    }

    void historyContainsEveryIterate()
    {
        const Mechanism mechanism;
        const double t = 0.4;
        for (const NewtonOptions &options : optionCombinations(10, 1e-8)) {
            Vector12 otherBranch = coldStart(mechanism, t);
            otherBranch[Theta3] = 3.0;
            const NewtonTimeStep before = solve(mechanism, t - 0.005, options);
            for (const NewtonTimeStep &start : {NewtonTimeStep(), startAt(before.q), startAt(otherBranch)}) {
                IterationHistory history(3);
                const NewtonTimeStep timeStep = solve(mechanism, t, options, start, &history);
                QCOMPARE(timeStep.isColdStart, start.positionStatus != Status::Solved || start.q == otherBranch);
                QVERIFY(history.front().q == (timeStep.isColdStart ? coldStart(mechanism, t) : start.q));
                QVERIFY(history.back().q == timeStep.q);
                QCOMPARE(history.back().residual, timeStep.residual);
                QCOMPARE(int(history.size()), timeStep.iterations + 1);
                for (const Iteration &iteration : history) {
                    const Vector12 C = constraints(mechanism, iteration.q, t);
                    const bool isAbsolute = options.toleranceKind == ToleranceKind::Absolute;
                    QVERIFY(!isAbsolute || std::abs(iteration.residual - C.norm()) <= 1e-13);
                }
            }
        }
        IterationHistory history;
        const NewtonTimeStep unreached =
            solve(mechanism, t, {.maxIterations = 1000, .tolerance = 1e-300}, {}, &history);
        QCOMPARE(unreached.positionStatus, Status::IterationLimit);
        QCOMPARE(history.size(), kLongestHistory);
        QVERIFY(history.back().q == unreached.q);
    }
};

const Suite<TestNewton> suite("tst_newton");

} // namespace tst_newton

#include "tst_newton.moc"
