// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for the name of a file to write. A missing suffix is that of the chosen filter; the folder is remembered.

#include <QStandardPaths>
#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace slidercrank
{

struct SaveRequest {
    QString title;
    QStringList filters; ///< "SVG drawings (*.svg)", with one suffix each, or "(*)": any name
    QString folder;
    QString name; ///< proposed
    std::function<void(const QString &path, const QString &filter)> save;
};

/// Does not wait: request.save is called when the person has chosen. The dialog belongs to `parent`.
void chooseFileToSave(QWidget *parent, const SaveRequest &request);

/// The path, with the suffix of `filter` if it has none of those of `filters`.
QString completedName(const QString &path, const QString &filter, const QStringList &filters);

/// For what can be drawn.
QStringList figureFilters();

/// Where a file was saved last, if that folder still exists.
QString lastFolder(QStandardPaths::StandardLocation otherwise);

} // namespace slidercrank
