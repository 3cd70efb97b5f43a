// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/run_form.h"

#include "core/mechanism/turn.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/document/with.h"

#include <QGridLayout>
#include <QLabel>
#include <QScreen>
#include <QToolButton>

#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kMostSteps = 1e6; // of a warm start: with more, nobody gains

} // namespace

RunForm::RunForm(QWidget *parent)
    : QFrame(parent, Qt::Popup)
{
    named("runForm", this, tr("Run and speed"));
    setFrameShape(QFrame::StyledPanel);
    auto *grid = new QGridLayout(this);
    grid->setVerticalSpacing(4);

    m_start = addBox(grid, QStringLiteral("startBox"), tr("Start"), tr(" s"));
    m_start->setUnit(kSecond);
    m_start->setToolTip(tr("The first instant"));
    connect(m_start, &NumberBox::edited, this,
            [this](double seconds) { edit(with(m_sampling, &Sampling::start, seconds)); });

    m_duration = addBox(grid, QStringLiteral("durationBox"), tr("Duration"), tr(" s"));
    m_duration->setUnit(kSecond);
    m_duration->setRange({.smallest = 0.0, .isOpen = true});
    m_duration->setToolTip(tr("From the first instant to the last"));
    connect(m_duration, &NumberBox::edited, this,
            [this](double seconds) { edit(with(m_sampling, &Sampling::duration, seconds)); });
    m_oneTurn = named("oneTurnButton", new QToolButton);
    m_oneTurn->setText(tr("One turn"));
    m_oneTurn->setToolTip(tr("As long as the crank takes to turn round once"));
    grid->addWidget(m_oneTurn, 1, 2);
    connect(m_oneTurn, &QToolButton::clicked, this, [this] { edit(with(m_sampling, &Sampling::duration, turn())); });

    m_steps = addBox(grid, QStringLiteral("stepsBox"), tr("Steps"), QString());
    m_steps->setRange({.smallest = 1.0, .largest = kMostSteps, .isWhole = true});
    m_steps->setFixedDecimals(0);
    m_steps->setStep(1.0);
    m_steps->setToolTip(tr("Intervals; one instant more is computed"));
    connect(m_steps, &NumberBox::edited, this,
            [this](double steps) { edit(with(m_sampling, &Sampling::steps, static_cast<int>(steps))); });

    m_speedBox = addBox(grid, QStringLiteral("speedBox"), tr("Playing speed"), tr("×"));
    m_speedBox->setRange({.smallest = kSlowestPlaying, .largest = kFastestPlaying});
    m_speedBox->setToolTip(tr("Seconds of the motion in a second of the clock"));
    connect(m_speedBox, &NumberBox::edited, this, &RunForm::speedEdited);

    m_turnBox = addBox(grid, QStringLiteral("turnBox"), tr("A turn plays in"), tr(" s"));
    m_turnBox->setUnit(kSecond);
    m_turnBox->setToolTip(tr("Seconds of the clock for one turn of the crank"));
    connect(m_turnBox, &NumberBox::edited, this, [this](double seconds) { emit speedEdited(turn() / seconds); });

    setSampling(m_sampling);
    setSpeed(m_speed);
}

NumberBox *RunForm::addBox(QGridLayout *grid, const QString &objectName, const QString &name, const QString &suffix)
{
    auto *box = named(objectName, new NumberBox, name);
    box->setSuffix(suffix);
    auto *label = new QLabel(name);
    label->setBuddy(box);
    const int row = grid->count() == 0 ? 0 : grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1);
    return box;
}

void RunForm::setSampling(const Sampling &sampling)
{
    m_sampling = sampling;
    m_start->setValue(sampling.start);
    m_duration->setValue(sampling.duration);
    m_steps->setValue(sampling.steps);
}

void RunForm::setParameters(const Parameters &parameters)
{
    m_parameters = parameters;
    showTurn();
}

void RunForm::setSpeed(double speed)
{
    m_speed = speed;
    m_speedBox->setValue(speed);
    showTurn();
}

void RunForm::openAt(const QWidget &widget)
{
    adjustSize();
    const QRect room = widget.screen()->availableGeometry();
    QRect place(QPoint(), size());
    place.moveTopRight(widget.mapToGlobal(widget.rect().bottomRight()) + QPoint(0, 1));
    if (place.bottom() > room.bottom()) {
        place.moveBottom(widget.mapToGlobal(QPoint()).y() - 1);
    }
    place.moveLeft(std::max(place.left(), room.left()));
    move(place.topLeft());
    show();
    m_start->setFocus(Qt::PopupFocusReason);
    m_start->selectAll(); // what is typed replaces what is there
}

double RunForm::turn() const
{
    return kTurn / std::abs(m_parameters.omega2);
}

void RunForm::showTurn()
{
    const bool turns = m_parameters.omega2 != 0.0;
    m_oneTurn->setEnabled(turns);
    m_turnBox->setEnabled(turns);
    if (turns) {
        m_turnBox->setRange({.smallest = turn() / kFastestPlaying, .largest = turn() / kSlowestPlaying});
        m_turnBox->setValue(QString::number(turn() / m_speed, 'g', 15).toDouble()); // 3500, not 3499.9999999999995
    }
}

/// What the session will make of a run without length, or farther away than any parameter, helps nobody.
void RunForm::edit(const Sampling &sampling)
{
    const bool isUsable = sampling.duration > 0.0 && sampling.duration <= kLargestParameter;
    if (isUsable && sampling != m_sampling) {
        m_sampling = sampling;
        emit edited(sampling);
    }
    setSampling(m_sampling);
}

} // namespace slidercrank
