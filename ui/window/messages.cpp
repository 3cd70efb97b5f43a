// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/messages.h"

#include "ui/document/session.h"
#include "ui/text/remember.h"
#include "ui/text/written_number.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/scene_file.h"

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
    m_greeting = tr("Drag a slider or a link. Press Space to play.");
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

void Messages::followResult()
{
    if (m_bar->text() == m_forNow) {
        m_bar->hide();
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
    case Finding::Remedy::ReadByAngle: m_session->readAbscissaAs(ColumnRole::CrankAngle); break;
    case Finding::Remedy::ReadByTime: m_session->readAbscissaAs(ColumnRole::Time); break;
    case Finding::Remedy::ChooseColumns: emit columnsRequested(m_session->reference()->paths); break;
    }
}

} // namespace slidercrank
