// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/limits/slider_stroke.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"

#include <QTest>

using namespace slidercrank;

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2.0 * kPi;

/// Relative to a + b + |c|, or rad: a few roundings, more where a square root of a small difference stands.
constexpr double kTolerance = 1e-12;

/// Full turns, rockers of one and of two arcs, impossible ones.
Parameters anyMechanism(RandomMechanisms &random)
{
    Parameters p = random.next();
    p.b = (p.a + std::abs(p.c)) * std::exp(random.uniform(-3.0, 1.5));
    return p;
}

std::vector<Parameters> mechanisms()
{
    std::vector<Parameters> all;
    for (const Case &which : allCases()) {
        all.push_back(which.parameters);
    }
    RandomMechanisms random(31);
    for (int i = 0; i < 300; ++i) {
        all.push_back(anyMechanism(random));
    }
    return all;
}

/// By exact sums.
Mobility exactMobility(const Parameters &p)
{
    const Digits100 a = p.a;
    const Digits100 b = p.b;
    const Digits100 offset = std::abs(p.c);
    if (b >= a + offset) {
        return Mobility::FullTurn;
    }
    if (b < offset - a) {
        return Mobility::Impossible;
    }
    return b == offset - a ? Mobility::Locked : Mobility::Rocker;
}

template <class Real = long double>
ExactState<Real> atAngle(Parameters p, double theta2)
{
    p.omega2 = 1.0;
    p.theta20 = theta2;
    return exactState<Real>(p, 0.0);
}

/// From 0 to 1 as x does, but slower near both.
double crowded(double x)
{
    return 0.5 - 0.5 * std::cos(kPi * x);
}

double difference(double angle, double other)
{
    return std::remainder(angle - other, kTurn);
}

bool isWithin(const MotionLimits &limits, double theta2)
{
    return std::any_of(limits.ranges.begin(), limits.ranges.end(), [&](const CrankRange &range) {
        const double turned = theta2 - kTurn * std::floor((theta2 - range.from) / kTurn);
        return turned <= range.to;
    });
}

bool near(double x, double y, double tolerance)
{
    return std::abs(x - y) <= tolerance;
}

bool near(const std::optional<double> &x, const std::optional<double> &y, double tolerance)
{
    return x.has_value() == y.has_value() && (!x || near(*x, *y, tolerance));
}

/// Prints the mechanism beside a failure.
#define VERIFY_FOR(parameters, condition) QVERIFY2(condition, describe(parameters).c_str())

} // namespace

class tst_mobility : public QObject
{
    Q_OBJECT

private slots:
    void classifiesByExactSums();
    void grashofIsSharp_data();
    void grashofIsSharp();
    void rangesAreOrderedWithinATurn();
    void rangesAreWhereThereIsAPose();
    void rangesEndWhereTheCouplerIsSquare();
    void deadCentresStandStill();
    void deadCentresOfTable1();
    void strokeIsThatOfTheMotion();
    void anglesLeadFromDeadCentreToDeadCentre();
    void timeRatioIsOneWithoutOffset();
    void largestPressureAngleIsThatOfTheMotion();
    void mirroringTheOffsetMirrorsTheAngles();
    void mirroringTheBranchMirrorsTheSlider();
    void sizeDoesNotMatter();
    void shortestCouplersAreTheLimits();
    void eachLengthHasItsLimitForAFullTurn();
    void lockedAndImpossible();
    void sliderPositionsLeadBackToTheCrank();
};

void tst_mobility::classifiesByExactSums()
{
    std::array<int, 4> seen{};
    for (const Parameters &p : mechanisms()) {
        const Mobility mobility = motionLimits(Mechanism(p)).mobility;
        VERIFY_FOR(p, mobility == exactMobility(p));
        ++seen[std::size_t(mobility)];
    }
    for (const int count : seen) {
        QVERIFY(count > 0);
    }
}

