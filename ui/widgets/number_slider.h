// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slider over real numbers in equal steps. A screen reader reads the number with its unit, not the position of the
// handle.

#include <QSlider>
#include <QString>

namespace slidercrank
{

class NumberSlider : public QSlider
{
    Q_OBJECT

public:
    explicit NumberSlider(QWidget *parent = nullptr);

    /// Position p, from `lowest` to `highest`, represents the number first + p · step. Emits no signal.
    void setScale(double first, double step, int lowest, int highest);

    /// Moves the handle to the nearest position without emitting a signal.
    void setNumber(double number);

    /// Sets the unit, with a leading space if needed: " mm", "°".
    void setSuffix(const QString &suffix) { m_suffix = suffix; }

    double step() const { return m_step; }
    double numberAt(int position) const; ///< rounded to 12 digits: 0.3 rather than 0.30000000000000004
    double number() const { return numberAt(value()); }
    int positionOf(double number) const; ///< the nearest position, even outside the range

    /// Returns the text for a screen reader: "65 mm".
    QString valueText() const;

protected:
    QRect handle() const;                              ///< px
    void mousePressEvent(QMouseEvent *event) override; ///< a click in the groove moves the handle there

private:
    double m_first = 0.0;
    double m_step = 1.0;
    QString m_suffix;
};

} // namespace slidercrank
