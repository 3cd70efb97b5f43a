// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/design_form.h"

#include "ui/text/design_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/widgets/paragraph.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

Lengths lengthsOf(const Parameters &parameters)
{
    return {parameters.a, parameters.b, parameters.c};
}

} // namespace

DesignForm::DesignForm(QWidget *parent)
    : QWidget(parent)
    , m_stroke(named("designStroke", new NumberBox))
    , m_timeRatio(named("designTimeRatio", new NumberBox))
    , m_transmissionAngle(named("designTransmissionAngle", new NumberBox))
    , m_ratio(named("designRatio", new NumberSlider))
    , m_best(named("designBest", new QToolButton))
    , m_lengths(named("designLengths", plainText()))
    , m_refusal(named("designRefusal", plainText()))
{
    named("designForm", this, tr("Mechanism with a given stroke and time ratio"));
    m_stroke->setSuffix(tr(" mm"));
    m_stroke->setUnit(kMillimetre);
    m_stroke->setToolTip(tr("Type a stroke: the mechanism is scaled, so that its time ratio and angles stay"));
    m_timeRatio->setToolTip(
        tr("Type a time ratio: the mechanism with the largest minimum transmission angle is chosen, the stroke "
           "stays. A ratio below 1 exchanges the forward and the return stroke."));
    m_transmissionAngle->setSuffix(QStringLiteral("°"));
    m_transmissionAngle->setUnit(kDegree);
    m_transmissionAngle->setToolTip(
        tr("Type the smallest transmission angle that you accept: the mechanism with the largest "
           "minimum transmission angle is chosen, stroke and time ratio stay"));
    for (NumberBox *box : {m_stroke, m_timeRatio, m_transmissionAngle}) {
        box->setRange({.smallest = 0.0, .isOpen = true});
    }
    m_ratio->setToolTip(tr("The freedom that stroke and time ratio leave: the ratio b/a of coupler and crank"));
    m_ratio->setMinimumWidth(120);
    m_best->setText(tr("Best transmission angle"));
    m_best->setToolTip(
        tr("The ratio b/a with the largest minimum transmission angle, at most %1").arg(kLongestCoupler));
    m_best->setFocusPolicy(Qt::TabFocus);
    connect(m_stroke, &NumberBox::edited, this, &DesignForm::requestStroke);
    connect(m_timeRatio, &NumberBox::edited, this, &DesignForm::requestTimeRatio);
    connect(m_transmissionAngle, &NumberBox::edited, this, &DesignForm::requestTransmissionAngle);
    connect(m_ratio, &QSlider::valueChanged, this,
            [this] { apply(findLengths(m_wanted.stroke, m_wanted.timeRatio, m_ratio->number())); });
    connect(m_ratio, &QSlider::sliderPressed, this, &DesignForm::dragBegan);
    connect(m_ratio, &QSlider::sliderReleased, this, &DesignForm::dragEnded);
    connect(m_best, &QToolButton::clicked, this, [this] { requestDesign(m_wanted); });

    auto *form = new QFormLayout;
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    const auto addRow = [form](const QString &name, QWidget *field) {
        field->setAccessibleName(name);
        form->addRow(name, field);
    };
    addRow(tr("Stroke"), m_stroke);
    addRow(tr("Time ratio"), m_timeRatio);
    addRow(tr("Minimum transmission angle"), m_transmissionAngle);
    addRow(tr("Ratio b/a"), m_ratio);
    auto *outcome = new QVBoxLayout;
    outcome->addWidget(m_lengths);
    outcome->addWidget(m_best);
    outcome->addWidget(m_refusal);
    outcome->addStretch(1);
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(4, 0, 0, 0);
    columns->setSpacing(20);
    columns->addLayout(form);
    columns->addLayout(outcome, 1);
}

void DesignForm::setResult(const Result &result)
{
    const Parameters &parameters = result.mechanism.parameters();
    m_limits = result.limits;
    if (parameters != m_parameters || m_wanted.stroke == 0.0) { // otherwise the request is unchanged and free of rounding errors
        m_parameters = parameters;
        m_wanted.stroke = m_limits.stroke.value_or(0.0) > 0.0 ? *m_limits.stroke : m_wanted.stroke;
        const double timeRatio = m_limits.timeRatio.value_or(1.0);
        m_wanted.timeRatio = parameters.c < 0.0 ? 1.0 / timeRatio : timeRatio;
        m_refusal->clear();
    }
    showWanted();
}

