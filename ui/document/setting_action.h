// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/with.h"

#include <QAction>

namespace slidercrank
{

/// Returns a checkable action for a member of the settings of a view. Triggering it sets the member to `on`, or to
/// `off` if the action was checked. The view has settings(), setSettings() and the signal settingsChanged().
template <typename View, typename Settings, typename Value>
QAction *makeSettingAction(View *view, const QString &text, Value Settings::*member, Value on, Value off)
{
    auto *action = new QAction(text, view);
    action->setCheckable(true);
    action->setChecked(view->settings().*member == on);
    QObject::connect(action, &QAction::triggered, view,
                     [=](bool checked) { view->setSettings(with(view->settings(), member, checked ? on : off)); });
    QObject::connect(view, &View::settingsChanged, action,
                     [=](const Settings &settings) { action->setChecked(settings.*member == on); });
    return action;
}

/// Returns a checkable action that switches a member of the settings of a view on and off.
template <typename View, typename Settings>
QAction *makeSwitchAction(View *view, const QString &text, bool Settings::*member)
{
    constexpr bool on = true;
    return makeSettingAction(view, text, member, on, !on);
}

} // namespace slidercrank
