// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery.h"

#include "ui/document/session.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/scene_file.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QJsonDocument>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QStyleHints>
#include <QTemporaryFile>
#include <QUuid>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#ifdef Q_OS_UNIX
#include <cerrno>

#include <signal.h>
#endif

namespace slidercrank
{

namespace
{

constexpr std::chrono::seconds kMostLost{2};

const QString kPrefix = QStringLiteral("recovery_");          // of the files' names
const QString kFile = QStringLiteral("recoveryOf");           // key of the file that the scene was of
const QString kSize = QStringLiteral("recoveryOfSize");       // of that file, bytes
const QString kChanged = QStringLiteral("recoveryOfChanged"); // when that file was, ms

/// Beside the settings, which on Windows are in no file.
QDir folder()
{
#ifdef Q_OS_WIN
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation));
#else
    return QFileInfo(QSettings().fileName()).absoluteDir();
#endif
}

/// All but how it is looked at.
QJsonObject contentOf(Scene scene)
{
    scene.asRead = {};
    QJsonObject content = QJsonDocument::fromJson(jsonOf(scene, folder().filePath(kFile))).object();
    content.remove(QStringLiteral("view"));
    return content;
}

/// By a window that is open, or is just taking it. Where no file can be made, as on a full disk, neither can a lock,
/// and the one that a crash left stays.
bool isHeld(const QLockFile &lock)
{
    if (lock.error() != QLockFile::LockFailedError) {
        return false;
    }
#ifdef Q_OS_UNIX
    qint64 process = 0;
    QString machine;
    QString program;
    const bool isLeft = lock.getLockInfo(&process, &machine, &program) && machine == QSysInfo::machineHostName() &&
                        ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
    QTemporaryFile trial(lock.fileName());
    return !isLeft || (trial.open() && trial.write("1") == 1 && trial.flush());
#else
    return true;
#endif
}

} // namespace

Recovery::Recovery(Session *session, SceneFile *scene, QVBoxLayout *column, QObject *parent)
    : QObject(parent)
    , m_scene(scene)
    , m_column(column)
{
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &Recovery::keep);
    connect(&session->undoStack(), &QUndoStack::indexChanged, this, &Recovery::follow);
    connect(&session->undoStack(), &QUndoStack::cleanChanged, this, &Recovery::follow);
    connect(session, &Session::opened, this, &Recovery::dropWhatIsOnShow);
    findOffers();
    dropWhatIsOnShow();
}

Recovery::~Recovery()
{
    forget();
}

Recovery::Kept Recovery::claim(const QString &path)
{
    Kept kept{path, std::make_unique<QLockFile>(path + QStringLiteral(".lock"))};
    kept.lock->setStaleLockTime(0); // only with its process
    if (!kept.lock->tryLock() && isHeld(*kept.lock)) {
        kept.lock = nullptr;
    }
    return kept;
}

void Recovery::follow()
{
    if (!m_scene->isModified()) {
        forget();
    } else if (!m_soon.isActive()) { // what goes on changing is kept all the same
        m_soon.start(kMostLost);
    }
}

/// In silence where it cannot be: saving says why.
void Recovery::keep()
{
    if (m_writing.isRunning()) {
        m_soon.start(kMostLost);
        return;
    }
    if (!m_own) {
        const QString name = QUuid::createUuid().toString(QUuid::Id128);
        QDir().mkpath(folder().path());
        m_own = std::make_shared<const Kept>(claim(folder().filePath(kPrefix + name + QStringLiteral(".json"))));
    }
    Scene scene = m_scene->scene();
    scene.asRead.insert(kFile, m_scene->path());
    scene.asRead.insert(kSize, m_scene->state().size);
    scene.asRead.insert(kChanged, m_scene->state().changed.toMSecsSinceEpoch());
    const auto write = [scene, own = m_own](const std::stop_token &stop, const auto &) {
        const std::optional<QString> problem = writeScene(scene, own->path);
        if (stop.stop_requested()) { // forgotten meanwhile
            QFile::remove(own->path);
        }
        return problem;
    };
    m_writing.start(
        write, [](const auto &) {}, [](const QString &) {});
}

