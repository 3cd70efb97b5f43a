// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_columns.h"

#include "core/import/column_guess.h"
#include "core/import/named_choice.h"
#include "core/import/number_text.h"
#include "core/import/text_encoding.h"
#include "core/import/text_pieces.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

constexpr std::size_t kBeginning = std::size_t{1} << 20U; ///< bytes of a large file that tell what it is

/// The numbers of some rows.
ColumnSamples sampleRows(const Table &table, std::string_view rowText)
{
    ColumnSamples samples(table.headings.size());
    for (CellScanner scanner(rowText, table.layout.delimiter, 1); !scanner.atEnd(); scanner.nextLine()) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::string_view text = scanner.hasCell() ? scanner.cell().text : std::string_view();
            samples[i].push_back(readNumber(withoutUnit(text, table.cellUnits[i]), table.layout.decimalSign).value);
        }
    }
    // A row without a single number is none.
    const std::size_t rows = samples.empty() ? 0 : samples[0].size();
    std::size_t kept = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        const bool any = std::any_of(samples.begin(), samples.end(),
                                     [row](const std::vector<double> &column) { return !std::isnan(column[row]); });
        for (std::vector<double> &column : samples) {
            column[kept] = column[row];
        }
        kept += any ? 1 : 0;
    }
    for (std::vector<double> &column : samples) {
        column.resize(kept);
    }
    return samples;
}

/// Why no channel is among the columns.
ReadFault faultWithoutChannel(const FileLayout &layout)
{
    for (const FileColumn &column : layout.columns) {
        const bool almost = leavesOpen(column.reason) || column.reason == ColumnReason::UnknownUnit ||
                            column.reason == ColumnReason::NotDerivative;
        if (almost) {
            return {Fault::NoCertainChannel, {}, excerpt(column.heading), column.reason};
        }
    }
    return {Fault::NoChannel};
}

/// Of a plot alone in its file, the heading that says nothing, where the file's name says it: the column, and that name
/// in its place.
std::optional<std::pair<std::size_t, Heading>> headingByFile(std::span<const Heading> headings, const std::string &file)
{
    if (headings.size() != 2) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const bool isPlotted = meaningOf(headings[1 - i]).kind == NameMeaning::Kind::Time && saysNothing(headings[i]);
        Heading byFile = headingOf(file.substr(0, file.find_last_of('.')));
        byFile.printed = headings[i].printed;
        byFile.unit = headings[i].unit.empty() ? byFile.unit : headings[i].unit;
        const NameMeaning meaning = meaningOf(byFile);
        const std::optional<Unit> unit = unitOf(byFile.unit);
        const bool suits =
            meaning.kind == NameMeaning::Kind::Quantity ||
            (meaning.kind == NameMeaning::Kind::Channel &&
             (byFile.unit.empty() || (unit && unit->order == static_cast<int>(meaning.channel.order) &&
                                      (unit->dimension == Dimension::Angle) == isAngle(meaning.channel.coordinate))));
        if (isPlotted && suits) {
            return std::pair(i, std::move(byFile));
        }
    }
    return std::nullopt;
}

/// Settles what each column is. `sampledRows`: text of some rows from all over the table.
std::variant<TableLayout, ReadError> layOut(Table table, const std::string &file, const ReadOptions &options,
                                            const std::function<std::string()> &sampledRows)
{
    TableLayout layout;
    const std::size_t headerLine = table.layout.headerLine;
    const auto refused = [&](ReadError error) {
        error.layout = std::move(table.layout);
        return error;
    };
    const std::variant<std::vector<ColumnChoice>, ReadFault> choices = choicesByNumber(options, table.headings);
    if (const ReadFault *fault = std::get_if<ReadFault>(&choices)) {
        return refused({headerLine, 0, {}, *fault});
    }
    const auto byFile = headingByFile(table.headings, file);
    if (byFile) {
        table.headings[byFile->first] = byFile->second;
        table.layout.columns[byFile->first].unit = byFile->second.unit;
    }
    const auto outcome = assignColumns(table.headings, std::get<std::vector<ColumnChoice>>(choices),
                                       [&] { return sampleRows(table, sampledRows()); });
    if (const ColumnFault *fault = std::get_if<ColumnFault>(&outcome)) {
        return refused({headerLine, fault->column + 1, excerpt(table.headings[fault->column].printed), fault->fault});
    }
    bool hasTime = false;
    const auto &uses = std::get<std::vector<ColumnUse>>(outcome);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const ColumnUse &use = uses[i];
        FileColumn &described = table.layout.columns[i];
        described.role = use.role;
        described.channel = use.channel;
        const bool isByFile = byFile && i == byFile->first && use.role == ColumnRole::Channel;
        described.reason = isByFile && use.reason != ColumnReason::Chosen ? ColumnReason::FileName : use.reason;
        described.otherColumn = use.otherColumn;
        const bool isTime = use.role == ColumnRole::Time || use.role == ColumnRole::CrankAngle;
        layout.columns.push_back(
            {isTime ? ColumnRole::Time : use.role, layout.channels.size(), use.factor, table.cellUnits[i]});
        if (isTime) {
            hasTime = true;
            layout.timeColumn = i;
            layout.isByAngle = use.role == ColumnRole::CrankAngle;
        } else if (use.role == ColumnRole::Channel) {
            layout.channels.push_back(use.channel);
        }
    }
    if (headerLine == 0 && (!hasTime || layout.channels.empty())) {
        return refused({table.firstDataLine, 1, excerpt(rowsOf(table).cell().text), {Fault::NamesMissing}});
    }
    if (!hasTime) {
        return refused({headerLine, 0, table.headerText, {Fault::NoTime}});
    }
    if (layout.channels.empty()) {
        return refused({headerLine, 0, table.headerText, faultWithoutChannel(table.layout)});
    }
    layout.table = std::move(table);
    return layout;
}

