// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/mobility.h"
#include "core/limits/output_channel.h"
#include "tests/support/accelerating_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <map>

using namespace slidercrank;

namespace tst_output_channel
{

class TestOutputChannel : public QObject
{
    Q_OBJECT

private slots:
    void namesAreUniqueAndReadBack()
    {
        std::map<std::string_view, int> seen;
        for (const OutputChannel &channel : allOutputChannels()) {
            ++seen[nameOf(channel)];
            QVERIFY(outputChannelNamed(nameOf(channel)) == channel);
        }
        QCOMPARE(seen.size(), std::size_t(48));
        QVERIFY(!outputChannelNamed("transmission angle"));
        for (const auto &[symbol, name] : {std::pair{"x", "R4_x"},
                                           {"v_B", "R4_x_diff"},
                                           {"a", "R4_x_diff2"},
                                           {"omega3", "theta3_diff"},
                                           {"mu", "transmission_angle"},
                                           {"s", "displacement"}}) {
            QVERIFY2(outputChannelNamed(symbol) && outputChannelNamed(symbol) == outputChannelNamed(name), symbol);
        }
        QVERIFY(measureOf(*outputChannelNamed("transmission_angle_diff2")) == Measure::AngularAcceleration);
        QVERIFY(measureOf(*outputChannelNamed("displacement")) == Measure::Length);
    }

    /// The tolerance is relative to the natural size of the channel: a length of the mechanism, or 1 for an angle,
    /// times the rate of the crank to the power of the order.
    void equalsTheMotionOfAnAcceleratingCrank()
    {
        RandomMechanisms random(4601);
        for (int i = 0; i < 400; ++i) {
            Parameters p = random.next();
            const double alpha2 = random.uniform(-3.0, 3.0) * p.omega2 * p.omega2;
            if (i % 10 == 0) {
                p.omega2 = 0.0; // a crank that starts from rest
            }
            const OutputState state = outputStateAt(Mechanism(p), 0.0, alpha2);
            const double rate = std::hypot(p.omega2, std::sqrt(std::abs(alpha2)));
            for (const auto &[name, exact] : exactMotion(p, alpha2)) {
                const OutputChannel channel = *outputChannelNamed(name);
                const double size = (isAngular(measureOf(channel)) ? 1.0 : characteristicLength(p)) *
                                    std::pow(rate, static_cast<int>(orderOf(channel)));
                const double error = static_cast<double>(abs(exact - state.valueOf(channel)));
                QVERIFY2(error <= 1e-12 * size, (std::string(name) + " of " + describe(p)).c_str());
            }
        }
    }

    /// Near the outer dead centre the displacement is as accurate, relative to itself, as the crank angle allows.
    void displacementKeepsItsDigitsNearTheDeadCentre()
    {
        RandomMechanisms random(4602);
        for (int i = 0; i < 300; ++i) {
            Parameters p = random.next();
            p.c = 0.0; // the dead centre is at 0° or 180°
            p.theta20 = std::pow(10.0, random.uniform(-12.0, -1.0));
            p.branch = Branch::Open;
            const double computed = outputStateAt(Mechanism(p), 0.0).derived.displacement.position;
            const double exact = static_cast<double>(exactPositions(p, p.theta20).at("displacement"));
            QVERIFY2(std::abs(computed - exact) <= 2e-15 * exact, describe(p).c_str());
        }
    }

    void transmissionAngleKeepsItsDigitsNearAToggle()
    {
        RandomMechanisms random(4603);
        for (int i = 0; i < 300; ++i) {
            Parameters p = random.next();
            p.b = (p.a + std::abs(p.c)) * (1.0 + std::pow(10.0, -random.uniform(2.0, 15.0)));
            p.theta20 = (p.c < 0.0 ? 0.5 : -0.5) * std::numbers::pi;
            const double computed = outputStateAt(Mechanism(p), 0.0).derived.transmissionAngle.position;
            const double exact = static_cast<double>(exactPositions(p, p.theta20).at("transmission_angle"));
            QVERIFY2(std::abs(computed - exact) <= 2e-15 * exact, describe(p).c_str());
        }
    }

