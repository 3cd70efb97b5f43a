// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_panel.h"

#include "ui/document/session.h"
#include "ui/document/whole_file.h"
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
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kProgressSteps = 200;

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
    , m_runThis(named("runThisButton", new QPushButton))
    , m_runHard(named("runHardButton", new QPushButton))
    , m_progress(named("studyProgress", new QProgressBar, tr("Progress of the study")))
    , m_summary(named("studySummary", new QLabel))
    , m_cases(named("caseBox", new QComboBox, tr("Case shown")))
    , m_page(new TablePanel("studyPage", tr("Error and time of the methods"), [this] {
        const CaseResult *shown = shownCase();
        return shown ? studyPage(*shown) : emptyStudyPage();
    }))
{
    named("studyPanel", this, tr("Speed and accuracy of the methods"));
    m_runThis->setToolTip(tr("Times every method on one revolution of this mechanism"));
    m_runHard->setToolTip(
        tr("Mechanisms that only just make full turns or only just oscillate, very long and very short "
           "links, very late times: takes some ten seconds"));
    connect(m_runThis, &QPushButton::clicked, this, &StudyPanel::runThisMechanism);
    connect(m_runHard, &QPushButton::clicked, this, &StudyPanel::runHardCases);
    m_progress->setRange(0, kProgressSteps);
    m_progress->setMaximumWidth(140);
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
    for (QWidget *widget : std::initializer_list<QWidget *>{m_runThis, m_runHard, m_progress}) {
        controls->addWidget(widget);
    }
    controls->addWidget(m_summary, 1);
    controls->addWidget(m_cases);
    m_export = addButton(controls, "exportStudyButton", tr("Export all cases…"),
                         tr("The numbers of every case as CSV or JSON"));
    connect(m_export, &QToolButton::clicked, this, [this] {
        chooseExport(this, {tr("Tables (*.csv)"), "JSON (*.json)"}, tr("speed.csv"), &StudyPanel::exportNumbers);
    });
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addLayout(controls);
    rows->addWidget(m_page, 1);
    connect(&m_study, &BackgroundTask::progressed, this,
            [this](double part) { m_progress->setValue(static_cast<int>(part * kProgressSteps)); });
    connect(&m_study, &BackgroundTask::runningChanged, this, &StudyPanel::updateButtons);
    connect(session, &Session::parametersChanged, this, &StudyPanel::showSummary);
    updateButtons();
}

void StudyPanel::runThisMechanism()
{
    run(m_runThis, {.cases = {studyCase(m_session->parameters())}});
}

void StudyPanel::runHardCases()
{
    run(m_runHard, {.cases = {hardCases().begin(), hardCases().end()}});
}

void StudyPanel::run(QPushButton *button, StudyRequest request)
{
    if (m_study.isRunning()) {
        m_study.cancel();
        return;
    }
    m_pressed = button;
    m_progress->setValue(0);
    m_study.start(
        [request = std::move(request)](const std::stop_token &stop, const BackgroundTask::Progress &progress) {
            return std::make_shared<const StudyResult>(runStudy(request, stop, progress));
        },
        [this](const std::shared_ptr<const StudyResult> &result) {
            if (!result->cases.empty()) {
                setResult(result);
            }
        },
        [this](const QString &sentence) { emit problemFound(sentence); });
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
    updateButtons();
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
    if (!m_result->complete) {
        parts << tr("cancelled");
    }
    const bool isOfThisMechanism = shown->name == studyCase(shown->parameters).name;
    if (isOfThisMechanism && shown->parameters != m_session->parameters()) {
        parts << tr("the mechanism has changed since: run again");
    }
    m_summary->setText(parts.join(", "));
    m_summary->setToolTip(tr("%1\nTimes measured on %2")
                              .arg(mechanismText(Mechanism(shown->parameters)), machineText(m_result->machine)));
}

/// While the study runs, the button that started it cancels it, so that the keyboard focus does not move.
void StudyPanel::updateButtons()
{
    const bool running = m_study.isRunning();
    const auto show = [&](QPushButton *button, const QString &text) {
        button->setText(running && button == m_pressed ? tr("Cancel") : text);
        button->setEnabled(!running || button == m_pressed);
    };
    show(m_runThis, tr("Run (this mechanism)"));
    show(m_runHard, tr("Run hard cases"));
    m_progress->setVisible(running);
    m_cases->setVisible(m_result && m_result->cases.size() > 1);
    m_export->setEnabled(m_result != nullptr);
}

std::optional<QString> StudyPanel::exportNumbers(const QString &path) const
{
    if (!m_result) {
        return tr("There is nothing to export yet: run the study first.");
    }
    const bool json = path.endsWith(".json", Qt::CaseInsensitive);
    return writeWhole(path, json ? jsonDocument(studyJson(*m_result)) : csvText(studyRecords(*m_result)));
}

} // namespace slidercrank
