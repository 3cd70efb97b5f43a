// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_deviation.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

bool canBeFitted(Channel channel)
{
    return channel.coordinate == Theta3 || channel.coordinate == R4x || channel == kY ||
           (channel.coordinate == Theta2 && channel.order != Order::Acceleration);
}

/// Returns the product of the unit factors that the claim found for a column.
double unitFactor(const ProgramClaim &claim, Channel channel)
{
    double factor = 1.0;
    for (const Finding &finding : claim.findings) {
        if (finding.name.ends_with("-unit") && std::ranges::count(finding.channels, channel) > 0) {
            factor *= finding.amount;
        }
    }
    return factor;
}

/// Deviation of one column, as interpreted by the claim, from the claimed motion.
struct ColumnDeviation {
    Channel channel;
    const ClaimColumn *column = nullptr;
    double largest = 0.0;
    double largestWithTurns = 0.0; ///< the same without removing whole turns from angles
    double rms = 0.0;
    double peak = 0.0;                ///< of the numbers
    double range = 0.0;               ///< largest minus smallest value of the motion
    double spread = 0.0;              ///< standard deviation of the numbers
    double uncertainty = 0.0;         ///< rms explained by noise and by the rounding of values and time stamps
    double medianUncertainties = 0.0; ///< median of |deviation| / uncertainty over the rows
    double mostUncertainties = 0.0;   ///< largest ratio among rows with wrong readings that are not excluded
};

class Deviations
{
public:
    Deviations(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim, const Parameters &mechanism)
        : m_file(file)
        , m_claim(claim)
        , m_mechanism(mechanism)
    {
        for (const std::size_t line : data.lines) {
            m_rows.push_back(static_cast<std::size_t>(std::ranges::find(file.lines, line) - file.lines.begin()));
        }
    }

    /// Returns the deviations of all columns except swapped ones.
    std::vector<ColumnDeviation> all() const
    {
        std::vector<ColumnDeviation> deviations;
        for (const ReferenceSeries &series : m_claim.read.series) {
            if (!hasFinding(m_claim, "swapped-columns", series.channel)) {
                deviations.push_back(of(series));
            }
        }
        return deviations;
    }

    bool isExcluded(std::size_t i) const
    {
        return isKnown(i) && ((m_file.hasSaturation && isBad(i)) ||
                              std::ranges::count(m_claim.excludedLines, m_file.lines[m_rows[i]]) > 0);
    }

private:
    ColumnDeviation of(const ReferenceSeries &series) const
    {
        const Channel channel = series.channel;
        const ClaimColumn &column = *std::ranges::find(m_file.columns, channel, &ClaimColumn::named);
        const double factor = unitFactor(m_claim, channel);
        const auto noise = std::ranges::find(m_claim.noise, channel, &ProgramClaim::ChannelValue::channel);
        const double rms = noise == m_claim.noise.end() ? 0.0 : noise->value;
        ColumnDeviation deviation{channel, &column};
        std::vector<double> ratios;
        double count = 0.0, sum = 0.0, squares = 0.0, low = INFINITY, high = -INFINITY;
        for (std::size_t i = 0; i < series.values.size(); ++i) {
            const double value = series.values[i];
            const double motion = at(i, channel);
            if (!std::isfinite(value) || !std::isfinite(motion) || isExcluded(i)) {
                continue;
            }
            const double difference = static_cast<double>(differenceIn(channel, motion, value));
            const double step = column.form.stepAt(value / factor) * std::abs(factor);
            const double half = 0.5 * m_file.timeStep * m_file.timeFactor;
            const double blur = half > 0.0 ? at(i, channel, half) - at(i, channel, -half) : 0.0;
            const double variance = (step * step + (std::isfinite(blur) ? blur * blur : 0.0)) / 12.0 + rms * rms;
            ratios.push_back(std::abs(difference) / std::sqrt(variance));
            deviation.largest = std::max(deviation.largest, std::abs(difference));
            deviation.largestWithTurns = std::max(deviation.largestWithTurns, std::abs(motion - value));
            deviation.peak = std::max(deviation.peak, std::abs(value));
            deviation.rms += difference * difference;
            deviation.uncertainty += variance;
            if (isBad(i)) {
                deviation.mostUncertainties = std::max(deviation.mostUncertainties, ratios.back());
            }
            low = std::min(low, motion);
            high = std::max(high, motion);
            count += 1.0;
            sum += value;
            squares += value * value;
        }
        if (!ratios.empty()) {
            const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
            std::ranges::nth_element(ratios, middle);
            deviation.medianUncertainties = *middle;
        }
        count = std::max(count, 1.0);
        deviation.rms = std::sqrt(deviation.rms / count);
        deviation.uncertainty = std::sqrt(deviation.uncertainty / count);
        deviation.range = high > low ? high - low : 0.0;
        deviation.peak = deviation.peak > 0.0 ? deviation.peak : std::max(std::abs(low), std::abs(high));
        deviation.spread = std::sqrt(std::max(squares / count - sum / count * sum / count, 0.0));
        return deviation;
    }

