// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tables that contain the motion of a slider-crank, perhaps with white noise or gaps, or a different motion.
#include "tests/support/claim_kinds.h"

#include "core/mechanism/turn.h"

#include <array>

namespace slidercrank
{

Channels randomDerivative(ClaimRandom &random)
{
    return {random.oneOf({kSliderSpeed, kTheta3Speed, kSliderAcceleration, kTheta3Acceleration})};
}

std::vector<ClaimKind> claimKinds()
{
    std::vector<ClaimKind> kinds;
    for (const auto &group : {plainTables(), limitTables(), tablesByAngle(), tablesWithConventions(),
                              tablesBesideAGivenMechanism(), otherMotions()}) {
        kinds.insert(kinds.end(), group.begin(), group.end());
    }
    for (const auto &group : {filteredTables(), contradictoryTables(), sensorTables(), clockTables()}) {
        for (ClaimKind kind : group) {
            kind.isFault = true;
            kinds.push_back(kind);
        }
    }
    return kinds;
}

/// Tables of ordinary mechanisms whose headings state the quantities and units of the columns.
std::vector<ClaimKind> plainTables()
{
    using Random = ClaimRandom;
    return {
        {"six columns",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).with(kSixColumns);
             return random.isTrue(0.5) ? table.decimals(6) : table;
         }},
        {"some of the six columns",
         [](Random &random) {
             return ClaimTable(random).with(
                 random.oneOf<Channels>({{kTheta3},
                                         {kTheta3Speed, kSliderSpeed},
                                         {kTheta3, kSlider, kTheta3Speed, kTheta3Acceleration},
                                         {kSlider, kSliderAcceleration},
                                         {kTheta3, kTheta3Speed, kSliderSpeed, kSliderAcceleration},
                                         {kSliderSpeed, kTheta3Acceleration, kSliderAcceleration},
                                         {kTheta3Speed},
                                         {kTheta3, kSlider, kTheta3Speed, kSliderSpeed},
                                         {kSlider, kSliderSpeed, kTheta3Acceleration},
                                         {kTheta3Speed, kTheta3Acceleration}}));
         }},
        {"theta2, R4_x",
         [](Random &random) {
             return ClaimTable(random).with(
                 random.oneOf<Channels>({{kTheta2, kSlider}, {kTheta2, kSlider, kSliderSpeed, kR4y}}));
         }},
        {"six columns of nine digits", [](Random &random) { return ClaimTable(random).with(kSixColumns).digits(9); }},
        {"R4_x with two decimals", [](Random &random) { return ClaimTable(random).with({kSlider}).decimals(2); }},
        {"theta2 in whole degrees, R4_x to 0.1 mm",
         [](Random &random) { return ClaimTable(random).with({kTheta2}).decimals(0).with({kSlider}).decimals(1); }},
        {"R4_x in whole mm",
         [](Random &random) {
             return ClaimTable(random).overTime(random.onLogScale(0.6, 3.0), 60).with({kSlider}).decimals(0);
         }},
        {"noise of R4_x and theta3",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kSlider, kTheta3})
                 .digits(7)
                 .withNoise(kAllColumns, random.onLogScale(0.001, 0.01));
         }},
        {"noise of six columns",
         [](Random &random) {
             return ClaimTable(random)
                 .with(kSixColumns)
                 .digits(7)
                 .withNoise(kAllColumns, random.onLogScale(0.001, 0.02));
         }},
        {"noise of theta2 and R4_x",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kTheta2, kSlider})
                 .digits(7)
                 .withNoise({kSlider}, random.onLogScale(0.001, 0.01))
                 .withNoise({kTheta2}, random.onLogScale(0.0003, 0.002));
         }},
        {"noise of R4_x alone",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(0.4, 2.0), random.onLogScale(60, 400))
                 .with({kSlider})
                 .digits(7)
                 .withNoise(kAllColumns, 0.003);
         }},
        {"noise, 0.1 to 0.6 turns",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.onLogScale(0.1, 0.6), random.onLogScale(60, 400))
                 .with(kSixColumns)
                 .digits(7)
                 .withNoise(kAllColumns, 0.005);
         }},
        {"noise, a tenth of a turn",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(0.1, random.onLogScale(60, 400))
                 .with(kSixColumns)
                 .digits(7)
                 .withNoise(kAllColumns, 0.005);
         }},
        {"noise, a quarter turn of theta3",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(0.25, random.between(60, 200))
                 .with({kTheta3})
                 .digits(7)
                 .withNoise(kAllColumns, 0.005);
         }},
        {"drifting noise",
         [](Random &random) {
             return ClaimTable(random)
                 .with({kSlider, kTheta3})
                 .digits(7)
                 .withUnevenNoise(kAllColumns, {.fraction = 0.01, .correlation = 0.95})
                 .mayBeMissed()
                 .approximate();
         }},
        {"time stamps with four decimals",
         [](Random &random) {
             return ClaimTable(random, withSpeed(random.mechanism(), random.eitherSign(0.5, 5.0)))
                 .overTime(random.between(0.6, 3.0), random.between(20, 100))
                 .timeDecimals(4)
                 .with(random.oneOf({kSixColumns, kSliderColumns}));
         }},
        {"six digits printed with 19", [](Random &random) { return ClaimTable(random).with(kSixColumns).reprinted(); }},
        {"1.3 to 1.9 rows a turn",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(32, 46), 60)
                 .with(random.oneOf<Channels>({kSixColumns, {kSlider, kSliderSpeed}}));
         }},
        // With 1.34 rows a turn, a slower crank with 3.94 rows a turn gives the same samples; with 1.1 rows, one
        // with 11.
        {"1.3 to 1.9 rows a turn, R4_x alone",
         [](Random &random) { return ClaimTable(random).overTime(random.between(32, 44), 60).with({kSlider}); }},
        {"1.3 to 1.9 rows a turn, theta2 within a turn",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(32, 44), 60)
                 .with({kTheta2, kSlider})
                 .withinATurn(kTheta2)
                 .mayBeMissed();
         }},
        {"two to five values",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(0.3, 1.5), random.between(2, 5))
                 .with({kSlider})
                 .tooFewValues();
         }},
        {"4 to 14 rows of R4_x",
         [](Random &random) {
             return ClaimTable(random).overTime(random.between(0.6, 1.5), random.between(4, 14)).with({kSlider});
         }},
        {"2 to 8 rows of six columns",
         [](Random &random) {
             return ClaimTable(random).overTime(random.between(0.6, 1.5), random.between(2, 8)).with(kSixColumns);
         }},
        {"a tenth of a turn",
         [](Random &random) {
             ClaimTable table(random);
             table.overTime(0.1, random.between(60, 200));
             return random.isTrue(0.33) ? table.with({kTheta3, kSlider}).decimals(4)
                                        : table.with({random.oneOf({kTheta3, kSlider})});
         }},
        {"10 to 25 turns",
         [](Random &random) {
             return ClaimTable(random).overTime(random.between(10, 25), random.between(200, 500)).with(kSixColumns);
         }},
        {"gaps and missing rows",
         [](Random &random) {
             return ClaimTable(random)
                 .with(random.oneOf<Channels>({kSixColumns, {kTheta3, kSlider, kSliderSpeed}}))
                 .withGaps(kAllColumns, 0.15);
         }},
        {"theta3 in every tenth row",
         [](Random &random) {
             return ClaimTable(random).with({kSlider, kTheta3}).withGaps({kTheta3}, 0.9);
         }},
        {"constants and whole numbers",
         [](Random &random) {
             const Parameters whole{random.oneOf({20.0, 43.0, 60.0}), random.oneOf({110.0, 154.0, 200.0}),
                                    random.oneOf({-37.0, -12.0, 8.0, 45.0}), kTurn * 5.0 / 6.0,
                                    random.oneOf({-2.0, 0.0, 1.0})};
             return ClaimTable(random, whole)
                 .overTime(random.oneOf({1.0, 2.0, 3.0}), random.oneOf({121.0, 241.0, 361.0}))
                 .with({kTheta2, kTheta2Diff, kSlider, kTheta3, kR4y});
         }},
        {"R2 and R3 beside six columns",
         [](Random &random) {
             const Channels coupler{{R3x}, {R3y}, {R3x, Order::Velocity}, {R3y, Order::Velocity}};
             const Channels crank{{R2x}, {R2y}, {R2x, Order::Velocity}, {R2y, Order::Velocity}};
             return random.isTrue(0.5) ? ClaimTable(random).with(kSixColumns).with(coupler)
                                       : ClaimTable(random).with({kSlider}).with(crank);
         }},
        // A table without any of the six plotted channels.
        {"R2 or R3 alone",
         [](Random &random) {
             const Coordinate x = random.oneOf({R2x, R3x});
             const auto y = static_cast<Coordinate>(x + 1);
             return ClaimTable(random).with({{x}, {y}, {x, Order::Velocity}, {y, Order::Velocity}}).mayBeMissed();
         }},
        // The same numbers in mm are those of a smaller mechanism.
        {"all lengths in another unit",
         [](Random &random) {
             return ClaimTable(random, enlarged(random.mechanism(), random.oneOf({1e-3, 0.1, 1.0 / 25.4})))
                 .with(random.oneOf<Channels>({kSixColumns, {kSlider}}));
         }},
        {"clock in ms, positions",
         [](Random &random) {
             return ClaimTable(random, withSpeed(random.mechanism(), random.onLogScale(5e-4, 0.1)))
                 .with({kSlider, kTheta3});
         }},
    };
}