void DesignForm::showWanted()
{
    const bool turns = m_limits.mobility == Mobility::FullTurn;
    const double ratio = m_parameters.b / m_parameters.a;
    m_stroke->setValue(m_wanted.stroke);
    m_timeRatio->setValue(std::max(m_wanted.timeRatio, 1.0 / m_wanted.timeRatio));
    const std::optional<DesignRange> range = findDesignRange(m_wanted.timeRatio);
    const double best = range ? range->bestTransmissionAngle : 0.0;
    m_transmissionAngle->setValue(turns ? 90.0 - kDegreesPerRadian * m_limits.largestPressureAngle : kDegreesPerRadian * best);
    m_ratio->setEnabled(turns && range);
    m_best->setEnabled(range.has_value());
    const auto number = [](double value) { return numberText(value, 5); };
    QString text = tr("b/a = %1.").arg(number(ratio));
    if (!turns) {
        text += u' ' + tr("The crank does not make full turns: there is no time ratio.");
    } else if (range) {
        const double last = std::min(range->largestRatio, std::max(kLongestCoupler, ratio));
        const double step = nextRoundNumber((last - 1.0) / 500.0);
        const QSignalBlocker quiet(m_ratio);
        m_ratio->setScale(1.0, step);
        m_ratio->setRange(1,
                          std::max(1, static_cast<int>(std::ceil((last - 1.0) / step)) - 1)); // both ends are excluded
        m_ratio->setValue(m_ratio->positionOf(ratio));
        text += u' ' + tr("With this time ratio the minimum transmission angle is largest, %1°, for b/a = %2.")
                           .arg(number(kDegreesPerRadian * best), number(range->bestRatio));
    }
    m_lengths->setText(text);
}

void DesignForm::requestStroke(double stroke)
{
    if (m_limits.stroke.value_or(0.0) == 0.0) { // there is no stroke to scale
        DesignRequest request = m_wanted;
        request.stroke = stroke;
        requestDesign(request);
        return;
    }
    const double scale = stroke / m_wanted.stroke;
    const auto &[a, b, c] = lengthsOf(m_parameters);
    m_wanted.stroke = stroke;
    apply({scale * a, scale * b, scale * c});
}

/// The slower stroke remains the same one, unless the ratio is below 1.
void DesignForm::requestTimeRatio(double timeRatio)
{
    DesignRequest request = m_wanted;
    request.timeRatio = m_parameters.c < 0.0 ? 1.0 / timeRatio : timeRatio;
    requestDesign(request);
}

void DesignForm::requestTransmissionAngle(double degrees)
{
    DesignRequest request = m_wanted;
    request.transmissionAngle = degrees / kDegreesPerRadian;
    requestDesign(request);
}

void DesignForm::requestDesign(const DesignRequest &request)
{
    const std::variant<Lengths, DesignFault> designed = design(request);
    if (const DesignFault *fault = std::get_if<DesignFault>(&designed)) {
        refuse(designFaultText(*fault, request));
        return;
    }
    m_wanted = request;
    m_wanted.transmissionAngle.reset();
    apply(std::get<Lengths>(designed));
}

void DesignForm::refuse(const QString &sentence)
{
    m_refusal->setText(QStringLiteral("⚠ ") + sentence);
    setInk(*m_refusal, seriesColours(palette()).warning);
    showWanted();
}

void DesignForm::apply(const Lengths &lengths)
{
    Parameters wanted = m_parameters;
    wanted.a = lengths.a;
    wanted.b = lengths.b;
    wanted.c = lengths.c;
    if (findFault(wanted)) {
        refuse(tr("No length may be below 10⁻⁹ mm or above 10¹² mm."));
        return;
    }
    m_refusal->clear();
    m_parameters = wanted;
    emit edited(wanted);
    showWanted(); // also if the parameters are unchanged
}

} // namespace slidercrank
