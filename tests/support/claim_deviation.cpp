// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what a claim says about deviations, noise, omitted columns and excluded rows.
#include "tests/support/claim_judge.h"
#include "tests/support/claim_precision.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// The numbers of one column, as the claim interprets them, beside the motion of a mechanism. Rows that are excluded or
/// have no number are omitted.
struct Deviation {
    Channel channel;
    const ClaimColumn *column = nullptr;
    Values numbers{};
    Values motion{};
    Values difference{};  ///< of motion and numbers, without whole turns
    Values uncertainty{}; ///< standard deviation that noise and the rounding of numbers and time stamps explain
    Values excess{};      ///< of the difference over half a rounding step, at the best time within its rounding
    Values isBad{};       ///< 1 in rows with wrong readings

    double largest() const { return difference.abs().maxCoeff(); }
    double rms() const { return std::sqrt(difference.square().mean()); }
    double noise() const { return std::sqrt(uncertainty.square().mean()); }
    double peak() const { return (numbers.isZero() ? motion : numbers).abs().maxCoeff(); }
    double range() const { return motion.maxCoeff() - motion.minCoeff(); }
    double spread() const { return std::sqrt((numbers - numbers.mean()).square().mean()); }
    bool moves() const { return range() > 1e-6 * peak(); }
};
using Deviations = std::vector<Deviation>;

/// Returns the product of the unit factors that the claim found for a column.
double unitFactor(const Claim &claim, Channel channel)
{
    double factor = 1.0;
    for (const auto &[convention, before, after, standardError] : claim.diagnosis.conventions) {
        const bool isUnit = convention.kind == Kind::AngleUnit || convention.kind == Kind::LengthUnit;
        factor *= isUnit && concerns(convention, channel) ? convention.amount : 1.0;
    }
    return factor;
}

template <class List>
double valueFor(Channel channel, const List &list, double List::value_type::*value)
{
    const auto found = std::ranges::find(list, channel, &List::value_type::channel);
    return found == list.end() ? 0.0 : (*found).*value;
}

/// Returns the deviations of the columns from a mechanism: with the claim's conventions and without its excluded rows,
/// or as they are in the file.
Deviations deviationsFrom(const Parameters &p, const Claim &claim, bool isAsClaimed = true)
{
    const ClaimFile &file = claim.file;
    const ReferenceData &data = isAsClaimed ? claim.read : claim.data;
    Values times = Values::Map(data.time.data(), static_cast<Index>(data.time.size()));
    if (data.crank) {
        times = (Values::Map(data.crank->degrees.data(), times.size()) / kDegreesPerRadian - p.theta20) / p.omega2;
    }
    const Values late = Values::Constant(times.size(), 0.5 * file.timeStep * file.timeFactor);
    const std::array motions{motionOf(p, times), motionOf(p, times - late), motionOf(p, times + late)};
    Values isBad = Values::Zero(times.size());
    Values isExcluded = isBad;
    for (Index i = 0; i < times.size(); ++i) {
        const std::size_t line = data.lines[static_cast<std::size_t>(i)];
        isBad[i] = file.badRows.contains(std::ranges::find(file.lines, line) - file.lines.begin()) ? 1.0 : 0.0;
        const bool isNamed = std::ranges::count(claim.found.excludedRows, line) > 0;
        isExcluded[i] = isAsClaimed && (isNamed || (file.hasSaturation && isBad[i] > 0.0)) ? 1.0 : 0.0;
    }
    Deviations deviations;
    for (const ReferenceSeries &series : data.series) {
        const Channel channel = series.channel;
        const auto column = std::ranges::find(file.columns, channel, &ClaimColumn::named);
        const double factor = isAsClaimed ? unitFactor(claim, channel) : 1.0;
        const Values numbers = Values::Map(series.values.data(), times.size());
        const Values steps = column->form.stepsAt(numbers / factor) * std::abs(factor);
        std::array<Values, 3> motion;
        std::ranges::transform(motions, motion.begin(),
                               [&](const Poses &all) { return all.col(columnOf(channel)).cast<double>(); });
        std::vector<Index> rows;
        for (Index i = 0; i < times.size(); ++i) {
            if (std::isfinite(numbers[i] + motion[0][i]) && isExcluded[i] == 0.0) {
                rows.push_back(i);
            }
        }
        if (rows.empty() || (isAsClaimed && claim.has(Kind::SwappedColumns, channel))) {
            continue;
        }
        Deviation &deviation = deviations.emplace_back(Deviation{channel, &*column});
        const double rms = valueFor(channel, claim.found.noise, &Identification::Noise::rms);
        const Values blur = (motion[2] - motion[1]).isFinite().select(motion[2] - motion[1], 0.0);
        const bool hasTurns = isAngle(channel.coordinate) && channel.order == Order::Position;
        const Values difference = motion[0] - numbers;
        const Values nearest = difference.abs().min((motion[1] - numbers).abs()).min((motion[2] - numbers).abs());
        deviation.numbers = numbers(rows);
        deviation.motion = motion[0](rows);
        deviation.difference =
            difference(rows).unaryExpr([=](double x) { return hasTurns ? std::remainder(x, 360.0) : x; });
        deviation.uncertainty = ((steps.square() + blur.square()) / 12.0 + rms * rms).sqrt()(rows);
        deviation.excess = (nearest - 0.5 * steps)(rows);
        deviation.isBad = isBad(rows);
    }
    return deviations;
}

