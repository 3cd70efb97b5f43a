// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_assignment.h"

#include "core/import/crank_angles.h"
#include "core/import/quantity.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

constexpr std::size_t kFewestSamples = 8; // fewer values do not show how a quantity moves

/// No gap, and each value above the one before.
bool onlyRises(const std::vector<double> &values)
{
    return values.size() >= 2 && std::ranges::all_of(values, [](double value) { return std::isfinite(value); }) &&
           std::ranges::adjacent_find(values, [](double x, double y) { return !(x < y); }) == values.end();
}

/// Whether the quantity changes at one rate throughout: a position on a line through its ends, a velocity that is
/// constant and not zero, an acceleration that is zero.
bool isEven(const std::vector<double> &time, const std::vector<double> &values, Order order)
{
    constexpr double kEvenness = 1e-3; // of the values: columns may have few digits
    const ValueRange range = rangeOf(values);
    if (range.count < kFewestSamples || range.count != values.size()) {
        return false;
    }
    const bool isPosition = order == Order::Position;
    const bool isZero = order == Order::Acceleration;
    const double slope = isPosition ? (values.back() - values.front()) / (time.back() - time.front()) : 0.0;
    const double start = isZero ? 0.0 : values.front();
    const double allowed = isZero ? 0.0 : kEvenness * (isPosition ? range.width() : range.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(start + slope * (time[i] - time.front()) - values[i]) <= allowed)) {
            return false;
        }
    }
    return isZero || allowed > 0.0;
}

/// Whether `rate` is the time derivative of `values`, by its integral: differences of rounded values would be noise.
/// Also true where there is too little to judge by.
bool isDerivative(const std::vector<double> &time, const std::vector<double> &values, const std::vector<double> &rate)
{
    // Trapezoids over steps of 12° of the crank are off by 1 %, and files have rounding: a derivative in another unit,
    // or of another quantity, is off by far more.
    constexpr double kTolerance = 0.05;
    double integral = 0.0;
    double worst = 0.0;
    double largest = 0.0; // of the integral
    std::size_t count = 0;
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i]) || !std::isfinite(values[i]) || !std::isfinite(rate[i])) {
            continue;
        }
        first = count++ == 0 ? i : first;
        if (count > 1) {
            integral += 0.5 * (rate[last] + rate[i]) * (time[i] - time[last]);
            worst = std::max(worst, std::abs(values[i] - values[first] - integral));
            largest = std::max(largest, std::abs(integral));
        }
        last = i;
    }
    return count < kFewestSamples || worst <= kTolerance * std::max(rangeOf(values).width(), largest);
}

std::vector<double> scaled(std::vector<double> values, double factor)
{
    for (double &value : values) {
        value *= factor;
    }
    return values;
}

std::optional<double> unitsPerSecond(const std::string &unitText)
{
    const std::optional<Unit> unit = unitText.empty() ? kSecond : parseUnit(unitText);
    return unit && unit->dimension == Dimension::Time ? std::optional(unit->factor) : std::nullopt;
}

/// ColumnAssignment::factor; nothing where the unit does not suit.
std::optional<double> factorFor(ColumnRole role, Channel channel, const std::string &unit)
{
    switch (role) {
    case ColumnRole::Ignored: return 1.0;
    case ColumnRole::Time: return unitsPerSecond(unit);
    case ColumnRole::CrankAngle: return unitsPerDegree(unit);
    case ColumnRole::Channel: return factorTo(channel, unit);
    }
    return std::nullopt;
}

enum class Evidence { QuantityAlone, Words, ChannelName };

/// A column that could be a channel.
struct Claim {
    std::size_t column = 0;
    Channel channel;
    Evidence evidence = Evidence::QuantityAlone;
    ColumnReason reason = ColumnReason::KnownName;
    std::optional<std::size_t> otherColumn{};
    double factor = 1.0;
};

