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
#include "ui/text/remember.h"
#include "ui/text/theme.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/ghost.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QStandardPaths>

#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kScale = 2.0; // of what is on screen, for documents
constexpr QSize kPlotSize(900, 600);

} // namespace

Exports::Exports(Session *session, const Rooms &rooms, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_rooms(rooms)
    , m_window(window)
    , m_aside(new WorkAside(WorkAside::Kind::Lasting, this))
{
    connect(m_aside, &WorkAside::progressed, this, &Exports::progressed);
    connect(m_aside, &WorkAside::runningChanged, this, &Exports::busyChanged);
}

Exports::Picture Exports::figure() const
{
    const auto draw = [this](QPainter &painter, const QSize &size) { // in rooms that may have been made anew
        m_rooms.plots->paintFigure(painter, size, paletteFor(Theme::Light));
    };
    return {tr("figure.png"), m_rooms.plots->size(), draw, tr("The figure is in the clipboard.")};
}

Exports::Picture Exports::plot(const QString &name) const
{
    const auto draw = [this, name](QPainter &painter, const QSize &size) {
        m_rooms.plots->paintPlot(painter, name, size, paletteFor(Theme::Light));
    };
    return {name + QStringLiteral(".png"), kPlotSize, draw, tr("The plot is in the clipboard.")};
}

Exports::Picture Exports::mechanism() const
{
    const auto draw = [this](QPainter &painter, const QSize &size) {
        m_rooms.mechanism->paintMechanism(painter, size, paletteFor(Theme::Light));
    };
    return {tr("mechanism.png"), m_rooms.mechanism->pictureSize(),
            withParameters(draw, m_session->result()->mechanism, paletteFor(Theme::Light)),
            tr("The mechanism is in the clipboard.")};
}

void Exports::choose(const Picture &picture)
{
    chooseFileToSave(m_window,
                     {tr("Export"), figureFilters(), lastFolder(QStandardPaths::PicturesLocation), picture.name,
                      [this, picture](const QString &path, const QString &) { write(picture, path); }});
}

void Exports::write(const Picture &picture, const QString &path)
{
    const QString title = tr("Motion of an offset slider-crank");
    tellWritten(path, exportFigure(path, {picture.size, kScale}, title, picture.draw));
}

void Exports::copy(const Picture &picture)
{
    if (const std::optional<QString> problem = copyFigureToClipboard({picture.size, kScale}, picture.draw)) {
        emit problemFound(*problem);
    } else {
        emit done(picture.inClipboard);
    }
}

void Exports::chooseData()
{
    const QString plotted = tr("The six channels of the plots (*.csv)");
    const QString byAngle = tr("The six channels, every so many degrees of the crank (*.csv)");
    const SaveRequest request{tr("Export data"),
                              {plotted, tr("All 36 channels (*.csv)"), byAngle},
                              lastFolder(QStandardPaths::DocumentsLocation),
                              tr("motion.csv"),
                              [this, plotted, byAngle](const QString &path, const QString &filter) {
                                  if (filter == byAngle) {
                                      chooseCrankStep(path);
                                  } else {
                                      writeData(path, filter == plotted ? plottedChannels() : allChannels());
                                  }
                              }};
    chooseFileToSave(m_window, request);
}

void Exports::chooseCrankStep(const QString &path)
{
    auto *dialog = new QInputDialog(m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Export data"));
    dialog->setLabelText(tr("Step of the crank angle, in degrees:"));
    dialog->setInputMode(QInputDialog::DoubleInput);
    dialog->setDoubleDecimals(2);
    dialog->setDoubleRange(0.01, 180.0);
    dialog->setDoubleValue(5.0);
    connect(dialog, &QInputDialog::doubleValueSelected, this,
            [this, path](double step) { writeData(path, plottedChannels(), step); });
    dialog->open();
}

void Exports::writeData(const QString &path, const ChannelSet &channels, double crankStep)
{
    writeAside(path, [path, channels, crankStep, result = m_session->result()](const std::stop_token &stop,
                                                                               const WorkAside::Progress &progress) {
        return exportMotion(path, *result, channels, crankStep, stop, progress);
    });
}

void Exports::chooseReport()
{
    chooseFileToSave(m_window, {tr("Export report"),
                                {tr("Reports (*.pdf)")},
                                lastFolder(QStandardPaths::DocumentsLocation),
                                tr("report.pdf"),
                                [this](const QString &path, const QString &) { writeReport(path); }});
}

void Exports::writeReport(const QString &path)
{
    const auto content = std::make_shared<ReportContent>();
    content->result = m_session->result();
    const auto write = [this, path, content]() -> std::optional<QString> {
        if (content->result != m_session->result()) {
            return tr("No report was written: the mechanism was changed meanwhile. Export it again.");
        }
        content->hasGhost = m_rooms.mechanism->hasGhost();
        const auto draw = [this](QPainter &painter, const QSize &size) {
            m_rooms.mechanism->paintMechanism(painter, size, paletteFor(Theme::Light));
        };
        const auto drawPlots = [this](QPainter &painter, const QSize &size) {
            m_rooms.plots->paintFigure(painter, size, paletteFor(Theme::Light));
        };
        return exportReport(path, *content, {draw, drawPlots});
    };
    const Result &result = *content->result;
    const std::shared_ptr<const ReferenceDiagnosis> &diagnosis = m_session->diagnosis();
    const bool isKnown = diagnosis && diagnosis->reference == result.chosenReference() &&
                         diagnosis->parameters == result.mechanism.parameters();
    if (isKnown) {
        content->diagnosis = diagnosis->found;
    }
    if (!result.reference) {
        tellWritten(path, write());
        return;
    }
    const auto prepareAside = [content, isKnown](const std::stop_token &stop, const auto &) -> std::optional<QString> {
        const Reference &reference = *content->result->reference;
        if (!isKnown) {
            content->diagnosis = diagnose(reference.data, content->result->mechanism, stop);
        }
        content->checksums = checksumsOf(reference);
        return std::nullopt;
    };
    writeAside(path, prepareAside, write);
}

Animation Exports::animationOnShow() const
{
    const Sampling &sampling = m_session->sampling();
    Animation animation;
    animation.start = sampling.start;
    animation.duration = sampling.duration;
    animation.size = {m_rooms.mechanism->pictureSize(), 1.0};
    animation.speed = m_rooms.timeline->speed();
    return animation;
}

void Exports::chooseAnimation()
{
    auto *form = new AnimationForm(animationOnShow(), m_window);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] { chooseAnimationFile(form->animation()); });
    form->open();
}

