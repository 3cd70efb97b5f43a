// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery.h"

#include "ui/document/session.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/scene_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include <chrono>
#include <variant>

namespace slidercrank
{

namespace
{

constexpr std::chrono::seconds kRest{2};

const QString kMessage = "recovery";

/// Returns the folder of the settings file, or the configuration folder on Windows, where settings are not a file.
QDir folder()
{
#ifdef Q_OS_WIN
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation));
#else
    return QFileInfo(QSettings().fileName()).absoluteDir();
#endif
}

} // namespace

Recovery::Recovery(Session *session, SceneFile *scene, MessageBar *messages, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_scene(scene)
    , m_messages(messages)
    , m_path(folder().filePath("recovery.json"))
    , m_lock(m_path + ".lock")
{
    m_lock.setStaleLockTime(0); // the lock is released only when its process ends
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (lock()) {
            writeScene(m_scene->scene(), m_path); // a failure is not reported; saving the scene will report it
        }
    });
    connect(&session->undoStack(), &QUndoStack::indexChanged, this, &Recovery::followEdits);
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &Recovery::followEdits);
    m_isOffered = std::holds_alternative<Scene>(readScene(m_path)) && lock();
    showOffer();
}

Recovery::~Recovery()
{
    if (!m_isOffered) {
        removeCopy();
    }
}

/// Locks the copy for this window. Returns false if another window has locked it.
bool Recovery::lock()
{
    return m_lock.isLocked() || (QDir().mkpath(folder().path()) && m_lock.tryLock());
}

void Recovery::followEdits()
{
    if (m_isOffered) {
        return; // the offered copy is not replaced before the answer
    }
    if (m_session->isModified()) {
        m_rest.start(kRest);
    } else {
        removeCopy();
    }
}

void Recovery::removeCopy()
{
    m_rest.stop();
    if (m_lock.isLocked()) {
        QFile::remove(m_path);
        m_lock.unlock();
    }
}

void Recovery::showOffer()
{
    if (!m_isOffered) {
        m_messages->removeMessage(kMessage);
        return;
    }
    const QString when = QLocale().toString(QFileInfo(m_path).lastModified(), QLocale::ShortFormat);
    const auto discard = [this] {
        m_isOffered = false;
        removeCopy();
        followEdits();
    };
    m_messages->showMessage({kMessage, Message::Kind::Question,
                             tr("The program ended before your changes were saved. They are kept, as of %1.").arg(when),
                             tr("Restore"), [this] { restore(); }, tr("Discard"), discard});
}

/// Restores the offered copy, which then becomes the copy of the current scene. The user may cancel; then it is still
/// offered.
void Recovery::restore()
{
    const std::variant<Scene, QString> outcome = readScene(m_path);
    if (const Scene *scene = std::get_if<Scene>(&outcome)) {
        m_scene->restore(*scene, [this] {
            m_isOffered = false;
            followEdits();
            showOffer();
        });
    }
    showOffer();
}

} // namespace slidercrank

#include "moc_recovery.cpp"
