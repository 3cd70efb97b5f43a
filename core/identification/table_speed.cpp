// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/table_speed.h"

#include "core/identification/column_scale.h"
#include "core/identification/joint_fit.h"
#include "core/identification/residual_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// A speed that a derivative shows, if it is in one of unitFactors(): the derivative votes for this speed.
struct Vote {
    Index column = 0;   ///< of the observations
    double speed = 0.0; ///< rad/s; with a sign only if isVelocity
    bool isVelocity = false;
    bool isNearRounding = false;  ///< at this speed, the residuals of the column are as small as rounding
    bool contradictsUnit = false; ///< at this speed, the unit is not the expected one (see isUnexpectedUnit())
};

/// Whether two speeds or factors are equal apart from their signs and from the effect of rounding.
bool haveSameMagnitude(double value, double other)
{
    // The rounding of a coarse table changes a speed by less, a wrong unit by far more.
    constexpr double kRelativeTolerance = 0.03;
    return std::abs(std::abs(value / other) - 1.0) < kRelativeTolerance;
}

/// Whether a speed has the magnitude of the given one. (haveSameMagnitude() allows more, but in other units speeds may
/// be similar by chance.)
bool isGivenSpeed(double speed, double givenSpeed)
{
    return std::abs(std::abs(speed / givenSpeed) - 1.0) < kTypedDifference;
}

/// Whether one of two speeds is ten times the other one, as the same number of mm and of cm would show them.
bool haveRatioOfTen(double speed, double other)
{
    return haveSameMagnitude(speed, 10.0 * other) || haveSameMagnitude(10.0 * speed, other);
}

/// Whether `unit`, one of unitFactors(), differs from the unit that a derivative is expected to have: the stated one
/// (1), or else the usual one for lengths (1), and radians for rates of angles if θ2 is in radians. If θ2 is in
/// degrees, rates of angles without a stated unit may have any.
bool isUnexpectedUnit(const ObservedColumn &column, const Model &model, double unit)
{
    if (column.statesUnit || !column.containsAngles()) {
        return unit != 1.0;
    }
    const double unitOfCrankAngle = 1.0 / std::abs(model.angleFactor);
    return unitOfCrankAngle != 1.0 && unit != unitOfCrankAngle;
}

/// The scale of a derivative at ω2 = 1 rad/s by a mechanism that is fitted to it together with the columns of the fit;
/// nullopt if no mechanism explains all of them. `start`: the scale by the fit alone, with which the search starts.
std::optional<ColumnScale> scaleOfJointFit(const Observations &observations, const Fit &fit, Index k,
                                           const ColumnScale &start)
{
    // The scale of a velocity is ω2, and that of an acceleration ±ω2².
    const Channel channel = observations.columns[k].channel;
    const bool isVelocity = channel.order == Order::Velocity;
    const double sign = isVelocity ? 1.0 : std::copysign(1.0, start.factor);
    Fit withSpeed = fit;
    Model &model = withSpeed.model;
    model.mechanism.omega2 = isVelocity ? start.factor : std::sqrt(std::abs(start.factor));
    model.readings[k] = {sign * signOfCoordinate(observations, fit, channel.coordinate), 0.0};
    withSpeed.unknowns.push_back(Parameter::Omega2);
    const std::optional<Fit> together = tryToAddColumn(observations, withSpeed, model, k);
    if (!together) {
        return std::nullopt;
    }
    const double speed = together->model.mechanism.omega2;
    return ColumnScale{.factor = isVelocity ? speed : sign * speed * speed,
                       .isExplained = true,
                       .isNearRounding = isNearRounding(observations, *together, std::ssize(together->columns) - 1)};
}

/// The scale of a derivative at ω2 = 1 rad/s. If the mechanism of the fit does not explain the derivative, perhaps
/// because the positions are too coarsely rounded to determine the mechanism, returns scaleOfJointFit() if there is
/// one.
ColumnScale scaleOfDerivative(const Observations &observations, const Fit &fit, Index k)
{
    Model atUnitSpeed = fit.model;
    atUnitSpeed.mechanism.omega2 = 1.0;
    const ColumnScale scale = fitScale(observations, fit, atUnitSpeed, k);
    return scale.isExplained ? scale : scaleOfJointFit(observations, fit, k, scale).value_or(scale);
}