class Assignment
{
public:
    Assignment(std::span<const Heading> headings, const Columns &values)
        : m_headings(headings)
        , m_values(values)
        , m_uses(headings.size())
        , m_meanings(headings.size())
    {
        std::ranges::transform(headings, m_meanings.begin(), meaningOf);
    }

    std::optional<ColumnFault> takeChoices(std::span<const ColumnChoice> choices);
    std::optional<ColumnFault> takeTime();
    void guessTime();
    void guessCrankAngle();
    std::optional<ColumnFault> assignChannels();

    std::vector<ColumnAssignment> take() { return std::move(m_uses); }

private:
    std::optional<std::size_t> columnUsedAs(ColumnRole role, Channel channel = {}) const;
    std::optional<std::size_t> abscissa() const;
    std::vector<double> time() const { return scaled(m_values[*abscissa()], 1.0 / m_uses[*abscissa()].factor); }
    bool isOpen(std::size_t i) const
    {
        return m_uses[i].role == ColumnRole::Ignored && m_uses[i].reason == ColumnReason::UnknownName;
    }
    bool isSame(std::size_t i, std::size_t j) const;
    void ignore(std::size_t i, ColumnReason reason, std::optional<std::size_t> other = std::nullopt)
    {
        m_uses[i] = ColumnAssignment{ColumnRole::Ignored, {}, reason, other, 1.0};
    }
    void explainIgnored(std::size_t i);
    std::variant<Claim, ColumnFault, ColumnReason> claimOf(std::size_t i) const;
    void findCrank(std::vector<Claim> &claims) const;
    std::optional<ColumnFault> decide(std::vector<Claim> claims);
    void dropOtherDerivatives(std::vector<Claim> &claims);

    std::span<const Heading> m_headings;
    const Columns &m_values;
    std::vector<ColumnAssignment> m_uses;
    std::vector<NameMeaning> m_meanings;
};

std::optional<std::size_t> Assignment::columnUsedAs(ColumnRole role, Channel channel) const
{
    const auto found = std::ranges::find_if(m_uses, [&](const ColumnAssignment &use) {
        return use.role == role && (role != ColumnRole::Channel || use.channel == channel);
    });
    return found == m_uses.end() ? std::nullopt : std::optional<std::size_t>(found - m_uses.begin());
}

/// The time, or the crank angle in its place.
std::optional<std::size_t> Assignment::abscissa() const
{
    const std::optional<std::size_t> time = columnUsedAs(ColumnRole::Time);
    return time ? time : columnUsedAs(ColumnRole::CrankAngle);
}

/// Whether both columns hold the same numbers in the same unit.
bool Assignment::isSame(std::size_t i, std::size_t j) const
{
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return m_headings[i].unit == m_headings[j].unit && std::ranges::equal(m_values[i], m_values[j], same);
}

std::optional<ColumnFault> Assignment::takeChoices(std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        if (choice.column >= m_uses.size()) {
            continue; // a choice remembered from a wider file
        }
        const std::string &unit = choice.unit.empty() ? m_headings[choice.column].unit : choice.unit;
        const bool isChannel = choice.role == ColumnRole::Channel;
        const std::optional<double> factor = factorFor(choice.role, choice.channel, unit);
        const Channel channel = isChannel ? choice.channel : Channel{Theta2, Order::Position};
        if (!factor) {
            return ColumnFault{choice.column, choice.role == ColumnRole::Time ? ReadFault{Fault::UnknownTimeUnit}
                                                                              : ReadFault{Fault::UnknownUnit, channel}};
        }
        if (isChannel && columnUsedAs(ColumnRole::Channel, channel)) {
            return ColumnFault{choice.column, {Fault::ChannelChosenTwice, channel}};
        }
        if (!isChannel && choice.role != ColumnRole::Ignored && abscissa()) {
            return ColumnFault{choice.column, {Fault::TimeChosenTwice}};
        }
        m_uses[choice.column] = {choice.role, choice.channel, ColumnReason::Chosen, {}, *factor};
    }
    return std::nullopt;
}

