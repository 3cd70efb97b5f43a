// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_panel.h"

#include "ui/panels/response.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyleOptionSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

/// A display unit and its conversion from and to the core's unit.
struct ShownUnit {
    QString name;
    Unit unit;
    double halfTurn; ///< π rad in this unit; 0 for a length
    double range;    ///< initial range of the slider, to both sides of 0

    // Dividing by the half turn first converts 360 °/s, 60 rpm and 90° to the doubles nearest to 2π, 2π and π/2.
    double toCore(double value) const { return isCoreUnit() ? value : value / halfTurn * std::numbers::pi; }
    double fromCore(double value) const
    {
        if (isCoreUnit()) {
            return value;
        }
        const double exact = value / std::numbers::pi * halfTurn;
        const double rounded = QString::number(exact, 'g', 15).toDouble(); // 370, not 370.00000000000006
        return toCore(rounded) == value ? rounded : exact;
    }
    bool isCoreUnit() const { return halfTurn == 0.0 || halfTurn == std::numbers::pi; }
};

struct ParameterText {
    QString noun;
    QString explanation;
    std::vector<ShownUnit> units;
};

namespace
{

ParameterText textFor(Parameter parameter)
{
    const auto length = [](double range) {
        return std::vector{ShownUnit{ParameterPanel::tr("mm"), kMillimetre, 0.0, range}};
    };
    switch (parameter) {
    case Parameter::A:
        return {ParameterPanel::tr("crank"), ParameterPanel::tr("Length of the crank, O₂ to A"), length(100.0)};
    case Parameter::B:
        return {ParameterPanel::tr("coupler"), ParameterPanel::tr("Length of the coupler, A to B"), length(200.0)};
    case Parameter::C:
        return {ParameterPanel::tr("offset"),
                ParameterPanel::tr("Height of the slider's line above O₂; may be negative"), length(100.0)};
    case Parameter::Omega2:
        return {ParameterPanel::tr("crank speed"),
                ParameterPanel::tr("Angular velocity of the crank, counter-clockwise positive"),
                {{ParameterPanel::tr("rad/s"), kRadianPerSecond, std::numbers::pi, 20.0},
                 {ParameterPanel::tr("°/s"), kDegreePerSecond, 180.0, 1000.0},
                 {ParameterPanel::tr("rpm"), kTurnPerMinute, 30.0, 200.0}}};
    case Parameter::Theta20:
        return {ParameterPanel::tr("initial angle"),
                ParameterPanel::tr("Angle of the crank at t = 0"),
                {{ParameterPanel::tr("°"), kDegree, 180.0, 180.0},
                 {ParameterPanel::tr("rad"), kRadian, std::numbers::pi, 3.2}}};
    }
    return {};
}

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
        setMinimumWidth(56);
        setPageStep(10);
    }

    double range() const { return m_range; }

    /// Covers -range to range or, if `positive`, the first step to range.
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

    void setFree(const Interval &range)
    {
        if (range != m_free) {
            m_free = range;
            update();
        }
    }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        constexpr float kOpacity = 0.3F; // the groove and the handle remain visible
        constexpr double kBand = 12.0;   // px high
        QStyleOptionSlider option;
        initStyleOption(&option);
        const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
        const double lowest = numberAt(minimum());
        const double highest = numberAt(maximum());
        const auto pixel = [&](double number) {
            const double part = (std::clamp(number, lowest, highest) - lowest) / (highest - lowest);
            return 0.5 * handle.width() + part * (width() - handle.width());
        };
        QColor colour = seriesColours(palette()).warning;
        colour.setAlphaF(kOpacity);
        QPainter painter(this);
        const double top = handle.center().y() - 0.5 * kBand;
        const double from = m_free.length() < 0.0 ? width() : m_free.lower > lowest ? pixel(m_free.lower) : 0.0;
        const double to = m_free.upper < highest ? std::max(from, pixel(m_free.upper)) : width();
        painter.fillRect(QRectF(0.0, top, from, kBand), colour);
        painter.fillRect(QRectF(to, top, width() - to, kBand), colour);
        painter.end();
        NumberSlider::paintEvent(event);
    }

