// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/file_comparison.h"

#include "core/identification/reading_conventions.h"
#include "core/identification/whole_file_conventions.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Converts the positions of a file with θ2 to a table over the crank angle, which is sorted by θ2 without jumps. Rows
/// without θ2 are left out. Of several rows with the same θ2, only the first one remains, because a table has distinct
/// angles.
ReferenceData tableOverAngle(const ReferenceData &data)
{
    const ReferenceSeries &crank = *data.find(kCrankAngle);
    std::vector<double> degrees = crank.values;
    removeJumps(degrees, kTurnInDegrees);
    std::vector<std::size_t> rows(degrees.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::erase_if(rows, [&](std::size_t row) { return !std::isfinite(degrees[row]); });
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return degrees[row]; });
    const auto isRepeated = [&](std::size_t row, std::size_t next) { return degrees[row] == degrees[next]; };
    rows.erase(std::unique(rows.begin(), rows.end(), isRepeated), rows.end());
    const auto inTable = [&](const std::vector<double> &values) {
        std::vector<double> sorted(rows.size());
        std::ranges::transform(rows, sorted.begin(), [&](std::size_t row) { return values[row]; });
        return sorted;
    };
    ReferenceData table;
    table.crank = CrankAngles{.degrees = inTable(degrees), .rounding = crank.rounding};
    for (const ReferenceSeries &series : data.series) {
        if (series.channel.order == Order::Position && series.channel != kCrankAngle) {
            table.series.push_back({series.channel, inTable(series.values), series.rounding});
        }
    }
    return table;
}

/// Applies conventions to the data in their order.
ReferenceData applyAll(const std::vector<ConventionFinding> &conventions, ReferenceData data)
{
    for (const ConventionFinding &finding : conventions) {
        data = applied(finding.convention, std::move(data));
    }
    return data;
}

/// Compares a mechanism with a corrected file, to which all conventions have been applied. If a file with θ2 does not
/// show a constant speed, positions are compared as in a table over the crank angle, and derivatives are not compared.
/// `fitted`: how the mechanism was fitted to the file; {} if it was not.
std::vector<ChannelComparison> compareCorrectedFile(const Parameters &mechanism, const ReferenceData &data,
                                                    const Findings &findings, const FittedMechanism &fitted)
{
    const Drive &drive = findings.drive;
    const bool overAngle = drive.hasChangingSpeed() || (drive.kind == Drive::Kind::OverAngle && !data.crank);
    // A table over the angle is compared as if the crank turned by one radian per second from 0.
    constexpr double kUnitSpeed = 1.0;
    constexpr double kStartAngle = 0.0;
    const Mechanism timed = overAngle ? withDrive(Mechanism(mechanism), kUnitSpeed, kStartAngle) : Mechanism(mechanism);
    const std::optional<ReferenceData> reference = timedBy(timed, overAngle ? tableOverAngle(data) : data);
    const std::stop_token &stop = findings.lastFit.observations.stop;
    return reference ? compareExactly(timed, *reference, stop, fitted).channels : std::vector<ChannelComparison>();
}

/// Whether a convention changes the comparison of every column: it changes the times, the axes or the model, or θ2
/// where this is the abscissa.
bool changesAllColumns(const Convention &convention, bool isAngleAbscissa)
{
    constexpr std::array kKindsOfAllColumns{Kind::TimeUnit, Kind::TimeShift, Kind::Axis, Kind::OtherAssembly};
    return std::ranges::find(kKindsOfAllColumns, convention.kind) != kKindsOfAllColumns.end() ||
           (isAngleAbscissa && concerns(convention, kCrankAngle));
}

/// The largest error of the columns that a convention changes, in percent of their peaks.
double largestPercentOfPeak(const std::vector<ChannelComparison> &comparisons, const Convention &convention,
                            bool isAngleAbscissa)
{
    const bool changesAll = changesAllColumns(convention, isAngleAbscissa);
    double largest = 0.0;
    for (const ChannelComparison &comparison : comparisons) {
        if (changesAll || concerns(convention, comparison.channel)) {
            largest = std::max(largest, comparison.percentOfPeak.value_or(0.0));
        }
    }
    return largest;
}

