// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_panel.h"

#include "ui/document/session.h"
#include "ui/panels/response.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/widgets/spacing.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kPi = std::numbers::pi;

bool isPositive(Parameter parameter)
{
    return parameter == Parameter::A || parameter == Parameter::B;
}

} // namespace

/// A slider with round steps, which shades the numbers outside an interval.
class ParameterSlider : public NumberSlider
{
public:
    ParameterSlider()
    {
        constexpr int kMinWidth = 50; // px, leaves space for large letters
        constexpr int kPageStep = 10; // round steps
        setMinimumWidth(kMinWidth);
        setPageStep(kPageStep);
    }

    double range() const { return m_range; }

    /// Covers -range to range or, for a parameter that must be positive, the first step to range.
    void setRange(double range, Parameter parameter)
    {
        constexpr double kMaxSteps = 200.0;
        m_range = range;
        const double step = nextRoundNumber(range / kMaxSteps);
        const int positions = static_cast<int>(std::lround(range / step));
        setScale(0.0, step, isPositive(parameter) ? 1 : -positions, positions);
    }

    void setUnshaded(const Interval &range)
    {
        if (range != m_unshaded) {
            m_unshaded = range;
            update();
        }
    }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        constexpr float kOpacity = 0.3F;     // the groove and the handle remain visible
        constexpr double kBandHeight = 12.0; // px high
        const QRect handle = this->handle();
        const double lowest = numberAt(minimum());
        const double highest = numberAt(maximum());
        const auto pixel = [&](double number) {
            const double fraction = (std::clamp(number, lowest, highest) - lowest) / (highest - lowest);
            return 0.5 * handle.width() + fraction * (width() - handle.width());
        };
        QColor colour = seriesColours(palette()).warning;
        colour.setAlphaF(kOpacity);
        QPainter painter(this);
        const double top = handle.center().y() - 0.5 * kBandHeight;
        double left = m_unshaded.lower > lowest ? pixel(m_unshaded.lower) : 0.0; // of the unshaded part
        if (m_unshaded.isEmpty()) {
            left = width();
        }
        const double right = m_unshaded.upper < highest ? std::max(left, pixel(m_unshaded.upper)) : width();
        painter.fillRect(QRectF(0.0, top, left, kBandHeight), colour);
        painter.fillRect(QRectF(right, top, width() - right, kBandHeight), colour);
        painter.end();
        NumberSlider::paintEvent(event);
    }

private:
    double m_range = 0.0;
    Interval m_unshaded{-kLargestParameter, kLargestParameter};
};

