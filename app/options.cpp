// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.h"

#include "app/help.h"
#include "app/option_reader.h"
#include "app/window_system.h"
#include "core/import/heading.h"
#include "core/import/quantity.h"
#include "core/sampling/crank_instant.h"
#include "core/study/study.h"
#include "ui/document/byte_stream.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/text/finding_text.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr int kMostSteps = 100'000'000;

Unit unitOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return kMillimetre;
    case Parameter::Omega2: return kRadianPerSecond;
    case Parameter::Theta20: return kRadian;
    }
    return {};
}

Mechanism readMechanism(OptionReader &reader)
{
    Parameters parameters = reader.scene().parameters;
    for (const Parameter parameter : kParameters) {
        double &value = valueOf(parameters, parameter);
        value = reader.number(wordOf(parameter), value, unitOf(parameter));
    }
    parameters.branch =
        reader.choice("branch", parameters.branch, {{"open", Branch::Open}, {"crossed", Branch::Crossed}});
    const std::optional<ParameterFault> fault = findFault(parameters);
    if (!fault) {
        return Mechanism(parameters);
    }
    const char *const name = wordOf(fault->parameter);
    switch (fault->reason) {
    case ParameterFault::Reason::NotFinite: // number() refuses these itself
    case ParameterFault::Reason::TooLarge: reader.refuse(OptionReader::tooLarge(name)); break;
    case ParameterFault::Reason::NotPositive:
        reader.refuse(
            CommandLine::tr("--%1 must be greater than 0, not %2.").arg(QLatin1String(name), reader.text(name)));
        break;
    }
    return {};
}

Sampling readSampling(OptionReader &reader)
{
    Sampling sampling = reader.scene().sampling;
    sampling.start = reader.boundedNumber("start", sampling.start, kSecond);
    sampling.duration = reader.boundedNumber("duration", sampling.duration, kSecond);
    sampling.steps = reader.integer("steps", sampling.steps, 1, kMostSteps);
    if (!(sampling.duration > 0.0)) {
        reader.refuse(CommandLine::tr("--duration must be greater than 0, not %1.").arg(reader.text("duration")));
    }
    // Doubles are coarsest at the end that is farther from 0: if neighbours differ there, they do everywhere.
    const double farthest = std::max(std::abs(sampling.start), std::abs(sampling.start + sampling.duration));
    const double spacing = std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
    if (sampling.duration / sampling.steps < 2.0 * spacing) {
        reader.refuse(CommandLine::tr("The instants lie too close together to be told apart: choose fewer --steps, a "
                                      "longer --duration or a --start nearer to 0."));
    }
    return sampling;
}

SolverSettings readSolver(OptionReader &reader)
{
    SolverSettings solver = reader.scene().solver;
    solver.method =
        reader.choice("method", solver.method, {{"newton", Method::Newton}, {"closed-form", Method::ClosedForm}});
    solver.newton.maxIterations = reader.integer("max-iterations", solver.newton.maxIterations, 1, 1'000'000);
    solver.newton.tolerance = reader.number("tolerance", solver.newton.tolerance);
    if (!(solver.newton.tolerance >= 0.0)) {
        reader.refuse(CommandLine::tr("--tolerance must be 0 or more, not %1.").arg(reader.text("tolerance")));
    }
    solver.newton.toleranceKind =
        reader.choice("tolerance-kind", solver.newton.toleranceKind,
                      {{"absolute", ToleranceKind::Absolute}, {"relative", ToleranceKind::Relative}});
    return solver;
}

/// For --at-angle.
double readCrankInstant(OptionReader &reader, const Mechanism &mechanism, double start)
{
    const double degrees = reader.boundedNumber("at-angle", 0.0, kDegree);
    const double theta2 = std::remainder(degrees, 360.0) / kDegreesPerRadian;
    const std::optional<double> instant = instantAtCrankAngle(mechanism, theta2, start);
    if (!instant && mechanism.omega2() == 0.0) {
        reader.refuse(CommandLine::tr("The crank stands still (--omega2 0) and never comes to %1°: choose another "
                                      "--omega2, or set its angle with --theta20.")
                          .arg(QString::number(degrees, 'g', 6)));
    } else if (!instant || std::abs(*instant) > kLargestParameter) {
        reader.refuse(CommandLine::tr("The crank turns too slowly to come to %1° within 1e12 s: choose a larger "
                                      "--omega2.")
                          .arg(QString::number(degrees, 'g', 6)));
    }
    return instant.value_or(start);
}

