// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"
#include "tests/support/deviation.h"
#include "tests/support/mechanism_list.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_mobility
{

using std::numbers::pi;

/// Tolerance relative to a + b + |c|, or in rad: a few rounding errors. Square roots of small differences need more.
constexpr double kTolerance = 1e-12;

/// Returns a random mechanism: one with full turns, a rocker with one or two arcs, or one that cannot be assembled.
Parameters anyMechanism(RandomMechanisms &random)
{
    Parameters p = random.next();
    p.b = (p.a + std::abs(p.c)) * std::exp(random.uniform(-3.0, 1.5));
    return p;
}

/// A mechanism and its limits.
struct Subject {
    Parameters p;
    MotionLimits limits;
};

const std::vector<Subject> &subjects()
{
    static const std::vector<Subject> kSubjects = [] {
        std::vector<Subject> all;
        for (const auto &[name, p] : mechanismList(300, 31)) {
            all.push_back({p, motionLimits(Mechanism(p))});
        }
        return all;
    }();
    return kSubjects;
}

/// Determines the mobility with exact sums.
Mobility exactMobility(const Parameters &p)
{
    const ManyDigits a = p.a;
    const ManyDigits b = p.b;
    const ManyDigits offset = std::abs(p.c);
    if (b >= a + offset) {
        return Mobility::FullTurn;
    }
    if (b < offset - a) {
        return Mobility::Impossible;
    }
    return b == offset - a ? Mobility::Locked : Mobility::Rocker;
}

/// Returns the exact state at a crank angle (rad) for ω2 = 1 rad/s.
ExactState exactStateAt(Parameters p, double theta2)
{
    p.omega2 = 1.0;
    p.theta20 = theta2;
    return exactState(ExactInput(p, 0.0));
}

/// Returns the number of ranges of crank angles at which the mechanism can be assembled.
std::size_t rangeCount(const Parameters &p, Mobility mobility)
{
    if (mobility == Mobility::Impossible) {
        return 0;
    }
    const bool hasTwoArcs = mobility == Mobility::Rocker && p.b < p.a - std::abs(p.c);
    return hasTwoArcs ? 2 : 1;
}

/// Returns R4x or its derivative.
double sliderMotion(const ExactState &exact, Order order = Order::Position)
{
    return static_cast<double>(exact.values[indexOf({R4x, order})]);
}

/// Maps 0 … 1 to 0 … 1 with denser samples at both ends.
double denserAtEnds(double x)
{
    return 0.5 - 0.5 * std::cos(pi * x);
}

bool isWithin(const MotionLimits &limits, double theta2)
{
    return std::any_of(limits.ranges.begin(), limits.ranges.end(), [&](const CrankRange &range) {
        const double turned = theta2 - kTurn * std::floor((theta2 - range.from) / kTurn);
        return turned <= range.to;
    });
}

bool isNear(double x, double y, double tolerance)
{
    return std::abs(x - y) <= tolerance;
}

/// Like QVERIFY, but a failure also prints the mechanism.
#define VERIFY_FOR(parameters, condition) QVERIFY2(condition, describe(parameters).c_str())

class TestMobility : public QObject
{
    Q_OBJECT

private slots:
    /// One unit in the last place of b decides. If a + |c| is not exactly representable, b is compared with the exact
    /// sum.
    void classifiesByExactSums()
    {
        std::vector<Parameters> mechanisms;
        std::ranges::transform(subjects(), std::back_inserter(mechanisms), &Subject::p);
        for (const auto &[a, c] : {std::pair(20.0, 25.0),
                                   {20.0, -25.0},
                                   {20.0, 0.0},
                                   {0.1, 0.2},
                                   {1.0 / 3.0, 1e-9},
                                   {1e12, 1e-3},
                                   {1e-9, 1e9}}) {
            for (const double edge : {a + std::abs(c), std::abs(c) - a}) {
                for (const double b : {std::nextafter(edge, 0.0), edge, std::nextafter(edge, 1e300)}) {
                    mechanisms.push_back({a, b, c, 1.0});
                }
            }
        }
        std::array<int, 4> seen{};
        std::erase_if(mechanisms, [](const Parameters &p) { return findFault(p).has_value(); });
        for (const Parameters &p : mechanisms) {
            const Mobility mobility = motionLimits(Mechanism(p)).mobility;
            VERIFY_FOR(p, mobility == exactMobility(p));
            ++seen[std::size_t(mobility)];
        }
        for (const int count : seen) {
            QVERIFY(count > 0);
        }
    }

    /// A mechanism with one length at its limit still makes full turns; slightly beyond the limit it does not.
    void eachLengthHasItsLimitForAFullTurn()
    {
        const Parameters p{.a = 20.0, .b = 65.0, .c = -25.0, .omega2 = 1.0};
        const Mechanism mechanism(p);
        QCOMPARE(shortestCouplerForAnyPose(mechanism), 5.0);
        const auto turns = [&](double Parameters::*length, double value) {
            Parameters changed = p;
            changed.*length = value;
            return motionLimits(Mechanism(changed)).mobility == Mobility::FullTurn;
        };
        const double b = shortestCouplerForFullTurn(mechanism);
        QVERIFY(turns(&Parameters::a, 40.0) && !turns(&Parameters::a, std::nextafter(40.0, 1e3)));
        QVERIFY(turns(&Parameters::b, b) && !turns(&Parameters::b, std::nextafter(b, 0.0)));
        QVERIFY(turns(&Parameters::c, -45.0) && !turns(&Parameters::c, std::nextafter(-45.0, -1e3)));
    }

    /// The ranges are ordered within a turn. Those of a rocker begin and end where |c - a sin θ2| = b; that angle is
    /// accurate only to √u if a range nearly vanishes or nearly closes.
    void rangesContainTheAssemblableAngles()
    {
        constexpr double kBesideAnEnd = 1e-9; // fraction of b
        for (const auto &[p, limits] : subjects()) {
            const std::vector<CrankRange> &ranges = limits.ranges;
            VERIFY_FOR(p, ranges.size() == rangeCount(p, limits.mobility));
            VERIFY_FOR(p, limits.mobility != Mobility::FullTurn ||
                              isNear(ranges[0].to - ranges[0].from, kTurn, kTolerance));
            VERIFY_FOR(p, limits.mobility != Mobility::Locked ||
                              (ranges[0].from == ranges[0].to && !limits.innerDeadCentre));
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                VERIFY_FOR(p, ranges[i].from >= -pi && ranges[i].from < pi && ranges[i].from <= ranges[i].to);
                VERIFY_FOR(p, (i == 0 || ranges[i - 1].to < ranges[i].from) && ranges[i].to <= ranges[0].from + kTurn);
                for (const double end : {ranges[i].from, ranges[i].to}) {
                    const double height = std::abs(p.c - p.a * std::sin(end));
                    VERIFY_FOR(p, limits.mobility == Mobility::FullTurn ||
                                      isNear(height, p.b, 8.0 * kUnitRoundoff * characteristicLength(p)));
                }
            }
            for (int i = 0; i < 200; ++i) {
                const double theta2 = -pi + kTurn * i / 200.0;
                const long double height = p.c - p.a * std::sin(static_cast<long double>(theta2));
                const long double clearance = (p.b - std::abs(height)) / p.b;
                if (std::abs(clearance) > kBesideAnEnd) {
                    VERIFY_FOR(p, isWithin(limits, theta2) == (clearance > 0.0));
                }
            }
        }
    }

    void velocityIsZeroAtDeadCentres()
    {
        for (const auto &[p, limits] : subjects()) {
            VERIFY_FOR(p, limits.outerDeadCentre.has_value() == (limits.mobility != Mobility::Impossible));
            const bool hasInner =
                abs(ManyDigits(p.b) - ManyDigits(p.a)) >= std::abs(p.c) && limits.mobility != Mobility::Impossible;
            VERIFY_FOR(p, limits.innerDeadCentre.has_value() == hasInner);
            for (const bool stretched : {true, false}) {
                const std::optional<SliderPosition> &centre =
                    stretched ? limits.outerDeadCentre : limits.innerDeadCentre;
                if (!centre) {
                    continue;
                }
                VERIFY_FOR(p, centre->theta2 >= -pi && centre->theta2 < pi);
                // The distance of B from O2 is b + a or |b - a|.
                const double distance = stretched ? p.b + p.a : std::abs(p.b - p.a);
                VERIFY_FOR(p, isNear(std::hypot(centre->R4x, p.c), distance, kTolerance * characteristicLength(p)));

                const ExactState exact = exactStateAt(p, centre->theta2);
                const double cosine = std::abs(static_cast<double>(exact.cosTheta3));
                if (cosine < 1e-3) {
                    continue; // the dead centre is at a limit of the motion, where the velocity is not zero
                }
                VERIFY_FOR(p, exact.status == Status::Solved);
                const double size = characteristicLength(p) / cosine;
                VERIFY_FOR(p, isNear(centre->R4x, sliderMotion(exact), kTolerance * size));
                // Rounding θ2 changes it by up to u π, and the velocity by u π R̈4x, or more if larger terms cancel.
                const double acceleration = std::abs(sliderMotion(exact, Order::Acceleration));
                VERIFY_FOR(p, isNear(sliderMotion(exact, Order::Velocity), 0.0,
                                     16.0 * kUnitRoundoff * (pi * acceleration + size)));
            }
        }
    }

    /// Samples densely near ±90° and near the ends of a rocker's arcs, where the slider reverses within a small angle.
    void strokeEqualsThatOfTheMotion()
    {
        constexpr int kSamples = 2000;
        constexpr double kSampling = 1e-5; // of a + b + |c|: error due to the distance of the samples
        for (const auto &[p, limits] : subjects()) {
            VERIFY_FOR(p, limits.stroke.has_value() == (limits.mobility != Mobility::Impossible));
            double stroke = 0.0;
            for (const CrankRange &range : limits.ranges) {
                double least = kInfinity;
                double most = -least;
                double from = range.from;
                for (const double target : {-0.5 * pi, 0.5 * pi, 1.5 * pi, 2.5 * pi, kTurn + range.to}) {
                    const double to = std::clamp(target, range.from, range.to);
                    for (int i = 0; i <= kSamples; ++i) {
                        const double along = denserAtEnds(denserAtEnds(static_cast<double>(i) / kSamples));
                        if (const auto motion = motionAt(p, from + along * (to - from))) {
                            least = std::min(least, motion->sliderX[0]);
                            most = std::max(most, motion->sliderX[0]);
                        }
                    }
                    from = to;
                }
                stroke = std::max(stroke, most - least);
            }
            VERIFY_FOR(p, isNear(limits.stroke.value_or(0.0), stroke, kSampling * characteristicLength(p)));
        }
    }

    /// From the inner dead centre the crank turns by angleOutwards to the outer one, and the slider never reverses
    /// meanwhile.
    void anglesLeadFromDeadCentreToDeadCentre()
    {
        int seen = 0;
        for (const auto &[p, limits] : subjects()) {
            const bool turns = limits.mobility == Mobility::FullTurn;
            VERIFY_FOR(p, limits.angleOutwards.has_value() == turns && limits.angleInwards.has_value() == turns &&
                              limits.timeRatio.has_value() == turns);
            if (!turns) {
                continue;
            }
            ++seen;
            const double outwards = *limits.angleOutwards;
            const double inwards = *limits.angleInwards;
            const double sense = p.omega2 < 0.0 ? -1.0 : 1.0;
            VERIFY_FOR(p, outwards > 0.0 && inwards > 0.0 && isNear(outwards + inwards, kTurn, kTolerance));
            VERIFY_FOR(p, isNear(std::remainder(limits.innerDeadCentre->theta2 + sense * outwards -
                                                    limits.outerDeadCentre->theta2,
                                                kTurn),
                                 0.0, kTolerance));
            VERIFY_FOR(
                p, isNear(*limits.timeRatio, std::max(outwards, inwards) / std::min(outwards, inwards), kTolerance));
            const double away = limits.outerDeadCentre->R4x > limits.innerDeadCentre->R4x ? 1.0 : -1.0;
            double last = limits.innerDeadCentre->R4x;
            for (int i = 1; i <= 50; ++i) {
                const double theta2 = limits.innerDeadCentre->theta2 + sense * outwards * i / 50.0;
                const double x = sliderMotion(exactStateAt(p, theta2));
                VERIFY_FOR(p, away * (x - last) >= -kTolerance * characteristicLength(p));
                last = x;
            }
        }
        QVERIFY(seen > 50);
    }

    void minimumTransmissionAngleEqualsThatOfTheMotion()
    {
        for (const auto &[p, limits] : subjects()) {
            if (limits.mobility == Mobility::Impossible) {
                continue;
            }
            const AngleExtreme &minimum = limits.coupler.minimumTransmissionAngle;
            const ManyDigits cosine = limits.mobility == Mobility::FullTurn
                                          ? ManyDigits((ManyDigits(p.a) + std::abs(p.c)) / p.b)
                                          : ManyDigits(1);
            const auto exact = static_cast<double>(acos(cosine));
            VERIFY_FOR(p, isNear(minimum.angle, exact, 1e-15 * exact));
            for (const double theta2 : minimum.crankAngles) {
                const double height = std::abs(p.c - p.a * std::sin(theta2));
                VERIFY_FOR(p,
                           isNear(std::cos(minimum.angle), height / p.b, kTolerance * characteristicLength(p) / p.b));
            }
            for (int i = 0; i < 100; ++i) {
                if (const auto motion = motionAt(p, kTurn * i / 100.0)) {
                    VERIFY_FOR(p, std::asin(std::min(1.0, std::abs(motion->reach / p.b))) >= minimum.angle - 1e-7);
                }
            }
        }
    }

    /// Positions beyond the stroke lead to its nearer end.
    void sliderPositionsLeadBackToTheCrank()
    {
        // Fraction of b. Closer to a limit, a position does not determine the angle.
        constexpr double kPerpendicular = 1e-3;
        RandomMechanisms random(35);
        int checked = 0;
        for (int i = 0; i < 2000; ++i) {
            const Parameters p = anyMechanism(random);
            const Mechanism mechanism(p);
            const auto motionAt = [&](double theta2) {
                return ClosedForm(withCrankAt(mechanism, theta2)).motionAt(0.0);
            };
            const Motion motion = motionAt(random.uniform(-pi, pi));
            if (!(std::abs(motion.s) > kPerpendicular * p.b)) {
                continue;
            }
            ++checked;
            const CrankDirection direction = i % 2 == 0 ? CrankDirection::CounterClockwise : CrankDirection::Clockwise;
            const auto stroke = strokeAround(motionLimits(mechanism), motion.theta2, direction);
            VERIFY_FOR(p, stroke && stroke->from.theta2 < stroke->to.theta2);
            const double found = crankAngleAt(mechanism, *stroke, motion.R4x);
            VERIFY_FOR(p, isNear(motionAt(found).R4x, motion.R4x, 1e-12 * characteristicLength(p)));
            const double farOutside = 2.0 * characteristicLength(p);
            const bool grows = stroke->from.R4x < stroke->to.R4x;
            VERIFY_FOR(p, crankAngleAt(mechanism, *stroke, farOutside) == (grows ? stroke->to : stroke->from).theta2);
            VERIFY_FOR(p, crankAngleAt(mechanism, *stroke, -farOutside) == (grows ? stroke->from : stroke->to).theta2);
        }
        QVERIFY(checked > 500);
    }
};

const Suite<TestMobility> suite("tst_mobility");

} // namespace tst_mobility

#include "tst_mobility.moc"
