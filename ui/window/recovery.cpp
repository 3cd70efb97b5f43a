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

const QString kMessage = QStringLiteral("recovery");
const QString kPrefix = QStringLiteral("recovery_"); // prefix of the file names of copies

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
    findOffer();
    showOffer();
}

Recovery::~Recovery()
{
    removeCopy();
}

/// Locks a copy; returns nullopt if another process has locked it.
std::optional<Recovery::Copy> Recovery::claim(const QString &path)
{
    Copy copy{path, std::make_unique<QLockFile>(path + QStringLiteral(".lock"))};
    copy.lock->setStaleLockTime(0); // the lock is released only when its process ends
    return copy.lock->tryLock() ? std::optional(std::move(copy)) : std::nullopt;
}

void Recovery::followEdits()
{
    if (m_session->isModified()) {
        m_rest.start(kRest);
    } else {
        removeCopy();
    }
}

/// Writes the copy. A failure is not reported; saving the scene will report it.
void Recovery::write()
{
    if (!m_copy) {
        const QString name = kPrefix + QUuid::createUuid().toString(QUuid::Id128) + QStringLiteral(".json");
        QDir().mkpath(folder().path());
        m_copy = claim(folder().filePath(name));
    }
    if (m_copy) {
        writeScene(m_scene->scene(), m_copy->path);
    }
}

void Recovery::removeCopy()
{
    m_rest.stop();
    if (m_copy) {
        QFile::remove(m_copy->path);
        m_copy.reset();
    }
}

/// Finds the latest copy. Older ones are offered at the next starts.
void Recovery::findOffer()
{
    for (const QFileInfo &file : folder().entryInfoList(QDir::Files, QDir::Time)) {
        if (!file.fileName().startsWith(kPrefix) || file.suffix() != u"json") {
            continue;
        }
        std::optional<Copy> copy = claim(file.absoluteFilePath());
        std::variant<Scene, QString> outcome = copy ? readScene(copy->path) : QString();
        if (Scene *scene = std::get_if<Scene>(&outcome)) {
            m_offer = Offer{std::move(*copy), std::move(*scene)};
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
    const QString when = QLocale().toString(QFileInfo(m_offer->copy.path).lastModified(), QLocale::ShortFormat);
    const auto discard = [this] {
        QFile::remove(m_offer->copy.path);
        m_offer.reset();
    };
    m_messages->showMessage({kMessage, Message::Kind::Question,
                             tr("The program ended before your changes were saved. They are kept, as of %1.").arg(when),
                             tr("Restore"), [this] { restore(); }, tr("Discard"), discard});
}

/// Restores the offered copy, which then becomes the copy of the current scene. The offer remains until the scene is
/// shown, because the user may cancel.
void Recovery::restore()
{
    const auto takeOver = [this] {
        removeCopy();
        if (m_offer) { // the user may have discarded it while the reference was read
            m_copy = std::move(std::exchange(m_offer, std::nullopt)->copy);
        }
        write();
        showOffer();
    };
    m_scene->restore(m_offer->scene, takeOver);
    showOffer();
}

} // namespace slidercrank
