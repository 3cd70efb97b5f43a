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

std::optional<double> unitsPerSecond(const std::string &text)
{
    const std::optional<Unit> unit = text.empty() ? kSecond : parseUnit(text);
    return unit && unit->dimension == Dimension::Time ? std::optional(unit->factor) : std::nullopt;
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
    explicit Assignment(JoinedTable &table);

    std::optional<ReadError> takeChoices(std::span<const ColumnChoice> choices);
    std::optional<ReadError> takeAbscissas();
    std::optional<ReadError> assignChannels();
    std::optional<ReadError> findGap() const;

private:
    FileColumn &use(std::size_t i) const { return m_table.layout.columns[i]; }
    const Heading &heading(std::size_t i) const { return m_table.headings[i]; }
    Column scaled(const Claim &claim) const;
    bool isUndecided(std::size_t i) const
    {
        return use(i).role == ColumnRole::Ignored && use(i).reason == ColumnReason::UnknownName;
    }
    void set(std::size_t i, ColumnRole role, ColumnReason reason, std::optional<std::size_t> other = {}) const
    {
        use(i).role = role;
        use(i).reason = reason;
        use(i).otherColumn = other;
    }
    void setChannel(const Claim &claim) const;
    std::optional<std::size_t> columnOf(Channel channel) const;
    bool hasAbscissa(std::size_t file) const;
    std::optional<ReadError> takeAbscissa(std::size_t i, ColumnRole role, ColumnReason reason, const std::string &unit);
    std::optional<ReadError> guessAbscissa(std::size_t file);
    std::variant<Claim, ReadError, ColumnReason> claimOf(std::size_t i) const;
    void moveToCrank(std::vector<Claim> &claims) const;
    std::optional<ReadError> decide(std::vector<Claim> claims) const;
    ReadError twice(Channel channel, std::size_t first, std::size_t second, Fault fault) const;
    ReadError whyNoChannel(std::size_t file) const;

    JoinedTable &m_table;
    std::size_t m_count;
};

/// Says why columns without a meaning are ignored, where more can be said than that their name is unknown.
Assignment::Assignment(JoinedTable &table)
    : m_table(table)
    , m_count(table.headings.size())
{
    m_table.factors.assign(m_count, 1.0);
    for (std::size_t i = 0; i < m_count; ++i) {
        if (heading(i).printed.empty()) {
            use(i).reason = ColumnReason::NoName;
        } else if (heading(i).component) {
            set(i, ColumnRole::Ignored, ColumnReason::Magnitude,
                *heading(i).component + m_table.firstColumns[use(i).file]);
        } else if (heading(i).meaning.kind == Kind::RowNumber) {
            use(i).reason = ColumnReason::RowNumber;
        } else if (heading(i).meaning.kind == Kind::Nothing && endsInQuantity(heading(i))) {
            use(i).reason = ColumnReason::UnknownBody;
        }
    }
}

std::optional<std::size_t> Assignment::columnOf(Channel channel) const
{
    const auto found = std::ranges::find_if(m_table.layout.columns, [&](const FileColumn &column) {
        return column.role == ColumnRole::Channel && column.channel == channel;
    });
    const auto index = static_cast<std::size_t>(found - m_table.layout.columns.begin());
    return index < m_count ? std::optional(index) : std::nullopt;
}

bool Assignment::hasAbscissa(std::size_t file) const
{
    return std::ranges::any_of(m_table.layout.columns, [&](const FileColumn &column) {
        return column.file == file && (column.role == ColumnRole::Time || column.role == ColumnRole::CrankAngle ||
                                       column.reason == ColumnReason::SameInstants);
    });
}

Column Assignment::scaled(const Claim &claim) const
{
    Column values = m_table.columns[claim.column];
    std::ranges::transform(values, values.begin(), [&](double value) { return value * claim.factor; });
    return values;
}

void Assignment::setChannel(const Claim &claim) const
{
    set(claim.column, ColumnRole::Channel, claim.reason, claim.otherColumn);
    use(claim.column).channel = claim.channel;
    m_table.factors[claim.column] = claim.factor;
    if (claim.factor != 1.0) {
        m_table.columns[claim.column] = scaled(claim);
    }
}

