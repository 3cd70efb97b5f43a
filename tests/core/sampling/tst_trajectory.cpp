// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/mechanism/in_parallel.h"
#include "core/newton/newton.h"
#include "core/sampling/trajectory.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"

#include <QTest>

#include <latch>
#include <new>
#include <thread>

using namespace slidercrank;

namespace
{

/// The same number, or both none.
bool same(double x, double y)
{
    return x == y || (std::isnan(x) && std::isnan(y));
}

ChannelSet only(std::initializer_list<Channel> channels)
{
    ChannelSet set;
    for (const Channel channel : channels) {
        set.set(indexOf(channel));
    }
    return set;
}

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

} // namespace

Q_DECLARE_METATYPE(slidercrank::SolverSettings)
Q_DECLARE_METATYPE(slidercrank::ChannelSet)

class tst_trajectory : public QObject
{
    Q_OBJECT

private slots:
    void defaultsAreTable2();
    void instantsIncludeBothEnds_data();
    void instantsIncludeBothEnds();
    void fillsOnlyWhatIsAskedFor_data();
    void fillsOnlyWhatIsAskedFor();
    void closedFormValuesAreThoseOfClosedForm();
    void newtonValuesAreThoseOfTheSolver();
    void plottedChannelsAreTheSameAloneAndAmongAll();
    void reportsWhereNothingExists_data();
    void reportsWhereNothingExists();
    void goesOnBehindAGap();
    void reportsWhereIterationsRanOut();
    void reportsSingularInstants();
    void takesAnyInstants();
    void stopsWhenAsked_data();
    void stopsWhenAsked();
    void whatAThreadThrowsReachesTheCaller();
};

void tst_trajectory::defaultsAreTable2()
{
    QCOMPARE(Sampling{}.steps, 200);
    QCOMPARE(Sampling{}.start, 0.0);
    QCOMPARE(Sampling{}.duration, 1.0);
    QCOMPARE(SolverSettings{}.method, Method::Newton);
    QCOMPARE(SolverSettings{}.newton.maxIterations, 10);
    QCOMPARE(SolverSettings{}.newton.tolerance, 1e-8);
}

void tst_trajectory::instantsIncludeBothEnds_data()
{
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("duration");
    QTest::addColumn<int>("steps");
    QTest::newRow("the report") << 0.0 << 1.0 << 200;
    QTest::newRow("one step") << 0.0 << 1.0 << 1;
    QTest::newRow("a third of a second in 7") << 0.25 << 1.0 / 3.0 << 7;
    QTest::newRow("backwards in time") << 1.0 << -1.0 << 10;
    QTest::newRow("one instant") << 2.0 << 0.0 << 3;
    QTest::newRow("late") << 1e9 << 1.0 << 200;
}

void tst_trajectory::instantsIncludeBothEnds()
{
    QFETCH(double, start);
    QFETCH(double, duration);
    QFETCH(int, steps);
    const Sampling sampling{start, duration, steps};
    const std::vector<double> instants = sampling.instants();
    QCOMPARE(instants.size(), std::size_t(steps) + 1);
    QCOMPARE(instants.front(), start);
    QCOMPARE(instants.back(), start + duration);
    for (int i = 0; i <= steps; ++i) {
        QCOMPARE(instants[std::size_t(i)], start + duration * i / steps);
        QCOMPARE(sampling.instant(i), instants[std::size_t(i)]);
    }
}

void tst_trajectory::fillsOnlyWhatIsAskedFor_data()
{
    QTest::addColumn<SolverSettings>("settings");
    QTest::addColumn<ChannelSet>("channels");
    for (const Method method : {Method::Newton, Method::ClosedForm}) {
        const char *name = method == Method::Newton ? "Newton" : "closed form";
        const SolverSettings settings{method, {}};
        QTest::addRow("%s, nothing", name) << settings << ChannelSet();
        QTest::addRow("%s, one plotted", name) << settings << only({{R4x, Order::Velocity}});
        QTest::addRow("%s, one other", name) << settings << only({{R3y, Order::Acceleration}});
        QTest::addRow("%s, a few", name)
            << settings << only({{Theta3, Order::Position}, {R1x, Order::Position}, {Theta4, Order::Acceleration}});
        QTest::addRow("%s, plotted", name) << settings << plottedChannels();
        QTest::addRow("%s, all", name) << settings << allChannels();
    }
}

/// And those have the same values as among all.
void tst_trajectory::fillsOnlyWhatIsAskedFor()
{
    QFETCH(SolverSettings, settings);
    QFETCH(ChannelSet, channels);
    const std::vector<double> instants = Sampling{0.0, 1.0, 20}.instants();
    const Trajectory trajectory = sample(Mechanism(), instants, channels, settings);
    const Trajectory everything = sample(Mechanism(), instants, allChannels(), settings);
    QVERIFY(trajectory.complete);
    QCOMPARE(trajectory.time, instants);
    QCOMPARE(trajectory.status.size(), instants.size());
    QCOMPARE(trajectory.count(Status::Solved), instants.size());
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        const Channel channel = channelAt(index);
        if (channels.test(index)) {
            QCOMPARE(trajectory[channel], everything[channel]);
        } else {
            QVERIFY2(trajectory[channel].empty(), std::string(nameOf(channel)).c_str());
        }
    }
}

