// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace slidercrank
{

/// Sets the object name and, if not empty, the accessible name of a widget, and returns the widget.
template <typename Widget>
Widget *named(QAnyStringView name, Widget *widget, const QString &spoken = {})
{
    widget->setObjectName(name);
    if (!spoken.isEmpty()) {
        widget->setAccessibleName(spoken);
    }
    return widget;
}

} // namespace slidercrank
