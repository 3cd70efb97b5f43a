// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/diagnosis.h"

#include "core/identification/by_crank_angle.h"
#include "core/identification/explanation.h"
#include "core/identification/hypotheses.h"
#include "core/identification/crank_speed.h"
#include "core/identification/decision.h"
#include "core/identification/file_search.h"
#include "core/identification/motion_start.h"
#include "core/identification/round_numbers.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;

/// A hypothesis, and what became of it.
struct Tried {
    Hypothesis hypothesis;
    Candidate candidate;
};

bool goesBefore(const Tried &x, const Tried &y)
{
    return isBetter(x.candidate, y.candidate);
}

/// With no other unit, sense or origin than it says.
bool isAsWritten(const SearchRows &rows, const Tried &tried)
{
    return tried.hypothesis.columns == plainHypothesis(rows.all).columns;
}

/// Another origin may take up what is another fault: it has to compete.
bool anyStandsAsWritten(const SearchRows &rows, const std::vector<Tried> &tried)
{
    return std::ranges::any_of(
        tried, [&](const Tried &one) { return one.candidate.standing.stands && isAsWritten(rows, one); });
}

/// As the candidate's reading has it: constants that turned out to be idle are gone.
void takeZerosFrom(const Candidate &candidate, Hypothesis &hypothesis)
{
    for (std::size_t i = 0; i < hypothesis.columns.size(); ++i) {
        hypothesis.columns[i].isZeroFree = candidate.reading[i].isZeroFree;
    }
}

Tried triedOn(const SearchRows &rows, Hypothesis hypothesis, const std::stop_token &stop)
{
    Candidate candidate = candidateFrom(rows, hypothesis.reading(), hypothesis.price(rows.all), hypothesis.start, stop);
    candidate = withoutIdleZeros(rows, std::move(candidate), stop);
    takeZerosFrom(candidate, hypothesis);
    return {std::move(hypothesis), std::move(candidate)};
}

/// Never more than half of the columns are left out.
bool mayLeaveOut(const Hypothesis &hypothesis, std::size_t more)
{
    const auto left =
        static_cast<std::size_t>(std::ranges::count(hypothesis.columns, false, &ColumnHypothesis::isUsed));
    return 2 * (left + more) <= hypothesis.columns.size();
}

/// The columns that do not stand, where they are derivatives all of them.
std::vector<std::size_t> failingDerivatives(const Observations &observations, const Tried &tried)
{
    std::vector<std::size_t> failing;
    const FitProblem problem = problemOf(observations, tried.candidate.reading);
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        if (tried.candidate.standing.columnStands[k]) {
            continue;
        }
        if (problem.columns[k].channel.order == Order::Position || !isPlotted(problem.columns[k].channel)) {
            return {};
        }
        failing.push_back(k);
    }
    return failing;
}

/// Largest σ of some columns as part of their spread.
double offBy(const Observations &observations, const Tried &tried, const std::vector<std::size_t> &columns)
{
    const FitProblem problem = problemOf(observations, tried.candidate.reading);
    double most = 0.0;
    for (const std::size_t k : columns) {
        most = std::max(most, std::sqrt(tried.candidate.fit.noise[k]) / problem.columns[k].spread);
    }
    return most;
}

/// A derivative that is a little off and smooth, as differences are, is left out of the fit and is no finding.
constexpr double kALittleOff = 0.03;

/// The same without the derivatives that do not stand.
std::optional<Tried> withoutFailing(const SearchRows &rows, const Tried &tried, const std::stop_token &stop)
{
    const std::vector<std::size_t> failing = failingDerivatives(rows.all, tried);
    const bool isLittle = !failing.empty() && offBy(rows.all, tried, failing) <= kALittleOff;
    if (failing.empty() || (!isLittle && !mayLeaveOut(tried.hypothesis, failing.size()))) {
        return std::nullopt;
    }
    const FitProblem problem = problemOf(rows.all, tried.candidate.reading);
    Hypothesis fewer = tried.hypothesis;
    for (const std::size_t k : failing) {
        fewer.columns[problem.columns[k].source] = {rows.all.columns[problem.columns[k].source].channel};
        fewer.columns[problem.columns[k].source].isUsed = false;
    }
    // Only derivatives tell of another unit of time.
    if (std::ranges::none_of(fewer.columns, &ColumnHypothesis::isPerSecond)) {
        fewer.timeUnit = 1.0;
    }
    fewer.start = tried.candidate.fit.parameters;
    return triedOn(rows, fewer, stop);
}

