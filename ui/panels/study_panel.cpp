// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_panel.h"

#include "ui/document/session.h"
#include "ui/panels/study_page.h"
#include "ui/panels/table_panel.h"
#include "ui/text/finding_text.h"
#include "ui/text/study_text.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include <utility>

namespace slidercrank
{

namespace
{

std::size_t silentFailures(const StudyResult &result)
{
    std::size_t sum = 0;
    for (const CaseResult &shown : result.cases) {
        for (const MethodResult &row : shown.methods) {
            sum += row.silentFailures.value_or(0);
        }
    }
    return sum;
}

} // namespace

StudyPanel::StudyPanel(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_summary(named("studySummary", new QLabel))
    , m_cases(named("caseBox", new QComboBox, tr("Case shown")))
    , m_page(new TablePanel(session, "studyPage", tr("Error and time of the methods"), [this] {
        const CaseResult *shown = shownCase();
        return shown ? studyPage(*shown) : emptyStudyPage();
    }))
{
    named("studyPanel", this, tr("Speed and accuracy of the methods"));
    auto *runThis = named("runThisButton", new QPushButton(tr("Run (this mechanism)")));
    runThis->setToolTip(tr("Times every method on one revolution of this mechanism"));
    connect(runThis, &QPushButton::clicked, this, [this] { run({studyCase(m_session->parameters())}); });
    auto *runHard = named("runHardButton", new QPushButton(tr("Run hard cases")));
    runHard->setToolTip(tr("Mechanisms that only just make full turns or only just oscillate, very long and very short "
                           "links, very late times: takes some ten seconds"));
    connect(runHard, &QPushButton::clicked, this, [this] { run(hardCases()); });
    session->track(&m_study);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_cases->setToolTip(tr("Case shown"));
    m_cases->setMinimumContentsLength(12);
    m_cases->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(m_cases, &QComboBox::currentIndexChanged, this, [this] {
        m_page->refreshNow();
        showSummary();
    });

    auto *controls = new QHBoxLayout;
    controls->setContentsMargins(6, 4, 6, 0);
    controls->addWidget(runThis);
    controls->addWidget(runHard);
    controls->addWidget(m_summary, 1);
    controls->addWidget(m_cases);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addLayout(controls);
    rows->addWidget(m_page, 1);
    connect(session, &Session::parametersChanged, this, &StudyPanel::showSummary);
    setResult(nullptr);
}

/// Starts the study; it replaces one that runs.
void StudyPanel::run(const std::vector<Case> &cases)
{
    m_study.start(
        [cases](const std::stop_token &stop, const BackgroundTask::Progress &progress) {
            return std::make_shared<const StudyResult>(runStudy({.cases = cases}, stop, progress));
        },
        [this](const std::shared_ptr<const StudyResult> &result) { setResult(result); },
        [this](const QString &sentence) { emit m_session->failed(sentence); });
}

void StudyPanel::setResult(const std::shared_ptr<const StudyResult> &result)
{
    m_result = result;
    {
        const QSignalBlocker quiet(m_cases);
        m_cases->clear();
        for (const CaseResult &shown : m_result ? m_result->cases : std::vector<CaseResult>()) {
            m_cases->addItem(caseText(shown.name));
        }
    }
    m_cases->setVisible(m_cases->count() > 1);
    m_page->refreshNow();
    showSummary();
}

const CaseResult *StudyPanel::shownCase() const
{
    const int index = m_cases->currentIndex();
    return m_result && index >= 0 ? &m_result->cases[static_cast<std::size_t>(index)] : nullptr;
}

void StudyPanel::showSummary()
{
    const CaseResult *shown = shownCase();
    if (!shown) {
        return;
    }
    QStringList parts;
    const std::size_t silent = silentFailures(*m_result);
    parts << (silent == 0 ? tr("No undetected failures") : tr("⚠ %1 undetected failures").arg(QString::number(silent)))
          << tr("done in %1 s").arg(QLocale().toString(m_result->seconds, 'f', 1));
    const bool isOfThisMechanism = shown->name == studyCase(shown->parameters).name;
    if (isOfThisMechanism && shown->parameters != m_session->parameters()) {
        parts << tr("the mechanism has changed since: run again");
    }
    m_summary->setText(parts.join(", "));
    m_summary->setToolTip(tr("%1\nTimes measured on %2")
                              .arg(mechanismText(Mechanism(shown->parameters)), machineText(m_result->machine)));
}

} // namespace slidercrank
