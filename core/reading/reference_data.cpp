// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/reference_data.h"

#include "core/mechanism/in_parallel.h"
#include "core/reading/number_text.h"
#include "core/reading/table_columns.h"
#include "core/reading/text_encoding.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>

namespace slidercrank
{

namespace
{

/// How many rows left out are listed one by one; the last entry then counts the others.
constexpr std::size_t kMostSkippedRows = 1000;
constexpr std::size_t kRowsBetweenPolls = 4096;

/// The numbers of one line, reused from line to line.
struct Row {
    PlainNumber time;                 ///< in seconds
    std::vector<PlainNumber> numbers; ///< by place in TableLayout::channels, in the author's unit; a gap has no digits
};

/// The cell for which a line holds no row; without a fault, the line is blank.
struct BadCell {
    std::size_t column = 0; ///< from 1
    std::string_view text{};
    std::optional<RowFault> fault{};
};

/// The short way through most lines: as many cells as columns, plain numbers in all that count. Where the line is
/// another, the scanner is left at its beginning.
bool readPlainRow(CellScanner &scanner, const TableLayout &layout, Row &row)
{
    const char *const begin = scanner.position();
    for (const ReadColumn &column : layout.columns) {
        bool plain = scanner.hasCell();
        switch (column.role) {
        case ColumnRole::Ignored: plain = plain && scanner.skipPlainCell(); break;
        case ColumnRole::Time: plain = plain && scanner.plainNumber(row.time); break;
        case ColumnRole::Channel:
            plain = plain && scanner.plainNumber(row.numbers[column.series]);
            row.numbers[column.series].value *= column.factor;
            break;
        }
        if (!plain) {
            scanner.backTo(begin);
            return false;
        }
    }
    if (scanner.hasCell() || !scanner.atLineEnd()) {
        scanner.backTo(begin);
        return false;
    }
    row.time.value /= layout.columns[layout.timeColumn].factor;
    scanner.nextLine();
    return true;
}

/// Reads any line into `row`; the scanner moves to the next.
std::optional<BadCell> readRow(CellScanner &scanner, const TableLayout &layout, Row &row)
{
    std::optional<BadCell> bad;
    const auto blame = [&bad](std::size_t cell, std::string_view text, RowFault fault) {
        if (!bad) {
            bad = BadCell{cell + 1, text, fault};
        }
    };
    bool blank = true;
    std::size_t cellCount = 0;
    for (; scanner.hasCell(); ++cellCount) {
        const bool named = cellCount < layout.columns.size();
        const ReadColumn column = named ? layout.columns[cellCount] : ReadColumn();
        const Cell cell = scanner.cell();
        CellNumber number;
        if (!cell.wellFormed) {
            number.fault = RowFault::OpenQuotation;
        } else if (column.role != ColumnRole::Ignored) {
            number = readNumber(cell.text, layout.table.layout.decimalSign);
        } else if (!named && !cell.text.empty()) {
            number.fault = RowFault::TooManyCells;
        }
        blank = blank && cell.text.empty();
        switch (column.role) {
        case ColumnRole::Ignored: break;
        case ColumnRole::Time:
            row.time = {number.value / column.factor, placesOf(number.digits), number.digits};
            if (!number.fault && std::isnan(row.time.value)) {
                number.fault = RowFault::NoTime;
            }
            break;
        case ColumnRole::Channel: {
            const double value = number.value * column.factor;
            if (std::isinf(value)) {
                number.fault = RowFault::TooLarge;
            }
            row.numbers[column.series] = {value, placesOf(number.digits), number.digits};
            break;
        }
        }
        if (number.fault) {
            blame(cellCount, cell.text, *number.fault);
        }
    }
    scanner.nextLine();
    if (blank) {
        return BadCell{};
    }
    if (cellCount < layout.columns.size()) {
        blame(cellCount - 1, {}, RowFault::TooFewCells);
    }
    return bad;
}

/// Lists a row left out; where the list is full, counts it.
void leaveOut(SkippedRow row, std::vector<SkippedRow> &skipped)
{
    if (skipped.size() > kMostSkippedRows) {
        skipped.back().rows += row.rows;
    } else if (skipped.size() == kMostSkippedRows) {
        skipped.push_back({row.line, 0, {}, RowFault::NotListed, row.rows});
    } else {
        skipped.push_back(std::move(row));
    }
}

/// The columns that the rows fill.
class SeriesBuilder
{
public:
    SeriesBuilder(const TableLayout &layout, std::size_t expectedRows)
        : m_observers(layout.channels.size())
    {
        m_data.time.reserve(expectedRows);
        m_data.series.resize(layout.channels.size());
        for (std::size_t i = 0; i < layout.channels.size(); ++i) {
            m_data.series[i].channel = layout.channels[i];
            m_data.series[i].values.reserve(expectedRows);
        }
    }

