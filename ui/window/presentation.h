// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Presentation mode: the mechanism and the plots fill the screen, with a large font and wide lines. The tabs are
// folded. F11 or Escape ends the mode.

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

    void setOn(bool on);
    bool isOn() const { return m_isOn; }

    /// Fills the window with the mechanism, or shows the plots again.
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
    bool m_wasFoldedBefore = false;  ///< whether the tabs were folded before the mode began
    QList<int> m_columnWidthsBefore; ///< px, before the mode began
};

} // namespace slidercrank
