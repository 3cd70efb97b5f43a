// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Who gets a key that several could use, and the wheel. Space plays and pauses wherever the focus is, but where it is
// part of what somebody types, ticks a box or chooses from an open list; buttons are pressed with Enter. Arrows, Home
// and End belong to the control that has a use for them, and the key that copies to a text that is marked. The wheel
// turns only what has the focus: elsewhere it scrolls.

#include <QObject>

class QKeyEvent;
class QWidget;

namespace slidercrank
{

class KeyOwner : public QObject
{
    Q_OBJECT

public:
    explicit KeyOwner(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isHeld(const QKeyEvent &key) const;

    QWidget *m_window;
    quint64 m_spaceLetGo = 0; ///< when; of the window system's clock, ms
};

} // namespace slidercrank
