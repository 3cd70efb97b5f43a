// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a person may read about the program, in a window beside it: the keys and the mouse, the formulas in short.

#include <QDialog>
#include <QString>

class QMenuBar;

namespace slidercrank
{

/// Every action of the menus that has a key, as they are now, and what the mouse and the keys do in the rooms. HTML.
QString shortcutsText(const QMenuBar &menus);

/// What the program is for and what it computes. HTML.
QString formulasText();

/// Deletes itself when it is closed.
class HelpPage : public QDialog
{
    Q_OBJECT

public:
    HelpPage(const QString &title, const QString &html, QWidget *window);
};

} // namespace slidercrank
