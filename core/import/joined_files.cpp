// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/joined_files.h"

#include "core/import/clock.h"
#include "core/import/difference.h"
#include "core/import/named_choice.h"
#include "core/import/table_columns.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

bool isAbscissa(ColumnRole role)
{
    return role == ColumnRole::Time || role == ColumnRole::CrankAngle;
}

/// The columns of another file, behind those of the ones before.
void append(const FileLayout &next, const std::string &name, FileLayout &all)
{
    const std::size_t before = all.columns.size();
    if (all.files.empty()) {
        all = next;
    } else {
        all.columns.insert(all.columns.end(), next.columns.begin(), next.columns.end());
        all.rows.resize(std::max(all.rows.size(), next.rows.size()));
        for (std::size_t row = 0; row < next.rows.size(); ++row) {
            all.rows[row].resize(before);
            all.rows[row].insert(all.rows[row].end(), next.rows[row].begin(), next.rows[row].end());
        }
    }
    for (std::size_t i = before; i < all.columns.size(); ++i) {
        FileColumn &column = all.columns[i];
        column.file = all.files.size();
        if (column.otherColumn) {
            *column.otherColumn += before;
        }
    }
    all.files.push_back(name);
}

/// What the files' beginnings tell: which columns there are, and in which file.
struct Columns {
    FileLayout layout;
    std::vector<Heading> headings;
};

Columns columnsOf(std::span<const ByteSource> files)
{
    Columns all;
    for (const ByteSource &file : files) {
        std::string beginning;
        const std::variant<OpenedTable, ReadError> opened = openTable(file, beginning);
        const OpenedTable *const found = std::get_if<OpenedTable>(&opened);
        append(found ? found->table.layout : FileLayout(), file.name, all.layout);
        if (found) {
            all.headings.insert(all.headings.end(), found->table.headings.begin(), found->table.headings.end());
        }
    }
    return all;
}

/// Of choices that count the columns of all files, those of each.
std::vector<std::vector<ColumnChoice>> choicesByFile(const std::vector<ColumnChoice> &choices, const FileLayout &all)
{
    std::vector<std::size_t> first(all.files.size(), all.columns.size());
    for (std::size_t i = all.columns.size(); i-- > 0;) {
        first[all.columns[i].file] = i;
    }
    std::vector<std::vector<ColumnChoice>> byFile(all.files.size());
    for (ColumnChoice choice : choices) {
        if (choice.column < all.columns.size()) {
            const std::size_t file = all.columns[choice.column].file;
            choice.column -= first[file];
            byFile[file].push_back(choice);
        }
    }
    const auto isOfAbscissa = [](const ColumnChoice &choice) { return isAbscissa(choice.role); };
    const auto chosen = std::ranges::find_if(byFile.front(), isOfAbscissa);
    for (std::size_t i = 0; i < all.columns.size() && chosen != byFile.front().end(); ++i) {
        const std::size_t file = all.columns[i].file;
        const std::size_t column = i - first[file];
        const bool isSaid = std::ranges::any_of(byFile[file], [&](const ColumnChoice &choice) {
            return isAbscissa(choice.role) || choice.column == column;
        });
        if (!isSaid && all.columns[i].heading == all.columns[chosen->column].heading) {
            byFile[file].push_back({column, chosen->role, {}, chosen->unit});
        }
    }
    return byFile;
}

/// What a file counts by.
struct Instants {
    std::vector<double> &values;
    Rounding &rounding;

