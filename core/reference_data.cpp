// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reference_data.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t kLongestExcerpt = 40; ///< bytes of a cell that a message repeats
/// How many rows left out are listed one by one; the last entry then counts the others.
constexpr std::size_t kMostSkippedRows = 1000;
constexpr std::size_t kRowsBetweenPolls = 4096;

ReadError wholeFile(std::string reason)
{
    ReadError error;
    error.reason = std::move(reason);
    return error;
}

// ---- cells ---------------------------------------------------------------------------------------------------------

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// What a message repeats of a cell: its beginning, not cut within a character.
std::string excerpt(std::string_view text)
{
    if (text.size() <= kLongestExcerpt) {
        return std::string(text);
    }
    std::size_t length = kLongestExcerpt;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    return std::string(text.substr(0, length)) + "…";
}

/// One cell as it stands in the file.
struct Cell {
    std::string_view text;  ///< without the spaces and quotation marks around it; doubled marks are still doubled
    bool wellFormed = true; ///< false: a quotation mark is not closed, or something follows the closing one
};

/// Walks over the cells of each line. Lines end with LF, CR LF or CR; a cell never spans lines.
class CellScanner
{
public:
    CellScanner(std::string_view bytes, char delimiter, std::size_t firstLine)
        : m_next(bytes.data())
        , m_end(bytes.data() + bytes.size())
        , m_delimiter(delimiter)
        , m_line(firstLine)
    {
        for (const char c : {delimiter, '\n', '\r'}) {
            m_stops[static_cast<unsigned char>(c)] = true;
        }
    }

    bool atEnd() const { return m_next == m_end; }
    std::size_t line() const { return m_line; }
    const char *position() const { return m_next; }

    /// The cell here; the scanner moves behind its delimiter.
    Cell cell()
    {
        skipBlanks();
        Cell cell = m_next != m_end && *m_next == '"' ? quotedCell() : plainCell();
        skipDelimiter();
        return cell;
    }

    /// Whether the line has another cell: always for the first, then where a delimiter stood behind the last one.
    bool hasCell() const { return m_hasCell; }

    /// The cell here, if it is a plain number with a decimal point and nothing else: the short way through most files.
    bool plainNumber(double &value, std::string_view &digits)
    {
        const char *begin = m_next;
        while (begin != m_end && *begin == ' ') {
            ++begin;
        }
        const char *first = begin != m_end && *begin == '-' ? begin + 1 : begin;
        if (first == m_end || !isDigit(*first)) {
            return false;
        }
        const auto [last, fault] = std::from_chars(begin, m_end, value);
        if (fault != std::errc() || !(last == m_end || isStop(*last))) {
            return false;
        }
        digits = {begin, static_cast<std::size_t>(last - begin)};
        m_next = last;
        skipDelimiter();
        return true;
    }

    /// To the beginning of the next line.
    void nextLine()
    {
        while (m_next != m_end && !isLineEnd(*m_next)) {
            ++m_next;
        }
        if (m_next != m_end) {
            const char end = *m_next++;
            if (end == '\r' && m_next != m_end && *m_next == '\n') {
                ++m_next;
            }
        }
        ++m_line;
        m_hasCell = true;
    }

private:
    bool isStop(char c) const { return m_stops[static_cast<unsigned char>(c)]; }

    void skipBlanks()
    {
        while (m_next != m_end && isBlank(*m_next) && *m_next != m_delimiter) {
            ++m_next;
        }
    }

    void skipToStop()
    {
        while (m_next != m_end && !isStop(*m_next)) {
            ++m_next;
        }
    }

    void skipDelimiter()
    {
        m_hasCell = m_next != m_end && *m_next == m_delimiter;
        if (m_hasCell) {
            ++m_next;
        }
    }

    Cell plainCell()
    {
        const char *const begin = m_next;
        skipToStop();
        return {trimmed({begin, static_cast<std::size_t>(m_next - begin)})};
    }

    Cell quotedCell()
    {
        const char *const begin = ++m_next;
        for (; m_next != m_end && !isLineEnd(*m_next); ++m_next) {
            if (*m_next != '"') {
                continue;
            }
            if (m_next + 1 != m_end && m_next[1] == '"') {
                ++m_next;
                continue;
            }
            const std::string_view text{begin, static_cast<std::size_t>(m_next - begin)};
            ++m_next;
            skipBlanks();
            const bool closed = m_next == m_end || isStop(*m_next);
            skipToStop();
            return {trimmed(text), closed};
        }
        return {{begin, static_cast<std::size_t>(m_next - begin)}, false};
    }

