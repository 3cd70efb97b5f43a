// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline.h"

#include "core/mechanism/turn.h"
#include "core/sampling/crank_instant.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/panels/run_form.h"
#include "ui/text/written_number.h"

#include <QFontInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
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

} // namespace

QString speedText(double speed)
{
    return Timeline::tr("%1×").arg(numberText(speed, 3));
}

/// A flat button whose sign is drawn in the palette's colour, so that it can be read in every theme and at every scale.
class PlaybackButton : public QToolButton
{
public:
    enum class Sign { Start, Back, Play, Pause, Forward, End, Loop };

    PlaybackButton(Sign sign, const QString &name, const QString &shortcut)
        : m_sign(sign)
    {
        setAutoRaise(true);
        setAccessibleName(name);
        setToolTip(shortcut.isEmpty() ? name : Timeline::tr("%1 (%2)").arg(name, shortcut));
        setFocusPolicy(Qt::TabFocus);
    }

    void setSign(Sign sign, const QString &name)
    {
        m_sign = sign;
        setAccessibleName(name);
        update();
    }

    QSize sizeHint() const override { return (factor() * QSizeF(28.0, 26.0)).toSize(); }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        QToolButton::paintEvent(event);
        const bool chosen = isCheckable() && isChecked();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(QRectF(rect()).center());
        painter.scale(factor(), factor());
        const QPalette::ColorGroup group = isEnabled() ? QPalette::Normal : QPalette::Disabled;
        const QColor colour = palette().color(group, chosen ? QPalette::Link : QPalette::ButtonText);
        painter.setBrush(colour);
        painter.setPen(Qt::NoPen);
        paintSign(painter, colour);
    }

private:
    /// Larger beside large letters.
    double factor() const
    {
        constexpr double kUsual = 15.0; // px, at most
        return std::max(1.0, QFontInfo(font()).pixelSize() / kUsual);
    }

    static void paintTriangle(QPainter &painter, double left, double right)
    {
        painter.drawPolygon(QPolygonF{{left, -6.0}, {right, 0.0}, {left, 6.0}});
    }

    void paintSign(QPainter &painter, const QColor &colour) const
    {
        switch (m_sign) {
        case Sign::Play: paintTriangle(painter, -4.0, 6.0); break;
        case Sign::Pause:
            painter.drawRect(QRectF(-5.0, -6.0, 3.5, 12.0));
            painter.drawRect(QRectF(1.5, -6.0, 3.5, 12.0));
            break;
        case Sign::Forward:
            painter.drawRect(QRectF(-5.0, -6.0, 2.0, 12.0));
            paintTriangle(painter, -1.5, 6.0);
            break;
        case Sign::Back:
            painter.drawRect(QRectF(3.0, -6.0, 2.0, 12.0));
            paintTriangle(painter, 1.5, -6.0);
            break;
        case Sign::End:
            paintTriangle(painter, -7.0, -0.5);
            paintTriangle(painter, -1.0, 5.5);
            painter.drawRect(QRectF(5.0, -6.0, 2.0, 12.0));
            break;
        case Sign::Start:
            paintTriangle(painter, 7.0, 0.5);
            paintTriangle(painter, 1.0, -5.5);
            painter.drawRect(QRectF(-7.0, -6.0, 2.0, 12.0));
            break;
        case Sign::Loop: {
            painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::FlatCap));
            painter.setBrush(Qt::NoBrush);
            painter.drawArc(QRectF(-6.0, -6.0, 12.0, 12.0), 70 * 16, 290 * 16);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawPolygon(QPolygonF{{1.5, -9.5}, {1.5, -1.5}, {6.5, -5.5}});
            break;
        }
        }
    }

    Sign m_sign;
};

