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
const QString kPrefix = QStringLiteral("recovery_"); // of the names of copies

/// Beside the settings, which on Windows are no file.
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

/// The copy, if no other window has it.
std::optional<Recovery::Copy> Recovery::claim(const QString &path)
{
    Copy copy{path, std::make_unique<QLockFile>(path + QStringLiteral(".lock"))};
    copy.lock->setStaleLockTime(0); // it ends with its process only
    return copy.lock->tryLock() ? std::optional(std::move(copy)) : std::nullopt;
}

void Recovery::followEdits()
{
    if (m_scene->isModified()) {
        m_rest.start(kRest);
    } else {
        removeCopy();
    }
}

/// Silently, if it cannot be written: saving the scene says why.
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

/// The latest copy; an older one is found at the next start.
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

/// The copy then belongs to the scene shown. Until that is shown, it is still offered: the person may cancel.
void Recovery::restore()
{
    const auto takeOver = [this] {
        removeCopy();
        if (m_offer) { // not discarded while the reference was read
            m_copy = std::move(std::exchange(m_offer, std::nullopt)->copy);
        }
        write();
        showOffer();
    };
    m_scene->restore(m_offer->scene, takeOver);
    showOffer();
}

} // namespace slidercrank
