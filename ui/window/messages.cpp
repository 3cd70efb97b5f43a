// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/messages.h"

#include "ui/text/written_number.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include <QSettings>

#include <algorithm>

namespace slidercrank
{

namespace
{

// The subjects of messages that disappear when they no longer apply.
const QString kResult = "result";
const QString kReference = "reference";
const QString kColumns = "columns";
const QString kTimeRange = "timeRange";

} // namespace

Messages::Messages(MainWindow *window, MessageBar *bar)
    : QObject(bar)
    , m_window(window)
    , m_bar(bar)
{
    const Session *session = &window->session();
    connect(session, &Session::confirmed, this, [this](const QString &sentence) {
        m_bar->showMessage({"confirmation", Message::Kind::Hint, sentence});
    });
    connect(session, &Session::failed, this, [this](const QString &sentence) {
        m_bar->showMessage({"problem", Message::Kind::Problem, sentence});
    });
    connect(session, &Session::problemFound, this, [this](const QString &sentence) {
        m_bar->showMessage({kResult, Message::Kind::Problem, sentence});
    });
    connect(session, &Session::resultChanged, this, [this] { m_bar->removeMessage(kResult); });
    connect(session, &Session::settingsChanged, this, [this] { m_bar->removeMessage(kTimeRange); });
    connect(session, &Session::timeRangeReplaced, this, &Messages::showTimeRange);
    connect(session, &Session::referenceRefused, this, &Messages::showRefused);
    connect(session, &Session::referenceLoaded, this, &Messages::showReading);
}

void Messages::greetOnce()
{
    const QString key = "greeted";
    QSettings settings;
    if (!settings.value(key).toBool()) {
        settings.setValue(key, true);
        m_bar->showMessage({"greeting", Message::Kind::Hint, tr("Drag a slider or a link. Press Space to play."),
                            tr("Open the sample"), [this] { m_window->openSample(); }});
    }
}

/// Offers to choose the columns if the files have any; otherwise another file.
void Messages::showRefused(const QStringList &paths, const QString &sentence)
{
    const bool isOpen = m_window->scene().lacksReference();
    Message message{kReference, Message::Kind::Problem,
                    isOpen ? tr("The scene is open without its reference. %1").arg(sentence) : sentence};
    if (readLayout(paths).columns.empty()) {
        message.actionText = tr("Open reference…");
        message.action = [this] { m_window->chooseReference(); };
    } else {
        message.actionText = tr("Choose columns…");
        message.action = [this, paths] { m_window->chooseColumns(paths); };
    }
    m_bar->showMessage(message);
}

void Messages::showReading(const std::shared_ptr<const Reference> &reference)
{
    m_bar->removeMessage(kReference);
    m_bar->removeMessage(kColumns);
    if (!reference || reference->asPrinted || !reference->data.layout.isGuessed()) {
        return;
    }
    const bool isAngleOnly = std::ranges::all_of(reference->data.layout.columns, [](const FileColumn &column) {
        return !isGuess(column.reason) || column.reason == ColumnReason::AngleForTime;
    });
    const QString sentence = isAngleOnly
                                 ? tr("%1 is a table by crank angle: ω₂ and θ₂₀ give its time.")
                                 : tr("The headings in %1 do not identify every column: some meanings were guessed.");
    m_bar->showMessage({kColumns, Message::Kind::Question, sentence.arg(reference->name), tr("Choose columns…"),
                        [this, paths = reference->paths] { m_window->chooseColumns(paths); }});
}

void Messages::showTimeRange(const std::shared_ptr<const Reference> &reference, const Sampling &sampling)
{
    m_bar->showMessage(
        {kTimeRange, Message::Kind::Hint,
         tr("The time range is now that of %1: %2 s to %3 s.")
             .arg(reference->name, numberText(sampling.start), numberText(sampling.start + sampling.duration))});
}

} // namespace slidercrank
