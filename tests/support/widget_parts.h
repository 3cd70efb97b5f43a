// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds child widgets by object name, and types numbers into them.

#include <QAbstractSpinBox>
#include <QTest>

namespace slidercrank
{

/// Returns the child with this object name. Terminates the test program if there is none.
template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

/// Types a number and presses Enter. The text may contain characters that no key produces.
inline void typeNumber(QAbstractSpinBox *box, const QString &text)
{
    box->setFocus();
    box->selectAll();
    for (const QChar letter : text) {
        QTest::sendKeyEvent(QTest::Click, box, Qt::Key_unknown, QString(letter), Qt::NoModifier);
    }
    QTest::keyClick(box, Qt::Key_Return);
}

} // namespace slidercrank
