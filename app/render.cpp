// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank render`: draws what the window shows into a file, by the views of the window.

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/reference_files.h"
#include "app/time_step_report.h"
#include "core/comparison/reference_pose.h"
#include "core/identification/diagnosis.h"
#include "ui/document/result.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_scene.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"

#include <QFileInfo>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <csignal>
#include <memory>
#include <span>

namespace slidercrank
{

namespace
{

enum class Subject { Figure, Mechanism, Report, Frames, Plot };

constexpr int kLargestSide = 20'000; // pixels

struct RenderRequest {
    Subject subject = Subject::Figure;
    QString plot;        ///< for Subject::Plot: the name of a channel, or error_position, error_velocity …
    Scene scene;         ///< supplies the settings of the views
    Choices model;       ///< what is drawn
    double time = 0.0;   ///< s, at which the mechanism is drawn and the plots are marked
    Animation animation; ///< for Subject::Frames; its size is that of every picture
    Theme theme = Theme::Light;
    QString output;
};

/// Reads --what.
void readSubject(const OptionReader &options, RenderRequest &request)
{
    request.plot = options.has("what") ? options.text("what") : "figure";
    QStringList plots{"error_position", "error_velocity", "error_acceleration"};
    for (const Channel channel : kPlottedChannels) {
        plots += columnNameOf(channel);
    }
    const qsizetype index = QStringList{"figure", "mechanism", "report", "frames"}.indexOf(request.plot);
    if (index < 0 && !plots.contains(request.plot)) {
        throw UsageError{
            CommandLine::tr("--what must be figure, mechanism, frames, report or one of the plots %1, not \"%2\".")
                .arg(joinedByOr(plots), request.plot)};
    }
    request.subject = index < 0 ? Subject::Plot : static_cast<Subject>(index);
    constexpr std::array kSizes{QSize(1400, 1800), QSize(900, 700), QSize(), QSize(900, 700),
                                QSize(900, 600)}; // by Subject
    request.animation.size.size = kSizes[static_cast<std::size_t>(request.subject)];
}

/// Reads --size and --scale.
void readSize(const OptionReader &options, FigureSize &size)
{
    if (options.has("size")) {
        static const QRegularExpression syntax("^(\\d{3,5})x(\\d{3,5})$");
        const QRegularExpressionMatch match = syntax.match(options.text("size"));
        if (!match.hasMatch()) {
            throw UsageError{CommandLine::tr("--size must be width x height in pixels, each from 100 to %1, such as "
                                             "900x600, not \"%2\".")
                                 .arg(QString::number(kLargestSide), options.text("size"))};
        }
        size.size = QSize(match.captured(1).toInt(), match.captured(2).toInt());
    }
    size.scale = options.number("scale", 1.0);
    if (!(size.scale >= 0.1 && size.scale <= 10.0)) {
        throw UsageError{CommandLine::tr("--scale must be from 0.1 to 10, not %1.").arg(options.text("scale"))};
    }
    if (size.scale * std::max(size.size.width(), size.size.height()) > kLargestSide) {
        throw UsageError{
            CommandLine::tr("The picture would be larger than %1 pixels: choose a smaller --size or --scale.")
                .arg(kLargestSide)};
    }
}

/// Throws unless the name of the output suits the subject.
void checkOutput(const RenderRequest &request)
{
    const std::optional<FigureFormat> format = figureFormatOf(request.output);
    if (request.output.isEmpty()) {
        throw UsageError{
            CommandLine::tr("\"slidercrank render\" needs --output with a name that ends in .png, .svg or .pdf.")};
    }
    if (request.subject == Subject::Report && format != FigureFormat::Pdf) {
        throw UsageError{
            CommandLine::tr("A report is a PDF: --output must end in .pdf, not \"%1\".").arg(request.output)};
    }
    if (request.subject == Subject::Frames && format) {
        throw UsageError{
            CommandLine::tr("Frames are written to a new folder or as a video: --output must not end in .%1.")
                .arg(QFileInfo(request.output).suffix())};
    }
    if (request.subject != Subject::Frames && !format) {
        throw UsageError{CommandLine::tr("--output must end in .png, .svg or .pdf, not \"%1\".").arg(request.output)};
    }
}

/// Reads --speed for frames, and --at and --at-angle for everything else.
void readTime(const OptionReader &options, RenderRequest &request)
{
    const Sampling &sampling = request.model.sampling;
    const double end = sampling.start + sampling.duration;
    if (request.subject == Subject::Frames) {
        request.animation.start = sampling.start;
        request.animation.duration = sampling.duration;
        options.refuse(
            {"at", "at-angle"},
            CommandLine::tr(
                "Frames show the whole time range: remove %1, or choose the range with --start and --duration."));
        request.animation.speed = options.positiveNumber("speed", 1.0);
        if (request.animation.frameCount() > Animation::kMostFrames) {
            throw UsageError{
                CommandLine::tr("There would be more than %1 frames: choose a shorter --duration or a greater --speed.")
                    .arg(Animation::kMostFrames)};
        }
    } else {
        options.refuse({"speed"}, CommandLine::tr("Only --what frames has a speed: remove %1."));
    }
    const double sceneTime =
        options.has("scene") ? std::clamp(request.scene.time, sampling.start, end) : sampling.start;
    request.time = readTimeStamp(options, Mechanism(request.model.parameters), sampling.start).value_or(sceneTime);
    if (request.subject != Subject::Mechanism && (request.time < sampling.start || request.time > end)) {
        throw UsageError{CommandLine::tr("t = %1 s lies outside the time range from %2 s to %3 s: choose another time, "
                                         "or another --start or --duration.")
                             .arg(roundedText(request.time, 6), roundedText(sampling.start, 6), roundedText(end, 6))};
    }
}

volatile std::sig_atomic_t interruption = 0; // the signal that asked the program to end, or 0

/// Sets the handler of the signals that ask the program to end, except those that are ignored, as under nohup.
void handleTermination(void (*handler)(int))
{
    for (const int signal : {
             SIGINT,
             SIGTERM,
#ifdef SIGHUP
             SIGHUP,
#endif
         }) {
        if (std::signal(signal, SIG_IGN) != SIG_IGN) {
            std::signal(signal, handler);
        }
    }
}

/// Writes frames or a video. Returns a sentence if that fails. If a signal asks the program to end, this function
/// removes what it has written and ends the program.
std::optional<QString> exportFrames(const RenderRequest &request, const FrameDrawing &draw)
{
    handleTermination([](int signal) { interruption = signal; });
    const std::optional<QString> problem =
        exportAnimation(request.output, request.animation, draw, [](int) { return interruption == 0; });
    handleTermination(SIG_DFL);
    if (const int signal = interruption; signal != 0) {
        std::raise(signal); // reports the signal to the parent process
    }
    return problem;
}

ExitStatus reportTimeSteps(const Streams &streams, const RenderRequest &request, const Result &result)
{
    TimeStepReport steps;
    const auto add = [&steps](const Trajectory &motion) {
        steps.add(motion.time, motion.status);
        return true;
    };
    if (request.subject == Subject::Frames) {
        std::vector<double> times;
        for (int frame = 0; frame < request.animation.frameCount(); ++frame) {
            times.push_back(request.animation.timeOfFrame(frame));
        }
        add(sample(result.mechanism, times, {}, {}));
    } else if (request.subject == Subject::Mechanism) {
        add(sample(result.mechanism, {request.time}, {}, {}));
    } else {
        sampleInPieces(result.mechanism, result.sampling, {}, result.solver, add);
        add(result.atReference);
    }
    return steps.finish(streams, result.mechanism, result.solver.newton);
}

/// The plots and the drawing of the window, as the request asks for them.
class Views
{
public:
    Views(const RenderRequest &request, const std::shared_ptr<const Result> &result)
        : m_request(request)
        , m_palette(paletteFor(request.theme))
    {
        m_content.result = result;
        m_plots.setSettings(request.scene.plots);
        m_plots.setResult(result);
        m_plots.setZoom(request.scene.zoom);
        if (request.time != request.model.sampling.start) {
            m_plots.markTime(request.time);
        }
        m_mechanism.setResult(result);
        m_mechanism.setSettings(request.scene.mechanism);
        m_mechanism.setZoom(request.scene.mechanismFrame);
        chooseGhost();
        showTime(request.time);
        m_content.hasGhost = m_mechanism.hasGhost();
    }

