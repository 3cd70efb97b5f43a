// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/findings.h"

#include "core/comparison/comparison.h"
#include "core/identification/round_numbers.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

constexpr Channel kCrank{Theta2, Order::Position};
constexpr double kErrors = 5.0; // standard errors of a significant difference
constexpr std::size_t kFewRows = 1000;

/// Adds a channel to the convention of that kind and amount, or adds a new convention. Signs of angles and of lengths
/// are separate conventions.
void addConvention(Kind kind, double amount, Channel channel, std::vector<ConventionFinding> &findings)
{
    for (ConventionFinding &finding : findings) {
        Convention &convention = finding.convention;
        if (convention.kind == kind && convention.amount == amount &&
            (kind != Kind::Sign || isLength(convention.channels.front()) == isLength(channel))) {
            convention.channels.push_back(channel);
            return;
        }
    }
    findings.push_back({{kind, {channel}, amount}});
}

/// An origin offset in the unit of files, as the roundest number within its standard error; nullopt if it is not
/// significant.
std::optional<ConventionFinding> originFinding(Channel channel, double offset, double error, double size, double step)
{
    constexpr double kLeastPart = 1e-3; // of the size
    constexpr std::array kUnits{1.0};
    if (std::abs(offset) < std::max({kLeastPart * size, kErrors * error, step})) {
        return std::nullopt;
    }
    const double amount = toFileUnit(channel, offset);
    const double standardError = toFileUnit(channel, error);
    ConventionFinding finding{{Kind::ZeroPoint, {channel}, amount}};
    if (standardError > 0.0) {
        finding.convention.amount = roundest(amount, standardError, kUnits);
        finding.standardError = standardError;
    }
    return finding;
}

/// Adds the conventions of the crank angle of a file by crank angle.
void addCrankConventions(const Observations &data, const Candidate &candidate, const Uncertainty &uncertainty,
                         std::vector<ConventionFinding> &findings)
{
    const Hypothesis &hypothesis = candidate.fit.hypothesis;
    const double factor = hypothesis.abscissaFactor;
    if (std::abs(factor) != 1.0) {
        findings.push_back({{Kind::AngleUnit, {kCrank}, std::abs(factor)}});
    }
    if (factor < 0.0) {
        findings.push_back({{Kind::Sign, {kCrank}, -1.0}});
    }
    if (hypothesis.isFree[indexOf(Parameter::Theta20)]) {
        const double offset = std::remainder(hypothesis.unknowns[4] - factor * data.origin, kTurn);
        const double error = uncertainty.standardError[indexOf(Parameter::Theta20)];
        if (const auto finding = originFinding(kCrank, offset, error, 1.0, 0.0)) {
            findings.push_back(*finding);
        }
    }
}

/// The columns that were left out because they are not the derivatives of their positions: they deviate by more than
/// differences do, and not by noise. Empty if the positions are noisy, because a filter that differentiates them may
/// cause any deviation.
std::vector<Channel> strangeDerivatives(const Observations &data, const Candidate &candidate)
{
    std::vector<Channel> channels;
    const std::vector<double> angles = crankAngles(data, candidate.fit.hypothesis);
    for (std::size_t j = 0; j < data.columns.size() && candidate.isExact; ++j) {
        if (candidate.fit.hypothesis.columns[j].isUsed) {
            continue;
        }
        Hypothesis alone = candidate.fit.hypothesis;
        alone.unknowns.conservativeResize(static_cast<Eigen::Index>(kParameterCount));
        for (std::size_t k = 0; k < alone.columns.size(); ++k) {
            alone.columns[k].isUsed = k == j;
            alone.columns[k].hasOffset = false;
        }
        std::vector<double> residuals;
        std::vector<double> residualAngles;
        double squares = 0.0;
        forEachResidual<double>(data, alone, alone.unknowns,
                                [&](std::size_t row, std::size_t, double, double residual) {
                                    residuals.push_back(residual);
                                    residualAngles.push_back(angles[row]);
                                    squares += residual * residual;
                                });
        const double rms = std::sqrt(squares / std::max(data.columns[j].count, 1.0));
        if (rms > kLargestDifferencePart * data.columns[j].spread && !looksLikeNoise(residuals, residualAngles)) {
            channels.push_back(data.columns[j].channel);
        }
    }
    return channels;
}

