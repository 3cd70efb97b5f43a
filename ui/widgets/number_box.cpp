// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_box.h"

#include "ui/widgets/named.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <QAccessible>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

bool isUndo(const QKeyEvent &key)
{
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

} // namespace

NumberBox::NumberBox(QWidget *parent)
    : QAbstractSpinBox(parent)
    , m_widestText(QStringLiteral("-000.000"))
{
    setFocusPolicy(Qt::StrongFocus); // not by the wheel: scrolling past must change nothing
    setAlignment(Qt::AlignRight);
    connect(this, &QAbstractSpinBox::editingFinished, this, &NumberBox::commit);
    lineEdit()->installEventFilter(this);
    // Not QLineEdit::isModified(): the spin box clears that before it says that Enter was pressed.
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        m_typed = true;
        takeBackRefusal();
    });
    showValue();
}

void NumberBox::setValue(double value)
{
    if (value == m_value) {
        if (!m_editing && !m_typed) {
            showValue();
        }
        return;
    }
    m_value = value;
    if (!(m_editing && m_typed)) {
        showValue();
    }
    tellValue();
}

void NumberBox::edit(double value)
{
    if (m_range.takesNearest) {
        value = std::clamp(value, m_range.smallest, m_range.largest);
    }
    if (const QString refusal = refusalOf(value); !refusal.isEmpty()) {
        refuse(refusal);
    } else {
        take(value);
    }
}

void NumberBox::take(double value)
{
    const bool isDifferent = value != m_value;
    m_value = value;
    showValue();
    if (isDifferent) {
        tellValue();
        emit edited(m_value);
    }
}

void NumberBox::tellValue()
{
    if (QAccessible::isActive()) {
        QAccessibleValueChangeEvent event(this, m_value);
        QAccessible::updateAccessibility(&event);
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

double NumberBox::step() const
{
    if (m_step != 0.0) {
        return m_step;
    }
    return m_value == 0.0 ? 1.0 : std::pow(10.0, std::floor(std::log10(std::abs(m_value) * (1.0 + 1e-9))) - 1.0);
}

void NumberBox::stepBy(int steps)
{
    commit();
    double step = this->step();
    // Towards zero from a power of ten, the next lower decade rules: 100 → 99, not 90.
    if (m_step == 0.0 && m_value != 0.0 && (m_value > 0.0) == (steps < 0)) {
        step = std::pow(10.0, std::floor(std::log10(std::abs(m_value) * (1.0 - 1e-9))) - 1.0);
    }
    // Steps of a tenth would leave a tail of binary rounding.
    const double target = m_value + steps * step;
    const double grain = step * 1e-6;
    double value = std::abs(target / grain) < 1e15 ? std::round(target / grain) * grain : target;
    value = std::clamp(QString::number(value, 'g', 14).toDouble(), m_range.smallest, m_range.largest);
    if (refusalOf(value).isEmpty()) {
        take(value);
        selectFromItsEnd();
    }
}

QAbstractSpinBox::StepEnabled NumberBox::stepEnabled() const
{
    StepEnabled enabled = StepNone;
    enabled.setFlag(StepUpEnabled, !isReadOnly() && m_value < m_range.largest);
    enabled.setFlag(StepDownEnabled, !isReadOnly() && m_value > m_range.smallest);
    return enabled;
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    m_editing = true;
    if (!m_typed) {
        showValue();
    }
    QAbstractSpinBox::focusInEvent(event);
    if (lineEdit()->selectedText() == lineEdit()->text()) {
        selectFromItsEnd();
    }
}

void NumberBox::focusOutEvent(QFocusEvent *event)
{
    QAbstractSpinBox::focusOutEvent(event); // commits
    m_editing = false;
    if (!m_typed) {
        showValue();
    }
    lineEdit()->setCursorPosition(0);
}

/// All of it, with the cursor before it: a long number shows its first digits.
void NumberBox::selectFromItsEnd()
{
    const int length = static_cast<int>(lineEdit()->text().size());
    lineEdit()->setSelection(length, -length);
}

bool NumberBox::isTyping() const
{
    return m_typed && lineEdit()->text().trimmed() != textFor(m_value) + m_suffix;
}

/// What was typed and not taken over yet is undone in the box; anything else is the window's to undo. So are all keys
/// with Control that have another meaning than the clipboard: on some systems they move in a line of text.
bool NumberBox::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const auto is = [key](QKeySequence::StandardKey meaning) { return key->matches(meaning); };
        const bool isClipboard =
            is(QKeySequence::Copy) || is(QKeySequence::Cut) || is(QKeySequence::Paste) || is(QKeySequence::SelectAll);
        const bool isMeant = isUndo(*key) ? isTyping() : isClipboard || !key->modifiers().testFlag(Qt::ControlModifier);
        if (!isMeant) {
            event->ignore();
            return false;
        }
    }
    return QAbstractSpinBox::event(event);
}

