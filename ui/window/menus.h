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
    void addFileMenu();
    void addExportMenu(QMenu *menu);
    void addEditMenu();
    void addViewMenu();
    void addNotationMenu(QMenu *menu);
    void addHelpMenu();

    void fillRecent(QMenu *menu);
    void showAbout();

    MainWindow &m_window;
    const Views &m_views;
};

} // namespace slidercrank