/// In the author's units.
void tst_trajectory::closedFormValuesAreThoseOfClosedForm()
{
    for (const Case &which : allCases()) {
        const Mechanism mechanism(which.parameters);
        const std::vector<double> instants = instantsOf(which);
        const Trajectory trajectory = sample(mechanism, instants, allChannels(), {Method::ClosedForm, {}});
        const ClosedForm closedForm(mechanism);
        QCOMPARE(trajectory.iterations, 0LL);
        QCOMPARE(trajectory.mostIterations, 0);
        QCOMPARE(trajectory.largestResidual, 0.0);
        for (std::size_t i = 0; i < instants.size(); ++i) {
            const State state = closedForm.stateAt(instants[i]);
            QCOMPARE(trajectory.status[i], state.status);
            for (std::size_t index = 0; index < kChannelCount; ++index) {
                const Channel channel = channelAt(index);
                const double expected = toFileUnit(channel, valueOf(state, channel));
                if (!same(trajectory[channel][i], expected)) {
                    QFAIL(qPrintable(QString("%1, %2 at t=%3: %4, expected %5")
                                         .arg(QString::fromStdString(std::string(which.name)))
                                         .arg(QString::fromStdString(std::string(nameOf(channel))))
                                         .arg(instants[i], 0, 'g', 17)
                                         .arg(trajectory[channel][i], 0, 'g', 17)
                                         .arg(expected, 0, 'g', 17)));
                }
            }
        }
    }
}

/// Each instant starts from the one before; the sums of iterations and the largest residual are those of the instants.
void tst_trajectory::newtonValuesAreThoseOfTheSolver()
{
    const Mechanism mechanism;
    const std::vector<double> instants = Sampling{}.instants();
    const SolverSettings settings;
    const Trajectory trajectory = sample(mechanism, instants, allChannels(), settings);
    NewtonResult last;
    long long iterations = 0;
    int most = 0;
    double residual = 0.0;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        last = i == 0 ? assemble(mechanism, instants[i], settings.newton)
                      : track(mechanism, instants[i], last.q, settings.newton);
        iterations += last.iterations;
        most = std::max(most, last.iterations);
        residual = std::max(residual, last.residual());
        const State state = differentiate(mechanism, last.q, last.residual());
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            const Channel channel = channelAt(index);
            QCOMPARE(trajectory[channel][i], toFileUnit(channel, valueOf(state, channel)));
        }
    }
    QCOMPARE(trajectory.count(Status::Solved), instants.size());
    QCOMPARE(trajectory.iterations, iterations);
    QCOMPARE(trajectory.mostIterations, most);
    QCOMPARE(trajectory.largestResidual, residual);
}

/// The closed form has a shorter way for the six alone: the numbers are the same.
void tst_trajectory::plottedChannelsAreTheSameAloneAndAmongAll()
{
    for (const Case &which : allCases()) {
        const Mechanism mechanism(which.parameters);
        const std::vector<double> instants = instantsOf(which);
        const Trajectory alone = sample(mechanism, instants, plottedChannels(), {Method::ClosedForm, {}});
        const Trajectory among = sample(mechanism, instants, allChannels(), {Method::ClosedForm, {}});
        QVERIFY(alone.status == among.status);
        for (const Channel channel : kPlottedChannels) {
            for (std::size_t i = 0; i < instants.size(); ++i) {
                QVERIFY2(same(alone[channel][i], among[channel][i]), std::string(which.name).c_str());
            }
        }
    }
}

void tst_trajectory::reportsWhereNothingExists_data()
{
    QTest::addColumn<Method>("method");
    QTest::newRow("Newton") << Method::Newton;
    QTest::newRow("closed form") << Method::ClosedForm;
}

void tst_trajectory::reportsWhereNothingExists()
{
    QFETCH(Method, method);
    const std::vector<double> instants = Sampling{}.instants();
    const Trajectory never = sample(Mechanism(withCoupler(4.0)), instants, allChannels(), {method, {}});
    QCOMPARE(never.count(Status::NotAssemblable), instants.size());
    QCOMPARE(never.iterations, 0LL);
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        for (const double value : never.values[index]) {
            QVERIFY(std::isnan(value));
        }
    }

    // A rocker: sin θ2 >= (25 - 40)/20 = -3/4, of the 201 instants those from -48.59° to 228.59°.
    const Trajectory rocker = sample(Mechanism(withCoupler(40.0)), instants, plottedChannels(), {method, {}});
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const bool exists = std::sin(2.0 * std::numbers::pi * instants[i]) >= -0.75;
        QCOMPARE(rocker.status[i] == Status::NotAssemblable, !exists);
        for (const Channel channel : kPlottedChannels) {
            QCOMPARE(std::isnan(rocker[channel][i]), !exists);
        }
    }

    const std::vector<double> bad = {0.1, std::numeric_limits<double>::quiet_NaN(), 0.2};
    const Trajectory hole = sample(Mechanism(), bad, plottedChannels(), {method, {}});
    QCOMPARE(hole.status[0], Status::Solved);
    QCOMPARE(hole.status[1], Status::NotFinite);
    QCOMPARE(hole.status[2], Status::Solved);
    QVERIFY(std::isnan(hole[Channel{R4x, Order::Position}][1]));
}

