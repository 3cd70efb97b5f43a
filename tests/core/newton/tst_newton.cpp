// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"

#include <QTest>

#include <algorithm>
#include <iterator>

Q_DECLARE_METATYPE(slidercrank::Case)

using namespace slidercrank;

namespace
{

constexpr NewtonOptions kReport;            // Table 2
constexpr NewtonOptions kToTheEnd{50, 0.0}; // until the residual no longer falls
constexpr double kPromise = 5e-14;          // of a channel's peak, where the mechanism is well conditioned

struct Instant {
    double t = 0.0;
    NewtonResult result;
    State state;
};

/// Each instant from the one before, as a study does; from afar where there is none.
std::vector<Instant> run(const Parameters &parameters, const std::vector<double> &instants, NewtonOptions options)
{
    const Mechanism mechanism(parameters);
    std::vector<Instant> done;
    for (const double t : instants) {
        Instant here{};
        here.t = t;
        here.result = done.empty() || done.back().result.status != Status::Solved
                          ? assemble(mechanism, t, options)
                          : track(mechanism, t, done.back().result.q, options);
        if (here.result.status == Status::Solved) {
            here.state = differentiate(mechanism, here.result.q, here.result.residual());
        } else {
            here.state.status = here.result.status;
        }
        done.push_back(here);
    }
    return done;
}

/// Each way of solving, but for the report's.
std::vector<NewtonOptions> rungsOf(const NewtonOptions &report)
{
    std::vector<NewtonOptions> rungs;
    for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
        for (const WarmStart warmStart : {WarmStart::Previous, WarmStart::Taylor}) {
            for (const ToleranceKind kind : {ToleranceKind::Absolute, ToleranceKind::Relative}) {
                const NewtonOptions rung{report.maxIterations, report.tolerance, kind, warmStart, elimination};
                if (rung != report) {
                    rungs.push_back(rung);
                }
            }
        }
    }
    return rungs;
}

std::vector<Instant> runOnRung(const Parameters &parameters, const std::vector<double> &instants,
                               const NewtonOptions &options)
{
    const Mechanism mechanism(parameters);
    std::vector<Instant> done;
    NewtonInstant last;
    for (const double t : instants) {
        last = solveInstant(mechanism, t, last, options);
        Instant here{};
        here.t = t;
        here.result.q = last.q;
        here.result.iterations = last.iterations;
        here.result.status = last.positionStatus;
        here.state = last.state;
        done.push_back(here);
    }
    return done;
}

QString said(const NewtonOptions &options)
{
    return QStringLiteral("%1, %2, %3 tolerance %4")
        .arg(options.elimination == Elimination::Dense ? QStringLiteral("dense") : QStringLiteral("structured"),
             options.warmStart == WarmStart::Previous ? QStringLiteral("from the instant before")
                                                      : QStringLiteral("Taylor start"),
             options.toleranceKind == ToleranceKind::Absolute ? QStringLiteral("absolute") : QStringLiteral("relative"))
        .arg(options.tolerance);
}

std::vector<double> turn(const Parameters &parameters, int steps, double turns = 1.0)
{
    const double duration = turns * 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    return Sampling{0.0, duration, steps}.instants();
}

QString said(const Parameters &parameters, const Deviation &deviation)
{
    return QString::fromStdString(describe(parameters) + "\n    " + describe(deviation));
}

QString at(const Case &which, const Instant &instant)
{
    return QString("%1 at t=%2: status %3 after %4 iterations, residual %5, theta3 %6")
        .arg(QString::fromUtf8(which.name.data(), qsizetype(which.name.size())))
        .arg(instant.t, 0, 'g', 17)
        .arg(int(instant.state.status))
        .arg(instant.result.iterations)
        .arg(instant.result.residual())
        .arg(instant.result.q[Theta3], 0, 'g', 17);
}

void addCases(const std::vector<Case> &cases)
{
    QTest::addColumn<Case>("which");
    for (const Case &which : cases) {
        QTest::newRow(std::string(which.name).c_str()) << which;
    }
}

std::vector<Case> nominal()
{
    return {nominalCases().begin(), nominalCases().end()};
}

