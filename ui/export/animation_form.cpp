// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_form.h"

#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <cmath>

namespace slidercrank
{

AnimationForm::AnimationForm(const Animation &animation, QWidget *parent)
    : QDialog(parent)
    , m_animation(animation)
    , m_frameRate(makeBox("rateBox", 1, 240, animation.framesPerSecond))
    , m_width(makeBox("widthBox", 64, 7680, animation.pixels().width()))
    , m_height(makeBox("heightBox", 64, 7680, animation.pixels().height()))
    , m_duration(named("lengthBox", new NumberBox))
    , m_summary(named("outcomeLabel", new QLabel))
{
    named("animationForm", this);
    setWindowTitle(tr("Export animation"));
    constexpr double kLongest = 1e9; // s
    m_duration->setRange(0.0, kLongest);
    m_duration->setSuffix(tr(" s of the motion"));
    m_duration->setUnit(kSecond);
    m_duration->setValue(std::abs(animation.duration));
    connect(m_duration, &NumberBox::edited, this, &AnimationForm::showSummary);
    for (QSpinBox *box : {m_width, m_height}) {
        box->setSuffix(tr(" px"));
    }
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *form = new QFormLayout(this);
    form->addRow(tr("Frames per second"), m_frameRate);
    form->addRow(tr("Width"), m_width);
    form->addRow(tr("Height"), m_height);
    form->addRow(tr("Length"), m_duration);
    form->addRow(m_summary);
    if (!hasVideoEncoder()) {
        auto *hint = named("encoderHint", new QLabel(tr("Videos need the program ffmpeg, which is not installed. "
                                                        "Without it, the frames are written as pictures.")));
        hint->setWordWrap(true);
        form->addRow(hint);
    }
    form->addRow(buttons);
    showSummary();
}

QSpinBox *AnimationForm::makeBox(const QString &objectName, int smallest, int largest, int value)
{
    auto *box = new QSpinBox(this);
    box->setObjectName(objectName);
    box->setRange(smallest, largest);
    box->setValue(value);
    connect(box, &QSpinBox::valueChanged, this, &AnimationForm::showSummary);
    return box;
}

Animation AnimationForm::animation() const
{
    Animation chosen = m_animation;
    chosen.framesPerSecond = m_frameRate->value();
    chosen.size = videoSize({m_width->value(), m_height->value()});
    chosen.duration = std::copysign(m_duration->value(), m_animation.duration);
    return chosen;
}

void AnimationForm::showSummary()
{
    constexpr int kDigits = 3;
    const Animation chosen = animation();
    const bool fits = chosen.frameCount() <= Animation::kMaxFrames;
    m_summary->setText(
        fits
            ? tr("%n frames: %1 s at the playback speed of %2×.", nullptr, static_cast<int>(chosen.frameCount()))
                  .arg(numberText(std::abs(chosen.duration) / chosen.speed, kDigits), numberText(chosen.speed, kDigits))
            : tr("More than %1 frames: choose a shorter length, fewer frames per second or a higher playback speed.")
                  .arg(QString::number(Animation::kMaxFrames)));
    m_export->setEnabled(fits);
}

} // namespace slidercrank

#include "moc_animation_form.cpp"
