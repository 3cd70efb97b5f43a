// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr CommandDescription kCommands[] = {
    {"", "[SCENE | FILE.csv…] [options]", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "opens the window"),
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "Motion of an offset slider-crank. Several CSV files are read as one motion. "
                       "\"slidercrank help COMMAND\" describes a command.")},
    {"solve", "[options]", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "the motion as CSV or JSON"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Computes the motion and writes a row for each time step: time, then the channels: positions (R1_x, R1_y, "
         "theta1, R2_x … theta4), first derivatives (theta3_diff) and second derivatives (theta3_diff2), with 17 "
         "significant digits. A value that does not exist is nan in CSV and null in JSON. A column name stands alone "
         "if its unit is mm, ° or s; any other unit follows the name: theta3_diff [rad/s].")},
    {"limits", "[options]",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "dead centres, stroke, transmission angle, peaks"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Prints whether the crank makes full turns and why, the dead centres, the stroke, angles and times of both "
         "strokes, the time ratio, the minimum transmission angle, mean and peak speeds and peak accelerations, and "
         "where and when they occur. Angles in JSON and CSV are in degrees. The exit status is 4 if the mechanism "
         "cannot be assembled at all.")},
    {"compare", "FILE… [options]",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "how far simulations' files are from the model"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Reads CSV files of simulations (time,R4_x,theta3_diff,…) and prints how far each column is from the model "
         "at the file's own time stamps. A value is uncertain by half a unit of its last digit and by the motion "
         "within half a unit of its time stamp. A column agrees if at least 95 % of its errors are within that bound "
         "and none exceeds ten times the bound; it is close if none exceeds a hundred times the bound; otherwise it "
         "differs. It also differs if an error exceeds its bound by 1 % of half the range of the motion. For a file "
         "that differs, the program says what would explain the difference. A file that cannot be read is reported, "
         "and the others are still compared. FILE may be - for standard input.")},
    {"identify", "FILE… [options]",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "the mechanism that each file belongs to"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Finds the mechanism that a simulation's file belongs to, from all of its columns, and how certain each "
         "parameter is. Where a column means something else than its heading says (radians, another origin, another "
         "sign …), the program says so and reads the file accordingly. The options of the mechanism supply what the "
         "file does not determine. R4_x and R4_y are measured from the crank pivot O₂, angles counter-clockwise from "
         "x. FILE may be - for standard input. Outcomes: identified, the residuals are rounding or white noise; "
         "approximate, a mechanism explains the file up to a systematic deviation of at most 1 %; ambiguous, several "
         "mechanisms explain the file equally well; insufficient, the file holds too little to decide; nearest, no "
         "mechanism explains the file and the nearest one is printed; none, there is no such mechanism either.")},
    {"study", "[options]", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "speed against error of every method"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Times every method on the same time stamps and measures its error against the exact motion in 50 to 100 "
         "digits: the largest error of the six plotted channels, relative to the channel's peak, over the time "
         "stamps that the method reports as solved. Times depend on the machine: compare them within one run.")},
    {"render", "--output FILE [options]",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "a picture, an animation or a report"),
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Draws what the window shows into a file, or writes a report of it. Needs no display. A scene (--scene) also "
         "supplies what the window showed: arrows, path, names, dimensions, zoom, abscissa and error measure.")},
};

constexpr int bit(Subcommand subcommand)
{
    return 1 << static_cast<int>(subcommand);
}

constexpr int kWindow = bit(Subcommand::Window);
constexpr int kSolve = bit(Subcommand::Solve);
constexpr int kLimits = bit(Subcommand::Limits);
constexpr int kCompare = bit(Subcommand::Compare);
constexpr int kIdentify = bit(Subcommand::Identify);
constexpr int kStudy = bit(Subcommand::Study);
constexpr int kRender = bit(Subcommand::Render);
constexpr int kWithMechanism = kSolve | kLimits | kCompare | kIdentify | kStudy | kRender;

constexpr const char *kMechanism = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Mechanism");
constexpr const char *kSampling = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Time steps");
constexpr const char *kMethod = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Method");
constexpr const char *kFiles = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Files");
constexpr const char *kResult = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Result");
constexpr const char *kOther = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Other");

