// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/explanation.h"

#include "core/identification/unit_and_sense.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What may be left of the error, as part of how much the channel varies, where the file's own rounding is not reached:
/// a derivative may have been computed with few digits, the data may have been measured. A derivative that is farther
/// off is none.
constexpr double kNearlyNothing = 0.01;
/// Values next to zero have finer steps than a shift that was found from the data can meet: so many steps of the
/// largest values are agreement too.
constexpr double kStepsOfAgreement = 5.0;
/// How many times smaller a finding makes the error, at least.
constexpr double kImprovement = 20.0;

Convention &add(std::vector<Convention> &conventions, Kind kind, double amount)
{
    for (Convention &convention : conventions) {
        if (convention.kind == kind && convention.amount == amount) {
            return convention;
        }
    }
    return conventions.emplace_back(Convention{kind, {}, amount});
}

/// Swaps that bring each column under the name of what it holds.
void addSwaps(std::vector<Convention> &conventions, std::vector<Channel> names, const std::vector<Channel> &contents)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == contents[i]) {
            continue;
        }
        const auto other = std::find(names.begin(), names.end(), contents[i]);
        std::vector<Channel> two{names[i], *other};
        std::sort(two.begin(), two.end(), [](Channel x, Channel y) { return indexOf(x) < indexOf(y); });
        conventions.push_back({Kind::SwappedColumns, two, 1.0});
        std::swap(names[i], *other);
    }
}

/// Whether the file has the coordinate, or a lower derivative of it, in a column that is understood.
bool hasLowerOrder(const ReferenceData &data, const std::vector<bool> &understood, Channel channel)
{
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        const Channel other = data.series[i].channel;
        if (understood[i] && other.coordinate == channel.coordinate && other.order < channel.order) {
            return true;
        }
    }
    return false;
}

/// What is wrong with the columns if the model is right; nothing where a column cannot be understood. Expects the
/// conventions that `explanation` already has to be applied to the data.
bool explainColumns(const ReferenceData &data, const Trajectory &model, Explanation &explanation)
{
    const std::size_t count = data.series.size();
    std::vector<std::optional<UnitAndSense>> readings(count);
    std::vector<Channel> names;
    std::vector<bool> understood(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        const ReferenceSeries &series = data.series[i];
        names.push_back(series.channel);
        readings[i] = unitAndSenseOf(series.channel, series.values, model[series.channel], explanation.timeUnit);
        understood[i] = readings[i].has_value();
    }

    // Columns under each other's names: the best pairs first, as long as there are any. Only the plotted channels take
    // part, and only whole cycles count.
    std::vector<Channel> contents = names;
    struct Pair {
        std::size_t column;
        std::size_t name;
        UnitAndSense reading;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            if (i == k || understood[i] || understood[k] || !isPlotted(names[i]) || !isPlotted(names[k])) {
                continue;
            }
            const ReferenceSeries &series = data.series[i];
            if (const auto reading = unitAndSenseOf(names[k], series.values, model[names[k]], explanation.timeUnit)) {
                pairs.push_back({i, k, *reading});
            }
        }
    }
    std::ranges::stable_sort(pairs, {},
                             [](const Pair &pair) { return std::pair(pair.reading.steps(), pair.reading.misfit); });
    std::vector<bool> nameTaken(count, false);
    for (const Pair &pair : pairs) {
        if (!readings[pair.column] && !nameTaken[pair.name]) {
            readings[pair.column] = pair.reading;
            contents[pair.column] = names[pair.name];
            nameTaken[pair.name] = true;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const bool moved = contents[i] != names[i];
        if (moved != nameTaken[i]) {
            return false; // no cycle
        }
        understood[i] = understood[i] || moved;
    }
    addSwaps(explanation.conventions, names, contents);

    std::array<std::vector<Channel>, 2> signs; // an axis and a sense of rotation are not the same fault
    std::vector<Channel> notDerivatives;
    for (std::size_t i = 0; i < count; ++i) {
        const Channel channel = contents[i];
        if (!understood[i]) {
            if (!isPlotted(channel)) {
                continue;
            }
            if (!hasLowerOrder(data, understood, channel)) {
                return false;
            }
            notDerivatives.push_back(channel);
            continue;
        }
        const UnitAndSense &reading = *readings[i];
        if (reading.timeUnit != 1.0) {
            add(explanation.conventions, Kind::TimeUnit, explanation.timeUnit).channels.push_back(channel);
        }
        if (reading.unit != 1.0) {
            const Kind kind = isAngle(channel.coordinate) ? Kind::AngleUnit : Kind::LengthUnit;
            add(explanation.conventions, kind, reading.unit).channels.push_back(channel);
        }
        if (reading.sign < 0.0) {
            signs[isAngle(channel.coordinate) ? 1 : 0].push_back(channel);
        }
        if (reading.turned) {
            const Kind kind = std::fmod(reading.turn, 360.0) == 0.0 ? Kind::WholeTurns : Kind::HalfTurn;
            add(explanation.conventions, kind, reading.turn).channels.push_back(channel);
        }
    }
    for (const std::vector<Channel> &channels : signs) {
        if (!channels.empty()) {
            explanation.conventions.push_back({Kind::Sign, channels, -1.0});
        }
    }
    if (!notDerivatives.empty()) {
        explanation.conventions.push_back({Kind::NotDerivative, notDerivatives, 1.0});
    }
    return true;
}