Timeline::Timeline(QWidget *parent)
    : QWidget(parent)
    , m_clock(steadySeconds)
{
    named("timeline", this, tr("Timeline"));
    m_frames.setInterval(16);
    m_frames.setTimerType(Qt::PreciseTimer);
    connect(&m_frames, &QTimer::timeout, this, &Timeline::nextFrame);

    m_timeBox = named("timeBox", new NumberBox, tr("Instant in seconds"));
    m_timeBox->setToolTip(tr("Instant"));
    m_timeBox->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_timeBox->setSuffix(tr(" s"));
    m_timeBox->setUnit(kSecond);
    connect(m_timeBox, &NumberBox::edited, this, &Timeline::timeRequested);

    m_angleBox = named("angleBox", new NumberBox, tr("Crank angle in degrees"));
    m_angleBox->setToolTip(tr("Crank angle: type one to go where the crank first passes it"));
    m_angleBox->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_angleBox->setSuffix(tr("°"));
    m_angleBox->setUnit(kDegree);
    m_angleBox->setFixedDecimals(2);
    m_angleBox->setStep(1.0);
    connect(m_angleBox, &NumberBox::edited, this, &Timeline::goToAngle);

    m_slider = named("timeSlider", new NumberSlider, tr("Instant, slider"));
    m_slider->setSuffix(tr(" s"));
    m_slider->setMinimumWidth(60);
    connect(m_slider, &NumberSlider::valueChanged, this,
            [this](int step) { emit timeRequested(m_sampling.instant(step)); });

    auto *timeLabel = new QLabel(tr("t"));
    timeLabel->setBuddy(m_timeBox);
    auto *angleLabel = new QLabel(tr("θ₂"));
    angleLabel->setBuddy(m_angleBox);

    auto *scrubbing = new QHBoxLayout;
    scrubbing->setSpacing(5);
    scrubbing->addWidget(timeLabel);
    scrubbing->addWidget(m_timeBox);
    scrubbing->addWidget(m_slider, 1);
    scrubbing->addWidget(angleLabel);
    scrubbing->addWidget(m_angleBox);

    using Sign = PlaybackButton::Sign;
    auto *start = named("startButton", new PlaybackButton(Sign::Start, tr("To the start"), tr("Home")));
    auto *back = named("backButton", new PlaybackButton(Sign::Back, tr("One step back"), tr("Left")));
    m_play = named("playButton", new PlaybackButton(Sign::Play, tr("Play"), QString()));
    auto *forward = named("forwardButton", new PlaybackButton(Sign::Forward, tr("One step forward"), tr("Right")));
    auto *end = named("endButton", new PlaybackButton(Sign::End, tr("To the end"), tr("End")));
    m_loop = named("loopButton", new PlaybackButton(Sign::Loop, tr("Loop"), QString()));
    m_play->setToolTip(tr("Play or pause (Space)"));
    m_loop->setToolTip(tr("Start again at the end (Ctrl+L)"));
    m_loop->setCheckable(true);
    m_loop->setChecked(true);
    connect(m_loop, &QToolButton::toggled, this, &Timeline::loopingChanged);
    for (PlaybackButton *button : {back, forward}) {
        button->setAutoRepeat(true);
    }
    connect(start, &QToolButton::clicked, this, &Timeline::toStart);
    connect(back, &QToolButton::clicked, this, &Timeline::stepBack);
    connect(m_play, &QToolButton::clicked, this, &Timeline::togglePlaying);
    connect(forward, &QToolButton::clicked, this, &Timeline::stepForward);
    connect(end, &QToolButton::clicked, this, &Timeline::toEnd);

    m_run = named("runButton", new QToolButton, tr("Run and speed"));
    m_run->setAutoRaise(true);
    m_run->setFocusPolicy(Qt::TabFocus);
    m_run->setToolTip(tr("Start, duration, steps, one turn, and the speed of playing (Ctrl+R)"));
    connect(m_run, &QToolButton::clicked, this, &Timeline::openRun);
    m_runForm = new RunForm(this);
    connect(m_runForm, &RunForm::edited, this, &Timeline::samplingEdited);
    connect(m_runForm, &RunForm::speedEdited, this, &Timeline::setSpeed);

    auto *playing = new QHBoxLayout;
    playing->setSpacing(2);
    for (PlaybackButton *button : {start, back, m_play, forward, end}) {
        playing->addWidget(button);
    }
    playing->addSpacing(8);
    playing->addWidget(m_loop);
    playing->addStretch(1);
    playing->addWidget(m_run);

    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 4, 6, 4);
    rows->setSpacing(3);
    rows->addLayout(scrubbing);
    rows->addLayout(playing);

    setSampling(m_sampling);
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
        restartClock(pose.time); // somebody scrubs while it plays
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
    m_play->setSign(PlaybackButton::Sign::Pause, tr("Pause"));
    emit playingChanged(true);
}

void Timeline::pause()
{
    if (!isPlaying()) {
        return;
    }
    m_frames.stop();
    m_play->setSign(PlaybackButton::Sign::Play, tr("Play"));
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
    m_speed = speed > 0.0 ? std::clamp(speed, kSlowestPlaying, kFastestPlaying) : kSlowestPlaying; // not a number, too
    m_runForm->setSpeed(m_speed);
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
    // An instant that is a sample up to rounding is that sample.
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

/// What opens it says what is chosen.
void Timeline::showRun()
{
    constexpr int kDigits = 3;
    m_run->setText(tr("%1 s · %2 ▾", "duration of the run, speed of playing")
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