    /// Draws the subject into the file. Returns a sentence if that fails.
    std::optional<QString> draw()
    {
        const FigureDrawing figure = [this](QPainter &painter, const QSize &size) {
            m_plots.paintFigure(painter, size, m_palette);
        };
        const FigureDrawing drawing = [this](QPainter &painter, const QSize &size) {
            m_mechanism.paintMechanism(painter, size, m_palette);
        };
        const FigureDrawing plot = [this](QPainter &painter, const QSize &size) {
            m_plots.paintPlot(painter, "plot_" + m_request.plot, size, m_palette);
        };
        switch (m_request.subject) {
        case Subject::Figure: return drawInto(figure);
        case Subject::Plot: return drawInto(plot);
        case Subject::Mechanism: return drawInto(withParameters(drawing, m_content.result->mechanism, m_palette));
        case Subject::Report:
            m_content.checksums =
                m_content.result->reference ? fileChecksums(*m_content.result->reference) : QByteArrayList();
            return exportReport(m_request.output, m_content, {drawing, figure});
        case Subject::Frames:
            return exportFrames(m_request, [this](QPainter &painter, const QSize &size, double time) {
                showTime(time);
                m_mechanism.paintMechanism(painter, size, m_palette);
            });
        }
        return std::nullopt;
    }

private:
    std::optional<QString> drawInto(const FigureDrawing &draw) const
    {
        return exportFigure(m_request.output, m_request.animation.size,
                            CommandLine::tr("Motion of an offset slider-crank"), draw);
    }

