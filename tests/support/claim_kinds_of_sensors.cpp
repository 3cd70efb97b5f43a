// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tables with the faults of sensors, filters, loggers and spreadsheets. Filtered, interpolated or integrated
// values change the parameters by more than the residuals show.
#include "tests/support/claim_kinds.h"

#include "core/mechanism/turn.h"

namespace slidercrank
{

namespace
{

constexpr double kErrorCode = -9999.0; // a logger writes it in place of a reading

/// Returns a table of 100 … 300 rows in 1 … 3 turns.
ClaimTable longTable(ClaimRandom &random, std::initializer_list<Channels> choices, int digits = 7)
{
    return ClaimTable(random)
        .overTime(random.between(1.0, 3.0), random.between(100, 300))
        .with(random.oneOf(choices))
        .digits(digits);
}

/// Returns a table of 100 … 300 rows with R4_x, with R4_x and θ2 or θ3, or with all six channels.
ClaimTable tableOfPositionsAndMore(ClaimRandom &random, int digits = 7)
{
    return longTable(random, {{kSlider}, {kSlider, kTheta3}, {kTheta2, kSlider}, kSixColumns}, digits);
}

ClaimTable tableOfPositions(ClaimRandom &random, int digits = 7)
{
    return longTable(random, {{kSlider}, {kSlider, kTheta3}}, digits);
}

/// Returns a table of 100 … 300 rows with R4_x, with R4_x and θ3, or with all six channels. With a probability of one
/// half, it has noise of 1e-4 … `maxNoise` of half the range.
ClaimTable tableOfPositionsOrSixChannels(ClaimRandom &random, double maxNoise)
{
    ClaimTable table = longTable(random, {{kSlider}, {kSlider, kTheta3}, kSixColumns});
    return random.isTrue(0.5) ? table.withNoise(kAllColumns, random.onLogScale(1e-4, maxNoise)) : table;
}

} // namespace

std::vector<ClaimKind> filteredTables()
{
    using Random = ClaimRandom;
    return {
        {"moving average",
         [](Random &random) {
             return tableOfPositionsAndMore(random)
                 .smoothed(kAllColumns, {.before = random.oneOf({1, 2, 3, 4})})
                 .approximate();
         }},
        {"centred moving average",
         [](Random &random) {
             const int rows = random.oneOf({1, 3});
             return tableOfPositionsAndMore(random)
                 .smoothed(kAllColumns, {.before = rows, .after = rows})
                 .approximate();
         }},
        {"centred moving average of position and velocity",
         [](Random &random) {
             return longTable(random, {{kSlider, kSliderSpeed}})
                 .smoothed(kAllColumns, {.before = 2, .after = 2})
                 .approximate()
                 .mayBeMissed();
         }},
        {"centred moving average of the position, exact velocity",
         [](Random &random) {
             return longTable(random, {{kSlider, kSliderSpeed}})
                 .smoothed({kSlider}, {.before = 2, .after = 2})
                 .approximate()
                 .mayBeMissed();
         }},
        {"first-order low-pass",
         [](Random &random) {
             return tableOfPositionsAndMore(random)
                 .smoothed(kAllColumns, {.before = 40, .decay = random.between(0.2, 1.0)})
                 .approximate();
         }},
        {"zero-phase low-pass",
         [](Random &random) {
             return tableOfPositionsAndMore(random)
                 .smoothed(kAllColumns, {.before = 40, .after = 40, .decay = random.between(0.2, 1.0)})
                 .approximate();
         }},
        {"linear interpolation of a coarse run",
         [](Random &random) {
             return tableOfPositionsAndMore(random).interpolated(kAllColumns, random.between(2.2, 8.0)).approximate();
         }},
        {"last value of a coarse run",
         [](Random &random) {
             return tableOfPositionsAndMore(random).held(kAllColumns, random.between(2.2, 8.0)).approximate();
         }},
        {"integration errors",
         [](Random &random) {
             return tableOfPositionsAndMore(random, 9)
                 .withTone(kAllColumns,
                           {.perTurn = random.onLogScale(0.2, 4.0), .fraction = random.onLogScale(5e-7, 5e-5)})
                 .withTone(kAllColumns,
                           {.perTurn = random.onLogScale(0.2, 4.0), .fraction = random.onLogScale(5e-7, 5e-5)})
                 .approximate();
         }},
        {"drifting zero",
         [](Random &random) {
             return longTable(random, {{kSlider}, {kSlider, kTheta3}, kSixColumns})
                 .withTone({kSlider},
                           {.perTurn = random.onLogScale(0.02, 0.2), .fraction = random.onLogScale(1e-3, 2e-2)})
                 .approximate();
         }},
        {"hum",
         [](Random &random) {
             return tableOfPositions(random)
                 .withTone({kSlider}, {.perTurn = random.between(6.3, 20.0), .fraction = random.between(1e-3, 5e-3)})
                 .approximate();
         }},
        {"backlash",
         [](Random &random) {
             return longTable(random, {{kSlider, kTheta3}, {kTheta2, kSlider}})
                 .withBacklash(kSlider, random.onLogScale(5e-4, 4e-3))
                 .approximate();
         }},
        {"noise that grows with the reading",
         [](Random &random) {
             return tableOfPositions(random)
                 .withUnevenNoise(kAllColumns, {.fraction = random.onLogScale(1e-3, 1e-2), .growth = 5.0})
                 .approximate();
         }},
        {"speed ripple",
         [](Random &random) {
             const double fraction = random.onLogScale(1e-4, 5e-3);
             ClaimTable table = ClaimTable(random).rippling(fraction, random.onLogScale(0.5, 4.0));
             table.isCrankUneven = false; // the file does not show it
             return table.with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}})).digits(7).approximate();
         }},
        // A different origin explains the error of the sensor equally well.
        {"error with half the period",
         [](Random &random) {
             return longTable(random, {{kSlider}})
                 .withNoise(kAllColumns, random.onLogScale(1e-4, 1e-3))
                 .withTone(kAllColumns, {.perTurn = 2.0, .fraction = random.between(2e-3, 8e-3)})
                 .shifted(kAllColumns, 0.0)
                 .conventionsBetween(0, 2)
                 .approximate();
         }},
        {"averages over bins of the crank angle",
         [](Random &random) {
             return ClaimTable(random)
                 .overCrankAngle(random.oneOf({1.0, 2.0, 5.0}), random.between(1.0, 3.0))
                 .with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}}))
                 .digits(7)
                 .smoothed({kSlider, kTheta3}, {.before = 1, .after = 1})
                 .approximate();
         }},
    };
}

