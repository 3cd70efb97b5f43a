// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/scene_file.h"

#include "ui/document/byte_stream.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/remembered.h"
#include "ui/window/rooms.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <utility>
#include <variant>

namespace slidercrank
{

namespace
{

/// Where scenes are: beside the last one.
QString folderOf(const QString &path)
{
    const QString last = path.isEmpty() ? recentFiles(kRecentScenes).value(0) : path;
    return last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                          : QFileInfo(last).absolutePath();
}

FileState stateOf(const QString &path)
{
    const QFileInfo file(path);
    return {file.size(), file.lastModified()};
}

} // namespace

SceneFile::SceneFile(Session *session, const Rooms &rooms, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_rooms(rooms)
    , m_window(window)
{
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &SceneFile::changed);
    connect(session, &Session::referenceLoaded, this, [this] { m_missing.reset(); });
    connect(session, &Session::opened, this, &SceneFile::finishOpening);
    connect(session, &Session::editedMeanwhile, this, &SceneFile::askThen);
}

bool SceneFile::isModified() const
{
    return !m_session->undoStack().isClean();
}

void SceneFile::takeWhatIsTyped()
{
    if (auto *box = qobject_cast<NumberBox *>(m_window->focusWidget())) {
        box->interpretText();
    }
}

Scene SceneFile::scene() const
{
    return {.parameters = m_session->parameters(),
            .sampling = m_session->sampling(),
            .solver = m_session->solver(),
            .reference = m_session->reference() ? std::optional(sourceOf(*m_session->reference())) : m_missing,
            .kept = m_session->kept(),
            .time = m_session->time(),
            .plots = m_rooms.plots->settings(),
            .zoom = m_rooms.plots->zoom(),
            .mechanism = m_rooms.mechanism->settings(),
            .mechanismFrame = m_rooms.mechanism->zoom(),
            .asRead = m_asRead};
}

void SceneFile::askThen(const std::function<void()> &goOn)
{
    takeWhatIsTyped();
    if (!isModified()) {
        goOn();
        return;
    }
    if (auto *asked = m_window->findChild<QMessageBox *>(QStringLiteral("unsavedQuestion"))) {
        asked->reject();
    }
    auto *question =
        new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                        m_path.isEmpty() ? tr("Save what you changed as a scene, to go on from there another time?")
                                         : tr("Save the changes to %1?").arg(QFileInfo(m_path).fileName()),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    question->setObjectName(QStringLiteral("unsavedQuestion"));
    question->setInformativeText(tr("Otherwise they are lost."));
    question->setDefaultButton(QMessageBox::Save);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, goOn](int answer) {
        if (answer == QMessageBox::Save) {
            save(goOn);
        } else if (answer == QMessageBox::Discard) {
            goOn();
        }
    });
    question->open();
}

void SceneFile::open(const QString &path, const QStringList &reference)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (isPipeOrDevice(QFileInfo(absolute))) {
        emit problemFound(tr("%1 is a pipe or a device: save the scene in a file, and open that.")
                              .arg(QDir::toNativeSeparators(absolute)));
        return;
    }
    const FileState state = stateOf(absolute);
    std::variant<Scene, QString> outcome = readScene(absolute);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        emit problemFound(*sentence);
        return;
    }
    askThen([this, reference, opening = Opening{absolute, state, std::get<Scene>(std::move(outcome)), {}}] {
        show(opening, reference.isEmpty() ? opening.scene.reference : std::nullopt);
        if (!reference.isEmpty()) {
            m_session->loadReference(reference);
        }
    });
}

void SceneFile::restore(const Scene &scene, const QString &path, const FileState &state,
                        const std::function<void()> &goOn)
{
    askThen([this, opening = Opening{path, state, scene, goOn}] { show(opening, opening.scene.reference); });
}

