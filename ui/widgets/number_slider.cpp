// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_slider.h"

#include "ui/text/written_number.h"

#include <QAccessibleWidget>
#include <QMouseEvent>
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
    QAccessible::installFactory(accessibleSlider); // a second time does nothing
}

void NumberSlider::setScale(double first, double step)
{
    m_first = first;
    m_step = step;
}

double NumberSlider::numberAt(int position) const
{
    return QString::number(m_first + position * m_step, 'g', 12).toDouble();
}

int NumberSlider::positionOf(double number) const
{
    constexpr double kFarthest = 1e9; // as far as an int goes, and beyond every range
    const double position = m_step > 0.0 ? (number - m_first) / m_step : 0.0;
    return static_cast<int>(std::lround(std::clamp(position, -kFarthest, kFarthest)));
}

void NumberSlider::mousePressEvent(QMouseEvent *event)
{
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto placeOf = [&](QStyle::SubControl part) {
        return style()->subControlRect(QStyle::CC_Slider, &option, part, this);
    };
    const QRect handle = placeOf(QStyle::SC_SliderHandle);
    if (event->button() != Qt::LeftButton || handle.contains(event->position().toPoint())) {
        QSlider::mousePressEvent(event);
        return;
    }
    setSliderDown(true); // first: what it goes through from here on is one drag
    const QRect groove = placeOf(QStyle::SC_SliderGroove);
    const int left = static_cast<int>(event->position().x()) - handle.width() / 2 - groove.left();
    setSliderPosition(QStyle::sliderValueFromPosition(minimum(), maximum(), left, groove.width() - handle.width(),
                                                      option.upsideDown));
    initStyleOption(&option);
    // Of few steps none may be under the mouse.
    const QPointF centre = placeOf(QStyle::SC_SliderHandle).center();
    QMouseEvent onHandle(event->type(), centre, mapToGlobal(centre), event->button(), event->buttons(),
                         event->modifiers());
    QSlider::mousePressEvent(&onHandle);
}

QString NumberSlider::valueText() const
{
    return numberText(number()) + m_suffix;
}

} // namespace slidercrank
