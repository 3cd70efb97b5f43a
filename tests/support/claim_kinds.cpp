// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a slider-crank that read as they stand.
#include "core/mechanism/turn.h"
#include "tests/support/claim_files.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Rule = NumberForm::Rule;

constexpr Channel kX{R4x, Order::Position};
constexpr Channel kV{R4x, Order::Velocity};
constexpr Channel kAngle{Theta3, Order::Position};
constexpr Channel kCrank{Theta2, Order::Position};
constexpr Channel kCrankSpeed{Theta2, Order::Velocity};
constexpr Channel kY{R4y, Order::Position};

/// A random mechanism, not yet when.
ClaimFile mechanismOf(Dice &dice)
{
    ClaimFile file;
    file.truth = anyMechanism(dice);
    return file;
}

ClaimFile finished(ClaimFile file, Dice &dice)
{
    finish(file, dice);
    return file;
}

/// 0.6 … 3 turns of those columns.
ClaimFile ordinary(Dice &dice, std::vector<ClaimColumn> columns)
{
    ClaimFile file = mechanismOf(dice);
    file.columns = std::move(columns);
    setInstants(file, dice);
    return finished(std::move(file), dice);
}

/// Or for so many turns, with so many rows.
ClaimFile lasting(Dice &dice, std::vector<ClaimColumn> columns, double turns, int rows)
{
    ClaimFile file = mechanismOf(dice);
    file.columns = std::move(columns);
    setInstants(file, dice, turns, rows);
    return finished(std::move(file), dice);
}

/// White noise on every column, as part of how much it swings in these instants.
ClaimFile noisy(Dice &dice, ClaimFile file, double part)
{
    for (ClaimColumn &each : file.columns) {
        each.noise = part * swingOf(file, each.shown);
    }
    return finished(std::move(file), dice);
}

/// Of numbers that are rounded to three places less than the noise.
NumberForm formOfNoise()
{
    return {Rule::Digits, 7};
}

ClaimFile sixColumns(Dice &dice)
{
    const bool asInventor = dice.chance(0.5);
    return ordinary(dice, plottedColumns({asInventor ? Rule::DigitsInDecimals : Rule::Digits, 6}));
}

ClaimFile someOfSix(Dice &dice)
{
    const auto mask = static_cast<unsigned>(1 + dice.number() % 63);
    return ordinary(dice, plottedColumns({}, mask));
}

ClaimFile crankAndSlider(Dice &dice)
{
    return ordinary(dice, {column(kCrank), column(kX), column(kV), column(kY)});
}

ClaimFile crankAndPosition(Dice &dice)
{
    return ordinary(dice, {column(kCrank), column(kX)});
}

ClaimFile twoDecimals(Dice &dice)
{
    return ordinary(dice, {column(kX, {Rule::Decimals, 2})});
}

ClaimFile nineDigits(Dice &dice)
{
    return ordinary(dice, plottedColumns({Rule::Digits, 9}));
}

/// As a person types them into a spreadsheet.
ClaimFile oneDecimal(Dice &dice)
{
    return ordinary(dice, {column(kCrank, {Rule::Decimals, 0}), column(kX, {Rule::Decimals, 1})});
}

ClaimFile wholeMillimetres(Dice &dice)
{
    return lasting(dice, {column(kX, {Rule::Decimals, 0})}, dice.uniform(0.6, 3.0), 60);
}

ClaimFile noiseOfPositions(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    const double part = dice.logUniform(0.001, 0.01);
    file.columns = {column(kX, formOfNoise()), column(kAngle, formOfNoise())};
    file.columns[0].noise = part * file.truth->a;
    file.columns[1].noise = part * file.truth->a / file.truth->b * kDegreesPerRadian;
    return finished(std::move(file), dice);
}

ClaimFile noiseOfSix(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    file.columns = plottedColumns(formOfNoise());
    return noisy(dice, std::move(file), dice.logUniform(0.001, 0.02));
}

/// Two encoders.
ClaimFile noiseOfCrankAndSlider(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    file.columns = {column(kCrank, formOfNoise()), column(kX, formOfNoise())};
    file.columns[0].noise = dice.logUniform(0.05, 1.0);
    file.columns[1].noise = dice.logUniform(0.001, 0.01) * file.truth->a;
    return finished(std::move(file), dice);
}

