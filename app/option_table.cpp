// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::array<std::pair<Subcommand, const char *>, 6> kNames{{{Subcommand::Solve, "solve"},
                                                                    {Subcommand::Limits, "limits"},
                                                                    {Subcommand::Compare, "compare"},
                                                                    {Subcommand::Identify, "identify"},
                                                                    {Subcommand::Study, "study"},
                                                                    {Subcommand::Render, "render"}}};

constexpr int kWindow = static_cast<int>(Subcommand::Window);
constexpr int kSolve = static_cast<int>(Subcommand::Solve);
constexpr int kLimits = static_cast<int>(Subcommand::Limits);
constexpr int kCompare = static_cast<int>(Subcommand::Compare);
constexpr int kIdentify = static_cast<int>(Subcommand::Identify);
constexpr int kStudy = static_cast<int>(Subcommand::Study);
constexpr int kRender = static_cast<int>(Subcommand::Render);
constexpr int kWithMechanism = kSolve | kLimits | kCompare | kIdentify | kStudy | kRender;

constexpr const char *kMechanism = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Mechanism");
constexpr const char *kSampling = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Time steps");
constexpr const char *kMethod = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Method");
constexpr const char *kFiles = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Files");
constexpr const char *kResult = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Result");
constexpr const char *kOther = QT_TRANSLATE_NOOP("slidercrank::CommandLine", "Other");

constexpr OptionDescription kOptions[] = {
    {kWithMechanism, kMechanism, "a", "MM",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "crank length O₂A (20)")},
    {kWithMechanism, kMechanism, "b", "MM",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "coupler length AB (65)")},
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
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
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
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
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
    {kLimits, kResult, "count", "N",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "number of values of --vary (100)")},
    {kLimits, kResult, "design", "LIST",
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
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
     QT_TRANSLATE_NOOP("slidercrank::CommandLine", "time at which the mechanism is drawn, marked in the plots (--start)")},
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

QStringList subcommandNames()
{
    QStringList names;
    for (const auto &[subcommand, name] : kNames) {
        names += QLatin1String(name);
    }
    return names;
}

QString nameOf(Subcommand subcommand)
{
    const auto found = std::ranges::find(kNames, subcommand, &std::pair<Subcommand, const char *>::first);
    return found == kNames.end() ? QString() : QString::fromLatin1(found->second);
}

std::optional<Subcommand> subcommandNamed(const QString &name)
{
    const auto found = std::ranges::find_if(kNames, [&](const auto &entry) { return name == QLatin1String(entry.second); });
    return found == kNames.end() ? std::nullopt : std::optional(found->first);
}

std::vector<OptionDescription> optionsOf(Subcommand subcommand)
{
    std::vector<OptionDescription> options;
    std::ranges::copy_if(kOptions, std::back_inserter(options), [subcommand](const OptionDescription &option) {
        return (option.commands & static_cast<int>(subcommand)) != 0;
    });
    return options;
}

} // namespace slidercrank
