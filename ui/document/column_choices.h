// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a person once said of the columns of a file, kept in the settings for every file with the same headings; where a
// file has no headings, for that file alone. Of files that are joined, for files of the same names and headings.

#include "core/import/file_layout.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace slidercrank
{

/// Empty: nobody said anything.
std::vector<ColumnChoice> rememberedChoices(const FileLayout &layout, const QStringList &paths);

/// No choices: forgets.
void rememberChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices);

} // namespace slidercrank
