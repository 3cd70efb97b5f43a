// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"

#include <QTest>

using namespace slidercrank;

namespace
{

/// What the closed form promises, of a channel's peak.
constexpr double kPromise = 1e-15;

/// Roundings between input and answer, in units of 2^-53: two for a sine, one for each sum and product, thrice those of
/// s.
constexpr double kRoundings = 16.0;

/// The size of each value together with that of the two terms that bodies 3 and 4 are the sum of: R4x = a cos θ2 + s
/// and R3 = (A + B)/2, where they cancel for no fault of the method. But R4x itself does not cancel.
std::array<double, kChannelCount> termSizes(const Parameters &parameters, const ExactState<Digits100> &exact)
{
    std::array<double, kChannelCount> sizes;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        sizes[index] = std::max(static_cast<double>(abs(exact.values[index])),
                                kExactZero * naturalSize(parameters, channelAt(index)));
    }
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        sizes[indexOf({R3x, order})] += sizes[indexOf({R4x, order})] + 2.0 * sizes[indexOf({R2x, order})];
        sizes[indexOf({R3y, order})] += sizes[indexOf({R4y, order})] + 2.0 * sizes[indexOf({R2y, order})];
        if (order != Order::Position) {
            sizes[indexOf({R4x, order})] += 2.0 * sizes[indexOf({R2x, order})];
        }
    }
    return sizes;
}

QString said(const Parameters &parameters, const Deviation &deviation)
{
    return QString::fromStdString(describe(parameters) + "\n    " + describe(deviation));
}

bool isRocker(const Parameters &p)
{
    return Digits50(p.b) < Digits50(p.a) + Digits50(std::abs(p.c));
}

} // namespace

Q_DECLARE_METATYPE(slidercrank::Parameters)

class tst_closed_form : public QObject
{
    Q_OBJECT

private slots:
    void judgeKnowsTable1();
    void isExactOnRandomMechanisms();
    void isExactOnNamedCases_data();
    void isExactOnNamedCases();
    void isExactAtTheDoublesNearestNinetyDegrees_data();
    void isExactAtTheDoublesNearestNinetyDegrees();
    void isExactBesideTheToggle_data();
    void isExactBesideTheToggle();
    void isExactUpToARockersLimits_data();
    void isExactUpToARockersLimits();
    void saysWhereNothingExists();
    void saysWhenTheInstantIsNotANumber();
    void motionAndStateAgree();
    void scalesWithTheMechanism();
};

/// Values of the report's own data: R4x(0) of b = 60, and the largest coupler angle there, 48.59°.
void tst_closed_form::judgeKnowsTable1()
{
    Parameters p;
    p.b = 60.0;
    const ExactState<Digits50> start = exactState<Digits50>(p, 0.0);
    const double R4xStart = static_cast<double>(start.values[indexOf({R4x, Order::Position})]);
    QVERIFY2(std::abs(R4xStart - 74.5436) < 5e-5, qPrintable(QString::number(R4xStart, 'g', 17)));
    const ExactState<Digits50> steep = exactState<Digits50>(p, 0.75);
    const double theta3 = static_cast<double>(steep.values[indexOf({Theta3, Order::Position})]) * kDegreesPerRadian;
    QVERIFY2(std::abs(theta3 - 48.59) < 5e-3, qPrintable(QString::number(theta3, 'g', 17)));

    // The judge's derivatives are those of its positions.
    const double kStep = 1e-12;
    for (const Branch branch : {Branch::Open, Branch::Crossed}) {
        p.branch = branch;
        ExactInput<Digits50> before(p, 0.3);
        ExactInput<Digits50> after(p, 0.3);
        before.t -= kStep;
        after.t += kStep;
        const ExactState<Digits50> here = exactState<Digits50>(p, 0.3);
        const ExactState<Digits50> left = exactState(before);
        const ExactState<Digits50> right = exactState(after);
        for (std::size_t index = 0; index < 2 * kCoordinateCount; ++index) {
            const Digits50 slope = (right.values[index] - left.values[index]) / (2 * Digits50(kStep));
            const double difference = static_cast<double>(abs(slope - here.values[index + kCoordinateCount]));
            QVERIFY2(difference < 1e-15, std::string(nameOf(channelAt(index))).c_str());
        }
    }
}

