// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "app/command_line.h"

#include <QRegularExpression>

namespace slidercrank
{

namespace
{

constexpr qsizetype kLineWidth = 100; // characters
constexpr qsizetype kIndent = 34;     // characters before the description of an option

bool isWindow(const CommandDescription &command)
{
    return &command == &allCommands().front();
}

/// "slidercrank solve [options]"
QString usage(const CommandDescription &command)
{
    return (isWindow(command) ? "slidercrank " : QString("slidercrank %1 ").arg(command.name)) + command.arguments;
}

QString exitStatusText()
{
    return CommandLine::tr("Exit status: 0 success; 1 --fail-on-difference was given and a channel differs; 2 usage "
                           "error; 3 a file cannot be read or written; 4 the mechanism cannot be assembled at some "
                           "time step (the other steps are still written); 5 not converged or singular at some time "
                           "step, or no mechanism identified. If several apply: 3 before 4 before 5 before 1.");
}

QString unitsText()
{
    return CommandLine::tr(
        "Numbers without a unit are in the unit shown; 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms are accepted, too.");
}

/// Breaks the text into lines, all but the first of which are indented.
QString wrapped(QString text, qsizetype indent = 0)
{
    const QRegularExpression line(QString("(.{1,%1})(?: |$)").arg(kLineWidth - indent));
    return text.replace(line, "\\1\n" + QString(indent, ' ')).chopped(indent);
}

/// Returns an entry of a list: a name, and its description beside or below it.
QString entry(const QString &name, const QString &description)
{
    const QString start = "  " + name;
    return (start.size() < kIndent ? start.leftJustified(kIndent) : start + '\n' + QString(kIndent, ' ')) +
           wrapped(description, kIndent);
}

/// "--output, -o FILE"
QString optionSyntax(const OptionDescription &option)
{
    const QString shortName = option.shortName ? QString(", -") + option.shortName : QString();
    return QString("--") + option.name + shortName + (option.value ? QString(" ") + option.value : QString());
}

/// Escapes text for the manual page.
QString roff(QString text)
{
    return text.replace('\\', "\\e").replace('-', "\\-");
}

/// Returns the usage, the description and the options of a command.
QString describe(const CommandDescription &command)
{
    QString text = CommandLine::tr("Usage:") + ' ' + usage(command) + "\n\n" + wrapped(CommandLine::tr(command.text));
    if (isWindow(command)) {
        text += '\n';
        for (const CommandDescription &each : allCommands()) {
            text += entry(usage(each), CommandLine::tr(each.summary));
        }
    }
    const char *group = nullptr;
    for (const OptionDescription &option : optionsOf(command)) {
        if (option.group != group) {
            group = option.group;
            text += '\n' + CommandLine::tr(group) + '\n';
        }
        text += entry(optionSyntax(option), CommandLine::tr(option.text));
    }
    return text + '\n';
}

} // namespace

QString helpText(const CommandDescription &command)
{
    return describe(command) + wrapped(unitsText()) + '\n' + wrapped(exitStatusText());
}

QString manualPage()
{
    QString text =
        ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n.TH SLIDERCRANK 1 \"\" \"slidercrank " SLIDERCRANK_VERSION
        "\" \"User Commands\"\n.SH NAME\nslidercrank \\- motion of an offset slider\\-crank\n";
    for (const CommandDescription &command : allCommands()) {
        text += ".SH " + (isWindow(command) ? "DESCRIPTION" : QString(command.name).toUpper()) + "\n.nf\n" +
                roff(describe(command)) + ".fi\n";
    }
    return text + ".SH UNITS\n" + roff(unitsText()) + "\n.SH EXIT STATUS\n" + roff(exitStatusText()) + '\n';
}

} // namespace slidercrank
