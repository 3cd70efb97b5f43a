// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/control_states.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSplitter>

#include <functional>

namespace slidercrank
{

namespace
{

void forEachCheckable(const QList<QAction *> &actions, const std::function<void(QAction *)> &visit)
{
    for (QAction *action : actions) {
        if (const QMenu *menu = action->menu()) {
            forEachCheckable(menu->actions(), visit);
        } else if (action->isCheckable()) {
            visit(action);
        }
    }
}

} // namespace

ControlStates controlStatesOf(const QMainWindow &window)
{
    ControlStates states;
    for (const QComboBox *box : window.findChildren<QComboBox *>()) {
        states.choices[box->objectName()] = box->currentIndex();
    }
    for (const QAbstractButton *button : window.findChildren<QAbstractButton *>()) {
        if (button->isCheckable()) {
            states.checkedButtons[button->objectName()] = button->isChecked();
        }
    }
    for (const QSplitter *splitter : window.findChildren<QSplitter *>()) {
        states.splitters[splitter->objectName()] = splitter->saveState();
    }
    forEachCheckable(window.menuBar()->actions(),
                     [&](const QAction *action) { states.checkedActions += action->isChecked(); });
    if (const QWidget *focus = window.focusWidget()) {
        states.focus = focus->objectName();
    }
    return states;
}

void setControlStates(QMainWindow &window, const ControlStates &states)
{
    for (QComboBox *box : window.findChildren<QComboBox *>()) {
        const int index = states.choices.value(box->objectName(), -1);
        if (index >= 0 && index < box->count() && index != box->currentIndex()) {
            box->setCurrentIndex(index);
            emit box->activated(index);
        }
    }
    for (QAbstractButton *button : window.findChildren<QAbstractButton *>()) {
        const auto checked = states.checkedButtons.find(button->objectName());
        const bool differs =
            button->isCheckable() && checked != states.checkedButtons.end() && *checked != button->isChecked();
        if (differs && (*checked || !button->autoExclusive())) { // of an exclusive group only what is chosen
            button->click();
        }
    }
    for (QSplitter *splitter : window.findChildren<QSplitter *>()) {
        splitter->restoreState(states.splitters.value(splitter->objectName()));
    }
    int at = 0;
    forEachCheckable(window.menuBar()->actions(), [&](QAction *action) {
        const bool checked = states.checkedActions.value(at++, action->isChecked());
        if (checked != action->isChecked() && (checked || !action->actionGroup())) {
            action->trigger();
        }
    });
    if (!states.focus.isEmpty()) {
        if (auto *focus = window.findChild<QWidget *>(states.focus)) {
            focus->setFocus();
        }
    }
}

} // namespace slidercrank
