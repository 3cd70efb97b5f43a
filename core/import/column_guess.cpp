// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_guess.h"

#include "core/import/column_motion.h"
#include "core/import/crank_angles.h"
#include "core/import/reference_data.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

bool suits(const Unit &unit, Channel channel)
{
    const Dimension dimension = isAngle(channel.coordinate) ? Dimension::Angle : Dimension::Length;
    return unit.dimension == dimension && unit.order == static_cast<int>(channel.order);
}

/// To the author's unit; 1 without a unit; nothing where it does not suit.
std::optional<double> factorOf(const std::string &unitText, Channel channel)
{
    if (unitText.empty()) {
        return 1.0;
    }
    const std::optional<Unit> unit = unitOf(unitText);
    return unit && suits(*unit, channel) ? std::optional(unit->factor) : std::nullopt;
}

std::optional<double> unitsPerSecond(const std::string &unitText)
{
    if (unitText.empty()) {
        return 1.0;
    }
    const std::optional<Unit> unit = unitOf(unitText);
    return unit && unit->dimension == Dimension::Time ? std::optional(unit->factor) : std::nullopt;
}

class Assignment
{
public:
    Assignment(std::span<const Heading> headings, const std::function<ColumnSamples()> &sample)
        : m_headings(headings)
        , m_sample(sample)
        , m_uses(headings.size())
        , m_meanings(headings.size())
    {
        for (std::size_t i = 0; i < headings.size(); ++i) {
            m_meanings[i] = meaningOf(headings[i]);
        }
    }

    std::optional<ColumnFault> choose(std::span<const ColumnChoice> choices);
    std::optional<ColumnFault> takeNames();
    void guessTime();
    void settlePairs();
    void guessCrankAngle();
    void guessChannels();

    std::vector<ColumnUse> take() { return std::move(m_uses); }

private:
    /// A column whose name says a quantity, while it is being told which channel it is.
    struct Candidate {
        std::size_t column = 0;
        Order order = Order::Position;
        std::optional<Dimension> dimension;
        ColumnReason reason = ColumnReason::QuantityInName;
        std::optional<std::size_t> otherColumn;
        bool crank = false;
    };

    const ColumnSamples &samples()
    {
        if (m_samples.empty()) {
            m_samples = m_sample();
        }
        return m_samples;
    }

    /// The column's samples in the author's unit, of the time in s.
    std::vector<double> scaledSamples(std::size_t column, double factor)
    {
        std::vector<double> values = samples()[column];
        for (double &value : values) {
            value *= factor;
        }
        return values;
    }

    /// The time, or the crank's angle in its place.
    std::optional<std::size_t> abscissa() const
    {
        const std::optional<std::size_t> time = columnAs(ColumnRole::Time);
        return time ? time : columnAs(ColumnRole::CrankAngle);
    }

    std::vector<double> timeSamples()
    {
        const std::size_t time = *abscissa();
        return scaledSamples(time, 1.0 / m_uses[time].factor);
    }

    /// `channel`: where the role is Channel.
    std::optional<std::size_t> columnAs(ColumnRole role, Channel channel = {}) const
    {
        const auto found = std::find_if(m_uses.begin(), m_uses.end(), [&](const ColumnUse &use) {
            return use.role == role && (role != ColumnRole::Channel || use.channel == channel);
        });
        return found == m_uses.end() ? std::nullopt : std::optional<std::size_t>(found - m_uses.begin());
    }

    bool isOpen(std::size_t i) const
    {
        return m_uses[i].role == ColumnRole::Ignored && m_uses[i].reason != ColumnReason::Chosen;
    }

    void ignore(std::size_t i, ColumnReason reason, std::optional<std::size_t> other = std::nullopt)
    {
        m_uses[i] = ColumnUse{ColumnRole::Ignored, {}, reason, other, 1.0};
    }

    /// Whether the columns hold the same numbers.
    bool areEqual(std::size_t i, std::size_t j)
    {
        const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
        return i < samples().size() && j < samples().size() && std::ranges::equal(samples()[i], samples()[j], same);
    }

    std::optional<ColumnFault> nameTime(std::size_t i);
    std::optional<ColumnFault> nameChannel(std::size_t i, Channel channel);
    std::vector<Candidate> candidates();
    void tellAngleFromLength(std::vector<Candidate> &all);
    void tellByValues(std::vector<Candidate> &all, Candidate &position);
    void give(const std::vector<Candidate> &all, Channel channel);

