// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a slider-crank that read otherwise than they say: other origins, units, signs, half turns, swapped columns;
// and such as can be told only with the mechanism at hand.
#include "core/mechanism/turn.h"
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
constexpr Channel kOmega{Theta3, Order::Velocity};
constexpr Channel kAlpha{Theta3, Order::Acceleration};
constexpr Channel kCrank{Theta2, Order::Position};
constexpr Channel kY{R4y, Order::Position};
constexpr unsigned kSix = 0x3F;
constexpr unsigned kSliderFamily = 0x2A;
constexpr unsigned kCouplerFamily = 0x15;

/// A random mechanism, its instants and columns; not yet printed.
ClaimFile begun(Dice &dice, std::vector<ClaimColumn> columns)
{
    ClaimFile file;
    file.truth = anyMechanism(dice);
    setInstants(file, dice);
    file.columns = std::move(columns);
    return file;
}

ClaimColumn &columnOf(ClaimFile &file, Channel channel)
{
    return *std::ranges::find(file.columns, channel, &ClaimColumn::named);
}

double valueAtStart(const ClaimFile &file, Channel channel)
{
    return static_cast<double>(motionAt(*file.truth, file.instants.front())[indexOf(channel)]);
}

void expect(ClaimFile &file, std::vector<ExpectedFinding> findings)
{
    file.readings.push_back({*file.truth, std::move(findings)});
}

/// Those columns are counted from elsewhere. What is next to nothing need not be named.
ClaimFile shifted(Dice &dice, ClaimFile file, std::vector<std::pair<Channel, double>> shifts)
{
    std::vector<ExpectedFinding> findings;
    std::vector<ExpectedFinding> named;
    for (const auto &[channel, shift] : shifts) {
        columnOf(file, channel).zero = shift;
        const double swing = channel == kY ? file.truth->a : swingOf(file, channel);
        if (std::abs(shift) > 5e-4 * swing) {
            findings.push_back({"zero-point", {channel}, -shift});
        }
        if (std::abs(shift) > 5e-3 * swing) {
            named.push_back({"zero-point", {channel}, -shift});
        }
    }
    expect(file, findings);
    if (named.size() != findings.size()) {
        expect(file, named);
    }
    finish(file, dice);
    return file;
}

double lengthShift(const ClaimFile &file, Dice &dice)
{
    return file.truth->a * dice.uniform(0.2, 9.0) * dice.sign();
}

/// Never as good as half a turn.
double angleShift(Dice &dice)
{
    return dice.uniform(5.0, 170.0) * dice.sign();
}

ClaimFile originOfSlider(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const double shift = lengthShift(file, dice);
    return shifted(dice, std::move(file), {{kX, shift}});
}

ClaimFile originOfHeight(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    file.columns.push_back(column(kY));
    const double shift = lengthShift(file, dice);
    return shifted(dice, std::move(file), {{kY, shift}});
}

ClaimFile originOfAngle(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    return shifted(dice, std::move(file), {{kTheta, angleShift(dice)}});
}

ClaimFile originsOfAll(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    file.columns.push_back(column(kY));
    const double x = lengthShift(file, dice);
    const double y = lengthShift(file, dice);
    return shifted(dice, std::move(file), {{kX, x}, {kY, y}, {kTheta, angleShift(dice)}});
}

ClaimFile sliderFromStart(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns({}, kSliderFamily));
    const double from = valueAtStart(file, kX);
    return shifted(dice, std::move(file), {{kX, -from}});
}

ClaimFile sixFromStart(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const double from = valueAtStart(file, kX);
    const double angle = valueAtStart(file, kTheta);
    return shifted(dice, std::move(file), {{kX, -from}, {kTheta, -angle}});
}

ClaimFile angleFromStart(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const double from = valueAtStart(file, kTheta);
    return shifted(dice, std::move(file), {{kTheta, -from}});
}

