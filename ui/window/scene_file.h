// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scene of the window as a document: it is opened, saved, and the person is asked before changes are lost. It is
// modified while there is an edit that could be undone since; neither the time nor the view of the plots counts.

#include "ui/document/scene.h"
#include "ui/document/session.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace slidercrank
{

struct Views;

class SceneFile : public QObject
{
    Q_OBJECT

public:
    /// `window`: the parent of dialogs.
    SceneFile(Session *session, const Views &views, QWidget *window);

    const QString &path() const { return m_path; } ///< empty: never saved
    bool isModified() const;

    /// Enters a number that is typed and not entered yet: it belongs to the scene.
    void enterTypedNumber();

    Scene scene() const; ///< as it would be saved now

    /// Calls proceed(); if changes would be lost, only when the person has saved or discarded them.
    void askThen(const std::function<void()> &proceed);

    /// Shows a scene that was never saved. Asks about unsaved changes first, and calls proceed() when it is shown.
    void restore(const Scene &scene, const std::function<void()> &proceed);

public slots:
    /// Asks about unsaved changes first. With a reference, that instead of the scene's own.
    void open(const QString &path, const QStringList &reference = {});
    void chooseAndOpen();

    /// Asks for a name if there is none yet, and before it replaces a file that somebody else has changed; calls
    /// proceed() when the scene is saved.
    void save(const std::function<void()> &proceed = {});
    void saveAs(const std::function<void()> &proceed = {});

    /// False if the scene cannot be written: then problemFound says why.
    bool saveTo(const QString &path);

signals:
    void changed(); ///< path or isModified
    void saved(const QString &path);
    void problemFound(const QString &sentence);
    void referenceMissing(const QString &sentence); ///< the scene is open without it

private:
    struct Opening {
        QString path;
        FileState state;
        Scene scene;
        std::function<void()> restored; ///< empty: the scene is as in the file
    };
    void show(const Opening &opening, const std::optional<ReferenceSource> &reference);
    void finishOpening(const QString &problem);
    void askToReplace(const std::function<void()> &proceed);

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    QString m_path;
    FileState m_state;    ///< of that file when it was opened or saved last
    std::optional<ReferenceSource>
        m_missing;                    ///< of the scene, which is open without it: it is saved again all the same
    std::optional<Opening> m_opening; ///< while its reference is read
};

} // namespace slidercrank
