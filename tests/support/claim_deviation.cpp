// SPDX-License-Identifier: GPL-3.0-or-later
// Judges what a claim says about residuals and excluded rows, by the motion of the mechanisms that it names.
#include "tests/support/claim_judge.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;
using Outcome = Identification::Outcome;

/// The numbers of one column, after the claimed conventions are applied, and the motion of a mechanism minus these
/// numbers. Rows that are excluded or have no number are omitted.
struct Deviation {
    Channel channel;
    Values numbers{};
    Values difference{};  ///< of an angle: without whole turns
    Values uncertainty{}; ///< standard deviation of noise and of the rounding of numbers, time stamps and lengths

    double largest() const { return difference.abs().maxCoeff(); }
    double rms() const { return std::sqrt(difference.square().mean()); }
    double noise() const { return std::sqrt(uncertainty.square().mean()); }
    double peak() const { return numbers.abs().maxCoeff(); }
    double range() const { return numbers.maxCoeff() - numbers.minCoeff(); }
};

/// Returns the product of the unit factors that the claim found for a column.
double unitFactor(const Claim &claim, Channel channel)
{
    double factor = 1.0;
    for (const ConventionFinding &finding : claim.found.conventions) {
        const Convention &convention = finding.convention;
        const bool isUnit = convention.kind == Kind::AngleUnit || convention.kind == Kind::LengthUnit;
        factor *= isUnit && concerns(convention, channel) ? convention.amount : 1.0;
    }
    return factor;
}

/// Returns the times at which the crank of a mechanism has the angles of the rows. With an uneven drive, these are not
/// the time stamps.
Values timesOf(const Parameters &p, const Claim &claim)
{
    const ReferenceData &data = claim.read;
    const ReferenceSeries *angles = data.find(kTheta2);
    const auto toValues = [](const std::vector<double> &column) {
        return Values(Values::Map(column.data(), static_cast<Index>(column.size())));
    };
    if (data.crank) {
        return (toValues(data.crank->degrees) / kDegreesPerRadian - p.theta20) / p.omega2;
    }
    if (claim.found.drive && angles) {
        return (toValues(angles->values) / kDegreesPerRadian - p.theta20) / p.omega2;
    }
    return toValues(data.time);
}

std::vector<Deviation> deviationsFrom(Parameters p, const Claim &claim)
{
    const ClaimTable &table = claim.table;
    const ReferenceData &data = claim.read;
    const bool isUneven = claim.found.drive.has_value();
    if (isUneven) {
        p.omega2 = 1.0; // positions over θ2 do not depend on the speed
    }
    Parameters withLongerCoupler = p; // the rounding of b changes the motion much near a toggle
    withLongerCoupler.b *= 1.0 + 1e-15;
    const Values times = timesOf(p, claim);
    std::vector<Deviation> deviations;
    for (const ReferenceSeries &series : data.series) {
        const Channel channel = series.channel;
        const auto column = std::ranges::find(table.columns, nameOf(channel), &ClaimColumn::heading);
        if (column == table.columns.end() || (isUneven && (channel.order != Order::Position || channel == kTheta2))) {
            continue;
        }
        const double factor = std::abs(unitFactor(claim, channel));
        const Values numbers = Values::Map(series.values.data(), times.size());
        const Values motion = valuesOf(p, channel, times);
        const Values changeByTimeStep = valuesOf(p, channel, times + table.timeStep()) - motion;
        const Values rounding = valuesOf(withLongerCoupler, channel, times) - motion;
        const double peak = numbers.isFinite().select(numbers, 0.0).abs().maxCoeff();
        const double finest =
            0.01 * column->stepAt(peak / factor); // the step of a value near 0 may be arbitrarily small
        const Values steps = column->stepsAt(numbers / factor).max(finest) * factor;
        std::vector<Index> rows;
        for (Index i = 0; i < times.size(); ++i) {
            const std::size_t line = data.lines[static_cast<std::size_t>(i)];
            const bool isExcluded = std::ranges::count(claim.found.excludedRows, line) > 0 ||
                                    (table.hasSaturation && table.badLines.contains(line));
            if (std::isfinite(numbers[i] + motion[i] + changeByTimeStep[i]) && !isExcluded) {
                rows.push_back(i);
            }
        }
        if (!rows.empty()) {
            const bool hasTurns = isAngle(channel.coordinate) && channel.order == Order::Position;
            const double noise = column->noise * factor;
            Deviation &deviation = deviations.emplace_back(Deviation{channel});
            deviation.numbers = numbers(rows);
            deviation.difference =
                (motion - numbers)(rows).unaryExpr([=](double x) { return hasTurns ? std::remainder(x, 360.0) : x; });
            deviation.uncertainty =
                ((steps.square() + changeByTimeStep.square()) / 12.0 + rounding.square() + noise * noise).sqrt()(rows);
        }
    }
    return deviations;
}