/// Takes the time by its name.
std::optional<ColumnFault> Assignment::takeTime()
{
    const std::optional<std::size_t> chosen = abscissa();
    for (std::size_t i = 0; i < m_uses.size(); ++i) {
        if (m_meanings[i].kind != NameMeaning::Kind::Time || !isOpen(i)) {
            explainIgnored(i);
            continue;
        }
        const std::optional<std::size_t> other = abscissa();
        const std::optional<double> factor = unitsPerSecond(m_headings[i].unit);
        if (chosen) {
            ignore(i, ColumnReason::LikeOther, chosen);
        } else if (other && !isSame(i, *other)) {
            return ColumnFault{i, {Fault::TimeTwice}};
        } else if (other) {
            ignore(i, ColumnReason::SameInstants, other); // a time in front of each quantity
        } else if (!factor) {
            return ColumnFault{i, {Fault::UnknownTimeUnit}};
        } else {
            m_uses[i] = {ColumnRole::Time, {}, ColumnReason::KnownName, {}, *factor};
        }
    }
    return std::nullopt;
}

/// Says why a column without a meaning is ignored, where more can be said than that its name is unknown.
void Assignment::explainIgnored(std::size_t i)
{
    const Heading &heading = m_headings[i];
    if (!isOpen(i)) {
        return;
    }
    if (heading.printed.empty()) {
        ignore(i, ColumnReason::NoName);
    } else if (heading.component) {
        ignore(i, ColumnReason::Magnitude, heading.component);
    } else if (m_meanings[i].kind == NameMeaning::Kind::RowNumber) {
        ignore(i, ColumnReason::RowNumber);
    } else if (m_meanings[i].kind == NameMeaning::Kind::Nothing && endsInQuantity(heading)) {
        ignore(i, ColumnReason::UnknownBody);
    }
}

void Assignment::guessTime()
{
    for (std::size_t i = 0; i < m_uses.size() && !abscissa(); ++i) {
        const std::optional<double> factor = unitsPerSecond(m_headings[i].unit);
        const bool mayBe =
            isOpen(i) && m_meanings[i].kind == NameMeaning::Kind::Nothing && !isCrankAngle(m_headings[i]);
        if (mayBe && factor && onlyRises(m_values[i])) {
            m_uses[i] = {ColumnRole::Time, {}, ColumnReason::RisingValues, {}, *factor};
        }
    }
}

/// Where there is no time, the crank angle tells it; where none is named so, an angle in front of the other columns
/// that goes one way throughout, as in "theta, x, v".
void Assignment::guessCrankAngle()
{
    for (const bool byName : {true, false}) {
        bool isFirst = true;
        for (std::size_t i = 0; i < m_uses.size() && !abscissa(); ++i) {
            const NameMeaning &meaning = m_meanings[i];
            const std::optional<double> factor = unitsPerDegree(m_headings[i].unit);
            const bool isCounted =
                m_uses[i].reason == ColumnReason::NoName || m_uses[i].reason == ColumnReason::RowNumber;
            const bool isAngle = meaning.kind == NameMeaning::Kind::Quantity && meaning.dimension == Dimension::Angle &&
                                 meaning.order == Order::Position;
            const auto goesOneWay = [&] { return !turnsBackAt(goingOn(scaled(m_values[i], 1.0 / *factor))); };
            const bool suits = byName ? isCrankAngle(m_headings[i]) : isFirst && isAngle && factor && goesOneWay();
            if (suits && factor && m_uses[i].reason != ColumnReason::Chosen) {
                m_uses[i] = {ColumnRole::CrankAngle, {}, ColumnReason::AngleForTime, {}, *factor};
            }
            isFirst = isFirst && isCounted;
        }
    }
}