void tst_mobility::grashofIsSharp_data()
{
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("c");
    QTest::newRow("report") << 20.0 << 25.0;
    QTest::newRow("c < 0") << 20.0 << -25.0;
    QTest::newRow("c = 0") << 20.0 << 0.0;
    QTest::newRow("0.1 + 0.2") << 0.1 << 0.2; // the sum rounds
    QTest::newRow("1/3 + 1e-9") << 1.0 / 3.0 << 1e-9;
    QTest::newRow("1e12 + 1e-3") << 1e12 << 1e-3;
    QTest::newRow("1e-9 + 1e9") << 1e-9 << 1e9;
}

/// One unit in the last place of b decides; where a + |c| is no double, b is compared with the exact sum.
void tst_mobility::grashofIsSharp()
{
    QFETCH(double, a);
    QFETCH(double, c);
    const double edges[] = {a + std::abs(c), std::abs(c) - a};
    for (const double edge : edges) {
        for (const double b : {std::nextafter(edge, 0.0), edge, std::nextafter(edge, 1e300)}) {
            const Parameters p{a, b, c, 1.0, 0.0, Branch::Open};
            if (findFault(p)) {
                continue;
            }
            VERIFY_FOR(p, motionLimits(Mechanism(p)).mobility == exactMobility(p));
        }
    }
}

void tst_mobility::rangesAreOrderedWithinATurn()
{
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        const std::vector<CrankRange> &ranges = limits.ranges;
        switch (limits.mobility) {
        case Mobility::Impossible: VERIFY_FOR(p, ranges.empty()); break;
        case Mobility::FullTurn:
            VERIFY_FOR(p, ranges.size() == 1);
            VERIFY_FOR(p, near(ranges[0].to - ranges[0].from, kTurn, kTolerance));
            break;
        case Mobility::Locked:
            VERIFY_FOR(p, ranges.size() == 1);
            VERIFY_FOR(p, ranges[0].from == ranges[0].to);
            VERIFY_FOR(p, near(ranges[0].from, p.c > 0.0 ? 0.5 * kPi : -0.5 * kPi, kTolerance));
            break;
        case Mobility::Rocker: VERIFY_FOR(p, ranges.size() == (p.b < p.a - std::abs(p.c) ? 2U : 1U)); break;
        }
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            VERIFY_FOR(p, ranges[i].from >= -kPi && ranges[i].from < kPi);
            VERIFY_FOR(p, ranges[i].from <= ranges[i].to);
            VERIFY_FOR(p, i == 0 || ranges[i - 1].to < ranges[i].from);
            VERIFY_FOR(p, ranges[i].to <= ranges[0].from + kTurn);
        }
    }
}

/// All round the circle, but for what lies within rounding of an end.
void tst_mobility::rangesAreWhereThereIsAPose()
{
    constexpr double kBesideAnEnd = 1e-9;
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        for (int i = 0; i < 200; ++i) {
            const double theta2 = -kPi + kTurn * i / 200.0;
            const ExactState<long double> exact = atAngle(p, theta2);
            if (std::abs(exact.clearance) > kBesideAnEnd) {
                VERIFY_FOR(p, isWithin(limits, theta2) == (exact.status != Status::NotAssemblable));
            }
        }
    }
}

/// |c - a sin θ2| = b there; to √u in the angle where a range is about to vanish or to close.
void tst_mobility::rangesEndWhereTheCouplerIsSquare()
{
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        if (limits.mobility != Mobility::Rocker) {
            continue;
        }
        for (const CrankRange &range : limits.ranges) {
            for (const double end : {range.from, range.to}) {
                const double height = std::abs(p.c - p.a * std::sin(end));
                VERIFY_FOR(p, near(height, p.b, 8.0 * kUnitRoundoff * characteristicLength(p)));
            }
        }
    }
}

