// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_panel.h"

#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace slidercrank
{

/// A part of a slider's numbers.
struct Stretch {
    double from;
    double to;
    friend bool operator==(const Stretch &, const Stretch &) = default;
};

namespace
{

/// What a unit is called, and how the core's rad or rad/s become it.
struct ShownUnit {
    QString name;
    Unit unit;
    double halfTurn; ///< π rad in this unit
    double range;    ///< of the slider at first, either way
};

enum OmegaUnit { RadiansPerSecond, DegreesPerSecond, TurnsPerMinute };
enum AngleUnit { Degrees, Radians };

ShownUnit omegaUnit(int index)
{
    switch (static_cast<OmegaUnit>(index)) {
    case RadiansPerSecond: return {ParameterPanel::tr("rad/s"), kRadianPerSecond, std::numbers::pi, 20.0};
    case DegreesPerSecond: return {ParameterPanel::tr("°/s"), kDegreePerSecond, 180.0, 1000.0};
    case TurnsPerMinute: return {ParameterPanel::tr("rpm"), kTurnPerMinute, 30.0, 200.0};
    }
    return {};
}

ShownUnit angleUnit(int index)
{
    switch (static_cast<AngleUnit>(index)) {
    case Degrees: return {ParameterPanel::tr("°"), kDegree, 180.0, 180.0};
    case Radians: return {ParameterPanel::tr("rad"), kRadian, std::numbers::pi, 3.2};
    }
    return {};
}

bool isLength(Parameter parameter)
{
    return parameter == Parameter::A || parameter == Parameter::B || parameter == Parameter::C;
}

bool isPositive(Parameter parameter)
{
    return parameter == Parameter::A || parameter == Parameter::B;
}

QString nounOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return ParameterPanel::tr("crank");
    case Parameter::B: return ParameterPanel::tr("coupler");
    case Parameter::C: return ParameterPanel::tr("offset");
    case Parameter::Omega2: return ParameterPanel::tr("speed");
    case Parameter::Theta20: return ParameterPanel::tr("start");
    }
    return {};
}

QString explanationOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return ParameterPanel::tr("Length of the crank, O₂ to A");
    case Parameter::B: return ParameterPanel::tr("Length of the coupler, A to B");
    case Parameter::C: return ParameterPanel::tr("Height of the slider's line above O₂; may be negative");
    case Parameter::Omega2: return ParameterPanel::tr("Speed of the crank, counter-clockwise positive");
    case Parameter::Theta20: return ParameterPanel::tr("Angle of the crank at t = 0");
    }
    return {};
}

/// Where a rocker's crank cannot stand, from -range to range (rad).
std::vector<Stretch> anglesWithoutPose(const MotionLimits &limits, double range)
{
    constexpr double kMostTurns = 4.0; // more on a slider would be but stripes
    const bool rocks = limits.mobility == Mobility::Rocker || limits.mobility == Mobility::Locked;
    if (!rocks || range > kMostTurns * kTurn) {
        return {};
    }
    std::vector<Stretch> stretches;
    for (double turn = -kMostTurns - 1.0; turn <= kMostTurns + 1.0; turn += 1.0) {
        for (std::size_t i = 0; i < limits.ranges.size(); ++i) { // from the end of each arc to the start of the next
            const bool last = i + 1 == limits.ranges.size();
            const double from = limits.ranges[i].to + kTurn * turn;
            const double to = (last ? limits.ranges[0].from + kTurn : limits.ranges[i + 1].from) + kTurn * turn;
            if (to > -range && from < range) {
                stretches.push_back({from, to});
            }
        }
    }
    return stretches;
}

} // namespace

/// Its steps are round numbers; parts of its range are shaded.
class ParameterSlider : public NumberSlider
{
public:
    ParameterSlider()
    {
        setMinimumWidth(56);
        setPageStep(10);
    }

    double range() const { return m_range; }

    /// Positive numbers only: from the first step on.
    void setRangeAndValue(double range, bool positive, double value)
    {
        const QSignalBlocker quiet(this);
        if (range != m_range) {
            m_range = range;
            setScale(0.0, nextRoundNumber(range / 200.0));
        }
        const int positions = positionOf(m_range);
        setRange(positive ? 1 : -positions, positions);
        setValue(positionOf(value));
    }

