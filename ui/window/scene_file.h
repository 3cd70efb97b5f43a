// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The scene of the window as a document: opens and saves it, and asks the user before changes are lost. The scene
// counts as modified if something was edited since it was saved; moving the time or zooming is no edit.

#include "ui/document/scene.h"
#include "ui/document/session.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

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

    /// Returns whether the reference of the scene has not been opened. It is saved with the scene again.
    bool lacksReference() const { return m_missing.has_value(); }

    /// Enters the number that is being typed into a box, so that it becomes part of the scene.
    void enterTypedNumber();

    /// Returns the scene as it would be saved now.
    Scene scene() const;

    /// Calls proceed(), after the user has saved or discarded unsaved changes.
    void askThen(const std::function<void()> &proceed);

    /// Shows the scene of another window, with its path, its unsaved changes and the steps that can be undone.
    void takeOver(const SceneFile &other);

    /// Asks about unsaved changes, then shows a scene that was never saved, and calls proceed().
    void restore(const Scene &scene, const std::function<void()> &proceed);

public slots:
    /// Reads the scene of a file or of a link, asks about unsaved changes, and shows the scene. If the scene cannot be
    /// read, reports the reason and asks nothing.
    void open(const QString &path);

    /// Saves the scene and calls proceed(). Asks for a name if the scene has none, and before it replaces a file that
    /// another program has changed.
    void save(const std::function<void()> &proceed = {});
    void saveAs(const std::function<void()> &proceed = {});

    /// Copies a link with the scene to the clipboard.
    void copyLink();

    /// Saves the scene and calls proceed(). Returns false if the scene cannot be written; the session then reports the
    /// reason.
    bool saveTo(const QString &path, const std::function<void()> &proceed = {});

signals:
    void changed(); ///< emitted after a change of the path, or of whether the scene is modified
    void notationChosen(const slidercrank::Notation &notation); ///< by the scene that is shown

private:
    /// Shows a scene. `path`: its file; empty if it has none. Reads the reference of the scene unless `loaded` contains
    /// it.
    void show(const Scene &scene, const QString &path, const std::shared_ptr<const Reference> &loaded = nullptr);

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    QString m_path;
    std::pair<qint64, QDateTime> m_fileStamp; ///< size and time of the file when it was last opened or saved
    std::optional<ReferenceSource> m_missing; ///< the reference of the scene that has not been opened
};

} // namespace slidercrank
