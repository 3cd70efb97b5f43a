// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A dialog in which a person says what the columns of a file are, with the reader's guess in place and a preview that
// is read from the beginning of the file at every change. The choice is remembered for files with the same headings.

#include "core/import/reference_data.h"

#include <QByteArrayList>
#include <QDialog>
#include <QStringList>

#include <variant>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace slidercrank
{

class Chart;

class ColumnMapping : public QDialog
{
    Q_OBJECT

public:
    /// `beginnings`: the first bytes of the file, or of each of several that are joined.
    ColumnMapping(const QStringList &paths, const QByteArrayList &beginnings, QWidget *parent = nullptr);

    void accept() override;

signals:
    /// The choice is in the settings: the file is to be read again.
    void chosen(const QStringList &paths);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Row {
        QComboBox *meaning = nullptr;
        QComboBox *unit = nullptr;
        QLabel *why = nullptr;
        bool isChosen = false; ///< by the person; else it shows what the reader makes of the column
    };

    QWidget *createRows();
    void addRow(QGridLayout *grid, int line, std::size_t column);
    std::variant<ReferenceData, ReadError> readWith(const std::vector<ColumnChoice> &choices) const;
    std::vector<ColumnChoice> choices() const; ///< of the rows that the person chose
    void showChoice(std::size_t row, const ColumnChoice &choice); ///< in its two lists
    void choose(std::size_t row);
    void detectAgain();
    void readAgain();
    void showRow(std::size_t row);
    void showPreview();

    QStringList m_paths;
    QByteArrayList m_beginnings;
    FileLayout m_layout; ///< with the choices
    std::variant<ReferenceData, ReadError> m_outcome;
    std::vector<Row> m_rows;
    std::size_t m_current = 0; ///< the row in the preview
    Chart *m_preview;
    QLabel *m_caption;
    QLabel *m_problem;
    QPushButton *m_use = nullptr;
};

} // namespace slidercrank
