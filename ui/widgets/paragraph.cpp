// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/paragraph.h"

#include <QRegularExpression>

namespace slidercrank
{

QString withUnbrokenUnits(QString text)
{
    text.replace("θ₂₀ = ", "θ₂₀\u00a0=\u00a0").replace(" ± ", "\u00a0±\u00a0");
    text.replace("|c|", "|\u2060c|"); // a line may end after a bar
    static const QRegularExpression kBeforeUnit("(?<=\\d) (?=%|°|mm|rad|s\\b)");
    return text.replace(kBeforeUnit, "\u00a0");
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
