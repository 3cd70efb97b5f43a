// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/diagnosis.h"

#include "core/identification/crank_speed.h"
#include "core/identification/decision.h"
#include "core/identification/file_search.h"
#include "core/identification/findings.h"
#include "core/identification/round_numbers.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>

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

/// The data with gaps in place of excluded values: outliers, and values of a saturated sensor.
ReferenceData withoutExcluded(ReferenceData data, const Observations &all, const std::vector<std::size_t> &excluded)
{
    for (const ObservedColumn &column : all.columns) {
        const auto series = std::ranges::find(data.series, column.channel, &ReferenceSeries::channel);
        for (std::size_t i = 0; i < all.rows.size(); ++i) {
            if (std::isnan(column.values[i])) {
                series->values[all.rows[i]] = kNone;
            }
        }
    }
    for (ReferenceSeries &series : data.series) {
        for (const std::size_t row : excluded) {
            series.values[row] = kNone;
        }
    }
    return data;
}

/// The columns whose residuals are neither rounding errors nor white noise.
Observations unexplainedColumns(const Observations &data, const Candidate &candidate)
{
    Observations some = data;
    some.columns.clear();
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        if (candidate.residuals[j] != Residual::Rounding && candidate.residuals[j] != Residual::White) {
            some.columns.push_back(data.columns[j]);
        }
    }
    return some;
}

/// Whether the columns that a candidate does not explain are the motion of another mechanism.
bool isOfTwoMechanisms(const FileSearch &search, const Candidate &found, const Parameters &given,
                       const std::stop_token &stop)
{
    constexpr double kSamePart = 1e-3;
    const Observations rest = unexplainedColumns(search.data, found);
    if (rest.columns.size() < 2 || rest.columns.size() == search.data.columns.size() || findLack(rest)) {
        return false;
    }
    const std::vector<Candidate> candidates = searchCandidates(rest, given, stop);
    if (candidates.empty() || candidates.front().acceptance != Acceptance::Identified ||
        !isAsWritten(rest, candidates.front())) {
        return false;
    }
    const Parameters one = middleParameters(found.fit.hypothesis);
    return std::ranges::none_of(
        mirrorImages(middleParameters(candidates.front().fit.hypothesis)), [&](const Parameters &other) {
            const double ratio = found.fit.hypothesis.isFree[indexOf(Parameter::A)] ? 1.0 : other.a / one.a;
            return std::abs(one.a * ratio - other.a) <= kSamePart * other.a &&
                   std::abs(one.b * ratio - other.b) <= kSamePart * other.b &&
                   std::abs(one.c * ratio - other.c) <= kSamePart * std::max(std::abs(other.c), other.a) &&
                   std::abs(one.omega2 - other.omega2) <= kSamePart * std::abs(other.omega2);
        });
}

/// Whether the file has columns of lengths, none of which has a unit.
bool hasNoLengthUnit(const FileLayout &layout)
{
    const auto isLength = [](const FileColumn &column) {
        return column.role == ColumnRole::Channel && !isAngle(column.channel.coordinate);
    };
    return std::ranges::any_of(layout.columns, isLength) &&
           std::ranges::none_of(layout.columns,
                                [&](const FileColumn &column) { return isLength(column) && !column.unit.empty(); });
}

/// Diagnoses one file without exchanging its axes.
class FileDiagnosis
{
public:
    FileDiagnosis(const ReferenceData &data, const Mechanism &mechanism, const std::stop_token &stop)
        : m_data(data)
        , m_mechanism(mechanism)
        , m_given(mechanism.parameters())
        , m_stop(stop)
    {
    }

    Diagnosis compute();

private:
    void interpret(const Observations &all, const FileSearch &search);
    void keepNearest(const FileSearch &search);
    void compareWith(const ReferenceData &read);
    void nameLeftOut(const ReferenceData &data, const Candidate &candidate, const Observations &observed, bool isOfTwo);
    ReferenceData timed(const ReferenceData &data, const Parameters &parameters) const;

    const ReferenceData &m_data;
    const Mechanism &m_mechanism;
    const Parameters &m_given;
    const std::stop_token &m_stop;
    Diagnosis m_result;
};

/// A file by crank angle with the time stamps of that mechanism; any other file as it is.
ReferenceData FileDiagnosis::timed(const ReferenceData &data, const Parameters &parameters) const
{
    std::optional<ReferenceData> result = data.crank ? timedBy(Mechanism(parameters), data) : std::nullopt;
    return result ? *std::move(result) : data;
}

