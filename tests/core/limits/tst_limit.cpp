// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/limit.h"
#include "core/mechanism/turn.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <map>

using namespace slidercrank;

namespace tst_limit
{

constexpr double kFourteenDigits = 1e-14; // relative

/// Returns a mechanism with lengths of 1e-9 to 1e12 mm. By the index, the lengths are independent of each other, or the
/// mechanism is near a toggle on either side, or coupler and offset have ordinary proportions to the crank.
Parameters mechanismOfAnySize(RandomMechanisms &random, int index)
{
    const auto anyLength = [&random] { return std::pow(10.0, random.uniform(-9.0, 12.0)); };
    Parameters p;
    p.a = anyLength();
    p.c = (random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0) * (index % 7 == 0 ? 0.0 : anyLength());
    p.b = anyLength();
    if (index % 3 == 1) {
        p.c = p.a * random.uniform(-3.0, 3.0);
        const double gap = std::pow(10.0, -random.uniform(1.0, 16.0));
        p.b = (p.a + std::abs(p.c)) * (1.0 + (random.uniform(-1.0, 1.0) < 0.0 ? -gap : gap));
    } else if (index % 3 == 2) {
        p.c = p.a * random.uniform(-3.0, 3.0);
        p.b = p.a * random.uniform(0.1, 8.0);
    }
    p.b = std::clamp(p.b, kShortestLink, kLargestParameter);
    p.c = std::clamp(p.c, -kLargestParameter, kLargestParameter);
    p.omega2 = random.uniform(0.1, 10.0) * (index % 2 == 0 ? 1.0 : -1.0);
    p.branch = index % 4 < 2 ? Branch::Open : Branch::Crossed;
    return p;
}

/// The limits by the formulas of the textbook with 115 digits, by kind.
class ExactLimits
{
public:
    explicit ExactLimits(const Parameters &parameters)
        : p(parameters)
        , a(parameters.a)
        , b(parameters.b)
        , c(parameters.c)
        , C(std::abs(parameters.c))
        , pi(acos(ManyDigits(-1.0)))
    {
        if (b >= a + C) {
            addFullTurn();
        } else if (b > C - a) {
            addRocker();
        }
    }

    std::map<LimitKind, ManyDigits> values;

private:
    void addFullTurn()
    {
        using enum LimitKind;
        const ManyDigits side = p.branch == Branch::Open ? 1.0 : -1.0;
        const ManyDigits outer = side * sqrt((a + b) * (a + b) - c * c);
        const ManyDigits inner = side * sqrt((b - a) * (b - a) - c * c);
        values[OuterDeadCentre] = outer;
        values[InnerDeadCentre] = inner;
        const ManyDigits stroke = abs(outer - inner);
        values[Stroke] = stroke;
        const ManyDigits outerAngle = atan2(c, outer);
        const ManyDigits innerAngle = atan2(c, inner) + pi;
        ManyDigits forward = (outerAngle - innerAngle) * (p.omega2 < 0.0 ? -1 : 1);
        while (forward < 0) {
            forward += 2 * pi;
        }
        while (forward >= 2 * pi) {
            forward -= 2 * pi;
        }
        const ManyDigits back = 2 * pi - forward;
        values[ForwardAngle] = forward;
        values[ReturnAngle] = back;
        values[ForwardTime] = forward / std::abs(p.omega2);
        values[ReturnTime] = back / std::abs(p.omega2);
        values[MeanForwardSpeed] = stroke / values[ForwardTime];
        values[MeanReturnSpeed] = stroke / values[ReturnTime];
        values[TimeRatio] = forward > back ? ManyDigits(forward / back) : ManyDigits(back / forward);
        addAngles(asin((c - a) / b), asin((c + a) / b));
    }