    /// A former defect: where the velocities jump, one of their two values was given as if it were the only one.
    void whereVelocitiesJumpThereAreNone_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<bool>("jumps");
        QTest::addRow("b = a + c, below") << 60.0 << 20.0 << 270.0 << true;
        QTest::addRow("two turns later") << 60.0 << 20.0 << 990.0 << true;
        QTest::addRow("b = a + c, above") << 60.0 << 20.0 << 90.0 << false;
        QTest::addRow("beside it") << 60.0 << 20.0 << 270.001 << false;
        QTest::addRow("b = a + |c|, above") << 60.0 << -20.0 << 90.0 << true;
        QTest::addRow("b = a") << 40.0 << 0.0 << 90.0 << true;
        QTest::addRow("b = a, below") << 40.0 << 0.0 << -90.0 << true;
        QTest::addRow("a longer coupler") << 60.001 << 20.0 << 270.0 << false;
        QTest::addRow("a shorter coupler") << 59.0 << 20.0 << 230.0 << false;
    }
    void whereVelocitiesJumpThereAreNone()
    {
        QFETCH(double, b);
        QFETCH(double, c);
        QFETCH(double, degrees);
        QFETCH(bool, jumps);
        const double theta2 = degrees * std::numbers::pi / 180.0;
        const Mechanism mechanism({.a = 40.0, .b = b, .c = c, .omega2 = 2.0, .theta20 = theta2});
        QCOMPARE(velocitiesJumpAt(mechanism, theta2), jumps);
        const OutputState state = unambiguousStateAt(mechanism, 0.0);
        QCOMPARE(state.state.status, jumps ? Status::Singular : Status::Solved);
        QCOMPARE(std::isnan(state.valueOf(Channel{R4x, Order::Velocity})), jumps);
        QCOMPARE(std::isnan(state.valueOf(DerivedChannel{DerivedQuantity::Displacement, Order::Acceleration})), jumps);
        QVERIFY(std::isfinite(state.valueOf(Channel{R4x, Order::Position})));
        QVERIFY(std::isfinite(state.derived.transmissionAngle.position));
        const Mechanism atRest({.a = 40.0, .b = b, .c = c, .omega2 = 0.0, .theta20 = theta2});
        QCOMPARE(unambiguousStateAt(atRest, 0.0).state.status, Status::Solved);
    }

    /// A former defect: the velocity was 10¹⁰ mm/s and the acceleration 10²⁶ mm/s² at a crank angle where both are
    /// unbounded.
    void atTheEndOfARockersArcThereAreNoVelocities()
    {
        const double end = 210.0 * std::numbers::pi / 180.0; // sin 210° = -1/2 = (c - b)/a
        const Mechanism atEnd({.a = 60.0, .b = 50.0, .c = 20.0, .theta20 = end - 1e-15}); // not beyond it
        const OutputState state = unambiguousStateAt(atEnd, 0.0);
        QCOMPARE(state.state.status, Status::Singular);
        QVERIFY(std::isnan(state.valueOf(Channel{R4x, Order::Velocity})));
        QVERIFY(std::isfinite(state.valueOf(Channel{R4x, Order::Position})));
        QCOMPARE(state.derived.transmissionAngle.position, 0.0);
        const Mechanism before({.a = 60.0, .b = 50.0, .c = 20.0, .theta20 = end - 1e-6});
        QCOMPARE(unambiguousStateAt(before, 0.0).state.status, Status::Solved);
    }

    void keepsThePositionsAtTheEndsOfArcs_data()
    {
        QTest::addColumn<double>("c");
        QTest::addColumn<Branch>("branch");
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("theta3");
        QTest::newRow("third quadrant") << 20.0 << Branch::Open << 210.0 << 90.0;
        QTest::newRow("fourth quadrant") << 20.0 << Branch::Open << 330.0 << 90.0;
        QTest::newRow("B below A") << -20.0 << Branch::Open << 30.0 << -90.0;
        QTest::newRow("crossed") << 20.0 << Branch::Crossed << 330.0 << 90.0;
        QTest::newRow("crossed, B below A") << -20.0 << Branch::Crossed << 150.0 << 270.0;
    }

