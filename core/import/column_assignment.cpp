// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_assignment.h"

#include "core/import/cells.h"
#include "core/import/clock.h"
#include "core/import/crank_angles.h"
#include "core/import/quantity.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;
using Kind = NameMeaning::Kind;
using Column = std::vector<double>;

constexpr Channel kCrankAngle{Theta2, Order::Position};
constexpr std::size_t kFewestValues = 8; // fewer values do not show how a quantity moves

/// Whether each value is above the one before, where rows can be read.
bool onlyRises(const Column &values)
{
    double before = -std::numeric_limits<double>::infinity();
    for (const double value : values) {
        if (!(std::isinf(value) || value > before)) {
            return false;
        }
        before = std::isinf(value) ? before : value;
    }
    return rangeOf(values).count >= 2;
}

/// Whether an angle grows at one rate throughout.
bool isEven(const Column &time, const Column &values)
{
    constexpr double kEvenness = 1e-3; // of the range: columns may have few digits
    const ValueRange range = rangeOf(values);
    const double slope = (values.back() - values.front()) / (time.back() - time.front());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double line = values.front() + slope * (time[i] - time.front());
        if (std::isfinite(values[i] + time[i]) && !(std::abs(line - values[i]) <= kEvenness * range.width())) {
            return false;
        }
    }
    return range.count >= kFewestValues && range.width() > 0.0;
}

/// Whether `rate` is the time derivative of `values`, by its integral: differences of rounded values would be noise.
/// Also true where there is too little to judge by.
bool isDerivative(const Column &time, const Column &values, const Column &rate)
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
        if (!std::isfinite(time[i] + values[i] + rate[i])) {
            continue;
        }
        first = count++ == 0 ? i : first;
        integral += count > 1 ? 0.5 * (rate[last] + rate[i]) * (time[i] - time[last]) : 0.0;
        worst = std::max(worst, std::abs(values[i] - values[first] - integral));
        largest = std::max(largest, std::abs(integral));
        last = i;
    }
    return count < kFewestValues || worst <= kTolerance * std::max(rangeOf(values).width(), largest);
}

/// Whether two lists of time stamps are the same as far as they are printed; nearer than a quarter of their spacing.
bool areSameInstants(const Column &x, const Rounding &ofX, const Column &y, const Rounding &ofY)
{
    constexpr double kUlps = 4.0; // of a change of unit in either
    constexpr double kOfSpacing = 0.25;
    const ValueRange range = rangeOf(x);
    const double spacing = range.width() / static_cast<double>(std::max<std::size_t>(range.count, 2) - 1);
    const double rounded = 0.5 * (clockOf(x, ofX).step() + clockOf(y, ofY).step());
    return std::ranges::equal(x, y, [allowed = std::min(rounded, kOfSpacing * spacing)](double a, double b) {
        const double ulps = kUlps * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
        return !std::isfinite(a - b) || std::abs(a - b) <= allowed + ulps;
    });
}

/// By what a column of that role has to be divided; nothing where the unit does not suit.
std::optional<double> divisorFor(ColumnRole role, const std::string &unit)
{
    const std::optional<Unit> time = unit.empty() ? kSecond : parseUnit(unit);
    return role == ColumnRole::CrankAngle               ? unitsPerDegree(unit)
           : time && time->dimension == Dimension::Time ? std::optional(time->factor)
                                                        : std::nullopt;
}

/// The factor to the author's unit; 1 without a unit, nothing where the unit does not suit.
std::optional<double> factorTo(Channel channel, const std::string &unitText)
{
    const Unit own{isAngle(channel.coordinate) ? Dimension::Angle : Dimension::Length, static_cast<int>(channel.order)};
    const std::optional<Unit> unit = unitText.empty() ? own : parseUnit(unitText);
    const bool suits = unit && unit->dimension == own.dimension && unit->order == own.order;
    return suits ? std::optional(unit->factor) : std::nullopt;
}

