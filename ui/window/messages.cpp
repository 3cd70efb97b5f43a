// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/messages.h"

#include "ui/widgets/message_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct Messages {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::Messages)
};

// The ids (Message::id) of messages that disappear when they no longer apply.
const QString kResult = "result";
const QString kReference = "reference";
const QString kColumns = "columns";
const QString kConfirmation = "confirmation";
const QString kProblem = "problem";

/// Returns the message about reference files that cannot be read. It offers to choose their columns, or a different
/// file if they have no columns.
Message refusedReferenceMessage(MainWindow *window, const QStringList &paths, const QString &sentence)
{
    Message message{.id = kReference, .kind = Message::Kind::Problem, .text = sentence};
    if (window->scene().lacksReference()) {
        message.text = Messages::tr("The scene is open without its reference. %1").arg(sentence);
    }
    if (readLayout(paths).columns.empty()) {
        message.actionText = Messages::tr("Open reference…");
        message.action = [window] { window->chooseFiles(); };
    } else {
        message.actionText = Messages::tr("Choose columns…");
        message.action = [window, paths] { window->chooseColumns(paths); };
    }
    return message;
}

/// Returns the message that meanings of columns were guessed; the reference page says which.
Message guessedColumnsMessage(MainWindow *window, const Reference &reference)
{
    return {kColumns, Message::Kind::Question,
            Messages::tr("The headings in %1 do not identify every column: some meanings were guessed.")
                .arg(reference.name),
            Messages::tr("Choose columns…"),
            [window, paths = reference.source.paths] { window->chooseColumns(paths); }};
}

} // namespace

void showMessages(MainWindow *window, MessageBar *bar)
{
    const Session *session = &window->session();
    QObject::connect(session, &Session::confirmed, bar, [bar](const QString &sentence) {
        bar->showMessage({kConfirmation, Message::Kind::Hint, sentence});
    });
    // "Saved" and "cannot be written" are never shown together.
    QObject::connect(session, &Session::fileWritten, bar, [bar] { bar->removeMessage(kProblem); });
    QObject::connect(session, &Session::failed, bar, [bar](const QString &sentence) {
        bar->removeMessage(kConfirmation);
        bar->showMessage({kProblem, Message::Kind::Problem, sentence});
    });
    QObject::connect(session, &Session::problemFound, bar, [bar](const QString &sentence) {
        bar->showMessage({kResult, Message::Kind::Problem, sentence});
    });
    QObject::connect(session, &Session::resultChanged, bar, [bar] { bar->removeMessage(kResult); });
    QObject::connect(session, &Session::referenceRefused, bar,
                     [window, bar](const QStringList &paths, const QString &sentence) {
                         bar->showMessage(refusedReferenceMessage(window, paths, sentence));
                     });
    QObject::connect(session, &Session::referenceLoaded, bar, [window, bar](const auto &reference) {
        bar->removeMessage(kReference);
        bar->removeMessage(kColumns);
        if (reference && !reference->asPrinted && reference->data.layout.isGuessed()) {
            bar->showMessage(guessedColumnsMessage(window, *reference));
        }
    });
}

} // namespace slidercrank
