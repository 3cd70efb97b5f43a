// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/findings.h"

#include "core/identification/interpretation.h"
#include "core/identification/round_numbers.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/find_element.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Rounds an origin to the roundest number within its standard error, unless this changes the residuals of its column,
/// because the other parameters are not rounded with it.
void roundOrigin(const Observations &data, const Candidate &candidate, const Uncertainty &uncertainty,
                 ConventionFinding &finding)
{
    constexpr double kSmallPart = 0.3; // of the rms residual
    const Channel channel = finding.channels.front();
    const std::size_t j = columnIndex(data.columns, channel);
    const double residual = j < data.columns.size()
                                ? std::sqrt(candidate.noiseVariances[j] + data.columns[j].meanVariance)
                                : kInfinity; // of the crank angle in the abscissa
    const double error = uncertainty.originError(candidate.hypothesis, channel);
    const double rounded = roundest(finding.amount, error);
    if (error > 0.0) {
        finding.standardError = error;
    }
    if (std::abs(rounded - finding.amount) <= toFileUnit(channel, kSmallPart * residual)) {
        finding.amount = rounded;
    }
}

} // namespace

std::vector<ConventionFinding> findConventions(const Observations &data, const Candidate &candidate,
                                               const Uncertainty &uncertainty)
{
    std::vector<ConventionFinding> findings;
    for (Convention &convention : conventionsOf(data, candidate.hypothesis)) {
        ConventionFinding finding{std::move(convention)};
        std::vector<Channel> &channels = finding.channels;
        if (finding.kind == Kind::NotDerivative) {
            // Differences of the positions deviate, too, and a filter that differentiates noisy positions may cause any
            // deviation.
            std::erase_if(channels, [&](Channel channel) {
                return !candidate.isExact || !isPlotted(channel) ||
                       isLikeDifferences(data, candidate.hypothesis, columnIndex(data.columns, channel));
            });
            if (channels.empty()) {
                continue;
            }
        }
        if (finding.kind == Kind::ZeroPoint) {
            roundOrigin(data, candidate, uncertainty, finding);
        }
        findings.push_back(std::move(finding));
    }
    return findings;
}

std::vector<ConventionFinding> findFaultsOfWholeFile(const ReferenceData &data, const Parameters &given,
                                                     Identification &found)
{
    constexpr std::size_t kMostFaults = 2;
    constexpr double kSamePart = 2e-3;
    // Each fault changes the mechanism by one symmetry (convention.h), which the ratios of the parameters tell.
    Parameters p = found.parameters;
    std::array errors = found.standardError;
    const ReferenceSeries *const length =
        findElement(data.series, [](const ReferenceSeries &series) { return isLength(series.channel); });
    const double lengthFactor =
        nearestFactor(kLengthFactors, given.a / p.a, length ? length->rounding.unitFactor : 1.0);
    const double timeFactor = nearestFactor(kTimeFactors, p.omega2 / given.omega2, data.timeRounding.unitFactor);
    const bool isReversed = p.omega2 * given.omega2 < 0.0;
    const double sense = isReversed ? -1.0 : 1.0;
    for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
        valueOf(p, parameter) *= lengthFactor;
        errors[indexOf(parameter)] *= lengthFactor;
    }
    p.c *= sense;
    p.omega2 *= sense / timeFactor;
    p.theta20 *= sense;
    errors[indexOf(Parameter::Omega2)] /= timeFactor;
    std::vector<ConventionFinding> findings;
    const auto addIf = [&](bool isPresent, Kind kind, double amount, auto &&concerns) {
        if (isPresent) {
            ConventionFinding &finding = findings.emplace_back(ConventionFinding{{kind, {}, amount}});
            for (const ReferenceSeries &series : data.series) {
                if (concerns(series.channel)) {
                    finding.channels.push_back(series.channel);
                }
            }
        }
    };
    addIf(lengthFactor != 1.0, Kind::LengthUnit, lengthFactor, isLength);
    addIf(timeFactor != 1.0, Kind::TimeUnit, timeFactor,
          [](Channel channel) { return channel.order != Order::Position; });
    addIf(isReversed, Kind::Sign, -1.0, [](Channel channel) { return !isLength(channel); });
    addIf(p.branch != given.branch, Kind::Branch, 1.0, [](Channel) { return false; });
    Parameters likeGiven = p;
    likeGiven.theta20 = given.theta20;
    likeGiven.branch = given.branch;
    Parameters started = given;
    started.theta20 = p.theta20;
    if (!data.crank && !areNear(given, started, kSamePart, errors)) {
        const double late = std::remainder(p.theta20 - given.theta20, kTurn) / given.omega2;
        const double error = errors[indexOf(Parameter::Theta20)] / std::abs(given.omega2);
        const double amount = roundest(late, error);
        findings.push_back({{Kind::TimeShift, {}, amount}});
        p.theta20 -= amount * p.omega2;
    }
    if (findings.empty() || findings.size() > kMostFaults || !areNear(given, likeGiven, kSamePart, errors)) {
        return {};
    }
    p.theta20 = std::remainder(p.theta20, kTurn);
    found.parameters = p;
    found.standardError = errors;
    found.alternatives.clear();
    return findings;
}

