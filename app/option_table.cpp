// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include "app/commands.h"
#include "app/option_words.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace slidercrank
{

namespace
{

/// The names of the commands, in the order of allCommands().
constexpr std::string_view kCommandNames[] = {"window",  "solve",    "limits", "check",
                                              "compare", "identify", "study",  "render"};

consteval bool areCommands(std::string_view names)
{
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(' '));
        if (std::ranges::find(kCommandNames, name) == std::end(kCommandNames)) {
            return false;
        }
        names.remove_prefix(std::min(name.size() + 1, names.size()));
    }
    return true;
}

} // namespace

consteval CommandList::CommandList(const char *theNames)
    : names(theNames)
{
    if (!areCommands(theNames)) {
        throw "an unknown command"; // stops the compiler
    }
}

namespace
{

struct OptionGroup {
    const char *heading; ///< untranslated
    std::vector<OptionDescription> options;
};

struct Descriptions {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::CommandLine)

public:
    static constexpr CommandDescription kCommands[] = {
        {"window", "[SCENE | FILE.csv…] [options]", QT_TR_NOOP("opens the window"),
         QT_TR_NOOP("Motion of an offset slider-crank. Several CSV files are read as one motion. \"slidercrank help "
                    "COMMAND\" describes a command."),
         windowCommand, Platform::Window},
        {"solve", "[options]", QT_TR_NOOP("the motion as CSV or JSON"),
         QT_TR_NOOP(
             "Computes the motion and writes a row for each time step: time, then the channels: positions (R1_x, R1_y, "
             "theta1, R2_x … theta4), first derivatives (theta3_diff) and second derivatives (theta3_diff2), with 17 "
             "significant digits. A value that does not exist is nan in CSV and null in JSON. A column name stands "
             "alone if its unit is mm, ° or s; any other unit follows the name: theta3_diff [rad/s]."),
         solveCommand},
        {"limits", "[options]", QT_TR_NOOP("dead centres, stroke, transmission angle, peaks"),
         QT_TR_NOOP(
             "Prints whether the crank makes full turns and why, the dead centres, the stroke, angles and times "
             "of both strokes, the time ratio, the extremes of the transmission angle and of the coupler angle, mean "
             "and peak speeds and peak accelerations, and where and when they occur. Crank angles in JSON and "
             "CSV are in degrees. The exit status is 4 if the mechanism cannot be assembled at all."),
         limitsCommand},
        {"check", "NAME=VALUE… [options]", QT_TR_NOOP("which slip gives the numbers of a calculation by hand"),
         QT_TR_NOOP(
             "Checks numbers of a calculation by hand for one position of the crank (--at-angle), and names the slip "
             "that gives exactly the wrong ones. Names: x, v, a (position, velocity and acceleration of the slider), "
             "theta3, omega3, alpha3 (of the coupler), displacement (from the outer dead centre), mu (transmission "
             "angle), and every channel of solve. A number alone is in mm, degrees and s, omega3 and alpha3 also in "
             "rad/s if that is more likely; units are accepted: omega3=5.42rad/s. A number is right if the exact one "
             "rounds to it; zeros at the end of a whole number count up to the third digit. theta3 may also be "
             "measured at B, as in Norton's book. A slip is named only if it does not contradict the right numbers, "
             "if no other slip gives all wrong numbers, and if these have enough digits to exclude a coincidence."),
         checkCommand},
        {"compare", "FILE… [options]", QT_TR_NOOP("how far simulation files are from the model"),
         QT_TR_NOOP(
             "Reads CSV files of simulations (time,R4_x,theta3_diff,…) and prints how far each column is from the "
             "model at the file's own time stamps. A value is uncertain by half a unit of its last digit and by the "
             "motion within half a unit of its time stamp. A column agrees if at least 95 % of its errors are within "
             "that bound and none exceeds ten times the bound; it is close if none exceeds a hundred times the bound; "
             "otherwise it differs. Moreover, no error of a column that agrees may exceed its bound by more than 0.5 % "
             "of half the range of the motion, and none of a close one by more than 1 %. For a file that differs, the "
             "program says what would explain the difference. A file that cannot be read is reported, and the others "
             "are still compared. FILE may be - for standard input."),
         compareCommand},
        {"identify", "FILE… [options]", QT_TR_NOOP("the mechanism that produced each file"),
         QT_TR_NOOP("Identifies the mechanism that produced a file, from all of its columns, and how certain each "
                    "parameter is (± one standard error). If the meaning of a column differs from its heading "
                    "(radians, a different origin or sign …), the program reports that and reads the file accordingly. "
                    "The options of the mechanism supply what the file does not determine. R4_x and R4_y are measured "
                    "from the crank pivot O₂, angles counter-clockwise from x. FILE may be - for standard input. "
                    "Outcomes: identified (rounding explains every column that is used), approximate (a mechanism "
                    "explains the file with residuals below 2 % of the range), insufficient (the file does not "
                    "determine the mechanism), none (no mechanism explains the file)."),
         identifyCommand},
        {"study", "[options]", QT_TR_NOOP("speed and error of every method"),
         QT_TR_NOOP(
             "Times every method on the same time stamps and measures its error against the exact motion in 115 "
             "digits: the largest error of the six plotted channels, relative to the channel's peak, over the time "
             "stamps that the method reports as solved. Times depend on the machine: compare them within one run. With "
             "several cases (--cases), a table of the methods over all cases comes first: largest error, median time, "
             "and how many time steps were solved. The tables of the cases follow; --format csv has their rows, too."),
         studyCommand},
        {"render", "--output FILE [options]", QT_TR_NOOP("a picture, an animation or a report"),
         QT_TR_NOOP("Draws what the window shows into a file, or writes a report of it. Needs no display. A scene "
                    "(--scene) also supplies what the window showed: arrows, path, names, dimensions, zoom, abscissa "
                    "and error measure. Without --start, --duration and --scene, the plots of a fast crank show its "
                    "first revolution."),
         renderCommand, Platform::Offscreen},
    };

