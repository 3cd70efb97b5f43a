// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables with one row for each enumerator of an enumeration. A row is a struct whose member `key` is the enumerator,
// and whose other members describe the enumerator: its name in files, its unit, its sentence.

#include <cstddef>

namespace slidercrank
{

/// Returns whether the table has one row for each enumerator from 0 to `last`, in their order. Meant for static_assert.
template <typename Row, std::size_t count, typename Enum>
consteval bool isCompleteTable(const Row (&rows)[count], Enum last)
{
    for (std::size_t i = 0; i < count; ++i) {
        if (rows[i].key != static_cast<Enum>(i)) {
            return false;
        }
    }
    return count == static_cast<std::size_t>(last) + 1;
}

/// Returns the row of an enumerator in a complete table.
template <typename Row, std::size_t count, typename Enum>
constexpr const Row &rowOf(const Row (&rows)[count], Enum key)
{
    return rows[static_cast<std::size_t>(key)];
}

} // namespace slidercrank
