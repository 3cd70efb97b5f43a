// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/model_curves.h"

#include "ui/document/session.h"

#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

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

/// NaN is as good as NaN.
bool isSame(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool isSame(const std::vector<CurvePoint> &a, const std::vector<CurvePoint> &b)
{
    return std::ranges::equal(a, b, [](const CurvePoint &one, const CurvePoint &other) {
        return isSame(one.t, other.t) && isSame(one.value, other.value);
    });
}

} // namespace

/// A run that is computed wherever somebody looks is that which was kept, to the last bit.
class TestModelCurves : public QObject
{
    Q_OBJECT

private slots:
    void whatIsComputedIsWhatWouldBeKept_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<Branch>("branch");
        QTest::addColumn<double>("duration");
        QTest::newRow("a crank that turns round") << 65.0 << Branch::Open << 1.0;
        QTest::newRow("crossed") << 65.0 << Branch::Crossed << 3.0;
        QTest::newRow("backwards in time") << 65.0 << Branch::Open << -2.0;
        QTest::newRow("a rocker: gaps") << 40.0 << Branch::Open << 2.0;
        QTest::newRow("a rocker backwards") << 40.0 << Branch::Open << -2.0;
        QTest::newRow("through the toggle") << 45.0 << Branch::Open << 1.0;
        QTest::newRow("no pose at all") << 4.0 << Branch::Open << 1.0;
    }

    void whatIsComputedIsWhatWouldBeKept()
    {
        QFETCH(const double, b);
        QFETCH(const Branch, branch);
        QFETCH(const double, duration);
        Parameters parameters;
        parameters.b = b;
        parameters.branch = branch;
        const Result unkept = runOf(parameters, {0.25, duration, kSteps});
        const Result whole = kept(unkept);
        QVERIFY(!unkept.isKept() && whole.isKept());
        ModelCurves computed(unkept);
        ModelCurves lookedUp(whole);

        QCOMPARE(computed.size(), lookedUp.size());
        const double first = lookedUp.instant(0);
        const double last = lookedUp.instant(lookedUp.size() - 1);
        QVERIFY(first < last);
        const double middle = first + 0.3 * (last - first);
        const Interval ranges[] = {{first, last}, {middle, middle + 0.1}, {middle, middle + 1e-4}, {first - 1.0, last}};
        for (std::size_t channel = 0; channel < ModelCurves::kChannels; ++channel) {
            for (const Interval &range : ranges) {
                const std::vector<CurvePoint> points = computed.decimated(channel, range, kColumns);
                QVERIFY(!points.empty());
                QVERIFY(isSame(points, lookedUp.decimated(channel, range, kColumns)));
                QVERIFY(isSame(points, computed.decimated(channel, range, kColumns))); // asked for again
            }
            QVERIFY(computed.extremes(channel) == lookedUp.extremes(channel));
            for (const std::size_t i : {std::size_t(0), std::size_t(77'777), computed.size() - 1}) {
                QCOMPARE(computed.instant(i), lookedUp.instant(i));
                QVERIFY(isSame(computed.value(channel, i), lookedUp.value(channel, i)));
            }
        }
        for (const double t : {first - 1.0, first, middle, last, last + 1.0}) {
            QCOMPARE(computed.nearest(t), lookedUp.nearest(t));
        }
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
            QCOMPARE(result.summary.endedWith[i], whole.trajectory.count(static_cast<Status>(i)));
        }
    }

    void noResultHasNoInstant()
    {
        const ModelCurves none;
        QVERIFY(none.empty());
        QCOMPARE(none.size(), std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(TestModelCurves)
#include "tst_model_curves.moc"
