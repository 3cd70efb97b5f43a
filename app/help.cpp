// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "app/command_line.h"

#include <array>

namespace slidercrank
{

namespace
{

constexpr qsizetype kLineWidth = 100;
constexpr qsizetype kOptionWidth = 34;

QString usage(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window: return QStringLiteral("slidercrank [SCENE | FILE.csv…] [options]");
    case Subcommand::Compare:
    case Subcommand::Identify: return QStringLiteral("slidercrank %1 FILE… [options]").arg(nameOf(subcommand));
    case Subcommand::Render: return QStringLiteral("slidercrank render --output FILE [options]");
    case Subcommand::Solve:
    case Subcommand::Limits:
    case Subcommand::Study: return QStringLiteral("slidercrank %1 [options]").arg(nameOf(subcommand));
    }
    return {};
}

/// One line for the list of commands.
QString summary(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window: return CommandLine::tr("opens the window");
    case Subcommand::Solve: return CommandLine::tr("the motion as CSV or JSON");
    case Subcommand::Limits: return CommandLine::tr("dead centres, stroke, transmission angle, peaks");
    case Subcommand::Compare: return CommandLine::tr("how far simulations' files are from the model");
    case Subcommand::Identify: return CommandLine::tr("the mechanism that each file belongs to");
    case Subcommand::Study: return CommandLine::tr("speed against error of every method");
    case Subcommand::Render: return CommandLine::tr("a picture, an animation or a report");
    }
    return {};
}

QString description(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window:
        return CommandLine::tr("Motion of an offset slider-crank. Several CSV files are read as one motion. "
                               "\"slidercrank help COMMAND\" describes a command.");
    case Subcommand::Solve:
        return CommandLine::tr(
            "Computes the motion and writes a row for each time step: time, then the channels: positions (R1_x, R1_y, "
            "theta1, R2_x … theta4), first derivatives (theta3_diff) and second derivatives (theta3_diff2), with 17 "
            "significant digits. A value that does not exist is nan in CSV and null in JSON. A column name stands alone "
            "if its unit is mm, ° or s; any other unit follows the name: theta3_diff [rad/s].");
    case Subcommand::Limits:
        return CommandLine::tr(
            "Prints whether the crank makes full turns and why, the dead centres, the stroke, angles and times of both "
            "strokes, the time ratio, the minimum transmission angle, mean and peak speeds and peak accelerations, and "
            "where and when they occur. Angles in JSON and CSV are in degrees. The exit status is 4 if the mechanism "
            "cannot be assembled at all.");
    case Subcommand::Compare:
        return CommandLine::tr(
            "Reads CSV files of simulations (time,R4_x,theta3_diff,…) and prints how far each column is from the model "
            "at the file's own time stamps. A value is uncertain by half a unit of its last digit and by the motion "
            "within half a unit of its time stamp. A column agrees if at least 95 % of its errors are within that bound "
            "and none exceeds ten times the bound; it is close if none exceeds a hundred times the bound; otherwise it "
            "differs. It also differs if an error exceeds its bound by 1 % of half the range of the motion. For a file "
            "that differs, the program says what would explain the difference. A file that cannot be read is reported, "
            "and the others are still compared. FILE may be - for standard input.");
    case Subcommand::Identify:
        return CommandLine::tr(
            "Finds the mechanism that a simulation's file belongs to, from all of its columns, and how certain each "
            "parameter is. Where a column means something else than its heading says (radians, another origin, another "
            "sign …), the program says so and reads the file accordingly. The options of the mechanism supply what the "
            "file does not determine. R4_x and R4_y are measured from the crank pivot O₂, angles counter-clockwise from "
            "x. FILE may be - for standard input. Outcomes: identified, the residuals are rounding or white noise; "
            "approximate, a mechanism explains the file up to a systematic deviation of at most 1 %; ambiguous, several "
            "mechanisms explain the file equally well; insufficient, the file holds too little to decide; nearest, no "
            "mechanism explains the file and the nearest one is printed; none, there is no such mechanism either.");
    case Subcommand::Study:
        return CommandLine::tr(
            "Times every method on the same time stamps and measures its error against the exact motion in 50 to 100 "
            "digits: the largest error of the six plotted channels, relative to the channel's peak, over the time "
            "stamps that the method reports as solved. Times depend on the machine: compare them within one run.");
    case Subcommand::Render:
        return CommandLine::tr(
            "Draws what the window shows into a file, or writes a report of it. Needs no display. A scene (--scene) also "
            "supplies what the window showed: arrows, path, names, dimensions, zoom, abscissa and error measure.");
    }
    return {};
}

