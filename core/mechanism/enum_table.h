// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables with one row for each enumerator of an enumeration. A row is a struct whose member `key` is the enumerator,
// and whose other members describe the enumerator: its name in files, its unit, its sentence.

#include <cstddef>
#include <string_view>

namespace slidercrank
{

/// Returns whether the table has one row for each enumerator from 0 to `last`, in their order. Meant for static_assert.
template <typename Row, std::size_t count, typename Enum>
consteval bool hasRowForEachUpTo(const Row (&rows)[count], Enum last)
{
    for (std::size_t i = 0; i < count; ++i) {
        if (rows[i].key != static_cast<Enum>(i)) {
            return false;
        }
    }
    return count == static_cast<std::size_t>(last) + 1;
}

/// Returns whether the value is one of the enumerators. In the name of the function, GCC and Clang write an enumerator
/// as "Order::Position", and any other value as a cast: "(Order)3".
template <auto value>
consteval bool isEnumerator()
{
    const std::string_view function = __PRETTY_FUNCTION__; // "… isEnumerator() [with auto value = Order::Position]"
    const std::size_t endOfCast = function.rfind(')');
    const char afterCast = function[endOfCast + 1];
    return afterCast < '0' || afterCast > '9';
}

/// Returns the number of the enumerators 0, 1, … `last`. Does not compile unless `last` is the last one.
template <auto last>
consteval std::size_t enumeratorCount()
{
    constexpr auto count = static_cast<std::size_t>(last) + 1;
    static_assert(isEnumerator<last>() && !isEnumerator<static_cast<decltype(last)>(count)>());
    return count;
}

/// Returns whether the table has one row for each enumerator, in their order, so that a new enumerator does not compile
/// without a row. `last`: the last enumerator. Meant for static_assert.
template <typename Row, std::size_t count, typename Enum>
consteval bool isCompleteTable(const Row (&rows)[count], Enum last)
{
    return hasRowForEachUpTo(rows, last) && !isEnumerator<static_cast<Enum>(count)>();
}

/// Returns the row of an enumerator in a complete table.
template <typename Row, std::size_t count, typename Enum>
constexpr const Row &rowOf(const Row (&rows)[count], Enum key)
{
    return rows[static_cast<std::size_t>(key)];
}

} // namespace slidercrank
