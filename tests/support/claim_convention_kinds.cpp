// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of files whose columns have other origins, units or signs than their headings state, are half a turn off or are
// swapped, and kinds whose deviation can be found only with a given mechanism.
#include "tests/support/claim_file.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

void expect(ClaimFile &f, std::vector<Finding> findings)
{
    f.interpretations.push_back({*f.truth, std::move(findings)});
}

/// Expects the origins of the columns. Small origins need not be found.
void expectOrigins(ClaimFile &f)
{
    for (const double least : {5e-4, 5e-3}) {
        std::vector<Finding> findings;
        for (const ClaimColumn &column : f.columns) {
            if (std::abs(column.origin) > least * (column.named == kY ? f.truth->a : f.swing(column.named))) {
                findings.push_back({"zero-point", {column.named}, -column.origin});
            }
        }
        expect(f, findings);
    }
}

void shift(ClaimFile &f, Channel channel)
{
    f.at(channel).origin = isAngle(channel.coordinate)
                               ? f.random.uniform(5.0, 170.0) * f.random.sign() // never close to half a turn
                               : f.truth->a * f.random.uniform(0.2, 9.0) * f.random.sign();
}

void addShifted(ClaimFile &f, Channels columns, const Channels &shifted)
{
    f.add(columns);
    for (const Channel channel : shifted) {
        shift(f, channel);
    }
    expectOrigins(f);
}

/// Adds columns of which the shifted ones are zero in the first row.
void addFromStart(ClaimFile &f, const Channels &columns, const Channels &shifted, NumberForm form = {})
{
    f.add(columns, form);
    f.sample();
    for (const Channel channel : shifted) {
        f.at(channel).origin = -f.exactValue(channel, f.instants.front());
    }
    expectOrigins(f);
}

Channels withHeight()
{
    Channels channels = kSix;
    channels.push_back(kY);
    return channels;
}

void multiply(ClaimFile &f, const Channels &channels, double factor)
{
    for (const Channel channel : channels) {
        f.at(channel).factor = factor;
    }
}

/// Adds all six columns, multiplies some by `factor`, and expects this to be reported as `finding`.
void addMultiplied(ClaimFile &f, std::string_view finding, const Channels &channels, double factor)
{
    f.add(kSix);
    multiply(f, channels, factor);
    expect(f, {{finding, channels, 1.0 / factor}});
}

/// Writes one slider column in another length unit. Equally true: the other two have another unit, with another
/// mechanism.
void addLengthUnit(ClaimFile &f, Channel channel, double unit, const std::vector<Finding> &more = {})
{
    f.add(kSix);
    f.at(channel).factor = 1.0 / unit;
    Channels others = kSlider;
    std::erase(others, channel);
    Parameters other = *f.truth;
    for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
        valueOf(other, length) /= unit;
    }
    f.interpretations = {{*f.truth, more}, {other, more}};
    f.interpretations[0].findings.push_back({"length-unit", {channel}, unit});
    f.interpretations[1].findings.push_back({"length-unit", others, 1.0 / unit});
}

/// Reverses the slider's axis. Equally true: the coupler's angle is measured at its other end.
void addAxisTheOtherWay(ClaimFile &f)
{
    addMultiplied(f, "sign", kSlider, -1.0);
    // x → -x and θ → θ + 180° correspond to -c, θ20 + 180° and the other branch.
    f.interpretations.push_back({mirrorImages(*f.truth)[7], {{"half-turn", {kTheta}}}});
}

/// Counts angles clockwise. Equally true: the sign of the height is wrong.
void addClockwise(ClaimFile &f)
{
    addMultiplied(f, "sign", kCoupler, -1.0);
    f.add(kY);
    const Parameters mirrored = mirrorImages(*f.truth)[2];
    f.interpretations.push_back({mirrored, {{"sign", {kY}, -1.0}}});
    constexpr double kSmall = 4.0; // the sign of so small a height cannot be found
    if (std::abs(f.truth->c) < kSmall) {
        f.interpretations.push_back({mirrored, {}});
    }
}

void addHalfTurn(ClaimFile &f)
{
    f.add(kSix);
    f.at(kTheta).origin = 180.0 * f.random.sign();
    expect(f, {{"half-turn", {kTheta}}});
}

/// Writes the textbook's θ_3, in the range 0 … 360°.
void addHalfTurnWithinATurn(ClaimFile &f)
{
    f.add(kSix);
    f.sample();
    for (const double t : f.instants) {
        f.at(kTheta).values.push_back(wrapToTwoPi((f.exactValue(kTheta, t) + 180.0) / kDegreesPerRadian) *
                                      kDegreesPerRadian);
    }
    f.at(kTheta).origin = 180.0;
    expect(f, {{"half-turn", {kTheta}}});
}