/// Mechanisms with extreme proportions or positions.
std::vector<ClaimKind> limitTables()
{
    using Random = ClaimRandom;
    return {
        {"b = 1.02 (a + |c|)",
         [](Random &random) { return ClaimTable(random, withMargin(random.mechanism(), 0.02)).with(kSixColumns); }},
        {"b = 8 a",
         [](Random &random) { return ClaimTable(random, withCoupler(random.mechanism(), 8.0)).with(kSixColumns); }},
        // The last digit of a length changes the first digit of an acceleration.
        {"near a toggle",
         [](Random &random) {
             return ClaimTable(random, withMargin(random.mechanism(), random.onLogScale(1e-10, 1e-3)))
                 .with(kSixColumns)
                 .mayBeMissed()
                 .mayExcludeRows();
         }},
        {"rocker with gaps",
         [](Random &random) {
             const double offset = random.eitherSign(0.1, 1.2);
             ClaimTable table(random,
                              withMargin(withOffset(random.mechanism(), offset), -random.onLogScale(0.02, 0.25)));
             table.with(kSixColumns).mayBeMissed().mayExcludeRows();
             return random.isTrue(0.5) ? table.withEmptyRows() : table;
         }},
        {"rocker between its limits",
         [](Random &random) {
             const Parameters rocker = withMargin(withOffset(random.mechanism(), random.onLogScale(0.1, 1.2)),
                                                  -random.onLogScale(0.02, 0.25));
             return ClaimTable(random, withStart(withSpeed(rocker, random.onLogScale(0.5, 50.0)), 0.67))
                 .overTime(0.286, random.onLogScale(60, 400))
                 .with(kSixColumns);
         }},
        {"crossed",
         [](Random &random) {
             return ClaimTable(random, crossed(random.mechanism()))
                 .with(random.oneOf<Channels>({kSixColumns, kSliderColumns}));
         }},
        {"c = 0",
         [](Random &random) {
             return ClaimTable(random, withOffset(random.mechanism(), 0.0))
                 .with(random.oneOf<Channels>({kSixColumns, kSliderColumns}));
         }},
        {"a << b",
         [](Random &random) {
             return ClaimTable(random, withCoupler(random.mechanism(), random.onLogScale(1e2, 1e9)))
                 .with(random.oneOf<Channels>({kSixColumns, kSliderColumns, {kSlider}}));
         }},
        {"c >> a",
         [](Random &random) {
             const Parameters far = withOffset(random.mechanism(), random.onLogScale(5.0, 5e4));
             return ClaimTable(random, withMargin(far, random.onLogScale(0.02, 0.5))).with(kSixColumns);
         }},
        // A rocker, or a mechanism that passes through its change points.
        {"a = b",
         [](Random &random) {
             const double offset = random.isTrue(0.5) ? 0.0 : random.onLogScale(0.01, 0.3);
             return ClaimTable(random, withCoupler(withOffset(random.mechanism(), offset), 1.0))
                 .with(kSixColumns)
                 .mayBeMissed()
                 .mayExcludeRows();
         }},
        {"t near 1e9 s",
         [](Random &random) {
             return ClaimTable(random, withSpeed(random.mechanism(), random.onLogScale(1.0, 10.0)))
                 .overTime(random.between(0.6, 3.0), random.onLogScale(60, 400), 1e9)
                 .timeDecimals(4)
                 .with(kSixColumns)
                 .mayBeMissed();
         }},
    };
}

