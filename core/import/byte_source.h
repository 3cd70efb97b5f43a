// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a file's bytes come from.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace slidercrank
{

/// Bytes that are asked for in pieces, by several threads at once.
struct ByteSource {
    std::size_t size = 0;

    /// Fills `room` from that offset on; false where there is not so much, or it cannot be had.
    std::function<bool(std::size_t offset, std::span<char> room)> read;

    /// How many a thread takes at a time: any number gives the same. These stay in the processor's cache.
    std::size_t piece = std::size_t{1} << 18U;

    std::string name{};       ///< of the file; empty: none
    bool isBeginning = false; ///< of a file that goes on
};

/// Bytes in memory, which outlive it.
inline ByteSource sourceOf(std::string_view bytes)
{
    const auto copy = [bytes](std::size_t offset, std::span<char> room) {
        const bool isThere = offset <= bytes.size() && room.size() <= bytes.size() - offset;
        std::ranges::copy(bytes.substr(std::min(offset, bytes.size()), isThere ? room.size() : 0), room.begin());
        return isThere;
    };
    return {bytes.size(), copy};
}

} // namespace slidercrank