/// Takes the column as the time or the crank angle. There may be others that hold the same, in other files or for
/// other signals: of all of them the one with most digits counts.
std::optional<ReadError> Assignment::takeAbscissa(std::size_t i, ColumnRole role, ColumnReason reason,
                                                  const std::string &unit)
{
    const bool isTime = role == ColumnRole::Time;
    const std::optional<double> perUnit = isTime ? unitsPerSecond(unit) : unitsPerDegree(unit);
    if (!perUnit) {
        return m_table.faultIn(i,
                               isTime ? ReadFault{Fault::UnknownTimeUnit} : ReadFault{Fault::UnknownUnit, kCrankAngle});
    }
    Column &values = m_table.columns[i];
    std::ranges::transform(values, values.begin(), [&](double value) { return value / *perUnit; });
    m_table.factors[i] = 1.0 / *perUnit;
    if (!m_table.abscissa) {
        m_table.abscissa = i;
        set(i, role, reason);
        return std::nullopt;
    }
    const std::size_t first = *m_table.abscissa;
    const Rounding own = m_table.roundings[i].inferOfInstants(m_table.factors[i]);
    const Rounding ofFirst = m_table.roundings[first].inferOfInstants(m_table.factors[first]);
    const std::size_t file = use(first).file;
    if (!areSameInstants(m_table.columns[first], ofFirst, values, own)) {
        return file == use(i).file
                   ? m_table.faultIn(i, {Fault::TimeTwice})
                   : ReadError{0, 0, {}, {Fault::OtherInstants, {}, m_table.layout.files[file]}, {}, use(i).file, file};
    }
    if (own.finestStep() > 0.0 && own.finestStep() < ofFirst.finestStep()) {
        std::swap(m_table.columns[first], values);
        std::swap(m_table.roundings[first], m_table.roundings[i]);
        std::swap(m_table.factors[first], m_table.factors[i]);
    }
    set(i, ColumnRole::Ignored, ColumnReason::SameInstants, first);
    return std::nullopt;
}

std::optional<ReadError> Assignment::takeChoices(std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        const std::size_t i = choice.column;
        if (i >= m_count) {
            continue; // a choice remembered from a wider file
        }
        const std::string &unit = choice.unit.empty() ? heading(i).unit : choice.unit;
        if (choice.role == ColumnRole::Ignored) {
            set(i, choice.role, ColumnReason::Chosen);
        } else if (choice.role == ColumnRole::Channel) {
            const std::optional<double> factor = factorTo(choice.channel, unit);
            if (!factor) {
                return m_table.faultIn(i, {Fault::UnknownUnit, choice.channel});
            }
            if (const std::optional<std::size_t> other = columnOf(choice.channel)) {
                return twice(choice.channel, *other, i, Fault::ChannelChosenTwice);
            }
            setChannel({i, choice.channel, Evidence::ChannelName, ColumnReason::Chosen, {}, *factor});
        } else if (hasAbscissa(use(i).file)) {
            return m_table.faultIn(i, {Fault::TimeChosenTwice});
        } else if (std::optional<ReadError> error = takeAbscissa(i, choice.role, ColumnReason::Chosen, unit)) {
            return error;
        }
    }
    return std::nullopt;
}