    void addRocker()
    {
        const ManyDigits high = c + a > b ? b : ManyDigits(c + a);
        const ManyDigits low = c - a < -b ? ManyDigits(-b) : ManyDigits(c - a);
        addAngles(asin(low / b), asin(high / b));
        // x at which the slider reverses, on the arc with cos θ2 > 0 (`right`) and on that with cos θ2 < 0 (`left`).
        std::vector<ManyDigits> right;
        std::vector<ManyDigits> left;
        for (const ManyDigits &height : {b, ManyDigits(-b)}) {
            const ManyDigits sine = (c - height) / a;
            if (abs(sine) <= 1) {
                const ManyDigits reach = a * sqrt(1 - sine * sine);
                right.push_back(reach);
                left.push_back(ManyDigits(-reach));
            }
        }
        const bool isOpen = p.branch == Branch::Open;
        const ManyDigits outer = sqrt((a + b) * (a + b) - c * c);
        (isOpen ? right : left).push_back(isOpen ? outer : ManyDigits(-outer));
        values[LimitKind::OuterDeadCentre] = isOpen ? outer : ManyDigits(-outer);
        const ManyDigits square = (b - a) * (b - a) - c * c;
        if (square >= 0) {
            const ManyDigits inner = sqrt(square);
            (isOpen ? left : right).push_back(isOpen ? ManyDigits(-inner) : inner);
            values[LimitKind::InnerDeadCentre] = isOpen ? ManyDigits(-inner) : inner;
        }
        if (b >= a - C) { // one arc
            right.insert(right.end(), left.begin(), left.end());
            left = right;
        }
        const auto span = [](const std::vector<ManyDigits> &positions) {
            return ManyDigits(*std::ranges::max_element(positions) - *std::ranges::min_element(positions));
        };
        values[LimitKind::Stroke] = span(right) > span(left) ? span(right) : span(left);
    }

    /// Adds the angles of the coupler from the extremes of asin(h/b).
    void addAngles(const ManyDigits &low, const ManyDigits &high)
    {
        using enum LimitKind;
        const bool isOpen = p.branch == Branch::Open;
        values[MinimumCouplerAngle] = isOpen ? low : ManyDigits(pi - high);
        values[MaximumCouplerAngle] = isOpen ? high : ManyDigits(pi - low);
        values[CouplerSwing] = high - low;
        const ManyDigits steepest = abs(low) > abs(high) ? ManyDigits(abs(low)) : ManyDigits(abs(high));
        const ManyDigits flattest = abs(low) > abs(high) ? ManyDigits(abs(high)) : ManyDigits(abs(low));
        values[MinimumTransmissionAngle] = pi / 2 - steepest;
        values[MaximumTransmissionAngle] = pi / 2 - (low < 0 && high > 0 ? ManyDigits(0.0) : flattest);
    }

    Parameters p;
    ManyDigits a, b, c, C, pi;
};

/// Returns the largest magnitude of a channel near a crank angle, by Newton's method for its derivative.
ManyDigits exactPeakNear(const Parameters &p, Channel channel, double theta2)
{
    const ManyDigits step = 1e-30;
    const auto at = [&](const ManyDigits &angle) {
        ExactInput in(p, 0.0);
        in.theta20 = angle;
        return exactState(in).values[indexOf(channel)];
    };
    ManyDigits angle = theta2;
    for (int i = 0; i < 6; ++i) {
        const ManyDigits before = at(ManyDigits(angle - step));
        const ManyDigits here = at(angle);
        const ManyDigits after = at(ManyDigits(angle + step));
        const ManyDigits curvature = after - 2 * here + before;
        if (curvature == 0) {
            break;
        }
        angle -= (after - before) * step / (2 * curvature);
    }
    return abs(at(angle));
}

class TestLimit : public QObject
{
    Q_OBJECT

private slots:
    /// Tests lengths that differ by many orders of magnitude, and mechanisms near toggles, too.
    void everyLimitHasFourteenDigits()
    {
        RandomMechanisms random(50);
        std::map<LimitKind, int> counts;
        for (int i = 0; i < 2000; ++i) {
            const Parameters p = mechanismOfAnySize(random, i);
            const Mechanism mechanism(p);
            const std::vector<Limit> limits = findLimits(mechanism, motionLimits(mechanism));
            const std::map<LimitKind, ManyDigits> exact = ExactLimits(p).values;
            for (const auto &[kind, value] : exact) {
                ++counts[kind];
                const double computed = valueOf(limits, kind);
                const double error = static_cast<double>(abs(computed - value));
                QVERIFY2(
                    error <= kFourteenDigits * static_cast<double>(abs(value)),
                    (std::string(describe(kind).key) + " of " + describe(p) + ": " + std::to_string(computed)).c_str());
            }
            for (const Limit &limit : limits) {
                const bool isPeak = peakChannel(limit.kind).has_value();
                QVERIFY2(isPeak || limit.kind == LimitKind::CrankLimit || exact.contains(limit.kind),
                         (std::string(describe(limit.kind).key) + " of " + describe(p)).c_str());
            }
        }
        for (const LimitDescription &description : kLimitDescriptions) {
            const bool isTested = !peakChannel(description.kind) && description.kind != LimitKind::CrankLimit;
            QVERIFY2(!isTested || counts[description.kind] > 200, std::string(description.key).c_str());
        }
    }

