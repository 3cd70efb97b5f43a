// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "ui/text/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace slidercrank
{

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent)
    , m_symbol(new QLabel(this))
    , m_text(named("messageText", new Paragraph({}, this)))
    , m_remedyButton(named("messageRemedy", new QPushButton(this)))
    , m_dismiss(named("messageDismiss", new QPushButton(this)))
{
    setObjectName(QStringLiteral("messageBar"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

    for (QPushButton *button : {m_remedyButton, m_dismiss}) {
        button->setFocusPolicy(Qt::TabFocus); // they vanish when pressed: a click must not leave the focus to chance
    }

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, 6, 4);
    row->addWidget(m_symbol);
    row->addWidget(m_text, 1);
    row->addWidget(m_remedyButton);
    row->addWidget(m_dismiss);

    connect(m_dismiss, &QPushButton::clicked, this, [this] {
        hide();
        emit dismissed();
    });
    connect(m_remedyButton, &QPushButton::clicked, this, [this] {
        hide();
        const std::function<void()> remedy = m_remedy; // the remedy may show another message
        remedy();
    });
    recolour();
    hide();
}

void MessageBar::showMessage(Kind kind, const QString &sentence, const QString &remedyText,
                             const std::function<void()> &remedy, const QString &dismissText)
{
    m_kind = kind;
    m_remedy = remedy;
    m_text->setText(sentence);
    setAccessibleName(sentence);
    m_remedyButton->setText(remedyText);
    m_dismiss->setText(dismissText.isEmpty() ? tr("Dismiss")
                                             : dismissText); // now: the bar outlives a change of the language
    m_remedyButton->setVisible(static_cast<bool>(remedy));
    recolour();
    show();
}

QString MessageBar::text() const
{
    return m_text->text();
}

void MessageBar::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange) {
        recolour();
    }
    QFrame::changeEvent(event);
}

void MessageBar::recolour()
{
    const SeriesColours colours = seriesColours(palette());
    const QColor accent = m_kind == Kind::Problem ? colours.warning : colours.model;
    m_symbol->setText(m_kind == Kind::Problem ? QStringLiteral("⚠") : QStringLiteral("ℹ"));
    setInk(*m_symbol, accent);
}

} // namespace slidercrank
