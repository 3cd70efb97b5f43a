// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/by_crank_angle.h"

#include "core/identification/explanation.h"
#include "core/identification/observations.h"
#include "core/identification/round_numbers.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

constexpr Channel kCrank{Theta2, Order::Position};
constexpr double kSigmas = 5.0; ///< that two numbers lie apart before they are two

/// rad/s, and one standard deviation.
struct CrankSpeed {
    double value = 0.0;
    double error = 0.0;
};

/// Of a column and its derivative: the slope of ∫ v dθ2 over x, both about their means.
std::optional<double> slopeOf(std::span<const double> degrees, std::span<const double> values,
                              std::span<const double> rates)
{
    std::vector<double> integral;
    std::vector<double> position;
    double sum = 0.0;
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (!std::isfinite(values[i]) || !std::isfinite(rates[i])) {
            continue;
        }
        if (last) {
            sum += 0.5 * (rates[*last] + rates[i]) * (degrees[i] - degrees[*last]) / kDegreesPerRadian;
        }
        integral.push_back(sum);
        position.push_back(values[i]);
        last = i;
    }
    const auto count = static_cast<double>(position.size());
    double meanI = 0.0;
    double meanX = 0.0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        meanI += integral[i] / count;
        meanX += position[i] / count;
    }
    double xx = 0.0;
    double xi = 0.0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        xx += (position[i] - meanX) * (position[i] - meanX);
        xi += (position[i] - meanX) * (integral[i] - meanI);
    }
    const double slope = xi / xx;
    return std::isfinite(slope) && slope != 0.0 ? std::optional(slope) : std::nullopt;
}

/// What the derivative columns say of ω2, about; none where they say nothing of it.
std::optional<double> roughSpeedOf(const ReferenceData &data)
{
    if (const ReferenceSeries *speed = data.find({Theta2, Order::Velocity})) {
        const ValueRange range = rangeOf(speed->values);
        return range.size() > 0.0 ? std::optional(0.5 * (range.low + range.high) / kDegreesPerRadian) : std::nullopt;
    }
    for (const Coordinate coordinate : {R4x, Theta3, R3x, R2x, R3y, R2y}) {
        for (const auto &[order, next] :
             {std::pair{Order::Position, Order::Velocity}, std::pair{Order::Velocity, Order::Acceleration}}) {
            const ReferenceSeries *values = data.find({coordinate, order});
            const ReferenceSeries *rates = data.find({coordinate, next});
            const std::optional<double> slope =
                values && rates ? slopeOf(data.crank->degrees, values->values, rates->values) : std::nullopt;
            if (slope) {
                return slope;
            }
        }
    }
    return std::nullopt;
}

/// By the derivative columns of the motion that was found with a speed near to it. `data`: timed by that. What is not
/// known of the mechanism's size is not known of the speed.
CrankSpeed refinedSpeed(const ReferenceData &data, const Identification &found)
{
    const Parameters &motion = found.parameters;
    const Trajectory model = motionOf(motion, data.time, channelsOf(data));
    double weights = 0.0; // 1 / variance of ln ω2
    double sum = 0.0;
    for (const ReferenceSeries &series : data.series) {
        const int order = static_cast<int>(series.channel.order);
        const std::vector<double> &expected = model[series.channel];
        double squares = 0.0;
        double product = 0.0;
        double steps = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < expected.size() && order > 0; ++i) {
            if (std::isfinite(series.values[i]) && std::isfinite(expected[i])) {
                const double step = series.rounding.stepAt(series.values[i]);
                squares += expected[i] * expected[i];
                product += expected[i] * series.values[i];
                steps += step * step / 12.0;
                count += 1.0;
            }
        }
        const double ratio = product / squares;
        if (!(squares > 0.0 && ratio > 0.0)) {
            continue;
        }
        double left = 0.0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const double error = series.values[i] - ratio * expected[i];
            left += std::isfinite(error) ? error * error : 0.0;
        }
        const double variance = std::max({left, steps, kArithmeticStep * kArithmeticStep * squares}) / count;
        const double weight = order * order * squares / variance;
        weights += weight;
        sum += weight * std::log(ratio) / order;
    }
    if (!(weights > 0.0)) {
        return {motion.omega2, 0.0};
    }
    const double sizeError = found.standardError[indexOf(Parameter::A)] / motion.a;
    const double ofSize = std::isfinite(sizeError) ? sizeError : 0.0;
    return {motion.omega2 * std::exp(sum / weights),
            std::abs(motion.omega2) * std::hypot(1.0 / std::sqrt(weights), ofSize)};
}