/// Half a turn rather than a zero point of 180°.
void tryHalfTurn(const SearchRows &rows, std::vector<Tried> &tried, const std::stop_token &stop)
{
    constexpr double kNearHalfATurn = 0.05; // radians
    const std::size_t count = tried.size();
    for (std::size_t n = 0; n < count; ++n) {
        const FitProblem problem = problemOf(rows.all, tried[n].candidate.reading);
        for (const FitColumn &column : problem.columns) {
            if (column.zero < 0 || column.channel.coordinate != Theta3) {
                continue;
            }
            const double zero = tried[n].candidate.fit.zeros[static_cast<std::size_t>(column.zero)];
            if (std::abs(std::remainder(zero - std::numbers::pi, 2.0 * std::numbers::pi)) < kNearHalfATurn) {
                Hypothesis turned = tried[n].hypothesis;
                turned.columns[column.source].isZeroFree = false;
                turned.columns[column.source].isTurned = !turned.columns[column.source].isTurned;
                turned.start = tried[n].candidate.fit.parameters;
                tried.push_back(triedOn(rows, turned, stop));
            }
        }
    }
}

/// The file as it says, and with origins elsewhere.
std::vector<Tried> plainly(const SearchRows &rows, std::span<const Parameters> starts, const std::stop_token &stop)
{
    std::vector<Tried> tried;
    for (Candidate &candidate : plainCandidates(rows, starts, stop)) {
        Hypothesis hypothesis = plainHypothesis(rows.all);
        takeZerosFrom(candidate, hypothesis);
        tried.push_back({std::move(hypothesis), std::move(candidate)});
    }
    tryHalfTurn(rows, tried, stop);
    return tried;
}

/// Met exactly as written without some columns: another origin, unit or sense that meets all of them nearly is none.
void dropNearMisses(const SearchRows &rows, std::vector<Tried> &tried)
{
    const bool isMet = std::ranges::any_of(tried, [&](const Tried &one) {
        const Standing &standing = one.candidate.standing;
        return standing.stands && standing.isExact &&
               std::ranges::equal(one.hypothesis.columns, plainHypothesis(rows.all).columns,
                                  [](const ColumnHypothesis &column, const ColumnHypothesis &plain) {
                                      return !column.isUsed || column == plain;
                                  });
    });
    if (isMet) {
        std::erase_if(tried,
                      [&](const Tried &one) { return !isAsWritten(rows, one) && !one.candidate.standing.isExact; });
    }
}

/// Where all columns are off by little only, the derivatives may be differences: the lowest orders have to stand
/// without them, and then those of them that agree are taken in again.
void tryWithoutDifferences(const SearchRows &rows, std::vector<Tried> &tried, const std::stop_token &stop)
{
    if (tried.empty() || !tried.front().candidate.fit.exists()) {
        return;
    }
    const Tried &nearest = tried.front();
    const FitProblem problem = problemOf(rows.all, nearest.candidate.reading);
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        if (std::sqrt(nearest.candidate.fit.noise[k]) > kALittleOff * problem.columns[k].spread) {
            return;
        }
    }
    Hypothesis lowest = plainHypothesis(rows.all);
    lowest.start = nearest.candidate.fit.parameters;
    bool any = false;
    for (ColumnHypothesis &column : lowest.columns) {
        column.isUsed =
            !isPlotted(column.channel) || std::ranges::none_of(lowest.columns, [&](const ColumnHypothesis &other) {
                return other.channel.coordinate == column.channel.coordinate &&
                       other.channel.order < column.channel.order;
            });
        any = any || !column.isUsed;
    }
    if (!any) {
        return;
    }
    Tried stood = triedOn(rows, lowest, stop);
    if (!stood.candidate.standing.stands) {
        return;
    }
    constexpr FreeParameters kNoneFree{};
    const FitProblem whole = problemOf(rows.all, asWritten(rows.all));
    const Fit against = fit(whole, stood.candidate.fit.parameters, kNoneFree, 1, stop);
    Hypothesis more = lowest;
    more.start = stood.candidate.fit.parameters;
    for (std::size_t k = 0; against.exists() && k < whole.columns.size(); ++k) {
        more.columns[k].isUsed = lowest.columns[k].isUsed || against.noise[k] == 0.0;
    }
    if (more.columns != lowest.columns) {
        Tried again = triedOn(rows, more, stop);
        if (again.candidate.standing.stands) {
            stood = std::move(again);
        }
    }
    tried.push_back(std::move(stood));
    dropNearMisses(rows, tried);
}

