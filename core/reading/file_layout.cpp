// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/file_layout.h"

#include <algorithm>

namespace slidercrank
{

bool FileLayout::isGuessed() const
{
    return std::any_of(columns.begin(), columns.end(), [](const FileColumn &column) { return isGuess(column.reason); });
}

} // namespace slidercrank
