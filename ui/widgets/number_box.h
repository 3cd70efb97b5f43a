// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A box for one number: shows it shortened, in the user's locale and with its unit, and keeps it exact. What is typed
// may have another unit behind it. What cannot be taken it leaves as it was typed, and says beside it why, until
// somebody types something else or presses Escape. A double click selects the whole number.

#include "core/mechanism/mechanism.h"
#include "core/import/quantity.h"

#include <QAbstractSpinBox>
#include <QPointer>
#include <QString>

class QLabel;

namespace slidercrank
{

/// What a box takes.
struct NumberRange {
    double smallest = -kLargestParameter;
    double largest = kLargestParameter;
    bool isOpen = false;       ///< only what is greater than the smallest
    bool isWhole = false;      ///< whole numbers only
    bool takesNearest = false; ///< of what lies outside the end that is nearer
};

class NumberBox : public QAbstractSpinBox
{
    Q_OBJECT

    // By these a screen reader, or who speaks to the program, reads and sets it: as Qt's own boxes have them.
    Q_PROPERTY(double value READ value WRITE edit NOTIFY edited)
    Q_PROPERTY(double minimum READ smallest)
    Q_PROPERTY(double maximum READ largest)
    Q_PROPERTY(double singleStep READ step)

public:
    explicit NumberBox(QWidget *parent = nullptr);

    double value() const { return m_value; }
    double smallest() const { return m_range.smallest; }
    double largest() const { return m_range.largest; }
    double step() const;

    /// Does not emit. Leaves alone what somebody is just typing.
    void setValue(double value);

    /// As if it were typed.
    void edit(double value);

    /// Of the number shown, and of one typed alone; without it none is understood.
    void setUnit(const Unit &unit) { m_unit = unit; }

    void setRange(const NumberRange &range) { m_range = range; }

    /// The text is somebody's, and another one than the box would show.
    bool isTyping() const;

    /// Takes what was typed, as Enter does.
    void commit();

    /// Shown behind the number, with the space that belongs there: " mm", "°".
    void setSuffix(const QString &suffix);

    /// Always so many decimals where there is room, also while edited: for a number that runs.
    void setFixedDecimals(int decimals);

    /// What one press of an arrow adds; 0: a tenth of the number's power of ten.
    void setStep(double step) { m_step = step; }

    /// The box asks for room for this text.
    void setWidestText(const QString &text);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    void stepBy(int steps) override;

signals:
    void edited(double value); ///< somebody typed a number (and pressed Enter or left) or pressed an arrow

protected:
    StepEnabled stepEnabled() const override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QString textFor(double value) const;
    void showValue();
    void selectFromItsEnd();
    void take(double value);
    QString refusalOf(double value) const; ///< empty: it is taken
    void refuse(const QString &sentence);
    void takeBackRefusal();
    void tellValue();

    double m_value = 0.0;
    double m_step = 0.0;
    std::optional<Unit> m_unit;
    NumberRange m_range;
    int m_fixedDecimals = -1; ///< negative: as many as it takes
    QString m_suffix;
    QString m_widestText;
    bool m_editing = false;     ///< has the focus: every digit is shown
    bool m_typed = false;       ///< the text is somebody's and not taken over yet
    QPointer<QLabel> m_refusal; ///< why it was not, beside the box; null: never yet
};

} // namespace slidercrank
