// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what a claim says about deviations, noise, omitted columns and excluded rows.
#include "tests/support/claim_judge.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// The numbers of one column, as the claim interprets them, and their difference to the motion of a mechanism. Rows
/// that are excluded or have no number are omitted.
struct Deviation {
    Channel channel;
    double claimedNoise = 0.0;
    Values numbers{};
    Values motion{};
    Values difference{};  ///< without whole turns
    Values uncertainty{}; ///< standard deviation of noise and of the rounding of numbers, time stamps and lengths
    Values isRight{};     ///< 0 in rows with wrong readings

    double largest() const { return difference.abs().maxCoeff(); }
    double rms() const { return std::sqrt(difference.square().mean()); }
    double noise() const { return std::sqrt(uncertainty.square().mean()); }
    double peak() const { return (numbers.isZero() ? motion : numbers).abs().maxCoeff(); }
    double range() const { return motion.maxCoeff() - motion.minCoeff(); }
    double spread() const { return std::sqrt((numbers - numbers.mean()).square().mean()); }
};

template <class List>
double valueFor(Channel channel, const List &list, double List::value_type::*value)
{
    const auto found = std::ranges::find(list, channel, &List::value_type::channel);
    return found == list.end() ? 0.0 : (*found).*value;
}

/// Returns the product of the unit factors that the claim found for a column.
double unitFactor(const Claim &claim, Channel channel)
{
    double factor = 1.0;
    for (const ConventionFinding &finding : claim.diagnosis.conventions) {
        const bool isUnit = finding.kind == Kind::AngleUnit || finding.kind == Kind::LengthUnit;
        factor *= isUnit && concerns(finding, channel) ? finding.amount : 1.0;
    }
    return factor;
}

std::vector<Deviation> deviationsFrom(const Parameters &p, const Claim &claim)
{
    const ClaimFile &file = claim.file;
    const ReferenceData &data = claim.read;
    Parameters longer = p; // where a mechanism folds, the last digit of b decides about its derivatives
    longer.b *= 1.0 + 1e-15;
    Values times = Values::Map(data.time.data(), static_cast<Index>(data.time.size()));
    if (data.crank) {
        times = (Values::Map(data.crank->degrees.data(), times.size()) / kDegreesPerRadian - p.theta20) / p.omega2;
    }
    Values isRight = Values::Ones(times.size());
    Values isExcluded = Values::Zero(times.size());
    for (Index i = 0; i < times.size(); ++i) {
        const std::size_t line = data.lines[static_cast<std::size_t>(i)];
        isRight[i] = file.badLines.contains(line) ? 0.0 : 1.0;
        const bool isNamed = std::ranges::count(claim.found.excludedRows, line) > 0;
        isExcluded[i] = isNamed || (file.hasSaturation && isRight[i] == 0.0) ? 1.0 : 0.0;
    }
    std::vector<Deviation> deviations;
    for (const ReferenceSeries &series : data.series) {
        const Channel channel = series.channel;
        const auto column = std::ranges::find(file.columns, nameOf(channel), &ClaimColumn::heading);
        const double factor = std::abs(unitFactor(claim, channel));
        const Values numbers = Values::Map(series.values.data(), times.size());
        const Values motion = valuesOf(p, channel, times);
        const Values blur = valuesOf(p, channel, times + file.timeStep()) - motion;
        const Values rounding = valuesOf(longer, channel, times) - motion;
        const double peak = numbers.isFinite().select(numbers, 0.0).abs().maxCoeff();
        const double finest = 0.01 * column->stepAt(peak / factor); // the step of a zero tells nothing
        const Values steps = column->stepsAt(numbers / factor).max(finest) * factor;
        std::vector<Index> rows;
        for (Index i = 0; i < times.size(); ++i) {
            if (std::isfinite(numbers[i] + motion[i] + blur[i]) && isExcluded[i] == 0.0) {
                rows.push_back(i);
            }
        }
        if (!rows.empty()) {
            Deviation &deviation = deviations.emplace_back(
                Deviation{channel, valueFor(channel, claim.found.noise, &Identification::Noise::rms)});
            const bool hasTurns = isAngle(channel.coordinate) && channel.order == Order::Position;
            const double noise = column->noise * factor;
            deviation.numbers = numbers(rows);
            deviation.motion = motion(rows);
            deviation.difference =
                (motion - numbers)(rows).unaryExpr([=](double x) { return hasTurns ? std::remainder(x, 360.0) : x; });
            deviation.uncertainty =
                ((steps.square() + blur.square()) / 12.0 + rounding.square() + noise * noise).sqrt()(rows);
            deviation.isRight = isRight(rows);
        }
    }
    return deviations;
}

