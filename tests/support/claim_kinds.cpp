// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of files whose headings are correct: ordinary mechanisms, mechanisms at their limits, and motions of other
// mechanisms.
#include "tests/support/claim_file.h"

#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "core/study/exact_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Rule = NumberForm::Rule;

/// Number format for noisy columns, with a rounding step far below the noise.
const NumberForm kNoisyForm = digits(7);

void add(ClaimFile &f, double turns, int rows, const Channels &channels, NumberForm form = {})
{
    f.add(channels, form);
    f.sample(turns, rows);
}

void addNoisy(ClaimFile &f, double turns, int rows, const Channels &channels, double noise)
{
    add(f, turns, rows, channels, kNoisyForm);
    f.setNoise(noise);
}

Channels sixOr(ClaimFile &f, Channels channels)
{
    return f.random.chance(0.5) ? kSix : std::move(channels);
}

void addFewRowsATurn(ClaimFile &f, double least, const Channels &channels)
{
    const int rows = f.random.whole(30, 120);
    add(f, rows / f.random.uniform(least, 1.9), rows, channels);
}

/// Writes sensors whose drift is correlated over about twenty rows, so that standard errors would be wrong.
void addDriftingNoise(ClaimFile &f)
{
    constexpr double kMemory = 0.95;
    f.add({kX, kTheta}, kNoisyForm);
    f.mayBeMissed = f.mayBeApproximate = true;
    for (ClaimColumn &column : f.columns) {
        const double size = 0.01 * f.swing(column.shown);
        double drift = size * f.random.normal();
        for (const double t : f.instants) {
            column.values.push_back(f.exactValue(column.shown, t) + drift);
            drift = kMemory * drift + std::sqrt(1.0 - kMemory * kMemory) * size * f.random.normal();
        }
        column.content = ClaimColumn::Content::Systematic;
    }
}

/// Samples at 30 frames per second. The time has four decimals.
void addFrames(ClaimFile &f)
{
    f.truth->omega2 = f.random.logUniform(0.5, 15.0) * f.random.sign();
    const double seconds = f.random.uniform(0.6, 3.0) * kTurn / std::abs(f.truth->omega2);
    for (int i = 0; i < std::clamp(static_cast<int>(seconds * 30.0), 20, 400); ++i) {
        f.instants.push_back(i / 30.0);
    }
    f.timeForm = decimals(4);
    f.timeStep = 1e-4;
    f.add(sixOr(f, kSlider));
}

void addGaps(ClaimFile &f)
{
    f.add(sixOr(f, {kTheta, kX, kV}));
    f.sample();
    std::erase_if(f.instants, [&](double t) { return t != f.instants.back() && f.random.chance(0.1); });
    f.compute();
    for (ClaimColumn &column : f.columns) {
        std::ranges::for_each(column.values, [&](double &value) { value = f.random.chance(0.15) ? kNone : value; });
    }
}

void addThetaInEveryTenthRow(ClaimFile &f)
{
    f.add({kX, kTheta});
    f.compute();
    for (std::size_t row = 0; row < f.instants.size(); ++row) {
        f.at(kTheta).values[row] = row % 10 == 0 ? f.at(kTheta).values[row] : kNone;
    }
}

/// Uses a crank angle in whole degrees, an integer offset and a constant speed.
void addWholeNumbers(ClaimFile &f)
{
    f.truth->c = std::round(f.truth->c);
    f.truth->b = std::max(f.truth->b, f.truth->a + std::abs(f.truth->c) + 1.0);
    f.truth->omega2 = 300.0 / kDegreesPerRadian * f.random.sign(); // three degrees in 0.01 s
    f.truth->theta20 = f.random.whole(-170, 170) / kDegreesPerRadian;
    for (int i = 0, rows = f.random.whole(80, 300); i < rows; ++i) {
        f.instants.push_back(i / 100.0);
    }
    f.add({kCrank, kCrankSpeed, kX, kTheta, kY});
}

Channels centre(Coordinate x, Coordinate y)
{
    return {{x, Order::Position}, {y, Order::Position}, {x, Order::Velocity}, {y, Order::Velocity}};
}

