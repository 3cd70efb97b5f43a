// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_box.h"

#include "core/mechanism/mechanism.h"
#include "ui/text/expression.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/popup_position.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyleOptionSpinBox>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kDecimals = 60; // with fewer, QDoubleSpinBox would round small numbers
constexpr std::chrono::seconds kNoteDuration{10};
constexpr int kNoteMargin = 3;    // px
constexpr int kMinimumDigits = 2; // significant digits of a number that is shortened to fit into the box

bool isUndo(const QKeyEvent &key)
{
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

/// Returns the text without the unit at its end, "9" for "9 pt" and "9pt". "9 mm" is not 9 times the unit "m".
QString withoutUnit(QString text, const QString &unit)
{
    const auto endsWithUnit = [&] {
        const qsizetype length = text.size() - unit.size();
        return !unit.isEmpty() && text.endsWith(unit) && (length == 0 || !text[length - 1].isLetter());
    };
    while (endsWithUnit()) {
        text.chop(unit.size());
        text = text.trimmed();
    }
    return text.trimmed();
}

} // namespace

NumberBox::NumberBox(QWidget *parent)
    : QDoubleSpinBox(parent)
{
    setFocusPolicy(Qt::StrongFocus); // without wheel focus, so that scrolling changes no number
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setDecimals(kDecimals);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    setRange(-kLargestParameter, kLargestParameter);
    lineEdit()->installEventFilter(this);
    connect(this, &QDoubleSpinBox::valueChanged, this, &NumberBox::edited);
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        m_hasTyped = false;
        if (!m_refusal.isEmpty()) {
            refuse(std::exchange(m_refusal, {}));
        }
    });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        m_hasTyped = true;
        if (m_note) {
            m_note->hide();
            setAccessibleDescription({});
        }
    });
}

void NumberBox::setValue(double value)
{
    if (value == this->value()) {
        return; // formatting a number takes long during a drag
    }
    const QSignalBlocker quiet(this);
    const bool typing = isTyping();
    const QString typed = lineEdit()->text();
    const int cursor = lineEdit()->cursorPosition();
    const bool isSelected = lineEdit()->hasSelectedText();
    QDoubleSpinBox::setValue(value);
    if (typing) {
        lineEdit()->setText(typed);
        lineEdit()->setCursorPosition(cursor);
    } else if (isSelected) {
        selectNumber(); // the next typed character still replaces the whole number
    }
}

void NumberBox::setRange(double smallest, double largest)
{
    const QSignalBlocker quiet(this);
    QDoubleSpinBox::setRange(smallest, largest);
    m_isPositive = false;
}

void NumberBox::setPositiveRange(double smallest, double largest)
{
    setRange(smallest, largest);
    m_isPositive = true;
}

void NumberBox::setStep(double step)
{
    setStepType(QAbstractSpinBox::DefaultStepType);
    setSingleStep(step);
}

void NumberBox::setFixedDecimals(int decimals)
{
    m_fixedDecimals = decimals;
    if (decimals == 0) {
        setStep(1.0);
    }
    showValue();
}

void NumberBox::setWidestNumber(const QString &number)
{
    m_widestNumber = number;
    updateGeometry();
}

bool NumberBox::isTyping() const
{
    return m_isEditing && lineEdit()->text().trimmed() != shownText();
}

