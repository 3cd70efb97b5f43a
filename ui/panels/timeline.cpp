// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline.h"

#include "core/mechanism/turn.h"
#include "core/sampling/crank_time.h"
#include "ui/document/session.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/widgets/popup_position.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QEvent>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kMaximumSteps = 1e6;

// Playback speed: seconds of the motion in a second of real time.
constexpr double kSlowestPlayback = 1e-9;
constexpr double kFastestPlayback = 1e9;

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the icon of the style in the text colour of the palette; its own colour is too dark on a dark background.
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

Timeline::Timeline(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_clock(steadySeconds)
{
    named("timeline", this, tr("Timeline"));
    constexpr std::chrono::milliseconds kFrameInterval{16}; // 60 frames per second
    m_frameTimer.setInterval(kFrameInterval);
    m_frameTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_frameTimer, &QTimer::timeout, this, &Timeline::nextFrame);
    createActions();
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kControlMargins);
    rows->setSpacing(kRowSpacing);
    rows->addLayout(createScrubbing());
    rows->addLayout(createButtons());
    createForm();
    drawIcons();
    connect(session, &Session::parametersChanged, this, &Timeline::showSettings);
    connect(session, &Session::settingsChanged, this, &Timeline::showSettings);
    connect(session, &Session::timeChanged, this, &Timeline::showTime);
    setSpeed(m_speed);
}

void Timeline::addAction(Command command, const QString &text, const QKeySequence &shortcut,
                         const std::function<void()> &act)
{
    auto *action = m_actions[command] = new QAction(text, this);
    action->setShortcut(shortcut);
    const QString name = QString(text).remove(u'&').remove(u'…');
    action->setToolTip(tr("%1 (%2)").arg(name, shortcut.toString(QKeySequence::NativeText)));
    if (act) {
        connect(action, &QAction::triggered, this, act);
    }
}

void Timeline::createActions()
{
    addAction(Play, tr("&Play or pause"), Qt::Key_Space, [this] { togglePlaying(); });
    m_actions[Play]->setAutoRepeat(false);
    addAction(Forward, tr("Step &forward"), Qt::Key_Right, [this] { stepTo(std::floor(currentStep() + 1.0)); });
    addAction(Back, tr("Step &back"), Qt::Key_Left, [this] { stepTo(std::ceil(currentStep() - 1.0)); });
    addAction(Start, tr("To the &start"), Qt::Key_Home, [this] { m_session->setTime(startTime()); });
    addAction(End, tr("To the &end"), Qt::Key_End, [this] { m_session->setTime(endTime()); });
    addAction(Loop, tr("&Loop"), Qt::CTRL | Qt::Key_L);
    m_actions[Loop]->setToolTip(tr("Start again at the end (Ctrl+L)"));
    m_actions[Loop]->setCheckable(true);
    m_actions[Loop]->setChecked(true);
    addAction(Faster, tr("F&aster"), Qt::SHIFT | Qt::Key_Right, [this] { setSpeed(2.0 * m_speed); });
    addAction(Slower, tr("Slo&wer"), Qt::SHIFT | Qt::Key_Left, [this] { setSpeed(0.5 * m_speed); });
    addAction(OpenTimeRange, tr("&Time range and speed…"), Qt::CTRL | Qt::Key_R, [this] { openTimeRange(); });
}

void Timeline::fillMenu(QMenu *menu)
{
    for (const Command command : {Play, Forward, Back, Start, End, Loop}) {
        menu->addAction(m_actions[command]);
    }
    menu->addSeparator();
    for (const Command command : {Faster, Slower, OpenTimeRange}) {
        menu->addAction(m_actions[command]);
    }
}

