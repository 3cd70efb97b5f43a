// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/positions.h"

#include "app/similar_words.h"
#include "core/import/quantity.h"
#include "core/limits/crank_search.h"
#include "core/mechanism/turn.h"
#include "ui/text/expression.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kDigits = 10; // significant digits of the values in messages

/// A channel with a value, as in "R4_x=60", "theta3=10deg" or "R4_x_diff=8m/s".
struct ChannelValue {
    OutputChannel channel;
    double value = 0.0; ///< mm, rad, s
    QString text;       ///< with its unit
};

/// Returns the message that no channel has this name.
QString unknownChannel(const QString &name)
{
    QStringList words{"omega3", "alpha3", "mu"};
    for (const OutputChannel &known : allOutputChannels()) {
        words += columnName(known);
    }
    return CommandLine::tr("\"%1\" is no quantity: choose x, v, a, theta3, omega3, alpha3, displacement, mu, or a "
                           "channel such as R4_x, R4_x_diff or R4_x_diff2.")
               .arg(name) +
           didYouMean(similarWords(name, words));
}

/// Parses a channel with a value. A number without a unit is in the units of the output.
ChannelValue readChannelValue(const char *option, const QString &text, const Units &units)
{
    const QString name = text.section('=', 0, 0).trimmed();
    if (!text.contains('=')) {
        throw UsageError{CommandLine::tr("--%1 must be a channel, = and its value, such as %2, not \"%3\".")
                             .arg(option, QLatin1String(option) == u"when" ? "R4_x=60" : "R4_x_diff=8m/s", text)};
    }
    const OutputChannel channel = parseOutputChannel(option, name);
    const Measure measure = measureOf(channel);
    const Unit fileUnit{.dimension = isAngular(measure) ? Dimension::Angle : Dimension::Length,
                        .order = static_cast<int>(orderOf(channel)),
                        .factor = 1.0};
    const double perFileUnit = fromFileUnit(measure, 1.0, units);
    const QString number = text.section('=', 1).trimmed();
    const bool hasUnit = readExpression(number, {}, QLocale::c()).fault.has_value();
    const double inFileUnit = parseNumber(option, number, fileUnit) / (hasUnit ? 1.0 : perFileUnit);
    return {.channel = channel,
            .value = isAngular(measure) ? inFileUnit / kDegreesPerRadian : inFileUnit,
            .text = withUnit(numberText(inFileUnit * perFileUnit, kDigits), unitText(measure, units))};
}

/// Returns the positions of a crank that stands still at each of the crank angles (rad).
std::vector<Positions> positionsAtRest(const OptionReader &options, const Mechanism &mechanism,
                                       const std::vector<double> &crankAngles)
{
    std::vector<Positions> positions;
    for (const double theta2 : crankAngles) {
        positions.push_back({.mechanism = withDrive(mechanism, 0.0, theta2), .timeStamps = {readStart(options)}});
    }
    return positions;
}

/// Reads --step-angle: one revolution of the crank in equal steps of that angle, from --start on. If the crank stands
/// still, the revolution is counter-clockwise from its angle on.
std::vector<Positions> readRevolution(const OptionReader &options, const Mechanism &mechanism)
{
    constexpr double kDegreesPerTurn = 360.0;
    constexpr double kSmallestStep = 1e-4;      // degrees
    constexpr double kRelativeTolerance = 1e-9; // decimal numbers are not exact in binary
    const double stepAngle = options.number("step-angle", 0.0, kDegree, kSmallestStep, kDegreesPerTurn);
    const double steps = kDegreesPerTurn / stepAngle;
    if (std::abs(steps - std::round(steps)) > kRelativeTolerance * steps) {
        throw UsageError{CommandLine::tr("--step-angle must divide 360° into equal steps, such as 15 or 0.5, not %1.")
                             .arg(options.text("step-angle"))};
    }
    const int stepCount = static_cast<int>(std::lround(steps));
    if (mechanism.omega2() == 0.0) {
        std::vector<double> crankAngles;
        for (int i = 0; i <= stepCount; ++i) {
            crankAngles.push_back(mechanism.theta20() + kTurn * i / stepCount);
        }
        return positionsAtRest(options, mechanism, crankAngles);
    }
    const Sampling revolution{
        .start = readStart(options), .duration = kTurn / std::abs(mechanism.omega2()), .steps = stepCount};
    if (!(revolution.duration <= kLargestParameter)) {
        throw UsageError{
            CommandLine::tr("A revolution of the crank takes more than 1e12 s: choose a larger --omega2.")};
    }
    checkTimeSteps(revolution, CommandLine::tr("The rows are too close in time to be distinguished: choose a larger "
                                               "--step-angle, a smaller --omega2 or a --start nearer to 0."));
    return {{.mechanism = mechanism, .timeStamps = revolution.timeStamps()}};
}

