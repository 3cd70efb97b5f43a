// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Walks over the cells of a table of text, in UTF-8. In the header, for the compiler to see through: a large file is
// read cell by cell.

#include "core/import/plain_number.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace slidercrank
{

inline bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

inline bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

inline std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// One cell as it stands in the file.
struct Cell {
    std::string_view text;  ///< without the spaces and quotation marks around it; doubled marks are still doubled
    bool wellFormed = true; ///< false: a quotation mark is not closed, or something follows the closing one
};

/// Walks over the cells of each line. Lines end with LF, CR LF or CR; a cell never spans lines. Where a space separates
/// the cells, any number of spaces and tabs does.
class CellScanner
{
public:
    CellScanner(std::string_view bytes, char delimiter, std::size_t firstLine)
        : m_next(bytes.data())
        , m_end(bytes.data() + bytes.size())
        , m_delimiter(delimiter)
        , m_line(firstLine)
    {
        for (const char c : {delimiter, delimiter == ' ' ? '\t' : delimiter, '\n', '\r'}) {
            m_stops[static_cast<unsigned char>(c)] = true;
        }
    }

    bool atEnd() const { return m_next == m_end; }
    std::size_t line() const { return m_line; }
    const char *position() const { return m_next; }

    bool atLineEnd() const { return m_next == m_end || isLineEnd(*m_next); }

    /// To the beginning of the line where the scanner is.
    void backTo(const char *lineBegin)
    {
        m_next = lineBegin;
        m_hasCell = true;
    }

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
    bool plainNumber(PlainNumber &number)
    {
        const char *begin = m_next;
        while (begin != m_end && *begin == ' ') {
            ++begin;
        }
        const char *const last = scanPlainNumber(begin, m_end, number);
        if (!last || !(last == m_end || isStop(*last))) {
            return false;
        }
        m_next = last;
        skipDelimiter();
        return true;
    }

    /// Over the cell here; false, and nowhere, where it is quoted.
    bool skipPlainCell()
    {
        skipBlanks();
        if (m_next != m_end && *m_next == '"') {
            return false;
        }
        skipToStop();
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
        if (m_delimiter == ' ') {
            skipRun();
        }
    }

    void skipRun()
    {
        while (m_next != m_end && isBlank(*m_next)) {
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
        if (m_delimiter == ' ') {
            const char *const behindCell = m_next - (m_hasCell ? 1 : 0);
            skipRun();
            m_hasCell = m_next != behindCell && !atLineEnd();
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
            if (m_delimiter != ' ') {
                skipBlanks();
            }
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

} // namespace slidercrank
