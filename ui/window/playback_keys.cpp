// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/playback_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QTabBar>

namespace slidercrank
{

bool PlaybackKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        const bool activates = key == Qt::Key_Space && qobject_cast<QAbstractButton *>(watched);
        const bool moves = (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End) &&
                           (qobject_cast<QAbstractSlider *>(watched) || qobject_cast<QComboBox *>(watched) ||
                            qobject_cast<QAbstractItemView *>(watched) || qobject_cast<QTabBar *>(watched));
        if (activates || moves) {
            event->accept();
            return true;
        }
        const bool isInNumber = qobject_cast<QAbstractSpinBox *>(watched) ||
                                qobject_cast<QAbstractSpinBox *>(watched->parent()); // or in the line within
        if (key == Qt::Key_Space && isInNumber) {
            event->ignore(); // no number has a space
            return true;
        }
    }
    return false;
}

} // namespace slidercrank
