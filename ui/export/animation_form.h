// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How an animation is to be: how many frames a second, how large, how long.

#include "core/mechanism/mechanism.h"
#include "ui/export/animation_export.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace slidercrank
{

class NumberBox;

class AnimationForm : public QDialog
{
    Q_OBJECT

public:
    /// Starts from `animation`, of that mechanism.
    AnimationForm(const Animation &animation, const Parameters &parameters, QWidget *parent);

    /// As it is chosen; the start and the speed stay.
    Animation animation() const;

    /// Not with a number that a box does not take.
    void accept() override;

private:
    enum LengthUnit { Seconds, Turns };
    NumberBox *addWholeBox(const QString &objectName, const QString &name, double smallest, double largest);
    double perUnit() const; ///< s of the motion
    void showOutcome();

    Animation m_animation;
    double m_turn; ///< s; infinite where the crank stands still
    NumberBox *m_rate = nullptr;
    NumberBox *m_width = nullptr;
    NumberBox *m_height = nullptr;
    NumberBox *m_length = nullptr;
    QComboBox *m_unit = nullptr;
    QLabel *m_outcome = nullptr;
    QPushButton *m_export = nullptr;
};

} // namespace slidercrank