/// Takes, for a file where no column is named as the time, the one that is headed as that of another file; else the
/// first without a meaning that only rises; else the crank angle; else an angle in front of the other columns that goes
/// one way throughout, as in "theta, x, v".
std::optional<ReadError> Assignment::guessAbscissa(std::size_t file)
{
    bool isFirst = true;
    const auto isLike = [&](std::size_t i) {
        return m_table.abscissa && heading(i).printed == heading(*m_table.abscissa).printed;
    };
    const auto mayBeTime = [&](std::size_t i) {
        return isUndecided(i) && heading(i).meaning.kind == Kind::Nothing && unitsPerSecond(heading(i).unit) &&
               onlyRises(m_table.columns[i]);
    };
    const auto isNamedAngle = [&](std::size_t i) {
        return heading(i).isCrankAngle() && unitsPerDegree(heading(i).unit);
    };
    const auto isLeadingAngle = [&](std::size_t i) {
        const NameMeaning &meaning = heading(i).meaning;
        const bool isNext = isFirst;
        isFirst = isFirst && (use(i).reason == ColumnReason::NoName || use(i).reason == ColumnReason::RowNumber);
        return isNext && meaning.kind == Kind::Quantity && meaning.channel == Channel{Theta3, Order::Position} &&
               unitsPerDegree(heading(i).unit) &&
               !turnsBackAt(goingOn(scaled({i, {}, {}, {}, {}, 1.0 / *unitsPerDegree(heading(i).unit)})));
    };
    struct Candidate {
        std::function<bool(std::size_t)> suits;
        ColumnRole role;
        ColumnReason reason;
    };
    const ColumnRole role = m_table.abscissa ? use(*m_table.abscissa).role : ColumnRole::Ignored;
    for (const Candidate &candidate : {Candidate{isLike, role, ColumnReason::KnownName},
                                       Candidate{mayBeTime, ColumnRole::Time, ColumnReason::RisingValues},
                                       Candidate{isNamedAngle, ColumnRole::CrankAngle, ColumnReason::AngleForTime},
                                       Candidate{isLeadingAngle, ColumnRole::CrankAngle, ColumnReason::AngleForTime}}) {
        for (std::size_t i = 0; i < m_count && (role == ColumnRole::Ignored || role == candidate.role); ++i) {
            if (use(i).file == file && use(i).reason != ColumnReason::Chosen && candidate.suits(i)) {
                return takeAbscissa(i, candidate.role, candidate.reason, heading(i).unit);
            }
        }
    }
    return std::nullopt;
}

std::optional<ReadError> Assignment::takeAbscissas()
{
    const std::optional<std::size_t> chosen = m_table.abscissa;
    for (std::size_t file = 0; file < m_table.files.size(); ++file) {
        if (m_table.files[file].lines.size() != m_table.files[0].lines.size()) {
            return ReadError{0, 0, {}, {Fault::OtherInstants, {}, m_table.layout.files[0]}, {}, file, 0};
        }
        std::optional<ReadError> error;
        for (std::size_t i = 0; i < m_count && !error; ++i) {
            if (use(i).file != file || heading(i).meaning.kind != Kind::Time || !isUndecided(i)) {
                continue;
            }
            if (chosen && use(*chosen).file == file) {
                set(i, ColumnRole::Ignored, ColumnReason::LikeOther, chosen);
            } else if (!m_table.abscissa || use(*m_table.abscissa).role == ColumnRole::Time) {
                error = takeAbscissa(i, ColumnRole::Time, ColumnReason::KnownName, heading(i).unit);
            }
        }
        if (!error && !hasAbscissa(file)) {
            error = guessAbscissa(file);
        }
        if (error) {
            return error;
        }
    }
    return std::nullopt;
}

/// What the column could be by its name and unit, or why it cannot be anything.
std::variant<Claim, ReadError, ColumnReason> Assignment::claimOf(std::size_t i) const
{
    const Heading &heading = m_table.headings[i];
    const NameMeaning &meaning = heading.meaning;
    Claim claim{i, meaning.channel, meaning.isExact ? Evidence::ChannelName : Evidence::Words};
    if (meaning.kind == Kind::Quantity) {
        if (rangeOf(m_table.columns[i]).count == 0 && rangeOf(m_table.columns[*m_table.abscissa]).count > 0) {
            return ColumnReason::NoNumber;
        }
        const bool isInventor = !meaning.owner.empty() && !meaning.isModelica;
        if (!meaning.dimension && isInventor) {
            return heading.unit.empty() ? ColumnReason::AngleOrLength : ColumnReason::UnknownUnit;
        }
        claim.evidence = Evidence::QuantityAlone;
        claim.reason = !isInventor            ? ColumnReason::QuantityInName
                       : heading.unit.empty() ? ColumnReason::OtherOfJoint
                                              : ColumnReason::LetterAndUnit;
    }
    claim.reason = heading.hasUnitOfModelica ? ColumnReason::ModelicaName
                   : heading.isFromFileName  ? ColumnReason::FileName
                                             : claim.reason;
    const std::optional<double> factor = factorTo(claim.channel, heading.unit);
    if (!factor && meaning.isExact) {
        return m_table.faultIn(i, {Fault::UnknownUnit, claim.channel});
    }
    if (!factor) {
        return ColumnReason::UnknownUnit;
    }
    claim.factor = *factor;
    return claim;
}

