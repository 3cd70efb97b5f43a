// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnosis/explanation.h"

#include "core/diagnosis/column_reading.h"
#include "core/identification/identification.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Instants of one column from which a mechanism is found that all of them then judge.
constexpr std::size_t kWitnessRows = 100;

/// The same mechanism in the sizes that the file's columns of length have: angles alone do not tell it.
std::vector<Parameters> sizesOf(const Parameters &parameters, const ReferenceData &data)
{
    const Trajectory model = motionOf(parameters, data.time, channelsOf(data));
    std::vector<Parameters> sizes{parameters};
    for (const ReferenceSeries &series : data.series) {
        if (isPlotted(series.channel) && !isAngle(series.channel.coordinate)) {
            const double scale = std::abs(1.0 / bestFactor(model[series.channel], series.values));
            Parameters one = parameters;
            one.a /= scale;
            one.b /= scale;
            one.c /= scale;
            if (!findFault(one)) {
                sizes.push_back(one);
            }
        }
    }
    return sizes;
}

/// The mechanism that a derivative alone was taken for, when its instants count in another unit than itself.
Parameters retimed(Parameters parameters, double timeUnit, Channel witness)
{
    const double size = isAngle(witness.coordinate) ? 1.0 : powerOf(timeUnit, witness);
    parameters.a *= size;
    parameters.b *= size;
    parameters.c *= size;
    parameters.omega2 /= timeUnit;
    return parameters;
}

/// One column, read as that channel: if nothing is wrong with it, the mechanism follows from it, and what is wrong
/// with the others from the mechanism.
ReferenceData alone(const ReferenceData &data, std::size_t column, Channel channel, double unit)
{
    ReferenceData one;
    one.time = data.time;
    one.series.push_back(data.series[column]);
    one.series.front().channel = channel;
    one = applied({Kind::AngleUnit, {channel}, unit}, std::move(one));
    return everySoManyth(one, kWitnessRows);
}

/// Columns that may be trusted one by one: first as they stand, ...
std::vector<ReferenceData> plainWitnesses(const ReferenceData &data)
{
    std::vector<ReferenceData> witnesses;
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        if (isPlotted(data.series[i].channel)) {
            witnesses.push_back(alone(data, i, data.series[i].channel, 1.0));
        }
    }
    return witnesses;
}

/// ... and where that leads nowhere, angles in the other unit and under the other name.
std::vector<ReferenceData> doubtfulWitnesses(const ReferenceData &data)
{
    std::vector<ReferenceData> witnesses;
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        const Channel channel = data.series[i].channel;
        if (!isPlotted(channel)) {
            continue;
        }
        if (isAngle(channel.coordinate)) {
            witnesses.push_back(alone(data, i, channel, kDegreesPerRadian));
            witnesses.push_back(alone(data, i, channel, 1.0 / kDegreesPerRadian));
        }
        if (channel.order == Order::Position) {
            witnesses.push_back(alone(data, i, {channel.coordinate == R4x ? Theta3 : R4x, channel.order}, 1.0));
        }
    }
    return witnesses;
}

/// Whether the motion is about that of the mechanism at hand: then the data are rather about it, too.
bool resembles(const ReferenceData &data, const Explanation &explanation, const Mechanism &atHand)
{
    constexpr double kResemblance = 0.25; // b = 65 for 60 is 0.1
    const ReadMotion motion(data, explanation);
    const ChannelSet channels = channelsOf(motion.read);
    const Trajectory other = motionOf(atHand.parameters(), motion.read.time, channels);
    for (const Channel channel : kPlottedChannels) {
        if (channels.test(indexOf(channel)) && !(rmsMisfit(other[channel], motion.model[channel]) <= kResemblance)) {
            return false;
        }
    }
    return true;
}

/// The columns of lowest order, which no derivative can spoil.
ReferenceData withoutDerivatives(const ReferenceData &data)
{
    ReferenceData lowest = data;
    std::erase_if(lowest.series, [&](const ReferenceSeries &series) { return hasLowerOrder(data, series.channel); });
    return lowest;
}

/// The explanation with the mechanism fitted to all that it leaves.
std::optional<Explanation> provenByFit(const ReferenceData &data, Explanation explanation, const std::stop_token &stop)
{
    const auto fitTo = [&](const ReferenceData &some) {
        const Identification fit = identify(some, Mechanism(explanation.parameters), stop);
        if (fit.outcome == Identification::Outcome::Identified) {
            explanation.parameters = fit.parameters;
        }
    };
    const ReferenceData read = allApplied(explanation.conventions, data);
    fitTo(read);
    if (const auto whole = proven(data, explanation, Demand::NearlyNothing)) {
        return whole;
    }
    // A derivative that is none, but near enough not to have been seen yet, has spoilt the fit.
    fitTo(withoutDerivatives(read));
    const auto suspicious = proven(data, explanation, Demand::NearlyNothing);
    if (!suspicious || suspicious->conventions == explanation.conventions) {
        return suspicious;
    }
    explanation = *suspicious;
    fitTo(allApplied(explanation.conventions, data));
    return proven(data, explanation, Demand::NearlyNothing);
}

