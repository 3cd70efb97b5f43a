// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The lines of a text of any size, a piece at a time: each line is in one of them, whole.

#include "core/import/byte_source.h"
#include "core/import/read_fault.h"
#include "core/import/text_encoding.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// Bytes with their line end. A table has none that is longer.
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

/// Some lines, and why the line behind them cannot be had: NotText, LineTooLong or Unreadable.
struct PieceLines {
    std::string_view text; ///< in UTF-8
    std::optional<ReadFault::Kind> fault{};
};

/// What a thread reads into, again and again.
struct PieceBuffer {
    std::vector<char> bytes;
    std::string text; ///< where the bytes are not what is returned
};

class TextPieces
{
public:
    /// The text begins at offset `begin`.
    TextPieces(const ByteSource &source, TextEncoding encoding, std::size_t begin);

    std::size_t size() const { return m_end - m_begin; }
    std::size_t count() const { return (size() + m_piece - 1) / m_piece; }

    /// The lines that begin in that piece.
    PieceLines lines(std::size_t piece, PieceBuffer &buffer) const;

    /// Up to so many lines, from all over the text.
    std::string sample(std::size_t count) const;

private:
    PieceLines linesBeginningIn(std::size_t from, std::size_t to, PieceBuffer &buffer) const;
    std::string_view inUtf8(std::string_view bytes, PieceBuffer &buffer) const;
    std::size_t aligned(std::size_t length) const { return length / m_unit * m_unit; }

    const ByteSource &m_source;
    TextEncoding m_encoding;
    std::size_t m_unit;
    std::size_t m_begin;
    std::size_t m_end;
    std::size_t m_piece;
};

} // namespace slidercrank
