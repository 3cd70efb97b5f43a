// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/listed_headings.h"

#include "core/import/crank_angles.h"
#include "core/import/heading.h"

#include <algorithm>
#include <string>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

/// Returns the text behind the number of a column in a line that describes the column: "time [s]" of "# Column 1: time
/// [s]". Empty if the first number in the line is a different one.
std::string_view textBehindNumber(std::string_view line, std::size_t number)
{
    const std::string digits = std::to_string(number);
    const std::string_view rest = line.substr(std::min(line.find_first_of("0123456789"), line.size()));
    const std::size_t text = rest.find_first_not_of(" \t:=.)]-", digits.size());
    const bool isNumbered = rest.starts_with(digits) && text != rest.npos && !isDigit(rest[digits.size()]);
    return isNumbered ? trimmed(rest.substr(text)) : std::string_view();
}

/// Returns the headings in lines that have the numbers of the columns; `firstNumber` is that of the first one. Returns
/// nullopt if a line has a different number, or if no name is known.
std::optional<HeadingCandidate> readNumberedList(Lines lines, std::size_t firstNumber)
{
    Cells names;
    for (const Line &line : lines) {
        names.push_back(textBehindNumber(line.text, firstNumber + names.size()));
    }
    if (std::ranges::count(names, std::string_view()) > 0) {
        return std::nullopt;
    }
    HeadingCandidate list = countNames(names, ',');
    return list.known() > 0 ? std::optional(std::move(list)) : std::nullopt;
}

/// Returns the headings in lines without numbers. Returns nullopt if any name is unknown, or if the first one is
/// neither the time nor the crank angle.
std::optional<HeadingCandidate> readBulletedList(Lines lines)
{
    Cells names;
    for (const Line &line : lines) {
        const std::string_view text = withoutCommentMark(line.text);
        names.push_back(text.substr(std::min(text.find_first_not_of("- "), text.size())));
    }
    const NameMeaning first = parseHeading(names.front()).meaning;
    if (first.kind != Kind::Time && !(first.kind >= Kind::Words && first.channel == kCrankAngle)) {
        return std::nullopt;
    }
    HeadingCandidate list = countNames(names, ',');
    return list.known() == lines.size() ? std::optional(std::move(list)) : std::nullopt;
}

/// Returns the headings in lines that are numbered from 0 or 1, or else in lines without numbers; nullopt if the lines
/// are neither.
std::optional<HeadingCandidate> readList(Lines lines)
{
    for (const std::size_t firstNumber : {0U, 1U}) {
        if (std::optional<HeadingCandidate> list = readNumberedList(lines, firstNumber)) {
            return list;
        }
    }
    return readBulletedList(lines);
}

} // namespace

std::optional<HeadingCandidate> findListedHeadings(Lines above, const NumberRow &row)
{
    const std::size_t size = row.cells.size();
    for (std::size_t end = above.size(); end >= size; --end) {
        if (end < above.size()) {
            const HeadingCandidate below = readNames(above[end].text, row);
            const bool areMostlyNames = 2 * below.known() > below.cells.size();
            if (row.hasCountOf(below.cells) && areMostlyNames) {
                return std::nullopt;
            }
        }
        if (std::optional<HeadingCandidate> list = readList(above.subspan(end - size, size))) {
            list->line = end - 1;
            return list;
        }
    }
    return std::nullopt;
}

} // namespace slidercrank