/// Motions that no slider-crank with a constant speed makes.
std::vector<ClaimKind> otherMotions()
{
    using Random = ClaimRandom;
    return {
        {"scotch yoke",
         [](Random &random) {
             return ClaimTable(random)
                 .ofYoke(0.0, 0.0)
                 .with(random.oneOf<Channels>(
                     {kSliderColumns, {kSlider}, {kSlider, kSliderSpeed, kTheta2}, {kSlider, kTheta2}}))
                 .noMechanism();
         }},
        {"yoke, third harmonic",
         [](Random &random) {
             return ClaimTable(random).ofYoke(0.0, random.onLogScale(0.003, 0.2)).with(kSliderColumns).noMechanism();
         }},
        {"yoke, 8 % and noise",
         [](Random &random) {
             return ClaimTable(random)
                 .ofYoke(0.0, 0.08)
                 .with(kSliderColumns)
                 .digits(7)
                 .withNoise(kAllColumns, 0.01)
                 .noMechanism();
         }},
        {"yoke, 2 %, R4_x alone",
         [](Random &random) { return ClaimTable(random).ofYoke(0.0, 0.02).with({kSlider}).noMechanism(); }},
        {"damped oscillation",
         [](Random &random) {
             return ClaimTable(random)
                 .ofYoke(0.08, 0.0)
                 .with(random.oneOf<Channels>({kSliderColumns, {kSlider}}))
                 .noMechanism();
         }},
        {"crank speeds up",
         [](Random &random) {
             return ClaimTable(random).speedingUp(random.between(0.01, 0.03)).with(kSixColumns).noMechanism();
         }},
        {"crank speeds up, with theta2",
         [](Random &random) {
             return ClaimTable(random).speedingUp(random.onLogScale(0.05, 0.3)).with({kTheta2, kSlider, kTheta3});
         }},
        {"crank speeds up, with theta2 and derivatives",
         [](Random &random) {
             return ClaimTable(random).speedingUp(random.onLogScale(0.05, 0.3)).with(kSixColumns).with({kTheta2});
         }},
        {"speed swings",
         [](Random &random) {
             return ClaimTable(random)
                 .rippling(random.oneOf({0.02, 0.2}), random.oneOf({1.0, 2.0, 3.0}))
                 .with(kSixColumns)
                 .noMechanism();
         }},
        {"speed swings by 20 %, with theta2",
         [](Random &random) {
             return ClaimTable(random)
                 .rippling(0.2, random.oneOf({1.0, 2.0, 3.0}))
                 .with(random.oneOf<Channels>({kSixColumns, {kSlider}}))
                 .with({kTheta2});
         }},
        {"random values",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(0.6, 3.0), random.between(5, 60))
                 .with(random.oneOf<Channels>({{kSlider}, kSixColumns}))
                 .replacedByRandom(kAllColumns)
                 .noMechanism();
         }},
        {"a sloping line",
         [](Random &random) {
             ClaimTable table = ClaimTable(random).with({kSlider}).with(kR4y, kSlider);
             return table.multiplied({kR4y}, random.onLogScale(0.05, 0.6)).noMechanism();
         }},
        {"nothing moves",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(0.6, 3.0), 60)
                 .with({kSlider, kTheta3})
                 .amplified(kAllColumns, 0.0)
                 .noMechanism();
         }},
    };
}

} // namespace slidercrank