bool isUsed(const Claim &claim, Channel channel)
{
    return canBeFitted(channel) && !claim.isLeftOut(channel);
}

/// Checks that the printed deviations are those of the printed mechanism, and that `nearest` fits better than a
/// constant.
std::string falsePrintedDeviation(const Claim &claim, const Deviations &deviations)
{
    for (const Deviation &deviation : deviations) {
        const std::string name(nameOf(deviation.channel));
        const double tolerance = 0.02 * deviation.largest() + 1e-6 * deviation.peak() + deviation.noise();
        const auto differs = [&](double printed, double actual) { return std::abs(printed - actual) > tolerance; };
        const auto printed =
            std::ranges::find(claim.diagnosis.identified, deviation.channel, &ChannelComparison::channel);
        if (!claim.file.isByAngle && !claim.file.hasSaturation && printed != claim.diagnosis.identified.end() &&
            printed->maxAbs && differs(*printed->maxAbs, deviation.largest()) &&
            differs(*printed->maxAbs, (deviation.motion - deviation.numbers).abs().maxCoeff())) {
            return "false deviation of " + name;
        }
        const double leftOut =
            valueFor(deviation.channel, claim.found.leftOut, &Identification::LeftOut::percentOfPeak);
        if (claim.isLeftOut(deviation.channel) && differs(0.01 * leftOut * deviation.peak(), deviation.largest())) {
            return "false deviation of the omitted " + name;
        }
        if (claim.isNearest() && isUsed(claim, deviation.channel) && deviation.spread() > 1e-3 * deviation.peak() &&
            deviation.rms() > 1.2 * deviation.spread()) {
            return "a constant is nearer to " + name;
        }
    }
    return {};
}

/// Checks that every column and every wrong reading that an identified mechanism does not explain is named.
std::string unnamedDeviation(const Claim &claim, const Deviations &deviations)
{
    constexpr double kVisible = 5e-4; // of the peak
    constexpr double kFar = 16.0;     // twice the limit beyond which readings must be excluded
    for (const Deviation &deviation : deviations) {
        Values ratios = deviation.difference.abs() / deviation.uncertainty;
        const double worstReading = (ratios * deviation.isBad).maxCoeff();
        const auto middle = ratios.begin() + ratios.size() / 2;
        std::nth_element(ratios.begin(), middle, ratios.end());
        if (isUsed(claim, deviation.channel) &&
            (worstReading > kFar || (*middle > 3.0 && deviation.largest() > kVisible * deviation.peak()))) {
            return "does not name " + std::string(nameOf(deviation.channel)) + " or its wrong readings";
        }
    }
    return {};
}

/// Checks that the claimed noise does not exceed the noise of the correct readings.
std::string falseNoise(const Claim &claim)
{
    constexpr double kMost = 1.5;
    const ClaimFile &file = claim.file;
    for (const auto &[channel, rms] : claim.found.noise) {
        const ClaimColumn &column = *std::ranges::find(file.columns, channel, &ClaimColumn::named);
        const Values before = column.factor * file.exactValues(column.shown, file.instants - 0.5 * file.timeStep);
        const Values after = column.factor * file.exactValues(column.shown, file.instants + 0.5 * file.timeStep);
        const Values squares = (column.values - 0.5 * (before + after) - column.origin).square() +
                               (column.form.stepsAt(column.values).square() + (after - before).square()) / 12.0;
        double sum = 0.0;
        double count = 0.0;
        for (Index row = 0; row < squares.size(); ++row) {
            const bool isUsed = std::isfinite(squares[row]) && !file.badRows.contains(row);
            sum += isUsed ? squares[row] : 0.0;
            count += isUsed ? 1.0 : 0.0;
        }
        if (rms > kMost * std::sqrt(sum / std::max(count, 1.0)) * std::abs(unitFactor(claim, channel))) {
            return "too much noise of " + std::string(nameOf(channel)) + ", " + std::to_string(rms);
        }
    }
    return {};
}