/// Sets the largest errors of a mechanism without (`before`) and with (`after`) each convention of the file.
/// `usedColumns`: as they are in the file.
void measureConventions(std::vector<ConventionFinding> &conventions, const Parameters &mechanism,
                        const ReferenceData &usedColumns, const Findings &findings)
{
    const FittedMechanism notFitted{}; // the percentages do not depend on how the mechanism was fitted
    if (conventions.empty()) {
        return;
    }
    const std::vector<ChannelComparison> withAll =
        compareCorrectedFile(mechanism, applyAll(conventions, usedColumns), findings, notFitted);
    for (std::size_t i = 0; i < conventions.size(); ++i) {
        const Convention &convention = conventions[i].convention;
        std::vector<ConventionFinding> others = conventions;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        Parameters without = mechanism;
        if (convention.kind == Convention::Kind::OtherAssembly) {
            without.branch = oppositeBranch(mechanism.branch);
        }
        const std::vector<ChannelComparison> withOthers =
            compareCorrectedFile(without, applyAll(others, usedColumns), findings, notFitted);
        const bool isAngleAbscissa = findings.lastFit.fit.model.followsAngle;
        conventions[i].before = largestPercentOfPeak(withOthers, convention, isAngleAbscissa);
        conventions[i].after = largestPercentOfPeak(withAll, convention, isAngleAbscissa);
    }
}

/// The file with gaps in the excluded rows, and without the columns that the fit does not use. (It uses θ2 if its model
/// follows the angle in the file.) `tableConvention`: the one that was applied before the file was observed. It is
/// applied here only to find out which columns the fit uses; the columns returned are as they are in the file.
ReferenceData keepUsedColumns(ReferenceData data, const std::optional<Convention> &tableConvention,
                              const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    const ReferenceData observed = tableConvention ? applied(*tableConvention, data) : data;
    std::vector<ReferenceSeries> used;
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        const Channel channel = observed.series[i].channel;
        const auto isChannel = [&](Index k) { return observations.columns[k].channel == channel; };
        if (std::ranges::any_of(lastFit.fit.columns, isChannel)) {
            used.push_back(std::move(data.series[i]));
            for (const Index row : lastFit.excludedRows) {
                used.back().values[observations.rows[row]] = kNone;
            }
        } else if (lastFit.fit.model.followsAngle && channel == kCrankAngle) {
            used.push_back(std::move(data.series[i]));
        }
    }
    data.series = std::move(used);
    return data;
}

/// The conventions of the columns add a turn to a negated θ3 of the crossed assembly, and those of the whole file add
/// one again after they have negated θ3 once more. Removes both turns: -(-θ3 + 360°) + 360° = θ3.
void removeCancellingTurns(std::vector<ConventionFinding> &conventions)
{
    const auto isTurn = [](const ConventionFinding &finding) {
        const Convention turn{
            .kind = Convention::Kind::WholeTurns, .channels = {{Theta3, Order::Position}}, .amount = kTurnInDegrees};
        return finding.convention == turn;
    };
    if (std::ranges::count_if(conventions, isTurn) == 2) {
        std::erase_if(conventions, isTurn);
    }
}

/// Appends the conventions of the whole file after which the mechanism found is the given one, if there are such, and
/// changes the mechanism accordingly. Does nothing if the file contains only angles or the speed changes.
/// `usedColumns`: as they are in the file.
void addWholeFileConventions(Identification &result, const ReferenceData &usedColumns, const Parameters &given)
{
    if (result.lengthScale == Identification::LengthScale::GivenCrank || result.drive) {
        return;
    }
    const WholeFileConventions whole = findWholeFileConventions(applyAll(result.conventions, usedColumns),
                                                                result.rounded, result.standardErrors, given);
    if (whole.conventions.empty()) {
        return;
    }
    std::ranges::copy(whole.conventions, std::back_inserter(result.conventions));
    removeCancellingTurns(result.conventions);
    result.parameters = whole.parameters;
    result.rounded = whole.parameters;
    result.standardErrors = whole.standardErrors;
    result.alternatives.clear();
}

/// Compares the corrected file with the mechanism found. Returns the comparisons with result.parameters; those with
/// result.rounded instead if all columns agree with these only (R4_y = 12 mm may agree with the rounded c only).
std::vector<ChannelComparison> compareWithMechanismFound(const Identification &result, const ReferenceData &corrected,
                                                         const Findings &findings)
{
    const FittedMechanism fitted = findings.lastFit.fit.fittedMechanism();
    std::vector<ChannelComparison> exact = compareCorrectedFile(result.parameters, corrected, findings, fitted);
    if (allAgree(exact)) {
        return exact;
    }
    std::vector<ChannelComparison> rounded = compareCorrectedFile(result.rounded, corrected, findings, fitted);
    return allAgree(rounded) ? rounded : exact;
}