void addSwapped(ClaimFile &f)
{
    f.add(kSix);
    const int first = f.random.whole(0, 5);
    ClaimColumn &one = f.columns[static_cast<std::size_t>(first)];
    ClaimColumn &other = f.columns[static_cast<std::size_t>((first + f.random.whole(1, 5)) % 6)];
    std::swap(one.shown, other.shown);
    expect(f, {{"swapped-columns", {one.named, other.named}}});
}

/// Replaces the values of a column by scaled, delayed or unrelated ones.
void spoil(ClaimFile &f, Channel channel)
{
    const int way = f.random.whole(0, 2);
    const double factor = f.random.uniform(1.1, 1.8);
    const double late = f.random.uniform(0.05, 0.4) * kTurn / f.truth->omega2;
    const double size = f.swing(channel);
    ClaimColumn &column = f.at(channel);
    for (const double t : f.instants) {
        const double value = f.exactValue(channel, t);
        column.values.push_back(way == 0   ? value * factor
                                : way == 1 ? f.exactValue(channel, t - late)
                                           : value + 0.2 * size * std::sin(2.7 * f.truth->omega2 * t));
    }
    column.content = ClaimColumn::Content::Foreign;
}

void addNoDerivative(ClaimFile &f)
{
    f.add(kSix);
    const Channel channel = f.random.pick({kOmega, kV, kAlpha, kA});
    spoil(f, channel);
    expect(f, {{"not-derivative", {channel}}});
}

/// Adds derivatives by finite differences, as a spreadsheet computes them. With 80 rows a turn or more the error is
/// below 1 %.
void addCentralDifferences(ClaimFile &f)
{
    f.add(kSix);
    const double turns = f.random.uniform(0.6, 3.0);
    f.sample(turns, static_cast<int>(turns * f.random.uniform(80.0, 130.0)) + 10);
    const double step = f.instants[1] - f.instants[0];
    for (ClaimColumn &column : f.columns) {
        if (column.shown.order == Order::Position) {
            continue;
        }
        const std::size_t k = indexOf({column.shown.coordinate, Order::Position});
        for (const double t : f.instants) {
            const long double before = motionAt(*f.truth, t - step)[k];
            const long double after = motionAt(*f.truth, t + step)[k];
            const long double second = (after - 2.0 * motionAt(*f.truth, t)[k] + before) / (step * step);
            column.values.push_back(
                static_cast<double>(column.shown.order == Order::Velocity ? (after - before) / (2.0 * step) : second));
        }
        column.content = ClaimColumn::Content::Systematic;
    }
    f.mayBeApproximate = true;
}

void addTwoFaults(ClaimFile &f)
{
    const int fault = f.random.whole(0, 3);
    if (fault == 2) {
        addLengthUnit(f, kA, 1e3, {{"half-turn", {kTheta}}});
        f.at(kTheta).origin = 180.0;
        return;
    }
    f.add(kSix);
    if (fault == 1) {
        f.at(kV).factor = -1.0;
        f.at(kAlpha).factor = 1.0 / kDegreesPerRadian;
        expect(f, {{"sign", {kV}, -1.0}, {"angle-unit", {kAlpha}, kDegreesPerRadian}});
        return;
    }
    shift(f, kX);
    std::vector<Finding> findings{{"zero-point", {kX}, -f.at(kX).origin}};
    if (fault == 0) {
        multiply(f, kCoupler, 1.0 / kDegreesPerRadian);
        findings.push_back({"angle-unit", kCoupler, kDegreesPerRadian});
    } else {
        spoil(f, kOmega);
        findings.push_back({"not-derivative", {kOmega}});
    }
    expect(f, findings);
}

/// Writes the time stamps in ms, but the derivatives per second.
void addMillisecondsOnly(ClaimFile &f)
{
    f.add(kSix);
    f.timeFactor = 1e3;
    f.mayBeMissed = true; // either the time or the four derivatives have the wrong unit
    expect(f, {{"time-unit", {}, 1e-3}});
}

/// Writes the motion of a slider that moves along the y axis of the file.
void addAlongY(ClaimFile &f)
{
    f.add({kX, kY, kTheta});
    f.sample();
    f.mayBeMissed = true;
    f.setContent(ClaimColumn::Content::Foreign, {kX, kY, kTheta});
    f.motion = [truth = *f.truth](double t) {
        Pose pose = motionAt(truth, t);
        pose[indexOf(kX)] = std::exchange(pose[indexOf(kY)], pose[indexOf(kX)]) * -1.0L;
        pose[indexOf(kTheta)] += 90.0L;
        return pose;
    };
    expect(f, {{"axis"}});
}

// Kinds for which the true mechanism, or a similar one, is given.

void addGiven(ClaimFile &f, const Channels &channels = kSix)
{
    f.given = *f.truth;
    f.add(channels);
}

void addOtherLengthsThanGiven(ClaimFile &f)
{
    const double unit = f.random.pick({10.0, 25.4, 1000.0});
    addMultiplied(f, "length-unit", kSlider, 1.0 / unit);
    f.given = *f.truth;
}