void tryReadings(const SearchRows &rows, std::span<const Parameters> starts, std::vector<Tried> &tried,
                 const std::stop_token &stop)
{
    constexpr std::size_t kMostTried = 4;
    constexpr int kScreeningRounds = 5;
    std::vector<std::pair<double, Hypothesis>> screened;
    for (Hypothesis &hypothesis : hypothesesFrom(rows.few, starts, stop)) {
        const FitProblem few = problemOf(rows.few, hypothesis.reading());
        const Fit found = fit(few, hypothesis.start, rows.isFree, kScreeningRounds, stop);
        const bool isKnown = std::ranges::any_of(tried, [&](const Tried &one) {
            const Parameters &known = one.candidate.fit.parameters;
            return one.hypothesis.columns == hypothesis.columns && known.branch == found.parameters.branch &&
                   known.c * found.parameters.c > 0.0 && known.omega2 * found.parameters.omega2 > 0.0 &&
                   isSameMechanism(known, found.parameters);
        });
        if (found.exists() && !isKnown) {
            hypothesis.start = found.parameters;
            screened.emplace_back(found.score + hypothesis.price(rows.few), std::move(hypothesis));
        }
    }
    std::ranges::stable_sort(screened, {}, [](const auto &one) { return one.first; });
    for (std::size_t i = 0; i < std::min(screened.size(), kMostTried) && !stop.stop_requested(); ++i) {
        Tried one = triedOn(rows, screened[i].second, stop);
        if (!one.candidate.fit.exists()) {
            continue;
        }
        if (!one.candidate.standing.stands) {
            if (std::optional<Tried> fewer = withoutFailing(rows, one, stop)) {
                tried.push_back(std::move(*fewer));
            }
        }
        tried.push_back(std::move(one));
    }
    tryHalfTurn(rows, tried, stop);
}

bool leavesOut(const Tried &tried)
{
    return std::ranges::any_of(tried.hypothesis.columns, [](const ColumnHypothesis &column) { return !column.isUsed; });
}

/// Whether it is about the mechanism at hand: then the file is rather read to be about it, too.
bool isAbout(const Parameters &found, const Parameters &given)
{
    constexpr double kAbout = 0.25;
    return found.branch == given.branch && std::abs(found.a - given.a) <= kAbout * given.a &&
           std::abs(found.b - given.b) <= kAbout * given.b &&
           std::abs(found.c - given.c) <= kAbout * std::max(std::abs(given.c), given.a) &&
           std::abs(found.omega2 - given.omega2) <= kAbout * std::abs(given.omega2) &&
           std::abs(std::remainder(found.theta20 - given.theta20, 2.0 * std::numbers::pi)) <= kAbout;
}

/// Every way to read the file, as far as it takes until one stands; the best first.
std::vector<Tried> allWays(const SearchRows &rows, const std::stop_token &stop)
{
    const FitProblem problem = problemOf(rows.all, asWritten(rows.all));
    std::vector<Parameters> starts = startsOf(problem, speedsOf(problem, stop), rows.given.a, stop);
    starts.push_back(rows.given);
    std::vector<Tried> tried = plainly(rows, starts, stop);
    if (!anyStandsAsWritten(rows, tried)) {
        tryWithoutDifferences(rows, tried, stop);
    }
    if (!anyStandsAsWritten(rows, tried)) {
        tryReadings(rows, starts, tried, stop);
        std::ranges::stable_sort(tried, goesBefore);
        if (tried.empty() || !tried.front().candidate.standing.stands || leavesOut(tried.front())) {
            tryReadings(rows, startsFromParts(rows.all, rows.given.a, stop), tried, stop);
        }
        dropNearMisses(rows, tried);
    }
    for (Tried &one : tried) {
        constexpr double kBonus = 24.0; // between two names of the same fault
        one.candidate.penalty -= isAbout(one.candidate.fit.parameters, rows.given) ? kBonus : 0.0;
    }
    std::ranges::stable_sort(tried, goesBefore);
    return tried;
}