QLayout *Timeline::createScrubbing()
{
    const auto makeBox = [](const char *name, const QString &spoken, const QString &explanation, const QString &suffix,
                            const Unit &unit) {
        auto *box = named(name, new NumberBox, spoken);
        box->setToolTip(explanation);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setSuffix(suffix);
        box->setUnit(unit);
        return box;
    };
    m_timeBox = makeBox("timeBox", tr("Time in seconds"), tr("Time"), tr(" s"), kSecond);
    connect(m_timeBox, &NumberBox::edited, m_session, &Session::setTime);

    constexpr double kLargestAngle = 1e300; // larger than any angle that a mechanism reaches
    m_angleBox = makeBox(
        "angleBox", tr("Crank angle"),
        tr("Crank angle: type one to go to the nearest time at which the crank passes it, or to turn a crank at "
           "rest"),
        {}, kDegree);
    m_angleBox->setRange(-kLargestAngle, kLargestAngle);
    refreshNotation();
    connect(m_angleBox, &NumberBox::edited, this, &Timeline::goToAngle);

    m_slider = named("timeSlider", new NumberSlider, tr("Time, slider"));
    m_slider->setSuffix(tr(" s"));
    constexpr int kMinSliderWidth = 60; // px, so that times can still be chosen
    m_slider->setMinimumWidth(kMinSliderWidth);
    connect(m_slider, &NumberSlider::valueChanged, this,
            [this](int step) { m_session->setTime(m_session->sampling().timeStamp(step)); });

    auto *row = new QHBoxLayout;
    row->setSpacing(kFormSpacing);
    for (const auto &[text, box] : {std::pair{tr("t"), m_timeBox}, {tr("θ₂"), m_angleBox}}) {
        auto *label = new QLabel(text);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box);
    }
    row->insertWidget(2, m_slider, 1); // behind "t" and its box
    return row;
}

QLayout *Timeline::createButtons()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(kDenseSpacing);
    const auto addToolButton = [row](const char *name, QAction *action) {
        auto *button = named(name, new QToolButton);
        if (action) {
            button->setDefaultAction(action);
        }
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        return button;
    };
    addToolButton("startButton", m_actions[Start]);
    addToolButton("backButton", m_actions[Back])->setAutoRepeat(true);
    m_playButton = addToolButton("playButton", m_actions[Play]);
    addToolButton("forwardButton", m_actions[Forward])->setAutoRepeat(true);
    addToolButton("endButton", m_actions[End]);
    constexpr int kBesideStepping = 8; // px, because the loop is a choice and no step
    row->addSpacing(kBesideStepping);
    addToolButton("loopButton", m_actions[Loop]);
    row->addStretch(1);
    m_offerButton = addToolButton("oneTurnOffer", nullptr);
    m_offerButton->setText(tr("One revolution"));
    m_offerButton->hide();
    connect(m_offerButton, &QToolButton::clicked, this, &Timeline::showOneRevolution);
    m_timeRangeButton = addToolButton("runButton", nullptr);
    m_timeRangeButton->setAccessibleName(tr("Time range and speed"));
    m_timeRangeButton->setToolTip(
        tr("Start, duration, steps, one revolution, and the playback speed (Ctrl+R). A fast crank is slowed "
           "to four seconds a revolution."));
    connect(m_timeRangeButton, &QToolButton::clicked, this, &Timeline::openTimeRange);
    return row;
}

/// Creates the form of the time range and the speed, which opens below its button.
void Timeline::createForm()
{
    m_form = named("runForm", new QFrame(this, Qt::Popup), tr("Time range and speed"));
    m_form->setFrameShape(QFrame::StyledPanel);
    auto *form = new QFormLayout(m_form);
    form->setVerticalSpacing(kFormSpacing);
    m_startBox = addField(form, "startBox", tr("Start"), new NumberBox, tr("The first time step"));
    m_durationBox =
        addField(form, "durationBox", tr("Duration"), new NumberBox, tr("From the first time step to the last"));
    m_durationBox->setPositiveRange(kSmallestPositive, kLargestParameter);
    m_oneRevolutionButton = named("oneTurnButton", new QToolButton);
    m_oneRevolutionButton->setText(tr("One revolution"));
    m_oneRevolutionButton->setToolTip(tr("Sets the duration to one revolution of the crank"));
    form->addRow(QString(), m_oneRevolutionButton);
    m_stepsBox = addField(form, "stepsBox", tr("Steps"), new NumberBox,
                          tr("Number of intervals: the motion is computed at one instant more, both ends included"));
    m_stepsBox->setRange(1.0, kMaximumSteps);
    m_stepsBox->setFixedDecimals(0);
    m_speedBox = addField(form, "speedBox", tr("Playback speed"), new NumberBox,
                          tr("Seconds of the motion in a second of real time"));
    m_speedBox->setSuffix(tr("×"));
    m_speedBox->setPositiveRange(kSlowestPlayback, kFastestPlayback);
    for (NumberBox *box : {m_startBox, m_durationBox}) {
        box->setSuffix(tr(" s"));
        box->setUnit(kSecond);
    }
    for (const NumberBox *box : {m_startBox, m_durationBox, m_stepsBox}) {
        connect(box, &NumberBox::edited, this, &Timeline::editSampling);
    }
    connect(m_oneRevolutionButton, &QToolButton::clicked, this, &Timeline::showOneRevolution);
    connect(m_speedBox, &NumberBox::edited, this, &Timeline::setSpeed);
}