/// Those of the columns; and how the angles of the file are to be read to be those of the crank that was found: they
/// may be counted clockwise, or from another direction.
std::vector<Convention> conventionsOf(const Diagnosis &result, const Parameters &drive)
{
    const Identification &found = result.identification;
    const double sign = found.parameters.omega2 * drive.omega2 < 0.0 ? -1.0 : 1.0;
    double zero = std::remainder(found.parameters.theta20 - sign * drive.theta20, 2.0 * std::numbers::pi);
    std::vector<Convention> conventions;
    for (const ConventionFinding &finding : result.conventions) {
        if (finding.convention.kind == Kind::TimeShift) {
            zero += drive.omega2 * finding.convention.amount;
        } else {
            conventions.push_back(finding.convention);
        }
    }
    const double error = kDegreesPerRadian * found.standardError[indexOf(Parameter::Theta20)];
    constexpr double kLeastZero = 1e-6; // °
    constexpr std::array kDegrees{1.0};
    zero *= kDegreesPerRadian;
    if (found.stands() && sign < 0.0) {
        conventions.push_back({Kind::Sign, {kCrank}, -1.0});
    }
    if (found.stands() && std::abs(zero) > std::max(kSigmas * error, kLeastZero)) {
        const double rounded = error > 0.0 ? roundest(zero, error, kDegrees) : zero;
        conventions.push_back({Kind::ZeroPoint, {kCrank}, rounded});
    }
    return conventions;
}

/// Of images that the columns cannot tell apart, the crank's angle may: the first that turns as the file counts.
void preferSenseOf(double omega2, Identification &found)
{
    const auto turnsSo = [omega2](const Parameters &parameters) { return parameters.omega2 * omega2 > 0.0; };
    if (!turnsSo(found.parameters)) {
        const auto image = std::ranges::find_if(
            found.alternatives, [&](const auto &alternative) { return turnsSo(alternative.parameters); });
        if (image == found.alternatives.end()) {
            return;
        }
        std::swap(found.parameters, image->parameters);
    }
    std::erase_if(found.alternatives,
                  [&](const Identification::Alternative &alternative) { return !turnsSo(alternative.parameters); });
}

/// Without what says something else of θ2, but with θ2 itself, far finer than anything else: so the drive is as it was
/// timed by. `positionsOnly`: without the derivatives by the time, where there are positions.
ReferenceData withCrankColumn(ReferenceData data, bool positionsOnly)
{
    const auto isPosition = [](const ReferenceSeries &series) { return series.channel.order == Order::Position; };
    const bool hasPositions = std::ranges::any_of(
        data.series, [&](const ReferenceSeries &series) { return isPosition(series) && isPlotted(series.channel); });
    std::erase_if(data.series, [&](const ReferenceSeries &series) {
        return series.channel.coordinate == Theta2 || (positionsOnly && hasPositions && !isPosition(series));
    });
    constexpr int kDecimals = 9;
    Rounding exact;
    exact.rule = Rounding::Rule::Decimals;
    exact.digits = kDecimals;
    exact.finestPlace = -kDecimals;
    data.series.push_back({kCrank, data.crank->degrees, exact});
    data.crank.reset();
    return data;
}

double worstOf(const std::vector<ChannelComparison> &channels)
{
    double worst = 0.0;
    for (const ChannelComparison &channel : channels) {
        worst = std::max(worst, channel.percentOfPeak.value_or(0.0));
    }
    return worst;
}

/// The sum over the channels of the squared errors, each as part of its peak.
double squaresOf(const std::vector<ChannelComparison> &channels)
{
    double sum = 0.0;
    for (const ChannelComparison &channel : channels) {
        if (channel.rms && channel.maxAbs && channel.percentOfPeak && *channel.maxAbs > 0.0) {
            const double part = *channel.rms * *channel.percentOfPeak / *channel.maxAbs;
            sum += part * part;
        }
    }
    return sum;
}

bool differsAny(const std::vector<ChannelComparison> &channels)
{
    return std::ranges::any_of(channels,
                               [](const ChannelComparison &channel) { return channel.verdict == Verdict::Differs; });
}

Diagnosis nothingFound(const Parameters &given)
{
    Diagnosis result;
    result.identification.parameters = result.rounded = given;
    result.identification.claimNothing();
    return result;
}

} // namespace