ClaimFile noiseOfSliderAlone(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice, dice.uniform(0.4, 2.0), dice.whole(60, 400));
    file.columns = {column(kX, formOfNoise())};
    return noisy(dice, std::move(file), 0.003);
}

ClaimFile noiseOfPartOfATurn(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice, dice.uniform(0.1, 0.6), dice.whole(60, 400));
    file.columns = plottedColumns(formOfNoise());
    return noisy(dice, std::move(file), 0.005);
}

ClaimFile quarterTurnOfAngle(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice, 0.25, dice.whole(60, 200));
    file.columns = {column(kAngle, formOfNoise())};
    return noisy(dice, std::move(file), 0.005);
}

/// Noise with a memory of some twenty rows: of sensors that drift. Nothing may be sure of it.
ClaimFile driftingNoise(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    file.columns = {column(kX, formOfNoise()), column(kAngle, formOfNoise())};
    file.mayBeMissed = true;
    constexpr double kMemory = 0.95;
    for (ClaimColumn &each : file.columns) {
        const double size = 0.01 * swingOf(file, each.shown);
        double drift = size * dice.normal();
        for (const double t : file.instants) {
            each.values.push_back(static_cast<double>(motionAt(*file.truth, t)[indexOf(each.shown)]) + drift);
            drift = kMemory * drift + std::sqrt(1.0 - kMemory * kMemory) * size * dice.normal();
        }
        each.isMotion = false;
    }
    return finished(std::move(file), dice);
}

/// 30 frames a second; the instants have four decimals.
ClaimFile framesOfACamera(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    file.truth->omega2 = dice.logUniform(0.5, 15.0) * dice.sign();
    const double turns = dice.uniform(0.6, 3.0);
    const int rows = std::clamp(static_cast<int>(turns * kTurn / std::abs(file.truth->omega2) * 30.0), 20, 400);
    for (int i = 0; i < rows; ++i) {
        file.instants.push_back(i / 30.0);
    }
    file.timeForm = {Rule::Decimals, 4};
    file.timeStep = 1e-4;
    file.columns = plottedColumns({}, dice.chance(0.5) ? 0x3F : 0x2A);
    return finished(std::move(file), dice);
}

/// Six digits, as a program writes them that knows no better than "%.18e".
ClaimFile everyDigitOfADouble(Dice &dice)
{
    return ordinary(dice, plottedColumns({Rule::Digits, 6, true}));
}

ClaimFile fewRowsATurn(Dice &dice, unsigned mask, double least)
{
    ClaimFile file = mechanismOf(dice);
    const int rows = dice.whole(30, 120);
    setInstants(file, dice, rows / dice.uniform(least, 1.9), rows);
    file.columns = plottedColumns({}, mask);
    return finished(std::move(file), dice);
}

ClaimFile fewRowsATurnOfSix(Dice &dice)
{
    return fewRowsATurn(dice, 0x3F, 1.3);
}

ClaimFile fewRowsATurnWithSpeed(Dice &dice)
{
    return fewRowsATurn(dice, 0x0A, 1.3);
}

/// At 1.34 rows a turn the other speed that meets the same instants has 3.94; a true 1.1 looks like 11, and nobody can
/// see that.
ClaimFile fewRowsATurnOfSliderAlone(Dice &dice)
{
    return fewRowsATurn(dice, 0x02, 1.35);
}

ClaimFile twoToFourValues(Dice &dice)
{
    ClaimFile file = lasting(dice, {column(kX)}, dice.uniform(0.3, 1.5), dice.whole(2, 4));
    file.tooFew = true;
    return file;
}

ClaimFile fiveValues(Dice &dice)
{
    ClaimFile file = lasting(dice, {column(kX)}, dice.uniform(0.3, 1.5), 5);
    file.tooFew = true;
    return file;
}

ClaimFile fewRowsOfSlider(Dice &dice)
{
    return lasting(dice, {column(kX)}, dice.uniform(0.6, 1.5), dice.whole(4, 14));
}

ClaimFile fewRowsOfSix(Dice &dice)
{
    return lasting(dice, plottedColumns(), dice.uniform(0.6, 1.5), dice.whole(2, 8));
}

