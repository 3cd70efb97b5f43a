// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/assigned_table.h"

#include "core/import/cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

bool isAbscissa(ColumnRole role)
{
    return role == ColumnRole::Time || role == ColumnRole::CrankAngle;
}

/// Some rows from all over a table, without what cannot be read.
Columns sampleRows(const RawTable &table)
{
    constexpr std::size_t kMost = 4096;
    const std::size_t step = table.lines.size() / kMost + 1;
    Columns samples(table.columns.size());
    for (std::size_t row = 0; row < table.lines.size(); row += step) {
        const bool isEmpty =
            std::ranges::none_of(table.columns, [row](const auto &column) { return std::isfinite(column[row]); });
        for (std::size_t i = 0; i < samples.size() && !isEmpty; ++i) {
            const double value = table.columns[i][row];
            samples[i].push_back(std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN());
        }
    }
    return samples;
}

/// In a plot alone in its file: the column whose heading says nothing, while the name of the file says it, and that
/// name in the place of its own.
std::optional<std::pair<std::size_t, Heading>> headingByFile(std::span<const Heading> headings, const std::string &file)
{
    for (std::size_t i = 0; headings.size() == 2 && i < 2; ++i) {
        if (meaningOf(headings[1 - i]).kind != NameMeaning::Kind::Time || !saysNothing(headings[i])) {
            continue;
        }
        Heading byFile = parseHeading(file.substr(0, file.find_last_of('.')));
        byFile.printed = headings[i].printed;
        byFile.unit = headings[i].unit.empty() ? byFile.unit : headings[i].unit;
        const NameMeaning meaning = meaningOf(byFile);
        if (meaning.kind == NameMeaning::Kind::Quantity ||
            (meaning.kind == NameMeaning::Kind::Channel && factorTo(meaning.channel, byFile.unit))) {
            return std::pair(i, std::move(byFile));
        }
    }
    return std::nullopt;
}

/// Why no channel is among the columns.
ReadFault faultWithoutChannel(const FileLayout &layout)
{
    for (const FileColumn &column : layout.columns) {
        if (leavesOpen(column.reason) || column.reason == ColumnReason::UnknownUnit ||
            column.reason == ColumnReason::NotDerivative) {
            return {Fault::NoCertainChannel, {}, excerpt(column.heading), column.reason};
        }
    }
    return {Fault::NoChannel};
}

