// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A table of names and numbers that change while one looks: short on the screen, every digit in the clipboard (CSV,
// with a decimal point), a colour for the size of a number where it is wanted. It tells which part of the mechanism the
// row under the mouse, or the current one, is about.

#include "core/mechanism/mechanism_part.h"

#include <QTableView>

#include <limits>
#include <optional>
#include <vector>

namespace slidercrank
{

struct TableColumn {
    QString title;
    QString explanation; ///< tool tip of the title
    QString csvName;
    bool isNumber = true;
};

struct TableCell {
    QString text;      ///< on screen; in the CSV too where there is no number
    QString shortText; ///< on screen where `text` does not fit; empty: `text`, cut off
    std::optional<double> number;
    double tint = 0.0; ///< -1 … 1: how strongly, and by the sign in which colour, the cell is filled
    QString explanation;
};

struct TableRow {
    MechanismPart part = MechanismPart::None;
    std::vector<TableCell> cells; ///< one a column
};

class NumberTableModel;

class NumberTable : public QTableView
{
    Q_OBJECT

public:
    NumberTable(std::vector<TableColumn> columns, QWidget *parent = nullptr);

    /// Only the cells that change are painted anew.
    void setRows(std::vector<TableRow> rows);

    /// All of it, a line a row.
    QString csv() const;

    /// Room in a column for such a text, whatever it holds now; without: the rest of the width.
    void setColumnText(int column, const QString &longest);

    void setRuled(bool ruled); ///< a line below each row, where much is empty

    QSize minimumSizeHint() const override { return {1, 1}; }

public slots:
    void copy() const; ///< as CSV

signals:
    void partHovered(slidercrank::MechanismPart part); ///< None: no row is pointed at

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    void fitColumns();
    void setHeights();
    void point(int row); ///< with the mouse; -1: at none
    void tell();

    NumberTableModel *m_model;
    std::vector<QString> m_longest; ///< a column; null: the rest of the width
    int m_pointed = -1;
    MechanismPart m_told = MechanismPart::None;
};

/// What a cell with that tint is filled with, on that palette.
QColor tintColour(double tint, const QPalette &palette);

} // namespace slidercrank