/// Checks that the printed deviations are those of the printed mechanism, that `nearest` fits better than a constant,
/// and that the claimed noise does not exceed the noise of the correct readings.
std::string falsePrintedDeviation(const Claim &claim, const Deviation &deviation)
{
    constexpr double kMostNoise = 1.5;
    const double tolerance = 0.02 * deviation.largest() + 1e-6 * deviation.peak() + deviation.noise();
    const auto differs = [&](double printed, double actual) { return std::abs(printed - actual) > tolerance; };
    const auto printed = std::ranges::find(claim.diagnosis.identified, deviation.channel, &ChannelComparison::channel);
    if (!claim.file.isByAngle && !claim.file.hasSaturation && printed != claim.diagnosis.identified.end() &&
        printed->maxAbs && differs(*printed->maxAbs, deviation.largest()) &&
        differs(*printed->maxAbs, (deviation.motion - deviation.numbers).abs().maxCoeff())) {
        return "false deviation";
    }
    const double leftOut = valueFor(deviation.channel, claim.found.leftOut, &Identification::LeftOut::percentOfPeak);
    if (leftOut > 0.0 && differs(0.01 * leftOut * deviation.peak(), deviation.largest())) {
        return "false deviation of an omitted column";
    }
    if (claim.found.outcome == Identification::Outcome::Nearest && claim.isUsed(deviation.channel) &&
        deviation.spread() > 1e-3 * deviation.peak() && deviation.rms() > 1.2 * deviation.spread()) {
        return "a constant is nearer";
    }
    const double actual = std::sqrt((deviation.difference * deviation.isRight).square().mean());
    return deviation.claimedNoise > kMostNoise * std::max(actual, deviation.noise()) ? "too much noise" : "";
}

/// Checks that an approximate mechanism explains every used column to 1 % and has no standard errors, and that round
/// numbers explain the file equally well, by the largest or by the rms deviation.
std::string falseApproximation(const Claim &claim, const std::vector<Deviation> &deviations)
{
    constexpr double kMost = 0.01;
    constexpr double kEqually = 1.15;
    const std::vector<Deviation> rounded = deviationsFrom(claim.diagnosis.rounded, claim);
    std::array<double, 4> parts{}; // of the range: largest and rms, then the same of the rounded mechanism
    for (std::size_t k = 0; k < deviations.size(); ++k) {
        const Deviation &deviation = deviations[k];
        const double range = deviation.range();
        if (!claim.isUsed(deviation.channel) || range <= 1e-6 * deviation.peak()) {
            continue;
        }
        if (deviation.rms() > kMost * range + 2.0 * deviation.noise() ||
            deviation.largest() > kMost * range + 5.0 * deviation.noise()) {
            return std::string(nameOf(deviation.channel)) + " is not even approximate";
        }
        const std::array sizes{deviation.largest(), deviation.rms(), rounded[k].largest(), rounded[k].rms()};
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            parts[i] = std::max(parts[i], sizes[i] / range);
        }
    }
    if (std::ranges::any_of(claim.found.standardError, [](double error) { return std::isfinite(error); })) {
        return "standard errors of an approximate mechanism";
    }
    return parts[2] <= kEqually * parts[0] || parts[3] <= kEqually * parts[1] ? "" : "the round numbers deviate more";
}

} // namespace

bool explains(const Claim &claim, const Parameters &parameters, bool isStrict)
{
    constexpr double kVisible = 5e-4; // of the peak
    constexpr double kFar = 16.0;     // twice the limit beyond which readings must be excluded
    return std::ranges::none_of(deviationsFrom(parameters, claim), [&](const Deviation &deviation) {
        if (!claim.isUsed(deviation.channel)) {
            return false;
        }
        if (isStrict) {
            return deviation.rms() > 1.5 * deviation.noise();
        }
        const double noise = deviation.claimedNoise;
        Values ratios = deviation.difference.abs() / (deviation.uncertainty.square() + noise * noise).sqrt();
        const double worstReading = (ratios * (1.0 - deviation.isRight)).maxCoeff();
        const auto middle = ratios.begin() + ratios.size() / 2;
        std::nth_element(ratios.begin(), middle, ratios.end());
        return worstReading > kFar || (*middle > 3.0 && deviation.largest() > kVisible * deviation.peak());
    });
}

std::string falseDeviation(const Claim &claim)
{
    const Identification &found = claim.found;
    for (const ConventionFinding &finding : claim.diagnosis.conventions) {
        if (!(finding.after < finding.before) && (finding.before > 0.0 || finding.after > 0.0)) {
            return "a convention worsens the deviation";
        }
    }
    const auto isGood = [&](std::size_t line) { return !claim.file.badLines.contains(line); };
    if (std::ranges::any_of(found.excludedRows, isGood) ||
        (20 * found.excludedRows.size() > claim.file.lineCount && !claim.file.hasSaturation)) {
        return "excludes rows that are right";
    }
    if (claim.isIdentified() && !claim.file.hasSaturation && !explains(claim, found.parameters, false)) {
        return "does not name a column or wrong readings";
    }
    if (found.outcome == Identification::Outcome::None || found.outcome == Identification::Outcome::Insufficient) {
        return {};
    }
    const std::vector<Deviation> deviations = deviationsFrom(found.parameters, claim);
    for (const Deviation &deviation : deviations) {
        if (const std::string why = falsePrintedDeviation(claim, deviation); !why.empty()) {
            return why + ", " + std::string(nameOf(deviation.channel));
        }
    }
    return found.outcome == Identification::Outcome::Approximate ? falseApproximation(claim, deviations) : "";
}

} // namespace slidercrank
