// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stores the meanings that the user chose for the columns of a file, in the settings of the program. They apply to
// every file with the same headings and units; to joined files only if their names are the same, too; and if there are
// no headings, only to files with the same paths.

#include "core/import/file_layout.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace slidercrank
{

/// Returns the saved choices for files of this layout; empty if there are none.
std::vector<ColumnChoice> savedChoices(const FileLayout &layout, const QStringList &paths);

/// Saves the choices for files of this layout. They replace the choices that were saved for them before.
void saveChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices);

} // namespace slidercrank