/// The order in which findings are applied: what concerns the file as a whole, names, numbers.
int rankOf(Kind kind)
{
    switch (kind) {
    case Kind::Axis: return 0;
    case Kind::Branch: return 1;
    case Kind::TimeUnit: return 2;
    case Kind::TimeShift: return 3;
    case Kind::SwappedColumns: return 4;
    case Kind::AngleUnit: return 5;
    case Kind::LengthUnit: return 6;
    case Kind::Sign: return 7;
    case Kind::HalfTurn: return 8;
    case Kind::WholeTurns: return 9;
    case Kind::ZeroPoint: return 10;
    case Kind::NotDerivative: return 11;
    }
    return 12;
}

/// The largest error among these channels (none given: the six), as part of the motion's peak.
double largestError(const ReadMotion &motion, std::span<const Channel> channels)
{
    double largest = 0.0;
    for (const ReferenceSeries &series : motion.read.series) {
        const bool meant = channels.empty()
                               ? isPlotted(series.channel)
                               : std::find(channels.begin(), channels.end(), series.channel) != channels.end();
        if (!meant) {
            continue;
        }
        const std::vector<double> &model = motion.model[series.channel];
        double error = 0.0;
        for (std::size_t i = 0; i < model.size(); ++i) {
            const double difference = std::abs(series.values[i] - model[i]);
            error = std::isfinite(difference) ? std::max(error, difference) : error;
        }
        const double peak = rangeOf(model).size();
        largest = std::max(largest, error / (peak > 0.0 ? peak : std::max(error, 1.0)));
    }
    return largest;
}

} // namespace

bool concerns(const Convention &convention, Channel channel)
{
    return std::find(convention.channels.begin(), convention.channels.end(), channel) != convention.channels.end();
}

ReferenceData allApplied(std::span<const Convention> conventions, ReferenceData data)
{
    for (const Convention &convention : conventions) {
        data = applied(convention, std::move(data));
    }
    return data;
}

bool hasLowerOrder(const ReferenceData &data, Channel channel)
{
    return hasLowerOrder(data, std::vector<bool>(data.series.size(), true), channel);
}

Trajectory motionOf(const Parameters &parameters, std::span<const double> time, const ChannelSet &channels)
{
    SolverSettings settings;
    settings.method = Method::ClosedForm;
    return sample(Mechanism(parameters), {time.begin(), time.end()}, channels, settings);
}

ReadMotion::ReadMotion(const ReferenceData &data, const Explanation &explanation)
    : read(allApplied(explanation.conventions, data))
    , model(motionOf(explanation.parameters, read.time, channelsOf(read)))
{
}

double rmsMisfit(std::span<const double> values, std::span<const double> model)
{
    double count = 0.0;
    double errors = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i]) && std::isfinite(model[i])) {
            count += 1.0;
            errors += (values[i] - model[i]) * (values[i] - model[i]);
            sum += model[i];
            squares += model[i] * model[i];
        } else if (std::isfinite(values[i])) {
            return kInfinity;
        }
    }
    const double variation = squares - sum * sum / count;
    return variation > 0.0 ? std::sqrt(errors / variation) : kInfinity;
}

ReferenceData everySoManyth(const ReferenceData &data, std::size_t rows)
{
    const std::size_t stride = std::max<std::size_t>(1, data.time.size() / rows);
    ReferenceData some;
    some.timeRounding = data.timeRounding;
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, {}, series.rounding});
    }
    for (std::size_t row = 0; row < data.time.size(); row += stride) {
        some.time.push_back(data.time[row]);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            some.series[k].values.push_back(data.series[k].values[row]);
        }
    }
    return some;
}