void tst_mobility::deadCentresStandStill()
{
    int outer = 0;
    int inner = 0;
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        VERIFY_FOR(p, limits.outer.has_value() == (limits.mobility != Mobility::Impossible));
        const bool folds =
            abs(Digits100(p.b) - Digits100(p.a)) >= std::abs(p.c) && limits.mobility != Mobility::Impossible;
        VERIFY_FOR(p, limits.inner.has_value() == folds);
        outer += limits.outer ? 1 : 0;
        inner += limits.inner ? 1 : 0;
        for (const bool stretched : {true, false}) {
            const std::optional<DeadCentre> &centre = stretched ? limits.outer : limits.inner;
            if (!centre) {
                continue;
            }
            VERIFY_FOR(p, centre->theta2 >= -kPi && centre->theta2 < kPi);
            // B is b + a, or |b - a|, away from O2.
            const double distance = stretched ? p.b + p.a : std::abs(p.b - p.a);
            VERIFY_FOR(p, near(std::hypot(centre->R4x, p.c), distance, kTolerance * characteristicLength(p)));

            const ExactState<Digits50> exact = atAngle<Digits50>(p, centre->theta2);
            const double cosine = std::abs(static_cast<double>(exact.cosTheta3));
            if (cosine < 1e-3) {
                continue; // at an end of the motion, where nothing stands still
            }
            VERIFY_FOR(p, exact.status == Status::Solved);
            const double R4 = static_cast<double>(exact.values[indexOf({R4x, Order::Position})]);
            const double R4Dot = static_cast<double>(exact.values[indexOf({R4x, Order::Velocity})]);
            const double R4DDot = static_cast<double>(exact.values[indexOf({R4x, Order::Acceleration})]);
            VERIFY_FOR(p, near(centre->R4x, R4, kTolerance * characteristicLength(p) / cosine));
            // An error of u in θ2 leaves u R̈4x of speed; and more, for lengths, where terms larger than it cancel.
            VERIFY_FOR(p, near(R4Dot, 0.0,
                               16.0 * kUnitRoundoff * (kPi * std::abs(R4DDot) + characteristicLength(p) / cosine)));
        }
    }
    QVERIFY(outer > 0 && inner > 0);
}

/// b = 65, c = 25: √(85² - 25²) and √(45² - 25²); reached where the crank points along, or against, O2-B.
void tst_mobility::deadCentresOfTable1()
{
    const MotionLimits limits = motionLimits(Mechanism());
    QVERIFY(near(limits.outer->R4x, std::sqrt(6600.0), 1e-13));
    QVERIFY(near(limits.inner->R4x, std::sqrt(1400.0), 1e-13));
    QVERIFY(near(limits.outer->theta2, std::asin(25.0 / 85.0), 1e-15));
    QVERIFY(near(limits.inner->theta2, std::asin(25.0 / 45.0) - kPi, 1e-15));
    QVERIFY(near(*limits.stroke, std::sqrt(6600.0) - std::sqrt(1400.0), 1e-13));
}

/// Sampled densely towards ±90° and towards the ends of a rocker's arcs, where the slider turns within a tiny angle.
void tst_mobility::strokeIsThatOfTheMotion()
{
    constexpr int kSamples = 2000;
    constexpr double kSampling = 1e-5; // of a + b + |c|: what samples that far apart can miss
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        VERIFY_FOR(p, limits.stroke.has_value() == (limits.mobility != Mobility::Impossible));
        double stroke = 0.0;
        for (const CrankRange &range : limits.ranges) {
            std::vector<double> ends{range.from, range.to};
            for (const double square : {-0.5 * kPi, 0.5 * kPi, 1.5 * kPi, 2.5 * kPi}) {
                if (square > range.from && square < range.to) {
                    ends.push_back(square);
                }
            }
            std::sort(ends.begin(), ends.end());
            double least = std::numeric_limits<double>::infinity();
            double most = -least;
            for (std::size_t piece = 1; piece < ends.size(); ++piece) {
                for (int i = 0; i <= kSamples; ++i) {
                    const double along = crowded(crowded(static_cast<double>(i) / kSamples));
                    const double theta2 = ends[piece - 1] + along * (ends[piece] - ends[piece - 1]);
                    const ExactState<double> exact = atAngle<double>(p, theta2);
                    if (exact.status != Status::NotAssemblable) {
                        const double R4 = exact.values[indexOf({R4x, Order::Position})];
                        least = std::min(least, R4);
                        most = std::max(most, R4);
                    }
                }
            }
            stroke = std::max(stroke, most - least);
        }
        if (limits.stroke) {
            QVERIFY2(near(*limits.stroke, stroke, kSampling * characteristicLength(p)),
                     qPrintable(QString("%1: %2, sampled %3")
                                    .arg(QString::fromStdString(describe(p)))
                                    .arg(*limits.stroke, 0, 'g', 17)
                                    .arg(stroke, 0, 'g', 17)));
        }
    }
}