    bool isBad(std::size_t i) const { return isKnown(i) && m_file.badRows.contains(m_rows[i]); }
    bool isKnown(std::size_t i) const { return i < m_rows.size() && m_rows[i] < m_file.lines.size(); }

    double at(std::size_t i, Channel channel, double late = 0.0) const
    {
        const Parameters &p = m_mechanism;
        const std::optional<CrankAngles> &crank = m_claim.read.crank;
        const Pose pose = crank ? poseAt(p, crank->degrees[i] / kDegreesPerRadian, p.omega2)
                                : motionAt(p, m_claim.read.time[i] + late);
        return static_cast<double>(pose[indexOf(channel)]);
    }

    const ClaimFile &m_file;
    const ProgramClaim &m_claim;
    const Parameters m_mechanism;
    std::vector<std::size_t> m_rows; ///< row of the file for each row of the data
};

std::string percent(double part)
{
    return std::to_string(100.0 * part) + " %";
}

/// Checks that the printed deviations are those of the printed mechanism, and that `nearest` fits better than a
/// constant.
std::string falsePrintedDeviation(const ClaimFile &file, const ProgramClaim &claim,
                                  const std::vector<ColumnDeviation> &deviations)
{
    for (const ColumnDeviation &deviation : deviations) {
        const std::string name(nameOf(deviation.channel));
        const double tolerance = 0.02 * deviation.largest + 1e-6 * deviation.peak + deviation.uncertainty;
        const auto printed = std::ranges::find(claim.identified, deviation.channel, &ChannelComparison::channel);
        if (!file.byAngle && !file.hasSaturation && printed != claim.identified.end() && printed->maxAbs &&
            std::abs(*printed->maxAbs - deviation.largest) > tolerance &&
            std::abs(*printed->maxAbs - deviation.largestWithTurns) > tolerance) {
            return "says that " + name + " deviates by " + percent(*printed->maxAbs / deviation.peak) +
                   " of its peak, not " + percent(deviation.largest / deviation.peak);
        }
        const auto leftOut = std::ranges::find(claim.leftOut, deviation.channel, &ProgramClaim::ChannelValue::channel);
        if (leftOut != claim.leftOut.end() &&
            std::abs(0.01 * leftOut->value * deviation.peak - deviation.largest) > tolerance) {
            return "leaves out " + name + " as off by " + percent(0.01 * leftOut->value) + " of its peak, not " +
                   percent(deviation.largest / deviation.peak);
        }
        const bool moves = deviation.spread > 1e-3 * deviation.peak;
        if (claim.outcome == ClaimedOutcome::Nearest && leftOut == claim.leftOut.end() && moves &&
            canBeFitted(deviation.channel) && deviation.rms > 1.2 * deviation.spread) {
            return "nearest is off by " + percent(deviation.rms / deviation.spread) + " of the spread of " + name;
        }
    }
    return {};
}

/// Checks that every column and every wrong reading that an identified mechanism does not explain is named.
std::string unnamedDeviation(const ProgramClaim &claim, const std::vector<ColumnDeviation> &deviations)
{
    constexpr double kVisible = 5e-4; // of the peak
    constexpr double kFar = 16.0;     // twice the limit beyond which readings must be excluded
    for (const ColumnDeviation &deviation : deviations) {
        if (isLeftOut(claim, deviation.channel) || !canBeFitted(deviation.channel)) {
            continue;
        }
        const std::string name(nameOf(deviation.channel));
        if (deviation.mostUncertainties > kFar) {
            return "a reading of " + name + " that is off by " + std::to_string(deviation.mostUncertainties) +
                   " standard deviations is not named";
        }
        if (deviation.medianUncertainties > 3.0 && deviation.largest > kVisible * deviation.peak) {
            return name + " is not named, which is off by " + percent(deviation.largest / deviation.peak) +
                   " of its peak and " + std::to_string(deviation.medianUncertainties) + " times its uncertainty";
        }
    }
    return {};
}

