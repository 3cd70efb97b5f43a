// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What was read from the reference file and how: its form, a row a column, the rows left out; beside it whose motion it
// is, and by which other reading it would come nearer.

#include "ui/document/result.h"

#include <QWidget>

#include <memory>

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace slidercrank
{

class NumberTable;

class ReferencePanel : public QWidget
{
    Q_OBJECT

public:
    explicit ReferencePanel(QWidget *parent = nullptr);

    QSize minimumSizeHint() const override;

public slots:
    /// Kept, and filled in when the panel is on show; null: none.
    void setReference(const std::shared_ptr<const slidercrank::Reference> &reference);
    void setDiagnosis(const std::shared_ptr<const slidercrank::ReferenceDiagnosis> &diagnosis);

signals:
    void openReferenceRequested();
    void openSampleRequested();
    void columnsRequested();                              ///< somebody wants to say what the columns are
    void abscissaRequested(slidercrank::ColumnRole role); ///< what the rows are to count by: Time or CrankAngle
    void applyRequested(const slidercrank::Convention &convention);
    void readAsPrintedRequested();
    void takeOverRequested();
    void rowsCopied(int count); ///< of a table, to the clipboard

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *createFilePage();
    QWidget *createTables();
    void arrange();
    void showView(int view);
    void refill();
    void fill();
    void showName();
    void showAbscissa();
    void fillForm();
    void fillColumns();
    void fillSkipped();
    void fillFindings();

    std::shared_ptr<const Reference> m_reference;
    std::shared_ptr<const ReferenceDiagnosis> m_diagnosis;
    bool m_stale = false; ///< what is kept is not on show yet
    QStackedWidget *m_pages = nullptr;
    QLabel *m_name = nullptr;
    QLabel *m_form = nullptr;
    QComboBox *m_abscissa = nullptr;
    QButtonGroup *m_choice = nullptr; ///< of what the left shows
    QStackedWidget *m_tables = nullptr;
    NumberTable *m_columns = nullptr;
    NumberTable *m_skipped = nullptr;
    QHBoxLayout *m_halves = nullptr;
    QScrollArea *m_findingsArea = nullptr;
    QWidget *m_findings = nullptr; ///< made anew with every diagnosis
    QVBoxLayout *m_findingsRoom = nullptr;
};

} // namespace slidercrank
