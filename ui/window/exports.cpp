// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/exports.h"

#include "ui/document/session.h"
#include "ui/export/animation_export.h"
#include "ui/export/animation_form.h"
#include "ui/export/motion_csv.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/theme.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/ghost.h"

#include <QInputDialog>
#include <QProgressDialog>

namespace slidercrank
{

namespace
{

using Problem = std::optional<QString>;

constexpr double kScale = 2.0; // pixels of an exported picture per pixel of the screen
constexpr QSize kPlotSize(900, 600);

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

FigureDrawing Exports::drawMechanism() const
{
    return [this](QPainter &painter, const QSize &size) {
        m_views.mechanism->paintMechanism(painter, size, paletteFor(Theme::Light));
    };
}

Exports::Picture Exports::plot(const QString &name) const
{
    const QPalette palette = paletteFor(Theme::Light);
    const auto paint = [this, name, palette](QPainter &painter, const QSize &size) {
        m_views.plots->paintFigure(painter, name, size, palette);
    };
    const FigureDrawing draw = withParameters(paint, m_session->result()->mechanism, palette);
    return name.isEmpty() ? Picture{tr("figure"), m_views.plots->size(), draw} : Picture{name, kPlotSize, draw};
}

Exports::Picture Exports::mechanism() const
{
    return {tr("mechanism"), m_views.mechanism->pictureSize(),
            withParameters(drawMechanism(), m_session->result()->mechanism, paletteFor(Theme::Light))};
}

void Exports::choose(const Picture &picture)
{
    chooseFileToSave(m_window, {tr("Export"), figureFilters(), picture.name,
                                [this, picture](const QString &path, const QString &) { write(picture, path); }});
}

void Exports::write(const Picture &picture, const QString &path)
{
    const QString title = tr("Motion of an offset slider-crank");
    m_session->reportWritten(path, exportFigure(path, {picture.size, kScale}, title, picture.draw));
}

void Exports::copy(const Picture &picture)
{
    if (const Problem problem = copyFigureToClipboard({picture.size, kScale}, picture.draw)) {
        emit m_session->failed(*problem);
    } else {
        emit m_session->confirmed(tr("The picture is in the clipboard."));
    }
}

void Exports::chooseData()
{
    const QString plotted = tr("The six channels of the plots (*.csv)");
    const QString byAngle = tr("The six channels, every so many degrees of the crank (*.csv)");
    const auto write = [this, plotted, byAngle](const QString &path, const QString &filter) {
        if (filter != byAngle) {
            writeData(path, filter == plotted ? plottedChannels() : allChannels());
            return;
        }
        bool isChosen = false;
        const double step = QInputDialog::getDouble(
            m_window, tr("Export data"), tr("Step of the crank angle, in degrees:"), 5.0, 0.01, 180.0, 2, &isChosen);
        if (isChosen) {
            writeData(path, plottedChannels(), step);
        }
    };
    chooseFileToSave(m_window,
                     {tr("Export data"), {plotted, tr("All 36 channels (*.csv)"), byAngle}, tr("motion"), write});
}

void Exports::writeData(const QString &path, const ChannelSet &channels, double crankStep)
{
    if (isWriting()) {
        emit m_session->failed(tr("Another file is still being written: wait for it, or cancel it below."));
        return;
    }
    const auto write = [path, channels, crankStep, result = m_session->result()](
                           const std::stop_token &stop, const BackgroundTask::Progress &progress) {
        return exportMotion(path, *result, channels, crankStep, stop, progress);
    };
    const auto done = [this, path](const Problem &problem) { m_session->reportWritten(path, problem); };
    m_task->start(write, done, [this](const QString &problem) { emit m_session->failed(problem); });
}

void Exports::chooseReport()
{
    chooseFileToSave(m_window, {tr("Export report"),
                                {tr("Reports (*.pdf)")},
                                tr("report"),
                                [this](const QString &path, const QString &) { writeReport(path); }});
}

void Exports::writeReport(const QString &path)
{
    ReportContent content{m_session->result(), {}};
    if (const auto &reference = content.result->choices.reference) {
        const auto &diagnosis = m_session->diagnosis();
        if (!diagnosis || diagnosis->reference != reference ||
            diagnosis->parameters != content.result->mechanism.parameters()) {
            emit m_session->failed(tr("No report was written: the mechanism of the file is still being identified. "
                                      "Export it again in a moment."));
            return;
        }
        content.diagnosis = diagnosis->found;
    }
    m_session->reportWritten(path, exportReport(path, content, drawMechanism(), plot().draw));
}

Animation Exports::animationShown() const
{
    const Sampling &sampling = m_session->sampling();
    Animation animation;
    animation.start = sampling.start;
    animation.duration = sampling.duration;
    animation.size = {m_views.mechanism->pictureSize(), 1.0};
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
        chooseFileToSave(m_window, {tr("Export animation"),
                                    {tr("New folder of numbered frames (*)"), tr("Videos (*.mp4)"),
                                     tr("Videos (*.webm)"), tr("Animated pictures (*.gif)")},
                                    tr("motion"),
                                    write});
    });
    form->open();
}

void Exports::writeAnimation(const QString &path, const Animation &animation)
{
    MechanismView view;
    view.setResult(m_session->result());
    view.setSettings(m_views.mechanism->settings());
    view.setFrame(m_views.mechanism->frame());
    const auto draw = [&view, parameters = m_session->parameters(),
                       ghost = m_views.ghost->motion()](QPainter &painter, const QSize &size, double time) {
        view.setPose(poseAt(parameters, time));
        view.setGhost(ghost ? ghost(time) : ReferencePose());
        view.paintMechanism(painter, size, paletteFor(Theme::Light));
    };
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