ChannelSet readChannels(OptionReader &reader)
{
    if (!reader.has("channels") || reader.text("channels") == u"all") {
        return allChannels();
    }
    ChannelSet channels;
    for (const QString &part : reader.text("channels").split(u',')) {
        const QString name = part.trimmed();
        if (const std::optional<Channel> channel = channelNamed(name.toStdString())) {
            channels.set(indexOf(*channel));
            continue;
        }
        QStringList names;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            names += columnNameOf(channelAt(index));
        }
        const QStringList near = nearest(name, names);
        reader.refuse(near.isEmpty() ? CommandLine::tr("--channels: there is no channel \"%1\"; there are %2.")
                                           .arg(name, names.join(QStringLiteral(", ")))
                                     : CommandLine::tr("--channels: there is no channel \"%1\"; did you mean %2?")
                                           .arg(name, alternatives(near)));
    }
    return channels;
}

/// "R4_x [m]", "time", "ignored": what --column says that a column is.
NamedChoice readMeaning(OptionReader &reader, const QString &meaning)
{
    const Heading heading = parseHeading(meaning.toStdString());
    NamedChoice choice;
    choice.unit = heading.unit;
    std::optional<Unit> wanted;
    if (const std::optional<Channel> channel = channelNamed(heading.name)) {
        choice.role = ColumnRole::Channel;
        choice.channel = *channel;
        wanted = Unit{isAngle(channel->coordinate) ? Dimension::Angle : Dimension::Length,
                      static_cast<int>(channel->order), 1.0};
    } else if (heading.name == "time") {
        choice.role = ColumnRole::Time;
        wanted = kSecond;
    } else if (heading.name == "crank-angle") {
        choice.role = ColumnRole::CrankAngle;
        wanted = kDegree;
    } else if (meaning != u"ignored") {
        QStringList names{QStringLiteral("time"), QStringLiteral("crank-angle"), QStringLiteral("ignored")};
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            names += columnNameOf(channelAt(index));
        }
        const QString name = QString::fromStdString(heading.name);
        const QStringList near = nearest(name, names);
        reader.refuse(near.isEmpty() ? CommandLine::tr("--column: there is no channel \"%1\"; there are %2.")
                                           .arg(name, names.join(QStringLiteral(", ")))
                                     : CommandLine::tr("--column: there is no channel \"%1\"; did you mean %2?")
                                           .arg(name, alternatives(near)));
    }
    const std::optional<Unit> unit = parseUnit(choice.unit);
    const bool suits = unit && wanted && unit->dimension == wanted->dimension && unit->order == wanted->order;
    if (!choice.unit.empty() && !suits) {
        reader.refuse(CommandLine::tr("--column: \"%1\" is no unit of %2.")
                          .arg(QString::fromStdString(choice.unit), QString::fromStdString(heading.name)));
    }
    return choice;
}

/// --abscissa, and --column, any number of times.
std::vector<NamedChoice> readColumns(OptionReader &reader)
{
    std::vector<NamedChoice> choices;
    if (reader.has("abscissa")) {
        const ColumnRole role = reader.choice("abscissa", ColumnRole::Time,
                                              {{"time", ColumnRole::Time}, {"angle", ColumnRole::CrankAngle}});
        choices.push_back({"#1", role, {}, {}});
    }
    for (const QString &text : reader.texts("column")) {
        const qsizetype equals = text.lastIndexOf(u'='); // a heading may hold one, a meaning does not
        if (equals < 1) {
            reader.refuse(
                CommandLine::tr("--column must be a heading, = and what it is, such as \"slider.s=R4_x [m]\", "
                                "\"#1=time\" or \"id=ignored\", not \"%1\".")
                    .arg(text));
            break;
        }
        NamedChoice choice = readMeaning(reader, text.sliced(equals + 1).trimmed());
        choice.heading = text.first(equals).trimmed().toStdString();
        if (std::ranges::find(choices, choice.heading, &NamedChoice::heading) != choices.end()) {
            reader.refuse(CommandLine::tr("--column says twice what \"%1\" is: keep one of them.")
                              .arg(QString::fromStdString(choice.heading)));
        }
        choices.push_back(std::move(choice));
    }
    return choices;
}

