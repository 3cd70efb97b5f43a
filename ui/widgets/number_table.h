// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A read-only table of names and numbers that change while one looks: four significant digits on the screen, every
// digit in the clipboard (CSV with a decimal point). It reports which part of the mechanism the row under the mouse, or
// the current row, is about, and the time that a row leads to.

#include "core/mechanism/mechanism_part.h"

#include <QTableView>

#include <optional>
#include <vector>

class QStandardItemModel;

namespace slidercrank
{

inline constexpr int kReadoutDigits = 4; ///< significant digits of a readout

/// What a text means, by its colour.
enum class Tone { Normal, Muted, Link, Model, Good, Fair, Bad };
QColor toneColour(Tone tone, const QPalette &palette);

/// The background of a cell with that tint.
QColor tintColour(double tint, const QPalette &palette);

struct TableColumn {
    QString title;
    QString explanation = {}; ///< tool tip of the title
    QString csvName = {};
    bool isNumber = true; ///< aligned to the right
};

struct TableCell {
    QString text;
    std::optional<double> number = {}; ///< exact; the CSV holds it instead of the text
    QString explanation = {};          ///< tool tip
    QString csv = {};                  ///< in the CSV instead of the text
    Tone tone = Tone::Normal;
    double tint = 0.0; ///< -1 … 1: the background, the sign giving its colour
};

struct TableRow {
    std::vector<TableCell> cells;             ///< one for each column
    std::optional<double> time = {};          ///< s, where a click or Enter leads
    MechanismPart part = MechanismPart::None; ///< that the row is about
};

/// A line of headings and a line for each row; numbers with every digit and a decimal point.
QString csvText(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows);

class NumberTable : public QTableView
{
    Q_OBJECT

public:
    /// `name`: the object name; `title`: what a screen reader announces.
    NumberTable(const QString &name, const QString &title, std::vector<TableColumn> columns);

    /// Only the cells that change are painted again.
    void setRows(std::vector<TableRow> rows);

    QSize contentSize() const; ///< px, without scroll bars

public slots:
    void copy(); ///< as CSV: the selected rows, or every row where none is selected

signals:
    void copied(int rows);
    void partHovered(slidercrank::MechanismPart part); ///< None: no row is pointed at
    void timeRequested(double seconds);

protected:
    bool event(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    void goToRow(int row);
    void fillCells();
    void fitColumns();
    void setPointedRow(int row);
    void reportPart();

    std::vector<TableColumn> m_columns;
    std::vector<TableRow> m_rows{};
    QStandardItemModel *m_model;
    std::vector<int> m_widths; ///< px, the widest that each column has needed: columns do not shrink while numbers move
    int m_pointedRow = -1;
    MechanismPart m_reported = MechanismPart::None;
};

} // namespace slidercrank
