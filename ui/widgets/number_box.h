// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A box for one number. It shows the number shortened, in the user's locale and with its unit, but stores it exactly. A
// number may be typed with a different unit, or as an expression such as "2*pi" or "1/2 in". If a number is not
// accepted, the box restores the previous one, and a note says why.

#include "core/import/quantity.h"

#include <QDoubleSpinBox>

#include <optional>

class QLabel;

namespace slidercrank
{

/// The lower limit of a number that must be positive.
inline constexpr double kSmallestPositive = 1e-12;

class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit NumberBox(QWidget *parent = nullptr);

    /// Sets the number without emitting a signal. Text that is being typed is not changed.
    void setValue(double value);

    /// Sets the numbers that are accepted. By default, they are -kLargestParameter to kLargestParameter.
    void setRange(double smallest, double largest);

    /// Sets the numbers that are accepted, which are greater than 0. 0 and negative numbers are refused for that
    /// reason, whatever the smallest number is.
    void setPositiveRange(double smallest, double largest);

    /// Set and remove the unit of the number, which may be omitted when typing. By default, the number has no unit.
    void setUnit(const Unit &unit) { m_unit = unit; }
    void clearUnit() { m_unit.reset(); }

    /// Shows a fixed number of decimals if there is space, also while editing; for numbers that change continuously.
    /// With 0 decimals, only whole numbers are accepted, and the step is 1.
    void setFixedDecimals(int decimals);

    /// Makes the box wide enough for a number with these characters; by default, for "-000.000".
    void setWidestNumber(const QString &number);

    /// Sets the change per arrow key. The default is a tenth of the number's power of ten.
    void setStep(double step);

    /// Returns whether the text was changed and has not been accepted yet.
    bool isTyping() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    void stepBy(int steps) override;
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;

signals:
    void edited(double value); ///< the user entered a number or pressed an arrow key
    void enterPressed();       ///< after the typed number has been accepted or refused

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QString refusalOf(double value) const;
    QString shownText() const { return textFromValue(value()) + suffix(); }
    void showValue();
    void selectNumber();
    void refuse(const QString &sentence);

    std::optional<Unit> m_unit;
    bool m_isPositive = false; ///< whether the numbers must be greater than 0
    int m_fixedDecimals = -1;  ///< negative: not fixed
    QString m_widestNumber = QStringLiteral("-000.000");
    bool m_isEditing = false;  ///< the box has the focus and shows every digit that fits
    bool m_hasTyped = false;   ///< text was typed since the last number was accepted, even if it equals that number
    mutable QString m_refusal; ///< why the typed text is refused; empty if it is accepted
    QLabel *m_note = nullptr;
};

} // namespace slidercrank
