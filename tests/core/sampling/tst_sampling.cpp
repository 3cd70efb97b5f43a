// SPDX-License-Identifier: GPL-3.0-or-later

// Tests that sampled motions equal the solvers' results for any selection, that they satisfy the constraint equations,
// and that the crank has the requested angle.

#include "core/closed_form/state_at.h"
#include "core/mechanism/in_parallel.h"
#include "core/newton/newton.h"
#include "core/sampling/crank_time.h"
#include "core/sampling/time_step_equations.h"
#include "core/study/cases.h"
#include "tests/support/all_cases.h"
#include "tests/support/channels.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <atomic>
#include <new>
#include <thread>

using namespace slidercrank;

namespace tst_sampling
{

constexpr SolverSettings kClosedForm;
constexpr SolverSettings kNewton{Method::Newton, {}};

/// Returns whether the values are equal or both NaN.
bool isSame(const std::vector<double> &x, const std::vector<double> &y)
{
    return std::ranges::equal(x, y, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

ChannelSet only(Channel channel)
{
    return ChannelSet().set(indexOf(channel));
}

/// Returns the time of one revolution of the crank.
double period(const Mechanism &mechanism)
{
    return 2.0 * std::numbers::pi / std::abs(mechanism.omega2());
}

/// Returns how far the crank is from the angle at that time, up to whole turns.
double angleError(const Mechanism &mechanism, double time, double theta2)
{
    const double angle = mechanism.omega2() * time + mechanism.theta20();
    return std::abs(std::remainder(angle - theta2, 2.0 * std::numbers::pi));
}

class TestSampling : public QObject
{
    Q_OBJECT

private slots:
    void defaultsAreTable2InClosedForm()
    {
        const NewtonOptions newton = SolverSettings{}.newton;
        QVERIFY(Sampling{}.steps == 200 && Sampling{}.start == 0.0 && Sampling{}.duration == 1.0);
        QVERIFY(SolverSettings{}.method == Method::ClosedForm);
        QVERIFY(newton.maxIterations == 10 && newton.tolerance == 1e-8);
        QVERIFY(newton.warmStart == WarmStart::Previous && newton.elimination == Elimination::Dense);
    }

    void timeStampsIncludeBothEnds()
    {
        const Sampling rows[] = {
            {}, {0.0, 1.0, 1}, {0.25, 1.0 / 3.0, 7}, {1.0, -1.0, 10}, {2.0, 0.0, 3}, {1e9, 1.0, 200}};
        for (const Sampling &sampling : rows) {
            const std::vector<double> times = sampling.timeStamps();
            QVERIFY(times.front() == sampling.start && times.back() == sampling.start + sampling.duration);
            for (int i = 0; i <= sampling.steps; ++i) {
                QCOMPARE(times.at(std::size_t(i)), sampling.start + sampling.duration * i / sampling.steps);
            }
        }
        QCOMPARE(timeStepsPerTurn(Mechanism({.omega2 = -std::numbers::pi}), {}), 400.0);
    }

    /// Compares values, statuses and the summary for every case, both methods, all channels and subsets of them. The
    /// time stamps are in any order, and one has no finite angle.
    void samplesEqualTheSolversResults()
    {
        for (const Case &namedCase : allCases()) {
            const Mechanism mechanism(namedCase.parameters);
            const ClosedForm closedForm(mechanism);
            std::vector<double> times = timeStampsOf(namedCase);
            times.insert(times.end(), {namedCase.sampling.start, 1e308, 0.3, -3.3});
            for (const SolverSettings &settings : {kClosedForm, kNewton}) {
                const Trajectory all = sample(mechanism, times, allChannels(), settings);
                QVERIFY(all.complete && all.time == times);
                SamplingSummary expected{.timeSteps = times.size()};
                std::array<std::vector<double>, kChannelCount> values;
                NewtonTimeStep timeStep;
                for (std::size_t i = 0; i < times.size(); ++i) {
                    advance(mechanism, times[i], timeStep);
                    const bool isNewton = settings.method == Method::Newton;
                    const State state = isNewton ? timeStep.state : closedForm.stateAt(times[i]);
                    QCOMPARE(all.status[i], state.status);
                    StatusSummary &status = expected.withStatus(state.status);
                    if (status.count++ == 0) {
                        status.firstTime = times[i];
                        status.firstTheta2 = mechanism.theta20() + mechanism.omega2() * times[i];
                    }
                    if (isNewton && timeStep.positionStatus == Status::Solved) {
                        expected.iterations += timeStep.iterations;
                        expected.maxIterationsOfStep = std::max(expected.maxIterationsOfStep, timeStep.iterations);
                        expected.largestResidual = std::max(expected.largestResidual, timeStep.residual);
                    }
                    for (std::size_t index = 0; index < kChannelCount; ++index) {
                        const Channel channel = channelAt(index);
                        values[index].push_back(toFileUnit(channel, valueOf(state, channel)));
                    }
                }
                QVERIFY2(all.summary == expected, std::string(namedCase.name).c_str());
                for (const ChannelSet &channels : {ChannelSet(), only(kSlider), only({R3y, Order::Acceleration}),
                                                   plottedChannels(), allChannels()}) {
                    const Trajectory part = sample(mechanism, times, channels, settings);
                    QVERIFY(part.status == all.status && part.summary == all.summary);
                    for (std::size_t index = 0; index < kChannelCount; ++index) {
                        QVERIFY2(
                            isSame(part.values[index], channels.test(index) ? values[index] : std::vector<double>()),
                            std::string(namedCase.name).c_str());
                    }
                }
            }
        }
    }

    void stopsWhenAsked()
    {
        std::stop_source source;
        source.request_stop();
        for (const SolverSettings &settings : {kClosedForm, kNewton}) {
            for (const ChannelSet &channels : {plottedChannels(), allChannels()}) {
                QVERIFY(!sample(Mechanism(), {0.0}, channels, settings, source.get_token()).complete);
                const Trajectory none = sample(Mechanism(), {}, channels, settings);
                QVERIFY(none.complete && none.time.empty() && none.summary == SamplingSummary());
            }
        }
    }

    void piecesEqualTheWholeSampling()
    {
        const Sampling sampling{0.0, 2.0, 70000};
        const Mechanism mechanism({.b = 40.0});
        const Trajectory whole = sample(mechanism, sampling.timeStamps(), only(kSlider), kClosedForm);
        std::vector<double> values;
        SamplingSummary summary;
        int pieces = 0;
        const auto take = [&](const Trajectory &piece) {
            values.insert(values.end(), piece[kSlider].begin(), piece[kSlider].end());
            summary.add(piece.summary);
            return ++pieces != 5;
        };
        sampleInPieces(mechanism, sampling, only(kSlider), kClosedForm, take);
        QCOMPARE(pieces, 3);
        QVERIFY(isSame(values, whole[kSlider]) && summary == whole.summary);
        sampleInPieces(mechanism, sampling, only(kSlider), kClosedForm, take); // stopped by take() in its second piece
        QCOMPARE(pieces, 5);
    }

    void exceptionsInThreadsReachTheCaller()
    {
        if (std::thread::hardware_concurrency() < 2) {
            QSKIP("needs two processors");
        }
        std::atomic<int> arrived = 0;
        const auto work = [&arrived, caller = std::this_thread::get_id()](std::size_t) {
            ++arrived;
            while (arrived < 2) { // so that each thread has one piece
                std::this_thread::yield();
            }
            if (std::this_thread::get_id() != caller) {
                throw std::bad_alloc();
            }
        };
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, inParallel(2, work));
    }

    void crankHasTheAngleAtTheFirstTime()
    {
        RandomMechanisms random(51);
        for (int i = 0; i < 500; ++i) {
            const Mechanism mechanism(random.next());
            const double theta2 = random.uniform(-20.0, 20.0);
            const double start = random.uniform(-5.0, 5.0);
            const double time = timeAtCrankAngle(mechanism, theta2, start).value();
            QVERIFY(angleError(mechanism, time, theta2) < 1e-10);
            QVERIFY(time >= start && time < start + period(mechanism) * (1.0 + 1e-9));

            const double angleAtStart = mechanism.omega2() * start + mechanism.theta20();
            QVERIFY(timeAtCrankAngle(mechanism, angleAtStart, start).value() - start < 1e-9);
        }
    }

    void crankHasTheAngleAtTheNearestTime()
    {
        RandomMechanisms random(52);
        for (int i = 0; i < 500; ++i) {
            const Mechanism mechanism(random.next());
            const double theta2 = random.uniform(-20.0, 20.0);
            const double start = random.uniform(-5.0, 5.0);
            const Sampling sampling{start, 1.5 * period(mechanism), 10};
            const double time = start + random.uniform(0.0, 1.0) * sampling.duration;
            const double nearest = nearestTimeAtCrankAngle(mechanism, sampling, theta2, time);
            QVERIFY(angleError(mechanism, nearest, theta2) < 1e-10);
            QVERIFY(nearest >= start && nearest <= start + sampling.duration);
            QVERIFY(std::abs(nearest - time) <= period(mechanism));

            // A time span in which the crank hardly ever reaches the angle.
            const Sampling brief{start, 1e-3 * period(mechanism), 10};
            const double end = nearestTimeAtCrankAngle(mechanism, brief, theta2, start);
            QVERIFY(
                angleError(mechanism, end, theta2) <=
                std::min(angleError(mechanism, start, theta2), angleError(mechanism, start + brief.duration, theta2)) +
                    1e-10);
        }
    }

    void aCrankAtRestHasOnlyOneAngle()
    {
        const Mechanism still({.omega2 = 0.0, .theta20 = 1.0});
        QCOMPARE(timeAtCrankAngle(still, 1.0, 3.0), 3.0);
        QVERIFY(!timeAtCrankAngle(still, 1.1, 3.0));
        QCOMPARE(nearestTimeAtCrankAngle(still, {}, 1.1, 0.3), 0.3);
    }

    /// The closed form does not use the constraint equations, so their agreement confirms both.
    void theConstraintEquationsHold()
    {
        const Mechanism mechanism;
        constexpr double kStep = 0.005; // s
        for (const SolverSettings &settings : {kClosedForm, kNewton}) {
            for (const double t : {0.0, 0.2, 0.55, 0.9}) {
                const TimeStepEquations equations = equationsAt(mechanism, t, kStep, settings);
                QVERIFY(equations.hasPosition() && equations.C.norm() <= 1e-12);
                QVERIFY((equations.Cq * equations.state.qDot + equations.Ct).norm() <= 1e-10);
                QVERIFY((equations.Cq * equations.state.qDDot - equations.Qd).norm() <= 1e-9);
                QVERIFY(equations.Qd.norm() > 1.0 && equations.Ct[CrankDrive] == -mechanism.omega2());
            }
            const TimeStepEquations none = equationsAt(Mechanism({.b = 40.0}), 0.75, kStep, settings);
            QVERIFY(none.state.status == Status::NotAssemblable && !none.hasPosition());
            QVERIFY(none.C.array().isNaN().all() && none.Cq.array().isNaN().all() && none.Qd.array().isNaN().all());
        }
        const TimeStepEquations last = equationsAt(mechanism, 0.2, 0.05, {Method::Newton, {1, 1e-8}});
        QCOMPARE(last.state.status, Status::IterationLimit);
        QVERIFY(last.hasPosition() && last.C.norm() > 1e-8 && last.Qd.array().isNaN().all());
    }

    void conditionNumberIsTheRatioOfTheSingularValues()
    {
        Matrix12 matrix = Matrix12::Zero();
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            matrix(i, (i + 5) % kCoordinateCount) = (i % 2 == 0 ? 1e-9 : -1e-9) * static_cast<double>(i + 1);
        }
        QVERIFY(std::abs(conditionNumber(matrix) - 12.0) <= 1e-12);
        matrix.row(4).setZero();
        QVERIFY(std::isinf(conditionNumber(matrix)));
    }
};

const Suite<TestSampling> suite("tst_sampling");

} // namespace tst_sampling

#include "tst_sampling.moc"
