// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds child widgets by object name, reads messages, and types numbers into boxes.

#include <QAbstractSpinBox>
#include <QLabel>
#include <QLayout>
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

/// Returns the messages of a message bar, one per line, newest first.
inline QString messageText(const QWidget &bar)
{
    QStringList texts;
    for (int i = 0; i < bar.layout()->count(); ++i) {
        texts << child<QLabel>(*bar.layout()->itemAt(i)->widget(), "messageText")->text();
    }
    return texts.join(u'\n');
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