/// Lists the columns that the fit does not use, with their deviations; in a file of two mechanisms, all columns of the
/// other one.
void FileDiagnosis::nameLeftOut(const ReferenceData &data, const Candidate &candidate, const Observations &observed,
                                bool isOfTwo)
{
    Identification &found = m_result.identification;
    const std::vector<ChannelComparison> channels = compareExactly(Mechanism(found.parameters), data).channels;
    for (std::size_t j = 0; j < observed.columns.size(); ++j) {
        const auto channel = std::ranges::find(channels, observed.columns[j].channel, &ChannelComparison::channel);
        const bool isNamed =
            candidate.residuals[j] == Residual::NotUsed || (isOfTwo && candidate.residuals[j] == Residual::Systematic);
        if (isNamed && channel != channels.end()) {
            const double ofZeros = channel->maxAbs.value_or(0.0) > 0.0 ? 100.0 : 0.0; // percent of the motion's peak
            found.leftOut.push_back({channel->channel, channel->percentOfPeak.value_or(ofZeros)});
        }
    }
}

/// Makes no claim. Reports the nearest mechanism that was fitted to the columns as their headings say, and its
/// deviation.
void FileDiagnosis::keepNearest(const FileSearch &search)
{
    Identification &found = m_result.identification;
    found = decideNearest(search.data, search.candidates, m_given).identification;
    found.rejectImpossible(m_given);
    m_result.conventions.clear();
    m_result.rounded = found.parameters;
    if (found.outcome == Outcome::Nearest) {
        m_result.identified =
            compareExactly(Mechanism(found.parameters), timed(m_data, found.parameters), m_stop).channels;
    }
}

void FileDiagnosis::interpret(const Observations &all, const FileSearch &search)
{
    constexpr double kLargestCondition = 1e5; // above this, different motions are nearly equal
    Identification &found = m_result.identification;
    Decision decision = decide(search.data, search.candidates, m_given);
    found = std::move(decision.identification);
    found.rejectImpossible(m_given);
    m_result.rounded = found.parameters;
    if (found.outcome == Outcome::Nearest) {
        keepNearest(search);
    }
    if (!found.hasMechanism()) {
        return;
    }
    const Candidate &best = *decision.candidate;
    m_result.conventions = findConventions(search.data, best, decision.uncertainty);
    const bool isOfNumbers = std::ranges::any_of(m_result.conventions, [](const ConventionFinding &finding) {
        const Kind kind = finding.convention.kind;
        return kind != Kind::ZeroPoint && kind != Kind::HalfTurn && kind != Kind::WholeTurns &&
               kind != Kind::NotDerivative;
    });
    if (isOfNumbers && found.conditionNumber > kLargestCondition) {
        keepNearest(search);
        return;
    }
    const bool isCleaned = !search.excluded.empty() || all.hasSaturation;
    const ReferenceData cleaned = isCleaned ? withoutExcluded(m_data, all, search.excluded) : ReferenceData();
    ReferenceData own = timed(isCleaned ? cleaned : m_data, found.parameters);
    const std::vector<ConventionFinding> ofFile =
        found.onlyRatios ? std::vector<ConventionFinding>() : findFaultsOfWholeFile(own, m_given, found);
    std::ranges::copy(ofFile, std::back_inserter(m_result.conventions));
    found.rejectImpossible(m_given);
    if (!found.hasMechanism()) {
        m_result.conventions.clear();
        return;
    }
    own = timed(own, found.parameters);
    const bool doAllPay = measureFindings(own, found.parameters, m_result.conventions);
    std::vector<ConventionFinding> ofUsed = m_result.conventions;
    std::erase_if(ofUsed, [](const ConventionFinding &one) { return one.convention.kind == Kind::NotDerivative; });
    const bool isOfTwo = isOfTwoMechanisms(search, best, m_given, m_stop);
    nameLeftOut(allApplied(ofUsed, own), best, search.data, isOfTwo);
    if (!doAllPay || isOfTwo) {
        keepNearest(search);
        return;
    }
    for (const std::size_t row : search.excluded) {
        found.excludedRows.push_back(m_data.lineOfRow(row));
    }
    m_result.isSpeedOfDerivatives = all.isByCrankAngle && found.identifiable[indexOf(Parameter::Omega2)];
    compareWith(allApplied(m_result.conventions, std::move(own)));
}

