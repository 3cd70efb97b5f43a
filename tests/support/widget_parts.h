// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The parts of a widget by their object names, and typing into them.

#include <QAbstractSpinBox>
#include <QTest>

namespace slidercrank
{

/// Ends the test program if there is no such part.
template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

/// Types a number, also with characters that are on no key, and presses Enter.
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