constexpr OptionDescription kOptions[] = {
    {kWithMechanism, kMechanism, "a", "MM", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank length O₂A (20)")},
    {kWithMechanism, kMechanism, "b", "MM", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "coupler length AB (65)")},
    {kWithMechanism, kMechanism, "c", "MM",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "offset of the slider's line from O₂ (25)")},
    {kWithMechanism, kMechanism, "omega2", "RAD_PER_S",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank speed, constant (2π)")},
    {kWithMechanism, kMechanism, "theta20", "ANGLE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank angle at t = 0, with its unit: 30deg or 0.5rad (0)")},
    {kWithMechanism, kMechanism, "branch", "open|crossed",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "assembly: the slider to the right or to the left of A (open)")},
    {kWithMechanism, kMechanism, "scene", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "take every setting from a scene that the window saved; options override it")},

    {kSolve | kRender, kSampling, "steps", "N",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "number of equal steps; N + 1 rows, both ends included (200)")},
    {kSolve | kRender, kSampling, "duration", "SECONDS",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "time span (1)")},
    {kSolve | kRender, kSampling, "start", "SECONDS",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "first time stamp (0)")},
    {kSolve, kSampling, "step-angle", "DEGREES",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "instead: a row every so many degrees of the crank, over one revolution")},
    {kSolve, kSampling, "at", "SECONDS", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "instead: one time stamp")},
    {kSolve, kSampling, "at-angle", "DEGREES",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "instead: the first time from --start on at which the crank is at this angle")},

    {kSolve | kCompare | kRender, kMethod, "method", "newton|closed-form",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "how the motion is computed (closed-form)")},
    {kSolve | kCompare | kRender, kMethod, "max-iterations", "N",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "maximum iterations of Newton-Raphson per time step (10)")},
    {kSolve | kCompare | kRender, kMethod, "tolerance", "T",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "residual ‖C‖ at which Newton-Raphson stops; 0: when it no longer decreases (1e-8)")},
    {kSolve | kCompare | kRender, kMethod, "tolerance-kind", "absolute|relative",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "absolute: ‖C‖ in mm and rad; relative: lengths divided by a + b + |c| (absolute)")},

    {kCompare | kIdentify, kFiles, "join", nullptr,
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "the files are of one motion: read them as one; their columns are numbered on from file to file")},
    {kWindow | kRender, kFiles, "reference", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "a simulation's CSV file; repeat it for several files of one motion"),
     nullptr, true},
    {kCompare | kIdentify | kRender, kFiles, "column", "HEADING=MEANING",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "overrides the meaning of a column, may be repeated: \"slider.s=R4_x [m]\", \"T=time [ms]\", "
                       "\"id=ignored\"; #3 is the third column"),
     nullptr, true},
    {kCompare | kIdentify | kRender, kFiles, "abscissa", "time|angle",
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "the first column holds time stamps, or crank angles, which --omega2 and --theta20 turn into time")},

    {kSolve, kResult, "channels", "LIST",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "all, or names separated by commas: theta3,R4_x_diff (all)")},
    {kSolve, kResult, "angle-unit", "deg|rad",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "unit of the angles in the output (deg)")},
    {kSolve, kResult, "format", "csv|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "output format (csv)")},
    {kIdentify, kResult, "format", "text|json", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "output format (text)")},
    {kLimits | kCompare | kStudy, kResult, "format", "text|csv|json",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "output format (text)")},
    {kLimits, kResult, "vary", "NAME=FROM..TO",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "a row of limits for each of several values of a parameter: b=50..120 (csv or json)")},
    {kLimits, kResult, "count", "N", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "number of values of --vary (100)")},
    {kLimits, kResult, "design", "LIST",
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "the mechanism with this stroke and time ratio: stroke=80,time-ratio=1.2; its minimum transmission "
         "angle is as large as possible, and at least that of ,transmission-angle=40")},
    {kCompare, kResult, "fail-on-difference", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "exit with status 1 if a channel differs")},
    {kStudy, kResult, "cases", "nominal|hard|all",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "the mechanism of the options, the hard cases (after the mechanism, if one is given), or ten "
                       "ordinary and the hard cases (nominal)")},
    {kRender, kResult, "what", "WHAT",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "figure (all plots), mechanism, frames (the mechanism moving), report, or one plot: theta3, "
                       "R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, "
                       "error_acceleration (figure)")},
    {kRender, kResult, "size", "WxH",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "pixels (figure 1400x1800, mechanism and frames 900x700, plot 900x600)")},
    {kRender, kResult, "scale", "FACTOR",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "pixels of a PNG per pixel of --size, 0.1 to 10 (1)")},
    {kRender, kResult, "theme", "light|dark", QT_TRANSLATE_NOOP("slidercrank::CommandLine", "colours (light)")},
    {kRender, kResult, "at", "SECONDS",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "time at which the mechanism is drawn, marked in the plots (--start)")},
    {kRender, kResult, "at-angle", "DEGREES",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "the same by crank angle: the first time from --start on with the crank at this angle")},
    {kRender, kResult, "speed", "FACTOR",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "for frames, 30 per second: seconds of motion per second (1)")},
    {kRender, kResult, "output", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "required: a name that ends in .png, .svg or .pdf; for frames the name of a new folder, or of a "
                       "video that ends in .mp4, .webm or .gif (needs ffmpeg)"),
     "o"},
    {kWithMechanism & ~kRender, kResult, "output", "FILE",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "write to this file instead of standard output"), "o"},

    {kWindow, kOther, "reset-settings", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "remove the window's settings: layout, recent files, language, theme, meanings of columns")},
    {kWindow | kWithMechanism, kOther, "help", nullptr, QT_TRANSLATE_NOOP("slidercrank::CommandLine", "show this text"),
     "h"},
    {kWindow | kWithMechanism, kOther, "version", nullptr,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "show the version of the program and of its libraries")},
};

} // namespace

std::span<const CommandDescription> allCommands()
{
    return kCommands;
}

QStringList subcommandNames()
{
    QStringList names;
    for (const CommandDescription &command : allCommands().subspan(1)) {
        names += command.name;
    }
    return names;
}

const CommandDescription &describe(Subcommand subcommand)
{
    return kCommands[static_cast<std::size_t>(subcommand)];
}

std::optional<Subcommand> subcommandNamed(const QString &name)
{
    const qsizetype index = subcommandNames().indexOf(name);
    return index < 0 ? std::nullopt : std::optional(static_cast<Subcommand>(index + 1));
}

std::vector<OptionDescription> optionsOf(Subcommand subcommand)
{
    std::vector<OptionDescription> options;
    std::ranges::copy_if(kOptions, std::back_inserter(options), [subcommand](const OptionDescription &option) {
        return (option.commands & bit(subcommand)) != 0;
    });
    return options;
}

} // namespace slidercrank
