// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a person has set the controls of a window that its session knows nothing of: units, speed, what is ticked in the
// menus, how wide the panes are. Taken from a window and given to the one made in its place.

#include <QByteArray>
#include <QHash>
#include <QList>
#include <QString>

class QMainWindow;

namespace slidercrank
{

/// By the controls' object names; of the menus by their order.
struct ControlStates {
    QHash<QString, int> choices;
    QHash<QString, bool> checkedButtons;
    QHash<QString, QByteArray> splitters;
    QList<bool> checkedActions;
    QString focus;
};

ControlStates controlStatesOf(const QMainWindow &window);

/// As if the person had chosen them again.
void setControlStates(QMainWindow &window, const ControlStates &states);

} // namespace slidercrank
