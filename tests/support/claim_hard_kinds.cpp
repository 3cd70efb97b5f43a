// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a slider-crank at its limits: toggles, rockers, a ≪ b, a = b, clocks far from zero; and motions that no
// slider-crank makes.
#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "core/study/exact_motion.h"
#include "tests/support/claim_files.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Rule = NumberForm::Rule;

constexpr Channel kX{R4x, Order::Position};
constexpr Channel kV{R4x, Order::Velocity};
constexpr Channel kA{R4x, Order::Acceleration};
constexpr Channel kTheta{Theta3, Order::Position};
constexpr Channel kCrank{Theta2, Order::Position};
constexpr Channel kCrankSpeed{Theta2, Order::Velocity};
constexpr Channel kY{R4y, Order::Position};
constexpr unsigned kSliderFamily = 0x2A;

ClaimFile mechanismWith(Dice &dice, const Parameters &parameters, std::vector<ClaimColumn> columns)
{
    ClaimFile file;
    file.truth = parameters;
    setInstants(file, dice);
    file.columns = std::move(columns);
    return file;
}

/// By the judge of many digits: the textbook's formulas cancel near a toggle.
AllChannels manyDigits(const Parameters &parameters, double t)
{
    const ExactState<Digits50> state = exactState<Digits50>(parameters, t);
    AllChannels all;
    for (std::size_t k = 0; k < kChannelCount; ++k) {
        const Channel channel = channelAt(k);
        const bool exists =
            state.status == Status::Solved || (state.status == Status::Singular && channel.order == Order::Position);
        const double value = static_cast<double>(state.values[k]);
        const bool isZero = std::abs(value) <= kExactZero * naturalSize(parameters, channel);
        all[k] = exists ? toFileUnit(channel, isZero ? 0.0 : value) : kNone;
    }
    return all;
}

ClaimFile finishedExactly(ClaimFile file, Dice &dice)
{
    finish(file, dice, [truth = *file.truth](double t) { return manyDigits(truth, t); });
    return file;
}

ClaimFile nearAToggle(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.b = (p.a + std::abs(p.c)) * (1.0 + dice.logUniform(1e-12, 1e-3));
    ClaimFile file = mechanismWith(dice, p, plottedColumns());
    file.mayBeMissed = true; // some rows weigh next to nothing, others alone say all
    return finishedExactly(std::move(file), dice);
}

/// With rows at the toggle itself, where the last digit of a length moves the first of an acceleration.
ClaimFile atAToggle(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.b = (p.a + std::abs(p.c)) * (1.0 + dice.logUniform(1e-14, 1e-9));
    p.theta20 = p.c > 0.0 ? -kQuarterTurn : kQuarterTurn;
    ClaimFile file = mechanismWith(dice, p, plottedColumns());
    file.mayBeMissed = true;
    return finishedExactly(std::move(file), dice);
}

/// The crank turns on where the coupler does not reach: rows without a pose are left out, or have empty cells.
ClaimFile rockerWithGaps(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.c = p.a * dice.uniform(0.1, 1.2) * dice.sign();
    p.b = (p.a + std::abs(p.c)) * dice.uniform(0.75, 0.98);
    ClaimFile file = mechanismWith(dice, p, plottedColumns());
    file.mayBeMissed = true;
    file.keepsEmptyRows = dice.chance(0.5);
    finish(file, dice);
    return file;
}

/// A rocker that swings within its limits, all rows there.
ClaimFile rockerBetweenLimits(Dice &dice)
{
    ClaimFile file;
    Parameters p = anyMechanism(dice);
    p.c = p.a * dice.uniform(0.1, 1.2) * dice.sign();
    p.b = (p.a + std::abs(p.c)) * dice.uniform(0.75, 0.98);
    p.theta20 = (p.c > 0.0 ? kQuarterTurn : -kQuarterTurn) - 0.9 * (p.omega2 > 0.0 ? 1.0 : -1.0);
    file.truth = p;
    setInstants(file, dice, 1.8 / kTurn, dice.whole(60, 400));
    file.columns = plottedColumns();
    finish(file, dice);
    return file;
}

ClaimFile crossedAssembly(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.branch = Branch::Crossed;
    ClaimFile file = mechanismWith(dice, p, plottedColumns({}, dice.chance(0.5) ? 0x3F : kSliderFamily));
    finish(file, dice);
    return file;
}

ClaimFile centred(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.c = 0.0;
    ClaimFile file = mechanismWith(dice, p, plottedColumns({}, dice.chance(0.5) ? 0x3F : kSliderFamily));
    finish(file, dice);
    return file;
}