    const std::vector<double> &time() const { return m_data.time; }

    /// Without rows again, but with the room for them.
    void clear()
    {
        m_data.time.clear();
        for (ReferenceSeries &series : m_data.series) {
            series.values.clear();
        }
        m_timeObserver = RoundingObserver();
        std::fill(m_observers.begin(), m_observers.end(), RoundingObserver());
    }

    /// The rows that follow.
    void add(const SeriesBuilder &later)
    {
        const auto append = [](std::vector<double> &values, const std::vector<double> &more) {
            values.insert(values.end(), more.begin(), more.end());
        };
        append(m_data.time, later.m_data.time);
        m_timeObserver.add(later.m_timeObserver);
        for (std::size_t i = 0; i < m_observers.size(); ++i) {
            append(m_data.series[i].values, later.m_data.series[i].values);
            m_observers[i].add(later.m_observers[i]);
        }
    }

    void add(const Row &row)
    {
        m_data.time.push_back(row.time.value);
        m_timeObserver.observe(row.time.places, row.time.digits);
        for (std::size_t i = 0; i < row.numbers.size(); ++i) {
            const PlainNumber &number = row.numbers[i];
            m_data.series[i].values.push_back(number.value);
            if (!number.digits.empty()) {
                m_observers[i].observe(number.places, number.digits);
            }
        }
    }

    /// The data, without the columns that hold no number at all: those count as ignored.
    ReferenceData take(TableLayout &layout, std::vector<SkippedRow> skipped)
    {
        m_data.skipped = std::move(skipped);
        m_data.layout = std::move(layout.table.layout);
        m_data.timeRounding = m_timeObserver.inferOfInstants(1.0 / layout.columns[layout.timeColumn].factor);
        for (std::size_t i = 0; i < layout.columns.size(); ++i) {
            const ReadColumn &column = layout.columns[i];
            FileColumn &described = m_data.layout.columns[i];
            if (column.role == ColumnRole::Channel) {
                ReferenceSeries &series = m_data.series[column.series];
                series.rounding = m_observers[column.series].infer(column.factor);
                if (isEmpty(series)) {
                    described.role = ColumnRole::Ignored;
                    described.reason = ColumnReason::NoNumber;
                }
            }
        }
        std::erase_if(m_data.series, isEmpty);
        return std::move(m_data);
    }

private:
    static bool isEmpty(const ReferenceSeries &series)
    {
        return std::all_of(series.values.begin(), series.values.end(), [](double value) { return std::isnan(value); });
    }

    ReferenceData m_data;
    RoundingObserver m_timeObserver;
    std::vector<RoundingObserver> m_observers;
};

/// How many rows there hardly are more of: from the length of the first, or the shortest that can fill the columns.
/// Room that is never written to costs next to nothing, a move to more room much.
std::size_t estimateRows(std::string_view lines, std::size_t bytes, std::size_t columns)
{
    const std::size_t firstLine = std::min(lines.find_first_of("\r\n"), lines.size()) + 1;
    const std::size_t rows = bytes / std::max(firstLine, columns) + 1;
    return rows + rows / 4;
}

/// Some lines of the table. They are counted from 1 until it is known how many stand before them.
struct Part {
    Part(std::string_view text, SeriesBuilder into)
        : lines(text)
        , builder(std::move(into))
    {
    }