    std::span<const Heading> m_headings;
    const std::function<ColumnSamples()> &m_sample;
    std::vector<ColumnUse> m_uses;
    std::vector<NameMeaning> m_meanings;
    ColumnSamples m_samples;
};

std::optional<ColumnFault> Assignment::choose(std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        if (choice.column >= m_uses.size()) {
            continue; // a choice remembered from a wider file
        }
        const std::string &unit = choice.unit.empty() ? m_headings[choice.column].unit : choice.unit;
        ColumnUse use;
        use.role = choice.role;
        use.channel = choice.channel;
        use.reason = ColumnReason::Chosen;
        switch (choice.role) {
        case ColumnRole::Ignored: break;
        case ColumnRole::Time: {
            const std::optional<double> factor = unitsPerSecond(unit);
            if (!factor || abscissa()) {
                return ColumnFault{choice.column, {factor ? Fault::TimeChosenTwice : Fault::UnknownTimeUnit}};
            }
            use.factor = *factor;
            break;
        }
        case ColumnRole::CrankAngle: {
            const std::optional<double> factor = unitsPerDegree(unit);
            if (!factor || abscissa()) {
                const Fault kind = factor ? Fault::TimeChosenTwice : Fault::UnknownUnit;
                return ColumnFault{choice.column, {kind, {Theta2, Order::Position}}};
            }
            use.factor = *factor;
            break;
        }
        case ColumnRole::Channel: {
            const std::optional<double> factor = factorOf(unit, choice.channel);
            if (!factor || columnAs(ColumnRole::Channel, choice.channel)) {
                const Fault kind = factor ? Fault::ChannelChosenTwice : Fault::UnknownUnit;
                return ColumnFault{choice.column, {kind, choice.channel}};
            }
            use.factor = *factor;
            break;
        }
        }
        m_uses[choice.column] = use;
    }
    return std::nullopt;
}

std::optional<ColumnFault> Assignment::nameTime(std::size_t i)
{
    if (const std::optional<std::size_t> other = abscissa()) {
        if (m_uses[*other].reason == ColumnReason::Chosen) {
            ignore(i, ColumnReason::LikeOther, other);
            return std::nullopt;
        }
        if (m_headings[i].unit == m_headings[*other].unit && areEqual(i, *other)) {
            ignore(i, ColumnReason::SameInstants, other); // a time in front of each quantity
            return std::nullopt;
        }
        return ColumnFault{i, {Fault::TimeTwice}};
    }
    const std::optional<double> factor = unitsPerSecond(m_headings[i].unit);
    if (!factor) {
        return ColumnFault{i, {Fault::UnknownTimeUnit}};
    }
    m_uses[i] = ColumnUse{ColumnRole::Time, {}, ColumnReason::KnownName, std::nullopt, *factor};
    return std::nullopt;
}

std::optional<ColumnFault> Assignment::nameChannel(std::size_t i, Channel channel)
{
    const bool fileName = m_meanings[i].fileName;
    if (const std::optional<std::size_t> other = columnAs(ColumnRole::Channel, channel)) {
        if (fileName && m_uses[*other].reason != ColumnReason::Chosen) {
            return ColumnFault{i, {Fault::ChannelTwice, channel}};
        }
        ignore(i, ColumnReason::LikeOther, other);
        return std::nullopt;
    }
    for (std::size_t j = 0; j < m_uses.size() && !fileName; ++j) { // words are not names: which of two, nobody knows
        const NameMeaning &other = m_meanings[j];
        if (j != i && other.kind == NameMeaning::Kind::Channel && !other.fileName && other.channel == channel &&
            !(m_headings[i].unit == m_headings[j].unit && areEqual(i, j))) {
            ignore(i, ColumnReason::LikeOther, j);
            return std::nullopt;
        }
    }
    const std::optional<double> factor = factorOf(m_headings[i].unit, channel);
    if (!factor && fileName) {
        return ColumnFault{i, {Fault::UnknownUnit, channel}};
    }
    if (!factor) {
        ignore(i, ColumnReason::UnknownUnit);
        return std::nullopt;
    }
    const ColumnReason reason = m_headings[i].unitOfModelica ? ColumnReason::ModelicaName : ColumnReason::KnownName;
    m_uses[i] = ColumnUse{ColumnRole::Channel, channel, reason, std::nullopt, *factor};
    return std::nullopt;
}