/// The largest error of some channels (all if `channels` is empty) in percent of their peaks; 0 if there are no values.
double largestPercent(const Parameters &parameters, const ReferenceData &data, const std::vector<Channel> &channels)
{
    double largest = 0.0;
    for (const ChannelComparison &channel : compareExactly(Mechanism(parameters), data).channels) {
        if (channels.empty() || std::ranges::count(channels, channel.channel) > 0) {
            largest = std::max(largest, channel.percentOfPeak.value_or(0.0));
        }
    }
    return largest;
}

/// The channels of a convention after it was applied: an exchange of axes renames them.
std::vector<Channel> channelsAfter(const Convention &convention)
{
    std::vector<Channel> channels = convention.channels;
    for (Channel &channel : channels) {
        if (convention.kind == Kind::Axis && isLength(channel)) {
            channel.coordinate = channel.coordinate == R4x ? R4y : R4x;
        }
    }
    return channels;
}

/// A set of conventions of the whole file.
struct WholeFileFault {
    double lengthFactor = 1.0;
    double timeFactor = 1.0;
    bool isReversed = false; ///< the angles have the opposite sense of rotation
    bool isOtherAssembly = false;
    bool isLate = false;

    int count() const
    {
        return static_cast<int>(lengthFactor != 1.0) + static_cast<int>(timeFactor != 1.0) +
               static_cast<int>(isReversed) + static_cast<int>(isOtherAssembly) + static_cast<int>(isLate);
    }

    /// The mechanism of the data after all conventions except the late start are applied.
    Parameters undone(Parameters p) const
    {
        p.a *= lengthFactor;
        p.b *= lengthFactor;
        p.c *= lengthFactor * (isReversed ? -1.0 : 1.0);
        p.omega2 *= (isReversed ? -1.0 : 1.0) / timeFactor;
        p.theta20 *= isReversed ? -1.0 : 1.0;
        return p;
    }
};

bool isGivenMechanism(const Parameters &p, const Parameters &given, const std::array<double, kParameterCount> &errors)
{
    constexpr double kPart = 2e-3;
    const auto near = [&](Parameter parameter, double size) {
        const double error = errors[indexOf(parameter)];
        const double tolerance = std::max(std::isfinite(error) ? kErrors * error : 0.0, kPart * size);
        return std::abs(valueOf(p, parameter) - valueOf(given, parameter)) <= tolerance;
    };
    return near(Parameter::A, given.a) && near(Parameter::B, given.b) &&
           near(Parameter::C, std::max(std::abs(given.c), given.a)) && near(Parameter::Omega2, std::abs(given.omega2));
}

std::optional<WholeFileFault> findWholeFileFault(const ReferenceData &data, const Parameters &given,
                                                 const Identification &found)
{
    constexpr int kMostFaults = 2;
    constexpr double kPart = 2e-3; // rad
    const double angleError = found.standardError[indexOf(Parameter::Theta20)];
    const double sameAngle = std::max(std::isfinite(angleError) ? kErrors * angleError : 0.0, kPart);
    std::optional<WholeFileFault> best;
    for (const double length : {1.0, 10.0, 25.4, 1000.0, 0.1, 1.0 / 25.4, 1e-3}) {
        for (const double time : {1.0, 1e-3, 1e3}) {
            for (const bool isReversed : {false, true}) {
                WholeFileFault fault{length, time, isReversed};
                const Parameters undone = fault.undone(found.parameters);
                std::array<double, kParameterCount> errors = found.standardError;
                for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
                    errors[indexOf(parameter)] *= length;
                }
                errors[indexOf(Parameter::Omega2)] /= time;
                fault.isOtherAssembly = undone.branch != given.branch;
                fault.isLate =
                    !data.crank && std::abs(std::remainder(undone.theta20 - given.theta20, kTurn)) > sameAngle;
                if (isGivenMechanism(undone, given, errors) && fault.count() > 0 && fault.count() <= kMostFaults &&
                    (!best || fault.count() < best->count())) {
                    best = fault;
                }
            }
        }
    }
    return best;
}

} // namespace

