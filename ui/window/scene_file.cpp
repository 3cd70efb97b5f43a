// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/scene_file.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/views.h"
#include "ui/window/window_settings.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <utility>
#include <variant>

namespace slidercrank
{

namespace
{

/// Creates a question with a Cancel button. It replaces an open question of the same name.
QMessageBox *makeQuestion(const char *name, const QString &title, const QString &text, QWidget *window)
{
    if (auto *unanswered = window->findChild<QMessageBox *>(QLatin1String(name))) {
        unanswered->reject();
    }
    auto *question = new QMessageBox(QMessageBox::Question, title, text, QMessageBox::Cancel, window);
    question->setObjectName(QLatin1String(name));
    question->setAttribute(Qt::WA_DeleteOnClose);
    return question;
}

} // namespace

SceneFile::SceneFile(Session *session, const Views &views, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_views(views)
    , m_window(window)
{
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &SceneFile::changed);
    connect(&session->undoStack(), &QUndoStack::indexChanged, this, &SceneFile::changed);
    connect(session, &Session::referenceLoaded, this, [this] { m_missing.reset(); });
    connect(session, &Session::opened, this, &SceneFile::finishOpening);
    connect(session, &Session::editedMeanwhile, this, &SceneFile::askThen);
}

void SceneFile::enterTypedNumber()
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
            .reference = m_session->reference() ? std::optional(toSource(*m_session->reference())) : m_missing,
            .pinned = m_session->pinned(),
            .time = m_session->time(),
            .plots = m_views.plots->settings(),
            .zoom = m_views.plots->zoom(),
            .mechanism = m_views.mechanism->settings(),
            .mechanismFrame = m_views.mechanism->zoom()};
}

void SceneFile::askThen(const std::function<void()> &proceed)
{
    enterTypedNumber();
    if (!m_session->isModified()) {
        proceed();
        return;
    }
    const QString name = QFileInfo(m_path).fileName();
    QMessageBox *question = makeQuestion(
        "unsavedQuestion", tr("Unsaved changes"),
        name.isEmpty() ? tr("Save your changes as a scene?") : tr("Save your changes to %1?").arg(name), m_window);
    question->setInformativeText(tr("They will be lost if you don't."));
    question->setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    question->setDefaultButton(QMessageBox::Save);
    connect(question, &QMessageBox::finished, this, [this, proceed](int answer) {
        if (answer == QMessageBox::Save) {
            save(proceed);
        } else if (answer == QMessageBox::Discard) {
            proceed();
        }
    });
    question->open();
}

void SceneFile::open(const QString &path, const QStringList &reference)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const FileState state = fileState(absolute);
    const std::variant<Scene, QString> outcome = readScene(absolute);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        emit problemFound(*sentence);
        return;
    }
    askThen([this, reference, opening = Opening{absolute, state, std::get<Scene>(outcome), {}}] {
        show(opening, reference.isEmpty() ? opening.scene.reference : std::nullopt);
        if (!reference.isEmpty()) {
            m_session->loadReference(reference);
        }
    });
}

void SceneFile::restore(const Scene &scene, const std::function<void()> &proceed)
{
    askThen([this, opening = Opening{{}, {}, scene, proceed}] { show(opening, opening.scene.reference); });
}

void SceneFile::show(const Opening &opening, const std::optional<ReferenceSource> &reference)
{
    m_opening = opening;
    const Scene &scene = opening.scene;
    m_session->open({scene.parameters, scene.sampling, scene.solver, nullptr, scene.pinned}, scene.time, reference);
}

void SceneFile::finishOpening(const QString &problem)
{
    if (!m_opening) {
        return;
    }
    const Opening opening = *std::exchange(m_opening, std::nullopt);
    m_path = opening.path;
    m_state = opening.state;
    m_missing = problem.isEmpty() ? std::nullopt : opening.scene.reference;
    m_views.plots->setSettings(opening.scene.plots);
    m_views.plots->setZoom(opening.scene.zoom);
    m_views.mechanism->setSettings(opening.scene.mechanism);
    m_views.mechanism->setZoom(opening.scene.mechanismFrame);
    if (m_session->result()->sampling != m_session->sampling()) { // still being computed; the result resets the zoom
        const auto zoom = [this, zoom = opening.scene.zoom] { m_views.plots->setZoom(zoom); };
        connect(m_session, &Session::resultChanged, this, zoom, Qt::SingleShotConnection);
    }
    if (opening.restored) {
        m_session->undoStack().resetClean();
        opening.restored();
    } else {
        rememberFiles({m_path});
    }
    emit changed();
    if (!problem.isEmpty()) {
        emit referenceMissing(problem);
    }
}

void SceneFile::chooseAndOpen()
{
    auto *dialog =
        new QFileDialog(m_window, tr("Open scene"), recentFolder(), tr("Scenes (*.slidercrank *.json);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) { open(path); });
    dialog->open();
}

void SceneFile::save(const std::function<void()> &proceed)
{
    enterTypedNumber();
    if (m_path.isEmpty()) {
        saveAs(proceed);
    } else if (QFileInfo::exists(m_path) && fileState(m_path) != m_state) {
        askToReplace(proceed);
    } else if (saveTo(m_path) && proceed) {
        proceed();
    }
}

void SceneFile::askToReplace(const std::function<void()> &proceed)
{
    QMessageBox *question = makeQuestion(
        "changedQuestion", tr("Changed elsewhere"),
        tr("%1 has been changed by another program since you opened it. Replace it?").arg(QFileInfo(m_path).fileName()),
        m_window);
    question->addButton(tr("Replace"), QMessageBox::AcceptRole);
    const QPushButton *saveElsewhere = question->addButton(tr("Save as…"), QMessageBox::ActionRole);
    question->setDefaultButton(QMessageBox::Cancel);
    connect(question, &QMessageBox::accepted, this, [this, proceed] {
        if (saveTo(m_path) && proceed) {
            proceed();
        }
    });
    connect(saveElsewhere, &QPushButton::clicked, this, [this, proceed] { saveAs(proceed); });
    question->open();
}

void SceneFile::saveAs(const std::function<void()> &proceed)
{
    const QFileInfo file(m_path);
    chooseFileToSave(m_window, {tr("Save scene"),
                                {tr("Scenes (*.slidercrank)"), tr("Scenes (*.json)")},
                                m_path.isEmpty() ? lastFolder(QStandardPaths::DocumentsLocation) : file.absolutePath(),
                                m_path.isEmpty() ? tr("scene.slidercrank") : file.fileName(),
                                [this, proceed](const QString &path, const QString &) {
                                    if (saveTo(path) && proceed) {
                                        proceed();
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
    m_state = fileState(absolute);
    m_session->undoStack().setClean();
    rememberFiles({m_path});
    emit changed();
    emit saved(m_path);
    return true;
}

} // namespace slidercrank