    const char *m_next;
    const char *m_end;
    char m_delimiter;
    std::size_t m_line;
    bool m_hasCell = true;
    std::array<bool, 256> m_stops{};
};

// ---- numbers -------------------------------------------------------------------------------------------------------

/// A cell's number, NaN where the cell is a gap, or a clause that says why it is neither.
struct Number {
    double value = kMissing;
    std::string_view digits; ///< as printed; empty for a gap
    const char *fault = nullptr;
};

Number unreadable(const char *clause)
{
    Number number;
    number.fault = clause;
    return number;
}

bool equalIgnoringCase(std::string_view text, std::string_view lowerCase)
{
    return std::equal(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(), [](char x, char lower) {
        return (x >= 'A' && x <= 'Z' ? static_cast<char>(x - 'A' + 'a') : x) == lower;
    });
}

/// Whether the cell could be a number by its letters, whatever its decimal sign.
bool looksNumeric(std::string_view text)
{
    return text.find_first_of("0123456789") != std::string_view::npos &&
           text.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
}

/// The number that all of `digits` are, if they are one; with its point, whatever the file's decimal sign.
std::optional<double> valueOf(std::string_view digits)
{
    const std::size_t first = !digits.empty() && digits.front() == '-' ? 1 : 0;
    if (first == digits.size() || !(isDigit(digits[first]) || digits[first] == '.')) {
        return std::nullopt; // also inf, which from_chars would take
    }
    double value = 0.0;
    const char *const end = digits.data() + digits.size();
    const auto [last, fault] = std::from_chars(digits.data(), end, value);
    if (last != end || fault == std::errc::invalid_argument) {
        return std::nullopt;
    }
    if (fault == std::errc::result_out_of_range) {
        const double sizeBeyondDouble = placesOf(digits).first > 0 ? std::numeric_limits<double>::infinity() : 0.0;
        return sizeBeyondDouble;
    }
    return value;
}

Number readNumber(std::string_view text, DecimalSign decimalSign)
{
    const bool comma = decimalSign == DecimalSign::Comma;
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    Number number;
    number.digits = plus ? text.substr(1) : text;

    std::optional<double> value;
    std::array<char, 128> withPoint; // no number needs more
    if (!comma) {
        value = valueOf(number.digits);
    } else if (number.digits.size() <= withPoint.size() && number.digits.find('.') == std::string_view::npos) {
        std::replace_copy(number.digits.begin(), number.digits.end(), withPoint.begin(), ',', '.');
        value = valueOf({withPoint.data(), number.digits.size()});
    }
    if (value && std::isfinite(*value)) {
        number.value = *value;
        return number;
    }
    if (value) {
        return unreadable("not a number: too large");
    }
    if (text.empty() || equalIgnoringCase(text, "nan") || equalIgnoringCase(text, "-nan")) {
        return {};
    }
    if (looksNumeric(text) && text.find(comma ? '.' : ',') != std::string_view::npos) {
        return unreadable(comma ? "not a number: this file writes a decimal comma"
                                : "not a number: this file writes a decimal point");
    }
    return unreadable("not a number");
}

/// The decimal sign of a file whose cells are not separated by commas. The first number that can be read in one way
/// only decides: 0,005 and 74,5436 hold a decimal comma; 74,543 alone could be thousands.
DecimalSign findDecimalSign(CellScanner rows)
{
    bool commas = false;
    bool points = false;
    for (; !rows.atEnd(); rows.nextLine()) {
        while (rows.hasCell()) {
            const std::string_view text = rows.cell().text;
            const std::size_t sign = text.find_first_of(".,");
            if (sign == std::string_view::npos || !looksNumeric(text) ||
                text.find_first_of(".,", sign + 1) != std::string_view::npos) {
                continue;
            }
            const std::size_t firstDigit = text.find_first_of("0123456789");
            const std::size_t fraction = text.find_first_not_of("0123456789", sign + 1);
            const std::size_t fractionDigits = std::min(fraction, text.size()) - sign - 1;
            const bool couldBeThousands = fractionDigits == 3 && fraction == std::string_view::npos &&
                                          firstDigit < sign && text[firstDigit] != '0' && sign - firstDigit <= 3;
            const bool comma = text[sign] == ',';
            if (!couldBeThousands) {
                return comma ? DecimalSign::Comma : DecimalSign::Point;
            }
            (comma ? commas : points) = true;
        }
    }
    return commas && !points ? DecimalSign::Comma : DecimalSign::Point;
}

