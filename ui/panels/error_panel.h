// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the reference data are from the model: a sentence that says whether they belong together, what explains the
// difference and how to remedy it, and a row a channel. Where there is no file, the same of a motion that was kept, in
// numbers alone.

#include "ui/document/result.h"
#include "ui/panels/findings.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QStackedWidget;

namespace slidercrank
{

class NumberTable;

class ErrorPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ErrorPanel(QWidget *parent = nullptr);

public slots:
    /// Kept, and filled in when the panel is on show.
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);

    /// Null: not known yet.
    void setDiagnosis(const std::shared_ptr<const slidercrank::ReferenceDiagnosis> &diagnosis);

signals:
    void timeRequested(double seconds); ///< somebody wants to see where an error is largest
    void rowsCopied(int count);
    void remedyRequested(const slidercrank::Finding &finding);
    void openReferenceRequested();
    void openSampleRequested();

protected:
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QWidget *createTablePage();
    QWidget *createKeptPage();
    void refresh(); ///< fills in, now or when the panel comes on show
    void fill();
    bool isOnTheMove() const; ///< the parameters are, and nothing was found out for these yet
    void fillFindings();
    void fillTable();
    void fillKept();

    std::shared_ptr<const Result> m_result;
    std::shared_ptr<const ReferenceDiagnosis> m_diagnosis;
    bool m_stale = false; ///< these are not on show yet
    QTimer m_pause{this}; ///< runs for a while after each filling
    QStackedWidget *m_pages = nullptr;
    QLabel *m_verdict = nullptr;
    FindingList *m_findings = nullptr;
    QLabel *m_leftOut = nullptr;
    NumberTable *m_table = nullptr;
    QLabel *m_kept = nullptr;
    NumberTable *m_keptTable = nullptr;
};

} // namespace slidercrank
