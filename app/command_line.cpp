// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "app/commands.h"
#include "app/help.h"
#include "app/option_reader.h"
#include "app/output.h"

#include <algorithm>
#include <array>

namespace slidercrank
{

namespace
{

Command commandWriting(const QString &text)
{
    return {[text](const Streams &streams) { return writeOutput(streams, {}, text.toUtf8()); }};
}

/// `help [COMMAND]`, and the forms of the help for other programs: the manual page.
Command prepareHelp(const QStringList &topics)
{
    if (topics == QStringList("--man-page")) {
        return commandWriting(manualPage());
    }
    const std::optional<Subcommand> subcommand =
        topics.isEmpty() ? Subcommand::Window : subcommandNamed(topics.front());
    if (!subcommand || topics.size() > 1) {
        throw UsageError{CommandLine::tr("There is no help for \"%1\": choose one of %2.")
                             .arg(topics.join(' '), subcommandNames().join(", "))};
    }
    return commandWriting(helpText(*subcommand));
}

Command parse(const QStringList &arguments)
{
    const QString word = arguments.value(1);
    if (word == u"help") {
        return prepareHelp(arguments.mid(2));
    }
    const std::optional<Subcommand> named = subcommandNamed(word);
    const Subcommand subcommand = named.value_or(Subcommand::Window);
    OptionReader options(subcommand, named ? arguments.mid(2) : withoutWindowSystemOptions(arguments.mid(1)));
    if (options.has("help")) {
        return commandWriting(helpText(subcommand));
    }
    if (options.has("version")) {
        return commandWriting("slidercrank " SLIDERCRANK_VERSION "\n" SLIDERCRANK_BUILT_OF "\n");
    }
    options.readScene();
    constexpr std::array kPrepare{prepareWindow,   prepareSolve, prepareLimits, prepareCompare,
                                  prepareIdentify, prepareStudy, prepareRender}; // by Subcommand
    Command command = kPrepare[static_cast<std::size_t>(subcommand)](options);
    command.choosesPlatform = !named && choosesPlatform(arguments);
    return command;
}

} // namespace

ExitStatus moreSevere(ExitStatus x, ExitStatus y)
{
    constexpr std::array kMostSevereFirst{ExitStatus::UsageError, ExitStatus::FileError, ExitStatus::NotAssemblable,
                                          ExitStatus::NotSolved,  ExitStatus::Differs,   ExitStatus::Success};
    return *std::ranges::find_if(kMostSevereFirst, [x, y](ExitStatus status) { return status == x || status == y; });
}

void Streams::report(const QString &message) const
{
    error.write(message.toUtf8() + '\n');
}

Command parseCommandLine(const QStringList &arguments)
{
    try {
        return parse(arguments);
    } catch (const UsageError &usageError) {
        return {[usageError](const Streams &streams) {
            streams.report(usageError.message);
            return usageError.status;
        }};
    }
}

} // namespace slidercrank
