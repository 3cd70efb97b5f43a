// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_slider.h"

#include "ui/text/written_number.h"

#include <QAccessibleWidget>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyleOptionSlider>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

class AccessibleNumberSlider : public QAccessibleWidget, public QAccessibleValueInterface
{
public:
    explicit AccessibleNumberSlider(NumberSlider *slider)
        : QAccessibleWidget(slider, QAccessible::Slider)
        , m_slider(slider)
    {
    }

    void *interface_cast(QAccessible::InterfaceType type) override
    {
        return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface *>(this)
                                                   : QAccessibleWidget::interface_cast(type);
    }

    QString text(QAccessible::Text type) const override
    {
        return type == QAccessible::Value ? m_slider->valueText() : QAccessibleWidget::text(type);
    }

    QVariant currentValue() const override { return m_slider->number(); }
    QVariant minimumValue() const override { return m_slider->numberAt(m_slider->minimum()); }
    QVariant maximumValue() const override { return m_slider->numberAt(m_slider->maximum()); }
    QVariant minimumStepSize() const override { return m_slider->step(); }

    void setCurrentValue(const QVariant &value) override { m_slider->setValue(m_slider->positionOf(value.toDouble())); }

private:
    NumberSlider *m_slider;
};

QAccessibleInterface *accessibleSlider(const QString &, QObject *object)
{
    auto *slider = qobject_cast<NumberSlider *>(object);
    return slider ? new AccessibleNumberSlider(slider) : nullptr;
}

} // namespace

NumberSlider::NumberSlider(QWidget *parent)
    : QSlider(Qt::Horizontal, parent)
{
    QAccessible::installFactory(accessibleSlider); // has no effect the second time
}

void NumberSlider::setScale(double first, double step, int lowest, int highest)
{
    const QSignalBlocker quiet(this);
    m_first = first;
    m_step = step;
    setRange(lowest, highest);
}

void NumberSlider::setNumber(double number)
{
    const QSignalBlocker quiet(this);
    setValue(positionOf(number));
}

double NumberSlider::numberAt(int position) const
{
    constexpr int kDigits = 12;
    return QString::number(m_first + position * m_step, 'g', kDigits).toDouble();
}

int NumberSlider::positionOf(double number) const
{
    constexpr double kFarthest = 1e9; // fits in an int and exceeds every range
    const double position = m_step > 0.0 ? (number - m_first) / m_step : 0.0;
    return static_cast<int>(std::lround(std::clamp(position, -kFarthest, kFarthest)));
}

QRect NumberSlider::handle() const
{
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

void NumberSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || handle().contains(event->position().toPoint())) {
        QSlider::mousePressEvent(event);
        return;
    }
    setSliderDown(true); // the change by the click is part of the drag
    // With this button, QSlider moves the handle to the click and continues with the mouse.
    const auto button = static_cast<Qt::MouseButton>(style()->styleHint(QStyle::SH_Slider_AbsoluteSetButtons));
    QMouseEvent absolute(event->type(), event->position(), event->globalPosition(), button, button, event->modifiers());
    QSlider::mousePressEvent(&absolute);
}

QString NumberSlider::valueText() const
{
    return numberText(number()) + m_suffix;
}

} // namespace slidercrank

#include "moc_number_slider.cpp"
