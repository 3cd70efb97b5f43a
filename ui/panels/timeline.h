// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A widget that plays, steps and scrubs through the simulated time. Playback follows the clock: a slow machine drops
// frames. A button opens the form for the time range and the playback speed.

#include <QTimer>
#include <QWidget>

#include <array>
#include <functional>

class QAction;
class QFrame;
class QLayout;
class QMenu;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class NumberSlider;
class Session;

class Timeline : public QWidget
{
    Q_OBJECT

public:
    explicit Timeline(Session *session, QWidget *parent = nullptr);

    bool isPlaying() const { return m_frameTimer.isActive(); }
    double speed() const { return m_speed; } ///< seconds of the motion per second of real time

    /// `clock` returns the seconds since an arbitrary moment.
    void setClock(const std::function<double()> &clock) { m_clock = clock; }

    QFrame *form() const { return m_form; } ///< the form for the time range and the speed

    /// Adds the playback actions to the menu; the buttons use the same actions.
    void fillMenu(QMenu *menu);

public slots:
    void togglePlaying() { isPlaying() ? pause() : play(); }
    void play();
    void pause();
    void setSpeed(double speed);
    void refreshNotation(); ///< shows the crank angle in the chosen unit
    void openTimeRange();   ///< opens form()

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    enum Command { Play, Forward, Back, Start, End, Loop, Faster, Slower, OpenTimeRange, CommandCount };

    void addAction(Command command, const QString &text, const QKeySequence &shortcut,
                   const std::function<void()> &act = {});
    void createActions();
    QLayout *createScrubbing();
    QLayout *createButtons();
    void createForm();
    void drawIcons();
    double startTime() const;      ///< s
    double endTime() const;        ///< s
    double revolutionTime() const; ///< s; infinite if the crank is at rest
    bool isFast() const;           ///< whether the crank turns so fast that playing is slowed
    double playbackSpeed() const;  ///< seconds of the motion per second, with the slowing of a fast crank
    void showOneRevolution();
    void nextFrame();
    double currentStep() const;
    void stepTo(double step);
    void goToAngle(double angle);
    void editSampling();
    void showSettings();
    void showOffer();
    void fitTimeRangeButton();
    void showTime();

    Session *m_session;

    QTimer m_frameTimer{this}; ///< runs while playing
    std::function<double()> m_clock;
    double m_lastFrame = 0.0; ///< m_clock() when the last frame was shown
    double m_speed = 1.0;

    std::array<QAction *, CommandCount> m_actions{};
    QToolButton *m_playButton;
    QToolButton *m_offerButton; ///< offers a time range of one revolution, see showOffer()
    QToolButton *m_timeRangeButton;
    NumberSlider *m_slider;
    NumberBox *m_timeBox;
    NumberBox *m_angleBox;

    QFrame *m_form;
    NumberBox *m_startBox;
    NumberBox *m_durationBox;
    QToolButton *m_oneRevolutionButton;
    NumberBox *m_stepsBox;
    NumberBox *m_speedBox;
};

} // namespace slidercrank
