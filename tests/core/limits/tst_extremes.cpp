// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/extremes.h"
#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "tests/support/all_cases.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <set>

using namespace slidercrank;

namespace tst_extremes
{

constexpr double kPi = std::numbers::pi;

/// Returns the approximate width (rad of θ2) of the minimum of b cos θ3 at the steepest coupler. The peaks are about as
/// narrow.
double toggleWidth(const Parameters &p)
{
    const ManyDigits gap = ManyDigits(p.b) - p.a - std::abs(p.c);
    return std::min(1.0, std::sqrt(static_cast<double>(2 * gap / p.a)));
}

ExactState exactAt(const Parameters &p, const ManyDigits &theta2)
{
    ExactInput in(p, 0.0);
    in.theta20 = theta2;
    return exactState(in);
}

/// Returns distances (rad) from ±90° that, on both sides, cover the circle. Close to ±90° their spacing is a hundredth
/// of toggleWidth().
std::vector<double> scanDistances(const Parameters &p)
{
    std::vector<double> steps;
    for (double step = 0.01 * toggleWidth(p); step < 0.5 * kPi;
         step += std::min(0.06 * std::hypot(step, toggleWidth(p)), 0.05)) {
        steps.push_back(step);
    }
    return steps;
}

constexpr std::array<Channel, 4> kRates{
    {{R4x, Order::Velocity}, {R4x, Order::Acceleration}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}}};

struct ExactPeak {
    ManyDigits theta2;
    ManyDigits magnitude;
};

/// Finds the largest magnitude of each rate in a fine scan, and refines it by bisection between its neighbours.
std::array<ExactPeak, kRates.size()> scannedPeaks(const Parameters &p)
{
    using std::abs;
    const ManyDigits quarter = mpfr::const_pi(ManyDigits::kBits) / 2;
    std::vector<ManyDigits> angles;
    for (const int centre : {-1, 1}) {
        angles.push_back(centre * quarter);
        for (const double step : scanDistances(p)) {
            angles.push_back(centre * quarter - step);
            angles.push_back(centre * quarter + step);
        }
    }
    std::sort(angles.begin(), angles.end());
    std::array<std::size_t, kRates.size()> best{};
    std::array<ManyDigits, kRates.size()> largest{};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const ExactState state = exactAt(p, angles[i]);
        for (std::size_t k = 0; k < kRates.size(); ++k) {
            const ManyDigits magnitude = abs(state.values[indexOf(kRates[k])]);
            if (magnitude > largest[k]) {
                largest[k] = magnitude;
                best[k] = i;
            }
        }
    }
    const ManyDigits turn = 4 * quarter;
    std::array<ExactPeak, kRates.size()> peaks;
    for (std::size_t k = 0; k < kRates.size(); ++k) {
        const auto magnitudeAt = [&](const ManyDigits &theta2) {
            return ManyDigits(abs(exactAt(p, theta2).values[indexOf(kRates[k])]));
        };
        ManyDigits low = best[k] > 0 ? angles[best[k] - 1] : ManyDigits(angles.back() - turn);
        ManyDigits high = best[k] + 1 < angles.size() ? angles[best[k] + 1] : ManyDigits(angles.front() + turn);
        for (int i = 0; i < 45; ++i) {
            const ManyDigits middle = (low + high) / 2;
            (magnitudeAt(middle + 1e-40) > magnitudeAt(middle) ? low : high) = middle;
        }
        peaks[k] = {low, magnitudeAt(low)};
    }
    return peaks;
}

bool makesFullTurns(const Parameters &p)
{
    return ManyDigits(p.b) > ManyDigits(p.a) + std::abs(p.c) && p.omega2 != 0.0;
}

class TestExtremes : public QObject
{
    Q_OBJECT

private slots:
    void peaksEqualThoseOfAFineScan_data()
    {
        QTest::addColumn<Parameters>("p");
        std::set<std::array<double, 4>> seen;
        for (const Case &namedCase : allCases()) {
            const Parameters &p = namedCase.parameters;
            const std::array<double, 4> key{p.a, p.b, p.c, p.branch == Branch::Open ? 0.0 : 1.0};
            if (makesFullTurns(p) && seen.insert(key).second) {
                QTest::newRow(std::string(namedCase.name).c_str()) << p;
            }
        }
        RandomMechanisms random(71);
        for (int i = 0; i < 25; ++i) {
            QTest::addRow("random %d", i) << random.next();
        }
        QTest::newRow("gap 2e-17") << Parameters{.a = 1.0, .b = std::nextafter(1.0, 2.0), .c = 2e-16, .omega2 = 1.0};
    }

    void peaksEqualThoseOfAFineScan()
    {
        QFETCH(Parameters, p);
        const std::vector<Peak> peaks = motionPeaks(Mechanism(p));
        QCOMPARE(peaks.size(), kRates.size());
        const auto scanned = scannedPeaks(p);
        for (std::size_t i = 0; i < kRates.size(); ++i) {
            const Peak &peak = peaks[i];
            QVERIFY(peak.channel == kRates[i]);
            const ExactPeak &exact = scanned[i];
            const double relative =
                static_cast<double>((ManyDigits(peak.magnitude) - exact.magnitude) / exact.magnitude);
            QVERIFY2(std::abs(relative) <= 4e-15, describe(p).c_str());

            // The tolerance grows with the distance from ±90°, near which the spacing of doubles is 2.2e-16.
            const double fromSteepest = std::abs(std::abs(static_cast<double>(exact.theta2)) - 0.5 * kPi);
            const double tolerance = 1e-11 * toggleWidth(p) + 1e-14 * fromSteepest + 2.3e-16;
            double nearest = kTurn;
            for (const PeakPoint &point : peak.points) {
                const double off = static_cast<double>(ManyDigits(point.theta2) - exact.theta2);
                nearest = std::min(nearest, std::abs(std::remainder(off, kTurn)));
                QVERIFY(point.theta2 >= -kPi && point.theta2 < kPi);
            }
            QVERIFY2(nearest <= tolerance, describe(p).c_str());
        }
    }

