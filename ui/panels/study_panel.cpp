// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_panel.h"

#include "ui/document/session.h"
#include "ui/panels/study_page.h"
#include "ui/text/parameter_text.h"
#include "ui/text/study_text.h"
#include "ui/text/written_number.h"

namespace slidercrank
{

StudyPanel::StudyPanel(Session *session)
    : TablePanel(session, "studyPanel", tr("Speed and accuracy of the methods"), [this] { return makePage(); })
    , m_session(session)
{
    session->track(&m_study);
    connect(this, &TablePanel::remedyRequested, this, &StudyPanel::run);
    connect(session, &Session::parametersChanged, this, &TablePanel::refresh);
}

/// Starts the study again if it is running.
void StudyPanel::run()
{
    m_study.startPieces(
        std::make_shared<Study>(StudyRequest{.cases = {studyCase(m_session->parameters())}}),
        [this](const Study &study) { setResult(std::make_shared<const StudyResult>(study.result())); },
        [this](const QString &sentence) { m_session->reportFailure(sentence); });
}

void StudyPanel::setResult(const std::shared_ptr<const StudyResult> &result)
{
    m_result = result;
    refresh();
}

Page StudyPanel::makePage() const
{
    Page page{.sentence = tr(
                  "Every method is timed at the same time steps of one revolution, and its error is measured against a "
                  "computation with 115 digits.")};
    if (m_result) {
        constexpr int kDigits = 2;
        const CaseResult &shownCase = m_result->cases.front();
        page = studyPage(shownCase);
        page.note = tr("%1. Measured on %2, in %3 s.")
                        .arg(mechanismText(Mechanism(shownCase.parameters)), machineText(),
                             numberText(m_result->seconds, kDigits));
        if (shownCase.parameters != m_session->parameters()) {
            page.note += u' ' + tr("The mechanism has changed since: run again.");
        }
    }
    page.findings = {{.sentence = tr("How fast and how accurate is each method for this mechanism?"),
                      .remedy = Remedy::RunStudy,
                      .remedyText = tr("Run")}};
    return page;
}

} // namespace slidercrank

#include "moc_study_panel.cpp"
