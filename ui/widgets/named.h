// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFormLayout>

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

/// Adds a row to a form: the name, which a screen reader announces, and the field with its tool tip. Returns the field.
template <typename Field>
Field *addField(QFormLayout *form, QAnyStringView objectName, const QString &name, Field *field,
                const QString &explanation)
{
    named(objectName, field, name)->setToolTip(explanation);
    form->addRow(name, field);
    return field;
}

} // namespace slidercrank
