// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab for speed and accuracy: runs the study in the background, for the current mechanism or for the named hard
// cases, and shows one case at a time.

#include "core/study/study.h"
#include "ui/document/background_task.h"

#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace slidercrank
{

class Session;
class TablePanel;

class StudyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StudyPanel(Session *session, QWidget *parent = nullptr);

    /// Writes the numbers of every case: as JSON if the name ends in .json, otherwise as CSV. Returns an error message
    /// if they cannot be written.
    std::optional<QString> exportNumbers(const QString &path) const;

public slots:
    void setResult(const std::shared_ptr<const slidercrank::StudyResult> &result);
    void runThisMechanism(); ///< or cancels the study that runs
    void runHardCases();     ///< or cancels the study that runs

signals:
    void problemFound(const QString &sentence);

private:
    void run(QPushButton *button, StudyRequest request);
    const CaseResult *shownCase() const;
    void showSummary();
    void updateButtons();

    Session *m_session;
    std::shared_ptr<const StudyResult> m_result;
    BackgroundTask m_study;
    QPushButton *m_runThis;
    QPushButton *m_runHard;
    QPushButton *m_pressed = nullptr; ///< while the study runs: the button that started it and now cancels it
    QProgressBar *m_progress;
    QLabel *m_summary;
    QComboBox *m_cases;
    QToolButton *m_export;
    TablePanel *m_page;
};

} // namespace slidercrank