bool isSame(const Column &x, const Column &y)
{
    return std::ranges::equal(x, y, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

enum class Evidence { QuantityAlone, Words, ChannelName };

/// A column that could be a channel.
struct Claim {
    std::size_t column = 0;
    Channel channel{};
    Evidence evidence = Evidence::QuantityAlone;
    ColumnReason reason = ColumnReason::KnownName;
    std::optional<std::size_t> otherColumn{};
    double factor = 1.0;
};

class Assignment
{
public:
    explicit Assignment(RawTable &table);

    void takeChoices(std::span<const ColumnChoice> choices);
    void takeAbscissas();
    void assignChannels();
    void requireAbscissaAndChannel(std::size_t file) const;

private:
    FileColumn &use(std::size_t i) const { return m_table.layout.columns[i]; }
    const Heading &heading(std::size_t i) const { return m_table.headings[i]; }
    const Column &abscissa() const { return m_table.columns[*m_table.abscissa]; }
    Column scaled(std::size_t i, double factor) const;
    bool isUndecided(std::size_t i) const
    {
        return use(i).role == ColumnRole::Ignored && use(i).reason == ColumnReason::UnknownName;
    }
    void ignore(std::size_t i, ColumnReason reason, std::optional<std::size_t> other = {}) const
    {
        use(i).reason = reason;
        use(i).otherColumn = other;
    }
    void setChannel(const Claim &claim) const;
    std::optional<std::size_t> columnOf(Channel channel) const;
    bool hasAbscissa(std::size_t file) const;
    void takeAbscissa(std::size_t i, ColumnRole role, ColumnReason reason, const std::string &unit);
    void guessAbscissa(std::size_t file);
    std::optional<Claim> claimOf(std::size_t i) const;
    void moveToCrank(std::vector<Claim> &claims) const;
    void dropOtherDerivatives(std::vector<Claim> &claims) const;
    void decide(std::vector<Claim> claims) const;
    ReadError twice(Channel channel, std::size_t first, std::size_t second, Fault fault) const;

    RawTable &m_table;
    std::size_t m_count;
};

/// Says why columns without a meaning are ignored, where more can be said than that their name is unknown.
Assignment::Assignment(RawTable &table)
    : m_table(table)
    , m_count(table.headings.size())
{
    m_table.factors.assign(m_count, 1.0);
    for (std::size_t i = 0; i < m_count; ++i) {
        const Heading &own = heading(i);
        if (own.printed.empty()) {
            ignore(i, ColumnReason::NoName);
        } else if (own.component) {
            ignore(i, ColumnReason::Magnitude, *own.component + m_table.fileOf(i).firstColumn);
        } else if (own.meaning.kind == Kind::RowNumber) {
            ignore(i, ColumnReason::RowNumber);
        } else if (own.meaning.kind == Kind::Nothing && endsInQuantity(own)) {
            ignore(i, ColumnReason::UnknownBody);
        }
    }
}

std::optional<std::size_t> Assignment::columnOf(Channel channel) const
{
    for (std::size_t i = 0; i < m_count; ++i) {
        if (use(i).role == ColumnRole::Channel && use(i).channel == channel) {
            return i;
        }
    }
    return std::nullopt;
}

bool Assignment::hasAbscissa(std::size_t file) const
{
    return std::ranges::any_of(m_table.layout.columns, [&](const FileColumn &column) {
        return column.file == file && (column.role == ColumnRole::Time || column.role == ColumnRole::CrankAngle ||
                                       column.reason == ColumnReason::SameInstants);
    });
}

Column Assignment::scaled(std::size_t i, double factor) const
{
    Column values = m_table.columns[i];
    std::ranges::transform(values, values.begin(), [&](double value) { return value * factor; });
    return values;
}

void Assignment::setChannel(const Claim &claim) const
{
    use(claim.column).role = ColumnRole::Channel;
    use(claim.column).channel = claim.channel;
    ignore(claim.column, claim.reason, claim.otherColumn);
    m_table.factors[claim.column] = claim.factor;
    if (claim.factor != 1.0) {
        m_table.columns[claim.column] = scaled(claim.column, claim.factor);
    }
}

/// Takes the column as the time or the crank angle. There may be others that hold the same, in other files or for
/// other signals: of all of them the one with most digits counts.
void Assignment::takeAbscissa(std::size_t i, ColumnRole role, ColumnReason reason, const std::string &unit)
{
    const std::optional<double> divisor = divisorFor(role, unit);
    if (!divisor) {
        throw faultIn(m_table, i,
                      role == ColumnRole::Time ? ReadFault{Fault::UnknownTimeUnit}
                                               : ReadFault{Fault::UnknownUnit, {Theta2, Order::Position}});
    }
    Column &values = m_table.columns[i];
    std::ranges::transform(values, values.begin(), [&](double value) { return value / *divisor; });
    m_table.factors[i] = 1.0 / *divisor;
    if (!m_table.abscissa) {
        m_table.abscissa = i;
        use(i).role = role;
        ignore(i, reason);
        return;
    }
    const std::size_t first = *m_table.abscissa;
    const Rounding own = m_table.roundings[i].inferOfInstants(m_table.factors[i]);
    const Rounding ofFirst = m_table.roundings[first].inferOfInstants(m_table.factors[first]);
    const std::size_t file = use(first).file;
    if (!areSameInstants(abscissa(), ofFirst, values, own)) {
        throw file == use(i).file
            ? faultIn(m_table, i, {Fault::TimeTwice})
            : ReadError{0, 0, {}, {Fault::OtherInstants, {}, m_table.layout.files[file]}, {}, use(i).file, file};
    }
    if (own.finestStep() > 0.0 && own.finestStep() < ofFirst.finestStep()) {
        std::swap(m_table.columns[first], values);
        std::swap(m_table.roundings[first], m_table.roundings[i]);
        std::swap(m_table.factors[first], m_table.factors[i]);
    }
    ignore(i, ColumnReason::SameInstants, first);
}

void Assignment::takeChoices(std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        const std::size_t i = choice.column;
        if (i >= m_count) {
            continue; // a choice remembered from a wider file
        }
        const std::string &unit = choice.unit.empty() ? heading(i).unit : choice.unit;
        if (choice.role == ColumnRole::Ignored) {
            ignore(i, ColumnReason::Chosen);
        } else if (choice.role != ColumnRole::Channel) {
            if (hasAbscissa(use(i).file)) {
                throw faultIn(m_table, i, {Fault::TimeChosenTwice});
            }
            takeAbscissa(i, choice.role, ColumnReason::Chosen, unit);
        } else if (const std::optional<std::size_t> other = columnOf(choice.channel)) {
            throw twice(choice.channel, *other, i, Fault::ChannelChosenTwice);
        } else if (const std::optional<double> factor = factorTo(choice.channel, unit)) {
            setChannel({i, choice.channel, Evidence::ChannelName, ColumnReason::Chosen, {}, *factor});
        } else {
            throw faultIn(m_table, i, {Fault::UnknownUnit, choice.channel});
        }
    }
}

/// Takes, where no column is named as the time, the one that is headed as that of another file. In the first file it is
/// the first column without a meaning that only rises, else the crank angle, else an angle in front of the other
/// columns that goes one way throughout, as in "theta, x, v".
void Assignment::guessAbscissa(std::size_t file)
{
    const auto find = [&](const auto &suits) {
        std::size_t i = 0;
        while (i < m_count && (use(i).file != file || use(i).reason == ColumnReason::Chosen || !suits(i))) {
            ++i;
        }
        return i;
    };
    const auto isAngle = [&](std::size_t i) { return divisorFor(ColumnRole::CrankAngle, heading(i).unit).has_value(); };
    const std::size_t angle = find([&](std::size_t i) { return heading(i).isCrankAngle() && isAngle(i); });
    if (m_table.abscissa) {
        const ColumnRole role = use(*m_table.abscissa).role;
        const std::string &name = heading(*m_table.abscissa).printed;
        const std::size_t same = find([&](std::size_t i) { return heading(i).printed == name; });
        const std::size_t found = same == m_count && role == ColumnRole::CrankAngle ? angle : same;
        if (found < m_count) {
            takeAbscissa(found, role, ColumnReason::KnownName, heading(found).unit);
        }
        return;
    }
    const std::size_t time = find([&](std::size_t i) {
        return isUndecided(i) && heading(i).meaning.kind == Kind::Nothing &&
               divisorFor(ColumnRole::Time, heading(i).unit) && onlyRises(m_table.columns[i]);
    });
    if (time < m_count) {
        return takeAbscissa(time, ColumnRole::Time, ColumnReason::RisingValues, heading(time).unit);
    }
    const std::size_t leading = find([&](std::size_t i) {
        return use(i).reason != ColumnReason::NoName && use(i).reason != ColumnReason::RowNumber;
    });
    const auto goesOneWay = [&](std::size_t i) {
        const NameMeaning &meaning = heading(i).meaning;
        return meaning.kind == Kind::Quantity && meaning.channel == Channel{Theta3, Order::Position} && isAngle(i) &&
               !turnsBackAt(goingOn(scaled(i, 1.0 / *unitsPerDegree(heading(i).unit))));
    };
    const std::size_t found = angle == m_count && leading < m_count && goesOneWay(leading) ? leading : angle;
    if (found < m_count) {
        takeAbscissa(found, ColumnRole::CrankAngle, ColumnReason::AngleForTime, heading(found).unit);
    }
}

void Assignment::takeAbscissas()
{
    const std::optional<std::size_t> chosen = m_table.abscissa;
    for (std::size_t file = 0; file < m_table.files.size(); ++file) {
        if (m_table.files[file].lines.size() != m_table.files[0].lines.size()) {
            throw ReadError{0, 0, {}, {Fault::OtherInstants, {}, m_table.layout.files[0]}, {}, file, 0};
        }
        for (std::size_t i = 0; i < m_count; ++i) {
            if (use(i).file != file || heading(i).meaning.kind != Kind::Time || !isUndecided(i)) {
                continue;
            }
            if (chosen && use(*chosen).file == file) {
                ignore(i, ColumnReason::LikeOther, chosen);
            } else if (!m_table.abscissa || use(*m_table.abscissa).role == ColumnRole::Time) {
                takeAbscissa(i, ColumnRole::Time, ColumnReason::KnownName, heading(i).unit);
            }
        }
        if (!hasAbscissa(file)) {
            guessAbscissa(file);
        }
    }
}

/// What the column could be by its name and unit; nothing, and the reason set, where it cannot be anything.
std::optional<Claim> Assignment::claimOf(std::size_t i) const
{
    const Heading &own = heading(i);
    const NameMeaning &meaning = own.meaning;
    const bool isQuantity = meaning.kind == Kind::Quantity;
    if (!isUndecided(i) || (meaning.kind != Kind::Channel && !(isQuantity && m_table.abscissa))) {
        return std::nullopt;
    }
    const bool isInventor = isQuantity && !meaning.owner.empty() && !meaning.isModelica;
    const std::optional<double> factor = factorTo(meaning.channel, own.unit);
    if (!factor && meaning.isExact) {
        throw faultIn(m_table, i, {Fault::UnknownUnit, meaning.channel});
    }
    if (isQuantity && rangeOf(m_table.columns[i]).count == 0 && rangeOf(abscissa()).count > 0) {
        ignore(i, ColumnReason::NoNumber);
    } else if (isInventor && !meaning.dimension && own.unit.empty()) {
        ignore(i, ColumnReason::AngleOrLength);
    } else if (!factor || (isInventor && !meaning.dimension)) {
        ignore(i, ColumnReason::UnknownUnit);
    } else {
        const ColumnReason reason = own.hasUnitOfModelica ? ColumnReason::ModelicaName
                                    : own.isFromFileName  ? ColumnReason::FileName
                                    : !isQuantity         ? ColumnReason::KnownName
                                    : !isInventor         ? ColumnReason::QuantityInName
                                    : own.unit.empty()    ? ColumnReason::OtherOfJoint
                                                          : ColumnReason::LetterAndUnit;
        const Evidence evidence = isQuantity        ? Evidence::QuantityAlone
                                  : meaning.isExact ? Evidence::ChannelName
                                                    : Evidence::Words;
        return Claim{i, meaning.channel, evidence, reason, {}, *factor};
    }
    return std::nullopt;
}

/// An angle that grows at an even rate, or beyond one turn, is the crank's, and so are the derivatives of such a one.
void Assignment::moveToCrank(std::vector<Claim> &claims) const
{
    constexpr double kTurn = 360.0;
    const Claim *base = nullptr; // the angle of the crank, or what is of one order more
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const Claim *found = nullptr;
        for (Claim &claim : claims) {
            if (claim.evidence != Evidence::QuantityAlone || claim.channel != Channel{Theta3, order}) {
                continue;
            }
            const Column values = scaled(claim.column, claim.factor);
            const bool hasEvenRate = order == Order::Position && isEven(abscissa(), values);
            const bool isBeyond = order == Order::Position && rangeOf(values).width() > kTurn;
            if (hasEvenRate || isBeyond ||
                (base && isDerivative(abscissa(), scaled(base->column, base->factor), values))) {
                claim.channel.coordinate = Theta2;
                claim.reason = hasEvenRate ? ColumnReason::EvenRate : ColumnReason::BeyondOneTurn;
                claim.otherColumn = base ? std::optional(base->column) : std::nullopt;
                found = &claim;
            }
        }
        base = found;
    }
}

