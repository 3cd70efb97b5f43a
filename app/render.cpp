// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank render`: draws what the window shows into a file, by the views of the window.

#include "app/commands.h"
#include "app/option_words.h"
#include "app/positions.h"
#include "app/reference_files.h"
#include "app/time_step_report.h"
#include "core/identification/identification.h"
#include "core/import/quantity.h"
#include "core/sampling/positions.h"
#include "ui/document/result.h"
#include "ui/document/scene_link.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/export/motion_table.h"
#include "ui/export/polygon_figure.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"
#include "ui/window/ghost.h"

#include <QMimeDatabase>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace slidercrank
{

namespace
{

enum class Subject { Figure, Mechanism, Polygons, Report, Animation, Plot };

/// The words of --what. A Plot is not among them: its word is the name of the plot.
constexpr EnumWord<Subject> kSubjects[] = {{Subject::Figure, "figure"},
                                           {Subject::Mechanism, "mechanism"},
                                           {Subject::Polygons, "polygons"},
                                           {Subject::Report, "report"},
                                           {Subject::Animation, "frames"}};

struct RenderRequest {
    Subject subject = Subject::Figure;
    FigureOptions figure;           ///< for pictures
    std::optional<FigureSize> size; ///< by --size; otherwise figure.width decides
    double scale = 1.0;
    Scene scene;         ///< the settings, the time that is drawn, and the crank acceleration
    Animation animation; ///< for Subject::Animation
    PaperSize paper = PaperSize::A4;
    Theme theme = Theme::Light;
    bool isTimeChosen = false; ///< whether the user chose the time range; otherwise plottedTime() does
    QString output;

    /// Returns whether the subject shows a single position, so that it may be asked for a time outside the time range.
    bool isOnePosition() const { return subject == Subject::Mechanism || subject == Subject::Polygons; }
};

/// Returns the words that stand for plots in --what and --plots: "theta3", …, "error_acceleration".
QStringList plotWords()
{
    QStringList names;
    for (const QString &name : PlotGrid::plotNames()) {
        names << name.mid(static_cast<int>(QStringLiteral("plot_").size()));
    }
    return names;
}

/// Returns the name of the plot that shows the quantity of this name or symbol, such as "R4_x" for "x" (--channels
/// knows the same symbols). Returns other words as they are.
QString plotNamed(const QString &word)
{
    const std::optional<OutputChannel> channel = outputChannelNamed(word.toStdString());
    const QString name = channel ? columnName(*channel) : QString();
    return plotWords().contains(name) ? name : word;
}

/// Reads --what, --plots and --no-cursor.
void readSubject(const OptionReader &options, RenderRequest &request)
{
    QStringList plots;
    if (options.has("what")) {
        const QString what = plotNamed(options.text("what"));
        QStringList words;
        for (const auto &[subject, word] : kSubjects) {
            words += word;
            if (what == QLatin1String(word)) {
                request.subject = subject;
            }
        }
        requireOneOf(words + plotWords(), what, "what");
        if (!words.contains(what)) {
            request.subject = Subject::Plot;
            plots += what;
        }
    }
    if (options.has("plots")) {
        if (request.subject != Subject::Figure) {
            throw UsageError{CommandLine::tr("--plots chooses among the plots of the figure: use it without --what.")};
        }
        for (const QString &word : options.text("plots").split(',')) {
            plots += plotNamed(word.trimmed());
        }
    }
    for (const QString &plot : plots) {
        requireOneOf(plotWords(), plot, "plots");
        request.figure.plots << "plot_" + plot;
    }
    request.figure.plots.removeDuplicates();
    request.figure.showsCursor = !options.has("no-cursor");
}

/// Returns the number and the unit that the option gives. Throws unless the text is a number followed by one of
/// `units`.
std::pair<double, QString> readLength(const OptionReader &options, const char *name, const QStringList &units)
{
    const QString text = options.text(name);
    for (const QString &unit : units) {
        if (text.endsWith(unit)) {
            bool isNumber = false;
            const double value = text.chopped(unit.size()).trimmed().toDouble(&isNumber);
            if (isNumber) {
                return {value, unit};
            }
        }
    }
    throw UsageError{
        CommandLine::tr("--%1 must be a number with the unit %2, not \"%3\".").arg(name, anyOf(units), text)};
}

void checkRange(const char *name, double value, double smallest, double largest, const QString &unit)
{
    if (!(value >= smallest && value <= largest)) {
        throw UsageError{CommandLine::tr("--%1 must be between %2 and %3 %4.")
                             .arg(name, typedNumberText(smallest), typedNumberText(largest), unit)};
    }
}

/// Reads --width and --font-size.
void readFigure(const OptionReader &options, FigureOptions &figure)
{
    if (options.has("width")) {
        const auto [width, unit] = readLength(options, "width", {"mm", "px"});
        const bool isInPixels = unit == u"px";
        checkRange("width", width, isInPixels ? kMinFigureWidthPx : kMinFigureWidthMm,
                   isInPixels ? kMaxFigureWidthPx : kMaxFigureWidthMm, unit);
        figure.width = width;
        figure.unit = isInPixels ? FigureOptions::Unit::Pixel : FigureOptions::Unit::Millimetre;
    }
    if (options.has("font-size")) {
        const auto [size, unit] = readLength(options, "font-size", {"pt"});
        checkRange("font-size", size, kSmallestFont, kLargestFont, unit);
        figure.fontSize = size;
    }
}

/// Reads --size and --scale.
void readSize(const OptionReader &options, RenderRequest &request)
{
    constexpr int kSmallestSide = 100;   // pixels
    constexpr int kLargestSide = 20'000; // pixels
    constexpr double kSmallestScale = 0.1;
    constexpr double kLargestScale = 10.0;
    request.scale = options.number("scale", 1.0, {}, kSmallestScale, kLargestScale);
    if (!options.has("size")) {
        return;
    }
    options.refuseIfGiven({"width"}, CommandLine::tr("--size and %1 both state the width: remove one of them."));
    const QStringList sides = options.text("size").split('x');
    const QSize size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
    const auto [shorter, longer] = std::minmax({size.width(), size.height()});
    if (shorter < kSmallestSide || request.scale * longer > kLargestSide) {
        throw UsageError{CommandLine::tr("--size must be width x height in pixels, such as 900x600, each at least 100, "
                                         "and at most %1 when multiplied by --scale, not \"%2\".")
                             .arg(QString::number(kLargestSide), options.text("size"))};
    }
    request.size = FigureSize{.size = size, .scale = request.scale};
    if (options.has("font-size")) {
        request.size->fontPixels = std::max(
            1, static_cast<int>(std::lround(request.figure.fontSize / kPointsPerInch * kLogicalPixelsPerInch)));
    }
}

/// Reads --output, and checks that it suits the subject.
void readTarget(const OptionReader &options, RenderRequest &request)
{
    request.output = readOutput(options);
    const std::optional<FigureFormat> format = figureFormat(request.output);
    const QString type = QMimeDatabase().mimeTypeForFile(request.output, QMimeDatabase::MatchExtension).name();
    const bool isFolder = !request.output.isEmpty() && !format && !type.contains(QRegularExpression("^video|^image"));
    bool isSuitable = format.has_value();
    if (request.subject == Subject::Animation) {
        isSuitable = isFolder || isVideo(request.output);
    } else if (request.subject == Subject::Report) {
        isSuitable = format == FigureFormat::Pdf;
    }
    if (!isSuitable) {
        throw UsageError{CommandLine::tr("render needs --output with a name that ends in .png, .svg or .pdf (report: "
                                         ".pdf; frames: a new folder, .mp4, .webm or .gif).")};
    }
}

/// Reads --speed, --at and --at-angle.
void readTime(const OptionReader &options, RenderRequest &request)
{
    constexpr double kSmallestSpeed = 1e-9; // positive, so that an animation ends
    const Sampling &sampling = request.scene.sampling;
    const double end = sampling.start + sampling.duration;
    request.animation.start = sampling.start;
    request.animation.duration = sampling.duration;
    request.animation.speed = options.number("speed", 1.0, {}, kSmallestSpeed);
    if (request.subject == Subject::Animation) {
        options.refuseIfGiven(
            {"at", "at-angle"},
            CommandLine::tr(
                "Frames show the whole time range: remove %1, or choose the range with --start and --duration."));
        if (request.animation.frameCount() > Animation::kMaxFrames) {
            throw UsageError{
                CommandLine::tr("There would be more than %1 frames: choose a shorter --duration or a greater --speed.")
                    .arg(Animation::kMaxFrames)};
        }
    } else {
        options.refuseIfGiven({"speed"}, CommandLine::tr("Only --what frames has a speed: remove %1."));
    }
    double &time = request.scene.time;
    time = options.has("scene") ? std::clamp(time, sampling.start, end) : sampling.start;
    time = readTimeStamp(options, Mechanism(request.scene.parameters)).value_or(time);
    if (!request.isOnePosition() && (time < sampling.start || time > end)) {
        throw UsageError{CommandLine::tr("t = %1 s lies outside the time range from %2 s to %3 s: choose another time, "
                                         "or another --start or --duration.")
                             .arg(numberText(time), numberText(sampling.start), numberText(end))};
    }
}

/// Reads --alpha2.
void readAcceleration(const OptionReader &options, RenderRequest &request)
{
    request.scene.alpha2 = readCrankAcceleration(options);
    const bool hasArrows = request.subject == Subject::Mechanism && request.scene.mechanism.acceleration;
    if (request.subject != Subject::Report && request.subject != Subject::Polygons && !hasArrows) {
        options.refuseIfGiven(
            {"alpha2"}, CommandLine::tr("Only a report, polygons and a scene with arrows of acceleration show an "
                                        "acceleration of the crank, and everything else is for a constant crank speed: "
                                        "remove %1."));
    }
}

/// Reads --step-angle: the step of the table in a report.
void readTableStep(const OptionReader &options, RenderRequest &request)
{
    if (!options.has("step-angle")) {
        return;
    }
    if (request.subject != Subject::Report) {
        options.refuseIfGiven({"step-angle"}, CommandLine::tr("Only a report contains a table: remove %1."));
    }
    if (request.scene.reference) {
        options.refuseIfGiven({"step-angle"},
                              CommandLine::tr("A report of a comparison contains no table: remove %1."));
    }
    constexpr double kSmallestStep = 1.0; // degrees: with more rows a report would state every 15°
    constexpr double kLargestStep = 360.0;
    MotionTableSettings table = request.scene.table.value_or(MotionTableSettings{.columns = usualTableChannels()});
    table.step = TableStep::CrankAngle;
    table.angleStep = options.number("step-angle", table.angleStep, kDegree, kSmallestStep, kLargestStep);
    request.scene.table = table;
}

/// Reads the options about the size and the paper, and refuses options that do not suit the subject.
void readPicture(const OptionReader &options, RenderRequest &request)
{
    const bool isReport = request.subject == Subject::Report;
    const bool isAnimation = request.subject == Subject::Animation;
    if (isReport) {
        options.refuseIfGiven({"size", "scale", "theme", "width", "font-size", "no-cursor"},
                              CommandLine::tr("A report has a fixed layout, black on white: remove %1."));
    } else {
        options.refuseIfGiven({"paper"}, CommandLine::tr("Only a report has a paper size: remove %1."));
    }
    if (isAnimation) {
        options.refuseIfGiven({"width", "font-size", "no-cursor"}, CommandLine::tr("Frames have a --size: remove %1."));
    }
    request.paper = options.choice("paper", PaperSize::A4);
    readFigure(options, request.figure);
    readSize(options, request);
    const QSize fullHd(1920, 1080);
    request.animation.size = videoSize(request.size ? request.size->size : fullHd);
    request.animation.size.scale *= request.scale;
}

RenderRequest readRequest(const OptionReader &options)
{
    RenderRequest request;
    readSubject(options, request);
    readTarget(options, request);
    request.scene = options.scene();
    const bool hasDrawingSettings = options.has("scene") && !isSceneLink(options.text("scene"));
    if (!hasDrawingSettings) { // draws what the window shows at its first start
        request.scene.mechanism = {.names = true, .dimensions = true, .angles = true};
    }
    request.scene.parameters = readMechanism(options).parameters();
    request.scene.sampling = readSampling(options);
    request.scene.solver = readSolver(options);
    if (const QStringList files = options.texts("reference"); !files.isEmpty()) {
        request.scene.reference = ReferenceSource{.paths = files};
    }
    request.theme = options.choice("theme", Theme::Light);
    request.isTimeChosen = options.has("scene") || options.has("start") || options.has("duration");
    readPicture(options, request);
    readTime(options, request);
    readAcceleration(options, request);
    readTableStep(options, request);
    options.refuseFiles();
    return request;
}

/// Returns the plots that are drawn. The values are written at the time that --at or a scene states.
FigureContent contentOf(const RenderRequest &request)
{
    FigureContent content;
    content.plots = PlotGrid::plotsNamed(request.figure.plots);
    const Scene &scene = request.scene;
    if (request.figure.showsCursor && scene.time != scene.sampling.start && request.subject != Subject::Report) {
        content.cursorTime = scene.time;
    }
    return content;
}

/// Returns the time range that the plots show; nullopt for that of the scene or the whole motion.
std::optional<Interval> plottedTimeOf(const RenderRequest &request, const Result &result,
                                      const std::optional<double> &cursorTime)
{
    if (request.isTimeChosen && request.subject != Subject::Report) {
        return std::nullopt;
    }
    const std::optional<Interval> time = plottedTime(result, request.scene.zoom);
    const bool showsCursor = !time || !cursorTime || time->contains(*cursorTime);
    return showsCursor ? time : std::nullopt;
}

/// The plots and the drawing of the mechanism as the window shows them, with the settings of the request's scene.
class Pictures
{
public:
    Pictures(const RenderRequest &request, const std::shared_ptr<const Result> &result, const Identification &found)
        : m_scene(request.scene)
        , m_palette(paletteFor(request.theme))
        , m_figure(contentOf(request))
        , m_ghost(findGhost(*result, &found))
    {
        m_plots.setSettings(m_scene.plots);
        m_plots.setResult(result);
        m_plots.setZoom(m_scene.zoom);
        m_figure.time = plottedTimeOf(request, *result, m_figure.cursorTime);
        m_mechanism.setResult(result);
        m_mechanism.setSettings(m_scene.mechanism);
        m_mechanism.setZoom(m_scene.mechanismFrame);
        m_mechanism.setGhostBounds(m_ghost.bounds);
    }

    void drawPlots(QPainter &painter, const QSize &size) { m_plots.paintFigure(painter, m_figure, size, m_palette); }
    int plotsHeight(int width, const QFont &font) { return m_plots.figureHeight(m_figure, width, font); }

    void drawMechanism(QPainter &painter, const QSize &size) { drawFrame(painter, size, m_scene.time); }
    int mechanismHeight(int width) const { return m_mechanism.pictureHeight(width); }

    /// Draws the mechanism at a time (s).
    void drawFrame(QPainter &painter, const QSize &size, double time)
    {
        m_mechanism.setPose(poseAt(m_scene.parameters, time));
        m_mechanism.setGhost(m_ghost.pose ? m_ghost.pose(time) : ReferencePose());
        m_mechanism.paintMechanism(painter, size, m_palette);
    }

    const QPalette &palette() const { return m_palette; }

private:
    const Scene &m_scene;
    QPalette m_palette;
    FigureContent m_figure;
    GhostMotion m_ghost;
    PlotGrid m_plots;
    MechanismView m_mechanism;
};

/// Writes a picture with the parameters below it. Returns a message on failure.
std::optional<QString> writePicture(const RenderRequest &request, const Mechanism &mechanism, const QPalette &palette,
                                    const FigureDrawing &drawing, const FigureHeight &height)
{
    FigureSize size = request.size.value_or(FigureSize());
    if (!request.size) {
        size = figureSize(request.figure, withParameters(height, mechanism));
        size.scale *= request.scale;
    }
    return exportFigure(request.output, size, CommandLine::tr("Motion of an offset slider-crank"),
                        withParameters(drawing, mechanism, palette));
}

/// Writes the subject of the request into its file. Returns a message on failure.
std::optional<QString> write(const RenderRequest &request, const std::shared_ptr<const Result> &result)
{
    const bool showsMechanism = request.subject == Subject::Mechanism || request.subject == Subject::Animation ||
                                request.subject == Subject::Report;
    Identification found;
    if (result->reference && showsMechanism) {
        found = identify(result->reference->data, result->mechanism);
    }
    Pictures pictures(request, result, found);
    const auto drawPlots = [&](QPainter &painter, const QSize &size) { pictures.drawPlots(painter, size); };
    const auto drawMechanism = [&](QPainter &painter, const QSize &size) { pictures.drawMechanism(painter, size); };
    switch (request.subject) {
    case Subject::Figure:
    case Subject::Plot:
        return writePicture(request, result->mechanism, pictures.palette(), drawPlots,
                            [&](int width, const QFont &font) { return pictures.plotsHeight(width, font); });
    case Subject::Mechanism:
        return writePicture(request, result->mechanism, pictures.palette(), drawMechanism,
                            [&](int width, const QFont &) { return pictures.mechanismHeight(width); });
    case Subject::Polygons:
        return writePicture(
            request, result->mechanism, pictures.palette(),
            polygonFigure(result->mechanism, request.scene.time, request.scene.alpha2, pictures.palette()),
            polygonHeight);
    case Subject::Animation: {
        const auto drawFrame = [&](QPainter &painter, const QSize &size, double time) {
            const FigureDrawing draw = [&](QPainter &target, const QSize &part) {
                pictures.drawFrame(target, part, time);
            };
            withParameters(draw, result->mechanism, pictures.palette())(painter, size);
        };
        const auto neverCancel = [](int) { return true; };
        return exportAnimation(request.output, request.animation, drawFrame, neverCancel);
    }
    case Subject::Report: {
        const ReportContent content{.result = result,
                                    .found = found,
                                    .time = request.scene.time,
                                    .alpha2 = request.scene.alpha2,
                                    .table = request.scene.table,
                                    .plottedTime = plottedTime(*result, request.scene.zoom),
                                    .paper = request.paper};
        return exportReport(request.output, content, drawMechanism, drawPlots);
    }
    }
    return std::nullopt;
}

} // namespace

ExitStatus renderCommand(const OptionReader &options, const Streams &streams)
{
    RenderRequest request = readRequest(options);
    const Notation ofScene = request.scene.notation.value_or(Notation());
    setNotation({.symbols = options.choice("notation", ofScene.symbols),
                 .units = readUnits(options, ofScene.units),
                 .crankSpeed = ofScene.crankSpeed});
    Scene &scene = request.scene;
    const std::vector<ColumnChoice> columns = readColumns(options);
    if (!scene.reference) {
        options.refuseIfGiven({"column", "abscissa"},
                              CommandLine::tr("%1 describes a reference file: name the file with --reference."));
    }
    if (request.isOnePosition()) {
        scene.sampling.start = scene.time;
    }
    Choices choices{.parameters = scene.parameters,
                    .sampling = scene.sampling,
                    .solver = scene.solver,
                    .reference = nullptr,
                    .pinned = scene.pinned,
                    .alpha2 = scene.alpha2};
    if (scene.reference) {
        choices.reference = readTimedReference(streams, *scene.reference, columns, Mechanism(scene.parameters));
        if (!choices.reference) {
            return ExitStatus::FileError;
        }
    }
    const std::shared_ptr<const Result> result = compute(choices, {});
    if (const std::optional<QString> problem = write(request, result)) {
        streams.report(*problem);
        return ExitStatus::FileError;
    }
    SamplingSummary summary = result->summary;
    summary.add(result->atReference.summary);
    if (request.isOnePosition()) {
        const ChannelSet noChannels; // the status is sufficient
        summary = samplePositions(result->mechanism, {scene.time}, noChannels, SolverSettings()).summary;
    }
    return reportTimeSteps(streams, summary, result->mechanism, result->solver.newton);
}

} // namespace slidercrank
