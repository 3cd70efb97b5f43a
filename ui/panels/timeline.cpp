// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline.h"

#include "core/mechanism/turn.h"
#include "core/sampling/crank_instant.h"
#include "ui/panels/run_form.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

QString speedText(double speed)
{
    return Timeline::tr("%1×").arg(numberText(speed, 3));
}

/// The style's icon in the colour of the palette's text: its own is too dark on a dark background.
QIcon colouredIcon(const QWidget &widget, QStyle::StandardPixmap symbol)
{
    constexpr int kSize = 32; // px
    QPixmap pixmap = widget.style()->standardIcon(symbol, nullptr, &widget).pixmap(kSize);
    QPainter painter(&pixmap);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), widget.palette().color(QPalette::ButtonText));
    return QIcon(pixmap);
}

} // namespace

Timeline::Timeline(QWidget *parent)
    : QWidget(parent)
    , m_clock(steadySeconds)
{
    named("timeline", this, tr("Timeline"));
    m_frames.setInterval(16);
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &Timeline::nextFrame);
    createActions();
    m_runForm = new RunForm(this);
    connect(m_runForm, &RunForm::edited, this, &Timeline::samplingEdited);
    connect(m_runForm, &RunForm::speedEdited, this, &Timeline::setSpeed);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 4, 6, 4);
    rows->setSpacing(3);
    rows->addLayout(createScrubbing());
    rows->addLayout(createButtons());
    colourIcons();
    setSampling(m_sampling);
    setSpeed(m_speed);
}

QAction *Timeline::addAction(const QString &text, const QKeySequence &shortcut, void (Timeline::*slot)())
{
    auto *action = new QAction(text, this);
    action->setShortcut(shortcut);
    const QString name = QString(text).remove(u'&').remove(u'…');
    action->setToolTip(tr("%1 (%2)").arg(name, shortcut.toString(QKeySequence::NativeText)));
    connect(action, &QAction::triggered, this, slot);
    return action;
}

void Timeline::createActions()
{
    m_play = addAction(tr("&Play or pause"), Qt::Key_Space, &Timeline::togglePlaying);
    m_play->setAutoRepeat(false);
    m_forward = addAction(tr("Step &forward"), Qt::Key_Right, &Timeline::stepForward);
    m_back = addAction(tr("Step &back"), Qt::Key_Left, &Timeline::stepBack);
    m_start = addAction(tr("To the &start"), Qt::Key_Home, &Timeline::toStart);
    m_end = addAction(tr("To the &end"), Qt::Key_End, &Timeline::toEnd);
    m_faster = addAction(tr("F&aster"), Qt::SHIFT | Qt::Key_Right, &Timeline::faster);
    m_slower = addAction(tr("Slo&wer"), Qt::SHIFT | Qt::Key_Left, &Timeline::slower);
    m_openRun = addAction(tr("&Time range and speed…"), Qt::CTRL | Qt::Key_R, &Timeline::openRun);
    m_loop = new QAction(tr("&Loop"), this);
    m_loop->setShortcut(Qt::CTRL | Qt::Key_L);
    m_loop->setToolTip(tr("Start again at the end (Ctrl+L)"));
    m_loop->setCheckable(true);
    m_loop->setChecked(true);
    m_speeds = new QActionGroup(this);
    for (const double speed : kSpeeds) {
        QAction *action = m_speeds->addAction(speedText(speed));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, speed] { setSpeed(speed); });
    }
}

void Timeline::fillMenu(QMenu *menu)
{
    menu->addActions({m_play, m_forward, m_back, m_start, m_end, m_loop});
    menu->addSeparator();
    menu->addMenu(tr("Spee&d"))->addActions(m_speeds->actions());
    menu->addActions({m_faster, m_slower, m_openRun});
}