    std::string_view lines;
    SeriesBuilder builder;
    std::vector<SkippedRow> skipped;
    std::optional<ReadError> error;
    std::size_t lineCount = 0;
    std::size_t firstRow = 0; ///< its line; 0: there is no row
    std::string_view firstTime;
};

ReadError timeFault(std::size_t line, const TableLayout &layout, std::string_view digits)
{
    return {line, layout.timeColumn + 1, excerpt(digits), {ReadFault::Kind::TimeNotRising}};
}

/// `read`: called with the bytes read since the last call; false when reading is to stop.
void readPart(Part &part, const TableLayout &layout, const std::function<bool(std::size_t)> &read)
{
    Row row;
    row.numbers.resize(layout.channels.size());
    const bool plainNumbers = layout.table.layout.decimalSign == DecimalSign::Point;
    CellScanner scanner(part.lines, layout.table.layout.delimiter, 1);
    const char *reported = scanner.position();
    for (std::size_t count = 0; !scanner.atEnd(); ++count) {
        if (count % kRowsBetweenPolls == 0) {
            if (!read(static_cast<std::size_t>(scanner.position() - reported))) {
                return;
            }
            reported = scanner.position();
        }
        const std::size_t line = scanner.line();
        if (!plainNumbers || !readPlainRow(scanner, layout, row)) {
            if (const std::optional<BadCell> bad = readRow(scanner, layout, row)) {
                if (bad->fault) {
                    leaveOut({line, bad->column, excerpt(bad->text), *bad->fault}, part.skipped);
                }
                continue;
            }
        }
        if (part.firstRow == 0) {
            part.firstRow = line;
            part.firstTime = row.time.digits;
        } else if (!(row.time.value > part.builder.time().back())) {
            part.error = timeFault(line, layout, row.time.digits);
            return;
        }
        part.builder.add(row);
    }
    part.lineCount = scanner.line() - 1;
}

/// Threads that so many bytes are worth.
std::size_t threadsFor(std::size_t bytes)
{
    constexpr std::size_t kLeast = std::size_t{1} << 20U; // bytes each
    constexpr std::size_t kMost = 8;
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(bytes / kLeast, 1, std::min(processors, kMost));
}

/// The lines in pieces of like size, one for each processor where there are enough of them.
std::vector<std::string_view> partsOf(std::string_view lines)
{
    const std::size_t count = threadsFor(lines.size());
    std::vector<std::string_view> parts;
    for (std::size_t left = count; left > 0; --left) {
        std::size_t end = lines.size() / left;
        if (left > 1) { // to the end of the line; lines may end with LF, CR LF or CR
            end = std::min(lines.find_first_of("\r\n", end), lines.size());
            end = std::min(end + (lines.substr(end).starts_with("\r\n") ? 2 : 1), lines.size());
        }
        parts.push_back(lines.substr(0, end));
        lines.remove_prefix(end);
    }
    return parts;
}

std::variant<ReferenceData, ReadError> readRows(TableLayout layout, const std::stop_token &stop,
                                                const ReadOptions &options)
{
    const auto refused = [&](ReadError error) {
        error.layout = std::move(layout.table.layout);
        return error;
    };
    const Table &table = layout.table;
    std::vector<Part> parts;
    for (const std::string_view lines : partsOf(table.data)) {
        // The first takes the others in: its room is for all.
        const std::string_view roomFor = parts.empty() ? table.data : lines;
        const std::size_t rows = estimateRows(roomFor, roomFor.size(), layout.columns.size());
        parts.emplace_back(lines, SeriesBuilder(layout, rows));
    }
    std::atomic<std::size_t> done = 0;
    const std::thread::id caller = std::this_thread::get_id();
    const auto tell = [&](std::size_t bytes) {
        done += bytes;
        if (options.progress && std::this_thread::get_id() == caller) {
            options.progress(done, table.data.size());
        }
        return !stop.stop_requested();
    };
    inParallel(parts.size(), [&](std::size_t i) { readPart(parts[i], layout, tell); });
    if (stop.stop_requested()) {
        return ReadError{0, 0, {}, {ReadFault::Kind::Stopped}};
    }
    if (options.progress) {
        options.progress(table.data.size(), table.data.size()); // the others may have been the last to end
    }

    SeriesBuilder &builder = parts.front().builder;
    std::vector<SkippedRow> skipped;
    std::size_t linesBefore = table.firstDataLine - 1;
    for (Part &part : parts) {
        const bool isFirst = &part == &parts.front();
        const bool continues = isFirst || part.firstRow == 0 || builder.time().empty() ||
                               part.builder.time().front() > builder.time().back();
        if (!continues) {
            return refused(timeFault(part.firstRow + linesBefore, layout, part.firstTime));
        }
        if (part.error) {
            part.error->line += linesBefore;
            return refused(*std::move(part.error));
        }
        if (!isFirst) {
            builder.add(part.builder);
        }
        for (SkippedRow &row : part.skipped) {
            row.line += linesBefore;
            leaveOut(std::move(row), skipped);
        }
        linesBefore += part.lineCount;
    }

    const std::size_t firstLine = table.firstDataLine;
    const bool noRow = builder.time().empty();
    ReferenceData data = builder.take(layout, std::move(skipped));
    const auto useless = [&](ReadError error) {
        error.layout = std::move(data.layout);
        return error;
    };
    if (noRow) {
        if (data.skipped.empty()) {
            return useless({firstLine - 1, 0, {}, {ReadFault::Kind::NoNumbers}});
        }
        const SkippedRow &first = data.skipped.front();
        ReadFault fault{ReadFault::Kind::NoRow};
        fault.row = first.fault;
        return useless({first.line, first.column, first.text, std::move(fault)});
    }
    if (data.series.empty()) {
        return useless({firstLine, 0, {}, {ReadFault::Kind::NoValues}});
    }
    return data;
}

// ---- large files ---------------------------------------------------------------------------------------------------

constexpr std::size_t kPiece = std::size_t{1} << 18U;       // bytes: stays in the processor's cache
constexpr std::size_t kLongestLine = std::size_t{1} << 12U; // bytes

/// The lines that begin in the piece at offset `from`, read into `buffer`; none where they are not plain. The table
/// begins at offset `dataBegin`.
std::optional<std::string_view> plainLines(const ByteSource &source, std::size_t from, std::size_t dataBegin,
                                           std::vector<char> &buffer)
{
    const std::size_t before = from > dataBegin ? 1 : 0; // that byte tells whether a line begins with the piece
    const std::size_t start = from - before;
    const std::size_t length = std::min(source.size - start, before + kPiece + kLongestLine);
    buffer.resize(length);
    if (!source.read(start, buffer)) {
        return std::nullopt;
    }
    const std::string_view text(buffer.data(), length);
    const bool toTheEnd = start + length == source.size;
    const auto behindLine = [&](std::size_t at) {
        const std::size_t end = text.find('\n', at);
        return end == text.npos ? (toTheEnd ? std::optional(length) : std::nullopt) : std::optional(end + 1);
    };
    const std::optional<std::size_t> begin = before > 0 ? behindLine(0) : std::optional<std::size_t>(0);
    const std::optional<std::size_t> end = behindLine(std::min(before + kPiece - 1, length));
    if (!begin || !end || *begin > *end) {
        return std::nullopt;
    }
    const std::string_view lines = text.substr(*begin, *end - *begin);
    const bool isAscii = findBeyondAscii(lines, 0) == lines.size();
    return isAscii && lines.find('\0') == lines.npos ? std::optional(lines) : std::nullopt;
}

/// The rows of pieces that come in any order, and in turn from several threads.
class JoinedRows
{
public:
    JoinedRows(const TableLayout &layout, std::size_t expectedRows, std::size_t pieces)
        : m_layout(layout)
        , m_all(layout, expectedRows)
        , m_waiting(pieces)
    {
    }

