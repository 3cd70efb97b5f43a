// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank` without a command: the window.

#include "app/commands.h"
#include "app/option_reader.h"
#include "app/output.h"
#include "ui/document/whole_file.h"
#include "ui/document/scene.h"

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

[[noreturn]] void throwMissingFile(const QString &file)
{
    throw UsageError{CommandLine::tr("There is no file %1.").arg(QDir::toNativeSeparators(file)),
                     ExitStatus::FileError};
}

/// An argument that is neither a scene nor a file.
void requireFile(const QString &argument)
{
    if (subcommandNames().contains(argument)) {
        throw UsageError{CommandLine::tr("The command must come first: slidercrank %1 …").arg(argument)};
    }
    static const QRegularExpression partOfFileName("[./\\\\]");
    if (argument.contains(partOfFileName)) {
        throwMissingFile(argument);
    }
    throwUnknownName(CommandLine::tr("There is no command and no file \"%1\"").arg(argument), argument,
                     subcommandNames());
}

/// The files of one motion, as if they were dropped on the window.
QStringList referenceFiles(const QStringList &files)
{
    for (const QString &file : files) {
        if (isNamedAsScene(file)) {
            throw UsageError{CommandLine::tr("%1 is a scene: open it alone, and the files of one motion together.")
                                 .arg(QDir::toNativeSeparators(file))};
        }
        if (!QFileInfo::exists(file)) {
            throwMissingFile(file);
        }
    }
    return files;
}

} // namespace

QStringList withoutWindowSystemOptions(const QStringList &arguments)
{
    static const QRegularExpression option(
        "^--?(display|geometry|platform|platformtheme|qwindowgeometry|qwindowtitle|session|style|stylesheet|title)$");
    QStringList rest;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (option.match(arguments[i]).hasMatch()) {
            ++i; // its value
        } else {
            rest += arguments[i];
        }
    }
    return rest;
}

bool choosesPlatform(const QStringList &arguments)
{
    return !arguments.filter(QRegularExpression("-(platform|display)")).isEmpty();
}

Command prepareWindow(OptionReader &options)
{
    Command command;
    const QStringList files = options.files();
    if (options.has("reset-settings")) {
        if (!files.isEmpty() || options.has("reference")) {
            throw UsageError{CommandLine::tr("--reset-settings opens no window: remove the other arguments.")};
        }
        command.run = resetSettings;
        return command;
    }
    command.platform = Command::Platform::Window;
    command.run = [](const Streams &) { return ExitStatus::Success; };
    command.referenceFiles = options.texts("reference");
    if ((command.referenceFiles + files).contains("-")) {
        throw UsageError{CommandLine::tr("The window cannot read standard input: save it as a file first.")};
    }
    if (files.isEmpty()) {
        return command;
    }
    const QString &first = files.first();
    if (!isNamedAsScene(first) && !QFileInfo::exists(first)) {
        requireFile(first);
    }
    if (!isNamedAsScene(first) && command.referenceFiles.isEmpty()) {
        command.referenceFiles = referenceFiles(files);
    } else if (files.size() > 1) {
        throw UsageError{CommandLine::tr("The window opens one scene: remove \"%1\".").arg(files[1])};
    } else {
        command.scene = first;
        if (!isPipeOrDevice(QFileInfo(first))) { // which the window refuses
            const std::variant<Scene, QString> scene =
                readScene(first); // an error is reported before there is a window
            if (const QString *message = std::get_if<QString>(&scene)) {
                throw UsageError{*message, ExitStatus::FileError};
            }
        }
    }
    return command;
}

} // namespace slidercrank