// ---- units ---------------------------------------------------------------------------------------------------------

struct NamedFactor {
    std::string_view name;
    double factor;
};

constexpr std::array<NamedFactor, 5> kLengthUnits{
    {{"mm", 1.0}, {"cm", 10.0}, {"m", 1e3}, {"in", 25.4}, {"inch", 25.4}}};
constexpr std::array<NamedFactor, 2> kAngleUnits{{{"deg", 1.0}, {"rad", kDegreesPerRadian}}};
constexpr std::array<NamedFactor, 3> kUnitsPerSecond{{{"s", 1.0}, {"sec", 1.0}, {"ms", 1e3}}};

template <std::size_t N>
std::optional<double> factorOf(std::string_view name, const std::array<NamedFactor, N> &units)
{
    for (const NamedFactor &unit : units) {
        if (unit.name == name) {
            return unit.factor;
        }
    }
    return std::nullopt;
}

/// Lower case, without spaces; degree and square signs (also the ordinal sign that stands for degrees on Spanish
/// keyboards, and all of them in Windows' 8-bit encoding) as "deg" and "2", without "^".
std::string plainUnit(std::string_view text)
{
    std::string plain;
    for (const char c : text) {
        switch (static_cast<unsigned char>(c)) {
        case 0xC2: // first byte of °, º and ² in UTF-8
        case ' ':
        case '\t':
        case '^': break;
        case 0xB0:
        case 0xBA: plain += "deg"; break;
        case 0xB2: plain += '2'; break;
        default: plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        }
    }
    return plain;
}

/// From a unit such as "rad/s²", "mm/s/s" or "°/ms2" to the author's unit of the channel.
std::optional<double> channelUnitFactor(std::string_view text, Channel channel)
{
    const std::string plain = plainUnit(text);
    std::string_view rest = plain;
    const std::string_view base = rest.substr(0, rest.find('/'));
    std::optional<double> factor =
        isAngle(channel.coordinate) ? factorOf(base, kAngleUnits) : factorOf(base, kLengthUnits);
    rest.remove_prefix(base.size());
    int order = 0;
    while (factor && !rest.empty()) {
        rest.remove_prefix(1);
        std::string_view per = rest.substr(0, rest.find('/'));
        rest.remove_prefix(per.size());
        const bool squared = !per.empty() && per.back() == '2';
        if (squared) {
            per.remove_suffix(1);
        }
        const std::optional<double> perSecond = factorOf(per, kUnitsPerSecond);
        if (!perSecond) {
            return std::nullopt;
        }
        *factor *= squared ? *perSecond * *perSecond : *perSecond;
        order += squared ? 2 : 1;
    }
    return order == static_cast<int>(channel.order) ? factor : std::nullopt;
}

// ---- header --------------------------------------------------------------------------------------------------------

/// What a column's cells are.
struct Column {
    enum class Kind { Ignored, Time, Series };
    Kind kind = Kind::Ignored;
    std::size_t series = 0;      ///< its place in Layout::channels
    double unitFactor = 1.0;     ///< of a series: to the author's unit
    double unitsPerSecond = 1.0; ///< of the time: divides, so that 5 ms are 0.005 s to the last bit
};

struct Layout {
    FileLayout file;
    char delimiter = ',';
    DecimalSign decimalSign = DecimalSign::Point;
    std::vector<Column> columns;
    std::vector<Channel> channels;
    std::vector<std::string> names; ///< of the columns, as printed
    std::vector<std::string> ignoredColumns;
    std::size_t timeColumn = 0;
    std::size_t firstDataLine = 0;
    std::string_view data; ///< everything below the header
};

/// A header cell: "theta3_diff [rad/s]" is printed so, and has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    std::string printed;
    std::string name;
    std::string unit; ///< empty: none given
};

