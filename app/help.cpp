// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "app/command_line.h"

namespace slidercrank
{

namespace
{

constexpr OptionEntry kMechanismOptions[] = {
    {"a", "MM", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank length O₂-A, > 0 (20)")},
    {"b", "MM", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "coupler length A-B, > 0 (65)")},
    {"c", "MM", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "offset of the slider's line from O₂ (25)")},
    {"omega2", "RAD_PER_S", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank speed, constant (2π)")},
    {"theta20", "RAD", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank angle at t = 0 (0)")},
    {"branch", "open|crossed",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "assembly: slider to the right of A, or to the left (open)")},
    {"scene", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "a scene saved by the window: these and all else come from it; an option beside it wins")},
};

constexpr OptionEntry kRunOptions[] = {
    {"steps", "N",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "equal steps of the run; N + 1 instants, both ends (200)")},
    {"duration", "SECONDS", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "length of the run, > 0 (1)")},
    {"start", "SECONDS", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "first instant (0)")},
};

constexpr OptionEntry kInstantOptions[] = {
    {"at-angle", "DEGREES",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "one instant instead of a run: the first from --start on with the crank at this angle")},
};

constexpr OptionEntry kMethodOptions[] = {
    {"method", "newton|closed-form",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "how the motion is computed (closed-form)")},
    {"max-iterations", "N",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "most iterations of Newton-Raphson at an instant, >= 1 (10)")},
    {"tolerance", "T",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "residual ‖C‖ at which Newton-Raphson stops; 0: when it no longer falls (1e-8)")},
    {"tolerance-kind", "absolute|relative",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "absolute: ‖C‖ in mm and rad as they are; relative: lengths divided by a + b + |c| (absolute)")},
};

constexpr OptionEntry kSolveOptions[] = {
    {"channels", "LIST",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "all, or names separated by commas: theta3,R4_x_diff (all)")},
    {"angle-unit", "deg|rad", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "unit of the angles written (deg)")},
    {"format", "csv|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "form of the output (csv)")},
    {"output", "FILE", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file, not to standard output")},
};

constexpr OptionEntry kLimitsOptions[] = {
    {"format", "text|csv|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "form of the output (text: a table)")},
    {"output", "FILE", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file, not to standard output")},
};

constexpr OptionEntry kJoinOptions[] = {
    {"join", nullptr,
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "the files are of one motion, a plot each: read them as one, whose columns count on from file to "
         "file")},
};

constexpr OptionEntry kFileOptions[] = {
    {"column", "HEADING=MEANING",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "what a column of the files is, over what its name says, any number of times: \"slider.s=R4_x "
                       "[m]\", \"T=time [ms]\", \"id=ignored\"; #3 is the third column"),
     true},
    {"abscissa", "time|angle",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "what the first column of the files is: the time, or the crank's angle, of which --omega2 and "
                       "--theta20 make the time (by its name)")},
};

constexpr OptionEntry kCompareOptions[] = {
    {"format", "text|csv|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "form of the output (text: a table)")},
    {"output", "FILE", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file, not to standard output")},
    {"fail-on-difference", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "exit status 1 when a channel differs")},
};

constexpr OptionEntry kIdentifyOptions[] = {
    {"format", "text|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "form of the output (text)")},
    {"output", "FILE", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file, not to standard output")},
};

constexpr OptionEntry kStudyOptions[] = {
    {"cases", "nominal|hard|all",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "nominal: the mechanism of these options; hard: the hard cases, after the mechanism if one is "
                       "given; all: ten ordinary and the hard cases (nominal)")},
    {"format", "text|csv|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "form of the output (text: a table)")},
    {"output", "FILE", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file, not to standard output")},
};

constexpr OptionEntry kRenderOptions[] = {
    {"what", "WHAT",
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "figure (all plots), mechanism, frames (of the mechanism moving), report (on A4, PDF), or one plot: "
         "theta3, R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, "
         "error_acceleration (figure)")},
    {"output", "FILE",
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "a name that ends in .png, .svg or .pdf; for frames a new folder or, with ffmpeg, a video that ends in .mp4, "
         ".webm or .gif; needed")},
    {"reference", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "a simulation's CSV file to draw beside it; the files of one motion, a plot each, one by one"),
     true},
    {"size", "WxH",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "pixels (figure 1400x1800, mechanism and frames 900x700, plot 900x600)")},
    {"scale", "FACTOR",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "pixels of a PNG for each one of --size, 0.1 to 10 (1)")},
    {"theme", "light|dark", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "colours (light)")},
    {"at", "SECONDS",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "instant of the pose, marked in the plots (--start)")},
    {"at-angle", "DEGREES",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "the same by crank angle: the first instant from --start on with the crank at this angle")},
    {"speed", "FACTOR",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "for frames, 30 a second: seconds of motion in a second of film (1)")},
};