    /// Shades them, in the unit of number(); `why` joins the tooltip.
    void setForbidden(std::vector<Stretch> forbidden, const QString &explanation, const QString &why)
    {
        if (forbidden != m_forbidden) {
            m_forbidden = std::move(forbidden);
            update();
        }
        setToolTip(m_forbidden.empty() ? explanation : explanation + QLatin1Char('\n') + why);
    }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        paintForbidden();
        QSlider::paintEvent(event);
    }

private:
    void paintForbidden()
    {
        QStyleOptionSlider option;
        initStyleOption(&option);
        const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
        const double first = 0.5 * handle.width();
        const double travel = width() - handle.width();
        const double lowest = numberAt(minimum());
        const double highest = numberAt(maximum());
        const auto pixel = [&](double number) { return first + travel * (number - lowest) / (highest - lowest); };
        QColor colour = seriesColours(palette()).warning;
        colour.setAlphaF(kShade);
        QPainter painter(this);
        for (const Stretch &stretch : m_forbidden) {
            const double left = stretch.from <= lowest ? 0.0 : pixel(std::min(stretch.from, highest));
            const double right = stretch.to >= highest ? width() : pixel(std::max(stretch.to, lowest));
            painter.fillRect(QRectF(left, handle.center().y() - 0.5 * kBand, right - left, kBand), colour);
        }
    }

    static constexpr float kShade = 0.3F; // opacity: the groove and the handle stay clear
    static constexpr double kBand = 12.0; // px high

    double m_range = 0.0;
    std::vector<Stretch> m_forbidden;
};

ParameterPanel::ParameterPanel(QWidget *parent)
    : QWidget(parent)
    , m_rows{{{Parameter::A}, {Parameter::B}, {Parameter::C}, {Parameter::Omega2}, {Parameter::Theta20}}}
{
    named("parameterPanel", this, tr("Parameters of the mechanism"));

    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(6, 4, 6, 4);
    m_grid->setHorizontalSpacing(4);
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(1, 1);
    for (Row &row : m_rows) {
        addRow(row);
    }

    m_branchLabel = new QLabel(tr("assembly"));
    m_branch = named("branchBox", new QComboBox, tr("Assembly"));
    m_branch->addItem(tr("open: slider to the right of A"));
    m_branch->addItem(tr("crossed: slider to the left of A"));
    m_branch->setToolTip(tr("The two ways to put the same parts together"));
    m_branch->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_branchLabel->setBuddy(m_branch);
    m_grid->addWidget(m_branchLabel, m_grid->rowCount(), 0);
    m_grid->addWidget(m_branch, m_grid->rowCount() - 1, 1, 1, 4);
    connect(m_branch, &QComboBox::activated, this, [this](int index) {
        const Branch branch = static_cast<Branch>(index);
        if (branch != m_parameters.branch) {
            m_parameters.branch = branch;
            emit edited(m_parameters);
        }
    });
    m_chosen = named("parameterBox", new QComboBox(this), tr("Parameter to change"));
    m_chosen->setToolTip(tr("Parameter to change"));
    for (const Row &row : m_rows) {
        m_chosen->addItem(tr("%1 %2").arg(symbolOf(row.parameter), nounOf(row.parameter)));
    }
    m_chosen->addItem(tr("assembly"));
    m_chosen->setCurrentIndex(static_cast<int>(Parameter::B)); // what classes vary first
    m_chosen->hide();
    connect(m_chosen, &QComboBox::currentIndexChanged, this, &ParameterPanel::showBriefly);
    m_grid->setRowStretch(m_grid->rowCount(), 1);
    showParameters();
}

void ParameterPanel::setBrief(bool brief)
{
    m_isBrief = brief;
    showBriefly();
}

void ParameterPanel::showBriefly()
{
    const auto isShown = [this](int line) { return !m_isBrief || line == m_chosen->currentIndex(); };
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = m_rows[i];
        const bool shown = isShown(static_cast<int>(i));
        row.label->setVisible(!m_isBrief);
        for (QWidget *part : {static_cast<QWidget *>(row.slider), static_cast<QWidget *>(row.box),
                              static_cast<QWidget *>(row.unit), static_cast<QWidget *>(row.reset)}) {
            if (part) {
                part->setVisible(shown);
            }
        }
    }
    m_branchLabel->setVisible(!m_isBrief);
    m_branch->setVisible(isShown(static_cast<int>(m_rows.size())));
    m_chosen->setVisible(m_isBrief);
    if (m_isBrief) {
        m_grid->addWidget(m_chosen, m_chosen->currentIndex(), 0);
    }
}

