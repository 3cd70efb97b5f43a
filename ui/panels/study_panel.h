// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The tab for speed and accuracy: runs the study of the current mechanism in the background.

#include "core/study/study.h"
#include "ui/document/background_task.h"
#include "ui/panels/table_panel.h"

#include <memory>

namespace slidercrank
{

class StudyPanel : public TablePanel
{
    Q_OBJECT

public:
    explicit StudyPanel(Session *session);

    void setResult(const std::shared_ptr<const StudyResult> &result);

private:
    void run();
    Page makePage() const;

    Session *m_session;
    std::shared_ptr<const StudyResult> m_result; ///< null until the study was run
    BackgroundTask m_study;
};

} // namespace slidercrank
