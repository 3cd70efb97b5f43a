// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/lines.h"

#include "core/import/cells.h"
#include "core/import/reference_data.h"

#include <algorithm>
#include <array>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kMaxLineSize = std::size_t{1} << 20U;        // bytes
constexpr std::string_view kEndOfPreamble = "***End_of_Header***"; // of LabVIEW, which names columns there, too
constexpr std::array<std::string_view, 6> kRemarkMarks{"#", "//", "/*", "%", "!", "--"};

/// Returns whether a mark in a line, between the texts `before` and `after`, begins a remark:
///
/// - "#", "//" and "/*" behind a blank or a digit: "0.5 # start". But directly before a character other than a small
///   letter, as in "0.5 #N/A", they do not.
/// - "%", "!" and "--" only behind a blank and, after another one, before a word that is no gap, as in "0.5 % start",
/// or
///   else directly before a small letter. They have further meanings, as in "12 %" and "0.5 -- NaN".
bool beginsRemark(std::string_view before, std::string_view mark, std::string_view after)
{
    const bool isAmbiguous = mark == "%" || mark == "!" || mark == "--";
    const bool isApart = isBlank(before.back()) || (!isAmbiguous && isDigit(before.back()));
    if (!isApart) {
        return false;
    }
    const std::string_view text = trimmed(after);
    if (text.empty()) {
        return !isAmbiguous;
    }
    if (!isBlank(after[0])) {
        return text[0] >= 'a' && text[0] <= 'z';
    }
    const bool isLetter = lowerCase(text[0]) >= 'a' && lowerCase(text[0]) <= 'z';
    const std::string_view word = text.substr(0, text.find_first_of(" \t"));
    return !isAmbiguous || (isLetter && parseNumber(word, DecimalSign::Point).fault);
}

std::string_view withoutRemark(std::string_view line)
{
    for (const std::string_view mark : kRemarkMarks) {
        for (std::size_t at = line.find(mark, 1); at != line.npos; at = line.find(mark, at + 1)) {
            if (beginsRemark(line.substr(0, at), mark, line.substr(at + mark.size()))) {
                line = line.substr(0, at);
                break;
            }
        }
    }
    return line;
}

/// Returns whether a line only separates rows: "|---|:--:|", "+====+====+", "----+----" or "____  ____".
bool isRule(std::string_view line)
{
    const auto has = [line](std::string_view part) { return line.find(part) != line.npos; };
    return line.find_first_not_of("-=_:+| \t") == line.npos &&
           (has("--") || has("==") || has("__") || line.starts_with('|'));
}

/// Returns whether every line with a bar near the beginning of a text, apart from rules, begins and ends with one, as
/// in Markdown. Otherwise, a bar at the end of a line delimits an empty cell.
bool isBordered(std::string_view text)
{
    const std::string_view beginning = text.substr(0, kFileBeginning);
    for (std::string_view rest = beginning.substr(0, beginning.rfind('\n')); !rest.empty();) {
        const std::string_view line = trimmed(takeUntil('\n', rest));
        const bool hasBorders = line.starts_with('|') && line.ends_with('|');
        if (line.find('|') != line.npos && !hasBorders && !isRule(line)) {
            return false;
        }
    }
    return true;
}

/// Returns a line without the commands of a table in LaTeX; empty for a line of any format that only separates rows,
/// and for the beginning and end of an environment.
std::string_view withoutBorders(std::string_view line)
{
    std::string_view text = trimmed(line);
    const auto begins = [text](std::string_view border) { return text.starts_with(border); };
    if (isRule(text) || begins("\\begin{") || begins("\\end{")) {
        return {};
    }
    for (const std::string_view rule : {"\\toprule", "\\midrule", "\\bottomrule", "\\hline"}) {
        text.remove_prefix(text.starts_with(rule) ? rule.size() : 0);
    }
    text = text.substr(0, text.rfind("\\\\"));
    return text.size() < trimmed(line).size() ? trimmed(text) : line;
}