ParameterPanel::ParameterPanel(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_grid(new QGridLayout(this))
{
    named("parameterPanel", this, tr("Parameters of the mechanism"));
    m_grid->setContentsMargins(kControlMargins);
    m_grid->setHorizontalSpacing(kFormSpacing);
    m_grid->setVerticalSpacing(kRowSpacing);
    m_grid->setColumnStretch(1, 1);
    addRow(Parameter::A, tr("Length of the crank, O₂ to A"), {lengthUnit(Parameter::A)});
    addRow(Parameter::B, tr("Length of the coupler, A to B"), {lengthUnit(Parameter::B)});
    addRow(Parameter::C, tr("Height of the slider's line above O₂; may be negative"), {lengthUnit(Parameter::C)});
    addRow(Parameter::Omega2, tr("Angular velocity of the crank, counter-clockwise positive"),
           {{tr("rad/s"), kRadianPerSecond, 20.0, CrankSpeedUnit::RadianPerSecond},
            {tr("°/s"), kDegreePerSecond, 1000.0, CrankSpeedUnit::DegreePerSecond},
            {tr("rpm"), kTurnPerMinute, 200.0, CrankSpeedUnit::TurnPerMinute}});
    addRow(Parameter::Theta20, tr("Angle of the crank at t = 0"),
           {{tr("°"), kDegree, 180.0, {}, AngleUnit::Degree}, {tr("rad"), kRadian, 3.2, {}, AngleUnit::Radian}});
    m_grid->setRowStretch(m_grid->rowCount(), 1);
    connect(session, &Session::parametersChanged, this, &ParameterPanel::showParameters);
    showParameters();
}

bool ParameterPanel::ShownUnit::isCoreUnit() const
{
    return unit.dimension == Dimension::Length ? unit.factor == 1.0 : unit.factor == kDegreesPerRadian;
}

// Dividing by the half turn first converts 360 °/s, 60 rpm and 90° to the doubles nearest to 2π, 2π and π/2.
double ParameterPanel::ShownUnit::toCore(double value) const
{
    if (isCoreUnit()) {
        return value;
    }
    return unit.dimension == Dimension::Length ? value * unit.factor : value / (180.0 / unit.factor) * kPi;
}

double ParameterPanel::ShownUnit::fromCore(double value) const
{
    if (isCoreUnit()) {
        return value;
    }
    const double exact =
        unit.dimension == Dimension::Length ? value / unit.factor : value / kPi * (180.0 / unit.factor);
    const double rounded = QString::number(exact, 'g', 15).toDouble(); // 370, not 370.00000000000006
    return toCore(rounded) == value ? rounded : exact;
}

const ParameterPanel::ShownUnit &ParameterPanel::Row::shownUnit() const
{
    return units[unit ? static_cast<std::size_t>(unit->currentIndex()) : 0];
}

void ParameterPanel::Row::showUnit(const std::function<bool(const ShownUnit &)> &isWanted)
{
    const auto wantedUnit = std::ranges::find_if(units, isWanted);
    unit->setCurrentIndex(static_cast<int>(wantedUnit - units.begin()));
}

void ParameterPanel::addRow(Parameter parameter, const QString &explanation, const std::vector<ShownUnit> &units)
{
    Row &row = m_rows[indexOf(parameter)];
    row.explanation = explanation;
    row.units = units;
    row.label = makeLabel(parameter);
    row.slider = makeSlider(parameter);
    row.box = makeBox(parameter);
    row.label->setBuddy(row.box);
    const int line = static_cast<int>(parameter);
    m_grid->addWidget(row.label, line, 0);
    m_grid->addWidget(row.slider, line, 1);
    if (units.size() == 1) {
        row.box->setSuffix(u' ' + units[0].name);
        m_grid->addWidget(row.box, line, 2, 1, 2);
    } else {
        row.unit = makeUnitBox(parameter);
        m_grid->addWidget(row.box, line, 2);
        m_grid->addWidget(row.unit, line, 3);
    }
    row.reset = makeResetButton(parameter);
    m_grid->addWidget(row.reset, line, 4);
    useUnit(parameter);
}

QLabel *ParameterPanel::makeLabel(Parameter parameter)
{
    const QString symbol = symbolText(parameter);
    const QString &explanation = m_rows[indexOf(parameter)].explanation;
    auto *label = new QLabel(tr("<b>%1</b> %2").arg(symbol, parameterName(parameter)));
    label->setWordWrap(true); // large fonts and long translations must leave space for the slider
    label->setToolTip(explanation);
    if (parameter != Parameter::Theta20) {
        label->setToolTip(explanation + u'\n' +
                          tr("Click to see how the limits of the motion depend on %1").arg(symbol));
        label->setCursor(Qt::PointingHandCursor);
        label->installEventFilter(this);
    }
    return label;
}

/// Returns the name of the row's widgets for a screen reader.
QString ParameterPanel::spokenName(Parameter parameter) const
{
    return tr("%1 (%2)").arg(m_rows[indexOf(parameter)].explanation, symbolText(parameter));
}

ParameterSlider *ParameterPanel::makeSlider(Parameter parameter)
{
    auto *slider = named(QStringLiteral("slider_") + optionName(parameter), new ParameterSlider,
                         tr("%1, slider").arg(spokenName(parameter)));
    slider->setToolTip(m_rows[indexOf(parameter)].explanation);
    connect(slider, &QSlider::valueChanged, this, [this, parameter, slider] { edit(parameter, slider->number()); });
    connect(slider, &QSlider::sliderPressed, m_session, &Session::beginDrag);
    connect(slider, &QSlider::sliderReleased, m_session, &Session::endDrag);
    return slider;
}

NumberBox *ParameterPanel::makeBox(Parameter parameter)
{
    auto *box = named(QStringLiteral("box_") + optionName(parameter), new NumberBox, spokenName(parameter));
    box->setToolTip(m_rows[indexOf(parameter)].explanation);
    connect(box, &NumberBox::edited, this, [this, parameter](double value) { edit(parameter, value); });
    return box;
}

QComboBox *ParameterPanel::makeUnitBox(Parameter parameter)
{
    auto *box = named(QStringLiteral("unit_") + optionName(parameter), new QComboBox,
                      tr("Unit of %1").arg(symbolText(parameter)));
    box->setToolTip(tr("Unit"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents); // also when the letters grow
    for (const ShownUnit &unit : m_rows[indexOf(parameter)].units) {
        box->addItem(unit.name);
    }
    connect(box, &QComboBox::currentIndexChanged, this, [this, parameter] {
        useUnit(parameter);
        showRow(parameter);
        if (const auto speedUnit = m_rows[indexOf(parameter)].shownUnit().speedUnit) {
            emit crankSpeedUnitChosen(*speedUnit);
        }
    });
    return box;
}

QToolButton *ParameterPanel::makeResetButton(Parameter parameter)
{
    auto *button = named(QStringLiteral("reset_") + optionName(parameter), new QToolButton,
                         tr("Reset %1").arg(symbolText(parameter)));
    button->setText("↺");
    button->setAutoRaise(true);
    button->setFixedWidth(20);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(tr("Back to the initial value"));
    connect(button, &QToolButton::clicked, m_session,
            [this, parameter] { m_session->setParameter(parameter, valueOf(Parameters(), parameter)); });
    return button;
}

/// Returns the chosen unit of lengths, with the initial range of the slider of this length.
ParameterPanel::ShownUnit ParameterPanel::lengthUnit(Parameter length)
{
    constexpr double kSlack = 0.999;                             // rounding errors do not change a round range
    const double range = length == Parameter::B ? 200.0 : 100.0; // mm
    const double factor = 1.0 / shownValue(Measure::Length, 1.0, notation().units); // mm
    return {shownUnit(Measure::Length), Unit{Dimension::Length, 0, factor}, nextRoundNumber(kSlack * range / factor)};
}

void ParameterPanel::refreshNotation()
{
    for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
        Row &row = m_rows[indexOf(parameter)];
        row.units = {lengthUnit(parameter)};
        row.box->setSuffix(u' ' + row.units[0].name);
        useUnit(parameter);
    }
    if (m_angleUnit != notation().units.angle) { // otherwise a unit that was chosen for this angle alone stays
        m_angleUnit = notation().units.angle;
        m_rows[indexOf(Parameter::Theta20)].showUnit(
            [isRadian = m_angleUnit == AngleUnit::Radian](const ShownUnit &unit) {
                return (unit.angleUnit == AngleUnit::Radian) == isRadian;
            });
    }
    m_rows[indexOf(Parameter::Omega2)].showUnit(
        [](const ShownUnit &unit) { return unit.speedUnit == notation().crankSpeed; });
    showParameters();
}

bool ParameterPanel::eventFilter(QObject *watched, QEvent *event)
{
    for (const Parameter parameter : kAllParameters) {
        if (event->type() == QEvent::MouseButtonPress && watched == m_rows[indexOf(parameter)].label) {
            emit responseRequested(parameter);
        }
    }
    return QWidget::eventFilter(watched, event);
}

/// Converts the numbers of the slider and of the box to the displayed unit.
void ParameterPanel::useUnit(Parameter parameter)
{
    const Row &row = m_rows[indexOf(parameter)];
    const ShownUnit &unit = row.shownUnit();
    const double largest = unit.fromCore(kLargestParameter);
    row.slider->setSuffix(u' ' + unit.name);
    row.slider->setRange(unit.range, parameter); // showRow() extends it if it is too small
    row.box->setUnit(unit.unit);
    if (isPositive(parameter)) {
        row.box->setPositiveRange(unit.fromCore(kShortestLink), largest);
    } else {
        row.box->setRange(-largest, largest);
    }
}

void ParameterPanel::edit(Parameter parameter, double value)
{
    m_session->setParameter(parameter, m_rows[indexOf(parameter)].shownUnit().toCore(value));
    showRow(parameter); // also if nothing has changed
}

void ParameterPanel::showParameters()
{
    for (const Parameter parameter : kAllParameters) {
        showRow(parameter);
    }
}

void ParameterPanel::showRow(Parameter parameter)
{
    const Row &row = m_rows[indexOf(parameter)];
    const Parameters &parameters = m_session->parameters();
    const double exact = valueOf(parameters, parameter);
    const ShownUnit &unit = row.shownUnit();
    const double value = unit.fromCore(exact);
    const bool isLength = unit.unit.dimension == Dimension::Length;

    // The range of the slider must include the number and must not be much larger than the mechanism.
    constexpr double kMaxRangeRatio = 50.0; // the range over the size of the mechanism
    constexpr double kNewRangeRatio = 1.5;  // that of a new range
    constexpr double kRounding = 1e-9;      // relative
    const double size = isLength ? unit.fromCore(std::max({parameters.a, parameters.b, std::abs(parameters.c)}))
                                 : std::max(std::abs(value), unit.range / kMaxRangeRatio);
    const auto fits = [&](double range) {
        return range > 0.0 && std::abs(value) <= range && range <= kMaxRangeRatio * size * (1.0 + kRounding);
    };
    if (!row.slider->isSliderDown() && !fits(row.slider->range())) { // the range is fixed during a drag
        row.slider->setRange(fits(unit.range) ? unit.range : nextRoundNumber(kNewRangeRatio * size), parameter);
    }
    row.slider->setNumber(value);
    if (isLength) { // the lengths with which the crank cannot make a full turn are shaded
        const ResponseRange range = responseRange(parameters, parameter);
        row.slider->setUnshaded({unit.fromCore(range.fullTurn.lower), unit.fromCore(range.fullTurn.upper)});
        row.slider->setToolTip(row.explanation + u'\n' + fullTurnText(parameter, range));
    }
    row.box->setValue(value);
    row.reset->setEnabled(exact != valueOf(Parameters(), parameter));
}

} // namespace slidercrank

#include "moc_parameter_panel.cpp"