ClaimFile tenthOfATurn(Dice &dice)
{
    constexpr std::array kMasks{0x01U, 0x02U, 0x03U};
    const unsigned mask = kMasks[static_cast<std::size_t>(dice.whole(0, 2))];
    return lasting(dice, plottedColumns({Rule::Decimals, 4}, mask), 0.1, dice.whole(60, 200));
}

ClaimFile manyTurns(Dice &dice)
{
    const double turns = dice.uniform(10.0, 25.0);
    return lasting(dice, plottedColumns(), turns, dice.whole(200, 500));
}

ClaimFile barelyLongEnough(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    file.truth->b = 1.02 * (file.truth->a + std::abs(file.truth->c));
    setInstants(file, dice);
    file.columns = plottedColumns();
    return finished(std::move(file), dice);
}

ClaimFile longCoupler(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    file.truth->b = 8.0 * file.truth->a;
    setInstants(file, dice);
    file.columns = plottedColumns();
    return finished(std::move(file), dice);
}

ClaimFile gapsAndMissingRows(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    std::erase_if(file.instants, [&](double t) { return t != file.instants.back() && dice.chance(0.1); });
    file.columns = plottedColumns({}, dice.chance(0.5) ? 0x3F : 0x0B);
    for (ClaimColumn &each : file.columns) {
        for (const double t : file.instants) {
            const auto value = static_cast<double>(motionAt(*file.truth, t)[indexOf(each.shown)]);
            each.values.push_back(dice.chance(0.15) ? kNone : value);
        }
    }
    return finished(std::move(file), dice);
}

ClaimFile someInTenthRowsOnly(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    file.columns = {column(kX), column(kAngle)};
    for (std::size_t i = 0; i < file.instants.size(); ++i) {
        const AllChannels all = motionAt(*file.truth, file.instants[i]);
        file.columns[0].values.push_back(static_cast<double>(all[indexOf(kX)]));
        file.columns[1].values.push_back(i % 10 == 0 ? static_cast<double>(all[indexOf(kAngle)]) : kNone);
    }
    return finished(std::move(file), dice);
}

/// Numbers that a person chose: whole degrees of the crank, a whole offset, a constant speed.
ClaimFile constantsAndWholeNumbers(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    file.truth->c = std::round(file.truth->c);
    file.truth->b = std::max(file.truth->b, file.truth->a + std::abs(file.truth->c) + 1.0);
    constexpr double kStep = 0.01; // s, in which the crank turns by three degrees
    file.truth->omega2 = 300.0 / kDegreesPerRadian * dice.sign();
    file.truth->theta20 = dice.whole(-170, 170) / kDegreesPerRadian;
    const int rows = dice.whole(80, 300);
    for (int i = 0; i < rows; ++i) {
        file.instants.push_back(std::round(i * kStep * 100.0) / 100.0);
    }
    file.columns = {column(kCrank), column(kCrankSpeed), column(kX), column(kAngle), column(kY)};
    return finished(std::move(file), dice);
}

ClaimFile clockFromFiveSeconds(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    const double turns = dice.uniform(0.6, 3.0);
    setInstants(file, dice, turns, dice.whole(60, 400), 5.0);
    file.columns = plottedColumns();
    return finished(std::move(file), dice);
}

constexpr std::array kCentres{R3x, R3y};
constexpr std::array kCrankCentres{R2x, R2y};

std::vector<ClaimColumn> centreOf(const std::array<Coordinate, 2> &coordinates, std::vector<ClaimColumn> columns)
{
    for (const Order order : {Order::Position, Order::Velocity}) {
        for (const Coordinate coordinate : coordinates) {
            columns.push_back(column({coordinate, order}));
        }
    }
    return columns;
}

ClaimFile couplerAlone(Dice &dice)
{
    ClaimFile file = ordinary(dice, centreOf(kCentres, {}));
    file.mayBeMissed = true; // no column of the six
    return file;
}

ClaimFile crankAlone(Dice &dice)
{
    return ordinary(dice, centreOf(kCrankCentres, {}));
}

ClaimFile couplerBesideSix(Dice &dice)
{
    return ordinary(dice, centreOf(kCentres, plottedColumns()));
}