/// Behind the arc where nothing exists Newton-Raphson finds the same branch again.
void tst_trajectory::goesOnBehindAGap()
{
    for (const Branch branch : {Branch::Open, Branch::Crossed}) {
        Parameters parameters = withCoupler(40.0);
        parameters.branch = branch;
        const std::vector<double> instants = Sampling{0.0, 3.0, 200}.instants();
        const Channel R4{R4x, Order::Position};
        const Trajectory newton = sample(Mechanism(parameters), instants, only({R4}), {Method::Newton, {}});
        const Trajectory closed = sample(Mechanism(parameters), instants, only({R4}), {Method::ClosedForm, {}});
        QVERIFY(newton.status == closed.status);
        for (std::size_t i = 0; i < instants.size(); ++i) {
            if (newton.status[i] == Status::Solved) {
                QVERIFY(std::abs(newton[R4][i] - closed[R4][i]) < 1e-6);
            }
        }
    }
}

void tst_trajectory::reportsWhereIterationsRanOut()
{
    SolverSettings settings;
    settings.newton.maxIterations = 1;
    const std::vector<double> instants = Sampling{}.instants();
    const Trajectory trajectory = sample(Mechanism(), instants, allChannels(), settings);
    QCOMPARE(trajectory.status.front(), Status::Solved); // assembled, under a cap of its own
    QVERIFY(trajectory.count(Status::IterationLimit) > 0);
    for (std::size_t i = 0; i < instants.size(); ++i) {
        if (trajectory.status[i] == Status::IterationLimit) {
            QVERIFY(std::isnan(trajectory[Channel{R4x, Order::Position}][i]));
            QVERIFY(std::isnan(trajectory[Channel{Theta3, Order::Acceleration}][i]));
        }
    }
}

/// Position there, derivatives not.
void tst_trajectory::reportsSingularInstants()
{
    SolverSettings settings;
    settings.newton = {50, 0.0};
    const std::vector<double> toggle = {0.75};
    const Trajectory trajectory = sample(Mechanism(withCoupler(45.0)), toggle, allChannels(), settings);
    QCOMPARE(trajectory.status[0], Status::Singular);
    QVERIFY(std::abs(trajectory[Channel{Theta3, Order::Position}][0] - 90.0) < 1e-5);
    QVERIFY(std::isnan(trajectory[Channel{Theta3, Order::Velocity}][0]));
    QVERIFY(std::isnan(trajectory[Channel{R4x, Order::Acceleration}][0]));
    QCOMPARE(trajectory.count(Status::Singular), std::size_t(1));
    QCOMPARE(trajectory.count(Status::Solved), std::size_t(0));
}

/// In any order, or none at all.
void tst_trajectory::takesAnyInstants()
{
    const std::vector<double> instants = {0.9, 0.1, 0.1, -3.3, 0.55};
    for (const Method method : {Method::Newton, Method::ClosedForm}) {
        const Trajectory trajectory = sample(Mechanism(), instants, plottedChannels(), {method, {50, 0.0}});
        const ClosedForm closedForm{Mechanism()};
        for (std::size_t i = 0; i < instants.size(); ++i) {
            const Motion motion = closedForm.motionAt(instants[i]);
            QCOMPARE(trajectory.status[i], Status::Solved);
            QVERIFY(std::abs(trajectory[Channel{R4x, Order::Position}][i] - motion.R4x) < 1e-12);
        }
        const Trajectory none = sample(Mechanism(), {}, plottedChannels(), {method, {}});
        QVERIFY(none.complete);
        QVERIFY(none.time.empty() && none.status.empty());
    }
}

void tst_trajectory::stopsWhenAsked_data()
{
    reportsWhereNothingExists_data();
}

void tst_trajectory::stopsWhenAsked()
{
    QFETCH(Method, method);
    std::stop_source source;
    const std::vector<double> instants = Sampling{}.instants();
    QVERIFY(sample(Mechanism(), instants, plottedChannels(), {method, {}}, source.get_token()).complete);
    source.request_stop();
    QVERIFY(!sample(Mechanism(), instants, plottedChannels(), {method, {}}, source.get_token()).complete);
}

void tst_trajectory::whatAThreadThrowsReachesTheCaller()
{
    if (std::thread::hardware_concurrency() < 2) {
        QSKIP("there is no other thread on one processor");
    }
    std::latch both(2);
    const auto work = [&both, caller = std::this_thread::get_id()](std::size_t) {
        both.arrive_and_wait(); // one piece each
        if (std::this_thread::get_id() != caller) {
            throw std::bad_alloc();
        }
    };
    QVERIFY_THROWS_EXCEPTION(std::bad_alloc, inParallel(2, work));
}

QTEST_APPLESS_MAIN(tst_trajectory)
#include "tst_trajectory.moc"