/// Checks that an approximate mechanism explains every used column to 1 % and has no standard errors, and that round
/// numbers explain the file equally well, by the largest or by the rms deviation.
std::string falseApproximation(const Claim &claim, const Deviations &deviations)
{
    constexpr double kMost = 0.01;
    constexpr double kEqually = 1.15;
    const Deviations rounded = deviationsFrom(claim.diagnosis.rounded, claim);
    std::array<double, 4> parts{}; // of the range: largest and rms, then the same of the rounded mechanism
    for (std::size_t k = 0; k < deviations.size(); ++k) {
        const Deviation &deviation = deviations[k];
        const double noise = deviation.column->noise + deviation.noise();
        const double range = deviation.range();
        if (!isUsed(claim, deviation.channel) || !deviation.moves()) {
            continue;
        }
        if (deviation.rms() > kMost * range + noise || deviation.largest() > kMost * range + 5.0 * noise) {
            return "approximate, but " + std::string(nameOf(deviation.channel)) + " is far";
        }
        const std::array sizes{deviation.largest(), deviation.rms(), rounded[k].largest(), rounded[k].rms()};
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            parts[i] = std::max(parts[i], sizes[i] / (i < 2 ? range : rounded[k].range()));
        }
    }
    if (std::ranges::any_of(claim.found.standardError, [](double error) { return std::isfinite(error); })) {
        return "standard errors of an approximate mechanism";
    }
    return parts[2] <= kEqually * parts[0] || parts[3] <= kEqually * parts[1] ? "" : "the round numbers deviate more";
}

std::string falseExclusion(const Claim &claim)
{
    const std::vector<std::size_t> &excluded = claim.found.excludedRows;
    const auto isRight = [&](std::size_t line) {
        return !claim.file.badRows.contains(std::ranges::find(claim.file.lines, line) - claim.file.lines.begin());
    };
    const bool isTooMuch = 20 * excluded.size() > claim.file.lines.size() && !claim.file.hasSaturation;
    return isTooMuch || std::ranges::any_of(excluded, isRight) ? "excludes rows that are right" : "";
}

/// Finds a verdict better than `differs` for a motion whose error exceeds 2 % of its peak plus half a rounding step.
std::string falseVerdict(const std::vector<ChannelComparison> &verdicts, const Parameters &p,
                         const Deviations &deviations)
{
    constexpr double kVisible = 0.02;
    for (const Deviation &deviation : deviations) {
        const auto verdict = std::ranges::find(verdicts, deviation.channel, &ChannelComparison::channel);
        const double least = 1e-9 * toFileUnit(deviation.channel, naturalSize(p, deviation.channel));
        if (verdict != verdicts.end() && verdict->verdict != Verdict::Differs &&
            deviation.excess.maxCoeff() > kVisible * std::max(deviation.motion.abs().maxCoeff(), least)) {
            return "false verdict of " + std::string(nameOf(deviation.channel));
        }
    }
    return {};
}

/// Checks that no channel differs from its own motion if the columns contain that motion in the stated units.
std::string falseDifference(const Claim &claim)
{
    const ClaimFile &file = claim.file;
    const bool isPlain = file.truth && !file.isByAngle && file.timeFactor == 1.0 && file.badRows.empty() &&
                         std::ranges::all_of(file.columns, [](const ClaimColumn &column) {
                             return column.content == ClaimColumn::Content::Motion && column.named == column.shown &&
                                    column.factor == 1.0 && column.origin == 0.0 && column.noise == 0.0 &&
                                    column.form.quantum == 0.0 && !column.form.isTruncated;
                         });
    if (isPlain) {
        for (const ChannelComparison &channel : compareExactly(Mechanism(*file.truth), claim.data).channels) {
            if (channel.verdict == Verdict::Differs) {
                return std::string(nameOf(channel.channel)) + " differs from its own motion";
            }
        }
    }
    return {};
}

} // namespace

std::string falseDeviation(const Claim &claim)
{
    const auto worsens = [](const ConventionFinding &finding) {
        return !(finding.after < finding.before) && (finding.before > 0.0 || finding.after > 0.0);
    };
    const auto isAxis = [](const ConventionFinding &finding) { return finding.convention.kind == Kind::Axis; };
    std::string wrong;
    const auto add = [&wrong](const std::string &statement) { wrong += statement.empty() ? "" : statement + "; "; };
    add(std::ranges::any_of(claim.diagnosis.conventions, worsens) ? "a convention worsens the deviation" : "");
    add(falseExclusion(claim));
    if (std::ranges::none_of(claim.diagnosis.conventions, isAxis) &&
        (claim.isIdentified() || claim.isApproximate() || claim.isNearest())) {
        const Parameters &p = claim.found.parameters;
        const Deviations deviations = deviationsFrom(p, claim);
        add(claim.data.crank ? "" : falseVerdict(claim.diagnosis.identified, p, deviations));
        add(falsePrintedDeviation(claim, deviations));
        add(claim.isIdentified() && !claim.file.hasSaturation ? unnamedDeviation(claim, deviations) : "");
        add(claim.isIdentified() && claim.file.truth ? falseNoise(claim) : "");
        add(claim.isApproximate() ? falseApproximation(claim, deviations) : "");
    }
    if (!claim.data.crank) {
        const std::vector<ChannelComparison> given = compareExactly(Mechanism(claim.file.given), claim.data).channels;
        add(falseVerdict(given, claim.file.given, deviationsFrom(claim.file.given, claim, false)));
    }
    add(falseDifference(claim));
    return wrong;
}

} // namespace slidercrank