std::optional<Explanation> explain(const ReferenceData &data, Explanation explanation)
{
    const ReferenceData read = allApplied(explanation.conventions, data);
    const Trajectory model = motionOf(explanation.parameters, read.time, channelsOf(read));
    if (!explainColumns(read, model, explanation)) {
        return std::nullopt;
    }
    std::ranges::stable_sort(explanation.conventions, {}, [](const Convention &one) { return rankOf(one.kind); });
    return explanation;
}

double costOf(const Explanation &explanation)
{
    constexpr double kOfAColumn = 0.01;
    constexpr double kOfAShift = 1.5;  // any amount of it is possible
    constexpr double kOfALoss = 1.5;   // what is left out can no longer contradict
    constexpr double kOfASign = 1.005; // an angle negated is often one turned
    double cost = 0.0;
    for (const Convention &convention : explanation.conventions) {
        switch (convention.kind) {
        case Kind::TimeShift: cost += kOfAShift; break;
        case Kind::NotDerivative: cost += kOfALoss; break;
        case Kind::Sign: cost += kOfASign; break;
        default: cost += 1.0;
        }
        cost += kOfAColumn * static_cast<double>(convention.channels.size());
    }
    return cost;
}

std::vector<ConventionFinding> findingsOf(const ReferenceData &data, const Explanation &explanation)
{
    const ReadMotion with(data, explanation);
    std::vector<ConventionFinding> findings;
    for (std::size_t i = 0; i < explanation.conventions.size(); ++i) {
        const Convention &convention = explanation.conventions[i];
        Explanation others = explanation;
        others.conventions.erase(others.conventions.begin() + static_cast<std::ptrdiff_t>(i));
        if (convention.kind == Kind::Branch) {
            others.parameters.branch = oppositeBranch(others.parameters.branch);
        }
        const bool ofAll = convention.kind == Kind::TimeUnit;
        const std::vector<Channel> concerned = ofAll ? std::vector<Channel>() : convention.channels;
        const ReadMotion without(data, others);
        if (convention.kind == Kind::Axis) { // the columns have other names with it
            std::vector<Channel> turned;
            for (const ReferenceSeries &series : with.read.series) {
                const bool isOfSlider = series.channel.coordinate == R4x || series.channel.coordinate == R4y;
                if (isOfSlider || concerns(convention, series.channel)) {
                    turned.push_back(series.channel);
                }
            }
            findings.push_back(
                {convention, 100.0 * largestError(without, concerned), 100.0 * largestError(with, turned)});
            continue;
        }
        findings.push_back(
            {convention, 100.0 * largestError(without, concerned), 100.0 * largestError(with, concerned)});
    }
    return findings;
}

std::optional<Explanation> proven(const ReferenceData &data, Explanation explanation)
{
    const ReadMotion motion(data, explanation);
    std::vector<Channel> notDerivatives;
    for (const ReferenceSeries &series : motion.read.series) {
        const ChannelComparison column =
            compareChannel(motion.read.time, motion.model[series.channel], series,
                           slidercrank::sizeOf(Mechanism(explanation.parameters), series.channel));
        const double error = column.maxAbs.value_or(kInfinity);
        const bool small =
            error <= kNearlyNothing * sizeOf(motion.model[series.channel]) && column.missingModel <= column.count / 20;
        const bool derivative = hasLowerOrder(motion.read, series.channel);
        const bool nearRounding = error <= kStepsOfAgreement * column.roundingStep.value_or(0.0);
        const bool agrees =
            column.verdict == Verdict::Agrees || (small && (column.verdict == Verdict::Close || nearRounding));
        if (derivative ? small || agrees : agrees) {
            continue;
        }
        const bool changed = std::any_of(explanation.conventions.begin(), explanation.conventions.end(),
                                         [&](const Convention &one) { return concerns(one, series.channel); });
        if (!isPlotted(series.channel) && !changed) {
            continue;
        }
        if (!derivative || changed) {
            return std::nullopt;
        }
        notDerivatives.push_back(series.channel);
    }
    if (!notDerivatives.empty()) {
        std::vector<Channel> &channels = add(explanation.conventions, Kind::NotDerivative, 1.0).channels;
        channels.insert(channels.end(), notDerivatives.begin(), notDerivatives.end());
    }
    for (const ConventionFinding &finding : findingsOf(data, explanation)) {
        if (finding.before < kImprovement * finding.after) {
            return std::nullopt;
        }
    }
    return explanation;
}

} // namespace slidercrank