/// Against the closed form, over one run: the worst of all 36 channels.
Deviation worstOf(const Parameters &parameters, const std::vector<Instant> &instants,
                  const std::array<double, kChannelCount> &tolerances)
{
    const ClosedForm closedForm{Mechanism(parameters)};
    Deviation worst;
    for (const Instant &instant : instants) {
        const State reference = closedForm.stateAt(instant.t);
        ExactState<double> exact;
        exact.status = reference.status;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            exact.values[index] = valueOf(reference, channelAt(index));
        }
        const Deviation deviation = worstDeviation(instant.state, exact, instant.t, tolerances);
        if (deviation.ratio() > worst.ratio()) {
            worst = deviation;
        }
    }
    return worst;
}

std::array<double, kChannelCount> sizesOf(const Parameters &parameters, const std::vector<double> &instants)
{
    return channelSizes<long double>(parameters, exactRun<long double>(parameters, instants));
}

} // namespace

class tst_newton : public QObject
{
    Q_OBJECT

private slots:
    void agreesWithTheClosedFormOnRandomMechanisms();
    void agreesWithTheClosedFormOnNominalCases_data() { addCases(nominal()); }
    void agreesWithTheClosedFormOnNominalCases();
    void needsThreeToFourIterationsAStateInTheReportsStudy();
    void residualsFallAndTheLastIsThatOfTheAnswer_data() { addCases(nominal()); }
    void residualsFallAndTheLastIsThatOfTheAnswer();
    void keepsTheOpenBranchWithFiveStepsATurn();
    void keepsTheBranchWithFewStepsATurn_data();
    void keepsTheBranchWithFewStepsATurn();
    void startsAgainFromAfarOnTheOtherBranch();
    void startsAgainFromASquareCoupler();
    void assemblesFromAfarWithinItsCap_data() { addCases(allCases()); }
    void assemblesFromAfarWithinItsCap();
    void saysNotAssemblableWithoutIterating();
    void saysNotFinite();
    void saysWhenIterationsRunOut();
    void isSingularAtTheExactToggle_data();
    void isSingularAtTheExactToggle();
    void solvesLengthsOfAnySizeWithToleranceZero();
    void isNeverWrongSilently_data();
    void isNeverWrongSilently();
    void goesOnWhereItsToleranceLeavesNoDigit();
    void givesDerivativesBesideAToggleOnlyWithTheirDigits();
};

void tst_newton::agreesWithTheClosedFormOnRandomMechanisms()
{
    RandomMechanisms random(21);
    Deviation worst;
    Parameters worstParameters;
    for (int i = 0; i < numericRuns(300, 3000); ++i) {
        Parameters p = random.next();
        const std::vector<double> instants = turn(p, 40);
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            const std::vector<Instant> done = run(p, instants, kToTheEnd);
            for (const Instant &instant : done) {
                QVERIFY2(instant.state.status == Status::Solved, describe(p).c_str());
            }
            const Deviation deviation = worstOf(p, done, scaled(sizesOf(p, instants), kPromise));
            if (deviation.ratio() > worst.ratio()) {
                worst = deviation;
                worstParameters = p;
            }
        }
    }
    qInfo("worst: %.3g of peak, %s", worst.ratio() * kPromise, qPrintable(said(worstParameters, worst)));
    QVERIFY2(worst.accepted(), qPrintable(said(worstParameters, worst)));
}

/// Both to the end, and with the report's tolerance and iterations.
void tst_newton::agreesWithTheClosedFormOnNominalCases()
{
    QFETCH(Case, which);
    const std::vector<double> instants = instantsOf(which);
    const std::array<double, kChannelCount> tolerances = scaled(sizesOf(which.parameters, instants), kPromise);
    for (const NewtonOptions &options : {kToTheEnd, kReport}) {
        const std::vector<Instant> done = run(which.parameters, instants, options);
        for (const Instant &instant : done) {
            QVERIFY2(instant.state.status == Status::Solved, qPrintable(at(which, instant)));
        }
        const Deviation worst = worstOf(which.parameters, done, tolerances);
        QVERIFY2(worst.accepted(), qPrintable(said(which.parameters, worst)));
    }
}