constexpr OptionEntry kWindowOptions[] = {
    {"reference", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "a simulation's CSV file to open; the files of one motion, a plot each, one by one"),
     true},
    {"reset-settings", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "forget what the window remembers: layout, recent files, language, theme, choices of columns")},
};

constexpr OptionEntry kEverywhereOptions[] = {
    {"help", nullptr, QT_TRANSLATE_NOOP("slidercrank::CommandLine", "this text")},
    {"version", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "name and version of the program, and what it is built of")},
};

constexpr const char *kMechanism = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Mechanism");
constexpr const char *kRun = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Instants");
constexpr const char *kMethod = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Method");
constexpr const char *kFiles = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Files");
constexpr const char *kResult = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Result");
constexpr const char *kOther = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Other");

QString introductionOf(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window:
        return CommandLine::tr(
            "Usage: slidercrank [FILE…] [options]           opens the window, with a scene or a "
            "reference\n"
            "       slidercrank solve [options]             the motion as CSV or JSON\n"
            "       slidercrank limits [options]            dead centres, stroke, transmission angle, peaks\n"
            "       slidercrank compare FILE… [options]     how far simulations' files are from "
            "the model\n"
            "       slidercrank identify FILE… [options]    the mechanism that each file belongs to\n"
            "       slidercrank study [options]             speed against error of every method\n"
            "       slidercrank render --output FILE [...]  a picture or a report: PNG, SVG or PDF\n"
            "\n"
            "Motion of an offset slider-crank. \"slidercrank solve --help\" and so on tell the "
            "options of each.\n"
            "Several files for the window are of one motion, a plot each: they are read as one reference.\n");
    case Subcommand::Solve:
        return CommandLine::tr("Usage: slidercrank solve [options]\n"
                               "\n"
                               "Computes the motion and writes a row an instant: time (s), then the channels asked "
                               "for: positions\n"
                               "(R1_x, R1_y, theta1, R2_x … theta4; mm, °), their first derivatives (theta3_diff) and "
                               "their\n"
                               "second (theta3_diff2), 17 significant digits, nan where a value does not exist.\n");
    case Subcommand::Limits:
        return CommandLine::tr("Usage: slidercrank limits [options]\n"
                               "\n"
                               "Whether the crank turns round and why, dead centres, stroke, the strokes' angles and "
                               "times, time ratio, transmission\n"
                               "angle, mean and peak speeds, peak accelerations, and where and when they are. A rocker "
                               "has fewer of them; exit status 4\n"
                               "where there is no pose at all.\n");
    case Subcommand::Compare:
        return CommandLine::tr(
            "Usage: slidercrank compare FILE… [options]\n\nReads simulations' CSV files (time,R4_x,theta3_diff,… as "
            "Inventor exports them) and tells how far each of their\ncolumns is from the exact motion of the mechanism "
            "at the file's own instants. Rounding makes a value uncertain by half\na unit of its last digit, and by "
            "how far the motion goes in half a unit of its instant's (evenly spaced instants count\nas exact). A "
            "column agrees when at least 95 % of its errors are within that and none beyond ten times as much, is "
            "close\nwhen none is beyond a hundred times, and differs otherwise; also where an error goes beyond its "
            "rounding by 1 % of half\nthe motion's range. Where one differs, the text says what explains it. A file "
            "that cannot be read is named on\nstandard error, and the others are still compared. FILE may be - for "
            "standard input.\n");
    case Subcommand::Identify:
        return CommandLine::tr(
            "Usage: slidercrank identify FILE… [options]\n\nFinds the mechanism that a simulation's file belongs to, "
            "from all of its columns, theta3, R4_x and their derivatives\nabove all, and how certain each of its "
            "parameters is. Where the file means something else by a column than its\nheading says (radians, another "
            "origin, the textbook's angle, another sign, …), that is said, and the file is read so.\nThe options of "
            "the mechanism give what the file cannot fix. R4_x and R4_y are measured from the crank's pivot "
            "O₂,\nangles counter-clockwise from x. A file that cannot be read is named on standard error, and the "
            "others are still\nlooked at. FILE may be - for standard input.\n\nidentified    what is left is rounding, "
            "or noise that looks like noise\nambiguous     several mechanisms explain the file equally: all are "
            "listed\ninsufficient  too few values, instants a turn or columns to tell\nnearest       no mechanism "
            "found explains the file: the nearest, as no more than that\nnone          not even that\n");
    case Subcommand::Study:
        return CommandLine::tr(
            "Usage: slidercrank study [options]\n\nTimes every method on the same instants and measures its error "
            "against the exact motion in 50 to 100 digits: the\nworst of the six plotted channels, relative to the "
            "channel's peak, over the instants that the method calls\nsolved. Beside it, what rounding the given "
            "numbers may cost by itself. newton-dense is the\nreport's way, with its absolute tolerance; the others "
            "measure the residual relative to a + b + |c|.\nfinite-difference differentiates positions sampled 200 "
            "times a turn; harmonic-N keeps N harmonics.\nTimes depend on the machine: compare them within one run.\n");
    case Subcommand::Render:
        return CommandLine::tr("Usage: slidercrank render --output FILE.png|.svg|.pdf [options]\n"
                               "\n"
                               "Draws what the window shows into a file, or writes a report of it. Needs no "
                               "display. A scene (--scene)\n"
                               "also brings what was on show: arrows, path, names, dimensions and zoom of the "
                               "mechanism; zoom, abscissa and\n"
                               "measure of the errors of the plots.\n");
    }
    return {};
}

