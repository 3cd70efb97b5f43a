// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/design_form.h"

#include "core/limits/mobility.h"
#include "ui/document/session.h"
#include "ui/document/with.h"
#include "ui/text/design_text.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/spacing.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

DesignForm::DesignForm(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_keepsLinks(named("designKeepsLinks", new QCheckBox))
    , m_bestButton(named("designBest", new QToolButton))
    , m_ratioText(named("designLengths", plainText()))
    , m_refusal(named("designRefusal", plainText()))
{
    named("designForm", this, tr("Mechanism with a given stroke and time ratio"));
    createControls();
    connect(m_stroke, &NumberBox::edited, this,
            [this](double stroke) { requestStroke(coreValue(Measure::Length, stroke, notation().units)); });
    connect(m_timeRatio, &NumberBox::edited, this, [this](double timeRatio) {
        // A ratio above 1 leaves the direction of the slower stroke unchanged; a ratio below 1 reverses it.
        const double directedRatio = m_parameters.c < 0.0 ? 1.0 / timeRatio : timeRatio;
        if (m_keepsLinks->isChecked()) {
            requestOffset(directedRatio);
        } else {
            requestDesign(with(m_request, &DesignRequest::timeRatio, directedRatio));
        }
    });
    connect(m_transmissionAngle, &NumberBox::edited, this, [this](double angle) {
        requestDesign(
            with(m_request, &DesignRequest::transmissionAngle, coreValue(Measure::Angle, angle, notation().units)));
    });
    connect(m_ratio, &QSlider::valueChanged, this,
            [this] { apply(findLengths(m_request.stroke, m_request.timeRatio, m_ratio->number())); });
    connect(m_ratio, &QSlider::sliderPressed, session, &Session::beginDrag);
    connect(m_ratio, &QSlider::sliderReleased, session, &Session::endDrag);
    connect(m_bestButton, &QToolButton::clicked, this, [this] { requestDesign(m_request); });
    connect(session, &Session::parametersChanged, this, &DesignForm::showParameters);
    connect(session, &Session::resultChanged, this, &DesignForm::showParameters); // also after a change of units
}

void DesignForm::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    showParameters();
}

void DesignForm::createControls()
{
    auto *form = new QFormLayout;
    form->setVerticalSpacing(kFormSpacing);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    m_stroke = addField(form, "designStroke", tr("Stroke"), new NumberBox,
                        tr("Type a stroke: the mechanism is scaled; its time ratio and its angles do not change"));
    m_timeRatio = addField(
        form, "designTimeRatio", tr("Time ratio"), new NumberBox,
        tr("Type a time ratio: the mechanism with the largest minimum transmission angle is chosen, the stroke "
           "stays. A ratio below 1 exchanges the forward and the return stroke."));
    m_keepsLinks->setText(tr("keep a and b"));
    m_keepsLinks->setToolTip(tr("A time ratio changes the offset c alone; the stroke follows"));
    form->addRow(QString(), m_keepsLinks);
    m_transmissionAngle = addField(form, "designTransmissionAngle", tr("Minimum transmission angle"), new NumberBox,
                                   tr("Type the smallest transmission angle that you accept: the mechanism with the "
                                      "largest minimum transmission angle is chosen, stroke and time ratio stay"));
    for (NumberBox *box : {m_stroke, m_timeRatio, m_transmissionAngle}) {
        box->setWidestNumber(QStringLiteral("0000.00000000")); // these are computed, and have many digits
        box->setPositiveRange(kSmallestPositive, kLargestParameter);
    }
    m_ratio = addField(form, "designRatio", tr("Ratio b/a"), new NumberSlider,
                       tr("The remaining degree of freedom: the ratio b/a of coupler and crank"));
    constexpr int kMinSliderWidth = 120; // px, so that ratios can be chosen finely
    m_ratio->setMinimumWidth(kMinSliderWidth);
    m_bestButton->setText(tr("Best transmission angle"));
    m_bestButton->setToolTip(
        tr("The ratio b/a with the largest minimum transmission angle, at most %1").arg(kLargestProposedRatio));
    m_bestButton->setFocusPolicy(Qt::TabFocus);

    form->addRow(QString(), m_bestButton);

    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kPageMargins);
    rows->addLayout(form);
    rows->addWidget(m_refusal);
    rows->addWidget(m_ratioText);
    rows->addStretch(1);
}

/// Makes the stroke and the time ratio of a mechanism the request.
void DesignForm::takeRequestFrom(const Parameters &parameters)
{
    const MotionLimits limits = motionLimits(Mechanism(parameters));
    m_parameters = parameters;
    m_request.stroke = limits.stroke.value_or(0.0) > 0.0 ? *limits.stroke : m_request.stroke;
    const double timeRatio = limits.timeRatio.value_or(1.0);
    m_request.timeRatio = parameters.c < 0.0 ? 1.0 / timeRatio : timeRatio;
    m_refusal->clear();
}