/// Replaces the residuals of the columns as they are in the file by those after the conventions are applied. Their
/// percentages of the range remain, because a column and its range are converted by the same factor; but those of a fit
/// by the approximate formula are replaced by those of the exact motion.
void takeResidualsFromComparison(Identification &result, const ReferenceData &corrected, const Model &fitted)
{
    for (const ChannelComparison &channel : result.channels) {
        const auto residual = std::ranges::find(result.residuals, channel.channel, &ColumnResidual::channel);
        if (residual != result.residuals.end()) {
            residual->rms = channel.rms.value_or(0.0);
            residual->max = channel.largestError.value_or(0.0);
            if (fitted.isApproximateFormula && channel.channel.coordinate == R4x) {
                residual->percentOfRange =
                    100.0 * residual->max / rangeOf(corrected.find(channel.channel)->values).width();
            }
        }
    }
}

/// Adds the conventions, and changes the mechanism found if conventions of the whole file lead to the given one.
/// Returns the used columns after all conventions are applied.
ReferenceData addConventions(Identification &result, const ReferenceData &data,
                             const std::optional<Convention> &tableConvention, const Findings &findings,
                             const Parameters &given)
{
    const ReferenceData usedColumns = keepUsedColumns(data, tableConvention, findings.lastFit);
    result.conventions = listConventions(findings.lastFit);
    if (tableConvention) { // the other conventions refer to the table after this one is applied
        result.conventions.insert(result.conventions.begin(), {*tableConvention});
    }
    addWholeFileConventions(result, usedColumns, given);
    measureConventions(result.conventions, result.parameters, usedColumns, findings);
    return applyAll(result.conventions, usedColumns);
}

/// Adds the comparisons of the corrected file with the mechanism found and with the given one, and what follows from
/// them: the unit of the lengths, the residuals and `agreesWithGiven`.
void compareWithBothMechanisms(Identification &result, const ReferenceData &corrected, const Findings &findings,
                               const Parameters &given)
{
    result.lengthUnit = findLengthUnit(corrected);
    result.channels = compareWithMechanismFound(result, corrected, findings);
    takeResidualsFromComparison(result, corrected, findings.lastFit.fit.model);
    const FittedMechanism notFitted{};
    const std::vector<ChannelComparison> withGiven = compareCorrectedFile(given, corrected, findings, notFitted);
    result.agreesWithGiven = std::ranges::none_of(
        withGiven, [](const ChannelComparison &channel) { return channel.verdict == Verdict::Differs; });
}

} // namespace

bool isRowContradicted(const Identification &result, const ReferenceData &data, std::size_t row,
                       const Findings &findings)
{
    constexpr double kMaxErrorInBounds = 4.0; // bounds of rounding: more than rounding and the error of a fit together
    ReferenceData corrected = applyAll(result.conventions, data);
    for (ReferenceSeries &series : corrected.series) {
        if (series.channel != kCrankAngle) { // only the values of this row are compared
            std::vector<double> valueOfRow(series.values.size(), kNone);
            valueOfRow[row] = series.values[row];
            series.values = std::move(valueOfRow);
        }
    }
    const FittedMechanism fitted = findings.lastFit.fit.fittedMechanism();
    const std::vector<ChannelComparison> channels =
        compareCorrectedFile(result.parameters, corrected, findings, fitted);
    return std::ranges::any_of(
        channels, [](const ChannelComparison &channel) { return channel.largestErrorInBounds > kMaxErrorInBounds; });
}

bool allAgree(const std::vector<ChannelComparison> &channels)
{
    return std::ranges::all_of(channels,
                               [](const ChannelComparison &channel) { return channel.verdict == Verdict::Agrees; });
}

void addConventionsAndComparisons(Identification &result, const ReferenceData &data,
                                  const std::optional<Convention> &tableConvention, const Findings &findings,
                                  const Parameters &given)
{
    const ReferenceData corrected = addConventions(result, data, tableConvention, findings, given);
    compareWithBothMechanisms(result, corrected, findings, given);
}

} // namespace slidercrank