/// What is no table of text, by its first bytes.
std::optional<ReadError> findForeignFormat(std::string_view bytes)
{
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0") || bytes.starts_with("\x1F\x8B")) {
        return ReadError{0, 0, {}, {Fault::Spreadsheet}};
    }
    if (bytes.starts_with("%PDF")) {
        return ReadError{0, 0, {}, {Fault::Pdf}};
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first != bytes.npos && bytes[first] == '<') {
        return ReadError{0, 0, {}, {Fault::Markup}};
    }
    // "{"name": …", "[{…", "[[…"; "[s]" may be a unit.
    const std::size_t second = bytes.find_first_not_of(" \t\r\n", first + 1);
    if (first != bytes.npos && second != bytes.npos &&
        (bytes[first] == '{' ? bytes[second] == '"'
                             : bytes[first] == '[' && (bytes[second] == '{' || bytes[second] == '['))) {
        return ReadError{0, 0, {}, {Fault::Json}};
    }
    return std::nullopt;
}

std::optional<ReadError> findZeroByte(std::string_view text)
{
    const std::size_t zero = text.find('\0');
    if (zero == std::string_view::npos) {
        return std::nullopt;
    }
    CellScanner scanner(text, ',', 1);
    std::size_t line = 1;
    while (scanner.position() <= text.data() + zero) {
        line = scanner.line();
        scanner.nextLine();
    }
    return ReadError{line, 0, {}, {Fault::NotText}};
}

} // namespace

std::variant<OpenedTable, ReadError> openTable(const ByteSource &source, std::string &beginning)
{
    constexpr std::size_t kReadWhole = std::size_t{1} << 22U; // bytes
    const bool isWhole = source.size <= kReadWhole;
    beginning.resize(isWhole ? source.size : kBeginning);
    if (!source.read(0, beginning)) {
        return ReadError{0, 0, {}, {Fault::Unreadable}};
    }
    if (std::optional<ReadError> error = findForeignFormat(beginning)) {
        return *std::move(error);
    }
    const EncodingFound found = findEncoding(beginning);
    if (found.encoding == TextEncoding::Utf8) {
        beginning.erase(0, found.markLength);
    } else {
        beginning = toUtf8(std::string_view(beginning).substr(found.markLength), found.encoding);
    }
    if (std::optional<ReadError> error = findZeroByte(beginning)) {
        return *std::move(error);
    }
    if (!isWhole) { // whole lines, and no LF right behind
        beginning.resize(beginning.find_last_of("\r\n", beginning.size() - 2) + 1);
        if (beginning.empty()) {
            return ReadError{1, 0, {}, {Fault::LineTooLong}};
        }
    }
    std::variant<Table, ReadError> outcome = findTable(beginning);
    if (ReadError *error = std::get_if<ReadError>(&outcome)) {
        return std::move(*error);
    }
    Table &table = std::get<Table>(outcome);
    table.layout.encoding = found.encoding;
    table.layout.byteOrderMark = found.markLength > 0;
    const std::string_view above(beginning.data(), static_cast<std::size_t>(table.data.data() - beginning.data()));
    const std::size_t dataBegin = found.markLength + sizeIn(found.encoding, above);
    return OpenedTable{std::move(table), dataBegin};
}

std::variant<TableLayout, ReadError> layOut(const ByteSource &source, std::string &beginning,
                                            const ReadOptions &options)
{
    constexpr std::size_t kSampledRows = 4096;
    std::variant<OpenedTable, ReadError> outcome = openTable(source, beginning);
    if (ReadError *error = std::get_if<ReadError>(&outcome)) {
        return std::move(*error);
    }
    OpenedTable &opened = std::get<OpenedTable>(outcome);
    const std::string_view data = opened.table.data;
    const TextEncoding encoding = opened.table.layout.encoding;
    std::variant<TableLayout, ReadError> layout = layOut(std::move(opened.table), source.name, options, [&] {
        return source.size <= kBeginning ? std::string(data)
                                         : TextPieces(source, encoding, opened.dataBegin).sample(kSampledRows);
    });
    if (TableLayout *laidOut = std::get_if<TableLayout>(&layout)) {
        laidOut->dataBegin = opened.dataBegin;
    }
    return layout;
}

} // namespace slidercrank