/// Scales all lengths to another unit. The file cannot be distinguished from one of a mechanism of another size.
void addLengthsInAnotherUnit(ClaimFile &f)
{
    const double unit = f.random.pick({1e-3, 0.1, 1.0 / 25.4});
    for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
        valueOf(*f.truth, length) *= unit;
    }
    f.add(sixOr(f, {kX}));
}

// Limits.

/// Computes the pose in multiple precision, because the textbook's formulas suffer from cancellation near a toggle.
template <class Real>
Pose manyDigits(const Parameters &parameters, double t, double zero)
{
    const ExactState<Real> state = exactState<Real>(parameters, t);
    Pose pose;
    for (std::size_t k = 0; k < kChannelCount; ++k) {
        const Channel channel = channelAt(k);
        const bool exists =
            state.status == Status::Solved || (state.status == Status::Singular && channel.order == Order::Position);
        const double value = static_cast<double>(state.values[k]);
        const bool isZero = std::abs(value) <= zero * naturalSize(parameters, channel);
        pose[k] = exists ? toFileUnit(channel, isZero ? 0.0 : value) : kNone;
    }
    return pose;
}

void addExact(ClaimFile &f)
{
    f.motion = [truth = *f.truth](double t) { return manyDigits<Digits50>(truth, t, kExactZero); };
    f.mayBeMissed = true; // a few rows dominate the fit
    f.add(kSix);
}

/// Includes rows at the toggle, where the last digit of a length changes the first digit of an acceleration.
void addToggle(ClaimFile &f)
{
    Parameters &p = *f.truth;
    p.b = (p.a + std::abs(p.c)) * (1.0 + f.random.logUniform(1e-14, 1e-9));
    p.theta20 = p.c > 0.0 ? -kQuarterTurn : kQuarterTurn;
    addExact(f);
}

void makeRocker(ClaimFile &f)
{
    Parameters &p = *f.truth;
    p.c = p.a * f.random.uniform(0.1, 1.2) * f.random.sign();
    p.b = (p.a + std::abs(p.c)) * f.random.uniform(0.75, 0.98);
}

/// Turns a rocker's crank beyond its limits. Rows that cannot be assembled are omitted or have empty cells.
void addRockerWithGaps(ClaimFile &f)
{
    makeRocker(f);
    f.mayBeMissed = true;
    f.keepsEmptyRows = f.random.chance(0.5);
    f.add(kSix);
}

void addRockerBetweenLimits(ClaimFile &f)
{
    makeRocker(f);
    f.truth->theta20 = std::copysign(kQuarterTurn, f.truth->c) - std::copysign(0.9, f.truth->omega2);
    add(f, 1.8 / kTurn, f.random.whole(60, 400), kSix);
}

/// Uses a = b: a rocker if it has an offset; otherwise the mechanism passes through its change points.
void addEqualLengths(ClaimFile &f)
{
    f.truth->b = f.truth->a;
    f.truth->c = f.random.chance(0.5) ? 0.0 : f.truth->a * f.random.uniform(-0.3, 0.3);
    addExact(f);
}

void addLateClock(ClaimFile &f)
{
    f.truth->omega2 = f.random.uniform(1.0, 10.0) * f.random.sign();
    const double turns = f.random.uniform(0.6, 3.0);
    const int rows = f.random.whole(60, 400);
    for (int i = 0; i < rows; ++i) {
        f.instants.push_back(1e9 + std::round(i * turns * kTurn / std::abs(f.truth->omega2) / rows * 1e4) * 1e-4);
    }
    f.timeForm = decimals(4);
    f.motion = [truth = *f.truth](double t) {
        return manyDigits<Digits50>(truth, std::round(t * 1e4) / 1e4, kExactZero);
    };
    f.add(kSix);
}