    /// θ3 depends only on sin θ2, so its derivatives have two equal peaks; without an offset, so does the slider's
    /// speed.
    void everyPeakPointHasThePeaksValue()
    {
        RandomMechanisms random(72);
        for (int i = 0; i < 100; ++i) {
            Parameters p = random.next();
            p.c = i % 5 == 0 ? 0.0 : p.c;
            const std::vector<Peak> peaks = motionPeaks(Mechanism(p));
            for (const Peak &peak : peaks) {
                QVERIFY(!peak.points.empty());
                for (const PeakPoint &point : peak.points) {
                    const double exact = static_cast<double>(exactAt(p, point.theta2).values[indexOf(peak.channel)]);
                    QVERIFY2(std::abs(point.value - exact) <= 1e-13 * peak.magnitude, describe(p).c_str());
                    QVERIFY2(std::abs(std::abs(exact) - peak.magnitude) <= 1e-11 * peak.magnitude, describe(p).c_str());
                }
            }
            const std::vector<PeakPoint> &points = peaks[2].points;
            QVERIFY2(points.size() == 2, describe(p).c_str());
            QVERIFY(std::abs(std::remainder(points[0].theta2 - (kPi - points[1].theta2), kTurn)) < 1e-12);
            QVERIFY(std::signbit(points[0].value) != std::signbit(points[1].value));
            QCOMPARE(peaks[0].points.size(), std::size_t(p.c == 0.0 ? 2 : 1));
        }
    }

    /// The peaks of motions without a finite acceleration, and of no motion. At an exact toggle the slider reverses
    /// abruptly: the velocities have one-sided limits (that of θ3 is ±ω √(a/b)). If a = b and c = 0, the slider moves
    /// to 2a and back in one half turn and rests during the other.
    void unboundedPeaksAreAtAPerpendicularCoupler()
    {
        struct Row {
            Parameters parameters;
            std::array<double, 4> magnitudes;       ///< in the order of motionPeaks()
            std::array<std::size_t, 4> pointCounts; ///< number of points of each peak
        };
        constexpr std::array<double, 4> kAllUnbounded{kInfinity, kInfinity, kInfinity, kInfinity};
        const std::array<double, 4> toggle{150.0, kInfinity, 3.0 * std::sqrt(20.0 / 45.0), kInfinity};
        const Row rows[] = {
            {{.b = 40.0}, kAllUnbounded, {2, 2, 2, 2}},
            {{.b = 10.0, .c = 5.0}, kAllUnbounded, {4, 4, 4, 4}},
            {{.b = 45.0, .c = 25.0, .omega2 = 3.0, .branch = Branch::Open}, toggle, {1, 1, 1, 1}},
            {{.b = 45.0, .c = 25.0, .omega2 = 3.0, .branch = Branch::Crossed}, toggle, {1, 1, 1, 1}},
            {{.b = 45.0, .c = -25.0, .omega2 = 3.0, .branch = Branch::Open}, toggle, {1, 1, 1, 1}},
            {{.b = 45.0, .c = -25.0, .omega2 = 3.0, .branch = Branch::Crossed}, toggle, {1, 1, 1, 1}},
            {{.b = 20.0, .c = 0.0, .omega2 = -3.0}, {120.0, kInfinity, 3.0, kInfinity}, {2, 2, 0, 2}},
            {{.omega2 = 0.0}, {}, {}},
            {{.b = 45.0, .omega2 = 0.0}, {}, {}},
            {{.b = 40.0, .omega2 = 0.0}, {}, {}},
        };
        for (const auto &[p, magnitudes, pointCounts] : rows) {
            const std::vector<Peak> peaks = motionPeaks(Mechanism(p));
            QCOMPARE(peaks.size(), magnitudes.size());
            for (std::size_t i = 0; i < peaks.size(); ++i) {
                const Peak &peak = peaks[i];
                QVERIFY2(peak.magnitude == magnitudes[i] ||
                             std::abs(peak.magnitude - magnitudes[i]) < 6e-15 * magnitudes[i],
                         describe(p).c_str());
                QVERIFY2(peak.points.size() == pointCounts[i], describe(p).c_str());
                for (const PeakPoint &point : peak.points) {
                    const double height = std::abs(p.c - p.a * std::sin(point.theta2));
                    const bool isToggle = p.b == p.a + std::abs(p.c);
                    QVERIFY(isToggle ? std::abs(std::cos(point.theta2)) < 1e-14 : std::abs(height - p.b) < 1e-12);
                }
            }
        }
        for (const double b : {5.0, 4.0}) { // locked, impossible
            QVERIFY(motionPeaks(Mechanism({.b = b})).empty());
        }
    }
};

const Suite<TestExtremes> suite("tst_extremes");

} // namespace tst_extremes

#include "tst_extremes.moc"
