// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for the name of a file to write, for all that is written: a suffix left out is that of the chosen filter, one
// that would lie is refused, an older file is asked about, and the folder is remembered from one time to the next.

#include <QStandardPaths>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

class QWidget;

namespace slidercrank
{

struct SaveRequest {
    QString title;
    QStringList filters; ///< "SVG drawings (*.svg)", of one suffix each
    QString folder;
    QString name; ///< that is proposed
    std::function<void(const QString &path, const QString &filter)> save;

    QString filter = {}; ///< that is chosen; empty: the first

    /// Whether something older would be lost; empty: a file of that name.
    std::function<bool(const QString &path)> replaces = {};
};

/// Does not wait: request.save is called when the person has chosen. `parent`: what it belongs to and goes with.
void chooseFileToSave(QWidget *parent, const SaveRequest &request);

/// As it is to be called, with the suffix of `filter` where it has none; none where it ends in what other files do.
std::optional<QString> completedName(const QString &path, const QString &filter, const QStringList &filters);

/// Of what can be drawn.
QStringList figureFilters();

/// The one that was saved to last, as long as it is there.
QString lastFolder(QStandardPaths::StandardLocation otherwise);

} // namespace slidercrank