/// An angle that grows at an even rate, or beyond one turn, is the crank's, and so are the derivatives of such a one.
void Assignment::moveToCrank(std::vector<Claim> &claims) const
{
    constexpr double kTurn = 360.0;
    const Column &time = m_table.columns[*m_table.abscissa];
    std::optional<std::size_t> base; // among the claims, of the order before
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        std::optional<std::size_t> found;
        for (std::size_t k = 0; k < claims.size(); ++k) {
            Claim &claim = claims[k];
            if (claim.evidence != Evidence::QuantityAlone || claim.channel != Channel{Theta3, order}) {
                continue;
            }
            const Column values = scaled(claim);
            const bool isPosition = order == Order::Position;
            const bool isOfCrank = isPosition ? isEven(time, values) || rangeOf(values).width() > kTurn
                                              : base && isDerivative(time, scaled(claims[*base]), values);
            if (isOfCrank) {
                claim.channel.coordinate = Theta2;
                claim.reason =
                    isPosition && isEven(time, values) ? ColumnReason::EvenRate : ColumnReason::BeyondOneTurn;
                claim.otherColumn = isPosition ? std::nullopt : std::optional(claims[*base].column);
                found = k;
            }
        }
        base = found;
    }
}

/// The error of two columns that are both the channel; `fault` if they stand in one file.
ReadError Assignment::twice(Channel channel, std::size_t first, std::size_t second, Fault fault) const
{
    const auto [file, later] = std::minmax(use(first).file, use(second).file);
    return file == later
               ? m_table.faultIn(second, {fault, channel})
               : ReadError{0, 0, {}, {Fault::ChannelInBoth, channel, m_table.layout.files[file]}, {}, later, file};
}

/// Gives the channel to the one claim with the best evidence. Of quantities without a body, derivatives have to be
/// those of the column that is one order less.
std::optional<ReadError> Assignment::decide(std::vector<Claim> claims) const
{
    const Channel channel = claims.front().channel;
    const std::optional<std::size_t> base =
        channel.order == Order::Position
            ? std::nullopt
            : columnOf({channel.coordinate, static_cast<Order>(static_cast<int>(channel.order) - 1)});
    if (base && use(*m_table.abscissa).role == ColumnRole::Time) { // by angle, nobody knows per how many seconds
        std::erase_if(claims, [&](const Claim &claim) {
            const bool isOther =
                claim.evidence == Evidence::QuantityAlone &&
                !isDerivative(m_table.columns[*m_table.abscissa], m_table.columns[*base], scaled(claim));
            if (isOther) {
                set(claim.column, ColumnRole::Ignored, ColumnReason::NotDerivative, base);
            }
            return isOther;
        });
    }
    if (claims.empty()) {
        return std::nullopt;
    }
    std::ranges::stable_sort(claims, std::ranges::greater(), &Claim::evidence);
    const Claim &first = claims.front();
    const std::optional<std::size_t> chosen = columnOf(channel);
    const bool isRivalled = claims.size() > 1 && claims[1].evidence == first.evidence;
    if (isRivalled && first.evidence == Evidence::ChannelName && !chosen) {
        return twice(channel, first.column, claims[1].column, Fault::ChannelTwice);
    }
    const bool isOne = std::ranges::all_of(claims, [&](const Claim &claim) {
        const auto isSame = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
        return claim.evidence != first.evidence ||
               (heading(claim.column).unit == heading(first.column).unit &&
                std::ranges::equal(m_table.columns[claim.column], m_table.columns[first.column], isSame));
    });
    for (const Claim &claim : claims) {
        const std::size_t rival = claims[isRivalled ? 1 : 0].column;
        set(claim.column, ColumnRole::Ignored, ColumnReason::LikeOther,
            chosen.value_or(claim.column == first.column ? rival : first.column));
        use(claim.column).channel = channel;
    }
    if (isOne && !chosen) {
        setChannel(first);
    }
    return std::nullopt;
}

