// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the closed form with multiple-precision results, and its evaluation of many time stamps with that of one.

#include "core/closed_form/state_at.h"
#include "core/closed_form/vector_targets.h"
#include "tests/support/all_cases.h"
#include "tests/support/deviation.h"
#include "tests/support/mechanism_list.h"
#include "tests/support/suite.h"

#include <QTest>
#include <hwy/highway.h>

using namespace slidercrank;

namespace tst_closed_form
{

/// The documented largest error of the closed form, relative to a channel's peak.
constexpr double kDocumentedError = 1e-15;

/// Accumulated rounding error in units of 2^-53: two for a sine, one for each sum and product, three times the error
/// of s = b cos θ3.
constexpr double kRoundings = 16.0;

constexpr double kQuarter = 0.5 * std::numbers::pi;

QString text(const Parameters &parameters, const Deviation &deviation)
{
    return QString::fromStdString(describe(parameters) + "\n    " + describe(deviation));
}

/// Returns the size of each value plus that of its terms, which may cancel in the channels of bodies 3 and 4:
/// R4x = a cos θ2 + s and R3 = (A + B)/2. The terms of the position R4x itself do not cancel.
std::array<double, kChannelCount> termSizes(const Parameters &parameters, const ExactState &exact)
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

/// Records the largest deviation, in units of its tolerance, and its mechanism.
struct Worst {
    Deviation deviation;
    Parameters parameters;

    void add(const Parameters &p, const Deviation &next)
    {
        if (!(next.ratio() <= deviation.ratio())) {
            deviation = next;
            parameters = p;
        }
    }
    void check(const char *what, double unit) const
    {
        qInfo("worst: %.3g %s, %s", unit * deviation.ratio(), what, qPrintable(text(parameters, deviation)));
        QVERIFY2(deviation.accepted(), qPrintable(text(parameters, deviation)));
    }
};

std::vector<double> randomTimes(RandomMechanisms &random, int count, double from, double to)
{
    std::vector<double> times;
    for (int k = 0; k < count; ++k) {
        times.push_back(random.uniform(from, to));
    }
    return times;
}

/// Evaluates all time stamps at once with every instruction set of this processor, and compares them bit by bit with
/// the evaluation of single time stamps. `wanted` has a bit for each plotted channel. Returns the first difference, or
/// an empty text.
QString findBatchDifference(const Parameters &parameters, std::span<const double> times, unsigned wanted = 63)
{
    constexpr double kNotWritten = -12345.0;
    constexpr std::size_t kGuardElements = 16; // behind each channel; must not be written
    const ClosedForm closedForm{Mechanism(parameters)};
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        PlottedColumns columns{};
        std::array<std::vector<double>, columns.size()> values;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            values[k].assign(times.size() + kGuardElements, kNotWritten);
            columns[k] = (wanted >> k & 1U) != 0 ? values[k].data() : nullptr;
        }
        std::vector<Status> statuses(times.size(), Status::IterationLimit);
        closedForm.evaluate(times, columns, statuses);
        hwy::SetSupportedTargetsForTest(0);
        for (std::size_t i = 0; i < times.size() + kGuardElements; ++i) {
            const bool isBehind = i >= times.size();
            const Motion motion = isBehind ? Motion() : closedForm.motionAt(times[i]);
            const auto expected = motion.plotted();
            bool isSame = isBehind || statuses[i] == motion.status;
            for (std::size_t k = 0; k < columns.size(); ++k) {
                const double value = columns[k] && !isBehind ? expected[k] : kNotWritten;
                isSame = isSame && (values[k][i] == value || (std::isnan(values[k][i]) && std::isnan(value)));
            }
            if (!isSame) {
                return QStringLiteral("%1, %2, time stamp %3 of %4")
                    .arg(QString::fromStdString(describe(parameters)), QString(hwy::TargetName(target)))
                    .arg(i)
                    .arg(times.size());
            }
        }
    }
    return {};
}