/// Speeds that are not constant, and columns that contradict each other.
std::vector<ClaimKind> contradictoryTables()
{
    using Random = ClaimRandom;
    return {
        {"speed ripple, with theta2",
         [](Random &random) {
             const double fraction = random.onLogScale(0.05, 0.3);
             return ClaimTable(random).rippling(fraction, random.onLogScale(0.3, 2.0)).with({kTheta2, kSlider});
         }},
        {"joined runs",
         [](Random &random) {
             const double jump = random.onLogScale(0.1, 6.2);
             const double jumpAngle = random.between(2.0, 4.0);
             return ClaimTable(random)
                 .turnedBy([=](double angle) { return angle < jumpAngle ? angle : angle + jump; })
                 .with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}}))
                 .noMechanism();
         }},
        {"standstill",
         [](Random &random) {
             const double lastAngle = random.between(1.5, 4.5);
             return ClaimTable(random)
                 .turnedBy([=](double angle) { return std::min(angle, lastAngle); })
                 .with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}}))
                 .noMechanism();
         }},
        {"two mechanisms",
         [](Random &random) {
             return longTable(random, {{kSlider, kTheta3}, kSixColumns}, 6)
                 .ofLongerCoupler(kCouplerColumns, random.between(1.02, 1.2))
                 .contradictory();
         }},
        {"a derivative of another mechanism",
         [](Random &random) {
             return longTable(random, {kSixColumns}, 6)
                 .ofLongerCoupler(randomDerivative(random), random.between(1.2, 1.5));
         }},
        {"gain error of a derivative",
         [](Random &random) {
             const double gain = 1.0 + random.eitherSign(0.005, 0.03);
             return longTable(random, {kSixColumns}, 6).amplified(randomDerivative(random), gain);
         }},
        {"unconnected derivative",
         [](Random &random) { return longTable(random, {kSixColumns}, 6).amplified(randomDerivative(random), 0.0); }},
        {"lagging channel",
         [](Random &random) {
             return longTable(random, {{kSlider, kTheta3}, kSixColumns}, 6)
                 .delayed(kCouplerColumns, random.oneOf({1, 2, 3, 4, 5, 6}))
                 .contradictory();
         }},
        {"set speed of the crank",
         [](Random &random) {
             const double gain = 1.0 + random.eitherSign(0.01, 0.1);
             return longTable(random, {{kSlider, kTheta3}, kSixColumns})
                 .with({kTheta2Diff})
                 .amplified({kTheta2Diff}, gain);
         }},
        {"twice the centre of the crank",
         [](Random &random) {
             return longTable(random, {{{R2x}, {R2y}, kSlider, kTheta3}}).amplified({{R2x}, {R2y}}, 2.0);
         }},
        {"centre of mass of the coupler",
         [](Random &random) {
             return longTable(random, {kSliderColumns, kSixColumns})
                 .with({{R3x}})
                 .amplified({{R3x}}, random.between(0.7, 0.9));
         }},
        {"Savitzky-Golay derivatives of noisy positions",
         [](Random &random) {
             return longTable(random, {kSixColumns})
                 .withNoise(kAllColumns, random.onLogScale(5e-4, 5e-3))
                 .differentiated(kDerivatives, random.oneOf({3, 4, 5, 6, 7}));
         }},
        {"central differences of noisy positions",
         [](Random &random) {
             return longTable(random, {kSixColumns})
                 .withNoise(kAllColumns, random.onLogScale(5e-4, 5e-3))
                 .differentiated(kDerivatives, 1);
         }},
        {"Savitzky-Golay derivatives of exact positions",
         [](Random &random) {
             return longTable(random, {kSixColumns}).differentiated(kDerivatives, random.oneOf({2, 3, 4, 5}));
         }},
        // A gain error of θ3 looks nearly like a different b.
        {"gain error and two origins",
         [](Random &random) {
             return longTable(random, {{kTheta3, kSlider}})
                 .withNoise(kAllColumns, 2e-3)
                 .amplified({kTheta3}, random.oneOf({0.98, 1.02}))
                 .shifted({kTheta3}, random.between(5.0, 20.0))
                 .shifted({kSlider}, random.between(20.0, 60.0))
                 .conventionsBetween(0, 3)
                 .approximate()
                 .mayBeMissed();
         }},
        {"velocity in m/s",
         [](Random &random) {
             return longTable(random, {{kSlider, kSliderSpeed}, {kSlider, kTheta3, kSliderSpeed}}, 6)
                 .multiplied({kSliderSpeed}, 1e-3)
                 .conventions(1);
         }},
        {"acceleration in g",
         [](Random &random) {
             return longTable(random, {kSliderColumns, kSixColumns}, 6)
                 .amplified({kSliderAcceleration}, 1.0197162129779e-4);
         }},
        {"derivatives per radian",
         [](Random &random) {
             return longTable(random, {{kSlider, kSliderSpeed}, {kSlider, kTheta3, kSliderSpeed, kTheta3Speed}}, 6)
                 .amplified({kSliderSpeed, kTheta3Speed}, random.onLogScale(0.01, 0.1));
         }},
        {"forward differences",
         [](Random &random) {
             return longTable(random, {kSliderColumns, kSixColumns}, 6)
                 .delayed({kSliderSpeed, kTheta3Speed}, -0.5)
                 .delayed({kSliderAcceleration, kTheta3Acceleration}, -1.0);
         }},
    };
}