ClaimFile sliderAloneFromStart(Dice &dice)
{
    ClaimFile file = begun(dice, {column(kX, {Rule::Digits, 9})});
    const double from = valueAtStart(file, kX);
    return shifted(dice, std::move(file), {{kX, -from}});
}

ClaimFile couplerTurned(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns({}, kCouplerFamily));
    return shifted(dice, std::move(file), {{kTheta, 40.0}});
}

ClaimFile noiseAndOrigin(Dice &dice)
{
    ClaimFile file = begun(dice, {column(kX, {Rule::Digits, 7})});
    columnOf(file, kX).noise = 0.003 * swingOf(file, kX);
    const double shift = lengthShift(file, dice);
    return shifted(dice, std::move(file), {{kX, shift}});
}

ClaimFile anglesInRadians(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    for (const Channel channel : {kTheta, kOmega, kAlpha}) {
        columnOf(file, channel).factor = 1.0 / kDegreesPerRadian;
    }
    expect(file, {{"angle-unit", {kTheta, kOmega, kAlpha}, kDegreesPerRadian}});
    finish(file, dice);
    return file;
}

ClaimFile oneAngleInRadians(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const Channel channel = std::array{kTheta, kOmega, kAlpha}[static_cast<std::size_t>(dice.whole(0, 2))];
    columnOf(file, channel).factor = 1.0 / kDegreesPerRadian;
    expect(file, {{"angle-unit", {channel}, kDegreesPerRadian}});
    finish(file, dice);
    return file;
}

/// One length has another unit, or the two others have: then it is another mechanism.
void expectLengthUnit(ClaimFile &file, Channel channel, double unit, const std::vector<ExpectedFinding> &more = {})
{
    std::vector<Channel> others;
    for (const Channel each : {kX, kV, kA}) {
        if (each != channel) {
            others.push_back(each);
        }
    }
    Parameters other = *file.truth;
    other.a /= unit;
    other.b /= unit;
    other.c /= unit;
    for (const auto &[truth, finding] : {TrueReading{*file.truth, {{"length-unit", {channel}, unit}}},
                                         TrueReading{other, {{"length-unit", others, 1.0 / unit}}}}) {
        file.readings.push_back({truth, finding});
        file.readings.back().findings.insert(file.readings.back().findings.end(), more.begin(), more.end());
    }
}

ClaimFile oneLengthInAnotherUnit(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const Channel channel = std::array{kX, kV, kA}[static_cast<std::size_t>(dice.whole(0, 2))];
    const double unit = std::array{10.0, 25.4, 1000.0}[static_cast<std::size_t>(dice.whole(0, 2))];
    columnOf(file, channel).factor = 1.0 / unit;
    expectLengthUnit(file, channel, unit);
    finish(file, dice);
    return file;
}

ClaimFile oneSign(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const Channel channel = kPlottedChannels[static_cast<std::size_t>(dice.whole(0, 5))];
    columnOf(file, channel).factor = -1.0;
    expect(file, {{"sign", {channel}, -1.0}});
    finish(file, dice);
    return file;
}

/// The slider's axis points the other way, the angles do not know of it: so it is, or the coupler's angle is seen from
/// its other end.
ClaimFile axisTheOtherWay(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    for (const Channel channel : {kX, kV, kA}) {
        columnOf(file, channel).factor = -1.0;
    }
    expect(file, {{"sign", {kX, kV, kA}, -1.0}});
    // x → -x and θ → θ + 180°: -c, θ20 + 180°, the other assembly.
    file.readings.push_back({mirrorImages(*file.truth)[7], {{"half-turn", {kTheta}}}});
    finish(file, dice);
    return file;
}

