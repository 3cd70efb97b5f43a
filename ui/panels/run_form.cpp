// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/run_form.h"

#include "core/mechanism/turn.h"
#include "ui/document/session.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/popup_position.h"

#include <QFormLayout>
#include <QToolButton>

#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kMaximumSteps = 1e6;

} // namespace

RunForm::RunForm(Session *session, QWidget *parent)
    : QFrame(parent, Qt::Popup)
    , m_session(session)
{
    named("runForm", this, tr("Time range and speed"));
    setFrameShape(QFrame::StyledPanel);
    auto *form = new QFormLayout(this);
    form->setVerticalSpacing(4);
    m_start = addField(form, "startBox", tr("Start"), new NumberBox, tr("The first time step"));
    m_duration =
        addField(form, "durationBox", tr("Duration"), new NumberBox, tr("From the first time step to the last"));
    m_duration->setRange({.smallest = 0.0, .isOpen = true});
    m_oneTurn = named("oneTurnButton", new QToolButton);
    m_oneTurn->setText(tr("One revolution"));
    m_oneTurn->setToolTip(tr("Sets the duration to one revolution of the crank"));
    form->addRow(QString(), m_oneTurn);
    m_steps = addField(form, "stepsBox", tr("Steps"), new NumberBox, tr("Intervals; there is one time step more"));
    m_steps->setRange({.smallest = 1.0, .largest = kMaximumSteps, .isWhole = true});
    m_steps->setFixedDecimals(0);
    m_steps->setStep(1.0);
    m_speedBox = addField(form, "speedBox", tr("Playback speed"), new NumberBox,
                          tr("Seconds of the motion in a second of real time"));
    m_speedBox->setSuffix(tr("×"));
    m_speedBox->setRange({.smallest = kSlowestPlayback, .largest = kFastestPlayback});
    m_revolution = addField(form, "turnBox", tr("Playback time per revolution"), new NumberBox,
                            tr("Real time in which one revolution of the crank is played"));
    for (NumberBox *box : {m_start, m_duration, m_revolution}) {
        box->setSuffix(tr(" s"));
        box->setUnit(kSecond);
    }
    for (NumberBox *box : {m_start, m_duration, m_steps}) {
        connect(box, &NumberBox::edited, this, &RunForm::edit);
    }
    connect(m_oneTurn, &QToolButton::clicked, this, [this] {
        m_duration->setValue(revolution());
        edit();
    });
    connect(m_speedBox, &NumberBox::edited, this, &RunForm::speedEdited);
    connect(m_revolution, &NumberBox::edited, this,
            [this](double seconds) { emit speedEdited(revolution() / seconds); });
    connect(session, &Session::settingsChanged, this, &RunForm::showSettings);
    connect(session, &Session::parametersChanged, this, &RunForm::showSettings);
    showSettings();
}

void RunForm::setSpeed(double speed)
{
    m_speed = speed;
    showSettings();
}

void RunForm::openAt(const QWidget &widget)
{
    adjustSize();
    move(popupPosition(widget, size()));
    show();
    m_start->setFocus(Qt::PopupFocusReason);
    m_start->selectAll();
}

double RunForm::revolution() const
{
    return kTurn / std::abs(m_session->parameters().omega2);
}

void RunForm::showSettings()
{
    const auto &[start, duration, steps] = m_session->sampling();
    m_start->setValue(start);
    m_duration->setValue(duration);
    m_steps->setValue(steps);
    m_speedBox->setValue(m_speed);
    const bool turns = m_session->parameters().omega2 != 0.0;
    m_oneTurn->setEnabled(revolution() <= kLargestParameter);
    m_revolution->setEnabled(turns);
    if (turns) {
        m_revolution->setRange(
            {.smallest = revolution() / kFastestPlayback, .largest = revolution() / kSlowestPlayback});
        m_revolution->setValue(
            QString::number(revolution() / m_speed, 'g', 15).toDouble()); // 3500, not 3499.9999999999995
    }
}

void RunForm::edit()
{
    m_session->setSampling({m_start->value(), m_duration->value(), static_cast<int>(m_steps->value())});
    showSettings(); // also if nothing has changed
}

} // namespace slidercrank
