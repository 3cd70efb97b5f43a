// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank` without a command: opens the window.

#include "app/commands.h"
#include "app/option_reader.h"
#include "app/output.h"
#include "ui/document/scene.h"
#include "ui/document/whole_file.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>

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
    return writeOutput(
        streams, {},
        CommandLine::tr("Removed: layout, recent files, language, theme, meanings of columns.").toUtf8() + '\n');
}

/// Throws unless the file exists. An argument that cannot be the name of a file may be a misspelt command.
void requireFile(const QString &argument)
{
    if (QFileInfo::exists(argument)) {
        return;
    }
    static const QRegularExpression partOfFileName("[./\\\\]");
    if (argument.contains(partOfFileName)) {
        throw UsageError{CommandLine::tr("There is no file %1.").arg(QDir::toNativeSeparators(argument)),
                         ExitStatus::FileError};
    }
    if (findCommand(argument)) {
        throw UsageError{CommandLine::tr("The command must come first: slidercrank %1 …").arg(argument)};
    }
    throwUnknownName(CommandLine::tr("There is no command and no file \"%1\"").arg(argument), argument, commandNames());
}

/// Throws if the scene cannot be read, so that the error is reported before the window opens. Pipes are not read here:
/// the window refuses them.
void checkScene(const QString &file)
{
    if (!isPipeOrDevice(QFileInfo(file))) {
        const std::variant<Scene, QString> scene = readScene(file);
        if (const QString *message = std::get_if<QString>(&scene)) {
            throw UsageError{*message, ExitStatus::FileError};
        }
    }
}

} // namespace

Command prepareWindow(const OptionReader &options)
{
    QStringList files = options.files();
    if (options.has("reset-settings")) {
        if (!files.isEmpty() || options.has("reference")) {
            throw UsageError{CommandLine::tr("--reset-settings opens no window: remove the other arguments.")};
        }
        return {resetSettings};
    }
    Command command{[](const Streams &) { return ExitStatus::Success; }, Platform::Window};
    command.referenceFiles = options.texts("reference");
    if ((command.referenceFiles + files).contains("-")) {
        throw UsageError{CommandLine::tr("The window cannot read standard input: save it as a file first.")};
    }
    if (!files.isEmpty() && isNamedAsScene(files.first())) {
        command.scene = files.takeFirst();
        if (!files.isEmpty()) {
            throw UsageError{CommandLine::tr("The window opens one scene: remove \"%1\".").arg(files.first())};
        }
        checkScene(command.scene);
    }
    for (const QString &file : files) {
        if (isNamedAsScene(file)) {
            throw UsageError{CommandLine::tr("%1 is a scene: open it alone, and the files of one motion together.")
                                 .arg(QDir::toNativeSeparators(file))};
        }
        requireFile(file);
    }
    command.referenceFiles += files;
    return command;
}

} // namespace slidercrank
