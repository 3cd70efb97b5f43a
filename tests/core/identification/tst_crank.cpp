// SPDX-License-Identifier: GPL-3.0-or-later

// What the identification finds out about the crank: candidates of its speed, its drive, and derivatives that are
// difference quotients.

#include "core/identification/difference_quotients.h"
#include "core/identification/drive.h"
#include "core/identification/geometry.h"
#include "core/identification/speed_candidates.h"
#include "core/mechanism/turn.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace slidercrank;

namespace tst_crank
{

/// Observations with a time from 0 to 2 s and the angles θ2(t), rounded to a step.
template <class Angle>
Observations observationsOf(const Angle &angle, double step, Index rows = 201)
{
    Observations observations;
    observations.time.values = Values::LinSpaced(rows, -1.0, 1.0);
    observations.timeOrigin = 1.0;
    observations.angle.values =
        observations.time.values.unaryExpr([&](double time) { return step * std::rint(angle(time + 1.0) / step); });
    observations.angle.halfStep = 0.5 * step;
    observations.rows.resize(static_cast<std::size_t>(rows));
    return observations;
}

Index columnIndex(const Observations &observations, Channel channel)
{
    return std::ranges::find(observations.columns, channel, &ObservedColumn::channel) - observations.columns.begin();
}

/// Replaces a column of a printed motion by values that are computed from another one.
template <class Formula>
Observations withComputed(Channel computed, Channel source, double step, const Formula &formula)
{
    ReferenceData data = printedData(Parameters());
    const std::vector<double> values = valuesOf(data, source);
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const double value = formula(values[i - 1], values[i], values[i + 1], data.time[1] - data.time[0]);
        valuesOf(data, computed)[i] = step * std::rint(value / step);
    }
    return observe(data, {});
}

/// Replaces the acceleration of the slider by difference quotients of the difference quotients of its position, and
/// removes the velocity. The quotients are central or forward.
Observations withRepeatedQuotients(bool isCentral)
{
    Printing coarse;
    coarse.rows = 37;
    ReferenceData data = printedData(Parameters(), coarse);
    const std::vector<double> position = valuesOf(data, {R4x, Order::Position});
    const double dt = data.time[1] - data.time[0];
    const auto quotients = [&](const std::vector<double> &values) {
        std::vector<double> result(values.size(), 0.0);
        for (std::size_t i = 1; i + 1 < values.size(); ++i) {
            result[i] = isCentral ? (values[i + 1] - values[i - 1]) / (2.0 * dt) : (values[i + 1] - values[i]) / dt;
        }
        return result;
    };
    const std::vector<double> velocity = quotients(position);
    const std::vector<double> acceleration = quotients(velocity);
    for (std::size_t i = 0; i < acceleration.size(); ++i) {
        valuesOf(data, {R4x, Order::Acceleration})[i] = 0.01 * std::rint(100.0 * acceleration[i]);
    }
    std::erase_if(data.series, [](const ReferenceSeries &series) {
        return series.channel == Channel{R4x, Order::Velocity};
    });
    return observe(data, {});
}

class TestCrank : public QObject
{
    Q_OBJECT

private slots:
    void proposesTheSpeedFirstOrSecond()
    {
        RandomMechanisms random(20240614);
        for (int i = 0; i < 40; ++i) {
            const Parameters p = random.ordinary();
            Printing printing;
            printing.to = random.uniform(1.2, 40.0) * kTurn / std::abs(p.omega2);
            printing.rows = 400;
            const Observations observations = observe(printedData(p, printing), {});
            const std::vector<double> speeds = findSpeedCandidates(observations, shapeColumns(observations));
            const double tolerance = 0.2 * kTurn / observations.span();
            const auto isSpeed = [&](double speed) { return std::abs(speed - std::abs(p.omega2)) < tolerance; };
            QVERIFY2(std::any_of(speeds.begin(), speeds.begin() + 2, isSpeed), QByteArray::number(i));
        }
    }