ClaimFile shortCrank(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.b = p.a * dice.logUniform(1e2, 1e9);
    constexpr std::array kMasks{0x3FU, kSliderFamily, 0x02U};
    const unsigned mask = kMasks[static_cast<std::size_t>(dice.whole(0, 2))];
    ClaimFile file = mechanismWith(dice, p, plottedColumns({}, mask));
    finish(file, dice);
    return file;
}

ClaimFile farOffset(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.c = p.a * dice.logUniform(5.0, 5e4) * dice.sign();
    p.b = (p.a + std::abs(p.c)) * dice.uniform(1.02, 1.5);
    ClaimFile file = mechanismWith(dice, p, plottedColumns());
    finish(file, dice);
    return file;
}

/// a = b with an offset is a rocker; without one it folds through its change points.
ClaimFile equalLengths(Dice &dice)
{
    Parameters p = anyMechanism(dice);
    p.b = p.a;
    p.c = dice.chance(0.5) ? 0.0 : p.a * dice.uniform(-0.3, 0.3);
    ClaimFile file = mechanismWith(dice, p, plottedColumns());
    file.mayBeMissed = true;
    return finishedExactly(std::move(file), dice);
}

ClaimFile farClock(Dice &dice)
{
    ClaimFile file;
    file.truth = anyMechanism(dice);
    file.truth->omega2 = dice.uniform(1.0, 10.0) * dice.sign();
    const double turns = dice.uniform(0.6, 3.0);
    const int rows = dice.whole(60, 400);
    const double step = turns * kTurn / std::abs(file.truth->omega2) / rows;
    for (int i = 0; i < rows; ++i) {
        file.instants.push_back(1e9 + std::round(i * step * 1e4) * 1e-4);
    }
    file.timeForm = {Rule::Decimals, 4};
    file.columns = plottedColumns();
    finish(file, dice, [truth = *file.truth](double t) { return manyDigits(truth, std::round(t * 1e4) / 1e4); });
    return file;
}

/// One of the study's, as it is sampled there. Where nothing moves or nothing is assembled there is no mechanism in it.
ClaimFile caseOfTheStudy(Dice &dice)
{
    const std::span<const Case> cases = hardCases();
    const Case &which = cases[static_cast<std::size_t>(dice.number()) % cases.size()];
    ClaimFile file;
    file.truth = which.parameters;
    file.instants = which.sampling.instants();
    file.timeForm = {Rule::Digits, 17};
    file.columns = plottedColumns();
    file.mayBeMissed = true;
    finish(file, dice, [truth = which.parameters](double t) {
        const ExactState<Digits100> state = exactState<Digits100>(truth, t);
        AllChannels all;
        for (std::size_t k = 0; k < kChannelCount; ++k) {
            const Channel channel = channelAt(k);
            const bool exists = state.status == Status::Solved ||
                                (state.status == Status::Singular && channel.order == Order::Position);
            all[k] = exists ? toFileUnit(channel, static_cast<double>(state.values[k])) : kNone;
        }
        return all;
    });
    return file;
}

// No slider-crank.

/// Position and derivatives along x of a pin driven otherwise.
struct Along {
    long double x = 0.0L, v = 0.0L, a = 0.0L;
};

template <class Law>
ClaimFile ofNoMechanism(Dice &dice, std::vector<ClaimColumn> columns, Law law)
{
    ClaimFile file;
    file.atHand.omega2 = dice.logUniform(0.5, 100.0); // which sets the pace
    setInstants(file, dice);
    file.columns = std::move(columns);
    const double w = file.atHand.omega2;
    file.atHand = Parameters();
    const double size = dice.logUniform(5.0, 100.0);
    const double phase = dice.uniform(0.0, kTurn);
    const double middle = size * dice.uniform(0.0, 6.0);
    for (ClaimColumn &each : file.columns) {
        each.noise *= size * std::pow(w, static_cast<int>(each.shown.order));
    }
    finish(file, dice, [=](double t) {
        const Along along = law(static_cast<long double>(w) * t + phase);
        AllChannels all{};
        all[indexOf(kX)] = middle + size * along.x;
        all[indexOf(kV)] = size * w * along.v;
        all[indexOf(kA)] = size * w * w * along.a;
        all[indexOf(kCrank)] = (static_cast<long double>(w) * t + phase) * kDegreesPerRadian;
        return all;
    });
    return file;
}

/// A Scotch yoke, with so much of the third harmonic.
auto yoke(double third)
{
    return [third](long double angle) {
        return Along{std::cos(angle) + third * std::cos(3.0L * angle),
                     -std::sin(angle) - 3.0L * third * std::sin(3.0L * angle),
                     -std::cos(angle) - 9.0L * third * std::cos(3.0L * angle)};
    };
}

