// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/table_columns.h"

#include "core/reading/column_guess.h"
#include "core/reading/number_text.h"
#include "core/reading/text_encoding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

/// Rows from all over the table, all of them where there are few.
ColumnSamples sampleRows(const Table &table)
{
    constexpr std::size_t kRows = 4096;
    constexpr std::size_t kReadWhole = std::size_t{1} << 20U; ///< bytes
    ColumnSamples samples(table.headings.size());
    const auto readLine = [&](CellScanner &scanner) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const bool there = scanner.hasCell();
            samples[i].push_back(
                readNumber(there ? scanner.cell().text : std::string_view(), table.layout.decimalSign).value);
        }
        scanner.nextLine();
    };
    if (table.data.size() <= kReadWhole) {
        for (CellScanner scanner = rowsOf(table); !scanner.atEnd();) {
            readLine(scanner);
        }
    } else {
        for (std::size_t row = 0; row < kRows; ++row) {
            const std::size_t from = table.data.size() / kRows * row;
            CellScanner scanner(table.data.substr(from), table.layout.delimiter, 1);
            if (row > 0) {
                scanner.nextLine(); // the offset lies within a line
            }
            if (!scanner.atEnd()) {
                readLine(scanner);
            }
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
        const bool almost = column.reason == ColumnReason::LikeOther || column.reason == ColumnReason::UnknownUnit ||
                            column.reason == ColumnReason::NotDerivative ||
                            column.reason == ColumnReason::AngleOrLength;
        if (almost) {
            return {Fault::NoCertainChannel, {}, excerpt(column.heading), column.reason};
        }
    }
    return {Fault::NoChannel};
}

/// Settles what each column is.
std::variant<TableLayout, ReadError> layOut(Table table, const ReadOptions &options)
{
    TableLayout layout;
    const std::size_t headerLine = table.layout.headerLine;
    const auto refused = [&](ReadError error) {
        error.layout = std::move(table.layout);
        return error;
    };
    const auto outcome = assignColumns(table.headings, options.columns, [&] {
        layout.isSampled = true;
        return sampleRows(table);
    });
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
        described.reason = use.reason;
        described.otherColumn = use.otherColumn;
        layout.columns.push_back({use.role, layout.channels.size(), use.factor});
        if (use.role == ColumnRole::Time) {
            hasTime = true;
            layout.timeColumn = i;
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

std::variant<TableLayout, ReadError> layOut(std::string_view bytes, std::string &converted, const ReadOptions &options)
{
    if (std::optional<ReadError> error = findForeignFormat(bytes)) {
        return *std::move(error);
    }
    const EncodingFound encoding = findEncoding(bytes);
    std::string_view text = bytes.substr(encoding.markLength);
    if (encoding.encoding != TextEncoding::Utf8) {
        converted = toUtf8(bytes, encoding);
        text = converted;
    }
    if (std::optional<ReadError> error = findZeroByte(text)) {
        return *std::move(error);
    }
    std::variant<Table, ReadError> table = findTable(text);
    if (ReadError *error = std::get_if<ReadError>(&table)) {
        return std::move(*error);
    }
    Table &found = std::get<Table>(table);
    found.layout.encoding = encoding.encoding;
    found.layout.byteOrderMark = encoding.markLength > 0;
    return layOut(std::move(found), options);
}

} // namespace slidercrank