void refusePositional(OptionReader &reader, const QStringList &positional, Subcommand subcommand)
{
    if (!positional.isEmpty()) {
        reader.refuse(CommandLine::tr("\"slidercrank %1\" takes options only: remove \"%2\".")
                          .arg(wordOf(subcommand), positional.first()));
    }
}

/// --output, which must be none of the files that are read.
QString readOutputBeside(OptionReader &reader, const QStringList &files)
{
    const QString output = reader.file("output");
    for (const QString &file : files + QStringList(reader.text("scene"))) {
        if (!output.isEmpty() && QFileInfo::exists(output) && QFileInfo(output) == QFileInfo(file)) {
            reader.refuse(CommandLine::tr("--output would overwrite %1, which is to be read: choose another name.")
                              .arg(QDir::toNativeSeparators(file)));
        }
    }
    return output;
}

/// FILE…, and --join
QList<QStringList> readReferences(OptionReader &reader, const QStringList &positional, Subcommand subcommand)
{
    if (positional.isEmpty() || positional.contains(QString())) {
        reader.refuse(CommandLine::tr("\"slidercrank %1\" needs a file: slidercrank %1 FILE…").arg(wordOf(subcommand)));
    }
    if (reader.has("join")) {
        return {positional};
    }
    QList<QStringList> references;
    for (const QString &file : positional) {
        references += QStringList(file);
    }
    return references;
}

Command readSolve(OptionReader &reader, const QStringList &positional)
{
    SolveOptions options;
    options.mechanism = readMechanism(reader);
    if (reader.has("at-angle")) {
        for (const char *name : {"steps", "duration"}) {
            if (reader.has(name)) {
                reader.refuse(CommandLine::tr("--at-angle asks for one instant and --%1 for a run: remove one of them.")
                                  .arg(QLatin1String(name)));
            }
        }
        options.atInstant = readCrankInstant(reader, options.mechanism,
                                             reader.boundedNumber("start", reader.scene().sampling.start, kSecond));
    } else {
        options.sampling = readSampling(reader);
    }
    options.solver = readSolver(reader);
    options.channels = readChannels(reader);
    options.angleUnit =
        reader.choice("angle-unit", options.angleUnit, {{"deg", AngleUnit::Degree}, {"rad", AngleUnit::Radian}});
    options.format = reader.choice("format", options.format, {{"csv", Format::Csv}, {"json", Format::Json}});
    options.output = readOutputBeside(reader, {});
    refusePositional(reader, positional, Subcommand::Solve);
    return options;
}

Command readLimits(OptionReader &reader, const QStringList &positional)
{
    LimitsOptions options;
    options.mechanism = readMechanism(reader);
    options.format =
        reader.choice("format", options.format, {{"text", Format::Text}, {"csv", Format::Csv}, {"json", Format::Json}});
    options.output = readOutputBeside(reader, {});
    refusePositional(reader, positional, Subcommand::Limits);
    return options;
}

Command readCompare(OptionReader &reader, const QStringList &positional)
{
    CompareOptions options;
    options.mechanism = readMechanism(reader);
    options.format =
        reader.choice("format", options.format, {{"text", Format::Text}, {"csv", Format::Csv}, {"json", Format::Json}});
    options.failOnDifference = reader.has("fail-on-difference");
    options.references = readReferences(reader, positional, Subcommand::Compare);
    options.columns = readColumns(reader);
    options.output = readOutputBeside(reader, positional);
    return options;
}

Command readIdentify(OptionReader &reader, const QStringList &positional)
{
    IdentifyOptions options;
    options.mechanism = readMechanism(reader);
    options.format = reader.choice("format", options.format, {{"text", Format::Text}, {"json", Format::Json}});
    options.references = readReferences(reader, positional, Subcommand::Identify);
    options.columns = readColumns(reader);
    options.output = readOutputBeside(reader, positional);
    return options;
}

