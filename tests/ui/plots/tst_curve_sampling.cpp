// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/curve_sampling.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace slidercrank;

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> instants(std::size_t count)
{
    std::vector<double> time(count);
    for (std::size_t i = 0; i < count; ++i) {
        time[i] = static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return time;
}

std::vector<CurvePoint> decimated(const std::vector<double> &time, const std::vector<double> &values,
                                  std::size_t columns)
{
    return decimate(time, values, pixelColumns(time, {0.0, 1.0}, columns));
}

std::size_t gapsIn(const std::vector<CurvePoint> &points)
{
    std::size_t gaps = 0;
    for (const CurvePoint &point : points) {
        gaps += std::isnan(point.value) ? 1 : 0;
    }
    return gaps;
}

bool isAscending(const std::vector<CurvePoint> &points)
{
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].t < points[i - 1].t) {
            return false;
        }
    }
    return true;
}

} // namespace

class TstCurveSampling : public QObject
{
    Q_OBJECT

private slots:
    void drawsEveryOneOfFewSamples();
    void keepsTheExtremesOfEveryPixelColumn();
    void keepsTheirOrder();
    void keepsAGapOfOneSampleAmongThousands();
    void keepsTheExtremesBesideAGap();
    void takesAnInfiniteValueForAGap();
    void takesOneNeighbourBeyondEachEdge();
    void findsNoExtremesWhereNothingExists();
    void cutsACurveAtTheEdges();
    void cutsASegmentThatOnlyPassesThrough();
    void givesDashesTheirLength();
    void beginsADashBehindEveryGap();
    void findsPointsThatNoLineReaches();
    void dropsOnlyPointsThatTheLinePasses();
    void keepsCornersAndGapsWhenDroppingPoints();
};

void TstCurveSampling::drawsEveryOneOfFewSamples()
{
    const std::vector<double> time = instants(201);
    std::vector<double> values(time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
        values[i] = std::sin(20.0 * time[i]);
    }
    values[77] = kNaN;
    const std::vector<CurvePoint> points = decimated(time, values, 150);
    QCOMPARE(points.size(), time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
        QCOMPARE(points[i].t, time[i]);
        QCOMPARE(points[i].value, values[i]);
    }
}

void TstCurveSampling::keepsTheExtremesOfEveryPixelColumn()
{
    constexpr std::size_t kColumns = 100;
    std::mt19937 random(20260);
    std::normal_distribution<double> noise;
    const std::vector<double> time = instants(20001);
    std::vector<double> values(time.size());
    for (double &value : values) {
        value = noise(random);
    }
    const PixelColumns columns = pixelColumns(time, {0.0, 1.0}, kColumns);
    const std::vector<CurvePoint> points = decimate(time, values, columns);
    QCOMPARE(columns.starts.size(), kColumns + 1);
    QVERIFY(points.size() <= 2 * kColumns);
    QVERIFY(isAscending(points));
    for (std::size_t column = 0; column < kColumns; ++column) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(columns.starts[column]);
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(columns.starts[column + 1]);
        const auto [lowest, highest] = std::minmax_element(begin, end);
        const auto isKept = [&](double value) {
            return std::any_of(points.begin(), points.end(), [&](const CurvePoint &p) { return p.value == value; });
        };
        QVERIFY(isKept(*lowest));
        QVERIFY(isKept(*highest));
    }
}

void TstCurveSampling::keepsTheirOrder()
{
    const std::vector<double> time = instants(1001);
    std::vector<double> values(time.size(), 0.0);
    values[300] = 5.0;
    values[310] = -5.0;
    const std::vector<CurvePoint> points = decimated(time, values, 3);
    const auto peak = std::find_if(points.begin(), points.end(), [](const CurvePoint &p) { return p.value == 5.0; });
    const auto pit = std::find_if(points.begin(), points.end(), [](const CurvePoint &p) { return p.value == -5.0; });
    QVERIFY(peak != points.end() && pit != points.end());
    QVERIFY(peak < pit);
    QCOMPARE(peak->t, time[300]);
    QCOMPARE(pit->t, time[310]);
}