/// Encoders, converters, decimals, wrong readings. A file does not show that truncated values are half a step too small
/// on average.
std::vector<ClaimKind> sensorTables()
{
    using Random = ClaimRandom;
    return {
        {"encoders",
         [](Random &random) {
             ClaimTable table = longTable(random, {{kTheta2, kSlider}}, 10).accurateTo(0.0125);
             const double step = random.oneOf({0.0439453125, 0.17578125, 0.703125, 0.2, 0.9});
             table.inSteps({kSlider}, random.oneOf({0.005, 0.01, 0.02, 0.05}));
             return random.isTrue(0.5) ? table.inSteps({kTheta2}, step) : table.truncated({kTheta2}, step);
         }},
        {"steps of a converter",
         [](Random &random) {
             return tableOfPositions(random, 10).inSteps(kAllColumns, random.onLogScale(0.02, 0.15));
         }},
        {"truncated decimals",
         [](Random &random) {
             return longTable(random, {{kSlider}, {kSlider, kTheta3}, {kTheta2, kSlider}})
                 .decimals(3)
                 .truncated(kAllColumns, 1e-3);
         }},
        {"spikes",
         [](Random &random) {
             return tableOfPositionsOrSixChannels(random, 3e-3)
                 .misread(kSlider, {.offset = random.eitherSign(20, 300)});
         }},
        {"zeros for lost values",
         [](Random &random) { return tableOfPositionsOrSixChannels(random, 3e-3).misread(kSlider, {.factor = 0.0}); }},
        {"-9999 for lost values",
         [](Random &random) {
             return tableOfPositionsOrSixChannels(random, 3e-3).misread(kSlider, {.factor = 0.0, .offset = kErrorCode});
         }},
        {"-9999 for one lost row",
         [](Random &random) {
             return ClaimTable(random)
                 .overTime(random.between(2.2, 3.0), 60)
                 .with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}}))
                 .digits(7)
                 .misread(kSlider, {.factor = 0.0, .offset = kErrorCode});
         }},
        {"contact that fails",
         [](Random &random) {
             return longTable(random, {{kSlider, kTheta3}})
                 .withNoise(kAllColumns, 2e-3)
                 .failing(kSlider, 0.2, 0.3)
                 .approximate();
         }},
        {"frozen readings", [](Random &random) { return tableOfPositionsOrSixChannels(random, 1e-3).frozen(kSlider); }},
        {"saturation",
         [](Random &random) {
             return tableOfPositionsOrSixChannels(random, 1e-3).saturated(kSlider, random.onLogScale(0.03, 0.15));
         }},
    };
}

