// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks for files to open.

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace slidercrank
{

struct OpenRequest {
    QString title;
    QString folder;  ///< where the dialog begins
    QString filters; ///< "Tables (*.csv *.txt);;All files (*)"
    std::function<void(const QStringList &paths)> open;
};

/// Opens the dialog as a child of `parent` and returns at once. request.open is called when files have been chosen.
/// Defined in native_dialogs.cpp or, for a browser, in page_dialogs.cpp.
void chooseFilesToOpen(QWidget *parent, const OpenRequest &request);

} // namespace slidercrank