QLayout *Timeline::createScrubbing()
{
    m_timeBox = named("timeBox", new NumberBox, tr("Time in seconds"));
    m_timeBox->setToolTip(tr("Time"));
    m_timeBox->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_timeBox->setSuffix(tr(" s"));
    m_timeBox->setUnit(kSecond);
    connect(m_timeBox, &NumberBox::edited, this, &Timeline::timeRequested);

    constexpr double kLargestAngle = 1e300; // degrees: every angle that a mechanism can reach
    m_angleBox = named("angleBox", new NumberBox, tr("Crank angle in degrees"));
    m_angleBox->setToolTip(tr("Crank angle: type one to go to the time when the crank first passes it"));
    m_angleBox->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_angleBox->setSuffix(tr("°"));
    m_angleBox->setUnit(kDegree);
    m_angleBox->setRange({.smallest = -kLargestAngle, .largest = kLargestAngle});
    m_angleBox->setFixedDecimals(2);
    m_angleBox->setStep(1.0);
    connect(m_angleBox, &NumberBox::edited, this, &Timeline::goToAngle);

    m_slider = named("timeSlider", new NumberSlider, tr("Time, slider"));
    m_slider->setSuffix(tr(" s"));
    m_slider->setMinimumWidth(60);
    connect(m_slider, &NumberSlider::valueChanged, this,
            [this](int step) { emit timeRequested(m_sampling.instant(step)); });

    auto *row = new QHBoxLayout;
    row->setSpacing(5);
    for (const auto &[text, box] : {std::pair{tr("t"), m_timeBox}, std::pair{tr("θ₂"), m_angleBox}}) {
        auto *label = new QLabel(text);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box);
    }
    row->insertWidget(2, m_slider, 1);
    return row;
}

QToolButton *Timeline::addButton(QLayout *row, const QString &objectName, QAction *action)
{
    auto *button = named(objectName, new QToolButton);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
    return button;
}

QLayout *Timeline::createButtons()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(2);
    addButton(row, "startButton", m_start);
    addButton(row, "backButton", m_back)->setAutoRepeat(true);
    m_playButton = addButton(row, "playButton", m_play);
    addButton(row, "forwardButton", m_forward)->setAutoRepeat(true);
    addButton(row, "endButton", m_end);
    row->addSpacing(8);
    addButton(row, "loopButton", m_loop);
    row->addStretch(1);
    m_run = named("runButton", new QToolButton, tr("Time range and speed"));
    m_run->setAutoRaise(true);
    m_run->setFocusPolicy(Qt::TabFocus);
    m_run->setToolTip(tr("Start, duration, steps, one revolution, and the playback speed (Ctrl+R)"));
    connect(m_run, &QToolButton::clicked, this, &Timeline::openRun);
    row->addWidget(m_run);
    return row;
}

void Timeline::colourIcons()
{
    m_start->setIcon(colouredIcon(*this, QStyle::SP_MediaSkipBackward));
    m_back->setIcon(colouredIcon(*this, QStyle::SP_MediaSeekBackward));
    m_play->setIcon(colouredIcon(*this, isPlaying() ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
    m_forward->setIcon(colouredIcon(*this, QStyle::SP_MediaSeekForward));
    m_end->setIcon(colouredIcon(*this, QStyle::SP_MediaSkipForward));
    m_loop->setIcon(colouredIcon(*this, QStyle::SP_BrowserReload));
    m_playButton->setAccessibleName(isPlaying() ? tr("Pause") : tr("Play"));
}

void Timeline::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_playButton) {
        colourIcons();
    }
}

double Timeline::first() const
{
    return std::min(m_sampling.start, m_sampling.start + m_sampling.duration);
}

double Timeline::last() const
{
    return std::max(m_sampling.start, m_sampling.start + m_sampling.duration);
}

void Timeline::setSampling(const Sampling &sampling)
{
    m_sampling = sampling;
    const double step = std::abs(sampling.duration) / sampling.steps;
    const int decimals = step > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(step))), 3, 9) : 3;
    m_timeBox->setFixedDecimals(decimals);
    m_timeBox->setStep(step);
    m_timeBox->setRange({.smallest = first(), .largest = last(), .takesNearest = true});
    const double largest = std::max(std::abs(first()), std::abs(last()));
    m_timeBox->setWidestText(QLocale().toString(-largest, 'f', decimals));
    {
        const QSignalBlocker quiet(m_slider);
        m_slider->setScale(sampling.start, sampling.duration / sampling.steps);
        m_slider->setRange(0, sampling.steps);
        m_slider->setPageStep(std::max(1, sampling.steps / 20));
    }
    if (isPlaying()) {
        restartClock(std::clamp(m_requested, first(), last()));
    }
    m_runForm->setSampling(sampling);
    showRun();
    showTime();
}

void Timeline::setPose(const Pose &pose)
{
    m_pose = pose;
    if (isPlaying() && pose.time != m_requested) {
        restartClock(pose.time); // the time was moved while it plays
    }
    showTime();
}

void Timeline::setParameters(const Parameters &parameters)
{
    m_parameters = parameters;
    m_angleBox->setEnabled(parameters.omega2 != 0.0);
    m_runForm->setParameters(parameters);
}

void Timeline::togglePlaying()
{
    if (isPlaying()) {
        pause();
    } else {
        play();
    }
}

