// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The menu bar: the actions of the window and their keyboard shortcuts.

#include <QMenuBar>

namespace slidercrank
{

class MainWindow;
struct Views;

class Menus : public QMenuBar
{
    Q_OBJECT

public:
    Menus(MainWindow &window, const Views &views);

private:
    void addFile();
    void addExport(QMenu *menu);
    void addEdit();
    void addView();
    void addNotation(QMenu *menu);
    void addHelp();

    void fillRecent(QMenu *menu);
    void showAbout();

    MainWindow &m_window;
    const Views &m_views;
};

} // namespace slidercrank
