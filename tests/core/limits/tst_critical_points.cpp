// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/critical_points.h"

#include "core/limits/instant_centre.h"
#include "core/mechanism/turn.h"
#include "core/newton/newton.h"
#include "core/sampling/trajectory.h"
#include "tests/support/long_tests.h"
#include "tests/support/mechanism_list.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace slidercrank;

namespace tst_critical_points
{

constexpr int kSteps = 20'000;

/// Returns a crank angle at which the motion of a full turn exceeds the range that the critical points give, if there
/// is one. `turn` has the crank angles as time stamps.
std::optional<double> findExcess(const CriticalPoints &points, Channel channel, const Trajectory &turn)
{
    constexpr int kStepsPerInterval = 50;
    const std::vector<double> &theta2 = turn.time;
    const std::vector<double> &values = turn[channel];
    double size = 0.0;
    for (const double value : values) {
        size = std::isfinite(value) ? std::max(size, std::abs(value)) : size;
    }
    for (std::size_t from = 0; from + kStepsPerInterval < values.size(); from += kStepsPerInterval) {
        const std::size_t to = from + kStepsPerInterval;
        double lower = std::min(values[from], values[to]);
        double upper = std::max(values[from], values[to]);
        bool isWhole = std::isfinite(values[from]) && std::isfinite(values[to]);
        for (const CriticalPoint &point : points) {
            if (theta2[from] <= point.theta2 && point.theta2 <= theta2[to]) {
                lower = std::min(lower, toFileUnit(channel, point.value));
                upper = std::max(upper, toFileUnit(channel, point.value));
                isWhole = isWhole && point.kind == CriticalPoint::Kind::Extremum;
            }
        }
        for (std::size_t i = from; i <= to && isWhole; ++i) { // otherwise the motion ends or begins in this interval
            if (!(std::max(lower - values[i], values[i] - upper) <= 1e-9 * size)) {
                return theta2[i];
            }
        }
    }
    return std::nullopt;
}

class TestCriticalPoints : public QObject
{
    Q_OBJECT

private slots:
    void motionIsMonotonicBetweenCriticalPoints()
    {
        std::vector<double> angles;
        for (int i = 0; i <= kSteps; ++i) {
            angles.push_back(-std::numbers::pi + kTurn * i / kSteps);
        }
        for (auto &[name, parameters] : mechanismList(numericCaseCount(200, 5000), 11)) {
            parameters.omega2 = 1.0;
            parameters.theta20 = 0.0;
            const Mechanism mechanism(parameters);
            const auto points = findCriticalPoints(mechanism);
            const Trajectory turn = sample(mechanism, angles, plottedChannels(), {});
            for (std::size_t k = 0; k < points.size(); ++k) {
                const std::optional<double> excess = findExcess(points[k], kPlottedChannels[k], turn);
                QVERIFY2(!excess, qPrintable(QStringLiteral("%1, channel %2 at θ2 = %3")
                                                 .arg(QString::fromStdString(name))
                                                 .arg(k)
                                                 .arg(excess.value_or(0.0), 0, 'g', 12)));
            }
        }
    }

    void includesTheLimitsOfARocker()
    {
        for (const auto &[b, limits] : {std::pair(40.0, 1), std::pair(4.0, 0)}) { // one arc, impossible
            for (const CriticalPoints &points : findCriticalPoints(Mechanism({.b = b}))) {
                QCOMPARE(std::ranges::count(points, CriticalPoint::Kind::Begin, &CriticalPoint::kind), limits);
                QCOMPARE(std::ranges::count(points, CriticalPoint::Kind::End, &CriticalPoint::kind), limits);
                QCOMPARE(points.empty(), limits == 0);
            }
        }
    }

    /// Compares with velocities from the constraint equations: v = ω3 × (r − P) at each point of the coupler.
    void instantCentreGivesTheCouplersVelocities()
    {
        RandomMechanisms random(5);
        for (int i = 0; i < 300; ++i) {
            const Parameters p = random.next();
            const Mechanism mechanism(p);
            const double t = random.uniform(-2.0, 2.0);
            const std::optional<InstantCentre> centre = instantCentre(mechanism, t);
            const State state = solve(mechanism, t, {.tolerance = 0.0}).state;
            QVERIFY(centre && state.status == Status::Solved);
            const double omega3 = state.qDot[Theta3];
            const double size = p.a * std::abs(p.omega2);
            QVERIFY(std::abs(centre->omega3 - omega3) <= 1e-9 * std::abs(p.omega2));
            const Vector12 &q = state.q;
            const Vector12 &v = state.qDot;
            const double far = 1.0 + centre->position.length() / p.a; // cancellation grows with the distance
            for (const auto &[x, factor] : {std::pair(R2x, 2.0), {R3x, 1.0}, {R4x, 1.0}}) { // A, G3, B
                const Coordinate y = static_cast<Coordinate>(x + 1);
                const double across = factor * v[x] + omega3 * (factor * q[y] - centre->position.y);
                const double up = factor * v[y] - omega3 * (factor * q[x] - centre->position.x);
                QVERIFY(std::max(std::abs(across), std::abs(up)) <= 1e-9 * far * size);
            }
            QVERIFY(std::abs(std::abs(omega3) * centre->distanceToA - size) <= 1e-9 * size);
            QVERIFY(std::abs(std::abs(omega3) * centre->distanceToB - std::abs(v[R4x])) <= 1e-9 * size);
        }
        constexpr double kQuarter = 0.5 * std::numbers::pi;
        QVERIFY(instantCentre(Mechanism({.theta20 = kQuarter}), 0.0)->distanceToA >
                1e15);                                       // infinite, except for rounding of π
        QVERIFY(!instantCentre(Mechanism({.b = 5.0}), 0.0)); // cannot be assembled
    }
};

const Suite<TestCriticalPoints> suite("tst_critical_points");

} // namespace tst_critical_points

#include "tst_critical_points.moc"
