// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Widgets that show texts in which the letters after an underscore are subscripts: "v_B".

#include <QComboBox>
#include <QStyledItemDelegate>

class QPainter;

namespace slidercrank
{

void drawFormula(QPainter &painter, const QRect &box, Qt::Alignment alignment, const QString &formula);

/// Cells with subscripts.
class FormulaDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &given, const QModelIndex &index) const override;
};

/// A list of choices with subscripts.
class FormulaBox : public QComboBox
{
public:
    explicit FormulaBox(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace slidercrank