bool isAnyDifferent(const std::vector<ChannelComparison> &channels)
{
    return std::ranges::find(channels, Verdict::Differs, &ChannelComparison::verdict) != channels.end();
}

/// A length is not beyond a hundredth and a hundred times the others.
bool isSensible(const ParameterChange &change, Parameters parameters)
{
    constexpr double kBeyond = 100.0;
    valueOf(parameters, change.parameter) = change.value;
    const auto [shorter, longer] = std::minmax(parameters.a, parameters.b);
    return longer <= kBeyond * shorter && std::abs(parameters.c) <= kBeyond * longer;
}

std::optional<ParameterChange> changeFor(const ReferenceData &data, const Mechanism &mechanism, const Parameters &found,
                                         const std::stop_token &stop)
{
    constexpr double kNearlyAll = 0.99; // of the squares: what is left is a tenth of the error
    const std::vector<ParameterChange> changes = parameterChanges(data, mechanism, found, stop);
    const bool isChange = !changes.empty() && changes.front().explained >= kNearlyAll &&
                          isSensible(changes.front(), mechanism.parameters());
    return isChange ? std::optional(changes.front()) : std::nullopt;
}

/// The same shape in any size, whichever way it is assembled and turns: then the file may be the mechanism at hand,
/// read otherwise.
bool isSimilar(const Parameters &found, const Parameters &given)
{
    constexpr double kSame = 0.02;
    return std::abs(found.b / found.a - given.b / given.a) <= kSame * given.b / given.a &&
           std::abs(std::abs(found.c) / found.a - std::abs(given.c) / given.a) <=
               kSame * std::max(std::abs(given.c) / given.a, 1.0);
}

/// What is silently left out of a fit: derivatives that are a little off, as differences are, or as much as noise that
/// happens not to look quite like it, or no farther off than the mechanism that was found leaves room for, as near a
/// toggle.
bool isSilent(const SearchRows &rows, const Tried &best)
{
    Hypothesis all = best.hypothesis;
    for (ColumnHypothesis &column : all.columns) {
        column.isUsed = true;
    }
    const FitProblem problem = problemOf(rows.all, all.reading());
    Fit at = best.candidate.fit;
    at.noise.assign(problem.columns.size(), 0.0);
    FitResiduals left;
    if (!residualsOf(problem, at, left)) {
        return false;
    }
    const FitProblem fitted = problemOf(rows.all, best.candidate.reading);
    const Eigen::MatrixXd information = informationOf(fitted, best.candidate.fit, best.candidate.isFree).cast<double>();
    const Eigen::LDLT<Eigen::MatrixXd> solver(information);
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const FitColumn &column = problem.columns[k];
        if (best.hypothesis.columns[column.source].isUsed) {
            continue;
        }
        double squares = 0.0;
        std::size_t within = 0;
        InstantMotion motion;
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            const double residual = left.residuals[k][row];
            if (std::isnan(residual) || !motion.compute(at.parameters, problem.time[row])) {
                continue;
            }
            squares += residual * residual;
            const Gradient gradient = motion.gradientOf(column.channel);
            Eigen::VectorXd slope = Eigen::VectorXd::Zero(information.rows());
            Eigen::Index next = 0;
            for (std::size_t i = 0; i < kParameterCount; ++i) {
                if (best.candidate.isFree[i]) {
                    slope[next++] = gradient[static_cast<Eigen::Index>(i)];
                }
            }
            constexpr double kFar = 25.0; // of variances
            const double variance = left.variance[k][row] + slope.dot(solver.solve(slope));
            within += residual * residual <= kFar * variance ? 1 : 0;
        }
        const auto n = static_cast<double>(column.count);
        const double off = std::sqrt(squares / n) / column.spread;
        constexpr double kMost = 0.9;
        constexpr double kHardlyNoise = 6.0;
        const bool isNoise =
            off <= kMostNoise && std::abs(correlationOf(left.residuals[k])) <= kHardlyNoise / std::sqrt(n);
        if (off > kALittleOff && !isNoise && static_cast<double>(within) < kMost * n) {
            return false;
        }
    }
    return true;
}