Heading headingOf(std::string_view cell)
{
    Heading heading;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        heading.printed += cell[i];
        if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') {
            ++i; // a doubled mark stands for one
        }
    }
    std::string_view name = heading.printed;
    if (!name.empty() && (name.back() == ']' || name.back() == ')')) {
        const std::size_t open = name.rfind(name.back() == ']' ? '[' : '(');
        if (open != std::string_view::npos) {
            heading.unit = trimmed(name.substr(open + 1, name.size() - open - 2));
            name = trimmed(name.substr(0, open));
        }
    }
    heading.name = name;
    return heading;
}

bool isTime(const Heading &heading)
{
    return equalIgnoringCase(heading.name, "time");
}

std::optional<Channel> channelOf(const Heading &heading)
{
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        std::string lowerCase(nameOf(channelAt(index)));
        std::replace(lowerCase.begin(), lowerCase.end(), 'R', 'r');
        if (equalIgnoringCase(heading.name, lowerCase)) {
            return channelAt(index);
        }
    }
    return std::nullopt;
}

/// The headings of the line where the scanner stands, without empty ones at the end.
std::vector<Heading> readHeadings(CellScanner scanner)
{
    std::vector<Heading> headings;
    while (scanner.hasCell()) {
        headings.push_back(headingOf(scanner.cell().text));
    }
    while (!headings.empty() && headings.back().printed.empty()) {
        headings.pop_back();
    }
    return headings;
}

std::string_view lineAt(const CellScanner &scanner, std::string_view bytes)
{
    const std::string_view rest = bytes.substr(static_cast<std::size_t>(scanner.position() - bytes.data()));
    return rest.substr(0, std::min(rest.find_first_of("\r\n"), rest.size()));
}

constexpr std::string_view kDelimiters = "\t;,";

/// The delimiter that makes most headings known; failing that, the one that makes most headings.
char findDelimiter(std::string_view headerLine)
{
    char best = kDelimiters.back();
    std::pair<std::size_t, std::size_t> bestScore{0, 0};
    for (const char delimiter : kDelimiters) {
        const std::vector<Heading> headings = readHeadings(CellScanner(headerLine, delimiter, 1));
        const auto known = std::count_if(headings.begin(), headings.end(), [](const Heading &heading) {
            return isTime(heading) || channelOf(heading).has_value();
        });
        const std::pair<std::size_t, std::size_t> score{static_cast<std::size_t>(known), headings.size()};
        if (score > bestScore) {
            best = delimiter;
            bestScore = score;
        }
    }
    return best;
}

/// What a heading of a known name means, or why it cannot be used. `layout` holds the columns before it.
std::variant<Column, std::string> columnOf(const Heading &heading, const Layout &layout)
{
    const bool unitGiven = !heading.unit.empty();
    if (isTime(heading)) {
        const auto isTimeColumn = [](const Column &column) { return column.kind == Column::Kind::Time; };
        if (std::any_of(layout.columns.begin(), layout.columns.end(), isTimeColumn)) {
            return "there is a time column already: keep one of the two.";
        }
        const std::optional<double> unitsPerSecond =
            unitGiven ? factorOf(plainUnit(heading.unit), kUnitsPerSecond) : 1.0;
        if (!unitsPerSecond) {
            return "the unit of the time is not known: write [s] or [ms], or none for seconds.";
        }
        return Column{.kind = Column::Kind::Time, .unitsPerSecond = *unitsPerSecond};
    }
    const std::optional<Channel> channel = channelOf(heading);
    if (!channel) {
        return Column{};
    }
    if (std::find(layout.channels.begin(), layout.channels.end(), *channel) != layout.channels.end()) {
        return "there is a column of that name already: keep one of the two.";
    }
    const std::optional<double> unitFactor = unitGiven ? channelUnitFactor(heading.unit, *channel) : 1.0;
    if (!unitFactor) {
        return "the unit is not known or does not suit the quantity: write for example [" +
               std::string(authorUnitOf(*channel)) + "], " + (isAngle(channel->coordinate) ? "rad" : "m, cm or in") +
               " in its place, or none.";
    }
    return Column{.kind = Column::Kind::Series, .series = layout.channels.size(), .unitFactor = *unitFactor};
}

