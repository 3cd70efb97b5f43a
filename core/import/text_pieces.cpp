// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/text_pieces.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

/// The first LF or CR from that offset on; the size where there is none.
std::size_t findLineEnd(std::string_view bytes, std::size_t at, TextEncoding encoding)
{
    const std::size_t unit = codeUnitSize(encoding);
    if (unit == 1) {
        return std::min(bytes.find_first_of("\r\n", at), bytes.size());
    }
    const std::size_t low = encoding == TextEncoding::Utf16LittleEndian ? 0 : 1;
    for (; at + unit <= bytes.size(); at += unit) {
        if ((bytes[at + low] == '\n' || bytes[at + low] == '\r') && bytes[at + 1 - low] == '\0') {
            return at;
        }
    }
    return bytes.size();
}

/// Behind the first line end from that offset on, LF, CR LF or CR; none where it is still to come.
std::optional<std::size_t> behindLine(std::string_view bytes, std::size_t at, TextEncoding encoding, bool isWhole)
{
    const std::size_t unit = codeUnitSize(encoding);
    const std::size_t low = encoding == TextEncoding::Utf16BigEndian ? 1 : 0;
    const std::size_t end = findLineEnd(bytes, at, encoding);
    std::size_t next = end + unit;
    if (end < bytes.size() && bytes[end + low] == '\r') {
        if (next < bytes.size()) {
            next = findLineEnd(bytes, next, encoding) == next && bytes[next + low] == '\n' ? next + unit : next;
        } else if (!isWhole) {
            return std::nullopt; // LF may follow
        }
    }
    if (end == bytes.size()) {
        return isWhole ? std::optional(end) : std::nullopt;
    }
    return next;
}

} // namespace

TextPieces::TextPieces(const ByteSource &source, TextEncoding encoding, std::size_t begin)
    : m_source(source)
    , m_encoding(encoding)
    , m_unit(codeUnitSize(encoding))
    , m_begin(std::min(begin, source.size))
    , m_end(m_begin + aligned(source.size - m_begin))
    , m_piece(std::max(aligned(source.piece), m_unit))
{
}

PieceLines TextPieces::lines(std::size_t piece, PieceBuffer &buffer) const
{
    const std::size_t from = m_begin + piece * m_piece;
    return linesBeginningIn(from, std::min(from + m_piece, m_end), buffer);
}

std::string TextPieces::sample(std::size_t count) const
{
    constexpr std::size_t kLookedAt = std::size_t{1} << 12U; // bytes: most lines are shorter
    const std::size_t step = std::max(aligned(size() / count), m_unit);
    std::string text;
    PieceBuffer buffer;
    for (std::size_t i = 0; i < count && i * step < size(); ++i) {
        const std::size_t from = m_begin + i * step;
        const std::string_view lines =
            linesBeginningIn(from, std::min(from + std::min(step, kLookedAt), m_end), buffer).text;
        text += lines.substr(0, lines.find_first_of("\r\n"));
        text += '\n';
    }
    return text;
}

std::string_view TextPieces::inUtf8(std::string_view bytes, PieceBuffer &buffer) const
{
    const bool isUtf8 = m_encoding == TextEncoding::Utf8 ||
                        (m_encoding == TextEncoding::Windows1252 && findBeyondAscii(bytes, 0) == bytes.size());
    if (isUtf8) {
        return bytes;
    }
    buffer.text = toUtf8(bytes, m_encoding);
    return buffer.text;
}

PieceLines TextPieces::linesBeginningIn(std::size_t from, std::size_t to, PieceBuffer &buffer) const
{
    constexpr std::size_t kMostLines = std::size_t{1} << 12U; // bytes: what is usually enough for the last of them
    const std::size_t before = from > m_begin ? m_unit : 0;   // that tells whether a line begins right here
    const std::size_t start = from - before;
    const std::size_t all = m_end - start;
    const std::size_t last = to - start - m_unit;
    std::string_view bytes;
    std::optional<std::size_t> end;
    for (std::size_t length = std::min(last + m_unit + kMostLines, all);; length = std::min(2 * length, all)) {
        const std::size_t known = bytes.size();
        buffer.bytes.resize(std::max(buffer.bytes.size(), length));
        if (!m_source.read(start + known, std::span(buffer.bytes).subspan(known, length - known))) {
            return {{}, ReadFault::Kind::Unreadable};
        }
        bytes = {buffer.bytes.data(), length};
        end = behindLine(bytes, known > last ? known - m_unit : last, m_encoding, length == all);
        if (end || length - last > kLongestLine) {
            break;
        }
    }
    const bool isWhole = bytes.size() == all;
    std::size_t lineBegin = before > 0 ? behindLine(bytes, 0, m_encoding, isWhole).value_or(bytes.size()) : 0;
    if (lineBegin > last) {
        return {}; // whoever has the beginning of this line sees to it
    }
    const std::size_t begin = lineBegin;
    PieceLines found;
    while (!found.fault && lineBegin <= last && (!end || *end - begin > kLongestLine)) {
        const std::optional<std::size_t> next = behindLine(bytes, lineBegin, m_encoding, isWhole);
        if (!next || *next - lineBegin > kLongestLine) {
            const std::string_view line = inUtf8(bytes.substr(lineBegin, kLongestLine), buffer);
            found.fault = line.find('\0') == line.npos ? ReadFault::Kind::LineTooLong : ReadFault::Kind::NotText;
            end = lineBegin;
        }
        lineBegin = next.value_or(lineBegin);
    }
    found.text = inUtf8(bytes.substr(begin, *end - begin), buffer);
    if (const std::size_t zero = found.text.find('\0'); zero != found.text.npos) {
        const std::size_t lineEnd = found.text.find_last_of("\r\n", zero);
        found = {found.text.substr(0, lineEnd == found.text.npos ? 0 : lineEnd + 1), ReadFault::Kind::NotText};
    }
    return found;
}

} // namespace slidercrank
