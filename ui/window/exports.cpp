// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/exports.h"

#include "ui/document/session.h"
#include "ui/export/animation_export.h"
#include "ui/export/animation_form.h"
#include "ui/export/figure_form.h"
#include "ui/export/motion_csv.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/panels/polygon_view.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/ghost.h"

#include <QProgressDialog>

namespace slidercrank
{

namespace
{

using Problem = std::optional<QString>;

/// Returns a function that draws the frame of an animation at a time (s): the mechanism as `view` shows it, with the
/// ghost behind it if `ghostPose` is not empty, and the parameters. `view` must exist as long as the function is used.
FrameDrawing drawFrameWith(MechanismView &view, const Mechanism &mechanism,
                           const std::function<ReferencePose(double)> &ghostPose)
{
    return [&view, mechanism, ghostPose](QPainter &painter, const QSize &size, double time) {
        view.setPose(poseAt(mechanism.parameters(), time));
        view.setGhost(ghostPose ? ghostPose(time) : ReferencePose());
        const auto paint = [&view](QPainter &target, const QSize &part) {
            view.paintMechanism(target, part, paletteFor(Theme::Light));
        };
        withParameters(FigureDrawing(paint), mechanism, paletteFor(Theme::Light))(painter, size);
    };
}

} // namespace

Exports::Exports(Session *session, const Views &views, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_views(views)
    , m_window(window)
    , m_task(new BackgroundTask(this))
{
    session->track(m_task);
}

FigureDrawing Exports::mechanismDrawing() const
{
    return m_views.mechanism->picture(paletteFor(Theme::Light));
}

FigureDrawing Exports::plotsDrawing(const FigureContent &content) const
{
    return [this, content](QPainter &painter, const QSize &size) {
        m_views.plots->paintFigure(painter, content, size, paletteFor(Theme::Light));
    };
}

FigureContent Exports::contentOf(const FigureOptions &options) const
{
    FigureContent content;
    content.plots = PlotGrid::plotsNamed(options.plots);
    if (options.showsCursor) {
        content.cursorTime = m_session->time();
    }
    return content;
}

FigureSubject Exports::plot(const QString &name) const
{
    const Mechanism mechanism = m_session->result()->mechanism;
    const auto contentFor = [this, name](FigureOptions options) {
        if (!name.isEmpty()) {
            options.plots = QStringList(name);
        }
        return contentOf(options);
    };
    FigureSubject subject;
    subject.name = name.isEmpty() ? tr("figure") : name;
    subject.plots = name.isEmpty() ? m_views.plots->choosablePlots() : std::vector<NamedPlot>();
    subject.hasCursor = true;
    subject.height = [this, mechanism, contentFor](const FigureOptions &options) {
        const auto height = [this, content = contentFor(options)](int width, const QFont &font) {
            return m_views.plots->figureHeight(content, width, font);
        };
        return withParameters(FigureHeight(height), mechanism);
    };
    subject.draw = [this, mechanism, contentFor](const FigureOptions &options) {
        return withParameters(plotsDrawing(contentFor(options)), mechanism, paletteFor(Theme::Light));
    };
    return subject;
}

FigureSubject Exports::mechanism() const
{
    FigureSubject subject;
    subject.name = tr("mechanism");
    subject.height = [this](const FigureOptions &) {
        const auto height = [this](int width, const QFont &) { return m_views.mechanism->pictureHeight(width); };
        return withParameters(FigureHeight(height), m_session->result()->mechanism);
    };
    subject.draw = [this](const FigureOptions &) {
        return withParameters(mechanismDrawing(), m_session->result()->mechanism, paletteFor(Theme::Light));
    };
    return subject;
}

FigureSubject Exports::polygons() const
{
    return polygonSubject(*m_session);
}

void Exports::choose(const FigureSubject &subject)
{
    chooseFigure(m_window, subject,
                 [this, subject](const FigureOptions &options, const QString &path) { write(subject, options, path); });
}

bool Exports::mayWrite()
{
    if (isWriting()) {
        m_session->reportFailure(tr("Another file is still being written: wait for it, or cancel it below."));
    }
    return !isWriting();
}

void Exports::write(const FigureSubject &subject, const FigureOptions &options, const QString &path)
{
    if (!mayWrite()) {
        return;
    }
    const auto write = [writer = drawFigure(path, subject, options)](
                           const std::stop_token &stop, const BackgroundTask::Progress &) { return writer(stop); };
    const auto done = [this, path](const Problem &problem) { m_session->reportWritten(path, problem); };
    m_task->start(write, done, [this](const QString &problem) { m_session->reportFailure(problem); });
}

void Exports::copy(const FigureSubject &subject)
{
    FigureOptions options = storedFigureOptions();
    options.plots.clear(); // the whole figure
    const FigureSize size = figureSize(options, subject.height(options));
    if (const Problem problem = copyFigureToClipboard(size, subject.draw(options))) {
        m_session->reportFailure(*problem);
    } else {
        m_session->confirm(tr("The picture is in the clipboard."));
    }
}

void Exports::chooseData()
{
    const QString plotted = tr("The six channels of the plots (*.csv)");
    const auto write = [this, plotted](const QString &path, const QString &filter) {
        writeData(path, filter == plotted ? plottedChannels() : allChannels());
    };
    chooseFileToSave(m_window, {tr("Export data"), {plotted, tr("All 36 channels (*.csv)")}, tr("motion"), write});
}

void Exports::writeData(const QString &path, const ChannelSet &channels)
{
    if (!mayWrite()) {
        return;
    }
    const MotionCsvOptions options{channels, notation()};
    const auto write = [path, options, result = m_session->result()](const std::stop_token &stop,
                                                                     const BackgroundTask::Progress &progress) {
        return exportMotion(path, *result, options, stop, progress);
    };
    const auto done = [this, path](const Problem &problem) { m_session->reportWritten(path, problem); };
    m_task->start(write, done, [this](const QString &problem) { m_session->reportFailure(problem); });
}

void Exports::chooseReport()
{
    const QString a4 = tr("Reports on A4 (*.pdf)");
    const QString letter = tr("Reports on Letter (*.pdf)");
    const bool isLetter = usualPaper() == PaperSize::Letter;
    chooseFileToSave(m_window, {tr("Export report"), isLetter ? QStringList{letter, a4} : QStringList{a4, letter},
                                tr("report"), [this, letter](const QString &path, const QString &filter) {
                                    writeReport(path, filter == letter ? PaperSize::Letter : PaperSize::A4);
                                }});
}

void Exports::writeReport(const QString &path, PaperSize paper)
{
    if (!mayWrite()) {
        return;
    }
    ReportContent content{.result = m_session->result(),
                          .found = {},
                          .time = m_session->time(),
                          .alpha2 = m_session->alpha2(),
                          .table = m_views.table->settings(),
                          .plottedTime = plottedTime(*m_session->result(), m_views.plots->zoom()),
                          .paper = paper};
    if (const auto &reference = content.result->choices.reference) {
        const auto &identification = m_session->identification();
        if (!identification || identification->reference != reference ||
            identification->parameters != content.result->mechanism.parameters()) {
            m_session->reportFailure(tr("No report was written: the mechanism of the file is still being identified. "
                                        "Export it again in a moment."));
            return;
        }
        content.found = identification->found;
    }
    const auto plots = std::make_shared<PlotGrid>(); // keeps the present motion while that of the window may change
    plots->setPresentation(m_views.plots->isPresentation());
    plots->setSettings(m_views.plots->settings());
    plots->setResult(content.result);
    plots->setZoom(m_views.plots->zoom());
    const auto drawPlots = [plots, time = content.plottedTime](QPainter &painter, const QSize &size) {
        plots->paintFigure(painter, {.time = time}, size, paletteFor(Theme::Light));
    };
    m_task->startPiecesInGuiThread(
        beginReport(path, content, mechanismDrawing(), drawPlots),
        [this, path](const ReportExport &report) { m_session->reportWritten(path, report.problem()); },
        [this](const QString &problem) { m_session->reportFailure(problem); });
}

Animation Exports::animationShown() const
{
    const Sampling &sampling = m_session->sampling();
    Animation animation;
    animation.start = sampling.start;
    animation.duration = sampling.duration;
    animation.size = videoSize({1920, 1080});
    animation.speed = m_views.timeline->speed();
    return animation;
}

void Exports::chooseAnimation()
{
    auto *form = new AnimationForm(animationShown(), m_window);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] {
        const auto write = [this, animation = form->animation()](const QString &path, const QString &) {
            const auto writeNow = [this, path, animation] { writeAnimation(path, animation); };
            QMetaObject::invokeMethod(this, writeNow, Qt::QueuedConnection); // after the dialog is closed
        };
        QStringList filters{tr("Videos (*.mp4)"), tr("Videos (*.webm)"), tr("Animated pictures (*.gif)")};
        filters.insert(hasVideoEncoder() ? filters.size() : 0, tr("New folder of numbered frames (*)"));
        chooseFileToSave(m_window, {tr("Export animation"), filters, tr("motion"), write});
    });
    form->open();
}

void Exports::writeAnimation(const QString &path, const Animation &animation)
{
    MechanismView view;
    view.setResult(m_session->result());
    view.setSettings(m_views.mechanism->settings());
    view.setFrame(m_views.mechanism->frame());
    const FrameDrawing draw = drawFrameWith(view, m_session->result()->mechanism, m_views.ghost->motion());
    QProgressDialog dialog(tr("Exporting the animation…"), tr("Cancel"), 0, animation.frameCount(), m_window);
    dialog.setWindowModality(Qt::WindowModal);
    const auto progress = [&dialog](int done) {
        dialog.setValue(done);
        QCoreApplication::processEvents();
        return !dialog.wasCanceled();
    };
    const Problem problem = exportAnimation(path, animation, draw, progress);
    if (!problem || !problem->isEmpty()) { // an empty text means that the user cancelled
        m_session->reportWritten(path, problem);
    }
}

} // namespace slidercrank

#include "moc_exports.cpp"