/// Every explanation that a witness leads to, the cheapest first, each set of conventions once.
std::vector<Explanation> explanationsOf(const ReferenceData &data, const std::vector<ReferenceData> &witnesses,
                                        const Mechanism &atHand, const std::stop_token &stop)
{
    constexpr double kOfAStranger = 0.3;               // decides among as many findings only
    constexpr double kSimplest = 1.015 + kOfAStranger; // one finding in one column
    struct Priced {
        double cost;
        Explanation explanation;
    };
    std::vector<Priced> priced;

    for (const ReferenceData &witness : witnesses) {
        if (std::any_of(priced.begin(), priced.end(), [&](const Priced &one) { return one.cost <= kSimplest; })) {
            break; // no other witness can tell anything simpler
        }
        const Identification fit = identify(witness, atHand, stop);
        if (fit.outcome != Identification::Outcome::Identified) {
            continue;
        }
        for (const Parameters &image : imagesOf(fit.parameters)) {
            for (const Parameters &sized : fit.onlyRatios ? sizesOf(image, data) : std::vector{image}) {
                for (const double timeUnit : {1.0, kTimeUnits[0], kTimeUnits[1]}) {
                    Explanation assumption{retimed(sized, timeUnit, witness.series.front().channel), {}, timeUnit};
                    if (timeUnit != 1.0) {
                        assumption.conventions.push_back({Kind::TimeUnit, {}, timeUnit});
                    }
                    if (findFault(assumption.parameters)) {
                        continue;
                    }
                    if (const auto explanation = explain(data, assumption)) {
                        const double strange = resembles(data, *explanation, atHand) ? 0.0 : kOfAStranger;
                        priced.push_back({costOf(*explanation) + strange, *explanation});
                    }
                }
            }
        }
    }
    std::stable_sort(priced.begin(), priced.end(), [](const Priced &x, const Priced &y) { return x.cost < y.cost; });
    std::vector<Explanation> explanations;
    for (const Priced &one : priced) {
        const bool known = std::any_of(explanations.begin(), explanations.end(), [&](const Explanation &other) {
            return other.conventions == one.explanation.conventions;
        });
        if (!known) {
            explanations.push_back(one.explanation);
        }
    }
    return explanations;
}

} // namespace

std::optional<Explanation> explainedByFit(const ReferenceData &data, const Mechanism &atHand,
                                          const std::stop_token &stop)
{
    constexpr std::size_t kMostProofs = 6;
    constexpr double kAsSimple = 0.5; ///< of cost: as many findings

    // Lengths and angles keep each other's units: where there are both, nearly nothing left is the truth, measured or
    // computed with few digits. Angles alone are nearly the same motion in radians when they are small.
    const bool lengthsToo = std::any_of(data.series.begin(), data.series.end(), [](const ReferenceSeries &series) {
        return isPlotted(series.channel) && !isAngle(series.channel.coordinate);
    });
    std::optional<Explanation> likely;
    const Identification whole = identify(data, atHand, stop);
    if (whole.outcome == Identification::Outcome::Identified) {
        const Explanation plain{whole.parameters, {}};
        likely = proven(data, plain, Demand::NearlyNothing);
        if (likely && !likely->conventions.empty()) {
            likely.reset(); // the column that is no derivative has been fitted, too
        }
        if (likely && (lengthsToo || proven(data, plain, Demand::Agreement))) {
            return likely;
        }
    }
    for (const auto &witnesses : {plainWitnesses(data), doubtfulWitnesses(data)}) {
        if (likely && lengthsToo) {
            break;
        }
        std::vector<Explanation> explanations = explanationsOf(data, witnesses, atHand, stop);
        explanations.resize(std::min(explanations.size(), kMostProofs));
        for (const Explanation &explanation : explanations) {
            if (likely && lengthsToo && costOf(explanation) > costOf(*likely) + kAsSimple) {
                break;
            }
            const auto candidate = provenByFit(data, explanation, stop);
            if (candidate && proven(data, *candidate, Demand::Agreement)) {
                return candidate;
            }
            if (!likely) {
                likely = candidate;
            }
        }
    }
    return likely;
}

} // namespace slidercrank