ClaimFile crankBesideSlider(Dice &dice)
{
    return ordinary(dice, centreOf(kCrankCentres, {column(kX)}));
}

/// As the mirror image, as another length unit throughout, as a clock in ms throughout: another mechanism, and nothing
/// in the file tells.
ClaimFile lengthsInAnotherUnit(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    setInstants(file, dice);
    constexpr std::array kUnits{1e-3, 0.1, 1.0 / 25.4};
    const double unit = kUnits[static_cast<std::size_t>(dice.whole(0, 2))];
    file.truth->a *= unit;
    file.truth->b *= unit;
    file.truth->c *= unit;
    file.columns = plottedColumns({}, dice.chance(0.5) ? 0x3F : 0x02);
    return finished(std::move(file), dice);
}

ClaimFile clockInMilliseconds(Dice &dice)
{
    ClaimFile file = mechanismOf(dice);
    file.truth->omega2 *= 1e-3;
    setInstants(file, dice);
    file.columns = {column(kX), column(kAngle)};
    return finished(std::move(file), dice);
}

} // namespace

std::span<const ClaimKind> plainKinds()
{
    static constexpr std::array kKinds{
        ClaimKind{"six columns", sixColumns},
        ClaimKind{"some of the six columns", someOfSix, 63},
        ClaimKind{"theta2, R4_x, R4_x_diff, R4_y", crankAndSlider},
        ClaimKind{"theta2, R4_x", crankAndPosition},
        ClaimKind{"R4_x with two decimals", twoDecimals},
        ClaimKind{"six columns of nine digits", nineDigits},
        ClaimKind{"theta2 in whole degrees, R4_x to 0.1 mm", oneDecimal},
        ClaimKind{"R4_x in whole mm", wholeMillimetres},
        ClaimKind{"noise of R4_x and theta3", noiseOfPositions},
        ClaimKind{"noise of six columns", noiseOfSix},
        ClaimKind{"noise of theta2 and R4_x", noiseOfCrankAndSlider},
        ClaimKind{"noise of R4_x alone", noiseOfSliderAlone},
        ClaimKind{"noise, 0.1 to 0.6 turns", noiseOfPartOfATurn},
        ClaimKind{"noise, a quarter turn of theta3", quarterTurnOfAngle},
        ClaimKind{"drifting noise", driftingNoise},
        ClaimKind{"instants with four decimals", framesOfACamera},
        ClaimKind{"17 digits of six", everyDigitOfADouble},
        ClaimKind{"1.3 to 1.9 rows a turn, six columns", fewRowsATurnOfSix},
        ClaimKind{"1.3 to 1.9 rows a turn, R4_x and R4_x_diff", fewRowsATurnWithSpeed},
        ClaimKind{"1.3 to 1.9 rows a turn, R4_x alone", fewRowsATurnOfSliderAlone},
        ClaimKind{"two to four values", twoToFourValues},
        ClaimKind{"five values", fiveValues},
        ClaimKind{"4 to 14 rows of R4_x", fewRowsOfSlider},
        ClaimKind{"2 to 8 rows of six columns", fewRowsOfSix},
        ClaimKind{"a tenth of a turn", tenthOfATurn},
        ClaimKind{"10 to 25 turns", manyTurns},
        ClaimKind{"b = 1.02 (a + |c|)", barelyLongEnough},
        ClaimKind{"b = 8 a", longCoupler},
        ClaimKind{"gaps and missing rows", gapsAndMissingRows},
        ClaimKind{"theta3 in every tenth row", someInTenthRowsOnly},
        ClaimKind{"constants and whole numbers", constantsAndWholeNumbers},
        ClaimKind{"clock from 5 s", clockFromFiveSeconds},
        ClaimKind{"R3 alone", couplerAlone},
        ClaimKind{"R2 alone", crankAlone},
        ClaimKind{"R3 beside six columns", couplerBesideSix},
        ClaimKind{"R2 beside R4_x", crankBesideSlider},
        ClaimKind{"all lengths in another unit", lengthsInAnotherUnit},
        ClaimKind{"clock in ms, positions", clockInMilliseconds},
    };
    return kKinds;
}

} // namespace slidercrank