std::optional<ReadError> Assignment::assignChannels()
{
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < m_count; ++i) {
        const Kind kind = heading(i).meaning.kind;
        const bool mayBe = kind == Kind::Channel || (kind == Kind::Quantity && m_table.abscissa);
        if (!isUndecided(i) || !mayBe) {
            continue;
        }
        auto claim = claimOf(i);
        if (ReadError *const error = std::get_if<ReadError>(&claim)) {
            return std::move(*error);
        }
        if (const Claim *const found = std::get_if<Claim>(&claim)) {
            claims.push_back(*found);
        } else {
            use(i).reason = std::get<ColumnReason>(claim);
        }
    }
    if (m_table.abscissa && !m_table.columns[*m_table.abscissa].empty()) {
        moveToCrank(claims);
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) { // positions before their derivatives
        std::vector<Claim> rivals;
        std::ranges::copy_if(claims, std::back_inserter(rivals),
                             [&](const Claim &claim) { return indexOf(claim.channel) == index; });
        if (std::optional<ReadError> error = rivals.empty() ? std::nullopt : decide(std::move(rivals))) {
            return error;
        }
    }
    return std::nullopt;
}

/// Why no channel is among the columns of a file that has a time.
ReadError Assignment::whyNoChannel(std::size_t file) const
{
    const RawTable &own = m_table.files[file];
    ReadError error{own.layout.headerLine, 0, own.headerText, {Fault::NoChannel}, {}, file};
    for (std::size_t i = m_count; i-- > 0;) {
        const FileColumn &column = use(i);
        if (column.file != file) {
            continue;
        }
        if (column.reason == ColumnReason::LikeOther && use(*column.otherColumn).file != file) {
            return twice(column.channel, i, *column.otherColumn, Fault::ChannelTwice);
        }
        if (leavesOpen(column.reason) || column.reason == ColumnReason::UnknownUnit ||
            column.reason == ColumnReason::NotDerivative) {
            error.fault = {Fault::NoCertainChannel, {}, excerpt(column.heading), column.reason};
        }
    }
    return error;
}

/// Why a file lacks what is needed of it.
std::optional<ReadError> Assignment::findGap() const
{
    for (std::size_t file = 0; file < m_table.files.size(); ++file) {
        const RawTable &own = m_table.files[file];
        const auto isUsed = [&](const FileColumn &column) {
            return column.file == file && column.role == ColumnRole::Channel;
        };
        const bool hasChannel = std::ranges::any_of(m_table.layout.columns, isUsed);
        if (hasAbscissa(file) && hasChannel) {
            continue;
        }
        if (own.layout.headerLine == 0) {
            const std::string &first = m_table.layout.rows[0][m_table.firstColumns[file]];
            return ReadError{own.firstDataLine, 1, first, {Fault::NamesMissing}, {}, file};
        }
        if (hasAbscissa(file)) {
            return whyNoChannel(file);
        }
        bool countsOtherwise = false;
        for (std::size_t i = 0; i < m_count && m_table.abscissa; ++i) {
            const bool isAngle = use(*m_table.abscissa).role == ColumnRole::CrankAngle;
            countsOtherwise |=
                use(i).file == file && (isAngle ? heading(i).meaning.kind == Kind::Time : heading(i).isCrankAngle());
        }
        const std::size_t other = m_table.abscissa ? use(*m_table.abscissa).file : file;
        return countsOtherwise
                   ? ReadError{0, 0, {}, {Fault::CountsOtherwise, {}, m_table.layout.files[other]}, {}, file, other}
                   : ReadError{own.layout.headerLine, 0, own.headerText, {Fault::NoTime}, {}, file};
    }
    return std::nullopt;
}

} // namespace

ReadError JoinedTable::faultIn(std::size_t column, ReadFault fault) const
{
    const std::size_t file = layout.columns[column].file;
    return {files[file].layout.headerLine,
            column - firstColumns[file] + 1,
            excerpt(headings[column].printed),
            std::move(fault),
            {},
            file};
}

std::optional<double> factorTo(Channel channel, const std::string &unitText)
{
    const Unit own{isAngle(channel.coordinate) ? Dimension::Angle : Dimension::Length, static_cast<int>(channel.order)};
    const std::optional<Unit> unit = unitText.empty() ? own : parseUnit(unitText);
    const bool suits = unit && unit->dimension == own.dimension && unit->order == own.order;
    return suits ? std::optional(unit->factor) : std::nullopt;
}

std::optional<ReadError> assignColumns(JoinedTable &table, std::span<const ColumnChoice> choices)
{
    Assignment assignment(table);
    std::optional<ReadError> error = assignment.takeChoices(choices);
    error = error ? error : assignment.takeAbscissas();
    error = error ? error : assignment.assignChannels();
    return error ? error : assignment.findGap();
}

} // namespace slidercrank