/// Reads the header line. `bytes`: the file without byte order mark.
std::variant<Layout, ReadError> readLayout(std::string_view bytes)
{
    const auto isBlankLine = [](std::string_view line) { return line.find_first_not_of(" \t;,") == line.npos; };
    CellScanner scanner(bytes, kDelimiters.back(), 1);
    while (!scanner.atEnd() && isBlankLine(lineAt(scanner, bytes))) {
        scanner.nextLine();
    }
    if (scanner.atEnd()) {
        return wholeFile("The file is empty: it needs a line with the names of the columns, and numbers below.");
    }
    Layout layout;
    std::string_view headerLine = lineAt(scanner, bytes);
    constexpr std::string_view kSeparatorHint = "sep="; // spreadsheets may write their delimiter so, in a first line
    const bool hinted = headerLine.size() == kSeparatorHint.size() + 1 &&
                        equalIgnoringCase(headerLine.substr(0, kSeparatorHint.size()), kSeparatorHint) &&
                        kDelimiters.find(headerLine.back()) != std::string_view::npos;
    if (hinted) {
        layout.delimiter = headerLine.back();
        scanner.nextLine();
        headerLine = lineAt(scanner, bytes);
    } else {
        layout.delimiter = findDelimiter(headerLine);
    }
    const std::size_t line = scanner.line();
    const std::vector<Heading> headings = readHeadings(CellScanner(headerLine, layout.delimiter, line));

    bool hasTime = false;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const Heading &heading = headings[i];
        const std::variant<Column, std::string> meaning = columnOf(heading, layout);
        if (const std::string *reason = std::get_if<std::string>(&meaning)) {
            return ReadError{line, i + 1, excerpt(heading.printed), *reason};
        }
        const Column &column = std::get<Column>(meaning);
        switch (column.kind) {
        case Column::Kind::Time:
            hasTime = true;
            layout.timeColumn = i;
            break;
        case Column::Kind::Series: layout.channels.push_back(*channelOf(heading)); break;
        case Column::Kind::Ignored:
            layout.ignoredColumns.push_back(heading.printed.empty() ? "column " + std::to_string(i + 1)
                                                                    : heading.printed);
            break;
        }
        FileColumn described;
        described.heading = heading.printed;
        described.unit = heading.unit;
        described.reason = heading.printed.empty() ? ColumnReason::NoName : ColumnReason::UnknownName;
        if (column.kind != Column::Kind::Ignored) {
            described.reason = ColumnReason::KnownName;
            described.role = column.kind == Column::Kind::Time ? ColumnRole::Time : ColumnRole::Channel;
        }
        if (column.kind == Column::Kind::Series) {
            described.channel = layout.channels.back();
        }
        layout.file.columns.push_back(std::move(described));
        layout.columns.push_back(column);
        layout.names.push_back(heading.printed);
    }
    if (!hasTime && layout.channels.empty()) {
        for (std::size_t i = 0; i < headings.size(); ++i) {
            if (looksNumeric(headings[i].printed)) {
                return ReadError{line, i + 1, excerpt(headings[i].printed),
                                 "numbers stand where the names of the columns should: put a line such as "
                                 "time,theta3,R4_x above them."};
            }
        }
    }
    if (!hasTime) {
        return ReadError{line, 0, excerpt(headerLine),
                         "there is no time column: name the column of the instants \"time\"."};
    }
    if (layout.channels.empty()) {
        return ReadError{
            line, 0, excerpt(headerLine),
            "no column beside the time has a known name: name them as in theta3, theta3_diff, theta3_diff2, "
            "R4_x, R4_x_diff, R4_x_diff2."};
    }
    scanner.nextLine();
    layout.firstDataLine = scanner.line();
    layout.data = bytes.substr(static_cast<std::size_t>(scanner.position() - bytes.data()));
    if (layout.delimiter != ',') { // where the comma separates cells it is never a decimal comma as well
        layout.decimalSign = findDecimalSign(CellScanner(layout.data, layout.delimiter, layout.firstDataLine));
    }
    layout.file.delimiter = layout.delimiter;
    layout.file.decimalSign = layout.decimalSign;
    layout.file.headerLine = line;
    return layout;
}

// ---- rows ----------------------------------------------------------------------------------------------------------

/// The numbers of one line, reused from line to line.
struct Row {
    double time = kMissing;
    std::string_view timeDigits;
    std::vector<Number> numbers; ///< by place in Layout::channels
};