enum class StudyCases { Nominal, Hard, All };

Command readStudy(OptionReader &reader, const QStringList &positional)
{
    StudyOptions options;
    const Mechanism mechanism = readMechanism(reader);
    const StudyCases cases =
        reader.choice("cases", StudyCases::Nominal,
                      {{"nominal", StudyCases::Nominal}, {"hard", StudyCases::Hard}, {"all", StudyCases::All}});
    const bool asksForMechanism = mechanism != Mechanism();
    if (cases == StudyCases::Nominal || asksForMechanism) {
        options.cases.push_back(studyCase(mechanism.parameters()));
    }
    if (cases == StudyCases::All) {
        std::ranges::copy(nominalCases(), std::back_inserter(options.cases));
    }
    if (cases != StudyCases::Nominal) {
        std::ranges::copy(hardCases(), std::back_inserter(options.cases));
    }
    options.format =
        reader.choice("format", options.format, {{"text", Format::Text}, {"csv", Format::Csv}, {"json", Format::Json}});
    options.output = readOutputBeside(reader, {});
    refusePositional(reader, positional, Subcommand::Study);
    return options;
}

std::optional<QSize> parsedSize(const QString &text)
{
    const QStringList sides = text.split(u'x');
    if (sides.size() != 2) {
        return std::nullopt;
    }
    const std::optional<int> width = parsedInteger(sides[0]);
    const std::optional<int> height = parsedInteger(sides[1]);
    return width && height ? std::optional(QSize(*width, *height)) : std::nullopt;
}

void readSubject(OptionReader &reader, RenderOptions &options)
{
    using Subject = RenderOptions::Subject;
    const QString what = reader.has("what") ? reader.text("what") : QStringLiteral("figure");
    QStringList plots;
    for (const Channel channel : kPlottedChannels) {
        plots += columnNameOf(channel);
    }
    plots += {QStringLiteral("error_position"), QStringLiteral("error_velocity"), QStringLiteral("error_acceleration")};
    if (what == u"figure") {
        options.subject = Subject::Figure;
        options.size = QSize(1400, 1800);
    } else if (what == u"report") {
        options.subject = Subject::Report;
    } else if (what == u"mechanism" || what == u"frames") {
        options.subject = what == u"frames" ? Subject::Frames : Subject::Mechanism;
        options.size = QSize(900, 700);
    } else if (plots.contains(what)) {
        options.subject = Subject::Plot;
        options.plot = what;
        options.size = QSize(900, 600);
    } else {
        reader.refuse(CommandLine::tr("--what must be figure, mechanism, frames, report or one of the plots %1, not "
                                      "\"%2\".")
                          .arg(alternatives(plots), what));
    }
}

/// Where --output names no file that the subject can be written to.
void refuseOutput(OptionReader &reader, const RenderOptions &options)
{
    using Subject = RenderOptions::Subject;
    const std::optional<FigureFormat> format = figureFormatOf(options.output);
    if (options.output.isEmpty()) {
        reader.refuse(
            CommandLine::tr("\"slidercrank render\" needs --output with a name that ends in .png, .svg or .pdf."));
    } else if (options.subject == Subject::Frames) {
        if (format) {
            reader.refuse(CommandLine::tr("Frames are written to a folder or as a video: --output must name a new "
                                          "folder or end in .mp4, .webm or .gif, not be \"%1\".")
                              .arg(options.output));
        }
    } else if (options.subject == Subject::Report && format != FigureFormat::Pdf) {
        reader.refuse(
            CommandLine::tr("A report is a PDF: --output must end in .pdf, not be \"%1\".").arg(options.output));
    } else if (!format) {
        reader.refuse(CommandLine::tr("--output must end in .png, .svg or .pdf, not be \"%1\".").arg(options.output));
    }
}