/// Checks that the claimed noise does not exceed the noise of the correct readings.
std::string falseNoise(const ClaimFile &file, const ProgramClaim &claim)
{
    constexpr double kMost = 1.5;
    for (const auto &[channel, rms] : claim.noise) {
        const auto column = std::ranges::find(file.columns, channel, &ClaimColumn::named);
        double count = 0.0, squares = 0.0;
        for (std::size_t row = 0; row < file.instants.size(); ++row) {
            const double late = 0.5 * file.timeStep;
            const double before = file.exactValue(column->shown, file.instants[row] - late) * column->factor;
            const double after = file.exactValue(column->shown, file.instants[row] + late) * column->factor;
            const double difference = column->values[row] - 0.5 * (before + after) - column->origin;
            const double step = column->form.stepAt(column->values[row]);
            const double square = difference * difference + (step * step + (after - before) * (after - before)) / 12.0;
            if (std::isfinite(square) && !file.badRows.contains(row)) {
                squares += square;
                count += 1.0;
            }
        }
        const double actual = std::sqrt(squares / std::max(count, 1.0)) * std::abs(unitFactor(claim, channel));
        if (rms > kMost * actual) {
            return "noise of " + std::to_string(rms) + " in " + std::string(nameOf(channel)) + ", not " +
                   std::to_string(actual);
        }
    }
    return {};
}

/// Checks that an approximate mechanism explains every used column to 1 % and has no standard errors.
std::string falseApproximation(const ProgramClaim &claim, const std::vector<ColumnDeviation> &deviations)
{
    constexpr double kMost = 0.01;
    const bool hasError = std::ranges::any_of(claim.standardError, [](double error) { return std::isfinite(error); });
    if (hasError) {
        return "standard errors of an approximate mechanism";
    }
    for (const ColumnDeviation &deviation : deviations) {
        if (!canBeFitted(deviation.channel) || isLeftOut(claim, deviation.channel)) {
            continue;
        }
        const bool moves = deviation.range > 1e-6 * deviation.peak;
        const double noise = deviation.column->noise + deviation.uncertainty;
        if (moves && (deviation.rms > kMost * deviation.range + noise ||
                      deviation.largest > kMost * deviation.range + 5.0 * noise)) {
            return "approximate, but " + std::string(nameOf(deviation.channel)) + " is off by " +
                   percent(deviation.largest / deviation.range) + " of its range";
        }
    }
    return {};
}

/// Checks that the round numbers explain the file equally well, by the largest or by the rms deviation.
std::string falseRounding(const ProgramClaim &claim, const std::vector<ColumnDeviation> &exact,
                          const std::vector<ColumnDeviation> &rounded)
{
    constexpr double kEqually = 1.15;
    const auto largest = [&](const std::vector<ColumnDeviation> &deviations, double ColumnDeviation::*size) {
        double part = 0.0;
        for (const ColumnDeviation &deviation : deviations) {
            const bool isUsed = canBeFitted(deviation.channel) && !isLeftOut(claim, deviation.channel);
            if (isUsed && deviation.range > 1e-6 * deviation.peak) {
                part = std::max(part, deviation.*size / deviation.range);
            }
        }
        return part;
    };
    for (const auto size : {&ColumnDeviation::largest, &ColumnDeviation::rms}) {
        if (largest(rounded, size) <= kEqually * largest(exact, size)) {
            return {};
        }
    }
    return "round numbers deviate by " + percent(largest(rounded, &ColumnDeviation::largest)) + " instead of " +
           percent(largest(exact, &ColumnDeviation::largest));
}

std::string falseExclusion(const ClaimFile &file, const ProgramClaim &claim)
{
    if (20 * claim.excludedLines.size() > file.instants.size() && !file.hasSaturation) {
        return std::to_string(claim.excludedLines.size()) + " rows of " + std::to_string(file.instants.size()) +
               " are excluded";
    }
    for (const std::size_t line : claim.excludedLines) {
        const auto row = std::ranges::find(file.lines, line) - file.lines.begin();
        if (!file.badRows.contains(static_cast<std::size_t>(row))) {
            return "excludes line " + std::to_string(line) + ", which is right";
        }
    }
    return {};
}