QString exitStatusText()
{
    return CommandLine::tr(
        "Exit status: 0 success; 1 --fail-on-difference was given and a channel differs; 2 usage error; 3 a file cannot "
        "be read or written; 4 the mechanism cannot be assembled at some time step (the other steps are still written); "
        "5 not converged or singular at some time step, or no mechanism identified. If several apply: 3 before 4 before "
        "5 before 1.");
}

QString unitsText()
{
    return CommandLine::tr("A number alone is in the unit shown; 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms are understood.");
}

/// Breaks the text into lines; all but the first are indented.
QString wrapped(const QString &text, qsizetype indent, qsizetype firstColumn)
{
    QString result;
    qsizetype column = firstColumn;
    for (const QString &word : text.split(u' ', Qt::SkipEmptyParts)) {
        if (column > indent && column + 1 + word.size() > kLineWidth) {
            result += u'\n' + QString(indent, u' ');
            column = indent;
        } else if (column > indent) {
            result += u' ';
            ++column;
        }
        result += word;
        column += word.size();
    }
    return result + u'\n';
}

/// "--output, -o FILE"
QString optionSyntax(const OptionDescription &option)
{
    QString syntax = QStringLiteral("--") + QLatin1String(option.name);
    if (option.shortName) {
        syntax += QStringLiteral(", -") + QLatin1String(option.shortName);
    }
    return option.value ? syntax + u' ' + QLatin1String(option.value) : syntax;
}

QString roff(QString text)
{
    return text.replace(u'\\', QStringLiteral("\\e")).replace(u'-', QStringLiteral("\\-"));
}

constexpr std::array kAllSubcommands{Subcommand::Window,   Subcommand::Solve, Subcommand::Limits, Subcommand::Compare,
                                     Subcommand::Identify, Subcommand::Study, Subcommand::Render};

} // namespace

QString helpText(Subcommand subcommand)
{
    QString text = CommandLine::tr("Usage:") + u' ' + usage(subcommand) + QStringLiteral("\n\n");
    text += wrapped(description(subcommand), 0, 0);
    if (subcommand == Subcommand::Window) {
        text += u'\n';
        for (const Subcommand each : kAllSubcommands) {
            text += QStringLiteral("  ") + usage(each).leftJustified(44) + u' ' + summary(each) + u'\n';
        }
    }
    const char *group = nullptr;
    for (const OptionDescription &option : optionsOf(subcommand)) {
        if (option.group != group) {
            group = option.group;
            text += u'\n' + CommandLine::tr(group) + u'\n';
        }
        const QString syntax = QStringLiteral("  ") + optionSyntax(option);
        text += syntax.size() < kOptionWidth ? syntax.leftJustified(kOptionWidth) : syntax + u'\n' + QString(kOptionWidth, u' ');
        text += wrapped(CommandLine::tr(option.text), kOptionWidth, kOptionWidth);
    }
    if (subcommand != Subcommand::Window) {
        text += u'\n' + wrapped(unitsText(), 0, 0);
    }
    return text + u'\n' + wrapped(exitStatusText(), 0, 0);
}

QString manualPage()
{
    QString text = QStringLiteral(".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
                                  ".TH SLIDERCRANK 1 \"\" \"slidercrank " SLIDERCRANK_VERSION "\" \"User Commands\"\n"
                                  ".SH NAME\nslidercrank \\- motion of an offset slider\\-crank\n.SH SYNOPSIS\n");
    for (const Subcommand subcommand : kAllSubcommands) {
        text += roff(usage(subcommand)) + QStringLiteral("\n.br\n");
    }
    for (const Subcommand subcommand : kAllSubcommands) {
        const QString name = subcommand == Subcommand::Window ? QStringLiteral("DESCRIPTION") : nameOf(subcommand).toUpper();
        text += QStringLiteral(".SH ") + name + u'\n' + roff(description(subcommand)) + u'\n';
        for (const OptionDescription &option : optionsOf(subcommand)) {
            text += QStringLiteral(".TP\n.B ") + roff(optionSyntax(option)) + u'\n' + roff(CommandLine::tr(option.text)) + u'\n';
        }
    }
    return text + QStringLiteral(".SH UNITS\n") + roff(unitsText()) + QStringLiteral("\n.SH EXIT STATUS\n") +
           roff(exitStatusText()) + u'\n';
}

} // namespace slidercrank
