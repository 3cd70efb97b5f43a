// SPDX-License-Identifier: GPL-3.0-or-later

// Tests the design of a mechanism for a given stroke and time ratio, by the limits of its motion.

#include "core/limits/design.h"
#include "core/limits/mobility.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace slidercrank;

namespace tst_design
{

constexpr double kDegree = std::numbers::pi / 180.0;

MotionLimits limitsOf(const Lengths &lengths)
{
    return motionLimits(Mechanism({lengths.a, lengths.b, lengths.c}));
}

/// Returns the minimum transmission angle of a full revolution.
double transmissionAngle(const Lengths &lengths)
{
    return std::acos(std::min(1.0, (lengths.a + std::abs(lengths.c)) / lengths.b));
}

class TestDesign : public QObject
{
    Q_OBJECT

private slots:
    /// If the requested time ratio is below 1, the outward stroke is the slower one.
    void meetsRandomRequests()
    {
        std::mt19937_64 random(24);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        int feasible = 0;
        while (feasible < 10'000) {
            DesignRequest request;
            request.stroke = std::pow(10.0, -2.0 + 6.0 * unit(random));
            const double timeRatio = unit(random) < 0.1 ? 1.0 : 1.0 + 1.9 * unit(random);
            const bool isReciprocal = unit(random) < 0.2;
            request.timeRatio = isReciprocal ? 1.0 / timeRatio : timeRatio;
            if (unit(random) < 0.5) {
                request.transmissionAngle = 80.0 * kDegree * unit(random);
            }
            const std::variant<Lengths, DesignFault> result = design(request);
            if (std::holds_alternative<DesignFault>(result)) {
                continue;
            }
            ++feasible;
            const Lengths &lengths = std::get<Lengths>(result);
            const MotionLimits limits = limitsOf(lengths);
            QCOMPARE(limits.mobility, Mobility::FullTurn);
            QVERIFY(std::abs(*limits.stroke / request.stroke - 1.0) < 1e-12);
            // Near the ratio 3, the angle α between the two lines of the dead centres depends on the small difference b
            // - a, which the rounding of a and b changes.
            const double tolerance = std::max(1e-12, 1e-15 * lengths.a / (lengths.b - lengths.a) / (3.0 - timeRatio));
            QVERIFY(std::abs(*limits.timeRatio / timeRatio - 1.0) < tolerance);
            const double slower = isReciprocal ? *limits.angleOutwards : *limits.angleInwards;
            QVERIFY(timeRatio == 1.0 ? lengths.c == 0.0 : slower > std::numbers::pi);
            QVERIFY(transmissionAngle(lengths) >= request.transmissionAngle.value_or(0.0));
        }
    }

    void hasTheBestTransmissionAngle()
    {
        for (const double timeRatio : {1.05, 1.2, 1.5, 2.0, 2.8}) {
            const std::optional<DesignRange> range = findDesignRange(timeRatio);
            for (int i = 1; i < 1000; ++i) {
                const double ratio = 1.0 + (std::min(range->largestRatio, kLargestProposedRatio) - 1.0) * i / 1000.0;
                QVERIFY(transmissionAngle(findLengths(80.0, timeRatio, ratio)) <= range->bestTransmissionAngle + 1e-9);
            }
        }
    }

    void refusesWhatIsImpossible()
    {
        using Reason = DesignFault::Reason;
        const auto faultOf = [](const DesignRequest &request) { return std::get<DesignFault>(design(request)); };
        QCOMPARE(faultOf({0.0, 1.2, {}}).reason, Reason::StrokeNotPositive);
        QCOMPARE(faultOf({80.0, 3.0, {}}).reason, Reason::TimeRatioOutOfRange);
        QCOMPARE(faultOf({80.0, 1.0 / 3.0, {}}).reason, Reason::TimeRatioOutOfRange);
        QCOMPARE(faultOf({80.0, std::nan(""), {}}).reason, Reason::TimeRatioOutOfRange);
        QCOMPARE(faultOf({80.0, 1.0, 90.0 * kDegree}).reason, Reason::TransmissionAngleTooLarge);

        const DesignFault fault = faultOf({80.0, 1.2, 60.0 * kDegree});
        QCOMPARE(fault.reason, Reason::TransmissionAngleTooLarge);
        QVERIFY(std::holds_alternative<Lengths>(design({80.0, 1.2, fault.bound - 1e-9})));
        QVERIFY(std::holds_alternative<Lengths>(design({80.0, fault.timeRatioBound - 1e-6, 60.0 * kDegree})));
        QVERIFY(std::holds_alternative<DesignFault>(design({80.0, fault.timeRatioBound + 1e-6, 60.0 * kDegree})));
    }
};

const Suite<TestDesign> suite("tst_design");

} // namespace tst_design

#include "tst_design.moc"