void Recovery::forget()
{
    m_soon.stop();
    m_writing.drop();
    if (const auto own = std::exchange(m_own, nullptr)) {
        QFile::remove(own->path);
    }
}

/// The latest first.
void Recovery::findOffers()
{
    QFileInfoList files = folder().entryInfoList(QDir::Files, QDir::Time);
    files.removeIf([](const QFileInfo &file) { // at each start: a pattern would take longer than the rest
        return !file.fileName().startsWith(kPrefix) || file.suffix() != u"json";
    });
    for (const QFileInfo &file : files) {
        Kept kept = claim(file.absoluteFilePath());
        if (!kept.lock) {
            continue; // of a window that is open
        }
        std::variant<Scene, QString> outcome = readScene(kept.path);
        if (Scene *scene = std::get_if<Scene>(&outcome)) {
            const QString of = scene->asRead.take(kFile).toString();
            const qint64 size = scene->asRead.take(kSize).toInteger();
            const QDateTime changed = QDateTime::fromMSecsSinceEpoch(scene->asRead.take(kChanged).toInteger());
            m_offers.push_back({std::move(kept), std::move(*scene), of, {size, changed}});
        }
    }
}

void Recovery::dropWhatIsOnShow()
{
    if (!m_offers.empty()) {
        const QJsonObject shown = contentOf(m_scene->scene());
        std::erase_if(m_offers, [&shown](const Offer &offer) {
            return contentOf(offer.scene) == shown && QFile::remove(offer.kept.path);
        });
    }
    showOffer();
}

void Recovery::showOffer()
{
    if (m_offers.empty()) {
        if (m_bar) {
            m_bar->hide();
        }
        return;
    }
    if (!m_bar) {
        m_bar = new MessageBar;
        m_bar->setObjectName(QStringLiteral("recoveryBar"));
        m_column->insertWidget(0, m_bar);
        connect(m_bar, &MessageBar::dismissed, this, &Recovery::discard);
    }
    const Offer &offer = m_offers.front();
    const QString when = QLocale().toString(QFileInfo(offer.kept.path).lastModified(), QLocale::ShortFormat);
    m_bar->showMessage(
        MessageBar::Kind::Hint,
        offer.file.isEmpty()
            ? tr("The program ended before your changes were saved. They are kept, as of %1.").arg(when)
            : tr("The program ended before your changes to %1 were saved. They are kept, as of %2.")
                  .arg(QFileInfo(offer.file).fileName(), when),
        tr("Restore"), [this] { restore(); }, tr("Discard"));
}

void Recovery::sayAgain()
{
    if (m_bar && !m_bar->isHidden()) {
        showOffer();
    }
}

/// The file is kept on for what is on show then. Until then it is offered: the person may think better of it.
void Recovery::restore()
{
    const Offer &chosen = m_offers.front();
    const auto take = [this, path = chosen.kept.path] {
        forget();
        const auto offer = std::ranges::find(m_offers, path, [](const Offer &o) { return o.kept.path; });
        if (offer != m_offers.end()) { // else it was discarded while the reference was read
            m_own = std::make_shared<const Kept>(std::move(offer->kept));
            m_offers.erase(offer);
        }
        keep();
    };
    m_scene->restore(chosen.scene, chosen.file, chosen.state, take);
    showOffer();
}

void Recovery::discard()
{
    QFile::remove(m_offers.front().kept.path);
    m_offers.erase(m_offers.begin());
    // Not under a double click, which would discard the next one unread.
    QTimer::singleShot(QGuiApplication::styleHints()->mouseDoubleClickInterval(), this, &Recovery::showOffer);
}

} // namespace slidercrank