/// Describes a claimed residual that is not that of the mechanism, or too large for the outcome. Empty if it is right.
std::string falseColumn(const Claim &claim, const Deviation &deviation)
{
    constexpr double kApproximate = 0.02; // of the range, rms
    constexpr double kExact = 1e-3;       // of the range, beyond rounding
    const std::string name(nameOf(deviation.channel));
    const auto claimed = std::ranges::find(claim.found.residuals, deviation.channel, &ColumnResidual::channel);
    const double tolerance = 0.02 * deviation.largest() + 1e-6 * deviation.peak() + 2.0 * deviation.noise();
    if (claimed == claim.found.residuals.end()) {
        return "no residual of " + name;
    }
    if (std::abs(claimed->max - deviation.largest()) > tolerance ||
        std::abs(claimed->rms - deviation.rms()) > tolerance) {
        return "residual of " + name + " is " + std::to_string(deviation.largest()) + ", not " +
               std::to_string(claimed->max);
    }
    const double limit = claim.found.outcome == Outcome::Identified ? kExact : kApproximate;
    const double errorOfC = claim.found.standardErrors[indexOf(Parameter::C)];
    const double offsetError = deviation.channel == kR4y && std::isfinite(errorOfC) ? errorOfC : 0.0;
    const double allowed = limit * deviation.range() + 3.0 * deviation.noise() + 5.0 * offsetError;
    return deviation.rms() > allowed ? name + " is not explained" : "";
}

} // namespace

bool explainsExactly(const Claim &claim, const Parameters &parameters)
{
    return std::ranges::none_of(deviationsFrom(parameters, claim), [&](const Deviation &deviation) {
        return claim.isUsed(deviation.channel) && deviation.rms() > 1.5 * deviation.noise();
    });
}

std::string falseResidual(const Claim &claim)
{
    const Identification &found = claim.found;
    const auto isRight = [&](std::size_t line) { return !claim.table.badLines.contains(line); };
    if (!found.hasMechanism()) {
        return {};
    }
    if (!claim.table.hasSaturation && !claim.table.hasSteepRows &&
        (std::ranges::any_of(found.excludedRows, isRight) || 20 * found.excludedRows.size() > claim.table.lineCount)) {
        return "excludes rows that are right";
    }
    const std::vector<Deviation> deviations = deviationsFrom(found.parameters, claim);
    for (const Deviation &deviation : deviations) {
        if (claim.isUsed(deviation.channel) && !claim.table.hasSaturation) {
            if (const std::string why = falseColumn(claim, deviation); !why.empty()) {
                return why;
            }
        }
    }
    for (const AlternativeMechanism &alternative : found.alternatives) {
        const std::vector<Deviation> others = deviationsFrom(alternative.parameters, claim);
        for (std::size_t k = 0; k < std::min(deviations.size(), others.size()); ++k) {
            if (claim.isUsed(others[k].channel) &&
                others[k].rms() > 1.1 * deviations[k].rms() + deviations[k].noise()) {
                return "a false alternative, " + std::string(nameOf(others[k].channel));
            }
        }
    }
    return {};
}

} // namespace slidercrank
