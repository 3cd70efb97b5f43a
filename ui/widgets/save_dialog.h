// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for the name of a file to write. A missing suffix is taken from the chosen filter, and the folder is stored for
// the next time.

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace slidercrank
{

struct SaveRequest {
    QString title;
    QStringList filters; ///< "SVG drawings (*.svg)", with one suffix each, or "(*)" for any name
    QString name;        ///< default name, without the suffix
    std::function<void(const QString &path, const QString &filter)> save;
    QString folder = {}; ///< if empty, the folder in which a file was last saved
};

/// Opens the dialog as a child of `parent` and returns at once. request.save is called when a name has been chosen.
/// Defined in native_dialogs.cpp or, for a browser, in page_dialogs.cpp.
void chooseFileToSave(QWidget *parent, const SaveRequest &request);

/// Returns the path, with the suffix of `filter` appended if the path has no suffix of `filters`.
QString completedName(const QString &path, const QString &filter, const QStringList &filters);

/// Returns "svg" for "SVG drawings (*.svg)", and an empty text for "(*)".
QString suffixOf(const QString &filter);

/// Returns the filters for image files.
QStringList figureFilters();

} // namespace slidercrank