/// Why a line holds no row: a cell and a clause; without a clause, because it is blank.
struct RowFault {
    std::size_t column = 0; ///< from 1
    std::string_view text;
    const char *reason = nullptr;
};

/// Reads one line into `row`; the scanner moves to the next.
std::optional<RowFault> readRow(CellScanner &scanner, const Layout &layout, Row &row)
{
    std::optional<RowFault> fault;
    const auto blame = [&fault](std::size_t cell, std::string_view text, const char *reason) {
        if (!fault) {
            fault = RowFault{cell + 1, text, reason};
        }
    };
    const bool plainNumbers = layout.decimalSign == DecimalSign::Point;
    bool blank = true;
    std::size_t cellCount = 0;
    for (; scanner.hasCell(); ++cellCount) {
        const bool named = cellCount < layout.columns.size();
        const Column column = named ? layout.columns[cellCount] : Column();
        Number number;
        std::string_view text;
        if (plainNumbers && column.kind != Column::Kind::Ignored && scanner.plainNumber(number.value, number.digits)) {
            text = number.digits;
        } else {
            const Cell cell = scanner.cell();
            text = cell.text;
            if (!cell.wellFormed) {
                number.fault = "a quotation mark that is not closed at the end of the cell";
            } else if (column.kind != Column::Kind::Ignored) {
                number = readNumber(text, layout.decimalSign);
            } else if (!named && !text.empty()) {
                number.fault = "too many cells";
            }
        }
        blank = blank && text.empty();
        switch (column.kind) {
        case Column::Kind::Ignored: break;
        case Column::Kind::Time:
            row.time = number.value / column.unitsPerSecond;
            row.timeDigits = number.digits;
            if (!number.fault && std::isnan(row.time)) {
                number.fault = "no time";
            }
            break;
        case Column::Kind::Series:
            number.value *= column.unitFactor;
            if (std::isinf(number.value)) {
                number.fault = "not a number: too large";
            }
            row.numbers[column.series] = number;
            break;
        }
        if (number.fault) {
            blame(cellCount, text, number.fault);
        }
    }
    scanner.nextLine();
    if (blank) {
        return RowFault{};
    }
    if (cellCount < layout.columns.size()) {
        blame(cellCount - 1, {}, "too few cells");
    }
    return fault;
}

/// Counts the rows left out and keeps the first of them.
class SkippedRows
{
public:
    void add(std::size_t line, const RowFault &fault)
    {
        if (m_rows.size() < kMostSkippedRows) {
            m_rows.push_back({line, fault.column, excerpt(fault.text), fault.reason});
        } else if (m_unlisted++ == 0) {
            m_firstUnlisted = line;
        }
    }

    std::vector<SkippedRow> take()
    {
        if (m_unlisted > 0) {
            m_rows.push_back(
                {m_firstUnlisted,
                 0,
                 {},
                 "this line and " + std::to_string(m_unlisted - 1) + " more below it cannot be read either"});
        }
        return std::move(m_rows);
    }

private:
    std::vector<SkippedRow> m_rows;
    std::size_t m_unlisted = 0;
    std::size_t m_firstUnlisted = 0;
};

/// Something else than text in UTF-8 (or an 8-bit encoding), by its first bytes or a zero byte.
std::optional<ReadError> findForeignFormat(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        return wholeFile("The file is text in UTF-16: save it as UTF-8.");
    }
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0")) {
        return wholeFile("The file is a spreadsheet or an archive, not text: save the table as CSV.");
    }
    const std::size_t zero = bytes.find('\0');
    if (zero == std::string_view::npos) {
        return std::nullopt;
    }
    const bool everyOther = bytes.size() >= 4 && (bytes[0] == '\0') == (bytes[2] == '\0') &&
                            (bytes[1] == '\0') == (bytes[3] == '\0') && (bytes[0] == '\0') != (bytes[1] == '\0');
    if (everyOther) {
        return wholeFile("The file looks like text in UTF-16: save it as UTF-8.");
    }
    CellScanner line(bytes, ',', 1);
    for (CellScanner next = line; next.position() <= bytes.data() + zero; next.nextLine()) {
        line = next;
    }
    return ReadError{line.line(), 0, {}, "the file holds bytes that are not text: export the table as CSV."};
}