ClaimFile scotchYoke(Dice &dice)
{
    std::vector<ClaimColumn> columns = plottedColumns({}, dice.chance(0.5) ? kSliderFamily : 0x02);
    if (dice.chance(0.5)) {
        columns.push_back(column(kCrank));
    }
    return ofNoMechanism(dice, std::move(columns), yoke(0.0));
}

ClaimFile yokeWithThird(Dice &dice)
{
    return ofNoMechanism(dice, plottedColumns({}, kSliderFamily), yoke(dice.logUniform(0.003, 0.03)));
}

ClaimFile yokeWithMuchOfIt(Dice &dice)
{
    return ofNoMechanism(dice, plottedColumns({}, kSliderFamily), yoke(dice.uniform(0.05, 0.2)));
}

ClaimFile noisyYoke(Dice &dice)
{
    std::vector<ClaimColumn> columns = plottedColumns({Rule::Digits, 7}, kSliderFamily);
    for (ClaimColumn &each : columns) {
        each.noise = 0.01;
    }
    return ofNoMechanism(dice, std::move(columns), yoke(0.08));
}

ClaimFile yokeAlone(Dice &dice)
{
    return ofNoMechanism(dice, {column(kX)}, yoke(0.02));
}

ClaimFile dampedOscillation(Dice &dice)
{
    const long double damping = 0.08L;
    const unsigned mask = dice.chance(0.5) ? kSliderFamily : 0x02;
    return ofNoMechanism(dice, plottedColumns({}, mask), [=](long double angle) {
        const long double size = std::exp(-damping * angle);
        const long double cosine = std::cos(angle);
        const long double sine = std::sin(angle);
        return Along{size * cosine, size * (-damping * cosine - sine),
                     size * ((damping * damping - 1.0L) * cosine + 2.0L * damping * sine)};
    });
}

/// A slider-crank whose crank does not turn evenly: no constant ω2 made it.
template <class Law>
ClaimFile uneven(Dice &dice, std::vector<ClaimColumn> columns, Law law)
{
    ClaimFile file;
    const Parameters p = anyMechanism(dice);
    file.truth = p;
    setInstants(file, dice, dice.uniform(0.8, 3.0), dice.whole(60, 400));
    file.truth = std::nullopt;
    file.columns = std::move(columns);
    if (std::ranges::count(file.columns, kCrank, &ClaimColumn::named) > 0) {
        const auto speedAt = [&](double t) {
            return static_cast<double>(law(static_cast<long double>(p.omega2) * t, p.omega2).v);
        };
        file.crankSpeeds = {speedAt(file.instants.front()), speedAt(file.instants.back())};
    }
    finish(file, dice, [p, law](double t) {
        const Along crank = law(static_cast<long double>(p.omega2) * t, p.omega2); // angle, speed, acceleration
        return linkageAt(p, p.theta20 + crank.x, crank.v, crank.a);
    });
    return file;
}

/// Faster by so much from turn to turn.
auto ramp(double part)
{
    return [part](long double angle, double w) {
        const long double growth = part / kTurn;
        const long double all = std::abs(angle);
        return Along{angle * (1.0L + 0.5L * growth * all), w * (1.0L + growth * all), growth * w * std::abs(w)};
    };
}

auto swing(double part, double times)
{
    return [=](long double angle, double w) {
        return Along{angle + part / times * (1.0L - std::cos(times * angle)),
                     w * (1.0L + part * std::sin(times * angle)), part * times * w * w * std::cos(times * angle)};
    };
}

std::vector<ClaimColumn> withCrank(std::vector<ClaimColumn> columns)
{
    columns.push_back(column(kCrank));
    return columns;
}

ClaimFile crankSpeedsUp(Dice &dice)
{
    return uneven(dice, plottedColumns(), ramp(dice.uniform(0.01, 0.03)));
}

ClaimFile crankSpeedsUpWithAngle(Dice &dice)
{
    return uneven(dice, withCrank(plottedColumns()), ramp(dice.uniform(0.01, 0.3)));
}

ClaimFile smallSpeedSwing(Dice &dice)
{
    const double times = dice.whole(1, 3);
    return uneven(dice, plottedColumns(), swing(0.02, times));
}

ClaimFile largeSpeedSwing(Dice &dice)
{
    const double times = dice.whole(1, 3);
    return uneven(dice, dice.chance(0.5) ? plottedColumns() : withCrank(plottedColumns()), swing(0.2, times));
}