void SceneFile::show(const Opening &opening, const std::optional<ReferenceSource> &reference)
{
    m_opening = opening;
    const Scene &scene = opening.scene;
    m_session->open({scene.parameters, scene.sampling, scene.solver, nullptr, scene.kept}, scene.time, reference);
}

void SceneFile::finishOpening(const QString &problem)
{
    if (!m_opening) {
        return;
    }
    const Opening opening = *std::exchange(m_opening, std::nullopt);
    m_path = opening.path;
    m_state = opening.state;
    m_asRead = opening.scene.asRead;
    m_missing = problem.isEmpty() ? std::nullopt : opening.scene.reference;
    m_rooms.plots->setSettings(opening.scene.plots);
    m_rooms.plots->setZoom(opening.scene.zoom);
    m_rooms.mechanism->setSettings(opening.scene.mechanism);
    m_rooms.mechanism->setZoom(opening.scene.mechanismFrame);
    if (m_session->result()->sampling != m_session->sampling()) { // a long run, whose result will undo the zoom
        connect(
            m_session, &Session::resultChanged, this,
            [this, zoom = opening.scene.zoom] { m_rooms.plots->setZoom(zoom); }, Qt::SingleShotConnection);
    }
    if (opening.restored) {
        m_session->undoStack().resetClean();
        opening.restored();
    } else {
        rememberFile(kRecentScenes, m_path);
    }
    emit changed();
    if (!problem.isEmpty()) {
        emit referenceMissing(problem);
    }
}

void SceneFile::chooseAndOpen()
{
    auto *dialog = new QFileDialog(m_window, tr("Open scene"), folderOf(m_path),
                                   tr("Scenes (*.slidercrank *.json);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) { open(path); });
    dialog->open();
}

void SceneFile::save(const std::function<void()> &goOn)
{
    takeWhatIsTyped();
    if (m_path.isEmpty()) {
        saveAs(goOn);
    } else if (QFileInfo::exists(m_path) && stateOf(m_path) != m_state) {
        askToReplace(goOn);
    } else if (saveTo(m_path) && goOn) {
        goOn();
    }
}

void SceneFile::askToReplace(const std::function<void()> &goOn)
{
    auto *question = new QMessageBox(
        QMessageBox::Question, tr("Changed elsewhere"),
        tr("%1 was changed elsewhere since it was opened here. Replace it?").arg(QFileInfo(m_path).fileName()),
        QMessageBox::NoButton, m_window);
    question->setObjectName(QStringLiteral("changedQuestion"));
    question->addButton(tr("Replace"), QMessageBox::AcceptRole);
    QPushButton *other = question->addButton(tr("Save as…"), QMessageBox::ActionRole);
    question->setDefaultButton(question->addButton(QMessageBox::Cancel));
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::accepted, this, [this, goOn] {
        if (saveTo(m_path) && goOn) {
            goOn();
        }
    });
    connect(other, &QPushButton::clicked, this, [this, goOn] { saveAs(goOn); });
    question->open();
}

void SceneFile::saveAs(const std::function<void()> &goOn)
{
    const QFileInfo file(m_path);
    chooseFileToSave(m_window, {tr("Save scene"),
                                {tr("Scenes (*.slidercrank)"), tr("Scenes (*.json)")},
                                m_path.isEmpty() ? lastFolder(QStandardPaths::DocumentsLocation) : file.absolutePath(),
                                m_path.isEmpty() ? QStringLiteral("scene.slidercrank") : file.fileName(),
                                [this, goOn](const QString &path, const QString &) {
                                    if (saveTo(path) && goOn) {
                                        goOn();
                                    }
                                }});
}

bool SceneFile::saveTo(const QString &path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (const std::optional<QString> sentence = writeScene(scene(), absolute)) {
        emit problemFound(*sentence);
        return false;
    }
    m_path = absolute;
    m_state = stateOf(absolute);
    m_session->undoStack().setClean();
    rememberFile(kRecentScenes, m_path);
    emit changed();
    emit saved(m_path);
    return true;
}

} // namespace slidercrank