void Timeline::play()
{
    if (isPlaying()) {
        return;
    }
    restartClock(m_pose.time < last() ? m_pose.time : first());
    m_frames.start();
    colourIcons();
    emit playingChanged(true);
}

void Timeline::pause()
{
    if (!isPlaying()) {
        return;
    }
    m_frames.stop();
    colourIcons();
    emit playingChanged(false);
}

void Timeline::stepForward()
{
    stepTo(std::floor(stepsAt(m_pose.time) + 1.0));
}

void Timeline::stepBack()
{
    stepTo(std::ceil(stepsAt(m_pose.time) - 1.0));
}

void Timeline::toStart()
{
    emit timeRequested(m_sampling.start);
}

void Timeline::toEnd()
{
    emit timeRequested(m_sampling.start + m_sampling.duration);
}

void Timeline::setSpeed(double speed)
{
    m_speed = speed > 0.0 ? std::clamp(speed, kSlowestPlayback, kFastestPlayback) : kSlowestPlayback; // also for NaN
    m_runForm->setSpeed(m_speed);
    for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
        m_speeds->actions()[static_cast<int>(i)]->setChecked(kSpeeds[i] == m_speed);
    }
    showRun();
    if (isPlaying()) {
        restartClock(m_requested);
    }
    emit speedChanged(m_speed);
}

void Timeline::faster()
{
    const auto next = std::ranges::upper_bound(kSpeeds, m_speed);
    setSpeed(next == kSpeeds.end() ? std::max(m_speed, kSpeeds.back()) : *next);
}

void Timeline::slower()
{
    const auto next = std::ranges::lower_bound(kSpeeds, m_speed);
    setSpeed(next == kSpeeds.begin() ? std::min(m_speed, kSpeeds.front()) : *std::prev(next));
}

void Timeline::openRun()
{
    m_runForm->openAt(*m_run);
}

bool Timeline::isLooping() const
{
    return m_loop->isChecked();
}

void Timeline::setLooping(bool looping)
{
    m_loop->setChecked(looping);
}

void Timeline::restartClock(double from)
{
    m_playedFrom = from;
    m_requested = from;
    m_playedSince = m_clock();
}

void Timeline::nextFrame()
{
    const double run = last() - first();
    double time = m_playedFrom + m_speed * (m_clock() - m_playedSince);
    bool ended = false;
    if (time >= last()) {
        if (isLooping() && run > 0.0) {
            time = first() + std::fmod(time - first(), run);
        } else {
            time = last();
            ended = true;
        }
    }
    m_requested = time;
    emit timeRequested(time);
    if (ended) {
        pause();
    }
}

double Timeline::stepsAt(double time) const
{
    if (m_sampling.duration == 0.0) {
        return 0.0;
    }
    const double steps = (time - m_sampling.start) / m_sampling.duration * m_sampling.steps;
    // A time that is a time step up to rounding is that time step.
    constexpr double kSame = 1e-6; // of a step
    const double nearest = std::round(steps);
    return std::abs(steps - nearest) < kSame ? nearest : steps;
}

void Timeline::stepTo(double step)
{
    pause();
    emit timeRequested(
        m_sampling.instant(static_cast<int>(std::clamp(step, 0.0, static_cast<double>(m_sampling.steps)))));
}

void Timeline::goToAngle(double degrees)
{
    const double omega2 = m_parameters.omega2;
    if (omega2 != 0.0) {
        double time =
            (degrees / kDegreesPerRadian - m_parameters.theta20) / omega2; // the very angle, whole turns included
        if (!(time >= first() && time <= last())) {
            const double period = kTurn / std::abs(omega2);
            time = instantAtCrankAngle(Mechanism(m_parameters), degrees / kDegreesPerRadian, first()).value_or(first());
            if (time > last()) { // not passed: whichever end is nearer
                time = first() - (time - period) < time - last() ? first() : last();
            }
        }
        emit timeRequested(time);
    }
    showTime();
}

/// The button shows what is chosen.
void Timeline::showRun()
{
    constexpr int kDigits = 3;
    m_run->setText(tr("%1 s · %2 ▾", "duration, playback speed")
                       .arg(numberText(m_sampling.duration, kDigits), speedText(m_speed)));
}

void Timeline::showTime()
{
    m_timeBox->setValue(m_pose.time);
    m_angleBox->setValue(m_pose.theta2 * kDegreesPerRadian);
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(
        static_cast<int>(std::lround(std::clamp(stepsAt(m_pose.time), 0.0, static_cast<double>(m_sampling.steps)))));
}

} // namespace slidercrank