/// Uses one of the hard cases. Some of them do not move or cannot be assembled.
void addCaseOfTheStudy(ClaimFile &f)
{
    const std::span<const Case> cases = hardCases();
    const Case &hardCase = cases[static_cast<std::size_t>(f.number * 11) % cases.size()];
    f.truth = hardCase.parameters;
    f.instants = hardCase.sampling.timeStamps();
    f.timeForm = digits(17);
    f.motion = [truth = *f.truth](double t) { return manyDigits<Digits100>(truth, t, 0.0); };
    f.mayBeMissed = true;
    f.add(kSix);
}

// Motions of other mechanisms.

/// Position and derivatives of a pin or a crank, as functions of the angle of a crank with constant speed.
using Law = std::function<std::array<long double, 3>(long double angle)>;

void addOtherMotion(ClaimFile &f, const Channels &channels, const Law &law, double noise = 0.0)
{
    f.add(channels, noise > 0.0 ? kNoisyForm : NumberForm());
    f.truth->omega2 = f.random.logUniform(0.5, 100.0);
    f.sample();
    const double w = f.truth->omega2;
    f.truth = std::nullopt;
    const double size = f.random.logUniform(5.0, 100.0);
    const double phase = f.random.uniform(0.0, kTurn);
    const double middle = size * f.random.uniform(0.0, 6.0);
    for (ClaimColumn &column : f.columns) {
        column.noise = noise * size * std::pow(w, static_cast<int>(column.shown.order));
    }
    f.motion = [=](double t) {
        const auto [x, v, a] = law(static_cast<long double>(w) * t + phase);
        Pose pose{};
        pose[indexOf(kX)] = middle + size * x;
        pose[indexOf(kV)] = size * w * v;
        pose[indexOf(kA)] = size * w * w * a;
        pose[indexOf(kCrank)] = (static_cast<long double>(w) * t + phase) * kDegreesPerRadian;
        return pose;
    };
}

/// Returns the motion of a Scotch yoke with the given amplitude of the third harmonic.
Law yoke(double third)
{
    return [third](long double angle) {
        return std::array{std::cos(angle) + third * std::cos(3.0L * angle),
                          -std::sin(angle) - 3.0L * third * std::sin(3.0L * angle),
                          -std::cos(angle) - 9.0L * third * std::cos(3.0L * angle)};
    };
}

Law dampedOscillation()
{
    return [damping = 0.08L](long double angle) {
        const long double size = std::exp(-damping * angle);
        return std::array{size * std::cos(angle), size * (-damping * std::cos(angle) - std::sin(angle)),
                          size * ((damping * damping - 1.0L) * std::cos(angle) + 2.0L * damping * std::sin(angle))};
    };
}

/// Writes a slider-crank whose crank speed is not constant.
void addUneven(ClaimFile &f, Channels channels, bool withCrank, const Law &law)
{
    if (withCrank) {
        channels.push_back(kCrank);
    }
    f.add(channels);
    f.sample(f.random.uniform(0.8, 3.0), f.random.whole(60, 400));
    f.motion = [p = *f.truth, law](double t) {
        const auto [angle, speed, acceleration] = law(std::abs(p.omega2) * static_cast<long double>(t));
        const double sense = std::copysign(1.0, p.omega2);
        return poseAt(p, p.theta20 + sense * angle, p.omega2 * speed, sense * p.omega2 * p.omega2 * acceleration);
    };
    f.truth = std::nullopt;
    if (withCrank) {
        f.crankSpeeds = {f.exactValue(kCrankSpeed, f.instants.front()) / kDegreesPerRadian,
                         f.exactValue(kCrankSpeed, f.instants.back()) / kDegreesPerRadian};
    }
}

/// Returns a crank motion whose speed grows by `part` per turn.
Law ramp(double part)
{
    return [growth = part / kTurn](long double angle) {
        return std::array{angle * (1.0L + 0.5L * growth * angle), 1.0L + growth * angle,
                          static_cast<long double>(growth)};
    };
}

/// Returns a crank motion whose speed oscillates with the amplitude `part`, `times` per turn.
Law ripple(double part, double times)
{
    return [=](long double angle) {
        return std::array{angle + part / times * (1.0L - std::cos(times * angle)),
                          1.0L + part * std::sin(times * angle), part * times * std::cos(times * angle)};
    };
}

