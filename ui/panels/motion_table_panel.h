// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab with the table of the motion. The first row is the current position and stays; below it are rows at equal
// steps of the crank angle, or for time steps. A person can type values of a calculation by hand below the current
// position, which are checked at once, and shown again when the crank returns to that position. The tab also finds the
// positions in which a quantity has a value.

#include "ui/export/motion_table.h"
#include "ui/panels/my_values.h"
#include "ui/text/notation.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;
class QVBoxLayout;

namespace slidercrank
{

class FindLine;
class NumberBox;
class Session;

class MotionTablePanel : public QWidget
{
    Q_OBJECT

public:
    explicit MotionTablePanel(Session *session, QWidget *parent = nullptr);

    const MotionTableSettings &settings() const { return m_settings; }
    void setSettings(const MotionTableSettings &settings); ///< shows the columns in the order of tableChannels()

    const CsvStyle &csvStyle() const { return m_style; }
    void setCsvStyle(const CsvStyle &style);

    /// Asks in one line whether the notation of textbooks is wanted.
    void offerTextbookNotation();

    /// Makes the columns again after a change of the notation.
    void refreshNotation();

    /// Writes the rows to a CSV file. Returns an error message if it cannot be written.
    std::optional<QString> exportTo(const QString &path) const;

    /// Returns the height at which no part is cut off. The layout's heightForWidth() omits the minimum height of
    /// m_table, whose size policy is Ignored.
    int heightForWidth(int width) const override;

signals:
    void timeRequested(double seconds);
    void symbolsChosen(slidercrank::Symbols symbols);   ///< the answer to the offer
    void positionHovered(std::optional<double> theta2); ///< rad, of the row under the pointer

protected:
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QLayout *makeControls();
    QLayout *makeFindAndExportLine();
    void fillColumnsMenu();
    void fillExportMenu(QToolButton *button);

    void makeTables();
    void arrangeTable();
    void arrangeCurrentRow();
    void connectTables();
    void refresh();
    void showRows();
    void showCurrentPosition();
    void showAlpha2();
    void alignColumns();
    void deselectOtherPosition();
    TablePosition currentPosition() const;

    QByteArray csv() const; ///< the rows as a file
    void copy();

    Session *m_session;
    MotionTableSettings m_settings;
    CsvStyle m_style;
    std::vector<TablePosition> m_positions;
    std::vector<TableRow> m_rows;
    bool m_isStale = true;
    QTimer m_pause{this}; ///< runs for a short time after each update

    NumberBox *m_step;
    QComboBox *m_stepKind;
    QToolButton *m_columnsButton;
    NumberBox *m_alpha2;
    QLabel *m_constantSpeedNote;
    FindLine *m_findLine;
    QLabel *m_answer; ///< of m_findLine
    MyValues m_myValues;
    QLabel *m_conclusion; ///< of m_myValues
    QVBoxLayout *m_layout;
    QHBoxLayout *m_currentRowLayout; ///< of m_currentRowTable, with a margin as wide as the scroll bar of m_table
    NumberTable *m_currentRowTable = nullptr;
    NumberTable *m_table = nullptr;
};

} // namespace slidercrank