    /// tst_extremes tests that the peak is the largest one.
    void everyPeakHasFourteenDigits()
    {
        RandomMechanisms random(51);
        int seen = 0;
        for (int i = 0; i < 2000; ++i) {
            const Parameters p = mechanismOfAnySize(random, i);
            if (i % 4 != 0 || !(ManyDigits(p.b) > ManyDigits(p.a) + std::abs(p.c))) {
                continue;
            }
            const Mechanism mechanism(p);
            for (const Limit &limit : findLimits(mechanism, motionLimits(mechanism))) {
                if (const std::optional<Channel> channel = peakChannel(limit.kind)) {
                    ++seen;
                    const ManyDigits exact = exactPeakNear(p, *channel, *limit.theta2);
                    const double error = static_cast<double>(abs(std::abs(limit.value) - exact) / exact);
                    QVERIFY2(error <= kFourteenDigits, (std::string(describe(limit.kind).key) + " of " + describe(p) +
                                                        ": " + std::to_string(error / kFourteenDigits))
                                                           .c_str());
                }
            }
        }
        QVERIFY(seen > 500);
    }

    /// Computes θ3 or the transmission angle at each crank angle that is stated for its extremes.
    void couplerAnglesOccurAtTheirCrankAngles()
    {
        RandomMechanisms random(52);
        for (int i = 0; i < 500; ++i) {
            Parameters p = random.next();
            p.c = i % 5 == 0 ? 0.0 : p.c;
            p.b *= i % 2 == 0 ? 1.0 : random.uniform(0.2, 1.0);
            const Mechanism mechanism(p);
            for (const Limit &limit : findLimits(mechanism, motionLimits(mechanism))) {
                const bool isTransmission = limit.kind == LimitKind::MinimumTransmissionAngle ||
                                            limit.kind == LimitKind::MaximumTransmissionAngle;
                const bool isTheta3 =
                    limit.kind == LimitKind::MinimumCouplerAngle || limit.kind == LimitKind::MaximumCouplerAngle;
                if (isTransmission || isTheta3) {
                    const double sine = (p.c - p.a * std::sin(*limit.theta2)) / p.b;
                    const double elevation = std::asin(std::clamp(sine, -1.0, 1.0));
                    const double theta3 = p.branch == Branch::Open ? elevation : kTurn / 2.0 - elevation;
                    const double angle = isTheta3 ? theta3 : kQuarterTurn - std::abs(elevation);
                    QVERIFY2(std::abs(angle - limit.value) < 1e-7, describe(p).c_str());
                }
            }
        }
    }

    void crankAnglesOfOneLimitAscendFromZero()
    {
        const Mechanism mechanism({20.0, 65.0, 0.0, 1.0});
        double last = -1.0;
        int count = 0;
        for (const Limit &limit : findLimits(mechanism, motionLimits(mechanism))) {
            if (limit.kind == LimitKind::MinimumTransmissionAngle) {
                QVERIFY(wrapToTwoPi(*limit.theta2) > last);
                last = wrapToTwoPi(*limit.theta2);
                ++count;
            }
        }
        QCOMPARE(count, 2);
    }
};

const Suite<TestLimit> suite("tst_limit");

} // namespace tst_limit

#include "tst_limit.moc"
