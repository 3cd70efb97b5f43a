// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/diagnosis.h"

#include "core/identification/crank_speed.h"
#include "core/identification/decision.h"
#include "core/identification/file_search.h"
#include "core/identification/findings.h"
#include "core/identification/round_numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Kind = Convention::Kind;

bool differs(const std::vector<ChannelComparison> &channels)
{
    return std::ranges::find(channels, Verdict::Differs, &ChannelComparison::verdict) != channels.end();
}

/// The data with gaps in place of excluded values: outliers, and values of a saturated sensor, whose rows are added to
/// `excluded`.
ReferenceData withoutExcluded(ReferenceData data, const Observations &all, std::set<std::size_t> &excluded)
{
    for (ReferenceSeries &series : data.series) {
        for (const std::size_t row : excluded) {
            series.values[row] = kNone;
        }
    }
    for (const ObservedColumn &column : all.columns) {
        const auto series = std::ranges::find(data.series, column.channel, &ReferenceSeries::channel);
        for (std::size_t i = 0; i < all.rows.size(); ++i) {
            double &value = series->values[all.rows[i]];
            if (std::isnan(column.values[i]) && std::isfinite(value)) {
                value = kNone;
                excluded.insert(all.rows[i]);
            }
        }
    }
    return data;
}

/// Whether the columns that a candidate leaves out are the motion of another mechanism.
bool isOfTwoMechanisms(const Observations &data, const Candidate &found, const Parameters &given,
                       const std::stop_token &stop)
{
    Observations rest = data;
    rest.columns.clear();
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        if (found.judgements[j] == Residual::NotUsed && isPlotted(data.columns[j].channel)) {
            rest.columns.push_back(data.columns[j]);
        }
    }
    if (rest.columns.size() < 2 || findLack(rest)) {
        return false;
    }
    const auto magnitudes = [](const Candidate &candidate) { // which images have in common
        const Parameters p = middleParameters(candidate.hypothesis);
        return Parameters{p.a, p.b, std::abs(p.c), std::abs(p.omega2)};
    };
    const std::vector<Candidate> candidates = searchCandidates(rest, given, stop);
    return isIdentified(candidates) && isAsWritten(rest, candidates.front().hypothesis) &&
           !areNear(magnitudes(found), magnitudes(candidates.front()));
}

/// Sets everything that follows from the search. Returns false if nothing but the nearest mechanism can be reported.
bool interpret(const ReferenceData &data, const Observations &all, const FileSearch &search, const Parameters &given,
               const std::stop_token &stop, Diagnosis &result)
{
    const auto &[identification, candidate, uncertainty] = decide(search.data, search.candidates, given);
    Identification &found = result.identification = identification;
    if (!found.hasMechanism()) {
        return found.outcome == Outcome::Insufficient;
    }
    result.conventions = findConventions(search.data, candidate, uncertainty);
    std::set<std::size_t> excluded = search.excluded;
    const ReferenceData good = withoutExcluded(data, all, excluded);
    if (!found.onlyRatios) {
        std::ranges::copy(findFaultsOfWholeFile(good, given, found), std::back_inserter(result.conventions));
    }
    if (!measureFindings(good, found.parameters, result.conventions) ||
        isOfTwoMechanisms(search.data, candidate, given, stop)) {
        return false;
    }
    for (const std::size_t row : excluded) {
        found.excludedRows.push_back(data.lineOfRow(row));
    }
    constexpr double kSmallPercent = 0.01;
    const bool hasOrigin = std::ranges::count(result.conventions, Kind::ZeroPoint, &ConventionFinding::kind) > 0;
    std::vector<ConventionFinding> ofUsed = result.conventions;
    std::erase_if(ofUsed, [](const ConventionFinding &one) { return one.kind == Kind::NotDerivative; });
    const ReferenceData interpreted = allApplied(result.conventions, good);
    for (ChannelComparison &channel : compareTimed(found.parameters, allApplied(ofUsed, good), stop)) {
        const std::size_t j = columnIndex(search.data.columns, channel.channel);
        if (j < candidate.judgements.size() && candidate.judgements[j] == Residual::NotUsed) {
            const double ofZeros = channel.maxAbs.value_or(0.0) > 0.0 ? 100.0 : 0.0; // percent of the motion's peak
            found.leftOut.push_back({channel.channel, channel.percentOfPeak.value_or(ofZeros)});
            // If it deviates so little, the used columns may deviate, too, and the origin may hide that.
            if (found.leftOut.back().percentOfPeak < kSmallPercent && hasOrigin) {
                return false;
            }
        }
        if (interpreted.find(channel.channel)) {
            result.identified.push_back(std::move(channel));
        }
    }
    result.rounded = inRoundNumbers(found, interpreted);
    if (!result.conventions.empty()) {
        result.agreesWithGiven = !differs(compareTimed(given, interpreted, stop));
    }
    if (!result.agreesWithGiven && !found.onlyRatios) {
        result.change = findParameterChange(interpreted, given, result.rounded);
    }
    if (found.outcome == Outcome::Approximate) {
        found.standardError.fill(kNone);
    }
    return true;
}

/// Diagnoses one file without exchanging its axes.
Diagnosis diagnoseAxes(const ReferenceData &data, const Parameters &given, const std::stop_token &stop)
{
    Diagnosis result;
    Identification &found = result.identification;
    found.parameters = result.rounded = given;
    result.agreesWithGiven = !data.series.empty() && !differs(compareTimed(given, data, stop));
    const Observations all = observe(data);
    if (const std::optional<Identification::Lack> lack = findLack(all)) {
        found.outcome = Outcome::Insufficient;
        found.lack = *lack;
        return result;
    }
    result.unevenCrank = crankSpeedChange(all);
    const FileSearch search = searchFile(all, given, stop);
    if (!interpret(data, all, search, given, stop, result)) { // makes no claim
        result.conventions.clear();
        found = decideNearest(search.data, search.candidates, given);
        result.rounded = found.parameters;
        if (found.outcome == Outcome::Nearest) {
            result.identified = compareTimed(found.parameters, data, stop);
        }
    }
    found.stopped = stop.stop_requested();
    return result;
}

} // namespace

Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    std::optional<Diagnosis> best;
    for (const bool withAngles : {false, true}) {
        const std::optional<Convention> axis = axisAlongY(data, withAngles);
        if (!axis) {
            break;
        }
        Diagnosis exchanged = diagnoseAxes(applied(*axis, data), mechanism.parameters(), stop);
        const bool explainsSlider = std::ranges::any_of(exchanged.identified, [](const ChannelComparison &channel) {
            return channel.channel.coordinate == R4x && channel.verdict != Verdict::Differs;
        });
        exchanged.conventions.insert(exchanged.conventions.begin(), ConventionFinding{*axis});
        if (exchanged.identification.hasMechanism() && explainsSlider &&
            (!best || exchanged.conventions.size() < best->conventions.size())) {
            measureFindings(data, exchanged.identification.parameters, exchanged.conventions);
            best = std::move(exchanged);
        }
    }
    return best ? *std::move(best) : diagnoseAxes(data, mechanism.parameters(), stop);
}

} // namespace slidercrank