std::optional<ColumnFault> Assignment::takeNames()
{
    const auto take = [this](bool fileNames) -> std::optional<ColumnFault> {
        for (std::size_t i = 0; i < m_uses.size(); ++i) {
            const NameMeaning &meaning = m_meanings[i];
            if (!isOpen(i)) {
                continue;
            }
            std::optional<ColumnFault> fault;
            if (fileNames && meaning.kind == NameMeaning::Kind::Time) {
                fault = nameTime(i);
            } else if (meaning.kind == NameMeaning::Kind::Channel && meaning.fileName == fileNames) {
                fault = nameChannel(i, meaning.channel);
            } else if (fileNames && m_headings[i].printed.empty()) {
                ignore(i, ColumnReason::NoName);
            } else if (fileNames && meaning.kind == NameMeaning::Kind::RowNumber) {
                ignore(i, ColumnReason::RowNumber);
            } else if (fileNames && meaning.kind == NameMeaning::Kind::Nothing &&
                       m_headings[i].part == Heading::Part::Own && endsInQuantity(m_headings[i])) {
                ignore(i, ColumnReason::UnknownBody);
            }
            if (fault) {
                return fault;
            }
        }
        return std::nullopt;
    };
    std::optional<ColumnFault> fault = take(true);
    return fault ? fault : take(false);
}

void Assignment::guessTime()
{
    if (abscissa()) {
        return;
    }
    for (std::size_t i = 0; i < m_uses.size(); ++i) {
        const bool named = m_meanings[i].kind == NameMeaning::Kind::Nothing && !m_headings[i].printed.empty() &&
                           m_uses[i].reason != ColumnReason::UnknownBody && !isCrankAngle(m_headings[i]);
        const std::optional<double> factor = unitsPerSecond(m_headings[i].unit);
        if (isOpen(i) && named && factor && i < samples().size() && onlyRises(samples()[i])) {
            m_uses[i] = ColumnUse{ColumnRole::Time, {}, ColumnReason::RisingValues, std::nullopt, *factor};
            return;
        }
    }
}

/// Where there is no time, the crank's angle tells it; where none is named so, an angle in front of the others that
/// goes one way throughout, as in "theta, x, v".
void Assignment::guessCrankAngle()
{
    const auto take = [this](std::size_t i, const std::optional<double> &factor) {
        if (m_uses[i].reason != ColumnReason::Chosen && factor) {
            m_uses[i] = ColumnUse{ColumnRole::CrankAngle, {}, ColumnReason::AngleForTime, std::nullopt, *factor};
        }
    };
    for (std::size_t i = 0; i < m_uses.size() && !abscissa(); ++i) {
        if (isCrankAngle(m_headings[i])) {
            take(i, unitsPerDegree(m_headings[i].unit));
        }
    }
    const auto first = std::ranges::find_if(m_uses, [](const ColumnUse &use) {
        return use.reason != ColumnReason::NoName && use.reason != ColumnReason::RowNumber;
    });
    if (first == m_uses.end() || abscissa()) {
        return;
    }
    const auto i = static_cast<std::size_t>(first - m_uses.begin());
    const NameMeaning &meaning = m_meanings[i];
    const std::optional<double> factor = unitsPerDegree(m_headings[i].unit);
    const bool isAngle = meaning.kind == NameMeaning::Kind::Quantity && meaning.dimension == Dimension::Angle &&
                         meaning.order == Order::Position && m_headings[i].part == Heading::Part::Own;
    if (isAngle && factor && i < samples().size() && !turnsBackAt(goingOn(scaledSamples(i, 1.0 / *factor)))) {
        take(i, factor);
    }
}

/// Values that stand over other instants than the time's are of no use, instants that are the same of none either.
void Assignment::settlePairs()
{
    const std::optional<std::size_t> time = abscissa();
    for (std::size_t i = 0; i < m_uses.size(); ++i) {
        const Heading &heading = m_headings[i];
        if (!time || i == *time || m_uses[i].reason == ColumnReason::Chosen) {
            continue;
        }
        if (heading.part == Heading::Part::Magnitude) {
            ignore(i, ColumnReason::Magnitude, heading.other);
        } else if (heading.part == Heading::Part::Abscissa) {
            ignore(i, areEqual(i, *time) ? ColumnReason::SameInstants : ColumnReason::OtherInstants, time);
        } else if (heading.part == Heading::Part::Ordinate && *heading.other != *time &&
                   !areEqual(*heading.other, *time)) {
            ignore(i, ColumnReason::OtherInstants, time);
        }
    }
}

