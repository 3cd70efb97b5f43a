// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "tests/ui/plots/plot_results.h"
#include "ui/plots/curve_sampling.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace slidercrank;

namespace tst_curve_sampling
{

constexpr Interval kWhole{0.0, 1.0};

std::vector<double> evenTime(std::size_t count)
{
    std::vector<double> time(count);
    for (std::size_t i = 0; i < count; ++i) {
        time[i] = static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return time;
}

class TestCurveSampling : public QObject
{
    Q_OBJECT

private slots:
    void keepsFewSamplesAndOneBeyondEachEdge()
    {
        const std::vector<double> time = evenTime(11);
        std::vector<double> values = time;
        values[4] = kInfinity;
        QCOMPARE(textOfPoints(decimate(time, values, {0.32, 0.58}, 100)), "0.3,0.3 0.4,- 0.5,0.5 0.6,0.6");
        QCOMPARE(decimate(time, values, kWhole, 100).size(), time.size());
    }

    void keepsTheExtremesOfEveryPixelColumnInTheirOrder()
    {
        std::mt19937 random(20260);
        std::normal_distribution<double> noise;
        const std::vector<double> time = evenTime(20'001);
        std::vector<double> values(time.size());
        std::ranges::generate(values, [&] { return noise(random); });
        const std::vector<CurvePoint> points = decimate(time, values, kWhole, 100);
        QVERIFY(points.size() <= 200 && std::ranges::is_sorted(points, {}, &CurvePoint::t));
        for (std::size_t column = 0; column < 100; ++column) {
            const std::span<const double> ofColumn(&values[200 * column], 200);
            for (const double extreme : {std::ranges::min(ofColumn), std::ranges::max(ofColumn)}) {
                const auto point = std::ranges::find(points, extreme, &CurvePoint::value);
                QVERIFY(point != points.end() && values[nearestIndex(time, point->t)] == extreme);
            }
        }
    }

    void keepsGapsAndTheExtremesBesideThem()
    {
        const std::vector<double> time = evenTime(20'001);
        for (const std::size_t gap : {0, 1, 9'999, 10'000, 20'000}) {
            std::vector<double> values(time.size(), 1.0);
            values[gap] = -kInfinity;
            QCOMPARE(textOfPoints(decimate(time, values, kWhole, 200)).count(",-"), 1);
        }
        std::vector<double> values(time.size(), 0.0);
        values[20] = kNone;
        values[30] = -7.0;
        values[40] = 9.0;
        const std::vector<CurvePoint> points = decimate(time, values, kWhole, 2);
        QCOMPARE(textOfPoints({points.begin(), points.begin() + 3}), "0.001,- 0.0015,-7 0.002,9");
        QCOMPARE(usualRange(points, kWhole), std::optional(Interval{-7.0, 9.0}));
        QVERIFY(!usualRange(std::vector<CurvePoint>{{0.0, kNone}}, kWhole));
        constexpr bool kIsUnbounded = true;
        std::vector<CurvePoint> ramp;
        for (int i = 0; i <= 100; ++i) {
            ramp.push_back({0.01 * i, double(i)});
        }
        QCOMPARE(usualRange(ramp, {0.0, 0.505}), std::optional(Interval{0.0, 50.5})); // cut at the edge
        QCOMPARE(usualRange(ramp, kWhole, kIsUnbounded), std::optional(Interval{5.0, 95.0}));
        ramp.push_back({1.0, kBeyondAll});
        QCOMPARE(usualRange(ramp, kWhole), std::optional(Interval{5.0, 95.0}));
    }

    void cutsCurvesExactlyAtTheEdges()
    {
        struct Row {
            std::vector<CurvePoint> points;
            const char *expected;
        };
        for (const Row &row :
             {Row{{{-1, -0.5}, {0.5, 0.5}, {1.5, 2.5}, {2, 0.5}}, "0,0.166667 0.5,0.5 0.75,1 0.75,- 1.875,1 2,0.5"},
              Row{{{0, -1}, {1, 3}}, "0.25,0 0.5,1 0.5,-"}, // both ends are outside
              Row{{{0, 2}, {1, 3}}, ""}, Row{{{0, 0.5}, {1, kNone}, {1.5, 0.25}}, "0,0.5 1,- 1.5,0.25"},
              Row{{{0, 0.5}, {1, 1e300}}, "0,0.5 5e-301,1 5e-301,-"}}) {
            QCOMPARE(textOfPoints(clip(row.points, {0.0, 2.0}, {0.0, 1.0})), row.expected);
        }
        QCOMPARE(textOfPoints(
                     isolatedPoints(std::vector<CurvePoint>{{0, 1}, {1, kNone}, {2, 3}, {3, 4}, {4, kNone}, {5, 6}})),
                 "0,1 5,6");
    }

    void removesOnlyPointsOnTheRemainingLine()
    {
        std::vector<CurvePoint> curve;
        for (const double t : evenTime(2'001)) {
            curve.push_back({t, std::sin(15.0 * t) + 0.2 * std::cos(90.0 * t)});
        }
        constexpr double kTolerance = 1e-3;
        const std::vector<CurvePoint> kept = withoutNeedlessPoints(curve, kTolerance);
        QVERIFY(kept.size() < curve.size() / 4 && kept.front().t == 0.0 && kept.back().t == 1.0);
        std::size_t segment = 0; // of the kept line
        for (const CurvePoint &point : curve) {
            segment += kept[segment + 1].t < point.t ? 1 : 0;
            const double fraction = (point.t - kept[segment].t) / (kept[segment + 1].t - kept[segment].t);
            QVERIFY(std::abs(std::lerp(kept[segment].value, kept[segment + 1].value, fraction) - point.value) <=
                    kTolerance * (1.0 + 1e-9));
        }
        const std::vector<CurvePoint> corners{{0, 0}, {1, 1},     {2, 2}, {3, 0}, {4, kNone},
                                              {5, 7}, {6, kNone}, {7, 1}, {8, 1}, {9, 1}};
        QCOMPARE(textOfPoints(withoutNeedlessPoints(corners, 0.01)), "0,0 2,2 3,0 4,- 5,7 6,- 7,1 9,1");
        QVERIFY(withoutNeedlessPoints({}, 0.01).empty());
    }
};

const Suite<TestCurveSampling> suite("tst_curve_sampling");

} // namespace tst_curve_sampling

#include "tst_curve_sampling.moc"