/// What the column could be by its name and unit, or why it cannot be anything.
std::variant<Claim, ColumnFault, ColumnReason> Assignment::claimOf(std::size_t i) const
{
    const NameMeaning &meaning = m_meanings[i];
    const Heading &heading = m_headings[i];
    Claim claim{i, meaning.channel};
    if (meaning.kind == NameMeaning::Kind::Quantity) {
        if (!m_values[i].empty() && rangeOf(m_values[i]).count == 0) {
            return ColumnReason::NoNumber;
        }
        if (!meaning.dimension && !meaning.owner.empty()) {
            return heading.unit.empty() ? ColumnReason::AngleOrLength : ColumnReason::UnknownUnit;
        }
        const bool isAngle = meaning.dimension == Dimension::Angle; // "velocity" alone is no angular velocity
        claim.channel = {isAngle ? Theta3 : meaning.alongY ? R4y : R4x, meaning.order};
        const bool isInventor = !meaning.owner.empty() && !meaning.isModelica;
        claim.reason = !isInventor            ? ColumnReason::QuantityInName
                       : heading.unit.empty() ? ColumnReason::OtherOfJoint
                                              : ColumnReason::LetterAndUnit;
    } else {
        claim.evidence = meaning.isExact ? Evidence::ChannelName : Evidence::Words;
    }
    claim.reason = heading.unitOfModelica ? ColumnReason::ModelicaName : claim.reason;
    const std::optional<double> factor = factorTo(claim.channel, heading.unit);
    if (!factor && meaning.isExact) {
        return ColumnFault{i, {Fault::UnknownUnit, claim.channel}};
    }
    if (!factor) {
        return ColumnReason::UnknownUnit;
    }
    claim.factor = *factor;
    return claim;
}

/// An angle that grows at an even rate, or beyond one turn, is the crank's, and so are the derivatives of such a one.
void Assignment::findCrank(std::vector<Claim> &claims) const
{
    constexpr double kTurn = 360.0;
    const std::vector<double> times = time();
    const auto valuesOf = [&](const Claim &claim) { return scaled(m_values[claim.column], claim.factor); };
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (Claim &claim : claims) {
            if (claim.evidence != Evidence::QuantityAlone || claim.channel != Channel{Theta3, order}) {
                continue;
            }
            const std::vector<double> values = valuesOf(claim);
            const auto base = std::ranges::find_if(claims, [&](const Claim &other) {
                return order != Order::Position && other.reason == ColumnReason::BeyondOneTurn &&
                       indexOf(other.channel) + kCoordinateCount == indexOf({Theta2, order}) &&
                       isDerivative(times, valuesOf(other), values);
            });
            if (isEven(times, values, order)) {
                claim.channel.coordinate = Theta2;
                claim.reason = ColumnReason::EvenRate;
            } else if ((order == Order::Position && rangeOf(values).width() > kTurn) || base != claims.end()) {
                claim.channel.coordinate = Theta2;
                claim.reason = ColumnReason::BeyondOneTurn;
                claim.otherColumn = base == claims.end() ? std::nullopt : std::optional(base->column);
            }
        }
    }
}

/// Of quantities without a body, derivatives have to be those of the position that was found.
void Assignment::dropOtherDerivatives(std::vector<Claim> &claims)
{
    const Channel channel = claims.front().channel;
    const auto before = static_cast<Order>(static_cast<int>(channel.order) - 1);
    const std::optional<std::size_t> base = channel.order == Order::Position
                                                ? std::nullopt
                                                : columnUsedAs(ColumnRole::Channel, {channel.coordinate, before});
    if (!base || !columnUsedAs(ColumnRole::Time)) { // by angle, nobody knows per how many seconds
        return;
    }
    std::erase_if(claims, [&](const Claim &claim) {
        const bool isOther = claim.evidence == Evidence::QuantityAlone &&
                             !isDerivative(time(), scaled(m_values[*base], m_uses[*base].factor),
                                           scaled(m_values[claim.column], claim.factor));
        if (isOther) {
            ignore(claim.column, ColumnReason::NotDerivative, base);
        }
        return isOther;
    });
}

