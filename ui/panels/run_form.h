// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which instants are computed and how fast they are played: what opens from the timeline's button.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <QFrame>

class QGridLayout;
class QToolButton;

namespace slidercrank
{

class NumberBox;

// Of playing: seconds of the motion in a second of the clock.
inline constexpr double kSlowestPlaying = 1e-9;
inline constexpr double kFastestPlaying = 1e9;

class RunForm : public QFrame
{
    Q_OBJECT

public:
    explicit RunForm(QWidget *parent);

    // They show what there is, and emit nothing.
    void setSampling(const Sampling &sampling);
    void setParameters(const Parameters &parameters);
    void setSpeed(double speed);

    /// Beside that widget, where the screen has room.
    void openAt(const QWidget &widget);

signals:
    void edited(const slidercrank::Sampling &sampling);
    void speedEdited(double speed); ///< model seconds a second of the clock

private:
    NumberBox *addBox(QGridLayout *grid, const QString &objectName, const QString &name, const QString &suffix);
    double turn() const; ///< s; infinite where the crank stands still
    void showTurn();
    void edit(const Sampling &sampling);

    Sampling m_sampling;
    Parameters m_parameters;
    double m_speed = 1.0;
    NumberBox *m_start = nullptr;
    NumberBox *m_duration = nullptr;
    NumberBox *m_steps = nullptr;
    NumberBox *m_speedBox = nullptr;
    NumberBox *m_turnBox = nullptr;
    QToolButton *m_oneTurn = nullptr;
};

} // namespace slidercrank