    static constexpr CommandList kWithMechanism = "solve limits check compare identify study render";
    static constexpr CommandList kEveryCommand = "window solve limits check compare identify study render";

    static inline const std::vector<OptionGroup> kGroups{
        {QT_TR_NOOP("Mechanism"),
         {{kWithMechanism, "a", "MM", QT_TR_NOOP("crank length O₂A (20)")},
          {kWithMechanism, "b", "MM", QT_TR_NOOP("coupler length AB (65)")},
          {kWithMechanism, "c", "MM", QT_TR_NOOP("offset of the slider's line from O₂ (25)")},
          {kWithMechanism, "omega2", "RAD_PER_S", QT_TR_NOOP("crank speed, constant (2π)")},
          {kWithMechanism, "theta20", "ANGLE", QT_TR_NOOP("crank angle at t = 0, with its unit: 30deg or 0.5rad (0)")},
          {kWithMechanism, "branch", kJoinedWords<Branch>.data(),
           QT_TR_NOOP("assembly: the slider to the right or to the left of A (open)")},
          {kWithMechanism, "scene", "FILE",
           QT_TR_NOOP(
               "read all settings from a scene that the window saved, or from a copied link; options override them")}}},
        {QT_TR_NOOP("Time steps"),
         {{"solve render", "steps", "N", QT_TR_NOOP("number of equal steps; N + 1 rows, both ends included (200)")},
          {"solve render", "duration", "SECONDS", QT_TR_NOOP("time span (1)")},
          {"solve render", "start", "SECONDS", QT_TR_NOOP("first time stamp (0)")},
          {"solve", "step-angle", "DEGREES",
           QT_TR_NOOP(
               "instead of --steps and --duration: a row for each step of this crank angle, over one revolution")},
          {"render", "step-angle", "DEGREES", QT_TR_NOOP("step of the table in a report (15)")},
          {"solve", "at", "SECONDS", QT_TR_NOOP("instead of --steps and --duration: one row, for this time")},
          {"render", "at", "SECONDS", QT_TR_NOOP("the time that is drawn, and marked in the plots (--start)")},
          {"solve render", "at-angle", "DEGREES",
           QT_TR_NOOP("as --at, for the first time from --start on at which the crank is at this angle")},
          {"check", "at-angle", "DEGREES", QT_TR_NOOP("crank angle at which the values are checked (--theta20)")},
          {"check", "alpha2", "RAD_PER_S2", QT_TR_NOOP("crank acceleration (0)")},
          {"render", "alpha2", "RAD_PER_S2",
           QT_TR_NOOP("crank acceleration in the values of a report, in polygons, and in the arrows that a scene draws "
                      "(0)")},
          {"solve", "when", "CHANNEL=VALUE",
           QT_TR_NOOP("a row for each position of one revolution in which a quantity has this value: x=60, "
                      "theta3=10deg, v=-0.2m/s, or any channel")},
          {"solve", "alpha2", "RAD_PER_S2",
           QT_TR_NOOP("crank acceleration at the positions of --at, --at-angle, --step-angle or --when (0): a channel "
                      "f has the second derivative f″ω₂² + f′α₂")},
          {"solve", "omega2-for", "CHANNEL=VALUE",
           QT_TR_NOOP("with --at-angle: compute the crank speed at which a first derivative has this value, and report "
                      "it: v=8m/s")}}},
        {QT_TR_NOOP("Method"),
         {{"solve compare render", "method", kJoinedWords<Method>.data(),
           QT_TR_NOOP("how the motion is computed (closed-form)")},
          {"solve compare render", "max-iterations", "N",
           QT_TR_NOOP("maximum iterations of Newton-Raphson per time step (10)")},
          {"solve compare render", "tolerance", "T",
           QT_TR_NOOP("residual ‖C‖ at which Newton-Raphson stops; 0: when it no longer decreases (1e-8)")},
          {"solve compare render", "tolerance-kind", kJoinedWords<ToleranceKind>.data(),
           QT_TR_NOOP("absolute: ‖C‖ in mm and rad; relative: lengths divided by a + b + |c| (absolute)")}}},
        {QT_TR_NOOP("Files"),
         {{"compare identify", "join", nullptr,
           QT_TR_NOOP("read the files as parts of one motion; column numbers continue from file to file")},
          {"window render", "reference", "FILE",
           QT_TR_NOOP("CSV file of a simulation; may be repeated for several files of one motion")},
          {"compare identify render", "column", "HEADING=MEANING",
           QT_TR_NOOP("overrides the meaning of a column, may be repeated: \"slider.s=R4_x [m]\", \"T=time [ms]\", "
                      "\"#3=ignored\" (the third column). A meaning is time, crank-angle, ignored or a channel; theta2 "
                      "without a time is the crank angle")},
          {"compare identify render", "abscissa", kJoinedWords<FirstColumn>.data(),
           QT_TR_NOOP(
               "whether the first column holds time stamps or crank angles, which --omega2 and --theta20 convert "
               "to time")}}},
        {QT_TR_NOOP("Result"),
         {{"solve", "channels", "LIST",
           QT_TR_NOOP(
               "all, or names separated by commas: theta3,R4_x_diff (all); also transmission_angle, displacement "
               "(from the outer dead centre), A_x and A_y, with _diff and _diff2. The columns have the order of all, "
               "not that of the names")},
          {"limits", "notation", kJoinedWords<Symbols>.data(),
           QT_TR_NOOP("coupler angles in the text: absolute coordinates (θ³ at A), or those of textbooks (θ₃ at B) "
                      "(absolute)")},
          {"render", "notation", kJoinedWords<Symbols>.data(),
           QT_TR_NOOP("symbols in the output: absolute coordinates (θ³, Rₓ⁴), or those of textbooks (θ₃ measured at B, "
                      "x_B, v_B, a_B) (absolute)")},
          {"solve limits render", "angle-unit", kJoinedWords<AngleUnit>.data(),
           QT_TR_NOOP("unit of the angles in the output (deg)")},
          {"solve limits render", "length-unit", kJoinedWords<LengthUnit>.data(),
           QT_TR_NOOP("unit of the lengths in the output (mm)")},
          {"check", "angle-unit", kJoinedWords<AngleUnit>.data(),
           QT_TR_NOOP("unit of the checked angles, if they are written without one (deg)")},
          {"check", "length-unit", kJoinedWords<LengthUnit>.data(),
           QT_TR_NOOP("unit of the checked lengths, if they are written without one (mm); --a, --b and --c "
                      "remain in mm")},
          {"solve", "format", kSomeJoinedWords<OutputFormat::Csv, OutputFormat::Json>.data(),
           QT_TR_NOOP("output format (csv)")},
          {"check identify", "format", kSomeJoinedWords<OutputFormat::Text, OutputFormat::Json>.data(),
           QT_TR_NOOP("output format (text)")},
          {"limits compare study", "format", kJoinedWords<OutputFormat>.data(), QT_TR_NOOP("output format (text)")},
          {"limits", "vary", "NAME=FROM..TO",
           QT_TR_NOOP(
               "a row of limits for each of several values of a parameter: b=50..120 (CSV unless --format json)")},
          {"limits", "count", "N", QT_TR_NOOP("number of values of --vary (100)")},
          {"limits", "design", "LIST",
           QT_TR_NOOP(
               "find the mechanism with this stroke, this time ratio (1) and at least this minimum transmission angle: "
               "stroke=80,time-ratio=1.2,transmission-angle=40; if several are possible, the one with the largest "
               "angle is chosen. With time-ratio alone, and with --a and --b: find the offset c")},
          {"limits", "tolerance", "LIST",
           QT_TR_NOOP(
               "a=0.05,b=0.1,c=0.05: how much each limit may decrease and increase if the lengths deviate by this "
               "much (mm)")},
          {"compare", "fail-on-difference", nullptr, QT_TR_NOOP("exit with status 1 if a channel differs")},
          {"study", "cases", kJoinedWords<CaseChoice>.data(),
           QT_TR_NOOP(
               "nominal: the mechanism of the options; hard: the hard cases; all: ten ordinary cases and the hard "
               "ones; hard and all begin with the mechanism of the options if one is given (nominal)")},
          {"render", "what", "WHAT",
           QT_TR_NOOP(
               "figure (all plots), mechanism, polygons (of velocity and acceleration), frames (the mechanism moving), "
               "report, or one plot: theta3, R4_x, "
               "theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, "
               "error_acceleration (figure)")},
          {"render", "size", "WxH", QT_TR_NOOP("pixels of a picture, instead of --width (frames: 1920x1080)")},
          {"render", "scale", "FACTOR", QT_TR_NOOP("factor of the number of pixels of a PNG, 0.1 to 10 (1)")},
          {"render", "width", "WIDTH",
           QT_TR_NOOP("width of a picture in mm or px, such as 85mm or 1200px; the height follows (160mm, at 300 dots "
                      "per inch)")},
          {"render", "font-size", "SIZE", QT_TR_NOOP("size of the letters in a picture, such as 10pt (9pt)")},
          {"render", "plots", "NAMES",
           QT_TR_NOOP("the plots of the figure, separated by commas: channels, error_position, error_velocity, "
                      "error_acceleration (all)")},
          {"render", "no-cursor", nullptr, QT_TR_NOOP("do not write the values at the time of --at in the plots")},
          {"render", "paper", kJoinedWords<PaperSize>.data(), QT_TR_NOOP("paper of a report (a4)")},
          {"render", "theme", kSomeJoinedWords<Theme::Light, Theme::Dark>.data(), QT_TR_NOOP("colours (light)")},
          {"render", "speed", "FACTOR",
           QT_TR_NOOP("for frames (30 per second): seconds of motion per second of playback (1)")},
          {"render", "output", "FILE",
           QT_TR_NOOP("required: a name that ends in .png, .svg or .pdf; for frames the name of a new folder, or of a "
                      "video that ends in .mp4, .webm or .gif (needs ffmpeg)"),
           "o"},
          {"solve limits check compare identify study", "output", "FILE",
           QT_TR_NOOP("write to this file instead of standard output (-)"), "o"}}},
        {QT_TR_NOOP("Other"),
         {{"window", "reset-settings", nullptr,
           QT_TR_NOOP("remove all settings that the window has stored: layout, recent files, language, notation, "
                      "meanings of columns …")},
          {kEveryCommand, "help", nullptr, QT_TR_NOOP("show this text"), "h"},
          {kEveryCommand, "version", nullptr, QT_TR_NOOP("show the version of the program and of its libraries")}}},
    };
};

static_assert(std::ranges::equal(kCommandNames, Descriptions::kCommands, {}, {},
                                 [](const CommandDescription &command) { return std::string_view(command.name); }));

} // namespace

std::span<const CommandDescription> allCommands()
{
    return Descriptions::kCommands;
}

const CommandDescription &windowDescription()
{
    return allCommands().front();
}

std::span<const CommandDescription> typedCommands()
{
    return allCommands().subspan(1);
}

QStringList commandNames()
{
    QStringList names;
    for (const CommandDescription &command : typedCommands()) {
        names += command.name;
    }
    return names;
}

const CommandDescription *findCommand(const QString &name)
{
    for (const CommandDescription &command : typedCommands()) {
        if (name == QLatin1String(command.name)) {
            return &command;
        }
    }
    return nullptr;
}

std::vector<OptionDescription> optionsOf(const CommandDescription &command)
{
    std::vector<OptionDescription> options;
    for (const OptionGroup &group : Descriptions::kGroups) {
        for (const OptionDescription &option : group.options) {
            if (QString(option.commands.names).split(' ').contains(command.name)) {
                options.push_back(option);
                options.back().group = group.heading;
            }
        }
    }
    return options;
}

} // namespace slidercrank
