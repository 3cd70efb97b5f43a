// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/paragraph.h"

#include <algorithm>

namespace slidercrank
{

Paragraph::Paragraph(const QString &text, QWidget *parent)
    : QLabel(text, parent)
{
    setWordWrap(true);
}

int Paragraph::heightForWidth(int width) const
{
    constexpr qsizetype kMostWidths = 64; // somebody pulls at the window
    if (text() != m_text || font() != m_font || m_heights.size() > kMostWidths) {
        m_heights.clear();
        m_text = text();
        m_font = font();
    }
    auto height = m_heights.constFind(width);
    if (height == m_heights.constEnd()) {
        height = m_heights.insert(width, QLabel::heightForWidth(width));
    }
    return *height;
}

QSize Paragraph::minimumSizeHint() const
{
    constexpr int kLongestWord = 40; // letters
    const QSize size = QLabel::minimumSizeHint();
    return {std::min(size.width(), kLongestWord * fontMetrics().averageCharWidth()), size.height()};
}

Paragraph *plainText(const QString &text)
{
    auto *paragraph = new Paragraph(text);
    paragraph->setTextFormat(Qt::PlainText);
    paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard); // and copied by key
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