QString shapeOf(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Solve:
        return CommandLine::tr("A header name stands alone for mm, ° and s; any other unit stands behind it: "
                               "theta3_diff [rad/s].\n"
                               "\n"
                               "JSON: {\"mechanism\":{\"a\",\"b\",\"c\",\"omega2\",\"theta20\",\"branch\"}, "
                               "\"method\":\"newton\"|\"closed-form\",\n"
                               "       \"units\":{\"length\":\"mm\",\"angle\":\"deg\"|\"rad\",\"time\":\"s\"}, "
                               "\"time\":[…], \"channels\":{\"theta3\":[…],…}};\n"
                               "      the mechanism in mm and rad as in the options, null where a value does not "
                               "exist.\n");
    case Subcommand::Limits:
        return CommandLine::tr(
            "JSON: {\"mechanism\":{\"a\",\"b\",\"c\",\"omega2\",\"theta20\",\"branch\"}, "
            "\"mobility\":\"full-turn\"|\"rocker\"|\"locked\"|\"impossible\",\n"
            "       \"reason\", \"limits\":[{\"name\",\"value\",\"unit\",\"theta2\",\"time\"}]}; theta2 "
            "in degrees, time in s, the\n"
            "      first from 0 on; null where there is none. CSV: a row a limit.\n");
    case Subcommand::Compare:
        return CommandLine::tr("JSON: {\"files\":[{\"file\", "
                               "\"mechanism\":{\"a\",\"b\",\"c\",\"omega2\",\"theta20\",\"branch\"}, "
                               "\"verdict\", \"channels\":[…],\n"
                               "       \"columns\":[{\"heading\",\"unit\",\"channel\",\"guessed\",\"why\"}],\n"
                               "       \"explanation\":{\"sentence\",\"mechanism\",\"conventions\":[as of identify]}, "
                               "where it differs,\n"
                               "       \"skipped\":[{\"line\",\"column\",\"text\",\"reason\"}], "
                               "\"ignoredColumns\":[…]}]}; a channel is\n"
                               "      {\"name\",\"unit\",\"count\",\"maxAbs\",\"timeOfMaxAbs\",\"rms\",\"maxPercent\","
                               "\"timeOfMaxPercent\",\n"
                               "       \"zeroReference\",\"percentOfPeak\",\"roundingStep\",\"verdict\"} in mm, ° and "
                               "s; null where there is none.\n"
                               "CSV: the file's name, then the same columns; behind them fileVerdict, that of the "
                               "whole file, and sentence,\n"
                               "     why it differs.\n");
    case Subcommand::Identify:
        return CommandLine::tr(
            "JSON: {\"file\", \"outcome\":\"identified\"|\"ambiguous\"|\"insufficient\"|\"nearest\"|\"none\",\n       "
            "\"mechanism\":{\"a\",\"b\",\"c\",\"omega2\",\"theta20\",\"branch\"}, \"standardError\":{\"a\",…}, "
            "\"identifiable\":{\"a\":true,…},\n       \"alternatives\":[{\"mechanism\",\"why\"}], "
            "\"rounded\":{\"a\",…}, \"noise\":{\"theta3\":rms,…}, \"iterations\",\n       \"conditionNumber\", "
            "\"channels\":[as of compare, against it], \"columns\":[as of compare],\n       "
            "\"conventions\":[{\"name\",\"channel\",\"amount\",\"unit\",\"explanation\",\"before\",\"after\"}], "
            "\"summary\"};\n      in mm and rad as the options; why: \"mirror-image\", \"reversed\", "
            "\"other-assembly\", \"alias\" or \"another-mechanism\";\n      channel: one, or several with commas; "
            "before, after: largest error, % of peak; null where there is none.\n      With the outcome nearest, the "
            "mechanism is no more than the nearest one.\n      Of several files: {\"files\":[…]}.\n");
    case Subcommand::Study:
        return CommandLine::tr("JSON: {\"machine\", \"cases\":[{\"name\", \"methods\":[…]}]}; a method is\n"
                               "      {\"method\",\"tolerance\",\"channels\",\"nsPerState\",\"spread\","
                               "\"iterationsPerState\",\"maxError\",\n"
                               "       \"errorBound\",\"status\",\"counts\",\"silentFailures\"}; spread: between the "
                               "quartiles, in ns; status: the worst;\n"
                               "       counts: instants by status; silentFailures: instants called solved and wrong; "
                               "null where there is none.\n"
                               "CSV: the case's name, then the same columns, a column a status.\n");
    case Subcommand::Window:
    case Subcommand::Render: break;
    }
    return {};
}