/// Of quantities without a body, derivatives have to be those of the column that is of one order less.
void Assignment::dropOtherDerivatives(std::vector<Claim> &claims) const
{
    const Channel channel = claims.front().channel;
    const bool isDerived = channel.order != Order::Position && use(*m_table.abscissa).role == ColumnRole::Time;
    const auto before = static_cast<Order>(static_cast<int>(channel.order) - 1);
    const std::optional<std::size_t> base = isDerived ? columnOf({channel.coordinate, before}) : std::nullopt;
    std::erase_if(claims, [&](const Claim &claim) {
        const bool isOther = base && claim.evidence == Evidence::QuantityAlone &&
                             !isDerivative(abscissa(), m_table.columns[*base], scaled(claim.column, claim.factor));
        if (isOther) {
            ignore(claim.column, ColumnReason::NotDerivative, base);
        }
        return isOther;
    });
}

/// The error of two columns that are both the channel; `fault` if they stand in one file.
ReadError Assignment::twice(Channel channel, std::size_t first, std::size_t second, Fault fault) const
{
    const auto [file, later] = std::minmax(use(first).file, use(second).file);
    return file == later
               ? faultIn(m_table, second, {fault, channel})
               : ReadError{0, 0, {}, {Fault::ChannelInBoth, channel, m_table.layout.files[file]}, {}, later, file};
}