private:
    double m_range = 0.0;
    Interval m_free{-kLargestParameter, kLargestParameter};
};

ParameterPanel::ParameterPanel(QWidget *parent)
    : QWidget(parent)
    , m_rows{{{Parameter::A}, {Parameter::B}, {Parameter::C}, {Parameter::Omega2}, {Parameter::Theta20}}}
    , m_grid(new QGridLayout(this))
    , m_chosen(named("parameterBox", new QComboBox(this), tr("Parameter to change")))
{
    named("parameterPanel", this, tr("Parameters of the mechanism"));
    m_grid->setContentsMargins(6, 4, 6, 4);
    m_grid->setHorizontalSpacing(4);
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(1, 1);
    for (Row &row : m_rows) {
        addRow(row);
        m_chosen->addItem(tr("%1 %2").arg(symbolOf(row.parameter), row.text->noun));
    }
    m_chosen->setToolTip(tr("Parameter to change"));
    m_chosen->setCurrentIndex(static_cast<int>(Parameter::B));
    m_chosen->hide();
    connect(m_chosen, &QComboBox::currentIndexChanged, this, &ParameterPanel::showRows);
    m_grid->setRowStretch(m_grid->rowCount(), 1);
    showParameters();
}

const ShownUnit &ParameterPanel::Row::shownUnit() const
{
    return text->units[unit ? static_cast<std::size_t>(unit->currentIndex()) : 0];
}

void ParameterPanel::addRow(Row &row)
{
    const int line = static_cast<int>(&row - m_rows.data());
    const QLatin1String key(wordOf(row.parameter));
    const QString symbol = symbolOf(row.parameter);
    row.text = std::make_shared<const ParameterText>(textFor(row.parameter));
    const auto &[noun, explanation, units] = *row.text;
    const QString name = tr("%1 (%2)").arg(explanation, symbol);

    row.label = new QLabel(tr("<b>%1</b> %2").arg(symbol, noun));
    row.label->setWordWrap(true); // large fonts and long translations must leave space for the slider
    row.label->setToolTip(explanation);
    if (row.parameter != Parameter::Theta20) {
        row.label->setToolTip(explanation + u'\n' + tr("Click: how the limits of the motion depend on %1").arg(symbol));
        row.label->setCursor(Qt::PointingHandCursor);
        row.label->installEventFilter(this);
    }
    m_grid->addWidget(row.label, line, 0);

    row.slider = named(QStringLiteral("slider_") + key, new ParameterSlider, tr("%1, slider").arg(name));
    row.slider->setToolTip(explanation);
    m_grid->addWidget(row.slider, line, 1);
    connect(row.slider, &QSlider::valueChanged, this,
            [this, &row] { edit(row, row.shownUnit().toCore(row.slider->number())); });
    connect(row.slider, &QSlider::sliderPressed, this, &ParameterPanel::dragBegan);
    connect(row.slider, &QSlider::sliderReleased, this, &ParameterPanel::dragEnded);

    row.box = named(QStringLiteral("box_") + key, new NumberBox, name);
    row.box->setToolTip(explanation);
    row.label->setBuddy(row.box);
    m_grid->addWidget(row.box, line, 2, 1, units.size() > 1 ? 1 : 2);
    connect(row.box, &NumberBox::edited, this,
            [this, &row](double value) { edit(row, row.shownUnit().toCore(value)); });
    if (units.size() == 1) {
        row.box->setSuffix(u' ' + units[0].name);
    } else {
        row.box->setWidestText("-0.0·10⁻⁰");
        row.unit = named(QStringLiteral("unit_") + key, new QComboBox, tr("Unit of %1").arg(symbol));
        row.unit->setToolTip(tr("Unit"));
        for (const ShownUnit &unit : units) {
            row.unit->addItem(unit.name);
        }
        m_grid->addWidget(row.unit, line, 3);
        connect(row.unit, &QComboBox::currentIndexChanged, this, [this, &row] { showRow(row); });
    }

    row.reset = named(QStringLiteral("reset_") + key, new QToolButton, tr("Reset %1").arg(symbol));
    row.reset->setText("↺");
    row.reset->setAutoRaise(true);
    row.reset->setFixedWidth(20);
    row.reset->setFocusPolicy(Qt::TabFocus);
    row.reset->setToolTip(tr("Back to the initial value"));
    m_grid->addWidget(row.reset, line, 4);
    connect(row.reset, &QToolButton::clicked, this, [this, &row] { edit(row, valueOf(Parameters(), row.parameter)); });
}