/// The columns whose names say a quantity, with the unit's word on it.
std::vector<Assignment::Candidate> Assignment::candidates()
{
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < m_uses.size(); ++i) {
        const NameMeaning &meaning = m_meanings[i];
        const bool isSettled =
            m_uses[i].reason == ColumnReason::Magnitude || m_uses[i].reason == ColumnReason::OtherInstants;
        if (!isOpen(i) || isSettled || meaning.kind != NameMeaning::Kind::Quantity || !meaning.order) {
            continue;
        }
        if (i < samples().size() &&
            std::ranges::none_of(samples()[i], [](double value) { return std::isfinite(value); })) {
            ignore(i, ColumnReason::NoNumber);
            continue;
        }
        const bool grapher = !meaning.outputIndex.empty();
        Candidate candidate;
        candidate.column = i;
        candidate.order = *meaning.order;
        candidate.dimension = meaning.dimension;
        if (!m_headings[i].unit.empty()) {
            const std::optional<Unit> unit = unitOf(m_headings[i].unit);
            const bool suitable = unit && unit->dimension != Dimension::Time &&
                                  unit->order == static_cast<int>(candidate.order) &&
                                  (!meaning.dimension || meaning.dimension == unit->dimension);
            if (!suitable) {
                ignore(i, ColumnReason::UnknownUnit);
                continue;
            }
            candidate.dimension = unit->dimension;
            candidate.reason = m_headings[i].unitOfModelica     ? ColumnReason::ModelicaName
                               : grapher && !meaning.isModelica ? ColumnReason::LetterAndUnit
                                                                : ColumnReason::QuantityInName;
        } else if (!grapher && !candidate.dimension) {
            candidate.dimension = Dimension::Length; // "velocity" alone is no angular velocity
        }
        all.push_back(candidate);
    }
    return all;
}

/// For one of Inventor's positions without a unit, and its velocity and acceleration.
void Assignment::tellByValues(std::vector<Candidate> &all, Candidate &position)
{
    const auto derivative = [&](Order order) -> Candidate * {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Candidate &each) {
            return each.order == order &&
                   m_meanings[each.column].outputIndex == m_meanings[position.column].outputIndex;
        });
        return found == all.end() ? nullptr : &*found;
    };
    Candidate *const velocity = derivative(Order::Velocity);
    Candidate *const acceleration = derivative(Order::Acceleration);
    const std::vector<double> time = timeSamples();
    const auto valuesOf = [this](const Candidate *candidate) -> const std::vector<double> & {
        return samples()[candidate->column];
    };
    const bool crank = isEven(time, valuesOf(&position), Order::Position);
    if (!crank && velocity && acceleration && isDerivative(time, valuesOf(&position), valuesOf(velocity)) &&
        isDerivative(time, valuesOf(velocity), valuesOf(acceleration))) {
        position.dimension = dimensionOf(valuesOf(&position), valuesOf(velocity), valuesOf(acceleration));
    } else if (crank) {
        position.dimension = Dimension::Angle;
    }
    position.reason = ColumnReason::LetterAndValues;
}

/// Units say it for some of Inventor's columns, values for others; what belongs to the same joint is of the same kind.
void Assignment::tellAngleFromLength(std::vector<Candidate> &all)
{
    const std::vector<double> time = timeSamples();
    const auto sameJoint = [this](const Candidate &x, const Candidate &y) {
        return m_meanings[x.column].outputIndex == m_meanings[y.column].outputIndex;
    };
    const auto inherit = [&](Candidate &open) {
        for (const Candidate &other : all) {
            if (open.dimension || !other.dimension || !sameJoint(open, other) || other.order == open.order) {
                continue;
            }
            const bool later = open.order > other.order;
            const std::size_t base = later ? other.column : open.column;
            const std::size_t rate = later ? open.column : other.column;
            const int apart = std::abs(static_cast<int>(open.order) - static_cast<int>(other.order));
            if (apart == 1 && isDerivative(time, samples()[base], samples()[rate])) {
                open.dimension = other.dimension;
                open.reason = ColumnReason::DerivativeOfOther;
                open.otherColumn = other.column;
            }
        }
    };
    for (int round = 0; round < 2; ++round) { // from the position to the velocity, from there to the acceleration
        for (Candidate &candidate : all) {
            inherit(candidate);
        }
        for (Candidate &candidate : all) {
            if (round == 0 && !candidate.dimension && candidate.order == Order::Position) {
                tellByValues(all, candidate);
                for (Candidate &other : all) {
                    inherit(other);
                }
            }
        }
    }
    for (Candidate &candidate : all) {
        if (!candidate.dimension) {
            ignore(candidate.column, ColumnReason::AngleOrLength);
        } else if (candidate.dimension == Dimension::Angle &&
                   isEven(time, samples()[candidate.column], candidate.order)) {
            candidate.crank = true;
            candidate.reason = ColumnReason::EvenRate;
            candidate.otherColumn.reset();
        }
    }
    std::erase_if(all, [](const Candidate &candidate) { return !candidate.dimension; });
}

