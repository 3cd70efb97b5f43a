// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tables over the crank angle, and of tables whose columns have other units, signs or origins than their
// headings state.
#include "tests/support/claim_kinds.h"

#include "core/mechanism/turn.h"

#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kRadiansPerDegree = 1.0 / kDegreesPerRadian;

Channels positions(ClaimRandom &random)
{
    return random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}});
}

/// Returns a table over one turn of the crank angle, in steps of 1° … 30°.
ClaimTable tableByAngle(ClaimRandom &random, const Parameters &mechanism)
{
    return ClaimTable(random, mechanism).overCrankAngle(random.oneOf({1.0, 2.0, 5.0, 10.0, 15.0, 30.0}));
}

Parameters withOpenAssembly(Parameters p)
{
    p.branch = Branch::Open;
    return p;
}

/// R4_x (mm) at the outer dead centre of the open assembly.
double outerDeadCentre(const Parameters &p)
{
    return std::sqrt((p.a + p.b) * (p.a + p.b) - p.c * p.c);
}

/// Returns an origin in mm.
double randomOrigin(ClaimRandom &random)
{
    return random.eitherSign(5.0, 500.0);
}

} // namespace

/// Tables as in textbooks and exercises, most of them over the crank angle.
std::vector<ClaimKind> tablesByAngle()
{
    using Random = ClaimRandom;
    return {
        {"by angle",
         [](Random &random) {
             ClaimTable table(random);
             table.overCrankAngle(random.oneOf({1.0, 2.0, 3.0, 5.0}), random.between(1.0, 3.0));
             table.with(positions(random)).digits(7);
             return random.isTrue(0.5) ? table.withinATurn(kTheta2) : table;
         }},
        {"by angle, noisy",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({1.0, 2.0, 3.0, 5.0}))
                 .with(positions(random))
                 .digits(7)
                 .withNoise({kSlider, kTheta3}, random.onLogScale(5e-4, 5e-3));
         }},
        {"by angle from another origin",
         [](Random &random) {
             ClaimTable table(random);
             table.overCrankAngle(random.oneOf({1.0, 2.0, 3.0, 5.0})).with(positions(random)).digits(7);
             table.shifted({kTheta2}, random.eitherSign(2.0, 60.0)).conventions(1);
             return random.isTrue(0.5) ? table.withNoise({kSlider, kTheta3}, random.onLogScale(1e-4, 1e-3)) : table;
         }},
        {"by angle, clockwise",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({1.0, 2.0, 3.0, 5.0}))
                 .with(positions(random))
                 .digits(7)
                 .multiplied({kTheta2}, -1.0)
                 .conventionsBetween(0, 1);
         }},
        {"by angle in radians",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({1.0, 2.0, 3.0, 5.0}), random.between(1.0, 3.0))
                 .with(positions(random))
                 .digits(7)
                 .multiplied({kTheta2}, kRadiansPerDegree)
                 .conventionsBetween(0, 1);
         }},
        {"by angle, two to four decimals",
         [](Random &random) {
             return tableByAngle(random, random.mechanism()).with(positions(random)).decimals(random.oneOf({2, 3, 4}));
         }},
        {"by angle, with derivatives",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with(random.oneOf<Channels>(
                     {kSixColumns, kSliderColumns, {kSlider, kSliderSpeed}, {kTheta3, kSlider, kTheta3Speed}}));
         }},
        {"by angle, theta3 with derivatives of lengths",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with(random.oneOf<Channels>({{kTheta3, kSliderSpeed},
                                               {kTheta3, kSliderSpeed, kSliderAcceleration},
                                               {kTheta3, kTheta3Speed, kSliderSpeed},
                                               {kTheta3, kTheta3Acceleration, kSliderAcceleration}}));
         }},
        {"by angle, R4_x in whole mm with derivatives of four digits",
         [](Random &random) {
             ClaimTable table = tableByAngle(random, random.mechanism()).with({kSlider}).decimals(0);
             table.with(random.oneOf<Channels>({{kSliderSpeed}, {kTheta3Speed}, {kSliderSpeed, kSliderAcceleration}}));
             return table.digits(4);
         }},
        {"R4_x in whole mm from another origin with derivatives of four digits",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).overTime(random.between(0.9, 2.0), random.between(24, 60));
             table.with({kSlider})
                 .decimals(0)
                 .shifted({kSlider}, random.eitherSign(20.0, 200.0))
                 .conventionsBetween(1, 2);
             table.with(
                 random.oneOf<Channels>({{kSliderSpeed}, {kSliderAcceleration}, {kSliderSpeed, kSliderAcceleration}}));
             return table.digits(4);
         }},
        {"by angle, a typing error",
         [](Random &random) {
             const Channels channels = random.oneOf<Channels>(
                 {{kSlider}, {kTheta3}, {kSlider, kSliderSpeed}, {kTheta3, kSlider, kSliderSpeed}, kSliderColumns});
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({5.0, 10.0, 15.0}))
                 .with(channels)
                 .decimals(2)
                 .mistyped(channels[static_cast<std::size_t>(random.index(std::ssize(channels)))]);
         }},
        {"by angle, given mechanism",
         [](Random &random) {
             const Parameters p = withStart(withSpeed(random.mechanism(), kTurn), 0.0);
             return tableByAngle(random, p).with({kSlider, kSliderSpeed}).given(p);
         }},
        {"by angle, velocity counted the other way",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with({kSlider, kSliderSpeed})
                 .multiplied({kSliderSpeed}, -1.0)
                 .conventionsBetween(0, 1);
         }},
        {"by angle, finite differences",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({5.0, 10.0, 15.0}))
                 .with(random.oneOf<Channels>({{kSlider, kSliderSpeed}, kSliderColumns}))
                 .decimals(4)
                 .differentiated({kSliderSpeed, kSliderAcceleration}, 1);
         }},
        {"by angle, displacement from a dead centre",
         [](Random &random) {
             ClaimTable table = tableByAngle(random, random.mechanism()).with({kSlider}).decimals(3);
             const double sign = random.oneOf({-1.0, 1.0});
             table.multiplied({kSlider}, sign);
             const double least = table.find("R4_x")->values.minCoeff();
             return table.shifted({kSlider}, -least).conventionsBetween(1, sign < 0.0 ? 2 : 1);
         }},
        {"by angle, distance from the outer dead centre",
         [](Random &random) {
             const Parameters p = withOpenAssembly(random.mechanism());
             return tableByAngle(random, p)
                 .with(kSliderColumns)
                 .decimals(4)
                 .multiplied(kSliderColumns, -1.0)
                 .shifted({kSlider}, outerDeadCentre(p))
                 .conventions(2);
         }},
        {"distance from the outer dead centre beside theta3 at B",
         [](Random &random) {
             const Parameters p = withOpenAssembly(random.mechanism());
             return ClaimTable(random, p)
                 .with({kTheta2, kTheta3})
                 .shifted({kTheta3}, 180.0)
                 .with(kSliderColumns)
                 .multiplied(kSliderColumns, -1.0)
                 .shifted({kSlider}, outerDeadCentre(p))
                 .conventions(3);
         }},
        {"noise beside a falling theta2, theta3 measured at B",
         [](Random &random) {
             const Parameters p = random.mechanism();
             return ClaimTable(random, withSpeed(p, -std::abs(p.omega2)))
                 .with({kTheta2})
                 .with(kSixColumns)
                 .digits(7)
                 .shifted({kTheta3}, 180.0)
                 .withNoise(kSixColumns, random.onLogScale(0.001, 0.01))
                 .conventions(1);
         }},
        {"by angle, theta3 measured at B, 0 to 360",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with({kSlider, kTheta3})
                 .decimals(4)
                 .shifted({kTheta3}, 180.0)
                 .withinATurn(kTheta3)
                 .conventions(1);
         }},
        {"by angle, theta3 counted clockwise",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with({kSlider, kTheta3})
                 .decimals(4)
                 .multiplied({kTheta3}, -1.0)
                 .conventions(1);
         }},
        {"by angle, rates in radians",
         [](Random &random) {
             return tableByAngle(random, random.mechanism())
                 .with(kSixColumns)
                 .digits(8)
                 .multiplied({kTheta3Speed, kTheta3Acceleration}, kRadiansPerDegree)
                 .conventionsBetween(1, 2);
         }},
        {"by angle, half a turn",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({2.0, 5.0, 10.0}), 0.5)
                 .with({kSlider, kTheta3})
                 .decimals(4);
         }},
        {"by angle, c = 0",
         [](Random &random) {
             return tableByAngle(random, withOffset(random.mechanism(), 0.0)).with(positions(random)).decimals(4);
         }},
    };
}