void addRandomNumbers(ClaimFile &f, const Channels &channels, int rows)
{
    add(f, f.random.uniform(0.6, 3.0), rows, channels);
    f.truth = std::nullopt;
    for (ClaimColumn &column : f.columns) {
        for (int i = 0; i < rows; ++i) {
            column.values.push_back(f.random.uniform(-100.0, 100.0));
        }
    }
}

/// Tilts the slider's line, so that R4_y varies with R4_x.
void addSlopingLine(ClaimFile &f)
{
    f.add(f.random.chance(0.5) ? Channels{kX, kY} : Channels{kX, kY, kTheta});
    f.sample();
    const double slope = f.random.uniform(0.05, 0.6) * f.random.sign();
    f.motion = [p = *f.truth, slope](double t) {
        Pose pose = motionAt(p, t);
        const long double x = pose[indexOf(kX)];
        const long double y = pose[indexOf(kY)];
        pose[indexOf(kX)] = x * std::cos(slope) - y * std::sin(slope);
        pose[indexOf(kY)] = x * std::sin(slope) + y * std::cos(slope);
        pose[indexOf(kTheta)] += slope * kDegreesPerRadian;
        return pose;
    };
    f.truth = std::nullopt;
}

void addTwoRoundRows(ClaimFile &f)
{
    addRandomNumbers(f, {kX}, 2);
    for (double &value : f.columns[0].values) {
        value = 10.0 * f.random.whole(1, 12);
    }
}

void addNothingThatMoves(ClaimFile &f)
{
    addRandomNumbers(f, {kX, kTheta}, 60);
    for (ClaimColumn &column : f.columns) {
        column.values.assign(column.values.size(), column.values.front());
    }
}

Channels someOfSix(int mask)
{
    Channels channels;
    std::ranges::copy_if(kSix, std::back_inserter(channels),
                         [mask, k = 0](Channel) mutable { return (mask >> k++ & 1) != 0; });
    return channels;
}