/// Returns the message that no position has the wanted value. If the wanted value is that of θ3 at B for some position,
/// the message explains it.
QString noPosition(const Mechanism &mechanism, const ChannelValue &wanted, double alpha2, const Units &units)
{
    const QString name = columnName(wanted.channel);
    const bool isAngleAtB = wanted.channel == OutputChannel(Channel{Theta3, Order::Position}) &&
                            !crankAnglesAt(mechanism, wanted.channel, wanted.value + 0.5 * kTurn)->empty();
    if (isAngleAtB) {
        const double atA = shownValue(Measure::Angle, wrapToPi(wanted.value + 0.5 * kTurn), units);
        return CommandLine::tr("There is no position with %1 = %2, because %1 is measured at A. If %2 is the angle at "
                               "B, as in Norton's book, write %1=%3.")
            .arg(name, wanted.text, withUnit(numberText(atA, kDigits), unitText(Measure::Angle, units)));
    }
    const std::optional<ChannelRange> range = rangeOf(mechanism, wanted.channel, alpha2);
    if (!range || !range->excludes(wanted.value)) {
        return CommandLine::tr(
                   "There is no position with %1 = %2: \"slidercrank limits\" shows how far the motion goes.")
            .arg(name, wanted.text);
    }
    const Measure measure = measureOf(wanted.channel);
    const QString unit = unitText(measure, units);
    return CommandLine::tr("There is no position with %1 = %2: %1 lies between %3 and %4.")
        .arg(name, wanted.text, withUnit(lowerBoundText(shownValue(measure, range->least, units), kDigits), unit),
             withUnit(upperBoundText(shownValue(measure, range->greatest, units), kDigits), unit));
}

/// Reads --when: all positions of the revolution that begins at --start. If the crank stands still, the revolution is
/// counter-clockwise from its angle on.
std::vector<Positions> readSolutions(const OptionReader &options, const Mechanism &mechanism, const Units &units)
{
    const ChannelValue wanted = readChannelValue("when", options.text("when"), units);
    const double alpha2 = readCrankAcceleration(options);
    std::optional<std::vector<double>> angles = crankAnglesAt(mechanism, wanted.channel, wanted.value, alpha2);
    const QString name = columnName(wanted.channel);
    if (!angles) {
        throw UsageError{mechanism.omega2() == 0.0
                             ? CommandLine::tr("--when: the crank stands still, so that %1 is 0 everywhere.").arg(name)
                             : CommandLine::tr("--when: %1 does not depend on the crank angle.").arg(name)};
    }
    if (angles->empty()) {
        throw UsageError{noPosition(mechanism, wanted, alpha2, units), ExitStatus::NotAssemblable};
    }
    if (mechanism.omega2() == 0.0) {
        for (double &theta2 : *angles) {
            theta2 = mechanism.theta20() + wrapToTwoPi(theta2 - mechanism.theta20());
        }
        std::ranges::sort(*angles);
        return positionsAtRest(options, mechanism, *angles);
    }
    Positions positions{.mechanism = mechanism, .timeStamps = {}};
    for (const double theta2 : *angles) {
        positions.timeStamps.push_back(firstTimeAtAngle(options, mechanism, theta2));
    }
    std::ranges::sort(positions.timeStamps);
    return {positions};
}

/// Reads --omega2-for. Returns the crank speed (rad/s) at which the channel has the wanted value at the crank angle
/// theta2 (rad).
double readCrankSpeedFor(const OptionReader &options, const Mechanism &mechanism, double theta2, const Units &units)
{
    options.refuseIfGiven({"omega2"}, CommandLine::tr("--omega2-for computes the crank speed: remove %1."));
    const ChannelValue wanted = readChannelValue("omega2-for", options.text("omega2-for"), units);
    const QString name = columnName(wanted.channel);
    if (orderOf(wanted.channel) != Order::Velocity) {
        throw UsageError{
            CommandLine::tr("--omega2-for needs a first derivative, such as R4_x_diff=8m/s, not %1.").arg(name)};
    }
    const std::optional<double> speed = crankSpeedFor(mechanism, theta2, wanted.channel, wanted.value);
    if (!speed || std::abs(*speed) > kLargestParameter) {
        throw UsageError{CommandLine::tr("No crank speed gives %1 = %2 at %3°: there %1 is 0 at every speed, as at a "
                                         "dead centre, or does not exist.")
                             .arg(name, wanted.text, numberText(theta2 * kDegreesPerRadian)),
                         ExitStatus::NotAssemblable};
    }
    return *speed;
}