    double spacing() const
    {
        return values.size() < 2 ? 0.0 : (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    }
};

Instants instantsOf(ReferenceData &data)
{
    return data.crank ? Instants{data.crank->degrees, data.crank->rounding} : Instants{data.time, data.timeRounding};
}

/// The rows of two files at the instants that both have, in pairs.
struct CommonRows {
    std::vector<std::size_t> ofOne;
    std::vector<std::size_t> ofOther;
};

CommonRows commonRows(const Instants &one, const Instants &other)
{
    constexpr double kUlps = 4.0;            // of a change of unit in either
    constexpr double kOfTheirSpacing = 0.25; // nearer they are the same: more is not rounding, but another clock
    const double rounded =
        0.5 * (clockOf(one.values, one.rounding).step() + clockOf(other.values, other.rounding).step());
    const double most = std::min(rounded, kOfTheirSpacing * std::min(one.spacing(), other.spacing()));
    CommonRows rows;
    for (std::size_t i = 0, j = 0; i < one.values.size() && j < other.values.size();) {
        const double x = one.values[i];
        const double y = other.values[j];
        const double ulps = kUlps * std::numeric_limits<double>::epsilon() * std::max(std::abs(x), std::abs(y));
        if (std::abs(x - y) <= most + ulps) {
            rows.ofOne.push_back(i++);
            rows.ofOther.push_back(j++);
        } else {
            ++(x < y ? i : j);
        }
    }
    return rows;
}

void keep(std::vector<double> &values, const std::vector<std::size_t> &rows)
{
    std::ranges::transform(rows, values.begin(), [&values](std::size_t row) { return values[row]; }); // in rising order
    values.resize(rows.size());
}

void keepRows(ReferenceData &data, const std::vector<std::size_t> &rows)
{
    if (rows.size() == data.time.size()) {
        return;
    }
    keep(data.time, rows);
    if (!data.lines.empty()) {
        std::ranges::transform(rows, data.lines.begin(), [&data](std::size_t row) { return data.lines[row]; });
        data.lines.resize(rows.size());
    }
    if (data.crank) {
        keep(data.crank->degrees, rows);
    }
    for (ReferenceSeries &series : data.series) {
        keep(series.values, rows);
    }
}

/// The channels of `next`, the file of that number, beside those of `data`; or why it is none of the same motion.
/// `areBeginnings`: one of them may break off earlier.
std::optional<ReadError> join(ReferenceData &data, ReferenceData next, std::size_t file, bool areBeginnings)
{
    const auto refused = [&](Fault kind, std::size_t other, Channel channel = {}) {
        ReadFault fault{kind, channel};
        fault.heading = data.layout.files[other];
        ReadError error{0, 0, {}, std::move(fault)};
        error.file = file;
        error.otherFile = other;
        return error;
    };
    if (data.crank.has_value() != next.crank.has_value()) {
        return refused(Fault::CountsOtherwise, 0);
    }
    const CommonRows rows = commonRows(instantsOf(data), instantsOf(next));
    const auto lackIn = [areBeginnings](const std::vector<double> &time, const std::vector<std::size_t> &common) {
        return (areBeginnings ? common.back() + 1 : time.size()) - common.size();
    };
    if (rows.ofOne.empty() || lackIn(data.time, rows.ofOne) > next.skippedRowCount() ||
        lackIn(next.time, rows.ofOther) > data.skippedRowCount()) {
        return refused(Fault::OtherInstants, 0);
    }
    for (const ReferenceSeries &series : next.series) {
        const auto same = std::ranges::find_if(data.layout.columns, [&](const FileColumn &column) {
            return column.role == ColumnRole::Channel && column.channel == series.channel;
        });
        if (same != data.layout.columns.end()) {
            return refused(Fault::ChannelInBoth, same->file, series.channel);
        }
    }
    keepRows(data, rows.ofOne);
    keepRows(next, rows.ofOther);
    const double step = instantsOf(data).rounding.finestStep();
    const double nextStep = instantsOf(next).rounding.finestStep();
    if (nextStep > 0.0 && nextStep < step) { // more digits of the same
        data.time = std::move(next.time);
        data.timeRounding = next.timeRounding;
        data.crank = std::move(next.crank);
    }
    std::ranges::move(next.series, std::back_inserter(data.series));
    for (SkippedRow &row : next.skipped) {
        row.file = file;
        data.skipped.push_back(std::move(row));
    }
    return std::nullopt;
}

/// Instants that another column has told already.
void settleInstants(FileLayout &layout)
{
    const auto isOfInstants = [](const FileColumn &column) { return isAbscissa(column.role); };
    const auto first = std::ranges::find_if(layout.columns, isOfInstants);
    for (auto column = first; column != layout.columns.end(); ++column) {
        if (column != first && isOfInstants(*column)) {
            column->role = ColumnRole::Ignored;
            column->reason = ColumnReason::SameInstants;
            column->otherColumn = static_cast<std::size_t>(first - layout.columns.begin());
        }
    }
}

std::variant<ReferenceData, ReadError> readAll(std::span<const ByteSource> files, const std::stop_token &stop,
                                               const ReadOptions &options)
{
    const Columns columns = columnsOf(files);
    const std::variant<std::vector<ColumnChoice>, ReadFault> choices = choicesByNumber(options, columns.headings);
    if (const ReadFault *fault = std::get_if<ReadFault>(&choices)) {
        return ReadError{0, 0, {}, *fault, columns.layout};
    }
    const auto chosen = choicesByFile(std::get<std::vector<ColumnChoice>>(choices), columns.layout);
    const auto sizeOf = [](std::size_t sum, const ByteSource &file) { return sum + file.size; };
    const std::size_t bytes = std::accumulate(files.begin(), files.end(), std::size_t{0}, sizeOf);

    const bool areBeginnings = std::ranges::count(files, true, &ByteSource::isBeginning) > 0;

    std::optional<ReferenceData> all;
    std::optional<ReadError> error;
    FileLayout layout;
    std::size_t before = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto progress = [&](std::size_t done, std::size_t) {
            if (options.progress) {
                options.progress(before + done, bytes);
            }
        };
        std::variant<ReferenceData, ReadError> outcome = readReferenceData(files[i], stop, {chosen[i], progress});
        if (stop.stop_requested()) {
            return ReadError{0, 0, {}, {Fault::Stopped}};
        }
        before += files[i].size;
        ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        append(data ? data->layout : std::get<ReadError>(outcome).layout, files[i].name, layout);
        if (!data && !error) {
            error = std::get<ReadError>(std::move(outcome));
            error->file = i;
        }
        if (error) {
            continue; // its columns are all that is wanted
        }
        if (all) {
            error = join(*all, std::move(*data), i, areBeginnings);
        } else {
            all = std::move(*data);
        }
        if (all) {
            all->layout = layout;
        }
    }
    settleInstants(layout);
    if (error) {
        error->layout = std::move(layout);
        return *std::move(error);
    }
    all->layout = std::move(layout);
    for (FileColumn &column : all->layout.columns) {
        if (column.role == ColumnRole::Channel) {
            column.difference = differenceIn(*all, column.channel);
        }
    }
    return *std::move(all);
}

} // namespace

std::variant<ReferenceData, ReadError> readJoined(std::span<const ByteSource> files, std::stop_token stop,
                                                  const ReadOptions &options)
{
    if (files.size() == 1) {
        return readReferenceData(files.front(), std::move(stop), options);
    }
    try {
        return readAll(files, stop, options);
    } catch (const std::bad_alloc &) {
        return ReadError{0, 0, {}, {Fault::NoMemory}};
    }
}

} // namespace slidercrank