void Timeline::drawIcons()
{
    using enum QStyle::StandardPixmap;
    for (const auto &[command, symbol] : {std::pair{Start, SP_MediaSkipBackward},
                                          {Back, SP_MediaSeekBackward},
                                          {Play, isPlaying() ? SP_MediaPause : SP_MediaPlay},
                                          {Forward, SP_MediaSeekForward},
                                          {End, SP_MediaSkipForward},
                                          {Loop, SP_BrowserReload}}) {
        m_actions[command]->setIcon(colouredIcon(*this, symbol));
    }
    for (QToolButton *button : findChildren<QToolButton *>()) {
        button->setIconSize(QSize(1, 1) * fontMetrics().height());
    }
    m_playButton->setAccessibleName(isPlaying() ? tr("Pause") : tr("Play"));
}

void Timeline::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitTimeRangeButton();
}

void Timeline::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        drawIcons();
    }
}

double Timeline::startTime() const
{
    return m_session->sampling().start;
}

double Timeline::endTime() const
{
    return startTime() + m_session->sampling().duration;
}

double Timeline::revolutionTime() const
{
    return kTurn / std::abs(m_session->parameters().omega2);
}

bool Timeline::isFast() const
{
    constexpr double kFastRevolution = 0.2; // s: five revolutions in the usual time range of a second
    return revolutionTime() < kFastRevolution;
}

/// Returns the speed of the playback. At a chosen speed of 1, a revolution of a fast crank takes four seconds.
double Timeline::playbackSpeed() const
{
    constexpr double kSecondsPerRevolution = 4.0;
    return isFast() ? m_speed * revolutionTime() / kSecondsPerRevolution : m_speed;
}

void Timeline::showOneRevolution()
{
    m_durationBox->setValue(revolutionTime());
    editSampling();
}

void Timeline::showSettings()
{
    const auto &[start, duration, steps] = m_session->sampling();
    const double step = duration / steps;
    constexpr int kMinDecimals = 3;
    constexpr int kMaxDecimals = 9;
    constexpr int kPages = 20;
    const int decimals = // two digits of the step
        std::clamp(1 - static_cast<int>(std::floor(std::log10(step))), kMinDecimals, kMaxDecimals);
    m_timeBox->setFixedDecimals(decimals);
    m_timeBox->setStep(step);
    m_slider->setScale(start, step, 0, steps);
    m_slider->setPageStep(std::max(1, steps / kPages));
    m_startBox->setValue(start);
    m_durationBox->setValue(duration);
    m_stepsBox->setValue(steps);
    m_speedBox->setValue(m_speed);
    m_oneRevolutionButton->setEnabled(revolutionTime() <= kLargestParameter);
    showOffer();
    fitTimeRangeButton();
    showTime();
}

/// Writes the duration and the speed on the button of the time range, if there is space beside the other buttons.
void Timeline::fitTimeRangeButton()
{
    constexpr int kDigits = 3;
    const double duration = m_session->sampling().duration;
    m_timeRangeButton->setText(tr("%1 s · %2× ▾", "duration, playback speed")
                                   .arg(numberText(duration, kDigits), numberText(playbackSpeed(), kDigits)));
    if (layout()->minimumSize().width() > width()) {
        m_timeRangeButton->setText("▾");
    }
}

/// Offers a time range of one revolution if the crank is fast and makes many, or if it makes only a part of one and so
/// does not reach every angle.
void Timeline::showOffer()
{
    constexpr double kManyRevolutions = 5.0;
    constexpr double kWholeRevolution = 0.99; // a second at 6.28 rad/s counts as one
    const double revolutions = m_session->sampling().duration / revolutionTime();
    const bool showsMany = isFast() && revolutions > kManyRevolutions;
    const bool showsPart = revolutions < kWholeRevolution && revolutionTime() <= kLargestParameter;
    m_offerButton->setVisible(showsMany || showsPart);
    m_offerButton->setToolTip(
        showsMany ? tr("The crank is fast: shows one revolution, which takes four seconds when it is played")
                  : tr("The time range is only a part of a revolution: shows one revolution"));
}