std::vector<ChannelComparison> compareTimed(const Parameters &parameters, const ReferenceData &data,
                                            const std::stop_token &stop)
{
    const Mechanism mechanism(parameters);
    const std::optional<ReferenceData> timed = data.crank ? timedBy(mechanism, data) : std::nullopt;
    return compareExactly(mechanism, timed ? *timed : data, stop).channels;
}

ReferenceData allApplied(const std::vector<ConventionFinding> &findings, ReferenceData data)
{
    for (const ConventionFinding &finding : findings) {
        data = applied(finding, std::move(data));
    }
    return data;
}

bool measureFindings(const ReferenceData &data, const Parameters &found, std::vector<ConventionFinding> &findings)
{
    bool doAllPay = true;
    const ReferenceData some = thinned(data);
    for (std::size_t i = 0; i < findings.size();) { // a finding that is removed may change those that follow
        const Convention &convention = findings[i];
        std::vector<ConventionFinding> others = findings;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        Parameters without = found;
        without.branch = convention.kind == Kind::Branch ? oppositeBranch(found.branch) : found.branch;
        const bool concernsAll = convention.kind == Kind::TimeUnit || convention.kind == Kind::Axis ||
                                 (data.crank && concerns(convention, kCrankAngle));
        const std::vector<Channel> channels = concernsAll ? std::vector<Channel>() : convention.channels;
        findings[i].before = largestPercent(without, allApplied(others, some), channels);
        findings[i].after = largestPercent(found, allApplied(findings, some), channels);
        if (findings[i].after < findings[i].before) {
            ++i;
        } else {
            doAllPay = doAllPay && (convention.kind == Kind::WholeTurns || convention.kind == Kind::NotDerivative);
            findings = std::move(others);
        }
    }
    return doAllPay;
}

std::optional<ParameterChange> findParameterChange(const ReferenceData &data, const Parameters &given,
                                                   const Parameters &found)
{
    constexpr double kNearlyAll = 0.99; // of the square: a tenth of the error remains
    const ReferenceData some = thinned(data);
    const double before = largestPercent(given, some);
    std::optional<ParameterChange> best;
    for (const Parameter parameter : kAllParameters) {
        Parameters changed = given;
        valueOf(changed, parameter) = parameter == Parameter::Theta20
                                          ? given.theta20 + std::remainder(found.theta20 - given.theta20, kTurn)
                                          : valueOf(found, parameter);
        if (findFault(changed)) {
            continue;
        }
        const double explained = before > 0.0 ? 1.0 - std::pow(largestPercent(changed, some) / before, 2.0) : 0.0;
        if (explained >= std::max(kNearlyAll, best ? best->explained : 0.0)) {
            best = {parameter, valueOf(changed, parameter), explained};
        }
    }
    return best;
}

ReferenceData thinned(ReferenceData data)
{
    const std::vector<std::size_t> rows = spreadRows(data.time.size(), 1000);
    data.time = valuesAt(data.time, rows);
    if (data.crank) {
        data.crank->degrees = valuesAt(data.crank->degrees, rows);
    }
    for (ReferenceSeries &series : data.series) {
        series.values = valuesAt(series.values, rows);
    }
    return data;
}

double largestPercent(const Parameters &parameters, const ReferenceData &data, const std::vector<Channel> &channels)
{
    double largest = 0.0;
    for (const ChannelComparison &channel : compareTimed(parameters, data)) {
        if (channels.empty() || std::ranges::count(channels, channel.channel) > 0) {
            largest = channel.missingModel > 0 ? kInfinity : std::max(largest, channel.percentOfPeak.value_or(0.0));
        }
    }
    return largest;
}

} // namespace slidercrank