/// Measured elsewhere for the same study: 3.9.
void tst_newton::needsThreeToFourIterationsAStateInTheReportsStudy()
{
    for (const double b : {60.0, 65.0}) {
        Parameters p;
        p.b = b;
        const std::vector<Instant> done = run(p, Sampling{}.instants(), kReport);
        int iterations = 0;
        int most = 0;
        for (std::size_t i = 1; i < done.size(); ++i) {
            iterations += done[i].result.iterations;
            most = std::max(most, done[i].result.iterations);
            QVERIFY(!done[i].result.startedAfar);
        }
        const double mean = double(iterations) / double(done.size() - 1);
        qInfo("b = %g: %.3g iterations a state, at most %d", b, mean, most);
        QVERIFY(mean > 2.5 && mean < 4.5);
        QVERIFY(most <= 5);
    }
}

void tst_newton::residualsFallAndTheLastIsThatOfTheAnswer()
{
    QFETCH(Case, which);
    const Mechanism mechanism(which.parameters);
    for (const NewtonOptions &options : {kToTheEnd, kReport}) {
        for (const Instant &instant : run(which.parameters, instantsOf(which), options)) {
            const NewtonResult &result = instant.result;
            QVERIFY2(result.residualCount >= 1, qPrintable(at(which, instant)));
            QCOMPARE(result.residual(), constraints(mechanism, result.q, instant.t).norm());
            if (options.tolerance > 0.0) {
                QVERIFY2(result.residual() <= options.tolerance, qPrintable(at(which, instant)));
                QCOMPARE(result.residualCount, result.iterations + 1);
            }
            // Far above rounding, each step gains; a start from afar first has to come near.
            constexpr double kRoundingResidual = 1e-12;
            for (int k = 1; k < result.residualCount && !result.startedAfar; ++k) {
                const double before = result.residuals[std::size_t(k - 1)];
                const double after = result.residuals[std::size_t(k)];
                QVERIFY2(after < before || before < kRoundingResidual, qPrintable(at(which, instant)));
            }
        }
    }
}

/// The report's warm start alone jumps to the crossed assembly here (gap 1e-1).
void tst_newton::keepsTheOpenBranchWithFiveStepsATurn()
{
    int restarts = 0;
    for (int phase = 0; phase < 20; ++phase) {
        Parameters p;
        p.b = 1.1 * 45.0;
        p.theta20 = 0.1 * phase;
        for (const Instant &instant : run(p, turn(p, 15, 3.0), kReport)) {
            QCOMPARE(instant.state.status, Status::Solved);
            QVERIFY(std::cos(instant.state.q[Theta3]) > 0.0);
            const double theta3 = ClosedForm{Mechanism(p)}.stateAt(instant.t).q[Theta3];
            QVERIFY2(std::abs(instant.state.q[Theta3] - theta3) < 1e-12,
                     qPrintable(QString("t=%1: %2, exact %3").arg(instant.t).arg(instant.state.q[Theta3]).arg(theta3)));
            restarts += instant.t > 0.0 && instant.result.startedAfar ? 1 : 0;
        }
    }
    qInfo("%d restarts", restarts);
    QVERIFY(restarts > 0); // else nothing was tested
}

void tst_newton::keepsTheBranchWithFewStepsATurn_data()
{
    QTest::addColumn<double>("gap");
    QTest::addColumn<int>("steps");
    for (const double gap : {1e-1, 1e-2, 1e-3}) {
        for (const int steps : {2, 3, 4, 5, 8, 15, 47}) {
            QTest::addRow("%d steps a turn, gap %g", steps, gap) << gap << steps;
        }
    }
}