/// The votes of a derivative, one for each of unitFactors(); those that do not contradict its unit come first. `scale`:
/// that of the derivative at ω2 = 1 rad/s, which is the true ω2 to the power of its order, times its unit.
std::vector<Vote> votesOfColumn(const ObservedColumn &column, Index k, const Model &model, const ColumnScale &scale)
{
    const bool isVelocity = column.channel.order == Order::Velocity;
    std::vector<Vote> votes;
    for (const double unit : unitFactors(column.channel)) {
        const double speed = isVelocity ? scale.factor / unit : std::sqrt(std::abs(scale.factor) / unit);
        votes.push_back({.column = k,
                         .speed = speed,
                         .isVelocity = isVelocity,
                         .isNearRounding = scale.isNearRounding,
                         .contradictsUnit = isUnexpectedUnit(column, model, unit)});
    }
    std::ranges::stable_sort(votes, {}, &Vote::contradictsUnit);
    return votes;
}

/// The votes of the derivatives that the fit does not use and the mechanism explains. Derivatives of lengths do not
/// vote if the fit contains only angles, which do not show the size of the mechanism. If the residuals of some
/// derivatives are as small as rounding, only these vote, because other derivatives may be difference quotients, whose
/// speed is too low.
std::vector<Vote> collectVotes(const Observations &observations, const Fit &fit)
{
    const bool isSizeOpen = observations.containOnlyAngles(fit.columns);
    std::vector<Vote> votes;
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        const bool mayVote = column.isDerivative() && (column.containsAngles() || !isSizeOpen);
        if (fit.usesColumn(k) || !mayVote) {
            continue;
        }
        const ColumnScale scale = scaleOfDerivative(observations, fit, k);
        if (scale.isExplained) {
            std::ranges::copy(votesOfColumn(column, k, fit.model, scale), std::back_inserter(votes));
        }
    }
    if (std::ranges::any_of(votes, &Vote::isNearRounding)) {
        std::erase_if(votes, std::not_fn(&Vote::isNearRounding));
    }
    return votes;
}

/// A speed, and how many columns vote for it.
struct Support {
    /// rad/s. It is that of a velocity if there is one among the columns, because only a velocity shows the sign.
    double speed = 0.0;
    int columns = 0;           ///< how many columns vote for the speed
    int contradictedUnits = 0; ///< how many of these columns contradict the unit of their vote

    /// The speed with the highest rank is preferred: that with the most columns, then with the fewest contradictions.
    auto rank() const { return std::pair(columns, -contradictedUnits); }
};

/// Counts the columns that vote for the speed of a candidate. Each counts once. `votes`: those of a column that do not
/// contradict its unit come before those that do.
Support countSupport(const Vote &candidate, const std::vector<Vote> &votes)
{
    Support support{.speed = candidate.speed};
    Indices columns;
    for (const Vote &vote : votes) {
        const bool isCounted = std::ranges::find(columns, vote.column) != columns.end();
        if (isCounted || !haveSameMagnitude(vote.speed, candidate.speed)) {
            continue;
        }
        columns.push_back(vote.column);
        support.columns += 1;
        support.contradictedUnits += vote.contradictsUnit ? 1 : 0;
        if (vote.isVelocity) {
            support.speed = vote.speed;
        }
    }
    return support;
}

