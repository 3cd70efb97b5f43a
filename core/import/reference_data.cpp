// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "core/mechanism/in_parallel.h"
#include "core/import/crank_angles.h"
#include "core/import/difference.h"
#include "core/import/table_columns.h"
#include "core/import/table_rows.h"
#include "core/import/text_pieces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>
#include <thread>
#include <utility>

namespace slidercrank
{

namespace
{

/// How many rows there hardly are more of, from the lines that are known. Room that is never written to costs next to
/// nothing, a move to more room much.
std::size_t estimateRows(std::string_view lines, std::size_t textSize)
{
    const auto ends = std::max(std::ranges::count(lines, '\n'), std::ranges::count(lines, '\r'));
    const double linesPerByte = static_cast<double>(ends) / static_cast<double>(std::max<std::size_t>(lines.size(), 1));
    return static_cast<std::size_t>(1.25 * linesPerByte * static_cast<double>(textSize)) + 1;
}

/// Threads that so many bytes are worth.
std::size_t threadsFor(std::size_t bytes)
{
    constexpr std::size_t kLeast = std::size_t{1} << 20U; // bytes each
    constexpr std::size_t kMost = 8;
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(bytes / kLeast, 1, std::min(processors, kMost));
}

/// The rows of pieces that come in any order, and in turn from several threads.
class JoinedRows
{
public:
    JoinedRows(const TableLayout &layout, std::size_t expectedRows, std::size_t pieces)
        : m_layout(layout)
        , m_rows(layout)
        , m_linesBefore(layout.table.firstDataLine - 1)
        , m_waiting(pieces)
    {
        if (pieces > 1) {
            m_rows.reserve(expectedRows);
        }
    }

    /// To read a piece into.
    ReadLines empty()
    {
        const std::lock_guard lock(m_mutex);
        if (m_spare.empty()) {
            return ReadLines(m_layout);
        }
        ReadLines spare = std::move(m_spare.back());
        m_spare.pop_back();
        return spare;
    }

    /// False where a fault is known: nothing more is wanted.
    bool add(std::size_t piece, ReadLines lines)
    {
        const std::lock_guard lock(m_mutex);
        m_waiting[piece] = std::move(lines);
        for (; !m_error && m_joined < m_waiting.size() && m_waiting[m_joined]; ++m_joined) {
            join(*m_waiting[m_joined]);
            m_waiting[m_joined].reset();
        }
        return !m_error;
    }

    const std::optional<ReadError> &error() const { return m_error; }
    bool isEmpty() const { return m_rows.time().empty(); }

    ReferenceData take(TableLayout &layout) { return m_rows.take(layout, std::move(m_skipped)); }

private:
    void join(ReadLines &next)
    {
        const bool follows =
            next.firstRow == 0 || isEmpty() || m_layout.isByAngle || next.rows.time().front() > m_rows.time().back();
        if (!follows) {
            m_error = timeFault(next.firstRow, m_layout, next.firstTime);
        } else if (next.error) {
            m_error = std::move(next.error);
        }
        if (m_error) {
            m_error->line += m_error->line > 0 ? m_linesBefore : 0;
            return;
        }
        for (SkippedRow &row : next.skipped) {
            row.line += m_linesBefore;
            leaveOut(std::move(row), m_skipped);
        }
        next.rows.countLinesFrom(m_linesBefore);
        m_linesBefore += next.count;
        if (m_waiting.size() == 1) {
            m_rows = std::move(next.rows);
            return;
        }
        m_rows.add(next.rows);
        next.clear();
        m_spare.push_back(std::move(next));
    }

