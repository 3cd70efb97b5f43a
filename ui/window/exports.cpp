// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/exports.h"

#include "ui/widgets/save_dialog.h"
#include "ui/document/session.h"
#include "ui/export/animation_export.h"
#include "ui/export/animation_form.h"
#include "ui/export/motion_csv.h"
#include "ui/export/report_pages.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/window/ghost.h"
#include "ui/text/theme.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
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
    return {QStringLiteral("figure.png"), m_rooms.plots->size(), draw, tr("The figure is in the clipboard.")};
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
    return {QStringLiteral("mechanism.png"), m_rooms.mechanism->size(), draw, tr("The mechanism is in the clipboard.")};
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
    const SaveRequest request{tr("Export data"),
                              {plotted, tr("All 36 channels (*.csv)")},
                              lastFolder(QStandardPaths::DocumentsLocation),
                              QStringLiteral("motion.csv"),
                              [this, plotted](const QString &path, const QString &filter) {
                                  writeData(path, filter == plotted ? plottedChannels() : allChannels());
                              }};
    chooseFileToSave(m_window, request);
}

void Exports::writeData(const QString &path, const ChannelSet &channels)
{
    writeAside(path, [path, channels, result = m_session->result()](const std::stop_token &stop,
                                                                    const WorkAside::Progress &progress) {
        return exportMotion(path, *result, channels, stop, progress);
    });
}

void Exports::chooseReport()
{
    chooseFileToSave(m_window, {tr("Export report"),
                                {tr("Reports (*.pdf)")},
                                lastFolder(QStandardPaths::DocumentsLocation),
                                QStringLiteral("report.pdf"),
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
        return exportReport(path, *content, {mechanism().draw, figure().draw});
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
    animation.size = {m_rooms.mechanism->size(), kScale};
    animation.speed = m_rooms.timeline->speed();
    return animation;
}

void Exports::chooseAnimation()
{
    auto *form = new AnimationForm(animationOnShow(), m_session->parameters(), m_window);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] { chooseAnimationFile(form->animation()); });
    form->open();
}

void Exports::chooseAnimationFile(const Animation &animation)
{
    const QString frames = QStringLiteral("png");
    SaveRequest request{tr("Export animation"),
                        {},
                        lastFolder(QStandardPaths::MoviesLocation),
                        QStringLiteral("motion.png"),
                        [this, animation](const QString &path, const QString &) { writeAnimation(path, animation); }};
    for (const QString &suffix : AnimationExport::suffixes()) {
        request.filters << (suffix == frames ? tr("Numbered frames (*.png)") : tr("Videos (*.%1)").arg(suffix));
    }
    request.replaces = [frames](const QString &path) { // frames have names of their own
        return QFileInfo(path).suffix().toLower() != frames && QFileInfo::exists(path);
    };
    chooseFileToSave(m_window, request);
}

void Exports::writeAnimation(const QString &path, const Animation &animation)
{
    if (refusesAnother()) {
        return;
    }
    const QStringList older = AnimationExport::olderFrames(path, animation.frameCount());
    if (older.isEmpty()) {
        film(path, animation);
        return;
    }
    auto *question = new QMessageBox(QMessageBox::Question, tr("Older frames"),
                                     tr("Older frames of this name are there: %1, from %2 to %3. Replace them?")
                                         .arg(QString::number(older.size()), older.first(), older.last()),
                                     QMessageBox::Cancel, m_window);
    question->setObjectName(QStringLiteral("framesQuestion"));
    question->setInformativeText(
        tr("All of them are deleted; the new ones, %1, take their place.").arg(animation.frameCount()));
    question->addButton(tr("Replace"), QMessageBox::AcceptRole);
    question->setDefaultButton(QMessageBox::Cancel);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QDialog::accepted, this, [this, path, animation] { film(path, animation); });
    question->open();
}

void Exports::film(const QString &path, const Animation &animation)
{
    const auto view = std::make_shared<MechanismView>();
    view->setResult(m_session->result());
    view->setSettings(m_rooms.mechanism->settings());
    view->setFrame(m_rooms.mechanism->frame());
    const auto draw = [view, parameters = m_session->parameters(),
                       ghost = m_rooms.ghost->motion()](QPainter &painter, const QSize &size, double time) {
        view->setPose(poseAt(parameters, time));
        view->setGhost(ghost ? ghost(time) : ReferencePose());
        view->paintMechanism(painter, size, paletteFor(Theme::Light));
    };
    const QStringList frames = AnimationExport::frameNames(path, animation.frameCount());
    const QFileInfo file(path);
    const QString written =
        frames.size() > 1 ? tr("%1 frames, %2 to %3, in %4")
                                .arg(QString::number(frames.size()), frames.first(), frames.last(), file.absolutePath())
                          : file.absoluteDir().filePath(frames.value(0, file.fileName()));
    m_animation = new AnimationExport(animation, draw, this);
    connect(m_animation, &AnimationExport::progressed, this,
            [this](int done, int all) { emit progressed(static_cast<double>(done) / all); });
    connect(m_animation, &AnimationExport::finished, this, [this, path = written](const QString &problem) {
        std::exchange(m_animation, nullptr)->deleteLater();
        tellWritten(path, problem.isEmpty() ? std::nullopt : std::optional(problem));
        emit busyChanged(false);
    });
    emit busyChanged(true);
    m_animation->start(path);
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
    return m_animation || m_aside->isRunning();
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
    if (m_animation) {
        delete std::exchange(m_animation, nullptr);
        emit busyChanged(false);
    }
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