/// Deviations from the headings that can be found without a mechanism.
std::vector<ClaimKind> tablesWithConventions()
{
    using Random = ClaimRandom;
    return {
        {"origin of R4_x",
         [](Random &random) {
             return ClaimTable(random).with(kSixColumns).shifted({kSlider}, randomOrigin(random)).conventions(1);
         }},
        // A displacement may be measured in the other direction; the mechanism is then that of the other assembly.
        {"origin of R4_x alone",
         [](Random &random) {
             return ClaimTable(random, withSpeed(random.mechanism(), -random.between(20.0, 60.0)))
                 .with({kSlider})
                 .shifted({kSlider}, random.onLogScale(5.0, 500.0))
                 .conventionsBetween(1, 2);
         }},
        {"origin of R4_x far away",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kSlider})
                 .decimals(3)
                 .shifted({kSlider}, random.eitherSign(500.0, 3000.0))
                 .conventionsBetween(1, 2);
         }},
        {"origin of theta2",
         [](Random &random) {
             return ClaimTable(random)
                 .with(random.oneOf<Channels>({{kTheta2, kSlider}, {kTheta2, kSlider, kTheta3}}))
                 .digits(7)
                 .shifted({kTheta2}, random.eitherSign(5.0, 150.0))
                 .conventions(1);
         }},
        {"origin of theta2, which counts the other way",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kTheta2, kSlider, kTheta3})
                 .digits(7)
                 .multiplied({kTheta2}, -1.0)
                 .shifted({kTheta2}, random.eitherSign(5.0, 150.0))
                 .conventions(2);
         }},
        {"origin of R4_y",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .with({kR4y})
                 .shifted({kR4y}, randomOrigin(random))
                 .conventions(1);
         }},
        {"origin of theta3",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .shifted({kTheta3}, random.eitherSign(5.0, 170.0))
                 .conventions(1);
         }},
        {"origins of R4_x, R4_y and theta3",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .with({kR4y})
                 .shifted({kSlider}, randomOrigin(random))
                 .shifted({kR4y}, randomOrigin(random))
                 .shifted({kTheta3}, random.eitherSign(5.0, 170.0))
                 .conventions(3);
         }},
        {"theta3 from the start",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).with(kSixColumns).shifted({kTheta3}, 0.0);
             return table.shifted({kTheta3}, -table.find("theta3")->values[0]).conventionsBetween(0, 1);
         }},
        {"theta3 family turned by 40 degrees",
         [](Random &random) {
             return ClaimTable(random).with(kCouplerColumns).shifted({kTheta3}, 40.0).conventions(1);
         }},
        {"noise and another origin",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kSlider})
                 .digits(7)
                 .withNoise(kAllColumns, 0.003)
                 .shifted({kSlider}, random.eitherSign(100.0, 500.0))
                 .conventionsBetween(1, 2);
         }},
        {"angles in radians",
         [](Random &random) {
             const Channels columns =
                 random.oneOf<Channels>({kCouplerColumns, {kTheta3}, {kTheta3Speed}, {kTheta3Acceleration}});
             return ClaimTable(random).with(kSixColumns).multiplied(columns, kRadiansPerDegree).conventions(1);
         }},
        {"crank angle in radians, too",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kTheta2, kTheta3, kSlider})
                 .multiplied({kTheta2, kTheta3}, kRadiansPerDegree)
                 .conventions(1);
         }},
        {"one length in another unit",
         [](Random &random) {
             const Channels column{random.oneOf({kSlider, kSliderSpeed, kSliderAcceleration})};
             const double factor = random.oneOf({0.1, 1.0 / 25.4, 1e-3});
             return ClaimTable(random).with(kSixColumns).multiplied(column, factor).conventions(1);
         }},
        {"a sign",
         [](Random &random) {
             const Channels column{random.oneOf(
                 {kTheta3, kTheta3Speed, kTheta3Acceleration, kSlider, kSliderSpeed, kSliderAcceleration})};
             return ClaimTable(random).with(kSixColumns).multiplied(column, -1.0).conventions(1);
         }},
        // A half turn of theta3 together with the opposite sign of R4_y describes the same file.
        {"the slider's axis the other way, or clockwise",
         [](Random &random) {
             return ClaimTable(random, withOffset(random.mechanism(), random.eitherSign(0.02, 0.4)))
                 .with(kSixColumns)
                 .with({kR4y})
                 .multiplied(random.oneOf({kSliderColumns, kCouplerColumns}), -1.0)
                 .conventionsBetween(1, 2);
         }},
        {"half a turn",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .shifted({kTheta3}, random.oneOf({-180.0, 180.0}))
                 .conventions(1);
         }},
        {"half a turn, within 0 to 360",
         [](Random &random) {
             return ClaimTable(random).with(kSixColumns).shifted({kTheta3}, 180.0).withinATurn(kTheta3).conventions(1);
         }},
        // Six significant digits leave fewer decimals near 360° than near 0°.
        {"theta3 within 0 to 360",
         [](Random &random) {
             return ClaimTable(random).with(random.oneOf({kCouplerColumns, kSixColumns})).withinATurn(kTheta3);
         }},
        {"two columns swapped",
         [](Random &random) {
             ClaimTable table(random);
             table.conventions(1);
             switch (random.index(3)) {
             case 0:
                 return table.with({kTheta3, kSlider, kTheta3Acceleration, kSliderAcceleration})
                     .with(kTheta3Speed, kSliderSpeed)
                     .with(kSliderSpeed, kTheta3Speed);
             case 1:
                 return table.with({kTheta3Speed, kSliderSpeed, kTheta3Acceleration, kSliderAcceleration})
                     .with(kTheta3, kSlider)
                     .with(kSlider, kTheta3);
             default:
                 return table.with({kTheta3, kSlider, kTheta3Speed, kTheta3Acceleration})
                     .with(kSliderSpeed, kSliderAcceleration)
                     .with(kSliderAcceleration, kSliderSpeed);
             }
         }},
        {"one that is no derivative",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).with(kSixColumns);
             const Channels column = randomDerivative(random);
             switch (random.index(3)) {
             case 0: return table.delayed(column, random.between(5.0, 20.0));
             case 1: return table.amplified(column, 0.0);
             default:
                 return table.amplified(column,
                                        random.isTrue(0.5) ? random.between(0.56, 0.91) : random.between(1.1, 1.8));
             }
         }},
        // With 80 rows per turn or more, the differences deviate from the derivatives by less than 1 %.
        {"central differences",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(1.0, random.between(80, 130))
                 .with(kSixColumns)
                 .differentiated(kDerivatives, 1);
         }},
        {"finite differences of positions from another origin",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(1.0, random.oneOf({24.0, 36.0, 72.0}))
                 .with(random.oneOf<Channels>({{kSlider, kSliderSpeed}, kSliderColumns}))
                 .decimals(3)
                 .shifted({kSlider}, random.eitherSign(20.0, 200.0))
                 .differentiated({kSliderSpeed, kSliderAcceleration}, 1)
                 .conventionsBetween(1, 2); // for a crossed assembly, the open one with the opposite sign of R4_x
         }},
        {"two faults at once",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).with(kSixColumns).conventions(2);
             switch (random.index(3)) {
             case 0:
                 return table.shifted({kSlider}, randomOrigin(random)).multiplied(kCouplerColumns, kRadiansPerDegree);
             case 1: return table.multiplied({kSliderSpeed}, -1.0).multiplied({kTheta3Acceleration}, kRadiansPerDegree);
             default: return table.shifted({kTheta3}, 180.0).multiplied({kSliderAcceleration}, 1e-3);
             }
         }},
        // Either the time or the four derivatives have the wrong unit.
        {"clock in ms, derivatives per s",
         [](Random &random) {
             return ClaimTable(random).with(kSixColumns).timeMultiplied(1000.0).conventionsBetween(0, 1).mayBeMissed();
         }},
        {"the slider along y",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kR4y, kSlider)
                 .with(kSlider, kR4y)
                 .with({kTheta3})
                 .multiplied({kSlider}, -1.0)
                 .shifted({kTheta3}, 90.0)
                 .conventions(1)
                 .mayBeMissed();
         }},
        {"noise and angles in radians",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .digits(8)
                 .withNoise(kAllColumns, random.onLogScale(5e-4, 1e-2))
                 .multiplied(kCouplerColumns, kRadiansPerDegree)
                 .conventions(1);
         }},
        {"noise and a sign",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .digits(8)
                 .withNoise(kAllColumns, random.onLogScale(5e-4, 1e-2))
                 .multiplied({random.oneOf({kSliderSpeed, kSliderAcceleration, kTheta3Speed})}, -1.0)
                 .conventions(1);
         }},
    };
}