void TstCurveSampling::keepsAGapOfOneSampleAmongThousands()
{
    const std::vector<double> time = instants(20001);
    std::vector<double> values(time.size(), 1.0);
    for (const std::size_t gap :
         {std::size_t(0), std::size_t(1), std::size_t(9999), std::size_t(10000), time.size() - 1}) {
        std::vector<double> broken = values;
        broken[gap] = kNaN;
        const std::vector<CurvePoint> points = decimated(time, broken, 200);
        QCOMPARE(gapsIn(points), std::size_t(1));
        QVERIFY(isAscending(points));
    }
}

void TstCurveSampling::keepsTheExtremesBesideAGap()
{
    const std::vector<double> time = instants(1001);
    std::vector<double> values(time.size(), 0.0);
    values[10] = 7.0;
    values[20] = kNaN;
    values[30] = -7.0;
    values[40] = 9.0;
    values[50] = kNaN;
    const std::vector<CurvePoint> points = decimated(time, values, 2);
    const std::optional<Interval> range = extremes(points);
    QVERIFY(range.has_value());
    QCOMPARE(range->lower, -7.0);
    QCOMPARE(range->upper, 9.0);
    QVERIFY(gapsIn(points) >= 1);
    QVERIFY(isAscending(points));
}

void TstCurveSampling::takesAnInfiniteValueForAGap()
{
    const std::vector<double> time = instants(1001);
    std::vector<double> values(time.size(), 2.0);
    values[500] = std::numeric_limits<double>::infinity();
    for (const std::size_t columns : {std::size_t(10), std::size_t(1000)}) {
        const std::vector<CurvePoint> points = decimated(time, values, columns);
        QCOMPARE(gapsIn(points), std::size_t(1));
        QCOMPARE(extremes(points)->upper, 2.0);
    }
    QCOMPARE(extremes(values)->upper, 2.0);
}

void TstCurveSampling::takesOneNeighbourBeyondEachEdge()
{
    const std::vector<double> time = instants(11);
    const PixelColumns columns = pixelColumns(time, {0.32, 0.58}, 100);
    QCOMPARE(columns.first, std::size_t(3));
    QCOMPARE(columns.end, std::size_t(7));
}

void TstCurveSampling::findsNoExtremesWhereNothingExists()
{
    QVERIFY(!extremes(std::vector<double>{}).has_value());
    QVERIFY(!extremes(std::vector<double>{kNaN, kNaN}).has_value());
    QVERIFY(!extremes(std::vector<CurvePoint>{{0.0, kNaN}}).has_value());
}

void TstCurveSampling::cutsACurveAtTheEdges()
{
    const std::vector<CurvePoint> line{{-1.0, -1.0}, {0.5, 0.5}, {1.5, 2.5}, {2.0, 0.5}};
    const std::vector<CurvePoint> kept = clip(line, {0.0, 2.0}, {0.0, 1.0});
    QCOMPARE(kept.size(), std::size_t(6));
    QCOMPARE(kept[0].t, 0.0);
    QCOMPARE(kept[0].value, 0.0);
    QCOMPARE(kept[1].t, 0.5);
    QCOMPARE(kept[2].t, 0.75);
    QCOMPARE(kept[2].value, 1.0);
    QVERIFY(std::isnan(kept[3].value));
    QCOMPARE(kept[4].t, 1.875);
    QCOMPARE(kept[4].value, 1.0);
    QCOMPARE(kept[5].t, 2.0);
}

void TstCurveSampling::cutsASegmentThatOnlyPassesThrough()
{
    const std::vector<CurvePoint> kept = clip(std::vector<CurvePoint>{{0.0, -1.0}, {1.0, 3.0}}, {0.0, 1.0}, {0.0, 1.0});
    QCOMPARE(kept.size(), std::size_t(3));
    QCOMPARE(kept[0].t, 0.25);
    QCOMPARE(kept[1].t, 0.5);
    QVERIFY(std::isnan(kept[2].value));
    QVERIFY(clip(std::vector<CurvePoint>{{0.0, 2.0}, {1.0, 3.0}}, {0.0, 1.0}, {0.0, 1.0}).empty());
}