void Timeline::editSampling()
{
    m_session->setSampling({m_startBox->value(), m_durationBox->value(), static_cast<int>(m_stepsBox->value())});
    showSettings(); // also if nothing has changed
}

void Timeline::play()
{
    if (!isPlaying()) {
        if (m_session->time() >= endTime()) {
            m_session->setTime(startTime());
        }
        m_lastFrame = m_clock();
        m_frameTimer.start();
        drawIcons();
    }
}

void Timeline::pause()
{
    m_frameTimer.stop();
    drawIcons();
}

void Timeline::setSpeed(double speed)
{
    m_speed = std::clamp(speed, kSlowestPlayback, kFastestPlayback);
    showSettings();
}

void Timeline::openTimeRange()
{
    m_form->adjustSize();
    m_form->move(popupPosition(*m_timeRangeButton, m_form->size()));
    m_form->show();
    m_startBox->setFocus(Qt::PopupFocusReason);
    m_startBox->selectAll();
}

void Timeline::nextFrame()
{
    const double now = m_clock();
    const double time = m_session->time() + playbackSpeed() * (now - std::exchange(m_lastFrame, now));
    const bool isOver = time >= endTime() && !m_actions[Loop]->isChecked();
    m_session->setTime(
        time < endTime() || isOver ? time : startTime() + std::fmod(time - startTime(), endTime() - startTime()));
    if (isOver) {
        pause();
    }
}

/// Returns the number of the current time step; not a whole number between two steps. A number that is whole except for
/// rounding errors is rounded.
double Timeline::currentStep() const
{
    constexpr double kTolerance = 1e-6; // time steps
    const auto &[start, duration, count] = m_session->sampling();
    const double steps = std::clamp((m_session->time() - start) / duration, 0.0, 1.0) * count;
    const double nearest = std::round(steps);
    return std::abs(steps - nearest) < kTolerance ? nearest : steps;
}

void Timeline::stepTo(double step)
{
    pause();
    m_session->setTime(m_session->sampling().timeStamp(static_cast<int>(step)));
}

void Timeline::refreshNotation()
{
    const bool isRadian = notation().units.angle == AngleUnit::Radian;
    m_angleBox->setSuffix(isRadian ? tr(" rad") : tr("°"));
    m_angleBox->setUnit(isRadian ? kRadian : kDegree);
    constexpr int kDecimalsOfRadians = 4;
    constexpr int kDecimalsOfDegrees = 2;
    constexpr double kStepInRadians = 0.02;
    constexpr double kStepInDegrees = 1.0;
    m_angleBox->setFixedDecimals(isRadian ? kDecimalsOfRadians : kDecimalsOfDegrees);
    m_angleBox->setStep(isRadian ? kStepInRadians : kStepInDegrees);
}

void Timeline::goToAngle(double angle)
{
    constexpr double kMaxStep = 12.0 / kDegreesPerRadian; // Page Up and Page Down: ten steps of the box
    const Parameters &parameters = m_session->parameters();
    const double currentTheta2 = m_session->pose().motion.theta2;
    const double shownTheta2 = degreesFromZero(currentTheta2) / kDegreesPerRadian;
    double theta2 = coreValue(Measure::Angle, angle, notation().units);
    if (std::abs(theta2 - shownTheta2) < kMaxStep) { // a step of the box stays in the current revolution
        theta2 += currentTheta2 - shownTheta2;
    }
    if (parameters.omega2 == 0.0) { // at rest: the box turns the crank
        m_session->setParameter(Parameter::Theta20, theta2);
        showTime();
        return;
    }
    const double time = (theta2 - parameters.theta20) / parameters.omega2; // of exactly this angle, not modulo 2π
    m_session->setTime(
        time >= startTime() && time <= endTime()
            ? time
            : nearestTimeAtCrankAngle(Mechanism(parameters), m_session->sampling(), theta2, m_session->time()));
}

void Timeline::showTime()
{
    const Pose pose = m_session->pose();
    m_timeBox->setValue(pose.time);
    m_angleBox->setValue(shownCrankAngle(pose.motion.theta2));
    m_slider->setNumber(pose.time);
}

} // namespace slidercrank

#include "moc_timeline.cpp"