/// Frames show the run at its own pace; everything else one instant.
void readPace(OptionReader &reader, RenderOptions &options)
{
    const bool hasFrames = options.subject == RenderOptions::Subject::Frames;
    if (reader.has("speed") && !hasFrames) {
        reader.refuse(CommandLine::tr("--speed is of --what frames: remove it."));
    }
    for (const char *name : {"at", "at-angle"}) {
        if (reader.has(name) && hasFrames) {
            reader.refuse(CommandLine::tr("Frames show the whole run: remove --%1, or choose the run with --start and "
                                          "--duration.")
                              .arg(QLatin1String(name)));
        }
    }
    options.speed = reader.number("speed", options.speed);
    if (!(options.speed > 0.0)) {
        reader.refuse(CommandLine::tr("--speed must be greater than 0, not %1.").arg(reader.text("speed")));
    }
    Animation animation;
    animation.duration = options.sampling.duration;
    animation.speed = options.speed;
    if (hasFrames && animation.frameCount() > Animation::kMostFrames) {
        reader.refuse(CommandLine::tr("There would be more than %1 frames: choose a shorter --duration or a greater "
                                      "--speed.")
                          .arg(Animation::kMostFrames));
    }
}

Command readRender(OptionReader &reader, const QStringList &positional)
{
    RenderOptions options;
    readSubject(reader, options);
    options.output = readOutputBeside(reader, reader.texts("reference"));
    refuseOutput(reader, options);
    options.mechanism = readMechanism(reader);
    options.sampling = readSampling(reader);
    options.solver = readSolver(reader);
    options.reference = reader.scene().reference;
    if (const QStringList files = reader.files("reference"); !files.isEmpty()) {
        options.reference = ReferenceSource{files, {}, {}};
    }
    options.kept = reader.scene().kept;
    options.columns = readColumns(reader);
    if (!options.columns.empty() && !options.reference) {
        reader.refuse(CommandLine::tr("--column is of a reference: give its file with --reference."));
    }
    options.plots = reader.scene().plots;
    options.zoom = reader.scene().zoom;
    options.mechanismSettings = reader.scene().mechanism;
    options.mechanismFrame = reader.scene().mechanismFrame;
    options.theme = reader.choice("theme", options.theme, {{"light", Theme::Light}, {"dark", Theme::Dark}});

    if (options.subject == RenderOptions::Subject::Report) {
        for (const char *name : {"size", "scale", "theme"}) {
            if (reader.has(name)) {
                reader.refuse(
                    CommandLine::tr("A report is always on A4, black on white: remove --%1.").arg(QLatin1String(name)));
            }
        }
    }

    // What a PNG can hold, and a little less than what a person could have meant.
    constexpr int kLargestSide = 20'000;
    if (reader.has("size")) {
        const std::optional<QSize> size = parsedSize(reader.text("size"));
        if (size && std::min(size->width(), size->height()) >= 100 &&
            std::max(size->width(), size->height()) <= kLargestSide) {
            options.size = *size;
        } else {
            reader.refuse(CommandLine::tr("--size must be width x height in pixels, each from 100 to %1, such as "
                                          "900x600, not \"%2\".")
                              .arg(kLargestSide)
                              .arg(reader.text("size")));
        }
    }
    options.scale = reader.number("scale", options.scale);
    if (!(options.scale >= 0.1 && options.scale <= 10.0)) {
        reader.refuse(CommandLine::tr("--scale must be from 0.1 to 10, not %1.").arg(reader.text("scale")));
    }
    if (options.scale * std::max(options.size.width(), options.size.height()) > kLargestSide) {
        reader.refuse(CommandLine::tr("The picture would be larger than %1 pixels: choose a smaller --size or --scale.")
                          .arg(kLargestSide));
    }

    readPace(reader, options);
    const double end = options.sampling.start + options.sampling.duration;
    options.poseInstant =
        reader.has("scene") ? std::clamp(reader.scene().time, options.sampling.start, end) : options.sampling.start;
    if (reader.has("at") && reader.has("at-angle")) {
        reader.refuse(CommandLine::tr("--at and --at-angle both choose the instant: remove one of them."));
    } else if (reader.has("at")) {
        options.poseInstant = reader.boundedNumber("at", 0.0, kSecond);
    } else if (reader.has("at-angle")) {
        options.poseInstant = readCrankInstant(reader, options.mechanism, options.sampling.start);
    }
    if (options.subject != RenderOptions::Subject::Mechanism &&
        (options.poseInstant < options.sampling.start || options.poseInstant > end)) {
        reader.refuse(CommandLine::tr("The cursor's instant, t = %1 s, lies outside the run from %2 s to %3 s: choose "
                                      "another instant, or another --start or --duration.")
                          .arg(QString::number(options.poseInstant, 'g', 6),
                               QString::number(options.sampling.start, 'g', 6), QString::number(end, 'g', 6)));
    }
    refusePositional(reader, positional, Subcommand::Render);
    return options;
}