void TstCurveSampling::givesDashesTheirLength()
{
    const std::vector<CurvePoint> line{{0.0, 0.0}, {0.5, 0.0}, {3.0, 0.0}};
    const std::vector<CurvePoint> dashes = cutIntoDashes(line, {7.0, 6.0, 10.0, 1.0}); // 30 long
    // 0-7, 13-20, 26-30: each begin and end, two gaps, and the vertex at 5.
    QCOMPARE(dashes.size(), std::size_t(9));
    QCOMPARE(dashes[0].t, 0.0);
    QCOMPARE(dashes[1].t, 0.5);
    QCOMPARE(dashes[2].t, 0.7);
    QVERIFY(std::isnan(dashes[3].value));
    QCOMPARE(dashes[4].t, 1.3);
    QCOMPARE(dashes[5].t, 2.0);
    QVERIFY(std::isnan(dashes[6].value));
    QCOMPARE(dashes[7].t, 2.6);
    QCOMPARE(dashes[8].t, 3.0);
}

void TstCurveSampling::beginsADashBehindEveryGap()
{
    const std::vector<CurvePoint> line{{0.0, 0.0}, {8.0, 0.0}, {9.0, kNaN}, {10.0, 1.0}, {11.0, 1.0}};
    const std::vector<CurvePoint> dashes = cutIntoDashes(line, {7.0, 6.0, 1.0, 1.0});
    QCOMPARE(dashes.back().t, 11.0);
    QCOMPARE(dashes[dashes.size() - 2].t, 10.0);
}

void TstCurveSampling::findsPointsThatNoLineReaches()
{
    const std::vector<CurvePoint> points{{0.0, 1.0}, {1.0, kNaN}, {2.0, 3.0}, {3.0, 4.0}, {4.0, kNaN}, {5.0, 6.0}};
    const std::vector<CurvePoint> isolated = isolatedPoints(points);
    QCOMPARE(isolated.size(), std::size_t(2));
    QCOMPARE(isolated[0].t, 0.0);
    QCOMPARE(isolated[1].t, 5.0);
}

void TstCurveSampling::dropsOnlyPointsThatTheLinePasses()
{
    const std::vector<double> time = instants(2001);
    std::vector<CurvePoint> curve;
    for (const double t : time) {
        curve.push_back({t, std::sin(15.0 * t) + 0.2 * std::cos(90.0 * t)});
    }
    constexpr double kTolerance = 1e-3;
    const std::vector<CurvePoint> kept = withoutNeedlessPoints(curve, kTolerance);
    QVERIFY(kept.size() < curve.size() / 4);
    QCOMPARE(kept.front().t, curve.front().t);
    QCOMPARE(kept.back().t, curve.back().t);
    QVERIFY(isAscending(kept));
    std::size_t part = 0;
    for (const CurvePoint &point : curve) {
        while (part + 2 < kept.size() && kept[part + 1].t < point.t) {
            ++part;
        }
        const double slope = (kept[part + 1].value - kept[part].value) / (kept[part + 1].t - kept[part].t);
        const double line = kept[part].value + slope * (point.t - kept[part].t);
        QVERIFY2(std::abs(line - point.value) <= kTolerance * (1.0 + 1e-9), qPrintable(QString::number(point.t)));
    }
}

void TstCurveSampling::keepsCornersAndGapsWhenDroppingPoints()
{
    const std::vector<CurvePoint> curve{{0, 0}, {1, 1},    {2, 2}, {3, 0}, {4, kNaN},
                                        {5, 7}, {6, kNaN}, {7, 1}, {8, 1}, {9, 1}};
    const std::vector<double> expected{0, 2, 3, 4, 5, 6, 7, 9};
    std::vector<double> kept;
    for (const CurvePoint &point : withoutNeedlessPoints(curve, 0.01)) {
        kept.push_back(point.t);
    }
    QCOMPARE(kept, expected);
    QVERIFY(withoutNeedlessPoints({}, 0.01).empty());
}

QTEST_APPLESS_MAIN(TstCurveSampling)
#include "tst_curve_sampling.moc"
