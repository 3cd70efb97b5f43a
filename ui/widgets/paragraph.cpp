// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/paragraph.h"

namespace slidercrank
{

QLabel *plainText(const QString &text)
{
    auto *paragraph = new QLabel(text);
    paragraph->setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    paragraph->setSizePolicy(policy);
    paragraph->setTextFormat(Qt::PlainText);
    paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return paragraph;
}

} // namespace slidercrank
