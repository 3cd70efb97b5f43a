// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "app/commands.h"
#include "app/help.h"
#include "app/option_reader.h"
#include "app/output.h"
#include "app/window_system.h"

#include <array>
#include <algorithm>

namespace slidercrank
{

namespace
{

Command commandWriting(const QString &text)
{
    Command command;
    command.run = [text](const Streams &streams) { return writeOutput(streams, {}, text.toUtf8()); };
    return command;
}

Command prepare(Subcommand subcommand, OptionReader &options)
{
    switch (subcommand) {
    case Subcommand::Window: return prepareWindow(options);
    case Subcommand::Solve: return prepareSolve(options);
    case Subcommand::Limits: return prepareLimits(options);
    case Subcommand::Compare: return prepareCompare(options);
    case Subcommand::Identify: return prepareIdentify(options);
    case Subcommand::Study: return prepareStudy(options);
    case Subcommand::Render: return prepareRender(options);
    }
    return {};
}

/// `help [COMMAND]`, and the forms of the help for other programs: the manual page.
Command prepareHelp(const QStringList &topics)
{
    if (topics == QStringList(QStringLiteral("--man-page"))) {
        return commandWriting(manualPage());
    }
    const std::optional<Subcommand> subcommand =
        topics.isEmpty() ? Subcommand::Window : subcommandNamed(topics.front());
    if (!subcommand || topics.size() > 1) {
        throw UsageError{CommandLine::tr("There is no help for \"%1\": choose one of %2.")
                             .arg(topics.join(u' '), subcommandNames().join(QStringLiteral(", ")))};
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
        return commandWriting(QStringLiteral("slidercrank " SLIDERCRANK_VERSION "\n" SLIDERCRANK_BUILT_OF "\n"));
    }
    options.readScene();
    Command command = prepare(subcommand, options);
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
        Command command;
        command.run = [usageError](const Streams &streams) {
            streams.report(usageError.message);
            return usageError.status;
        };
        return command;
    }
}

} // namespace slidercrank
