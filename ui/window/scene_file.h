// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scene of the window as a document: opens and saves it, and asks the user before changes are lost. The scene counts
// as modified if something was edited since it was saved; moving the time or zooming is no edit.

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
    /// `window` is the parent of dialogs.
    SceneFile(Session *session, const Views &views, QWidget *window);

    const QString &path() const { return m_path; } ///< empty if it was never saved

    /// Enters the number that is being typed into a box, so that it becomes part of the scene.
    void enterTypedNumber();

    /// Returns the scene as it would be saved now.
    Scene scene() const;

    /// Calls proceed(), after the user has saved or discarded unsaved changes.
    void askThen(const std::function<void()> &proceed);

    /// Shows a scene that has no file. Asks about unsaved changes first, and calls proceed() when the scene is shown.
    void restore(const Scene &scene, const std::function<void()> &proceed);

public slots:
    /// Asks about unsaved changes, then opens the scene. If `reference` is not empty, these files replace the scene's own
    /// reference.
    void open(const QString &path, const QStringList &reference = {});
    void chooseAndOpen();

    /// Saves the scene and calls proceed(). Asks for a name if the scene has none, and before it replaces a file that
    /// another program has changed.
    void save(const std::function<void()> &proceed = {});
    void saveAs(const std::function<void()> &proceed = {});

    /// Returns false if the scene cannot be written; problemFound then says why.
    bool saveTo(const QString &path);

signals:
    void changed(); ///< the path, or whether the scene is modified
    void saved(const QString &path);
    void problemFound(const QString &sentence);
    void referenceMissing(const QString &sentence); ///< the scene was opened without its reference

private:
    /// A scene that is about to be shown.
    struct Opening {
        QString path;
        FileState state;
        Scene scene;
        std::function<void()> restored; ///< set for a scene that has no file; called when it is shown
    };
    void show(const Opening &opening, const std::optional<ReferenceSource> &reference);
    void finishOpening(const QString &problem);
    void askToReplace(const std::function<void()> &proceed);

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    QString m_path;
    FileState m_state; ///< of the file when it was last opened or saved

    /// The reference that could not be opened; it is saved with the scene again.
    std::optional<ReferenceSource> m_missing;
    std::optional<Opening> m_opening; ///< set while its reference is being read
};

} // namespace slidercrank