    /// Chooses the linkage that is drawn behind the mechanism: that of the file, or of the motion that was pinned last.
    void chooseGhost()
    {
        const Result &result = *m_content.result;
        const bool showsMechanism = m_request.subject != Subject::Figure && m_request.subject != Subject::Plot;
        if (result.reference && showsMechanism) {
            m_content.diagnosis = diagnose(result.reference->data, result.mechanism);
            const Diagnosis &diagnosis = m_content.diagnosis;
            if (diagnosis.conventions.empty() && !diagnosis.agreesWithGiven) {
                const Identification &found = diagnosis.identification;
                m_ghost = found.hasMechanism() ? Mechanism(found.parameters) : result.mechanism;
            }
        } else if (!result.reference && result.difference && Mechanism(result.pinned.back()) != result.mechanism) {
            m_ghost = Mechanism(result.pinned.back());
        }
        if (m_ghost) {
            m_mechanism.setGhostBounds(motionBounds(*m_ghost, motionLimits(*m_ghost)));
        }
    }

    void showTime(double time)
    {
        const auto &reference = m_content.result->reference;
        m_mechanism.setPose(poseAt(m_request.model.parameters, time));
        m_mechanism.setGhost(!m_ghost    ? ReferencePose()
                             : reference ? referencePoseAt(reference->data, *m_ghost, time)
                                         : referencePoseAt(*m_ghost, time));
    }

    const RenderRequest &m_request;
    QPalette m_palette;
    PlotGrid m_plots;
    MechanismView m_mechanism;
    ReportContent m_content;
    std::optional<Mechanism> m_ghost;
};

} // namespace

ExitStatus renderCommand(const OptionReader &options, const Streams &streams)
{
    RenderRequest request;
    request.scene = options.scene();
    readSubject(options, request);
    request.output = readOutput(options, options.texts("reference"));
    checkOutput(request);
    request.model = {
        readMechanism(options).parameters(), readSampling(options), readSolver(options), {}, request.scene.pinned};
    const QStringList files = options.texts("reference");
    const auto source = files.isEmpty() ? request.scene.reference : std::optional(ReferenceSource{files, {}, {}});
    const std::vector<NamedChoice> columns = readColumns(options);
    if (!columns.empty() && !source) {
        throw UsageError{CommandLine::tr("--column describes a reference file: name the file with --reference.")};
    }
    request.theme = options.choice("theme", 0) == 0 ? Theme::Light : Theme::Dark;
    if (request.subject == Subject::Report) {
        options.refuse({"size", "scale", "theme"},
                       CommandLine::tr("A report is printed on A4, black on white: remove %1."));
    } else {
        readSize(options, request.animation.size);
    }
    readTime(options, request);
    options.refuseFiles();
    if (request.subject == Subject::Mechanism) {
        request.model.sampling.start = request.time; // the mechanism can be drawn at any time
    }
    if (source) {
        const ReferenceOutcome outcome = readTimedReference(*source, columns, Mechanism(request.model.parameters));
        if (const QString *message = std::get_if<QString>(&outcome)) {
            streams.report(*message);
            return ExitStatus::FileError;
        }
        request.model.reference = std::get<std::shared_ptr<const Reference>>(outcome);
        reportDoubts(streams, *request.model.reference);
    }
    const std::shared_ptr<const Result> result = compute(request.model, {});
    if (const std::optional<QString> problem = Views(request, result).draw()) {
        streams.report(*problem);
        return ExitStatus::FileError;
    }
    return reportTimeSteps(streams, request, *result);
}

} // namespace slidercrank
