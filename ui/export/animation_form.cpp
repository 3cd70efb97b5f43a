// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_form.h"

#include "core/mechanism/turn.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kMostFramesPerSecond = 240.0;
constexpr double kNarrowestFrame = 64.0; // px
constexpr double kWidestFrame = 7680.0;

/// Videos want even sides.
int even(double side)
{
    return 2 * static_cast<int>(side / 2.0);
}

} // namespace

AnimationForm::AnimationForm(const Animation &animation, const Parameters &parameters, QWidget *parent)
    : QDialog(parent)
    , m_animation(animation)
    , m_turn(kTurn / std::abs(parameters.omega2))
{
    named("animationForm", this);
    setWindowTitle(tr("Export animation"));
    auto *grid = new QGridLayout(this);

    m_rate = addWholeBox(QStringLiteral("rateBox"), tr("Frames per second"), 1.0, kMostFramesPerSecond);
    m_rate->setValue(animation.framesPerSecond);
    m_width = addWholeBox(QStringLiteral("widthBox"), tr("Width"), kNarrowestFrame, kWidestFrame);
    m_height = addWholeBox(QStringLiteral("heightBox"), tr("Height"), kNarrowestFrame, kWidestFrame);
    for (NumberBox *box : {m_width, m_height}) {
        box->setSuffix(tr(" px"));
        box->setStep(2.0);
    }
    m_width->setValue(even(animation.size.size.width() * animation.size.scale));
    m_height->setValue(even(animation.size.size.height() * animation.size.scale));

    m_length = named("lengthBox", new NumberBox, tr("Length"));
    m_length->setRange({.smallest = 0.0, .isOpen = true});
    auto *label = new QLabel(tr("Length"));
    label->setBuddy(m_length);
    m_unit = named("lengthUnitBox", new QComboBox, tr("Unit of the length"));
    m_unit->addItem(tr("s of the motion"));
    if (std::isfinite(m_turn)) {
        m_unit->addItem(tr("revolutions"));
    }
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(m_length, row, 1);
    grid->addWidget(m_unit, row, 2);
    connect(m_length, &NumberBox::edited, this, [this](double length) {
        m_animation.duration = std::copysign(length * perUnit(), m_animation.duration);
        showOutcome();
    });
    connect(m_unit, &QComboBox::currentIndexChanged, this,
            [this] { m_length->setValue(std::abs(m_animation.duration) / perUnit()); });
    m_length->setValue(std::abs(animation.duration));

    m_outcome = named("outcomeLabel", new QLabel);
    m_outcome->setWordWrap(true);
    grid->addWidget(m_outcome, row + 1, 0, 1, 3);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
    grid->addWidget(buttons, row + 2, 0, 1, 3);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showOutcome();
    m_rate->selectAll(); // what is typed replaces what is there
}

NumberBox *AnimationForm::addWholeBox(const QString &objectName, const QString &name, double smallest, double largest)
{
    auto *grid = static_cast<QGridLayout *>(layout());
    auto *box = named(objectName, new NumberBox, name);
    box->setRange({.smallest = smallest, .largest = largest, .isWhole = true});
    box->setFixedDecimals(0);
    box->setStep(1.0);
    auto *label = new QLabel(name);
    label->setBuddy(box);
    const int row = grid->count() == 0 ? 0 : grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1);
    connect(box, &NumberBox::edited, this, &AnimationForm::showOutcome);
    return box;
}

Animation AnimationForm::animation() const
{
    Animation animation = m_animation;
    animation.framesPerSecond = static_cast<int>(m_rate->value());
    animation.size.size =
        QSizeF(even(m_width->value()) / animation.size.scale, even(m_height->value()) / animation.size.scale).toSize();
    return animation;
}

void AnimationForm::accept()
{
    for (NumberBox *box : {m_rate, m_width, m_height, m_length}) {
        if (box->isTyping()) {
            box->setFocus();
            return;
        }
    }
    QDialog::accept();
}

double AnimationForm::perUnit() const
{
    return m_unit->currentIndex() == Turns ? m_turn : 1.0;
}

void AnimationForm::showOutcome()
{
    const Animation chosen = animation();
    const bool fits = chosen.frameCount() <= Animation::kMostFrames;
    m_outcome->setText(
        fits ? tr("%1 frames: %2 s at the playback speed of %3×.")
                   .arg(countText(static_cast<std::size_t>(chosen.frameCount())),
                        numberText(std::abs(chosen.duration) / chosen.speed, 3), numberText(chosen.speed, 3))
             : tr("More than %1 frames: choose a shorter length, fewer frames per second or a higher playback speed.")
                   .arg(countText(Animation::kMostFrames)));
    m_export->setEnabled(fits);
}

} // namespace slidercrank
