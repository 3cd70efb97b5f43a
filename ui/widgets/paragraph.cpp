// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/paragraph.h"

#include <QRegularExpression>

namespace slidercrank
{

QString withUnbrokenUnits(QString text)
{
    static const QRegularExpression kAroundSign("(?<=[=≥≤<±+−]) | (?=[=≥≤<±+−])");
    static const QRegularExpression kBeforeUnit("(?<=\\d) (?=%|°|mm|cm|m\\b|in\\b|rad|s\\b)");
    text.replace(kAroundSign, "\u00a0").replace(kBeforeUnit, "\u00a0");
    return text.replace("|c|", "|\u2060c|").replace("|\u00a0", "|\u2060\u00a0"); // a line may end after a bar
}

QLabel *plainText(const QString &text)
{
    auto *paragraph = new QLabel(withUnbrokenUnits(text));
    paragraph->setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    paragraph->setSizePolicy(policy);
    paragraph->setTextFormat(Qt::PlainText);
    // Not selectable by the keyboard, for which a click would leave a caret.
    paragraph->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return paragraph;
}

} // namespace slidercrank