QSize NumberBox::sizeHint() const
{
    ensurePolished();
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    constexpr int kCursor = 4;              // px
    int width = 0;                          // of the wider text: an ordinary number, or one with a power of ten
    constexpr double kWideNumber = -8.8e-8; // has a power of ten, and the widest digits
    for (const QString &number : {m_widestNumber, numberText(kWideNumber, kMinimumDigits)}) {
        width = std::max(width, fontMetrics().horizontalAdvance(number + suffix()));
    }
    const QSize content(width + kCursor, lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
}

void NumberBox::stepBy(int steps)
{
    interpretText();
    const double before = value();
    QSignalBlocker quiet(this);
    QDoubleSpinBox::stepBy(steps);
    const bool isFromZero = before == 0.0 && stepType() == QAbstractSpinBox::AdaptiveDecimalStepType;
    constexpr int kDigits = 12; // without the rounding error of the sum: 0.1 + 0.2 is 0.3
    const double next = isFromZero ? steps : QString::number(value(), 'g', kDigits).toDouble();
    QDoubleSpinBox::setValue(before);
    quiet.unblock();
    if (refusalOf(next).isEmpty()) {
        QDoubleSpinBox::setValue(next);
        selectNumber();
    }
}

/// Returns every digit while the number is edited, otherwise at most six; in either case only as many digits as fit, so
/// that -2.17724e-5 is never cut to -2.1772, and the unit stays visible.
QString NumberBox::textFromValue(double value) const
{
    constexpr int kMargins = 4; // px; margins of QLineEdit
    constexpr int kUnfocusedDigits = 6;
    constexpr int kDigitsOfDouble = 17;
    const auto fits = [this](const QString &text) {
        return fontMetrics().horizontalAdvance(text + suffix()) <= lineEdit()->width() - kMargins;
    };
    if (m_fixedDecimals >= 0) {
        const QString text = fixedText(value, m_fixedDecimals);
        if (m_isEditing || fits(text)) {
            return text;
        }
    } else if (m_isEditing && fits(typedNumberText(value))) {
        return typedNumberText(value);
    }
    int digits = m_isEditing ? kDigitsOfDouble : kUnfocusedDigits;
    while (digits > kMinimumDigits && !fits(numberText(value, digits))) {
        --digits;
    }
    return numberText(value, digits);
}

/// Returns the number in the text, or the current number if the text is refused.
double NumberBox::valueFromText(const QString &text) const
{
    m_refusal.clear();
    const QString number = withoutUnit(text, suffix().trimmed()); // the displayed unit remains in the text while typing
    if (number.isEmpty() || number == textFromValue(value())) {
        return value(); // the exact number instead of the shortened text
    }
    if (m_fixedDecimals == 0 && number.contains(u'.')) { // may separate thousands
        constexpr double kNotWhole = 0.5;                // refused for the same reason as every fraction
        m_refusal = refusalOf(kNotWhole);
        return value();
    }
    const Quantity typed = readExpression(number, m_unit);
    m_refusal = typed.fault ? quantityFaultText(number, *typed.fault, m_unit) : refusalOf(typed.value);
    return m_refusal.isEmpty() ? typed.value : value();
}

/// Returns why the box does not accept the number; empty if it accepts the number.
QString NumberBox::refusalOf(double value) const
{
    const bool isWhole = m_fixedDecimals == 0;
    const auto withUnit = [&](double limit) {
        return (isWhole ? QString::number(std::llround(limit)) : numberText(limit)) + suffix();
    };
    if (isWhole && (value != std::round(value) || value < minimum() || value > maximum())) {
        return tr("This must be a whole number from %1 to %2.").arg(withUnit(minimum()), withUnit(maximum()));
    }
    if (m_isPositive && value <= 0.0) {
        return tr("This must be greater than 0.");
    }
    if (value < minimum()) {
        return tr("This must be at least %1.").arg(withUnit(minimum()));
    }
    return value > maximum() ? tr("This must be at most %1.").arg(withUnit(maximum())) : QString();
}

QValidator::State NumberBox::validate(QString &text, int &) const
{
    if (!suffix().isEmpty() && text.endsWith(suffix())) {
        const QString typed = text.chopped(suffix().size()).trimmed();
        if (typed.endsWith(suffix())) { // the typed unit replaces the displayed unit
            text = typed;
        }
    }
    return QValidator::Acceptable; // valueFromText() checks the number once it is complete
}

void NumberBox::showValue()
{
    const QSignalBlocker quiet(this);
    QDoubleSpinBox::setValue(value());
}

/// Selects the number with the cursor at its start, so that a long number shows its first digits.
void NumberBox::selectNumber()
{
    const int length = static_cast<int>(lineEdit()->text().size());
    lineEdit()->setSelection(length, -length);
}

/// Shows why the number was refused in a note beside the box.
void NumberBox::refuse(const QString &sentence)
{
    if (!m_note) {
        m_note = named("refusalLabel", new QLabel(this, Qt::ToolTip));
        m_note->setTextFormat(Qt::PlainText);
        m_note->setFrameShape(QFrame::Box);
        m_note->setMargin(kNoteMargin);
        m_note->setBackgroundRole(QPalette::ToolTipBase);
        m_note->setForegroundRole(QPalette::ToolTipText);
    }
    m_note->setText(sentence);
    m_note->adjustSize();
    m_note->move(popupPosition(*this, m_note->size()));
    m_note->show();
    setAccessibleDescription(sentence);
    QTimer::singleShot(kNoteDuration, m_note, &QWidget::hide);
}

/// Leaves undo and redo to the window unless text has been typed, and leaves all other Control keys to the window
/// except the keys of the clipboard.
bool NumberBox::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const auto is = [key](QKeySequence::StandardKey meaning) { return key->matches(meaning); };
        const bool isClipboard =
            is(QKeySequence::Copy) || is(QKeySequence::Cut) || is(QKeySequence::Paste) || is(QKeySequence::SelectAll);
        const bool isPlayback = key->key() == Qt::Key_Space && !m_hasTyped; // "120 in" begins like "120 mm"
        const bool isOtherControlKey = key->modifiers().testFlag(Qt::ControlModifier) && !isClipboard;
        const bool isOfWindow = isUndo(*key) ? !isTyping() : isPlayback || isOtherControlKey;
        if (isOfWindow) {
            event->ignore();
            return false;
        }
    }
    return QDoubleSpinBox::event(event);
}

/// Selects the whole number on a double click; QLineEdit would stop at the decimal point.
bool NumberBox::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonDblClick) {
        QMetaObject::invokeMethod(this, &NumberBox::selectNumber, Qt::QueuedConnection);
    }
    return QDoubleSpinBox::eventFilter(watched, event);
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    m_isEditing = true;
    showValue(); // every digit
    QDoubleSpinBox::focusInEvent(event);
    if (lineEdit()->hasSelectedText()) {
        selectNumber();
    }
}

void NumberBox::focusOutEvent(QFocusEvent *event)
{
    QDoubleSpinBox::focusOutEvent(event); // accepts the typed number
    m_isEditing = false;
    showValue();
    lineEdit()->setCursorPosition(0);
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    if (isUndo(*event) && !isTyping()) {
        event->ignore();
        return;
    }
    if ((isTyping() || m_hasTyped) && (event->key() == Qt::Key_Escape || event->matches(QKeySequence::Undo))) {
        lineEdit()->setText(shownText());
        m_hasTyped = false;
        selectNumber();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        event->setAccepted(m_note && m_note->isVisible()); // a dialog does not close with a number that was refused
        emit enterPressed();
    }
}

void NumberBox::resizeEvent(QResizeEvent *event)
{
    QDoubleSpinBox::resizeEvent(event);
    if (!m_hasTyped) {
        showValue();
    }
}

} // namespace slidercrank

#include "moc_number_box.cpp"