/// Settles what each column of a table is.
std::optional<ReadError> assign(AssignedTable &assigned, const std::string &file, std::span<const ColumnChoice> choices)
{
    RawTable &table = assigned.table;
    const auto byFile = headingByFile(table.headings, file);
    if (byFile) {
        table.headings[byFile->first] = byFile->second;
        table.layout.columns[byFile->first].unit = byFile->second.unit;
    }
    auto outcome = assignColumns(table.headings, choices, sampleRows(table));
    const std::size_t headerLine = table.layout.headerLine;
    if (const ColumnFault *fault = std::get_if<ColumnFault>(&outcome)) {
        return ReadError{headerLine, fault->column + 1, excerpt(table.headings[fault->column].printed), fault->fault};
    }
    assigned.uses = std::get<std::vector<ColumnAssignment>>(std::move(outcome));
    bool hasChannel = false;
    assigned.abscissa = assigned.uses.size();
    for (std::size_t i = 0; i < assigned.uses.size(); ++i) {
        const ColumnAssignment &use = assigned.uses[i];
        const bool isByFile =
            byFile && i == byFile->first && use.role == ColumnRole::Channel && use.reason != ColumnReason::Chosen;
        FileColumn &column = table.layout.columns[i];
        column.role = use.role;
        column.channel = use.channel;
        column.reason = isByFile ? ColumnReason::FileName : use.reason;
        column.otherColumn = use.otherColumn;
        hasChannel = hasChannel || use.role == ColumnRole::Channel;
        assigned.abscissa = isAbscissa(use.role) ? i : assigned.abscissa;
        for (double &value : use.factor == 1.0 ? std::span<double>() : std::span(table.columns[i])) {
            value = use.role == ColumnRole::Channel ? value * use.factor : value / use.factor;
        }
    }
    const bool hasAbscissa = assigned.abscissa < assigned.uses.size();
    if (hasAbscissa && hasChannel) {
        return std::nullopt;
    }
    if (headerLine == 0) {
        return ReadError{table.firstDataLine, 1, table.layout.rows[0][0], {Fault::NamesMissing}};
    }
    return ReadError{headerLine, 0, table.headerText,
                     hasAbscissa ? faultWithoutChannel(table.layout) : ReadFault{Fault::NoTime}};
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

/// The columns that a name may mean: those with that heading, else with that heading but for the unit, else the one of
/// that number.
std::vector<std::size_t> columnsNamed(std::string_view name, std::span<const Heading> headings)
{
    std::vector<std::size_t> columns;
    for (const auto part : {&Heading::printed, &Heading::name}) {
        for (std::size_t i = 0; i < headings.size(); ++i) {
            if (headings[i].*part == name) {
                columns.push_back(i);
            }
        }
        if (!columns.empty()) {
            return columns;
        }
    }
    std::size_t number = 0;
    const char *const end = name.data() + name.size();
    const bool isNumber = name.starts_with('#') && std::from_chars(name.data() + 1, end, number).ptr == end;
    if (isNumber && number >= 1 && number <= headings.size()) {
        columns.push_back(number - 1);
    }
    return columns;
}

/// All choices by number: what is said of a heading overrides what was said of its number.
std::variant<std::vector<ColumnChoice>, ReadFault> resolveChoices(const ReadOptions &options,
                                                                  std::span<const Heading> headings)
{
    std::vector<ColumnChoice> choices = options.columns;
    for (const NamedChoice &named : options.named) {
        const std::vector<std::size_t> columns = columnsNamed(named.heading, headings);
        if (columns.size() != 1) {
            ReadFault fault{columns.empty() ? ReadFault::Kind::NoSuchColumn : ReadFault::Kind::SeveralColumns};
            fault.heading = named.heading;
            return fault;
        }
        std::erase_if(choices, [&](const ColumnChoice &choice) { return choice.column == columns.front(); });
        choices.push_back({columns.front(), named.role, named.channel, named.unit});
    }
    return choices;
}

/// The choices of one file's columns, by its own numbers. What is chosen as the abscissa of the first file holds for a
/// column of that heading.
std::vector<ColumnChoice> choicesOf(const AssignedTable &file, std::span<const ColumnChoice> all,
                                    std::span<const Heading> headings)
{
    std::vector<ColumnChoice> choices;
    const std::vector<Heading> &own = file.table.headings;
    const ColumnChoice *ofFirst = nullptr;
    for (const ColumnChoice &choice : all) {
        ofFirst = isAbscissa(choice.role) && !ofFirst ? &choice : ofFirst;
        if (choice.column >= file.firstColumn && choice.column - file.firstColumn < own.size()) {
            choices.push_back(choice);
            choices.back().column -= file.firstColumn;
        }
    }
    const bool hasOwn =
        std::ranges::any_of(choices, [](const ColumnChoice &choice) { return isAbscissa(choice.role); });
    if (!ofFirst || hasOwn || ofFirst->column >= headings.size()) {
        return choices;
    }
    const auto found = std::ranges::find(own, headings[ofFirst->column].printed, &Heading::printed);
    const auto column = static_cast<std::size_t>(found - own.begin());
    if (found != own.end() && std::ranges::count(choices, column, &ColumnChoice::column) == 0) {
        choices.push_back({column, ofFirst->role, {}, ofFirst->unit});
    }
    return choices;
}

/// Of files that break off somewhere, the rows that all of them have.
void cutToShortest(std::vector<AssignedTable> &files)
{
    const auto rows = [](const AssignedTable &file) { return file.table.lines.size(); };
    const std::size_t shortest = rows(*std::ranges::min_element(files, {}, rows));
    for (AssignedTable &file : files) {
        file.table.lines.resize(shortest);
        for (std::vector<double> &column : file.table.columns) {
            column.resize(shortest);
        }
    }
}

/// Why the files are not of one motion, as far as their columns tell.
std::optional<ReadError> findConflict(std::span<const AssignedTable> files, const FileLayout &layout)
{
    for (std::size_t i = 1; i < files.size(); ++i) {
        const auto refused = [&](Fault kind, std::size_t other, Channel channel = {}) {
            return ReadError{0, 0, {}, {kind, channel, layout.files[other]}, {}, i, other};
        };
        if (files[i].uses[files[i].abscissa].role != files[0].uses[files[0].abscissa].role) {
            return refused(Fault::CountsOtherwise, 0);
        }
        if (files[i].table.lines.size() != files[0].table.lines.size()) {
            return refused(Fault::OtherInstants, 0);
        }
        for (const FileColumn &column : layout.columns) {
            const bool isTwice = column.file < i && column.role == ColumnRole::Channel &&
                                 std::ranges::any_of(files[i].table.layout.columns, [&](const FileColumn &other) {
                                     return other.role == ColumnRole::Channel && other.channel == column.channel;
                                 });
            if (isTwice) {
                return refused(Fault::ChannelInBoth, column.file, column.channel);
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<ReadError> assignAll(std::vector<AssignedTable> &tables, std::span<const FileBytes> files,
                                   const ReadOptions &options, FileLayout &layout)
{
    std::vector<Heading> headings;
    for (AssignedTable &table : tables) {
        table.firstColumn = headings.size();
        headings.insert(headings.end(), table.table.headings.begin(), table.table.headings.end());
    }
    const std::variant<std::vector<ColumnChoice>, ReadFault> choices = resolveChoices(options, headings);
    const ReadFault *const wrongChoice = std::get_if<ReadFault>(&choices);
    std::optional<ReadError> error;
    if (wrongChoice) {
        error = ReadError{tables.size() == 1 ? tables[0].table.layout.headerLine : 0, 0, {}, *wrongChoice};
    }
    bool areBeginnings = false;
    bool areRead = true;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const bool isRead = !tables[i].table.headings.empty();
        std::optional<ReadError> refused;
        if (isRead && !wrongChoice) {
            refused = assign(tables[i], files[i].name,
                             choicesOf(tables[i], std::get<std::vector<ColumnChoice>>(choices), headings));
        }
        append(tables[i].table.layout, files[i].name, layout);
        if (refused && !error) {
            error = std::move(refused);
            error->file = i;
        }
        areBeginnings = areBeginnings || files[i].isBeginning;
        areRead = areRead && isRead;
    }
    if (error || !areRead) {
        return error;
    }
    if (areBeginnings) {
        cutToShortest(tables);
    }
    return findConflict(tables, layout);
}

std::optional<SkippedRow> findFault(const AssignedTable &file, std::size_t row)
{
    const RawTable &table = file.table;
    for (auto bad = std::ranges::lower_bound(table.badCells, row, {}, &BadCell::row);
         bad != table.badCells.end() && bad->row == row; ++bad) {
        if (bad->spoilsRow || file.uses[bad->column].role != ColumnRole::Ignored) {
            return SkippedRow{table.lines[row], bad->column + 1, bad->text, bad->fault};
        }
    }
    for (std::size_t i = 0; i < file.uses.size(); ++i) {
        const double value = table.columns[i][row];
        if (i == file.abscissa && std::isnan(value)) {
            return SkippedRow{table.lines[row], i + 1, {}, RowFault::NoTime};
        }
        if (file.uses[i].role != ColumnRole::Ignored && std::isinf(value)) {
            return SkippedRow{table.lines[row], i + 1, {}, RowFault::TooLarge};
        }
    }
    return std::nullopt;
}

std::string printedNumber(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

} // namespace slidercrank
