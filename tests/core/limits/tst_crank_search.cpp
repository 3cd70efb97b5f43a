// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/crank_search.h"
#include "core/mechanism/turn.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_crank_search
{

/// Returns a channel for ω2 = 1 in extended precision by the formulas of the textbook; NaN if it does not exist.
/// `alpha2`: acceleration of the crank.
long double textbookValue(const Parameters &p, const OutputChannel &channel, long double theta2, double alpha2 = 0.0)
{
    if (alpha2 != 0.0 && orderOf(channel) == Order::Acceleration) { // f'' + f' α2
        return textbookValue(p, channel, theta2) +
               alpha2 * textbookValue(p, withOrder(channel, Order::Velocity), theta2);
    }
    using Real = long double;
    TextbookMotion<Real> motion;
    if (!motion.compute({p.a, p.b, p.c, 1.0}, theta2, p.branch == Branch::Open ? 1.0 : -1.0,
                        std::numbers::pi_v<Real>)) {
        return std::numeric_limits<Real>::quiet_NaN();
    }
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        return motion.valueAt(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    const auto k = static_cast<std::size_t>(order);
    switch (quantity) {
    case DerivedQuantity::PinX: return motion.pinX[k];
    case DerivedQuantity::PinY: return motion.pinY[k];
    case DerivedQuantity::Displacement: {
        const Real sum = Real(p.a) + p.b;
        const Real outer = motion.side * std::sqrt(sum * sum - Real(p.c) * p.c);
        return motion.side * ((k == 0 ? outer : 0.0L) - motion.sliderX[k]);
    }
    case DerivedQuantity::TransmissionAngle: break;
    }
    // The transmission angle decreases where the coupler turns away from the slider's line.
    const Real sign = (motion.height > 0.0L ? -1.0L : 1.0L) * motion.side;
    switch (order) {
    case Order::Position: return std::atan2(std::abs(motion.reach), std::abs(motion.height));
    case Order::Velocity: return sign * motion.omega3;
    case Order::Acceleration: break;
    }
    return sign * motion.alpha3;
}

std::vector<OutputChannel> channelsThatVary()
{
    std::vector<OutputChannel> channels;
    for (const char *name :
         {"theta3", "R4_x", "R3_x", "R2_x", "R2_y", "R3_y", "transmission_angle", "displacement", "A_x", "A_y"}) {
        for (const char *suffix : {"", "_diff", "_diff2"}) {
            channels.push_back(*outputChannelNamed(std::string(name) + suffix));
        }
    }
    return channels;
}

constexpr int kScanSteps = 1500;

/// Returns the channel for ω2 = 1 at kScanSteps + 1 crank angles of a revolution.
std::vector<long double> scan(const Parameters &p, const OutputChannel &channel, double alpha2)
{
    std::vector<long double> values;
    for (int i = 0; i <= kScanSteps; ++i) {
        const long double theta2 = -kTurn / 2.0L + static_cast<long double>(kTurn) * i / kScanSteps;
        values.push_back(textbookValue(p, channel, theta2, alpha2));
    }
    return values;
}

/// Returns the number of times that the scanned channel passes the value. Steps beyond `largestStep` are jumps, which
/// do not count.
int countPassages(const std::vector<long double> &values, long double value, double largestStep)
{
    int count = 0;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const bool jumps = std::abs(values[i + 1] - values[i]) > largestStep;
        count += !jumps && (values[i] < value) != (values[i + 1] < value) && std::isfinite(values[i]) &&
                 std::isfinite(values[i + 1]);
    }
    return count;
}

/// Returns whether the channel has the value at this crank angle, apart from rounding errors. `size` is its largest
/// magnitude.
bool hasValueAt(const Parameters &p, const OutputChannel &channel, double theta2, double alpha2, long double value,
                double size)
{
    constexpr long double kStep = 1e-6L;
    const auto at = [&](long double angle) { return textbookValue(p, channel, angle, alpha2); };
    const long double slope = (at(theta2 + kStep) - at(theta2 - kStep)) / (2.0L * kStep);
    const long double error = std::abs(at(theta2) - value);
    return error <= 1e-12L * std::max<long double>(size, std::abs(slope)) ||
           (std::isnan(slope) && error <= 1e-9L * size);
}

/// Returns whether the channel jumps where the coupler is parallel to the slider's line.
bool canJump(const OutputChannel &channel)
{
    const auto *derived = std::get_if<DerivedChannel>(&channel);
    return derived && derived->quantity == DerivedQuantity::TransmissionAngle && derived->order != Order::Position;
}

class TestCrankSearch : public QObject
{
    Q_OBJECT

private slots:
    void findsAllSolutionsAndNoneElse_data()
    {
        QTest::addColumn<double>("accelerationRatio"); // |α2|/ω2²
        QTest::newRow("constant speed") << 0.0;
        QTest::newRow("slight acceleration") << 0.3;
        QTest::newRow("strong acceleration") << 30.0;
    }

    /// Every solution satisfies the equation, and there are as many as a scan of the revolution finds. The values are
    /// random, and hardly any is so near an extreme that the scan would miss its two solutions.
    void findsAllSolutionsAndNoneElse()
    {
        QFETCH(double, accelerationRatio);
        RandomMechanisms random(461);
        const std::vector<OutputChannel> channels = channelsThatVary();
        int solutions = 0;
        for (int i = 0; i < 1000; ++i) {
            Parameters p = random.next();
            p.b *= i % 4 == 0 ? random.uniform(0.3, 1.0) : 1.0; // some rockers
            const OutputChannel channel = channels[static_cast<std::size_t>(i) % channels.size()];
            const double ratio = i % 2 == 0 ? accelerationRatio : -accelerationRatio;
            const std::vector<long double> values = scan(p, channel, ratio);
            std::vector<long double> sorted;
            std::ranges::copy_if(values, std::back_inserter(sorted),
                                 [](long double value) { return std::isfinite(value); });
            std::ranges::sort(sorted);
            if (sorted.size() < kScanSteps / 10) {
                continue;
            }
            const long double usual = sorted[sorted.size() * 9 / 10] - sorted[sorted.size() / 10];
            const long double value = sorted[sorted.size() / 10] + usual * random.uniform(-0.3, 1.3);
            const double size = static_cast<double>(std::max(std::abs(sorted.front()), std::abs(sorted.back())));
            const double unit = std::pow(p.omega2, static_cast<int>(orderOf(channel)));
            const double alpha2 = ratio * p.omega2 * p.omega2;
            const auto found = crankAnglesAt(Mechanism(p), channel, static_cast<double>(value) * unit, alpha2);
            QVERIFY(found);
            for (const double theta2 : *found) {
                ++solutions;
                QVERIFY2(hasValueAt(p, channel, theta2, ratio, value, size),
                         (std::string(nameOf(channel)) + " of " + describe(p)).c_str());
            }
            const double largestStep = canJump(channel) ? 0.2 * static_cast<double>(usual) : kInfinity;
            const int expected = countPassages(values, value, largestStep);
            const bool isRocker = p.b < p.a + std::abs(p.c);
            const auto count = static_cast<int>(found->size());
            // Between the last sample and the limit of a rocker the motion may pass the value once more.
            QVERIFY2(isRocker ? count >= expected && count <= expected + 4 : count == expected,
                     (std::string(nameOf(channel)) + " of " + describe(p) + ": " + std::to_string(count) + " for " +
                      std::to_string(expected))
                         .c_str());
        }
        QVERIFY(solutions > 1000);
    }

    void findsTheAnglesOfASliderAt60Millimetres()
    {
        const auto found = crankAnglesAt(Mechanism(), Channel{R4x, Order::Position}, 60.0);
        QVERIFY(found);
        QCOMPARE(found->size(), std::size_t(2));
        for (const double theta2 : *found) { // (x - a cos θ2)² + (c - a sin θ2)² = b²
            const double side = std::hypot(60.0 - 20.0 * std::cos(theta2), 25.0 - 20.0 * std::sin(theta2));
            QVERIFY(std::abs(side - 65.0) < 1e-12);
        }
    }

    void anExtremeHasOneSolution()
    {
        const double outer = std::sqrt(85.0 * 85.0 - 25.0 * 25.0);
        const Channel slider{R4x, Order::Position};
        QCOMPARE(crankAnglesAt(Mechanism(), slider, outer)->size(), std::size_t(1));
        QCOMPARE(crankAnglesAt(Mechanism(), slider, outer * (1.0 + 1e-12))->size(), std::size_t(0));
        QCOMPARE(crankAnglesAt(Mechanism(), slider, outer * (1.0 - 1e-12))->size(), std::size_t(2));
        QCOMPARE(crankAnglesAt(Mechanism({.c = 0.0}), *outputChannelNamed("transmission_angle"), kQuarterTurn)->size(),
                 std::size_t(2));
    }

    /// At a limit of a rocker the coupler is perpendicular to the slider's line, so that B has the x of A: a sin θ2 = c
    /// + b or c - b.
    void findsTheLimitsOfARocker()
    {
        RandomMechanisms random(463);
        int limits = 0;
        for (int i = 0; i < 300; ++i) {
            Parameters p = random.next();
            p.c = p.a * random.uniform(-1.2, 1.2);
            p.b = (p.a + std::abs(p.c)) * random.uniform(0.4, 0.99);
            for (const double side : {1.0, -1.0}) { // B is above A, or below it
                const double sine = (p.c - side * p.b) / p.a;
                if (std::abs(sine) > 1.0) {
                    continue;
                }
                const double pinX = p.a * std::sqrt((1.0 - sine) * (1.0 + sine));
                const auto isAtLimit = [&](double theta2) {
                    return std::hypot(p.a * std::cos(theta2) - pinX, p.a * (std::sin(theta2) - sine)) < 1e-13 * p.a;
                };
                const auto canBeAssembled = [&p](double theta2) {
                    return !std::isnan(outputStateAt(withCrankAt(Mechanism(p), theta2), 0.0).state.q[R4x]);
                };
                const std::pair<const char *, double> values[] = {{"theta3", side * kQuarterTurn},
                                                                  {"transmission_angle", 0.0},
                                                                  {"R4_x", pinX},
                                                                  {"R3_x", pinX},
                                                                  {"A_x", pinX},
                                                                  {"A_y", p.a * sine}};
                for (const auto &[name, value] : values) {
                    const auto found = crankAnglesAt(Mechanism(p), *outputChannelNamed(name), value);
                    QVERIFY2(std::ranges::any_of(*found, isAtLimit),
                             (std::string(name) + " of " + describe(p)).c_str());
                    ++limits;
                }
                const auto folded = crankAnglesAt(Mechanism(p), *outputChannelNamed("mu"), 0.0);
                QVERIFY(std::ranges::all_of(*folded, canBeAssembled));
            }
        }
        QVERIFY(limits > 1000);
        const auto range = rangeOf(Mechanism({.a = 20.0, .b = 10.0, .c = 0.0}), *outputChannelNamed("theta3"));
        QCOMPARE(range->least, -kQuarterTurn);
        QCOMPARE(range->greatest, kQuarterTurn);
    }

    /// The scanned values reach the ends of the range, and none is beyond them.
    void theRangeHoldsAllValues()
    {
        RandomMechanisms random(20260);
        for (int i = 0; i < 40; ++i) {
            const Parameters p = random.next();
            const double alpha2 = (i % 3 - 1) * 0.7 * p.omega2 * p.omega2;
            const bool isFarFromToggle = p.b > 1.2 * (p.a + std::abs(p.c)); // so that the scan meets every peak
            for (const OutputChannel &channel : channelsThatVary()) {
                const auto range = rangeOf(Mechanism(p), channel, alpha2);
                if (!range) {
                    QCOMPARE(std::get<DerivedChannel>(channel).quantity, DerivedQuantity::TransmissionAngle);
                    continue;
                }
                const double unit = std::pow(p.omega2, static_cast<int>(orderOf(channel)));
                long double least = 1e300L;
                long double greatest = -1e300L;
                for (const long double value : scan(p, channel, alpha2 / (p.omega2 * p.omega2))) {
                    least = std::min(least, std::isnan(value) ? least : unit * value);
                    greatest = std::max(greatest, std::isnan(value) ? greatest : unit * value);
                }
                const double size = static_cast<double>(greatest - least);
                QVERIFY(range->least <= static_cast<double>(least) + 1e-12 * size);
                QVERIFY(range->greatest >= static_cast<double>(greatest) - 1e-12 * size);
                if (isFarFromToggle) {
                    QVERIFY(range->least > static_cast<double>(least) - 1e-3 * size);
                    QVERIFY(range->greatest < static_cast<double>(greatest) + 1e-3 * size);
                }
            }
        }
        QVERIFY(!rangeOf(Mechanism(), *outputChannelNamed("R4_y")));
        QVERIFY(!rangeOf(Mechanism({.omega2 = 0.0}), *outputChannelNamed("R4_x_diff")));
        // f' α2 is the velocity at ω2 = α2
        const auto atRest = rangeOf(Mechanism({.omega2 = 0.0}), *outputChannelNamed("R4_x_diff2"), 5.0);
        const auto moving = rangeOf(Mechanism({.omega2 = 5.0}), *outputChannelNamed("R4_x_diff"));
        QCOMPARE(atRest->greatest, moving->greatest);
        QCOMPARE(atRest->least, moving->least);
    }

    /// θ3 is a direction: -170° and 190° are the same one, which only the crossed assembly has.
    void anAngleIsADirection()
    {
        const Channel theta3{Theta3, Order::Position};
        for (const double turns : {-2.0, -1.0, 1.0, 7.0}) {
            for (const auto &[branch, angle] : {std::pair(Branch::Open, 0.3), {Branch::Crossed, 2.8}}) {
                const Mechanism mechanism({.branch = branch});
                const auto found = crankAnglesAt(mechanism, theta3, angle + turns * kTurn);
                const auto same = crankAnglesAt(mechanism, theta3, angle);
                QCOMPARE(found->size(), std::size_t(2));
                QVERIFY(std::abs(found->front() - same->front()) < 1e-13 &&
                        std::abs(found->back() - same->back()) < 1e-13);
                QVERIFY(crankAnglesAt(mechanism, theta3, angle + 0.5 * kTurn)->empty());
            }
        }
    }

    /// The slider of a = b, c = 0 rests at O2 from 90° to 270°. Only the ends of this arc are solutions, and not every
    /// angle in it at which rounding happens to give the value.
    void aValueThatIsKeptHasTheEndsOfItsArc()
    {
        const Mechanism folding({.a = 10.0, .b = 10.0, .c = 0.0});
        const auto position = crankAnglesAt(folding, *outputChannelNamed("R4_x"), 0.0);
        QCOMPARE(position->size(), std::size_t(2));
        QVERIFY(std::abs(position->front() + kQuarterTurn) < 1e-14);
        QVERIFY(std::abs(position->back() - kQuarterTurn) < 1e-14);
        const auto velocity = crankAnglesAt(folding, *outputChannelNamed("R4_x_diff"), 0.0);
        for (const double theta2 : *velocity) {
            const double fromEnds = std::min({std::abs(theta2), std::abs(std::abs(theta2) - kQuarterTurn)});
            QVERIFY2(fromEnds < 1e-14, qPrintable(QString::number(theta2)));
        }
        QCOMPARE(velocity->size(), std::size_t(3)); // and the outer dead centre
        QCOMPARE(crankAnglesAt(folding, *outputChannelNamed("R4_x"), 10.0)->size(), std::size_t(2));
    }

    /// At rest, the second derivative is f' α2.
    void aCrankStartsFromRest()
    {
        const Mechanism resting({.omega2 = 0.0});
        const auto found = crankAnglesAt(resting, *outputChannelNamed("R4_x_diff2"), -50.0, 4.0);
        QCOMPARE(found->size(), std::size_t(2));
        for (const double theta2 : *found) {
            const double slope =
                static_cast<double>(textbookValue(resting.parameters(), *outputChannelNamed("R4_x_diff"), theta2));
            QVERIFY(std::abs(4.0 * slope + 50.0) < 1e-11);
        }
        QVERIFY(!crankAnglesAt(resting, *outputChannelNamed("R4_x_diff"), 1.0, 4.0));
    }

    void tellsConstantsApart()
    {
        for (const char *name : {"R4_y", "theta1", "theta2_diff", "theta2_diff2", "R1_x_diff"}) {
            QVERIFY2(!crankAnglesAt(Mechanism(), *outputChannelNamed(name), 0.0), name);
        }
        QVERIFY(!crankAnglesAt(Mechanism({.omega2 = 0.0}), *outputChannelNamed("R4_x_diff"), 0.0));
        QCOMPARE(*crankAnglesAt(Mechanism(), *outputChannelNamed("theta2"), 7.0), std::vector{7.0 - kTurn});
        QVERIFY(crankAnglesAt(Mechanism({.b = 40.0}), *outputChannelNamed("theta2"), -1.5)->empty());
        QVERIFY(crankAnglesAt(Mechanism({.b = 4.0}), *outputChannelNamed("R4_x"), 0.0)->empty()); // cannot be assembled
    }

    void scalesTheCrankSpeed()
    {
        RandomMechanisms random(462);
        const Channel velocity{R4x, Order::Velocity};
        for (int i = 0; i < 300; ++i) {
            const Parameters p = random.next();
            const double theta2 = random.uniform(-3.0, 3.0);
            const double wanted = random.uniform(-1e4, 1e4);
            const auto speed = crankSpeedFor(Mechanism(p), theta2, velocity, wanted);
            QVERIFY(speed);
            const OutputState state = outputStateAt(withDrive(Mechanism(p), *speed, theta2), 0.0);
            QVERIFY(std::abs(state.valueOf(velocity) - wanted) <= 1e-14 * std::abs(wanted));
        }
        QVERIFY(!crankSpeedFor(Mechanism({.c = 0.0}), 0.0, velocity, 5.0)); // a dead centre
        QVERIFY(!crankSpeedFor(Mechanism({.b = 40.0}), -1.5, velocity, 5.0));
        QCOMPARE(*crankSpeedFor(Mechanism(), 1.0, *outputChannelNamed("theta2_diff"), 5.0), 5.0);
    }
};

const Suite<TestCrankSearch> suite("tst_crank_search");

} // namespace tst_crank_search

#include "tst_crank_search.moc"