void tst_newton::keepsTheBranchWithFewStepsATurn()
{
    QFETCH(double, gap);
    QFETCH(int, steps);
    // θ3 follows from sin θ3 with the relative error u/cos²θ3 at worst: 1e-13 for the smallest gap.
    constexpr double kTolerance = 1e-11;
    for (const Branch branch : {Branch::Open, Branch::Crossed}) {
        for (const double c : {25.0, 0.0, -25.0}) {
            for (const double omega2 : {2.0 * std::numbers::pi, -2.0 * std::numbers::pi}) {
                for (int phase = 0; phase < 4; ++phase) {
                    const Parameters p{20.0, (20.0 + std::abs(c)) * (1.0 + gap), c, omega2, 0.2 * phase, branch};
                    const ClosedForm closedForm{Mechanism(p)};
                    for (const NewtonOptions &options : {kReport, kToTheEnd}) {
                        for (const Instant &instant : run(p, turn(p, 3 * steps, 3.0), options)) {
                            const double exact = closedForm.stateAt(instant.t).q[Theta3];
                            const QString where = QString("%1 t=%2: status %3, %4, exact %5, iterations %6")
                                                      .arg(QString::fromStdString(describe(p)))
                                                      .arg(instant.t, 0, 'g', 17)
                                                      .arg(int(instant.state.status))
                                                      .arg(instant.result.q[Theta3])
                                                      .arg(exact)
                                                      .arg(instant.result.iterations);
                            QVERIFY2(instant.state.status == Status::Solved, qPrintable(where));
                            QVERIFY2(std::abs(instant.state.q[Theta3] - exact) < kTolerance, qPrintable(where));
                        }
                    }
                }
            }
        }
    }
}

void tst_newton::startsAgainFromAfarOnTheOtherBranch()
{
    for (const Branch branch : {Branch::Open, Branch::Crossed}) {
        Parameters p;
        p.branch = branch;
        Parameters other = p;
        other.branch = oppositeBranch(branch);
        const Vector12 start = ClosedForm{Mechanism(other)}.stateAt(0.19).q;
        const NewtonResult result = track(Mechanism(p), 0.2, start, kToTheEnd);
        QCOMPARE(result.status, Status::Solved);
        QVERIFY(result.startedAfar);
        QVERIFY(std::abs(result.q[Theta3] - ClosedForm{Mechanism(p)}.stateAt(0.2).q[Theta3]) < 1e-13);
    }
}

/// There C_q is singular: the step is no number, or as good as none.
void tst_newton::startsAgainFromASquareCoupler()
{
    const Parameters p;
    const Mechanism mechanism(p);
    for (const double theta3 :
         {0.5 * std::numbers::pi, -0.5 * std::numbers::pi, std::numeric_limits<double>::quiet_NaN()}) {
        Vector12 start = ClosedForm{mechanism}.stateAt(0.19).q;
        start[Theta3] = theta3;
        const NewtonResult result = track(mechanism, 0.2, start, kReport);
        QCOMPARE(result.status, Status::Solved);
        QVERIFY(std::abs(result.q[Theta3] - ClosedForm{mechanism}.stateAt(0.2).q[Theta3]) < 1e-13);
    }
}

void tst_newton::assemblesFromAfarWithinItsCap()
{
    QFETCH(Case, which);
    const Mechanism mechanism(which.parameters);
    int most = 0;
    for (const double t : instantsOf(which)) {
        const NewtonResult result = assemble(mechanism, t, kToTheEnd);
        most = std::max(most, result.iterations);
        Instant instant{t, result, {}};
        instant.state.status = result.status;
        if (ClosedForm{mechanism}.stateAt(t).status == Status::NotAssemblable) {
            QVERIFY2(result.status == Status::NotAssemblable, qPrintable(at(which, instant)));
            continue;
        }
        QVERIFY2(result.status == Status::Solved, qPrintable(at(which, instant)));
        QVERIFY2(result.startedAfar, qPrintable(at(which, instant)));
    }
    QVERIFY(most <= kAssemblyIterations);
    qInfo("at most %d iterations", most);
}

void tst_newton::saysNotAssemblableWithoutIterating()
{
    Parameters never;
    never.b = 4.0;
    Parameters rocker;
    rocker.b = 40.0;
    for (const Parameters &p : {never, rocker}) {
        const Mechanism mechanism(p);
        for (const double t : {0.74, 0.75, 0.76}) {
            Vector12 start = Vector12::Zero();
            for (const NewtonResult &result : {assemble(mechanism, t, kReport), track(mechanism, t, start, kReport)}) {
                QCOMPARE(result.status, Status::NotAssemblable);
                QCOMPARE(result.iterations, 0);
                QVERIFY(result.q.array().isNaN().all());
            }
        }
    }
}