/// Loggers with unusual time stamps.
std::vector<ClaimKind> clockTables()
{
    using Random = ClaimRandom;
    return {
        {"repeated rows of events",
         [](Random &random) {
             return longTable(random, {{kSlider}, {kSlider, kTheta3}, {kTheta2, kSlider}, kSixColumns}, 6)
                 .withRepeatedRows(static_cast<int>(random.onLogScale(1, 60)));
         }},
        {"jitter of the time",
         [](Random &random) {
             return tableOfPositions(random, 8).jittered(kAllColumns, random.onLogScale(3e-3, 5e-2)).approximate();
         }},
        {"mixed sampling",
         [](Random &random) { return tableOfPositionsAndMore(random, 6).slowedDown(random.between(2.0, 5.0)); }},
        {"lost blocks",
         [](Random &random) {
             return tableOfPositionsAndMore(random, 6).withoutABlock(random.oneOf<Channels>({{kSlider}, kAllColumns}));
         }},
        {"late trigger",
         [](Random &random) {
             const double start = random.onLogScale(1.0, 1e3);
             return ClaimTable(random)
                 .overTime(random.between(1.0, 3.0), random.onLogScale(100, 400), start)
                 .timeDecimals(9)
                 .with(random.oneOf<Channels>({{kSlider}, {kSlider, kTheta3}, {kTheta2, kSlider}, kSixColumns}));
         }},
    };
}

} // namespace slidercrank
