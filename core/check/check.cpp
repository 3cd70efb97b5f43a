// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/check.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace slidercrank
{

namespace
{

constexpr double kRoundingAllowance =
    1e-12; ///< allowance for rounding errors of the computation, relative to the value

const OutputChannel kTheta3 = Channel{Theta3, Order::Position};
const OutputChannel kTheta2 = Channel{Theta2, Order::Position};

/// Returns the period of the channel: values that differ by it are the same angle. Returns 0 if there is none.
double periodOf(const OutputChannel &channel)
{
    if (channel == kTheta3) {
        return kHalfTurn;
    }
    return channel == kTheta2 ? kTurn : 0.0;
}

/// Returns x - y; for an angle, reduced to within half a period.
double difference(const OutputChannel &channel, double x, double y)
{
    const double period = periodOf(channel);
    return period > 0.0 ? std::remainder(x - y, period) : x - y;
}

/// Returns whether a deviation from the given value is no more than its rounding.
bool isWithinRounding(const GivenValue &given, double deviation)
{
    return std::abs(deviation) <= given.halfStep + kRoundingAllowance * std::abs(given.value);
}

/// Returns whether a value rounds to the given one. Returns false for a given angle whose rounding step is at least
/// its period, such as 1e6°, because every angle would round to it.
bool roundsTo(const GivenValue &given, double value)
{
    const double period = periodOf(given.channel);
    const bool coversPeriod = period > 0.0 && given.halfStep >= 0.5 * period;
    return !coversPeriod && isWithinRounding(given, difference(given.channel, given.value, value));
}

/// Returns whether the slip gives this value. In the wrong unit an angle has no period: the number itself counts.
bool gives(const SlipOutcome &outcome, const GivenValue &given)
{
    const double value = outcome.values.valueOf(given.channel);
    return outcome.slip == Slip::ValueInRadians ? isWithinRounding(given, given.value - value) : roundsTo(given, value);
}

/// Compares a value with the exact one. In both of them, a rounding error of zero counts as zero.
CheckedValue checkValue(const CrankPosition &position, const GivenValue &typed, double computed)
{
    const auto cleaned = [&](double value) {
        return withoutNoise(value, typed.channel, position.mechanism, position.alpha2);
    };
    const GivenValue given{.channel = typed.channel, .value = cleaned(typed.value), .halfStep = typed.halfStep};
    const double exact = cleaned(computed);
    CheckedValue checked{.given = typed};
    checked.deviation = difference(given.channel, given.value, exact);
    checked.isRight = roundsTo(given, exact);
    const double omittedHalfTurns = std::round((given.value - exact - checked.deviation) / kHalfTurn);
    const bool isOddNumber = std::remainder(omittedHalfTurns, 2.0) != 0.0;
    checked.isMeasuredAtB = checked.isRight && given.channel == kTheta3 && isOddNumber;
    return checked;
}

bool isOfSlider(const OutputChannel &channel)
{
    if (const auto *coordinate = std::get_if<Channel>(&channel)) {
        return coordinate->coordinate == R4x;
    }
    return std::get<DerivedChannel>(channel).quantity == DerivedQuantity::Displacement;
}

/// The given channels whose values are wrong, and those whose values are right.
struct ChannelsByVerdict {
    std::vector<OutputChannel> wrong;
    std::vector<OutputChannel> right;
};

ChannelsByVerdict channelsByVerdict(std::span<const CheckedValue> values)
{
    ChannelsByVerdict channels;
    for (const CheckedValue &value : values) {
        (value.isRight ? channels.right : channels.wrong).push_back(value.given.channel);
    }
    return channels;
}

/// Returns whether a slip is considered for these channels. Some slips give the same values as a simpler slip in some
/// channels. Such a slip is considered only if a wrong value or, for CouplerAngleEnd, a right θ3 distinguishes it from
/// the simpler one.
bool isConsidered(Slip slip, const ChannelsByVerdict &channels)
{
    const auto &[wrong, right] = channels;
    const auto isOfOrder = [](Order order) {
        return [order](const OutputChannel &channel) { return orderOf(channel) == order; };
    };
    const bool isSliderWrong = std::ranges::any_of(wrong, isOfSlider);
    const bool isVelocityWrong = std::ranges::any_of(wrong, isOfOrder(Order::Velocity));
    const bool isAccelerationWrong = std::ranges::any_of(wrong, isOfOrder(Order::Acceleration));
    if (slip == Slip::HarmonicMotion || slip == Slip::FromOuterDeadCentre) {
        return isSliderWrong; // if only θ3 is wrong, CouplerAngleSign gives the same
    }
    if (slip == Slip::TwoHarmonics) {
        return isSliderWrong || isVelocityWrong || isAccelerationWrong; // its θ3 is exact
    }
    if (slip == Slip::SecondHarmonicDouble) {
        return isVelocityWrong; // TwoHarmonics gives the same positions and accelerations
    }
    if (slip == Slip::CouplerAngleEnd) {
        // OtherAssembly can give the same values, but not a right θ3.
        return std::ranges::count(right, kTheta3) > 0;
    }
    return true;
}

/// Returns whether the slip cannot be the reason, because it would change a position that is right. The crank angle is
/// given, not computed: it does not count.
bool contradictsPositions(const SlipOutcome &outcome, std::span<const CheckedValue> values)
{
    const auto isContradicted = [&](const CheckedValue &value) {
        const OutputChannel &channel = value.given.channel;
        const bool isComputedPosition = orderOf(channel) == Order::Position && channel != kTheta2;
        return value.isRight && isComputedPosition && !gives(outcome, value.given);
    };
    return outcome.affectsPositions && std::ranges::any_of(values, isContradicted);
}

/// How a slip compares with the given values.
struct Comparison {
    Slip slip;
    bool fits = true;             ///< gives every wrong value
    bool keepsRightValues = true; ///< leaves every right value right
    bool changesAll = true;       ///< changes every wrong value by more than its rounding
    double change = 1.0;          ///< product of the changes of the wrong values
};

Comparison compareSlip(const SlipOutcome &outcome, const OutputState &exact, std::span<const CheckedValue> values)
{
    Comparison comparison{outcome.slip};
    for (const CheckedValue &value : values) {
        const GivenValue &given = value.given;
        const bool givesValue = gives(outcome, given);
        if (value.isRight) {
            comparison.keepsRightValues &= givesValue;
            continue;
        }
        const double predicted = outcome.values.valueOf(given.channel);
        const double change = std::abs(difference(given.channel, predicted, exact.valueOf(given.channel)));
        comparison.fits &= givesValue;
        comparison.changesAll &= change > given.halfStep;
        comparison.change *= change;
    }
    return comparison;
}

/// Compares every slip that is considered with the given values. Slips that neither fit nor change every wrong value
/// are left out.
std::vector<Comparison> compareSlips(const CrankPosition &position, const OutputState &exact,
                                     std::span<const CheckedValue> values)
{
    const ChannelsByVerdict channels = channelsByVerdict(values);
    std::vector<Comparison> comparisons;
    for (const SlipOutcome &outcome : slipOutcomes(position, exact)) {
        if (!isConsidered(outcome.slip, channels) || contradictsPositions(outcome, values)) {
            continue;
        }
        const Comparison comparison = compareSlip(outcome, exact, values);
        if (comparison.changesAll || comparison.fits) {
            comparisons.push_back(comparison);
        }
    }
    return comparisons;
}

/// Returns the slips that fit, without repetition. Requires that at least one fits.
std::vector<Slip> fittingSlips(const std::vector<Comparison> &comparisons)
{
    std::vector<Slip> slips;
    for (const Comparison &comparison : comparisons) {
        if (comparison.fits && std::ranges::count(slips, comparison.slip) == 0) {
            slips.push_back(comparison.slip);
        }
    }
    return slips;
}

/// Returns n of check.h: the number of different changes that are at most as large as the largest of a slip that fits.
std::ptrdiff_t countPossibleSlips(const std::vector<Comparison> &comparisons)
{
    constexpr double kRelativeTolerance = 1e-9; // two computations of the same change differ by less
    double largest = 0.0;
    std::vector<double> changes;
    for (const Comparison &comparison : comparisons) {
        changes.push_back(comparison.change);
        largest = comparison.fits ? std::max(largest, comparison.change) : largest;
    }
    std::erase_if(changes, [largest](double change) { return change > largest; });
    std::ranges::sort(changes);
    const auto areEqual = [](double x, double y) { return std::abs(y - x) <= kRelativeTolerance * std::abs(x); };
    return std::distance(changes.begin(), std::unique(changes.begin(), changes.end(), areEqual));
}

/// What explains the wrong values.
struct Explanation {
    CheckOutcome outcome = CheckOutcome::None;
    std::vector<Slip> slips = {};
};

/// Explains the wrong values by the slips that fit. `coincidence`: the product of h/d over the wrong values (check.h).
Explanation explainBySlips(std::vector<Comparison> comparisons, double coincidence)
{
    const auto keepsRightValues = [](const Comparison &each) { return each.keepsRightValues; };
    const auto fitsAllValues = [](const Comparison &each) { return each.keepsRightValues && each.fits; };
    if (std::ranges::any_of(comparisons, fitsAllValues)) {
        std::erase_if(comparisons, std::not_fn(keepsRightValues));
    }
    const std::vector<Slip> slips = fittingSlips(comparisons);
    if (slips.empty()) {
        return {};
    }
    if (static_cast<double>(countPossibleSlips(comparisons)) * coincidence >= kLargestChance) {
        return {CheckOutcome::TooFewDigits};
    }
    return {slips.size() == 1 ? CheckOutcome::SingleSlip : CheckOutcome::Ambiguous, slips};
}

/// Returns whether all deviations are within the error of intermediate results that are rounded to three digits.
bool earlierRoundingExplains(const CrankPosition &position, const OutputState &exact,
                             std::span<const CheckedValue> values)
{
    const OutputState errors = roundingErrors(position, exact);
    return std::ranges::all_of(values, [&](const CheckedValue &value) {
        return std::abs(value.deviation) <= errors.valueOf(value.given.channel) + value.given.halfStep;
    });
}

} // namespace

CheckResult check(const CrankPosition &position, std::span<const GivenValue> given)
{
    const OutputState exact = unambiguousStateAt(position.mechanism, 0.0, position.alpha2);
    CheckResult result{.status = exact.state.status};
    double coincidence = 1.0;
    for (const GivenValue &each : given) {
        const CheckedValue checked = checkValue(position, each, exact.valueOf(each.channel));
        if (!checked.isRight) {
            coincidence *= each.halfStep / std::abs(checked.deviation);
        }
        result.values.push_back(checked);
    }
    if (std::ranges::all_of(result.values, &CheckedValue::isRight)) {
        return result;
    }
    Explanation explanation;
    if (exact.state.status == Status::Solved) {
        explanation = explainBySlips(compareSlips(position, exact, result.values), coincidence);
        if (explanation.slips.empty() && earlierRoundingExplains(position, exact, result.values)) {
            explanation.outcome = CheckOutcome::RoundedEarlier;
        }
    }
    result.explanation = explanation.outcome;
    result.slips = explanation.slips;
    return result;
}

} // namespace slidercrank
