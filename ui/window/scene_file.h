// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scene of the window as a document: opened, saved, asked about before it is lost. It is modified while there is an
// edit that could be undone since; neither the instant on show nor the plots' view counts as one.

#include "ui/document/scene.h"
#include "ui/document/session.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace slidercrank
{

struct Rooms;

class SceneFile : public QObject
{
    Q_OBJECT

public:
    /// `window`: whose session and rooms these are, and in front of which is asked.
    SceneFile(Session *session, const Rooms &rooms, QWidget *window);

    const QString &path() const { return m_path; }     ///< empty: never saved
    const FileState &state() const { return m_state; } ///< of the file there, as it was opened or saved last
    bool isModified() const;

    /// Before saving and asking: a number that is typed and not entered yet belongs to what is on show.
    void takeWhatIsTyped();

    /// What is on show, as it would be saved now.
    Scene scene() const;

    /// Goes on at once where nothing would be lost; otherwise asks first, and goes on unless the person cancels.
    void askThen(const std::function<void()> &goOn);

    /// Puts on show, unsaved, what was left of the file at `path`, which was in that state; empty: of none. Asks about
    /// unsaved changes first, then goes on once it is there.
    void restore(const Scene &scene, const QString &path, const FileState &state, const std::function<void()> &goOn);

public slots:
    /// Asks about unsaved changes first. With a reference, that instead of the scene's own.
    void open(const QString &path, const QStringList &reference = {});
    void chooseAndOpen();

    /// Asks for a name where there is none yet, and where somebody else has written to the file since; then goes on
    /// once it is saved.
    void save(const std::function<void()> &goOn = {});
    void saveAs(const std::function<void()> &goOn = {});

    /// False where it cannot be written: then problemFound says why.
    bool saveTo(const QString &path);

signals:
    void changed(); ///< path or isModified
    void saved(const QString &path);
    void problemFound(const QString &sentence);
    void referenceMissing(const QString &sentence); ///< the scene is open without it

private:
    struct Opening {
        QString path;
        FileState state; ///< of the file there
        Scene scene;
        std::function<void()> restored; ///< empty: it is as in the file
    };
    void show(const Opening &opening, const std::optional<ReferenceSource> &reference);
    void finishOpening(const QString &problem);
    void askToReplace(const std::function<void()> &goOn);

    Session *m_session;
    const Rooms &m_rooms;
    QWidget *m_window;
    QString m_path;
    FileState m_state;
    QJsonObject m_asRead;                     ///< of the file at m_path
    std::optional<ReferenceSource> m_missing; ///< of the scene, which is open without it: saved again all the same
    std::optional<Opening> m_opening;         ///< while its reference is read
};

} // namespace slidercrank
