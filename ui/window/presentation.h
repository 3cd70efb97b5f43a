// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Presentation mode: mechanism and plots fill the screen, with letters and lines to be read from the last row, θ₂ and
// θ³ on the drawing, the playback and one parameter at a time below it. Escape leaves.

#include <QList>
#include <QObject>

class QMainWindow;

namespace slidercrank
{

class MessageBar;
struct Views;

class Presentation : public QObject
{
    Q_OBJECT

public:
    Presentation(const Views &views, MessageBar *messages, QMainWindow *window);

    bool isOn() const { return m_isOn; }
    void setOn(bool on);

    /// The mechanism alone fills the window.
    void setMechanismAlone(bool alone);

signals:
    void changed(bool on);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    const Views &m_views;
    MessageBar *m_messages;
    QMainWindow *m_window;
    bool m_isOn = false;
    bool m_hadAngles = false;
    QList<int> m_widths; ///< of the columns before, px
};

} // namespace slidercrank
