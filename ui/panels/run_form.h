// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The form that opens from the button of the timeline: the simulated time range, its steps, and the playback speed.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <QFrame>

class QFormLayout;
class QToolButton;

namespace slidercrank
{

class NumberBox;

// Playback speed: seconds of the motion in a second of real time.
inline constexpr double kSlowestPlayback = 1e-9;
inline constexpr double kFastestPlayback = 1e9;

class RunForm : public QFrame
{
    Q_OBJECT

public:
    explicit RunForm(QWidget *parent);

    // These functions show the values and emit nothing.
    void setSampling(const Sampling &sampling);
    void setParameters(const Parameters &parameters);
    void setSpeed(double speed);

    /// Opens the form below the widget, or above it at the lower edge of the screen.
    void openAt(const QWidget &widget);

signals:
    void edited(const slidercrank::Sampling &sampling);
    void speedEdited(double speed);

private:
    NumberBox *addBox(QFormLayout *form, const QString &objectName, const QString &name, const QString &suffix,
                      const QString &explanation);
    double revolution() const; ///< time of one revolution, s; infinite if the crank is at rest
    void showRevolution();
    void edit();

    Sampling m_sampling;
    Parameters m_parameters;
    double m_speed = 1.0;
    NumberBox *m_start;
    NumberBox *m_duration;
    QToolButton *m_oneTurn;
    NumberBox *m_steps;
    NumberBox *m_speedBox;
    NumberBox *m_revolution;
};

} // namespace slidercrank
