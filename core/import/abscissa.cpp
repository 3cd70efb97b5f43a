// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/abscissa.h"

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
using Values = std::vector<double>;

/// Returns whether two columns contain the same time stamps, apart from the rounding errors of a unit conversion.
bool areSameTimes(const Values &x, const Values &y)
{
    constexpr double kUlps = 4.0;
    return std::ranges::equal(x, y, [](double a, double b) {
        const double allowed = kUlps * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
        return !std::isfinite(a - b) || std::abs(a - b) <= allowed;
    });
}

/// Returns the number by which a column of that role has to be divided, or nullopt if the unit does not suit the role.
std::optional<double> divisorFor(ColumnRole role, const std::string &unit)
{
    const std::optional<Unit> time = unit.empty() ? kSecond : parseUnit(unit);
    return role == ColumnRole::CrankAngle               ? unitsPerDegree(unit)
           : time && time->dimension == Dimension::Time ? std::optional(time->factor)
                                                        : std::nullopt;
}

/// Returns whether the column has an unknown name and values that only rise, apart from unreadable cells.
bool mayBeTime(const RawColumn &column)
{
    const bool isUnknown = column.isUndecided() && column.heading.meaning.kind == Kind::Nothing;
    if (!isUnknown || !divisorFor(ColumnRole::Time, column.heading.unit)) {
        return false;
    }
    double before = -std::numeric_limits<double>::infinity();
    for (const double value : column.values) {
        if (!(std::isinf(value) || value > before)) {
            return false;
        }
        before = std::isinf(value) ? before : value;
    }
    return rangeOf(column.values).count >= 2;
}

/// Returns whether the column is an angle of an unnamed body that does not change its direction.
bool isTurningAngle(const RawColumn &column)
{
    const NameMeaning &meaning = column.heading.meaning;
    const std::optional<double> divisor = unitsPerDegree(column.heading.unit);
    if (meaning.kind != Kind::Quantity || meaning.channel != Channel{Theta3, Order::Position} || !divisor) {
        return false;
    }
    Values degrees = column.values;
    std::ranges::for_each(degrees, [&](double &value) { value /= *divisor; });
    return !findReversal(unwrapped(std::move(degrees)));
}

/// Finds the abscissa of a file in which no column is named as the time. If another file has one, it is the column with
/// the same heading. Otherwise it is the first column, if it has an unknown name and only rises; else the crank angle;
/// else the first column, if it is an angle that does not change its direction, as in "theta, x, v".
void guessAbscissa(RawTable &table, std::size_t file)
{
    const auto find = [&](const auto &suits) {
        const auto found = std::ranges::find_if(table.columns, [&](const RawColumn &column) {
            return column.use.file == file && column.use.reason != ColumnReason::Chosen && suits(column);
        });
        return found == table.columns.end() ? nullptr : &*found;
    };
    const RawColumn *const other = table.abscissa();
    RawColumn *const leading = find([](const RawColumn &column) {
        return column.use.reason != ColumnReason::NoName && column.use.reason != ColumnReason::RowNumber;
    });
    RawColumn *found = find([&](const RawColumn &column) {
        return other ? column.heading.printed == other->heading.printed : &column == leading && mayBeTime(column);
    });
    const ColumnReason reason = other   ? ColumnReason::KnownName
                                : found ? ColumnReason::RisingValues
                                        : ColumnReason::AngleForTime;
    const ColumnRole role = other ? other->use.role : found ? ColumnRole::Time : ColumnRole::CrankAngle;
    if (!found && role == ColumnRole::CrankAngle) {
        found = find([](const RawColumn &column) {
            return column.heading.isCrankAngle() && unitsPerDegree(column.heading.unit);
        });
    }
    if (!found && !other && leading && isTurningAngle(*leading)) {
        found = leading;
    }
    if (found) {
        setAbscissa(table, *found, role, reason, found->heading.unit);
    }
}

} // namespace

bool hasAbscissa(const RawTable &table, std::size_t file)
{
    return std::ranges::any_of(table.columns, [&](const RawColumn &column) {
        return column.use.file == file && (column.isAbscissa() || column.use.reason == ColumnReason::SameTimeStamps);
    });
}

void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason, const std::string &unit)
{
    const std::optional<double> divisor = divisorFor(role, unit);
    if (!divisor) {
        const bool isTime = role == ColumnRole::Time;
        throw faultIn(table, column,
                      isTime ? ReadFault{Fault::UnknownTimeUnit} : ReadFault{Fault::UnknownUnit, kCrankAngle});
    }
    std::ranges::for_each(column.values, [&](double &value) { value /= *divisor; });
    column.factor = 1.0 / *divisor;
    RawColumn *const first = table.abscissa();
    if (!first) {
        column.use.role = role;
        column.setReason(reason);
        return;
    }
    const std::size_t file = first->use.file;
    if (!areSameTimes(first->values, column.values)) {
        throw file == column.use.file
            ? faultIn(table, column, {Fault::TimeTwice})
            : ReadError{0, 0, {}, {Fault::OtherTimeStamps, {}, table.files[file].name}, {}, column.use.file};
    }
    column.setReason(ColumnReason::SameTimeStamps, first->index);
}

void assignAbscissas(RawTable &table)
{
    const RawColumn *const chosen = table.abscissa();
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        if (table.files[file].rows.size() != table.files[0].rows.size()) {
            throw ReadError{0, 0, {}, {Fault::OtherTimeStamps, {}, table.files[0].name}, {}, file};
        }
        std::vector<RawColumn *> times;
        for (RawColumn &column : table.columns) {
            if (column.use.file == file && column.heading.meaning.kind == Kind::Time && column.isUndecided()) {
                times.push_back(&column);
            }
        }
        const auto hasNumber = [](const RawColumn *column) { return rangeOf(column->values).count > 0; };
        const bool isAnyNumeric = times.size() > 1 && std::ranges::any_of(times, hasNumber);
        for (RawColumn *const column : times) {
            if (isAnyNumeric && !hasNumber(column)) {
                column->setReason(ColumnReason::NoNumber); // "2024-03-01 12:00", next to the seconds
            } else if (chosen && chosen->use.file == file) {
                column->setReason(ColumnReason::LikeOther, chosen->index);
            } else if (!table.abscissa() || table.abscissa()->use.role == ColumnRole::Time) {
                setAbscissa(table, *column, ColumnRole::Time, ColumnReason::KnownName, column->heading.unit);
            }
        }
        if (!hasAbscissa(table, file)) {
            guessAbscissa(table, file);
        }
    }
}

} // namespace slidercrank
