// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The menus of the window: what a person can do, and the keys for it.

#include <QMenuBar>

namespace slidercrank
{

class MainWindow;
struct Rooms;

class Menus : public QMenuBar
{
    Q_OBJECT

public:
    Menus(MainWindow &window, const Rooms &rooms);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void addFile();
    void addEdit();
    void addView();
    void addPlayback();
    void addHelp();

    void fillRecent(QMenu *menu);
    void showAbout();

    MainWindow &m_window;
    const Rooms &m_rooms;
};

} // namespace slidercrank
