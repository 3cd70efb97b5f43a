// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank render`: draws what the window shows into a file, by the views of the window.

#include "app/commands.h"
#include "app/reference_files.h"
#include "app/time_step_report.h"
#include "core/identification/diagnosis.h"
#include "ui/document/result.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/window/ghost.h"

#include <QMimeDatabase>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <memory>

namespace slidercrank
{

namespace
{

enum class Subject { Figure, Mechanism, Report, Frames, Plot };

struct RenderRequest {
    Subject subject = Subject::Figure;
    QString plot;        ///< for Subject::Plot: its name in PlotGrid; empty: all plots
    Scene scene;         ///< the settings and the time that is drawn
    Animation animation; ///< for Subject::Frames; its size is that of every picture
    Theme theme = Theme::Light;
    QString output;
};

/// Reads --what.
void readSubject(const OptionReader &options, RenderRequest &request)
{
    QStringList names{"figure", "mechanism", "report", "frames"};
    const qsizetype firstPlot = names.size();
    for (const Channel channel : kPlottedChannels) {
        names += columnName(channel);
    }
    names += {"error_position", "error_velocity", "error_acceleration"};
    const qsizetype index = options.has("what") ? indexAmong(names, options.text("what"), "what") : 0;
    request.subject = static_cast<Subject>(std::min(index, firstPlot));
    request.plot = index < firstPlot ? QString() : "plot_" + names[index];
    constexpr std::array kSizes{QSize(1400, 1800), QSize(900, 700), QSize(), QSize(900, 700),
                                QSize(900, 600)}; // by Subject
    request.animation.size.size = kSizes[static_cast<std::size_t>(request.subject)];
}

/// Reads --size and --scale.
void readSize(const OptionReader &options, FigureSize &size)
{
    constexpr int kLargestSide = 20'000; // pixels
    if (options.has("size")) {
        const QStringList sides = options.text("size").split('x');
        size.size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
    }
    size.scale = options.number("scale", 1.0, {}, 0.1, 10.0);
    const auto [shorter, longer] = std::minmax({size.size.width(), size.size.height()});
    if (shorter < 100 || size.scale * longer > kLargestSide) {
        throw UsageError{CommandLine::tr("--size must be width x height in pixels, such as 900x600, each at least 100, "
                                         "and at most %1 when multiplied by --scale, not \"%2\".")
                             .arg(QString::number(kLargestSide), options.text("size"))};
    }
}

/// Reads --output, and checks that it suits the subject.
void readTarget(const OptionReader &options, RenderRequest &request)
{
    request.output = readOutput(options);
    const std::optional<FigureFormat> format = figureFormat(request.output);
    const QString type = QMimeDatabase().mimeTypeForFile(request.output, QMimeDatabase::MatchExtension).name();
    const bool isFolder = !request.output.isEmpty() && !format && !type.contains(QRegularExpression("^video|^image"));
    const bool isSuitable = request.subject == Subject::Frames   ? isFolder || isVideo(request.output)
                            : request.subject == Subject::Report ? format == FigureFormat::Pdf
                                                                 : format.has_value();
    if (!isSuitable) {
        throw UsageError{
            CommandLine::tr("--output must be a name that ends in .png, .svg or .pdf (report: .pdf; frames: a "
                            "new folder, .mp4, .webm or .gif), not \"%1\".")
                .arg(request.output)};
    }
}

/// Reads --speed, --at and --at-angle.
void readTime(const OptionReader &options, RenderRequest &request)
{
    const Sampling &sampling = request.scene.sampling;
    const double end = sampling.start + sampling.duration;
    request.animation.start = sampling.start;
    request.animation.duration = sampling.duration;
    request.animation.speed = options.number("speed", 1.0, {}, 1e-9);
    if (request.subject == Subject::Frames) {
        options.refuse(
            {"at", "at-angle"},
            CommandLine::tr(
                "Frames show the whole time range: remove %1, or choose the range with --start and --duration."));
        if (request.animation.frameCount() > Animation::kMostFrames) {
            throw UsageError{
                CommandLine::tr("There would be more than %1 frames: choose a shorter --duration or a greater --speed.")
                    .arg(Animation::kMostFrames)};
        }
    } else {
        options.refuse({"speed"}, CommandLine::tr("Only --what frames has a speed: remove %1."));
    }
    double &time = request.scene.time;
    time = options.has("scene") ? std::clamp(time, sampling.start, end) : sampling.start;
    time = readTimeStamp(options, Mechanism(request.scene.parameters)).value_or(time);
    if (request.subject != Subject::Mechanism && (time < sampling.start || time > end)) {
        throw UsageError{CommandLine::tr("t = %1 s lies outside the time range from %2 s to %3 s: choose another time, "
                                         "or another --start or --duration.")
                             .arg(numberText(time), numberText(sampling.start), numberText(end))};
    }
}

RenderRequest readRequest(const OptionReader &options)
{
    RenderRequest request;
    readSubject(options, request);
    readTarget(options, request);
    request.scene = options.scene();
    request.scene.parameters = readMechanism(options).parameters();
    request.scene.sampling = readSampling(options);
    request.scene.solver = readSolver(options);
    if (const QStringList files = options.texts("reference"); !files.isEmpty()) {
        request.scene.reference = ReferenceSource{files, {}, {}};
    }
    request.theme = options.word("theme", "light") == u"light" ? Theme::Light : Theme::Dark;
    if (request.subject == Subject::Report) {
        options.refuse({"size", "scale", "theme"},
                       CommandLine::tr("A report is printed on A4, black on white: remove %1."));
    } else {
        readSize(options, request.animation.size);
    }
    readTime(options, request);
    options.refuseFiles();
    return request;
}

/// Draws the subject into the file, by the plots and the drawing of the window. Returns a sentence if that fails.
std::optional<QString> draw(const RenderRequest &request, const std::shared_ptr<const Result> &result)
{
    const Scene &scene = request.scene;
    const QPalette palette = paletteFor(request.theme);
    const bool showsMechanism = request.subject != Subject::Figure && request.subject != Subject::Plot;
    ReportContent content{.result = result, .diagnosis = {}};
    if (result->reference && showsMechanism) {
        content.diagnosis = diagnose(result->reference->data, result->mechanism);
    }
    PlotGrid plots;
    plots.setSettings(scene.plots);
    plots.setResult(result);
    plots.setZoom(scene.zoom);
    if (scene.time != scene.sampling.start) {
        plots.markTime(scene.time);
    }
    MechanismView mechanism;
    mechanism.setResult(result);
    mechanism.setSettings(scene.mechanism);
    mechanism.setZoom(scene.mechanismFrame);
    const GhostMotion ghost = findGhost(*result, &content.diagnosis);
    mechanism.setGhostBounds(ghost.bounds);
    const FrameDrawing drawFrame = [&](QPainter &painter, const QSize &size, double time) {
        mechanism.setPose(poseAt(scene.parameters, time));
        mechanism.setGhost(ghost.pose ? ghost.pose(time) : ReferencePose());
        mechanism.paintMechanism(painter, size, palette);
    };
    const FigureDrawing drawMechanism = [&](QPainter &painter, const QSize &size) {
        drawFrame(painter, size, scene.time);
    };
    const FigureDrawing drawFigure = [&](QPainter &painter, const QSize &size) {
        plots.paintFigure(painter, request.plot, size, palette);
    };
    const auto write = [&](const FigureDrawing &drawing) {
        return exportFigure(request.output, request.animation.size, CommandLine::tr("Motion of an offset slider-crank"),
                            withParameters(drawing, result->mechanism, palette));
    };
    switch (request.subject) {
    case Subject::Figure:
    case Subject::Plot: return write(drawFigure);
    case Subject::Mechanism: return write(drawMechanism);
    case Subject::Frames:
        return exportAnimation(request.output, request.animation, drawFrame, [](int) { return true; });
    case Subject::Report: return exportReport(request.output, content, drawMechanism, drawFigure);
    }
    return std::nullopt;
}

} // namespace

ExitStatus renderCommand(const OptionReader &options, const Streams &streams)
{
    RenderRequest request = readRequest(options);
    Scene &scene = request.scene;
    const std::vector<ColumnChoice> columns = readColumns(options);
    if (!scene.reference) {
        options.refuse({"column", "abscissa"},
                       CommandLine::tr("%1 describes a reference file: name the file with --reference."));
    }
    if (request.subject == Subject::Mechanism) {
        scene.sampling.start = scene.time; // the mechanism can be drawn at any time
    }
    Choices choices{scene.parameters, scene.sampling, scene.solver, nullptr, scene.pinned};
    if (scene.reference) {
        choices.reference = readTimedReference(streams, *scene.reference, columns, Mechanism(scene.parameters));
        if (!choices.reference) {
            return ExitStatus::FileError;
        }
    }
    const std::shared_ptr<const Result> result = compute(choices, {});
    if (const std::optional<QString> problem = draw(request, result)) {
        streams.report(*problem);
        return ExitStatus::FileError;
    }
    SamplingSummary summary = result->summary;
    summary.add(result->atReference.summary);
    if (request.subject == Subject::Mechanism) {
        summary = sample(result->mechanism, {scene.time}, ChannelSet(), {}).summary;
    }
    return reportTimeSteps(streams, summary, result->mechanism, result->solver.newton);
}

} // namespace slidercrank