/// Turning with ω2 from the inner one by angleOutwards the crank is at the outer one, and the slider never turned back.
void tst_mobility::anglesLeadFromDeadCentreToDeadCentre()
{
    int seen = 0;
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
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
        VERIFY_FOR(p, outwards > 0.0 && inwards > 0.0);
        VERIFY_FOR(p, near(outwards + inwards, kTurn, kTolerance));
        VERIFY_FOR(p, near(difference(limits.inner->theta2 + sense * outwards, limits.outer->theta2), 0.0, kTolerance));
        VERIFY_FOR(p, near(*limits.timeRatio, std::max(outwards, inwards) / std::min(outwards, inwards), kTolerance));
        VERIFY_FOR(p, *limits.timeRatio >= 1.0);
        const double away = limits.outer->R4x > limits.inner->R4x ? 1.0 : -1.0;
        double last = limits.inner->R4x;
        for (int i = 1; i <= 50; ++i) {
            const double theta2 = limits.inner->theta2 + sense * outwards * i / 50.0;
            const double R4 = static_cast<double>(atAngle<Digits50>(p, theta2).values[indexOf({R4x, Order::Position})]);
            VERIFY_FOR(p, away * (R4 - last) >= -kTolerance * characteristicLength(p));
            last = R4;
        }
    }
    QVERIFY(seen > 50);
}

void tst_mobility::timeRatioIsOneWithoutOffset()
{
    RandomMechanisms random(32);
    for (int i = 0; i < 50; ++i) {
        Parameters p = random.next();
        p.c = i % 2 == 0 ? 0.0 : -0.0;
        VERIFY_FOR(p, near(*motionLimits(Mechanism(p)).timeRatio, 1.0, kTolerance));
        p.c = p.a;
        p.b = 3.0 * p.a;
        VERIFY_FOR(p, *motionLimits(Mechanism(p)).timeRatio > 1.1);
    }
}

void tst_mobility::largestPressureAngleIsThatOfTheMotion()
{
    for (const Parameters &p : mechanisms()) {
        const MotionLimits limits = motionLimits(Mechanism(p));
        if (limits.mobility == Mobility::Impossible) {
            continue;
        }
        const double largest = limits.largestPressureAngle;
        // θ3 reaches asin of its largest sine: known to √u where that is 1
        const ExactState<Digits50> there = atAngle<Digits50>(p, limits.largestPressureAngleAt);
        const double height = std::abs(p.c - p.a * std::sin(limits.largestPressureAngleAt));
        VERIFY_FOR(p, near(std::sin(largest), height / p.b, kTolerance * characteristicLength(p) / p.b));
        if (limits.mobility == Mobility::FullTurn) {
            const Digits50 sine = (Digits50(p.a) + std::abs(p.c)) / p.b;
            VERIFY_FOR(p, near(largest, static_cast<double>(asin(sine)), 1e-15));
            VERIFY_FOR(p, there.status != Status::NotAssemblable);
        } else {
            VERIFY_FOR(p, near(largest, 0.5 * kPi, 1e-15));
        }
        for (int i = 0; i < 100; ++i) {
            const ExactState<double> exact = atAngle<double>(p, kTurn * i / 100.0);
            if (exact.status != Status::NotAssemblable) {
                const double steepness =
                    std::atan2(std::sin(exact.values[indexOf({Theta3, Order::Position})]), std::abs(exact.cosTheta3));
                VERIFY_FOR(p, std::abs(steepness) <= largest + 1e-7);
            }
        }
    }
}

