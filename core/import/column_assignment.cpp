// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_assignment.h"

#include "core/import/abscissa.h"
#include "core/import/cells.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;
using Kind = NameMeaning::Kind;

enum class Evidence { QuantityAlone, Words, ChannelName };

/// A column that could be a channel.
struct Claim {
    RawColumn *column = nullptr;
    Channel channel{};
    Evidence evidence = Evidence::QuantityAlone;
    ColumnReason reason = ColumnReason::KnownName;
    double factor = 1.0; ///< to the default unit
};

/// Returns the factor to the default unit: 1 without a unit, nullopt if the unit does not suit the channel.
std::optional<double> factorTo(Channel channel, const std::string &unitText)
{
    const Unit own{isAngle(channel.coordinate) ? Dimension::Angle : Dimension::Length, static_cast<int>(channel.order)};
    const std::optional<Unit> unit = unitText.empty() ? own : parseUnit(unitText);
    const bool suits = unit && unit->dimension == own.dimension && unit->order == own.order;
    return suits ? std::optional(unit->factor) : std::nullopt;
}

/// Sets why columns without a meaning are ignored, if there is more to say than that the name is unknown.
void setReasons(RawTable &table)
{
    for (RawColumn &column : table.columns) {
        const Heading &heading = column.heading;
        if (heading.printed.empty()) {
            column.setReason(ColumnReason::NoName);
        } else if (heading.component) {
            column.setReason(ColumnReason::Magnitude, *heading.component + table.fileOf(column).firstColumn);
        } else if (heading.meaning.kind == Kind::RowNumber) {
            column.setReason(ColumnReason::RowNumber);
        } else if (heading.meaning.kind == Kind::AngleOrLength) {
            column.setReason(heading.unit.empty() ? ColumnReason::AngleOrLength : ColumnReason::UnknownUnit);
        } else if (heading.meaning.kind == Kind::Nothing && endsInQuantity(heading)) {
            column.setReason(ColumnReason::UnknownBody);
        }
    }
}

const RawColumn *findChannel(const RawTable &table, Channel channel)
{
    const auto found = std::ranges::find_if(table.columns, [&](const RawColumn &column) {
        return column.use.role == ColumnRole::Channel && column.use.channel == channel;
    });
    return found == table.columns.end() ? nullptr : &*found;
}

void setChannel(const Claim &claim)
{
    RawColumn &column = *claim.column;
    column.use.role = ColumnRole::Channel;
    column.use.channel = claim.channel;
    column.setReason(claim.reason);
    column.factor = claim.factor;
    std::ranges::for_each(column.values, [&](double &value) { value *= claim.factor; });
}

/// Returns the error that two columns are the same channel: `fault` if they are in one file.
ReadError conflict(const RawTable &table, const RawColumn &column, const RawColumn &other, Channel channel, Fault fault)
{
    const auto &[first, second] = column.index < other.index ? std::tie(column, other) : std::tie(other, column);
    const std::size_t file = first.use.file;
    const std::size_t later = second.use.file;
    return file == later
               ? faultIn(table, second, {fault, channel})
               : ReadError{0, 0, {}, {Fault::ChannelInBoth, channel, table.files[file].name}, {}, later};
}

void applyChoices(RawTable &table, std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        if (choice.column >= table.columns.size()) {
            continue; // remembered from a file with more columns
        }
        RawColumn &column = table.columns[choice.column];
        const std::string &unit = choice.unit.empty() ? column.heading.unit : choice.unit;
        if (choice.role == ColumnRole::Ignored) {
            column.setReason(ColumnReason::Chosen);
        } else if (choice.role != ColumnRole::Channel) {
            if (hasAbscissa(table, column.use.file)) {
                throw faultIn(table, column, {Fault::TimeChosenTwice});
            }
            setAbscissa(table, column, choice.role, ColumnReason::Chosen, unit);
        } else if (const RawColumn *const other = findChannel(table, choice.channel)) {
            throw conflict(table, column, *other, choice.channel, Fault::ChannelChosenTwice);
        } else if (const std::optional<double> factor = factorTo(choice.channel, unit)) {
            setChannel({&column, choice.channel, Evidence::ChannelName, ColumnReason::Chosen, *factor});
        } else {
            throw faultIn(table, column, {Fault::UnknownUnit, choice.channel});
        }
    }
}

/// Returns what the column could be according to its name and unit. Otherwise sets the reason why it is ignored.
std::optional<Claim> claimOf(const RawTable &table, RawColumn &column)
{
    const Heading &heading = column.heading;
    const NameMeaning &meaning = heading.meaning;
    const bool isQuantity = meaning.kind == Kind::Quantity;
    if (!column.isUndecided() || (meaning.kind != Kind::Channel && !isQuantity)) {
        return std::nullopt;
    }
    const std::optional<double> factor = factorTo(meaning.channel, heading.unit);
    if (!factor && meaning.isExact) {
        throw faultIn(table, column, {Fault::UnknownUnit, meaning.channel});
    }
    if (!factor) {
        column.setReason(ColumnReason::UnknownUnit);
        return std::nullopt;
    }
    const ColumnReason reason = heading.hasUnitOfModelica ? ColumnReason::ModelicaName
                                : !isQuantity             ? ColumnReason::KnownName
                                                          : ColumnReason::QuantityInName;
    const Evidence evidence = isQuantity        ? Evidence::QuantityAlone
                              : meaning.isExact ? Evidence::ChannelName
                                                : Evidence::Words;
    return Claim{&column, meaning.channel, evidence, reason, *factor};
}

