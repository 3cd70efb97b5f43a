// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of the window that are kept from one start of the program to the next: recent files, the theme, the
// layout, the units, what the drawing shows, and the playback speed. The scene is not part of it.

#include "ui/text/notation.h"
#include "ui/text/theme.h"

#include <QString>
#include <QStringList>

class QMainWindow;

namespace slidercrank
{

/// Returns the files opened last, the latest first. Each entry is one scene, or the files of one reference.
QList<QStringList> recentFiles();
void rememberFiles(const QStringList &paths);

/// Returns the folder of the file opened last, or the user's documents folder if there is none. If that folder does not
/// exist, returns the home folder.
QString recentFolder();

/// Return and store the notation and the units that the user chose.
Notation chosenNotation();
void rememberNotation(const Notation &notation);
bool isNotationChosen(); ///< false as long as the user has chosen none: chosenNotation() is then the default

Theme chosenTheme();
void rememberTheme(Theme theme);

/// Save and restore the size and the splitters of the window, the parts of the drawing that are shown, the options of
/// the motion table, units and playback speed.
void saveLayout(const QMainWindow &window);
void restoreLayout(QMainWindow &window);

} // namespace slidercrank