/// The columns that the rows fill.
class SeriesBuilder
{
public:
    SeriesBuilder(const Layout &layout, std::size_t expectedRows)
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

    void add(const Row &row)
    {
        m_data.time.push_back(row.time);
        for (std::size_t i = 0; i < row.numbers.size(); ++i) {
            m_data.series[i].values.push_back(row.numbers[i].value);
            if (!row.numbers[i].digits.empty()) {
                m_observers[i].observe(row.numbers[i].digits);
            }
        }
    }

    /// The data, without the columns that hold no number at all: those are listed with the ignored ones.
    ReferenceData take(const Layout &layout, SkippedRows &skipped)
    {
        m_data.skipped = skipped.take();
        m_data.ignoredColumns = layout.ignoredColumns;
        m_data.layout = layout.file;
        for (std::size_t i = 0; i < layout.columns.size(); ++i) {
            const Column &column = layout.columns[i];
            if (column.kind == Column::Kind::Series) {
                m_data.series[column.series].rounding = m_observers[column.series].infer(column.unitFactor);
                if (isEmpty(m_data.series[column.series])) {
                    m_data.ignoredColumns.push_back(layout.names[i]);
                    m_data.layout.columns[i].role = ColumnRole::Ignored;
                    m_data.layout.columns[i].reason = ColumnReason::NoNumber;
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
    std::vector<RoundingObserver> m_observers;
};

/// About how many rows there are: from the length of the first, or the shortest that can fill the columns.
std::size_t estimateRows(const Layout &layout)
{
    const std::size_t firstLine = std::min(layout.data.find_first_of("\r\n"), layout.data.size()) + 1;
    return layout.data.size() / std::max(firstLine, layout.columns.size()) + 1;
}

} // namespace

const ReferenceSeries *ReferenceData::find(Channel channel) const
{
    const auto found = std::find_if(series.begin(), series.end(),
                                    [channel](const ReferenceSeries &each) { return each.channel == channel; });
    return found == series.end() ? nullptr : &*found;
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop,
                                                         const ReadOptions &options)
{
    if (std::optional<ReadError> error = findForeignFormat(bytes)) {
        return *std::move(error);
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrderMark)) {
        bytes.remove_prefix(kByteOrderMark.size());
    }
    std::variant<Layout, ReadError> header = readLayout(bytes);
    if (ReadError *error = std::get_if<ReadError>(&header)) {
        return std::move(*error);
    }
    const Layout &layout = std::get<Layout>(header);

    SeriesBuilder builder(layout, estimateRows(layout));
    SkippedRows skipped;
    Row row;
    row.numbers.resize(layout.channels.size());
    CellScanner scanner(layout.data, layout.delimiter, layout.firstDataLine);
    for (std::size_t count = 0; !scanner.atEnd(); ++count) {
        if (count % kRowsBetweenPolls == 0) {
            if (stop.stop_requested()) {
                return wholeFile("Reading was stopped.");
            }
            if (options.progress) {
                options.progress(static_cast<std::size_t>(scanner.position() - bytes.data()), bytes.size());
            }
        }
        const std::size_t line = scanner.line();
        if (const std::optional<RowFault> fault = readRow(scanner, layout, row)) {
            if (fault->reason) {
                skipped.add(line, *fault);
            }
            continue;
        }
        if (!builder.time().empty() && !(row.time > builder.time().back())) {
            return ReadError{line, layout.timeColumn + 1, excerpt(row.timeDigits),
                             "the time does not increase from the row before: sort the rows by time and keep one of "
                             "each instant."};
        }
        builder.add(row);
    }

    const bool noRow = builder.time().empty();
    ReferenceData data = builder.take(layout, skipped);
    if (noRow) {
        if (data.skipped.empty()) {
            return ReadError{layout.firstDataLine - 1, 0, {}, "there are no numbers below the names of the columns."};
        }
        SkippedRow &first = data.skipped.front();
        return ReadError{first.line, first.column, std::move(first.text),
                         "no row can be read; here the reason is: " + first.reason +
                             ". Numbers look like 0.005, or like 0,005 where semicolons or tabs separate the columns."};
    }
    if (data.series.empty()) {
        return ReadError{layout.firstDataLine, 0, {}, "no column beside the time holds a number."};
    }
    return data;
}

} // namespace slidercrank
