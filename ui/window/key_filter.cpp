// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/key_filter.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QSlider>
#include <QTabBar>

namespace slidercrank
{

namespace
{

/// Returns whether the widget uses a key that is also a shortcut of the window.
bool uses(const QWidget &widget, const QKeyEvent &key)
{
    if (key.key() == Qt::Key_Left || key.key() == Qt::Key_Right) {
        return qobject_cast<const QSlider *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget) ||
               qobject_cast<const QTabBar *>(&widget) || qobject_cast<const QMenuBar *>(&widget);
    }
    const auto *label = qobject_cast<const QLabel *>(&widget);
    return label && label->hasSelectedText() && key.matches(QKeySequence::Copy);
}

bool pressEnter(QWidget &widget)
{
    if (auto *button = qobject_cast<QAbstractButton *>(&widget)) {
        button->click();
        return true;
    }
    if (auto *list = qobject_cast<QComboBox *>(&widget)) {
        list->showPopup();
        return true;
    }
    return false;
}

bool changesWithWheel(const QWidget &widget)
{
    return qobject_cast<const QSlider *>(&widget) || qobject_cast<const QComboBox *>(&widget) ||
           qobject_cast<const QAbstractSpinBox *>(&widget);
}

} // namespace

KeyFilter::KeyFilter(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool KeyFilter::eventFilter(QObject *watched, QEvent *event)
{
    const QEvent::Type type = event->type();
    if (type != QEvent::Wheel && type != QEvent::Show && type != QEvent::ShortcutOverride && type != QEvent::KeyPress) {
        return false;
    }
    auto *widget = qobject_cast<QWidget *>(watched);
    if (!widget) {
        return false;
    }
    if (type == QEvent::Show) {
        if (qobject_cast<QComboBox *>(widget)) {
            widget->setFocusPolicy(Qt::StrongFocus); // turning the wheel does not give it the focus
        }
        return false;
    }
    if (type == QEvent::Wheel) {
        event->setAccepted(!changesWithWheel(*widget) || widget->hasFocus());
        return !event->isAccepted();
    }
    if (qobject_cast<QDialog *>(widget->window())) {
        return false; // dialogs handle their own keys
    }
    const auto &key = *static_cast<QKeyEvent *>(event);
    if (type == QEvent::ShortcutOverride && uses(*widget, key)) {
        event->accept();
        return true;
    }
    const bool isEnter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    return type == QEvent::KeyPress && isEnter && !key.isAutoRepeat() && pressEnter(*widget);
}

} // namespace slidercrank

#include "moc_key_filter.cpp"