void ParameterPanel::addRow(Row &row)
{
    const QLatin1String key(wordOf(row.parameter));
    const QString symbol = symbolOf(row.parameter);
    const QString explanation = explanationOf(row.parameter);
    const int line = static_cast<int>(&row - m_rows.data());
    const QString name = tr("%1 (%2)").arg(explanation, symbol);

    row.label = new QLabel(tr("<b>%1</b> %2").arg(symbol, nounOf(row.parameter)));
    row.label->setToolTip(explanation);
    m_grid->addWidget(row.label, line, 0);

    row.slider = named(QStringLiteral("slider_") + key, new ParameterSlider, tr("%1, slider").arg(name));
    row.slider->setToolTip(explanation);
    m_grid->addWidget(row.slider, line, 1);
    connect(row.slider, &QSlider::valueChanged, this,
            [this, &row] { edit(row, fromUnitOf(row, row.slider->number())); });
    connect(row.slider, &QSlider::sliderPressed, this, &ParameterPanel::dragBegan);
    connect(row.slider, &QSlider::sliderReleased, this, &ParameterPanel::dragEnded);

    row.box = named(QStringLiteral("box_") + key, new NumberBox, name);
    row.box->setToolTip(explanation);
    row.label->setBuddy(row.box);
    connect(row.box, &NumberBox::edited, this, [this, &row](double value) { edit(row, fromUnitOf(row, value)); });
    if (isLength(row.parameter)) {
        row.box->setSuffix(tr(" mm"));
        row.box->setUnit(kMillimetre);
        if (isPositive(row.parameter)) {
            row.box->setRange({.smallest = 0.0, .isOpen = true});
        }
        m_grid->addWidget(row.box, line, 2, 1, 2);
    } else {
        row.box->setWidestText(QStringLiteral("-0.0·10⁻⁰"));
        m_grid->addWidget(row.box, line, 2);
        row.unit = named(QStringLiteral("unit_") + key, new QComboBox, tr("Unit of %1").arg(symbol));
        row.unit->setToolTip(tr("Unit"));
        const bool speed = row.parameter == Parameter::Omega2;
        for (int i = 0; i < (speed ? 3 : 2); ++i) {
            row.unit->addItem(speed ? omegaUnit(i).name : angleUnit(i).name);
        }
        m_grid->addWidget(row.unit, line, 3);
        connect(row.unit, &QComboBox::currentIndexChanged, this, [this, &row] {
            showRow(row);
            shadeForbidden();
        });
    }

    row.reset = named(QStringLiteral("reset_") + key, new QToolButton, tr("Reset %1").arg(symbol));
    row.reset->setText(QStringLiteral("↺"));
    row.reset->setAutoRaise(true);
    row.reset->setFixedSize(20, 22); // beside five sliders, which need the width more
    row.reset->setToolTip(tr("Back to the initial value"));
    m_grid->addWidget(row.reset, line, 4);
    connect(row.reset, &QToolButton::clicked, this, [this, &row] { edit(row, valueOf(Parameters(), row.parameter)); });
}

void ParameterPanel::setParameters(const Parameters &parameters)
{
    m_parameters = parameters;
    showParameters();
}

void ParameterPanel::edit(const Row &row, double value)
{
    Parameters wanted = m_parameters;
    valueOf(wanted, row.parameter) = value;
    const bool usable = wanted != m_parameters && !findFault(wanted);
    if (usable) {
        m_parameters = wanted;
    }
    showParameters();
    if (usable) {
        emit edited(wanted);
    }
}

double ParameterPanel::halfTurnOf(const Row &row)
{
    if (!row.unit) {
        return 0.0;
    }
    return (row.parameter == Parameter::Omega2 ? omegaUnit(row.unit->currentIndex())
                                               : angleUnit(row.unit->currentIndex()))
        .halfTurn;
}

// Divided by the half turn first: 360 °/s, 60 rpm and 90° then become exactly the double nearest to 2π, 2π and π/2.

double ParameterPanel::toUnitOf(const Row &row, double value)
{
    const double halfTurn = halfTurnOf(row);
    if (halfTurn == 0.0 || halfTurn == std::numbers::pi) {
        return value;
    }
    const double exact = value / std::numbers::pi * halfTurn;
    const double written = QString::number(exact, 'g', 15).toDouble(); // 370 where it is 370.00000000000006
    return fromUnitOf(row, written) == value ? written : exact;
}

double ParameterPanel::fromUnitOf(const Row &row, double value)
{
    const double halfTurn = halfTurnOf(row);
    return halfTurn == 0.0 || halfTurn == std::numbers::pi ? value : value / halfTurn * std::numbers::pi;
}