std::vector<ConventionFinding> findConventions(const Observations &data, const Candidate &candidate,
                                               const Uncertainty &uncertainty)
{
    std::vector<ConventionFinding> findings;
    const Hypothesis &hypothesis = candidate.fit.hypothesis;
    if (data.isByCrankAngle) {
        addCrankConventions(data, candidate, uncertainty, findings);
    }
    if (hypothesis.timeUnit != 1.0) {
        findings.push_back({{Kind::TimeUnit, {}, hypothesis.timeUnit}});
    }
    const auto forEachUsed = [&](auto &&add) {
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            if (hypothesis.columns[j].isUsed) {
                add(hypothesis.columns[j], data.columns[j], j);
            }
        }
    };
    forEachUsed([&](const ColumnUse &use, const ObservedColumn &column, std::size_t) {
        if (indexOf(column.channel) < indexOf(use.channel)) {
            findings.push_back({{Kind::SwappedColumns, {column.channel, use.channel}, 1.0}});
        }
    });
    forEachUsed([&](const ColumnUse &use, const ObservedColumn &, std::size_t) {
        if (use.unit != 1.0) {
            addConvention(isLength(use.channel) ? Kind::LengthUnit : Kind::AngleUnit, use.unit, use.channel, findings);
        }
    });
    forEachUsed([&](const ColumnUse &use, const ObservedColumn &, std::size_t) {
        if (use.sign < 0.0) {
            addConvention(Kind::Sign, -1.0, use.channel, findings);
        }
    });
    forEachUsed([&](const ColumnUse &use, const ObservedColumn &column, std::size_t) {
        if (use.channel == Channel{Theta3, Order::Position} && (use.turn != 0.0 || column.hadJumps)) {
            addConvention(use.isHalfTurned() ? Kind::HalfTurn : Kind::WholeTurns, -use.turn * kDegreesPerRadian,
                          use.channel, findings);
        }
    });
    const UnknownLayout layout(hypothesis.columns);
    forEachUsed([&](const ColumnUse &use, const ObservedColumn &column, std::size_t j) {
        if (use.hasOffset) {
            const double size = use.channel.coordinate == R4y ? std::abs(hypothesis.unknowns[0]) : column.spread;
            if (const auto finding = originFinding(use.channel, -hypothesis.unknowns[layout.offset[j]],
                                                   uncertainty.offsetErrors[j], size, column.step)) {
                findings.push_back(*finding);
            }
        }
    });
    if (const std::vector<Channel> strange = strangeDerivatives(data, candidate); !strange.empty()) {
        findings.push_back({{Kind::NotDerivative, strange, 1.0}});
    }
    return findings;
}

std::vector<ConventionFinding> findFaultsOfWholeFile(const ReferenceData &data, const Parameters &given,
                                                     Identification &found)
{
    constexpr std::array kUnits{1.0};
    std::vector<ConventionFinding> findings;
    const std::optional<WholeFileFault> fault = findWholeFileFault(data, given, found);
    if (!fault) {
        return findings;
    }
    const auto add = [&](Kind kind, double amount, auto &&concerns) {
        ConventionFinding &finding = findings.emplace_back(ConventionFinding{{kind, {}, amount}});
        for (const ReferenceSeries &series : data.series) {
            if (concerns(series.channel)) {
                finding.convention.channels.push_back(series.channel);
            }
        }
    };
    if (fault->lengthFactor != 1.0) {
        add(Kind::LengthUnit, fault->lengthFactor, isLength);
    }
    if (fault->timeFactor != 1.0) {
        add(Kind::TimeUnit, fault->timeFactor, [](Channel channel) { return channel.order != Order::Position; });
    }
    if (fault->isReversed) {
        add(Kind::Sign, -1.0, [](Channel channel) { return isAngle(channel.coordinate); });
    }
    found.parameters = fault->undone(found.parameters);
    for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
        found.standardError[indexOf(parameter)] *= fault->lengthFactor;
    }
    found.standardError[indexOf(Parameter::Omega2)] /= fault->timeFactor;
    if (fault->isOtherAssembly) {
        findings.push_back({{Kind::Branch, {}, 1.0}});
    }
    if (fault->isLate) {
        const double late = std::remainder(found.parameters.theta20 - given.theta20, kTurn) / given.omega2;
        const double error = found.standardError[indexOf(Parameter::Theta20)] / std::abs(given.omega2);
        const double amount = error > 0.0 ? roundest(late, error, kUnits) : late;
        findings.push_back({{Kind::TimeShift, {}, amount}});
        found.parameters.theta20 -= amount * found.parameters.omega2;
    }
    found.parameters.theta20 = std::remainder(found.parameters.theta20, kTurn);
    found.alternatives.clear();
    return findings;
}