/// Gives the channel to the one claim with the best evidence.
std::optional<ColumnFault> Assignment::decide(std::vector<Claim> claims)
{
    dropOtherDerivatives(claims);
    if (claims.empty()) {
        return std::nullopt;
    }
    const std::optional<std::size_t> chosen = columnUsedAs(ColumnRole::Channel, claims.front().channel);
    const Evidence best = std::ranges::max(claims, {}, &Claim::evidence).evidence;
    std::vector<Claim> equals;
    std::ranges::copy_if(claims, std::back_inserter(equals),
                         [&](const Claim &claim) { return claim.evidence == best; });
    const Claim &first = equals.front();
    const bool isTwice = best == Evidence::ChannelName && equals.size() > 1 && !chosen;
    if (isTwice) {
        return ColumnFault{equals[1].column, {Fault::ChannelTwice, first.channel}};
    }
    const bool isOne = std::ranges::all_of(
        equals, [&](const Claim &claim) { return claim.column == first.column || isSame(claim.column, first.column); });
    for (const Claim &claim : claims) {
        const std::size_t other =
            claim.column != first.column ? first.column : equals[std::min<std::size_t>(1, equals.size() - 1)].column;
        ignore(claim.column, ColumnReason::LikeOther, chosen ? *chosen : other);
    }
    if (isOne && !chosen) {
        m_uses[first.column] = {ColumnRole::Channel, first.channel, first.reason, first.otherColumn, first.factor};
    }
    return std::nullopt;
}

std::optional<ColumnFault> Assignment::assignChannels()
{
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < m_uses.size(); ++i) {
        const bool isQuantity = m_meanings[i].kind == NameMeaning::Kind::Quantity;
        if (!isOpen(i) || (!isQuantity && m_meanings[i].kind != NameMeaning::Kind::Channel) ||
            (isQuantity && !abscissa())) {
            continue;
        }
        const auto claim = claimOf(i);
        if (const ColumnFault *fault = std::get_if<ColumnFault>(&claim)) {
            return *fault;
        }
        if (const Claim *const found = std::get_if<Claim>(&claim)) {
            claims.push_back(*found);
        } else {
            ignore(i, std::get<ColumnReason>(claim));
        }
    }
    if (abscissa()) {
        findCrank(claims);
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) { // positions before their derivatives
        std::vector<Claim> ofChannel;
        std::ranges::copy_if(claims, std::back_inserter(ofChannel),
                             [&](const Claim &claim) { return indexOf(claim.channel) == index; });
        if (ofChannel.empty()) {
            continue;
        }
        if (std::optional<ColumnFault> fault = decide(std::move(ofChannel))) {
            return fault;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<double> factorTo(Channel channel, const std::string &unitText)
{
    const Dimension dimension = isAngle(channel.coordinate) ? Dimension::Angle : Dimension::Length;
    const std::optional<Unit> unit =
        unitText.empty() ? Unit{dimension, static_cast<int>(channel.order), 1.0} : parseUnit(unitText);
    const bool suits = unit && unit->dimension == dimension && unit->order == static_cast<int>(channel.order);
    return suits ? std::optional(unit->factor) : std::nullopt;
}

std::variant<std::vector<ColumnAssignment>, ColumnFault>
assignColumns(std::span<const Heading> headings, std::span<const ColumnChoice> choices, const Columns &values)
{
    Assignment assignment(headings, values);
    std::optional<ColumnFault> fault = assignment.takeChoices(choices);
    if (!fault) {
        fault = assignment.takeTime();
    }
    if (fault) {
        return *std::move(fault);
    }
    assignment.guessTime();
    assignment.guessCrankAngle();
    fault = assignment.assignChannels();
    if (fault) {
        return *std::move(fault);
    }
    return assignment.take();
}

} // namespace slidercrank
