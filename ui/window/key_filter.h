// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keys and wheel that Qt would handle differently. Space, Home and End are shortcuts of the playback, unless a text is
// edited; the arrows to the side belong to the control that has a use for them; Enter presses a button and opens a
// list. The wheel changes only what has the focus: elsewhere it scrolls.

#include <QObject>

class QWidget;

namespace slidercrank
{

class KeyFilter : public QObject
{
    Q_OBJECT

public:
    explicit KeyFilter(QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *m_window;
};

} // namespace slidercrank