class TestClosedForm : public QObject
{
    Q_OBJECT

private slots:
    /// The multiple-precision results also agree with the reference file: R4x(0) for b = 60.
    void exactDerivativesMatchExactPositions()
    {
        const double kStep = 1e-12;
        Parameters p{.b = 60.0};
        const double start = static_cast<double>(exactState(p, 0.0).values[indexOf({R4x, Order::Position})]);
        QVERIFY(std::abs(start - 74.5436) < 5e-5);
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            ExactInput before(p, 0.3);
            ExactInput after(p, 0.3);
            before.t -= kStep;
            after.t += kStep;
            const ExactState here = exactState(p, 0.3);
            for (std::size_t index = 0; index < 2 * kCoordinateCount; ++index) {
                const ManyDigits slope =
                    (exactState(after).values[index] - exactState(before).values[index]) / (2 * ManyDigits(kStep));
                QVERIFY(static_cast<double>(abs(slope - here.values[index + kCoordinateCount])) < 1e-15);
            }
        }
    }

    /// κ of θ2 = ω2 t + θ20 is 2 ω2 t + θ20, and that of R4y = c is c.
    void conditioningOfSumsIsThatOfTheirTerms()
    {
        const Parameters p{.theta20 = 0.5};
        const auto kappa = conditioning(p, 0.25);
        QCOMPARE(kappa[indexOf({Theta2, Order::Position})], 0.5 * p.omega2 + 0.5);
        QCOMPARE(kappa[indexOf({R4y, Order::Position})], p.c);
    }

    void isExactOnRandomMechanisms()
    {
        RandomMechanisms random(20240501);
        Worst worst;
        for (int i = 0; i < 300; ++i) {
            Parameters p = random.next();
            const double turn = 2.0 * std::numbers::pi / std::abs(p.omega2);
            const std::vector<double> times = randomTimes(random, 8, 0.0, turn);
            for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                p.branch = branch;
                const std::vector<double> around = Sampling{0.0, turn, 200}.timeStamps();
                const auto tolerances = scaled(roughSizes(p, around), kDocumentedError);
                for (const double t : times) {
                    const State got = ClosedForm{Mechanism(p)}.stateAt(t);
                    QCOMPARE(got.status, Status::Solved);
                    worst.add(p, worstDeviation(got, exactState(p, t), t, tolerances));
                }
            }
        }
        worst.check("of peak", kDocumentedError);
    }

    /// The time stamps include the doubles closest to a toggle (timeStampsOf()).
    void isExactOnNamedCases()
    {
        Worst worst;
        for (const Case &namedCase : allCases()) {
            const Parameters &p = namedCase.parameters;
            if (isRocker(p)) {
                continue;
            }
            const std::vector<double> times = timeStampsOf(namedCase);
            const std::vector<ExactState> run = exactRun(p, times);
            const auto tolerances = scaled(channelSizes(p, run), kDocumentedError);
            for (std::size_t i = 0; i < times.size(); ++i) {
                const State got = ClosedForm{Mechanism(p)}.stateAt(times[i]);
                QVERIFY2(got.status == run[i].status, describe(p).c_str());
                worst.add(p, worstDeviation(got, run[i], times[i], tolerances));
            }
        }
        worst.check("of peak", kDocumentedError);
    }

    /// At the doubles closest to ±90° and their neighbours, the error is relative to each value, not to the channel's
    /// peak. At distances from 1e-16 to 0.1 rad it is relative to the channel's size between half and twice that
    /// distance.
    void isExactNearNinetyDegrees()
    {
        Worst worst;
        for (const Case &namedCase : allCases()) {
            if (isRocker(namedCase.parameters)) {
                continue;
            }
            for (const double centre : {kQuarter, -kQuarter}) {
                for (const double angle : {centre, std::nextafter(centre, 0.0), std::nextafter(centre, 2.0 * centre)}) {
                    Parameters p = namedCase.parameters;
                    p.theta20 = angle;
                    const ExactState exact = exactState(p, 0.0);
                    const State got = ClosedForm{Mechanism(p)}.stateAt(0.0);
                    QCOMPARE(got.status, exact.status);
                    worst.add(p,
                              worstDeviation(got, exact, 0.0, scaled(termSizes(p, exact), kRoundings * kUnitRoundoff)));
                }
                Parameters p = namedCase.parameters;
                p.omega2 = 1.0;
                p.theta20 = centre;
                for (double distance = 0.1; distance > 1e-16; distance *= 0.1) {
                    std::vector<double> near;
                    for (const double factor : {-2.0, -1.0, -0.5, 0.5, 1.0, 2.0}) {
                        near.push_back(factor * distance);
                    }
                    const std::vector<ExactState> exact = exactRun(p, near);
                    const auto tolerances = scaled(channelSizes(p, exact), kRoundings * kUnitRoundoff);
                    for (const std::size_t i : {1, 4}) { // -distance and +distance
                        const State got = ClosedForm{Mechanism(p)}.stateAt(near[i]);
                        worst.add(p, worstDeviation(got, exact[i], near[i], tolerances));
                    }
                }
            }
        }
        worst.check("u of the neighbourhood", kRoundings);
    }

    void isExactUpToARockersLimits_data()
    {
        QTest::addColumn<Parameters>("parameters");
        for (const Case &namedCase : hardCases()) {
            if (isRocker(namedCase.parameters)) {
                QTest::newRow(std::string(namedCase.name).c_str()) << namedCase.parameters;
            }
        }
        for (const NamedMechanism &rocker : difficultRockers()) {
            QTest::newRow(rocker.name.c_str()) << rocker.parameters;
        }
    }

    /// Near the limits of a rocker, rounding a, b, c or θ2 can change b - |h| by its own size, where h is the height of
    /// B above A. Then no result for rounded inputs is better than u(|f| + κ). For the exact inputs the
    /// result is accurate to the last digits.
    void isExactUpToARockersLimits()
    {
        QFETCH(const Parameters, parameters);
        constexpr double kConditionRoundings = 4.0;
        constexpr double kNearTheLimit = 1e-4;
        constexpr double kAtTheLimit = 1e-30; // relative to a + b + |c|: a two-part angle resolves no smaller distance
        const Case turn{.name = {},
                        .parameters = parameters,
                        .sampling = {0.0, 2.0 * std::numbers::pi / std::abs(parameters.omega2), 50}};

        // A whole turn, both sides of each limit, and the neighbouring doubles of t, and of θ20 at t = 0.
        std::vector<std::pair<Parameters, double>> positions; // mechanism and time
        for (const double t : turn.sampling.timeStamps()) {
            positions.emplace_back(parameters, t);
        }
        for (const double limit : perpendicularTimes(turn)) {
            for (double distance = 1e-1; distance > 1e-16; distance *= 0.1) {
                positions.emplace_back(parameters, limit - distance);
                positions.emplace_back(parameters, limit + distance);
            }
            double t = limit;
            Parameters turned = parameters;
            turned.theta20 = std::remainder(parameters.omega2 * limit + parameters.theta20, 2.0 * std::numbers::pi);
            for (int i = -3; i <= 3; ++i) {
                positions.emplace_back(parameters, t + i * (std::nextafter(t, 1e300) - t));
                positions.emplace_back(turned, 0.0);
                positions.back().first.theta20 += i * (std::nextafter(turned.theta20, 10.0) - turned.theta20);
            }
        }
        Worst worst;
        Worst worstNear;
        for (const auto &[p, t] : positions) {
            const ExactState exact = exactState(p, t);
            const State got = ClosedForm{Mechanism(p)}.stateAt(t);
            const double clearance = static_cast<double>(exact.clearance);
            if (std::abs(clearance) * p.b > kAtTheLimit * characteristicLength(p)) {
                QVERIFY2(got.status == exact.status, qPrintable(QStringLiteral("t = %1").arg(t, 0, 'g', 17)));
            }
            if (got.status == Status::NotAssemblable || exact.status == Status::NotAssemblable) {
                continue;
            }
            std::array<double, kChannelCount> sizes = termSizes(p, exact);
            std::array<double, kChannelCount> tolerances = conditioning(p, t);
            for (std::size_t index = 0; index < kChannelCount; ++index) {
                tolerances[index] = kConditionRoundings * kUnitRoundoff * (sizes[index] + tolerances[index]);
            }
            const Order last = got.status == Status::Solved ? Order::Acceleration : Order::Position;
            worst.add(p, worstDeviation(got, exact, t, tolerances, last));
            if (clearance < kNearTheLimit) {
                // Close to a dead centre, R4x is a small difference of its terms.
                sizes[indexOf({R4x, Order::Position})] += 2.0 * sizes[indexOf({R2x, Order::Position})];
                worstNear.add(p, worstDeviation(got, exact, t, scaled(sizes, kRoundings * kUnitRoundoff), last));
            }
        }
        worst.check("u(|f| + κ)", kConditionRoundings);
        worstNear.check("u|f| near a limit", kRoundings);
    }

    /// Tests time stamps up to 1e15 s, and both sides of 1.6e6 rad, the largest angle that the vectorized code reduces.
    void isExactAtAnyCrankAngle()
    {
        const Parameters p{.b = 60.0};
        auto tolerances = scaled(roughSizes(p, Sampling{}.timeStamps()), 2.0 * kDocumentedError);
        tolerances[indexOf({Theta2, Order::Position})] =
            kInfinity; // the angle grows, and one double cannot represent it
        const double limit = 1.6e6 / p.omega2;
        std::vector<double> times{limit, std::nextafter(limit, 0.0), std::nextafter(limit, 1e9), 0.999 * limit};
        for (double t = 0.1; t < 1e15; t *= 1.37) {
            times.push_back(t);
            times.push_back(-t);
        }
        for (double quarter = 0.25; quarter < limit; quarter *= 2.0) {
            times.push_back(quarter);
            times.push_back(std::nextafter(quarter, 0.0));
        }
        Worst worst;
        for (const double t : times) {
            worst.add(p, worstDeviation(ClosedForm{Mechanism(p)}.stateAt(t), exactState(p, t), t, tolerances));
        }
        worst.check("of peak", 2.0 * kDocumentedError);
        QCOMPARE(findBatchDifference(p, times), QString());
    }

    /// Tests rockers, both branches, arrays of any length and any selection of channels. The arrays of channels that
    /// are not selected must not be written.
    void manyTimeStampsEqualSingleOnes()
    {
        QVERIFY(!hwy::SupportedAndGeneratedTargets().empty());
        RandomMechanisms random(20240503);
        for (const auto &[name, parameters] : mechanismList(200)) {
            Parameters p = parameters;
            std::vector<double> times = randomTimes(random, 61, -100.0, 100.0);
            std::ranges::copy(perpendicularTimes({.name = {}, .parameters = p}), std::back_inserter(times));
            for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                p.branch = branch;
                QCOMPARE(findBatchDifference(p, times), QString());
            }
        }
        const std::vector<double> times = Sampling{0.0, 1.0, 300}.timeStamps();
        for (std::size_t length = 0; length <= 260; length += length < 40 ? 1 : 11) {
            for (const std::size_t from : {0, 1, 3}) {
                QCOMPARE(findBatchDifference(Parameters(), std::span(times).subspan(from, length)), QString());
            }
        }
        for (unsigned wanted = 0; wanted < 64; ++wanted) {
            QCOMPARE(findBatchDifference(Parameters(), std::span(times).first(70), wanted), QString());
        }
    }

    /// Puts every kind of time stamp that the vectorized code cannot process at every position among ordinary ones.
    /// Coordinates and derivatives that do not exist are NaN.
    void specialTimeStampsDoNotAffectOthers()
    {
        const Parameters locked{.b = 5.0, .c = 25.0, .theta20 = kQuarter}; // in its only pose at t = 0
        struct Row {
            Parameters parameters;
            double t;
            Status status;
        };
        for (const auto &[parameters, special, status] :
             {Row{{}, kNone, Status::NotFinite}, Row{{}, kInfinity, Status::NotFinite},
              Row{{}, -kInfinity, Status::NotFinite}, Row{{}, 1e308, Status::NotFinite},
              Row{{.b = 40.0}, 0.75, Status::NotAssemblable}, Row{locked, 0.0, Status::Singular},
              Row{{}, 1e9 + 0.3, Status::Solved}}) {
            const State state = ClosedForm{Mechanism(parameters)}.stateAt(special);
            const bool isSolved = status == Status::Solved;
            QCOMPARE(state.status, status);
            for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
                QCOMPARE(std::isfinite(state.q[i]), isSolved || status == Status::Singular);
                QVERIFY(std::isfinite(state.qDot[i]) == isSolved && std::isfinite(state.qDDot[i]) == isSolved);
            }
            for (std::size_t length = 1; length <= 20; ++length) {
                for (std::size_t position = 0; position < length; ++position) {
                    std::vector<double> times = Sampling{0.005, 0.2, 20}.timeStamps();
                    times.resize(length);
                    times[position] = special;
                    times[(position * 7 + 3) % length] = special;
                    for (const unsigned wanted : {63U, 3U}) {
                        QCOMPARE(findBatchDifference(parameters, times, wanted), QString());
                    }
                }
            }
        }
    }
};

const Suite<TestClosedForm> suite("tst_closed_form");

} // namespace tst_closed_form

#include "tst_closed_form.moc"