/// Gives the channel to the one claim with the best evidence.
void Assignment::decide(std::vector<Claim> claims) const
{
    std::ranges::stable_sort(claims, std::ranges::greater(), &Claim::evidence);
    const Claim &best = claims.front();
    const std::optional<std::size_t> chosen = columnOf(best.channel);
    const bool isRivalled = claims.size() > 1 && claims[1].evidence == best.evidence;
    if (isRivalled && best.evidence == Evidence::ChannelName && !chosen) {
        throw twice(best.channel, best.column, claims[1].column, Fault::ChannelTwice);
    }
    bool isOne = !chosen;
    for (const Claim &claim : claims) {
        isOne = isOne && (claim.evidence != best.evidence ||
                          (heading(claim.column).unit == heading(best.column).unit &&
                           isSame(m_table.columns[claim.column], m_table.columns[best.column])));
        const std::size_t rival = claim.column == best.column ? claims[isRivalled ? 1 : 0].column : best.column;
        ignore(claim.column, ColumnReason::LikeOther, chosen.value_or(rival));
        use(claim.column).channel = best.channel;
    }
    if (isOne) {
        setChannel(best);
    }
}

void Assignment::assignChannels()
{
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < m_count; ++i) {
        if (const std::optional<Claim> claim = claimOf(i)) {
            claims.push_back(*claim);
        }
    }
    if (m_table.abscissa && !abscissa().empty()) {
        moveToCrank(claims);
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) { // positions before their derivatives
        std::vector<Claim> rivals;
        const auto isOfChannel = [&](const Claim &claim) { return indexOf(claim.channel) == index; };
        std::ranges::copy_if(claims, std::back_inserter(rivals), isOfChannel);
        if (!rivals.empty() && m_table.abscissa) {
            dropOtherDerivatives(rivals);
        }
        if (!rivals.empty()) {
            decide(std::move(rivals));
        }
    }
}