    /// a = 60, b = 50, c = ±20 mm: sin θ2 = ∓1/2. A former defect: beyond the end by a rounding error, the mechanism
    /// could not be assembled, and before it the positions had 8 digits.
    void keepsThePositionsAtTheEndsOfArcs()
    {
        QFETCH(double, c);
        QFETCH(Branch, branch);
        QFETCH(double, degrees);
        QFETCH(double, theta3);
        for (const double roundingError : {-3e-15, 0.0, 3e-15}) {
            const double theta2 = degrees / kDegreesPerRadian + roundingError;
            for (const double omega2 : {2.0, 0.0}) {
                const Mechanism mechanism({60.0, 50.0, c, omega2, theta2, branch});
                const OutputState state = unambiguousStateAt(mechanism, 0.0);
                const double x = 60.0 * std::cos(degrees / kDegreesPerRadian);
                const bool isAtRest = omega2 == 0.0;
                QCOMPARE(state.state.status, isAtRest ? Status::Solved : Status::Singular);
                QCOMPARE(state.state.qDot[R4x] == 0.0, isAtRest);
                QVERIFY(std::abs(state.state.q[R4x] - x) < 1e-13);
                QVERIFY(std::abs(state.state.q[Theta3] * kDegreesPerRadian - theta3) < 1e-13);
                QVERIFY(std::abs(state.state.q[R3x] - x) < 1e-13);
                QVERIFY(std::abs(state.state.q[R3y] - 0.5 * (c + 60.0 * std::sin(theta2))) < 1e-12);
                QVERIFY(std::abs(state.derived.pinY.position - 60.0 * std::sin(theta2)) < 1e-12);
                const double outer = std::sqrt(110.0 * 110.0 - c * c);
                QVERIFY(std::abs(state.derived.displacement.position -
                                 (branch == Branch::Open ? outer - x : outer + x)) < 1e-12);
            }
        }
    }

    void understandsSymbolsAsTheyAreWritten()
    {
        struct Row {
            const char *symbol;
            const char *name;
        };
        for (const Row &row : {Row{"θ3", "theta3"},
                               {"θ₃", "theta3"},
                               {"θ³", "theta3"},
                               {"theta_3", "theta3"},
                               {"ω₃", "theta3_diff"},
                               {"omega_3", "theta3_diff"},
                               {"α₃", "theta3_diff2"},
                               {"θ₂", "theta2"},
                               {"ω2", "theta2_diff"},
                               {"alpha2", "theta2_diff2"},
                               {"x_B", "R4_x"},
                               {"xB", "R4_x"},
                               {"Rₓ⁴", "R4_x"},
                               {"vB", "R4_x_diff"},
                               {"v⁴", "R4_x_diff"},
                               {"a_B", "R4_x_diff2"},
                               {"\u03BC", "transmission_angle"},
                               {"\u00B5", "transmission_angle"},
                               {"R4_x_diff", "R4_x_diff"}}) {
            const std::optional<OutputChannel> channel = outputChannelNamed(row.symbol);
            QVERIFY2(channel && nameOf(*channel) == row.name, row.symbol);
        }
        for (const char *symbol : {"", "θ", "ω5", "V", "x_C", "_"}) {
            QVERIFY2(!outputChannelNamed(symbol), symbol);
        }
    }

    void valuesThatDoNotExistAreNaN()
    {
        const OutputState impossible = outputStateAt(Mechanism({.b = 40.0, .theta20 = -1.5}), 0.0, 5.0);
        for (const OutputChannel &channel : allOutputChannels()) {
            QVERIFY(std::isnan(impossible.valueOf(channel)));
        }
        const OutputState toggle = outputStateAt(Mechanism({.b = 25.0}), 0.0, 5.0);
        QCOMPARE(toggle.derived.transmissionAngle.position, 0.0);
        QVERIFY(std::isnan(toggle.derived.displacement.acceleration));
        const OutputState kink = outputStateAt(Mechanism({.c = 0.0}), 0.0, 5.0); // parallel to the slider's line
        QCOMPARE(kink.derived.transmissionAngle.position, 0.5 * std::numbers::pi);
        QVERIFY(std::isnan(kink.derived.transmissionAngle.velocity));
        QVERIFY(std::isfinite(kink.derived.displacement.acceleration));
    }
};

const Suite<TestOutputChannel> suite("tst_output_channel");

} // namespace tst_output_channel

#include "tst_output_channel.moc"