void Exports::chooseAnimationFile(const Animation &animation)
{
    auto *dialog = new QFileDialog(m_window, tr("Export animation"), lastFolder(QStandardPaths::MoviesLocation));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("New folder of numbered frames (*)"), tr("Videos (*.mp4)"), tr("Videos (*.webm)"),
                            tr("Animated pictures (*.gif)")});
    dialog->selectFile(tr("motion"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, animation](const QString &path) {
        const QString suffix = dialog->selectedNameFilter().section(QStringLiteral("(*"), -1).chopped(1);
        remember({{QStringLiteral("lastFolder"), QFileInfo(path).absolutePath()}});
        const QString completed = isVideo(path) ? path : path + suffix;
        const auto write = [this, completed, animation] { writeAnimation(completed, animation); };
        QMetaObject::invokeMethod(this, write, Qt::QueuedConnection); // writing handles events: the dialog may go
    });
    dialog->open();
}

void Exports::writeAnimation(const QString &path, const Animation &animation)
{
    if (refusesAnother()) {
        return;
    }
    MechanismView view;
    view.setResult(m_session->result());
    view.setSettings(m_rooms.mechanism->settings());
    view.setFrame(m_rooms.mechanism->frame());
    const auto draw = [&view, parameters = m_session->parameters(),
                       ghost = m_rooms.ghost->motion()](QPainter &painter, const QSize &size, double time) {
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
    const std::optional<QString> problem = exportAnimation(path, animation, draw, progress);
    if (!problem || !problem->isEmpty()) { // empty: cancelled
        tellWritten(path, problem);
    }
}

void Exports::writeAside(const QString &path, const Work &work, const Finish &finish)
{
    if (refusesAnother()) {
        return;
    }
    const auto done = [this, path, finish](const std::optional<QString> &problem) {
        tellWritten(path, problem || !finish ? problem : finish());
    };
    m_aside->start(work, done, [this](const QString &problem) { emit problemFound(problem); });
}

bool Exports::isWriting() const
{
    return m_aside->isRunning();
}

bool Exports::refusesAnother()
{
    if (isWriting()) {
        emit problemFound(tr("Another file is still being written: wait for it, or cancel it below."));
    }
    return isWriting();
}

void Exports::finishThen(const std::function<void()> &goOn)
{
    if (!isWriting()) {
        goOn();
        return;
    }
    if (auto *asked = m_window->findChild<QMessageBox *>(QStringLiteral("writingQuestion"))) {
        asked->reject();
    }
    auto *question = new QMessageBox(QMessageBox::Question, tr("Still writing"),
                                     tr("A file is still being written. The window closes when it is done."),
                                     QMessageBox::NoButton, m_window);
    question->setObjectName(QStringLiteral("writingQuestion"));
    const auto *stop = question->addButton(tr("Stop writing and close"), QMessageBox::AcceptRole);
    question->setDefaultButton(question->addButton(tr("Keep the window open"), QMessageBox::RejectRole));
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(this, &Exports::busyChanged, question, [this, question, goOn] {
        if (!isWriting()) {
            question->close();
            goOn();
        }
    });
    connect(this, &Exports::problemFound, question, &QDialog::reject);
    connect(question, &QDialog::finished, this, [this, question, stop] {
        if (question->clickedButton() == stop) {
            cancel();
        }
        disconnect(question);
    });
    question->open();
}

bool Exports::cancel()
{
    const bool writes = isWriting();
    m_aside->drop();
    return writes;
}

void Exports::tellWritten(const QString &path, const std::optional<QString> &problem)
{
    if (problem) {
        emit problemFound(*problem);
    } else {
        emit done(tr("Written: %1").arg(QDir::toNativeSeparators(path)));
    }
}

} // namespace slidercrank