    /// To read a piece into.
    SeriesBuilder empty()
    {
        const std::lock_guard lock(m_mutex);
        if (m_spare.empty()) {
            return SeriesBuilder(m_layout, 0);
        }
        SeriesBuilder spare = std::move(m_spare.back());
        m_spare.pop_back();
        return spare;
    }

    /// False where its instants do not follow those of the piece before.
    bool add(std::size_t piece, SeriesBuilder rows)
    {
        const std::lock_guard lock(m_mutex);
        m_waiting[piece] = std::move(rows);
        for (; m_joined < m_waiting.size() && m_waiting[m_joined]; ++m_joined) {
            SeriesBuilder &next = *m_waiting[m_joined];
            if (!next.time().empty() && !m_all.time().empty() && !(next.time().front() > m_all.time().back())) {
                return false;
            }
            m_all.add(next);
            next.clear();
            m_spare.push_back(std::move(next));
            m_waiting[m_joined].reset();
        }
        return true;
    }

    SeriesBuilder &all() { return m_all; }

private:
    const TableLayout &m_layout;
    std::mutex m_mutex;
    SeriesBuilder m_all;
    std::vector<std::optional<SeriesBuilder>> m_waiting;
    std::size_t m_joined = 0; ///< so many pieces are in
    std::vector<SeriesBuilder> m_spare;
};

} // namespace

const ReferenceSeries *ReferenceData::find(Channel channel) const
{
    const auto found = std::ranges::find(series, channel, &ReferenceSeries::channel);
    return found == series.end() ? nullptr : &*found;
}

std::size_t ReferenceData::skippedRowCount() const
{
    return std::accumulate(skipped.begin(), skipped.end(), std::size_t{0},
                           [](std::size_t count, const SkippedRow &row) { return count + row.rows; });
}

ValueRange rangeOf(std::span<const double> values)
{
    ValueRange range;
    for (const double value : values) {
        if (std::isfinite(value)) {
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
            ++range.count;
        }
    }
    return range;
}

ChannelSet channelsOf(const ReferenceData &data)
{
    ChannelSet channels;
    for (const ReferenceSeries &series : data.series) {
        channels.set(indexOf(series.channel));
    }
    return channels;
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop,
                                                         const ReadOptions &options)
{
    std::string converted;
    std::variant<TableLayout, ReadError> layout = layOut(bytes, converted, options);
    if (ReadError *error = std::get_if<ReadError>(&layout)) {
        return std::move(*error);
    }
    return readRows(std::get<TableLayout>(std::move(layout)), stop, options);
}

std::optional<ReferenceData> readPlainReferenceData(const ByteSource &source, std::stop_token stop,
                                                    const ReadOptions &options)
{
    constexpr std::size_t kBeginning = std::size_t{1} << 20U; // bytes
    if (source.size < 4 * kBeginning) {
        return std::nullopt; // nothing to gain
    }
    std::vector<char> bytes(kBeginning);
    if (!source.read(0, bytes)) {
        return std::nullopt;
    }
    std::string_view beginning(bytes.data(), bytes.size());
    beginning = beginning.substr(0, beginning.rfind('\n') + 1);
    std::string converted;
    std::variant<TableLayout, ReadError> outcome = layOut(beginning, converted, options);
    TableLayout *layout = std::get_if<TableLayout>(&outcome);
    if (!layout || layout->isSampled || layout->table.layout.encoding != TextEncoding::Utf8 ||
        layout->table.layout.decimalSign != DecimalSign::Point) {
        return std::nullopt;
    }

    const auto dataBegin = static_cast<std::size_t>(layout->table.data.data() - bytes.data());
    const std::size_t size = source.size - dataBegin;
    const std::size_t pieces = (size + kPiece - 1) / kPiece;
    JoinedRows rows(*layout, estimateRows(layout->table.data, size, layout->columns.size()), pieces);
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> isPlain = true;
    const std::thread::id caller = std::this_thread::get_id();
    inParallel(threadsFor(size), [&](std::size_t) {
        std::vector<char> buffer;
        for (std::size_t i = next++; i < pieces && isPlain && !stop.stop_requested(); i = next++) {
            const std::optional<std::string_view> lines = plainLines(source, dataBegin + i * kPiece, dataBegin, buffer);
            if (!lines) {
                isPlain = false;
                return;
            }
            Part part(*lines, rows.empty());
            readPart(part, *layout, [&stop](std::size_t) { return !stop.stop_requested(); });
            if (part.error || !part.skipped.empty() || !rows.add(i, std::move(part.builder))) {
                isPlain = false;
                return;
            }
            done += lines->size();
            if (options.progress && std::this_thread::get_id() == caller) {
                options.progress(done, size);
            }
        }
    });
    if (!isPlain || stop.stop_requested() || rows.all().time().empty()) {
        return std::nullopt;
    }
    if (options.progress) {
        options.progress(size, size);
    }
    ReferenceData data = rows.all().take(*layout, {});
    return data.series.empty() ? std::nullopt : std::optional(std::move(data));
}

} // namespace slidercrank