void addMillisecondsForGiven(ClaimFile &f)
{
    addGiven(f, {kTheta, kX});
    f.timeFactor = 1e3;
    expect(f, {{"time-unit", {}, 1e-3}});
    expect(f, {}); // another mechanism, as well
    f.interpretations.back().mechanism.omega2 *= 1e-3;
}

void addOtherAssemblyThanGiven(ClaimFile &f)
{
    addGiven(f);
    f.given.branch = oppositeBranch(f.given.branch);
    expect(f, {{"branch"}});
    expect(f, {}); // another mechanism, as well
}

void addLateForGiven(ClaimFile &f)
{
    addGiven(f);
    f.truth->theta20 += f.random.uniform(0.05, 0.4) * kTurn;
    f.interpretations.push_back({f.given, {{"time-shift"}}});
    expect(f, {}); // another mechanism, as well
}

void addOneParameterOff(ClaimFile &f)
{
    addGiven(f);
    f.wrongGiven = static_cast<Parameter>(f.random.whole(0, 4));
    double &value = valueOf(f.given, *f.wrongGiven);
    value = *f.wrongGiven == Parameter::Theta20 ? value + 0.1 : value * (1.0 + f.random.uniform(0.02, 0.05));
    expect(f, {});
    if (f.wrongGiven == Parameter::Theta20) {
        f.interpretations.push_back({f.given, {{"time-shift"}}}); // the same deviation under another name
    }
}

void addWholeMillimetresOfAnother(ClaimFile &f)
{
    f.add({kX, kTheta}, decimals(0));
    f.given = *f.truth;
    f.given.a *= 1.0 + f.random.uniform(0.03, 0.3) * f.random.sign();
    f.given.b *= f.random.uniform(1.1, 1.3);
}

const ClaimKind kConventionKinds[] = {
    {"origin of R4_x", [](ClaimFile &f) { addShifted(f, kSix, {kX}); }},
    {"origin of R4_y", [](ClaimFile &f) { addShifted(f, withHeight(), {kY}); }},
    {"origin of theta3", [](ClaimFile &f) { addShifted(f, kSix, {kTheta}); }},
    {"origins of R4_x, R4_y and theta3",
     [](ClaimFile &f) {
         addShifted(f, withHeight(), {kX, kY, kTheta});
     }},
    {"R4_x family from the start", [](ClaimFile &f) { addFromStart(f, kSlider, {kX}); }},
    {"R4_x and theta3 from the start",
     [](ClaimFile &f) {
         addFromStart(f, kSix, {kX, kTheta});
     }},
    {"theta3 from the start", [](ClaimFile &f) { addFromStart(f, kSix, {kTheta}); }},
    {"R4_x alone from the start, 9 digits", [](ClaimFile &f) { addFromStart(f, {kX}, {kX}, digits(9)); }},
    {"theta3 family turned by 40 degrees",
     [](ClaimFile &f) {
         f.add(kCoupler);
         f.at(kTheta).origin = 40.0;
         expectOrigins(f);
     }},
    {"noise and another origin",
     [](ClaimFile &f) {
         f.add(kX, digits(7));
         f.setNoise(0.003);
         shift(f, kX);
         expectOrigins(f);
     }},
    {"all angles in radians", [](ClaimFile &f) { addMultiplied(f, "angle-unit", kCoupler, 1.0 / kDegreesPerRadian); }},
    {"one angle in radians",
     [](ClaimFile &f) {
         addMultiplied(f, "angle-unit", {f.random.pick({kTheta, kOmega, kAlpha})}, 1.0 / kDegreesPerRadian);
     }},
    {"one length in another unit",
     [](ClaimFile &f) {
         addLengthUnit(f, f.random.pick({kX, kV, kA}), f.random.pick({10.0, 25.4, 1000.0}));
     }},
    {"a sign",
     [](ClaimFile &f) {
         addMultiplied(f, "sign", {kPlottedChannels[static_cast<std::size_t>(f.random.whole(0, 5))]}, -1.0);
     }},
    {"the slider's axis the other way", addAxisTheOtherWay},
    {"clockwise", addClockwise},
    {"half a turn", addHalfTurn},
    {"half a turn, within 0 to 360", addHalfTurnWithinATurn},
    {"two columns swapped", addSwapped},
    {"one that is no derivative", addNoDerivative},
    {"central differences", addCentralDifferences},
    {"two faults at once", addTwoFaults},
    {"clock in ms, derivatives per s", addMillisecondsOnly},
    {"the slider along y", addAlongY},
    {"given: agrees", [](ClaimFile &f) { addGiven(f); }},
    {"given: lengths in another unit", addOtherLengthsThanGiven},
    {"given: clock in ms", addMillisecondsForGiven},
    {"given: the other assembly", addOtherAssemblyThanGiven},
    {"given: a late clock", addLateForGiven},
    {"given: one parameter off", addOneParameterOff},
    {"given: whole mm of another", addWholeMillimetresOfAnother},
};

} // namespace

std::span<const ClaimKind> conventionKinds()
{
    return kConventionKinds;
}

} // namespace slidercrank