void tst_closed_form::isExactOnRandomMechanisms()
{
    constexpr int kMechanisms = 300;
    constexpr int kInstants = 8;
    constexpr int kPeakInstants = 200;
    RandomMechanisms random(20240501);
    Deviation worst;
    Parameters worstParameters;
    int outside = 0;
    for (int i = 0; i < kMechanisms; ++i) {
        Parameters p = random.next();
        const double turnTime = 2.0 * std::numbers::pi / std::abs(p.omega2);
        std::vector<double> turn;
        for (int k = 0; k < kPeakInstants; ++k) {
            turn.push_back(turnTime * k / kPeakInstants);
        }
        std::vector<double> instants;
        for (int k = 0; k < kInstants; ++k) {
            instants.push_back(random.uniform(0.0, turnTime));
        }
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            const std::vector<ExactState<long double>> run = exactRun<long double>(p, turn);
            const std::array<double, kChannelCount> tolerances = scaled(channelSizes<long double>(p, run), kPromise);
            const ClosedForm closedForm{Mechanism(p)};
            for (const double t : instants) {
                const State got = closedForm.stateAt(t);
                QCOMPARE(got.status, Status::Solved);
                const Deviation deviation = worstDeviation(got, exactState<Digits50>(p, t), t, tolerances);
                outside += deviation.accepted() ? 0 : 1;
                if (deviation.ratio() > worst.ratio()) {
                    worst = deviation;
                    worstParameters = p;
                }
            }
        }
    }
    qInfo("worst of %d states: %.3g of peak, %s", 2 * kMechanisms * kInstants, worst.ratio() * kPromise,
          qPrintable(said(worstParameters, worst)));
    QVERIFY2(outside == 0, qPrintable(QString("%1 states outside").arg(outside)));
}

void tst_closed_form::isExactOnNamedCases_data()
{
    QTest::addColumn<Parameters>("parameters");
    QTest::addColumn<std::vector<double>>("instants");
    for (const Case &which : allCases()) {
        if (!isRocker(which.parameters)) {
            QTest::newRow(std::string(which.name).c_str()) << which.parameters << instantsOf(which);
        }
    }
}

void tst_closed_form::isExactOnNamedCases()
{
    QFETCH(Parameters, parameters);
    QFETCH(std::vector<double>, instants);
    const std::vector<ExactState<Digits100>> run = exactRun<Digits100>(parameters, instants);
    const std::array<double, kChannelCount> tolerances = scaled(channelSizes<Digits100>(parameters, run), kPromise);
    const ClosedForm closedForm{Mechanism(parameters)};
    Deviation worst;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const State got = closedForm.stateAt(instants[i]);
        const Deviation deviation = worstDeviation(got, run[i], instants[i], tolerances);
        if (deviation.ratio() > worst.ratio()) {
            worst = deviation;
        }
        if (got.status != run[i].status) {
            QFAIL(qPrintable(QString("status %1 at t=%2, exact %3")
                                 .arg(int(got.status))
                                 .arg(instants[i], 0, 'g', 17)
                                 .arg(int(run[i].status))));
        }
    }
    qInfo("worst: %.3g of peak, %s", worst.ratio() * kPromise, qPrintable(said(parameters, worst)));
    QVERIFY2(worst.accepted(), qPrintable(said(parameters, worst)));
}

void tst_closed_form::isExactAtTheDoublesNearestNinetyDegrees_data()
{
    QTest::addColumn<Parameters>("parameters");
    for (const Case &which : allCases()) {
        if (!isRocker(which.parameters)) {
            QTest::newRow(std::string(which.name).c_str()) << which.parameters;
        }
    }
}

/// θ20 the doubles next to ±90° and the neighbours of those, at t = 0: every value of its own size, none hidden by a
/// peak elsewhere.
void tst_closed_form::isExactAtTheDoublesNearestNinetyDegrees()
{
    QFETCH(Parameters, parameters);
    const double quarter = 0.5 * std::numbers::pi;
    for (const double centre : {quarter, -quarter}) {
        for (const double angle : {centre, std::nextafter(centre, 0.0), std::nextafter(centre, 2.0 * centre)}) {
            Parameters p = parameters;
            p.theta20 = angle;
            const ExactState<Digits100> exact = exactState<Digits100>(p, 0.0);
            const State got = ClosedForm{Mechanism(p)}.stateAt(0.0);
            QCOMPARE(got.status, exact.status);
            const Deviation worst =
                worstDeviation(got, exact, 0.0, scaled(termSizes(p, exact), kRoundings * kUnitRoundoff));
            QVERIFY2(worst.accepted(), qPrintable(said(p, worst)));
        }
    }
}

void tst_closed_form::isExactBesideTheToggle_data()
{
    QTest::addColumn<Parameters>("parameters");
    for (const Case &which : hardCases()) {
        if (!isRocker(which.parameters) && which.sampling == Sampling{}) {
            QTest::newRow(std::string(which.name).c_str()) << which.parameters;
        }
    }
}