    void distinguishesConstantSpeedRunUpAndRipple()
    {
        Model model{.followsAngle = true};
        const double step = 1e-4;
        const auto constant = findDrive(observationsOf([](double t) { return 0.3 - 5.0 * t; }, step), model);
        QCOMPARE(constant.kind, Drive::Kind::Constant);
        QVERIFY(std::abs(constant.omega2 + 5.0) < 1e-4 && std::abs(constant.theta20 + 4.7) < 1e-4);

        const auto runUp = findDrive(observationsOf([](double t) { return 2.0 * t + 5.0 * t * t; }, step), model);
        QCOMPARE(runUp.kind, Drive::Kind::RunUp);
        QVERIFY(std::abs(runUp.alpha2 - 10.0) < 1e-3 && std::abs(runUp.omega2 - 12.0) < 1e-3);
        QVERIFY(runUp.speedErrorAtZero > 0.0 && runUp.speedErrorAtZero < 1e-3);

        const auto ripple =
            findDrive(observationsOf([](double t) { return 6.0 * t + 0.1 * std::sin(12.0 * t); }, step), model);
        QCOMPARE(ripple.kind, Drive::Kind::Uneven);
        QVERIFY(std::abs(ripple.minSpeed - 4.8) < 0.05 && std::abs(ripple.maxSpeed - 7.2) < 0.05);
        QVERIFY(std::abs(ripple.omega2 - 6.0) < 0.1);

        // Half a period of a ripple in a few rows resembles a parabola, but its residuals are a curve.
        const auto halfPeriod = [](double t) { return 0.25 * kTurn * t + 0.05 * std::sin(0.25 * kTurn * t); };
        QCOMPARE(findDrive(observationsOf(halfPeriod, 1e-5, 19), model).kind, Drive::Kind::Uneven);

        // A ripple over two turns with a row every 30° changes its sign four times in 25 rows, as noise may.
        const auto twoPeriods = [](double t) { return kTurn * t + 0.05 * std::sin(kTurn * t); };
        QCOMPARE(findDrive(observationsOf(twoPeriods, 1e-5, 25), model).kind, Drive::Kind::Uneven);
    }

    void takesNoiseOfTheAngleForAConstantSpeed()
    {
        RandomMechanisms random(3);
        const auto noisy =
            findDrive(observationsOf([&](double t) { return 6.0 * t + random.uniform(-0.01, 0.01); }, 1e-6),
                      {.followsAngle = true});
        QCOMPARE(noisy.kind, Drive::Kind::Constant);
        QVERIFY(std::abs(noisy.omega2 - 6.0) < 0.01);
    }

    void readsTheAngleOfTheFileLikeTheModel()
    {
        const auto drive = findDrive(observationsOf([](double t) { return 1.0 + 4.0 * t; }, 1e-4),
                                     {.mechanism = {.theta20 = 0.5}, .followsAngle = true, .angleFactor = -1.0});
        QVERIFY(std::abs(drive.omega2 + 4.0) < 1e-4 && std::abs(drive.theta20 + 4.5) < 1e-4); // 0.5 - (1 + 4)
    }

    void recognizesDifferenceQuotients()
    {
        const Channel slider{R4x, Order::Position};
        const Channel speed{R4x, Order::Velocity};
        const Channel acceleration{R4x, Order::Acceleration};
        const auto isMarked = [](const Observations &observations, Channel channel) {
            return withComputedColumnsMarked(observations).columns[columnIndex(observations, channel)].isDifference;
        };
        using Values3 = double (*)(double, double, double, double);
        for (const Values3 quotient :
             {Values3([](double before, double, double after, double dt) { return (after - before) / (2.0 * dt); }),
              Values3([](double, double at, double after, double dt) { return (after - at) / dt; }),
              Values3([](double before, double at, double, double dt) {
                  return 3.0 * (at - before) / dt; // apart from a factor
              })}) {
            QVERIFY(isMarked(withComputed(speed, slider, 1e-3, quotient), speed));
        }
        const auto second = [](double before, double at, double after, double dt) {
            return (before - 2.0 * at + after) / (dt * dt);
        };
        QVERIFY(isMarked(withComputed(acceleration, slider, 1e-2, second), acceleration));
        for (const bool isCentral : {true, false}) { // quotients of a velocity that the file does not contain
            QVERIFY(isMarked(withRepeatedQuotients(isCentral), acceleration));
        }
        Printing coarse; // so that quotients differ from derivatives by more than their rounding
        coarse.rows = 31;
        const Observations exact = observe(printedData(Parameters(), coarse), {});
        QVERIFY(!isMarked(exact, speed) && !isMarked(exact, acceleration));
    }

    void recognizesLinearInterpolation()
    {
        ReferenceData data = printedData(Parameters());
        const auto isInterpolated = [&] {
            const Observations observations = withComputedColumnsMarked(observe(data, {}));
            return observations.columns[columnIndex(observations, {R4x, Order::Position})].isInterpolated;
        };
        QVERIFY(!isInterpolated());
        std::vector<double> &values = valuesOf(data, {R4x, Order::Position});
        for (std::size_t i = 0; i + 4 < values.size(); i += 4) {
            for (std::size_t k = 1; k < 4; ++k) {
                values[i + k] = values[i] + 0.25 * static_cast<double>(k) * (values[i + 4] - values[i]);
            }
        }
        QVERIFY(isInterpolated());
    }
};

const Suite<TestCrank> suite("tst_crank");

} // namespace tst_crank

#include "tst_crank.moc"