ReferenceData allApplied(const std::vector<ConventionFinding> &findings, ReferenceData data)
{
    for (const ConventionFinding &finding : findings) {
        data = applied(finding.convention, std::move(data));
    }
    return data;
}

bool measureFindings(const ReferenceData &data, const Parameters &found, std::vector<ConventionFinding> &findings)
{
    bool doAllPay = true;
    const ReferenceData some = thinnedData(data, kFewRows);
    for (std::size_t i = 0; i < findings.size();) {
        const Convention &convention = findings[i].convention;
        std::vector<ConventionFinding> others = findings;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        Parameters without = found;
        without.branch = convention.kind == Kind::Branch ? oppositeBranch(found.branch) : found.branch;
        const bool concernsAll =
            convention.kind == Kind::TimeUnit || (data.crank && convention.channels.front() == kCrank);
        const std::vector<Channel> before = concernsAll ? std::vector<Channel>() : convention.channels;
        const std::vector<Channel> after = concernsAll ? std::vector<Channel>() : channelsAfter(convention);
        findings[i].before = largestPercent(without, allApplied(others, some), before);
        findings[i].after = largestPercent(found, allApplied(findings, some), after);
        if (findings[i].after < findings[i].before) {
            ++i;
        } else {
            doAllPay = doAllPay && (convention.kind == Kind::WholeTurns || convention.kind == Kind::NotDerivative);
            findings.erase(findings.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return doAllPay;
}

std::optional<ParameterChange> findParameterChange(const ReferenceData &data, const Parameters &given,
                                                   const Parameters &found)
{
    constexpr double kNearlyAll = 0.99;  // of the squares: a tenth of the error remains
    constexpr double kMostRatio = 100.0; // between the lengths of a realistic mechanism
    const ReferenceData some = thinnedData(data, kFewRows);
    const auto squaresOf = [&](const Parameters &p) {
        double sum = 0.0;
        const std::optional<ReferenceData> timed = timedBy(Mechanism(p), some);
        for (const ChannelComparison &channel :
             timed ? compareExactly(Mechanism(p), *timed).channels : std::vector<ChannelComparison>()) {
            if (channel.rms && channel.maxAbs.value_or(0.0) > 0.0) {
                const double part = *channel.rms * channel.percentOfPeak.value_or(0.0) / *channel.maxAbs;
                sum += part * part;
            }
            sum += channel.missingModel > 0 ? std::numeric_limits<double>::infinity() : 0.0;
        }
        return sum;
    };
    const double before = squaresOf(given);
    std::optional<ParameterChange> best;
    for (const Parameter parameter :
         {Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20}) {
        Parameters changed = given;
        valueOf(changed, parameter) = parameter == Parameter::Theta20
                                          ? given.theta20 + std::remainder(found.theta20 - given.theta20, kTurn)
                                          : valueOf(found, parameter);
        const auto [shorter, longer] = std::minmax(changed.a, changed.b);
        if (findFault(changed) || longer > kMostRatio * shorter || std::abs(changed.c) > kMostRatio * longer) {
            continue;
        }
        const double explained = before > 0.0 ? 1.0 - squaresOf(changed) / before : 0.0;
        if (explained >= std::max(kNearlyAll, best ? best->explained : 0.0)) {
            best = {parameter, valueOf(changed, parameter), explained};
        }
    }
    return best;
}

ReferenceData thinnedData(const ReferenceData &data, std::size_t count)
{
    if (data.time.size() <= count) {
        return data;
    }
    ReferenceData some;
    some.timeRounding = data.timeRounding;
    some.crank = data.crank;
    const std::vector<std::size_t> rows = spreadRows(data.time.size(), count);
    const auto thin = [&](const std::vector<double> &values) {
        std::vector<double> result;
        for (const std::size_t row : rows) {
            result.push_back(values[row]);
        }
        return result;
    };
    some.time = thin(data.time);
    if (some.crank) {
        some.crank->degrees = thin(data.crank->degrees);
    }
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, thin(series.values), series.rounding});
    }
    return some;
}

} // namespace slidercrank
