// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The dialog that asks for an animation's frame rate, size and length.

#include "ui/export/animation_export.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QSpinBox;

namespace slidercrank
{

class NumberBox;

class AnimationForm : public QDialog
{
    Q_OBJECT

public:
    AnimationForm(const Animation &animation, QWidget *parent);

    /// Returns the animation as chosen. Its start and its speed are those of the animation that was passed to the
    /// constructor.
    Animation animation() const;

private:
    QSpinBox *makeBox(const QString &objectName, int smallest, int largest, int value);
    void showSummary();

    Animation m_animation;
    QSpinBox *m_frameRate;
    QSpinBox *m_width;
    QSpinBox *m_height;
    NumberBox *m_duration;
    QLabel *m_summary;
    QPushButton *m_export;
};

} // namespace slidercrank