/// Angles count clockwise, heights upwards: so they do, or the height has the wrong sign.
ClaimFile clockwise(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    for (const Channel channel : {kTheta, kOmega, kAlpha}) {
        columnOf(file, channel).factor = -1.0;
    }
    file.columns.push_back(column(kY));
    expect(file, {{"sign", {kTheta, kOmega, kAlpha}, -1.0}});
    file.readings.push_back({mirrorImages(*file.truth)[2], {{"sign", {kY}, -1.0}}});
    constexpr double kSmall = 4.0; // a height of one digit does not tell its own sign
    if (std::abs(file.truth->c) < kSmall) {
        file.readings.push_back({mirrorImages(*file.truth)[2], {}});
    }
    finish(file, dice);
    return file;
}

ClaimFile halfTurn(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    columnOf(file, kTheta).zero = 180.0 * dice.sign();
    expect(file, {{"half-turn", {kTheta}}});
    finish(file, dice);
    return file;
}

/// The textbook's θ_3, within 0 … 360°.
ClaimFile halfTurnWithinATurn(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    ClaimColumn &angle = columnOf(file, kTheta);
    for (const double t : file.instants) {
        const auto value = static_cast<double>(motionAt(*file.truth, t)[indexOf(kTheta)]);
        angle.values.push_back(wrapToTwoPi((value + 180.0) / kDegreesPerRadian) * kDegreesPerRadian);
    }
    angle.zero = 180.0;
    expect(file, {{"half-turn", {kTheta}}});
    finish(file, dice);
    return file;
}

ClaimFile twoSwapped(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const int first = dice.whole(0, 5);
    const int second = (first + dice.whole(1, 5)) % 6;
    ClaimColumn &one = file.columns[static_cast<std::size_t>(first)];
    ClaimColumn &other = file.columns[static_cast<std::size_t>(second)];
    std::swap(one.shown, other.shown);
    expect(file, {{"swapped-columns", {one.named, other.named}}});
    finish(file, dice);
    return file;
}

/// Scaled, late, or another function altogether.
void ruin(ClaimFile &file, Dice &dice, ClaimColumn &which)
{
    const int how = dice.whole(0, 2);
    const double factor = dice.uniform(1.1, 1.8);
    const double late = dice.uniform(0.05, 0.4) * kTurn / file.truth->omega2;
    const double size = swingOf(file, which.shown);
    for (const double t : file.instants) {
        const auto value = static_cast<double>(motionAt(*file.truth, t)[indexOf(which.shown)]);
        const auto otherwise = static_cast<double>(motionAt(*file.truth, t - late)[indexOf(which.shown)]);
        which.values.push_back(how == 0   ? value * factor
                               : how == 1 ? otherwise
                                          : value + 0.2 * size * std::sin(2.7 * file.truth->omega2 * t));
    }
    which.isMotion = false;
}

ClaimFile oneNoDerivative(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    ClaimColumn &which = file.columns[static_cast<std::size_t>(dice.whole(2, 5))];
    ruin(file, dice, which);
    expect(file, {{"not-derivative", {which.named}}});
    finish(file, dice);
    return file;
}

/// Derivatives as a spreadsheet makes them, from 80 rows a turn on: less than one part in a hundred off.
ClaimFile centralDifferences(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    const double turns = dice.uniform(0.6, 3.0);
    setInstants(file, dice, turns, static_cast<int>(turns * dice.uniform(80.0, 130.0)) + 10);
    const double step = file.instants[1] - file.instants[0];
    for (ClaimColumn &each : file.columns) {
        if (each.shown.order == Order::Position) {
            continue;
        }
        for (const double t : file.instants) {
            const std::size_t k = indexOf({each.shown.coordinate, Order::Position});
            const long double before = motionAt(*file.truth, t - step)[k];
            const long double here = motionAt(*file.truth, t)[k];
            const long double after = motionAt(*file.truth, t + step)[k];
            const bool first = each.shown.order == Order::Velocity;
            each.values.push_back(static_cast<double>(first ? (after - before) / (2.0 * step)
                                                            : (after - 2.0 * here + before) / (step * step)));
        }
        each.isMotion = false;
    }
    expect(file, {});
    finish(file, dice);
    return file;
}