void DesignForm::showParameters()
{
    if (!isVisible()) {
        return;
    }
    // As long as the parameters are those that the form has set, the request stays as it was typed, without rounding
    // errors.
    if (m_session->parameters() != m_parameters || m_request.stroke == 0.0) {
        takeRequestFrom(m_session->parameters());
    }
    const MotionLimits limits = motionLimits(Mechanism(m_parameters));
    const bool makesFullTurns = limits.mobility == Mobility::FullTurn;
    const std::optional<DesignRange> range = findDesignRange(m_request.timeRatio);
    const double best = range ? range->bestTransmissionAngle : 0.0; // rad
    const Units &units = notation().units;
    const double shownPerMillimetre = shownValue(Measure::Length, 1.0, units);
    m_stroke->setSuffix(u' ' + shownUnit(Measure::Length));
    m_stroke->setUnit(Unit{Dimension::Length, 0, 1.0 / shownPerMillimetre});
    m_stroke->setValue(shownPerMillimetre * m_request.stroke);
    m_timeRatio->setValue(std::max(m_request.timeRatio, 1.0 / m_request.timeRatio));
    const bool isRadian = units.angle == AngleUnit::Radian;
    m_transmissionAngle->setSuffix(isRadian ? u' ' + shownUnit(Measure::Angle) : shownUnit(Measure::Angle));
    m_transmissionAngle->setUnit(isRadian ? kRadian : kDegree);
    m_transmissionAngle->setValue(
        shownValue(Measure::Angle, makesFullTurns ? limits.coupler.minimumTransmissionAngle.angle : best, units));
    m_ratio->setEnabled(makesFullTurns && range);
    m_bestButton->setEnabled(range.has_value());
    showRatio(makesFullTurns ? range : std::nullopt);
}

/// Shows the ratio b/a on the slider and as text. `range`: the mechanisms with the time ratio; nullopt if the crank
/// makes no full turns, or if no mechanism has the time ratio.
void DesignForm::showRatio(const std::optional<DesignRange> &range)
{
    constexpr int kDigits = 5;
    constexpr double kSliderSteps = 500.0;
    const auto number = [](double value) { return numberText(value, kDigits); };
    const double ratio = m_parameters.b / m_parameters.a;
    QString text = tr("b/a = %1.").arg(number(ratio));
    if (motionLimits(Mechanism(m_parameters)).mobility != Mobility::FullTurn) {
        text += u' ' + tr("The crank does not make full turns: there is no time ratio.");
    } else if (range) {
        const double last = std::min(range->largestRatio, std::max(kLargestProposedRatio, ratio));
        const double step = nextRoundNumber((last - 1.0) / kSliderSteps);
        const int steps = static_cast<int>(std::ceil((last - 1.0) / step));
        m_ratio->setScale(1.0, step, 1, std::max(1, steps - 1)); // both ends are excluded
        m_ratio->setNumber(ratio);
        const double best = shownValue(Measure::Angle, range->bestTransmissionAngle, notation().units);
        const QString angle = withUnit(number(best), shownUnit(Measure::Angle));
        text += u' ' + tr("With this time ratio the minimum transmission angle is largest, %1, for b/a = %2.")
                           .arg(angle, number(range->bestRatio));
    }
    m_ratioText->setText(text);
}

void DesignForm::requestStroke(double stroke)
{
    if (motionLimits(Mechanism(m_parameters)).stroke.value_or(0.0) == 0.0) { // there is no stroke to scale
        requestDesign(with(m_request, &DesignRequest::stroke, stroke));
        return;
    }
    const double scale = stroke / m_request.stroke;
    m_request.stroke = stroke;
    apply({scale * m_parameters.a, scale * m_parameters.b, scale * m_parameters.c});
}

void DesignForm::requestDesign(const DesignRequest &request)
{
    applyOrRefuse(design(request), request);
}

/// Changes the offset alone; the stroke follows from the offset.
void DesignForm::requestOffset(double timeRatio)
{
    DesignRequest request = with(m_request, &DesignRequest::timeRatio, timeRatio);
    const std::variant<Lengths, DesignFault> designed = designOffset(m_parameters.a, m_parameters.b, timeRatio);
    if (const Lengths *lengths = std::get_if<Lengths>(&designed)) {
        const Mechanism mechanism(with(m_parameters, &Parameters::c, lengths->c));
        request.stroke = motionLimits(mechanism).stroke.value_or(m_request.stroke);
    }
    applyOrRefuse(designed, request);
}

void DesignForm::applyOrRefuse(const std::variant<Lengths, DesignFault> &designed, const DesignRequest &request)
{
    if (const DesignFault *fault = std::get_if<DesignFault>(&designed)) {
        refuse(designFaultText(*fault, request));
        return;
    }
    m_request = request;
    m_request.transmissionAngle.reset();
    apply(std::get<Lengths>(designed));
}

void DesignForm::refuse(const QString &sentence)
{
    m_refusal->setText("⚠ " + sentence);
    setInk(*m_refusal, seriesColours(palette()).warning);
    showParameters();
}

void DesignForm::apply(const Lengths &lengths)
{
    m_refusal->clear();
    m_parameters.a = lengths.a;
    m_parameters.b = lengths.b;
    m_parameters.c = lengths.c;
    m_session->setParameters(m_parameters); // refuses lengths that are too short or too long
    showParameters();                       // also if nothing has changed
}

} // namespace slidercrank

#include "moc_design_form.cpp"
