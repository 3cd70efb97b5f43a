// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/number_box.h"

#include "ui/words/written_number.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>

#include <cmath>

namespace slidercrank
{

NumberBox::NumberBox(QWidget *parent)
    : QAbstractSpinBox(parent)
    , m_widestText(QStringLiteral("-000.000"))
{
    setFocusPolicy(Qt::StrongFocus); // not by the wheel: scrolling past must change nothing
    setAlignment(Qt::AlignRight);
    connect(this, &QAbstractSpinBox::editingFinished, this, &NumberBox::commit);
    // Not QLineEdit::isModified(): the spin box clears that before it says that Enter was pressed.
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] { m_typed = true; });
    showValue();
}

void NumberBox::setValue(double value)
{
    if (value == m_value) {
        if (!m_editing) {
            showValue();
        }
        return;
    }
    m_value = value;
    if (!(m_editing && m_typed)) {
        showValue();
    }
}

void NumberBox::setSuffix(const QString &suffix)
{
    m_suffix = suffix;
    showValue();
    updateGeometry();
}

void NumberBox::setFixedDecimals(int decimals)
{
    m_fixedDecimals = decimals;
    showValue();
}

void NumberBox::setWidestText(const QString &text)
{
    m_widestText = text;
    updateGeometry();
}

QSize NumberBox::sizeHint() const
{
    ensurePolished();
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const int cursor = 4; // px; what QAbstractSpinBox leaves for the blinking cursor, and a little air
    const QSize content(fontMetrics().horizontalAdvance(m_widestText + m_suffix) + cursor,
                        lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
}

QSize NumberBox::minimumSizeHint() const
{
    return sizeHint();
}

void NumberBox::stepBy(int steps)
{
    commit();
    double step = m_step;
    if (step == 0.0) {
        // Towards zero from a power of ten, the next lower decade rules: 100 → 99, not 90.
        const bool towardsZero = (m_value > 0.0) == (steps < 0);
        const double magnitude = std::abs(m_value) * (towardsZero ? 1.0 - 1e-9 : 1.0 + 1e-9);
        step = m_value == 0.0 ? 1.0 : std::pow(10.0, std::floor(std::log10(magnitude)) - 1.0);
    }
    // Steps of a tenth would leave a tail of binary rounding.
    const double target = m_value + steps * step;
    const double grain = step * 1e-6;
    m_value = std::abs(target / grain) < 1e15 ? std::round(target / grain) * grain : target;
    m_value = QString::number(m_value, 'g', 14).toDouble();
    showValue();
    selectAll();
    emit edited(m_value);
}

QAbstractSpinBox::StepEnabled NumberBox::stepEnabled() const
{
    return isReadOnly() ? StepNone : StepUpEnabled | StepDownEnabled;
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    m_editing = true;
    showValue();
    QAbstractSpinBox::focusInEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent *event)
{
    QAbstractSpinBox::focusOutEvent(event); // commits
    m_editing = false;
    showValue();
}

/// What was typed and not taken over yet is undone in the box; anything else is the window's to undo.
bool NumberBox::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && !m_typed) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QAbstractSpinBox::event(event);
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_typed) {
        showValue();
        selectAll();
        return;
    }
    QAbstractSpinBox::keyPressEvent(event);
}

void NumberBox::wheelEvent(QWheelEvent *event)
{
    if (hasFocus()) {
        QAbstractSpinBox::wheelEvent(event);
    } else {
        event->ignore();
    }
}

void NumberBox::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LocaleChange) {
        showValue();
    }
    QAbstractSpinBox::changeEvent(event);
}

QString NumberBox::textFor(double value) const
{
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    if (m_fixedDecimals >= 0) {
        const bool nothing = std::abs(value) < 0.5 * std::pow(10.0, -m_fixedDecimals); // not "-0.00"
        return localeWithoutGroups().toString(nothing ? 0.0 : value, 'f', m_fixedDecimals);
    }
    if (m_editing) {
        return numberText(value, QLocale::FloatingPointShortest);
    }
    // As many digits as there is room for: with its end cut off -2.17724e-5 would read as -2.1772.
    constexpr int kMostDigits = 6;
    constexpr int kFewestDigits = 2;
    constexpr int kMargins = 4; // px: what QLineEdit keeps free beside its text
    const int room = lineEdit()->width() - kMargins;
    for (int digits = kMostDigits; digits > kFewestDigits; --digits) {
        const QString text = numberText(value, digits);
        if (fontMetrics().horizontalAdvance(text + m_suffix) <= room) {
            return text;
        }
    }
    return numberText(value, kFewestDigits);
}

void NumberBox::resizeEvent(QResizeEvent *event)
{
    QAbstractSpinBox::resizeEvent(event);
    if (!m_typed) {
        showValue();
    }
}

void NumberBox::showValue()
{
    const QString text = textFor(m_value) + m_suffix;
    if (text != lineEdit()->text()) {
        lineEdit()->setText(text);
        if (!m_editing) {
            lineEdit()->setCursorPosition(0); // what does not fit is cut at its end
        }
    }
    m_typed = false;
}

void NumberBox::commit()
{
    if (!m_typed) {
        return;
    }
    QString text = lineEdit()->text().trimmed();
    const QString unit = m_suffix.trimmed();
    if (!unit.isEmpty() && text.endsWith(unit)) {
        text.chop(unit.size());
    }
    const std::optional<double> typed = readNumber(text);
    const bool different = typed && *typed != m_value && text.trimmed() != textFor(m_value);
    if (different) {
        m_value = *typed;
    }
    showValue();
    if (different) {
        emit edited(m_value);
    }
}

} // namespace slidercrank