/// Returns whether a line is the common factor that MATLAB and Octave print above a matrix: "1.0e+03 *".
bool isCommonFactor(std::string_view line)
{
    const std::string_view text = trimmed(line);
    return text.ends_with('*') && text.find('e') != text.npos && looksNumeric(trimmed(text.substr(0, text.size() - 1)));
}

/// Returns a line of a bordered table without the bars at both ends.
std::string_view withoutBars(std::string_view line)
{
    const std::string_view text = trimmed(line);
    const bool hasBars = text.size() > 1 && text.starts_with('|') && text.ends_with('|');
    return hasBars ? trimmed(text.substr(1, text.size() - 2)) : line;
}

/// Returns whether every closing bracket in a text has an opening one before it.
bool areBracketsOpened(std::string_view text)
{
    int depth = 0;
    return std::ranges::all_of(text, [&depth](char c) {
        const bool opens = c == '[' || c == '(' || c == '{';
        const bool closes = c == ']' || c == ')' || c == '}';
        depth += (opens ? 1 : 0) - (closes ? 1 : 0);
        return depth >= 0;
    });
}

/// Returns a line without the quotation marks around several cells, as in "0.1,85".
std::string_view withoutQuotes(std::string_view line)
{
    const std::string_view text = trimmed(line);
    const bool isQuoted = text.size() > 2 && text[0] == '"' && text.find('"', 1) == text.size() - 1;
    return isQuoted && text.find_first_of(kDelimiters) != text.npos ? text.substr(1, text.size() - 2) : line;
}

/// Returns a row of a list or matrix in the source of a program without its brackets: "{0.1, 85}," and "('t', 'x'),",
/// or "A = [0.1, 85;", "0.1 85;" and "0.1, 85];" of MATLAB. Brackets enclose data or quoted names; in MATLAB, a
/// semicolon or bracket ends a row of data. A line of brackets alone becomes empty, any other line remains as it is.
std::string_view withoutBrackets(std::string_view line)
{
    constexpr std::string_view kAssignment = "= [";
    const std::size_t assignment = line.find(kAssignment);
    const std::string_view assigned =
        assignment != line.npos ? line.substr(assignment + kAssignment.size()) : std::string_view();
    const std::string_view text = trimmed(isData(assigned) ? assigned : line);
    const std::size_t begin = std::min(text.find_first_not_of("[({"), text.size());
    const std::size_t end = std::max(text.find_last_not_of(" ;,])}") + 1, begin);
    const std::string_view inner = trimmed(text.substr(begin, end - begin));
    if (inner.empty()) {
        return inner;
    }
    const std::string_view after = text.substr(end);
    const bool isEnclosed = begin > 0 && after.find_first_of("])}") != after.npos && areBracketsOpened(inner);
    const bool areNames = (inner[0] == '\'' || inner[0] == '"') && inner.back() == inner[0];
    const bool endsRow = after.find_first_of(";]") != after.npos && inner.find_first_of(";([{") == inner.npos;
    const bool isRow = isData(inner) ? isEnclosed || endsRow : isEnclosed && areNames;
    return isRow ? inner : line;
}

/// Returns a line of Arduino's serial monitor without the time of its receipt: "12:03:04.013 -> 0.01, 85".
std::string_view withoutTimeOfReceipt(std::string_view line)
{
    constexpr std::string_view kArrow = " -> ";
    const std::string_view before = trimmed(line.substr(0, line.find(kArrow)));
    const bool isTime = before.find(':') != before.npos && before.find_first_not_of("0123456789:.") == before.npos;
    return isTime && before.size() < line.size() ? line.substr(line.find(kArrow) + kArrow.size()) : line;
}

/// Returns whether a line begins a quotation at the beginning of a cell and does not close it. Quotation marks at other
/// places are the signs of inches or of seconds of arc.
bool endsInQuotation(std::string_view line)
{
    bool isOpen = false;
    bool mayOpen = true; // at the beginning of a cell, or behind a mark, which it doubles
    for (const char c : line) {
        const bool isMark = c == '"';
        isOpen = isMark ? !isOpen && mayOpen : isOpen;
        mayOpen = isMark || kDelimiters.find(c) != kDelimiters.npos || (mayOpen && isBlank(c));
    }
    return isOpen;
}