Diagnosis diagnoseByCrankAngle(const ReferenceData &data, const Mechanism &mechanism, const std::stop_token &stop)
{
    constexpr std::size_t kSpeed = indexOf(Parameter::Omega2);
    constexpr std::size_t kStart = indexOf(Parameter::Theta20);
    const Parameters &given = mechanism.parameters();
    const std::optional<double> rough = roughSpeedOf(data);
    CrankSpeed speed{rough.value_or(given.omega2), 0.0};
    Diagnosis result;
    Identification &found = result.identification;
    std::vector<Convention> conventions;
    for (int round = 0; round < (rough ? 2 : 1); ++round) { // by the rough speed, and by the refined one
        Parameters drive = given;
        drive.omega2 = speed.value;
        const std::optional<ReferenceData> timed = findFault(drive) ? std::nullopt : timedBy(Mechanism(drive), data);
        if (!timed) {
            return nothingFound(given);
        }
        ReferenceData byTime = *timed;
        byTime.crank.reset();
        result = diagnose(byTime, Mechanism(drive), stop);
        if (found.stopped) {
            return result;
        }
        preferSenseOf(drive.omega2, found);
        conventions = conventionsOf(result, drive);
        found.parameters.omega2 = drive.omega2;
        found.parameters.theta20 = drive.theta20;
        if (!found.stands()) {
            break;
        }
        // Once more, the angles being what they are; then the speed of what was found.
        const ReferenceData read = allApplied(conventions, *timed);
        const Identification fixed =
            identify(withCrankColumn(read, rough.has_value()), Mechanism(found.parameters), stop);
        if (fixed.stands()) {
            found = fixed;
            found.parameters.omega2 = drive.omega2;
            found.parameters.theta20 = drive.theta20;
        }
        if (rough) {
            std::vector<Convention> ofColumns = conventions; // a derivative may be none because the start was off
            std::erase_if(ofColumns, [](const Convention &one) { return one.kind == Kind::NotDerivative; });
            speed = refinedSpeed(allApplied(ofColumns, *timed), found);
            found.parameters.omega2 = speed.value;
            if (findFault(found.parameters)) {
                return nothingFound(given);
            }
        }
    }
    const bool stands = found.stands();
    result.isSpeedOfDerivatives = rough && stands;
    found.standardError[kSpeed] = result.isSpeedOfDerivatives ? speed.error : kNone;
    found.identifiable[kSpeed] = result.isSpeedOfDerivatives;
    found.standardError[kStart] = kNone;
    found.identifiable[kStart] = false;
    for (Identification::Alternative &alternative : found.alternatives) {
        alternative.parameters.omega2 = found.parameters.omega2;
        alternative.parameters.theta20 = found.parameters.theta20;
    }

    // All of it anew, of the data as they read then.
    const std::optional<ReferenceData> atHand = timedBy(mechanism, data);
    const std::optional<ReferenceData> own = timedBy(Mechanism(found.parameters), data);
    result.rounded = found.parameters;
    result.isOfMechanismAtHand = false;
    if (!atHand || !own) {
        return result;
    }
    result.conventions.clear();
    for (std::size_t i = 0; i < conventions.size(); ++i) { // each with the errors without and with it
        std::vector<Convention> others = conventions;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const auto errorsWith = [&](std::span<const Convention> some) {
            std::vector<ChannelComparison> channels =
                compareExactly(Mechanism(found.parameters), allApplied(some, *own), stop).channels;
            if (!concerns(conventions[i], kCrank) && !conventions[i].channels.empty()) {
                std::erase_if(channels, [&](const ChannelComparison &channel) {
                    return !concerns(conventions[i], channel.channel);
                });
            }
            return worstOf(channels);
        };
        result.conventions.push_back({conventions[i], errorsWith(others), errorsWith(conventions)});
    }
    const ReferenceData read = allApplied(conventions, *own);
    const std::vector<ChannelComparison> before =
        compareExactly(mechanism, allApplied(conventions, *atHand), stop).channels;
    result.isOfMechanismAtHand = !differsAny(before);
    if (!result.identified.empty()) {
        result.identified = compareExactly(Mechanism(found.parameters), read, stop).channels;
    }
    if (found.outcome == Identification::Outcome::Identified) {
        result.rounded = inRoundNumbers(found, read, result.identified);
    }

    // A change of ω2 leaves the positions as they are, and one of another parameter was found by the file's own ω2.
    const bool isOtherSpeed = std::abs(speed.value - given.omega2) > kSigmas * speed.error;
    if (isOtherSpeed || result.isOfMechanismAtHand) {
        result.change.reset();
    }
    if (result.change &&
        (result.change->parameter == Parameter::Omega2 || result.change->parameter == Parameter::Theta20)) {
        result.change.reset();
    }
    if (isOtherSpeed && stands && !result.isOfMechanismAtHand) {
        Parameters changed = given;
        changed.omega2 = speed.value;
        const Mechanism faster(changed);
        const double left = squaresOf(compareExactly(faster, read, stop).channels);
        const double explained = 1.0 - left / squaresOf(before);
        constexpr double kMostOfIt = 0.99;
        if (explained >= kMostOfIt) {
            result.change = ParameterChange{Parameter::Omega2, result.rounded.omega2, explained};
        }
    }
    found.stopped = stop.stop_requested();
    return result;
}

} // namespace slidercrank
