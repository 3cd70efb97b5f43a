// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slider over real numbers in equal steps. Those who have it read aloud hear the number with its unit, not the
// position of the handle.

#include <QSlider>
#include <QString>

namespace slidercrank
{

class NumberSlider : public QSlider
{
    Q_OBJECT

public:
    explicit NumberSlider(QWidget *parent = nullptr);

    /// Position p stands for first + p · step.
    void setScale(double first, double step);

    /// Read behind the number, with the space that belongs there: " mm", "°".
    void setSuffix(const QString &suffix) { m_suffix = suffix; }

    double step() const { return m_step; }
    double numberAt(int position) const; ///< without the binary tail of 3 · 0.1
    double number() const { return numberAt(value()); }
    int positionOf(double number) const; ///< the nearest, also beyond the range

    /// As it is read aloud: "65 mm".
    QString valueText() const;

protected:
    void mousePressEvent(QMouseEvent *event) override; ///< in the groove: goes there, and follows on

private:
    double m_first = 0.0;
    double m_step = 1.0;
    QString m_suffix;
};

} // namespace slidercrank