/// c → -c, seen in a mirror along x: θ2 → -θ2, and the crank turns the other way.
void tst_mobility::mirroringTheOffsetMirrorsTheAngles()
{
    for (const Parameters &p : mechanisms()) {
        if (p.c == 0.0 || p.omega2 == 0.0) {
            continue;
        }
        Parameters mirrored = p;
        mirrored.c = -p.c;
        mirrored.omega2 = -p.omega2;
        const MotionLimits one = motionLimits(Mechanism(p));
        const MotionLimits other = motionLimits(Mechanism(mirrored));
        VERIFY_FOR(p, one.mobility == other.mobility);
        VERIFY_FOR(p, one.ranges.size() == other.ranges.size());
        VERIFY_FOR(p, near(one.stroke, other.stroke, kTolerance * characteristicLength(p)));
        VERIFY_FOR(p, near(one.angleOutwards, other.angleOutwards, kTolerance));
        VERIFY_FOR(p, near(one.angleInwards, other.angleInwards, kTolerance));
        VERIFY_FOR(p, near(one.timeRatio, other.timeRatio, 10.0 * kTolerance));
        VERIFY_FOR(p, near(one.largestPressureAngle, other.largestPressureAngle, kTolerance));
        for (const CrankRange &range : one.ranges) {
            // the same arc from the other end; a whole turn has no ends
            const bool found = std::any_of(other.ranges.begin(), other.ranges.end(), [&range](const CrankRange &image) {
                return near(image.to - image.from, range.to - range.from, kTolerance) &&
                       (near(difference(image.from, -range.to), 0.0, kTolerance));
            });
            VERIFY_FOR(p, found);
        }
        VERIFY_FOR(p, one.outer.has_value() == other.outer.has_value());
        VERIFY_FOR(p, one.inner.has_value() == other.inner.has_value());
        if (one.outer) {
            VERIFY_FOR(p, near(one.outer->R4x, other.outer->R4x, kTolerance * characteristicLength(p)));
            VERIFY_FOR(p, near(difference(one.outer->theta2, -other.outer->theta2), 0.0, kTolerance));
        }
        if (one.inner) {
            VERIFY_FOR(p, near(one.inner->R4x, other.inner->R4x, kTolerance * characteristicLength(p)));
            VERIFY_FOR(p, near(difference(one.inner->theta2, -other.inner->theta2), 0.0, kTolerance));
        }
    }
}

/// Open and crossed are images of each other in a mirror along y: θ2 → π - θ2, R4x → -R4x.
void tst_mobility::mirroringTheBranchMirrorsTheSlider()
{
    for (const Parameters &p : mechanisms()) {
        Parameters mirrored = p;
        mirrored.branch = oppositeBranch(p.branch);
        const MotionLimits one = motionLimits(Mechanism(p));
        const MotionLimits other = motionLimits(Mechanism(mirrored));
        VERIFY_FOR(p, one.mobility == other.mobility);
        VERIFY_FOR(p, near(one.stroke, other.stroke, kTolerance * characteristicLength(p)));
        if (one.outer) {
            VERIFY_FOR(p, near(one.outer->R4x, -other.outer->R4x, kTolerance * characteristicLength(p)));
            VERIFY_FOR(p, near(difference(one.outer->theta2, kPi - other.outer->theta2), 0.0, kTolerance));
        }
        if (one.inner) {
            VERIFY_FOR(p, near(one.inner->R4x, -other.inner->R4x, kTolerance * characteristicLength(p)));
        }
        if (one.angleOutwards && p.omega2 != 0.0) {
            VERIFY_FOR(p, near(*one.angleOutwards, *other.angleInwards, kTolerance));
        }
    }
}

void tst_mobility::sizeDoesNotMatter()
{
    for (const Parameters &p : mechanisms()) {
        const MotionLimits one = motionLimits(Mechanism(p));
        for (const int exponent : {-30, 3}) {
            Parameters scaled = p;
            scaled.a = std::ldexp(p.a, exponent);
            scaled.b = std::ldexp(p.b, exponent);
            scaled.c = std::ldexp(p.c, exponent);
            if (findFault(scaled)) {
                continue;
            }
            const MotionLimits other = motionLimits(Mechanism(scaled));
            VERIFY_FOR(p, one.mobility == other.mobility);
            VERIFY_FOR(p, one.ranges.size() == other.ranges.size());
            VERIFY_FOR(p, one.largestPressureAngle == other.largestPressureAngle);
            VERIFY_FOR(p, !one.stroke || *one.stroke == std::ldexp(*other.stroke, -exponent));
        }
    }
}