ClaimFile twoFaults(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    ClaimColumn &x = columnOf(file, kX);
    std::vector<ExpectedFinding> findings;
    switch (dice.whole(0, 3)) {
    case 0:
        x.zero = lengthShift(file, dice);
        findings = {{"zero-point", {kX}, -x.zero}, {"angle-unit", {kTheta, kOmega, kAlpha}, kDegreesPerRadian}};
        for (const Channel channel : {kTheta, kOmega, kAlpha}) {
            columnOf(file, channel).factor = 1.0 / kDegreesPerRadian;
        }
        break;
    case 1:
        columnOf(file, kV).factor = -1.0;
        columnOf(file, kAlpha).factor = 1.0 / kDegreesPerRadian;
        findings = {{"sign", {kV}, -1.0}, {"angle-unit", {kAlpha}, kDegreesPerRadian}};
        break;
    case 2:
        columnOf(file, kTheta).zero = 180.0;
        columnOf(file, kA).factor = 1e-3;
        expectLengthUnit(file, kA, 1e3, {{"half-turn", {kTheta}}});
        finish(file, dice);
        return file;
    default:
        x.zero = lengthShift(file, dice);
        ruin(file, dice, columnOf(file, kOmega));
        findings = {{"zero-point", {kX}, -x.zero}, {"not-derivative", {kOmega}}};
        break;
    }
    expect(file, findings);
    finish(file, dice);
    return file;
}

/// Instants in ms, derivatives per second: they cannot both be true.
ClaimFile clockInMillisecondsOnly(Dice &dice)
{
    ClaimFile file = begun(dice, plottedColumns());
    file.clock = 1e3;
    expect(file, {{"time-unit", {}, 1e-3}});
    finish(file, dice);
    file.mayBeMissed = true; // the clock is wrong, or four derivatives are
    return file;
}

/// A slider that moves along y, counted in the axes of the file.
ClaimFile alongY(Dice &dice)
{
    ClaimFile file = begun(dice, {column(kX), column(kY), column(kTheta)});
    const Parameters truth = *file.truth;
    expect(file, {{"axis", {}}});
    file.mayBeMissed = true;
    file.columns[0].isMotion = file.columns[1].isMotion = file.columns[2].isMotion = false;
    finish(file, dice, [truth](double t) {
        AllChannels turned = motionAt(truth, t);
        const long double x = turned[indexOf(kX)];
        turned[indexOf(kX)] = -turned[indexOf(kY)];
        turned[indexOf(kY)] = x;
        turned[indexOf(kTheta)] += 90.0L;
        return turned;
    });
    return file;
}

// With the mechanism at hand.

ClaimFile asAtHand(Dice &dice, unsigned mask = kSix)
{
    ClaimFile file = begun(dice, plottedColumns({}, mask));
    file.atHand = *file.truth;
    return file;
}

ClaimFile agreesWithHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice);
    finish(file, dice);
    return file;
}

ClaimFile metresOfHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice);
    const double unit = std::array{10.0, 25.4, 1000.0}[static_cast<std::size_t>(dice.whole(0, 2))];
    for (const Channel channel : {kX, kV, kA}) {
        columnOf(file, channel).factor = 1.0 / unit;
    }
    expect(file, {{"length-unit", {kX, kV, kA}, unit}});
    finish(file, dice);
    return file;
}

ClaimFile millisecondsOfHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice, 0x03);
    file.clock = 1e3;
    expect(file, {{"time-unit", {}, 1e-3}});
    file.readings.push_back({*file.truth, {}}); // another mechanism, as well
    file.readings.back().truth.omega2 *= 1e-3;
    finish(file, dice);
    return file;
}

ClaimFile otherAssemblyOfHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice);
    file.atHand.branch = oppositeBranch(file.atHand.branch);
    expect(file, {{"branch", {}}});
    file.readings.push_back({*file.truth, {}}); // another mechanism, as well
    finish(file, dice);
    return file;
}