/// From 0.1 rad to 1e-16 rad on either side of ±90°. Sizes are those of the channel between half and twice that
/// distance.
void tst_closed_form::isExactBesideTheToggle()
{
    QFETCH(Parameters, parameters);
    Deviation worst;
    Parameters worstParameters;
    for (const double centre : {0.5 * std::numbers::pi, -0.5 * std::numbers::pi}) {
        for (double distance = 0.1; distance > 1e-16; distance *= 0.1) {
            std::vector<ExactState<Digits100>> neighbours;
            for (const double factor : {-2.0, -1.0, -0.5, 0.5, 1.0, 2.0}) {
                Parameters p = parameters;
                p.omega2 = 1.0;
                p.theta20 = centre;
                neighbours.push_back(exactState<Digits100>(p, factor * distance));
            }
            Parameters p = parameters;
            p.omega2 = 1.0;
            p.theta20 = centre;
            const std::array<double, kChannelCount> tolerances =
                scaled(channelSizes<Digits100>(p, neighbours), kRoundings * kUnitRoundoff);
            const ClosedForm closedForm{Mechanism(p)};
            for (const double t : {-distance, distance}) {
                const State got = closedForm.stateAt(t);
                QCOMPARE(got.status, Status::Solved);
                const Deviation deviation = worstDeviation(got, exactState<Digits100>(p, t), t, tolerances);
                if (deviation.ratio() > worst.ratio()) {
                    worst = deviation;
                    worstParameters = p;
                }
            }
        }
    }
    qInfo("worst: %.3g u of the neighbourhood", kRoundings * worst.ratio());
    QVERIFY2(worst.accepted(), qPrintable(said(worstParameters, worst)));
}

void tst_closed_form::isExactUpToARockersLimits_data()
{
    QTest::addColumn<Parameters>("parameters");
    for (const Case &which : hardCases()) {
        if (isRocker(which.parameters)) {
            QTest::newRow(std::string(which.name).c_str()) << which.parameters;
        }
    }
    const auto add = [](const char *name, double a, double b, double c, Branch branch) {
        QTest::newRow(name) << Parameters{a, b, c, 3.0, 1.0, branch};
    };
    add("by a hair, gap -1e-12", 20.0, 45.0 * (1.0 - 1e-12), 25.0, Branch::Crossed);
    add("by a unit in the last place", 20.0, std::nextafter(45.0, 0.0), 25.0, Branch::Open);
    add("locked but for 1e-10", 20.0, 5.0 * (1.0 + 1e-10), 25.0, Branch::Open);
    add("locked but for a unit in the last place", 20.0, std::nextafter(5.0, 6.0), -25.0, Branch::Crossed);
    add("two arcs that all but meet", 20.0, 14.999999, 5.0, Branch::Open);
    add("b = |c|", 20.0, 25.0, 25.0, Branch::Open);
    add("b/a = 1e-6", 1e3, 1e-3, 0.5, Branch::Open);
    add("b/a = 1e4", 1e-3, 25.0001, 25.0003, Branch::Open);
}

/// Near its limits a rocker's b - |h| is a difference, and a rounding in a, b, c or θ2 moves it by as much as itself:
/// no answer to rounded numbers is worth more than u(|f| + κ). To the numbers as given, it is right to the last digits.
void tst_closed_form::isExactUpToARockersLimits()
{
    QFETCH(Parameters, parameters);
    constexpr double kConditionRoundings = 4.0;
    constexpr double kNearTheLimit = 1e-4;
    constexpr double kAtTheLimit = 1e-30; // of the reach: what an angle in two parts cannot tell from the limit
    const double reach = parameters.a + parameters.b + std::abs(parameters.c);
    const Case which{{}, parameters, {0.0, 2.0 * std::numbers::pi / std::abs(parameters.omega2), 50}};

    // A whole turn, both sides of each limit, and the doubles around it: of t, and of θ20 at t = 0.
    std::vector<std::pair<Parameters, double>> places;
    for (const double t : which.sampling.instants()) {
        places.emplace_back(parameters, t);
    }
    for (const double limit : squareInstants(which)) {
        for (double distance = 1e-1; distance > 1e-16; distance *= 0.1) {
            places.emplace_back(parameters, limit - distance);
            places.emplace_back(parameters, limit + distance);
        }
        double t = limit;
        Parameters turned = parameters;
        turned.theta20 = std::remainder(parameters.omega2 * limit + parameters.theta20, 2.0 * std::numbers::pi);
        for (int i = 0; i < 3; ++i) {
            t = std::nextafter(t, -1.0);
            turned.theta20 = std::nextafter(turned.theta20, -10.0);
        }
        for (int i = 0; i < 7; ++i) {
            places.emplace_back(parameters, t);
            places.emplace_back(turned, 0.0);
            t = std::nextafter(t, 1e300);
            turned.theta20 = std::nextafter(turned.theta20, 10.0);
        }
    }

    Deviation worst;
    Deviation worstNear;
    for (const auto &[p, t] : places) {
        const ExactState<Digits100> exact = exactState<Digits100>(p, t);
        const State got = ClosedForm{Mechanism(p)}.stateAt(t);
        const double clearance = static_cast<double>(exact.clearance);
        if (std::abs(clearance) * p.b > kAtTheLimit * reach) {
            QVERIFY2(got.status == exact.status, qPrintable(QString("t=%1, clearance %2, status %3, exact %4")
                                                                .arg(t, 0, 'g', 17)
                                                                .arg(clearance)
                                                                .arg(int(got.status))
                                                                .arg(int(exact.status))));
        }
        if (got.status == Status::NotAssemblable || exact.status == Status::NotAssemblable) {
            continue;
        }
        const std::array<double, kChannelCount> kappa = conditioning<Digits100>(p, t);
        std::array<double, kChannelCount> sizes = termSizes(p, exact);
        std::array<double, kChannelCount> tolerances;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            tolerances[index] = kConditionRoundings * kUnitRoundoff * (sizes[index] + kappa[index]);
        }
        const Order last = got.status == Status::Solved ? Order::Acceleration : Order::Position;
        const Deviation deviation = worstDeviation(got, exact, t, tolerances, last);
        QVERIFY2(deviation.accepted(), qPrintable(said(p, deviation)));
        if (deviation.ratio() > worst.ratio()) {
            worst = deviation;
        }
        if (clearance < kNearTheLimit) {
            // Beside a dead centre R4x is a small difference.
            sizes[indexOf({R4x, Order::Position})] += 2.0 * sizes[indexOf({R2x, Order::Position})];
            const Deviation near = worstDeviation(got, exact, t, scaled(sizes, kRoundings * kUnitRoundoff), last);
            QVERIFY2(near.accepted(), qPrintable(said(p, near)));
            if (near.ratio() > worstNear.ratio()) {
                worstNear = near;
            }
        }
    }
    qInfo("worst: %.3g u(|f| + κ); near a limit %.3g u|f|", kConditionRoundings * worst.ratio(),
          kRoundings * worstNear.ratio());
}

