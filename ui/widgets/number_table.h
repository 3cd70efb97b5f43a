// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A table of names and numbers, which can be typed into at most one row. It shows four significant digits and copies
// every digit, as CSV with a decimal point. It reports the part of the mechanism that the row under the mouse
// describes, and the time that a row leads to.

#include "core/mechanism/mechanism_part.h"

#include <QTableView>

#include <optional>
#include <vector>

class QStandardItemModel;

namespace slidercrank
{

/// The meaning of a text, which its colour shows.
enum class Tone { Normal, Muted, Link, Model, Good, Fair, Bad };
QColor toneColour(Tone tone, const QPalette &palette);

struct TableColumn {
    QString title;
    QString explanation = {}; ///< tool tip of the title
    QString csvName = {};
    bool isNumber = true;   ///< aligned to the right
    bool isFormula = false; ///< the letters behind an underscore are subscripts
};

struct TableCell {
    QString text;
    std::optional<double> number = {}; ///< with every digit; in a column of numbers the CSV contains it alone
    QString csv = {};                  ///< replaces the text in the CSV, if not empty
    Tone tone = Tone::Normal;
};

/// Returns a cell with a number, written as the text; a dash if the number is not finite.
TableCell numberCell(double value, const QString &text);

struct TableRow {
    std::vector<TableCell> cells;             ///< one for each column
    std::optional<double> time = {};          ///< s; a click or Enter goes to this time
    MechanismPart part = MechanismPart::None; ///< the part of the mechanism that the row describes
    QString explanation = {};                 ///< tool tip; if empty, the numbers with every digit
};

/// Returns a line of headings and a line for each row, with csvSeparators(); numbers have every digit. Returns an empty
/// text without rows.
QByteArray csvText(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows);

class NumberTable : public QTableView
{
    Q_OBJECT

public:
    /// `name`: the object name; `title`: what a screen reader announces.
    NumberTable(const QString &name, const QString &title, std::vector<TableColumn> columns);

    /// Replaces the columns; their number must stay the same.
    void setColumns(const std::vector<TableColumn> &columns);

    /// Replaces the rows. Only the cells that change are painted again.
    void setRows(std::vector<TableRow> rows);

    /// Lets a person type into the cells of `row` from `firstColumn` on. typed() then reports the text, and the
    /// receiver must call setRows() to show it.
    void setEditable(int row, int firstColumn);

    QSize contentSize() const; ///< size of the headings and all rows, px

public slots:
    void copy(); ///< copies the selected rows as CSV, or every row if none is selected

signals:
    void copied();
    void partHovered(slidercrank::MechanismPart part); ///< None: no row is under the mouse
    void rowHovered(int row);                          ///< the row under the mouse; -1: none
    void timeRequested(double seconds);
    void typed(int column, const QString &text); ///< into the row that can be edited

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    bool edit(const QModelIndex &index, EditTrigger trigger, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void setBehaviour();
    void setAppearance();
    void connectSignals();
    void makeHeadings();
    void goToRow(const QModelIndex &index);
    bool isEditableCell(const QModelIndex &index) const; ///< whether a person can type into the cell
    bool hasNames() const;                               ///< whether numbers follow the texts of the first column
    int widthOfNames() const;
    void fillCells();
    void fitColumns();
    void widen(int column, const QString &text);

    std::vector<TableColumn> m_columns;
    std::vector<TableRow> m_rows{};
    int m_namesWidth = 0;   ///< px, the width that the texts of the first column need
    int m_editableRow = -1; ///< -1: none
    int m_firstEditableColumn = 0;
    bool m_isFilling = false; ///< fillCells() is changing cells, which are therefore not typed
    QStandardItemModel *m_model;
};

} // namespace slidercrank
