// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>

namespace slidercrank
{

namespace
{

constexpr std::chrono::seconds kHintDuration{8};
constexpr int kSpaceBetweenMessages = 2;          // px
constexpr QMargins kMarginsOfMessage{8, 3, 4, 3}; // px: left, top, right, bottom
constexpr int kSymbolColumn = 0;                  // columns of a message
constexpr int kTextColumn = 1;
constexpr int kActionColumn = 2;
constexpr int kDismissColumn = 3;
constexpr int kColumnsBesideSymbol = kDismissColumn - kTextColumn + 1;

QLabel *makeSymbol(Message::Kind kind, const QWidget &widget)
{
    const auto icon = kind == Message::Kind::Problem ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation;
    auto *symbol = new QLabel;
    symbol->setPixmap(widget.style()->standardIcon(icon).pixmap(widget.fontMetrics().height() + 2));
    return symbol;
}

/// Returns an empty frame for the message with this id.
QFrame *makeFrame(const QString &id)
{
    auto *frame = named(id, new QFrame);
    frame->setFrameShape(QFrame::Box);
    frame->setAutoFillBackground(true);
    frame->setBackgroundRole(QPalette::ToolTipBase);
    frame->setForegroundRole(QPalette::ToolTipText);
    return frame;
}

} // namespace

MessageBar::MessageBar(QWidget *parent)
    : QWidget(parent)
    , m_rows(new QVBoxLayout(this))
{
    setObjectName("messageBar");
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(kSpaceBetweenMessages);
    parent->installEventFilter(this);
    hide();
}

void MessageBar::showMessage(const Message &message)
{
    removeMessage(message.id);
    auto *row = makeFrame(message.id);
    auto *text = named("messageText", plainText(message.text));
    text->setForegroundRole(QPalette::ToolTipText);
    const bool areButtonsBelow = message.action != nullptr; // two buttons beside the text would leave it little width
    auto *grid = new QGridLayout(row);
    grid->setContentsMargins(kMarginsOfMessage);
    grid->setColumnStretch(kTextColumn, 1);
    grid->addWidget(makeSymbol(message.kind, *this), 0, kSymbolColumn);
    grid->addWidget(text, 0, kTextColumn, 1, areButtonsBelow ? kColumnsBesideSymbol : 1);
    const auto addButton = [&](int column, const char *name, const QString &label,
                               const std::function<void()> &action) {
        // The accessible name includes the message, because there may be several such buttons.
        auto *button = named(name, new QPushButton(label), label + ": " + message.text);
        button->setFocusPolicy(Qt::TabFocus); // the button disappears when clicked and must not have the focus then
        connect(button, &QPushButton::clicked, this, [this, row, action] {
            remove(row);
            if (action) {
                action();
            }
        });
        grid->addWidget(button, areButtonsBelow ? 1 : 0, column);
    };
    if (message.action) {
        addButton(kActionColumn, "messageRemedy", message.actionText, message.action);
    }
    addButton(kDismissColumn, "messageDismiss", message.dismissText.isEmpty() ? tr("Dismiss") : message.dismissText,
              message.dismissed);
    m_rows->insertWidget(0, row);
    row->show(); // the layout leaves out a row that is not shown yet
    if (message.kind == Message::Kind::Hint) {
        auto *timer = new QTimer(row);
        connect(timer, &QTimer::timeout, this, [this, row] { remove(row); });
        timer->start(kHintDuration);
    }
    updateGeometryAndVisibility();
}

void MessageBar::removeMessage(const QString &id)
{
    if (auto *row = findChild<QFrame *>(id, Qt::FindDirectChildrenOnly)) {
        remove(row);
    }
}

/// Hides the row at once and deletes it later, because one of its buttons may be handling a click.
void MessageBar::remove(QFrame *row)
{
    m_rows->removeWidget(row);
    row->hide();
    row->setObjectName(QString());
    row->deleteLater();
    updateGeometryAndVisibility();
}

void MessageBar::setMuted(bool muted)
{
    m_isMuted = muted;
    updateGeometryAndVisibility();
}

bool MessageBar::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize) {
        updateGeometryAndVisibility();
    }
    return QWidget::eventFilter(watched, event);
}

void MessageBar::updateGeometryAndVisibility()
{
    constexpr int kMargin = 6;    // px
    constexpr int kMaxWidth = 64; // characters
    const int space = parentWidget()->width() - 2 * kMargin;
    const int width = std::min(space, kMaxWidth * fontMetrics().averageCharWidth());
    setGeometry(kMargin, kMargin, width, std::max(0, m_rows->heightForWidth(width)));
    setVisible(m_rows->count() > 0 && !m_isMuted);
    raise();
}

} // namespace slidercrank

#include "moc_message_bar.cpp"