/// What is no file of a motion.
void refuseAmong(OptionReader &reader, const QStringList &files)
{
    for (const QString &file : files) {
        if (isNamedAsScene(file)) {
            reader.refuse(CommandLine::tr("%1 is a scene: open it by itself, and files of one motion together.")
                              .arg(QDir::toNativeSeparators(file)));
        } else if (!QFileInfo::exists(file)) {
            reader.refuseFile(CommandLine::tr("There is no file %1.").arg(QDir::toNativeSeparators(file)));
        }
    }
}

Command readWindow(OptionReader &reader, const QStringList &positional, bool choosesDisplay)
{
    if (reader.has("reset-settings")) {
        if (!positional.isEmpty() || reader.has("reference")) {
            reader.refuse(CommandLine::tr("--reset-settings opens no window: remove what stands beside it."));
        }
        return ResetSettings{};
    }
    WindowOptions options;
    options.choosesDisplay = choosesDisplay;
    options.reference = reader.files("reference");
    if ((options.reference + positional).contains(QStringLiteral("-"))) {
        reader.refuse(CommandLine::tr("The window opens files: save what comes from standard input as one first."));
        return options;
    }
    if (positional.isEmpty()) {
        return options;
    }
    options.scene = positional.first();
    const QStringList words{QStringLiteral("solve"),    QStringLiteral("limits"), QStringLiteral("compare"),
                            QStringLiteral("identify"), QStringLiteral("study"),  QStringLiteral("render")};
    const bool isFile = isNamedAsScene(options.scene) || QFileInfo::exists(options.scene);
    if (words.contains(options.scene)) {
        reader.refuse(CommandLine::tr("The command must come first: slidercrank %1 …").arg(options.scene));
    } else if (!isFile && options.scene.contains(QRegularExpression(QStringLiteral("[./\\\\]")))) {
        reader.refuseFile(CommandLine::tr("There is no file %1.").arg(QDir::toNativeSeparators(options.scene)));
    } else if (!isFile) {
        reader.refuse(
            CommandLine::tr("There is no command \"%1\": use solve, limits, compare, identify, study or render, or "
                            "no word at all, or a scene's file, for the window.")
                .arg(options.scene));
    } else if (!isNamedAsScene(options.scene) && options.reference.isEmpty()) { // as what is dropped on the window
        options.scene.clear();
        options.reference = positional;
        refuseAmong(reader, positional);
    } else if (positional.size() > 1) {
        reader.refuse(CommandLine::tr("The window opens one scene, not %1: remove \"%2\".")
                          .arg(positional.size())
                          .arg(positional[1]));
    } else if (!isPipeOrDevice(QFileInfo(options.scene))) { // which the window refuses
        reader.takeScene(options.scene);                    // to know before there is a window whether it is one
    }
    return options;
}

QString helpHint(Subcommand subcommand)
{
    return subcommand == Subcommand::Window
               ? CommandLine::tr("\"slidercrank --help\" lists them.")
               : CommandLine::tr("\"slidercrank %1 --help\" lists them.").arg(wordOf(subcommand));
}