double ParameterPanel::sliderRangeFor(const Row &row, double value) const
{
    double usual = 0.0;
    switch (row.parameter) {
    case Parameter::A:
    case Parameter::C: usual = 100.0; break;
    case Parameter::B: usual = 200.0; break;
    case Parameter::Omega2: usual = omegaUnit(row.unit->currentIndex()).range; break;
    case Parameter::Theta20: usual = angleUnit(row.unit->currentIndex()).range; break;
    }
    // A slider is of use where its range is neither too short for the number nor much too long for the mechanism.
    constexpr double kMuchTooLong = 50.0;
    const double size = isLength(row.parameter) ? std::max({m_parameters.a, m_parameters.b, std::abs(m_parameters.c)})
                                                : std::max(std::abs(value), usual / kMuchTooLong);
    const auto fits = [&](double range) {
        return range > 0.0 && std::abs(value) <= range && range <= kMuchTooLong * size * (1.0 + 1e-9);
    };
    if (row.slider->isSliderDown() || fits(row.slider->range())) {
        return row.slider->range(); // under the hand, or good enough: nothing moves
    }
    return fits(usual) ? usual : nextRoundNumber(1.5 * size);
}

void ParameterPanel::showRow(const Row &row)
{
    const double exact = valueOf(m_parameters, row.parameter);
    const double value = toUnitOf(row, exact);
    row.slider->setRangeAndValue(sliderRangeFor(row, value), isPositive(row.parameter), value);
    row.slider->setSuffix(row.unit ? QLatin1Char(' ') + row.unit->currentText() : tr(" mm"));
    if (row.unit) {
        const int index = row.unit->currentIndex();
        row.box->setUnit((row.parameter == Parameter::Omega2 ? omegaUnit(index) : angleUnit(index)).unit);
        const double largest = toUnitOf(row, kLargestParameter);
        row.box->setRange({.smallest = -largest, .largest = largest});
    }
    row.box->setValue(value);
    row.reset->setEnabled(exact != valueOf(Parameters(), row.parameter));
}

void ParameterPanel::showParameters()
{
    for (const Row &row : m_rows) {
        showRow(row);
    }
    m_branch->setCurrentIndex(static_cast<int>(m_parameters.branch));
    shadeForbidden();
}

void ParameterPanel::shadeForbidden()
{
    const Mechanism mechanism(m_parameters);
    for (const Row &row : m_rows) {
        const QString explanation = explanationOf(row.parameter);
        const auto limitText = [](double limit) { return tr("%1 mm").arg(numberText(limit)); };
        switch (row.parameter) {
        case Parameter::A: {
            const double longest = longestCrankForFullTurn(mechanism);
            row.slider->setForbidden({{longest, kLargestParameter}}, explanation,
                                     longest > 0.0
                                         ? tr("Shaded: above %1 the crank cannot turn round").arg(limitText(longest))
                                         : tr("Shaded: with this coupler and offset no crank can turn round"));
            break;
        }
        case Parameter::B: {
            const double shortest = shortestCouplerForFullTurn(mechanism);
            row.slider->setForbidden({{-kLargestParameter, shortest}}, explanation,
                                     tr("Shaded: below %1 the crank cannot turn round").arg(limitText(shortest)));
            break;
        }
        case Parameter::C: {
            const double largest = largestOffsetForFullTurn(mechanism);
            if (largest >= 0.0) {
                row.slider->setForbidden({{-kLargestParameter, -largest}, {largest, kLargestParameter}}, explanation,
                                         tr("Shaded: beyond ±%1 the crank cannot turn round").arg(limitText(largest)));
            } else {
                row.slider->setForbidden(
                    {{-kLargestParameter, kLargestParameter}}, explanation,
                    tr("Shaded: with a crank longer than the coupler no offset lets it turn round"));
            }
            break;
        }
        case Parameter::Omega2: break;
        case Parameter::Theta20: {
            std::vector<Stretch> stretches =
                anglesWithoutPose(motionLimits(mechanism), fromUnitOf(row, row.slider->range()));
            for (Stretch &stretch : stretches) {
                stretch = {toUnitOf(row, stretch.from), toUnitOf(row, stretch.to)};
            }
            row.slider->setForbidden(std::move(stretches), explanation,
                                     tr("Shaded: with the crank there the mechanism cannot be assembled"));
            break;
        }
        }
    }
}

} // namespace slidercrank