/// Deviations that can be found only if the mechanism is given. A different mechanism also explains each file.
std::vector<ClaimKind> tablesBesideAGivenMechanism()
{
    using Random = ClaimRandom;
    return {
        {"given: agrees",
         [](Random &random) {
             const Parameters p = random.mechanism();
             return ClaimTable(random, p).with(kSixColumns).given(p);
         }},
        {"given: lengths in another unit",
         [](Random &random) {
             const Parameters p = random.mechanism();
             const double factor = random.oneOf({0.1, 1.0 / 25.4, 1e-3});
             return ClaimTable(random, p)
                 .with(kSixColumns)
                 .given(p)
                 .multiplied(kSliderColumns, factor)
                 .conventionsBetween(0, 1);
         }},
        {"given: clock in ms",
         [](Random &random) {
             const Parameters p = random.mechanism();
             return ClaimTable(random, p)
                 .with({kTheta3, kSlider})
                 .given(p)
                 .timeMultiplied(1000.0)
                 .conventionsBetween(0, 1);
         }},
        {"given: the other assembly",
         [](Random &random) {
             Parameters p = random.mechanism();
             ClaimTable table = ClaimTable(random, p).with(kSixColumns).conventionsBetween(0, 1);
             p.branch = oppositeBranch(p.branch);
             return table.given(p);
         }},
        {"given: a late clock",
         [](Random &random) {
             const Parameters p = random.mechanism();
             return ClaimTable(random, withStart(p, p.theta20 + random.onLogScale(0.3, 2.5)))
                 .with(kSixColumns)
                 .given(p)
                 .orMechanism(p)
                 .conventionsBetween(0, 1);
         }},
        {"given: one parameter off",
         [](Random &random) {
             const Parameters p = random.mechanism();
             const auto wrong = random.oneOf({Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2});
             Parameters given = p;
             valueOf(given, wrong) *= random.between(1.02, 1.05);
             ClaimTable table = ClaimTable(random, p).with(kSixColumns).given(given).conventionsBetween(0, 1);
             table.wrongGiven = wrong;
             return table;
         }},
    };
}

} // namespace slidercrank