/// The speed that has the magnitude of the given one, with the sign of the given one; nullopt if there is none among
/// those with the most votes. `best`: a support with the best rank. A wrong unit is likelier than a different speed,
/// unless that is ten times as high or low: 60 rpm and 600 rpm are both usual. If a speed ten times as high or low has
/// the best rank, the given one needs the best rank, too. (With the opposite sense of the crank, the velocities are
/// counted in the opposite direction, which is reported then.)
std::optional<double> findGivenSpeed(const std::vector<Support> &supports, const Support &best, double givenSpeed)
{
    const bool isTenthOrTenfoldBest = std::ranges::any_of(supports, [&](const Support &support) {
        return support.rank() == best.rank() && haveRatioOfTen(support.speed, givenSpeed);
    });
    for (const Support &support : supports) {
        const bool mayBeGiven = isTenthOrTenfoldBest ? support.rank() == best.rank() : support.columns == best.columns;
        if (mayBeGiven && isGivenSpeed(support.speed, givenSpeed)) {
            return std::copysign(support.speed, givenSpeed);
        }
    }
    return std::nullopt;
}

/// The speeds with the best rank, that of `best`: each magnitude once, although several columns vote for it.
std::vector<double> findBestSpeeds(const std::vector<Support> &supports, const Support &best)
{
    std::vector<double> speeds;
    for (const Support &support : supports) {
        const auto isSame = [&](double speed) { return haveSameMagnitude(speed, support.speed); };
        if (support.rank() == best.rank() && std::ranges::none_of(speeds, isSame)) {
            speeds.push_back(support.speed);
        }
    }
    return speeds;
}

/// Repeats a fit over the time from a start at `factor` times its speed, with the same angle of the crank in the first
/// row.
Fit fitAtScaledSpeed(const Observations &observations, const Fit &fit, double factor)
{
    const Parameters &before = fit.model.mechanism;
    Model start = fit.model;
    start.mechanism.omega2 *= factor;
    start.mechanism.theta20 += (before.omega2 - start.mechanism.omega2) * observations.time.values[0];
    return fitModel(observations, std::move(start), fit.columns, fit.unknowns);
}

} // namespace

std::vector<double> findTableSpeeds(const Observations &observations, const Fit &fit, double givenSpeed)
{
    constexpr double kMillimetresPerCentimetre = 10.0;
    const std::vector<Vote> votes = collectVotes(observations, fit);
    if (votes.empty()) {
        return {};
    }
    std::vector<Support> supports;
    std::ranges::transform(votes, std::back_inserter(supports),
                           [&](const Vote &vote) { return countSupport(vote, votes); });
    const Support best = std::ranges::max(supports, {}, &Support::rank);
    if (const std::optional<double> speed = findGivenSpeed(supports, best, givenSpeed)) {
        return {*speed};
    }
    std::vector<double> bestSpeeds = findBestSpeeds(supports, best);
    const Vote &firstVote = votes.front();
    const bool isVelocityOfLength = firstVote.isVelocity && !observations.columns[firstVote.column].containsAngles();
    const bool isSingleVelocityOfLength = bestSpeeds.size() == 1 && best.columns == 1 && isVelocityOfLength;
    if (isSingleVelocityOfLength && isGivenSpeed(kMillimetresPerCentimetre * bestSpeeds[0], givenSpeed)) {
        bestSpeeds.push_back(kMillimetresPerCentimetre * bestSpeeds[0]); // the values may be in cm/s (rule 5)
    }
    return bestSpeeds;
}

Fit withSpeedOfVelocities(const Observations &observations, const Fit &fit)
{
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Channel channel = observations.columns[k].channel;
        const bool isOfSliderOrCoupler = channel.coordinate == R4x || channel.coordinate == Theta3;
        if (fit.usesColumn(k) || channel.order != Order::Velocity || !isOfSliderOrCoupler) {
            continue;
        }
        const ColumnScale scale = fitScale(observations, fit, fit.model, k);
        const auto isScale = [&](double unit) { return haveSameMagnitude(scale.factor, unit); };
        // A wrong unit is likelier than a different speed.
        const bool isInOtherUnit = std::ranges::any_of(unitFactors(channel), isScale);
        if (!scale.isExplained || isInOtherUnit) {
            continue;
        }
        Fit atOtherSpeed = fitAtScaledSpeed(observations, fit, scale.factor);
        if (explainsAsWell(observations, atOtherSpeed, fit)) {
            return atOtherSpeed;
        }
    }
    return fit;
}

} // namespace slidercrank
