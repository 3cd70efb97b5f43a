// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/key_owner.h"

#include "ui/panels/run_form.h"
#include "ui/widgets/number_box.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>

namespace slidercrank
{

namespace
{

bool needsSpace(const QWidget &widget)
{
    if (const auto *box = qobject_cast<const NumberBox *>(&widget)) {
        return box->isTyping(); // "25 mm"; a box that only has the focus needs none
    }
    return qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QCheckBox *>(&widget);
}

/// Of the arrows to the side. Home and End belong to the playback, unless a text is edited.
bool moves(const QWidget &widget, int key)
{
    return (key == Qt::Key_Left || key == Qt::Key_Right) &&
           (qobject_cast<const QAbstractSlider *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget) ||
            widget.inherits("QTabBar") || widget.inherits("QMenuBar"));
}

/// What is marked in a sentence.
bool copies(const QWidget &widget, const QKeyEvent &key)
{
    const auto *sentence = qobject_cast<const QLabel *>(&widget);
    return sentence && sentence->hasSelectedText() && key.matches(QKeySequence::Copy);
}

/// Enter on a button, or on a list that is closed.
bool press(QWidget &widget, const QKeyEvent &key)
{
    if (auto *button = qobject_cast<QAbstractButton *>(&widget)) {
        if (!key.isAutoRepeat() || button->autoRepeat()) {
            button->click();
        }
        return true;
    }
    if (auto *list = qobject_cast<QComboBox *>(&widget)) {
        list->showPopup();
        return true;
    }
    return false;
}

bool turnsWithTheWheel(const QWidget &widget)
{
    return qobject_cast<const QSlider *>(&widget) || qobject_cast<const QComboBox *>(&widget) ||
           qobject_cast<const QAbstractSpinBox *>(&widget);
}

} // namespace

KeyOwner::KeyOwner(QWidget *window)
    : QObject(window)
    , m_window(window)
{
    qApp->installEventFilter(this);
}

/// X11 tells of a key that is held as of one let go and pressed at the same moment; not all of these are known to Qt.
bool KeyOwner::isHeld(const QKeyEvent &key) const
{
    return key.isAutoRepeat() ||
           (key.timestamp() == m_spaceLetGo && QGuiApplication::platformName() == QStringLiteral("xcb"));
}

bool KeyOwner::eventFilter(QObject *watched, QEvent *event)
{
    const QEvent::Type type = event->type(); // first: every event of the program comes by
    if (type != QEvent::Show && type != QEvent::Wheel && type != QEvent::ShortcutOverride && type != QEvent::KeyPress &&
        type != QEvent::KeyRelease) {
        return false;
    }
    auto *widget = qobject_cast<QWidget *>(watched);
    if (!widget) {
        return false;
    }
    const bool isOurs = widget->window() == m_window || qobject_cast<RunForm *>(widget->window());
    if (!isOurs && type != QEvent::Show && type != QEvent::Wheel) {
        return false; // open lists and dialogs keep their keys
    }
    switch (type) {
    case QEvent::Show:
        if (auto *list = qobject_cast<QComboBox *>(widget)) {
            list->setFocusPolicy(Qt::StrongFocus); // not by the wheel
        }
        break;
    case QEvent::Wheel:
        if (turnsWithTheWheel(*widget) && !widget->hasFocus()) {
            event->ignore();
            return true;
        }
        break;
    case QEvent::ShortcutOverride: {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (moves(*widget, key->key()) || copies(*widget, *key)) {
            event->accept();
            return true;
        }
        if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier && !needsSpace(*widget)) {
            event->setAccepted(isHeld(*key)); // once is enough
            return true;
        }
        break;
    }
    case QEvent::KeyRelease:
        if (const auto *key = static_cast<QKeyEvent *>(event); key->key() == Qt::Key_Space) {
            m_spaceLetGo = key->timestamp();
        }
        break;
    case QEvent::KeyPress: {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Space && isHeld(*key) && !needsSpace(*widget)) {
            return true;
        }
        return (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) && press(*widget, *key);
    }
    default: break;
    }
    return false;
}

} // namespace slidercrank