/// Compares the interpreted data with the mechanism found, its round numbers and the given mechanism.
void FileDiagnosis::compareWith(const ReferenceData &read)
{
    Identification &found = m_result.identification;
    m_result.identified = compareExactly(Mechanism(found.parameters), read, m_stop).channels;
    m_result.rounded =
        found.outcome == Outcome::Ambiguous ? found.parameters : inRoundNumbers(found, read, m_result.identified);
    const ReferenceData asGiven = timed(read, m_given);
    m_result.agreesWithGiven =
        !m_result.conventions.empty() && !differs(compareExactly(m_mechanism, asGiven, m_stop).channels);
    if (!m_result.agreesWithGiven && !found.onlyRatios) {
        m_result.change = findParameterChange(read, m_given, m_result.rounded);
    }
    if (found.outcome == Outcome::Approximate) {
        found.standardError.fill(kNone);
    }
}

Diagnosis FileDiagnosis::compute()
{
    Identification &found = m_result.identification;
    found.parameters = m_result.rounded = m_given;
    found.claimNothing();
    m_result.agreesWithGiven =
        !m_data.series.empty() && !differs(compareExactly(m_mechanism, timed(m_data, m_given), m_stop).channels);
    const bool isAsGiven = m_result.agreesWithGiven;
    const Observations all = observe(m_data);
    if (const std::optional<Identification::Lack> lack = findLack(all)) {
        found.outcome = Outcome::Insufficient;
        found.lack = *lack;
        return m_result;
    }
    m_result.unevenCrank = crankSpeedChange(all);
    interpret(all, searchFile(all, m_given, m_stop));
    m_result.agreesWithGiven = m_result.agreesWithGiven || (isAsGiven && m_result.conventions.empty());
    found.stopped = m_stop.stop_requested();
    return m_result;
}

/// Whether a convention shifts an angle by 90 degrees, so that it is measured from the y axis.
bool hasQuarterTurn(const Diagnosis &diagnosis)
{
    constexpr double kAbout = 1.0; // degrees
    return std::ranges::any_of(diagnosis.conventions, [](const ConventionFinding &finding) {
        const Convention &convention = finding.convention;
        return convention.kind == Kind::ZeroPoint && isAngle(convention.channels.front().coordinate) &&
               std::abs(std::remainder(convention.amount + 90.0, 360.0)) < kAbout;
    });
}

/// The diagnosis after the axes are exchanged; nullopt if the slider does not move along y, or if this does not explain
/// its motion.
std::optional<Diagnosis> turnedDiagnosis(const ReferenceData &data, const Mechanism &mechanism, bool withAngles,
                                         const std::stop_token &stop)
{
    const std::optional<Convention> axis = axisAlongY(data, withAngles);
    if (!axis) {
        return std::nullopt;
    }
    const ReferenceData turned = applied(*axis, data);
    Diagnosis result = FileDiagnosis(turned, mechanism, stop).compute();
    const bool explainsSlider = std::ranges::any_of(result.identified, [](const ChannelComparison &channel) {
        return channel.channel.coordinate == R4x && channel.verdict != Verdict::Differs;
    });
    if (!result.identification.hasMechanism() || !explainsSlider) {
        return std::nullopt;
    }
    result.conventions.insert(result.conventions.begin(), ConventionFinding{*axis});
    measureFindings(data, result.identification.parameters, result.conventions);
    return result;
}

} // namespace

Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    std::optional<Diagnosis> turned = turnedDiagnosis(data, mechanism, false, stop);
    if (turned && hasQuarterTurn(*turned)) {
        std::optional<Diagnosis> withAngles = turnedDiagnosis(data, mechanism, true, stop);
        const bool isSimpler = withAngles && withAngles->conventions.size() < turned->conventions.size();
        turned = isSimpler ? std::move(withAngles) : std::move(turned);
    }
    Diagnosis result = turned ? *std::move(turned) : FileDiagnosis(data, mechanism, stop).compute();
    constexpr double kShortCrank = 1.0; // mm
    result.mayBeInMetres = result.identification.hasMechanism() && !result.identification.onlyRatios &&
                           result.identification.parameters.a < kShortCrank && hasNoLengthUnit(data.layout) &&
                           std::ranges::none_of(result.conventions, [](const ConventionFinding &finding) {
                               return finding.convention.kind == Kind::LengthUnit;
                           });
    return result;
}

} // namespace slidercrank
