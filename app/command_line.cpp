// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "app/commands.h"
#include "app/help.h"
#include "app/option_reader.h"
#include "app/output.h"
#include "app/similar_words.h"
#include "ui/text/printable_text.h"

#include <array>

namespace slidercrank
{

namespace
{

/// Returns the text of `help [COMMAND]` or `help --man-page`.
QString findHelp(const QStringList &topics)
{
    if (topics == QStringList("--man-page")) {
        return manualPage();
    }
    const QString topic = topics.join(' ');
    const bool isAboutAll = QStringList{"", "-h", "--help"}.contains(topic);
    const CommandDescription *command = isAboutAll ? &windowDescription() : findCommand(topic);
    if (!command) {
        throw UsageError{
            CommandLine::tr("There is no help for \"%1\": choose one of %2.").arg(topic, commandNames().join(", ")) +
            didYouMean(similarWords(topic, commandNames()))};
    }
    return helpText(*command);
}

ExitStatus runCommand(const QStringList &arguments, const Streams &streams)
{
    const QString name = arguments.value(1);
    if (name == u"help") {
        return writeOutput(streams, {}, findHelp(arguments.mid(2)).toUtf8());
    }
    const CommandDescription *named = findCommand(name);
    if (!named && !name.isEmpty() && !name.startsWith('-')) {
        requireFile(name); // reports a misspelt command as such, before its options are refused as those of the window
    }
    const CommandDescription &command = named ? *named : windowDescription();
    OptionReader options(command, arguments.mid(named ? 2 : 1));
    if (options.has("help")) {
        return writeOutput(streams, {}, helpText(command).toUtf8());
    }
    if (options.has("version")) {
        return writeOutput(streams, {}, "slidercrank " SLIDERCRANK_VERSION "\n" SLIDERCRANK_BUILT_OF "\n");
    }
    options.readScene();
    return command.run(options, streams);
}

} // namespace

ExitStatus moreSevere(ExitStatus x, ExitStatus y)
{
    constexpr std::array kMostSevereFirst{ExitStatus::UsageError, ExitStatus::FileError, ExitStatus::NotAssemblable,
                                          ExitStatus::NotSolved, ExitStatus::Differs};
    for (const ExitStatus status : kMostSevereFirst) {
        if (status == x || status == y) {
            return status;
        }
    }
    return ExitStatus::Success;
}

void Streams::report(const QString &message) const
{
    const QByteArray text = printableText(message).toUtf8();
    error.write(QByteArray(text).replace('\n', ' ') + '\n'); // the message may quote an argument with line breaks
}

Platform platformFor(const QString &firstArgument)
{
    const CommandDescription *command = findCommand(firstArgument);
    if (command) {
        return command->platform;
    }
    const bool isHelp = QStringList{"help", "--help", "-h", "--version"}.contains(firstArgument);
    return isHelp ? Platform::Console : Platform::Window;
}

ExitStatus runCommandLine(const QStringList &arguments, const Streams &streams)
{
    try {
        return runCommand(arguments, streams);
    } catch (const UsageError &error) {
        streams.report(error.message);
        return error.status;
    }
}

} // namespace slidercrank