ClaimFile randomNumbers(Dice &dice, std::vector<ClaimColumn> columns, int rows)
{
    ClaimFile file;
    setInstants(file, dice, dice.uniform(0.6, 3.0), rows);
    for (ClaimColumn &each : columns) {
        for (int i = 0; i < rows; ++i) {
            each.values.push_back(dice.uniform(-100.0, 100.0));
        }
    }
    file.columns = std::move(columns);
    finish(file, dice, [](double) { return AllChannels{}; });
    return file;
}

ClaimFile fewRandomValues(Dice &dice)
{
    return randomNumbers(dice, {column(kX)}, dice.whole(5, 12));
}

ClaimFile sixtyRandomRows(Dice &dice)
{
    return randomNumbers(dice, plottedColumns({}, dice.chance(0.5) ? 0x3F : 0x02), 60);
}

ClaimFile fewRandomRowsOfSix(Dice &dice)
{
    return randomNumbers(dice, plottedColumns(), dice.whole(1, 4));
}

/// Whole numbers that a person may have typed: 70, 40.
ClaimFile twoRoundRows(Dice &dice)
{
    ClaimFile file = randomNumbers(dice, {column(kX)}, 2);
    for (double &value : file.columns[0].values) {
        value = 10.0 * dice.whole(1, 12);
    }
    finish(file, dice, [](double) { return AllChannels{}; });
    return file;
}

/// A slider on a line that is not level: R4_y varies with R4_x.
ClaimFile slopingLine(Dice &dice)
{
    const Parameters p = anyMechanism(dice);
    ClaimFile file;
    file.truth = p;
    setInstants(file, dice);
    const double slope = dice.uniform(0.05, 0.6) * dice.sign();
    file.columns = {column(kX), column(kY)};
    if (dice.chance(0.5)) {
        file.columns.push_back(column(kTheta));
    }
    file.truth = std::nullopt;
    finish(file, dice, [p, slope](double t) {
        AllChannels turned = motionAt(p, t);
        const long double x = turned[indexOf(kX)];
        const long double y = turned[indexOf(kY)];
        turned[indexOf(kX)] = x * std::cos(slope) - y * std::sin(slope);
        turned[indexOf(kY)] = x * std::sin(slope) + y * std::cos(slope);
        turned[indexOf(kTheta)] += slope * kDegreesPerRadian;
        return turned;
    });
    return file;
}

ClaimFile nothingMoves(Dice &dice)
{
    ClaimFile file = randomNumbers(dice, plottedColumns({}, 0x03), 60);
    for (ClaimColumn &each : file.columns) {
        each.values.assign(each.values.size(), each.values.front());
    }
    finish(file, dice, [](double) { return AllChannels{}; });
    return file;
}

} // namespace

std::span<const ClaimKind> hardKinds()
{
    static constexpr std::array kKinds{
        ClaimKind{"near a toggle", nearAToggle},
        ClaimKind{"at a toggle", atAToggle},
        ClaimKind{"rocker with gaps", rockerWithGaps},
        ClaimKind{"rocker between its limits", rockerBetweenLimits},
        ClaimKind{"crossed", crossedAssembly},
        ClaimKind{"c = 0", centred},
        ClaimKind{"a << b", shortCrank},
        ClaimKind{"c >> a", farOffset},
        ClaimKind{"a = b", equalLengths},
        ClaimKind{"t near 1e9 s", farClock},
        ClaimKind{"hard cases of the study", caseOfTheStudy, 62},
    };
    return kKinds;
}

std::span<const ClaimKind> otherMotionKinds()
{
    static constexpr std::array kKinds{
        ClaimKind{"scotch yoke", scotchYoke},
        ClaimKind{"yoke, 0.3 to 3 % third harmonic", yokeWithThird},
        ClaimKind{"yoke, 5 to 20 % third harmonic", yokeWithMuchOfIt},
        ClaimKind{"yoke, 8 % and noise", noisyYoke},
        ClaimKind{"yoke, 2 %, R4_x alone", yokeAlone},
        ClaimKind{"damped oscillation", dampedOscillation},
        ClaimKind{"crank speeds up", crankSpeedsUp},
        ClaimKind{"crank speeds up, with theta2", crankSpeedsUpWithAngle},
        ClaimKind{"speed swings by 2 %", smallSpeedSwing},
        ClaimKind{"speed swings by 20 %", largeSpeedSwing},
        ClaimKind{"5 to 12 random values", fewRandomValues},
        ClaimKind{"60 random rows", sixtyRandomRows},
        ClaimKind{"1 to 4 random rows of six", fewRandomRowsOfSix},
        ClaimKind{"two round rows", twoRoundRows},
        ClaimKind{"a sloping line", slopingLine},
        ClaimKind{"nothing moves", nothingMoves},
    };
    return kKinds;
}

} // namespace slidercrank
