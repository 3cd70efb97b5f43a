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
#include <array>
#include <cmath>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr int kSteps = 20'000;

/// Returns a crank angle near which the motion of a full turn exceeds the range that the critical points give, if there
/// is one. `turn` has the crank angles as time stamps.
std::optional<double> findExcess(const CriticalPoints &points, Channel channel, const Trajectory &turn)
{
    constexpr int kLook = 50; // number of angle steps per interval
    const std::vector<double> &theta2 = turn.time;
    const std::vector<double> &values = turn[channel];
    double size = 0.0;
    for (const double value : values) {
        size = std::isfinite(value) ? std::max(size, std::abs(value)) : size;
    }
    for (std::size_t from = 0; from + kLook < values.size(); from += kLook) {
        const std::size_t to = from + kLook;
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

} // namespace

/// Between two critical points the motion is monotonic.
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
        for (auto &[name, parameters] : mechanismList(numericRuns(200, 5000), 11)) {
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
        Parameters p;
        p.b = 40.0;
        for (const CriticalPoints &course : findCriticalPoints(Mechanism(p))) {
            const auto count = [&course](CriticalPoint::Kind kind) {
                return std::ranges::count(course, kind, &CriticalPoint::kind);
            };
            QCOMPARE(count(CriticalPoint::Kind::Begin), 1);
            QCOMPARE(count(CriticalPoint::Kind::End), 1);
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
            NewtonOptions options;
            options.tolerance = 0.0;
            const State state = solve(mechanism, t, options).state;
            QVERIFY(centre && state.status == Status::Solved);
            const double omega3 = state.qDot[Theta3];
            const double size = p.a * std::abs(p.omega2);
            QVERIFY(std::abs(centre->omega3 - omega3) <= 1e-9 * std::abs(p.omega2));
            const Vector12 &q = state.q;
            const Vector12 &v = state.qDot;
            const std::array<std::array<double, 4>, 3> points{{{2.0 * q[R2x], 2.0 * q[R2y], 2.0 * v[R2x], 2.0 * v[R2y]},
                                                               {q[R3x], q[R3y], v[R3x], v[R3y]},
                                                               {q[R4x], q[R4y], v[R4x], v[R4y]}}};
            for (const auto &[x, y, vx, vy] : points) {
                const double far = 1.0 + std::hypot(centre->position.x, centre->position.y) /
                                             p.a; // cancellation grows with the distance
                QVERIFY(std::abs(vx + omega3 * (y - centre->position.y)) <= 1e-9 * far * size);
                QVERIFY(std::abs(vy - omega3 * (x - centre->position.x)) <= 1e-9 * far * size);
            }
            QVERIFY(std::abs(std::abs(omega3) * centre->toA - size) <= 1e-9 * size);
            QVERIFY(std::abs(std::abs(omega3) * centre->toB - std::abs(v[R4x])) <= 1e-9 * size);
        }
        Parameters square;
        square.theta20 = 0.5 * std::numbers::pi;
        QVERIFY(instantCentre(Mechanism(square), 0.0)->toA > 1e15); // infinite, except for the rounding of π
        square.b = square.c - square.a;                             // crank and coupler are vertical and overlap
        square.theta20 = 0.0;
        QVERIFY(!instantCentre(Mechanism(square), 0.0)); // cannot be assembled
    }

    void isEmptyWhereNothingMoves()
    {
        Parameters p;
        p.b = 4.0;
        for (const CriticalPoints &course : findCriticalPoints(Mechanism(p))) {
            QVERIFY(course.empty());
        }
    }
};

const Suite suite("tst_critical_points", runWithEventLoop<TestCriticalPoints>);
#include "tst_critical_points.moc"