/// Reads --at-angle, and --omega2-for if it is given.
std::vector<Positions> readAngle(const OptionReader &options, const Mechanism &mechanism, const Units &units,
                                 const Streams &streams)
{
    const double theta2 = options.number("at-angle", 0.0, kDegree) / kDegreesPerRadian;
    if (!options.has("omega2-for")) {
        if (mechanism.omega2() == 0.0) {
            return positionsAtRest(options, mechanism, {theta2});
        }
        return {{.mechanism = mechanism, .timeStamps = {firstTimeAtAngle(options, mechanism, theta2)}}};
    }
    const double speed = readCrankSpeedFor(options, mechanism, theta2, units);
    streams.report("--omega2 " + typedNumberText(speed));
    if (speed == 0.0) {
        return positionsAtRest(options, mechanism, {theta2});
    }
    const Mechanism driven = withDrive(mechanism, speed, mechanism.theta20());
    return {{.mechanism = driven, .timeStamps = {firstTimeAtAngle(options, driven, theta2)}}};
}

/// Throws if two options ask for different rows, or if --omega2-for is given without --at-angle.
void checkSelection(const OptionReader &options)
{
    if (options.has("at") || options.has("at-angle")) {
        options.refuseIfGiven(
            {"steps", "duration", "step-angle", "when"},
            CommandLine::tr("--at and --at-angle ask for one time and %1 for several: remove one of them."));
    }
    if (options.has("at")) {
        options.refuseIfGiven({"start", "at-angle"}, CommandLine::tr("--at already sets the time: remove %1."));
    }
    if (options.has("step-angle")) {
        options.refuseIfGiven({"steps", "duration", "when"},
                              CommandLine::tr("--step-angle covers one revolution: remove %1."));
    }
    if (options.has("when")) {
        options.refuseIfGiven({"steps", "duration"}, CommandLine::tr("--when covers one revolution: remove %1."));
    }
    if (!options.has("at-angle")) {
        options.refuseIfGiven({"omega2-for"}, CommandLine::tr("%1 needs the position: add --at-angle."));
    }
}

} // namespace

std::vector<Positions> readPositions(const OptionReader &options, const Mechanism &mechanism, const Units &units,
                                     const Streams &streams)
{
    checkSelection(options);
    if (options.has("at")) {
        return {{.mechanism = mechanism, .timeStamps = {options.number("at", 0.0, kSecond)}}};
    }
    if (options.has("at-angle")) {
        return readAngle(options, mechanism, units, streams);
    }
    if (options.has("step-angle")) {
        return readRevolution(options, mechanism);
    }
    if (options.has("when")) {
        return readSolutions(options, mechanism, units);
    }
    options.refuseIfGiven({"alpha2"},
                          CommandLine::tr("The crank has a constant speed over time, and %1 applies to single "
                                          "positions: add --at-angle, --at, --step-angle or --when."));
    return {};
}

Units readUnits(const OptionReader &options, const Units &defaults)
{
    return {.length = options.choice("length-unit", defaults.length),
            .angle = options.choice("angle-unit", defaults.angle)};
}

double readCrankAcceleration(const OptionReader &options)
{
    return options.number("alpha2", options.scene().alpha2, kRadianPerSquareSecond);
}

OutputChannel parseOutputChannel(const QString &name)
{
    if (const std::optional<OutputChannel> channel = outputChannelNamed(name.toStdString())) {
        return *channel;
    }
    throw UsageError{unknownChannel(name)};
}

OutputChannel parseOutputChannel(const char *option, const QString &name)
{
    if (const std::optional<OutputChannel> channel = outputChannelNamed(name.toStdString())) {
        return *channel;
    }
    throw UsageError{QString("--%1: %2").arg(option, unknownChannel(name))};
}

} // namespace slidercrank