const ClaimKind kPlainKinds[] = {
    {"six columns",
     [](ClaimFile &f) {
         f.add(kSix, {f.random.chance(0.5) ? Rule::DigitsInDecimals : Rule::Digits, 6});
     }},
    {"some of the six columns", [](ClaimFile &f) { f.add(someOfSix(1 + f.number * 11 % 63)); }},
    {"theta2, R4_x, R4_x_diff, R4_y",
     [](ClaimFile &f) {
         f.add({kCrank, kX, kV, kY});
     }},
    {"theta2, R4_x",
     [](ClaimFile &f) {
         f.add({kCrank, kX});
     }},
    {"R4_x with two decimals", [](ClaimFile &f) { f.add(kX, decimals(2)); }},
    {"six columns of nine digits", [](ClaimFile &f) { f.add(kSix, digits(9)); }},
    {"theta2 in whole degrees, R4_x to 0.1 mm",
     [](ClaimFile &f) {
         f.add(kCrank, decimals(0));
         f.add(kX, decimals(1));
     }},
    {"R4_x in whole mm", [](ClaimFile &f) { add(f, f.random.uniform(0.6, 3.0), 60, {kX}, decimals(0)); }},
    {"noise of R4_x and theta3",
     [](ClaimFile &f) {
         const double noise = f.random.logUniform(0.001, 0.01) * f.truth->a;
         f.add(kX, kNoisyForm).noise = noise;
         f.add(kTheta, kNoisyForm).noise = noise / f.truth->b * kDegreesPerRadian;
     }},
    {"noise of six columns",
     [](ClaimFile &f) {
         f.add(kSix, kNoisyForm);
         f.setNoise(f.random.logUniform(0.001, 0.02));
     }},
    {"noise of theta2 and R4_x",
     [](ClaimFile &f) {
         f.add(kCrank, kNoisyForm).noise = f.random.logUniform(0.05, 1.0);
         f.add(kX, kNoisyForm).noise = f.random.logUniform(0.001, 0.01) * f.truth->a;
     }},
    {"noise of R4_x alone",
     [](ClaimFile &f) { addNoisy(f, f.random.uniform(0.4, 2.0), f.random.whole(60, 400), {kX}, 0.003); }},
    {"noise, 0.1 to 0.6 turns",
     [](ClaimFile &f) { addNoisy(f, f.random.uniform(0.1, 0.6), f.random.whole(60, 400), kSix, 0.005); }},
    {"noise, a quarter turn of theta3",
     [](ClaimFile &f) { addNoisy(f, 0.25, f.random.whole(60, 200), {kTheta}, 0.005); }},
    {"drifting noise", addDriftingNoise},
    {"instants with four decimals", addFrames},
    {"17 digits of six",
     [](ClaimFile &f) {
         f.add(kSix, {Rule::Digits, 6, true});
     }},
    {"1.3 to 1.9 rows a turn, six columns", [](ClaimFile &f) { addFewRowsATurn(f, 1.3, kSix); }},
    {"1.3 to 1.9 rows a turn, R4_x and R4_x_diff",
     [](ClaimFile &f) {
         addFewRowsATurn(f, 1.3, {kX, kV});
     }},
    // At 1.34 rows a turn, another speed fits the same samples with 3.94 rows a turn; a true 1.1 looks like 11.
    {"1.3 to 1.9 rows a turn, R4_x alone", [](ClaimFile &f) { addFewRowsATurn(f, 1.35, {kX}); }},
    {"two to four values",
     [](ClaimFile &f) {
         add(f, f.random.uniform(0.3, 1.5), f.random.whole(2, 4), {kX});
         f.hasTooFewValues = true;
     }},
    {"five values",
     [](ClaimFile &f) {
         add(f, f.random.uniform(0.3, 1.5), 5, {kX});
         f.hasTooFewValues = true;
     }},
    {"4 to 14 rows of R4_x", [](ClaimFile &f) { add(f, f.random.uniform(0.6, 1.5), f.random.whole(4, 14), {kX}); }},
    {"2 to 8 rows of six columns",
     [](ClaimFile &f) { add(f, f.random.uniform(0.6, 1.5), f.random.whole(2, 8), kSix); }},
    {"a tenth of a turn",
     [](ClaimFile &f) { add(f, 0.1, f.random.whole(60, 200), someOfSix(f.random.whole(1, 3)), decimals(4)); }},
    {"10 to 25 turns", [](ClaimFile &f) { add(f, f.random.uniform(10.0, 25.0), f.random.whole(200, 500), kSix); }},
    {"b = 1.02 (a + |c|)",
     [](ClaimFile &f) {
         f.truth->b = 1.02 * (f.truth->a + std::abs(f.truth->c));
         f.add(kSix);
     }},
    {"b = 8 a",
     [](ClaimFile &f) {
         f.truth->b = 8.0 * f.truth->a;
         f.add(kSix);
     }},
    {"gaps and missing rows", addGaps},
    {"theta3 in every tenth row", addThetaInEveryTenthRow},
    {"constants and whole numbers", addWholeNumbers},
    {"clock from 5 s",
     [](ClaimFile &f) {
         f.sample(f.random.uniform(0.6, 3.0), f.random.whole(60, 400), 5.0);
         f.add(kSix);
     }},
    {"R3 alone",
     [](ClaimFile &f) {
         f.add(centre(R3x, R3y));
         f.mayBeMissed = true; // none of the six plotted channels
     }},
    {"R2 alone", [](ClaimFile &f) { f.add(centre(R2x, R2y)); }},
    {"R3 beside six columns",
     [](ClaimFile &f) {
         f.add(kSix);
         f.add(centre(R3x, R3y));
     }},
    {"R2 beside R4_x",
     [](ClaimFile &f) {
         f.add(kX);
         f.add(centre(R2x, R2y));
     }},
    {"all lengths in another unit", addLengthsInAnotherUnit},
    {"clock in ms, positions", // another mechanism fits equally well
     [](ClaimFile &f) {
         f.truth->omega2 *= 1e-3;
         f.add({kX, kTheta});
     }},
};