/// A finding about what numbers count in, not about where they begin.
bool isOfNumbers(const Convention &convention)
{
    return convention.kind != Convention::Kind::ZeroPoint && convention.kind != Convention::Kind::HalfTurn &&
           convention.kind != Convention::Kind::WholeTurns;
}

void inSeconds(double timeUnit, Identification &found)
{
    constexpr std::size_t kSpeed = indexOf(Parameter::Omega2);
    found.parameters.omega2 /= timeUnit;
    found.standardError[kSpeed] /= timeUnit;
    for (Identification::Alternative &alternative : found.alternatives) {
        alternative.parameters.omega2 /= timeUnit;
    }
}

/// Whether no column of a length says its unit, and there is one.
bool isWithoutUnitOfLength(const FileLayout &layout)
{
    const auto isLength = [](const FileColumn &column) {
        return column.role == ColumnRole::Channel && !isAngle(column.channel.coordinate);
    };
    return std::ranges::any_of(layout.columns, isLength) &&
           std::ranges::none_of(layout.columns,
                                [&](const FileColumn &column) { return isLength(column) && !column.unit.empty(); });
}

bool isClaimed(const Diagnosis &diagnosis)
{
    return diagnosis.isOfMechanismAtHand || diagnosis.identification.stands();
}

/// Whether what was found is the motion of the slider, too, and not only of what else is in the file.
bool isOfSlider(const Diagnosis &diagnosis)
{
    return std::ranges::any_of(diagnosis.identified, [](const ChannelComparison &one) {
        return one.channel.coordinate == R4x && one.verdict != Verdict::Differs;
    });
}

/// The data as they stand.
Diagnosis diagnosed(const ReferenceData &data, const Mechanism &mechanism, const std::stop_token &stop)
{
    if (data.crank) {
        return diagnoseByCrankAngle(data, mechanism, stop);
    }
    const Parameters &given = mechanism.parameters();
    Diagnosis result;
    Identification &found = result.identification;
    found.parameters = given;
    found.claimNothing();
    result.rounded = given;
    result.isOfMechanismAtHand =
        !data.series.empty() && !isAnyDifferent(compareExactly(mechanism, data, stop).channels);
    const std::optional<FileSearch> search = searchIn(data, given);
    if (!search) {
        found.outcome = Outcome::Insufficient;
        found.lack = Identification::Lack::FewInstants;
        return result;
    }
    if (const auto lack = lackOf(search->window.all)) {
        found.outcome = Outcome::Insufficient;
        found.lack = *lack;
        return result;
    }
    result.unevenCrank = unevenCrankOf(search->window.all);

    std::vector<Tried> tried = allWays(search->window, stop);
    const SearchRows whole = wholeOf(data, *search, given);
    for (Tried &one : tried) {
        if (one.candidate.standing.stands) {
            one.candidate = grown(data, *search, whole, one.candidate, stop);
        }
    }
    std::ranges::stable_sort(tried, goesBefore);

    // The mechanism at hand, if the file may be read to be its motion.
    const bool isPlain = !tried.empty() && tried.front().candidate.standing.stands && isAsWritten(whole, tried.front());
    std::optional<Explanation> atHand;
    if (!result.isOfMechanismAtHand && (!isPlain || isSimilar(tried.front().candidate.fit.parameters, whole.given))) {
        atHand = explainedAtHand(data, given, stop);
    }
    if (atHand && !atHand->conventions.empty()) {
        result.conventions = findingsOf(data, *atHand);
        const ReferenceData read = allApplied(atHand->conventions, data);
        const Mechanism model(atHand->parameters);
        found = identify(read, model, stop);
        result.isOfMechanismAtHand = true;
        result.identified = compareExactly(Mechanism(found.parameters), read, stop).channels;
        result.rounded =
            found.outcome == Outcome::Identified ? inRoundNumbers(found, read, result.identified) : found.parameters;
        found.stopped = stop.stop_requested();
        return result;
    }

    std::vector<Candidate> candidates;
    for (const Tried &one : tried) {
        candidates.push_back(one.candidate);
    }
    found = decisionOn(whole, candidates, given, stop);
    found.keepToMechanisms(given);
    if (found.stopped) {
        return result;
    }
    result.rounded = found.parameters;
    const bool isClaimed = found.outcome == Outcome::Identified || found.outcome == Outcome::Ambiguous;
    if (!isClaimed) {
        if (found.outcome == Outcome::Nearest) {
            result.identified = compareExactly(Mechanism(found.parameters), data, stop).channels;
        }
        return result;
    }
    const Tried &best = tried.front();
    std::vector<Convention> conventions = conventionsOf(whole.all, best.hypothesis, best.candidate);
    if (leavesOut(best) && isSilent(whole, best)) {
        std::erase_if(conventions, [](const Convention &one) { return one.kind == Convention::Kind::NotDerivative; });
    }
    // Where next to nothing separates one motion from another, as at a toggle, no unit and no sense is proven.
    constexpr double kNextToNothing = 1e5;
    if (found.conditionNumber > kNextToNothing && std::ranges::any_of(conventions, isOfNumbers)) {
        found.outcome = Outcome::Nearest;
        found.claimNothing();
        result.identified = compareExactly(Mechanism(found.parameters), data, stop).channels;
        return result;
    }
    inSeconds(best.hypothesis.timeUnit, found);
    found.keepToMechanisms(given);
    if (!found.stands()) {
        result.rounded = given;
        return result;
    }
    std::optional<ReferenceData> converted; // a file may be large: copied only where it reads otherwise
    for (const Convention &convention : conventions) {
        converted = applied(convention, converted ? std::move(*converted) : data);
    }
    const ReferenceData &reading = converted ? *converted : data;
    result.conventions = findingsOf(data, {found.parameters, conventions, best.hypothesis.timeUnit});
    result.identified = compareExactly(Mechanism(found.parameters), reading, stop).channels;
    if (found.outcome == Outcome::Identified) {
        result.rounded = inRoundNumbers(found, reading, result.identified);
    }
    if (converted) {
        result.isOfMechanismAtHand = !isAnyDifferent(compareExactly(mechanism, reading, stop).channels);
    }
    if (!result.isOfMechanismAtHand) {
        result.change = changeFor(reading, mechanism, found.parameters, stop);
    }
    found.stopped = stop.stop_requested();
    return result;
}

