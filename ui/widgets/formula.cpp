// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/formula.h"

#include "ui/text/subscripts.h"

#include <QPainter>
#include <QStaticText>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStylePainter>

#include <utility>

namespace slidercrank
{

void drawFormula(QPainter &painter, const QRect &box, Qt::Alignment alignment, const QString &formula)
{
    const QStaticText text = withSubscripts(formula, painter.font());
    const QSize size = text.size().toSize();
    painter.setClipRect(box);
    painter.drawStaticText(QStyle::alignedRect(Qt::LeftToRight, alignment, size, box).topLeft(), text);
}

void FormulaDelegate::paint(QPainter *painter, const QStyleOptionViewItem &given, const QModelIndex &index) const
{
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QString formula = std::exchange(option.text, {});
    const QStyle *style = option.widget->style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &option, option.widget) + 1;
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setFont(option.font);
    painter->setPen(option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    drawFormula(*painter, option.rect.adjusted(margin, 0, -margin, 0), option.displayAlignment, formula);
    painter->restore();
}

FormulaBox::FormulaBox(QWidget *parent)
    : QComboBox(parent)
{
    setItemDelegate(new FormulaDelegate(this));
}

void FormulaBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    constexpr int kMargin = 3; // px
    const QRect field = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    painter.setPen(option.palette.color(QPalette::ButtonText));
    drawFormula(painter, field.adjusted(kMargin, 0, -kMargin, 0), Qt::AlignLeft | Qt::AlignVCenter, currentText());
}

} // namespace slidercrank
