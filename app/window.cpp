// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank` without a command: opens the window.

#include "app/commands.h"
#include "app/console.h"
#include "app/option_reader.h"
#include "app/output.h"
#include "app/similar_words.h"
#include "ui/document/scene_link.h"
#include "ui/document/whole_file.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QSettings>

#include <algorithm>
#include <memory>

namespace slidercrank
{

namespace
{

ExitStatus resetSettings(const Streams &streams)
{
    QSettings settings;
    settings.clear();
    settings.sync();
    if (settings.status() != QSettings::NoError) {
        streams.report(CommandLine::tr("Cannot write the settings in %1: remove that file.").arg(settings.fileName()));
        return ExitStatus::FileError;
    }
    return writeOutput(streams, {}, CommandLine::tr("All settings of the window are removed.").toUtf8() + '\n');
}

/// Replaces the window whenever another language is chosen in it.
void followLanguage(std::unique_ptr<MainWindow> &window)
{
    const auto remake = [&window] {
        std::unique_ptr<MainWindow> next = window->makeReplacement();
        next->show();
        window = std::move(next);
        followLanguage(window);
    };
    // Queued, because the menu in which the language was chosen belongs to the window that `remake` deletes.
    QObject::connect(window.get(), &MainWindow::languageChosen, qApp, remake, Qt::QueuedConnection);
}

} // namespace

void requireFile(const QString &argument)
{
    const QString name = QDir::toNativeSeparators(argument);
    if (isStandardInput(argument)) {
        throw UsageError{
            CommandLine::tr("The window does not read standard input: save it in a file, or use a command, "
                            "such as compare, which reads it.")};
    }
    if (QFileInfo::exists(argument) || isSceneLink(argument)) {
        return;
    }
    if (argument.contains('.')) { // otherwise it may be a misspelt command
        throw UsageError{CommandLine::tr("There is no file %1.").arg(name), ExitStatus::FileError};
    }
    if (commandNames().contains(argument)) {
        throw UsageError{CommandLine::tr("The command %1 must come first.").arg(argument)};
    }
    throw UsageError{CommandLine::tr("\"%1\" is neither a command nor a file. The commands are %2.")
                         .arg(name, commandNames().join(", ")) +
                     didYouMean(similarWords(argument, commandNames()))};
}

ExitStatus windowCommand(const OptionReader &options, const Streams &streams)
{
    const QStringList files = options.inputFiles();
    if (options.has("reset-settings")) {
        if (!files.isEmpty()) {
            throw UsageError{CommandLine::tr("--reset-settings opens no window: remove the other arguments.")};
        }
        return resetSettings(streams);
    }
    std::ranges::for_each(files, requireFile);
    if (!qobject_cast<QApplication *>(QCoreApplication::instance())) {
        throw UsageError{CommandLine::tr("There is no display for the window: set DISPLAY, or use a command, such as "
                                         "solve, which needs none.")};
    }
    leaveConsole();
    QApplication::setWindowIcon(QIcon(":/slidercrank.svg"));
    auto window = std::make_unique<MainWindow>();
    followLanguage(window);
    window->showWithinScreen();
    if (!files.isEmpty()) {
        window->openFiles(files);
    }
    return static_cast<ExitStatus>(QApplication::exec());
}

} // namespace slidercrank