/// Whether an angle is found to be counted from y.
bool hasQuarterTurn(const Diagnosis &diagnosis)
{
    constexpr double kAbout = 1.0; // degrees
    return std::ranges::any_of(diagnosis.conventions, [](const ConventionFinding &finding) {
        const Convention &convention = finding.convention;
        return convention.kind == Convention::Kind::ZeroPoint && isAngle(convention.channels.front().coordinate) &&
               std::abs(std::remainder(convention.amount + 90.0, 360.0)) < kAbout;
    });
}

/// Where the slider moves along y: the file turned, with what else is then found, if the slider's motion is.
std::optional<Diagnosis> turnedDiagnosis(const ReferenceData &data, const Mechanism &mechanism, bool withAngles,
                                         const std::stop_token &stop)
{
    const std::optional<Convention> axis = axisAlongY(data, withAngles);
    if (!axis) {
        return std::nullopt;
    }
    Diagnosis result = diagnosed(applied(*axis, data), mechanism, stop);
    if (!isClaimed(result) || !isOfSlider(result)) {
        return std::nullopt;
    }
    std::vector<Convention> conventions{*axis};
    for (const ConventionFinding &finding : result.conventions) {
        conventions.push_back(finding.convention);
    }
    const Parameters &of = result.isOfMechanismAtHand ? mechanism.parameters() : result.identification.parameters;
    result.conventions = findingsOf(data, {of, conventions});
    return result;
}

} // namespace

Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    std::optional<Diagnosis> turned = turnedDiagnosis(data, mechanism, false, stop);
    if (turned && hasQuarterTurn(*turned)) {
        std::optional<Diagnosis> whole = turnedDiagnosis(data, mechanism, true, stop);
        turned = whole && whole->conventions.size() < turned->conventions.size() ? std::move(whole) : std::move(turned);
    }
    Diagnosis result = turned ? *std::move(turned) : diagnosed(data, mechanism, stop);
    constexpr double kShort = 1.0; // mm
    result.mayBeInMetres = result.identification.stands() && !result.identification.onlyRatios &&
                           result.identification.parameters.a < kShort && isWithoutUnitOfLength(data.layout) &&
                           std::ranges::none_of(result.conventions, [](const ConventionFinding &finding) {
                               return finding.convention.kind == Convention::Kind::LengthUnit;
                           });
    return result;
}

} // namespace slidercrank