    const TableLayout &m_layout;
    std::mutex m_mutex;
    SeriesBuilder m_rows;
    std::vector<SkippedRow> m_skipped;
    std::optional<ReadError> m_error;
    std::size_t m_linesBefore;
    std::vector<std::optional<ReadLines>> m_waiting;
    std::size_t m_joined = 0; ///< so many pieces are in
    std::vector<ReadLines> m_spare;
};

/// Why there are no data at all.
std::optional<ReadError> findWhyUseless(const ReferenceData &data, std::size_t firstDataLine)
{
    if (!data.time.empty()) {
        return data.series.empty() ? std::optional(ReadError{firstDataLine, 0, {}, {ReadFault::Kind::NoValues}})
                                   : std::nullopt;
    }
    if (data.skipped.empty()) {
        return ReadError{firstDataLine - 1, 0, {}, {ReadFault::Kind::NoNumbers}};
    }
    const SkippedRow &first = data.skipped.front();
    ReadFault fault{ReadFault::Kind::NoRow};
    fault.row = first.fault;
    return ReadError{first.line, first.column, first.text, std::move(fault)};
}

/// Makes instants of the angles that were read in their place.
std::optional<ReadError> countByAngle(ReferenceData &data, const TableLayout &layout, std::size_t firstDataLine)
{
    data.crank.emplace();
    data.crank->degrees = goingOn(data.time);
    data.crank->rounding = data.timeRounding;
    if (const std::optional<std::size_t> row = turnsBackAt(data.crank->degrees)) {
        std::array<char, 32> angle{};
        const std::to_chars_result written =
            std::to_chars(angle.data(), angle.data() + angle.size(), data.time[*row - 1]);
        ReadFault fault{ReadFault::Kind::AngleTurnsBack};
        fault.heading = std::string(angle.data(), written.ptr) + "°";
        const FileColumn &column = data.layout.columns[layout.timeColumn];
        return ReadError{data.layout.headerLine, layout.timeColumn + 1, excerpt(column.heading), std::move(fault),
                         std::move(data.layout)};
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), std::move(data));
    if (!timed) {
        ReadFault fault{ReadFault::Kind::NoRow};
        fault.row = RowFault::TooLarge;
        return ReadError{firstDataLine, layout.timeColumn + 1, {}, std::move(fault)};
    }
    data = *std::move(timed);
    return std::nullopt;
}

/// All of the table's rows, in one list.
void readPieces(const TextPieces &text, const TableLayout &layout, const std::stop_token &stop,
                const ReadOptions &options, JoinedRows &rows)
{
    const std::size_t pieces = text.count();
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> isOver = false;
    const std::thread::id caller = std::this_thread::get_id();
    const auto readInTurn = [&] {
        PieceBuffer buffer;
        for (std::size_t i = next++; i < pieces && !isOver && !stop.stop_requested(); i = next++) {
            const PieceLines lines = text.lines(i, buffer);
            ReadLines read = rows.empty();
            readLines(lines.text, layout, read);
            if (lines.fault && !read.error) {
                const bool isOfTheLine = *lines.fault != ReadFault::Kind::Unreadable;
                read.error = ReadError{isOfTheLine ? read.count + 1 : 0, 0, {}, {*lines.fault}};
            }
            if (!rows.add(i, std::move(read))) {
                isOver = true;
            }
            done += text.size() / pieces;
            if (options.progress && std::this_thread::get_id() == caller) {
                options.progress(done, text.size());
            }
        }
    };
    inParallel(threadsFor(text.size()), [&](std::size_t) {
        try {
            readInTurn();
        } catch (...) { // no memory: the others need not go on
            isOver = true;
            throw;
        }
    });
}

std::variant<ReferenceData, ReadError> read(const ByteSource &source, const std::stop_token &stop,
                                            const ReadOptions &options)
{
    if (stop.stop_requested()) {
        return ReadError{0, 0, {}, {ReadFault::Kind::Stopped}};
    }
    std::string beginning;
    std::variant<TableLayout, ReadError> outcome = layOut(source, beginning, options);
    if (ReadError *error = std::get_if<ReadError>(&outcome)) {
        return std::move(*error);
    }
    TableLayout &layout = std::get<TableLayout>(outcome);
    const Table &table = layout.table;
    const TextPieces text(source, table.layout.encoding, layout.dataBegin);
    const std::size_t textSize = text.size() / codeUnitSize(table.layout.encoding);
    JoinedRows rows(layout, estimateRows(table.data, textSize), text.count());
    readPieces(text, layout, stop, options, rows);
    if (stop.stop_requested()) {
        return ReadError{0, 0, {}, {ReadFault::Kind::Stopped}};
    }
    if (std::optional<ReadError> error = rows.error()) {
        error->layout = std::move(layout.table.layout);
        return *std::move(error);
    }
    if (options.progress) {
        options.progress(text.size(), text.size()); // the others may have been the last to end
    }
    const std::size_t firstDataLine = table.firstDataLine;
    ReferenceData data = rows.take(layout);
    if (layout.isByAngle && !data.time.empty()) {
        if (std::optional<ReadError> error = countByAngle(data, layout, firstDataLine)) {
            return *std::move(error);
        }
    }
    if (std::optional<ReadError> error = findWhyUseless(data, firstDataLine)) {
        error->layout = std::move(data.layout);
        return *std::move(error);
    }
    for (FileColumn &column : data.layout.columns) {
        if (column.role == ColumnRole::Channel) {
            column.difference = differenceIn(data, column.channel);
        }
    }
    return data;
}

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

std::variant<ReferenceData, ReadError> readReferenceData(const ByteSource &source, std::stop_token stop,
                                                         const ReadOptions &options)
{
    try {
        return read(source, stop, options);
    } catch (const std::bad_alloc &) {
        return ReadError{0, 0, {}, {ReadFault::Kind::NoMemory}};
    }
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop,
                                                         const ReadOptions &options)
{
    return readReferenceData(sourceOf(bytes), std::move(stop), options);
}

} // namespace slidercrank