void tst_newton::saysNotFinite()
{
    for (const double t : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e308}) {
        QCOMPARE(assemble(Mechanism(), t).status, Status::NotFinite);
        QCOMPARE(track(Mechanism(), t, Vector12::Zero()).status, Status::NotFinite);
        QCOMPARE(assemble(Mechanism(), t).iterations, 0);
    }
}

void tst_newton::saysWhenIterationsRunOut()
{
    const Mechanism mechanism;
    const Vector12 start = assemble(mechanism, 0.0).q;
    const NewtonResult result = track(mechanism, 0.2, start, {1, 1e-8});
    QCOMPARE(result.status, Status::IterationLimit);
    QCOMPARE(result.iterations, 1);
    QVERIFY(result.residual() > 1e-8);
    QCOMPARE(track(mechanism, 0.2, start, {20, 1e-8}).status, Status::Solved);
}

void tst_newton::isSingularAtTheExactToggle_data()
{
    QTest::addColumn<Case>("which");
    QTest::addColumn<double>("t");
    for (const Case &which : hardCases()) {
        if (which.name.starts_with("exact toggle")) {
            QTest::newRow(std::string(which.name).c_str()) << which << (which.parameters.c > 0.0 ? 0.75 : 0.25);
        }
    }
}

/// The position is good to √u, velocity and acceleration are not there.
void tst_newton::isSingularAtTheExactToggle()
{
    QFETCH(Case, which);
    QFETCH(double, t);
    const Mechanism mechanism(which.parameters);
    const NewtonResult result = assemble(mechanism, t, kToTheEnd);
    QCOMPARE(result.status, Status::Solved);
    const double exact = ClosedForm{mechanism}.stateAt(t).q[Theta3];
    QVERIFY2(std::abs(result.q[Theta3] - exact) < 1e-7, qPrintable(at(which, {t, result, {}})));
    const State state = differentiate(mechanism, result.q, result.residual());
    QCOMPARE(state.status, Status::Singular);
    QVERIFY(state.q == result.q);
    QVERIFY(state.qDot.array().isNaN().all());
    QVERIFY(state.qDDot.array().isNaN().all());
}

void tst_newton::solvesLengthsOfAnySizeWithToleranceZero()
{
    for (const double factor : {1e-9, 1e-3, 1e3, 1e9}) {
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            const Parameters p{20.0 * factor, 60.0 * factor, 25.0 * factor, 2.0 * std::numbers::pi, 0.0, branch};
            const std::vector<double> instants = Sampling{}.instants();
            const std::vector<Instant> done = run(p, instants, kToTheEnd);
            for (const Instant &instant : done) {
                QVERIFY2(instant.state.status == Status::Solved, describe(p).c_str());
            }
            const Deviation worst = worstOf(p, done, scaled(sizesOf(p, instants), kPromise));
            QVERIFY2(worst.accepted(), qPrintable(said(p, worst)));
        }
    }
}

void tst_newton::isNeverWrongSilently_data()
{
    QTest::addColumn<Case>("which");
    QTest::addColumn<double>("tolerance");
    for (const Case &which : allCases()) {
        QTest::addRow("%s, to the end", std::string(which.name).c_str()) << which << 0.0;
        QTest::addRow("%s, report", std::string(which.name).c_str()) << which << 1e-8;
    }
}

