// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which column a person means by a heading.

#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <span>
#include <variant>
#include <vector>

namespace slidercrank
{

/// The choices of ReadOptions, all by number: what is said of a heading holds over what was said of its number.
std::variant<std::vector<ColumnChoice>, ReadFault> choicesByNumber(const ReadOptions &options,
                                                                   std::span<const Heading> headings);

} // namespace slidercrank
