// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A box for one number: shows it shortened, in the user's locale and with its unit, and keeps it exact. It takes any
// number; whoever owns the box decides whether the number will do, and puts the old one back if not.

#include <QAbstractSpinBox>
#include <QString>

namespace slidercrank
{

class NumberBox : public QAbstractSpinBox
{
    Q_OBJECT

public:
    explicit NumberBox(QWidget *parent = nullptr);

    double value() const { return m_value; }

    /// Does not emit. Leaves alone what somebody is just typing.
    void setValue(double value);

    /// Shown behind the number, with the space that belongs there: " mm", "°".
    void setSuffix(const QString &suffix);

    /// Always so many decimals, also while edited: for a number that runs.
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
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QString textFor(double value) const;
    void showValue();
    void commit();

    double m_value = 0.0;
    double m_step = 0.0;
    int m_fixedDecimals = -1; ///< negative: as many as it takes
    QString m_suffix;
    QString m_widestText;
    bool m_editing = false; ///< has the focus: every digit is shown
    bool m_typed = false;   ///< the text is somebody's and not taken over yet
};

} // namespace slidercrank