/// Whatever the way of solving: what is called solved has a position that is right as far as the residual can tell, and
/// derivatives that are right to a hundredth of the channel's peak at the very least. With r the tolerance, or what
/// rounding makes of it, b sin θ3 is known to 2r (four rows make it up), so θ3 to 2r/(b |cos θ3|) and, since sin θ3 is
/// flat there, to √(4r/b) at worst. Its relative error in cos θ3 is that of each derivative, once more for each
/// division by it.
void tst_newton::isNeverWrongSilently()
{
    QFETCH(Case, which);
    QFETCH(double, tolerance);
    const Parameters &p = which.parameters;
    constexpr double kRoundings = 32.0;
    int solved = 0;
    Deviation worst;
    const std::vector<double> instants = instantsOf(which);
    const std::vector<ExactState<Digits100>> exactStates = exactRun<Digits100>(p, instants);
    constexpr double kPart = 0.01;
    const std::array<double, kChannelCount> part = scaled(channelSizes<Digits100>(p, exactStates), kPart);
    const NewtonOptions report = tolerance == 0.0 ? kToTheEnd : kReport;
    const double reach = p.a + p.b + std::abs(p.c);
    const auto judge = [&](const NewtonOptions &options, const std::vector<Instant> &done) {
        for (std::size_t i = 0; i < done.size(); ++i) {
            const Instant &instant = done[i];
            const ExactState<Digits100> &exact = exactStates[i];
            const Status status = instant.state.status;
            if (status != Status::Solved && status != Status::Singular) {
                continue;
            }
            ++solved;
            // At a rocker's very limit rounding decides whether there is a position; the limit itself is then the
            // answer.
            const bool atTheLimit = std::abs(static_cast<double>(exact.clearance)) < 1e-14;
            if (atTheLimit && exact.status != Status::Solved) {
                continue;
            }
            QVERIFY2(exact.status == Status::Solved, qPrintable(said(options) + ' ' + at(which, instant)));

            const double cosine = std::abs(static_cast<double>(exact.cosTheta3));
            const double theta2 = std::abs(static_cast<double>(exact.values[indexOf({Theta2, Order::Position})]));
            const double rounding = kRoundings * kUnitRoundoff * (1.0 + theta2);
            const double inLengths = options.toleranceKind == ToleranceKind::Relative ? tolerance * reach : tolerance;
            const double residual = (2.0 * inLengths + rounding * reach) / p.b;
            const double theta3Error = std::min(residual / cosine, 2.0 * std::sqrt(2.0 * residual)) + rounding;
            std::array<double, kChannelCount> tolerances;
            for (std::size_t index = 0; index < kChannelCount; ++index) {
                const Channel channel = channelAt(index);
                const double relativeCosine = theta3Error / cosine;
                const double steepness = std::pow(cosine, -2.0 * static_cast<int>(channel.order) + 1.0);
                const double natural = naturalSize(p, channel);
                tolerances[index] = channel.order == Order::Position
                                        ? natural * theta3Error
                                        : std::min(part[index], 4.0 * natural * steepness * relativeCosine);
            }
            tolerances[indexOf({Theta2, Order::Position})] = rounding;
            const Order last = status == Status::Singular ? Order::Position : Order::Acceleration;
            const Deviation deviation = worstDeviation(instant.state, exact, instant.t, tolerances, last);
            if (deviation.ratio() > worst.ratio()) {
                worst = deviation;
            }
            QVERIFY2(deviation.accepted(),
                     qPrintable(said(options) + ' ' + at(which, instant) + '\n' + said(p, deviation)));
        }
    };
    judge(report, run(p, instants, report));
    for (const NewtonOptions &options : rungsOf(report)) {
        judge(options, runOnRung(p, instants, options));
        if (QTest::currentTestFailed()) {
            return;
        }
    }
    qInfo("%d of %d solved, worst: %.3g of the tolerance, %s", solved, 8 * int(instants.size()), worst.ratio(),
          qPrintable(said(p, worst)));
}

