// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/paragraph.h"

namespace slidercrank
{

Paragraph::Paragraph(const QString &text, QWidget *parent)
    : QLabel(text, parent)
{
    setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

Paragraph *plainText(const QString &text)
{
    auto *paragraph = new Paragraph(text);
    paragraph->setTextFormat(Qt::PlainText);
    paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return paragraph;
}

QLabel *boldLabel(const QString &text)
{
    auto *label = new QLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

} // namespace slidercrank
