// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab for speed and accuracy: runs the study in the background, for the current mechanism or for the named hard
// cases, and shows one case at a time.

#include "core/study/study.h"
#include "ui/document/background_task.h"

#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;

namespace slidercrank
{

class Session;
class TablePanel;

class StudyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPanel(Session *session, QWidget *parent = nullptr);

public slots:
    void setResult(const std::shared_ptr<const slidercrank::StudyResult> &result);

private:
    void run(const std::vector<Case> &cases);
    const CaseResult *shownCase() const;
    void showSummary();

    Session *m_session;
    std::shared_ptr<const StudyResult> m_result;
    BackgroundTask m_study;
    QLabel *m_summary;
    QComboBox *m_cases;
    TablePanel *m_page;
};

} // namespace slidercrank
