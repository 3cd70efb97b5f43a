// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace slidercrank
{

/// With the name by which the program finds it and, where it shows none of its own, one for a screen reader.
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