QString exitStatusText()
{
    return CommandLine::tr("Exit status: 0 done; 1 --fail-on-difference and a channel differs; 2 the command line is "
                           "wrong; 3 a file or\n"
                           "standard output cannot be read or written, or a file is not what it should be; 4 the "
                           "mechanism cannot be\n"
                           "assembled at some instant (the others are still written); 5 Newton-Raphson did not "
                           "converge, or velocity and\n"
                           "acceleration do not exist, somewhere, or a file's mechanism was neither identified nor "
                           "ambiguous. Of several, 3,\n"
                           "4, 5, 1 in this order.\n");
}

} // namespace

QString wordOf(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window: return {};
    case Subcommand::Solve: return QStringLiteral("solve");
    case Subcommand::Limits: return QStringLiteral("limits");
    case Subcommand::Compare: return QStringLiteral("compare");
    case Subcommand::Identify: return QStringLiteral("identify");
    case Subcommand::Study: return QStringLiteral("study");
    case Subcommand::Render: return QStringLiteral("render");
    }
    return {};
}

std::vector<OptionGroup> optionGroupsOf(Subcommand subcommand)
{
    switch (subcommand) {
    case Subcommand::Window: return {{kOther, kWindowOptions}, {kOther, kEverywhereOptions}};
    case Subcommand::Solve:
        return {{kMechanism, kMechanismOptions}, {kRun, kRunOptions},      {kRun, kInstantOptions},
                {kMethod, kMethodOptions},       {kResult, kSolveOptions}, {kOther, kEverywhereOptions}};
    case Subcommand::Limits:
        return {{kMechanism, kMechanismOptions}, {kResult, kLimitsOptions}, {kOther, kEverywhereOptions}};
    case Subcommand::Compare:
        return {{kMechanism, kMechanismOptions},
                {kFiles, kJoinOptions},
                {kFiles, kFileOptions},
                {kResult, kCompareOptions},
                {kOther, kEverywhereOptions}};
    case Subcommand::Identify:
        return {{kMechanism, kMechanismOptions},
                {kFiles, kJoinOptions},
                {kFiles, kFileOptions},
                {kResult, kIdentifyOptions},
                {kOther, kEverywhereOptions}};
    case Subcommand::Study:
        return {{kMechanism, kMechanismOptions}, {kResult, kStudyOptions}, {kOther, kEverywhereOptions}};
    case Subcommand::Render:
        return {{kMechanism, kMechanismOptions}, {kRun, kRunOptions},       {kMethod, kMethodOptions},
                {kFiles, kFileOptions},          {kResult, kRenderOptions}, {kOther, kEverywhereOptions}};
    }
    return {};
}

QString helpOf(Subcommand subcommand)
{
    QString help = introductionOf(subcommand);
    const char *title = nullptr;
    for (const OptionGroup &group : optionGroupsOf(subcommand)) {
        if (group.title != title) {
            title = group.title;
            help += u'\n' + CommandLine::tr(title) + u'\n';
        }
        for (const OptionEntry &entry : group.entries) {
            QString left = QStringLiteral("  --") + QLatin1String(entry.name);
            if (entry.value) {
                left += u' ' + QLatin1String(entry.value);
            }
            help += left.leftJustified(30) + u' ' + CommandLine::tr(entry.text) + u'\n';
        }
        if (title == kMechanism) {
            help += QStringLiteral("  ") +
                    CommandLine::tr("A unit behind a number is understood: 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms.") +
                    u'\n';
        }
    }
    if (const QString shape = shapeOf(subcommand); !shape.isEmpty()) {
        help += u'\n' + shape;
    }
    return help + u'\n' + exitStatusText();
}

} // namespace slidercrank