/// Gives the channel to the one candidate that can be it.
void Assignment::give(const std::vector<Candidate> &all, Channel channel)
{
    std::vector<const Candidate *> left;
    for (const Candidate &candidate : all) {
        const bool angle = candidate.dimension == Dimension::Angle;
        const Coordinate coordinate =
            !angle ? (m_meanings[candidate.column].alongY ? R4y : R4x) : (candidate.crank ? Theta2 : Theta3);
        if (Channel{coordinate, candidate.order} == channel) {
            left.push_back(&candidate);
        }
    }
    if (left.empty()) {
        return;
    }
    if (const std::optional<std::size_t> taken = columnAs(ColumnRole::Channel, channel)) {
        for (const Candidate *candidate : left) {
            ignore(candidate->column, ColumnReason::LikeOther, taken);
        }
        return;
    }
    const auto factorIn = [this](std::size_t column) {
        const std::optional<Unit> unit = unitOf(m_headings[column].unit);
        return unit ? unit->factor : 1.0;
    };
    if (channel.order != Order::Position) {
        const Order before = channel.order == Order::Velocity ? Order::Position : Order::Velocity;
        const std::optional<std::size_t> base = columnAs(ColumnRole::Channel, {channel.coordinate, before});
        const bool isByTime = columnAs(ColumnRole::Time).has_value(); // by angle, nobody knows per how many seconds
        std::erase_if(left, [&](const Candidate *candidate) {
            const bool wrong = base && isByTime &&
                               !isDerivative(timeSamples(), scaledSamples(*base, m_uses[*base].factor),
                                             scaledSamples(candidate->column, factorIn(candidate->column)));
            if (wrong) {
                ignore(candidate->column, ColumnReason::NotDerivative, base);
            }
            return wrong;
        });
    }
    if (std::ranges::all_of(left, [&](const Candidate *candidate) {
            const std::size_t first = left.front()->column;
            return m_headings[candidate->column].unit == m_headings[first].unit && areEqual(candidate->column, first);
        })) {
        while (left.size() > 1) {
            ignore(left.back()->column, ColumnReason::LikeOther, left.front()->column);
            left.pop_back();
        }
    }
    if (left.size() == 1) {
        const Candidate &found = *left.front();
        m_uses[found.column] =
            ColumnUse{ColumnRole::Channel, channel, found.reason, found.otherColumn, factorIn(found.column)};
        return;
    }
    for (const Candidate *candidate : left) {
        ignore(candidate->column, ColumnReason::LikeOther, (candidate == left[0] ? left[1] : left[0])->column);
    }
}

void Assignment::guessChannels()
{
    if (!abscissa()) {
        return;
    }
    std::vector<Candidate> all = candidates();
    if (all.empty() || samples().size() < m_uses.size()) {
        return;
    }
    tellAngleFromLength(all);
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (const Coordinate coordinate : {Theta2, Theta3, R4x, R4y}) {
            give(all, {coordinate, order});
        }
    }
}

} // namespace

std::variant<std::vector<ColumnUse>, ColumnFault> assignColumns(std::span<const Heading> headings,
                                                                std::span<const ColumnChoice> choices,
                                                                const std::function<ColumnSamples()> &sample)
{
    Assignment assignment(headings, sample);
    if (std::optional<ColumnFault> fault = assignment.choose(choices)) {
        return *std::move(fault);
    }
    if (std::optional<ColumnFault> fault = assignment.takeNames()) {
        return *std::move(fault);
    }
    assignment.guessTime();
    assignment.guessCrankAngle();
    assignment.settlePairs();
    assignment.guessChannels();
    return assignment.take();
}

} // namespace slidercrank