/// Finds a verdict better than `differs` for a motion whose error exceeds 2 % of its peak plus half a rounding step.
std::string falseVerdict(const ClaimFile &file, const ReferenceData &read,
                         const std::vector<ChannelComparison> &verdicts, const Parameters &model,
                         const ProgramClaim *claim, const Deviations &reader)
{
    constexpr double kVisible = 0.02;
    for (const ChannelComparison &verdict : verdicts) {
        const ReferenceSeries *series = read.find(verdict.channel);
        const auto column = std::ranges::find(file.columns, verdict.channel, &ClaimColumn::named);
        if (verdict.verdict == Verdict::Differs || series == nullptr || read.crank ||
            (claim && hasFinding(*claim, "swapped-columns", verdict.channel))) {
            continue;
        }
        const double factor = claim ? unitFactor(*claim, verdict.channel) : 1.0;
        double peak = 1e-9 * toFileUnit(verdict.channel, naturalSize(model, verdict.channel));
        double excess = 0.0;
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            const double value = series->values[i];
            if (!std::isfinite(value) || (claim && reader.isExcluded(i))) {
                continue;
            }
            double least = INFINITY;
            for (const double late : {0.0, -0.5, 0.5}) { // in rounding steps of the time
                const double t = read.time[i] + late * file.timeStep * file.timeFactor;
                const double motion = static_cast<double>(motionAt(model, t)[indexOf(verdict.channel)]);
                peak = late == 0.0 ? std::max(peak, std::abs(motion)) : peak;
                least = std::min(least, std::abs(motion - value));
            }
            excess = std::max(excess, least - 0.5 * column->form.stepAt(value / factor) * std::abs(factor));
        }
        if (excess > kVisible * peak) {
            return std::string(verdict.verdict == Verdict::Agrees ? "agrees" : "close") + " in " +
                   std::string(nameOf(verdict.channel)) + ", which is off by " + percent(excess / peak) +
                   " of the peak";
        }
    }
    return {};
}

/// Returns whether the columns contain the exact motion in the stated units.
bool isPlain(const ClaimFile &file)
{
    return file.truth && !file.byAngle && file.timeFactor == 1.0 && file.timeOffset == 0.0 && file.badRows.empty() &&
           std::ranges::all_of(file.columns, [](const ClaimColumn &column) {
               return column.content == ClaimColumn::Content::Motion && column.named == column.shown &&
                      column.factor == 1.0 && column.origin == 0.0 && column.noise == 0.0 &&
                      column.form.quantum == 0.0 && !column.form.isTruncated;
           });
}

} // namespace

bool isLeftOut(const ProgramClaim &claim, Channel channel)
{
    return std::ranges::count(claim.leftOut, channel, &ProgramClaim::ChannelValue::channel) > 0;
}

bool hasFinding(const ProgramClaim &claim, std::string_view name, Channel channel)
{
    return std::ranges::any_of(claim.findings, [&](const Finding &finding) {
        return finding.name == name && std::ranges::count(finding.channels, channel) > 0;
    });
}

long double differenceIn(Channel channel, long double one, long double other)
{
    const long double difference = one - other;
    const bool isPosition = isAngle(channel.coordinate) && channel.order == Order::Position;
    return isPosition ? std::remainder(difference, 360.0L) : difference;
}

std::string falseDeviation(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim)
{
    for (const ProgramClaim::ClaimedFinding &finding : claim.findings) {
        if (!(finding.after < finding.before) && (finding.before > 0.0 || finding.after > 0.0)) {
            return std::string(finding.name) + " leaves " + percent(0.01 * finding.after) + " of " +
                   percent(0.01 * finding.before);
        }
    }
    const Deviations reader(file, data, claim, claim.parameters);
    const bool isIdentified = claim.outcome == ClaimedOutcome::Identified || claim.outcome == ClaimedOutcome::Ambiguous;
    const bool isApproximate = claim.outcome == ClaimedOutcome::Approximate;
    std::string wrong = falseExclusion(file, claim);
    if (std::ranges::none_of(claim.findings, [](const Finding &finding) { return finding.name == "axis"; }) &&
        (isIdentified || isApproximate || claim.outcome == ClaimedOutcome::Nearest)) {
        const std::vector<ColumnDeviation> deviations = reader.all();
        wrong +=
            wrong.empty() ? falseVerdict(file, claim.read, claim.identified, claim.parameters, &claim, reader) : "";
        wrong += wrong.empty() ? falsePrintedDeviation(file, claim, deviations) : "";
        wrong += wrong.empty() && isIdentified && !file.hasSaturation ? unnamedDeviation(claim, deviations) : "";
        wrong += wrong.empty() && isIdentified && file.truth ? falseNoise(file, claim) : "";
        wrong += wrong.empty() && isApproximate ? falseApproximation(claim, deviations) : "";
        if (wrong.empty() && isApproximate) {
            wrong = falseRounding(claim, deviations, Deviations(file, data, claim, claim.rounded).all());
        }
    }
    if (wrong.empty()) {
        const ExactComparison given = compareExactly(Mechanism(file.given), data);
        wrong = falseVerdict(file, data, given.channels, file.given, nullptr, reader);
    }
    if (wrong.empty() && isPlain(file)) {
        for (const ChannelComparison &channel : compareExactly(Mechanism(*file.truth), data).channels) {
            if (channel.verdict == Verdict::Differs) {
                wrong = "differs in " + std::string(nameOf(channel.channel)) + " from its own motion, by " +
                        std::to_string(channel.worstOver) + " half steps";
            }
        }
    }
    return wrong;
}

} // namespace slidercrank
