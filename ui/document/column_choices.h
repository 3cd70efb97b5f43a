// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stores the meanings that the user chose for the columns of a file, in the settings of the program. They apply to
// every file with the same headings; if the file has no headings, to the same path; and if several files are joined, to
// files with the same names and headings.

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
