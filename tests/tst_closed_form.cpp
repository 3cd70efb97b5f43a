// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cases.h"
#include "core/closed_form.h"
#include "core/exact_motion.h"
#include "random_mechanisms.h"

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
    void losesNoMoreThanARockerMust_data();
    void losesNoMoreThanARockerMust();
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

void tst_closed_form::losesNoMoreThanARockerMust_data()
{
    QTest::addColumn<Parameters>("parameters");
    QTest::addColumn<std::vector<double>>("instants");
    for (const Case &which : hardCases()) {
        if (isRocker(which.parameters)) {
            std::vector<double> instants = instantsOf(which);
            for (const double limit : squareInstants(which)) {
                for (double distance = 1e-2; distance > 1e-16; distance *= 0.1) {
                    instants.push_back(limit - distance);
                    instants.push_back(limit + distance);
                }
            }
            QTest::newRow(std::string(which.name).c_str()) << which.parameters << instants;
        }
    }
}

/// Near its limits a rocker's b - |h| is a difference, and a rounding in it is as bad as one of a, b, c or θ2: no
/// answer computed from rounded numbers can promise less than u(|f| + κ). Closer to a limit than some hundred of them,
/// nothing but cos²θ3 = (b² - h²)/b² to within a few is left, and at the limit itself not even whether there is a
/// position.
void tst_closed_form::losesNoMoreThanARockerMust()
{
    QFETCH(Parameters, parameters);
    QFETCH(std::vector<double>, instants);
    constexpr double kConditionRoundings = 4.0;
    constexpr double kNearTheLimit = 1e-12;
    constexpr double kAtTheLimit = 1e-14;
    const double fewRoundings = std::sqrt(4.0 * kRoundings * kUnitRoundoff);
    const ClosedForm closedForm{Mechanism(parameters)};
    Deviation worst;
    for (const double t : instants) {
        const ExactState<Digits100> exact = exactState<Digits100>(parameters, t);
        const State got = closedForm.stateAt(t);
        const double clearance = static_cast<double>(exact.clearance);
        const QString where = QString("t=%1, clearance %2, status %3, exact %4")
                                  .arg(t, 0, 'g', 17)
                                  .arg(clearance)
                                  .arg(int(got.status))
                                  .arg(int(exact.status));
        if (std::abs(clearance) > kAtTheLimit) {
            QVERIFY2(got.status == exact.status, qPrintable(where));
        }
        if (got.status == Status::NotAssemblable || exact.status == Status::NotAssemblable) {
            continue;
        }
        std::array<double, kChannelCount> tolerances;
        Order last = Order::Acceleration;
        if (clearance > kNearTheLimit) {
            const std::array<double, kChannelCount> kappa = conditioning<Digits100>(parameters, t);
            const std::array<double, kChannelCount> sizes = termSizes(parameters, exact);
            for (std::size_t index = 0; index < kChannelCount; ++index) {
                tolerances[index] = kConditionRoundings * kUnitRoundoff * (sizes[index] + kappa[index]);
            }
        } else {
            last = Order::Position;
            tolerances.fill(fewRoundings * parameters.b);
            tolerances[indexOf({Theta3, Order::Position})] = fewRoundings;
            tolerances[indexOf({Theta2, Order::Position})] = kUnitRoundoff * std::abs(got.q[Theta2]);
        }
        const Deviation deviation = worstDeviation(got, exact, t, tolerances, last);
        if (deviation.ratio() > worst.ratio()) {
            worst = deviation;
        }
    }
    qInfo("worst: %.3g of the tolerance, %s", worst.ratio(), qPrintable(said(parameters, worst)));
    QVERIFY2(worst.accepted(), qPrintable(said(parameters, worst)));
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
