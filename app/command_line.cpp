// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "app/commands.h"
#include "app/help.h"
#include "app/option_reader.h"
#include "app/output.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <memory>

namespace slidercrank
{

namespace
{

Command printText(const QString &text)
{
    return {[text](const Streams &streams) { return writeOutput(streams, {}, text.toUtf8()); }};
}

/// `help [COMMAND]` or `help --man-page`.
Command prepareHelp(const QStringList &topics)
{
    if (topics == QStringList("--man-page")) {
        return printText(manualPage());
    }
    const CommandDescription *command = topics.isEmpty() ? &allCommands().front() : findCommand(topics.front());
    if (!command || topics.size() > 1) {
        throw UsageError{CommandLine::tr("There is no help for \"%1\": choose one of %2.")
                             .arg(topics.join(' '), commandNames().join(", "))};
    }
    return printText(helpText(*command));
}

/// Returns the arguments without the options that Qt itself reads, such as "-platform offscreen".
QStringList withoutQtOptions(const QStringList &arguments)
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

Command parse(const QStringList &arguments)
{
    const QString name = arguments.value(1);
    if (name == u"help") {
        return prepareHelp(arguments.mid(2));
    }
    const CommandDescription *named = findCommand(name);
    const CommandDescription &command = named ? *named : allCommands().front();
    const auto options =
        std::make_shared<OptionReader>(command, named ? arguments.mid(2) : withoutQtOptions(arguments.mid(1)));
    if (options->has("help")) {
        return printText(helpText(command));
    }
    if (options->has("version")) {
        return printText("slidercrank " SLIDERCRANK_VERSION "\n" SLIDERCRANK_BUILT_OF "\n");
    }
    options->readScene();
    if (!named) {
        return prepareWindow(*options);
    }
    return {[options, run = command.run](const Streams &streams) { return run(*options, streams); }, command.platform};
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
    Command command;
    try {
        command = parse(arguments);
    } catch (const UsageError &error) {
        command.run = [error](const Streams &) -> ExitStatus { throw error; };
    }
    command.run = [run = command.run](const Streams &streams) {
        try {
            return run(streams);
        } catch (const UsageError &error) {
            streams.report(error.message);
            return error.status;
        }
    };
    return command;
}

} // namespace slidercrank
