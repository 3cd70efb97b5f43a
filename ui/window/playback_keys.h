// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whose the playback keys are (Space, arrows, Home, End): the control's that has the focus where it has a use for them,
// else the menu's.

#include <QObject>

namespace slidercrank
{

/// To be installed in the application.
class PlaybackKeys : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace slidercrank
