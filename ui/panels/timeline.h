// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Playing, stepping and scrubbing through the sampled time. It asks for instants (timeRequested) and shows the one that
// comes back (setPose). Playing follows the clock: a slow machine drops frames, not time. What the run is and how fast
// it plays opens from a button.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/result.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <functional>

class QToolButton;

namespace slidercrank
{

class NumberBox;
class NumberSlider;
class PlaybackButton;
class RunForm;

/// Model seconds a second of the clock, to choose from.
inline constexpr std::array<double, 9> kSpeeds{0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 4.0, 5.0, 10.0};
QString speedText(double speed); ///< "0.1×"

class Timeline : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(QWidget *parent = nullptr);

    bool isPlaying() const { return m_frames.isActive(); }
    bool isLooping() const;
    double speed() const { return m_speed; } ///< model seconds a second of the clock

    /// It tells seconds since whenever.
    void setClock(const std::function<double()> &clock) { m_clock = clock; }

public slots:
    void setSampling(const slidercrank::Sampling &sampling);
    void setPose(const slidercrank::Pose &pose);

    /// The drive, ω₂ and θ₂₀: which instant a typed crank angle means.
    void setParameters(const slidercrank::Parameters &parameters);

    void togglePlaying();
    void play();
    void pause();
    void stepForward(); ///< one sampling step
    void stepBack();
    void toStart();
    void toEnd();
    void setLooping(bool looping);
    void setSpeed(double speed); ///< model seconds a second of the clock
    void faster();               ///< the next of kSpeeds
    void slower();
    void openRun(); ///< start, duration, steps and speed

signals:
    void timeRequested(double seconds);
    void playingChanged(bool playing);
    void loopingChanged(bool looping);
    void speedChanged(double speed);
    void samplingEdited(const slidercrank::Sampling &sampling);

private:
    double first() const; ///< of the sampled range, s
    double last() const;
    void nextFrame();
    void restartClock(double from);
    double stepsAt(double time) const; ///< since the start of the run
    void stepTo(double step);
    void goToAngle(double degrees);
    void showTime();
    void showRun();

    Sampling m_sampling;
    Parameters m_parameters;
    Pose m_pose;

    // While playing: the instant is m_playedFrom + m_speed · (m_clock() - m_playedSince).
    QTimer m_frames{this};
    std::function<double()> m_clock;
    double m_playedFrom = 0.0;
    double m_playedSince = 0.0;
    double m_requested = 0.0;
    double m_speed = 1.0;

    PlaybackButton *m_play = nullptr;
    PlaybackButton *m_loop = nullptr;
    QToolButton *m_run = nullptr;
    RunForm *m_runForm = nullptr;
    NumberSlider *m_slider = nullptr;
    NumberBox *m_timeBox = nullptr;
    NumberBox *m_angleBox = nullptr;
};

} // namespace slidercrank
