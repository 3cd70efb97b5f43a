// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery.h"

#include "ui/document/session.h"
#include "ui/text/language.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/scene_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <chrono>
#include <variant>

namespace slidercrank
{

namespace
{

constexpr std::chrono::seconds kWriteDelay{2};

constexpr int kMaxCopies = 100; // names that are tried: in a folder that cannot be written none of them is free

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

/// Returns the path of the copy with that number, counted from 1.
QString copyPath(int number)
{
    return folder().filePath(number == 1 ? QString("recovery.json") : QString("recovery-%1.json").arg(number));
}

} // namespace

Recovery::LockedCopy::LockedCopy(const QString &scenePath)
    : path(scenePath)
    , lock(scenePath + ".lock")
{
    lock.setStaleLockTime(0); // the lock is released only when its process ends
    lock.tryLock();
}

Recovery::Recovery(Session *session, SceneFile *scene, MessageBar *messages, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_scene(scene)
    , m_messages(messages)
{
    m_writeDelay.setSingleShot(true);
    connect(&m_writeDelay, &QTimer::timeout, this, &Recovery::writeCopy);
    connect(&session->undoStack(), &QUndoStack::indexChanged, this, &Recovery::followEdits);
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &Recovery::followEdits);
    findOffer();
    showOffer();
}

Recovery::~Recovery()
{
    removeCopy();
}

/// Offers the first copy that a crash has left. The copies of windows that still run are locked, and are passed over.
void Recovery::findOffer()
{
    m_offer.reset();
    for (int number = 1; number <= kMaxCopies; ++number) {
        if (!QFile::exists(copyPath(number))) {
            continue;
        }
        auto copy = std::make_unique<LockedCopy>(copyPath(number));
        if (copy->lock.isLocked() && std::holds_alternative<Scene>(readScene(copy->path))) {
            m_offer = std::move(copy);
            return;
        }
    }
}

void Recovery::showOffer()
{
    if (!m_offer) {
        m_messages->removeMessage(kMessage);
        return;
    }
    // The times of some languages end with a full stop, as in "7:08 p. m.".
    const QString when = textLocale().toString(QFileInfo(m_offer->path).lastModified(), tr("d MMMM yyyy, HH:mm"));
    m_messages->showMessage({kMessage, Message::Kind::Question,
                             tr("The program ended before your changes were saved. They are kept, as of %1.").arg(when),
                             tr("Restore"), [this] { restore(); }, tr("Discard"), [this] { discardOffer(); }});
}

/// Restores the offered copy, which then becomes the copy of this window. If the user cancels, the copy is
/// still offered.
void Recovery::restore()
{
    const std::variant<Scene, QString> outcome = readScene(m_offer->path);
    if (const Scene *scene = std::get_if<Scene>(&outcome)) {
        m_scene->restore(*scene, [this] {
            removeCopy();
            m_copy = std::move(m_offer);
            followEdits();
            showOffer();
        });
    }
    showOffer();
}

/// Removes the offered copy, and offers the next one if several windows have crashed.
void Recovery::discardOffer()
{
    QFile::remove(m_offer->path);
    findOffer();
    showOffer();
}

void Recovery::followEdits()
{
    if (m_session->isModified()) {
        m_writeDelay.start(kWriteDelay);
    } else {
        removeCopy();
    }
}

/// Writes the scene to the copy of this window. If there is none yet, first locks a name that is not in use. A failure
/// is not reported; saving the scene will report it.
void Recovery::writeCopy()
{
    QDir().mkpath(folder().path());
    for (int number = 1; !m_copy && number <= kMaxCopies; ++number) {
        const QString path = copyPath(number);
        if (QFile::exists(path)) { // of another window, or left by a crash
            continue;
        }
        auto copy = std::make_unique<LockedCopy>(path);
        if (copy->lock.isLocked()) {
            m_copy = std::move(copy);
        }
    }
    if (m_copy) {
        writeScene(m_scene->scene(), m_copy->path);
    }
}

void Recovery::removeCopy()
{
    m_writeDelay.stop();
    if (m_copy) {
        QFile::remove(m_copy->path);
        m_copy.reset();
    }
}

} // namespace slidercrank

#include "moc_recovery.cpp"
