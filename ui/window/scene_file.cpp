// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/scene_file.h"

#include "ui/document/scene_link.h"
#include "ui/document/whole_file.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/question.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/views.h"
#include "ui/window/window_settings.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QMessageBox>

#include <variant>

namespace slidercrank
{

namespace
{

const QString kQuestion = "unsavedQuestion";

std::pair<qint64, QDateTime> fileStampOf(const QString &path)
{
    const QFileInfo file(path);
    return {file.size(), file.lastModified()};
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
            .reference =
                m_session->reference() ? std::optional<ReferenceSource>(m_session->reference()->source) : m_missing,
            .pinned = m_session->pinned(),
            .time = m_session->time(),
            .alpha2 = m_session->alpha2(),
            .plots = m_views.plots->settings(),
            .zoom = m_views.plots->zoom(),
            .mechanism = m_views.mechanism->settings(),
            .mechanismFrame = m_views.mechanism->zoom(),
            .table = m_views.table->settings(),
            .notation = notation()};
}

void SceneFile::askThen(const std::function<void()> &proceed)
{
    enterTypedNumber();
    if (!m_session->isModified()) {
        proceed();
        return;
    }
    if (auto *unanswered = m_window->findChild<QMessageBox *>(kQuestion)) {
        unanswered->reject();
    }
    const QString name = QFileInfo(m_path).fileName();
    auto *question =
        named(kQuestion, new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                         name.isEmpty() ? tr("Save your changes as a scene?")
                                                        : tr("Save your changes to %1?").arg(name),
                                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window));
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, proceed](int answer) {
        if (answer == QMessageBox::Save) {
            save(proceed);
        } else if (answer == QMessageBox::Discard) {
            proceed();
        }
    });
    question->setInformativeText(tr("They will be lost if you don't."));
    question->open();
}

void SceneFile::open(const QString &path)
{
    const bool isLink = isSceneLink(path);
    const QString absolute = isLink ? path : QFileInfo(path).absoluteFilePath();
    const std::variant<Scene, QString> outcome = readScene(absolute);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        m_session->reportFailure(*sentence);
        return;
    }
    Scene scene = std::get<Scene>(outcome);
    if (isLink) { // a link does not contain the settings of the drawing
        scene.mechanism = m_views.mechanism->settings();
    }
    askThen([this, absolute, isLink, scene] {
        show(scene, isLink ? QString() : absolute);
        if (!isLink) {
            rememberFiles({absolute});
        }
    });
}

void SceneFile::restore(const Scene &scene, const std::function<void()> &proceed)
{
    askThen([this, scene, proceed] {
        show(scene, {});
        m_session->undoStack().resetClean();
        proceed();
    });
}

void SceneFile::takeOver(const SceneFile &other)
{
    show(other.scene(), other.m_path, other.m_session->reference());
    m_fileStamp = other.m_fileStamp;
    m_session->takeOverSteps(*other.m_session);
    emit changed();
}

void SceneFile::show(const Scene &scene, const QString &path, const std::shared_ptr<const Reference> &loaded)
{
    const std::optional<ReferenceSource> missing = loaded ? std::nullopt : scene.reference;
    m_session->open({scene.parameters, scene.sampling, scene.solver, loaded, scene.pinned, scene.alpha2}, scene.time,
                    missing);
    m_path = path;
    m_fileStamp = fileStampOf(path);
    m_missing = missing;
    m_views.plots->setSettings(scene.plots);
    m_views.plots->setZoom(scene.zoom);
    m_views.mechanism->setSettings(scene.mechanism);
    m_views.mechanism->setZoom(scene.mechanismFrame);
    if (scene.table) {
        m_views.table->setSettings(*scene.table);
    }
    if (scene.notation && *scene.notation != notation()) {
        emit notationChosen(*scene.notation);
    }
    emit changed();
}

void SceneFile::save(const std::function<void()> &proceed)
{
    enterTypedNumber();
    if (m_path.isEmpty()) {
        saveAs(proceed);
        return;
    }
    if (!QFileInfo::exists(m_path) || fileStampOf(m_path) == m_fileStamp) {
        saveTo(m_path, proceed);
        return;
    }
    const QString question = tr("%1 has been changed by another program since you opened it. Replace it?");
    askBeforeReplacing(m_window, tr("Changed elsewhere"), question.arg(QFileInfo(m_path).fileName()),
                       [this, proceed] { saveTo(m_path, proceed); });
}

void SceneFile::saveAs(const std::function<void()> &proceed)
{
    const QFileInfo file(m_path);
    chooseFileToSave(m_window, {tr("Save scene"),
                                {tr("Scenes (*.slidercrank)"), tr("Scenes (*.json)")},
                                m_path.isEmpty() ? tr("scene") : file.completeBaseName(),
                                [this, proceed](const QString &path, const QString &) { saveTo(path, proceed); },
                                m_path.isEmpty() ? QString() : file.absolutePath()});
}

void SceneFile::copyLink()
{
    enterTypedNumber();
    QApplication::clipboard()->setText(sceneLink(scene()));
    m_session->confirm(
        m_session->reference()
            ? tr("The link is in the clipboard. It carries the mechanism, α₂, the time steps and the method, but no "
                 "file.")
            : tr("The link is in the clipboard. It carries the mechanism, α₂, the time steps and the method."));
}

bool SceneFile::saveTo(const QString &path, const std::function<void()> &proceed)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (const std::optional<QString> sentence = writeScene(scene(), absolute)) {
        m_session->reportFailure(*sentence);
        return false;
    }
    m_path = absolute;
    m_fileStamp = fileStampOf(absolute);
    m_session->undoStack().setClean();
    rememberFiles({m_path});
    emit changed();
    emit m_session->fileWritten(m_path);
    m_session->confirm(tr("Saved: %1").arg(displayName(m_path)));
    if (proceed) {
        proceed();
    }
    return true;
}

} // namespace slidercrank

#include "moc_scene_file.cpp"