const ClaimKind kLimitKinds[] = {
    {"near a toggle",
     [](ClaimFile &f) {
         f.truth->b = (f.truth->a + std::abs(f.truth->c)) * (1.0 + f.random.logUniform(1e-12, 1e-3));
         addExact(f);
     }},
    {"at a toggle", addToggle},
    {"rocker with gaps", addRockerWithGaps},
    {"rocker between its limits", addRockerBetweenLimits},
    {"crossed",
     [](ClaimFile &f) {
         f.truth->branch = Branch::Crossed;
         f.add(sixOr(f, kSlider));
     }},
    {"c = 0",
     [](ClaimFile &f) {
         f.truth->c = 0.0;
         f.add(sixOr(f, kSlider));
     }},
    {"a << b",
     [](ClaimFile &f) {
         f.truth->b = f.truth->a * f.random.logUniform(1e2, 1e9);
         f.add(f.random.pick({kSix, kSlider, Channels{kX}}));
     }},
    {"c >> a",
     [](ClaimFile &f) {
         f.truth->c = f.truth->a * f.random.logUniform(5.0, 5e4) * f.random.sign();
         f.truth->b = (f.truth->a + std::abs(f.truth->c)) * f.random.uniform(1.02, 1.5);
         f.add(kSix);
     }},
    {"a = b", addEqualLengths},
    {"t near 1e9 s", addLateClock},
    {"hard cases of the study", addCaseOfTheStudy},
};

const ClaimKind kOtherMotionKinds[] = {
    {"scotch yoke",
     [](ClaimFile &f) {
         Channels channels = f.random.chance(0.5) ? kSlider : Channels{kX};
         if (f.random.chance(0.5)) {
             channels.push_back(kCrank);
         }
         addOtherMotion(f, channels, yoke(0.0));
     }},
    {"yoke, 0.3 to 3 % third harmonic",
     [](ClaimFile &f) { addOtherMotion(f, kSlider, yoke(f.random.logUniform(0.003, 0.03))); }},
    {"yoke, 5 to 20 % third harmonic",
     [](ClaimFile &f) { addOtherMotion(f, kSlider, yoke(f.random.uniform(0.05, 0.2))); }},
    {"yoke, 8 % and noise", [](ClaimFile &f) { addOtherMotion(f, kSlider, yoke(0.08), 0.01); }},
    {"yoke, 2 %, R4_x alone", [](ClaimFile &f) { addOtherMotion(f, {kX}, yoke(0.02)); }},
    {"damped oscillation",
     [](ClaimFile &f) { addOtherMotion(f, f.random.chance(0.5) ? kSlider : Channels{kX}, dampedOscillation()); }},
    {"crank speeds up", [](ClaimFile &f) { addUneven(f, kSix, false, ramp(f.random.uniform(0.01, 0.03))); }},
    {"crank speeds up, with theta2", [](ClaimFile &f) { addUneven(f, kSix, true, ramp(f.random.uniform(0.01, 0.3))); }},
    {"speed swings by 2 %", [](ClaimFile &f) { addUneven(f, kSix, false, ripple(0.02, f.random.whole(1, 3))); }},
    {"speed swings by 20 %",
     [](ClaimFile &f) { addUneven(f, kSix, f.random.chance(0.5), ripple(0.2, f.random.whole(1, 3))); }},
    {"5 to 12 random values", [](ClaimFile &f) { addRandomNumbers(f, {kX}, f.random.whole(5, 12)); }},
    {"60 random rows", [](ClaimFile &f) { addRandomNumbers(f, sixOr(f, {kX}), 60); }},
    {"1 to 4 random rows of six", [](ClaimFile &f) { addRandomNumbers(f, kSix, f.random.whole(1, 4)); }},
    {"two round rows", addTwoRoundRows},
    {"a sloping line", addSlopingLine},
    {"nothing moves", addNothingThatMoves},
};

} // namespace

std::span<const ClaimKind> plainKinds()
{
    return kPlainKinds;
}

std::span<const ClaimKind> limitKinds()
{
    return kLimitKinds;
}

std::span<const ClaimKind> otherMotionKinds()
{
    return kOtherMotionKinds;
}

} // namespace slidercrank