void tst_closed_form::saysWhereNothingExists()
{
    Parameters p;
    p.b = 4.0;
    const ClosedForm closedForm{Mechanism(p)};
    for (const double t : Sampling{}.instants()) {
        const State state = closedForm.stateAt(t);
        QCOMPARE(state.status, Status::NotAssemblable);
        QVERIFY(state.q.array().isNaN().all());
        QVERIFY(state.qDot.array().isNaN().all());
        QVERIFY(state.qDDot.array().isNaN().all());
        QCOMPARE(closedForm.motionAt(t).status, Status::NotAssemblable);
        QVERIFY(std::isnan(closedForm.motionAt(t).R4x));
    }
}

void tst_closed_form::saysWhenTheInstantIsNotANumber()
{
    for (const double t : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308}) {
        const State state = ClosedForm{Mechanism()}.stateAt(t);
        QCOMPARE(state.status, Status::NotFinite);
        QVERIFY(state.q.array().isNaN().all());
        QVERIFY(state.qDDot.array().isNaN().all());
    }
}

/// The six plotted channels are the same numbers whichever way they are asked for.
void tst_closed_form::motionAndStateAgree()
{
    for (const Case &which : allCases()) {
        const ClosedForm closedForm{Mechanism(which.parameters)};
        for (const double t : instantsOf(which)) {
            const Motion motion = closedForm.motionAt(t);
            const State state = closedForm.stateAt(t);
            QCOMPARE(motion.status, state.status);
            const double motions[] = {motion.theta3, motion.R4x,        motion.theta3Dot,
                                      motion.R4xDot, motion.theta3DDot, motion.R4xDDot};
            for (std::size_t k = 0; k < kPlottedChannels.size(); ++k) {
                const double value = valueOf(state, kPlottedChannels[k]);
                QVERIFY(motions[k] == value || (std::isnan(motions[k]) && std::isnan(value)));
            }
        }
    }
}

/// A larger mechanism is the same mechanism: by powers of two, to the last bit.
void tst_closed_form::scalesWithTheMechanism()
{
    Parameters p;
    const State reference = ClosedForm{Mechanism(p)}.stateAt(0.3);
    for (const int exponent : {-40, -3, 5, 30}) {
        Parameters larger = p;
        larger.a = std::ldexp(p.a, exponent);
        larger.b = std::ldexp(p.b, exponent);
        larger.c = std::ldexp(p.c, exponent);
        const State state = ClosedForm{Mechanism(larger)}.stateAt(0.3);
        QCOMPARE(state.q[Theta3], reference.q[Theta3]);
        QCOMPARE(std::ldexp(state.q[R4x], -exponent), reference.q[R4x]);
        QCOMPARE(std::ldexp(state.qDDot[R3x], -exponent), reference.qDDot[R3x]);
    }
}

QTEST_APPLESS_MAIN(tst_closed_form)
#include "tst_closed_form.moc"
