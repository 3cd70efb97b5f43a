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
#include <QUuid>

#include <chrono>
#include <utility>
#include <variant>

namespace slidercrank
{

namespace
{

constexpr std::chrono::seconds kRest{2};

const QString kMessage = "recovery";
const QString kName = "recovery_%1.json";
const QString kLockSuffix = ".lock";

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
{
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &Recovery::write);
    connect(&session->undoStack(), &QUndoStack::indexChanged, this, &Recovery::followEdits);
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &Recovery::followEdits);
    for (const QFileInfo &file : folder().entryInfoList({kName.arg(QChar(u'*'))}, QDir::Files, QDir::Time)) {
        Copy copy = claim(file.absoluteFilePath());
        if (copy && std::holds_alternative<Scene>(readScene(pathOf(copy)))) {
            m_offer = std::move(copy);
            break; // older copies are offered at the next starts
        }
    }
    showOffer();
}

Recovery::~Recovery()
{
    remove(m_copy);
}

/// Locks the copy at that path. Returns null if another process has locked it.
Recovery::Copy Recovery::claim(const QString &path)
{
    auto lock = std::make_unique<QLockFile>(path + kLockSuffix);
    lock->setStaleLockTime(0); // the lock is released only when its process ends
    return lock->tryLock() ? std::move(lock) : nullptr;
}

QString Recovery::pathOf(const Copy &copy)
{
    return copy->fileName().chopped(kLockSuffix.size());
}

void Recovery::remove(Copy &copy)
{
    if (copy) {
        QFile::remove(pathOf(copy));
        copy.reset();
    }
}

void Recovery::followEdits()
{
    if (m_session->isModified()) {
        m_rest.start(kRest);
    } else {
        m_rest.stop();
        remove(m_copy);
    }
}

/// Writes the copy. A failure is not reported; saving the scene will report it.
void Recovery::write()
{
    if (!m_copy) {
        QDir().mkpath(folder().path());
        m_copy = claim(folder().filePath(kName.arg(QUuid::createUuid().toString(QUuid::Id128))));
    }
    if (m_copy) {
        writeScene(m_scene->scene(), pathOf(m_copy));
    }
}

void Recovery::showOffer()
{
    if (!m_offer) {
        m_messages->removeMessage(kMessage);
        return;
    }
    const QString when = QLocale().toString(QFileInfo(pathOf(m_offer)).lastModified(), QLocale::ShortFormat);
    m_messages->showMessage({kMessage, Message::Kind::Question,
                             tr("The program ended before your changes were saved. They are kept, as of %1.").arg(when),
                             tr("Restore"), [this] { restore(); }, tr("Discard"), [this] { remove(m_offer); }});
}

/// Restores the offered copy, which then becomes the copy of the current scene. The user may cancel; then it is still
/// offered.
void Recovery::restore()
{
    const std::variant<Scene, QString> scene = readScene(pathOf(m_offer));
    if (std::holds_alternative<Scene>(scene)) {
        m_scene->restore(std::get<Scene>(scene), [this] {
            remove(m_copy);
            m_copy = std::move(m_offer);
            write();
            showOffer();
        });
    }
    showOffer();
}

} // namespace slidercrank
