// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A box for one number: shows it shortened, in the user's locale and with its unit, and keeps it exact. A typed number
// may carry another unit. What cannot be accepted is replaced by the number before, and a note beside the box says why.

#include "core/import/quantity.h"
#include "core/mechanism/mechanism.h"

#include <QDoubleSpinBox>
#include <QPointer>

#include <optional>

class QLabel;

namespace slidercrank
{

/// What a box accepts.
struct NumberRange {
    double smallest = -kLargestParameter;
    double largest = kLargestParameter;
    bool isOpen = false;       ///< only numbers greater than the smallest
    bool isWhole = false;      ///< whole numbers only
    bool takesNearest = false; ///< a number outside becomes the nearer end instead of being refused
};

class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit NumberBox(QWidget *parent = nullptr);

    /// Shows a number from elsewhere: emits nothing, and leaves alone what is being typed.
    void setValue(double value);

    void setRange(const NumberRange &range);

    /// The unit of the number, and of one typed without a unit. Without it no unit is understood.
    void setUnit(const Unit &unit) { m_unit = unit; }

    /// Always that many decimals where there is space, also while edited: for a number that changes all the time.
    void setFixedDecimals(int decimals);

    /// What one press of an arrow adds, instead of a tenth of the number's power of ten.
    void setStep(double step);

    /// The box asks for the width of this text.
    void setWidestText(const QString &text);

    /// Somebody has typed something that has not been taken over yet.
    bool isTyping() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    void stepBy(int steps) override;
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override { return read(text).value; }
    QValidator::State validate(QString &text, int &position) const override;
    void fixup(QString &text) const override;

signals:
    void edited(double value); ///< somebody typed a number (and pressed Enter or left the box) or pressed an arrow

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct TypedNumber {
        double value;
        QString refusal; ///< empty: it can be taken over
    };
    void take(double value);
    TypedNumber read(const QString &text) const;
    QString refusalOf(double value) const;
    QString shownText() const { return textFromValue(value()) + suffix(); }
    void showValue();
    void selectNumber();
    void refuse(const QString &sentence);

    NumberRange m_range;
    double m_taken = 0.0; ///< the last number that was accepted
    std::optional<Unit> m_unit;
    int m_fixedDecimals = -1; ///< negative: as many as needed
    QString m_widestText = QStringLiteral("-000.000");
    bool m_isEditing = false;  ///< it has the focus and shows every digit
    mutable QString m_refusal; ///< of what was just typed
    QPointer<QLabel> m_note;
};

} // namespace slidercrank
