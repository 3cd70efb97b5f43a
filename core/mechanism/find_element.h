// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace slidercrank
{

/// Returns a pointer to the first element that satisfies the condition, or null.
template <class Container, class Condition>
auto findElement(Container &container, const Condition &condition)
{
    const auto found = std::ranges::find_if(container, condition);
    return found == container.end() ? nullptr : &*found;
}

} // namespace slidercrank
