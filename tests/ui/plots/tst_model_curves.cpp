// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/model_curves.h"

#include "core/closed_form/closed_form.h"
#include "ui/document/session.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace slidercrank;

namespace
{

constexpr int kSteps = 120'000;
constexpr std::size_t kColumns = 230;

Result runOf(const Parameters &parameters, const Sampling &sampling)
{
    Result result;
    result.mechanism = Mechanism(parameters);
    result.sampling = sampling;
    result.solver.method = Method::ClosedForm;
    result.summary.instants = static_cast<std::size_t>(sampling.steps) + 1;
    return result;
}

Result kept(Result result)
{
    result.trajectory = sample(result.mechanism, result.sampling.instants(), plottedChannels(), result.solver);
    return result;
}

} // namespace

/// In closed form the motion, by Newton-Raphson its samples.
class TestModelCurves : public QObject
{
    Q_OBJECT

private slots:
    void inClosedFormEveryInstantCanBeRead()
    {
        const Parameters parameters;
        const Result result = runOf(parameters, {0.25, -2.0, 7});
        const ModelCurves curves(result);
        QVERIFY(curves.isMotion() && !curves.empty());
        QCOMPARE(curves.instantNear(-9.0), -1.75);
        QCOMPARE(curves.instantNear(0.5), 0.25);
        const double t = 0.123456789;
        QCOMPARE(curves.instantNear(t), t);
        const Motion motion = ClosedForm(result.mechanism).motionAt(t);
        QCOMPARE(curves.value(0, t), motion.theta3 * kDegreesPerRadian);
        QCOMPARE(curves.value(1, t), motion.R4x);
        QCOMPARE(curves.value(5, t), motion.R4xDDot);
    }

    void ofNewtonRaphsonItIsTheNearestSample()
    {
        for (const double duration : {2.0, -2.0}) {
            Result result = runOf({}, {0.25, duration, 8});
            result.solver.method = Method::Newton;
            result = kept(result);
            const ModelCurves curves(result);
            QVERIFY(!curves.isMotion());
            const double sample = 0.25 + duration / 8.0;
            QCOMPARE(curves.instantNear(sample + 0.1), sample);
            QCOMPARE(curves.value(1, sample), result.trajectory[kPlottedChannels[1]][1]);
        }
    }

    void whatIsShownIsThereFromEdgeToEdge_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("duration");
        QTest::addColumn<bool>("hasGaps");
        QTest::newRow("a crank that turns round") << 65.0 << 1.0 << false;
        QTest::newRow("backwards in time") << 65.0 << -2.0 << false;
        QTest::newRow("a rocker: gaps") << 40.0 << 2.0 << true;
        QTest::newRow("a rocker backwards") << 40.0 << -2.0 << true;
    }

    void whatIsShownIsThereFromEdgeToEdge()
    {
        QFETCH(const double, b);
        QFETCH(const double, duration);
        QFETCH(const bool, hasGaps);
        Parameters parameters;
        parameters.b = b;
        const Result result = runOf(parameters, {0.25, duration, 3});
        ModelCurves curves(result);
        const Interval run{std::min(0.25, 0.25 + duration), std::max(0.25, 0.25 + duration)};
        const double middle = run.lower + 0.3 * run.length();
        for (const Interval &range : {run, Interval{middle, middle + 0.1}, Interval{run.lower - 1.0, run.upper}}) {
            for (std::size_t channel = 0; channel < ModelCurves::kChannels; ++channel) {
                const std::vector<CurvePoint> points = curves.points(channel, range, kColumns);
                QVERIFY(!points.empty() && points.size() <= 3 * kColumns);
                QVERIFY(std::ranges::is_sorted(points, {}, &CurvePoint::t));
                QVERIFY(points.front().t >= std::max(range.lower, run.lower) && points.back().t <= range.upper);
                if (!hasGaps) {
                    QCOMPARE(points.front().t, std::max(range.lower, run.lower));
                    QCOMPARE(points.back().t, range.upper);
                }
                const bool hasGap =
                    std::ranges::any_of(points, [](const CurvePoint &point) { return std::isnan(point.value); });
                QVERIFY(hasGap == hasGaps || range.length() < 1.0);
            }
        }
    }

    void nothingIsShownWithoutAPose()
    {
        Parameters parameters;
        parameters.b = 4.0;
        const Result result = runOf(parameters, {0.0, 1.0, 200});
        ModelCurves curves(result);
        QVERIFY(curves.points(0, {0.0, 1.0}, kColumns).empty());
        QVERIFY(!curves.extremes(0, {0.0, 1.0}));
    }

    void aLongRunInClosedFormIsCountedButNotKept_data()
    {
        QTest::addColumn<double>("b");
        QTest::newRow("a crank that turns round") << 65.0;
        QTest::newRow("a rocker") << 40.0;
        QTest::newRow("toggle") << 45.0;
        QTest::newRow("no pose at all") << 4.0;
    }

    void aLongRunInClosedFormIsCountedButNotKept()
    {
        QFETCH(const double, b);
        Session session;
        Parameters parameters;
        parameters.b = b;
        session.setParameters(parameters);
        session.setSampling({0.0, 2.0, kSteps});
        const Result &result = *session.result();
        QVERIFY(!result.isKept());
        const Result whole = kept(result);
        QCOMPARE(result.summary.instants, whole.trajectory.time.size());
        for (std::size_t i = 0; i < kStatusCount; ++i) {
            QCOMPARE(result.summary.statusCounts[i], whole.trajectory.summary.count(static_cast<Status>(i)));
        }
    }

    void noResultHasNoCurve()
    {
        const ModelCurves none;
        QVERIFY(none.empty());
    }
};

QTEST_GUILESS_MAIN(TestModelCurves)
#include "tst_model_curves.moc"
