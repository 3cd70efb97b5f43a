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
    return &command == &windowDescription();
}

/// Returns the line "slidercrank solve [options]".
QString usageLine(const CommandDescription &command)
{
    return (isWindow(command) ? "slidercrank " : QString("slidercrank %1 ").arg(command.name)) + command.arguments;
}

QString exitStatusText()
{
    return CommandLine::tr(
        "Exit status: 0 success; 1 --fail-on-difference was given and a channel differs, or a value to be checked is "
        "wrong; 2 usage error; 3 a file cannot be read or written; 4 the mechanism cannot be assembled at some "
        "time step (the other steps are still written), or a request of --design, --when or --omega2-for is "
        "impossible; 5 not converged or singular at some time step, or no mechanism identified. If several apply, the "
        "first of 3, 4, 5, 1 is returned.");
}

QString unitsText()
{
    return CommandLine::tr(
        "Numbers without a unit are in the unit shown; 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms and expressions such as "
        "2*pi are accepted, too.");
}

/// Breaks the text into lines. All lines except the first begin with `indent` spaces.
QString wrapped(QString text, qsizetype indent = 0)
{
    const QRegularExpression line(QString("(.{1,%1})(?: |$)").arg(kLineWidth - indent));
    return text.replace(line, "\\1\n" + QString(indent, ' ')).chopped(indent);
}

/// Returns an entry of a list: a name, and its description beside or below it.
QString helpEntry(const QString &name, const QString &description)
{
    const QString start = "  " + name;
    return (start.size() < kIndent ? start.leftJustified(kIndent) : start + '\n' + QString(kIndent, ' ')) +
           wrapped(description, kIndent);
}

/// Returns the line "--output, -o FILE".
QString optionSyntax(const OptionDescription &option)
{
    const QString shortName = option.shortName ? QString(", -") + option.shortName : QString();
    return QString("--") + option.name + shortName + (option.value ? QString(" ") + option.value : QString());
}

using WriteEntry = QString (*)(const QString &name, const QString &description);

/// Returns the options of a command below their headings; for the window, the commands come first.
QString listOptions(const CommandDescription &command, const QString &headingMark, WriteEntry writeEntry)
{
    QString text;
    if (isWindow(command)) {
        text += headingMark + CommandLine::tr("Commands") + '\n';
        for (const CommandDescription &each : allCommands()) {
            text += writeEntry(usageLine(each), CommandLine::tr(each.summary));
        }
    }
    const char *group = nullptr;
    for (const OptionDescription &option : optionsOf(command)) {
        if (option.group != group) {
            group = option.group;
            text += headingMark + CommandLine::tr(group) + '\n';
        }
        text += writeEntry(optionSyntax(option), CommandLine::tr(option.text));
    }
    return text;
}

QString manualEntry(const QString &name, const QString &description)
{
    return QString(".TP\n.B %1\n%2\n").arg(name, description);
}

} // namespace

QString helpText(const CommandDescription &command)
{
    return CommandLine::tr("Usage:") + ' ' + usageLine(command) + "\n\n" + wrapped(CommandLine::tr(command.text)) +
           listOptions(command, "\n", helpEntry) + '\n' + wrapped(unitsText()) + '\n' + wrapped(exitStatusText());
}

QString manualPage()
{
    QString synopsis, sections;
    for (const CommandDescription &command : allCommands()) {
        synopsis += usageLine(command) + "\n.br\n";
        sections += QString(".SH %1\n%2\n%3")
                        .arg(isWindow(command) ? "DESCRIPTION" : QString(command.name).toUpper(),
                             CommandLine::tr(command.text), listOptions(command, ".SS ", manualEntry));
    }
    QString text = ".TH SLIDERCRANK 1 \"\" \"slidercrank " SLIDERCRANK_VERSION
                   "\" \"User Commands\"\n.SH NAME\nslidercrank - motion of an offset slider-crank\n"
                   ".SH SYNOPSIS\n" +
                   synopsis + sections + ".SH UNITS\n" + unitsText() + "\n.SH EXIT STATUS\n" + exitStatusText();
    return ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n" + text.replace('-', "\\-") + '\n';
}

} // namespace slidercrank
