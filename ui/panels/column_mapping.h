// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A dialog for choosing the meaning of the columns of a file. It starts with the stored choice or else with the
// meaning that was detected. Every change reads the beginning of the file again. The choice is stored for files with
// the same headings.

#include "core/import/reference_data.h"

#include <QByteArrayList>
#include <QDialog>
#include <QStringList>

#include <vector>

class QBoxLayout;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace slidercrank
{

class ColumnMapping : public QDialog
{
    Q_OBJECT

public:
    /// `beginnings`: the first bytes of each file.
    ColumnMapping(const QStringList &paths, const QByteArrayList &beginnings, QWidget *parent = nullptr);

    void accept() override;

signals:
    /// Emitted when the choice is stored: the files must be read again.
    void chosen(const QStringList &paths);

private:
    struct Row {
        QComboBox *meaning = nullptr;
        QComboBox *unit = nullptr;
        QLabel *why = nullptr;
        bool isChosen = false; ///< by the user; otherwise the row shows the meaning that was detected
    };

    QWidget *createRows();
    void addRow(QGridLayout *grid, int line, std::size_t column);
    void addButtons(QBoxLayout *rows);
    ColumnChoice choiceIn(std::size_t row) const;
    std::vector<ColumnChoice> choices() const;                    ///< of the rows that the user chose
    void showChoice(std::size_t row, const ColumnChoice &choice); ///< in the two lists of the row
    void acceptChoice(std::size_t row); ///< after the meaning or the unit of a column was chosen
    void detectAgain();
    void readAgain();
    void showRow(std::size_t row);

    QStringList m_paths;
    QByteArrayList m_beginnings;
    FileLayout m_layout; ///< as read with the choices
    std::vector<Row> m_rows;
    QLabel *m_problem;
    QPushButton *m_useButton = nullptr;
};

} // namespace slidercrank