/// Returns the range of a column of angles, in degrees, without the jumps of angles that are limited to one turn.
double sweepOf(const Claim &claim)
{
    std::vector<double> degrees;
    for (const double value : claim.column->values) {
        if (std::isfinite(value)) {
            degrees.push_back(value * claim.factor);
        }
    }
    return rangeOf(unwrapped(std::move(degrees))).width();
}

/// Reassigns angles of an unnamed body that have to be the crank angle, and the derivatives that belong to them. If
/// another angle of the same owner does not, it is open whose derivatives they are.
void findCrank(std::vector<Claim> &claims)
{
    constexpr double kHalfTurn = 180.0; // the coupler swings less in every mechanism that makes full turns
    const auto isOfUnnamedBody = [](const Claim &claim) {
        return claim.evidence == Evidence::QuantityAlone && isAngle(claim.channel.coordinate);
    };
    const auto isPosition = [&](const Claim &claim) {
        return isOfUnnamedBody(claim) && claim.channel.order == Order::Position;
    };
    for (Claim &claim : claims) {
        if (isPosition(claim) && sweepOf(claim) > kHalfTurn) {
            claim.channel = kCrankAngle;
            claim.reason = ColumnReason::WideAngle;
        }
    }
    std::vector<Claim> settled;
    for (Claim claim : claims) {
        const RawColumn *crank = nullptr; // whose derivative the column may be
        bool isAmbiguous = false;
        const std::string &owner = claim.column->heading.meaning.owner;
        for (const Claim &angle : claims) {
            if (isOfUnnamedBody(claim) && !isPosition(claim) && isPosition(angle) &&
                angle.column->heading.meaning.owner == owner) {
                crank = angle.channel == kCrankAngle ? angle.column : crank;
                isAmbiguous = isAmbiguous || angle.channel != kCrankAngle;
            }
        }
        if (crank && isAmbiguous) {
            claim.column->setReason(ColumnReason::LikeOther, crank->index);
            continue;
        }
        claim.channel.coordinate = crank ? Theta2 : claim.channel.coordinate;
        claim.reason = crank ? ColumnReason::WideAngle : claim.reason;
        settled.push_back(claim);
    }
    claims = std::move(settled);
}

/// Gives a channel to the claim with the best evidence, if there is only one.
void decide(const RawTable &table, std::vector<Claim> claims)
{
    std::ranges::stable_sort(claims, std::ranges::greater(), &Claim::evidence);
    const Claim &best = claims.front();
    const RawColumn *const chosen = findChannel(table, best.channel);
    const bool hasRival = claims.size() > 1 && claims[1].evidence == best.evidence;
    if (hasRival && best.evidence == Evidence::ChannelName && !chosen) {
        throw conflict(table, *best.column, *claims[1].column, best.channel, Fault::ChannelTwice);
    }
    for (const Claim &claim : claims) {
        const RawColumn *const rival = claim.column == best.column ? claims[hasRival ? 1 : 0].column : best.column;
        claim.column->setReason(ColumnReason::LikeOther, (chosen ? chosen : rival)->index);
        claim.column->use.channel = best.channel;
    }
    if (!chosen && !hasRival) {
        setChannel(best);
    }
}

void assignChannels(RawTable &table)
{
    std::vector<Claim> claims;
    for (RawColumn &column : table.columns) {
        if (const std::optional<Claim> claim = claimOf(table, column)) {
            claims.push_back(*claim);
        }
    }
    findCrank(claims);
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        std::vector<Claim> rivals;
        const auto isOfChannel = [&](const Claim &claim) { return indexOf(claim.channel) == index; };
        std::ranges::copy_if(claims, std::back_inserter(rivals), isOfChannel);
        if (!rivals.empty()) {
            decide(table, std::move(rivals));
        }
    }
}

/// Returns the error that the file lacks the time or a channel.
ReadError findMissing(const RawTable &table, std::size_t file)
{
    const TableFile &own = table.files[file];
    const FileLayout &layout = own.form.layout;
    if (layout.headerLine == 0) {
        const Cells cells = splitCells(own.rows.front().text, layout.delimiter);
        return {own.form.firstDataLine, 1, excerpt(cells.front()), {Fault::NamesMissing}, {}, file};
    }
    ReadError error{layout.headerLine, 0, own.form.headerText, {Fault::NoTime}, {}, file};
    if (!hasAbscissa(table, file)) {
        return error;
    }
    error.fault.kind = Fault::NoChannel;
    for (const RawColumn &column : table.columns) {
        const ColumnReason reason = column.use.reason;
        if (column.use.file != file) {
            continue;
        }
        if (reason == ColumnReason::LikeOther && table.columns[*column.use.otherColumn].use.file != file) {
            return conflict(table, column, table.columns[*column.use.otherColumn], column.use.channel,
                            Fault::NoChannel);
        }
        if (leavesOpen(reason) || reason == ColumnReason::UnknownUnit) {
            error.fault = {Fault::NoCertainChannel, {}, excerpt(column.heading.printed), reason};
            return error;
        }
    }
    return error;
}

} // namespace

void assignColumns(RawTable &table, std::span<const ColumnChoice> choices)
{
    setReasons(table);
    applyChoices(table, choices);
    assignAbscissas(table);
    assignChannels(table);
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const bool hasChannel = std::ranges::any_of(table.columns, [&](const RawColumn &column) {
            return column.use.file == file && column.use.role == ColumnRole::Channel;
        });
        if (!hasChannel || !hasAbscissa(table, file)) {
            throw findMissing(table, file);
        }
    }
}

} // namespace slidercrank
