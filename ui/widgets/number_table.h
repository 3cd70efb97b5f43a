// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A table of names and numbers that change while one looks: short on the screen, every digit in the clipboard (CSV,
// with a decimal point), a colour for the size of a number where it is wanted. It tells which part of the mechanism the
// row under the mouse, or the current one, is about, and to which instant somebody wants to go.

#include "core/mechanism/mechanism_part.h"

#include <QIcon>
#include <QTableView>

#include <optional>
#include <vector>

namespace slidercrank
{

struct TableColumn {
    QString title;
    QString explanation = {}; ///< tool tip of the title
    QString csvName = {};     ///< of the first column empty: nobody copies the table
    bool isNumber = true;
};

struct TableCell {
    QString text;           ///< on screen; in the CSV too where there is no number and nothing else for it
    QString shortText = {}; ///< on screen where `text` does not fit; empty: `text`, cut off
    std::optional<double> number = {};
    double tint = 0.0; ///< -1 … 1: how strongly, and by the sign in which colour, the cell is filled
    QString explanation = {};
    QColor ink = {};                    ///< invalid: that of the palette
    QString spoken = {};                ///< by a screen reader, where it is not the text
    std::optional<double> instant = {}; ///< s, where a click on it leads
    QString csv = {};                   ///< in the CSV instead of the text
    QIcon mark = {};                    ///< before the text
};

struct TableRow {
    MechanismPart part = MechanismPart::None;
    std::vector<TableCell> cells;       ///< one a column
    std::optional<double> instant = {}; ///< s, where Enter leads, and a click on a cell without one
};

enum class TableLook {
    Dense,  ///< rows as high as their text, the one under the mouse lit
    Striped ///< with air, every other row tinted; several can be chosen
};

class NumberTableModel;
class CellDelegate;

class NumberTable : public QTableView
{
    Q_OBJECT

public:
    /// `name` for the program, `title` for a screen reader.
    NumberTable(const QString &name, const QString &title, std::vector<TableColumn> columns,
                TableLook look = TableLook::Dense);

    /// Only the cells that change are painted anew.
    void setRows(std::vector<TableRow> rows);

    /// A line a row: all of them, or those.
    QString csv() const;
    QString csv(const std::vector<int> &rows) const;

    /// Room in a column for such a text, whatever it holds now; without: the rest of the width.
    void setColumnText(int column, const QString &longest);

    int widthFor(const QString &text) const; ///< of a column, px

    /// Room in every column for what it holds now, of short texts where there is no room for all, and air (px) as far
    /// as there is room for it.
    void fitToContents(int leastAir = 0, int mostAir = 0);

    void setRuled(bool ruled);  ///< a line below each row, where much is empty
    void setRowAir(int pixels); ///< beyond the height of a text

    /// What a cell has room for.
    QString shownText(const QModelIndex &index) const;

public slots:
    void copy(); ///< as CSV: the rows that are chosen where several may be, else all

signals:
    void copied(int rows);
    void partHovered(slidercrank::MechanismPart part); ///< None: no row is pointed at
    void instantRequested(double seconds);             ///< somebody wants to see the mechanism there

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
    bool copies(QKeyEvent *event) const;
    void goTo(std::optional<double> instant);
    void fitColumns();
    void setHeights();
    void point(int row); ///< with the mouse; -1: at none
    void tell();

    NumberTableModel *m_model;
    CellDelegate *m_delegate;
    TableLook m_look;
    int m_rowAir;
    std::vector<QString> m_longest; ///< a column; null: the rest of the width; empty: the columns fit what they hold
    int m_leastAir = 0;
    int m_mostAir = 0;
    int m_pointed = -1;
    MechanismPart m_told = MechanismPart::None;
};

/// What a cell with that tint is filled with, on that palette.
QColor tintColour(double tint, const QPalette &palette);

} // namespace slidercrank