/// A tolerance larger than the motion itself, or than what the nearness of a toggle lets pass.
void tst_newton::goesOnWhereItsToleranceLeavesNoDigit()
{
    struct Loose {
        Parameters parameters;
        double tolerance;
        ToleranceKind kind;
    };
    const double turn = 2.0 * std::numbers::pi;
    const std::array loose{
        Loose{{20.0, 2e10, 25.0, turn, 0.0, Branch::Open}, 1e-8, ToleranceKind::Relative},
        Loose{{2e-8, 6e-8, 2.5e-8, turn, 0.0, Branch::Open}, 1e-8, ToleranceKind::Absolute},
        Loose{{20.0, 45.0, 25.0, turn, 0.0, Branch::Open}, 1e-4, ToleranceKind::Relative},
        Loose{{20.0, 20.02, 0.0, turn, 0.0, Branch::Open}, 1e-2, ToleranceKind::Relative},
        Loose{{20.0, 65.0, 25.0, turn, 0.0, Branch::Open}, 1e3, ToleranceKind::Absolute},
    };
    for (const Loose &one : loose) {
        const std::vector<double> instants = Sampling{}.instants();
        const std::array<double, kChannelCount> tolerances = scaled(sizesOf(one.parameters, instants), 0.01);
        for (const Elimination elimination : {Elimination::Dense, Elimination::Structured}) {
            for (const WarmStart warmStart : {WarmStart::Previous, WarmStart::Taylor}) {
                const NewtonOptions options{60, one.tolerance, one.kind, warmStart, elimination};
                const std::vector<Instant> done = runOnRung(one.parameters, instants, options);
                std::vector<Instant> solved;
                std::copy_if(done.begin(), done.end(), std::back_inserter(solved),
                             [](const Instant &instant) { return instant.state.status == Status::Solved; });
                QVERIFY2(solved.size() + 2 >= done.size(), qPrintable(said(options))); // but at the very toggle
                const Deviation worst = worstOf(one.parameters, solved, tolerances);
                QVERIFY2(worst.accepted(), qPrintable(said(options) + ' ' + said(one.parameters, worst)));
            }
        }
    }
}

/// Instants within 0.03 rad of a toggle, of a limit, of an exact toggle and of a change point: what is called solved is
/// right to the part that kResolvedPart leaves, three times twice that, of the value or of what it would be where
/// nothing is steep.
void tst_newton::givesDerivativesBesideAToggleOnlyWithTheirDigits()
{
    constexpr double kPart = 6.0 * kResolvedPart;
    constexpr int kMechanisms = 600;
    RandomMechanisms random(22);
    double worst = 0.0;
    int solved = 0;
    for (int i = 0; i < kMechanisms; ++i) {
        Parameters p = random.next();
        const double gap = std::pow(10.0, random.uniform(-15.0, -4.0));
        p.c = i % 4 == 0 ? 0.0 : p.c;
        p.b = (p.a + std::abs(p.c)) * (1.0 + (i % 4 < 2 ? 0.0 : i % 4 == 2 ? gap : -gap));
        const double square = (p.c >= 0.0 ? -0.5 : 0.5) * std::numbers::pi;
        const double offset = std::pow(10.0, random.uniform(-8.0, -1.5)) * (random.uniform(-1.0, 1.0) < 0.0 ? -1 : 1);
        const double t = (square + offset - p.theta20) / p.omega2;
        const double before = t + 0.01 / p.omega2 * (offset < 0.0 ? -1.0 : 1.0);
        const ExactState<Digits100> exact = exactState<Digits100>(p, t);
        for (const double tolerance : {0.0, 1e-12, 1e-8, 1e-4}) {
            for (const NewtonOptions &options : rungsOf({60, tolerance})) {
                const Instant instant = runOnRung(p, {before, t}, options).back();
                if (instant.state.status != Status::Solved || exact.status != Status::Solved) {
                    continue;
                }
                ++solved;
                std::array<double, kChannelCount> tolerances;
                for (std::size_t index = 0; index < kChannelCount; ++index) {
                    const Channel channel = channelAt(index);
                    const double size = std::max(std::abs(static_cast<double>(exact.values[index])),
                                                 naturalSize(p, channel) * p.a / (p.a + p.b + std::abs(p.c)));
                    tolerances[index] = kPart * size;
                }
                const Deviation deviation = worstDeviation(instant.state, exact, t, tolerances);
                worst = std::max(worst, deviation.ratio());
                QVERIFY2(deviation.accepted(), qPrintable(said(options) + ' ' + said(p, deviation)));
            }
        }
    }
    qInfo("%d solved, worst %.3g of a part of %.3g", solved, worst, kPart);
    QVERIFY(solved > kMechanisms);
}

QTEST_APPLESS_MAIN(tst_newton)
#include "tst_newton.moc"
