// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_assignment.h"

#include "core/import/abscissa_assignment.h"
#include "core/import/cells.h"
#include "core/import/channel_assignment.h"
#include "core/import/heading_context.h"
#include "core/import/heading_corrections.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;
using Kind = NameMeaning::Kind;

/// Returns the only column with the heading `name` or, if there is none, with that heading apart from the unit, or with
/// a number such as "#3". Throws if several columns or no column have it.
RawColumn &findColumn(RawTable &table, const std::string &name)
{
    const auto headingOf = [](const RawColumn &column) { return column.use.heading; };
    const auto nameOfColumn = [](const RawColumn &column) { return column.name; };
    const auto numberOf = [](const RawColumn &column) { return '#' + std::to_string(column.index + 1); };
    const auto find = [&](const auto &textOf) -> RawColumn * {
        if (std::ranges::count(table.columns, name, textOf) > 1) {
            throw ReadError{.fault = {Fault::SeveralColumns, {}, name}};
        }
        return findElement(table.columns, [&](const RawColumn &column) { return textOf(column) == name; });
    };
    RawColumn *column = find(headingOf);
    column = column ? column : find(nameOfColumn);
    column = column ? column : find(numberOf);
    if (!column) {
        throw ReadError{.fault = {Fault::NoSuchColumn, {}, name}};
    }
    return *column;
}

/// Gives the columns the meanings that a person chose, and sets the chosen abscissas. Of several choices for one
/// column, the last one applies.
void applyChoices(RawTable &table, std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        if (!choice.heading.empty()) {
            findColumn(table, choice.heading).choice = choice;
        } else if (choice.column < table.columns.size()) { // otherwise the choice was made for a file with more columns
            table.columns[choice.column].choice = choice;
        }
    }
    for (RawColumn &column : table.columns) {
        if (!column.choice) {
            continue;
        }
        const ColumnRole role = column.choice->role;
        column.meaning = {Kind::Chosen, column.choice->channel, ColumnReason::Chosen};
        const bool isUndecided = role != ColumnRole::Ignored; // assignChannels() decides about a channel
        column.use.reason = isUndecided ? ColumnReason::UnknownName : ColumnReason::Chosen;
        if (role == ColumnRole::Time || role == ColumnRole::CrankAngle) {
            setAbscissa(table, column, role, ColumnReason::Chosen);
        }
    }
}

/// Returns the error of a file that lacks the time or a channel. If a person could choose a column as the channel, the
/// error names the first such column.
ReadError missingDataError(RawTable &table, std::size_t fileIndex)
{
    const TableFile &file = table.files[fileIndex];
    if (file.layout.headerLine == 0 && !file.rows.empty()) {
        return {.line = file.rows.front().number, .fault = {Fault::NamesMissing}, .file = fileIndex};
    }
    if (!file.hasAbscissa) {
        return {.line = file.layout.headerLine, .fault = {Fault::NoTime}, .file = fileIndex};
    }
    const std::span<const RawColumn> columns = table.columnsOf(file);
    const RawColumn *const open = findElement(columns, [](const RawColumn &column) {
        return leavesOpen(column.use.reason) || column.use.reason == ColumnReason::UnknownUnit ||
               column.use.reason == ColumnReason::Ratio || column.use.reason == ColumnReason::CrankPin;
    });
    if (!open) {
        return {.line = file.layout.headerLine, .fault = {Fault::NoChannel}, .file = fileIndex};
    }
    const RawColumn *const sameInOtherFile = findElement(table.columns, [&](const RawColumn &column) {
        return column.use.file != fileIndex && column.use.channel == open->use.channel;
    });
    if (open->use.reason == ColumnReason::LikeOther && sameInOtherFile) {
        return sameChannelError(table, *open, *sameInOtherFile);
    }
    return {.line = file.layout.headerLine,
            .fault = {.kind = Fault::NoCertainChannel,
                      .heading = excerpt(open->use.heading),
                      .columnReason = open->use.reason},
            .file = fileIndex};
}

/// Throws if a file lacks the time or a channel.
void requireData(RawTable &table)
{
    const auto isChannel = [](const RawColumn &column) { return column.use.role == ColumnRole::Channel; };
    for (std::size_t i = 0; i < table.files.size(); ++i) {
        const TableFile &file = table.files[i];
        if (!file.hasAbscissa || std::ranges::none_of(table.columnsOf(file), isChannel)) {
            throw missingDataError(table, i);
        }
    }
}

} // namespace

void assignColumns(RawTable &table, std::span<const ColumnChoice> choices)
{
    for (const TableFile &file : table.files) {
        interpretHeadings(table.columnsOf(file));
    }
    applyChoices(table, choices);
    correctMeanings(table);
    assignAbscissas(table);
    assignChannels(table);
    requireData(table);
}

} // namespace slidercrank
