// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The form that opens from the button of the timeline: the simulated time range, its steps, and the playback speed.

#include <QFrame>

class QToolButton;

namespace slidercrank
{

class NumberBox;
class Session;

// Playback speed: seconds of the motion in a second of real time.
inline constexpr double kSlowestPlayback = 1e-9;
inline constexpr double kFastestPlayback = 1e9;

class RunForm : public QFrame
{
    Q_OBJECT

public:
    RunForm(Session *session, QWidget *parent);

    /// Shows the playback speed and emits nothing.
    void setSpeed(double speed);

    /// Opens the form below the widget, or above it at the lower edge of the screen.
    void openAt(const QWidget &widget);

signals:
    void speedEdited(double speed);

private:
    double revolution() const; ///< time of one revolution, s; infinite if the crank is at rest
    void showSettings();
    void edit();

    Session *m_session;
    double m_speed = 1.0;
    NumberBox *m_start;
    NumberBox *m_duration;
    QToolButton *m_oneTurn;
    NumberBox *m_steps;
    NumberBox *m_speedBox;
    NumberBox *m_revolution;
};

} // namespace slidercrank