void tst_mobility::shortestCouplersAreTheLimits()
{
    const Mechanism table1;
    QCOMPARE(shortestCouplerForFullTurn(table1), 45.0);
    QCOMPARE(shortestCouplerForAnyPose(table1), 5.0);
    Parameters p;
    p.c = -10.0;
    QCOMPARE(shortestCouplerForFullTurn(Mechanism(p)), 30.0);
    QCOMPARE(shortestCouplerForAnyPose(Mechanism(p)), -10.0);
}

/// Each of the three lengths taken to its limit just turns round, and no further.
void tst_mobility::eachLengthHasItsLimitForAFullTurn()
{
    const Parameters p{20.0, 65.0, -25.0, 1.0, 0.0, Branch::Open};
    const Mechanism mechanism(p);
    QCOMPARE(longestCrankForFullTurn(mechanism), 40.0);
    QCOMPARE(largestOffsetForFullTurn(mechanism), 45.0);
    const auto turns = [](const Parameters &parameters) {
        return motionLimits(Mechanism(parameters)).mobility == Mobility::FullTurn;
    };
    Parameters atLimit = p;
    atLimit.a = 40.0;
    QVERIFY(turns(atLimit));
    atLimit.a = std::nextafter(40.0, 50.0);
    QVERIFY(!turns(atLimit));
    atLimit = p;
    atLimit.c = -45.0;
    QVERIFY(turns(atLimit));
    atLimit.c = std::nextafter(-45.0, -50.0);
    QVERIFY(!turns(atLimit));
}

void tst_mobility::lockedAndImpossible()
{
    Parameters locked;
    locked.b = 5.0;
    const MotionLimits one = motionLimits(Mechanism(locked));
    QVERIFY(one.mobility == Mobility::Locked);
    QVERIFY(near(*one.stroke, 0.0, 1e-13));
    QVERIFY(!one.timeRatio && !one.angleOutwards && !one.inner);
    QVERIFY(near(one.largestPressureAngle, 0.5 * kPi, 1e-15));

    Parameters impossible;
    impossible.b = 4.0;
    const MotionLimits none = motionLimits(Mechanism(impossible));
    QVERIFY(none.mobility == Mobility::Impossible);
    QVERIFY(none.ranges.empty());
    QVERIFY(!none.stroke && !none.timeRatio && !none.outer && !none.inner);
}

/// And positions beyond the stroke to its nearer end.
void tst_mobility::sliderPositionsLeadBackToTheCrank()
{
    constexpr double kPerpendicular = 1e-3; // of b: nearer to a limit a position does not tell the angle
    RandomMechanisms random(35);
    int checked = 0;
    for (int i = 0; i < 2000; ++i) {
        const Parameters p = anyMechanism(random);
        const Mechanism mechanism(p);
        const auto motionAt = [&](double theta2) { return ClosedForm(withCrankAt(mechanism, theta2)).motionAt(0.0); };
        const Motion motion = motionAt(random.uniform(-kPi, kPi));
        if (!(std::abs(motion.s) > kPerpendicular * p.b)) {
            continue;
        }
        ++checked;
        const auto stroke = strokeAround(mechanism, motionLimits(mechanism), motion.theta2, i % 2 == 0 ? 1 : -1);
        VERIFY_FOR(p, stroke && stroke->from < stroke->to);
        const double found = crankAngleAt(mechanism, *stroke, motion.R4x);
        VERIFY_FOR(p, near(motionAt(found).R4x, motion.R4x, 1e-12 * characteristicLength(p)));
        const double beyond = 2.0 * characteristicLength(p);
        const bool grows = stroke->R4xFrom < stroke->R4xTo;
        VERIFY_FOR(p, crankAngleAt(mechanism, *stroke, beyond) == (grows ? stroke->to : stroke->from));
        VERIFY_FOR(p, crankAngleAt(mechanism, *stroke, -beyond) == (grows ? stroke->from : stroke->to));
    }
    QVERIFY(checked > 500);
}

QTEST_APPLESS_MAIN(tst_mobility)
#include "tst_mobility.moc"