/// Returns where the first line of a text ends. Line ends in a quoted heading, as spreadsheets write them, belong to
/// the line.
std::size_t findLineEnd(std::string_view text)
{
    constexpr std::size_t kMaxContinuationSize = 200; // bytes of a quoted heading behind a line end inside it
    const std::size_t first = std::min(text.find('\n'), text.size());
    std::size_t end = first;
    while (endsInQuotation(text.substr(0, end))) {
        const std::size_t closing = text.substr(0, end + kMaxContinuationSize).find('"', end);
        if (closing == text.npos) {
            return first;
        }
        end = std::min(text.find('\n', closing), text.size());
    }
    return end;
}

/// Returns whether the text behind a number is a heading, so that the number only counts the headings: ". Time (s)",
/// ":time", but not ":30".
bool numbersHeading(std::string_view behind)
{
    const bool hasMark =
        behind.starts_with(". ") || ((behind.starts_with(')') || behind.starts_with(':')) && behind.size() > 1);
    return hasMark && !isDigit(trimmed(behind.substr(1))[0]);
}

} // namespace

std::vector<Line> splitLines(std::string_view text)
{
    const bool areBordered = isBordered(text);
    std::vector<Line> lines;
    std::size_t number = 0;
    while (!text.empty()) {
        const bool mayBeHeadings = lines.size() < kExaminedLines;
        const std::size_t end = mayBeHeadings ? findLineEnd(text) : std::min(text.find('\n'), text.size());
        std::string_view rest = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto lineEnds = mayBeHeadings ? std::ranges::count(rest, '\n') : 0; // in a quoted heading
        do { // for each line that ends with CR only
            ++number;
            const std::string_view printed = lineEnds > 0 ? std::exchange(rest, {}) : takeUntil('\r', rest);
            const std::string_view inner = withoutBorders(withoutTimeOfReceipt(printed));
            const std::string_view line = withoutBrackets(withoutQuotes(areBordered ? withoutBars(inner) : inner));
            if (line.size() > kMaxLineSize && lines.size() < kExaminedLines) {
                throw ReadError{.line = number, .fault = {ReadFault::Kind::LineTooLong}};
            }
            if (mayBeHeadings && isCommonFactor(line)) {
                throw ReadError{.line = number, .fault = {ReadFault::Kind::CommonFactor}};
            }
            if (trimmed(line).starts_with(kEndOfPreamble)) {
                lines.clear();
            } else if (line.find_first_not_of(" \t;,") != line.npos) {
                lines.push_back({number, isData(line) ? withoutRemark(line) : line});
            }
        } while (!rest.empty());
        number += static_cast<std::size_t>(lineEnds);
    }
    return lines;
}

bool isData(std::string_view line)
{
    constexpr std::size_t kMaxSigns = 3; // before the first digit: '"', '="' or "$", a sign and a decimal sign
    const std::string_view text = trimmed(line);
    const std::size_t digit = text.find_first_not_of("+-.,\"$=");
    if (digit == text.npos || !isDigit(text[digit]) || digit > kMaxSigns) {
        return false;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789", digit), text.size());
    return !numbersHeading(text.substr(end));
}

bool isRemark(std::string_view line)
{
    const std::string_view text = trimmed(line);
    return std::ranges::any_of(kRemarkMarks, [text](std::string_view mark) {
        return text.starts_with(mark) && beginsRemark(" ", mark, text.substr(mark.size()));
    });
}

std::string_view withoutCommentMark(std::string_view line)
{
    const std::string_view text = trimmed(line);
    for (const std::string_view mark : {"#", "%", "//", "!", "--", "*"}) {
        const std::size_t end = text.starts_with(mark) ? text.find_first_not_of(mark[0]) : text.npos;
        if (end != text.npos && !text.starts_with("% of ")) { // "% of cycle" is a heading
            return trimmed(text.substr(end));
        }
    }
    return line;
}

} // namespace slidercrank
