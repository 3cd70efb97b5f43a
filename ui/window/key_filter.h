// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Handles keys and the mouse wheel where the window behaves differently from Qt. Space, Home and End are shortcuts of
// the playback unless a text is being edited. Left and Right go to a control that uses them. Enter presses a button or
// opens a list. The wheel changes only the control with the focus; elsewhere it scrolls.

#include <QObject>

namespace slidercrank
{

class KeyFilter : public QObject
{
    Q_OBJECT

public:
    explicit KeyFilter(QObject *parent);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace slidercrank