bool ParameterPanel::eventFilter(QObject *watched, QEvent *event)
{
    const auto row = std::ranges::find(m_rows, watched, &Row::label);
    if (event->type() == QEvent::MouseButtonPress && row != m_rows.end()) {
        emit responseRequested(row->parameter);
    }
    return QWidget::eventFilter(watched, event);
}

void ParameterPanel::setBrief(bool brief)
{
    m_isBrief = brief;
    showRows();
}

void ParameterPanel::showRows()
{
    for (int i = 0; i < static_cast<int>(m_rows.size()); ++i) {
        const Row &row = m_rows[static_cast<std::size_t>(i)];
        row.label->setVisible(!m_isBrief);
        for (QWidget *part : std::initializer_list<QWidget *>{row.slider, row.box, row.unit, row.reset}) {
            if (part) {
                part->setVisible(!m_isBrief || i == m_chosen->currentIndex());
            }
        }
    }
    m_chosen->setVisible(m_isBrief);
    if (m_isBrief) {
        m_grid->addWidget(m_chosen, m_chosen->currentIndex(), 0);
    }
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
    const bool isUsable = wanted != m_parameters && !findFault(wanted);
    if (isUsable) {
        m_parameters = wanted;
    }
    showParameters();
    if (isUsable) {
        emit edited(wanted);
    }
}

void ParameterPanel::showRow(const Row &row)
{
    const double exact = valueOf(m_parameters, row.parameter);
    const ShownUnit &unit = row.shownUnit();
    const double value = unit.fromCore(exact);

    // The range of the slider must include the number and must not be much larger than the mechanism.
    constexpr double kMuchTooLong = 50.0;
    const double size = unit.halfTurn == 0.0 ? std::max({m_parameters.a, m_parameters.b, std::abs(m_parameters.c)})
                                             : std::max(std::abs(value), unit.range / kMuchTooLong);
    const auto fits = [&](double range) {
        return range > 0.0 && std::abs(value) <= range && range <= kMuchTooLong * size * (1.0 + 1e-9);
    };
    const double present = row.slider->range();
    const bool keepsRange = row.slider->isSliderDown() || fits(present); // the range is fixed during a drag
    row.slider->setRangeAndValue(keepsRange         ? present
                                 : fits(unit.range) ? unit.range
                                                    : nextRoundNumber(1.5 * size),
                                 isPositive(row.parameter), value);
    row.slider->setSuffix(u' ' + unit.name);

    const double largest = unit.fromCore(kLargestParameter);
    row.box->setUnit(unit.unit);
    row.box->setRange(isPositive(row.parameter) ? NumberRange{.smallest = 0.0, .isOpen = true}
                                                : NumberRange{.smallest = -largest, .largest = largest});
    row.box->setValue(value);
    row.reset->setEnabled(exact != valueOf(Parameters(), row.parameter));
}

void ParameterPanel::showParameters()
{
    for (const Row &row : m_rows) {
        showRow(row);
    }
    shade();
}

/// Shades the lengths with which the crank cannot make a full turn.
void ParameterPanel::shade()
{
    for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
        const Row &row = m_rows[indexOf(parameter)];
        const ResponseRange range = responseRange(m_parameters, parameter);
        row.slider->setFree(range.fullTurn);
        row.slider->setToolTip(row.text->explanation + u'\n' + fullTurnText(parameter, range));
    }
}

} // namespace slidercrank
