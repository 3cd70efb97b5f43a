// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

namespace slidercrank
{

/// Returns a copy of `whole` whose `member` is `part`.
template <typename Whole, typename Part>
Whole with(Whole whole, Part Whole::*member, const std::type_identity_t<Part> &part)
{
    whole.*member = part;
    return whole;
}

} // namespace slidercrank