/// Throws where the file lacks one of them.
void Assignment::requireAbscissaAndChannel(std::size_t file) const
{
    const TableFile &own = m_table.files[file];
    ReadError error{
        own.headerLine, 0, own.headerText, {hasAbscissa(file) ? Fault::NoChannel : Fault::NoTime}, {}, file};
    const std::size_t first = m_table.abscissa ? use(*m_table.abscissa).file : file;
    const bool isByAngle = m_table.abscissa && use(*m_table.abscissa).role == ColumnRole::CrankAngle;
    bool hasChannel = false;
    for (std::size_t i = m_count; i-- > 0;) {
        const FileColumn &column = use(i);
        if (column.file != file) {
            continue;
        }
        hasChannel = hasChannel || column.role == ColumnRole::Channel;
        const bool isOtherAbscissa = isByAngle ? heading(i).meaning.kind == Kind::Time : heading(i).isCrankAngle();
        if (!hasAbscissa(file) && first != file && isOtherAbscissa) {
            error = {0, 0, {}, {Fault::CountsOtherwise, {}, m_table.layout.files[first]}, {}, file, first};
        } else if (error.fault.kind == Fault::NoTime) {
            continue;
        } else if (column.reason == ColumnReason::LikeOther && use(*column.otherColumn).file != file) {
            error = twice(column.channel, i, *column.otherColumn, Fault::ChannelTwice);
        } else if (leavesOpen(column.reason) || column.reason == ColumnReason::UnknownUnit ||
                   column.reason == ColumnReason::NotDerivative) {
            error.fault = {Fault::NoCertainChannel, {}, excerpt(column.heading), column.reason};
        }
    }
    if (hasAbscissa(file) && hasChannel) {
        return;
    }
    throw own.headerLine > 0 ? error : ReadError{own.firstDataLine,     1,  m_table.layout.rows[0][own.firstColumn],
                                                 {Fault::NamesMissing}, {}, file};
}

} // namespace

ReadError faultIn(const RawTable &table, std::size_t column, ReadFault fault)
{
    const TableFile &file = table.fileOf(column);
    const std::string text = excerpt(table.headings[column].printed);
    return {
        file.headerLine, column - file.firstColumn + 1, text, std::move(fault), {}, table.layout.columns[column].file};
}

void assignColumns(RawTable &table, std::span<const ColumnChoice> choices)
{
    Assignment assignment(table);
    assignment.takeChoices(choices);
    assignment.takeAbscissas();
    assignment.assignChannels();
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        assignment.requireAbscissaAndChannel(file);
    }
}

} // namespace slidercrank
