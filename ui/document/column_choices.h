// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The columns that a person chose, remembered in the settings for every file with the same headings, and for a file
// without headings by its path; for files that are joined, by their names and headings.

#include "core/import/file_layout.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace slidercrank
{

/// Empty if nothing was chosen.
std::vector<ColumnChoice> rememberedChoices(const FileLayout &layout, const QStringList &paths);

/// Without choices, removes those that are remembered.
void rememberChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices);

} // namespace slidercrank
