// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/messages.h"

#include "ui/widgets/message_bar.h"
#include "ui/document/session.h"
#include "ui/window/scene_file.h"
#include "ui/text/remember.h"
#include "ui/text/written_number.h"

#include <QDir>
#include <QSettings>

#include <algorithm>

namespace slidercrank
{

Messages::Messages(Session *session, SceneFile *scene, MessageBar *bar)
    : QObject(bar)
    , m_session(session)
    , m_bar(bar)
{
    connect(session, &Session::problemFound, this, &Messages::tellRefusal);
    connect(session, &Session::runFollows, this,
            [this](const std::shared_ptr<const Reference> &reference, const Sampling &run) {
                m_runOf = reference;
                m_run = run;
            });
    connect(session, &Session::settingsChanged, this, [this](const Sampling &run) {
        if (m_runOf && (run.start != m_run.start || run.duration != m_run.duration)) {
            if (m_bar->text().startsWith(runSentence())) {
                m_bar->hide();
            }
            m_runOf = nullptr;
        }
    });
    connect(session, &Session::referenceRefused, this, &Messages::tellRefused);
    connect(session, &Session::referenceLoaded, this, &Messages::announceReading);
    connect(session, &Session::diagnosisChanged, this, &Messages::announceDiagnosis);
    connect(session, &Session::resultChanged, this, &Messages::followResult);
    connect(scene, &SceneFile::problemFound, this, &Messages::tellProblem);
    connect(scene, &SceneFile::saved, this,
            [this](const QString &path) { tell(tr("Saved: %1").arg(QDir::toNativeSeparators(path))); });
    connect(scene, &SceneFile::referenceMissing, this, [this](const QString &sentence) {
        m_bar->showMessage(MessageBar::Kind::Problem, tr("The scene is open without its reference. %1").arg(sentence),
                           tr("Open reference…"), [this] { emit openReferenceRequested(); });
    });
}

void Messages::greetOnce()
{
    const QString key = QStringLiteral("greeted");
    if (!QSettings().value(key).toBool()) {
        remember({{key, true}});
        greet();
    }
}

void Messages::greet()
{
    m_greeting = tr("Move a slider and everything follows; Space plays. Drop a simulation's CSV here to see "
                    "how far it is from this mechanism, or try it with the sample.");
    m_bar->showMessage(MessageBar::Kind::Hint, m_greeting, tr("Open the sample"),
                       [this] { emit openSampleRequested(); });
}

void Messages::sayAgain()
{
    if (m_bar->isHidden()) {
        return;
    }
    const bool greets = m_bar->text() == m_greeting;
    announceReading();
    announceDiagnosis();
    if (greets) {
        greet();
    }
}

void Messages::tell(const QString &sentence)
{
    m_bar->showMessage(MessageBar::Kind::Hint, sentence);
}

void Messages::tellForNow(const QString &sentence)
{
    m_forNow = sentence;
    tell(sentence);
}

void Messages::tellRowsCopied(int count)
{
    tell(count == 1 ? tr("The row is in the clipboard, as CSV with its headings.")
                    : tr("%1 rows are in the clipboard, as CSV with their headings.").arg(count));
}

void Messages::tellProblem(const QString &sentence)
{
    m_bar->showMessage(MessageBar::Kind::Problem, sentence);
}

/// Of what the mechanism cannot be, until it is something else.
void Messages::tellRefusal(const QString &sentence)
{
    m_forNow = sentence;
    tellProblem(sentence);
}

void Messages::tellRefused(const QStringList &paths, const QString &sentence)
{
    if (layoutOf(paths).columns.empty()) {
        tellProblem(sentence);
    } else { // which of them is what may help
        m_bar->showMessage(MessageBar::Kind::Problem, sentence, tr("Choose columns…"),
                           [this, paths] { emit columnsRequested(paths); });
    }
}

/// Empty where the run is not the file's.
QString Messages::runSentence() const
{
    return m_runOf ? tr("The run is now that of %1: %2 s to %3 s.")
                         .arg(m_runOf->name, numberText(m_run.start), numberText(m_run.start + m_run.duration))
                   : QString();
}

/// Of a file, another reading of it, or none.
void Messages::announceReading()
{
    const std::shared_ptr<const Reference> &reference = m_session->reference();
    const bool guessed = reference && !reference->asPrinted && reference->data.layout.isGuessed();
    m_announcesDiagnosis = reference && !guessed; // with wrong columns it would be another mechanism's
    m_bar->hide();
    if (m_runOf != reference) {
        m_runOf = nullptr;
    }
    if (m_runOf) {
        tell(runSentence());
    }
    if (guessed) {
        const bool isAngleOnly = std::ranges::all_of(reference->data.layout.columns, [](const FileColumn &column) {
            return !isGuess(column.reason) || column.reason == ColumnReason::AngleForTime;
        });
        const QString sentence =
            (isAngleOnly ? tr("%1 is a table by crank angle: ω₂ and θ₂₀ give its time.")
                         : tr("The names in %1 do not tell what all of its columns are: some are guessed."))
                .arg(reference->name);
        m_bar->showMessage(MessageBar::Kind::Hint, (runSentence() + u' ' + sentence).trimmed(), tr("Choose columns…"),
                           [this] { emit columnsRequested(m_session->reference()->paths); });
    }
}

/// Said when a file is opened or read otherwise.
void Messages::announceDiagnosis()
{
    const std::shared_ptr<const ReferenceDiagnosis> &diagnosis = m_session->diagnosis();
    if (!m_announcesDiagnosis || !diagnosis || diagnosis->reference != m_session->result()->chosenReference()) {
        tellDifferenceAnew();
        return;
    }
    m_announcesDiagnosis = false;
    if (m_bar->isHidden() || m_bar->text() == runSentence()) { // else what it says is newer than the file
        tellDifference();
    }
}

void Messages::followResult()
{
    if (m_bar->text() == m_forNow) {
        m_bar->hide();
    }
    tellDifferenceAnew();
}

/// What was said of a file is said of the mechanism now on show, until somebody puts it away.
void Messages::tellDifferenceAnew()
{
    if (!m_bar->isHidden() && !m_difference.isEmpty() && m_bar->text() == m_difference) {
        tellDifference();
    }
}

/// How the file on show is from the mechanism on show, and why as soon as that is known; nothing where it agrees.
void Messages::tellDifference()
{
    const Result &result = *m_session->result();
    const std::shared_ptr<const ReferenceDiagnosis> &diagnosis = m_session->diagnosis();
    const bool isKnown = diagnosis && diagnosis->reference == result.chosenReference() &&
                         diagnosis->parameters == result.mechanism.parameters();
    const auto is = [&](Verdict verdict) {
        return std::ranges::count(result.comparison, verdict, &ChannelComparison::verdict) > 0;
    };
    std::vector<Finding> findings;
    if (result.reference && isKnown) {
        findings = findingsOf(result, diagnosis.get());
        std::erase_if(findings,
                      [](const Finding &finding) { return finding.remedy == Finding::Remedy::ReadAsPrinted; });
    }
    m_difference.clear();
    if (!is(Verdict::Differs) && findings.empty()) {
        if (m_bar->text() != runSentence()) {
            m_bar->hide();
        }
        return;
    }
    const QString difference =
        (is(Verdict::Differs) ? tr("%1 differs from this mechanism.") : tr("%1 comes close to this mechanism."))
            .arg(result.reference->name);
    m_difference = (runSentence() + u' ' + difference).trimmed();
    if (findings.empty()) {
        if (m_bar->isHidden() || m_bar->text() != m_difference) { // else it is said while a slider is dragged
            m_bar->showMessage(MessageBar::Kind::Problem, m_difference);
        }
        return;
    }
    const Finding &first = findings.front();
    m_difference += u' ' + first.sentence;
    if (findings.size() == 1 && first.remedy != Finding::Remedy::None) {
        m_bar->showMessage(MessageBar::Kind::Problem, m_difference, first.remedyText, [this, first] { remedy(first); });
    } else {
        m_bar->showMessage(MessageBar::Kind::Problem, m_difference, tr("Show the errors"),
                           [this] { emit errorsRequested(); });
    }
}

void Messages::remedy(const Finding &finding)
{
    m_bar->hide();
    switch (finding.remedy) {
    case Finding::Remedy::None: break;
    case Finding::Remedy::TakeOver: m_session->takeOver(); break;
    case Finding::Remedy::Apply: m_session->apply(finding.convention); break;
    case Finding::Remedy::ReadAsPrinted: m_session->readAsPrinted(); break;
    }
}

} // namespace slidercrank