/// The line of text itself would take a word, which ends at the number's point; afterwards, so that it counts clicks
/// on.
bool NumberBox::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonDblClick) {
        QMetaObject::invokeMethod(this, &NumberBox::selectFromItsEnd, Qt::QueuedConnection);
    }
    return QAbstractSpinBox::eventFilter(watched, event);
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    if (isUndo(*event) && !isTyping()) {
        event->ignore(); // also where the window has nothing more to undo
        return;
    }
    if (event->key() == Qt::Key_Escape && m_typed) {
        showValue();
        selectFromItsEnd();
        return;
    }
    QAbstractSpinBox::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        selectFromItsEnd();
    }
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
    constexpr int kMargins = 4; // px: what QLineEdit keeps free beside its text
    const auto fits = [this](const QString &text) {
        return fontMetrics().horizontalAdvance(text + m_suffix) <= lineEdit()->width() - kMargins;
    };
    if (m_fixedDecimals >= 0) {
        const bool nothing = std::abs(value) < 0.5 * std::pow(10.0, -m_fixedDecimals); // not "-0.00"
        const QString text = localeWithoutGroups().toString(nothing ? 0.0 : value, 'f', m_fixedDecimals);
        if (m_editing || fits(text)) {
            return text;
        }
    } else if (m_editing) {
        return typedNumberText(value);
    }
    // As many digits as there is room for: with its end cut off -2.17724e-5 would read as -2.1772.
    constexpr int kMostDigits = 6;
    constexpr int kFewestDigits = 2;
    for (int digits = kMostDigits; digits > kFewestDigits; --digits) {
        if (const QString text = numberText(value, digits); fits(text)) {
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
        const bool isChosen = lineEdit()->hasSelectedText() && lineEdit()->selectedText() == lineEdit()->text();
        lineEdit()->setText(text);
        lineEdit()->setCursorPosition(0); // what does not fit is cut at its end
        if (isChosen) {
            selectFromItsEnd(); // it runs: what is typed still takes its place
        }
    }
    m_typed = false;
    takeBackRefusal();
}

void NumberBox::commit()
{
    if (!m_typed) {
        return;
    }
    const QString text = lineEdit()->text().trimmed();
    const QString shown = textFor(m_value);
    if (text.isEmpty() || text == shown || text == shown + m_suffix) {
        showValue();
        return;
    }
    QString number = text;
    if (const QString suffix = m_suffix.trimmed(); !m_unit && text.endsWith(suffix)) {
        number.chop(suffix.size()); // "2×", as displayed
    }
    const Quantity typed = m_range.isWhole ? readCount(number) : readQuantity(number, m_unit);
    if (typed.fault) {
        refuse(quantityFaultText(text, *typed.fault, m_unit));
    } else {
        edit(typed.value);
    }
}

QString NumberBox::refusalOf(double value) const
{
    const auto withUnit = [this](double limit) {
        return (m_range.isWhole ? countText(static_cast<std::size_t>(limit)) : numberText(limit)) + m_suffix;
    };
    if (m_range.isWhole && (value != std::round(value) || value < m_range.smallest || value > m_range.largest)) {
        return tr("This must be a whole number from %1 to %2.")
            .arg(withUnit(m_range.smallest), withUnit(m_range.largest));
    }
    if (m_range.isOpen && value <= m_range.smallest) {
        return tr("This must be greater than %1.").arg(withUnit(m_range.smallest));
    }
    if (value < m_range.smallest) {
        return tr("This must be at least %1.").arg(withUnit(m_range.smallest));
    }
    return value > m_range.largest ? tr("This must be at most %1.").arg(withUnit(m_range.largest)) : QString();
}

/// Under the box, or above it where there is no room, over its neighbours, but a box that has the focus: nothing moves.
void NumberBox::refuse(const QString &sentence)
{
    QWidget *around = parentWidget() ? parentWidget() : this;
    if (!m_refusal) {
        m_refusal = named("refusalLabel", new QLabel(around));
        m_refusal->setAttribute(Qt::WA_TransparentForMouseEvents);
        m_refusal->setTextFormat(Qt::PlainText);
        m_refusal->setWordWrap(true);
        m_refusal->setFrameShape(QFrame::Box);
        m_refusal->setMargin(3);
        m_refusal->setAutoFillBackground(true);
        m_refusal->setBackgroundRole(QPalette::ToolTipBase);
        m_refusal->setForegroundRole(QPalette::ToolTipText);
        connect(qApp, &QApplication::focusChanged, m_refusal, [label = m_refusal.data()](QWidget *, QWidget *now) {
            const bool covers = qobject_cast<NumberBox *>(now) && now->parentWidget() == label->parentWidget() &&
                                now->geometry().intersects(label->geometry());
            label->setVisible(!label->text().isEmpty() && !covers); // one sees what one types
        });
    }
    m_refusal->setText(sentence);
    constexpr int kAir = 12; // px: margin, frame, and what rounding takes
    const int width = std::min(around->width(), m_refusal->fontMetrics().horizontalAdvance(sentence) + kAir);
    QRect place(0, 0, width, m_refusal->heightForWidth(width));
    place.moveTopRight(geometry().bottomRight() + QPoint(0, 1));
    if (place.bottom() > around->height() && geometry().top() >= place.height()) {
        place.moveBottom(geometry().top() - 1);
    }
    place.moveLeft(std::max(0, place.left()));
    m_refusal->setGeometry(place);
    m_refusal->raise();
    m_refusal->show();
    setAccessibleDescription(sentence);
    if (QAccessible::isActive()) {
        QAccessibleEvent alert(m_refusal, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    }
}

void NumberBox::takeBackRefusal()
{
    if (m_refusal && !m_refusal->text().isEmpty()) {
        m_refusal->clear();
        m_refusal->hide();
        setAccessibleDescription({});
    }
}

} // namespace slidercrank