/// What is wrong with the shape of the line: unknown, repeated or unfinished options.
std::optional<QString> shapeFault(const QCommandLineParser &parser, bool wellFormed, const QStringList &arguments,
                                  const std::vector<OptionGroup> &groups, Subcommand subcommand)
{
    if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty()) {
        const QString &name = unknown.first();
        QStringList names;
        for (const OptionGroup &group : groups) {
            for (const OptionEntry &entry : group.entries) {
                names += QStringLiteral("--") + QLatin1String(entry.name);
            }
        }
        const auto typed = std::find_if(arguments.begin(), arguments.end(), [&](const QString &argument) {
            const QString word = argument.section(u'=', 0, 0);
            return word == u'-' + name || word == QStringLiteral("--") + name;
        });
        const QString shown = typed == arguments.end() ? name : typed->section(u'=', 0, 0);
        const QStringList near = nearest(shown, names);
        const QString what = CommandLine::tr("There is no option %1 here").arg(shown);
        return near.isEmpty() ? what + QStringLiteral(": ") + helpHint(subcommand)
                              : CommandLine::tr("%1; did you mean %2?").arg(what, alternatives(near));
    }
    for (const OptionGroup &group : groups) {
        for (const OptionEntry &entry : group.entries) {
            const QLatin1String name(entry.name);
            if (!entry.mayRepeat && parser.optionNames().count(name) > 1) {
                return CommandLine::tr("--%1 is given more than once: keep one of them.").arg(name);
            }
            if (!wellFormed && entry.value &&
                (arguments.last() == QStringLiteral("--") + name || arguments.last() == u'-' + name)) {
                return CommandLine::tr("--%1 needs a value: --%1 %2.").arg(name, QLatin1String(entry.value));
            }
        }
    }
    return wellFormed ? std::nullopt : std::optional(parser.errorText());
}

} // namespace

Command parseCommandLine(const QStringList &arguments)
{
    Subcommand subcommand = Subcommand::Window;
    for (const Subcommand candidate : {Subcommand::Solve, Subcommand::Limits, Subcommand::Compare, Subcommand::Identify,
                                       Subcommand::Study, Subcommand::Render}) {
        if (arguments.size() > 1 && arguments[1] == wordOf(candidate)) {
            subcommand = candidate;
        }
    }
    QStringList rest = subcommand == Subcommand::Window ? withoutWindowSystemOptions(arguments) : arguments;
    if (subcommand != Subcommand::Window) {
        rest.removeAt(1);
    }

    const std::vector<OptionGroup> groups = optionGroupsOf(subcommand);
    QCommandLineParser parser;
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    for (const OptionGroup &group : groups) {
        for (const OptionEntry &entry : group.entries) {
            parser.addOption(QCommandLineOption(QLatin1String(entry.name), QString(), QLatin1String(entry.value)));
        }
    }
    const bool wellFormed = parser.parse(rest); // process() would end the program by itself
    if (parser.isSet(QStringLiteral("help"))) {
        return Answer{helpOf(subcommand)};
    }
    if (const std::optional<QString> fault = shapeFault(parser, wellFormed, rest, groups, subcommand)) {
        return WrongCommandLine{*fault};
    }
    if (parser.isSet(QStringLiteral("version"))) {
        return Answer{QStringLiteral("slidercrank " SLIDERCRANK_VERSION "\n" SLIDERCRANK_BUILT_OF "\n")};
    }

    OptionReader reader(parser);
    const QStringList positional = parser.positionalArguments();
    if ((positional + reader.texts("scene") + reader.texts("reference")).count(QStringLiteral("-")) > 1) {
        return WrongCommandLine{CommandLine::tr("Standard input can be read only once: give one \"-\".")};
    }
    if (subcommand != Subcommand::Window && reader.has("scene")) {
        reader.takeScene(reader.file("scene"));
    }
    Command command;
    switch (subcommand) {
    case Subcommand::Window: command = readWindow(reader, positional, chooseDisplay(arguments)); break;
    case Subcommand::Solve: command = readSolve(reader, positional); break;
    case Subcommand::Limits: command = readLimits(reader, positional); break;
    case Subcommand::Compare: command = readCompare(reader, positional); break;
    case Subcommand::Identify: command = readIdentify(reader, positional); break;
    case Subcommand::Study: command = readStudy(reader, positional); break;
    case Subcommand::Render: command = readRender(reader, positional); break;
    }
    if (reader.fileFault()) {
        return UnreadableFile{*reader.fileFault()};
    }
    if (reader.fault()) {
        return WrongCommandLine{*reader.fault()};
    }
    return command;
}

} // namespace slidercrank
