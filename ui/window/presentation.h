// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// In front of a class: mechanism and plots fill the screen, with letters and lines for the last row, and θ₂ and θ³ are
// on the drawing; under the mechanism stays what moves it and one parameter at a time. Escape leaves.

#include <QList>
#include <QObject>

class QMainWindow;

namespace slidercrank
{

struct Rooms;

class Presentation : public QObject
{
    Q_OBJECT

public:
    Presentation(const Rooms &rooms, QMainWindow *window);

    bool isOn() const { return m_isOn; }
    void setOn(bool on);

    /// The mechanism fills all the room there is, or shares it again.
    void setAlone(bool alone);

signals:
    void changed(bool on);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    const Rooms &m_rooms;
    QMainWindow *m_window;
    bool m_isOn = false;
    bool m_hadAngles = false;
    QList<int> m_widths; ///< of the columns before, px
};

} // namespace slidercrank