ClaimFile lateClockOfHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice);
    const double late = dice.uniform(0.05, 0.4) * kTurn / file.truth->omega2;
    file.truth->theta20 += file.truth->omega2 * late;
    file.readings.push_back({file.atHand, {{"time-shift", {}}}});
    file.readings.push_back({*file.truth, {}}); // another mechanism, as well
    finish(file, dice);
    return file;
}

ClaimFile oneParameterOffHand(Dice &dice)
{
    ClaimFile file = asAtHand(dice);
    file.offBy = static_cast<Parameter>(dice.whole(0, 4));
    double &value = valueOf(file.atHand, *file.offBy);
    value = *file.offBy == Parameter::Theta20 ? value + 0.1 : value * (1.0 + dice.uniform(0.02, 0.05));
    if (file.offBy == Parameter::Theta20) {
        file.readings.push_back({*file.truth, {}});
        file.readings.push_back({file.atHand, {{"time-shift", {}}}}); // the same, with another name
    }
    finish(file, dice);
    return file;
}

/// Whole millimetres of a mechanism that is another one than that at hand.
ClaimFile wholeMillimetresOffHand(Dice &dice)
{
    ClaimFile file = begun(dice, {column(kX, {Rule::Decimals, 0}), column(kTheta, {Rule::Decimals, 0})});
    file.atHand = *file.truth;
    file.atHand.a *= 1.0 + dice.uniform(0.03, 0.3) * dice.sign();
    file.atHand.b *= dice.uniform(1.1, 1.3);
    finish(file, dice);
    return file;
}

} // namespace

std::span<const ClaimKind> conventionKinds()
{
    static constexpr std::array kKinds{
        ClaimKind{"origin of R4_x", originOfSlider},
        ClaimKind{"origin of R4_y", originOfHeight},
        ClaimKind{"origin of theta3", originOfAngle},
        ClaimKind{"origins of R4_x, R4_y and theta3", originsOfAll},
        ClaimKind{"R4_x family from the start", sliderFromStart},
        ClaimKind{"R4_x and theta3 from the start", sixFromStart},
        ClaimKind{"theta3 from the start", angleFromStart},
        ClaimKind{"R4_x alone from the start, 9 digits", sliderAloneFromStart},
        ClaimKind{"theta3 family turned by 40 degrees", couplerTurned},
        ClaimKind{"noise and another origin", noiseAndOrigin},
        ClaimKind{"all angles in radians", anglesInRadians},
        ClaimKind{"one angle in radians", oneAngleInRadians},
        ClaimKind{"one length in another unit", oneLengthInAnotherUnit},
        ClaimKind{"a sign", oneSign},
        ClaimKind{"the slider's axis the other way", axisTheOtherWay},
        ClaimKind{"clockwise", clockwise},
        ClaimKind{"half a turn", halfTurn},
        ClaimKind{"half a turn, within 0 to 360", halfTurnWithinATurn},
        ClaimKind{"two columns swapped", twoSwapped},
        ClaimKind{"one that is no derivative", oneNoDerivative},
        ClaimKind{"central differences", centralDifferences},
        ClaimKind{"two faults at once", twoFaults},
        ClaimKind{"clock in ms, derivatives per s", clockInMillisecondsOnly},
        ClaimKind{"the slider along y", alongY},
        ClaimKind{"at hand: agrees", agreesWithHand},
        ClaimKind{"at hand: lengths in another unit", metresOfHand},
        ClaimKind{"at hand: clock in ms", millisecondsOfHand},
        ClaimKind{"at hand: the other assembly", otherAssemblyOfHand},
        ClaimKind{"at hand: a late clock", lateClockOfHand},
        ClaimKind{"at hand: one parameter off", oneParameterOffHand},
        ClaimKind{"at hand: whole mm of another", wholeMillimetresOffHand},
    };
    return kKinds;
}

} // namespace slidercrank
