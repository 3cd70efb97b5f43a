// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/curve_sampling.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace slidercrank;

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Interval kWhole{0.0, 1.0};

std::vector<double> evenTime(std::size_t count)
{
    std::vector<double> time(count);
    for (std::size_t i = 0; i < count; ++i) {
        time[i] = static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return time;
}

std::size_t gapsIn(const std::vector<CurvePoint> &points)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(points, [](const CurvePoint &point) { return std::isnan(point.value); }));
}

/// "t,v" of each point; a gap is "t,-".
QString written(const std::vector<CurvePoint> &points)
{
    QStringList texts;
    for (const CurvePoint &point : points) {
        texts << QStringLiteral("%1,%2").arg(point.t).arg(std::isnan(point.value) ? QStringLiteral("-")
                                                                                  : QString::number(point.value));
    }
    return texts.join(u' ');
}

} // namespace

class TestCurveSampling : public QObject
{
    Q_OBJECT

private slots:
    void drawsEveryOneOfFewSamples()
    {
        const std::vector<double> time = evenTime(201);
        std::vector<double> values(time.size(), 1.0);
        values[77] = std::numeric_limits<double>::infinity();
        const std::vector<CurvePoint> points = decimate(time, values, kWhole, 150);
        QCOMPARE(points.size(), time.size());
        QVERIFY(std::isnan(points[77].value) && points[78].value == 1.0 && points[78].t == time[78]);
    }

    void keepsTheExtremesOfEveryPixelColumnInTheirOrder()
    {
        constexpr std::size_t kColumns = 100;
        std::mt19937 random(20260);
        std::normal_distribution<double> noise;
        const std::vector<double> time = evenTime(20'001);
        std::vector<double> values(time.size());
        std::ranges::generate(values, [&] { return noise(random); });
        const std::vector<CurvePoint> points = decimate(time, values, kWhole, kColumns);
        QVERIFY(points.size() <= 2 * kColumns);
        QVERIFY(std::ranges::is_sorted(points, {}, &CurvePoint::t));
        for (const CurvePoint &point : points) {
            QCOMPARE(point.value, values[nearestIndex(time, point.t)]);
        }
        for (std::size_t column = 0; column < kColumns; ++column) {
            const auto [lowest, highest] =
                std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(column * 200),
                                    values.begin() + static_cast<std::ptrdiff_t>(column * 200 + 200));
            QVERIFY(std::ranges::find(points, *lowest, &CurvePoint::value) != points.end());
            QVERIFY(std::ranges::find(points, *highest, &CurvePoint::value) != points.end());
        }
    }

    void keepsGapsAndTheExtremesBesideThem()
    {
        const std::vector<double> time = evenTime(20'001);
        for (const std::size_t gap : {0, 1, 9'999, 10'000, 20'000}) {
            for (const double missing : {kNaN, std::numeric_limits<double>::infinity()}) {
                std::vector<double> values(time.size(), 1.0);
                values[gap] = missing;
                QCOMPARE(gapsIn(decimate(time, values, kWhole, 200)), std::size_t(1));
            }
        }
        std::vector<double> values(time.size(), 0.0);
        values[10] = 7.0;
        values[20] = kNaN;
        values[30] = -7.0;
        values[40] = 9.0;
        values[50] = kNaN;
        const std::vector<CurvePoint> points = decimate(time, values, kWhole, 2);
        QCOMPARE(extremes(points), std::optional(Interval{-7.0, 9.0}));
        QVERIFY(gapsIn(points) >= 1 && std::ranges::is_sorted(points, {}, &CurvePoint::t));
        QVERIFY(!extremes(std::vector<CurvePoint>{{0.0, kNaN}}));
    }

    void takesOneNeighbourBeyondEachEdge()
    {
        const std::vector<double> time = evenTime(11);
        const std::vector<CurvePoint> points = decimate(time, time, {0.32, 0.58}, 100);
        QCOMPARE(points.size(), std::size_t(4));
        QCOMPARE(points.front().t, time[3]);
        QCOMPARE(points.back().t, time[6]);
    }

    void cutsCurvesExactlyAtTheEdges()
    {
        const auto clipped = [](std::vector<CurvePoint> points) {
            return written(clip(points, {0.0, 2.0}, {0.0, 1.0}));
        };
        QCOMPARE(clipped({{-1, -1}, {0.5, 0.5}, {1.5, 2.5}, {2, 0.5}}), "0,0 0.5,0.5 0.75,1 0.75,- 1.875,1 2,0.5");
        QCOMPARE(clipped({{0, -1}, {1, 3}}), "0.25,0 0.5,1 0.5,-"); // only passes through
        QCOMPARE(clipped({{0, 2}, {1, 3}}), QString());
        QCOMPARE(clipped({{0, 0.5}, {1, kNaN}, {1.5, 0.25}}), "0,0.5 1,- 1.5,0.25");
        QCOMPARE(clipped({{0, 0.5}, {1, 1e300}}).section(u',', -1), "-");
    }

    void findsPointsThatNoLineReaches()
    {
        const std::vector<CurvePoint> points{{0, 1}, {1, kNaN}, {2, 3}, {3, 4}, {4, kNaN}, {5, 6}};
        QCOMPARE(written(isolatedPoints(points)), "0,1 5,6");
    }

    void dropsOnlyPointsThatTheLinePasses()
    {
        std::vector<CurvePoint> curve;
        for (const double t : evenTime(2'001)) {
            curve.push_back({t, std::sin(15.0 * t) + 0.2 * std::cos(90.0 * t)});
        }
        constexpr double kTolerance = 1e-3;
        const std::vector<CurvePoint> kept = withoutNeedlessPoints(curve, kTolerance);
        QVERIFY(kept.size() < curve.size() / 4 && kept.front().t == 0.0 && kept.back().t == 1.0);
        std::size_t part = 0;
        for (const CurvePoint &point : curve) {
            part += kept[part + 1].t < point.t ? 1 : 0;
            const double along = (point.t - kept[part].t) / (kept[part + 1].t - kept[part].t);
            const double line = kept[part].value + along * (kept[part + 1].value - kept[part].value);
            QVERIFY(std::abs(line - point.value) <= kTolerance * (1.0 + 1e-9));
        }
        const std::vector<CurvePoint> corners{{0, 0}, {1, 1},    {2, 2}, {3, 0}, {4, kNaN},
                                              {5, 7}, {6, kNaN}, {7, 1}, {8, 1}, {9, 1}};
        QCOMPARE(written(withoutNeedlessPoints(corners, 0.01)), "0,0 2,2 3,0 4,- 5,7 6,- 7,1 9,1");
        QVERIFY(withoutNeedlessPoints({}, 0.01).empty());
    }
};

QTEST_APPLESS_MAIN(TestCurveSampling)
#include "tst_curve_sampling.moc"
